"""Grids of parallel view rays through the plane z = 0."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import drjit as dr

from loomlight.core.arrays import Float, UInt
from loomlight.core.backend import ArrayTypes, minimum
from loomlight.core.errors import InputError
from loomlight.yarn.search import Surface

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
