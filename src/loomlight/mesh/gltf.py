"""glTF meshes: primitives of triangles, placed by their nodes, with the uv that their base colour takes.

At rest morph targets have the file's default weights, and joints stand where their nodes do; at a time
animations move both. Their other uv are attributes: "uv1", "uv2" … in the order of their numbers.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
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
from loomlight.mesh.gltf_data import (
    Entry,
    GltfFile,
    attribute,
    decoded_primitive,
    indices,
    is_index,
    load_gltf,
)

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
    sampler = samplers[number] if is_index(number) and number < len(samplers) else None
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
