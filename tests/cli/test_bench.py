"""`weave heddles`, `threading`, `treadling` and `print`, as commands."""

from __future__ import annotations

from pathlib import Path

import pypdfium2
import pytest

from loomlight.cli.main import run


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A folder to work in, with a fabric file."""
    monkeypatch.chdir(tmp_path)
    Path("cloth.toml").write_text('weave = "twill 2/2"\nends_per_cm = 8\npicks_per_cm = 5\n')


def test_lists_are_printed_or_written(capsys: pytest.CaptureFixture[str]) -> None:
    for words in (["heddles", "--ends", "10"], ["threading", "--group", "4"], ["treadling", "--picks", "9"]):
        command = ["weave", words[0], "cloth.toml", *words[1:]]
        assert run(command) == 0
        shown = capsys.readouterr().out
        assert run([*command, "-o", "list.txt"]) == 0
        assert capsys.readouterr().out == "list.txt\n"
        assert Path("list.txt").read_text() == shown
    assert "9 picks on 4 treadles" in shown


def test_a_fabric_is_printed_in_its_setts_and_options_go_first(capsys: pytest.CaptureFixture[str]) -> None:
    for options, says in (
        ([], "8 ends/cm (20.3 epi), 5 picks/cm (12.7 ppi)"),
        (["--epi", "12.7", "--picks-per-cm", "10"], "5 ends/cm (12.7 epi), 10 picks/cm (25.4 ppi)"),
    ):
        assert run(["weave", "print", "cloth.toml", *options, "--ends", "40", "-o", "a.pdf"]) == 0
        document = pypdfium2.PdfDocument("a.pdf")
        assert says in document[0].get_textpage().get_text_range()
        document.close()
    assert capsys.readouterr().out == "a.pdf\n" * 2


@pytest.mark.parametrize(
    ("command", "says"),
    [
        (["print", "plain", "-o", "a.png"], "must end in .pdf"),
        (["print", "plain", "-o", "a.pdf", "--epi", "20", "--ends-per-cm", "8"], "say the same thing twice"),
        (["print", "plain", "-o", "a.pdf", "--ppi", "0"], "--ppi 0 is out of range"),
        (["print", "plain", "-o", "a.pdf", "--ends", "0"], "0 ends are out of range"),
        (["heddles", "plain", "-o", "a.csv"], "must end in .txt"),
        (["threading", "plain", "--group", "0", "-o", "a.txt"], "0 ends a line are out of range"),
        (["treadling", "plian"], "plain"),
    ],
)
def test_bad_input_is_a_sentence_and_nothing_is_written(
    command: list[str], says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["weave", *command]) == 2
    said = capsys.readouterr().err
    assert says in said
    assert said.count("\n") == 1
    assert [path.name for path in Path().iterdir()] == ["cloth.toml"]
