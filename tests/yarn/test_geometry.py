"""The analytic surface: normals against differences of heights, continuity, periodicity, no steps upwards.

Double precision where the truth is a difference: in single precision it would be rounding.

Covers: yarn/geometry.py, yarn/layout.py, yarn/threads.py
"""

from __future__ import annotations

import math

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Bool, Float, Float64

from loomlight.core.errors import InputError
from loomlight.yarn.flanks import SurfacePoint
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import MIN_GAP, ClothLayout, FamilyLayout
from tests.helpers.layouts import PLAIN, SATIN, TWILL, even_layout, random_layout

COUNT = 20_000
STEP = 1e-7  # mm: rounding of heights (1e-16) and curvature (radii above 1e-3 mm) both stay below 1e-3


def _evaluate(geometry: YarnGeometry, x: np.ndarray, y: np.ndarray, back: bool) -> SurfacePoint:
    return geometry.surface(Float64(x), Float64(y), dr.full(Bool, back, len(x)))


def _same_yarn(*points: SurfacePoint) -> np.ndarray:
    first = points[0]
    same = ~first.hole.numpy()
    for point in points[1:]:
        same &= point.is_warp.numpy() == first.is_warp.numpy()
        thread = np.where(first.is_warp.numpy(), first.warp_thread.numpy(), first.weft_thread.numpy())
        other = np.where(point.is_warp.numpy(), point.warp_thread.numpy(), point.weft_thread.numpy())
        same &= thread == other
    return same


@pytest.mark.parametrize("seed", range(12))
def test_normals_are_those_of_the_heights(seed: int) -> None:
    rng = np.random.default_rng(seed)
    geometry = YarnGeometry(random_layout(rng, uneven=seed % 2 == 1))
    width, height = geometry.size
    x, y = rng.uniform(-width, 2 * width, COUNT), rng.uniform(-height, 2 * height, COUNT)
    back = seed % 3 == 0
    here = _evaluate(geometry, x, y, back)
    right, left = _evaluate(geometry, x + STEP, y, back), _evaluate(geometry, x - STEP, y, back)
    above, below = _evaluate(geometry, x, y + STEP, back), _evaluate(geometry, x, y - STEP, back)
    slope_x = (right.height - left.height).numpy() / (2 * STEP)
    slope_y = (above.height - below.height).numpy() / (2 * STEP)
    expected = np.stack([-slope_x, -slope_y, np.ones(COUNT)])
    expected /= np.linalg.norm(expected, axis=0)
    same = _same_yarn(here, right, left, above, below)
    # The sine of the angle; where a difference straddles a change of curvature it errs by step/radius,
    # which a handful of points in 20 000 hit.
    error = np.linalg.norm(np.cross(expected, here.normal.numpy(), axis=0), axis=0)[same]
    assert same.mean() > 0.2
    assert np.quantile(error, 0.9995) < math.radians(5e-3)


@pytest.mark.parametrize("seed", range(6))
def test_tangents_are_unit_and_lie_in_the_surface(seed: int) -> None:
    rng = np.random.default_rng(seed)
    geometry = YarnGeometry(random_layout(rng, uneven=True))
    point = _evaluate(geometry, rng.uniform(0, 9, COUNT), rng.uniform(0, 9, COUNT), seed % 2 == 0)
    normal, tangent = point.normal.numpy(), point.tangent.numpy()
    assert np.abs((normal * tangent).sum(axis=0)).max() < 1e-9
    assert np.abs(np.linalg.norm(normal, axis=0) - 1).max() < 1e-9
    assert np.abs(np.linalg.norm(tangent, axis=0) - 1).max() < 1e-9
    assert (normal[2] > 0).all()


def test_published_normal_and_tangent_on_the_crown() -> None:
    # On top, at height scale 1, n and t are the published ones of angles u and v (Irawan and Marschner 2012).
    geometry = YarnGeometry(even_layout(TWILL, height_scale=1, twist=-30))
    rng = np.random.default_rng(0)
    x, y = rng.uniform(0, 1.6, COUNT), rng.uniform(0, 1.6, COUNT)
    point = _evaluate(geometry, x, y, False)
    n_x, n_y, n_z = point.normal.numpy()
    v = np.arcsin(n_x)
    u = np.arctan2(n_y, n_z)
    psi = math.radians(-30)
    expected = np.stack(
        [
            -np.cos(v) * math.sin(psi),
            np.cos(u) * math.cos(psi) + np.sin(u) * np.sin(v) * math.sin(psi),
            -np.sin(u) * math.cos(psi) + np.cos(u) * np.sin(v) * math.sin(psi),
        ]
    )
    # Away from the dive only: inside the outline of the pick that each end crosses.
    pick_across = np.abs((y % 0.4) - 0.2)
    warp = point.is_warp.numpy() & ~point.hole.numpy() & (pick_across < 0.16)
    assert warp.sum() > COUNT / 4
    assert np.abs(expected - point.tangent.numpy())[:, warp].max() < 1e-6


@pytest.mark.parametrize("seed", range(40))
def test_no_thread_below_stands_above_the_edge_on_top(seed: int) -> None:
    rng = np.random.default_rng(1000 + seed)
    layout = random_layout(rng, uneven=seed % 2 == 1)
    geometry = YarnGeometry(layout)
    tolerance = 1e-6  # mm, ten times the distance of the two points from the edge
    for is_warp, family, extent in (
        (True, layout.warp, geometry.size[1]),
        (False, layout.weft, geometry.size[0]),
    ):
        thread = rng.integers(0, family.spacing.size, COUNT)
        centre = np.cumsum(family.spacing) - family.spacing / 2
        half_width = np.minimum(family.width, (1 - MIN_GAP) * family.spacing) / 2
        side = rng.choice([-1, 1], COUNT)
        edge = centre[thread] + side * half_width[thread]
        along = rng.uniform(0, extent, COUNT)
        places = [edge - side * STEP, edge + side * STEP]
        inside, outside = (
            _evaluate(geometry, *((place, along) if is_warp else (along, place)), seed % 3 == 0)
            for place in places
        )
        stands = ~inside.hole.numpy() & (inside.is_warp.numpy() == is_warp)
        meets = stands & ~outside.hole.numpy() & (outside.is_warp.numpy() != is_warp)
        step = (outside.height - inside.height).numpy()[meets]
        assert step.size == 0 or step.max() < tolerance


@pytest.mark.parametrize("draft", [PLAIN, TWILL, SATIN])
def test_height_is_continuous_along_every_thread(draft: np.ndarray) -> None:
    geometry = YarnGeometry(even_layout(draft, inclination=40))
    y = np.linspace(0, geometry.size[1], 400_001)
    rng = np.random.default_rng(3)
    for end in range(draft.shape[1]):
        for across in rng.uniform(-0.15, 0.15, 3):
            point = _evaluate(geometry, np.full_like(y, 0.4 * end + 0.2 + across), y, False)
            seen = point.is_warp.numpy() & ~point.hole.numpy()
            jump = np.abs(np.diff(point.height.numpy()))[seen[1:] & seen[:-1]]
            # The steepest slope is below 10, the step 4e-6 mm.
            assert jump.max() < 1e-4


def test_repeats_are_alike_and_holes_have_the_area_of_the_gaps() -> None:
    geometry = YarnGeometry(even_layout(TWILL, gap=0.3))
    rng = np.random.default_rng(5)
    x, y = rng.uniform(0, 1.6, 400_000), rng.uniform(0, 1.6, 400_000)
    here = _evaluate(geometry, x, y, False)
    there = _evaluate(geometry, x + 3 * 1.6, y - 5 * 1.6, False)
    same = _same_yarn(here, there)
    assert np.abs((here.height - there.height).numpy())[same].max() < 1e-9
    share = here.hole.numpy().mean()
    deviation = math.sqrt(0.09 * 0.91 / 400_000)
    assert abs(share - 0.09) < 4 * deviation


def test_back_face_is_the_front_of_the_turned_cloth() -> None:
    # Turning the cloth about the warp direction mirrors the draft and swaps over and under.
    layout = even_layout(TWILL, twist=-30)
    turned = ClothLayout(~layout.warp_on_top[:, ::-1], layout.warp, layout.weft)
    rng = np.random.default_rng(7)
    x, y = rng.uniform(0, 1.6, COUNT), rng.uniform(0, 1.6, COUNT)
    behind = _evaluate(YarnGeometry(layout), x, y, True)
    front = _evaluate(YarnGeometry(turned), 1.6 - x, y, False)
    seen = ~behind.hole.numpy()
    assert (behind.is_warp.numpy() == front.is_warp.numpy())[seen].all()
    assert np.abs((behind.height - front.height).numpy())[seen].max() < 1e-9
    mirrored = np.array([[-1.0], [1.0], [1.0]])
    assert np.abs(behind.normal.numpy() - mirrored * front.normal.numpy())[:, seen].max() < 1e-9
    fibres = mirrored * front.tangent.numpy()
    assert np.abs(np.abs((behind.tangent.numpy() * fibres).sum(axis=0)) - 1)[seen].max() < 1e-9


def test_single_precision_agrees_with_double() -> None:
    rng = np.random.default_rng(8)
    geometry = YarnGeometry(random_layout(rng, uneven=True))
    x, y = (rng.uniform(0, 3, COUNT).astype(np.float32) for _ in range(2))
    single = geometry.surface(Float(x), Float(y), dr.full(Bool, False, COUNT))
    double = _evaluate(geometry, x.astype(np.float64), y.astype(np.float64), False)
    same = _same_yarn(double, single)
    assert same.mean() > 0.5
    error = np.abs(single.height.numpy() - double.height.numpy())[same]
    # float32 positions of some mm carry 2e-7 mm, slopes reach 12.
    assert np.quantile(error, 0.999) < 1e-5


def test_height_scale_has_gradients() -> None:
    geometry = YarnGeometry(even_layout(TWILL))
    rng = np.random.default_rng(9)
    x, y = Float64(rng.uniform(0, 1.6, 2000)), Float64(rng.uniform(0, 1.6, 2000))
    back = dr.full(Bool, False, 2000)
    scale = Float64(0.8)
    dr.enable_grad(scale)
    geometry.height_scale = (scale, scale)
    height, hole = geometry.height(x, y, back)
    dr.forward(scale)
    gradient = dr.grad(height).numpy()
    levels = []
    for nudged in (0.8 - 1e-5, 0.8 + 1e-5):
        geometry.height_scale = (nudged, nudged)
        levels.append(geometry.height(x, y, back)[0].numpy())
    expected = (levels[1] - levels[0]) / 2e-5
    seen = ~hole.numpy()
    assert np.abs(gradient - expected)[seen].max() < 1e-6


@pytest.mark.parametrize(
    ("field", "value"),
    [("inclination", math.radians(81)), ("twist", math.nan), ("height_scale", 3.0), ("height_scale", -1.0)],
)
def test_a_family_out_of_range_is_refused(field: str, value: float) -> None:
    fields = {"inclination": 0.3, "twist": 0.0, "height_scale": 1.0, field: value}
    with pytest.raises(InputError, match=field):
        FamilyLayout(np.ones(2), np.ones(2), **fields)


@pytest.mark.parametrize("seed", range(4))
def test_open_area_is_the_share_of_holes(seed: int) -> None:
    rng = np.random.default_rng(seed)
    layout = random_layout(rng, uneven=seed % 2 == 1)
    width, height = layout.size
    row, column = np.divmod(np.arange(500 * 500), 500)
    x, y = (np.stack([column, row]) + rng.random((2, 500 * 500))) / 500 * np.array([[width], [height]])
    holes = _evaluate(YarnGeometry(layout), x, y, False).hole.numpy().mean()
    # Jittered points: less than the 4.5 deviations of random ones.
    assert holes == pytest.approx(layout.open_area, abs=4.5 * math.sqrt(0.25 / 500**2))
    tight = even_layout(PLAIN, gap=0.0)
    assert tight.open_area == pytest.approx(MIN_GAP**2)
