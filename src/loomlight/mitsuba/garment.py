"""Mesh files of several parts: which cloth each part is given, at its own scale."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Generic, TypeVar

from loomlight.core.errors import InputError
from loomlight.core.sentences import closest, shown
from loomlight.mesh.cloth_mesh import (
    ClothMesh,
    MeshPart,
    at_one_scale,
    joined,
    warn_of_extent,
    warn_of_inside_out,
    warn_of_scale,
)
from loomlight.mesh.reading import read_parts

ClothT = TypeVar("ClothT")


@dataclass(frozen=True)
class Garment(Generic[ClothT]):
    """A mesh file, in a piece for each cloth, of one scale of uv.

    Attributes:
        pieces: meshes, in metres, and the cloth of each.
        uncovered: the triangles that have no uv; None where all have.
    """

    pieces: list[tuple[ClothMesh, ClothT]]
    uncovered: ClothMesh | None

    @property
    def meshes(self) -> list[ClothMesh]:
        """All triangles, covered ones first."""
        covered = [mesh for mesh, _ in self.pieces]
        return covered if self.uncovered is None else [*covered, self.uncovered]


def read_garment(
    path: str | os.PathLike[str], metres_per_unit: float, cloth: ClothT, others: Mapping[str, ClothT]
) -> Garment[ClothT]:
    """A mesh file whose parts are given `cloth`, or one of `others` by the name of the part or its material.

    A part's own name goes before that of its material. Warnings say so where uv have several scales within a
    piece, and where the whole is larger or smaller than cloth is.

    Args:
        metres_per_unit: the length of one unit of the file's positions.

    Raises:
        InputError: what `read_parts` raises, no usable uv, or a name that no part with uv has.
    """
    parts = read_parts(path)
    covered = [part for part in parts if len(part.mesh.uv)]
    if not covered:
        raise InputError(
            f"{path} has no uv coordinates, or they collapse to lines or points; unwrap it first."
        )
    warn_of_inside_out(covered, path)
    for name in others:
        _require_part(name, parts, covered, path)
    keys = [next((key for key in (part.name, part.material) if key in others), None) for part in covered]
    pieces = []
    for key in dict.fromkeys(keys):
        chosen = [
            part.mesh.scaled(metres_per_unit) for part, own in zip(covered, keys, strict=True) if own == key
        ]
        pieces.append((at_one_scale(chosen), cloth if key is None else others[key]))
    bare = [part.mesh.scaled(metres_per_unit) for part in parts if not len(part.mesh.uv)]
    garment = Garment(pieces, joined(bare) if bare else None)
    warn_of_extent(joined([mesh for mesh, _ in pieces]), metres_per_unit)
    for mesh, _ in pieces:
        warn_of_scale(mesh)
    return garment


def _require_part(
    name: str, parts: list[MeshPart], covered: list[MeshPart], path: str | os.PathLike[str]
) -> None:
    if any(name in (part.name, part.material) for part in covered):
        return
    if any(name in (part.name, part.material) for part in parts):
        raise InputError(f"{path}: the part {shown(name)} has no usable uv coordinates; unwrap it first.")
    known = dict.fromkeys(each for part in covered for each in (part.name, part.material) if each)
    advice = closest(name, known) if known else "its parts have no names."
    raise InputError(f"{path} has no part and no material {shown(name)}: {advice}")
