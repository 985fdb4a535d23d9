"""Meshes written and read back: positions, uv, names, further uv; whole or not at all.

Covers: mesh/writing.py
"""

from __future__ import annotations

import base64
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.mesh.cloth_mesh import MeshPart
from loomlight.mesh.reading import read_parts
from loomlight.mesh.unwrap import cut_pieces, with_uv
from loomlight.mesh.writing import WRITTEN_MESHES, write_mesh
from studies.instruments.garment_shapes import cushion


def pieces() -> list[MeshPart]:
    part = replace(cushion(200), name="pillow", material="linen")
    return with_uv([part], cut_pieces([part]))


@pytest.mark.parametrize("suffix", WRITTEN_MESHES)
def test_what_is_written_is_read_again(tmp_path: Path, suffix: str) -> None:
    written = pieces()
    file = tmp_path / f"cushion{suffix}"
    write_mesh(file, written)
    read = read_parts(file)
    assert {part.name for part in read} == {"front", "back"}
    assert [(part.name, part.material) for part in read] == [(part.piece, "linen") for part in written]
    for one, other in zip(written, read, strict=True):
        for values in ("positions", "uv", "normals"):
            ours, theirs = (getattr(p.mesh, values)[p.mesh.triangles] for p in (one, other))
            np.testing.assert_allclose(theirs, ours, atol=2e-6)


def test_further_uv_are_kept(tmp_path: Path) -> None:
    part, *_ = pieces()
    further = part.mesh.uv * [0.5, 0.25]
    part = replace(part, mesh=replace(part.mesh, attributes={"uv1": further}))
    write_mesh(tmp_path / "one.gltf", [part])
    document = json.loads((tmp_path / "one.gltf").read_text())
    attributes = document["meshes"][0]["primitives"][0]["attributes"]
    accessor = document["accessors"][attributes["TEXCOORD_1"]]
    view = document["bufferViews"][accessor["bufferView"]]
    content = base64.b64decode(document["buffers"][0]["uri"].partition(",")[2])
    values = np.frombuffer(content, np.float32, 2 * accessor["count"], view["byteOffset"])
    np.testing.assert_allclose(values.reshape(-1, 2), further, atol=1e-6)


def test_nothing_is_left_where_nothing_can_be_written(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"must end in .obj or .glb or .gltf"):
        write_mesh(tmp_path / "shirt.fbx", pieces())
    with pytest.raises(InputError, match="does not exist; make it first"):
        write_mesh(tmp_path / "lost" / "shirt.obj", pieces())
    assert list(tmp_path.iterdir()) == []
