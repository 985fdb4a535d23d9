"""Levels of the latent field, and which of its texels a footprint reads. Lengths are in threads.

Levels 0 to 3 have 8, 4, 2 and 1 texels a thread; the next hold running means over 2, 4, 8 … threads, a texel
a thread; the last is the mean of the repeat, one texel. A footprint reads two levels, bilinearly each.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

FINEST = 3  # levels finer than one texel a thread
# Footprints of so many repeats are means of the repeat to within what is left of a box's last repeat.
WHOLE_REPEATS = 4


@dataclass(frozen=True)
class Level:
    """One level.

    Attributes:
        first: its first texel in the table of all.
        columns, rows: its texels.
        window: threads that a texel stands for; 0 for the whole repeat.
        per_thread: texels a thread.
    """

    first: int
    columns: int
    rows: int
    window: float
    per_thread: int


def levels_of(picks: int, ends: int) -> list[Level]:
    """The levels of a repeat."""
    levels: list[Any] = []
    first = 0
    for finer in range(FINEST, -1, -1):
        per_thread = 1 << finer
        levels.append(Level(first, ends * per_thread, picks * per_thread, 1 / per_thread, per_thread))
        first += ends * picks * per_thread**2
    window = 2
    while window <= WHOLE_REPEATS * max(picks, ends):
        levels.append(Level(first, ends, picks, window, 1))
        first += ends * picks
        window *= 2
    levels.append(Level(first, 1, 1, 0, 0))
    return levels


def taps(
    levels: list[Level], x: NDArray[np.float32], y: NDArray[np.float32], size: NDArray[np.float32]
) -> tuple[NDArray[np.int64], NDArray[np.float32]]:
    """Texels and weights [n, 8] of footprints at x, y of a side `size` [n], in threads."""
    first = np.array([level.first for level in levels])
    columns = np.array([level.columns for level in levels])
    rows = np.array([level.rows for level in levels])
    per_thread = np.array([level.per_thread for level in levels], np.float32)
    # A texel of a running mean stands around its upper corner, other texels around their middle.
    corner = np.array([1.0 if level.window > 1 else 0.5 for level in levels], np.float32)
    place = np.clip(np.log2(np.maximum(size, 1e-6)) + FINEST, 0, len(levels) - 1).astype(np.float32)
    lower = np.minimum(place.astype(np.int64), len(levels) - 2)
    blend = place - lower
    index = np.empty((len(x), 8), np.int64)
    weight = np.empty((len(x), 8), np.float32)
    for side in range(2):
        level = lower + side
        u = x * per_thread[level] - corner[level]
        v = y * per_thread[level] - corner[level]
        column, row = np.floor(u), np.floor(v)
        right, up = u - column, v - row
        share = blend if side else 1 - blend
        lines = []
        for number, count in ((column.astype(np.int64), columns[level]), (row.astype(np.int64), rows[level])):
            one = number % count
            other = one + 1
            # A remainder takes longer than all else here.
            lines.append((one, np.where(other == count, 0, other)))
        for tap in range(4):
            index[:, 4 * side + tap] = first[level] + lines[1][tap // 2] * columns[level] + lines[0][tap % 2]
            across = right if tap % 2 else 1 - right
            along = up if tap // 2 else 1 - up
            weight[:, 4 * side + tap] = share * across * along
    return index, weight


def size_share(size: Any, smallest: float, largest: float, arrays: Any = np) -> Any:
    """Place of a size between two others by its logarithm, 0 to 1.

    Args:
        arrays: the module of the array's functions, numpy or drjit.
    """
    return arrays.clip(arrays.log(size / smallest) / math.log(largest / smallest), 0, 1)
