"""Which cloth each part of a mesh file wears, at its own scale, and where the weave lies on it."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.core.picture_settings import Placement
from loomlight.core.sentences import closest, shown
from loomlight.mesh.cloth_mesh import (
    ClothMesh,
    MeshPart,
    at_one_scale,
    joined,
    uv_size,
    warn_of_extent,
    warn_of_inside_out,
    warn_of_scale,
)
from loomlight.mesh.garments import garment_parts
from loomlight.mesh.writing import write_mesh

ClothT = TypeVar("ClothT")


@dataclass(frozen=True)
class Garment(Generic[ClothT]):
    """A mesh file, in a piece for each cloth, of one scale of uv.

    Attributes:
        pieces: meshes, in metres, and the cloth of each.
        uncovered: the triangles that have no uv; None where all have.
        parts: those of the file, in metres; none of a piece that is no file's.
        turns: degrees by which the cloth of each piece is turned, beyond that of all.
        members: of each piece the parts that it is joined of, as they are in the file.
    """

    pieces: list[tuple[ClothMesh, ClothT]]
    uncovered: ClothMesh | None
    parts: Sequence[MeshPart] = ()
    turns: Sequence[float] = (0.0,)
    members: Sequence[Sequence[MeshPart]] = ()

    @property
    def meshes(self) -> list[ClothMesh]:
        """All triangles, covered ones first."""
        covered = [mesh for mesh, _ in self.pieces]
        return covered if self.uncovered is None else [*covered, self.uncovered]


def read_garment(
    path: str | os.PathLike[str],
    metres_per_unit: float,
    cloth: ClothT,
    others: Mapping[str, ClothT],
    *,
    unwrap: bool | None = None,
    turns: Mapping[str, float] | None = None,
    save: str | os.PathLike[str] | None = None,
    time: float | None = None,
) -> Garment[ClothT]:
    """A mesh file whose parts are given `cloth`, or one of `others` by the name of the part or its material.

    The name of a piece that was cut goes before that of its part, and that before its material's. Warnings
    say so where uv have several scales within a piece, and where the whole is of no size of cloth.

    Args:
        metres_per_unit: the length of one unit of the file's positions.
        unwrap: see `garment_parts`.
        turns: degrees by which `others` are turned, by the same names.
        save: where the mesh is written as it is clothed; see `write_mesh`.
        time: as `read_parts` takes it.

    Raises:
        InputError: what `read_parts` raises, no usable uv, or a name that no part with uv has.
    """
    parts = garment_parts(path, metres_per_unit, unwrap, others, time)
    covered = [part for part in parts if len(part.mesh.uv)]
    warn_of_inside_out(covered, path)
    for name in others:
        _require_part(name, parts, covered, path)
    if save is not None:
        write_mesh(Path(save), parts)
    keys = [next((key for key in part.names if key in others), None) for part in covered]
    pieces, members = [], []
    for key in (found := list(dict.fromkeys(keys))):
        members.append([part for part, own in zip(covered, keys, strict=True) if own == key])
        whole = at_one_scale([part.mesh for part in members[-1]])
        pieces.append((whole, cloth if key is None else others[key]))
    bare = [part.mesh for part in parts if not len(part.mesh.uv)]
    turned = [(turns or {}).get(key or "", 0.0) for key in found]
    garment = Garment(pieces, joined(bare) if bare else None, parts, turned, members)
    warn_of_extent(joined([mesh for mesh, _ in pieces]), metres_per_unit)
    for mesh, _ in pieces:
        warn_of_scale(mesh)
    return garment


def split(mesh: ClothMesh, members: Sequence[MeshPart]) -> list[MeshPart]:
    """The parts that a piece was joined of, with its vertices as they are now.

    Args:
        mesh: the piece, of which vertices and triangles are as many as they were.
        members: see `Garment`.
    """
    found, vertex, triangle = [], 0, 0
    for part in members:
        count, faces = len(part.mesh.positions), len(part.mesh.triangles)
        own = mesh.triangles[triangle : triangle + faces] - vertex
        found.append(replace(part, mesh=mesh.taken(np.arange(vertex, vertex + count), own)))
        vertex, triangle = vertex + count, triangle + faces
    return found


def _require_part(
    name: str, parts: list[MeshPart], covered: list[MeshPart], path: str | os.PathLike[str]
) -> None:
    if any(name in part.names for part in covered):
        return
    if any(name in part.names for part in parts):
        raise InputError(f"{path}: the part {shown(name)} has no usable uv coordinates; unwrap it first.")
    known = dict.fromkeys(each for part in covered for each in part.names)
    advice = closest(name, known) if known else "its parts have no names."
    raise InputError(f"{path} has no part and no material {shown(name)}: {advice}")


# -------------------------------------------------------------------------------------------------- placement
# Placement of cloth on a mesh: turn, shift and scale.


def placed(mesh: ClothMesh, placement: Placement) -> tuple[ClothMesh, tuple[float, float]]:
    """A mesh with uv for cloth so placed, and its millimetres per unit of u and of v.

    Where they are as life has them nothing changes; otherwise uv become millimetres.
    """
    size = uv_size(mesh)
    if placement == Placement():
        return mesh, size
    upright = ~_mirrored(mesh)
    # Draft coordinates, as `bsdf.draft_position` has them: v is counted from its other end where mirrored.
    x, y = mesh.uv[:, 0] * size[0], np.where(upright, mesh.uv[:, 1], 1 - mesh.uv[:, 1]) * size[1]
    middle = np.array([(values.min() + values.max()) / 2 for values in (x, y)])
    angle = np.radians(placement.turn)
    # The weave turns with the angle, so the place where a point of the surface finds it turns against it.
    against = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    moved = (np.stack([x, y], axis=1) - middle - placement.shift) @ against.T / placement.scale + middle
    v = np.where(upright, moved[:, 1], 1 - moved[:, 1])
    return replace(mesh, uv=np.stack([moved[:, 0], v], axis=1)), (1.0, 1.0)


def _mirrored(mesh: ClothMesh) -> NDArray[np.bool_]:
    """Vertices of triangles whose uv run clockwise, as seen from the front."""
    a, b, c = (mesh.uv[mesh.triangles[:, corner]] for corner in range(3))
    (u1, v1), (u2, v2) = (b - a).T, (c - a).T
    turning = np.zeros(len(mesh.uv))
    for corner in range(3):
        np.add.at(turning, mesh.triangles[:, corner], u1 * v2 - u2 * v1)
    return turning < 0
