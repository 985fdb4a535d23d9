"""uv in millimetres of the cloth, x along the weft and y along the warp; tangents along x."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from loomlight.mesh.cloth_mesh import ClothMesh, cross_products, metric

Floats = NDArray[np.float64]


def with_draft_uv(mesh: ClothMesh, size: tuple[float, float]) -> ClothMesh:
    """The mesh with uv in millimetres of the draft, of which y runs to the left of x everywhere on the front.

    A draft counts from the other end of v where uv are mirrored, as in pictures, so that a twill leans the
    same way on all islands. Vertices between mirrored triangles and others are doubled.

    Args:
        mesh: with uv as `reading.py` gives them.
        size: millimetres a unit of u and of v.
    """
    mesh, mirrored = _sorted_out(mesh)
    u, v = mesh.uv.T
    return replace(mesh, uv=np.stack([u, np.where(mirrored, 1 - v, v)], axis=1) * size)


def _sorted_out(mesh: ClothMesh) -> tuple[ClothMesh, NDArray[np.bool_]]:
    """The mesh, none of whose vertices has mirrored triangles and others; which vertices are mirrored [n]."""
    area, dp_du, dp_dv = metric(mesh)
    facing = (np.cross(dp_du, dp_dv) * mesh.normals[mesh.triangles].sum(axis=1)).sum(axis=1)
    count = len(mesh.positions)
    votes = np.zeros(count)
    np.add.at(votes, mesh.triangles, np.where(np.isfinite(area), np.sign(facing), 0)[:, None])
    # Triangles whose uv collapse go with their vertices.
    mirrored = np.where(np.isfinite(area), facing < 0, votes[mesh.triangles].sum(axis=1) < 0)
    of_vertex = np.zeros((2, count), bool)
    for side in (0, 1):
        of_vertex[side, mesh.triangles[mirrored == bool(side)]] = True
    (both,) = np.nonzero(of_vertex.all(axis=0))
    renamed = np.arange(count)
    renamed[both] = count + np.arange(len(both))
    triangles = np.where(mirrored[:, None], renamed[mesh.triangles], mesh.triangles)
    doubled = mesh.taken(np.concatenate([np.arange(count), both]), triangles)
    is_mirrored = of_vertex[1].copy()
    is_mirrored[both] = False
    return doubled, np.concatenate([is_mirrored, np.ones(len(both), bool)])


def tangents(mesh: ClothMesh) -> Floats:
    """Unit vectors [n, 3] along u at vertices, across their normals; any where uv collapse."""
    area, dp_du, _ = metric(mesh)
    length = np.maximum(np.linalg.norm(dp_du, axis=1), 1e-300)
    weighted = np.nan_to_num(dp_du * (area / length)[:, None])
    sums = np.stack(
        [
            sum(np.bincount(corner, weighted[:, axis], len(mesh.positions)) for corner in mesh.triangles.T)
            for axis in range(3)
        ],
        axis=1,
    )
    flat = _across(sums, mesh.normals)
    scale = float(np.linalg.norm(cross_products(mesh), axis=1).max(initial=0))
    missing = np.linalg.norm(flat, axis=1) <= 1e-9 * scale
    if missing.any():
        # The axis that the normal is the farthest from.
        axes = np.eye(3)[np.abs(mesh.normals[missing]).argmin(axis=1)]
        flat[missing] = _across(axes, mesh.normals[missing])
    return flat / np.linalg.norm(flat, axis=1, keepdims=True)


def _across(vectors: Floats, normals: Floats) -> Floats:
    return vectors - (vectors * normals).sum(axis=1, keepdims=True) * normals
