"""The max-height pyramid against heights of many points, and against windows counted one by one."""

from __future__ import annotations

from itertools import product

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Bool, Float

from loomlight.core.llvm import require_llvm
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.max_heights import PYRAMID_RADII, TILE_CELLS, pack_max_heights
from tests.helpers.layouts import random_layout

require_llvm()


@pytest.mark.parametrize("shape", [(1, 1), (2, 3), (5, 8), (41, 37)])
def test_bounds_are_maxima_of_windows(shape: tuple[int, int]) -> None:
    rng = np.random.default_rng(0)
    picks, ends = shape
    # Few high levels, so that windows of all sizes differ.
    levels = np.where(rng.random((picks, ends, 2)) < 0.01, 15, rng.integers(0, 12, (picks, ends, 2)))
    warp_on_top = rng.random(shape) < 0.5
    words = (levels << 28 | np.stack([warp_on_top, ~warp_on_top], axis=2)).astype(np.uint32)
    max_heights = pack_max_heights(words)
    for row in range(max_heights.shape[0]):
        for column in range(max_heights.shape[1]):
            for (number, radius), up, right in product(enumerate(PYRAMID_RADII), (0, 1), (0, 1)):
                rows, columns = (
                    np.arange(
                        TILE_CELLS * first - (0 if ahead else radius),
                        TILE_CELLS * (first + 1) + (radius if ahead else 0),
                    )
                    % count
                    for first, count, ahead in ((row, picks, up), (column, ends, right))
                )
                window = np.ix_(rows, columns)
                for face, top in enumerate((warp_on_top, ~warp_on_top)):
                    expected = np.where(top, levels[..., 0], levels[..., 1])[window].max()
                    assert (
                        max_heights[row, column, right + 2 * up] >> (8 * number + 4 * face) & 15 == expected
                    )


@pytest.mark.parametrize("seed", range(6))
def test_nothing_rises_above_bounds(seed: int) -> None:
    rng = np.random.default_rng(seed)
    geometry = YarnGeometry(random_layout(rng, uneven=seed % 2 == 0))
    count = 20_000
    x, y = (rng.uniform(-extent, 2 * extent, count) for extent in geometry.size)
    back = Bool(rng.random(count) < 0.5)
    ahead = rng.random((2, count)) < 0.5
    for radius, share in geometry.max_heights(Float(x), Float(y), back, *(Bool(way) for way in ahead)):
        away_x, away_y = (
            np.where(way, 1, -1) * rng.uniform(0, radius, count) * 0.999 * extent
            for way, extent in zip(ahead, geometry.finest, strict=True)
        )
        height, hole = geometry.height(Float(x + away_x), Float(y + away_y), back)
        # Rounding of levels up to 15ths leaves more than that of float32.
        assert dr.all(hole | (height <= share * geometry.height_bounds[1] + 1e-6))
