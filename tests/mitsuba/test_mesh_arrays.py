"""Arrays of meshes go into Mitsuba and come back."""

from __future__ import annotations

import mitsuba as mi
import numpy as np

from loomlight.mitsuba.mesh_arrays import MeshArrays, arrays_of, make_shape

QUAD = MeshArrays(
    positions=np.array([[0, 0, 0], [2, 0, 0], [2, 3, 0], [0, 3, 0]], float),
    normals=np.array([[0, 0, 1]] * 4, float),
    uv=np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float),
    triangles=np.array([[0, 1, 2], [0, 2, 3]]),
)


def assert_same(found: MeshArrays, expected: MeshArrays) -> None:
    for name in ("positions", "normals", "uv", "triangles"):
        np.testing.assert_allclose(getattr(found, name), getattr(expected, name), atol=1e-6)


def test_arrays_go_through_mitsuba_and_back() -> None:
    shape = make_shape("quad", QUAD, mi.load_dict({"type": "diffuse"}))
    assert isinstance(shape.bsdf(), mi.BSDF)
    assert_same(arrays_of(shape), QUAD)


def test_what_a_mesh_does_not_have_is_empty() -> None:
    found = arrays_of(mi.Mesh("bare", vertex_count=3, face_count=1))
    assert found.positions.shape == (3, 3)
    assert found.normals.shape == (0, 3)
    assert found.uv.shape == (0, 2)
