"""Arrays in and out of Mitsuba's meshes, by either of its interfaces.

Up to 3.9 a mesh is allocated empty and filled by its scene parameters (`vertex_positions`, flat), and is read
by `vertex_positions_buffer()`. From 3.10 on it is made in one call, `mi.Mesh(name, faces=…, positions=…)`,
and read by `positions()`, rows of a tensor; `position_index()` and `normal_index()` say which row each vertex
takes, where vertices share them (mitsuba3 pull request 1933). The second is written from its description and
tested with a stand-in, as no release had it: pyproject.toml admits Mitsuba below 3.10 only.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class MeshArrays:
    """The arrays of a mesh.

    Attributes:
        positions: [n, 3].
        normals: [n, 3], or [0, 3] where the mesh has none.
        uv: [n, 2], or [0, 2] where the mesh has none.
        triangles: vertex indices [m, 3].
    """

    positions: NDArray[np.float64]
    normals: NDArray[np.float64]
    uv: NDArray[np.float64]
    triangles: NDArray[np.int64]


def arrays_of(shape: mi.Mesh) -> MeshArrays:
    """The arrays of a Mitsuba mesh.

    They are not read as scene parameters: a rectangle is a mesh that has none of these.
    """
    mesh: Any = shape  # of either interface
    if hasattr(mesh, "vertex_positions_buffer"):
        return MeshArrays(
            _rows(mesh.vertex_positions_buffer(), 3),
            _rows(mesh.vertex_normals_buffer() if mesh.has_vertex_normals() else [], 3),
            _rows(mesh.vertex_texcoords_buffer() if mesh.has_vertex_texcoords() else [], 2),
            _rows(mesh.faces_buffer(), 3).astype(np.int64),
        )
    return MeshArrays(
        _picked(_rows(mesh.positions(), 3), mesh, "position_index"),
        _picked(_rows(mesh.normals() if mesh.has_normals() else [], 3), mesh, "normal_index"),
        _rows(mesh.texcoords() if mesh.has_texcoords() else [], 2),
        _rows(mesh.faces(), 3).astype(np.int64),
    )


def make_shape(name: str, arrays: MeshArrays, bsdf: mi.BSDF) -> mi.Mesh:
    """A Mitsuba mesh of these arrays, normals and uv included, with a BSDF."""
    values = {
        "positions": arrays.positions.astype(np.float32),
        "normals": arrays.normals.astype(np.float32),
        "texcoords": arrays.uv.astype(np.float32),
    }
    faces = arrays.triangles.astype(np.uint32)
    api: Any = mi  # of either interface
    if not hasattr(api.Mesh, "vertex_positions_buffer"):
        tensors = {key: api.TensorXf(rows) for key, rows in values.items()}
        shape = api.Mesh(name, faces=api.TensorXu(faces), **tensors)
        shape.set_bsdf(bsdf)
        return shape
    props = api.Properties()
    props["bsdf"] = bsdf
    shape = api.Mesh(
        name,
        vertex_count=len(arrays.positions),
        face_count=len(faces),
        props=props,
        has_vertex_normals=True,
        has_vertex_texcoords=True,
    )
    params = api.traverse(shape)
    for key, rows in values.items():
        params[f"vertex_{key}"] = rows.ravel()
    params["faces"] = faces.ravel()
    params.update()
    return shape


def set_uv(shape: mi.Mesh, uv: NDArray[np.float64]) -> bool:
    """Gives a mesh other uv [n, 2]; False if it has none that can be set, as a rectangle."""
    params: Any = mi.traverse(shape)
    name = next((key for key in ("vertex_texcoords", "texcoords") if key in params), None)
    if name is None:
        return False
    rows = uv.astype(np.float32)
    params[name] = rows.ravel() if name.startswith("vertex") else mi.TensorXf(rows)
    params.update()
    return True


def _rows(values: Any, width: int) -> NDArray[np.float64]:
    return np.array(values, dtype=np.float64).reshape(-1, width)


def _picked(rows: NDArray[np.float64], shape: mi.Mesh, name: str) -> NDArray[np.float64]:
    """A row for each vertex, where vertices share rows."""
    if not hasattr(shape, name) or len(rows) == 0:
        return rows
    index = np.array(getattr(shape, name)(), dtype=np.int64).ravel()
    return rows[index] if len(index) else rows
