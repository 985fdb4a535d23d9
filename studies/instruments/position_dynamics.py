"""Cloth as a grid of vertices by extended position-based dynamics (Macklin et al. 2016, small steps: 2019).

Stretch along the threads, soft shear along the diagonals, and bending as second differences.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

# Positions [rows, columns, 3], metres.
Grid = NDArray[np.float64]


@dataclass(frozen=True)
class Cloth:
    """Compliances in metres per newton for unit vertex masses; 0 is rigid."""

    shear: float = 3e-5
    bend: float = 4e-5
    friction: float = 0.35
    drag: float = 1.2  # 1/s


def hold_together(position: Grid, spacing: float, step: float, cloth: Cloth) -> None:
    """Moves vertices so that neighbours are `spacing` apart and bend little, in a step of `step` seconds."""
    for first in (0, 1):
        _pull(position[:, first:-1:2], position[:, first + 1 :: 2], spacing, 0)
        _pull(position[first:-1:2], position[first + 1 :: 2], spacing, 0)
    shear = cloth.shear / step**2
    diagonal = spacing * np.sqrt(2)
    for row in (0, 1):
        for column in (0, 1):
            rows, below = slice(row, -1, 2), slice(row + 1, None, 2)
            columns, right = slice(column, -1, 2), slice(column + 1, None, 2)
            _pull(position[rows, columns], position[below, right], diagonal, shear)
            _pull(position[rows, right], position[below, columns], diagonal, shear)
    # The bending energy of a strip goes with the second difference over its spacing squared.
    bend = cloth.bend / step**2 * (spacing / 0.006) ** 2
    for first in (0, 1, 2):
        _straighten(
            position[:, first:-2:3], position[:, first + 1 : -1 : 3], position[:, first + 2 :: 3], bend
        )
        _straighten(position[first:-2:3], position[first + 1 : -1 : 3], position[first + 2 :: 3], bend)


def _pull(a: Grid, b: Grid, rest: float, compliance: float) -> None:
    offset = b - a
    length = np.sqrt(np.einsum("...i,...i->...", offset, offset))
    offset *= ((length - rest) / ((2 + compliance) * np.maximum(length, 1e-9)))[..., None]
    a += offset
    b -= offset


def _straighten(a: Grid, middle: Grid, b: Grid, compliance: float) -> None:
    shift = (a - 2 * middle + b) / (6 + compliance)
    a -= shift
    middle += 2 * shift
    b -= shift
