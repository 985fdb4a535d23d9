"""Triangles with uv, checked.

uv follows Mitsuba's bitmaps, v running down the image.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError


@dataclass(frozen=True, eq=False)
class ClothMesh:
    """Triangles with uv.

    Attributes:
        positions: [n, 3], the file's units.
        normals: unit vertex normals [n, 3].
        uv: [n, 2].
        triangles: vertex indices [m, 3], counter-clockwise from the front.
        name: the file, for messages.
    """

    positions: NDArray[np.float64]
    normals: NDArray[np.float64]
    uv: NDArray[np.float64]
    triangles: NDArray[np.int64]
    name: str

    def scaled(self, factor: float) -> ClothMesh:
        """The same mesh with lengths multiplied by `factor`."""
        return ClothMesh(self.positions * factor, self.normals, self.uv, self.triangles, self.name)


@dataclass(frozen=True, eq=False)
class MeshPart:
    """A part of a mesh file that can be clothed by itself.

    Attributes:
        name: of its object or group; "" where the file gives none.
        material: its material's name; "" where the file gives none.
        mesh: its triangles; `uv` is [0, 2] where the part has none.
    """

    name: str
    material: str
    mesh: ClothMesh


def checked(mesh: ClothMesh) -> ClothMesh:
    """The mesh with normals, which are computed where it has none.

    Raises:
        InputError: no triangles, an index or a number that is none, no area, or no usable uv.
    """
    count = len(mesh.positions)
    if len(mesh.triangles) == 0:
        raise InputError(f"{mesh.name} holds no triangles.")
    if mesh.triangles.min() < 0 or mesh.triangles.max() >= count:
        raise InputError(f"{mesh.name} is damaged: a triangle names a vertex that is not there.")
    if not np.isfinite(mesh.positions).all():
        raise InputError(f"{mesh.name} is damaged: a vertex position is not finite.")
    if len(mesh.uv) != count or not np.isfinite(mesh.uv).all():
        raise InputError(f"{mesh.name} has no uv coordinates; unwrap it first.")
    normals = mesh.normals
    if len(normals) != count or not np.isfinite(normals).all() or not np.any(normals):
        normals = _vertex_normals(mesh)
    mesh = ClothMesh(mesh.positions, normals, mesh.uv, mesh.triangles, mesh.name)
    area, _, _ = metric(mesh)
    total = np.linalg.norm(cross_products(mesh), axis=1).sum() / 2
    if total == 0:
        raise InputError(f"{mesh.name} is flat to a line: none of its triangles has an area.")
    # Seams may collapse a few triangles in uv; cloth whose larger part has no uv cannot be woven.
    if np.nansum(area) < 0.5 * total:
        raise InputError(f"{mesh.name}: its uv coordinates collapse to lines or points; unwrap it first.")
    return mesh


def joined(parts: list[ClothMesh]) -> ClothMesh:
    """One mesh of all parts; raises InputError if one has no uv."""
    if any(len(part.uv) != len(part.positions) for part in parts):
        raise InputError(f"{parts[0].name}: a part of the mesh has no uv coordinates; unwrap it first.")
    starts = np.cumsum([0] + [len(part.positions) for part in parts[:-1]])

    def stacked(values: Callable[[ClothMesh], NDArray[np.float64]]) -> NDArray[np.float64]:
        return np.concatenate([values(part) for part in parts])

    return ClothMesh(
        positions=stacked(lambda part: part.positions),
        normals=stacked(lambda part: part.normals),
        uv=stacked(lambda part: part.uv),
        triangles=np.concatenate([part.triangles + start for part, start in zip(parts, starts, strict=True)]),
        name=parts[0].name,
    )


def cross_products(mesh: ClothMesh) -> NDArray[np.float64]:
    """Of each triangle's edges [m, 3]: normals, of twice the area's length."""
    a, b, c = (mesh.positions[mesh.triangles[:, corner]] for corner in range(3))
    return np.cross(b - a, c - a)


def metric(mesh: ClothMesh) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Area [m] (NaN where the uv collapses), dp/du and dp/dv [m, 3] of each triangle."""
    a, b, c = (mesh.positions[mesh.triangles[:, corner]] for corner in range(3))
    uv_a, uv_b, uv_c = (mesh.uv[mesh.triangles[:, corner]] for corner in range(3))
    (u1, v1), (u2, v2) = (uv_b - uv_a).T, (uv_c - uv_a).T
    determinant = u1 * v2 - u2 * v1
    extent = np.abs([u1, v1, u2, v2]).max(axis=0)
    usable = np.abs(determinant) > 1e-6 * np.maximum(extent, 1e-12) ** 2
    inverse = np.where(usable, 1 / np.where(usable, determinant, 1), np.nan)[:, None]
    dp_du = (v2[:, None] * (b - a) - v1[:, None] * (c - a)) * inverse
    dp_dv = (u1[:, None] * (c - a) - u2[:, None] * (b - a)) * inverse
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    return np.where(usable, area, np.nan), dp_du, dp_dv


def _vertex_normals(mesh: ClothMesh) -> NDArray[np.float64]:
    normals = np.zeros_like(mesh.positions)
    weighted = cross_products(mesh)
    for corner in range(3):
        np.add.at(normals, mesh.triangles[:, corner], weighted)
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    return np.where(length > 0, normals / np.maximum(length, 1e-300), [0.0, 1.0, 0.0])
