"""Catmull–Clark surfaces against points by hand and against limits that are known.

Covers: mesh/subdivision.py
"""

from __future__ import annotations

import numpy as np
import pytest

from loomlight.mesh.subdivision import Polygons

CUBE = np.array([(x, y, z) for z in (-1.0, 1.0) for y in (-1.0, 1.0) for x in (-1.0, 1.0)])
FACES = np.array([(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)])
NONE = np.zeros((0, 2), np.int64), np.zeros(0)


def cube(*creases: tuple[int, int], sharpness: float = 0.0) -> Polygons:
    given = (np.array(creases), np.full(len(creases), sharpness)) if creases else NONE
    return Polygons(FACES.ravel(), np.full(6, 4), 8, *given)


def test_a_cube() -> None:
    """Of the first level by hand: vertices at 5/9, edges at 3/4 and faces at 1."""
    points = cube().moved(CUBE)
    assert len(points) == 8 + 12 + 6
    np.testing.assert_allclose(points[:8], CUBE * 5 / 9)
    # Of an edge: the mean of both ends and of the middles of both faces.
    np.testing.assert_allclose(np.sort(np.abs(points[8:20]), axis=1), np.tile([0, 0.75, 0.75], (12, 1)))
    np.testing.assert_allclose(np.sort(np.abs(points[20:]), axis=1), np.tile([0, 0, 1], (6, 1)))


def test_faces_keep_their_sense_and_close() -> None:
    polygons, points = cube(), CUBE
    for _ in range(2):
        polygons, points = polygons.finer(), polygons.moved(points)
    quads = points[polygons.corners.reshape(-1, 4)]
    normals = np.cross(quads[:, 2] - quads[:, 0], quads[:, 3] - quads[:, 1])
    assert (np.einsum("ij,ij->i", normals, quads.mean(axis=1)) > 0).all()
    np.testing.assert_allclose(normals.sum(axis=0), 0, atol=1e-12)
    assert polygons.points == len(points) == len(np.unique(polygons.corners))


def test_a_flat_grid_stays_flat_and_its_corners_stay() -> None:
    x, y = (axis.ravel() for axis in np.meshgrid(np.arange(3.0), np.arange(3.0)))
    first = np.array([0, 1, 3, 4])
    faces = first[:, None] + np.array([0, 1, 4, 3])
    grid = Polygons(faces.ravel(), np.full(4, 4), 9, *NONE)
    points = grid.moved(np.stack([x, y, 0 * x], axis=1))
    np.testing.assert_allclose(points[:9, :2], np.stack([x, y], axis=1))
    np.testing.assert_allclose(np.sort(points[9:, 0] % 0.5), 0, atol=1e-12)


def test_creases_stay_sharp_for_their_levels() -> None:
    edges = [(4, 5), (5, 7), (7, 6), (6, 4)]  # around the face z = 1
    soft = cube(*edges, sharpness=1.0)
    points = soft.moved(CUBE)
    ring = points[[4, 5, 6, 7]]
    # A closed curve of four corners: 6/8 of each and 1/8 of both neighbours.
    np.testing.assert_allclose(ring, CUBE[4:] * [0.75, 0.75, 1])
    again = soft.finer()
    assert set(again.sharpness.tolist()) == {0}
    assert len(again.creases) == 8
    assert again.moved(points)[4:8, 2].max() < 1


def test_values_of_corners_are_linear() -> None:
    triangle = Polygons(np.array([0, 1, 2]), np.array([3]), 3, *NONE)
    values = triangle.spread(np.array([[0.0], [3.0], [6.0]]))
    assert values.ravel().tolist() == pytest.approx([0, 1.5, 3, 3, 3, 4.5, 3, 1.5, 6, 3, 3, 4.5])
    assert triangle.finer().counts.tolist() == [4, 4, 4]
    assert triangle.face.tolist() == [0, 0, 0]
