"""The conversions of footprints, against the moments of points drawn from them."""

from __future__ import annotations

import math

import drjit as dr
import numpy as np
from drjit.llvm.ad import Array2f64, Float64

from loomlight.core.footprint import ANISOTROPIC_TAPS, Box, Footprint, box_footprint
from loomlight.core.llvm import require_llvm

require_llvm()


def _random(rng: np.random.Generator, count: int) -> Footprint:
    def pairs() -> Array2f64:
        return Array2f64(rng.normal(size=(2, count)))

    return Footprint(pairs(), pairs(), pairs())


def test_areas_are_those_of_the_parallelograms() -> None:
    footprint = _random(np.random.default_rng(0), 200)
    corners = [
        footprint.at(Float64(s), Float64(t)).numpy()
        for s, t in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))
    ]
    shoelace = sum(
        corners[k][0] * corners[(k + 1) % 4][1] - corners[k][1] * corners[(k + 1) % 4][0] for k in range(4)
    )
    np.testing.assert_allclose(footprint.area.numpy(), np.abs(shoelace) / 2, rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(footprint.square_side.numpy() ** 2, footprint.area.numpy(), rtol=1e-12)
    assert (footprint.spread_side.numpy() >= footprint.square_side.numpy() * (1 - 1e-12)).all()


def test_boxes_keep_the_variances_and_leave_the_correlation_out() -> None:
    rng = np.random.default_rng(1)
    footprint = _random(rng, 1)
    count = 400_000
    s, t = (Float64(rng.random(count) - 0.5) for _ in range(2))
    points = footprint.at(s, t).numpy()
    box = footprint.box()
    # The variance of a sample variance is below 2/n of a normal's: four deviations are 0.9 %.
    np.testing.assert_allclose(12 * points.var(axis=1), box.size.numpy()[:, 0] ** 2, rtol=0.009)
    spread = 2 * footprint.spread_side.numpy() ** 2
    np.testing.assert_allclose(12 * points.var(axis=1).sum(), spread, rtol=0.009)
    correlation = float(footprint.box_correlation()[0])
    assert abs(np.corrcoef(points)[0, 1] - correlation) < 4 / math.sqrt(count)
    share = footprint.area.numpy() / np.prod(box.size.numpy(), axis=0)
    np.testing.assert_allclose(share, math.sqrt(1 - correlation**2), rtol=1e-9)


def test_boxes_come_back_from_footprints() -> None:
    rng = np.random.default_rng(4)
    box = Box(Array2f64(rng.normal(size=(2, 20))), Array2f64(rng.random((2, 20))))
    footprint = box_footprint(box)
    np.testing.assert_allclose(footprint.box().size.numpy(), box.size.numpy(), rtol=1e-12)
    assert dr.all(footprint.box_correlation() == 0)
    np.testing.assert_allclose(footprint.area.numpy(), np.prod(box.size.numpy(), axis=0), rtol=1e-12)


def test_a_turned_square_keeps_what_is_said_of_it() -> None:
    side = 2**-0.5
    edges = (Array2f64(side, side), Array2f64(-side, side))
    footprint = Footprint(Array2f64(0, 0), *edges)
    np.testing.assert_allclose(footprint.box().size.numpy(), 1, rtol=1e-12)
    rng = np.random.default_rng(5)
    points = footprint.at(Float64(rng.random(100_000) - 0.5), Float64(rng.random(100_000) - 0.5)).numpy()
    inside = (np.abs(points) <= 0.5).all(axis=0).mean()
    assert abs(inside - (2 * math.sqrt(2) - 2)) < 0.005


def test_rows_of_squares_have_the_footprints_variances() -> None:
    rng, count = np.random.default_rng(11), 4000
    first, second = rng.normal(size=(2, 2, count))
    second *= np.exp(rng.uniform(-4, 0, count))
    side, step = Footprint(Array2f64(0), Array2f64(first), Array2f64(second)).anisotropic_taps()
    side, step = side.numpy(), step.numpy()
    outer = "in,jn->nij"
    # Twelve times the covariances; middles of four squares a step apart have 15 times its square.
    expected = np.einsum(outer, first, first) + np.einsum(outer, second, second)
    actual = side[:, None, None] ** 2 * np.eye(2) + (ANISOTROPIC_TAPS**2 - 1) * np.einsum(outer, step, step)
    short, long = np.linalg.eigvalsh(expected).T
    ratio = np.sqrt(long / np.maximum(short, 1e-12))
    alike = ratio < 1.2
    assert alike.any()
    np.testing.assert_array_equal(step[:, alike], 0)
    # The variance across the row errs by a quarter of the squared width; taps of longer footprints are wider.
    exact = ratio < ANISOTROPIC_TAPS
    np.testing.assert_allclose(np.trace(actual[exact], axis1=1, axis2=2), (short + long)[exact], rtol=1e-5)
    assert (np.abs(actual - expected).max((1, 2)) < 0.28 * short + 0.08 * long).all()
