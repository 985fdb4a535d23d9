"""What every command is asked: its help, its words, where it writes, and what is left of an interruption.

Covers: cli/main.py, cli/options.py, core/outputs.py
"""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest
import typer

from loomlight.cli.main import app, run
from tests.helpers.users import as_nobody
from tests.marks import slow_among

pytestmark = pytest.mark.filterwarnings("ignore::loomlight.core.errors.LoomlightWarning")


@dataclass(frozen=True)
class Command:
    """A command.

    Attributes:
        words: after its name, but for the draft or fabric and the output.
        output: name of what it writes; None for those that write nothing.
        option: of the output.
        is_folder: it writes a folder.
        takes: it takes a draft, fabric or other source, and names it so; "" for none.
        needs: neither the source nor the output has a default.
    """

    words: str = ""
    output: str | None = None
    option: str = "-o"
    is_folder: bool = False
    takes: str = ""
    needs: bool = True

    def line(self, name: str, source: str = "plain", output: str | None = None) -> list[str]:
        """The whole command line, with `output` in place of its own."""
        written = output or self.output
        line = [*name.split(), *([source] if self.takes else []), *self.words.split()]
        return line if written is None else [*line, self.option, written]


COMMANDS = {
    "weave show": Command("--cell 4", "a.png", takes="DRAFT"),
    "weave convert": Command("", "a.wif", takes="DRAFT"),
    "weave info": Command(takes="DRAFT"),
    "weave names": Command(),
    "weave heddles": Command(takes="DRAFT"),
    "weave threading": Command(takes="DRAFT"),
    "weave treadling": Command(takes="DRAFT"),
    "weave print": Command("", "a.pdf", takes="DRAFT"),
    "render": Command("--size 16x12 --spp 1 --model point", "a.png", takes="FABRIC"),
    "swatches": Command("--size 32 --spp 1 --model point", "a.png", takes="FABRIC"),
    "play": Command("--size 16x12 --passes 1 --model point", "a.png", takes="FABRIC", needs=False),
    "view": Command("--no-browser", "site", "--export", is_folder=True, takes="FABRIC", needs=False),
    "compare": Command("--models point --size 16x12 --spp 1", "report", is_folder=True, takes="FABRIC"),
    "capture": Command("photo.jpg --width-mm 20", "a.toml"),
    "demo": Command("--spp 1", "a.png", needs=False),
    "bake": Command("--model point", "a.loom", takes="SOURCE"),
    "bake-maps": Command("--resolution 8", "a.exr", takes="FABRIC"),
    "export": Command("--to wgsl", "cloth", is_folder=True, takes="FABRIC"),
    "doctor": Command(),
}
WRITING = [name for name, command in COMMANDS.items() if command.output is not None]
READING = [name for name, command in COMMANDS.items() if command.takes]
FILES = [name for name in WRITING if not COMMANDS[name].is_folder]
every_command = pytest.mark.parametrize("name", COMMANDS)


def test_these_are_all_commands() -> None:
    def names(command: object, prefix: str) -> Iterator[str]:
        for name, each in getattr(command, "commands", {}).items():
            if hasattr(each, "commands"):
                yield from names(each, f"{prefix}{name} ")
            else:
                yield f"{prefix}{name}"

    assert set(names(typer.main.get_command(app), "")) == set(COMMANDS)


# -------------------------------------------------------------------------------------------- help and words


@every_command
def test_the_help_has_an_example_and_fits_a_terminal(
    name: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    texts = []
    for option in ("--help", "-h"):
        assert run([*name.split(), option]) == 0
        captured = capsys.readouterr()
        assert captured.err == ""
        texts.append(captured.out)
    assert texts[0] == texts[1]
    assert max(map(len, texts[0].splitlines())) <= 80
    assert f"Example: loomlight {name}" in " ".join(texts[0].split())


@every_command
def test_an_unknown_option_is_named(name: str, refused: Callable[..., str]) -> None:
    said = refused([*COMMANDS[name].line(name), "--hepl"])
    assert "--hepl" in said
    assert f"`loomlight {name} --help` shows how it is used." in said


@pytest.mark.parametrize("name", [name for name, command in COMMANDS.items() if not command.takes])
def test_a_word_too_many_is_named(name: str, refused: Callable[..., str]) -> None:
    assert "(surplus)" in refused([*COMMANDS[name].line(name), "surplus"])


@pytest.mark.parametrize("name", [name for name in READING if COMMANDS[name].needs])
def test_what_is_missing_is_named(name: str, refused: Callable[..., str]) -> None:
    command = COMMANDS[name]
    assert command.takes in refused([*name.split(), *command.line(name)[len(name.split()) + 1 :]])
    if command.output is not None:
        assert "--output" in refused(command.line(name)[:-2])


# ---------------------------------------------------------------------------------------------- what is read

NO_SOURCES = {
    "none.toml": "none.toml does not exist",
    "none.wif": "none.wif does not exist",
    "none.png": "none.png does not exist",
    "none.loom": "none.loom does not exist",
    "plian": 'did you mean "plain"',
    "cloth.fbx": "cloth.fbx is no",
    "": '"" is no',
    "pipe.wif": "pipe.wif is no ordinary file",
    "folder.png": "folder.png is a folder",
    "\udcff": "no text in UTF-8|is no weave that is known",
    "a\udcff.wif": "no text in UTF-8|does not exist",
    "bad.toml": "bad.toml: gap = 2",
    "bad.wif": "bad.wif is no weaving information file",
    "bad.png": "bad.png is no picture",
    "bad.loom": "bad.loom: it is no .loom file",
}


@pytest.fixture
def sources() -> None:
    """Files in the current folder that are none of fabrics."""
    os.mkfifo("pipe.wif")
    Path("folder.png").mkdir()
    Path("bad.toml").write_text('weave = "plain"\ngap = 2')
    for suffix in ("wif", "png", "loom"):
        Path(f"bad.{suffix}").write_text("no such thing")


@pytest.mark.parametrize("name", READING)
@pytest.mark.parametrize("source", NO_SOURCES)
def test_what_is_no_source_is_refused(
    name: str, source: str, refused: Callable[..., str], sources: None
) -> None:
    said = refused(COMMANDS[name].line(name, source))
    assert any(part in said for part in NO_SOURCES[source].split("|"))


# ------------------------------------------------------------------------------------------- what is written


def elsewhere(name: str, place: str) -> str:
    """The output of a command within a place."""
    return f"{place}/{COMMANDS[name].output}"


@pytest.mark.parametrize("name", WRITING)
def test_a_folder_that_is_not_there_is_named(name: str, refused: Callable[..., str]) -> None:
    said = refused(COMMANDS[name].line(name, output=elsewhere(name, "none/deeper")))
    assert "none/deeper" in said
    assert "does not exist" in said


@pytest.mark.parametrize("name", WRITING)
def test_what_is_there_is_no_place_to_write(name: str, refused: Callable[..., str]) -> None:
    """A folder in the place of a file, a file in that of a folder."""
    output = COMMANDS[name].output
    assert output is not None
    if COMMANDS[name].is_folder:
        Path(output).write_text("mine")
    else:
        Path(output).mkdir()
    said = refused(COMMANDS[name].line(name))
    assert output in said
    assert any(word in said for word in ("is a folder", "holds a file", "is a file", "is no folder"))


@pytest.mark.parametrize("name", FILES)
@pytest.mark.parametrize("suffix", ["", ".tga", ".txt"])
def test_other_suffixes_are_refused(name: str, suffix: str, refused: Callable[..., str]) -> None:
    assert "must end in ." in refused(COMMANDS[name].line(name, output=f"a{suffix}"))


@pytest.mark.parametrize("name", WRITING)
@pytest.mark.parametrize(
    "output", ["a\0b/{}", "x" * 5000 + "/{}", "x" * 300 + "{}"], ids=["NUL", "path", "name"]
)
def test_what_is_no_path_is_refused(name: str, output: str, refused: Callable[..., str]) -> None:
    refused(COMMANDS[name].line(name, output=output.format(COMMANDS[name].output)))


@pytest.mark.parametrize("name", WRITING)
def test_a_folder_that_may_not_be_written_to_is_named(
    name: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    with tempfile.TemporaryDirectory() as place:
        monkeypatch.setenv("XDG_CACHE_HOME", place)
        # Modules that it imports on its way may lie where nobody else reads. One missing folder some make.
        assert run(COMMANDS[name].line(name, output=elsewhere(name, f"{place}/none/none"))) == 2
        capsys.readouterr()
        Path(place).chmod(0o555)
        with as_nobody():
            code = run(COMMANDS[name].line(name, output=elsewhere(name, place)))
        Path(place).chmod(0o755)
        said = capsys.readouterr().err
        assert (code, said.count("\n"), list(Path(place).iterdir())) == (2, 1, []), said
        assert place in said


@pytest.mark.parametrize("name", READING)
def test_an_interruption_is_one_line_and_leaves_nothing(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("loomlight.weave.named._words", interrupted)
    assert run(COMMANDS[name].line(name)) == 130
    captured = capsys.readouterr()
    assert captured.out == ""
    # What is made in parts goes on with those that are whole.
    left = "Nothing was written." if name != "swatches" else ".loomlight-a.png.parts keeps the fabrics"
    assert captured.err.startswith(f"loomlight: interrupted. {left}")
    assert captured.err.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


QUICK = ("weave show", "weave convert", "bake", "bake-maps", "export")


@pytest.mark.parametrize("name", slow_among(QUICK, ("export",)))
def test_what_was_written_is_printed(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """And nothing else; an old file is replaced, and the same once more."""
    monkeypatch.chdir(tmp_path)
    command = COMMANDS[name]
    for _ in range(2):
        assert run(command.line(name)) == 0
        captured = capsys.readouterr()
        assert captured.err == ""
        printed = [Path(line) for line in captured.out.splitlines()]
        assert printed
        assert all(path.exists() for path in printed)
        tops = {path.parts[0] for path in printed}
        assert tops == {path.name for path in tmp_path.iterdir()}


@pytest.mark.parametrize("name", QUICK)
def test_a_full_disk_is_one_sentence_and_leaves_what_was_there(
    name: str, refused: Callable[..., str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    if not COMMANDS[name].is_folder:
        Path(str(COMMANDS[name].output)).write_text("before")
    for maker in ("mkstemp", "mkdtemp"):
        monkeypatch.setattr(f"tempfile.{maker}", full)
    assert "cannot be written: No space left on device" in refused(COMMANDS[name].line(name))
