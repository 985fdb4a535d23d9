"""`weave convert`: to every kind of file, and one bitmap a weft.

Covers: weave/save.py
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from loomlight.cli.main import run
from loomlight.weave.load import load_draft
from loomlight.weave.named import named_weave
from loomlight.weave.save import SAVED_SUFFIXES

TOOTH = named_weave("houndstooth").drawdown


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder to work in."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_a_fabric_file_gives_its_draft_the_setts() -> None:
    Path("cloth.toml").write_text('weave = "twill 2/1"\nepi = 50.8\npicks_per_cm = 16\n')
    Path("bare.toml").write_text('weave = "twill 2/1"\n')
    for name in ("cloth", "bare"):
        assert run(["weave", "convert", f"{name}.toml", "-o", f"{name}.wif"]) == 0
    warp, weft = (getattr(load_draft("cloth.wif"), family).spacing_mm for family in ("warp", "weft"))
    np.testing.assert_allclose(warp, [0.5] * 3)
    np.testing.assert_allclose(weft, [0.625] * 3)
    assert load_draft("bare.wif").warp.spacing_mm is None


@pytest.mark.parametrize("suffix", SAVED_SUFFIXES)
def test_every_kind_of_file_is_the_draft_again(suffix: str) -> None:
    assert run(["weave", "convert", "houndstooth", "-o", f"a{suffix}"]) == 0
    np.testing.assert_array_equal(load_draft(f"a{suffix}").drawdown, TOOTH)


def test_a_bitmap_a_weft_and_back(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["weave", "convert", "houndstooth", "--each-weft", "-o", "a.bmp"]) == 0
    said = capsys.readouterr().out.splitlines()
    assert said[0] == "a-1.bmp: 4 picks of #23262e"
    assert said[2] == "order of the wefts: 4x1 4x2"
    assert sorted(path.name for path in Path().iterdir()) == ["a-1.bmp", "a-2.bmp"]
    assert Image.open("a-2.bmp").size == (8, 4)
    order = said[2].partition(": ")[2]
    assert run(["weave", "convert", "a-1.bmp", "a-2.bmp", "--order", order, "-o", "again.wif"]) == 0
    again = load_draft("again.wif")
    np.testing.assert_array_equal(again.drawdown, TOOTH)
    assert again.weft.colors is not None
    assert len(np.unique(again.weft.colors[:4], axis=0)) == 1


def test_each_convention_of_what_is_read_and_of_what_is_written() -> None:
    written = ["--lifted", "white", "--first-pick", "top", "--first-end", "right"]
    assert run(["weave", "convert", "twill 3/1", "-o", "a.png", *written]) == 0
    twill = named_weave("twill 3/1").drawdown
    np.testing.assert_array_equal(np.asarray(Image.open("a.png"))[:, ::-1], twill)
    read = ["--read-lifted", "white", "--read-first-pick", "top", "--read-first-end", "right"]
    assert run(["weave", "convert", "a.png", "-o", "b.png", *read]) == 0
    np.testing.assert_array_equal(load_draft("b.png").drawdown, twill)


@pytest.mark.parametrize(
    ("command", "says"),
    [
        (["plain", "-o", "a.txt"], "must end in .wif or .dtx or .png"),
        (["plain", "-o", "a.wif", "--each-weft"], "must end in .png"),
        (["plain", "twill", "-o", "a.wif"], "plain is no bitmap"),
        (["plain", "--order", "1 2", "-o", "a.wif"], "plain is no bitmap"),
        (["no.bmp", "--order", "1", "-o", "a.wif"], "no.bmp does not exist"),
        (["p.bmp", "p.bmp", "--order", "one", "-o", "a.wif"], '--order "one" is not understood'),
        (["p.bmp", "p.bmp", "--order", "1 1 2", "-o", "a.wif"], "the order 1 1 2 takes 3, 1 of so many"),
        (["p-1.bmp", "p.bmp", "--each-weft", "-o", "p.bmp"], "p.bmp is read by this command"),
        (["p-1.bmp", "--order", "1", "--each-weft", "-o", "p.bmp"], "p-1.bmp is read by this command"),
    ],
)
def test_bad_input_is_a_sentence_and_nothing_is_written(
    command: list[str], says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in ("p.bmp", "p-1.bmp"):
        Image.fromarray(np.eye(2, dtype=np.uint8) * 255).convert("1").save(name)
    before = {path.name: path.read_bytes() for path in Path().iterdir()}
    assert run(["weave", "convert", *command]) == 2
    said = capsys.readouterr().err
    assert says in said
    assert said.count("\n") == 1
    assert {path.name: path.read_bytes() for path in Path().iterdir()} == before
