"""Grids of parallel view rays, and summed-area tables over them: means over boxes, exact and without noise.

A slice has one value a texel. Its table T[r, c] is the sum of the texels below row r and left of column c,
in float64, so T has one row and column more than the slice; between its entries it is interpolated, which
is exact for values constant on each texel. On a grid of C columns and R rows the integral from the
origin to (c + a·C, r + b·R) is

    G = T[r, c] + a·T[r, C] + b·T[R, c] + a·b·T[R, C]

with whole a and b, so the cost of a box does not depend on its size: its mean takes four evaluations of G.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, FloatType, UInt
from loomlight.core.backend import ArrayTypes, array_types, clip, maximum, minimum, upload
from loomlight.core.errors import InputError
from loomlight.yarn.rays import Surface

TEXELS_PER_THREAD = 32
# Five float64 tables of so many texels take 640 MB.
MAXIMUM_TEXELS = 1 << 24
# The golden ratio's fraction, and one half, in units of 2⁻³²: products wrap around as fractions do.
_TURN = 0x9E3779B9
_START = 0x80000000


@dataclass(frozen=True)
class Grid:
    """Texels over a rectangle of the plane z = 0; row 0 lies at its lower edge, column 0 at its left.

    One ray goes through each texel, at an offset in x that advances by the golden ratio from row to row, and
    in y from column to column. Rays through the centres of texels would alias along the threads: yarns 25.6
    texels wide would be 26 wide everywhere.

    Attributes:
        left, bottom, width, height: the rectangle in draft coordinates, millimetres.
        columns, rows: texels.
    """

    left: float
    bottom: float
    width: float
    height: float
    columns: int
    rows: int

    @property
    def texels(self) -> int:
        """Number of texels."""
        return self.columns * self.rows

    @property
    def step(self) -> tuple[float, float]:
        """Size of a texel, millimetres."""
        return self.width / self.columns, self.height / self.rows

    def points(self, types: ArrayTypes, texel: UInt) -> tuple[Float, Float]:
        """Draft coordinates of the points of texels (UInt32, row by row), millimetres."""
        row, column = divide(texel, self.columns)
        # float32 has 24 bits of precision.
        fraction_x = types.Float((row * _TURN + _START) >> 8) * 2**-24
        fraction_y = types.Float((column * _TURN + _START) >> 8) * 2**-24
        step_x, step_y = (dr.opaque(types.Float, step) for step in self.step)
        left, bottom = dr.opaque(types.Float, self.left), dr.opaque(types.Float, self.bottom)
        return dr.fma(types.Float(column) + fraction_x, step_x, left), dr.fma(
            types.Float(row) + fraction_y, step_y, bottom
        )

    def nearest(self, types: ArrayTypes, x: Float, y: Float) -> UInt:
        """The texel around draft coordinates (millimetres) of a grid that is one repeat: UInt32."""
        column = _around(types, x, self.left, self.width, self.columns)
        row = _around(types, y, self.bottom, self.height, self.rows)
        return row * dr.opaque(types.UInt32, self.columns) + column


def divide(index: UInt, count: int) -> tuple[UInt, UInt]:
    """Quotient and remainder of UInt32 by a number that is opaque to Dr.Jit: UInt32 each.

    One product in double precision, exact for all 32 bits and faster than integer division.
    """
    UInt32 = type(index)
    double: Any = dr.float64_array_t(UInt32)
    quotient = UInt32((double(index) + 0.5) * dr.opaque(double, 1 / count))
    return quotient, index - quotient * dr.opaque(UInt32, count)


def _around(types: ArrayTypes, position: Float, start: float, period: float, count: int) -> UInt:
    """The texel of a coordinate among `count` that repeat with the period (millimetres): UInt32."""
    turns = (position - dr.opaque(types.Float, start)) * dr.opaque(types.Float, 1 / period)
    fraction = turns - dr.floor(turns)
    # Rounding may make the fraction 1.
    return minimum(types.UInt32(fraction * dr.opaque(types.Float, count)), dr.opaque(types.UInt32, count - 1))


def fabric_grid(
    surface: Surface,
    texels_per_thread: float = TEXELS_PER_THREAD,
    window: tuple[float, float, float, float] | None = None,
) -> Grid:
    """A grid with at least so many texels across the finest thread of each family.

    Args:
        window: left, bottom, width, height in millimetres; None is one repeat.

    Raises:
        InputError: a window without extent, or more than 16 million texels.
    """
    left, bottom, width, height = window or (0.0, 0.0, *surface.size)
    if not (0 < width < math.inf and 0 < height < math.inf and texels_per_thread > 0):
        raise InputError(f"window = {window} needs a width and a height above 0 mm, and texels to fill it.")
    fine_x, fine_y = surface.finest
    # A repeat divided by its threads may come out a rounding error above a whole number.
    columns = math.ceil(width / fine_x * texels_per_thread - 1e-6)
    rows = math.ceil(height / fine_y * texels_per_thread - 1e-6)
    if columns * rows > MAXIMUM_TEXELS:
        raise InputError(f"{columns}x{rows} texels are too many for one slice (16 million fit).")
    return Grid(left, bottom, width, height, columns, rows)


# ----------------------------------------------------------------------------------------- summed-area tables


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


# ---------------------------------------------------------------------------------------- entries of integers
# Entries of summed-area tables of integers, as gathers read them: one by one, or neighbours at once.


class SingleEntries:
    """The summed-area table of a large draft, read entry by entry."""

    def __init__(self, areas: UInt, shape: tuple[int, ...], types: ArrayTypes) -> None:
        self._types = types
        self._padded = shape[2]
        self._pitch = dr.opaque(types.UInt32, shape[1])
        self._areas = areas

    def read(self, rows: Sequence[UInt], columns: Sequence[UInt]) -> Iterator[list[list[Float]]]:
        """For each number of an entry, a grid of entries: by column, then by row."""
        size = min(self._padded, 4)
        kind = self._types.Index2 if size == 2 else self._types.Index4
        for part in range(self._padded // size):
            values = []
            for column in columns:
                starts = [(row * self._pitch + column) * (self._padded // size) for row in rows]
                values.append([dr.gather(kind, self._areas, start + part) for start in starts])
            for number in range(size):
                yield [[entry[number] for entry in line] for line in values]


class PairedEntries:
    """The summed-area table of a smaller draft: neighbours along its rows are read at once.

    The last column, of the whole repeat, has no right neighbour: it is paired with its next row.
    """

    def __init__(self, areas: NDArray[np.uint32], types: ArrayTypes) -> None:
        self._types = types
        self._size = min(areas.shape[2], 4)
        self._parts = areas.shape[2] // self._size
        self._pitch = dr.opaque(types.UInt32, areas.shape[1] - 1)
        split = areas.reshape(*areas.shape[:2], self._parts, 1, self._size)
        self._pairs = upload(types.UInt32, np.concatenate([split[:, :-1], split[:, 1:]], axis=3))
        last = split[:, -1]
        self._last = upload(types.UInt32, np.concatenate([last[:-1], last[1:]], axis=2))
        self._all = [dr.opaque(types.UInt32, int(number)) for number in areas[-1, -1]]

    def read(self, rows: Sequence[UInt], columns: Sequence[UInt]) -> Iterator[list[list[Float]]]:
        """For each number of an entry, a grid of entries: by column, then by row."""
        size = self._size
        for part in range(self._parts):
            lines = [
                [self._pair(self._pairs, row * self._pitch + columns[first], part) for first in (0, 2)]
                for row in rows
            ]
            ends = [self._pair(self._last, rows[first], part) for first in (0, 2)]
            for number in range(size):
                grid = [
                    [line[pair][number + size * half] for line in lines]
                    for pair in range(2)
                    for half in range(2)
                ]
                last = [end[number + size * half] for end in ends for half in range(2)]
                yield [*grid, [*last, self._all[part * size + number]]]

    def _pair(self, table: Float, index: UInt, part: int) -> Float:
        """The numbers of two neighbours, concatenated."""
        types, index = self._types, index * self._parts + part
        if self._size == 2:
            return dr.gather(types.Index4, table, index)
        return dr.gather(types.Indices, table, index, shape=(2 * self._size, dr.width(index)))


Entries = SingleEntries | PairedEntries
