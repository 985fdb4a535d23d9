"""Feeds mutilated meshes to the reader: each must be a mesh or one sentence, in 2 s and less than 1 GB.

    python -m tools.fuzz_meshes [--seconds 60 | --count 2000] [--seed 0] [--only ply] [--faults FOLDER]

Targets: obj, ply-ascii, ply-binary, gltf, glb and draco.
"""

from __future__ import annotations

import base64
import json
import random
import struct
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import DracoPy
import meshopt
import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.mesh.reading import read_parts
from tools.fuzzing import BYTES, TEXT, Mutation, Target, change_json, main

Arrays = tuple[NDArray[Any], ...]


def _grid(side: int) -> Arrays:
    """Positions, normals, uv and quadrilaterals of a square of cloth."""
    u, v = (axis.ravel() / side for axis in np.meshgrid(np.arange(side + 1), np.arange(side + 1)))
    positions = np.stack([u, v, 0.1 * np.sin(6 * u)], axis=1).astype("<f4")
    first = (np.arange(side)[:, None] * (side + 1) + np.arange(side)).ravel()
    quads = first[:, None] + [0, 1, side + 2, side + 1]
    normals = np.tile(np.array([0, 0, 1], "<f4"), (len(u), 1))
    return positions, normals, np.stack([u, v], axis=1).astype("<f4"), quads


def obj_text(side: int = 4) -> bytes:
    """An OBJ file of quadrilaterals, a concave face, and two parts."""
    positions, normals, uv, quads = _grid(side)
    lines = ["mtllib none.mtl", "o cloth", "usemtl red"]
    for kind, rows in (("v", positions), ("vt", uv), ("vn", normals)):
        lines += [f"{kind} " + " ".join(f"{x:.6g}" for x in row) for row in rows.tolist()]
    lines += ["f " + " ".join(f"{a + 1}/{a + 1}/{a + 1}" for a in quad) for quad in quads.tolist()]
    lines += [
        "g part two",
        "usemtl blue",
        "f -1 -2 \\",
        " -7",
        "f 1/1 5/5 15/15 7/7 11/11",
        "f 1//1 2//2 7//7",
    ]
    return ("\n".join(lines) + "\n").encode()


def ply_content(binary: bool, of_corners: bool, side: int = 4) -> bytes:
    """A PLY file with uv of vertices or of corners."""
    positions, normals, uv, quads = _grid(side)
    rows = np.concatenate([positions, normals, uv], axis=1).astype("<f4")
    lines = ["ply", f"format {'binary_little_endian' if binary else 'ascii'} 1.0", "comment a test"]
    names = ("x", "y", "z", "nx", "ny", "nz", "s", "t")
    lines += [f"element vertex {len(rows)}", *(f"property float {name}" for name in names)]
    lines += [f"element face {len(quads)}", "property list uchar int vertex_indices"]
    lines += ["property list uchar float texcoord"] if of_corners else []
    if of_corners:
        lines = [line for line in lines if line[-2:] not in (" s", " t")]
        rows = rows[:, :6]
    content = ("\n".join([*lines, "end_header"]) + "\n").encode()
    if binary:
        content += rows.tobytes()
    else:
        content += b"".join((" ".join(map(str, row)) + "\n").encode() for row in rows.tolist())
    for quad in quads.tolist():
        corners = uv[quad].ravel().tolist() if of_corners else []
        if binary:
            content += struct.pack("<B4i", 4, *quad)
            content += struct.pack("<B8f", 8, *corners) if corners else b""
        else:
            content += " ".join(map(str, [4, *quad, *([8, *corners] if corners else [])])).encode() + b"\n"
    return content


def gltf_parts(compression: str = "", side: int = 4) -> tuple[dict[str, Any], bytes]:
    """The JSON and the buffer of a glTF file, its geometry plain, or compressed by "draco" or "meshopt"."""
    positions, normals, uv, quads = _grid(side)
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]).astype("<u2")
    arrays = [positions, normals, uv, triangles.ravel()]
    pieces = [np.ascontiguousarray(array).tobytes() for array in arrays]
    pieces += [np.array([0, 3], "<u2").tobytes(), positions[[1, 4]].tobytes()]
    if compression == "meshopt":
        pieces.append(meshopt.encode_gltf_buffer(positions, "ATTRIBUTES"))
    if compression == "draco":
        coordinates = {"tex_coord": uv.astype(float), "normals": normals.astype(float)}
        pieces.append(DracoPy.encode(positions, triangles.astype(np.uint32), **coordinates))
    lengths = [len(piece) for piece in pieces]
    pieces = [piece + bytes(-len(piece) % 4) for piece in pieces]
    ends = np.cumsum([0, *map(len, pieces)]).tolist()
    views: list[dict[str, Any]] = [
        {"buffer": 0, "byteOffset": start, "byteLength": length}
        for start, length in zip(ends, lengths, strict=False)
    ]
    kinds = (5126, "VEC3"), (5126, "VEC3"), (5126, "VEC2"), (5123, "SCALAR")
    accessors: list[dict[str, Any]] = [
        {"bufferView": view, "componentType": component, "type": kind, "count": len(array)}
        for view, ((component, kind), array) in enumerate(zip(kinds, arrays, strict=True))
    ]
    accessors.append({**accessors[0], "sparse": {
        "count": 2, "indices": {"bufferView": 4, "componentType": 5123}, "values": {"bufferView": 5},
    }})  # fmt: skip
    names = {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}
    primitives: list[dict[str, Any]] = [
        {"attributes": names, "indices": 3, "material": 0},
        {"attributes": {**names, "POSITION": 4}, "mode": 5},
    ]
    if compression == "meshopt":
        entry = {**views[-1], "byteStride": 12, "count": len(positions), "mode": "ATTRIBUTES"}
        views[0]["extensions"] = {"EXT_meshopt_compression": entry}
    if compression == "draco":
        found = {a["attribute_type"]: a["unique_id"] for a in DracoPy.decode(pieces[-1]).attributes}
        numbers = {"POSITION": found[0], "NORMAL": found[1], "TEXCOORD_0": found[3]}
        entry = {"bufferView": len(views) - 1, "attributes": numbers}
        primitives[0]["extensions"] = {"KHR_draco_mesh_compression": entry}
    transform = {"offset": [0.1, 0.2], "rotation": 0.5, "scale": [2, 3], "texCoord": 0}
    texture = {"index": 0, "extensions": {"KHR_texture_transform": transform}}
    tree = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [
            {"name": "cloth", "mesh": 0, "scale": [1, 2, 1], "children": [1]},
            {"mesh": 0, "translation": [1, 0, 0], "rotation": [0, 0, 0.6, 0.8]},
        ],
        "meshes": [{"name": "square", "primitives": primitives}],
        "materials": [{"name": "red", "pbrMetallicRoughness": {"baseColorTexture": texture}}],
        "accessors": accessors, "bufferViews": views, "buffers": [{"byteLength": ends[-1]}],
    }  # fmt: skip
    return tree, b"".join(pieces)


def gltf_text(compression: str = "") -> bytes:
    """A .gltf file whose buffer is a data URI."""
    tree, body = gltf_parts(compression)
    tree["buffers"][0]["uri"] = "data:;base64," + base64.b64encode(body).decode()
    return json.dumps(tree).encode()


def glb_content(tree: bytes, body: bytes) -> bytes:
    """A .glb file of its JSON and its buffer."""
    tree += b" " * (-len(tree) % 4)
    chunks = struct.pack("<I4s", len(tree), b"JSON") + tree + struct.pack("<I4s", len(body), b"BIN\0") + body
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def within_glb(change: Mutation, of_body: bool) -> Mutation:
    """A mutation of a GLB file's JSON or buffer, its chunks kept whole; other content is kept."""

    def mutate(chance: random.Random, content: bytes) -> bytes:
        size = int.from_bytes(content[12:16], "little")
        tree, body = content[20 : 20 + size], content[28 + size :]
        if content[:4] != b"glTF" or len(tree) < size or not body:
            return content
        if of_body:
            return glb_content(tree, change(chance, body)[: len(body)].ljust(len(body), b"\0"))
        return glb_content(change(chance, tree), body)

    return mutate


def reader(suffix: str) -> Callable[[bytes], None]:
    """Reads a file of that suffix from a temporary folder."""
    folder = tempfile.TemporaryDirectory()

    def read(content: bytes) -> None:
        file = Path(folder.name) / f"mesh{suffix}"
        file.write_bytes(content)
        try:
            parts = read_parts(file)
        except InputError as error:
            if error.__cause__ is not None and "Error: " in str(error):
                raise RuntimeError("a kind of damage that no reader foresees") from error
            raise
        for part in parts:
            mesh = part.mesh
            assert len(mesh.triangles) > 0, "a part without triangles"
            assert 0 <= mesh.triangles.min() <= mesh.triangles.max() < len(mesh.positions), "indices"
            assert len(mesh.uv) in (0, len(mesh.positions)), "uv partly there"
            assert all(np.isfinite(rows).all() for rows in (mesh.positions, mesh.normals, mesh.uv)), "finite"
            assert np.allclose(np.linalg.norm(mesh.normals, axis=1), 1), "unit normals"

    return read


def targets() -> list[Target]:
    """A target for each format."""
    glb = [*BYTES, *(within_glb(change_json, of_body=False),) * 4, *(within_glb(c, True) for c in BYTES)]
    draco = [*(within_glb(change, True) for change in BYTES * 2), within_glb(change_json, of_body=False)]
    gltf = [change_json] * 6 + list(TEXT)
    plain, packed, compressed = (
        glb_content(json.dumps(tree).encode(), body)
        for tree, body in (gltf_parts(), gltf_parts("meshopt"), gltf_parts("draco", side=8))
    )
    return [
        Target("obj", [obj_text()], TEXT, reader(".obj")),
        Target("ply-ascii", [ply_content(False, c) for c in (False, True)], TEXT, reader(".ply")),
        Target("ply-binary", [ply_content(True, c) for c in (False, True)], [*BYTES, *TEXT], reader(".ply")),
        Target("gltf", [gltf_text(), gltf_text("meshopt")], gltf, reader(".gltf")),
        Target("glb", [plain, packed], glb, reader(".glb")),
        Target("draco", [compressed], draco, reader(".glb")),
    ]


if __name__ == "__main__":
    sys.exit(main("fuzz_meshes", targets))
