"""Meshes of scenes: cloth handed to Mitsuba and taken from it, where it lies, which part wears which.

Mitsuba 3.10 changes the interface of its meshes (mitsuba3 pull request 1933): pyproject.toml admits versions
below alone.
"""

from __future__ import annotations

import os
import re
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Generic, TypeVar
from xml.etree import ElementTree

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import upload
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.picture_settings import Placement
from loomlight.core.sentences import closest, shown
from loomlight.mesh.cloth_mesh import (
    ClothMesh,
    MeshPart,
    at_one_scale,
    checked,
    joined,
    uv_size,
    warn_of_extent,
    warn_of_inside_out,
    warn_of_scale,
)
from loomlight.mesh.garments import garment_parts
from loomlight.mesh.reading import read_parts
from loomlight.mesh.writing import write_mesh


def to_shape(
    mesh: ClothMesh,
    bsdf: mi.BSDF | dict[str, Any],
    attributes: Mapping[str, NDArray[np.float64]] | None = None,
) -> mi.Mesh:
    """The mesh as a Mitsuba shape with the BSDF object or dictionary `bsdf`, and attributes of vertices."""
    props = mi.Properties()
    props["bsdf"] = mi.load_dict(bsdf) if isinstance(bsdf, dict) else bsdf
    shape = mi.Mesh(
        Path(mesh.name).stem,
        vertex_count=len(mesh.positions),
        face_count=len(mesh.triangles),
        props=props,
        has_vertex_normals=True,
        has_vertex_texcoords=True,
    )
    params = mi.traverse(shape)
    for key, rows in {"positions": mesh.positions, "normals": mesh.normals, "texcoords": mesh.uv}.items():
        params[f"vertex_{key}"] = upload(mi.Float, rows.astype(np.float32))
    params["faces"] = upload(mi.UInt32, mesh.triangles.astype(np.uint32))
    params.update()
    add_attributes(shape, attributes or {})
    return shape


def add_attributes(shape: mi.Mesh, attributes: Mapping[str, NDArray[np.float64]]) -> None:
    """Gives the vertices of a shape further numbers [n, k] by name."""
    for name, rows in attributes.items():
        shape.add_attribute(name, rows.shape[1], rows.astype(np.float32).ravel().tolist())


def from_shape(shape: mi.Mesh, name: str) -> ClothMesh:
    """The triangles of a Mitsuba mesh.

    They are not read as scene parameters: a rectangle is a mesh that has none of these.

    Raises:
        InputError: no usable uv.
    """
    positions, normals, uv, triangles = (
        np.array(values, dtype=np.float64).reshape(-1, width)
        for values, width in (
            (shape.vertex_positions_buffer(), 3),
            (shape.vertex_normals_buffer() if shape.has_vertex_normals() else [], 3),
            (shape.vertex_texcoords_buffer() if shape.has_vertex_texcoords() else [], 2),
            (shape.faces_buffer(), 3),
        )
    )
    return checked(ClothMesh(positions, normals, uv, triangles.astype(np.int64), name))


def set_uv(shape: mi.Mesh, uv: NDArray[np.float64]) -> bool:
    """Gives a mesh other uv [n, 2]; False if it has none that can be set, as a rectangle."""
    params = mi.traverse(shape)
    if "vertex_texcoords" not in params:
        return False
    params["vertex_texcoords"] = upload(mi.Float, uv.astype(np.float32))
    params.update()
    return True


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


# ---------------------------------------------------------------------------------------------------- garment
# Mesh files of several parts: which cloth each part is given, at its own scale.


ClothT = TypeVar("ClothT")


@dataclass(frozen=True)
class Garment(Generic[ClothT]):
    """A mesh file, in a piece for each cloth, of one scale of uv.

    Attributes:
        pieces: meshes, in metres, and the cloth of each.
        uncovered: the triangles that have no uv; None where all have.
        parts: those of the file, in metres; none of a piece that is no file's.
        turns: degrees by which the cloth of each piece is turned, beyond that of all.
    """

    pieces: list[tuple[ClothMesh, ClothT]]
    uncovered: ClothMesh | None
    parts: Sequence[MeshPart] = ()
    turns: Sequence[float] = (0.0,)

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
    pieces = []
    for key in (found := list(dict.fromkeys(keys))):
        chosen = [part.mesh for part, own in zip(covered, keys, strict=True) if own == key]
        pieces.append((at_one_scale(chosen), cloth if key is None else others[key]))
    bare = [part.mesh for part in parts if not len(part.mesh.uv)]
    turned = [(turns or {}).get(key or "", 0.0) for key in found]
    garment = Garment(pieces, joined(bare) if bare else None, parts, turned)
    warn_of_extent(joined([mesh for mesh, _ in pieces]), metres_per_unit)
    for mesh, _ in pieces:
        warn_of_scale(mesh)
    return garment


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


# ----------------------------------------------------------------------------------------------- scene meshes
# Mesh files that a Mitsuba scene names, checked before Mitsuba reads them: it trusts their indices.


_CHECKED = ("obj", "ply")
_VARIABLE = re.compile(r"\$(\w+)")


def check_scene_meshes(file: Path) -> None:
    """Reads each OBJ and PLY mesh that a scene file, or one that it includes, names.

    Warns of those that are not found beside the scene and therefore not checked.

    Raises:
        InputError: a damaged mesh, or one of which some triangles alone have uv.
    """
    waiting, seen = [file], set[Path]()
    defaults: dict[str, str] = {}
    while waiting:
        scene = waiting.pop()
        if scene in seen:
            continue
        seen.add(scene)
        try:
            root = ElementTree.parse(scene).getroot()
        except (ElementTree.ParseError, ValueError, OSError):
            continue  # which Mitsuba says better
        for node in root.iter("default"):
            defaults.setdefault(node.get("name", ""), node.get("value", ""))
        for node in root.iter("include"):
            waiting.append(file.parent / _filled(node.get("filename", ""), defaults))
        for shape in root.iter("shape"):
            for node in shape.iterfind("string[@name='filename']"):
                if shape.get("type") in _CHECKED:
                    _check(file, _filled(node.get("value", ""), defaults), str(shape.get("type")))


def _filled(text: str, defaults: dict[str, str]) -> str:
    return _VARIABLE.sub(lambda found: defaults.get(found[1], found[0]), text)


def _check(scene: Path, name: str, kind: str) -> None:
    mesh = scene.parent / name
    if not mesh.is_file() or mesh.suffix.lower() != f".{kind}":
        warnings.warn(
            f'{scene}: the mesh "{name[:80]}" is not checked before Mitsuba reads it: it is no .{kind} file '
            "beside the scene.",
            LoomlightWarning,
            stacklevel=4,
        )
        return
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", LoomlightWarning)  # the sentence below takes its place
        parts = read_parts(mesh)
    bare = sum(len(part.mesh.triangles) for part in parts if len(part.mesh.uv) == 0)
    total = sum(len(part.mesh.triangles) for part in parts)
    if 0 < bare < total:
        raise InputError(
            f"{mesh}: {bare} of {total} triangles have no usable uv coordinates, and Mitsuba takes any "
            "numbers for them: unwrap the mesh, or make two meshes of it."
        )
