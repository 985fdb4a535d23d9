"""The viewer, by events as rendercanvas sends them and on its off-screen canvas."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from rendercanvas.offscreen import OffscreenRenderCanvas

from loomlight.fabric import fabric_from_text
from loomlight.realtime import Cloth, DirectionalLight, Environment, Renderer, rectangle
from loomlight.realtime.viewer import Lighting, Orbit, Viewer

SUN = Lighting("sun", [DirectionalLight((0, 0, 1))])
SKY = Lighting("sky", [], {"environment": Environment(np.ones((4, 8, 3)))})


@pytest.fixture
def viewer() -> Viewer:
    cloth = Cloth(rectangle(0.1, 0.1), fabric_from_text('weave = "plain"\n'))
    orbit = Orbit.between((0, 0, 0.3), (0, 0, 0))
    return Viewer(Renderer([cloth], (16, 12), "point"), orbit, [SUN, SKY], models=["point", "point"])


def event(kind: str, **values: Any) -> dict[str, Any]:
    return {"event_type": kind, "modifiers": (), **values}


def test_drags_turn_and_move_and_the_wheel_zooms(viewer: Viewer) -> None:
    assert not viewer.handle(event("pointer_move", x=5, y=5))  # no button is down
    viewer.handle(event("pointer_down", x=4, y=4, button=1))
    assert viewer.handle(event("pointer_move", x=7, y=4))
    assert viewer.orbit.azimuth == pytest.approx(360 - 180 * 3 / 12)
    viewer.handle(event("pointer_up"))
    viewer.handle(event("pointer_down", x=4, y=4, button=2))
    viewer.handle(event("pointer_move", x=4, y=7))
    assert viewer.orbit.target[1] > 0
    assert viewer.handle(event("wheel", dy=-100))
    assert viewer.orbit.distance < 0.3


def test_keys_change_light_and_exposure_and_go_back(viewer: Viewer) -> None:
    assert viewer.handle(event("key_down", key="l"))
    assert viewer.lighting is SKY
    assert viewer.handle(event("key_down", key="+"))
    assert viewer.exposure == 0.5
    viewer.handle(event("wheel", dy=-100))
    assert viewer.handle(event("key_down", key="r"))
    assert (viewer.exposure, viewer.orbit.distance) == (0, pytest.approx(0.3))
    assert viewer.handle(event("key_down", key="m"))
    assert not viewer.handle(event("key_down", key="x"))


def test_a_key_tells_the_camera_as_options(viewer: Viewer) -> None:
    told: list[str] = []
    viewer._tell = told.append
    viewer.handle(event("wheel", dy=-100))
    assert not viewer.handle(event("key_down", key="c"))
    assert told == ["--view 0,0 --target 0,0,0 --distance 0.26087 --focal-length 51.978"]


def test_frames_add_up_while_the_camera_rests(viewer: Viewer) -> None:
    first = viewer.frame().linear
    viewer.frame()
    assert viewer._renderer.passes == 2
    viewer.handle(event("key_down", key="+"))  # another exposure needs no other light
    viewer.frame()
    assert viewer._renderer.passes == 3
    viewer.handle(event("wheel", dy=-100))
    closer = viewer.frame().linear
    assert viewer._renderer.passes == 1
    assert not np.array_equal(first, closer)
    viewer.handle(event("resize", width=8, height=8, pixel_ratio=1.0))
    assert viewer.frame().srgb.shape == (8, 8, 4)


def test_a_canvas_shows_frames_and_their_time(viewer: Viewer) -> None:
    canvas = OffscreenRenderCanvas(size=(20, 10))
    titles: list[str] = []
    canvas.set_title = titles.append
    viewer.attach(canvas)
    shown = np.asarray(canvas.draw())
    assert shown.shape == (10, 20, 4)
    assert shown[..., :3].max() > 50
    assert "point · sun" in titles[-1]
    assert "ms a frame · 1 passes" in titles[-1]
