"""glTF files before their meshes are read: containers, buffers and the arrays in them, checked one by one.

Only geometry and uv are used: pictures are not read.
"""

from __future__ import annotations

import base64
import binascii
import json
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
        if not is_index(index) or index >= len(entries) or not isinstance(entries[index], dict):
            raise self.damaged(f'it names number {repr(index)[:20]} of its "{kind}", which it does not have')
        return entries[index]

    def integer(self, holder: Entry, key: str, default: int | None = None) -> int:
        """A whole number from 0 on; raises InputError if it is none, or is missing and has no default."""
        value = holder.get(key, default)
        if not is_index(value):
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


def is_index(value: object) -> TypeGuard[int]:
    """Whether a value of JSON is a whole number from 0 on."""
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
