"""Where pictures lie on a mesh: uv at its vertices, of one of its sets or thrown onto it from a side."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.core.sentences import closest, shown
from loomlight.mesh.cloth_mesh import ClothMesh

Floats = NDArray[np.float64]

# The attribute of a mesh that keeps the uv of its file, whatever is done to those of its weave.
FILE_UV = "uv"
# Directions from which pictures are thrown, and where right and up are, as one looks against them.
_SIDES = {
    "front": ((0, 0, 1), (1, 0, 0), (0, 1, 0)),
    "back": ((0, 0, -1), (-1, 0, 0), (0, 1, 0)),
    "right": ((1, 0, 0), (0, 0, -1), (0, 1, 0)),
    "left": ((-1, 0, 0), (0, 0, 1), (0, 1, 0)),
    "above": ((0, 1, 0), (1, 0, 0), (0, 0, -1)),
    "below": ((0, -1, 0), (1, 0, 0), (0, 0, 1)),
}
SIDES = tuple(_SIDES)
# Of the map of depths: cells across, and how much farther behind, metres, cloth is hidden.
_DEPTH_CELLS, _BEHIND = 256, 0.02
# Points that are looked at together.
_AT_ONCE = 2_000_000
# So that what has a place is told from what has none.
_LEAST_RATIO = 1e-6


@dataclass(frozen=True)
class PicturePlace:
    """Where a picture lies on a surface.

    Attributes:
        uv: the set of uv: "uv" is the first of the mesh, "uv1" the second; or a name that its file gives.
        side: in their place, the side of `SIDES` from which the picture is thrown onto what faces it.
        width_mm: of a picture that is thrown, where None covers the garment; or of one that is printed on the
            cloth, upright along the warp, where there is no side.
        at_mm: its middle, to the right and up from the middle of what is seen, or from the weave's origin.
        repeat: it repeats beyond its edges; else there is nothing.
        aspect: height over width of the picture.
    """

    uv: str = FILE_UV
    side: str = ""
    width_mm: float | None = None
    at_mm: tuple[float, float] = (0.0, 0.0)
    repeat: bool = True
    aspect: float = 1.0

    @property
    def is_on_cloth(self) -> bool:
        """Whether it is printed on the cloth, wherever that lies on the mesh."""
        return self.width_mm is not None and not self.side


def picture_uv(mesh: ClothMesh, place: PicturePlace, whole: Sequence[ClothMesh]) -> Floats:
    """uv of a picture at the vertices of a mesh, and by what its steps differ from those of the mesh [n, 3].

    v runs down the picture. The third number is the root of the ratio of areas in uv; it is negative where
    the surface faces away from the side that a picture is thrown from, or lies behind something.

    Args:
        mesh: metres.
        whole: all pieces of the garment, among them this one.

    Raises:
        InputError: a set of uv that the mesh does not have.
    """
    faces = np.ones(len(mesh.positions))
    if place.side:
        uv, faces = _thrown(mesh, place, whole)
    else:
        if place.uv not in mesh.attributes:
            sets = [name for name, values in mesh.attributes.items() if values.shape[1] == 2]
            known = closest(place.uv, sets) if sets else 'it has none; side = "front" needs none.'
            raise InputError(f"{mesh.name} has no set of uv {shown(place.uv)} for a map: {known}")
        uv = mesh.attributes[place.uv][:, :2]
        if not np.isfinite(uv).all():
            raise InputError(f"{mesh.name}: a part of it has no set of uv {shown(place.uv)} for a map.")
    ratio = np.sqrt(_areas(uv, mesh) / np.maximum(_areas(mesh.uv, mesh), 1e-300))
    return np.column_stack([uv, faces * np.maximum(ratio, _LEAST_RATIO)])


def _thrown(mesh: ClothMesh, place: PicturePlace, whole: Sequence[ClothMesh]) -> tuple[Floats, Floats]:
    """uv [n, 2], and 1 where vertices are seen from the side, else -1 [n]."""
    towards, right, up = (np.array(axis, float) for axis in _SIDES[place.side])
    points = np.concatenate([each.positions for each in whole])
    low, high = points.min(axis=0), points.max(axis=0)
    middle, extent = (low + high) / 2, high - low
    width = float(np.abs(extent @ right))
    if place.width_mm is not None:
        width = place.width_mm / 1000
    else:  # covers what is seen, whose height may ask for more
        width = max(width, float(np.abs(extent @ up)) / place.aspect)
    x, y = (
        (mesh.positions - middle) @ axis - shift / 1000
        for axis, shift in zip((right, up), place.at_mm, strict=True)
    )
    uv = np.column_stack([x / width + 0.5, 0.5 - y / (width * place.aspect)])
    is_seen = (mesh.normals @ towards > 0) & ~_lies_behind(mesh.positions, whole, (right, up, towards))
    return uv, np.where(is_seen, 1.0, -1.0)


def _lies_behind(
    places: Floats, whole: Sequence[ClothMesh], axes: tuple[Floats, Floats, Floats]
) -> NDArray[np.bool_]:
    """Whether something lies before places [n], as one looks against the last of the axes: by a depth map."""
    frame = np.stack(axes, axis=1)
    corners = np.concatenate([each.positions[each.triangles] for each in whole]) @ frame
    origin = corners.reshape(-1, 3).min(axis=0)
    cell = float((corners.reshape(-1, 3).max(axis=0) - origin)[:2].max()) / _DEPTH_CELLS
    depth = np.full((_DEPTH_CELLS + 2) ** 2, -np.inf)

    def cells(points: Floats) -> NDArray[np.int64]:
        column, row = ((points[:, axis] - origin[axis]) / max(cell, 1e-12) for axis in (0, 1))
        return (np.rint(row) * (_DEPTH_CELLS + 2) + np.rint(column)).astype(np.int64)

    # 1. Points of each triangle, at most a cell apart.
    sides = np.ptp(corners[..., :2], axis=1).max(axis=1)
    steps = np.minimum(np.ceil(sides / max(cell, 1e-12)).astype(np.int64) + 1, 2 * _DEPTH_CELLS)
    for count in np.unique(steps):
        triangles = corners[steps == count]
        u, v = np.meshgrid(*[np.linspace(0, 1, int(count) + 1)] * 2)
        weights = np.stack([1 - u - v, u, v], axis=-1)[u + v <= 1 + 1e-9]
        for part in np.array_split(triangles, -(-len(triangles) * len(weights) // _AT_ONCE)):
            points = np.einsum("ki,mij->mkj", weights, part).reshape(-1, 3)
            np.maximum.at(depth, cells(points), points[:, 2])
    # 2. Cloth itself is about as deep as its cell says; what is farther behind is hidden.
    seen = places @ frame
    return depth[cells(seen)] > seen[:, 2] + max(_BEHIND, 3 * cell)


def _areas(uv: Floats, mesh: ClothMesh) -> Floats:
    """Area in uv of the triangles around each vertex [n]."""
    a, b, c = (uv[mesh.triangles[:, corner]] for corner in range(3))
    (u1, v1), (u2, v2) = (b - a).T, (c - a).T
    area = np.abs(u1 * v2 - u2 * v1)
    total = np.zeros(len(uv))
    for corner in mesh.triangles.T:
        total += np.bincount(corner, area, len(uv))
    return total
