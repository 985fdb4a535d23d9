"""Mesh files written: OBJ, glTF and GLB, with names of parts and materials, normals, and uv in metres."""

from __future__ import annotations

import base64
import json
import re
import struct
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.files import replacing
from loomlight.core.outputs import check_output
from loomlight.mesh.cloth_mesh import MeshPart

WRITTEN_MESHES = (".obj", ".glb", ".gltf")
# Of glTF: single precision and 32-bit indices; buffers of vertices and of indices.
_FLOAT, _UINT = 5126, 5125
_VERTICES, _INDICES = 34962, 34963


def write_mesh(path: Path, parts: Sequence[MeshPart]) -> None:
    """Writes parts, in metres, whole or not at all.

    Parts are named by the pieces that were cut for them, else by their own names. glTF keeps further uv too.

    Raises:
        InputError: another suffix, or a folder that does not exist or cannot be written.
    """
    check_output(path, WRITTEN_MESHES)
    suffix = path.suffix.lower()
    with replacing(path) as temporary:
        if suffix == ".obj":
            temporary.write_text(_obj(parts), encoding="utf-8")
        else:
            document, binary = _gltf(parts)
            temporary.write_bytes(_glb(document, binary) if suffix == ".glb" else _embedded(document, binary))


def _name(part: MeshPart) -> str:
    return part.piece or part.name


def _obj(parts: Sequence[MeshPart]) -> str:
    lines = ["# uv in metres"]
    vertices = texture = 0
    for number, part in enumerate(parts, 1):
        mesh = part.mesh
        lines.append(f"o {_word(_name(part)) or f'part {number}'}")
        if part.material:
            lines.append(f"usemtl {_word(part.material)}")
        lines += _rows("v {:.9g} {:.9g} {:.9g}", mesh.positions)
        # v runs upwards in the file.
        lines += _rows("vt {:.9g} {:.9g}", mesh.uv * [1, -1] + [0, 1])
        lines += _rows("vn {:.6g} {:.6g} {:.6g}", mesh.normals)
        corners = mesh.triangles + 1
        if len(mesh.uv):
            rows = np.stack([corners + vertices, corners + texture, corners + vertices], axis=2)
            lines += _rows("f {}/{}/{} {}/{}/{} {}/{}/{}", rows.reshape(-1, 9))
        else:
            lines += _rows("f {}//{} {}//{} {}//{}", np.repeat(corners + vertices, 2, axis=1))
        vertices, texture = vertices + len(mesh.positions), texture + len(mesh.uv)
    return "\n".join([*lines, ""])


def _rows(form: str, rows: NDArray[Any]) -> list[str]:
    return [form.format(*row) for row in rows.tolist()]


def _word(text: str) -> str:
    """A name on one line."""
    return re.sub(r"[\s\\]+", " ", text).strip()


def _gltf(parts: Sequence[MeshPart]) -> tuple[dict[str, Any], bytes]:
    """The document without its buffer, and the buffer."""
    chunks: list[bytes] = []
    views: list[dict[str, Any]] = []
    accessors: list[dict[str, Any]] = []

    def add(rows: NDArray[Any], kind: str, component: int, target: int) -> int:
        content = rows.tobytes()
        offset = sum(map(len, chunks))
        views.append({"buffer": 0, "byteOffset": offset, "byteLength": len(content), "target": target})
        accessor = {
            "bufferView": len(views) - 1,
            "componentType": component,
            "count": len(rows),
            "type": kind,
        }
        if kind == "VEC3":  # the format asks for these of positions
            accessor |= {"min": rows.min(axis=0).tolist(), "max": rows.max(axis=0).tolist()}
        accessors.append(accessor)
        chunks.append(content)
        return len(accessors) - 1

    def vertices(rows: NDArray[Any], kind: str) -> int:
        return add(np.ascontiguousarray(rows, np.float32), kind, _FLOAT, _VERTICES)

    materials = list(dict.fromkeys(part.material for part in parts if part.material))
    meshes, nodes = [], []
    for number, part in enumerate(parts, 1):
        mesh, name = part.mesh, _name(part) or f"part {number}"
        attributes = {
            "POSITION": vertices(mesh.positions, "VEC3"),
            "NORMAL": vertices(mesh.normals, "VEC3"),
        }
        # Further sets of uv follow the first without a gap.
        sets = [mesh.uv] if len(mesh.uv) else []
        while (
            sets and (further := mesh.attributes.get(f"uv{len(sets)}")) is not None and further.shape[1] == 2
        ):
            sets.append(np.nan_to_num(further))
        for at, uv in enumerate(sets):
            attributes[f"TEXCOORD_{at}"] = vertices(uv, "VEC2")
        indices = add(mesh.triangles.astype(np.uint32).ravel(), "SCALAR", _UINT, _INDICES)
        primitive: dict[str, Any] = {"attributes": attributes, "indices": indices}
        if part.material:
            primitive["material"] = materials.index(part.material)
        meshes.append({"name": name, "primitives": [primitive]})
        nodes.append({"name": name, "mesh": number - 1})
    document: dict[str, Any] = {
        "asset": {"version": "2.0", "generator": "loomlight; uv in metres"},
        "scene": 0,
        "scenes": [{"nodes": list(range(len(nodes)))}],
        "nodes": nodes,
        "meshes": meshes,
        "accessors": accessors,
        "bufferViews": views,
    }
    if materials:
        document["materials"] = [{"name": name} for name in materials]
    return document, b"".join(chunks)


def _embedded(document: dict[str, Any], binary: bytes) -> bytes:
    uri = "data:application/octet-stream;base64," + base64.b64encode(binary).decode()
    return json.dumps({**document, "buffers": [{"byteLength": len(binary), "uri": uri}]}).encode()


def _glb(document: dict[str, Any], binary: bytes) -> bytes:
    text = json.dumps({**document, "buffers": [{"byteLength": len(binary)}]}).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    size = 12 + 8 + len(text) + 8 + len(binary)
    return b"".join(
        [
            struct.pack("<4sII", b"glTF", 2, size),
            struct.pack("<I4s", len(text), b"JSON"),
            text,
            struct.pack("<I4s", len(binary), b"BIN\0"),
            binary,
        ]
    )
