"""Primitives of glTF that Draco compresses."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from loomlight.mesh.gltf_accessors import attribute, normalized, view_bytes
from loomlight.mesh.gltf_file import Entry, GltfFile


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
