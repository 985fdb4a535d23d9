"""Summed-area tables: the mean over any axis-aligned box from a few reads, exact and without noise.

A slice has one value a texel. Its table T[r, c] is the sum of the texels below row r and left of column c,
in float64, so T has one row and column more than the slice; between its entries it is interpolated, which
is exact for values constant on each texel. On a grid of C columns and R rows the integral from the
origin to (c + a·C, r + b·R) is

    G = T[r, c] + a·T[r, C] + b·T[R, c] + a·b·T[R, C]

with whole a and b, so the cost of a box does not depend on its size: its mean takes four evaluations of G.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.aggregate.grid import Grid, divide
from loomlight.core.arrays import Float, FloatType, UInt
from loomlight.core.backend import array_types, clip, maximum, minimum, upload

# Smallest width and height of a box, in texels. Rounding of the difference of four float64 sums of 10⁷ texels
# then stays below 1e-4 of the slice's mean.
_MIN_BOX = 1e-2


def summed_areas(values: Float, columns: int, rows: int) -> Float:
    """Tables of slices, one after another, (rows + 1)·(columns + 1) entries each: Float64.

    Args:
        values: of whole slices, one after another, texels row by row: Float.
    """
    types = array_types(dr.float64_array_t(type(values)))
    slices = dr.width(values) // (columns * rows)
    table = dr.empty(types.Float, slices * (columns + 1) * (rows + 1))
    # Opaque, so that grids of all sizes share the kernels.
    width, height, pitch = (dr.opaque(types.UInt32, number) for number in (columns, rows, columns + 1))
    texels = dr.opaque(types.UInt32, columns * rows)
    entries = dr.opaque(types.UInt32, (columns + 1) * (rows + 1))

    # Sums along columns, a lane per column: neighbouring lanes read neighbouring texels. Column 0 is 0.
    number, column = divide(dr.arange(types.UInt32, slices * (columns + 1)), columns + 1)
    inside = column > 0
    texel = number * texels + column - 1
    entry = number * entries + column
    dr.scatter(table, types.Float(0), entry)

    def add_row(row: UInt, total: Float) -> tuple[UInt, Float]:
        total = total + types.Float(dr.gather(type(values), values, texel + row * width, inside))
        dr.scatter(table, total, entry + (row + 1) * pitch)
        return row + 1, total

    start = types.UInt32(0), dr.zeros(types.Float, slices * (columns + 1))
    dr.while_loop(start, lambda row, total: row < height, add_row, label="summed areas: columns")
    dr.eval(table)

    # Prefix sums along rows.
    table = dr.block_prefix_sum(table, columns + 1, exclusive=False)
    dr.eval(table)
    return table


@dataclass
class TexelBoxes:
    """Lower and upper bounds of boxes in texels from the corner of the grid, in double precision."""

    left: Float
    right: Float
    bottom: Float
    top: Float

    def at(self, index: UInt) -> TexelBoxes:
        """The boxes of these indices."""
        bounds = (self.left, self.right, self.bottom, self.top)
        return TexelBoxes(*(dr.gather(type(bound), bound, index) for bound in bounds))


def texel_boxes(grid: Grid, centres: NDArray[Any], sizes: NDArray[Any], float_type: FloatType) -> TexelBoxes:
    """Boxes on the grid from centres and sizes [n, 2] in millimetres, not evaluated yet.

    Args:
        float_type: the Dr.Jit Float type of a backend; bounds are its Float64.
    """
    centres, sizes = np.asarray(centres, np.float64), np.asarray(sizes, np.float64)
    types = array_types(dr.float64_array_t(float_type))
    lane = dr.arange(types.UInt32, len(centres))
    middle, whole = (dr.gather(types.Vector2, upload(types.Float, pair), lane) for pair in (centres, sizes))
    bounds = []
    for axis, (start, step) in enumerate(zip((grid.left, grid.bottom), grid.step, strict=True)):
        per_texel = dr.opaque(types.Float, 1 / step)
        half = 0.5 * maximum(whole[axis] * per_texel, _MIN_BOX)
        position = (middle[axis] - dr.opaque(types.Float, start)) * per_texel
        bounds += [position - half, position + half]
    return TexelBoxes(*bounds)


@dataclass
class _Bound:
    """One side of a box: table entry, fraction to the next entry, and number of whole repeats."""

    entry: UInt
    fraction: Float
    turns: Float


def _bound(position: Float, count: int) -> _Bound:
    types = array_types(position)
    whole = dr.opaque(types.Float, count)
    turns = dr.floor(position * dr.opaque(types.Float, 1 / count))
    local = clip(position - turns * whole, 0, whole)
    entry = minimum(types.UInt32(local), dr.opaque(types.UInt32, count - 1))
    return _Bound(entry, local - types.Float(entry), turns)


def box_means(table: Float, first: UInt, grid: Grid, boxes: TexelBoxes) -> Float:
    """Mean of a slice over boxes: Float64 [n].

    Args:
        table: tables one after another, Float64.
        first: index of the first entry of each box's table, UInt32 [n] or [1].
    """
    types = array_types(table)
    across = [_bound(position, grid.columns) for position in (boxes.left, boxes.right)]
    along = [_bound(position, grid.rows) for position in (boxes.bottom, boxes.top)]
    pitch = dr.opaque(types.UInt32, grid.columns + 1)
    columns, rows = dr.opaque(types.UInt32, grid.columns), dr.opaque(types.UInt32, grid.rows)

    def read(row: UInt, column: UInt) -> Float:
        return dr.gather(types.Float, table, first + row * pitch + column)

    def in_row(row: UInt, bound: _Bound) -> Float:
        return dr.lerp(read(row, bound.entry), read(row, bound.entry + 1), bound.fraction)

    def strip(row: UInt) -> Float:
        """Sum of a row of the table between the left and right bounds."""
        whole = (across[1].turns - across[0].turns) * read(row, columns)
        return in_row(row, across[1]) - in_row(row, across[0]) + whole

    def below(bound: _Bound) -> Float:
        return dr.lerp(strip(bound.entry), strip(bound.entry + 1), bound.fraction)

    total = below(along[1]) - below(along[0])
    total += (along[1].turns - along[0].turns) * strip(rows)
    return total / ((boxes.right - boxes.left) * (boxes.top - boxes.bottom))
