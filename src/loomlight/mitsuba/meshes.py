"""Cloth meshes handed to Mitsuba, and taken from it.

Mitsuba 3.10 changes this interface (mitsuba3 pull request 1933): pyproject.toml admits versions below alone.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import upload
from loomlight.mesh.cloth_mesh import ClothMesh, checked


def to_shape(mesh: ClothMesh, bsdf: mi.BSDF | dict[str, Any]) -> mi.Mesh:
    """The mesh as a Mitsuba shape with the BSDF object or dictionary `bsdf`."""
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
    return shape


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
