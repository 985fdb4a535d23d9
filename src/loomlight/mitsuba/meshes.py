"""Cloth meshes: read from OBJ, PLY and glTF, measured in their own metric, handed to Mitsuba.

uv follows Mitsuba's bitmaps, v running down the image: OBJ's v is turned over as Mitsuba's `obj` plugin does,
glTF's is kept, PLY's is taken as it is written, as Mitsuba's `ply` plugin does.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.core.files import require_file
from loomlight.mesh.cloth_mesh import ClothMesh, checked, joined
from loomlight.mitsuba.faults import reason_of
from loomlight.mitsuba.gltf import load_gltf
from loomlight.mitsuba.mesh_arrays import MeshArrays, arrays_of, make_shape

SUFFIXES = (".obj", ".ply", ".gltf", ".glb")


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
    return checked(mesh)


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
    return checked(ClothMesh(arrays.positions, arrays.normals, arrays.uv, arrays.triangles, name))


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
