"""Settings of cameras: names of views against angles, lenses, and what contradicts."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest

from loomlight.core.camera_settings import VIEWS, CameraSettings, direction_of_angles, focal_length_of
from loomlight.core.errors import InputError


def test_names_of_views_are_directions() -> None:
    """x to the right, y up, z to the front."""
    expected = {
        "front": (0, 0, 1),
        "back": (0, 0, -1),
        "left": (-1, 0, 0),
        "right": (1, 0, 0),
        "top": (0, 1, 0),
        "bottom": (0, -1, 0),
    }
    for name, towards in expected.items():
        np.testing.assert_allclose(direction_of_angles(*VIEWS[name]), towards, atol=1e-12)
    for name, front in (("three-quarter", 1), ("back-three-quarter", -1)):
        assert (np.sign(direction_of_angles(*VIEWS[name])) == (1, 1, front)).all()


@pytest.mark.parametrize("view", ["-30,20", " -30 , 2e1", (-30, 20), [-30.0, 20.0], np.array([-30, 20])])
def test_angles_are_text_or_numbers(view: Any) -> None:
    assert CameraSettings(view=view).angles == (-30, 20)


@pytest.mark.parametrize("view", ["side", "", "30", "1,2,3", "0,91", "361,0", "nan,0", (1,), 3, {}])
def test_other_views_are_refused(view: Any) -> None:
    with pytest.raises(InputError, match=r"view = .* is wrong: give front, back, .* such as 30,20"):
        CameraSettings(view=view)


def test_a_lens_of_film() -> None:
    """The diagonal of 24 × 24 mm aside, books have 28.1 degrees along 24 mm of a lens of 48 mm."""
    assert CameraSettings(focal_length=48).field_of_view == pytest.approx(28.07, abs=0.01)
    assert CameraSettings(focal_length=12).field_of_view == pytest.approx(90)
    assert focal_length_of(90) == pytest.approx(12)
    assert CameraSettings().field_of_view is None


@pytest.mark.parametrize(
    ("settings", "sentence"),
    [
        ({"camera": "a", "view": "back"}, 'camera = "a" and view = "back" both say how the file'),
        ({"camera": "a", "roll": 3.0}, 'camera = "a" and roll = 3.0 both say'),
        (
            {"look_at": "collar", "target": (0, 0, 0)},
            'look_at = "collar" and target = (0, 0, 0) both say where',
        ),
    ],
)
def test_what_contradicts_is_refused(settings: dict[str, Any], sentence: str) -> None:
    with pytest.raises(InputError, match=re.escape(sentence)):
        CameraSettings(**settings)
