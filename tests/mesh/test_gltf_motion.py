"""glTF animations against matrices by hand, times of their frames, cameras and further uv.

Covers: mesh/gltf.py, mesh/frames.py
"""

from __future__ import annotations

import json
from itertools import accumulate
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.mesh.reading import frame_times, read_cameras, read_parts
from tests.mesh.test_gltf_data import CODES, CORNERS, KINDS, UV, gltf, quad

HALF = float(np.sqrt(0.5))
QUARTER_TURN = [0.0, 0.0, HALF, HALF]  # about z, (x, y, z, w)


def moving(folder: Path, *channels: tuple[int, str, str, Any, Any], **more: Any) -> Path:
    """A file of a quad whose animation has channels: node, path, interpolation, keys and values."""
    return several(folder, [list(channels)], **more)


def several(folder: Path, clips: list[list[tuple[int, str, str, Any, Any]]], **more: Any) -> Path:
    """A file of several animations; their keys and values stand in buffer views after those of the quad."""
    arrays = more.pop("arrays", quad())
    pieces = [np.asarray(a) for a in arrays.values()]
    animations = []
    extra: list[np.ndarray] = []
    for channels in clips:
        made: dict[str, list[Any]] = {"channels": [], "samplers": []}
        for node, path, interpolation, keys, values in channels:
            made["channels"].append(
                {"sampler": len(made["samplers"]), "target": {"node": node, "path": path}}
            )
            first = len(pieces) + len(extra)
            made["samplers"].append({"input": first, "output": first + 1, "interpolation": interpolation})
            extra += [np.array(keys, "<f4"), np.array(values, "<f4")]
        animations.append(made)
    # `gltf` names every array but "indices" an attribute, so the file is made anew around its own.
    file = gltf(folder, arrays, animations=animations, **more)
    tree = json.loads(file.read_text())
    content = (folder / "mesh.bin").read_bytes()
    starts = [len(content), *(len(content) + n for n in accumulate(a.nbytes for a in extra))]
    for array, start in zip(extra, starts, strict=False):
        tree["accessors"].append(
            {
                "bufferView": len(tree["bufferViews"]),
                "componentType": CODES["<f4"],
                "count": len(array),
                "type": KINDS[array.size // len(array)],
            }
        )
        tree["bufferViews"].append({"buffer": 0, "byteOffset": start, "byteLength": array.nbytes})
    tree["buffers"][0]["byteLength"] = starts[-1]
    (folder / "mesh.bin").write_bytes(content + b"".join(a.tobytes() for a in extra))
    file.write_text(json.dumps(tree))
    return file


def corners(file: Path, time: float | None = None) -> np.ndarray:
    """The corners of the quad, in the order of `CORNERS`."""
    (part,) = read_parts(file, time)
    order = [int(np.flatnonzero((part.mesh.uv == uv).all(axis=1))[0]) for uv in UV]
    return part.mesh.positions[order]


@pytest.mark.parametrize(
    ("interpolation", "values", "middle"),
    [
        ("LINEAR", [(0, 0, 0), (4, 0, 8)], (1, 0, 2)),
        ("STEP", [(0, 0, 0), (4, 0, 8)], (0, 0, 0)),
        # Hermite at 1/4 over 2 s: 2(t³ − 2t² + t) = 0.28125 of the tangent behind the first key, 2(t³ − t²)
        # = −0.09375 of that before the second, and 3t² − 2t³ = 0.15625 of the second value.
        (
            "CUBICSPLINE",
            [(9, 9, 9), (0, 0, 0), (1, 0, 0), (0, 2, 0), (4, 0, 8), (9, 9, 9)],
            (0.28125 + 4 * 0.15625, -0.1875, 8 * 0.15625),
        ),
    ],
)
def test_translations(tmp_path: Path, interpolation: str, values: Any, middle: Any) -> None:
    file = moving(tmp_path, (0, "translation", interpolation, [1, 3], values))
    np.testing.assert_allclose(corners(file), CORNERS)
    for time, moved in ((0, (0, 0, 0)), (0.5, middle), (2, (4, 0, 8)), (9, (4, 0, 8))):
        np.testing.assert_allclose(corners(file, time), CORNERS + np.array(moved), atol=1e-6)


def test_rotations_take_the_shorter_way(tmp_path: Path) -> None:
    file = moving(tmp_path, (0, "rotation", "LINEAR", [0, 1], [(0, 0, 0, 1), [-x for x in QUARTER_TURN]]))
    angle = np.pi / 6  # a third of the quarter turn
    turn = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    np.testing.assert_allclose(corners(file, 1 / 3), CORNERS @ turn.T, atol=1e-6)


def test_nodes_above_move_too(tmp_path: Path) -> None:
    nodes = [{"mesh": 0, "translation": [1, 0, 0]}, {"children": [0], "scale": [2, 2, 2]}]
    file = moving(
        tmp_path,
        (1, "rotation", "STEP", [0, 1], [(0, 0, 0, 1), QUARTER_TURN]),
        (0, "scale", "LINEAR", [0, 1], [(1, 1, 1), (3, 1, 1)]),
        nodes=nodes,
        scenes=[{"nodes": [1]}],
    )
    np.testing.assert_allclose(corners(file), (CORNERS + np.array([1, 0, 0])) * 2)
    x, y = ((CORNERS * [3, 1, 1] + [1, 0, 0]) * 2)[:, :2].T
    np.testing.assert_allclose(corners(file, 1), np.stack([-y, x, 0 * x], axis=1), atol=1e-6)


def test_weights_of_morph_targets(tmp_path: Path) -> None:
    arrays = quad(lift=np.array([[0, 0, 1]] * 4, "<f4"), push=np.array([[0, 1, 0]] * 4, "<f4"))
    numbers = {name: number for number, name in enumerate(arrays)}
    primitive = {
        "attributes": {"POSITION": 0, "TEXCOORD_0": 1},
        "indices": numbers["indices"],
        "targets": [{"POSITION": numbers["lift"]}, {"POSITION": numbers["push"]}],
    }
    file = moving(
        tmp_path,
        (0, "weights", "LINEAR", [0, 1], [0.0, 1.0, 2.0, 0.0]),
        arrays=arrays,
        meshes=[{"primitives": [primitive], "weights": [0.5, 0]}],
    )
    np.testing.assert_allclose(corners(file), CORNERS + np.array([0, 0, 0.5]))
    np.testing.assert_allclose(corners(file, 0.25), CORNERS + np.array([0, 0.75, 0.5]))


def test_skins_follow_their_joints(tmp_path: Path) -> None:
    arrays = quad(
        JOINTS_0=np.array([[0, 1, 0, 0]] * 4, "|u1"), WEIGHTS_0=np.array([[0.5, 0.5, 0, 0]] * 4, "<f4")
    )
    file = moving(
        tmp_path,
        (2, "translation", "LINEAR", [0, 1], [(0, 0, 0), (0, 0, 4)]),
        arrays=arrays,
        nodes=[{"mesh": 0, "skin": 0}, {}, {}],
        scenes=[{"nodes": [0, 1, 2]}],
        skins=[{"joints": [1, 2]}],
    )
    np.testing.assert_allclose(corners(file, 0.5), CORNERS + np.array([0, 0, 1]))
    assert frame_times(file) == pytest.approx(np.arange(25) / 24)


def test_of_clips_of_one_node_the_first_is_played(tmp_path: Path) -> None:
    nodes = [{"mesh": 0}, {"children": [0]}]
    walk = [(0, "translation", "LINEAR", [0, 1], [(0, 0, 0), (1, 0, 0)])]
    run = [
        (0, "translation", "LINEAR", [0, 3], [(0, 0, 0), (9, 0, 0)]),
        (1, "scale", "LINEAR", [0, 3], [(1, 1, 1), (9, 9, 9)]),
    ]
    fly = [(1, "translation", "LINEAR", [0, 2], [(0, 0, 0), (0, 2, 0)])]
    file = several(tmp_path, [walk, run, fly], nodes=nodes, scenes=[{"nodes": [1]}])
    np.testing.assert_allclose(corners(file, 1), CORNERS + np.array([1, 1, 0]))
    assert frame_times(file)[-1] == 2


@pytest.mark.parametrize(
    ("keys", "rate", "count"),
    [
        ([0, 1 / 30, 1], 30, 31),
        ([5, 5.04, 6], 25, 26),
        ([0, 0.017, 0.5], 24, 13),  # on no rate
        ([0, 1], 24, 25),
    ],
)
def test_times_of_frames(tmp_path: Path, keys: list[float], rate: float, count: int) -> None:
    values = [(float(key), 0, 0) for key in keys]
    file = moving(tmp_path, (0, "translation", "LINEAR", keys, values))
    assert frame_times(file) == pytest.approx(np.arange(count) / rate)


def test_cameras_that_move_make_no_frames(tmp_path: Path) -> None:
    nodes = [{"mesh": 0}, {"camera": 0}]
    file = moving(
        tmp_path,
        (1, "translation", "LINEAR", [0, 1], [(0, 0, 0), (0, 0, 6)]),
        nodes=nodes,
        scenes=[{"nodes": [0, 1]}],
        cameras=[{"type": "perspective", "perspective": {"yfov": 1.0, "znear": 0.1}}],
    )
    assert frame_times(file) == []
    (camera,) = read_cameras(file, 0.5)
    np.testing.assert_allclose(camera.to_world[:3, 3], [0, 0, 3])


def test_cameras(tmp_path: Path) -> None:
    nodes = [
        {"mesh": 0, "children": [1], "scale": [2, 2, 2]},
        {"camera": 0, "name": "front", "translation": [0, 1, 2], "rotation": QUARTER_TURN},
        {"camera": 1},
    ]
    lens = {"yfov": 0.5, "aspectRatio": 1.25, "znear": 0.1}
    cameras = [
        {"type": "perspective", "perspective": lens},
        {
            "type": "orthographic",
            "name": "plan",
            "orthographic": {"xmag": 1, "ymag": 1, "zfar": 2, "znear": 0},
        },
    ]
    file = gltf(tmp_path, quad(), nodes=nodes, scenes=[{"nodes": [0, 2]}], cameras=cameras)
    found = {camera.name: camera for camera in read_cameras(file)}
    assert set(found) == {"front", "plan"}
    assert found["plan"].orthographic
    front = found["front"]
    assert (front.vertical, front.aspect, front.orthographic) == (pytest.approx(np.degrees(0.5)), 1.25, False)
    expected = [[0, -1, 0, 0], [1, 0, 0, 2], [0, 0, 1, 4], [0, 0, 0, 1]]
    np.testing.assert_allclose(front.to_world, expected, atol=1e-6)


def test_further_uv_are_attributes(tmp_path: Path) -> None:
    file = gltf(
        tmp_path,
        quad(TEXCOORD_1=UV * 2, TEXCOORD_2=UV * 3),
        materials=[{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 1}}}],
    )
    (part,) = read_parts(file)
    assert set(part.mesh.attributes) - {"index", "uv"} == {"uv1", "uv2"}
    np.testing.assert_allclose(part.mesh.attributes["uv1"], part.mesh.uv / 2)
    np.testing.assert_allclose(part.mesh.attributes["uv2"], part.mesh.uv * 1.5)


@pytest.mark.parametrize(
    ("channel", "more", "says"),
    [
        ((0, "translation", "LINEAR", [0, 0], [(0, 0, 0)] * 2), {}, "times of an animation do not rise"),
        ((0, "translation", "LINEAR", [0, np.nan], [(0, 0, 0)] * 2), {}, "times of an animation do not rise"),
        ((0, "translation", "CUBICSPLINE", [0, 1], [(0, 0, 0)] * 2), {}, "has 2 keys and 2 values"),
        ((0, "rotation", "LINEAR", [0, 1], [(0, 0, 0)] * 2), {}, "where 4 numbers are needed"),
        ((0, "scale", "WAVE", [0, 1], [(0, 0, 0)] * 2), {}, "interpolation of an animation is 'WAVE'"),
        ((7, "scale", "STEP", [0, 1], [(0, 0, 0)] * 2), {}, 'number 7 of its "nodes"'),
        (
            (0, "scale", "STEP", [0, 1], [(1, 1, 1)] * 2),
            {"nodes": [{"mesh": 0, "matrix": np.eye(4).ravel().tolist()}]},
            "node 0 has a matrix and is animated",
        ),
    ],
)  # fmt: skip
def test_damaged_animations(tmp_path: Path, channel: Any, more: dict[str, Any], says: str) -> None:
    with pytest.raises(InputError, match=says):
        read_parts(moving(tmp_path, channel, **more), 0.5)


def test_too_many_frames(tmp_path: Path) -> None:
    file = moving(tmp_path, (0, "translation", "LINEAR", [0, 1e6], [(0, 0, 0)] * 2))
    with pytest.raises(InputError, match="at most 86400 frames"):
        frame_times(file)
