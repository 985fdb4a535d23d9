"""Where rays meet the tubes of yarns, against marching along the ray, and against the height field."""

from __future__ import annotations

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Bool, Float
from numpy.typing import NDArray

from loomlight.yarn.flanks import FILLED_GAP, OPEN_GAP, filled_share
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout
from loomlight.yarn.rays import REFERENCE_QUALITY
from loomlight.yarn.threads import SECTION_ANGLE
from loomlight.yarn.visibility import first_hit, unoccluded
from tests.helpers.arrays import vectors
from tests.helpers.layouts import SATIN, TWILL, even_layout

COUNT = 4000
LAYOUTS = {"closed": even_layout(TWILL, gap=0.0), "arched": even_layout(SATIN, gap=0.1, inclination=60)}
layouts = pytest.mark.parametrize("layout", LAYOUTS.values(), ids=LAYOUTS)
Floats = NDArray[np.float64]


class Met:
    """Rays of an oblique view at random places, where they end, and what they meet there."""

    def __init__(self, layout: ClothLayout, back: bool = False) -> None:
        rng = np.random.default_rng(3)
        self.geometry = YarnGeometry(layout)
        width, height = self.geometry.size
        x, y = (Float(rng.uniform(0, side, COUNT).astype(np.float32)) for side in (width, height))
        rows = rng.normal(size=(COUNT, 3))
        rows[:, 2] = 0.3 + np.abs(rows[:, 2])
        self.view = vectors(np.float32(rows / np.linalg.norm(rows, axis=1, keepdims=True)))
        self.back = dr.full(Bool, back, COUNT)
        self.hit = first_hit(self.geometry, x, y, self.view, self.back, quality=REFERENCE_QUALITY)
        hit = self.hit
        self.field = self.geometry.surface(hit.x, hit.y, self.back)
        self.point = self.geometry.surface(hit.x, hit.y, self.back, (self.view, hit.height))
        self.yarn = ~hit.hole.numpy()


@pytest.mark.quick("True-closed")
@layouts
@pytest.mark.parametrize("back", [False, True])
def test_on_continuous_yarn_the_point_is_that_of_the_height_field(layout: ClothLayout, back: bool) -> None:
    met = Met(layout, back)
    thread = min(met.geometry.finest)
    smooth = met.yarn & (np.abs(met.point.depth.numpy()) < 1e-4 * thread)
    # The height field's own dive is no part of the tube.
    height = met.field.height.numpy() - met.hit.height.numpy()
    smooth &= np.abs(height) < 1e-4 * thread
    assert smooth.mean() > 0.6
    for name in ("normal", "tangent"):
        here, there = (np.array(getattr(point, name))[:, smooth] for point in (met.point, met.field))
        # A search that ends 1e-4 threads off moves grazing rays by sqrt(4e-4) of the radius, and four
        # times that on the steepest slopes.
        assert np.abs(here - there).max() < 0.08
        assert np.abs(here - there).mean() < 1e-3
    moved = np.hypot((met.point.x - met.hit.x).numpy()[smooth], (met.point.y - met.hit.y).numpy()[smooth])
    assert moved.max() < 0.02 * thread


@pytest.mark.slow
@layouts
def test_frames_are_those_of_the_tube_that_marching_meets(layout: ClothLayout) -> None:
    """The circle is marched in float64, from the eye's side, in the plane across the yarn."""
    met = Met(layout)
    point, field = met.point, met.field
    is_warp = point.is_warp.numpy()
    families = met.geometry.families
    radius = np.where(is_warp, *(f.half_width[0] for f in families)) / np.sin(SECTION_ANGLE)
    # Scales of 0.8 flatten the circle to an ellipse; unscaled directions are those of the circle.
    scale = np.where(is_warp, layout.warp.height_scale, layout.weft.height_scale)
    normal, tangent, view = (np.array(part, np.float64) for part in (point.normal, point.tangent, met.view))
    np.testing.assert_allclose(np.linalg.norm(normal, axis=0), 1, atol=1e-5)
    np.testing.assert_allclose(np.linalg.norm(tangent, axis=0), 1, atol=1e-5)
    assert np.abs((normal * tangent).sum(axis=0))[met.yarn].max() < 1e-4
    across = np.float64(field.across.numpy())
    sideways = np.where(is_warp, view[0], view[1])
    lengthwise = np.where(is_warp, view[1], view[0])
    circle = normal / np.stack([scale, scale, np.ones(COUNT)])
    along = np.where(is_warp, circle[1], circle[0])
    slope = -along / circle[2]
    cosine = 1 / np.sqrt(1 + slope**2)
    up = np.sqrt(np.maximum(radius**2 - across**2, 0)) - point.depth.numpy() / scale * cosine
    upwards = (view[2] / scale - slope * lengthwise) * cosine
    steps = np.linspace(1, -1, 20_001)[:, None] * radius
    chosen = np.flatnonzero(met.yarn & (np.abs(circle[2]) > 1e-2))[:400]
    x = across[chosen] + steps[:, chosen] * sideways[chosen]
    q = up[chosen] + steps[:, chosen] * upwards[chosen]
    inside = np.hypot(x, q) <= radius[chosen]
    meets = inside.any(axis=0) & ~inside[0]
    first = inside.argmax(axis=0)
    assert meets.mean() > 0.8
    expected = np.stack([x, q])[:, first, np.arange(len(chosen))] / radius[chosen]
    found = np.stack([np.where(is_warp, circle[0], circle[1]), circle[2] / cosine])[:, chosen]
    found /= np.linalg.norm(found, axis=0)
    # A step of the march is 1e-4 radii; where it grazes, that is sqrt(2e-4) around the circle.
    assert np.abs(found - expected)[:, meets].max() < 0.03
    assert np.abs(found - expected)[:, meets].mean() < 1e-3


def test_points_on_walls_turn_down_and_stay_outside() -> None:
    met = Met(LAYOUTS["arched"])
    wall = met.yarn & (met.point.depth.numpy() > 0.1 * min(met.geometry.finest))
    assert wall.mean() > 0.05
    field, point = (np.array(where.normal)[2][wall] for where in (met.field, met.point))
    assert (point < field + 1e-3).mean() > 0.9
    assert (point < 0).mean() > 0.1
    # The way back to the eye is free, so shadow rays do not start within the yarn.
    free = unoccluded(met.geometry, met.point.x, met.point.y, met.point.height, met.view, met.back)
    assert free.numpy()[wall].mean() > 0.9


def test_yarn_of_filled_cloth_goes_on_where_it_ends() -> None:
    gaps = Float([0.0, FILLED_GAP, 0.5 * (FILLED_GAP + OPEN_GAP), OPEN_GAP, 1.0])
    np.testing.assert_allclose(filled_share(gaps, Float(1)).numpy(), [1, 1, 0.5, 0, 0], atol=1e-6)
    closed = Met(LAYOUTS["closed"])
    # Faces of dives look along the cloth, their yarn looks up.
    dive = closed.yarn & (np.array(closed.field.normal)[2] < 0.1)
    assert dive.mean() > 0.01
    assert np.median(np.array(closed.point.normal)[2][dive]) > 0.5
