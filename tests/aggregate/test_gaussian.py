"""Gaussian footprints: by Fourier transform, by separable weights, and by sums over texels."""

from __future__ import annotations

import numpy as np
import pytest

from loomlight.aggregate.gaussian import gaussian_field, gaussian_means, texel_weights
from loomlight.aggregate.grid import Grid

COLUMNS, ROWS = 24, 17
GRID = Grid(-0.3, 0.2, 2.4, 3.4, COLUMNS, ROWS, periodic=True)
VALUES = np.random.default_rng(0).random((3, ROWS, COLUMNS))
SIGMAS = [0.003, 0.08, 0.3, 1.0, 4.0, 30.0]


def _summed(centre: np.ndarray, sigma: float) -> np.ndarray:
    """Gaussian mean by brute force: 24 points a texel each way, weighted by the density itself."""
    fine, repeats = 24, 1 + int(np.ceil(8 * sigma / min(GRID.width, GRID.height)))
    step = np.array(GRID.step) / fine

    def weights(low: float, extent: float, count: int, middle: float, step: float) -> np.ndarray:
        points = low - repeats * extent + (np.arange((2 * repeats + 1) * count * fine) + 0.5) * step
        density = np.exp(-0.5 * ((points - middle) / sigma) ** 2)
        shares = density.reshape(2 * repeats + 1, count, fine).sum(axis=(0, 2))
        return shares / shares.sum()

    across = weights(GRID.left, GRID.width, COLUMNS, centre[0], step[0])
    along = weights(GRID.bottom, GRID.height, ROWS, centre[1], step[1])
    return np.einsum("r,c,krc->k", along, across, VALUES)


@pytest.mark.parametrize("sigma", SIGMAS[1:4])
def test_means_are_those_of_the_density(sigma: float) -> None:
    rng = np.random.default_rng(1)
    centres = rng.uniform(-5, 5, (20, 2))
    # Within half a repeat of the grid, so that the brute force reaches far enough.
    centres = np.array([GRID.left, GRID.bottom]) + (centres % [GRID.width, GRID.height])
    means = gaussian_means(GRID, VALUES, centres, np.array(sigma))
    for centre, mean in zip(centres, means, strict=True):
        # The midpoint rule on pieces of a Gaussian: below 1e-3 at 24 points a texel and σ of 0.4 texels.
        np.testing.assert_allclose(mean, _summed(centre, sigma), rtol=1e-3)


@pytest.mark.parametrize("sigma", SIGMAS)
def test_the_transform_gives_the_same_about_texels(sigma: float) -> None:
    row, column = np.meshgrid(np.arange(ROWS), np.arange(COLUMNS), indexing="ij")
    step_x, step_y = GRID.step
    centres = np.stack(
        [GRID.left + (column.ravel() + 0.5) * step_x, GRID.bottom + (row.ravel() + 0.5) * step_y], 1
    )
    means = gaussian_means(GRID, VALUES, centres, np.array(sigma)).T.reshape(VALUES.shape)
    np.testing.assert_allclose(gaussian_field(GRID, VALUES, sigma), means, rtol=1e-10)


def test_narrow_ones_are_their_texel_and_wide_ones_the_mean() -> None:
    np.testing.assert_allclose(gaussian_field(GRID, VALUES, 0.0), VALUES, atol=1e-14)
    wide = gaussian_field(GRID, VALUES, 30.0)
    np.testing.assert_allclose(
        wide, np.broadcast_to(VALUES.mean((1, 2), keepdims=True), wide.shape), rtol=1e-9
    )


def test_means_do_not_depend_on_the_repeat() -> None:
    centres = np.array([[0.7, 1.1]])
    moved = centres + np.array([-3 * GRID.width, 8 * GRID.height])
    sigma = np.array([0.4])
    np.testing.assert_allclose(
        gaussian_means(GRID, VALUES, moved, sigma), gaussian_means(GRID, VALUES, centres, sigma), rtol=1e-9
    )


def test_weights_add_up() -> None:
    rng = np.random.default_rng(2)
    weights = texel_weights(rng.uniform(-50, 50, 40), np.geomspace(1e-3, 200, 40), COLUMNS)
    np.testing.assert_allclose(weights.sum(axis=1), 1, rtol=1e-12)
    assert (weights >= 0).all()
