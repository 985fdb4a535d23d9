"""Quilted cloth: the plate between stitches, its interpolation, and the surfaces that lie on it."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array3f, Bool, Float
from numpy.typing import NDArray

from loomlight.core.backend import array_types
from loomlight.core.llvm import require_llvm
from loomlight.yarn.layout import ClothLayout, Layer, Ties, shared_spacing
from loomlight.yarn.quilt import QuiltRelief, quilted
from loomlight.yarn.rays import REFERENCE_QUALITY
from loomlight.yarn.stack import StackedGeometry
from loomlight.yarn.visibility import first_hit
from tests.helpers.layouts import PLAIN, even_layout

require_llvm()
SPACING = 0.2
WADDING = np.array([False, True, False])


@cache
def quilt(side: int = 16, every: int = 8) -> ClothLayout:
    """Two plain cloths, wadding between; ends behind rise over picks of the face, so many threads apart."""
    whole = even_layout(np.zeros((3 * side, 2 * side), bool), spacing=SPACING)
    ends = [np.arange(0, 2 * side, 2), np.zeros(1, int), np.arange(1, 2 * side, 2)]
    picks = [np.arange(first, 3 * side, 3) for first in range(3)]
    weaves = [np.tile(PLAIN, (side // 2, side // 2)), np.zeros((side, 1), bool)]
    layers = []
    for number, weave in enumerate([*weaves, weaves[0]]):
        across, left = shared_spacing(whole.warp.spacing, ends[number])
        along, bottom = shared_spacing(whole.weft.spacing, picks[number])
        if number == 1:
            across, left = np.array([whole.warp.spacing.sum()]), 0.0
        layers.append(
            Layer(
                ClothLayout(
                    weave,
                    replace(whole.warp, spacing=across, width=across * (1e-5 if number == 1 else 0.8)),
                    replace(whole.weft, spacing=along, width=along * 0.8),
                ),
                ends[number],
                picks[number],
                (left, bottom),
            )
        )
    places = np.zeros((side, side), bool)
    places[::every, every // 2 :: every] = True
    plane = ClothLayout(places, layers[2].layout.warp, layers[0].layout.weft)
    tie = Layer(plane, ends[2], picks[0], (layers[2].start[0], layers[0].start[1]))
    return replace(whole, layers=tuple(layers), ties=(Ties(tie, 2, 0, True, False),))


def _plate(
    columns: int, rows: int, steps: tuple[float, float], pinned: NDArray[np.bool_]
) -> NDArray[np.float64]:
    """∇⁴M = 1 where nothing is pinned to 0, by dense linear algebra [rows, columns]."""
    count = rows * columns
    node = np.arange(count).reshape(rows, columns)
    bending = np.zeros((count, count))
    for axis, step in ((1, steps[0]), (0, steps[1])):
        for side in (-1, 1):
            bending[node.ravel(), np.roll(node, side, axis).ravel()] += 1 / step**2
            bending[node.ravel(), node.ravel()] -= 1 / step**2
    free = ~pinned.ravel()
    height = np.zeros(count)
    height[free] = np.linalg.solve((bending @ bending)[np.ix_(free, free)], np.ones(free.sum()))
    return height.reshape(rows, columns)


def test_the_relief_is_that_of_a_plate_pinned_at_stitches() -> None:
    layout = quilt()
    found = quilted(layout, WADDING)
    assert found is not None
    rows, columns = found.shape
    # Nodes a thread of the finer family of the face apart: 16 ends on 6.4 mm, 16 picks on 9.6 mm.
    assert (columns, rows) == (16, 24)
    steps = layout.size[0] / columns, layout.size[1] / rows
    pinned = np.zeros((rows, columns), bool)
    picks, ends = np.nonzero(layout.ties[0].places)
    # Ends lie every 0.4 mm from 0.3 mm on, picks every 0.6 mm from 0.1 mm on.
    x, y = 0.3 + 0.4 * ends, 0.1 + 0.6 * picks
    pinned[np.rint(y / steps[1]).astype(int) % rows, np.rint(x / steps[0]).astype(int) % columns] = True
    exact = _plate(columns, rows, steps, pinned)
    exact = (exact - exact.max()) / np.ptp(exact)
    # Steps end at 1e-4 of the pressure; nodes are given 2 % of room at either end.
    assert np.abs((found + 0.5) / 0.96 - 0.5 - exact).max() < 2e-3
    assert found.min() >= -1
    assert found.max() <= 0


def test_close_stitches_and_cloth_without_wadding_stay_flat() -> None:
    assert quilted(quilt(every=4), WADDING) is None
    assert quilted(quilt(), np.zeros(3, bool)) is None


def test_interpolation_meets_nodes_and_its_slopes() -> None:
    rng = np.random.default_rng(1)
    nodes = rng.random((6, 9))
    relief = QuiltRelief(nodes, (4.5, 4.2), (0.25, 0.3), array_types(Float(0)))
    rows, columns = np.indices(nodes.shape)
    x, y = columns.ravel() * 0.5 - 9.0, rows.ravel() * 0.7 + 8.4
    # A little off the nodes, so that rounding takes none for the cell before.
    assert np.allclose(relief.at(Float(x + 1e-4), Float(y + 1e-4)).height.numpy(), nodes.ravel(), atol=2e-3)
    x, y = rng.uniform(-5, 5, 4000), rng.uniform(-5, 5, 4000)
    here, step = relief.at(Float(x), Float(y)), 2e-3
    for slope, (right, up) in ((here.slope_x, (step, 0)), (here.slope_y, (0, step))):
        before, after = (relief.at(Float(x + s * right), Float(y + s * up)).height for s in (-1, 1))
        # Slopes of up to 3 are continuous, with a curvature of up to 20 per mm that jumps at nodes.
        assert np.abs(((after - before) / (2 * step) - slope).numpy()).max() < 20 * step


def test_bounds_hold_in_cells_and_windows() -> None:
    rng = np.random.default_rng(4)
    relief = QuiltRelief(rng.random((12, 18)), (9.0, 8.4), (0.25, 0.3), array_types(Float(0)))
    count = 20000
    x, y = (Float(rng.uniform(0, 9, count)) for _ in range(2))
    yes = dr.full(Bool, True, count)
    bounds = relief.bounds(x, y, yes, yes)
    for share in rng.random((8, 2)):
        there = relief.at(x + 0.999 * share[0] * bounds.side_x, y + 0.999 * share[1] * bounds.side_y)
        assert (there.height <= bounds.cell_max + 1e-5).numpy().all()
    tight = (bounds.cell_max - relief.at(x, y).height).numpy()
    assert np.median(tight) < 0.5
    for radius, highest in zip((8, 4, 2, 1), relief.windows(x, y), strict=True):
        for side in rng.uniform(-1, 1, (8, 2)):
            there = relief.at(x + 0.25 * radius * side[0], y + 0.3 * radius * side[1])
            assert (there.height <= highest + 1e-5).numpy().all()


@pytest.mark.parametrize("back", [False, True])
def test_heights_slopes_and_bounds_of_quilted_cloth_agree(back: bool) -> None:
    stack = StackedGeometry(quilt())
    flat = StackedGeometry(replace(quilt(), ties=()))
    rng = np.random.default_rng(2)
    count, step = 20000, 1e-3
    x, y = (Float(rng.uniform(0, length, count)) for length in stack.size)
    face, ahead = dr.full(Bool, back, count), dr.full(Bool, True, count)
    here = stack.probe(x, y, face, ahead, ahead)
    kept = ~here.hole.numpy()
    height = here.height.numpy()
    assert (height <= here.cell_bounds.cell_max.numpy() + 1e-5)[kept].all()
    low, high = stack.height_bounds
    assert (height[kept] >= low).all()
    assert (height[kept] <= high + 1e-5).all()
    for slope, (right, up) in ((here.slope_x, (step, 0)), (here.slope_y, (0, step))):
        before, after = (stack.probe(x + side * right, y + side * up, face, ahead, ahead) for side in (-1, 1))
        same = ((before.yarn == here.yarn) & (after.yarn == here.yarn)).numpy() & kept
        error = dr.abs((after.height - before.height) / (2 * step) - slope).numpy()
        # Curvature jumps where arcs begin and end.
        assert np.mean(error[same] > 0.02) < 0.01
    # Beside its stitches, where nothing dives, the face falls by the wadding's thickness; the back stays.
    picks, ends = np.nonzero(stack.layout.ties[0].places)
    away = [
        np.abs((at.numpy() - centre[:, None] + length / 2) % length - length / 2).min(axis=0)
        for at, centre, length in zip((x, y), (0.3 + 0.4 * ends, 0.1 + 0.6 * picks), stack.size, strict=True)
    ]
    beside = kept & ((away[0] > 0.2) | (away[1] > 0.3))
    moved = (height - flat.probe(x, y, face, ahead, ahead).height.numpy())[beside]
    thickness = 2 * stack.reaches[1]
    if back:
        assert np.median(np.abs(moved)) < 1e-6
    else:
        assert -thickness <= moved.min() < -0.9 * thickness
        assert -0.1 * thickness < moved.max() <= 0


@pytest.mark.slow
def test_rays_meet_the_quilted_surface() -> None:
    """Against marching over its heights in steps of a hundredth of a thread."""
    stack = StackedGeometry(quilt())
    rng = np.random.default_rng(3)
    count, steps = 1000, 800
    low, high = stack.height_bounds
    tilt, turn = np.arccos(rng.uniform(0.5, 1, count)), rng.uniform(0, 2 * math.pi, count)
    view = np.stack([np.sin(tilt) * np.cos(turn), np.sin(tilt) * np.sin(turn), np.cos(tilt)], axis=1)
    place = rng.uniform(0, stack.size[0], (count, 2))
    front = dr.full(Bool, False, count)
    hit = first_hit(
        stack, Float(place[:, 0]), Float(place[:, 1]), Array3f(view.T), front, quality=REFERENCE_QUALITY
    )
    found = np.full(count, np.nan)
    for z in np.linspace(high, low, steps):
        x, y = (place + z * view[:, :2] / view[:, 2:]).T
        height, hole = stack.height(Float(x), Float(y), front)
        below = ~hole.numpy() & (height.numpy() > z) & np.isnan(found)
        found[below] = z
    seen = ~hit.hole.numpy()
    assert np.mean(seen == ~np.isnan(found)) > 0.99
    both = seen & ~np.isnan(found)
    assert np.mean(np.abs(found - hit.height.numpy())[both] < 3 * (high - low) / steps) > 0.98
