"""Means over boxes from summed-area tables, against sums written out."""

from __future__ import annotations

import numpy as np
import pytest
from drjit.llvm.ad import Float, Float64, UInt32
from hypothesis import given, settings
from hypothesis import strategies as st

from loomlight.aggregate.tables import Grid, box_means, summed_areas, texel_boxes
from loomlight.core.llvm import require_llvm

require_llvm()

COLUMNS, ROWS = 7, 5
GRID = Grid(-0.3, 0.2, 1.4, 0.5, COLUMNS, ROWS)
VALUES = np.random.default_rng(0).random((ROWS, COLUMNS))
TABLE = summed_areas(Float64(VALUES.ravel()), COLUMNS, ROWS)


def _means(centres: np.ndarray, sizes: np.ndarray, grid: Grid = GRID) -> np.ndarray:
    boxes = texel_boxes(grid, centres, sizes, Float)
    return box_means(TABLE, UInt32(0), grid, boxes).numpy()


def _overlaps(low: float, high: float, count: int) -> np.ndarray:
    """Length of [low, high], in texels, that each texel of a periodic row takes up."""
    cells = np.arange(np.floor(low) - 1, np.ceil(high) + 1)
    lengths = np.clip(np.minimum(cells + 1, high) - np.maximum(cells, low), 0, None)
    total = np.zeros(count)
    np.add.at(total, cells.astype(int) % count, lengths)
    return total


def test_tables_are_sums_from_the_corner() -> None:
    values = np.random.default_rng(1).random((3, ROWS, COLUMNS))
    tables = summed_areas(Float64(values.ravel()), COLUMNS, ROWS).numpy().reshape(3, ROWS + 1, COLUMNS + 1)
    np.testing.assert_allclose(tables[:, 1:, 1:], values.cumsum(axis=1).cumsum(axis=2), rtol=1e-14)
    assert not tables[:, 0].any()
    assert not tables[:, :, 0].any()


coordinates = st.floats(-40, 40, allow_nan=False)
extents = st.floats(1e-3, 30, allow_nan=False)


@settings(max_examples=200, deadline=None)
@given(x=coordinates, y=coordinates, width=extents, height=extents)
def test_any_box_anywhere_is_the_mean_of_its_texels(x: float, y: float, width: float, height: float) -> None:
    step = np.array(GRID.step)
    size = np.maximum([width, height], 1e-2 * step)
    low = ([x, y] - size / 2 - [GRID.left, GRID.bottom]) / step
    high = ([x, y] + size / 2 - [GRID.left, GRID.bottom]) / step
    weights = np.outer(_overlaps(low[1], high[1], ROWS), _overlaps(low[0], high[0], COLUMNS))
    expected = (weights * VALUES).sum() / weights.sum()
    # Far from the origin the bounds of a box of 1e-2 texels carry 1e-14 / 1e-2 of rounding.
    assert _means(np.array([[x, y]]), np.array([[width, height]]))[0] == pytest.approx(expected, rel=1e-9)


@settings(max_examples=50, deadline=None)
@given(x=coordinates, y=coordinates, width=extents, turns=st.integers(-9, 9))
def test_repeats_do_not_matter(x: float, y: float, width: float, turns: int) -> None:
    centre, size = np.array([[x, y]]), np.array([[width, 0.3 * width]])
    moved = centre + turns * np.array([GRID.width, GRID.height])
    assert _means(moved, size)[0] == pytest.approx(_means(centre, size)[0], rel=1e-8)


@settings(max_examples=50, deadline=None)
@given(x=coordinates, y=coordinates, across=st.integers(1, 5), along=st.integers(1, 5))
def test_whole_repeats_have_the_mean_of_all(x: float, y: float, across: int, along: int) -> None:
    size = np.array([[across * GRID.width, along * GRID.height]])
    assert _means(np.array([[x, y]]), size)[0] == pytest.approx(VALUES.mean(), rel=1e-10)


@settings(max_examples=50, deadline=None)
@given(x=coordinates, y=coordinates, width=extents, height=extents, share=st.floats(0.1, 0.9))
def test_a_box_is_what_its_parts_are(x: float, y: float, width: float, height: float, share: float) -> None:
    size = np.array([[width, height]]) + 1
    part, rest = size * [share, 1], size * [1 - share, 1]
    left = np.array([[x, y]]) - size / 2
    parts = share * _means(left + part / 2, part) + (1 - share) * _means(
        left + [[share * size[0, 0], 0]] + rest / 2, rest
    )
    assert _means(np.array([[x, y]]), size)[0] == pytest.approx(parts[0], rel=1e-8)


def test_points_read_their_texel() -> None:
    grid_y, grid_x = np.meshgrid(np.arange(ROWS), np.arange(COLUMNS), indexing="ij")
    step_x, step_y = GRID.step
    x, y = GRID.left + (grid_x + 0.3) * step_x, GRID.bottom + (grid_y + 0.8) * step_y
    means = _means(np.stack([x.ravel(), y.ravel()], 1), np.zeros((x.size, 2)))
    np.testing.assert_allclose(means, VALUES.ravel(), rtol=1e-9)
