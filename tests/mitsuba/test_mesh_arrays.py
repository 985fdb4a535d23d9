"""Both interfaces of Mitsuba's meshes: the installed one, and that of 3.10 by a stand-in."""

from __future__ import annotations

from typing import Any

import mitsuba as mi
import numpy as np
import pytest

from loomlight.mitsuba import mesh_arrays
from loomlight.mitsuba.mesh_arrays import MeshArrays, arrays_of, make_shape

QUAD = MeshArrays(
    positions=np.array([[0, 0, 0], [2, 0, 0], [2, 3, 0], [0, 3, 0]], float),
    normals=np.array([[0, 0, 1]] * 4, float),
    uv=np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float),
    triangles=np.array([[0, 1, 2], [0, 2, 3]]),
)


class NewMesh:
    """A mesh as 3.10 has it: made in one call, read as tensors."""

    def __init__(self, name: str, **arrays: Any) -> None:
        self.name = name
        self.arrays = arrays
        self.bsdf: object = None

    def set_bsdf(self, bsdf: object) -> None:
        self.bsdf = bsdf

    def has_normals(self) -> bool:
        return "normals" in self.arrays

    def has_texcoords(self) -> bool:
        return "texcoords" in self.arrays

    def faces(self) -> Any:
        return self.arrays["faces"]

    def positions(self) -> Any:
        return self.arrays["positions"]

    def normals(self) -> Any:
        return self.arrays["normals"]

    def texcoords(self) -> Any:
        return self.arrays["texcoords"]


class SeamedMesh(NewMesh):
    """One whose vertices share positions and normals, as they do at seams of the uv."""

    def position_index(self) -> Any:
        return mi.UInt32(self.arrays["position_index"])

    def normal_index(self) -> Any:
        return mi.UInt32(self.arrays["normal_index"])


def assert_same(found: MeshArrays, expected: MeshArrays) -> None:
    for name in ("positions", "normals", "uv", "triangles"):
        np.testing.assert_allclose(getattr(found, name), getattr(expected, name), atol=1e-6)


def test_arrays_go_through_the_installed_mitsuba_and_back() -> None:
    shape = make_shape("quad", QUAD, mi.load_dict({"type": "diffuse"}))
    assert isinstance(shape.bsdf(), mi.BSDF)
    assert_same(arrays_of(shape), QUAD)


def test_arrays_go_through_the_new_interface_and_back(monkeypatch: pytest.MonkeyPatch) -> None:
    bsdf = mi.load_dict({"type": "diffuse"})
    monkeypatch.setattr(mesh_arrays.mi, "Mesh", NewMesh)
    shape: Any = make_shape("quad", QUAD, bsdf)
    assert shape.name == "quad"
    assert shape.bsdf is bsdf
    assert shape.arrays["positions"].shape == (4, 3)
    assert shape.arrays["faces"].shape == (2, 3)
    assert_same(arrays_of(shape), QUAD)


def test_shared_rows_are_read_for_each_vertex() -> None:
    """The quad folded along its diagonal in uv: 6 vertices of 4 positions and 1 normal."""
    order = np.array([0, 1, 2, 0, 2, 3])
    shape: Any = SeamedMesh(
        "seams",
        faces=mi.TensorXu(np.arange(6, dtype=np.uint32).reshape(2, 3)),
        positions=mi.TensorXf(QUAD.positions.astype(np.float32)),
        position_index=order.astype(np.uint32),
        normals=mi.TensorXf(np.array([[0, 0, 1]], np.float32)),
        normal_index=np.zeros(6, np.uint32),
        texcoords=mi.TensorXf(QUAD.uv[order].astype(np.float32)),
    )
    unrolled = MeshArrays(
        QUAD.positions[order], QUAD.normals[order], QUAD.uv[order], np.arange(6).reshape(2, 3)
    )
    assert_same(arrays_of(shape), unrolled)


def test_what_a_mesh_does_not_have_is_empty() -> None:
    shape: Any = NewMesh("bare", faces=mi.TensorXu([[0, 1, 2]]), positions=mi.TensorXf(np.eye(3)))
    found = arrays_of(shape)
    assert found.normals.shape == (0, 3)
    assert found.uv.shape == (0, 2)
