"""Arrays in and out of Mitsuba's meshes.

Mitsuba 3.10 changes this interface (mitsuba3 pull request 1933): pyproject.toml admits versions below alone.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import upload


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
    return MeshArrays(
        _rows(shape.vertex_positions_buffer(), 3),
        _rows(shape.vertex_normals_buffer() if shape.has_vertex_normals() else [], 3),
        _rows(shape.vertex_texcoords_buffer() if shape.has_vertex_texcoords() else [], 2),
        _rows(shape.faces_buffer(), 3).astype(np.int64),
    )


def make_shape(name: str, arrays: MeshArrays, bsdf: mi.BSDF) -> mi.Mesh:
    """A Mitsuba mesh of these arrays, normals and uv included, with a BSDF."""
    values = {
        "positions": arrays.positions.astype(np.float32),
        "normals": arrays.normals.astype(np.float32),
        "texcoords": arrays.uv.astype(np.float32),
    }
    props = mi.Properties()
    props["bsdf"] = bsdf
    shape = mi.Mesh(
        name,
        vertex_count=len(arrays.positions),
        face_count=len(arrays.triangles),
        props=props,
        has_vertex_normals=True,
        has_vertex_texcoords=True,
    )
    params = mi.traverse(shape)
    for key, rows in values.items():
        params[f"vertex_{key}"] = upload(mi.Float, rows)
    params["faces"] = upload(mi.UInt32, arrays.triangles.astype(np.uint32))
    params.update()
    return shape


def set_uv(shape: mi.Mesh, uv: NDArray[np.float64]) -> bool:
    """Gives a mesh other uv [n, 2]; False if it has none that can be set, as a rectangle."""
    params = mi.traverse(shape)
    if "vertex_texcoords" not in params:
        return False
    params["vertex_texcoords"] = upload(mi.Float, uv.astype(np.float32))
    params.update()
    return True


def _rows(values: Any, width: int) -> NDArray[np.float64]:
    return np.array(values, dtype=np.float64).reshape(-1, width)
