"""Offsets of point samples have a low error with few points; the regimes blend smoothly.

Covers: models/lobes/point_sampled.py
"""

from __future__ import annotations

from dataclasses import fields, replace

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Float, UInt32

from loomlight.core.backend import array_types
from loomlight.core.footprint import Footprint
from loomlight.fabric import fabric_from_text
from loomlight.models.lobes.model import LobesModel
from loomlight.models.lobes.point_sampled import (
    MAX_POINTS,
    MAX_POINTS_BESIDE_GROUPS,
    RegimeScale,
    _offset,
)
from tests.helpers.directions import directions

from .cloths import FootprintQueries

LINES = 4000


def places() -> np.ndarray:
    """All offsets [n, 2], in units of a footprint's edges."""
    actual = _offset(array_types(Float), UInt32(np.arange(MAX_POINTS, dtype=np.uint32)))
    return np.stack([part.numpy() for part in actual], axis=1)


def test_the_first_point_is_the_middle_and_all_lie_within() -> None:
    actual = places()
    np.testing.assert_array_equal(actual[0], [0, 0])
    assert (np.abs(actual) < 0.5).all()
    assert len(np.unique(actual, axis=0)) == MAX_POINTS


# Errors of `tools/fits/near_points.py`, a tenth added; points by chance have 0.2, 0.14 and 0.1.
@pytest.mark.parametrize(("count", "largest"), [(3, 0.11), (5, 0.055), (8, 0.031)])
def test_few_points_estimate_the_area_beyond_a_line(count: int, largest: float) -> None:
    rng = np.random.default_rng(0)
    angle = rng.uniform(0, 2 * np.pi, LINES)
    normal = np.stack([np.cos(angle), np.sin(angle)])
    reach = 0.5 * np.abs(normal).sum(0)
    offset = rng.uniform(-1, 1, LINES) * reach

    def beyond(points: np.ndarray) -> np.ndarray:
        """Softly, as pixels see edges: over a twelfth of the footprint or so."""
        return np.asarray(1 / (1 + np.exp((offset - points @ normal) / 0.04)))

    middles = (np.arange(64) + 0.5) / 64 - 0.5
    grid = np.stack([axis.ravel() for axis in np.meshgrid(middles, middles)], axis=1)
    error = beyond(places()[:count]).mean(0) - beyond(grid).mean(0)
    assert np.sqrt(np.average(error**2, weights=reach)) < largest


def test_holes_and_values_come_from_the_same_decision() -> None:
    """Open cloth close up: the hole alone is the one that comes with the components, or energy is made."""
    fabric = fabric_from_text('weave = "plain"\ngap = 0.6')
    model, rng, count = LobesModel.for_source(fabric), np.random.default_rng(2), 20_000
    sides = np.exp(rng.uniform(np.log(0.01), np.log(2), count)) * float(fabric.layout().warp.spacing[0])
    centres = rng.random((count, 2)) * np.asarray(fabric.repeat_mm)
    queries = FootprintQueries(
        directions(rng, count, lowest=0.02), directions(rng, count, lowest=0.02), centres, sides
    )
    alone = model.at(queries.view, queries.footprint).hole
    at = model.at(queries.view, queries.footprint)
    components = at.components(queries.light)
    dr.eval(alone, components, at.hole)
    together = at.hole.numpy()
    assert 0.2 < together.mean() < 0.6
    # Two kernels round differently.
    np.testing.assert_allclose(alone.numpy(), together, atol=1e-5)
    closed = together == 1
    assert closed.any()
    for part in fields(components):
        assert getattr(components, part.name).numpy()[closed].max() < 1e-5  # rounding of 1 − hole


def test_regimes_blend_smoothly() -> None:
    """Points alone below 0.7 threads, groups alone above 2, both between."""
    layout = fabric_from_text("plain").layout()
    thread = float(layout.warp.spacing[0])
    sides = thread * np.geomspace(0.02, 4, 200)
    edge = Float(sides.astype(np.float32))
    footprint = Footprint(Array2f(0, 0), Array2f(edge, 0), Array2f(0, edge))
    regime = RegimeScale(layout, 0.1 * thread, array_types(Float)).of(footprint)
    weight, points = regime.prefiltered.numpy(), regime.points.numpy()
    np.testing.assert_allclose(regime.threads.numpy(), sides / thread, rtol=1e-5)
    assert (weight[sides < 0.7 * thread] == 0).all()
    assert (weight[sides > 2.0 * thread] == 1).all()
    assert (np.diff(weight) >= 0).all()
    # Two hundred sizes: no step of more than a few hundredths.
    assert np.diff(weight).max() < 0.06
    assert (points[weight == 1] == 0).all()
    # Few points where groups have nearly all the weight would show as noise of irregular weaves.
    assert (points[(weight > 0) & (weight < 1)] >= MAX_POINTS_BESIDE_GROUPS).all()
    assert (points[weight < 1] >= 1).all()
    shared = RegimeScale(layout, 0.1 * thread, array_types(Float)).of(replace(footprint, samples=MAX_POINTS))
    assert (shared.points.numpy()[weight < 1] == 1).all()
    assert points.max() <= MAX_POINTS
    # Squares of the pyramid that are wider than a thread move the blend to larger footprints.
    coarse = RegimeScale(layout, 10 * thread, array_types(Float)).of(footprint)
    assert (coarse.prefiltered.numpy() == 0).all()
