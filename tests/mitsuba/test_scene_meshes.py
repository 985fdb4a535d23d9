"""Scenes whose meshes are damaged: a sentence before Mitsuba reads them, which it would not survive."""

from __future__ import annotations

from pathlib import Path

import pytest

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.mitsuba.meshes import check_scene_meshes
from loomlight.mitsuba.scenes import build_scene

PLY = """ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
property float u
property float v
element face 1
property list uchar int vertex_indices
end_header
0 0 0 0 0
1 0 0 1 0
0 1 0 0 1
3 0 1 {}
"""


def write(folder: Path, text: str) -> Path:
    (folder / "good.ply").write_text(PLY.format(2))
    (folder / "bad.ply").write_text(PLY.format(99999999))
    vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
    (folder / "partly.obj").write_text(vertices + "f 1/1 2/2 3/3\nf 3 2 1\n")
    (folder / "scene.xml").write_text(f'<scene version="3.0.0">{text}</scene>')
    return folder / "scene.xml"


def shape(name: str) -> str:
    kind = name.rpartition(".")[2]
    return f'<shape type="{kind}"><string name="filename" value="{name}"/></shape>'


def test_sound_meshes_pass(tmp_path: Path) -> None:
    check_scene_meshes(write(tmp_path, shape("good.ply") + '<shape type="sphere"/>'))


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (shape("bad.ply"), "a face names vertex 99999999, and there are 3"),
        ('<default name="mesh" value="bad"/>' + shape("$mesh.ply"), "a face names vertex 99999999"),
        (f'<shape type="shapegroup">{shape("bad.ply")}</shape>', "a face names vertex 99999999"),
        (shape("partly.obj"), "1 of 2 triangles have no usable uv coordinates, and Mitsuba takes any"),
    ],
)
def test_damaged_meshes_are_refused(tmp_path: Path, text: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        build_scene(write(tmp_path, text), {"type": "diffuse"})


def test_included_scenes_are_checked_too(tmp_path: Path) -> None:
    write(tmp_path, shape("bad.ply")).rename(tmp_path / "part.xml")
    with pytest.raises(InputError, match="a face names vertex 99999999"):
        check_scene_meshes(write(tmp_path, '<include filename="part.xml"/><include filename="scene.xml"/>'))


def test_what_is_not_checked_is_said(tmp_path: Path) -> None:
    with pytest.warns(LoomlightWarning, match='the mesh "none.ply" is not checked before Mitsuba reads it'):
        check_scene_meshes(write(tmp_path, shape("none.ply")))
