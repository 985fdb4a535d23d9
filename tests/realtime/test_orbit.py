"""The camera that a mouse moves."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import typer
from typer.testing import CliRunner

from loomlight.cli.options import Given, takes
from loomlight.core.camera_settings import CameraSettings
from loomlight.core.errors import InputError
from loomlight.mitsuba.camera import chosen_view
from loomlight.realtime.viewer import Orbit


@pytest.mark.parametrize("origin", [(0, 0, 1), (1, 2, 3), (-0.3, -0.4, 0.1)])
def test_an_orbit_begins_where_the_camera_stands(origin: tuple[float, float, float]) -> None:
    camera = Orbit.between(origin, (0.1, 0, 0)).camera()
    np.testing.assert_allclose(camera.origin, origin, atol=1e-12)
    np.testing.assert_allclose(camera.target, (0.1, 0, 0))


def test_the_object_follows_the_mouse() -> None:
    """A point of the object that faces the camera goes to the right of the picture where the drag does."""
    before = Orbit.between((0, 0, 1), (0, 0, 0))
    facing = np.array([0, 0, 0.1])
    after = before.turned(0.1, 0.0).camera().axes(10, 10)
    assert (facing - after["origin"]) @ after["right"] > 0
    after = before.turned(0.0, 0.1).camera().axes(10, 10)
    assert (facing - after["origin"]) @ after["up"] < 0


def test_a_move_takes_the_target_across_the_picture() -> None:
    """A drag over the whole side brings a point from one edge of the picture to the other."""
    orbit = Orbit.between((0, 0, 1), (0, 0, 0))
    half = np.tan(np.radians(orbit.field_of_view) / 2)
    np.testing.assert_allclose(orbit.moved(1, 0).target, [-2 * half, 0, 0], atol=1e-12)
    np.testing.assert_allclose(orbit.moved(0, 1).target, [0, 2 * half, 0], atol=1e-12)


def test_turns_and_distances_are_bounded() -> None:
    orbit = Orbit.between((0, 0, 1), (0, 0, 0))
    assert orbit.turned(0, 10).elevation == 89
    assert orbit.turned(0, -10).elevation == -89
    assert orbit.closer(1000).distance == orbit.nearest
    assert orbit.closer(-1000).distance == orbit.farthest
    assert orbit.closer(3).closer(-3).distance == pytest.approx(1)
    assert orbit.turned(0, 10).camera().axes(4, 4)["right"] == pytest.approx(
        orbit.camera().axes(4, 4)["right"]
    )
    with pytest.raises(InputError, match="looks at the point"):
        Orbit.between((0, 0, 0), (0, 0, 0))


@pytest.mark.parametrize("roll", [0.0, 30.0, -120.0])
def test_drags_follow_the_picture_that_is_rolled(roll: float) -> None:
    """What faces the camera goes where the drag does, in the picture as it is seen."""
    before = replace(Orbit.between((0.3, 0.4, 1), (0, 0, 0)), roll=roll)
    facing = 0.1 * before.backward
    for right, down in ((0.02, 0.0), (0.0, 0.02), (0.01, -0.02)):
        for after in (before.turned(right, down), before.moved(right, down)):
            seen = after.camera().axes(10, 10)
            offset = facing - seen["origin"]
            place = np.array([offset @ seen["right"], -(offset @ seen["up"])])
            assert place @ [right, down] / np.linalg.norm(place) / np.hypot(right, down) > 0.99


def test_rolled_pictures_turn_counter_clockwise() -> None:
    up = replace(Orbit.between((0, 0, 1), (0, 0, 0)), roll=90).camera().up
    np.testing.assert_allclose(up, [1, 0, 0], atol=1e-12)


def test_options_place_the_same_camera() -> None:
    """To a ten-thousandth of the distance, read as the command line reads them."""
    found: list[Given] = []
    small = typer.Typer()

    @small.command()
    @takes(CameraSettings)
    def show(given: Given) -> None:
        found.append(given)

    rng = np.random.default_rng(2)
    for _ in range(20):
        distance = float(10 ** rng.uniform(-2.5, 2))
        orbit = Orbit(
            rng.normal(size=3),
            float(rng.uniform(0, 360)),
            float(rng.uniform(-89, 89)),
            distance,
            field_of_view=float(rng.uniform(5, 60)),
            roll=float(rng.uniform(-90, 90)),
        )
        assert CliRunner().invoke(small, orbit.options().split()).exception is None
        read = chosen_view(CameraSettings(**found[-1]), np.eye(3), np.array([0.0, 0, 1]), (40, 30))
        camera = orbit.camera()
        np.testing.assert_allclose(read.target, camera.target, atol=2e-4 * distance)
        np.testing.assert_allclose(read.origin, camera.origin, atol=5e-4 * distance)
        np.testing.assert_allclose(read.up, camera.up, atol=2e-4)
        assert read.field_of_view == pytest.approx(camera.field_of_view, rel=1e-3)
    assert " --roll" not in Orbit.between((0, 0, 1), (0, 0, 0)).options()
