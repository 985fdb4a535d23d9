"""Pieces of cloth that are made of formulas: closed where they should be, unit normals, uv to scale.

Covers: studies/papers/zhu2024/cloth_pieces.py
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from loomlight.mesh.cloth_mesh import uv_size
from loomlight.mitsuba import ClothMesh, shapes
from studies.papers.zhu2024 import cloth_pieces

PIECES = {
    "couch": cloth_pieces.couch,
    "pillow": lambda: cloth_pieces.pillow((0.0, 0.5, 0.0)),
    "blanket": cloth_pieces.blanket,
    "blouse": cloth_pieces.blouse_body,
    "sleeves": cloth_pieces.blouse_sleeves,
    "gown": cloth_pieces.gown,
    "overskirt": cloth_pieces.overskirt,
}


@pytest.mark.quick("gown")
@pytest.mark.parametrize("name", PIECES)
def test_normals_are_those_of_the_triangles(name: str) -> None:
    make: Callable[[], ClothMesh] = PIECES[name]
    mesh = make()
    assert np.isfinite(mesh.positions).all()
    assert np.allclose(np.linalg.norm(mesh.normals, axis=1), 1)
    a, b, c = (mesh.positions[mesh.triangles[:, corner]] for corner in range(3))
    cross = np.cross(b - a, c - a)
    area = np.linalg.norm(cross, axis=1)
    mean = mesh.normals[mesh.triangles].mean(axis=1)
    facing = np.sum(cross * mean, axis=1) / np.maximum(area, 1e-12)
    # By area: seams of pillows are sharp.
    assert area @ (facing > 0.7) > 0.98 * area.sum()


@pytest.mark.quick("gown")
@pytest.mark.parametrize("name", PIECES)
def test_thread_counts_are_those_of_cloth(name: str) -> None:
    """A unit of u and v is between a tenth and three metres of cloth."""
    make: Callable[[], ClothMesh] = PIECES[name]
    for millimetres in uv_size(make()):
        assert 100 < millimetres < 3000


def test_boxes_are_closed_and_within_their_bounds() -> None:
    low, high = (-0.2, 0.0, -0.1), (0.3, 0.4, 0.2)
    box = cloth_pieces.rounded_box(low, high, 0.05)
    assert np.allclose(box.positions.min(axis=0), low)
    assert np.allclose(box.positions.max(axis=0), high)
    a, b, c = (box.positions[box.triangles[:, corner]] for corner in range(3))
    # Divergence theorem: a closed surface that faces outwards has its volume, here that of the rounded box.
    volume = np.sum(a * np.cross(b, c)) / 6
    side, radius = np.subtract(high, low) - 0.1, 0.05
    expected = side.prod() + 2 * radius * (side[0] * side[1] + side[1] * side[2] + side[0] * side[2])
    expected += np.pi * radius**2 * side.sum() + 4 / 3 * np.pi * radius**3
    assert volume == pytest.approx(expected, rel=5e-3)


def test_grids_may_be_longer_than_wide() -> None:
    mesh = shapes.grid_surface((3, 5), lambda u, v: (u, v, 0 * u), "sheet", stays_within=True)
    assert mesh.positions.shape == (15, 3)
    assert len(mesh.triangles) == 2 * 2 * 4
    assert np.allclose(mesh.normals, [0, 0, 1])
