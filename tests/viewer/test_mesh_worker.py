"""Meshes that came over the network: cut by a process of limited time and memory, as bytes for the page.

Covers: viewer/mesh_worker.py, viewer/mesh_message.py, viewer/limited_worker.py, viewer/limited_reader.py
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.mesh.writing import write_mesh
from loomlight.viewer.limited_reader import MeshReader
from loomlight.viewer.mesh_message import mesh_message
from studies.instruments.garment_shapes import skirt

SQUARE = "v 0 0 0\nv 0.3 0 0\nv 0.3 0.3 0\nv 0 0.3 0\n"


@pytest.fixture(scope="module")
def reader() -> Iterator[MeshReader]:
    with closing(MeshReader()) as made:
        yield made


def unpacked(content: bytes) -> tuple[dict[str, object], list[np.ndarray]]:
    """The head, and positions, normals, uv, positions and normals without uv, and triangles of both."""
    size = int(np.frombuffer(content, "<u4", 1)[0])
    head = json.loads(content[4 : 4 + size])
    counts = [head["vertices"]] * 3 + [head["bareVertices"]] * 2
    arrays, at = [], 4 + size
    for count, width in zip(counts, (3, 3, 2, 3, 3), strict=True):
        arrays.append(np.frombuffer(content, "<f4", count * width, at).reshape(-1, width))
        at += 4 * count * width
    for count in (head["triangles"], head["bareTriangles"]):
        arrays.append(np.frombuffer(content, "<u4", count * 3, at).reshape(-1, 3))
        at += 12 * count
    assert at == len(content)
    return head, arrays


def test_a_mesh_without_uv_comes_back_cut(reader: MeshReader, tmp_path: Path) -> None:
    write_mesh(tmp_path / "skirt.obj", [skirt(300)])
    head, (positions, normals, uv, *_, triangles, _) = unpacked(
        reader.read((tmp_path / "skirt.obj").read_bytes(), "skirt.obj")
    )
    assert "skirt.obj has no uv and is cut into 2 pieces" in str(head["warnings"])
    assert str(tmp_path) not in str(head["warnings"])
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-5)

    def lengths(rows: np.ndarray) -> np.ndarray:
        return np.linalg.norm(rows[triangles] - rows[np.roll(triangles, 1, axis=1)], axis=2)

    # uv are in the unit of positions, but for what cloth is stretched.
    assert np.median(lengths(uv) / lengths(positions)) == pytest.approx(1, abs=0.03)


def test_what_has_no_uv_beside_what_has_some_stays_bare(reader: MeshReader) -> None:
    text = SQUARE + "vt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\no button\nf 1 3 4\n"
    head, arrays = unpacked(reader.read(text.encode(), "coat.obj"))
    assert (head["triangles"], head["bareTriangles"]) == (1, 1)
    np.testing.assert_allclose(arrays[3][arrays[6][0]], [[0, 0, 0], [0.3, 0.3, 0], [0, 0.3, 0]], atol=1e-6)


@pytest.mark.parametrize(
    ("content", "name", "sentence"),
    [
        (b"v 0 0 0\nf 1 2 3\n", "../a/cut.obj", r"^cut\.obj is damaged"),
        (b"hello", "notes.txt", r"^notes\.txt: meshes are read from \.obj"),
        (b"", "empty.ply", r"^empty\.ply is empty"),
    ],
)
def test_faults_are_one_sentence(reader: MeshReader, content: bytes, name: str, sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        reader.read(content, name)


def test_time_is_limited() -> None:
    with (
        closing(MeshReader(seconds=0.01)) as hurried,
        pytest.raises(InputError, match=r"given up after 0\.01 s"),
    ):
        hurried.read(SQUARE.encode(), "a.obj")


@pytest.mark.parametrize("warning", ["", "a", "ab", "abc"])
def test_the_head_is_filled_up_to_words(warning: str) -> None:
    part = skirt(100)
    covered = replace(part, mesh=replace(part.mesh, uv=part.mesh.positions[:, :2]))
    head, _ = unpacked(mesh_message([covered], [warning]))
    assert head["warnings"] == [warning]
