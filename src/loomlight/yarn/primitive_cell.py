"""The primitive translation cell of a cloth: the smallest pair of shifts under which its structure is itself.

The structure is the drawdown with the spacing and the width of each thread; colours are no part of it. Satin
8/3 repeats after 8 ends and 8 picks, and its cell has 8 crossings: one end and three picks on, it is itself.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.yarn.layout import ClothLayout


def primitive_cell(layout: ClothLayout) -> NDArray[np.float64]:
    """The shortest two shifts that span the cell: [2, 2], a row each, x and y, millimetres."""
    picks, ends = layout.warp_on_top.shape
    shifts = primitive_shifts(layout) * (np.asarray(layout.size) / (ends, picks))
    while True:  # Lagrange's reduction. Shifts of equal length must not take turns for ever.
        first, second = sorted(shifts, key=lambda shift: float(shift @ shift))
        shorter = second - np.round(first @ second / (first @ first)) * first
        if shorter @ shorter >= (1 - 1e-9) * (second @ second):
            return np.array([first, second])
        shifts = np.array([first, shorter])


def primitive_shifts(layout: ClothLayout) -> NDArray[np.int64]:
    """Two shifts [2, 2], a row each, ends and picks, that span all shifts that leave the structure alone."""
    threads = (np.stack([family.spacing, family.width], axis=1) for family in (layout.warp, layout.weft))
    ends, picks = (next(n for n in _multiples(len(rows), 1) if _is_period(rows, n)) for rows in threads)
    drawdown = layout.warp_on_top
    height = next(n for n in _multiples(len(drawdown), picks) if _is_period(drawdown, n))
    drawdown = drawdown[:height]
    width = drawdown.shape[1]
    # One with a long period of its own.
    columns = [column.tobytes() for column in drawdown.T[:64]]
    rarest = max(range(len(columns)), key=lambda number: (columns[number] * 2).find(columns[number], 1))
    for shift in _multiples(width, ends):
        there = drawdown[:, (rarest + shift) % width].tobytes() * 2
        up = there.find(columns[rarest])
        while 0 <= up < height:
            if up % picks == 0 and _is_period(drawdown, up, shift):
                return np.array([[shift, up], [0, height]])
            up = there.find(columns[rarest], up + 1)
    raise AssertionError("A repeat shifted by itself is itself.")


def _is_period(rows: NDArray[Any], shift: int, columns: int = 0) -> bool:
    """Whether a table that repeats is itself after a shift; a few rows say no at once."""
    every = np.arange(len(rows))
    few = every[:: max(1, len(rows) // 4)]
    return all(np.array_equal(np.roll(rows[part - shift], columns, 1), rows[part]) for part in (few, every))


def _multiples(whole: int, unit: int) -> list[int]:
    """Divisors of `whole` that are multiples of `unit`, which divides it, ascending."""
    return [number for number in range(unit, whole + 1, unit) if whole % number == 0]
