"""glTF meshes: primitives of triangles, placed by their nodes, with the uv that their base colour takes."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.mesh.cloth_mesh import MAX_PARTS, ClothMesh, MeshPart, check_indices
from loomlight.mesh.draco import decoded_primitive
from loomlight.mesh.gltf_accessors import attribute, indices
from loomlight.mesh.gltf_file import Entry, GltfFile, load_gltf
from loomlight.mesh.polygons import strip_triangles

# Modes of primitives; those before are points and lines.
_TRIANGLES, _STRIP, _FAN = 4, 5, 6
# Nodes and primitives may show the same arrays any number of times: a bound for all triangles.
_MAX_TRIANGLES = 10_000_000
_DRACO = "KHR_draco_mesh_compression"
_INSTANCING = "EXT_mesh_gpu_instancing"
_TRANSFORM = "KHR_texture_transform"


def read_gltf(file: Path) -> list[MeshPart]:
    """A part for each primitive of each node, named by the node or else its mesh, where the scene places it.

    Raises:
        InputError: a damaged file, or one that shows no triangles.
    """
    gltf = load_gltf(file)
    parts: list[MeshPart] = []
    known: dict[int, list[MeshPart]] = {}
    total = 0
    for node, matrix in _placements(gltf):
        number = gltf.integer(node, "mesh")
        mesh = gltf.entry("meshes", number)
        if number not in known:
            known[number] = _primitives(gltf, mesh)
        total += sum(len(part.mesh.triangles) for part in known[number])
        _check_total(total, file)
        name = _text(node) or _text(mesh)
        if len(parts) + len(known[number]) > MAX_PARTS:
            raise InputError(f"{file} shows more than {MAX_PARTS} parts, copies included: join some.")
        parts += [MeshPart(name, part.material, _moved(part.mesh, matrix)) for part in known[number]]
    if not parts:
        reason = "its meshes are points or lines" if known else "its scene shows no mesh"
        raise InputError(f"{file} holds no triangles: {reason}.")
    return parts


def _check_total(total: int, file: Path) -> None:
    if total > _MAX_TRIANGLES:
        raise InputError(f"{file} shows more than {_MAX_TRIANGLES} triangles, copies included: export fewer.")


def _text(entry: Entry) -> str:
    name = entry.get("name")
    return " ".join(name.split()) if isinstance(name, str) else ""


def _placements(gltf: GltfFile) -> Iterator[tuple[Entry, NDArray[np.float64]]]:
    """Each node of the scene that has a mesh, and its matrix; a node again for each of its instances."""
    seen: set[int] = set()
    waiting = [(number, np.eye(4)) for number in reversed(_roots(gltf))]
    while waiting:
        number, above = waiting.pop()
        node = gltf.entry("nodes", number)
        if number in seen:
            raise gltf.damaged(f"node {number} is its own ancestor, or has two parents")
        seen.add(number)
        matrix = above @ _own_matrix(gltf, node)
        if "mesh" in node:
            for instance in _instances(gltf, node):
                yield node, matrix @ instance
        waiting += [(child, matrix) for child in reversed(_children(gltf, node))]


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


def _primitives(gltf: GltfFile, mesh: Entry) -> list[MeshPart]:
    """The primitives of triangles of a mesh, not placed yet."""
    primitives = mesh.get("primitives", [])
    if not isinstance(primitives, list) or not all(isinstance(entry, dict) for entry in primitives):
        raise gltf.damaged('the "primitives" of a mesh are no list of objects')
    parts = []
    total = 0
    for primitive in primitives:
        if gltf.integer(primitive, "mode", _TRIANGLES) < _TRIANGLES:
            continue
        material = gltf.entry("materials", primitive["material"]) if "material" in primitive else {}
        made = _geometry(gltf, primitive, material)
        total += len(made.triangles)
        _check_total(total, gltf.file)
        parts.append(MeshPart("", _text(material), made))
    return parts


def _geometry(gltf: GltfFile, primitive: Entry, material: Entry) -> ClothMesh:
    names = gltf.dictionary(primitive, "attributes")
    if "POSITION" not in names:
        raise gltf.damaged("a primitive has no positions")
    uv_name, transform = _uv_of_material(gltf, material, names)
    widths = {"POSITION": 3, "NORMAL": 3, uv_name: 2}
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
    )


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
        name = min((key for key in names if key.startswith("TEXCOORD_")), default=name)
    u, v = _vector(gltf, change, "scale", [1, 1])
    angle = change.get("rotation", 0)
    if isinstance(angle, bool) or not isinstance(angle, int | float) or not abs(angle) < 1e6:
        raise gltf.damaged(f'the "rotation" of a texture is {repr(angle)[:20]}')
    # Counter-clockwise in uv, whose v runs down.
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    offset = _vector(gltf, change, "offset", [0, 0])
    return name, np.concatenate([turn * [u, v], offset[:, None]], axis=1)


def _moved(mesh: ClothMesh, matrix: NDArray[np.float64]) -> ClothMesh:
    """The mesh in the scene; what the matrix mirrors keeps its front."""
    linear = matrix[:3, :3]
    determinant = np.linalg.det(linear)
    normals = mesh.normals @ np.linalg.inv(linear) if abs(determinant) > 1e-30 else np.zeros((0, 3))
    triangles = mesh.triangles[:, ::-1] if determinant < 0 else mesh.triangles
    return ClothMesh(mesh.positions @ linear.T + matrix[:3, 3], normals, mesh.uv, triangles, mesh.name)
