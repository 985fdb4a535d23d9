"""PLY files: formats, names of uv, and counts that the file does not hold."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.mesh.cloth_mesh import MeshPart
from loomlight.mesh.reading import read_parts

CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
UV = [(0.25, 0.5), (0.5, 0.5), (0.5, 1), (0.25, 1)]


def header(form: str = "ascii", names: tuple[str, ...] = ("u", "v"), faces: int = 1, more: str = "") -> bytes:
    lines = ["ply", f"format {form} 1.0", "comment of a test", "element vertex 4"]
    lines += [f"property float {name}" for name in ("x", "y", "z", *names)]
    lines += [f"element face {faces}", f"property list uchar int vertex_indices{more}", "end_header", ""]
    return "\n".join(lines).encode()


ROWS = "\n".join(" ".join(map(str, (*p, *q))) for p, q in zip(CORNERS, UV, strict=True)) + "\n"
BARE_ROWS = "\n".join(" ".join(map(str, p)) for p in CORNERS) + "\n"


def parts_of(folder: Path, content: bytes) -> list[MeshPart]:
    file = folder / "mesh.ply"
    file.write_bytes(content)
    return read_parts(file)


def check(parts: list[MeshPart]) -> None:
    """All four corners are there, each with its uv, as they are written."""
    (part,) = parts
    assert len(part.mesh.triangles) == 2
    for corner, uv in zip(CORNERS, UV, strict=True):
        at = np.flatnonzero((part.mesh.positions == corner).all(axis=1))
        assert len(at) > 0
        np.testing.assert_allclose(part.mesh.uv[at], np.tile(uv, (len(at), 1)))
    np.testing.assert_allclose(part.mesh.normals, np.tile([0, 0, 1], (len(part.mesh.normals), 1)))


@pytest.mark.parametrize(
    "names", [("u", "v"), ("s", "t"), ("texture_u", "texture_v"), ("texture_s", "texture_t")]
)
def test_names_of_uv(tmp_path: Path, names: tuple[str, ...]) -> None:
    check(parts_of(tmp_path, header(names=names) + f"{ROWS}4 0 1 2 3\n".encode()))


@pytest.mark.parametrize(("form", "order"), [("binary_little_endian", "<"), ("binary_big_endian", ">")])
@pytest.mark.parametrize("faces", [[(0, 1, 2, 3)], [(0, 1, 2), (0, 2, 3)], [(0, 1, 2), (2, 3, 0), (0, 1)]])
def test_binary(tmp_path: Path, form: str, order: str, faces: list[tuple[int, ...]]) -> None:
    body = np.concatenate([CORNERS, UV], axis=1).astype(f"{order}f4").tobytes()
    body += b"".join(struct.pack(f"{order}B{len(face)}i", len(face), *face) for face in faces)
    check(parts_of(tmp_path, header(form, faces=len(faces)) + body))


def test_uv_of_corners(tmp_path: Path) -> None:
    uv = " ".join(f"{u} {v}" for u, v in UV)
    more = "\nproperty list uchar float texcoord"
    check(parts_of(tmp_path, header(names=(), more=more) + f"{BARE_ROWS}4 0 1 2 3 8 {uv}\n".encode()))
    with pytest.warns(LoomlightWarning, match="1 of 3 triangles have no usable uv"):
        cloth, bare = parts_of(
            tmp_path,
            header(names=(), more=more, faces=2) + f"{BARE_ROWS}4 0 1 2 3 8 {uv}\n3 0 1 2 0\n".encode(),
        )
    assert (len(cloth.mesh.triangles), len(bare.mesh.uv)) == (2, 0)


def test_strips(tmp_path: Path) -> None:
    text = header().replace(b"element face 1", b"element tristrips 1") + f"{ROWS}7 0 1 3 2 -1 0 1\n".encode()
    check(parts_of(tmp_path, text))


def test_other_elements_and_line_ends_are_passed_over(tmp_path: Path) -> None:
    head = header().replace(b"element vertex", b"element camera 1\nproperty double fov\nelement vertex")
    check(parts_of(tmp_path, (head + f"35\n{ROWS}4 0 1 2 3\n".encode()).replace(b"\n", b"\r\n")))


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (b"ply\nformat ascii 1.0\n", "is no PLY file"),
        (b"play", "is no PLY file"),
        (header("ascii9") + ROWS.encode(), 'its header holds the line "format ascii9 1.0"'),
        (header().replace(b"format ascii 1.0\n", b""), "names no format"),
        (header().replace(b"float", b"vector"), 'its header holds the line "property vector x"'),
        (header(names=("u",)).replace(b"property float y\n", b""), "holds fewer than 4 rows"),
        (header(faces=2_000_000_000) + f"{ROWS}3 0 1 2\n".encode(), 'fewer than 2000000000 rows of "face"'),
        (header("binary_little_endian", faces=2**40), 'fewer than 4 rows of "vertex"'),
        (header() + f"{ROWS}200 0 1 2\n".encode(), "their lists are longer than the file"),
        (header() + f"{ROWS}-3 0 1 2\n".encode(), "their lists are longer than the file"),
        (header() + f"{ROWS}3 0 1 4\n".encode(), "a face names vertex 4, and there are 4"),
        (header() + f"{ROWS}3 0 1 -1\n".encode(), "a face names vertex -1"),
        (header() + f"{ROWS}3 0 1 two\n".encode(), "is no list of numbers"),
        (header() + f"{ROWS}3 0 1 nan\n".encode(), "a face names vertex"),
        (header() + ROWS.replace("1 1 0", "1 inf 0").encode() + b"4 0 1 2 3", "position is not finite"),
        (header().replace(b"float x", b"float w") + f"{ROWS}3 0 1 2".encode(), "have no x, y and z"),
    ],
)  # fmt: skip
def test_damage_is_one_sentence(tmp_path: Path, content: bytes, says: str) -> None:
    with pytest.raises(InputError) as caught:
        parts_of(tmp_path, content)
    assert says in str(caught.value)
    assert str(tmp_path / "mesh.ply") in str(caught.value)
    assert "\n" not in str(caught.value)
