"""How much of each group a footprint holds: the pyramid against sums over a fine map of the groups."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Bool, Float
from numpy.typing import NDArray

from loomlight.core.backend import array_types
from loomlight.core.footprint import Footprint
from loomlight.models.lobes.coverage import CoverageLookup, CoveragePyramid
from loomlight.models.lobes.groups import Groups, NearestGroup
from loomlight.models.lobes.hemisphere import byte_of_group, pack_count
from loomlight.models.lobes.rays import SurfaceHits
from loomlight.yarn.geometry import YarnGeometry
from tests.helpers.arrays import floats
from tests.helpers.fabrics import STRESSING

from .cloths import askew, geometry_of, pyramid_of

TYPES = array_types(Float)
PER_FAMILY = 8
ANISOTROPIC_TAPS = 150
# Points along each side of a square that is counted out.
POINTS = 48
# Largest mean error by size in units of s_0, half the sum over groups of |error|. Close, tents stand for
# squares, which blurs their edges; far away, where every footprint holds all, a plan of twelve rays across a
# thread is what errs.
ERRORS = {1.0: 0.15, 1.41: 0.16, 2.0: 0.14, 2.83: 0.10, 4.0: 0.08, 8.0: 0.045, 23.0: 0.045}
# The same of parallelograms up to thrice as long as wide: squares are too large still at 1. Squares along the
# threads in their place err by up to 0.19 at 2 and 0.137 at 2.83. At 1.41 open cloth errs by 0.172, as
# groups of what views meet are smaller on its plan. At 2.83 satin, whose warp has twelve groups, errs by
# 0.1025.
ERRORS_ASKEW = {1.41: 0.18, 2.0: 0.14, 2.83: 0.105, 4.0: 0.08, 8.0: 0.045}


@cache
def _made(name: str) -> tuple[YarnGeometry, Groups, CoveragePyramid]:
    geometry = geometry_of(name)
    return geometry, *pyramid_of(geometry, PER_FAMILY)


def _edges_of(sizes: NDArray[Any], shapes: NDArray[Any] | None) -> NDArray[np.float64]:
    """Edges [n, 2, 2] of footprints of so many sizes: squares if no shapes are given."""
    return np.asarray(sizes[:, None, None] * (np.eye(2) if shapes is None else shapes))


def _by_lookup(
    name: str, back: bool, centres: NDArray[Any], sizes: NDArray[Any], shapes: NDArray[Any] | None = None
) -> NDArray[np.float64]:
    """Coverage of groups and holes in footprints, by the pyramid [n, 2 K + 1]."""
    geometry, _, coverage = _made(name)
    table = CoverageLookup(coverage.base_size, coverage.levels, coverage.bytes, geometry.size, TYPES)
    edges = _edges_of(sizes, shapes)
    parts = centres, edges[:, 0], edges[:, 1]
    footprint = Footprint(*(Array2f(np.ascontiguousarray(part.T, np.float32)) for part in parts))
    taps = table.taps(footprint, Bool(back))
    packs = [pack for pair in range(table.pack_pairs) for pack in table.groups(taps, TYPES.UInt32(pair))]
    values = np.stack([byte.numpy() for pack in packs for byte in pack] + [table.holes(taps).numpy()], axis=1)
    places = np.append(byte_of_group(PER_FAMILY), 4 * pack_count(PER_FAMILY))
    return values[:, places] * coverage.scale[int(back), places] / 255


def _by_counting(
    name: str, back: bool, centres: NDArray[Any], sizes: NDArray[Any], shapes: NDArray[Any] | None = None
) -> NDArray[np.float64]:
    """The same by looking at POINTS² jittered points of every footprint."""
    geometry, groups, _ = _made(name)
    rng = np.random.default_rng(9)
    row, column = np.divmod(np.arange(POINTS * POINTS), POINTS)
    places = (np.stack([column, row], axis=1) + rng.random((len(sizes), POINTS * POINTS, 2))) / POINTS - 0.5
    x, y = (centres[:, None] + places @ _edges_of(sizes, shapes)).reshape(-1, 2).T
    point = geometry.surface(floats(x), floats(y), Bool(back))
    nearest = NearestGroup(groups, TYPES)
    group_of = nearest.find(Bool(back), SurfaceHits.of(point, point.hole)).numpy()
    shows = group_of.reshape(len(sizes), -1)
    return np.stack([(shows == group).mean(axis=1) for group in range(groups.count + 1)], axis=1)


def _squares(name: str, relative: float, seed: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Centres anywhere [n, 2], and sides of one size [n], millimetres."""
    geometry, _, coverage = _made(name)
    centres = np.random.default_rng(seed).uniform(-1, 2, (ANISOTROPIC_TAPS, 2)) * geometry.size
    return centres, np.full(ANISOTROPIC_TAPS, relative * coverage.base_size)


@pytest.mark.quick("long rib-1.0")
@pytest.mark.parametrize("relative", ERRORS)
@pytest.mark.parametrize("name", STRESSING)
def test_means_are_those_of_squares(name: str, relative: float) -> None:
    for back in (False, True):
        centres, sizes = _squares(name, relative, 1)
        actual, expected = (of(name, back, centres, sizes) for of in (_by_lookup, _by_counting))
        error = np.abs(actual - expected).sum(axis=1) / 2
        assert error.mean() < ERRORS[relative], (back, error.mean())
        # Of all squares together nothing is lost: every group as much as the repeat holds.
        assert np.abs(actual.mean(axis=0) - expected.mean(axis=0)).max() < 0.03


@pytest.mark.parametrize("relative", ERRORS_ASKEW)
@pytest.mark.parametrize("name", STRESSING)
def test_means_are_those_of_footprints_askew(name: str, relative: float) -> None:
    for back in (False, True):
        centres, sizes = _squares(name, relative, 6)
        shapes = askew(np.random.default_rng(7), len(sizes))
        actual, expected = (of(name, back, centres, sizes, shapes) for of in (_by_lookup, _by_counting))
        assert (np.abs(actual - expected).sum(axis=1) / 2).mean() < ERRORS_ASKEW[relative], back


def test_any_corner_of_a_footprint_may_come_first() -> None:
    """Edges turned round or exchanged are those of the same pixel."""
    centres, sizes = _squares("smooth satin", 2.3, 8)
    shapes = askew(np.random.default_rng(9), len(sizes))
    actual = _by_lookup("smooth satin", False, centres, sizes, shapes)
    for others in (-shapes, shapes * [[[1], [-1]]], shapes[:, ::-1]):
        again = _by_lookup("smooth satin", False, centres, sizes, others)
        # The nine squares are the same, but for rounding at the edges of cells.
        assert np.abs(again - actual).sum(axis=1).mean() / 2 < 1e-3


def test_squares_elsewhere_are_another_matter() -> None:
    """The bounds above reject a table read at the wrong position."""
    centres, sizes = _squares("smooth satin", 2.0, 2)
    moved = centres + 1.5 * _made("smooth satin")[2].base_size
    actual = _by_lookup("smooth satin", False, moved, sizes)
    expected = _by_counting("smooth satin", False, centres, sizes)
    assert (np.abs(actual - expected).sum(axis=1) / 2).mean() > 1.4 * ERRORS[2.0]


@pytest.mark.parametrize("name", STRESSING)
def test_shares_sum_to_one(name: str) -> None:
    for relative in (0.3, 1.0, 1.7, 5.0, 40.0):
        for back in (False, True):
            total = _by_lookup(name, back, *_squares(name, relative, 3)).sum(axis=1)
            # Each of 17 bytes is off by half a 255th of the group's largest share.
            np.testing.assert_allclose(total, 1, atol=6e-3)


@pytest.mark.parametrize("name", STRESSING)
def test_coverage_repeats(name: str) -> None:
    width, height = _made(name)[0].size
    for relative in (0.5, 1.3, 3.0, 30.0):
        centres, sizes = _squares(name, relative, 4)
        actual = _by_lookup(name, False, centres, sizes)
        again = _by_lookup(name, False, centres + np.array([3 * width, -2 * height]), sizes)
        # Shares of nodes are whole units: of a lane in some hundred one goes the other way.
        np.testing.assert_allclose(again, actual, atol=8e-3)
        assert (np.abs(again - actual).max(axis=1) < 1e-4).mean() > 0.95


def test_wider_squares_vary_less() -> None:
    """A footprint of many repeats has the coverage of any other: all steps between are monotone."""
    last = np.inf
    for relative in (0.5, 1.0, 1.41, 2.0, 2.83, 4.0, 8.0, 16.0, 64.0):
        varies = _by_lookup("smooth satin", False, *_squares("smooth satin", relative, 5)).std(axis=0).sum()
        assert varies <= last + 1e-3
        last = varies
    assert last < 1e-6
