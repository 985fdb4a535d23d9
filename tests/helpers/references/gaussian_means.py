"""Means over Gaussian footprints on a periodic grid, exact for values that are constant on each texel.

The weight of a texel is the integral of the Gaussian over it, summed over all repeats: a product of two
differences of error functions, one a direction.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.aggregate.tables import Grid

# Beyond so many standard deviations is 1e-12 of a Gaussian's weight.
_RADIUS = 7.2
# With a standard deviation of so many repeats, weights are uniform to 1e-17: exp(−2π²·1.5²).
_UNIFORM_SIGMA = 1.5
_MIN_SIGMA = 1e-6
_BATCH = 1 << 24
_erf = np.vectorize(math.erf, otypes=[np.float64])


def texel_weights(
    centres: NDArray[np.float64], sigmas: NDArray[np.float64], texels: int
) -> NDArray[np.float64]:
    """Weights [n, texels] of the texels of a row of `texels` for periodic Gaussians; sum 1.

    Args:
        centres, sigmas: [n], in texels; the first texel spans 0 to 1.
    """
    centres = centres % texels
    widths = np.clip(sigmas, _MIN_SIGMA, _UNIFORM_SIGMA * texels)
    repeats = max(1, math.ceil(_RADIUS * float(widths.max(initial=0)) / texels))
    weights = np.zeros((len(centres), texels))
    bounds = np.arange(texels + 1)
    for turn in range(-repeats, repeats + 1):
        offsets = (bounds + turn * texels - centres[:, None]) / (math.sqrt(2) * widths[:, None])
        weights += np.diff(_erf(offsets), axis=1) / 2
    return weights / weights.sum(axis=1, keepdims=True)


def gaussian_means(
    grid: Grid, values: NDArray[np.floating[Any]], centres: NDArray[Any], sigmas: NDArray[Any]
) -> NDArray[np.float64]:
    """Means [n, channels] of values [channels, rows, columns] weighted by Gaussians.

    Args:
        centres: [n, 2] millimetres.
        sigmas: standard deviations [n] or a number, millimetres.
    """
    centres = np.asarray(centres, np.float64)
    sigmas = np.broadcast_to(np.asarray(sigmas, np.float64), (len(centres),))
    step_x, step_y = grid.step
    flat = np.asarray(values, np.float64).transpose(2, 1, 0).reshape(grid.columns, -1)
    means = np.empty((len(centres), len(values)))
    at_once = max(1, _BATCH // flat.shape[1])
    for first in range(0, len(centres), at_once):
        part = slice(first, first + at_once)
        across = texel_weights((centres[part, 0] - grid.left) / step_x, sigmas[part] / step_x, grid.columns)
        along = texel_weights((centres[part, 1] - grid.bottom) / step_y, sigmas[part] / step_y, grid.rows)
        rows = (across @ flat).reshape(-1, grid.rows, len(values))
        means[part] = np.einsum("nr,nrc->nc", along, rows)
    return means
