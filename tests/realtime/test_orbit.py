"""The camera that a mouse moves."""

from __future__ import annotations

import numpy as np
import pytest

from loomlight.core.errors import InputError
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
