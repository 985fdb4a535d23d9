"""A mesh as the page takes it: a head in JSON, then numbers.

First the length of the head, filled up with spaces to whole words, and the head; then positions, normals and
uv of the cloth, and positions and normals of what has no uv, in single precision; then triangles of both. All
are little-endian words of 32 bits. uv of cloth that was cut are in the unit of positions.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Sequence

import numpy as np

from loomlight.mesh.cloth_mesh import ClothMesh, MeshPart, joined

_SIZE = struct.Struct("<I")


def mesh_message(parts: Sequence[MeshPart], warnings: Sequence[str]) -> bytes:
    """The message of parts, of which some have uv; `warnings` are sentences for the user."""
    cloth = joined([part.mesh for part in parts if len(part.mesh.uv)])
    bare = [part.mesh for part in parts if not len(part.mesh.uv)]
    nowhere = np.zeros((0, 3))
    none = ClothMesh(nowhere, nowhere, np.zeros((0, 2)), np.zeros((0, 3), np.int64), "")
    rest = joined(bare) if bare else none
    head = {
        "vertices": len(cloth.positions),
        "triangles": len(cloth.triangles),
        "bareVertices": len(rest.positions),
        "bareTriangles": len(rest.triangles),
        "warnings": list(warnings),
    }
    text = json.dumps(head).encode()
    text += b" " * (-len(text) % 4)
    numbers = (cloth.positions, cloth.normals, cloth.uv, rest.positions, rest.normals)
    content = [rows.astype("<f4").tobytes() for rows in numbers]
    content += [mesh.triangles.astype("<u4").tobytes() for mesh in (cloth, rest)]
    return b"".join([_SIZE.pack(len(text)), text, *content])
