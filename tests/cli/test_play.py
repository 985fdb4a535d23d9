"""`loomlight play`: frames off screen, and machines without a display."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from loomlight.cli.main import run
from loomlight.core.camera_settings import CameraKeywords
from loomlight.core.images import read_picture, write_image
from loomlight.core.picture_settings import PlaySettings
from loomlight.fabric import load_fabric
from loomlight.mitsuba import build_scene
from loomlight.models.registry import make_model
from loomlight.realtime.device import default_adapter
from loomlight.sources.loom_file import write_loom
from loomlight.window import _viewer
from tests.helpers.meshes import coat

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.mark.slow
def test_a_frame_is_written_off_screen(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write_image(tmp_path / "sky.exr", np.ones((4, 8, 3), np.float32))
    picture = tmp_path / "denim.png"
    arguments = ["play", str(EXAMPLES / "denim.toml"), "--scene", "flat", "--model", "point"]
    arguments += ["--env", str(tmp_path / "sky.exr"), "--size", "24x16", "--zoom", "2", "--passes", "1"]
    assert run([*arguments, "-o", str(picture)]) == 0
    captured = capsys.readouterr()
    assert captured.out.strip() == str(picture)
    assert ("computes on the CPU" in captured.err) == default_adapter().is_software
    pixels = read_picture(picture)
    assert pixels.shape == (16, 24, 3)
    assert pixels[8, 12, 2] > pixels[8, 12, 0] > 0  # blue cloth


@pytest.fixture
def loom(tmp_path: Path) -> Path:
    """A material of `point`, which is not what a window shows of a fabric."""
    file = tmp_path / "denim.loom"
    write_loom(file, make_model("point", load_fabric(EXAMPLES / "denim.toml")).to_loom())
    return file


def test_a_loom_is_shown_with_the_model_that_it_holds(loom: Path) -> None:
    settings = PlaySettings(scene="flat", size=(16, 12))
    assert [_viewer(file, settings).model for file in (loom, EXAMPLES / "denim.toml")] == ["point", "lobes"]


@pytest.mark.slow
def test_a_loom_is_shown_as_its_fabric(loom: Path, tmp_path: Path) -> None:
    options = ["--scene", "flat", "--size", "16x12", "--passes", "1"]
    pictures = []
    for path, more in ((loom, []), (EXAMPLES / "denim.toml", ["--model", "point"])):
        assert run(["play", str(path), *more, *options, "-o", str(tmp_path / "a.png")]) == 0
        pictures.append(read_picture(tmp_path / "a.png"))
    np.testing.assert_array_equal(*pictures)


def test_no_display_is_one_sentence(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "RENDERCANVAS_FORCE_OFFSCREEN"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr("sys.platform", "linux")
    assert run(["play", str(EXAMPLES / "denim.toml")]) == 2
    message = capsys.readouterr().err
    assert "has no display" in message
    assert "frame.png" in message
    assert message.count("\n") == 1


@pytest.mark.filterwarnings("ignore:.*stay uncovered", "ignore:.*several scales")
@pytest.mark.parametrize(
    "options",
    [
        {"view": "back", "look_at": "front"},
        {"view": "140,30", "look_at": "lining", "focal_length": 85.0},
        {"target": (0.1, 0.2, 0.0), "distance": 0.7, "roll": 20.0},
    ],
)
def test_the_window_opens_at_the_view_of_render(options: CameraKeywords, tmp_path: Path) -> None:
    """But for steepest views, and for the lens of tall pictures over a floor."""
    mesh, size = coat(tmp_path), (32, 24)
    settings = PlaySettings(mesh=mesh, size=size, model="point", **options)
    camera = _viewer("plain", settings).orbit.camera()
    view = build_scene("drape", {"type": "diffuse"}, mesh=mesh, size=size, **options).view
    for name in ("origin", "target", "field_of_view"):
        np.testing.assert_allclose(getattr(camera, name), getattr(view, name), atol=1e-9)
    across = np.cross(view.up, view.backward)
    np.testing.assert_allclose(np.cross(camera.up, view.backward), across / np.linalg.norm(across), atol=1e-9)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--scene", "table"], 'scene = "table" is unknown'),
        (["--model", "neural!"], 'model = "neural!" is unknown here'),
        (["--env", "none.exr"], "none.exr does not exist"),
        (["--passes", "0"], "--passes 0 is out of range"),
        (["--view", "0,100"], 'view = "0,100" is wrong: give front'),
        (["--look-at", "collar"], 'look_at = "collar" needs a mesh with parts'),
        (["--camera", "hero"], 'camera = "hero" needs a mesh file'),
    ],
)
def test_errors_are_sentences(arguments: list[str], message: str, refused: Callable[..., str]) -> None:
    assert message in refused(["play", str(EXAMPLES / "denim.toml"), *arguments, "-o", "a.png"])
