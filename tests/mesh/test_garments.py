"""Meshes are cut once: the next command finds the cut, and a damaged one is made anew.

Covers: mesh/garments.py
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from loomlight.core.files import cache_folder
from loomlight.mesh import garments
from loomlight.mesh.cloth_mesh import MeshPart
from loomlight.mesh.garments import garment_parts
from loomlight.mesh.unwrap import CutPieces, cut_pieces
from loomlight.mesh.writing import write_mesh
from studies.instruments.garment_shapes import skirt

pytestmark = pytest.mark.filterwarnings("ignore:.*is cut into")


@pytest.fixture
def cuts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Counts meshes that are cut, with caches of their own."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setattr(garments, "_held", {})
    counted: list[int] = []

    def counting(parts: list[MeshPart]) -> CutPieces:
        counted.append(len(parts))
        return cut_pieces(parts)

    monkeypatch.setattr(garments, "cut_pieces", counting)
    write_mesh(tmp_path / "skirt.obj", [skirt(300)])
    return counted


def uv_of(file: Path, **options: float) -> np.ndarray:
    return np.concatenate([part.mesh.uv for part in garment_parts(file, **options)])


def test_a_mesh_is_cut_once(tmp_path: Path, cuts: list[int], monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "skirt.obj"
    first = uv_of(file)
    np.testing.assert_array_equal(uv_of(file), first)
    monkeypatch.setattr(garments, "_held", {})  # as in another process
    np.testing.assert_array_equal(uv_of(file), first)
    assert len(cuts) == 1
    uv_of(file, metres_per_unit=0.5)
    assert len(cuts) == 2


@pytest.mark.parametrize("content", [b"", b"no tensors", None])
def test_a_damaged_cut_is_made_anew(
    tmp_path: Path, cuts: list[int], monkeypatch: pytest.MonkeyPatch, content: bytes | None
) -> None:
    file = tmp_path / "skirt.obj"
    first = uv_of(file)
    (kept,) = cache_folder("cuts").iterdir()
    kept.write_bytes(kept.read_bytes()[:-40] if content is None else content)
    monkeypatch.setattr(garments, "_held", {})
    np.testing.assert_array_equal(uv_of(file), first)
    assert len(cuts) == 2


def test_a_cache_that_cannot_be_written_is_none(
    tmp_path: Path, cuts: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "cache").write_text("a file")
    assert len(uv_of(tmp_path / "skirt.obj"))
    assert len(cuts) == 1
