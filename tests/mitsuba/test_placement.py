"""Cloth turned, shifted and scaled on a mesh."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.core.picture_settings import Placement
from loomlight.mesh.cloth_mesh import ClothMesh
from loomlight.mesh.clothing import placed
from loomlight.mitsuba import build_scene

WHITE = {"type": "diffuse"}


def rectangle(mirrored: bool = False) -> ClothMesh:
    """40 by 20 mm in the plane z = 0, seen from +z; lengths in metres."""
    corners = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
    uv = corners * [1, -1] + [0, 1] if mirrored else corners
    positions = np.c_[corners * [0.04, 0.02], np.zeros(4)]
    return ClothMesh(positions, np.tile([0.0, 0, 1], (4, 1)), uv, np.array([[0, 1, 2], [0, 2, 3]]), "card")


def draft_positions(mesh: ClothMesh, size: tuple[float, float], mirrored: bool) -> np.ndarray:
    """As `cloth_uv.draft_position` has them."""
    v = 1 - mesh.uv[:, 1] if mirrored else mesh.uv[:, 1]
    return np.c_[mesh.uv[:, 0] * size[0], v * size[1]]


def test_cloth_as_life_has_it_is_left_alone() -> None:
    mesh = rectangle()
    same, size = placed(mesh, Placement())
    assert same is mesh
    np.testing.assert_allclose(size, (40, 20))


@pytest.mark.parametrize("mirrored", [False, True])
def test_the_weave_moves_as_told(mirrored: bool) -> None:
    """What lay at a place of the cloth, from its middle, is found turned, scaled and shifted from there."""
    mesh, middle = rectangle(mirrored), np.array([20.0, 10.0])
    moved, size = placed(mesh, Placement(turn=30, shift=(3, -2), scale=2))
    draft = draft_positions(moved, size, mirrored)
    turn = np.radians(30)
    rotation = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    surface = 2 * (draft - middle) @ rotation.T + middle + [3, -2]
    np.testing.assert_allclose(surface, mesh.positions[:, :2] * 1000, atol=1e-9)


@pytest.mark.parametrize("values", [{"turn": np.nan}, {"shift": (0, np.inf)}, {"scale": 0.0}])
def test_what_is_no_placement(values: dict[str, float]) -> None:
    with pytest.raises(InputError, match=next(iter(values))):
        Placement(**values)


def test_scenes_lay_their_cloth(tmp_path: Path) -> None:
    told: list[tuple[float, float]] = []

    def factory(uv_size_mm: tuple[float, float]) -> dict[str, str]:
        told.append(uv_size_mm)
        return WHITE

    build_scene("flat", factory, size=(8, 8), placement=Placement(scale=3))
    scene = tmp_path / "scene.xml"
    scene.write_text(
        '<scene version="3.0.0"><sensor type="perspective"/>'
        '<shape type="rectangle"><bsdf type="diffuse" id="fabric"/></shape></scene>'
    )
    with pytest.raises(InputError, match=r"uv of the shape .* fixed"):
        build_scene(scene, factory, placement=Placement(scale=3))
    assert told == [(1.0, 1.0)]


def test_a_cloth_of_a_scene_file_is_turned_by_itself(tmp_path: Path) -> None:
    scene = tmp_path / "scene.xml"
    scene.write_text(
        '<scene version="3.0.0"><sensor type="perspective"/>'
        '<shape type="rectangle"><bsdf type="diffuse" id="fabric"/></shape>'
        '<shape type="rectangle"><bsdf type="diffuse" id="hem"/></shape></scene>'
    )
    cloths = {"others": {"hem": lambda _: WHITE}, "turns": {"hem": 0.0}}
    build_scene(scene, lambda _: WHITE, **cloths)
    with pytest.raises(InputError, match=r"uv of the shape .* fixed"):
        build_scene(scene, lambda _: WHITE, **{**cloths, "turns": {"hem": 30.0}})
