"""Cloth on a turntable.

Covers: cli/pictures.py
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import mitsuba as mi
import numpy as np
import pytest
from PIL import Image

from loomlight.cli.main import run
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.picture_settings import RenderSettings
from loomlight.mitsuba import build_scene
from loomlight.mitsuba.pictures import Turntable, turntable

WHITE = {"type": "twosided", "inner": {"type": "diffuse", "reflectance": 0.8}}


def test_a_whole_turn_comes_back() -> None:
    """Half a turn shows another side; four quarters end where they began."""
    table = Turntable(build_scene("drape", WHITE, size=(24, 18)))
    once = list(table.pictures(2, spp=4))
    again = next(table.pictures(1, spp=4))
    np.testing.assert_allclose(again, once[0], rtol=1e-3, atol=1e-4)
    assert np.abs(once[1] - once[0]).mean() > 0.01


def test_the_whole_turn_is_in_the_picture() -> None:
    """A narrow frame: the corners of a flat piece come closest to its sides when they point there."""
    shown = build_scene("drape", WHITE, size=(16, 32))
    table = Turntable(shown)
    forward = shown.view.target - shown.view.origin
    frame = next(table.pictures(1, spp=4))
    assert np.linalg.norm(forward) > 0
    assert np.isfinite(frame).all()


def test_paper_fills_tall_frames_of_a_whole_turn(tmp_path: Path) -> None:
    """A board seen edge-on at first: the turn's camera stands many times as far away."""
    board = tmp_path / "board.obj"
    board.write_text("v 0 0 0\nv 0.01 0 1\nv 0 .1 0\nvt 0 0\nvt 1 0\nvt 0 .1\nf 1/1 2/2 3/3\n")
    shown = build_scene("drape", WHITE, mesh=board, size=(12, 36))
    near = np.linalg.norm(shown.view.origin - shown.view.target)
    Turntable(shown, about_middle=True)
    sensor = shown.scene.sensors()[0]
    assert np.linalg.norm(sensor.world_transform().translation().numpy().ravel()) > 1.2 * near
    corners = mi.Point2f(np.float32([0, 1, 0, 1]), np.float32([0, 0, 1, 1]))
    rays, _ = sensor.sample_ray(mi.Float(0), mi.Float(0), corners, mi.Point2f(0))
    assert shown.scene.ray_intersect(rays).is_valid().numpy().all()


def test_yarns_below_pixels_are_told_once() -> None:
    settings = RenderSettings(model="point", size=(12, 8), spp=1)
    with pytest.warns(LoomlightWarning, match="20 ends/cm are .* yarns a pixel here") as told:
        list(turntable("plain", 2, settings=settings))
    assert len(told) == 1


def test_scene_files_do_not_turn() -> None:
    with pytest.raises(InputError, match="nothing in it turns"):
        next(turntable("plain", 4, "own.xml"))


def test_numbered_pictures_and_animations(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    small = ["--size", "24x16", "--spp", "1", "--model", "point", "--turntable", "2"]
    assert run(["render", "plain", "-o", str(tmp_path / "a.png"), *small]) == 0
    assert run(["render", "plain", "-o", str(tmp_path / "a.jpg"), *small]) == 0
    assert run(["render", "plain", "-o", str(tmp_path / "a.webp"), *small]) == 0
    names = [Path(line).name for line in capsys.readouterr().out.split()]
    assert names == ["a-000.png", "a-001.png", "a-000.jpg", "a-001.jpg", "a.webp"]
    with Image.open(tmp_path / "a-001.jpg") as picture:
        assert picture.format == "JPEG"
    with Image.open(tmp_path / "a.webp") as animation:
        assert animation.n_frames == 2  # type: ignore[attr-defined]
        assert animation.size == (24, 16)


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        (["-o", "a.png", "--turntable", "1"], "--turntable 1 is out of range"),
        (["-o", "a.mp4", "--turntable", "4"], "must end in .png or .jpg or .jpeg or .exr or .webp or .gif"),
        (["-o", "a.webp"], "must end in .png or .jpg or .jpeg or .exr."),
    ],
)
def test_what_does_not_turn(options: list[str], expected: str, refused: Callable[..., str]) -> None:
    assert expected in refused(["render", "plain", *options])
