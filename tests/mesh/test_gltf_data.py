"""glTF data: kinds of numbers, modes, nodes and uv sets, and what files declare without holding it."""

from __future__ import annotations

import json
from itertools import accumulate
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.mesh.cloth_mesh import ClothMesh, MeshPart, cross_products
from loomlight.mesh.reading import read_parts
from tests.work import allocates_at_most

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype="<f4")
UV = CORNERS[:, :2]
CODES = {"<i1": 5120, "|i1": 5120, "|u1": 5121, "<i2": 5122, "<u2": 5123, "<u4": 5125, "<f4": 5126}
KINDS = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}


def gltf(
    folder: Path, arrays: dict[str, np.ndarray], change: dict[str, Any] | None = None, **more: Any
) -> Path:
    """A file of one primitive of these attributes and "indices"; `change` is of the accessors of uv."""
    pieces = [np.ascontiguousarray(array).tobytes() for array in arrays.values()]
    starts = [0, *accumulate(len(piece) for piece in pieces)]
    accessors = []
    for view, (name, array) in enumerate(arrays.items()):
        kind = {"componentType": CODES[array.dtype.str], "type": KINDS[array.size // len(array)]}
        accessors.append({"bufferView": view, "count": len(array), **kind})
        if name.startswith("TEXCOORD"):
            accessors[-1].update(change or {})
    numbers = {name: number for number, name in enumerate(arrays)}
    primitive: dict[str, Any] = {"mode": more.pop("mode", 4), "material": 0}
    if "indices" in numbers:
        primitive["indices"] = numbers.pop("indices")
    tree = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{**primitive, "attributes": numbers}]}], "accessors": accessors,
        "materials": [{}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": start, "byteLength": len(piece)}
            for start, piece in zip(starts, pieces, strict=False)
        ],
        "buffers": [{"uri": "mesh.bin", "byteLength": starts[-1]}], **more,
    }  # fmt: skip
    (folder / "mesh.bin").write_bytes(b"".join(pieces))
    (folder / "mesh.gltf").write_text(json.dumps(tree))
    return folder / "mesh.gltf"


def quad(uv: np.ndarray = UV, **more: np.ndarray) -> dict[str, np.ndarray]:
    return {"POSITION": CORNERS, "TEXCOORD_0": uv, "indices": np.array([0, 1, 2, 0, 2, 3], "<u2"), **more}


def mesh_of(file: Path) -> ClothMesh:
    (part,) = read_parts(file)
    return part.mesh


@pytest.mark.parametrize("kind", ["|u1", "<u2", "|i1", "<i2"])
@pytest.mark.parametrize("normalized", [True, False])
def test_integers_are_divided_where_they_are_normalized(tmp_path: Path, kind: str, normalized: bool) -> None:
    largest = np.iinfo(kind).max
    uv = (UV * largest).astype(kind)
    mesh = mesh_of(gltf(tmp_path, quad(uv), {"normalized": normalized}))
    np.testing.assert_allclose(mesh.uv, UV * (1 if normalized else largest))


@pytest.mark.parametrize(
    ("mode", "index"),
    [(4, [0, 1, 2, 0, 2, 3]), (4, [0, 1, 2, 0, 2, 3, 1]), (5, [0, 1, 3, 2]), (6, [0, 1, 2, 3])],
)
def test_triangles_strips_and_fans(tmp_path: Path, mode: int, index: list[int]) -> None:
    mesh = mesh_of(gltf(tmp_path, quad(indices=np.array(index, "<u2")), mode=mode))
    np.testing.assert_allclose(cross_products(mesh), [[0, 0, 1]] * 2)


@pytest.mark.parametrize("mode", [0, 1, 2, 3])
def test_points_and_lines_are_no_triangles(tmp_path: Path, mode: int) -> None:
    with pytest.raises(InputError, match="holds no triangles: its meshes are points or lines"):
        read_parts(gltf(tmp_path, quad(), mode=mode))


@pytest.mark.parametrize("place", ["texCoord", "transform"])
def test_the_uv_set_of_the_base_colour(tmp_path: Path, place: str) -> None:
    transform = {"extensions": {"KHR_texture_transform": {"texCoord": 1}}}
    texture = {"index": 0, **({"texCoord": 1} if place == "texCoord" else transform)}
    materials = [{"name": "red", "pbrMetallicRoughness": {"baseColorTexture": texture}}]
    file = gltf(tmp_path, quad(TEXCOORD_1=UV / 2), materials=materials)
    np.testing.assert_allclose(mesh_of(file).uv, UV / 2)


def test_another_uv_set_is_better_than_none(tmp_path: Path) -> None:
    arrays = quad(TEXCOORD_1=UV / 2)
    del arrays["TEXCOORD_0"]
    np.testing.assert_allclose(mesh_of(gltf(tmp_path, arrays)).uv, UV / 2)


def test_texture_transforms_scale_turn_and_move(tmp_path: Path) -> None:
    transform = {"offset": [0.25, 0.5], "rotation": np.pi / 2, "scale": [2, 4]}
    texture = {"index": 0, "extensions": {"KHR_texture_transform": transform}}
    materials = [{"pbrMetallicRoughness": {"baseColorTexture": texture}}]
    # The specification's matrices: translation · rotation · scale.
    expected = np.stack([4 * UV[:, 1], -2 * UV[:, 0]], axis=1) + np.array([0.25, 0.5])
    np.testing.assert_allclose(mesh_of(gltf(tmp_path, quad(), materials=materials)).uv, expected, atol=1e-12)


@pytest.mark.parametrize(
    ("nodes", "says"),
    [
        ([{"children": [1]}, {"children": [0], "mesh": 0}], "node 0 is its own ancestor"),
        ([{"children": [0]}], "node 0 is its own ancestor"),
        ([{"children": [1, 1]}, {"mesh": 0}], "node 1 is its own ancestor, or has two parents"),
        ([{"children": [7]}], 'names number 7 of its "nodes"'),
        ([{"mesh": 0, "translation": [0, 1]}], '"translation" is no list of 3 finite numbers'),
        ([{"mesh": 0, "matrix": ["x"] * 16}], '"matrix" is no list of numbers'),
        ([{"mesh": -1}], "which is no whole number from 0 on"),
        ([{}], "holds no triangles: its scene shows no mesh"),
    ],
)
def test_nodes_that_are_refused(tmp_path: Path, nodes: list[Any], says: str) -> None:
    with pytest.raises(InputError, match=says):
        read_parts(gltf(tmp_path, quad(), nodes=nodes))


def test_nodes_are_placed_by_those_above(tmp_path: Path) -> None:
    nodes = [{"children": [1], "scale": [2, 2, 2]}, {"name": "sleeve", "mesh": 0, "translation": [1, 0, 0]}]
    (part,) = read_parts(gltf(tmp_path, quad(), nodes=nodes))
    assert part.name == "sleeve"
    np.testing.assert_allclose(part.mesh.positions, 2 * (CORNERS + np.array([1, 0, 0])))


@pytest.mark.parametrize("version", ["1.0", "1", "3.0", 1, "", "\n"])
def test_other_versions_are_named(tmp_path: Path, version: object) -> None:
    with pytest.raises(InputError, match=r"is glTF of version .*, and version 2.0 is read") as caught:
        read_parts(gltf(tmp_path, quad(), asset={"version": version}))
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("accessor", "says"),
    [
        ({"count": 400_000_000}, "400000000 elements of 8 bytes do not fit"),
        ({"count": 10**30}, "1000000000000000000000000000000 elements"),
        ({"count": -1}, "which is no whole number from 0 on"),
        ({"bufferView": 99}, 'names number 99 of its "bufferViews"'),
        ({"byteOffset": 10**9}, "do not fit"),
        ({"componentType": 5124}, '"componentType" is 5124'),
        ({"type": "VEC9"}, "an accessor is of type"),
        ({"type": "SCALAR"}, "stands where 2 numbers are needed"),
        ({"count": 3}, "differ in their number of vertices"),
        ({"sparse": {"count": 9}}, "a sparse accessor changes 9 of 4 elements"),
        (
            {"sparse": {"count": 3, "indices": {"bufferView": 2, "componentType": 5126}, "values": {}}},
            "do not fit",
        ),
    ],
)  # fmt: skip
def test_accessors_that_are_refused_at_once(tmp_path: Path, accessor: dict[str, Any], says: str) -> None:
    file = gltf(tmp_path, quad(indices=np.array([0, 1, 2], "<u2")), accessor)
    with allocates_at_most(1 << 20), pytest.raises(InputError, match=says):
        read_parts(file)


def test_sparse_elements_replace_others(tmp_path: Path) -> None:
    file = gltf(tmp_path, {**quad(), "at": np.array([1, 2], "<u2"), "values": UV[:2] + 5})
    tree = json.loads(file.read_text())
    for name in ("at", "values"):
        del tree["meshes"][0]["primitives"][0]["attributes"][name]
    tree["accessors"][1]["sparse"] = {
        "count": 2, "indices": {"bufferView": 3, "componentType": 5123}, "values": {"bufferView": 4},
    }  # fmt: skip
    file.write_text(json.dumps(tree))
    np.testing.assert_allclose(mesh_of(file).uv, [UV[0], [5, 5], [6, 5], UV[3]])


def repeated(folder: Path, count: int, vertices: int) -> list[MeshPart]:
    """So many primitives that share one large array."""
    rows = np.zeros((vertices, 3), "<f4")
    rows[:4] = CORNERS
    uv = rows[:, :2]
    file = gltf(folder, {"POSITION": rows, "TEXCOORD_0": uv, "indices": np.array([0, 1, 2, 0, 2, 3], "<u2")})
    tree = json.loads(file.read_text())
    tree["meshes"][0]["primitives"] *= count
    file.write_text(json.dumps(tree))
    return read_parts(file)


def test_primitives_that_share_arrays_keep_their_own_rows(tmp_path: Path) -> None:
    assert {len(part.mesh.positions) for part in repeated(tmp_path, 20, 10_000)} == {4}


@pytest.mark.slow
def test_what_is_read_again_and_again_is_bounded(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="the same ones again and again"):
        repeated(tmp_path, 2000, 200_000)
    with pytest.raises(InputError, match="shows more than 20000 parts"):
        repeated(tmp_path, 20_001, 4)


QUARTER = np.diag([0.25, 0.25, 0.25, 1]).astype("<f4")
JOINTS = np.array([[0, 1, 0, 0]] * 4, "|u1")


def skinned(folder: Path, weights: list[list[float]], nodes: list[Any], **skin: Any) -> ClothMesh:
    """A quad that hangs on two joints, the nodes 1 and 2."""
    arrays = quad(NORMAL=np.tile(np.array([[0, 0, 1]], "<f4"), (4, 1)))
    arrays |= {"JOINTS_0": JOINTS, "WEIGHTS_0": np.array(weights, "<f4")}
    scenes = [{"nodes": list(range(len(nodes)))}]
    return mesh_of(gltf(folder, arrays, nodes=nodes, scenes=scenes, skins=[{"joints": [1, 2], **skin}]))


def test_skins_follow_their_joints_and_not_their_node(tmp_path: Path) -> None:
    """glTF 2.0, 3.7.3.3: the transform of a skinned mesh's own node is ignored."""
    nodes = [{"mesh": 0, "skin": 0, "scale": [0.25] * 3}, {"scale": [2] * 3}, {"translation": [0, 0, 4]}]
    weights = [
        [1, 0, 0, 0],
        [0, 1, 0, 0],
        [0.5, 0.5, 0, 0],
        [2, 2, 0, 0],
    ]  # of which the last do not sum to 1
    mesh = skinned(tmp_path, weights, nodes)
    expected = [
        CORNERS[0] * 2,
        CORNERS[1] + [0, 0, 4],
        CORNERS[2] * 1.5 + [0, 0, 2],
        CORNERS[3] * 1.5 + [0, 0, 2],
    ]
    np.testing.assert_allclose(mesh.positions, expected)
    np.testing.assert_allclose(mesh.normals / np.linalg.norm(mesh.normals, axis=1)[:, None], [[0, 0, 1]] * 4)


def test_joints_are_undone_where_they_were_bound(tmp_path: Path) -> None:
    nodes: list[Any] = [{"mesh": 0, "skin": 0}, {"scale": [4] * 3}, {}]
    bound = np.stack([QUARTER.T, np.eye(4, dtype="<f4")])
    arrays = quad() | {"JOINTS_0": JOINTS, "WEIGHTS_0": np.array([[1, 0, 0, 0]] * 4, "<f4")}
    file = gltf(tmp_path, arrays | {"bound": bound}, nodes=nodes, scenes=[{"nodes": [0, 1, 2]}])
    tree = json.loads(file.read_text())
    number = tree["meshes"][0]["primitives"][0]["attributes"].pop("bound")
    file.write_text(json.dumps(tree | {"skins": [{"joints": [1, 2], "inverseBindMatrices": number}]}))
    np.testing.assert_allclose(mesh_of(file).positions, CORNERS)


def test_mirrored_skins_keep_their_front(tmp_path: Path) -> None:
    nodes = [{"mesh": 0, "skin": 0}, {"scale": [-1, 1, 1]}, {}]
    mesh = skinned(tmp_path, [[1, 0, 0, 0]] * 4, nodes)
    assert (cross_products(mesh)[:, 2] > 0).all()
    assert (mesh.normals[:, 2] > 0).all()


@pytest.mark.parametrize(
    ("weights", "skin", "says"),
    [
        (
            [[1, 0, 0, 0]] * 4,
            {"joints": [1, 9]},
            "skin 0 has no joints, or some that the scene does not show",
        ),
        ([[1, 0, 0, 0]] * 4, {"joints": [1]}, "a vertex hangs on joint 1 of 1"),
        ([[1, 0, 0, 0]] * 4, {"joints": []}, "skin 0 has no joints"),
    ],
)
def test_skins_that_are_refused(
    tmp_path: Path, weights: list[list[float]], skin: dict[str, Any], says: str
) -> None:
    with pytest.raises(InputError, match=says):
        skinned(tmp_path, weights, [{"mesh": 0, "skin": 0}, {}, {}], **skin)


@pytest.mark.parametrize("place", ["meshes", "nodes"])
def test_morph_targets_have_their_default_weights(tmp_path: Path, place: str) -> None:
    moved = np.array([[0, 0, 2]] * 4, "<f4")
    file = gltf(tmp_path, quad(moved=moved))
    tree = json.loads(file.read_text())
    primitive = tree["meshes"][0]["primitives"][0]
    number = primitive["attributes"].pop("moved")
    primitive["targets"] = [{"POSITION": number}, {"POSITION": number}]
    tree["meshes"][0]["weights"] = [9, 9]  # which those of a node replace
    tree[place][0]["weights"] = [0.25, 0.5]
    file.write_text(json.dumps(tree))
    np.testing.assert_allclose(mesh_of(file).positions, CORNERS + np.array([0, 0, 1.5]))


@pytest.mark.parametrize("name", ["KHR_mesh_quantization", "KHR_materials_sheen", "EXT_texture_webp"])
def test_required_extensions_that_are_read_or_change_no_shape(tmp_path: Path, name: str) -> None:
    assert len(mesh_of(gltf(tmp_path, quad(), extensionsRequired=[name])).triangles) == 2


def test_other_required_extensions_are_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match='requires the extension "VENDOR_x", which is not read'):
        read_parts(gltf(tmp_path, quad(), extensionsRequired=["VENDOR_x"]))
