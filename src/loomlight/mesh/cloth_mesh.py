"""Triangles with uv, checked.

uv follows Mitsuba's bitmaps, v running down the image.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError

# Areas are computed of squares, in single precision too.
MAX_COORDINATE = 1e15
# Each part costs about a millisecond, however small it is.
MAX_PARTS = 20_000


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
    """The mesh of one cloth, cleaned.

    Raises:
        InputError: what `cleaned` raises, no triangles, or no usable uv.
    """
    mesh = cleaned(mesh)
    if len(mesh.triangles) == 0:
        raise InputError(f"{mesh.name} holds no triangles that have an area.")
    if len(mesh.uv) != len(mesh.positions) or not np.isfinite(mesh.uv).all():
        raise InputError(f"{mesh.name} has no uv coordinates; unwrap it first.")
    if collapses(mesh):
        raise InputError(f"{mesh.name}: its uv coordinates collapse to lines or points; unwrap it first.")
    return mesh


def cleaned(mesh: ClothMesh) -> ClothMesh:
    """The triangles that have an area, their vertices, and unit normals, computed where there are none.

    uv stay as they are, finite or not.

    Raises:
        InputError: an index out of range, or a position that is not finite or too large to compute with.
    """
    count, triangles = len(mesh.positions), mesh.triangles
    check_indices(triangles, count, mesh.name)
    if not (np.abs(mesh.positions[triangles]) < MAX_COORDINATE).all():
        raise InputError(f"{mesh.name} is damaged: a vertex position is not finite, or beyond ±1e15.")
    triangles = triangles[np.any(cross_products(mesh) != 0, axis=1)]
    used = np.zeros(count, bool)
    used[triangles] = True
    mesh = ClothMesh(
        positions=mesh.positions[used],
        normals=mesh.normals[used] if len(mesh.normals) == count else np.zeros((used.sum(), 3)),
        uv=mesh.uv[used] if len(mesh.uv) == count else np.zeros((0, 2)),
        triangles=(np.cumsum(used) - 1)[triangles],
        name=mesh.name,
    )
    usable = np.isfinite(mesh.normals).all(axis=1, keepdims=True)
    normals = np.clip(np.where(usable, mesh.normals, 0), -1e100, 1e100)
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    if (length == 0).any():
        normals = np.where(length == 0, vertex_normals(mesh.positions, mesh.triangles), normals)
        length = np.linalg.norm(normals, axis=1, keepdims=True)
    return ClothMesh(mesh.positions, normals / length, mesh.uv, mesh.triangles, mesh.name)


def check_indices(indices: NDArray[np.int64], count: int, name: str) -> None:
    """Raises InputError if one of `indices` names none of `count` vertices."""
    wrong = (indices < 0) | (indices >= count)
    if wrong.any():
        raise InputError(
            f"{name} is damaged: a face names vertex {indices[wrong][0]}, and there are {count}, from 0 on."
        )


def collapses(mesh: ClothMesh) -> bool:
    """Whether more than half of the area has uv on lines or points; seams may collapse a few triangles."""
    area, _, _ = metric(mesh)
    return bool(np.nansum(area) < 0.25 * np.linalg.norm(cross_products(mesh), axis=1).sum())


def joined(parts: list[ClothMesh]) -> ClothMesh:
    """One mesh of all parts; raises InputError if some have uv and one has none."""
    if any(len(part.uv) for part in parts) and any(len(part.uv) != len(part.positions) for part in parts):
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
    area = np.linalg.norm(cross_products(mesh), axis=1) / 2
    return np.where(usable, area, np.nan), dp_du, dp_dv


def vertex_normals(positions: NDArray[np.float64], triangles: NDArray[np.int64]) -> NDArray[np.float64]:
    """Unit normals [n, 3] of vertices, weighted by areas; up (+y) where no area is known."""
    a, b, c = (positions[triangles[:, corner]] for corner in range(3))
    weighted = np.cross(b - a, c - a)
    normals = np.stack(
        [
            sum(np.bincount(corner, weighted[:, axis], len(positions)) for corner in triangles.T)
            for axis in range(3)
        ],
        axis=1,
    )
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    return np.where(length > 0, normals / np.maximum(length, 1e-300), [0.0, 1.0, 0.0])
