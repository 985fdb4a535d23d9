"""Frames of moving cloth: which there are, of one topology, and where their vertices are."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.mesh.cloth_mesh import INDEX
from loomlight.mesh.moving import Frame, MovingMesh, chosen_frames, extremes, find_frames, moved
from loomlight.mesh.reading import is_pattern, read_mesh

Floats = NDArray[np.float64]
Write = Callable[[Path, Floats], None]

# Two squares side by side, of a quadrilateral each, that share an edge; the last vertex is no one's.
PLACES = np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 0], [2, 1, 0], [9, 9, 9]], float)


def obj(places: Floats, faces: str = "f 1/1 2/2 5/5 4/4\nf 2/2 3/3 6/6 5/5") -> str:
    lines = [f"v {x} {y} {z}" for x, y, z in places] + [f"vt {x / 2} {y}" for x, y, _ in PLACES]
    return "\n".join([*lines, faces, ""])


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for number in (1, 2, 10):
        lifted = PLACES + np.array([0, 0, 0.1 * number])
        (tmp_path / f"v2-cloth{number}.obj").write_text(obj(lifted))
    (tmp_path / "v2-cloth1.mtl").write_text("newmtl a\n")
    return tmp_path


def test_files_are_in_the_order_of_their_numbers(folder: Path) -> None:
    with pytest.warns(LoomlightWarning, match="has no frame 3 between 2 and 10"):
        frames = find_frames(folder / "v2-*")
    assert [(frame.number, frame.path.name) for frame in frames] == [
        (number, f"v2-cloth{number}.obj") for number in (1, 2, 10)
    ]


def test_numbers_of_folders_and_of_one_file(tmp_path: Path) -> None:
    for number in (7, 11):
        (tmp_path / f"f{number}").mkdir()
        (tmp_path / f"f{number}" / "cloth3.obj").write_text(obj(PLACES))
    assert [frame.number for frame in find_frames(tmp_path / "*" / "cloth3.obj")] == [7, 11]
    assert [frame.number for frame in find_frames(tmp_path / "f7" / "*.obj")] == [3]


@pytest.mark.parametrize(
    ("files", "pattern", "expected"),
    [
        ([], "*.obj", "matches no file: frames are read from .obj"),
        (["a1.txt"], "*", "matches 1 files, none of them a mesh"),
        (["a1.obj", "a2.ply"], "*", "are of two formats: write the suffix, such as"),
        (["a1.obj", "b1.obj", "a2.obj"], "*", "are both frame 1: narrow the pattern"),
        (["a1.obj", "a2.obj", "rest.obj"], "*", "rest.obj, whose name has no number of a frame as"),
    ],
)
def test_patterns_that_are_no_frames(files: list[str], pattern: str, expected: str, tmp_path: Path) -> None:
    for name in files:
        (tmp_path / name).write_text("")
    with pytest.raises(InputError, match=expected):
        find_frames(tmp_path / "sub[1]" / ".." / pattern if not files else tmp_path / pattern)


def test_what_is_a_pattern(tmp_path: Path) -> None:
    (tmp_path / "shirt[2].obj").write_text("")
    assert is_pattern("frames/*.obj")
    assert is_pattern("frames/a?.obj")
    assert not is_pattern(tmp_path / "shirt[2].obj")
    assert not is_pattern("shirt.obj")


FRAMES = [Frame(number, Path(f"{number}.obj")) for number in (2, 4, 6, 8)]


@pytest.mark.parametrize(
    ("chosen", "numbers"),
    [
        (None, [2, 4, 6, 8]),
        (":", [2, 4, 6, 8]),
        ("4", [4]),
        (6, [6]),
        ("3:6", [4, 6]),
        ("4:", [4, 6, 8]),
        (":4", [2, 4]),
        ("2:8:4", [2, 6]),
        (range(4, 9, 2), [4, 6, 8]),
    ],
)
def test_chosen_frames(chosen: object, numbers: list[int]) -> None:
    assert [frame.number for frame in chosen_frames(FRAMES, chosen, "cloth")] == numbers  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("chosen", "expected"),
    [
        ("5", "--frames 5: cloth has frames 2 to 8, and 5 is none of them"),
        ("1:4", "--frames 1:4 is out of range: cloth has frames 2 to 8"),
        ("4:9", "out of range"),
        ("6:4", "out of range"),
        ("2:8:0", "out of range"),
        ("a:b", "says no frames: write A:B"),
        ("1:2:3:4", "says no frames"),
        ("", "says no frames"),
    ],
)
def test_frames_that_are_not_there(chosen: str, expected: str) -> None:
    with pytest.raises(InputError, match=expected):
        chosen_frames(FRAMES, chosen, "cloth", "--frames")


def lifted_frames(folder: Path, write: Write, suffix: str) -> list[Frame]:
    frames = []
    for number in range(2):
        path = folder / f"{number}{suffix}"
        write(path, PLACES + np.array([0, 0, 0.25 * number]))
        frames.append(Frame(number, path))
    return frames


def write_obj(path: Path, places: Floats) -> None:
    path.write_text(obj(places))


def write_glb(path: Path, places: Floats) -> None:
    uv = trimesh.visual.TextureVisuals(uv=PLACES[:, :2])
    faces = [[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4]]
    trimesh.Trimesh(places, faces, visual=uv, process=False).export(path)


def write_ply(path: Path, places: Floats) -> None:
    rows = [f"{x} {y} {z} {u} {v}" for (x, y, z), (u, v, _) in zip(places, PLACES, strict=True)]
    names = "\n".join(f"property float {name}" for name in ("x", "y", "z", "u", "v"))
    header = f"ply\nformat ascii 1.0\nelement vertex {len(rows)}\n{names}\nelement face 2"
    faces = ["4 0 1 4 3", "4 1 2 5 4"]
    path.write_text(
        "\n".join([header, "property list uchar int vertex_indices", "end_header", *rows, *faces, ""])
    )


@pytest.mark.parametrize(
    ("write", "suffix"),
    [(write_obj, ".obj"), (write_ply, ".ply"), (write_glb, ".glb")],
    ids=("obj", "ply", "glb"),
)
def test_every_vertex_finds_its_row(
    write: Callable[[Path, Floats], None], suffix: str, tmp_path: Path
) -> None:
    """Cleaning leaves out the vertex that no face names, and the first triangle once it has no area."""
    frames = lifted_frames(tmp_path, write, suffix)
    collapsed = PLACES.copy()
    collapsed[0] = collapsed[1]
    write(frames[0].path, collapsed)
    mesh = MovingMesh(frames, metres_per_unit=2.0)
    cloth = read_mesh(frames[0].path)
    assert len(cloth.positions) == 6
    found = moved(cloth, mesh.rows(frames[1]))
    expected = 2 * (PLACES[cloth.attributes[INDEX][:, 0].astype(int)] + np.array([0, 0, 0.25]))
    np.testing.assert_allclose(found.positions, expected, atol=1e-6)
    # Where a vertex is in the file its uv says, too.
    u = cloth.uv[:, 0] * (2 if suffix == ".obj" else 1)
    np.testing.assert_allclose(found.positions[:, 0] / 2, u, atol=1e-6)


def test_quadrilaterals_may_be_cut_otherwise(tmp_path: Path) -> None:
    """A face that becomes concave is cut from another corner: the first frame's triangles stay."""
    frames = lifted_frames(tmp_path, write_ply, ".ply")
    dented = PLACES.copy()
    dented[0] = [0.8, 0.8, 0]
    write_ply(frames[1].path, dented)
    np.testing.assert_allclose(MovingMesh(frames).rows(frames[1])[0], [0.8, 0.8, 0], atol=1e-6)


def test_normals_of_their_own_make_no_other_mesh(tmp_path: Path) -> None:
    """Writers that leave out equal normals number them anew in each frame."""
    frames = lifted_frames(tmp_path, write_obj, ".obj")
    faces = "vn 0 0 1\nvn 0 1 0\nf 1/1/1 2/2/2 5/5/1 4/4/1\nf 2/2/1 3/3/2 6/6/1 5/5/2"
    frames[1].path.write_text(obj(PLACES, faces))
    assert len(MovingMesh(frames).rows(frames[1])) == 7


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            obj(PLACES[:6]),
            "1.obj has 6 vertices and 4 triangles, and the first frame, .*, 7 vertices",
        ),
        (obj(PLACES, "f 1/1 2/2 5/5 4/4"), "7 vertices and 2 triangles, and the first frame"),
        (
            obj(PLACES, "f 1/1 2/2 6/6 4/4\nf 2/2 3/3 7/7 4/4"),
            "as many vertices and triangles .* but other",
        ),
        ("v 0 0 0\nv 1 zero 0\nf 1 2 2\n", "1.obj is damaged: line 2"),
        (obj(PLACES * [1, 1, np.nan]), "1.obj is damaged: a vertex position is not finite"),
        ("", "1.obj is empty"),
    ],
)
def test_frames_that_are_another_mesh(text: str, expected: str, tmp_path: Path) -> None:
    frames = lifted_frames(tmp_path, write_obj, ".obj")
    frames[1].path.write_text(text)
    with pytest.raises(InputError, match=expected):
        MovingMesh(frames).rows(frames[1])


def test_extremes_hold_the_hull() -> None:
    """Of 20 000 points in a ball few are kept, and in no direction a point lies 1.5 % farther out."""
    random = np.random.default_rng(3)
    points = random.standard_normal((20_000, 3))
    points *= (random.random((len(points), 1)) ** (1 / 3)) / np.linalg.norm(points, axis=1, keepdims=True)
    kept = extremes(points)
    assert len(kept) < 410
    directions = random.standard_normal((500, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    assert ((points @ directions.T).max(axis=0) - (kept @ directions.T).max(axis=0)).max() < 0.015
    np.testing.assert_allclose(kept.min(axis=0), points.min(axis=0), atol=1e-6)
