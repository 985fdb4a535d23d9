"""A chi-square test of sampled directions on the sphere, for densities that a footprint has."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.stats import chi2

ROWS, COLUMNS = 16, 24
_POINTS = 8
_MIN = 5.0  # cells that expect fewer directions are pooled, or the statistic is not chi-square's

Density = Callable[[NDArray[np.float64]], NDArray[np.float64]]


def cell_shares(density: Density, points: int = _POINTS) -> NDArray[np.float64]:
    """Integrals of a density over cells of equal solid angle [ROWS · COLUMNS].

    Args:
        density: from unit vectors [n, 3] to 1/sr [n].
        points: of the Gauss rule along each side of a cell.
    """
    nodes, weights = np.polynomial.legendre.leggauss(points)
    place, weight = (nodes + 1) / 2, weights / 2
    z = -1 + 2 * (np.arange(ROWS)[:, None] + place).ravel() / ROWS
    azimuth = 2 * math.pi * (np.arange(COLUMNS)[:, None] + place).ravel() / COLUMNS
    z, azimuth = (grid.ravel() for grid in np.meshgrid(z, azimuth, indexing="ij"))
    radius = np.sqrt(1 - z**2)
    actual = density(np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), z], axis=1))
    cells = actual.astype(np.float64).reshape(ROWS, points, COLUMNS, points)
    area = 4 * math.pi / (ROWS * COLUMNS)
    return np.einsum("rpcq,p,q->rc", cells, weight, weight).ravel() * area


def cell_counts(
    directions: NDArray[np.float64],
    shape: tuple[int, int] = (ROWS, COLUMNS),
    weights: NDArray[np.float64] | None = None,
) -> NDArray[Any]:
    """How many unit vectors [n, 3] fall into each cell, or the sum of their weights there.

    Args:
        shape: rows and columns of cells of equal solid angle.
    """
    rows, columns = shape
    row = np.clip(((directions[:, 2] + 1) / 2 * rows).astype(int), 0, rows - 1)
    turn = np.arctan2(directions[:, 1], directions[:, 0]) / (2 * math.pi) % 1
    column = np.clip((turn * columns).astype(int), 0, columns - 1)
    return np.bincount(row * columns + column, weights, rows * columns)


def p_value(counts: NDArray[np.int64], expected: NDArray[np.float64]) -> float:
    """Probability of counts so far from `expected`, or farther, were they drawn with it."""
    order = np.argsort(expected)
    counts, expected = counts[order], expected[order]
    pooled = int(np.searchsorted(np.cumsum(expected), _MIN * max(1.0, expected.sum() * 1e-4)))
    pooled = max(pooled, int((expected < _MIN).sum()))
    counts = np.append(counts[pooled:], counts[:pooled].sum())
    expected = np.append(expected[pooled:], expected[:pooled].sum())
    used = expected > _MIN
    if counts[~used].sum() > 20 + 5 * expected[~used].sum():
        return 0.0  # directions where there should be none
    statistic = ((counts[used] - expected[used]) ** 2 / expected[used]).sum()
    return float(chi2.sf(statistic, max(1, int(used.sum()) - 1)))
