"""Cloth meshes handed to Mitsuba, and taken from it."""

from __future__ import annotations

from pathlib import Path

import mitsuba as mi

from loomlight.mesh.cloth_mesh import ClothMesh, checked
from loomlight.mitsuba.mesh_arrays import MeshArrays, arrays_of, make_shape


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
