"""Bad input ends in one sentence on stderr and exit code 2; nothing is written."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import drjit as dr
import pytest
from drjit.llvm import Float

from loomlight.cli.main import _show_each_once, run
from loomlight.core.images import write_pixels
from loomlight.core.llvm import require_llvm
from loomlight.weave.drawing import draw_drawdown
from loomlight.weave.named import named_weave
from tests.helpers.pictures import png_head

require_llvm()
FAULTS: dict[str, tuple[list[str], str]] = {
    "no such command": (["rendr"], "render"),
    "no such subcommand": (["weave", "shw", "plain"], "show"),
    "no such option": (["render", "plain", "-o", "a.png", "--sp", "3"], "--spp"),
    "no number": (["render", "plain", "-o", "a.png", "--spp", "many"], "--spp many is no whole number"),
    "half a sample": (["render", "plain", "-o", "a.png", "--spp", "1.5"], "--spp 1.5 is no whole number"),
    "half a sample of a demo": (["demo", "-o", "a.png", "--spp", "1.5"], "--spp 1.5 is no whole number"),
    "no zoom": (["render", "plain", "-o", "a.png", "--zoom", "x"], "--zoom x is no number"),
    "a scene and a mesh": (
        ["render", "plain", "-o", "a.png", "--scene", "sphere", "--mesh", "shirt.obj"],
        "--scene sphere and --mesh shirt.obj both say what to clothe",
    ),
    "a close-up of a scene file": (
        ["render", "plain", "-o", "a.png", "--scene", "a.xml", "--inset"],
        "inset = True does not go with the scene a.xml",
    ),
    "a shift beyond the sun": (
        ["render", "plain", "-o", "a.png", "--shift", "1e300,0"],
        "shift = (1e+300, 0.0) is wrong: give 2 numbers from -1000000 to 1000000",
    ),
    "an unknown word in braces": (["render", "plain", "-o", "{nome}.png"], "{nome} stands for nothing"),
    "no samples": (["render", "plain", "-o", "a.png", "--spp", "0"], "--spp 0 is out of range"),
    "no size": (["render", "plain", "-o", "a.png", "--size", "big"], "960x540"),
    "no pixels": (["render", "plain", "-o", "a.png", "--size", "0x9"], "960x540"),
    "too many pixels": (["render", "plain", "-o", "a.png", "--size", "99999x9"], "16384"),
    "too many pixels in all": (["render", "plain", "-o", "a.png", "--size", "16000x16000"], "8192x8192"),
    "no exposure": (["render", "plain", "-o", "a.png", "--exposure", "nan"], "--exposure nan"),
    "no seed": (["render", "plain", "-o", "a.png", "--seed", "-1"], "--seed -1"),
    "no face": (["weave", "show", "plain", "-o", "a.png", "--face", "left"], "left"),
    "no origin": (["weave", "show", "plain", "-o", "a.png", "--origin", "left"], "left"),
    "no cell": (["weave", "show", "plain", "-o", "a.png", "--cell", "0"], "0"),
    "a huge cell": (["weave", "show", "plain", "-o", "a.png", "--cell", "99999999"], "99999999"),
    "no repeats": (["weave", "show", "plain", "-o", "a.png", "--repeats", "-2"], "-2"),
    "no window": (["bake-maps", "plain", "-o", "a.exr", "--window", "1,2,3"], "4 numbers"),
    "no resolution": (["bake-maps", "plain", "-o", "a.exr", "--resolution", "-4"], "--resolution"),
    "a window of nothing": (
        ["bake-maps", "plain", "-o", "a.exr", "--window", "0,0,0,5"],
        "width and height above 0",
    ),
    "a window far away": (["bake-maps", "plain", "-o", "a.exr", "--window", "1e30,0,1,1"], "100000"),
    "a pipe of pixels": (["render", "pipe.png", "-o", "a.png"], "pipe.png is no ordinary file"),
    "an empty field": (["render", "empty.toml", "-o", "a.png"], 'warp.count = "" is empty'),
    "an all-warp draft": (["render", "flat.wif", "-o", "a.png"], "flat.wif: none of its 2 ends and 1 picks"),
    "a draft as large as none": (["weave", "info", "huge.png"], "huge.png has 60000 x 60000 pixels"),
    "an empty mesh": (["render", "plain", "-o", "a.png", "--mesh", "empty.obj"], "empty.obj is empty"),
}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "folder.png").mkdir()
    (tmp_path / "bad.toml").write_text('weave = "plain"\ngap = 2')
    (tmp_path / "bad.wif").write_text("no draft")
    (tmp_path / "flat.wif").write_text("[WIF]\n[THREADING]\n1=1\n2=2\n[LIFTPLAN]\n1=1,2\n")
    (tmp_path / "empty.obj").touch()
    png_head(tmp_path / "huge.png", 60_000, 60_000)
    (tmp_path / "bad.png").write_bytes(b"no picture")
    (tmp_path / "empty.toml").write_text('weave = "plain"\n[warp]\ncount = ""')
    os.mkfifo(tmp_path / "pipe.wif")
    os.mkfifo(tmp_path / "pipe.png")
    return tmp_path


@pytest.mark.parametrize("name", FAULTS)
def test_a_fault_is_one_sentence(name: str, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = sorted(folder.iterdir())
    arguments, expected = FAULTS[name]
    assert run(arguments) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    lines = captured.err.splitlines()
    assert len(lines) == 1
    assert lines[0].startswith("loomlight: ")
    assert expected in lines[0]
    assert lines[0].isprintable()
    assert sorted(folder.iterdir()) == before


def test_a_warning_is_one_line(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["weave", "convert", "twill 2/2", "-o", "twill.wif"]) == 0
    text = (folder / "twill.wif").read_text()
    assert "Threads=4" in text
    (folder / "twill.wif").write_text(text.replace("Threads=4", "Threads=2"))
    capsys.readouterr()
    assert run(["weave", "info", "twill.wif"]) == 0
    warnings = capsys.readouterr().err.splitlines()
    assert warnings
    assert all(line.startswith("loomlight: warning: ") for line in warnings)


def test_an_interruption_is_one_line(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(_text: str) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("loomlight.weave.named.named_weave", interrupted)
    assert run(["weave", "info", "plain"]) == 130
    assert capsys.readouterr().err == "loomlight: interrupted. Nothing was written.\n"


@pytest.mark.parametrize(("raised", "code"), [(KeyboardInterrupt, 130), (ZeroDivisionError, None)])
def test_an_interruption_within_a_loop_of_drjit_is_one_line(
    raised: type[BaseException],
    code: int | None,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Dr.Jit raises an error of its own in its place; faults of any other kind are not hidden."""

    def body(_number: Float) -> tuple[Float]:
        raise raised

    def interrupted(_text: str) -> None:
        dr.while_loop((dr.arange(Float, 3),), lambda number: number < 2, body)

    monkeypatch.setattr("loomlight.weave.named.named_weave", interrupted)
    if code is None:
        with pytest.raises(RuntimeError):
            run(["weave", "info", "plain"])
        return
    assert run(["weave", "info", "plain"]) == code
    assert capsys.readouterr().err == "loomlight: interrupted. Nothing was written.\n"


def test_pictures_are_drafts(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write_pixels(folder / "satin.png", draw_drawdown(named_weave("satin 5/2"), cell_px=1))
    assert run(["weave", "info", "satin.png"]) == 0
    assert "5 ends, 5 picks" in capsys.readouterr().out


def test_a_warning_of_another_library_is_one_line(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "warnoptions", [])
    show = _show_each_once()
    for _ in range(2):
        show("overflow encountered\nin multiply", RuntimeWarning, "/a/b/core.py", 7)
    told = capsys.readouterr().err
    assert told == "loomlight: warning: overflow encountered in multiply (RuntimeWarning of core).\n"
