"""Shadows and what lies behind holes, with two sheets of cloth against Mitsuba; the shadow on a ground.

Covers: realtime/scene.py
"""

from __future__ import annotations

import math
from pathlib import Path

import mitsuba as mi
import numpy as np
import pytest

from loomlight.evaluation.metrics import flip_mean
from loomlight.fabric import load_fabric
from loomlight.realtime import Camera, Cloth, DirectionalLight, Mesh, PointLight, Renderer, rectangle
from loomlight.realtime.scene import Light
from studies.accuracy.realtime_frames import mitsuba_frame

EXAMPLES = Path(__file__).parents[2] / "examples"
SIZE = (32, 32)
CAMERA = Camera((0, -0.1, 0.15), field_of_view=30)
SUN = DirectionalLight((0.5, 0.3, 0.8))
LAMP = PointLight((0.05, 0.02, 0.06), (0.01, 0.01, 0.01))


def two_sheets(upper: str) -> list[Cloth]:
    """Denim with a smaller sheet 10 mm above it."""
    low = rectangle(0.1, 0.1)
    raised = low.positions * (0.4, 0.4, 1) + np.array([0, 0, 0.01])
    high = Mesh(raised, low.normals, low.uv * 0.4, low.faces)
    return [
        Cloth(low, load_fabric(EXAMPLES / "denim.toml")),
        Cloth(high, load_fabric(EXAMPLES / f"{upper}.toml")),
    ]


@pytest.fixture(scope="module")
def open_sheets() -> Renderer:
    return Renderer(two_sheets("organza"), SIZE, "point")


@pytest.mark.slow
@pytest.mark.parametrize("light", [SUN, LAMP], ids=["directional", "point"])
def test_open_cloth_shadows_and_shows_as_in_mitsuba(open_sheets: Renderer, light: Light) -> None:
    mi.set_variant("llvm_ad_rgb")
    found = open_sheets.render(CAMERA, [light], passes=24, samples=32).linear[..., :3]
    expected = mitsuba_frame(two_sheets("organza"), CAMERA, SIZE, [light], spp=768)
    # Frames filter fibres and hairs of the denim below by pixels, Mitsuba by the distance of samples; both
    # keep the mean to 1 %.
    assert found.mean() == pytest.approx(expected.mean(), rel=0.02)
    assert flip_mean(found, expected, np.ones(SIZE, bool)) <= 0.035


@pytest.mark.slow
def test_shadows_are_between_none_and_those_of_opaque_cloth(open_sheets: Renderer) -> None:
    """At a pixel in the shadow of the upper sheet, below it in the picture."""
    shadow = (21, 12)
    options = {"passes": 4, "samples": 16}
    lit = open_sheets.render(CAMERA, [SUN], shadows=False, **options).linear[shadow][:3].mean()
    through = open_sheets.render(CAMERA, [SUN], **options).linear[shadow][:3].mean()
    opaque = Renderer(two_sheets("denim"), SIZE, "point").render(CAMERA, [SUN], **options)
    assert lit > 1.3 * through > 0
    assert (opaque.linear[shadow][:3] == 0).all()


def test_one_flat_sheet_casts_none(open_sheets: Renderer) -> None:
    flat = Renderer(two_sheets("organza")[:1], SIZE, "point")
    assert flat._scene.is_flat
    assert not open_sheets._scene.is_flat


SHEET, ABOVE = 0.1, 0.05  # metres


def ground_below(fabric: str, lamp_share: float, passes: int = 32) -> float:
    """What the background keeps, on a ground below a square sheet, at the middle of an edge."""
    cloth = Cloth(rectangle(SHEET, SHEET), load_fabric(EXAMPLES / f"{fabric}.toml"))
    camera = Camera((0.2, 0, 0.2), target=(SHEET / 2, 0, -ABOVE), up=(0, 0, 1), field_of_view=0.1)
    options = {"background": (0.5, 0.5, 0.5), "ground": (0, 0, 1, -ABOVE, lamp_share), "samples": 1}
    picture = Renderer([cloth], (8, 8), "point").render(camera, [SUN], passes=passes, **options)
    assert picture.linear[..., 3].max() == 0  # no cloth is seen
    return float(picture.linear[..., :3].mean()) / 0.5


def test_a_ground_loses_the_share_of_the_sky_that_cloth_covers() -> None:
    """The form factor of a parallel rectangle below a corner, of two halves of the sheet (Howell C-11)."""
    x, y = SHEET / ABOVE, SHEET / 2 / ABOVE
    across, along = math.hypot(1, x), math.hypot(1, y)
    corner = (x / across * math.atan(y / across) + y / along * math.atan(x / along)) / (2 * math.pi)
    found = ground_below("denim", 0.0)
    assert found == pytest.approx(1 - 2 * corner, abs=0.01)
    # Open cloth covers less.
    layout = load_fabric(EXAMPLES / "organza.toml").layout()
    assert 1 - ground_below("organza", 0.0) == pytest.approx((1 - found) * (1 - layout.open_area), abs=0.01)


def test_a_ground_loses_the_light_of_the_lamp() -> None:
    """A lamp to the side, which the sheet does not hide, one of which it hides half, and one behind it."""
    cloth = Cloth(rectangle(SHEET, SHEET), load_fabric(EXAMPLES / "denim.toml"))
    camera = Camera((0.2, 0, 0.2), target=(SHEET / 2, 0, -ABOVE), up=(0, 0, 1), field_of_view=0.1)
    options = {"background": (0.5, 0.5, 0.5), "ground": (0, 0, 1, -ABOVE, 1.0), "passes": 32}
    renderer = Renderer([cloth], (8, 8), "point")
    shares = [
        float(renderer.render(camera, [DirectionalLight(towards)], **options).linear[..., :3].mean()) / 0.5
        for towards in [(1, 0, 0.5), (0, 0, 1), (-1, 0, 1)]
    ]
    # All but what its holes let through.
    open_area = load_fabric(EXAMPLES / "denim.toml").layout().open_area
    assert shares == pytest.approx([1, 0.5, open_area], abs=0.02)


def test_a_ground_is_not_seen_from_below() -> None:
    cloth = Cloth(rectangle(SHEET, SHEET), load_fabric(EXAMPLES / "denim.toml"))
    options = {"background": (0.5, 0.5, 0.5), "passes": 2}
    renderer, camera = Renderer([cloth], (16, 16), "point"), Camera((0.1, 0, -0.3), field_of_view=60)
    without = renderer.render(camera, [SUN], **options).linear
    np.testing.assert_array_equal(
        renderer.render(camera, [SUN], ground=(0, 0, 1, -ABOVE, 0.5), **options).linear, without
    )
