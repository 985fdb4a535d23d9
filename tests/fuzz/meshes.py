"""Feeds mutilated meshes to the reader: each must be a mesh or one sentence, in 2 s and less than 1 GB.

    python -m tests.fuzz.meshes [--seconds 60 | --count 2000] [--seed 0] [--only ply] [--faults FOLDER]

Targets: obj, ply-ascii, ply-binary, gltf, gltf-motion, glb, draco, usda, usdc and usdz.
"""

from __future__ import annotations

import base64
import json
import random
import struct
import subprocess
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
from loomlight.mesh.reading import frame_times, read_cameras, read_parts
from tests.fuzz.fuzzing import BYTES, TEXT, Mutation, Target, change_json, main

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


def gltf_motion_text() -> bytes:
    """A .gltf file of a skinned square with a morph target, animations of each interpolation, and cameras."""
    tree, body = gltf_parts(side=2)
    accessors, views = tree["accessors"], tree["bufferViews"]

    def add(array: NDArray[Any], kind: str, component: int = 5126) -> int:
        nonlocal body
        body += bytes(-len(body) % 4)
        views.append({"buffer": 0, "byteOffset": len(body), "byteLength": array.nbytes})
        body += array.tobytes()
        entry = {"bufferView": len(views) - 1, "componentType": component, "type": kind, "count": len(array)}
        accessors.append(entry)
        return len(accessors) - 1

    keys = add(np.array([0.5, 1, 2], "<f4"), "SCALAR")
    count = accessors[0]["count"]
    primitive = tree["meshes"][0]["primitives"][0]
    primitive["targets"] = [{"POSITION": add(np.ones((count, 3), "<f4"), "VEC3")}]
    primitive["attributes"] |= {
        "JOINTS_0": add(np.tile(np.array([0, 1, 0, 0], "|u1"), (count, 1)), "VEC4", 5121),
        "WEIGHTS_0": add(np.tile(np.array([0.5, 0.5, 0, 0], "<f4"), (count, 1)), "VEC4"),
        "TEXCOORD_1": add(np.ones((count, 2), "<f4"), "VEC2"),
    }
    tree["meshes"][0]["primitives"] = [primitive]
    tree["skins"] = [
        {
            "joints": [2, 3],
            "inverseBindMatrices": add(np.tile(np.eye(4, dtype="<f4").ravel(), (2, 1)), "MAT4"),
        }
    ]
    tree["nodes"] = [
        {"mesh": 0, "skin": 0}, {"mesh": 0, "children": [4]}, {}, {}, {"camera": 0}, {"camera": 1},
    ]  # fmt: skip
    tree["scenes"] = [{"nodes": [0, 1, 2, 3, 5]}]
    tree["cameras"] = [
        {"type": "perspective", "perspective": {"yfov": 0.7, "aspectRatio": 1.5, "znear": 0.1}},
        {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 0, "zfar": 1}},
    ]
    turns = add(np.tile(np.array([0, 0, 0.6, 0.8], "<f4"), (3, 1)), "VEC4")
    samplers = [
        {"input": keys, "output": add(np.ones((9, 3), "<f4"), "VEC3"), "interpolation": "CUBICSPLINE"},
        {"input": keys, "output": turns},
        {"input": keys, "output": add(np.ones((3, 3), "<f4"), "VEC3"), "interpolation": "STEP"},
        {"input": keys, "output": add(np.ones(3, "<f4"), "SCALAR")},
    ]
    targets = [(2, "translation"), (3, "rotation"), (1, "scale"), (1, "weights")]
    tree["animations"] = [
        {
            "samplers": samplers,
            "channels": [
                {"sampler": sampler, "target": {"node": node, "path": path}}
                for sampler, (node, path) in enumerate(targets)
            ],
        }
    ]
    tree["buffers"] = [{"uri": "data:;base64," + base64.b64encode(body).decode(), "byteLength": len(body)}]
    return json.dumps(tree).encode()


# Of everything that is read of USD: subsets, kinds of primvars, instances, a skeleton, samples and a camera.
_USDA = """#usda 1.0
(
    metersPerUnit = 0.01
    upAxis = "Z"
    startTimeCode = 1
    endTimeCode = 3
    timeCodesPerSecond = 24
    framesPerSecond = 24
)
def Xform "set" (kind = "group") {
    double3 xformOp:translate.timeSamples = { 1: (0, 0, 0), 2: (1, 2, 3), 3: (4, 5, 6) }
    float3 xformOp:scale = (1, -2, 1)
    uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:scale"]
    def Mesh "cloth" (prepend apiSchemas = ["MaterialBindingAPI"]) {
        uniform token orientation = "leftHanded"
        uniform token subdivisionScheme = "none"
        int[] faceVertexCounts = [4, 4, 5]
        int[] faceVertexIndices = [0, 1, 4, 3, 1, 2, 5, 4, 3, 4, 5, 7, 6]
        int[] holeIndices = [2]
        point3f[] points.timeSamples = {
            1: [(0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 1, 0), (1, 1, 0), (2, 1, 0), (0, 2, 0), (1, 2, 0)],
            3: [(0, 0, 1), (1, 0, 1), (2, 0, 1), (0, 1, 1), (1, 1, 1), (2, 1, 1), (0, 2, 1), (1, 2, 1)],
        }
        normal3f[] normals = [(0, 0, 1), (0, 0, 1), (0, 1, 1)] (interpolation = "uniform")
        texCoord2f[] primvars:st = [(0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (2, 1), (0, 2)] (interpolation = "faceVarying")
        int[] primvars:st:indices = [0, 1, 4, 3, 1, 2, 5, 4, 3, 4, 5, 6, 6]
        float2[] primvars:flow = [(0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (2, 1), (0, 2), (1, 2)] (interpolation = "vertex")
        rel material:binding = </looks/wool>
        def GeomSubset "cuff" {
            uniform token elementType = "face"
            uniform token familyName = "materialBind"
            int[] indices = [1]
        }
    }
    def PointInstancer "buttons" {
        rel prototypes = [</set/buttons/kind>]
        int[] protoIndices = [0, 0, 0]
        point3f[] positions = [(0, 0, 0), (1, 0, 0), (2, 0, 0)]
        quath[] orientations = [(1, 0, 0, 0), (0.7, 0, 0, 0.7), (1, 0, 0, 0)]
        float3[] scales = [(1, 1, 1), (2, 2, 2), (1, 1, 1)]
        int64[] invisibleIds = [2]
        def Mesh "kind" {
            int[] faceVertexCounts = [3]
            int[] faceVertexIndices = [0, 1, 2]
            point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0)]
        }
    }
    def Xform "copy" (instanceable = true; references = </set/buttons>) {
    }
}
def Mesh "ball" {
    uniform token subdivisionScheme = "catmullClark"
    int[] faceVertexCounts = [4, 4, 4, 4, 4, 4]
    int[] faceVertexIndices = [0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5]
    point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1), (1, 1, 1)]
    texCoord2f[] primvars:UVMap = [(0, 0), (1, 0), (0, 1), (1, 1), (0, 0), (1, 0), (0, 1), (1, 1)] (interpolation = "varying")
    int[] creaseIndices = [4, 5, 7, 6]
    int[] creaseLengths = [4]
    float[] creaseSharpnesses = [1.5]
}
def SkelRoot "body" {
    def Mesh "sleeve" (prepend apiSchemas = ["SkelBindingAPI"]) {
        int[] faceVertexCounts = [4]
        int[] faceVertexIndices = [0, 1, 2, 3]
        point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
        rel skel:skeleton = </body/bones>
        matrix4d primvars:skel:geomBindTransform = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1))
        int[] primvars:skel:jointIndices = [0, 1, 0, 1, 0, 1, 0, 1] (elementSize = 2; interpolation = "vertex")
        float[] primvars:skel:jointWeights = [1, 0, 1, 0, 0.5, 0.5, 0, 1] (elementSize = 2; interpolation = "vertex")
        uniform token[] skel:blendShapes = ["wind"]
        rel skel:blendShapeTargets = </body/sleeve/wind>
        def BlendShape "wind" {
            uniform vector3f[] offsets = [(0, 0, 2)]
            uniform int[] pointIndices = [1]
        }
    }
    def Skeleton "bones" (prepend apiSchemas = ["SkelBindingAPI"]) {
        uniform token[] joints = ["hip", "hip/knee"]
        uniform matrix4d[] bindTransforms = [((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1)), ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 1, 0, 1))]
        uniform matrix4d[] restTransforms = [((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1)), ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 1, 0, 1))]
        rel skel:animationSource = </body/motion>
    }
    def SkelAnimation "motion" {
        uniform token[] joints = ["hip", "hip/knee"]
        float3[] translations = [(0, 0, 0), (0, 1, 0)]
        quatf[] rotations.timeSamples = { 1: [(1, 0, 0, 0), (1, 0, 0, 0)], 3: [(1, 0, 0, 0), (0.7, 0, 0, 0.7)] }
        half3[] scales = [(1, 1, 1), (1, 1, 1)]
        uniform token[] blendShapes = ["wind"]
        float[] blendShapeWeights.timeSamples = { 1: [0], 3: [1] }
    }
}
def Camera "front" {
    float focalLength = 35
    float horizontalAperture = 36
    float verticalAperture = 24
    double3 xformOp:translate = (0, -5, 1)
    uniform token[] xformOpOrder = ["xformOp:translate"]
}
def Scope "looks" {
    def Material "wool" {
    }
}
"""  # noqa: E501
# In a process of its own: the threads of usd-core do not live on in the forked ones that read.
_CONVERT = """
import sys
from pathlib import Path
from pxr import Sdf, UsdUtils

folder = Path(sys.argv[1])
Sdf.Layer.FindOrOpen(str(folder / "a.usda")).Export(str(folder / "a.usdc"))
assert UsdUtils.CreateNewUsdzPackage(str(folder / "a.usdc"), str(folder / "a.usdz"))
"""


def usd_contents() -> dict[str, bytes]:
    """One stage as each kind of file, by its suffix."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "a.usda").write_text(_USDA)
        subprocess.run([sys.executable, "-c", _CONVERT, folder], check=True)
        return {file.suffix: file.read_bytes() for file in Path(folder).iterdir()}


def reader(suffix: str) -> Callable[[bytes], None]:
    """Reads a file of that suffix from a temporary folder: at rest, at a time, its frames and its cameras."""
    folder = tempfile.TemporaryDirectory()

    def read(content: bytes) -> None:
        file = Path(folder.name) / f"mesh{suffix}"
        file.write_bytes(content)
        try:
            parts = read_parts(file)
            times = frame_times(file)
            parts += read_parts(file, times[-1] if times else 0.25)
            cameras = read_cameras(file, 0.25)
        except InputError as error:
            if error.__cause__ is not None and "Error: " in str(error):
                raise RuntimeError("a kind of damage that no reader foresees") from error
            raise
        assert times == sorted(times), "times rise"
        for camera in cameras:
            turn = camera.to_world[:3, :3]
            assert np.allclose(turn @ turn.T, np.eye(3), atol=1e-6), "rigid"
            assert np.isfinite(camera.to_world).all(), "a finite place"
            assert camera.orthographic or 0 < camera.vertical < 180, "an angle"
        for part in parts:
            mesh = part.mesh
            assert len(mesh.triangles) > 0, "a part without triangles"
            assert 0 <= mesh.triangles.min() <= mesh.triangles.max() < len(mesh.positions), "indices"
            assert len(mesh.uv) in (0, len(mesh.positions)), "uv partly there"
            assert all(np.isfinite(rows).all() for rows in (mesh.positions, mesh.normals, mesh.uv)), "finite"
            assert all(len(rows) == len(mesh.positions) for rows in mesh.attributes.values()), "attributes"
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
    usd = usd_contents()
    return [
        Target("obj", [obj_text()], TEXT, reader(".obj")),
        Target("ply-ascii", [ply_content(False, c) for c in (False, True)], TEXT, reader(".ply")),
        Target("ply-binary", [ply_content(True, c) for c in (False, True)], [*BYTES, *TEXT], reader(".ply")),
        Target("gltf", [gltf_text(), gltf_text("meshopt")], gltf, reader(".gltf")),
        Target("gltf-motion", [gltf_motion_text()], gltf, reader(".gltf")),
        Target("glb", [plain, packed], glb, reader(".glb")),
        Target("draco", [compressed], draco, reader(".glb")),
        Target("usda", [usd[".usda"]], TEXT, reader(".usda")),
        Target("usdc", [usd[".usdc"]], BYTES, reader(".usdc")),
        Target("usdz", [usd[".usdz"]], BYTES, reader(".usdz")),
    ]


if __name__ == "__main__":
    sys.exit(main("meshes", targets))
