"""Normals of cloth that moves."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from loomlight.mesh.cloth_mesh import ClothMesh, vertex_normals
from loomlight.mesh.smoothing import Smoothing

TURN = np.array([[0, 0, 1], [0.6, 0.8, 0], [-0.8, 0.6, 0]])


def mesh_of(positions: NDArray[np.float64], triangles: NDArray[np.int64]) -> ClothMesh:
    return ClothMesh(positions, vertex_normals(positions, triangles), np.zeros((0, 2)), triangles, "mesh")


def split(mesh: ClothMesh) -> ClothMesh:
    """The mesh with vertices of its own for each triangle, and the normals that they had together."""
    return mesh.taken(mesh.triangles.ravel(), np.arange(mesh.triangles.size).reshape(-1, 3))


def bump(height: float) -> ClothMesh:
    """A bump on a grid of 13 × 13 vertices, whose exact normals follow from its slope."""
    x, y = (values.ravel() for values in np.meshgrid(*[np.linspace(-1, 1, 13)] * 2))
    z = height * np.exp(-2 * (x**2 + y**2))
    a = (np.arange(12)[:, None] * 13 + np.arange(12)).ravel()
    triangles = np.concatenate([np.stack([a, a + 1, a + 14], 1), np.stack([a, a + 14, a + 13], 1)])
    return mesh_of(np.stack([x, y, z], axis=1), triangles)


def test_seams_are_smooth_in_every_frame() -> None:
    first, later = split(bump(0.1)), split(bump(0.4))
    found = Smoothing.of(first).of_moved(replace(later, normals=first.normals)).normals
    x, y, z = later.positions.T
    exact = np.stack([4 * x * z, 4 * y * z, np.ones_like(z)], axis=1)
    exact /= np.linalg.norm(exact, axis=1, keepdims=True)
    inside = (np.abs(later.positions[:, :2]) < 0.9).all(axis=1)
    # Triangles of a sixth of the bump's radius: 3 degrees.
    assert (np.sum(found * exact, axis=1)[inside] > np.cos(np.radians(3))).all()
    # One place, one normal.
    _, place = np.unique(np.round(later.positions, 9), axis=0, return_inverse=True)
    means = np.stack([np.bincount(place, normal) / np.bincount(place) for normal in found.T], axis=1)
    np.testing.assert_allclose(found, means[place], atol=1e-12)


def test_sharp_edges_stay_sharp() -> None:
    """A sheet folded by 90 degrees, whose file has two normals along the fold, and turned."""
    positions = np.array([[0, 0, 0], [0, 1, 0], [1, 0, 0], [0, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    triangles = np.array([[0, 2, 1], [3, 4, 5]])
    folded = mesh_of(positions, triangles)
    found = Smoothing.of(folded).of_moved(replace(folded, positions=positions @ TURN.T))
    np.testing.assert_allclose(found.normals, folded.normals @ TURN.T, atol=1e-12)


def test_triangles_wound_against_their_normals_keep_them() -> None:
    """And where all triangles have collapsed the normal before it stays."""
    mesh = bump(0.2)
    wound = replace(mesh, triangles=mesh.triangles[:, ::-1])
    smoothing = Smoothing.of(wound)
    np.testing.assert_allclose(smoothing.of_moved(wound).normals, mesh.normals, atol=1e-12)
    flat = replace(wound, positions=0 * wound.positions)
    np.testing.assert_array_equal(smoothing.of_moved(flat).normals, mesh.normals)
