"""glTF files before their meshes are read: containers, buffers and files that they name, checked one by one.

Only geometry and uv are used: pictures are not read.
"""

from __future__ import annotations

import base64
import binascii
import json
import struct
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeGuard
from urllib.parse import unquote

from loomlight.core.errors import InputError

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
