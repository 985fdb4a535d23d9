"""glTF accessors as arrays: strided, normalized, sparse, in plain or compressed buffer views."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import MissingDependencyError
from loomlight.core.extras import installing
from loomlight.mesh.gltf_file import Entry, GltfFile

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
