"""The thread at a position, and what the geometry asks about it, on one Dr.Jit backend.

What differs between fabrics is opaque to the kernels, counts of threads included, so all fabrics share
them.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Self

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Int, Mask, UInt
from loomlight.core.backend import ArrayTypes, array_types, clip, minimum, upload
from loomlight.yarn.threads import (
    FamilyTables,
)


@dataclass
class Cell:
    """Where a coordinate falls among the threads of one family.

    Attributes:
        thread: index of the thread whose cell it is: UInt32.
        number: the same as a Float, known sooner.
        across: distance from the middle of that thread, signed, millimetres.
        half_width: of that thread.
        below, above: distances to the ends of the cell.
    """

    thread: UInt
    number: Float
    across: Float
    half_width: Float
    below: Float
    above: Float


class Count:
    """A number of threads or texels to count around with: opaque, so that kernels do not depend on it."""

    def __init__(self, number: Float, inverse: Float, half_inverse: Float) -> None:
        self.numbers = number, inverse, half_inverse
        self._number, self._inverse, self._half_inverse = self.numbers

    @classmethod
    def of(cls, number: int, types: ArrayTypes) -> Self:
        """Of a number on one backend."""
        number_, inverse, half = (
            dr.opaque(types.Float, value) for value in (number, 1 / number, 0.5 / number)
        )
        return cls(number_, inverse, half)

    def divide(self, index: UInt) -> tuple[Float, Float]:
        """Whole turns, rounded down, and the remainder ≥ 0 of whole numbers of any sign: Float each.

        Exact up to 4 million, where coordinates in single precision tell threads apart no longer.
        """
        turns = dr.floor(dr.fma(index, self._inverse, self._half_inverse))
        return turns, dr.fma(-turns, self._number, index)


def select_cell(first_one: Mask, first: Cell, second: Cell) -> Cell:
    """`first` where `first_one`, else `second`."""
    return Cell(
        dr.select(first_one, first.thread, second.thread),
        dr.select(first_one, first.number, second.number),
        dr.select(first_one, first.across, second.across),
        dr.select(first_one, first.half_width, second.half_width),
        dr.select(first_one, first.below, second.below),
        dr.select(first_one, first.above, second.above),
    )


class UniformFamily:
    """Threads that are all alike: arithmetic instead of tables."""

    is_uniform = True

    def __init__(self, tables: FamilyTables, types: ArrayTypes) -> None:
        self.count = Count.of(tables.lower.size, types)
        self._last = dr.opaque(types.Float, tables.lower.size - 1)
        size = float(tables.upper[0] - tables.lower[0])
        self.size = dr.opaque(types.Float, size)
        self.inverse_size = dr.opaque(types.Float, 1 / size)
        self.half_width = dr.opaque(types.Float, float(tables.half_width[0]))
        self.arc = dr.opaque(types.Float, float(tables.arc[0]))
        self.drop = dr.opaque(types.Float, float(tables.edge_drop[0]))
        inclination = float(tables.inclination[0])
        self.sine = dr.opaque(types.Float, math.sin(inclination))
        self.half_tangent = dr.opaque(types.Float, math.tan(inclination / 2))
        self._types = types

    def locate(self, position: Float) -> Cell:
        """The cell of a position in millimetres, any number of repeats away."""
        cells = position * self.inverse_size
        whole = dr.floor(cells)
        below = dr.fma(-whole, self.size, position)
        # Whatever comes in, there is such a thread: positions that are no number would read any memory.
        number = clip(self.count.divide(whole)[1], 0, self._last)
        return Cell(
            self._types.UInt32(number),
            number,
            below - 0.5 * self.size,
            self.half_width,
            below,
            self.size - below,
        )

    def span(self, thread: UInt, first: Int, last: Int) -> Float:
        """Length from the lower boundary of cell thread + first to that of thread + last."""
        del thread
        return self._types.Float(last - first) * self.size

    def bend(self, thread: UInt) -> tuple[Float, Float, Float]:
        """Sine of the inclination, tangent of half of it, and the arc's half-length."""
        del thread
        return self.sine, self.half_tangent, self.arc

    def edge_drop(self, thread: UInt, step: Int) -> Float:
        """Edge drop of thread + step, step in −1..1."""
        del thread, step
        return self.drop


class VariedFamily:
    """Threads that differ: a table by position finds the thread, tables by thread tell what it is."""

    is_uniform = False

    def __init__(self, tables: FamilyTables, types: ArrayTypes) -> None:
        self.count = Count.of(tables.lower.size, types)
        self._last = dr.opaque(types.UInt32, tables.lower.size - 1)
        self._types = types
        self.start = dr.opaque(types.Float, float(tables.lower[0]))
        self.period = dr.opaque(types.Float, tables.period)
        self.inverse_period = dr.opaque(types.Float, 1 / tables.period)
        lower = tables.lower - tables.lower[0]
        bins = math.ceil(tables.period / tables.finest) + 1
        edges = np.arange(bins) * (tables.period / bins)
        first = np.searchsorted(lower, edges, side="right") - 1
        self.bins = dr.opaque(types.Float, bins)
        self._last_bin = dr.opaque(types.UInt32, bins - 1)
        self._first = upload(types.UInt32, first.astype(np.uint32))
        self._place, self._bend = (upload(types.Float, rows) for rows in thread_rows(tables))

    def _row(self, table: Float, thread: UInt) -> Any:
        return dr.gather(self._types.Vector4, table, thread)

    def locate(self, position: Float) -> Cell:
        UInt32 = self._types.UInt32
        turns = (position - self.start) * self.inverse_period
        turns -= dr.floor(turns)
        local = turns * self.period
        slot = minimum(UInt32(turns * self.bins), self._last_bin)
        thread = dr.gather(UInt32, self._first, slot)
        upper = dr.gather(self._types.Float, self._place, thread * 4 + 1)
        # A bin is no wider than the smallest cell, so it meets two cells at most; rounding may add one.
        thread = minimum(thread + dr.select(local >= upper, UInt32(1), UInt32(0)), self._last)
        lower, upper, centre, half_width = self._row(self._place, thread)
        return Cell(
            thread, self._types.Float(thread), local - centre, half_width, local - lower, upper - local
        )

    def span(self, thread: UInt, first: Int, last: Int) -> Float:
        return self._boundary(thread, last) - self._boundary(thread, first)

    def _boundary(self, thread: UInt, step: Int) -> Float:
        turns, inside = self.count.divide(self._types.Float(self._types.Int32(thread) + step))
        lower = dr.gather(self._types.Float, self._place, self._types.UInt32(inside) * 4)
        return dr.fma(turns, self.period, lower)

    def bend(self, thread: UInt) -> tuple[Float, Float, Float]:
        row = self._row(self._bend, thread)
        return row[0], row[1], row[2]

    def edge_drop(self, thread: UInt, step: Int) -> Float:
        inside = self.count.divide(self._types.Float(self._types.Int32(thread) + step))[1]
        return dr.gather(self._types.Float, self._bend, self._types.UInt32(inside) * 4 + 3)


Family = UniformFamily | VariedFamily


def thread_rows(tables: FamilyTables) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Numbers of each thread: where it lies, and how it bends [n, 4]."""
    first = tables.lower[0]
    place = [tables.lower - first, tables.upper - first, tables.centre - first, tables.half_width]
    bend = [np.sin(tables.inclination), np.tan(tables.inclination / 2), tables.arc, tables.edge_drop]
    return np.stack(place, axis=1), np.stack(bend, axis=1)


def span_along(is_warp: Mask, thread: UInt, warp: Any, weft: Any) -> Callable[[Float, Int, Int], Float]:
    """A length (millimetres) plus `span` of the family that a thread of warp (else weft) crosses.

    Args:
        thread: the crossing that is counted from.
        warp, weft: families, or what takes their place (`planes.py`).
    """
    if warp.is_uniform and weft.is_uniform:
        size = dr.select(is_warp, weft.size, warp.size)
        return lambda length, first, last: dr.fma(array_types(size).Float(last - first), size, length)
    return lambda length, first, last: (
        length + dr.select(is_warp, weft.span(thread, first, last), warp.span(thread, first, last))
    )


def upload_family(tables: FamilyTables, types: ArrayTypes) -> Family:
    """The family on one backend: without tables where its threads are alike."""
    return UniformFamily(tables, types) if tables.uniform else VariedFamily(tables, types)
