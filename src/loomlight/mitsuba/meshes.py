"""Meshes of scenes: cloth handed to Mitsuba and taken from it, and files of scenes checked.

Mitsuba 3.10 changes the interface of its meshes (mitsuba3 pull request 1933): pyproject.toml admits versions
below alone.
"""

from __future__ import annotations

import re
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import upload
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.mesh.cloth_mesh import ClothMesh, checked
from loomlight.mesh.reading import read_parts


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
