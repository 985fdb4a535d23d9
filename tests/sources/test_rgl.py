"""RGL's measured BSDFs: sources of the model latent; damaged ones are one sentence.

Covers: sources/material.py
"""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import pytest

from loomlight.cli.main import run
from loomlight.core.errors import InputError
from loomlight.mitsuba.material_btf import MaterialBtf
from loomlight.models.registry import model_from_loom
from loomlight.sources.load import load_source
from loomlight.sources.loom_file import LoomFile, read_loom, write_loom
from loomlight.sources.material import Material
from tests.fuzz.merl import merl_file, rgl_file


def up(count: int) -> np.ndarray:
    return np.tile(np.array([[0, 0, 1]], np.float32), (count, 1))


def test_a_file_is_a_material_that_its_loom_holds(tmp_path: Path) -> None:
    (tmp_path / "satin & silk.bsdf").write_bytes(rgl_file())
    source = load_source(tmp_path / "satin & silk.bsdf")
    assert isinstance(source, Material)
    write_loom(tmp_path / "a.loom", LoomFile("latent", source))
    (tmp_path / "satin & silk.bsdf").unlink()
    again = read_loom(tmp_path / "a.loom").source
    assert isinstance(again, Material)
    found = MaterialBtf(again).values(np.zeros((4, 2), np.float32), up(4), up(4), (0,))
    assert np.isfinite(found).all()
    assert (found > 0).all()


def damaged(old: bytes, new: bytes) -> bytes:
    assert old in rgl_file()
    return rgl_file().replace(old, new)


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (rgl_file()[:20], "its header cannot be read"),
        (rgl_file()[:-300], "the field rgb is not within the file"),
        (damaged(b"rgb", b"rgc"), "lacks the field rgb: take the file whose name ends in _rgb"),
        (damaged(struct.pack("<f", 0.3), struct.pack("<f", np.nan)), "rgb holds NaN or infinity"),
        (damaged(struct.pack("<Q", 3), struct.pack("<Q", 2**62)), "the field rgb is not within the file"),
        (damaged(b"\x00\x00\x00\x09\x00", b"\x00\x00\x00\x09\xff"), "its header cannot be read"),
    ],
)
def test_damage_is_one_sentence(content: bytes, says: str, tmp_path: Path) -> None:
    (tmp_path / "a.bsdf").write_bytes(content)
    with pytest.raises(InputError, match=says):
        load_source(tmp_path / "a.bsdf")


@pytest.mark.parametrize("name", ["satin_rgb.bsdf", "brass.binary"])
def test_measured_brdfs_are_baked_as_downloaded(name: str, tmp_path: Path) -> None:
    """Settings are the smallest; what is learned is another test's."""
    (tmp_path / name).write_bytes(rgl_file() if name.endswith("bsdf") else merl_file())
    options = ["decoder=2x16", "resolution=8", "steps=2", f"folder={tmp_path / 'kept'}"]
    settings = [part for option in options for part in ("--set", option)]
    assert (
        run(["bake", str(tmp_path / name), "--model", "latent", "-o", str(tmp_path / "a.loom"), *settings])
        == 0
    )
    assert model_from_loom(tmp_path / "a.loom").source.name == Path(name).stem
