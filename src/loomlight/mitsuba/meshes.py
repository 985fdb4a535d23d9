"""Cloth meshes: read from OBJ, PLY and glTF, measured in their own metric, handed to Mitsuba.

uv follows Mitsuba's bitmaps, v running down the image: OBJ's v is turned over as Mitsuba's `obj` plugin does,
glTF's is kept, PLY's is taken as it is written, as Mitsuba's `ply` plugin does.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.core.files import require_file
from loomlight.mitsuba.faults import reason_of
from loomlight.mitsuba.gltf import load_gltf
from loomlight.mitsuba.mesh_arrays import MeshArrays, arrays_of, make_shape

SUFFIXES = (".obj", ".ply", ".gltf", ".glb")


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


def read_mesh(path: str | os.PathLike[str]) -> ClothMesh:
    """Every triangle of an OBJ, PLY, glTF or GLB file as one mesh; missing normals are computed.

    A Mitsuba variant must be set.

    Raises:
        InputError: no such file, another suffix, a damaged file, no triangles, or no usable uv.
    """
    file = Path(path)
    suffix = file.suffix.lower()
    if suffix not in SUFFIXES:
        raise InputError(f"{file}: meshes are read from {', '.join(SUFFIXES)} files.")
    require_file(file)
    if file.stat().st_size == 0:
        raise InputError(f"{file} is empty: it holds no mesh.")
    try:
        mesh = _read_gltf(file) if suffix in (".gltf", ".glb") else _read_with_mitsuba(file, suffix[1:])
    except InputError:
        raise
    except Exception as error:  # the readers raise whatever their parsers do
        raise InputError(f"{file} is damaged or no {suffix[1:]} mesh: {reason_of(error)}") from error
    return _checked(mesh)


def uv_size(mesh: ClothMesh, metres_per_unit: float = 1.0) -> tuple[float, float]:
    """Millimetres on the surface per unit of u and of v: the area-weighted RMS of |dp/du| and |dp/dv|.

    `metres_per_unit` is the length of one unit of the mesh's positions.
    """
    area, dp_du, dp_dv = _metric(mesh)
    known = np.isfinite(area)
    weight = area[known] / area[known].sum()
    millimetres = 1000 * metres_per_unit
    return (
        float(np.sqrt(weight @ np.sum(dp_du[known] ** 2, axis=1))) * millimetres,
        float(np.sqrt(weight @ np.sum(dp_dv[known] ** 2, axis=1))) * millimetres,
    )


def to_shape(mesh: ClothMesh, bsdf: mi.BSDF | dict[str, object]) -> mi.Mesh:
    """The mesh as a Mitsuba shape with the BSDF object or dictionary `bsdf`."""
    made = mi.load_dict(bsdf) if isinstance(bsdf, dict) else bsdf
    arrays = MeshArrays(mesh.positions, mesh.normals, mesh.uv, mesh.triangles)
    return make_shape(Path(mesh.name).stem, arrays, made)


def from_shape(shape: mi.Mesh, name: str) -> ClothMesh:
    """The triangles of a Mitsuba mesh.

    Raises:
        InputError: no usable uv.
    """
    arrays = arrays_of(shape)
    return _checked(ClothMesh(arrays.positions, arrays.normals, arrays.uv, arrays.triangles, name))


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


def _read_with_mitsuba(file: Path, plugin: str) -> ClothMesh:
    return from_shape(mi.load_dict({"type": plugin, "filename": str(file)}), str(file))


def _read_gltf(file: Path) -> ClothMesh:
    import trimesh

    scene = load_gltf(file)
    parts = []
    for node in scene.graph.nodes_geometry:
        transform, name = scene.graph[node]
        part = scene.geometry[name]
        if isinstance(part, trimesh.Trimesh) and len(part.faces):
            parts.append(_placed(part, np.asarray(transform), f"{file}"))
    if not parts:
        raise InputError(f"{file} holds no triangles.")
    return joined(parts)


def _placed(part: Any, transform: NDArray[np.float64], name: str) -> ClothMesh:
    linear = transform[:3, :3]
    uv = getattr(part.visual, "uv", None)
    uv = np.zeros((0, 2)) if uv is None else np.asarray(uv, dtype=np.float64)[:, :2]
    triangles = np.asarray(part.faces, dtype=np.int64)
    mirrored = np.linalg.det(linear) < 0
    normals = np.asarray(part.vertex_normals, dtype=np.float64) @ np.linalg.inv(linear)
    return ClothMesh(
        positions=np.asarray(part.vertices, dtype=np.float64) @ linear.T + transform[:3, 3],
        normals=normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12),
        # The reader turned v upwards; in the file, as in Mitsuba, it runs down.
        uv=uv * [1, -1] + [0, 1] if len(uv) else uv,
        triangles=triangles[:, ::-1] if mirrored else triangles,
        name=name,
    )


def _checked(mesh: ClothMesh) -> ClothMesh:
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
    area, _, _ = _metric(mesh)
    total = np.linalg.norm(_cross(mesh), axis=1).sum() / 2
    if total == 0:
        raise InputError(f"{mesh.name} is flat to a line: none of its triangles has an area.")
    # Seams may collapse a few triangles in uv; cloth whose larger part has no uv cannot be woven.
    if np.nansum(area) < 0.5 * total:
        raise InputError(f"{mesh.name}: its uv coordinates collapse to lines or points; unwrap it first.")
    return mesh


def _cross(mesh: ClothMesh) -> NDArray[np.float64]:
    a, b, c = (mesh.positions[mesh.triangles[:, corner]] for corner in range(3))
    return np.cross(b - a, c - a)


def _metric(mesh: ClothMesh) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
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
    weighted = _cross(mesh)
    for corner in range(3):
        np.add.at(normals, mesh.triangles[:, corner], weighted)
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    return np.where(length > 0, normals / np.maximum(length, 1e-300), [0.0, 1.0, 0.0])
