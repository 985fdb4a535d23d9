"""Optimizes the offsets of `models/lobes/point_sampled.py`: a progressive point set in a square cut by lines.

    python -m tools.fits.near_points [--seconds 100] [--seed 1]

For each of many lines the area of the square on one side is estimated by the first points, for numbers of
points from 1 to 8 in quarters, the last point weighted by its fraction. The objective is the mean, over these
numbers, of the root mean square error relative to that of the plastic-number sequence (Roberts 2018). Lines
are slightly soft, so that the objective has gradients. The best of many starts is returned.
"""

from __future__ import annotations

import json
import time
from argparse import ArgumentParser, Namespace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

COUNT, LINES, SOFTNESS = 8, 1500, 0.04
NUMBERS = np.arange(1, COUNT + 0.01, 0.25)
_GRID, _TURNS = 64, 40

Floats = NDArray[np.float64]


class Lines:
    """Lines that cut the square of side 1 around the origin."""

    def __init__(self, rng: np.random.Generator) -> None:
        angle = rng.uniform(0, 2 * np.pi, LINES)
        self._normal = np.stack([np.cos(angle), np.sin(angle)])
        # Uniform over all lines that cut the square.
        self._half_width = 0.5 * np.abs(self._normal).sum(0)
        self._offset = rng.uniform(-1, 1, LINES) * self._half_width
        middles = (np.arange(_GRID) + 0.5) / _GRID - 0.5
        across, along = np.meshgrid(middles, middles)
        self._fraction = self._weight_beyond(np.stack([across.ravel(), along.ravel()], 1)).mean(0)

    def errors(self, points: Floats) -> Floats:
        """Root mean square errors of the first of some points [COUNT, 2], for all `NUMBERS`."""
        weights_beyond = self._weight_beyond(points)
        weights = np.clip(NUMBERS[:, None] - np.arange(COUNT), 0, 1) / NUMBERS[:, None]
        return np.asarray(
            np.sqrt(np.average((weights @ weights_beyond - self._fraction) ** 2, 1, self._half_width))
        )

    def _weight_beyond(self, points: Floats) -> Floats:
        return 1 / (1 + np.exp((self._offset - points @ self._normal) / SOFTNESS))


def plastic() -> Floats:
    """Points of the plastic-number sequence, the first at the centre."""
    fractions = np.arange(COUNT)[:, None] * np.array([0.7548776662466927, 0.5698402909980532])
    return (fractions + 0.5) % 1 - 0.5


def measure(options: Namespace) -> dict[str, Any]:
    """The best points, and their errors by the number of points."""
    lines, rng = Lines(np.random.default_rng(0)), np.random.default_rng(options.seed)
    plastic_errors = lines.errors(plastic())

    def points_of(numbers: Floats) -> Floats:
        return np.vstack([np.zeros((1, 2)), numbers.reshape(-1, 2)])

    def ratio(numbers: Floats) -> float:
        return float((lines.errors(points_of(numbers)) / plastic_errors).mean())

    best, least = plastic(), 1.0
    end = time.monotonic() + options.seconds
    while time.monotonic() < end:
        start = rng.uniform(-0.45, 0.45, 2 * (COUNT - 1))
        bounds = [(-0.5, 0.5)] * start.size
        solution = minimize(ratio, start, method="L-BFGS-B", bounds=bounds, options={"maxiter": _TURNS})
        if solution.fun < least:
            best, least = points_of(solution.x), solution.fun
    return {
        "share_of_the_plastic_numbers_error": round(float(least), 3),
        "places": best.round(4).tolist(),
        "errors": dict(zip(NUMBERS.tolist(), lines.errors(best).round(4).tolist(), strict=True)),
        "errors_of_the_plastic_number": dict(
            zip(NUMBERS.tolist(), plastic_errors.round(4).tolist(), strict=True)
        ),
    }


def main() -> None:
    """Prints the figures as JSON."""
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=100.0)
    parser.add_argument("--seed", type=int, default=1)
    print(json.dumps(measure(parser.parse_args()), indent=2))


if __name__ == "__main__":
    main()
