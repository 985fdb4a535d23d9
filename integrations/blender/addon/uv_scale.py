# SPDX-License-Identifier: GPL-3.0-or-later
"""Millimetres that one unit of u and of v are on the surface of a mesh object."""

from __future__ import annotations

import bpy
import numpy as np

# Triangles that are stretched more than this against the median are left out of the mean.
_STRETCH = 2.0


def uv_size(thing: bpy.types.Object, metres_per_unit: float) -> tuple[float, float] | None:
    """Millimetres a unit of u and of v, whatever a few stretched triangles say; None without usable uv.

    Each is the area-weighted root mean square of |dp/du| or |dp/dv| over the triangles within a factor of 2
    of the area-weighted median, in the world as the object is scaled there.
    """
    mesh = thing.data
    layer = mesh.uv_layers.active
    if layer is None or not len(mesh.polygons):
        return None
    mesh.calc_loop_triangles()
    corners = _numbers(mesh.loop_triangles, "loops", 3, np.int32)
    vertices = _numbers(mesh.loop_triangles, "vertices", 3, np.int32)
    local = _numbers(mesh.vertices, "co", 3, np.float32).astype(float)
    places = local @ np.array(thing.matrix_world)[:3, :3].T
    uv = _numbers(layer.uv, "vector", 2, np.float32).astype(float)[corners]
    a, b, c = (places[vertices[:, corner]] for corner in range(3))
    (u1, v1), (u2, v2) = (uv[:, 1] - uv[:, 0]).T, (uv[:, 2] - uv[:, 0]).T
    determinant = u1 * v2 - u2 * v1
    extent = np.abs([u1, v1, u2, v2]).max(axis=0)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    usable = (np.abs(determinant) > 1e-6 * np.maximum(extent, 1e-12) ** 2) & (area > 0)
    if not usable.any():
        return None
    inverse = 1 / determinant[usable, None]
    along, across = (b - a)[usable], (c - a)[usable]
    dp_du = (v2[usable, None] * along - v1[usable, None] * across) * inverse
    dp_dv = (u1[usable, None] * across - u2[usable, None] * along) * inverse
    factor = 1000 * metres_per_unit
    return _typical(dp_du, area[usable]) * factor, _typical(dp_dv, area[usable]) * factor


def _numbers(items: bpy.types.bpy_prop_collection, name: str, width: int, kind: type) -> np.ndarray:
    found = np.empty(len(items) * width, kind)
    items.foreach_get(name, found)
    return found.reshape(-1, width)


def _typical(vectors: np.ndarray, area: np.ndarray) -> float:
    stretch = np.linalg.norm(vectors, axis=1)
    order = np.argsort(stretch)
    cumulative = np.cumsum(area[order])
    median = stretch[order[np.searchsorted(cumulative, 0.5 * cumulative[-1] * (1 - 1e-9))]]
    near = (stretch >= median / _STRETCH) & (stretch <= median * _STRETCH)
    return float(np.sqrt(np.average(stretch[near] ** 2, weights=area[near])))
