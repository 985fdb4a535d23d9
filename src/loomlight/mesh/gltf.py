"""glTF meshes: primitives of triangles, placed by their nodes, with the uv that their base colour takes.

At rest morph targets have the file's default weights, and joints stand where their nodes do; at a time
animations move both. Their other uv are attributes: "uv1", "uv2" … in the order of their numbers.
"""

from __future__ import annotations

import base64
import binascii
import json
import re
import struct
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeGuard
from urllib.parse import unquote

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError, MissingDependencyError
from loomlight.core.extras import installing
from loomlight.mesh.cloth_mesh import (
    MAX_PARTS,
    MAX_TRIANGLES,
    ClothMesh,
    MeshPart,
    check_indices,
    placed,
    strip_triangles,
)
from loomlight.mesh.file_camera import FileCamera, rigid
from loomlight.mesh.frames import times_of_frames

# Modes of primitives; those before are points and lines.
_TRIANGLES, _STRIP, _FAN = 4, 5, 6
_DRACO = "KHR_draco_mesh_compression"
_INSTANCING = "EXT_mesh_gpu_instancing"
_TRANSFORM = "KHR_texture_transform"


def read_gltf(file: Path, time: float | None = None) -> list[MeshPart]:
    """A part for each primitive of each node, named by the node or else its mesh, where the scene places it.

    Args:
        time: seconds after the first key of its animations; None for what it shows without them.

    Raises:
        InputError: a damaged file, or one that shows no triangles.
    """
    gltf = load_gltf(file)
    _animate(gltf, time)
    parts: list[MeshPart] = []
    known: dict[_Shape, list[MeshPart]] = {}
    total = 0
    shown, world = _placements(gltf)
    for node, matrix in shown:
        shape = _shape_of(gltf, node)
        mesh = gltf.entry("meshes", shape.mesh)
        if shape not in known:
            known[shape] = _primitives(
                gltf, mesh, _Pose(shape.morph_weights, _joints(gltf, shape.skin, world))
            )
        total += sum(len(part.mesh.triangles) for part in known[shape])
        _check_total(total, file)
        name = _text(node) or _text(mesh)
        if len(parts) + len(known[shape]) > MAX_PARTS:
            raise InputError(f"{file} shows more than {MAX_PARTS} parts, copies included: join some.")
        parts += [MeshPart(name, part.material, placed(part.mesh, matrix)) for part in known[shape]]
    if not parts:
        reason = "its meshes are points or lines" if known else "its scene shows no mesh"
        raise InputError(f"{file} holds no triangles: {reason}.")
    return parts


@dataclass(frozen=True)
class _Shape:
    """A mesh as a node shows it: nodes of one shape share their arrays.

    Attributes:
        skin: its number; None of a mesh that stands where its node does.
        morph_weights: of the targets of its primitives; those beyond the list have none.
    """

    mesh: int
    skin: int | None
    morph_weights: tuple[float, ...]


@dataclass(frozen=True, eq=False)
class _Pose:
    """What moves the vertices of a shape before it is placed.

    Attributes:
        joints: [n, 4, 4], from the mesh's space to the scene's by each joint; None without a skin.
    """

    morph_weights: tuple[float, ...]
    joints: NDArray[np.float64] | None


def _shape_of(gltf: GltfFile, node: Entry) -> _Shape:
    number = gltf.integer(node, "mesh")
    weights = node.get("weights", gltf.entry("meshes", number).get("weights", []))
    if not isinstance(weights, list):
        raise gltf.damaged('the "weights" of a mesh or node are no list')
    holder = {"weights": weights}
    return _Shape(
        number,
        gltf.integer(node, "skin") if "skin" in node else None,
        tuple(_vector(gltf, holder, "weights", [0.0] * len(weights)).tolist()),
    )


def _check_total(total: int, file: Path) -> None:
    if total > MAX_TRIANGLES:
        raise InputError(f"{file} shows more than {MAX_TRIANGLES} triangles, copies included: export fewer.")


def _text(entry: Entry) -> str:
    name = entry.get("name")
    return " ".join(name.split()) if isinstance(name, str) else ""


def _placements(
    gltf: GltfFile,
) -> tuple[list[tuple[Entry, NDArray[np.float64]]], dict[int, NDArray[np.float64]]]:
    """Each node of the scene that has a mesh, and its matrix; a node again for each of its instances.

    Beside them the matrix of every node. Of a skinned mesh joints alone say where it is (glTF 2.0, 3.7.3.3).
    """
    world: dict[int, NDArray[np.float64]] = {}
    shown: list[tuple[Entry, NDArray[np.float64]]] = []
    waiting = [(number, np.eye(4)) for number in reversed(_roots(gltf))]
    while waiting:
        number, above = waiting.pop()
        node = gltf.entry("nodes", number)
        if number in world:
            raise gltf.damaged(f"node {number} is its own ancestor, or has two parents")
        matrix = world[number] = above @ _own_matrix(gltf, node)
        if "mesh" in node and "skin" in node:
            shown.append((node, np.eye(4)))
        elif "mesh" in node:
            shown += [(node, matrix @ instance) for instance in _instances(gltf, node)]
        waiting += [(child, matrix) for child in reversed(_children(gltf, node))]
    return shown, world


def _joints(
    gltf: GltfFile, number: int | None, world: dict[int, NDArray[np.float64]]
) -> NDArray[np.float64] | None:
    """Matrices [n, 4, 4] of a skin's joints: back to the joint as it was bound, then to where it stands."""
    if number is None:
        return None
    skin = gltf.entry("skins", number)
    joints = _children(gltf, skin, "joints")
    if not joints or not set(joints) <= set(world):
        raise gltf.damaged(f"skin {number} has no joints, or some that the scene does not show")
    matrices = np.stack([world[joint] for joint in joints])
    if "inverseBindMatrices" in skin:
        bound = attribute(gltf, skin["inverseBindMatrices"], 16)
        if len(bound) < len(joints):
            raise gltf.damaged(f"skin {number} has {len(joints)} joints and {len(bound)} matrices")
        matrices = matrices @ bound[: len(joints)].reshape(-1, 4, 4).transpose(0, 2, 1)
    if not np.isfinite(matrices).all():
        raise gltf.damaged(f"a matrix of skin {number} holds numbers that are not finite")
    return matrices


def _children(gltf: GltfFile, node: Entry, key: str = "children") -> list[int]:
    children = node.get(key, [])
    if not isinstance(children, list) or not all(type(child) is int for child in children):
        raise gltf.damaged(f'"{key}" of a node or scene is no list of numbers')
    return children


def _roots(gltf: GltfFile) -> list[int]:
    """The nodes of the file's scene; of a file without scenes all that are no children."""
    if gltf.entries("scenes"):
        return _children(gltf, gltf.entry("scenes", gltf.integer(gltf.tree, "scene", 0)), "nodes")
    numbers = range(len(gltf.entries("nodes")))
    below = {child for number in numbers for child in _children(gltf, gltf.entry("nodes", number))}
    return [number for number in numbers if number not in below]


def _vector(gltf: GltfFile, holder: Entry, key: str, default: list[float]) -> NDArray[np.float64]:
    values = holder.get(key, default)
    try:
        vector = np.array(values, dtype=np.float64)
    except (TypeError, ValueError, OverflowError) as error:
        raise gltf.damaged(f'"{key}" is no list of numbers') from error
    if vector.shape != (len(default),) or not np.isfinite(vector).all():
        raise gltf.damaged(f'"{key}" is no list of {len(default)} finite numbers')
    return vector


def _own_matrix(gltf: GltfFile, node: Entry) -> NDArray[np.float64]:
    if "matrix" in node:
        return _vector(gltf, node, "matrix", np.eye(4).ravel().tolist()).reshape(4, 4).T
    return _matrix(
        _vector(gltf, node, "translation", [0, 0, 0]),
        _vector(gltf, node, "rotation", [0, 0, 0, 1]),
        _vector(gltf, node, "scale", [1, 1, 1]),
    )


def _matrix(
    translation: NDArray[np.float64], rotation: NDArray[np.float64], scale: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Scaled, then turned by the quaternion (x, y, z, w), then moved."""
    x, y, z, w = rotation / max(float(np.linalg.norm(rotation)), 1e-30)
    turn = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    matrix = np.eye(4)
    matrix[:3, :3] = np.array(turn) * scale
    matrix[:3, 3] = translation
    return matrix


def _instances(gltf: GltfFile, node: Entry) -> list[NDArray[np.float64]]:
    """The matrices of a node's instances; one that changes nothing where it has none."""
    places = gltf.dictionary(node, "extensions", _INSTANCING, "attributes")
    names = {"TRANSLATION": 3, "ROTATION": 4, "SCALE": 3}
    given = {name: attribute(gltf, places[name], width) for name, width in names.items() if name in places}
    if not given:
        return [np.eye(4)]
    count = min(len(rows) for rows in given.values())
    still = {"TRANSLATION": [0.0, 0, 0], "ROTATION": [0.0, 0, 0, 1], "SCALE": [1.0, 1, 1]}
    rows = [given.get(name, np.tile(values, (count, 1))) for name, values in still.items()]
    return [_matrix(*(values[number] for values in rows)) for number in range(count)]


def _primitives(gltf: GltfFile, mesh: Entry, pose: _Pose) -> list[MeshPart]:
    """The primitives of triangles of a mesh in their pose, not placed yet."""
    primitives = mesh.get("primitives", [])
    if not isinstance(primitives, list) or not all(isinstance(entry, dict) for entry in primitives):
        raise gltf.damaged('the "primitives" of a mesh are no list of objects')
    parts = []
    total = 0
    for primitive in primitives:
        if gltf.integer(primitive, "mode", _TRIANGLES) < _TRIANGLES:
            continue
        material = gltf.entry("materials", primitive["material"]) if "material" in primitive else {}
        made = _geometry(gltf, primitive, material, pose)
        total += len(made.triangles)
        _check_total(total, gltf.file)
        parts.append(MeshPart("", _text(material), made))
    return parts


def _geometry(gltf: GltfFile, primitive: Entry, material: Entry, pose: _Pose) -> ClothMesh:
    names = gltf.dictionary(primitive, "attributes")
    if "POSITION" not in names:
        raise gltf.damaged("a primitive has no positions")
    uv_name, transform = _uv_of_material(gltf, material, names)
    others = sorted(_texture_coordinates(names) - {uv_name})
    widths = {"POSITION": 3, "NORMAL": 3, uv_name: 2, **dict.fromkeys(others, 2)} | _skin_widths(names, pose)
    wanted = {name: width for name, width in widths.items() if name in names}
    compressed = gltf.dictionary(primitive, "extensions", _DRACO)
    if compressed:
        arrays, triangles = decoded_primitive(gltf, compressed, names, wanted)
    else:
        arrays = {name: attribute(gltf, names[name], width) for name, width in wanted.items()}
        count = len(arrays["POSITION"])
        given = primitive.get("indices")
        index = np.arange(count) if given is None else indices(gltf, given)
        triangles = _triangles(gltf, index, gltf.integer(primitive, "mode", _TRIANGLES))
    count = len(arrays["POSITION"])
    if any(len(rows) != count for rows in arrays.values()):
        raise gltf.damaged("the attributes of a primitive differ in their number of vertices")
    check_indices(triangles, count, str(gltf.file))
    _morph(gltf, primitive, arrays, pose.morph_weights)
    if pose.joints is not None:
        triangles = _skinned(gltf, arrays, triangles, pose.joints)
    none = np.zeros((0, 3))
    uv = arrays[uv_name] @ transform[:, :2].T + transform[:, 2] if uv_name in arrays else np.zeros((0, 2))
    # Primitives may share one large array, of which each uses some rows.
    used, inverse = np.unique(triangles, return_inverse=True)
    normals = arrays.get("NORMAL", none)
    return ClothMesh(
        positions=arrays["POSITION"][used],
        normals=normals[used] if len(normals) else none,
        uv=uv[used] if len(uv) else uv,
        triangles=inverse.reshape(-1, 3),
        name=str(gltf.file),
        attributes={f"uv{number}": arrays[name][used] for number, name in enumerate(others, 1)},
    )


def _texture_coordinates(names: Entry) -> set[str]:
    return {name for name in names if re.fullmatch(r"TEXCOORD_\d", name)}


def _skin_widths(names: Entry, pose: _Pose) -> dict[str, int]:
    """The attributes of joints and their weights, four numbers a vertex each."""
    if pose.joints is None:
        return {}
    return {name: 4 for name in names if name.startswith(("JOINTS_", "WEIGHTS_"))}


def _morph(
    gltf: GltfFile, primitive: Entry, arrays: dict[str, NDArray[np.float64]], weights: tuple[float, ...]
) -> None:
    """Adds the displacements of a primitive's morph targets to its arrays, by their weights."""
    targets = primitive.get("targets", [])
    if not isinstance(targets, list) or not all(isinstance(target, dict) for target in targets):
        raise gltf.damaged('the "targets" of a primitive are no list of objects')
    for target, weight in zip(targets, weights, strict=False):  # targets without a weight have none
        if weight == 0:
            continue
        for name in arrays.keys() & target.keys():
            moved = attribute(gltf, target[name], arrays[name].shape[1])
            if len(moved) != len(arrays[name]):
                raise gltf.damaged("a morph target differs from its primitive in its number of vertices")
            arrays[name] = arrays[name] + weight * moved


def _skinned(
    gltf: GltfFile,
    arrays: dict[str, NDArray[np.float64]],
    triangles: NDArray[np.int64],
    joints: NDArray[np.float64],
) -> NDArray[np.int64]:
    """Moves positions and normals to where joints hold them; the triangles, turned if they are mirrored."""
    sets = sorted(name.removeprefix("JOINTS_") for name in arrays if name.startswith("JOINTS_"))
    if not sets or any(f"WEIGHTS_{number}" not in arrays for number in sets):
        raise gltf.damaged("a skinned primitive has no joints and weights")
    index = np.concatenate([arrays[f"JOINTS_{number}"] for number in sets], axis=1).astype(np.int64)
    weights = np.concatenate([arrays[f"WEIGHTS_{number}"] for number in sets], axis=1)
    if index.size and not 0 <= index.min() <= index.max() < len(joints):
        raise gltf.damaged(f"a vertex hangs on joint {index.max()} of {len(joints)}")
    total = weights.sum(axis=1, keepdims=True)
    weights = np.divide(weights, total, out=np.zeros_like(weights), where=total > 0)
    weights[total[:, 0] <= 0, :1] = 1  # what hangs on nothing follows its first joint
    matrices = np.zeros((len(index), 3, 4))
    for column in range(index.shape[1]):  # one at a time: all at once would take 3 GB of a million vertices
        matrices += weights[:, column, None, None] * joints[index[:, column], :3]
    linear = matrices[..., :3]
    arrays["POSITION"] = np.einsum("nij,nj->ni", linear, arrays["POSITION"]) + matrices[..., 3]
    mirrored = np.linalg.det(linear) < 0
    if "NORMAL" in arrays:
        columns = linear.transpose(2, 0, 1)
        # Normals follow the cofactors, of the determinant's sign.
        turned = sum(
            arrays["NORMAL"][:, k, None] * np.cross(columns[(k + 1) % 3], columns[(k + 2) % 3])
            for k in range(3)
        )
        arrays["NORMAL"] = np.where(mirrored[:, None], -turned, turned)
    return triangles[:, ::-1] if mirrored.mean() > 0.5 else triangles


def _triangles(gltf: GltfFile, index: NDArray[np.int64], mode: int) -> NDArray[np.int64]:
    if mode == _TRIANGLES:
        return index[: len(index) // 3 * 3].reshape(-1, 3)
    if mode == _STRIP:
        return strip_triangles(index)
    if mode == _FAN:
        inner, outer = index[1:-1], index[2:]
        return np.stack([inner, outer, np.broadcast_to(index[:1], inner.shape)], axis=1)
    raise gltf.damaged(f"a primitive is of mode {mode}")


def _uv_of_material(gltf: GltfFile, material: Entry, names: Entry) -> tuple[str, NDArray[np.float64]]:
    """The uv set of the base colour's texture, or the first that there is, and its transform [2, 3]."""
    texture = gltf.dictionary(material, "pbrMetallicRoughness", "baseColorTexture") or gltf.dictionary(
        material, "extensions", "KHR_materials_pbrSpecularGlossiness", "diffuseTexture"
    )
    change = gltf.dictionary(texture, "extensions", _TRANSFORM)
    name = f"TEXCOORD_{gltf.integer(change, 'texCoord', gltf.integer(texture, 'texCoord', 0))}"
    if name not in names:
        name = min(_texture_coordinates(names), default=name)
    u, v = _vector(gltf, change, "scale", [1, 1])
    angle = change.get("rotation", 0)
    if isinstance(angle, bool) or not isinstance(angle, int | float) or not abs(angle) < 1e6:
        raise gltf.damaged(f'the "rotation" of a texture is {repr(angle)[:20]}')
    # Counter-clockwise in uv, whose v runs down.
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    offset = _vector(gltf, change, "offset", [0, 0])
    return name, np.concatenate([turn * [u, v], offset[:, None]], axis=1)


# ------------------------------------------------------------------------------------- animations and cameras
# What animations make of nodes at a time, and the cameras of nodes.


# Rows of the output of a sampler for each of its keys, by its interpolation.
_ROWS_OF_KEY = {"LINEAR": 1, "STEP": 1, "CUBICSPLINE": 3}
_WIDTHS_OF_PATHS = {"translation": 3, "rotation": 4, "scale": 3, "weights": 1}
# Frames a second at which animations are keyed; the first that all keys of a file lie on is taken.
_RATES = (24, 25, 30, 48, 50, 60, 120)


@dataclass(frozen=True, eq=False)
class _Channel:
    """What an animation does to a node.

    Attributes:
        path: "translation", "rotation", "scale" or "weights", of the morph targets.
        keys: times, seconds, which rise.
        values: [keys, 1, k], or [keys, 3, k] of a spline: tangent before, value and tangent behind.
    """

    node: int
    path: str
    interpolation: str
    keys: NDArray[np.float64]
    values: NDArray[np.float64]

    def at(self, time: float) -> NDArray[np.float64]:
        """The value [k] at a time, held before the first and after the last key (glTF 2.0, appendix C)."""
        keys, values = self.keys, self.values
        time = min(max(time, keys[0]), keys[-1])
        before = int(np.searchsorted(keys, time, side="right")) - 1
        middle = values.shape[1] // 2
        first = values[before, middle]
        if before + 1 == len(keys) or self.interpolation == "STEP":
            return first
        second, step = values[before + 1, middle], keys[before + 1] - keys[before]
        t = (time - keys[before]) / step
        if self.interpolation == "CUBICSPLINE":
            out, into = step * values[before, 2], step * values[before + 1, 0]
            return (
                (2 * t**3 - 3 * t**2 + 1) * first
                + (t**3 - 2 * t**2 + t) * out
                + (3 * t**2 - 2 * t**3) * second
                + (t**3 - t**2) * into
            )
        if self.path == "rotation":
            return _slerp(first, second, t)
        return first + t * (second - first)


def gltf_frames(file: Path) -> list[float]:
    """Seconds of each frame from the first key to the last, at the rate of the keys; [] where no mesh moves.

    The rate is the first of 24, 25, 30, 48, 50, 60 and 120 a second that all keys lie on, or else 24.

    Raises:
        InputError: a damaged file, or too many frames.
    """
    gltf = load_gltf(file)
    moving = _moving_nodes(gltf)
    keys = np.concatenate(
        [np.zeros(0), *(channel.keys for channel in _channels(gltf) if channel.node in moving)]
    )
    if len(keys) == 0 or keys.min() == keys.max():
        return []
    offsets = keys - keys.min()
    rate = next((r for r in _RATES if np.abs(offsets * r - np.round(offsets * r)).max() < 0.01), _RATES[0])
    return times_of_frames(float(offsets.max()), rate, file)


def gltf_cameras(file: Path, time: float | None = None) -> list[FileCamera]:
    """The cameras that the nodes of the scene have, named by the node or else the camera.

    Raises:
        InputError: a damaged file.
    """
    gltf = load_gltf(file)
    _animate(gltf, time)
    _, world = _placements(gltf)
    return [
        _camera(gltf, node, matrix)
        for number, matrix in world.items()
        if "camera" in (node := gltf.entry("nodes", number))
    ]


def _camera(gltf: GltfFile, node: Entry, matrix: NDArray[np.float64]) -> FileCamera:
    entry = gltf.entry("cameras", node["camera"])
    name = _text(node) or _text(entry)
    if not np.isfinite(matrix).all():
        raise gltf.damaged(f'a transform of the camera "{name[:40]}" is not finite')
    if entry.get("type") == "orthographic":
        return FileCamera(name, rigid(matrix), 0.0, orthographic=True)
    lens = gltf.dictionary(entry, "perspective")
    height = _number(gltf, lens, "yfov")
    aspect = _number(gltf, lens, "aspectRatio") if "aspectRatio" in lens else None
    if not 0 < height < np.pi or (aspect is not None and aspect <= 0):
        raise gltf.damaged(f'the camera "{name[:40]}" has an angle or an aspect ratio that makes no picture')
    return FileCamera(name, rigid(matrix), float(np.degrees(height)), aspect)


def _number(gltf: GltfFile, holder: Entry, key: str) -> float:
    (value,) = _vector(gltf, {key: [holder.get(key)]}, key, [0.0])
    return float(value)


def _animate(gltf: GltfFile, time: float | None) -> None:
    """Gives nodes what animations make of them `time` seconds after the first key that moves a mesh."""
    if time is None:
        return
    channels = _channels(gltf)
    moving = _moving_nodes(gltf)
    start = min((channel.keys[0] for channel in channels if channel.node in moving), default=None)
    if start is None:
        start = min((channel.keys[0] for channel in channels), default=0.0)
    for channel in channels:
        node = gltf.entry("nodes", channel.node)
        if "matrix" in node and channel.path != "weights":
            raise gltf.damaged(f"node {channel.node} has a matrix and is animated")
        node[channel.path] = channel.at(start + time).tolist()


def _channels(gltf: GltfFile) -> list[_Channel]:
    """What is played: all animations together, but for those that move what one before them moves."""
    played: list[_Channel] = []
    taken: set[tuple[int, str]] = set()
    for number in range(len(gltf.entries("animations"))):
        animation = gltf.entry("animations", number)
        channels, samplers = animation.get("channels"), animation.get("samplers")
        if not isinstance(channels, list) or not isinstance(samplers, list):
            raise gltf.damaged(f"animation {number} has no channels and samplers")
        targets: dict[tuple[int, str], object] = {}
        for channel in channels:
            if not isinstance(channel, dict):
                raise gltf.damaged(f"a channel of animation {number} is no object of JSON")
            target = gltf.dictionary(channel, "target")
            path = target.get("path")
            if "node" in target and isinstance(path, str) and path in _WIDTHS_OF_PATHS:
                gltf.entry("nodes", target["node"])
                targets[target["node"], path] = channel.get("sampler")
        if taken & set(targets):
            continue  # another clip, to be played instead
        taken |= set(targets)
        played += [_channel(gltf, *target, samplers, sampler) for target, sampler in targets.items()]
    return played


def _channel(gltf: GltfFile, node: int, path: str, samplers: list[object], number: object) -> _Channel:
    sampler = samplers[number] if _is_index(number) and number < len(samplers) else None
    if not isinstance(sampler, dict):
        raise gltf.damaged(f"an animation names sampler {repr(number)[:20]}, which it does not have")
    interpolation = sampler.get("interpolation", "LINEAR")
    if not isinstance(interpolation, str) or interpolation not in _ROWS_OF_KEY:
        raise gltf.damaged(f"the interpolation of an animation is {repr(interpolation)[:20]}")
    keys = attribute(gltf, sampler.get("input"), 1)[:, 0]
    values = attribute(gltf, sampler.get("output"), _WIDTHS_OF_PATHS[path])
    rows = _ROWS_OF_KEY[interpolation]
    if not len(keys) or not np.isfinite(keys).all() or (np.diff(keys) <= 0).any():
        raise gltf.damaged("the times of an animation do not rise")
    # Of morph targets there is a number for each at each key; others have one row.
    width = len(values) // (len(keys) * rows) if path == "weights" else 1
    if len(values) != len(keys) * rows * width or not width:
        raise gltf.damaged(f"an animation has {len(keys)} keys and {len(values)} values")
    return _Channel(node, path, interpolation, keys, values.reshape(len(keys), rows, -1))


def _slerp(first: NDArray[np.float64], second: NDArray[np.float64], t: float) -> NDArray[np.float64]:
    """Between two quaternions, the shorter way round."""
    first, second = (each / max(float(np.linalg.norm(each)), 1e-30) for each in (first, second))
    cosine = float(first @ second)
    if cosine < 0:
        second, cosine = -second, -cosine
    if cosine > 1 - 1e-9:
        return first + t * (second - first)
    angle = np.arccos(cosine)
    return (np.sin((1 - t) * angle) * first + np.sin(t * angle) * second) / np.sin(angle)


def _moving_nodes(gltf: GltfFile) -> set[int]:
    """Nodes that have a mesh or are a joint, and all above these."""
    count = len(gltf.entries("nodes"))
    above = {
        child: number for number in range(count) for child in _children(gltf, gltf.entry("nodes", number))
    }
    waiting = [number for number in range(count) if "mesh" in gltf.entry("nodes", number)]
    for number in range(len(gltf.entries("skins"))):
        waiting += _children(gltf, gltf.entry("skins", number), "joints")
    found: set[int] = set()
    while waiting:
        number = waiting.pop()
        if number not in found:
            found.add(number)
            waiting += [above[number]] if number in above else []
    return found


# ------------------------------------------------------------------------------------- containers and buffers
# glTF files before their meshes are read: containers, buffers and files that they name, checked one by one.
#
# Only geometry and uv are used: pictures are not read.


# glTF 2.0, section 4.4: magic, version and length of the file; then length, type and content of each chunk.
_HEADER, _CHUNK = struct.Struct("<4sII"), struct.Struct("<I4s")
_DATA_URI = "data:"
# Extensions that a file may require: those that are read, and how the names of those begin that say nothing
# of geometry or uv.
_READ = (
    "KHR_draco_mesh_compression",
    "EXT_meshopt_compression",
    "KHR_meshopt_compression",
    "KHR_mesh_quantization",
    "EXT_mesh_gpu_instancing",
    "KHR_texture_transform",
)
_OF_LOOKS = (
    "KHR_materials_",
    "KHR_texture_",
    "EXT_texture_",
    "MSFT_texture_",
    "KHR_lights_",
    "EXT_lights_",
    "KHR_xmp",
)
Entry = dict[str, Any]


@dataclass(eq=False)
class GltfFile:
    """The JSON of a .gltf or .glb file, and its buffers, read when they are asked for.

    Attributes:
        own_buffer: of a GLB file.
        size: bytes of the file and of the buffers read so far; no array of the file has more rows.
        elements_read: of accessors so far.
    """

    file: Path
    tree: Entry
    own_buffer: bytes | None
    size: int
    elements_read: int = 0
    _buffers: dict[int, bytes] = field(default_factory=dict)

    def damaged(self, what: str) -> InputError:
        """The error that says what is wrong with the file."""
        return InputError(f"{self.file} is damaged: {what}; export it anew.")

    def entries(self, kind: str) -> list[Any]:
        """One of the lists of the file, "meshes" say; empty where it has none."""
        found = self.tree.get(kind, [])
        if not isinstance(found, list):
            raise self.damaged(f'its "{kind}" is no list')
        return found

    def entry(self, kind: str, index: object) -> Entry:
        """An entry of one of the lists; raises InputError if there is none."""
        entries = self.entries(kind)
        if not _is_index(index) or index >= len(entries) or not isinstance(entries[index], dict):
            raise self.damaged(f'it names number {repr(index)[:20]} of its "{kind}", which it does not have')
        return entries[index]

    def integer(self, holder: Entry, key: str, default: int | None = None) -> int:
        """A whole number from 0 on; raises InputError if it is none, or is missing and has no default."""
        value = holder.get(key, default)
        if not _is_index(value):
            raise self.damaged(f'"{key}" is {repr(value)[:20]}, which is no whole number from 0 on')
        return value

    def dictionary(self, holder: Entry, *keys: str) -> Entry:
        """An entry within an entry; empty where there is none."""
        for key in keys:
            holder = holder.get(key, {})
            if not isinstance(holder, dict):
                raise self.damaged(f'"{key}" is no object of JSON')
        return holder

    def buffer(self, index: int) -> bytes:
        """The bytes of a buffer: of the GLB itself, a data URI, or a file in the same folder or below."""
        if index not in self._buffers:
            entry = self.entry("buffers", index)
            self._buffers[index] = _buffer(entry, self.integer(entry, "byteLength"), index, self)
            self.size += len(self._buffers[index])
        return self._buffers[index]


def _is_index(value: object) -> TypeGuard[int]:
    return isinstance(value, int) and not isinstance(value, bool) and value >= 0


def load_gltf(file: Path) -> GltfFile:
    """The file, its JSON parsed.

    Raises:
        InputError: a damaged container, another version than 2, or an extension that it requires and that is
            not read.
    """
    content = file.read_bytes()
    is_binary = file.suffix.lower() == ".glb" or content.startswith(b"glTF")
    text, own_buffer = _chunks(content, file) if is_binary else (content, None)
    gltf = GltfFile(file, _parsed(text, file), own_buffer, len(content))
    _check_extensions(gltf)
    return gltf


def _check_extensions(gltf: GltfFile) -> None:
    for name in gltf.entries("extensionsRequired"):
        if not isinstance(name, str):
            raise gltf.damaged('"extensionsRequired" holds what is no text')
        if name not in _READ and not name.startswith(_OF_LOOKS):
            raise InputError(
                f"{gltf.file} requires the extension {json.dumps(name[:80])}, which is not read: "
                "export it without."
            )


def _chunks(content: bytes, file: Path) -> tuple[bytes, bytes | None]:
    """The JSON of a GLB file, and its binary buffer if it has one."""
    if len(content) < _HEADER.size or not content.startswith(b"glTF"):
        raise InputError(f'{file} is no GLB file: it does not begin with "glTF" and a header of 12 bytes.')
    _, version, length = _HEADER.unpack_from(content)
    if version != 2:
        raise InputError(f"{file} is glTF of version {version}, and version 2 is read: export it anew.")
    if length > len(content):
        raise InputError(
            f"{file} is cut off: it holds {len(content)} of {length} bytes; copy or export it anew."
        )
    chunks: dict[bytes, bytes] = {}
    start = _HEADER.size
    while start + _CHUNK.size <= length:
        size, kind = _CHUNK.unpack_from(content, start)
        start += _CHUNK.size
        if start + size > length:
            raise InputError(
                f"{file} is damaged: a chunk of {size} bytes ends behind the file; export it anew."
            )
        chunks.setdefault(kind, content[start : start + size])
        start += size
    if b"JSON" not in chunks:
        raise InputError(f"{file} is damaged: it has no chunk of JSON; export it anew.")
    return chunks[b"JSON"], chunks.get(b"BIN\0")


def _parsed(text: bytes, file: Path) -> dict[str, Any]:
    try:
        tree = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise InputError(f"{file} is damaged: its JSON cannot be read ({error}); export it anew.") from error
    if not isinstance(tree, dict) or "asset" not in tree:
        raise InputError(f'{file} is no glTF: its JSON has no "asset".')
    version = " ".join(
        str(tree["asset"].get("version", "2.0") if isinstance(tree["asset"], dict) else "")[:20].split()
    )
    if not version.startswith("2."):
        raise InputError(f'{file} is glTF of version "{version}", and version 2.0 is read: export it anew.')
    return tree


def _buffer(entry: Entry, size: int, number: int, gltf: GltfFile) -> bytes:
    uri, own, file = entry.get("uri"), gltf.own_buffer, gltf.file
    if uri is None:
        if number or own is None:
            raise InputError(f"{file} is damaged: its buffer {number} names no file, and has no bytes here.")
        content, named = own, "the file itself"
    elif not isinstance(uri, str):
        raise gltf.damaged(f'the "uri" of its buffer {number} is no text')
    elif uri.startswith(_DATA_URI):
        try:
            content, named = base64.b64decode(uri.partition(",")[2], validate=True), "a data URI"
        except (binascii.Error, ValueError) as error:
            raise InputError(f"{file} is damaged: its buffer {number} is no base64.") from error
    else:
        content, named = _file_beside(uri, file), f"the file {json.dumps(uri[:80])}"
    if len(content) < size:
        raise InputError(
            f"{file}: its buffer {number}, {named}, holds {len(content)} of {size} bytes; export it anew."
        )
    return content


def _file_beside(uri: str, file: Path) -> bytes:
    shown = " ".join(uri[:80].split())
    if "://" in uri:
        raise InputError(
            f'{file} names "{shown}", and nothing is fetched: export a .glb, which holds everything.'
        )
    folder = file.resolve().parent
    try:
        named = (folder / unquote(uri)).resolve()
        is_there = named.is_file()
    except (OSError, ValueError):  # too long a name, a NUL
        named, is_there = folder, False
    if not named.is_relative_to(folder):
        raise InputError(
            f'{file} names the file "{shown}", which lies outside its folder {file.parent}: '
            "put it beside the mesh, or export a .glb, which holds everything."
        )
    if not is_there:
        raise InputError(
            f'{file} names the file "{shown}", which does not exist in {file.parent}: '
            "copy it there, or export a .glb, which holds everything."
        )
    return named.read_bytes()


# -------------------------------------------------------------------------------------------------- accessors
# glTF accessors as arrays: strided, normalized, sparse, in plain or compressed buffer views.


_COMPONENTS = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
# Both hold the same; the bytes of the data say which version of the codec they need.
_MESHOPT = ("EXT_meshopt_compression", "KHR_meshopt_compression")
# A row of zeros is coded in so small a share of its bytes at least.
_MESHOPT_RATIO = 4096
# Accessors and primitives may name the same bytes any number of times: a bound for all that are read.
_MAX_ELEMENTS = 200_000_000


def attribute(gltf: GltfFile, index: object, width: int) -> NDArray[np.float64]:
    """Numbers [n, width]; normalized integers between -1 or 0 and 1.

    Raises:
        InputError: no such accessor, or one that does not fit its data or `width`.
    """
    entry = gltf.entry("accessors", index)
    values = _elements(gltf, entry)
    if values.shape[1] < width:
        raise gltf.damaged(
            f'an accessor of type "{entry.get("type")}" stands where {width} numbers are needed'
        )
    return normalized(values[:, :width], entry)


def normalized(values: NDArray[Any], entry: Entry) -> NDArray[np.float64]:
    """Values of an accessor's data as numbers, divided by the largest of their integers where it says so."""
    numbers = values.astype(np.float64)
    if entry.get("normalized") is True and values.dtype.kind in "iu":
        numbers = np.maximum(numbers / np.iinfo(values.dtype).max, -1)
    return numbers


def indices(gltf: GltfFile, index: object) -> NDArray[np.int64]:
    """Indices [n]; raises InputError as `attribute` does."""
    # Some writers state rows of three, which the specification does not allow.
    return _elements(gltf, gltf.entry("accessors", index)).ravel().astype(np.int64)


def view_bytes(gltf: GltfFile, index: object) -> tuple[bytes, int]:
    """The bytes of a buffer view, decompressed, and its stride or 0."""
    view = gltf.entry("bufferViews", index)
    for name in _MESHOPT:
        if name in gltf.dictionary(view, "extensions"):
            return _decompressed(gltf, gltf.dictionary(view, "extensions", name), name)
    return _slice(gltf, view), gltf.integer(view, "byteStride", 0)


def _slice(gltf: GltfFile, holder: Entry) -> bytes:
    """The part of a buffer that `holder` names."""
    content = gltf.buffer(gltf.integer(holder, "buffer"))
    start, length = gltf.integer(holder, "byteOffset", 0), gltf.integer(holder, "byteLength")
    if start + length > len(content):
        raise gltf.damaged(f"a view ends at byte {start + length} of a buffer of {len(content)}")
    return content[start : start + length]


def _decompressed(gltf: GltfFile, entry: Entry, name: str) -> tuple[bytes, int]:
    try:
        import meshopt
    except ImportError as error:
        raise MissingDependencyError(
            f"{gltf.file} is compressed by {name}: install its decoder, {installing('meshopt')}, or export "
            "the file without compression."
        ) from error
    content, stride = _slice(gltf, entry), gltf.integer(entry, "byteStride")
    count = gltf.integer(entry, "count")
    if count * stride > _MESHOPT_RATIO * len(content):
        raise gltf.damaged(f"{len(content)} bytes of {name} cannot hold {count} rows")
    try:
        rows = meshopt.decode_gltf_buffer(content, count, stride, entry.get("mode"), entry.get("filter"))
    except (ValueError, TypeError, RuntimeError) as error:
        raise gltf.damaged(f"its data of {name} cannot be decoded") from error
    return rows.tobytes(), stride


def _elements(gltf: GltfFile, entry: Entry) -> NDArray[Any]:
    """The elements [n, width] of an accessor, as they are stored."""
    count, kind = gltf.integer(entry, "count"), entry.get("type")
    if not isinstance(kind, str) or kind not in _WIDTHS:
        raise gltf.damaged(f'an accessor is of type "{repr(kind)[:20]}"')
    width = _WIDTHS[kind]
    sparse = gltf.dictionary(entry, "sparse")
    if "bufferView" in entry:
        values = _strided(gltf, entry, entry, count, width)
    elif sparse and count <= gltf.size:
        values = np.zeros((count, width), _component(gltf, entry))
    else:
        raise gltf.damaged(f"an accessor states {count} elements, and has no data for them")
    gltf.elements_read += count
    if gltf.elements_read > _MAX_ELEMENTS:
        raise gltf.damaged(f"it reads more than {_MAX_ELEMENTS} elements, or the same ones again and again")
    if sparse:
        changed = gltf.integer(sparse, "count")
        if changed > count:
            raise gltf.damaged(f"a sparse accessor changes {changed} of {count} elements")
        where = gltf.dictionary(sparse, "indices")
        at = _strided(gltf, where, where, changed, 1).ravel().astype(np.int64)
        if (at >= count).any() or (at < 0).any():
            raise gltf.damaged(f"a sparse accessor changes element {at.max()} of {count}")
        values = values.copy()
        values[at] = _strided(gltf, gltf.dictionary(sparse, "values"), entry, changed, width)
    return values


def _component(gltf: GltfFile, holder: Entry) -> np.dtype[np.generic]:
    code = holder.get("componentType")
    if not isinstance(code, int) or code not in _COMPONENTS:
        raise gltf.damaged(f'"componentType" is {repr(code)[:20]}')
    return np.dtype(_COMPONENTS[code])


def _strided(gltf: GltfFile, place: Entry, kind: Entry, count: int, width: int) -> NDArray[Any]:
    """`count` elements where `place` says, of the component type of `kind`."""
    data, stride = view_bytes(gltf, place.get("bufferView"))
    component, offset = _component(gltf, kind), gltf.integer(place, "byteOffset", 0)
    size = component.itemsize * width
    stride = stride or size
    if stride < size or (count and offset + stride * (count - 1) + size > len(data)):
        raise gltf.damaged(f"{count} elements of {size} bytes do not fit into a view of {len(data)} bytes")
    if count == 0:
        return np.zeros((0, width), component)
    return np.ndarray((count, width), component, data, offset, (stride, component.itemsize))


# ------------------------------------------------------------------------------------------------------ Draco
# Primitives of glTF that Draco compresses.


def decoded_primitive(
    gltf: GltfFile, extension: Entry, accessors: Entry, wanted: Mapping[str, int]
) -> tuple[dict[str, NDArray[np.float64]], NDArray[np.int64]]:
    """The attributes `wanted` (names and widths) of a primitive, and its triangles.

    Raises:
        InputError: the data cannot be decoded, or lack one of the attributes.
    """
    import DracoPy

    content, _ = view_bytes(gltf, extension.get("bufferView"))
    try:
        mesh = DracoPy.decode(content)
    except (ValueError, RuntimeError, MemoryError, DracoPy.FileTypeException) as error:
        raise gltf.damaged("its Draco data cannot be decoded") from error
    numbers = gltf.dictionary(extension, "attributes")
    arrays = {}
    for name, width in wanted.items():
        if name not in numbers:
            arrays[name] = attribute(gltf, accessors[name], width)
            continue
        found = mesh.get_attribute_by_unique_id(gltf.integer(numbers, name))
        values = np.asarray(found["data"]) if found else np.zeros((0, 0))
        if values.ndim != 2 or values.shape[1] < width:
            raise gltf.damaged(f'its Draco data hold no "{name}" of {width} numbers')
        arrays[name] = normalized(values[:, :width], gltf.entry("accessors", accessors[name]))
    triangles = np.asarray(mesh.faces, dtype=np.int64).reshape(-1, 3)
    return arrays, triangles
