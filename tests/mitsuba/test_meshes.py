"""Meshes: every format gives the same cloth, and damaged files end in a sentence.

Covers: mesh/cloth_mesh.py, mitsuba/shapes.py, mitsuba/variants.py
"""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.mesh.cloth_mesh import ClothMesh
from loomlight.mitsuba import read_mesh, shapes, to_shape, uv_size
from loomlight.mitsuba.meshes import from_shape
from tests.helpers.meshes import CORNERS, UV_UP, obj_text, write_gltf, write_obj, write_ply

DATA = os.environ.get("LOOMLIGHT_DATA")


def uv_by_corner(mesh: ClothMesh) -> np.ndarray:
    """uv at each of CORNERS, whatever the order of vertices."""
    distance = np.linalg.norm(mesh.positions[:, None] - CORNERS, axis=-1)
    return mesh.uv[distance.argmin(axis=0)]


def test_obj_and_gltf_give_the_same_uv_and_normals(tmp_path: Path) -> None:
    obj, glb = read_mesh(write_obj(tmp_path)), read_mesh(write_gltf(tmp_path))
    np.testing.assert_allclose(uv_by_corner(obj), uv_by_corner(glb), atol=1e-6)
    np.testing.assert_allclose(uv_by_corner(obj), [[0, 1], [1, 1], [1, 0.5], [0, 0.5]], atol=1e-6)
    for mesh in (obj, glb):
        np.testing.assert_allclose(mesh.normals, [[0, 0, 1]] * 4, atol=1e-6)


def test_ply_keeps_its_uv(tmp_path: Path) -> None:
    mesh = read_mesh(write_ply(tmp_path))
    np.testing.assert_allclose(uv_by_corner(mesh), UV_UP, atol=1e-6)
    np.testing.assert_allclose(mesh.normals, [[0, 0, 1]] * 4, atol=1e-6)


def test_uv_size_is_the_metric(tmp_path: Path) -> None:
    for file in (write_obj(tmp_path), write_gltf(tmp_path), write_ply(tmp_path)):
        np.testing.assert_allclose(uv_size(read_mesh(file)), (2000, 6000), rtol=1e-6)
        np.testing.assert_allclose(uv_size(read_mesh(file), metres_per_unit=0.01), (20, 60), rtol=1e-6)


def test_gltf_parts_are_placed_and_joined(tmp_path: Path) -> None:
    moved, mirrored = np.eye(4), np.diag([-1.0, 1, 1, 1])
    moved[:3, 3] = [10, 0, 0]
    mesh = read_mesh(write_gltf(tmp_path, transforms=(moved, mirrored)))
    assert len(mesh.triangles) == 4
    np.testing.assert_allclose(mesh.positions.min(axis=0), [-2, 0, 0], atol=1e-6)
    np.testing.assert_allclose(mesh.positions.max(axis=0), [12, 3, 0], atol=1e-6)
    # Mirroring must not turn the front of a part to the back.
    a, b, c = (mesh.positions[mesh.triangles[:, i]] for i in range(3))
    facing = np.sum(np.cross(b - a, c - a) * mesh.normals[mesh.triangles[:, 0]], axis=1)
    assert (facing > 0).all()


def test_obj_groups_are_joined(tmp_path: Path) -> None:
    file = tmp_path / "two.obj"
    second = "g other\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 5/1 6/2 7/3\n"
    file.write_text("g one\n" + obj_text(extra=second))
    assert len(read_mesh(file).triangles) == 3


def test_goes_through_mitsuba_and_back(tmp_path: Path) -> None:
    mesh = read_mesh(write_obj(tmp_path))
    back = from_shape(to_shape(mesh, {"type": "diffuse"}), "back")
    for name in ("positions", "normals", "uv", "triangles"):
        np.testing.assert_allclose(getattr(back, name), getattr(mesh, name), atol=1e-6)


@pytest.mark.parametrize(
    ("name", "content", "says"),
    [
        ("missing.obj", None, "does not exist"),
        ("cloth.fbx", b"", ".obj, .ply, .gltf, .glb"),
        ("nouv.obj", obj_text(uv=None).encode(), "no uv"),
        (
            "collapsed.obj",
            obj_text().replace("vt 1.0", "vt 0.0").encode(),
            "collapse",
        ),
        ("empty.obj", b"", "empty.obj"),
        ("points.obj", b"v 0 0 0\nvt 0 0\n", "holds no triangles"),
        ("index.obj", obj_text(extra="f 1/1 2/2 99/1\n").encode(), "index.obj"),
        ("nan.obj", obj_text().replace("v 2.0 3.0", "v nan 3.0").encode(), "nan.obj"),
        ("noise.ply", b"ply\nformat ascii 1.0\nnothing", "noise.ply"),
        ("noise.glb", b"glTF\x02\x00\x00\x00", "noise.glb"),
        ("noise.gltf", b"{", "noise.gltf"),
    ],
)
def test_unusable_files_are_named(tmp_path: Path, name: str, content: bytes | None, says: str) -> None:
    file = tmp_path / name
    if content is not None:
        file.write_bytes(content)
    with pytest.raises(InputError) as caught:
        read_mesh(file)
    assert says in str(caught.value)
    assert name in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("make", [write_ply, write_gltf])
def test_truncated_files_are_refused(tmp_path: Path, make: object) -> None:
    file = make(tmp_path)  # type: ignore[operator]
    file.write_bytes(file.read_bytes()[:-20])
    with pytest.raises(InputError):
        read_mesh(file)


def test_built_in_cloths_are_to_scale() -> None:
    np.testing.assert_allclose(uv_size(shapes.flat()), (100, 100), rtol=1e-6)
    np.testing.assert_allclose(uv_size(shapes.cylinder()), (120, 2 * np.pi * 40), rtol=1e-3)
    # Gathering shortens circles only, so the metric is a little below the square's side.
    side = 2 * 100 * shapes.SPHERE_CAP
    assert all(0.8 * side < size < side for size in uv_size(shapes.sphere()))
    np.testing.assert_allclose(uv_size(shapes.drape()), (600, 600), rtol=0.02)


def test_built_in_cloths_face_outwards_with_unit_normals() -> None:
    for make in (shapes.flat, shapes.sphere, shapes.cylinder, shapes.drape):
        mesh = make()
        np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1, atol=1e-5)
        a, b, c = (mesh.positions[mesh.triangles[:, i]] for i in range(3))
        facing = np.sum(np.cross(b - a, c - a) * mesh.normals[mesh.triangles[:, 0]], axis=1)
        assert (facing > 0).mean() > 0.995


def test_draped_cloth_keeps_its_lengths_and_lies_on_ball_and_ground() -> None:
    mesh = shapes.drape()
    grid = mesh.positions.reshape(200, 200, 3)
    for axis in (0, 1):
        length = np.linalg.norm(np.diff(grid, axis=axis), axis=-1).sum(axis=axis)
        np.testing.assert_allclose(length, 0.6, rtol=0.05)
    assert mesh.positions[:, 1].min() > 0
    radius = shapes.DRAPE_BALL_RADIUS
    assert np.linalg.norm(mesh.positions - [0, radius, 0], axis=1).min() > radius


@pytest.mark.skipif(DATA is None, reason="LOOMLIGHT_DATA does not name the folder of outside meshes")
@pytest.mark.parametrize("name", ["cloth.ply", "towel.obj"])
def test_outside_meshes_are_read(name: str) -> None:
    mesh = read_mesh(Path(DATA or "") / "meshes" / name)
    u, v = uv_size(mesh)
    assert 0.2 < u / v < 5
