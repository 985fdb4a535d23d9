"""glTF files before they are parsed: containers, buffers and the files that they name, checked one by one.

Only geometry and uv are used, so materials and their pictures are left out, and what they name is not read.
"""

from __future__ import annotations

import base64
import binascii
import io
import json
import struct
from pathlib import Path
from typing import Any
from urllib.parse import unquote

from loomlight.core.errors import InputError

# glTF 2.0, section 4.4: magic, version and length of the file; then length, type and content of each chunk.
_HEADER, _CHUNK = struct.Struct("<4sII"), struct.Struct("<I4s")
_DATA_URI = "data:"
# Extensions that compress geometry, which the parser does not know.
_COMPRESSIONS = {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}


def load_gltf(file: Path) -> Any:
    """The `trimesh.Scene` of a .gltf or .glb file, without materials; uv of every mesh that has them.

    Raises:
        InputError: a damaged container, a buffer that is missing, cut off or outside the file's folder, or
            compressed geometry.
    """
    import trimesh

    content = file.read_bytes()
    is_binary = file.suffix.lower() == ".glb"
    text, own_buffer = _chunks(content, file) if is_binary else (content, None)
    tree = _parsed(text, file)
    compressions = sorted(_COMPRESSIONS & set(tree.get("extensionsRequired", [])))
    if compressions:
        raise InputError(
            f"{file} needs the extension {compressions[0]}, which is not read; export it without compression."
        )
    buffers = {
        f"{number}.bin": _buffer(buffer, number, own_buffer, file)
        for number, buffer in enumerate(tree.get("buffers", []))
    }
    stripped = json.dumps(_without_materials(tree)).encode()
    return trimesh.load(
        io.BytesIO(stripped), file_type="gltf", resolver=buffers, force="scene", process=False
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
    return tree


def _buffer(buffer: dict[str, Any], number: int, own: bytes | None, file: Path) -> bytes:
    """The bytes of a buffer: of the GLB itself, of a data URI, or of a file in the same folder or below."""
    uri, size = buffer.get("uri"), buffer.get("byteLength", 0)
    if uri is None:
        if number or own is None:
            raise InputError(f"{file} is damaged: its buffer {number} names no file, and has no bytes here.")
        content, named = own, "the file itself"
    elif uri.startswith(_DATA_URI):
        try:
            content, named = base64.b64decode(uri.partition(",")[2], validate=True), "a data URI"
        except binascii.Error as error:
            raise InputError(f"{file} is damaged: its buffer {number} is no base64 ({error}).") from error
    else:
        content, named = _file_beside(uri, file), f'the file "{uri}"'
    if len(content) < size:
        raise InputError(
            f"{file}: its buffer {number}, {named}, holds {len(content)} of {size} bytes; export it anew."
        )
    return content


def _file_beside(uri: str, file: Path) -> bytes:
    if "://" in uri:
        raise InputError(
            f'{file} names "{uri}", and nothing is fetched: export a .glb, which holds everything.'
        )
    folder = file.resolve().parent
    named = (folder / unquote(uri)).resolve()
    if not named.is_relative_to(folder):
        raise InputError(
            f'{file} names the file "{uri}", which lies outside its folder {file.parent}: '
            "put it beside the mesh, or export a .glb, which holds everything."
        )
    if not named.is_file():
        raise InputError(
            f'{file} names the file "{uri}", which does not exist in {file.parent}: '
            "copy it there, or export a .glb, which holds everything."
        )
    return named.read_bytes()


def _without_materials(tree: dict[str, Any]) -> dict[str, Any]:
    """The file with one plain material for all: the parser takes uv of meshes with a material alone."""
    meshes = [
        {**mesh, "primitives": [_plain(primitive) for primitive in mesh.get("primitives", [])]}
        for mesh in tree.get("meshes", [])
    ]
    buffers = [{**buffer, "uri": f"{number}.bin"} for number, buffer in enumerate(tree.get("buffers", []))]
    left_out = {"images", "textures", "samplers", "animations", "skins", "cameras"}
    kept = {key: value for key, value in tree.items() if key not in left_out}
    return {**kept, "meshes": meshes, "buffers": buffers, "materials": [{}]}


def _plain(primitive: dict[str, Any]) -> dict[str, Any]:
    attributes = {
        name: accessor for name, accessor in primitive["attributes"].items() if not name.startswith("COLOR_")
    }
    kept = {key: value for key, value in primitive.items() if key not in ("extensions", "targets")}
    return {**kept, "attributes": attributes, "material": 0}
