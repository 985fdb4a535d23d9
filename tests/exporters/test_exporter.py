"""`loomlight export`: targets, folders and faults.

Covers: cli/bake.py, exporters/folder.py
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from loomlight.cli.main import run
from loomlight.exporters import TARGETS
from loomlight.mitsuba import read_mesh
from loomlight.sources.loom_file import read_loom
from tests.helpers.standard_materials import few_queries


def export(*arguments: str) -> int:
    return run(["export", "twill 2/1", *arguments])


def test_an_earlier_export_is_replaced(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "cloth"
    assert export("--to", "hlsl", "--model", "point", "-o", str(folder)) == 0
    assert capsys.readouterr().out == f"{folder}\n"
    assert (folder / "cloth.hlsl").is_file()
    assert export("--to", "glsl", "--model", "point", "-o", str(folder)) == 0
    assert not (folder / "cloth.hlsl").exists()
    assert (folder / "cloth.glsl").is_file()
    assert [path.name for path in tmp_path.iterdir()] == ["cloth"]


def test_a_gltf_file_is_read_again(tmp_path: Path) -> None:
    """The smallest of all cloths; test_materials.py asks more of a larger one."""
    with few_queries():
        given = ["plain", "--to", "gltf", "--distance", "10", "-o", str(tmp_path / "cloth")]
        assert run(["export", *given]) == 0
    mesh = read_mesh(tmp_path / "cloth" / "cloth.glb")
    assert np.ptp(mesh.positions, axis=0)[:2] == pytest.approx([0.1, 0.1], rel=1e-5)
    assert (tmp_path / "cloth" / "textures" / "normal.png").is_file()


@pytest.mark.slow
def test_a_material_of_fewer_groups_is_exported_as_it_is(tmp_path: Path) -> None:
    """Such as one baked when 8 groups of a family were the default."""
    material = tmp_path / "cloth.loom"
    assert run(["bake", "plain", "--model", "lobes", "--set", "groups=8", "-o", str(material)]) == 0
    baked = read_loom(material).tensors
    assert baked["moments"].shape[1] == 16
    folder = tmp_path / "cloth"
    assert run(["export", str(tmp_path / "cloth.loom"), "--to", "wgsl", "-o", str(folder)]) == 0
    words = b"".join(file.read_bytes() for file in sorted(folder.glob("*.bin")))
    for name in ("moments", "irradiance", "joint"):
        assert baked[name].tobytes() in words, name


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["--to", "hsls", "-o", "x"], '--to "hsls" is unknown: use one of slang, wgsl'),
        (["--to", "wgsl", "--model", "samples", "-o", "x"], 'does not take the model "samples"'),
        (["--to", "wgsl", "--model", "neumip", "-o", "x"], "takes minutes: bake it with"),
        (["--to", "wgsl", "--distance", "1", "-o", "x"], "leave out --distance"),
        (["--to", "gltf", "--distance", "0", "-o", "x"], "from 0.01 to 1000"),
        (["--to", "wgsl", "-o", "no/x"], "does not exist; make it first"),
        (["--to", "wgsl", "-o", "file"], "file is a file"),
        (["--to", "wgsl", "-o", "full"], "full holds other files"),
    ],
)
def test_faults_are_one_sentence(arguments: list[str], says: str, refused: Callable[..., str]) -> None:
    Path("file").touch()
    Path("full").mkdir()
    Path("full/other.txt").touch()
    assert says in refused(arguments, lambda given: export(*given))


def test_a_fault_leaves_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["export", "no such weave", "--to", "wgsl", "-o", str(tmp_path / "x")]) == 2
    assert "no such weave" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_help_names_every_target(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["export", "--help"]) == 0
    text = capsys.readouterr().out
    assert all(name in text for name in TARGETS)
