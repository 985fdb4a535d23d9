"""glTF files: what they name, what is cut off, and uv without a material.

Covers: mesh/gltf.py
"""

from __future__ import annotations

import base64
import json
import struct
import sys
from itertools import pairwise
from pathlib import Path
from typing import Any

import DracoPy
import meshopt
import numpy as np
import pytest

from loomlight.core.errors import InputError, MissingDependencyError
from loomlight.mitsuba import read_mesh
from tests.helpers.meshes import CORNERS, TRIANGLES, UV_UP, write_obj
from tests.helpers.meshes import write_gltf as write_glb

from .test_meshes import uv_by_corner

PARTS = CORNERS.astype("<f4"), (UV_UP * [1, -1] + [0, 1]).astype("<f4"), TRIANGLES.astype("<u2")
BODY = b"".join(part.tobytes() for part in PARTS)


def tree_of(uri: str, **more: Any) -> dict[str, Any]:
    """A quad in one buffer, without a material."""
    ends = np.cumsum([0, *(part.nbytes for part in PARTS)]).tolist()
    kinds = (5126, "VEC3", 4), (5126, "VEC2", 4), (5123, "SCALAR", 6)
    return {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2}]}],
        "buffers": [{"uri": uri, "byteLength": len(BODY)}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": start, "byteLength": end - start} for start, end in pairwise(ends)
        ],
        "accessors": [
            {"bufferView": view, "componentType": component, "type": kind, "count": count}
            for view, (component, kind, count) in enumerate(kinds)
        ],
        **more,
    }


def write_gltf(folder: Path, uri: str, **more: Any) -> Path:
    file = folder / "quad.gltf"
    file.write_text(json.dumps(tree_of(uri, **more)))
    return file


@pytest.mark.parametrize("uri", ["quad.bin", "parts/quad.bin", "quad%2Ebin", "data"])
def test_uv_are_read_without_a_material(tmp_path: Path, uri: str) -> None:
    (tmp_path / "parts").mkdir()
    for name in ("quad.bin", "parts/quad.bin"):
        (tmp_path / name).write_bytes(BODY)
    if uri == "data":
        uri = "data:application/octet-stream;base64," + base64.b64encode(BODY).decode()
    mesh, expected = read_mesh(write_gltf(tmp_path, uri)), read_mesh(write_obj(tmp_path))
    np.testing.assert_allclose(uv_by_corner(mesh), uv_by_corner(expected), atol=1e-6)


def test_pictures_of_materials_are_not_read(tmp_path: Path) -> None:
    (tmp_path / "quad.bin").write_bytes(BODY)
    tree = tree_of("quad.bin", images=[{"uri": "../none.png"}], textures=[{"source": 0}])
    tree["materials"] = [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]
    tree["meshes"][0]["primitives"][0]["material"] = 0
    (tmp_path / "quad.gltf").write_text(json.dumps(tree))
    assert len(read_mesh(tmp_path / "quad.gltf").triangles) == 2


@pytest.mark.parametrize(
    ("uri", "says"),
    [
        ("../quad.bin", 'names the file "../quad.bin", which lies outside its folder'),
        ("/etc/hostname", 'names the file "/etc/hostname", which lies outside its folder'),
        ("%2e%2e/quad.bin", "lies outside its folder"),
        ("none.bin", 'names the file "none.bin", which does not exist in'),
        ("http://localhost/quad.bin", 'names "http://localhost/quad.bin", and nothing is fetched'),
        ("short.bin", 'its buffer 0, the file "short.bin", holds 40 of 92 bytes'),
        ("data:;base64,###", "its buffer 0 is no base64"),
    ],
)
def test_buffers_that_cannot_be_had(tmp_path: Path, uri: str, says: str) -> None:
    (tmp_path / "quad.bin").write_bytes(BODY)
    folder = tmp_path / "folder"
    folder.mkdir()
    (folder / "short.bin").write_bytes(BODY[:40])
    file = write_gltf(folder, uri)
    with pytest.raises(InputError) as caught:
        read_mesh(file)
    assert says in str(caught.value)
    assert str(caught.value).startswith(str(file))


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda whole: b"", "is empty"),
        (lambda whole: b"text that is no mesh", 'does not begin with "glTF"'),
        (lambda whole: whole[:100], "is cut off: it holds 100 of"),
        (lambda whole: whole[:-30], "is cut off"),
        (lambda whole: whole[:4] + struct.pack("<I", 1) + whole[8:], "is glTF of version 1"),
        (lambda whole: whole[:12] + struct.pack("<I", 1 << 30) + whole[16:], "a chunk of 1073741824 bytes"),
        (lambda whole: whole[:16] + b"TEXT" + whole[20:], "no chunk of JSON"),
        (lambda whole: whole.replace(b'{"', b'["', 1), "its JSON cannot be read"),
        (lambda whole: whole.replace(b'"asset"', b'"tessa"', 1), 'its JSON has no "asset"'),
    ],
)
def test_damaged_binaries(tmp_path: Path, change: Any, says: str) -> None:
    file = write_glb(tmp_path)
    file.write_bytes(change(file.read_bytes()))
    with pytest.raises(InputError) as caught:
        read_mesh(file)
    assert says in str(caught.value)
    assert str(caught.value).startswith(str(file))
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("damage", [False, True])
def test_draco_is_decoded(tmp_path: Path, damage: bool) -> None:
    body = DracoPy.encode(
        PARTS[0], TRIANGLES.astype(np.uint32), tex_coord=PARTS[1].astype(float), quantization_bits=20
    )
    (tmp_path / "quad.bin").write_bytes(body[:-40] if damage else body)
    tree = tree_of("quad.bin")
    tree["buffers"][0]["byteLength"] = len(body) - 40 * damage
    tree["bufferViews"] = [{"buffer": 0, "byteLength": len(body) - 40 * damage}]
    for accessor in tree["accessors"]:
        del accessor["bufferView"]
    extension = {"bufferView": 0, "attributes": {"POSITION": 1, "TEXCOORD_0": 0}}
    tree["meshes"][0]["primitives"][0]["extensions"] = {"KHR_draco_mesh_compression": extension}
    (tmp_path / "quad.gltf").write_text(json.dumps(tree))
    if damage:
        with pytest.raises(InputError, match="its Draco data cannot be decoded"):
            read_mesh(tmp_path / "quad.gltf")
        return
    mesh, expected = read_mesh(tmp_path / "quad.gltf"), read_mesh(write_obj(tmp_path))
    np.testing.assert_allclose(
        mesh.uv[np.lexsort(mesh.positions.round(2).T)],
        expected.uv[np.lexsort(expected.positions.T)],
        atol=1e-3,
    )


def write_compressed_quad(folder: Path, name: str = "EXT_meshopt_compression") -> None:
    """A square in quad.gltf and quad.bin, whose positions are compressed by the extension `name`."""
    body = meshopt.encode_gltf_buffer(PARTS[0], "ATTRIBUTES")
    tree = tree_of("quad.bin")
    (folder / "quad.bin").write_bytes(BODY + body)
    tree["buffers"][0]["byteLength"] = len(BODY + body)
    entry = {"buffer": 0, "byteOffset": len(BODY), "byteLength": len(body), "byteStride": 12}
    tree["bufferViews"][0]["extensions"] = {name: {**entry, "count": 4, "mode": "ATTRIBUTES"}}
    (folder / "quad.gltf").write_text(json.dumps(tree))


@pytest.mark.parametrize("name", ["EXT_meshopt_compression", "KHR_meshopt_compression"])
def test_meshopt_is_decoded_or_its_package_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    write_compressed_quad(tmp_path, name)
    np.testing.assert_allclose(read_mesh(tmp_path / "quad.gltf").positions, CORNERS)
    monkeypatch.setitem(sys.modules, "meshopt", None)
    with pytest.raises(MissingDependencyError, match=f"is compressed by {name}: install its decoder"):
        read_mesh(tmp_path / "quad.gltf")
