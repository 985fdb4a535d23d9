"""Meshes that users met, each with its right value, and neighbours of each kind.

Covers: mesh/cloth_mesh.py, mesh/reading.py
"""

from __future__ import annotations

import os
import warnings
from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.mesh.cloth_mesh import ClothMesh, MeshPart, cleaned, cross_products, metric
from loomlight.mesh.reading import read_mesh, read_parts
from tests.work import allocates_at_most

DATA = os.environ.get("LOOMLIGHT_DATA")
CASES = Path(DATA or "") / "cases"
needs_data = pytest.mark.skipif(DATA is None, reason="LOOMLIGHT_DATA does not name the folder of cases")


def area_of(mesh: ClothMesh) -> float:
    return float(np.linalg.norm(cross_products(mesh), axis=1).sum() / 2)


def parts_of(name: str) -> tuple[list[MeshPart], list[str]]:
    """The parts of a case, and the sentences of its warnings."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        parts = read_parts(CASES / name)
    assert all(issubclass(warning.category, LoomlightWarning) for warning in caught)
    return parts, [str(warning.message) for warning in caught]


@needs_data
@pytest.mark.parametrize(
    ("name", "area", "width"),
    [
        ("o04_negative_indices.obj", 1.0772, 1),
        ("o10_crlf_continued.obj", 1.0772, 1),
        ("o11_mm_units.obj", 1.0772e6, 1000),
        ("o16_concave_L.obj", 3, 2),
        ("m03_pos_short_normalized.gltf", 1.0772, 1),
        ("m14_texture_transform_rot.gltf", 1.0772, 1),
        ("square.obj", 0.04, 0.2),
        ("square_one_sliver.obj", 0.04, 0.2),
        ("turn4/m21b_skin_node_quarter.gltf", 0.263085, 0.5),
        ("turn4/m22_skin_joint_scale_cm.gltf", 0.263085, 0.5),
    ],
)
def test_cases_are_read(name: str, area: float, width: float) -> None:
    (part,), sentences = parts_of(name)
    assert area_of(part.mesh) == pytest.approx(area, rel=1e-3)
    assert np.ptp(part.mesh.positions[:, 0]) == pytest.approx(width, rel=1e-6)
    assert len(part.mesh.uv) == len(part.mesh.positions)
    assert sentences == []


@needs_data
@pytest.mark.parametrize(
    ("name", "covered", "bare"),
    [("o07_some_faces_without_vt.obj", 102, 26), ("m09_part_without_uv.gltf", 128, 128)],
)
def test_triangles_without_uv_are_parts_of_their_own(name: str, covered: int, bare: int) -> None:
    for _ in range(3):  # nothing is read that was never written
        (cloth, rest), (sentence,) = parts_of(name)
        assert (len(cloth.mesh.triangles), len(rest.mesh.triangles)) == (covered, bare)
        assert rest.mesh.uv.shape == (0, 2)
        assert np.abs(cloth.mesh.uv).max() <= 1
        assert f"{bare} of {covered + bare} triangles have no usable uv" in sentence


@needs_data
def test_densities_of_uv_stay_apart() -> None:
    (first, second), _ = parts_of("m11_two_primitives_other_uv_density.gltf")
    lengths = [np.linalg.norm(metric(part.mesh)[2], axis=1).mean() for part in (first, second)]
    assert lengths == pytest.approx([1, 0.25])


@needs_data
def test_a_texture_transform_turns_and_scales_uv() -> None:
    """u runs along z after a quarter turn, and five times as dense."""
    (part,), _ = parts_of("m14_texture_transform_rot.gltf")
    _, dp_du, dp_dv = metric(part.mesh)
    np.testing.assert_allclose(np.abs(dp_du).mean(axis=0), [0, 0, 0.2], atol=1e-3)
    np.testing.assert_allclose(np.abs(dp_dv[:, 0]), 0.2, atol=1e-6)


@needs_data
@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("p01_index_out_of_range.ply", "a face names vertex 99999999, and there are 36, from 0 on"),
        ("m15_sparse_count.gltf", "an accessor states 50000000 elements, and has no data for them"),
    ],
)
def test_cases_are_refused_at_once(name: str, says: str) -> None:
    with allocates_at_most(1 << 20), pytest.raises(InputError) as caught:
        read_parts(CASES / name)
    assert says in str(caught.value)
    assert str(CASES / name) in str(caught.value)


SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype=float)
NO_UV = np.zeros((0, 2))


def square(**changes: object) -> ClothMesh:
    arrays = {
        "positions": SQUARE, "normals": np.tile([0.0, 0, 1], (4, 1)), "uv": SQUARE[:, :2],
        "triangles": np.array([[0, 1, 2], [0, 2, 3]]), "name": "square",
    }  # fmt: skip
    # Values of several types by name, which a type checker cannot follow.
    return ClothMesh(**{**arrays, **changes})  # type: ignore[arg-type]


@pytest.mark.parametrize("bad", [[0, 0, 0], [np.nan, 0, 1], [np.inf, 0, 0], [-np.inf] * 3])
def test_normals_that_are_none_are_computed(bad: list[float]) -> None:
    normals = np.array([[0, 0, 5.0], bad, [0, 0, 1e200], [0, 0, 1e-200]])
    np.testing.assert_allclose(cleaned(square(normals=normals)).normals, [[0, 0, 1]] * 4, atol=1e-12)


def test_triangles_without_area_and_their_vertices_are_left_out() -> None:
    positions = np.concatenate([SQUARE, [[5, 5, 5], [7, 7, 7.0]]])
    triangles = np.array([[0, 0, 1], [0, 1, 2], [4, 4, 4], [0, 2, 3], [4, 5, 4]])
    mesh = cleaned(
        square(positions=positions, normals=np.zeros((0, 3)), uv=positions[:, :2], triangles=triangles)
    )
    np.testing.assert_array_equal(mesh.triangles, [[0, 1, 2], [0, 2, 3]])
    np.testing.assert_array_equal(mesh.positions, SQUARE)


@pytest.mark.parametrize("triangles", [[[0, 1, 4]], [[0, 1, -1]], [[0, 1, 2**62]]])
def test_indices_out_of_range_are_refused(triangles: list[list[int]]) -> None:
    with pytest.raises(InputError, match=r"a face names vertex .*, and there are 4, from 0 on"):
        cleaned(square(triangles=np.array(triangles)))


@pytest.mark.parametrize("value", [np.nan, np.inf, 1e30])
def test_positions_that_are_used_must_be_finite(value: float) -> None:
    positions = SQUARE.copy()
    positions[3] = value
    with pytest.raises(InputError, match="a vertex position is not finite"):
        cleaned(square(positions=positions))
    alone = square(positions=positions, triangles=np.array([[0, 1, 2]]))
    assert len(cleaned(alone).positions) == 3


@pytest.mark.parametrize(
    ("name", "content", "says"),
    [
        ("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nvt 0 0\nf 1/1 2/1 3/1\n", "no triangles that have an area"),
        ("line.obj", "v 0 0 0\nv 1 0 0\nv 2 1 0\nvt 0 0\nf 1/1 2/1 3/1\n", "collapse to lines or points"),
        ("none.obj", "v 0 0 0\nv 1 0 0\nv 2 1 0\nf 1 2 3\n", "has no uv coordinates"),
        ("two.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n", "holds no triangles"),
    ],
)
def test_meshes_that_cannot_be_clothed(tmp_path: Path, name: str, content: str, says: str) -> None:
    (tmp_path / name).write_text(content)
    with pytest.raises(InputError, match=says):
        read_mesh(tmp_path / name)
