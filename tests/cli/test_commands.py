"""What the commands do, and how little they load for it.

Covers: cli/doctor.py, cli/main.py, cli/weave.py
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import loomlight
from loomlight.cli.main import run
from loomlight.core.extras import required_packages
from loomlight.weave.load import load_draft
from loomlight.weave.named import named_weave, weave_names
from loomlight.weave.wif_reader import read_wif
from tests.limits import HANG


def test_show(tmp_path: Path) -> None:
    front, back = tmp_path / "front.png", tmp_path / "back.png"
    assert run(["weave", "show", "twill 3/1", "-o", str(front), "--drawdown", "--cell", "8"]) == 0
    assert (
        run(["weave", "show", "twill 3/1", "-o", str(back), "--drawdown", "--cell", "8", "--face", "back"])
        == 0
    )
    assert Image.open(front).size == Image.open(back).size
    assert not np.array_equal(np.asarray(Image.open(front)), np.asarray(Image.open(back)))


def test_show_stands_as_in_weaving_software_and_can_be_read_again_from_the_other_corner(
    tmp_path: Path,
) -> None:
    drawdown = named_weave("crepe").drawdown
    for origin, expected in (([], drawdown[::-1, ::-1]), (["--origin", "bottom-left"], drawdown)):
        path = tmp_path / "crepe.png"
        assert run(["weave", "show", "crepe", "-o", str(path), "--drawdown", "--cell", "1", *origin]) == 0
        np.testing.assert_array_equal(load_draft(path).drawdown, expected)


def test_convert_round_trips(tmp_path: Path) -> None:
    path = tmp_path / "tooth.wif"
    assert run(["weave", "convert", "houndstooth", "-o", str(path)]) == 0
    again, draft = read_wif(path), named_weave("houndstooth")
    np.testing.assert_array_equal(again.drawdown, draft.drawdown)
    assert again.warp.colors is not None
    assert draft.warp.colors is not None
    np.testing.assert_allclose(again.warp.colors, draft.warp.colors, atol=1e-6)


def test_names(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["weave", "names"]) == 0
    assert capsys.readouterr().out.splitlines() == weave_names()


def test_a_fabric_file_is_a_draft_too(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "a.toml").write_text('weave = "twill 2/2"\n[warp]\ncolor = ["#f00", "#0f0", "#00f"]')
    assert run(["weave", "info", str(tmp_path / "a.toml")]) == 0
    assert "12 ends, 4 picks" in capsys.readouterr().out


@pytest.mark.parametrize("arguments", [[], ["weave"]])
def test_no_arguments_show_the_help(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert run(arguments) == 0
    captured = capsys.readouterr()
    assert "Commands:" in captured.out
    assert captured.err == ""


def test_version(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["--version"]) == 0
    assert capsys.readouterr().out == f"loomlight {loomlight.__version__}\n"


def in_a_process(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, *arguments], capture_output=True, text=True, timeout=HANG)


@pytest.mark.parametrize("suffix", ["png", "jpg"])
def test_a_loom_serves_as_a_draft(suffix: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """`weave` takes a .loom wherever it takes the fabric file that it was baked of."""
    fabric = tmp_path / "cloth.toml"
    fabric.write_text('weave = "twill 2/1"\nends_per_cm = 14\n[warp]\ncount = "30 tex"\n')
    loomlight.save(loomlight.bake(fabric, "point"), tmp_path / "cloth.loom")
    told = []
    for name in ("cloth.toml", "cloth.loom"):
        picture = tmp_path / f"{name}.{suffix}"
        assert run(["weave", "show", str(tmp_path / name), "-o", str(picture)]) == 0
        assert run(["weave", "convert", str(tmp_path / name), "-o", str(tmp_path / f"{name}.wif")]) == 0
        capsys.readouterr()
        assert run(["weave", "info", str(tmp_path / name)]) == 0
        told.append((capsys.readouterr().out, picture.read_bytes(), (tmp_path / f"{name}.wif").read_text()))
    assert told[0] == told[1]
    assert "weight" in told[0][0]


def loaded_by(statement: str) -> set[str]:
    """Which of the heavy packages are loaded after `statement`."""
    heavy = ("drjit", "mitsuba", "scipy", "trimesh")
    done = in_a_process("-c", f"import sys\n{statement}\nprint(*[n for n in {heavy} if n in sys.modules])")
    assert done.returncode == 0, done.stderr
    return set(done.stdout.splitlines()[-1].split())


def test_drafts_need_no_renderer(tmp_path: Path) -> None:
    for arguments in (
        ["weave", "show", "houndstooth", "-o", str(tmp_path / "a.png")],
        ["weave", "convert", "houndstooth", "-o", str(tmp_path / "a.wif")],
        ["weave", "info", str(tmp_path / "a.wif")],
        ["--help"],
    ):
        assert loaded_by(f"from loomlight.cli.main import run\nassert run({arguments}) == 0") == set()


def test_exit_codes_of_the_process(tmp_path: Path) -> None:
    done = in_a_process("-m", "loomlight", "weave", "info", "no such weave")
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith("loomlight: ")
    assert "Traceback" not in done.stderr
    done = in_a_process("-m", "loomlight", "weave", "info", "plain")
    assert (done.returncode, done.stderr) == (0, "")


def test_a_reader_that_has_enough_is_no_fault() -> None:
    program = f"{sys.executable} -m loomlight weave names | true"
    program += f"; {sys.executable} -m loomlight weave | true"
    done = subprocess.run(
        ["bash", "-o", "pipefail", "-c", program], capture_output=True, text=True, timeout=HANG
    )
    assert done.stderr == ""
    assert done.returncode == 0


def test_the_doctor_finds_this_machine_usable() -> None:
    done = in_a_process("-m", "loomlight", "doctor")
    assert done.stderr == ""
    assert done.returncode == 0, done.stdout
    for subject in ("Python", "mitsuba", "LLVM", "SIMD kernels", "CUDA"):
        assert subject in done.stdout
    required = required_packages()
    for name in (*required.pop(""), *(f"[{extra}]" for extra in required if extra != "dev")):
        assert f" {name} " in done.stdout


def test_the_doctor_says_what_is_missing(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("loomlight.core.llvm.llvm_version", lambda: (14, 0, 6))
    assert run(["doctor"]) == 1
    text = capsys.readouterr().out
    assert "14.0.6" in text
    assert "libllvm19" in text
    assert "cannot render yet" in text
