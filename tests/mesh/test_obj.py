"""OBJ files: what their lines may look like, and what is refused.

Covers: mesh/cloth_mesh.py
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.mesh.cloth_mesh import MeshPart, cross_products, triangulate
from loomlight.mesh.reading import read_parts
from tests.work import calls_of

VERTICES = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"


def parts_of(folder: Path, text: str | bytes) -> list[MeshPart]:
    file = folder / "mesh.obj"
    file.write_bytes(text if isinstance(text, bytes) else text.encode())
    return read_parts(file)


@pytest.mark.parametrize(
    "faces",
    [
        "f 1/1 2/2 3/3 4/4",
        "f 1/1/1 2/2/1 3/3/1 4/4/1",
        "f -4/-4/-1 -3/-3/-1 -2/-2/-1 -1/-1/-1",
        "f 1/1 2/2 \\\n  3/3 \\\n 4/4",
        "f 1/1 2/2\\\r\n 3/3 4/4\r\n",
        "\tf\t1/1\t2/2 3/3   4/4  # the last",
        "f 1/1 2/2 3/3 4/4\rs off\rl 1 2\r",
        "f 1/1/ 2/2/ 3/3/ 4/4/",
        "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n\x1a",
    ],
)
def test_spellings_of_a_face(tmp_path: Path, faces: str) -> None:
    (part,) = parts_of(tmp_path, VERTICES + faces)
    assert len(part.mesh.triangles) == 2
    np.testing.assert_allclose(cross_products(part.mesh), [[0, 0, 1]] * 2)
    # v runs down.
    np.testing.assert_allclose(part.mesh.uv, part.mesh.positions[:, :2] * [1, -1] + [0, 1])
    np.testing.assert_allclose(part.mesh.normals, [[0, 0, 1]] * 4)


@pytest.mark.parametrize("line_end", ["\r\n", "\r"])
@pytest.mark.parametrize("mark", [b"", b"\xef\xbb\xbf"])
def test_line_ends_and_marks(tmp_path: Path, line_end: str, mark: bytes) -> None:
    text = (VERTICES + "f 1/1 2/2 3/3 4/4\n").replace("\n", line_end)
    assert len(parts_of(tmp_path, mark + text.encode())[0].mesh.triangles) == 2


def test_vertices_may_carry_more_numbers(tmp_path: Path) -> None:
    text = VERTICES.replace("v 1 0 0", "v 1 0 0 1.0 0.5 0.5 # a colour").replace("vt 0 0", "vt 0 0 0")
    assert len(parts_of(tmp_path, text + "f 1/1 2/2 3/3")[0].mesh.triangles) == 1


def test_relative_indices_count_from_their_line(tmp_path: Path) -> None:
    more = "f -4/-4 -3/-3 -2/-2\nv 5 0 0\nv 6 0 0\nv 6 1 0\nf -3/-4 -2/-3 -1/-2\n"
    (part,) = parts_of(tmp_path, VERTICES + more)
    np.testing.assert_allclose(np.sort(part.mesh.positions[:, 0]), [0, 1, 1, 5, 6, 6])


def test_parts_are_objects_and_materials(tmp_path: Path) -> None:
    text = (
        VERTICES
        + "o shirt\nusemtl red\nf 1/1 2/2 3/3\nusemtl blue\nf 1/1 3/3 4/4\n"
        + "g button one\nf 1/1 2/2 4/4\no shirt\nusemtl red\nf 2/2 3/3 4/4\n"
    )
    parts = parts_of(tmp_path, text)
    assert [(part.name, part.material, len(part.mesh.triangles)) for part in parts] == [
        ("shirt", "red", 2),
        ("shirt", "blue", 1),
        ("button one", "blue", 1),
    ]


@pytest.mark.parametrize(
    "faces", ["f 1 3 4", "f 1//1 3//1 4//1", "f 1/ 3/ 4/", "f 1/1 3 4/4", "f 1/0 3/0 4/0"]
)
def test_faces_without_uv_stay_uncovered(tmp_path: Path, faces: str) -> None:
    text = VERTICES + "g cloth\nf 1/1 2/2 3/3\n" + faces
    with pytest.warns(LoomlightWarning, match="1 of 2 triangles, of cloth, have no usable uv"):
        cloth, bare = parts_of(tmp_path, text)
    assert (len(cloth.mesh.uv), len(bare.mesh.uv)) == (3, 0)
    assert cloth.name == bare.name == "cloth"


@pytest.mark.parametrize(
    ("more", "says"),
    [
        ("f 1 2 5", 'face 1, "1 2 5", names a vertex that is not there; there are 4'),
        ("f 1/1 2/2 3/9", "names a texture vertex that is not there; there are 4"),
        ("f 1//1 2//1 3//2", "names a normal that is not there; there are 1"),
        ("f 0 1 2", "names a vertex that is not there"),
        ("f -5 1 2", "names a vertex that is not there"),
        ("f 1 2 3 99999999999999999999999", "face 1"),
        ("f 1 2 x", 'face 1 is "1 2 x", which is no list of corners'),
        ("f 1 2 3/1/1/1", "which is no list of corners"),
        ("f 1.5 2 3", "which is no list of corners"),
        ("v 1 2\nf 1 2 3", 'line 5 of those that begin with "v" goes on with "1 2", which is no 3 numbers'),
        ("vn 1 2 three\nf 1 2 3", 'line 2 of those that begin with "vn"'),
        ("v 1e999 0 0\nf 1 2 5", "a vertex position is not finite"),
        ("v nan 0 0\nf 1 2 5", "a vertex position is not finite"),
        ("", "holds no triangles: it has no faces"),
        ("p 1\nl 1 2", "holds no triangles: it has no faces"),
    ],
)
def test_lines_that_are_refused(tmp_path: Path, more: str, says: str) -> None:
    with pytest.raises(InputError) as caught:
        parts_of(tmp_path, VERTICES + more)
    assert says in str(caught.value)
    assert str(tmp_path / "mesh.obj") in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("encoding", ["utf-16-le", "utf-16-be"])
def test_text_of_16_bits_is_named(tmp_path: Path, encoding: str) -> None:
    with pytest.raises(InputError, match=r"is UTF-16 text: save it as UTF-8\.$"):
        parts_of(tmp_path, ("\ufeff" + VERTICES + "f 1 2 3\n").encode(encoding))


def test_parts_are_bounded(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="has more than 20000 parts"):
        parts_of(tmp_path, VERTICES + "\n".join(f"g {number}\nf 1 2 3" for number in range(20_001)))


# Corners of polygons, counter-clockwise, and their areas.
POLYGONS = {
    "L": ([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)], 3),
    "arrow": ([(0, 0), (2, 1), (0, 2), (0.5, 1)], 1.5),
    "arrow from its notch": ([(0.5, 1), (0, 0), (2, 1), (0, 2)], 1.5),
    "comb": ([(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)], 7),
    "straight corners": ([(0, 0), (1, 0), (2, 0), (2, 2), (1, 2), (0, 2)], 4),
    "hexagon": ([(2, 0), (3, 1), (3, 2), (2, 3), (1, 2), (1, 1)], 4),
}  # fmt: skip
TURNS = [np.eye(3), np.diag([1.0, -1, -1]), np.array([[0.0, 0, 1], [1, 0, 0], [0, 1, 0]])]


@pytest.mark.parametrize("turn", TURNS, ids=["as is", "turned over", "upright"])
@pytest.mark.parametrize("name", POLYGONS)
def test_polygons_keep_their_area_and_front(name: str, turn: np.ndarray) -> None:
    flat, area = POLYGONS[name]
    for start in range(len(flat)):
        ring = np.roll(np.array(flat, dtype=float), start, axis=0)
        positions = np.concatenate([ring, np.zeros((len(ring), 1))], axis=1) @ turn.T
        triangles = triangulate(positions, np.arange(len(ring)), np.array([len(ring)]))
        a, b, c = (positions[triangles[:, corner]] for corner in range(3))
        facing = np.cross(b - a, c - a) @ (turn @ [0, 0, 1]) / 2
        assert (facing > -1e-12).all()
        assert facing.sum() == pytest.approx(area)


def test_faces_of_fewer_than_three_corners_have_no_triangles() -> None:
    triangles = triangulate(np.eye(3), np.array([0, 1, 0, 0, 1, 2]), np.array([2, 1, 0, 3]))
    np.testing.assert_array_equal(triangles, [[3, 4, 5]])


def test_a_line_takes_as_few_calls_in_a_large_mesh(tmp_path: Path) -> None:
    side = 101
    x, y = np.meshgrid(np.arange(side), np.arange(side))
    vertices = "\n".join(f"v {a} {b} 0\nvt {a} {b}" for a, b in zip(x.ravel(), y.ravel(), strict=True))
    corner = (np.arange(side - 1)[:, None] * side + np.arange(side - 1) + 1).ravel()
    faces = "\n".join(
        f"f {a}/{a} {a + 1}/{a + 1} {a + side + 1}/{a + side + 1} {a + side}/{a + side}" for a in corner
    )
    file = tmp_path / "mesh.obj"
    file.write_text(f"{vertices}\n{faces}\n")
    parts: list[MeshPart] = []
    calls = calls_of(lambda: parts.extend(read_parts(file)))
    assert len(parts[0].mesh.triangles) == 20_000
    # 2.6 were seen: work that grows with the mesh for every line would be thousands.
    assert calls < 4 * file.read_text().count("\n")
