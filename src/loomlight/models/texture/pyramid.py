"""Mip pyramids of neural textures: their shape, and the texels that a query reads, with wrap-around.

Level 0 is the finest; each further one has half the texels a side, down to one. A footprint whose square of
the same area has side s belongs to level l = log2(s / `footprint_mm`), a texel or more; a Gaussian one of
deviation σ has s = √12 σ.

The formulas take Dr.Jit arrays or torch tensors: what differs between them is `ArrayFunctions`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Protocol

import drjit as dr

from loomlight.core.arrays import Float, Int
from loomlight.core.backend import ArrayTypes, clip

# Side of the square that has the variance of a Gaussian, over its standard deviation.
SIZE_OF_SIGMA = math.sqrt(12)


class ArrayFunctions(Protocol):
    """Functions of an array library that the formulas call."""

    def floor(self, value: Float) -> Float: ...
    def clip(self, value: Float, low: float, high: float) -> Float: ...
    def to_index(self, value: Float) -> Int: ...
    def gather(self, table: Sequence[int], index: Int) -> Int: ...
    def wrap(self, index: Int, count: Any) -> Int: ...


@dataclass(frozen=True)
class PyramidShape:
    """Numbers of texels of the levels of a repeat.

    Attributes:
        columns, rows: of level 0, powers of two.
        width_mm, height_mm: of the repeat.
        faces: 1, or 2 where front and back have textures of their own.
        is_apart: whether texels are materials of their own, such as a library's: of one level, and nothing is
            interpolated between them.
        footprint_texels: side of the footprints that level 0 is for, in texels.
    """

    columns: int
    rows: int
    width_mm: float
    height_mm: float
    faces: int = 1
    is_apart: bool = False
    footprint_texels: int = 1

    @classmethod
    def of(cls, repeat_mm: tuple[float, float], resolution: int, faces: int) -> PyramidShape:
        """About square texels: `resolution` along the longer side of the repeat."""
        width, height = repeat_mm
        longer = max(width, height)
        columns, rows = (
            2 ** max(0, round(math.log2(resolution * side / longer))) for side in (width, height)
        )
        return cls(columns, rows, width, height, faces)

    @cached_property
    def sizes(self) -> list[tuple[int, int]]:
        """Columns and rows of each level."""
        levels = 1 if self.is_apart else int(math.log2(max(self.columns, self.rows))) + 1
        return [(max(1, self.columns >> level), max(1, self.rows >> level)) for level in range(levels)]

    @cached_property
    def starts(self) -> list[int]:
        """First texel of each level of a face, and the number of all of them."""
        starts = [0]
        for columns, rows in self.sizes:
            starts.append(starts[-1] + columns * rows)
        return starts

    @property
    def levels(self) -> int:
        """Number of levels."""
        return len(self.sizes)

    @property
    def texels(self) -> int:
        """Texels of a face, all levels."""
        return self.starts[-1]

    @property
    def texel_mm(self) -> float:
        """Side of a texel of level 0: the geometric mean of both directions."""
        return math.sqrt(self.width_mm / self.columns * self.height_mm / self.rows)

    @property
    def footprint_mm(self) -> float:
        """Side of the footprints that level 0 is for."""
        return self.footprint_texels * self.texel_mm

    @property
    def length_mm(self) -> float:
        """The unit of ray depths: the geometric mean of both sides of the repeat."""
        return math.sqrt(self.width_mm * self.height_mm)

    @property
    def unit(self) -> tuple[float, float]:
        """The unit of ray depths in repeats of x and of y."""
        return self.length_mm / self.width_mm, self.length_mm / self.height_mm


@dataclass
class Taps:
    """Texels that a query reads, with their weights; as many of each."""

    texels: list[Int]
    weights: list[Float]


def bilinear_taps(u: Float, v: Float, columns: Any, rows: Any, start: Any, functions: ArrayFunctions) -> Taps:
    """The four taps of one level.

    Args:
        u, v: position in repeats, any.
        columns, rows, start: of the level, numbers or one each query; `start` of the query's face.
    """
    x, y = u * columns - 0.5, v * rows - 0.5
    left, bottom = functions.floor(x), functions.floor(y)
    across, along = x - left, y - bottom
    column, row = functions.to_index(left), functions.to_index(bottom)
    taps = Taps([], [])
    for up, vertical in ((0, 1 - along), (1, along)):
        for right, horizontal in ((0, 1 - across), (1, across)):
            texel = start + functions.wrap(row + up, rows) * columns + functions.wrap(column + right, columns)
            taps.texels.append(texel)
            taps.weights.append(vertical * horizontal)
    return taps


def trilinear_taps(
    shape: PyramidShape, u: Float, v: Float, level: Float, face_start: Int, functions: ArrayFunctions
) -> Taps:
    """The eight taps of a query between two levels.

    Args:
        level: log2 of the footprint's size in texels, any number.
        face_start: first texel of the query's face.
    """
    level = functions.clip(level, 0, shape.levels - 1)
    lower = functions.clip(functions.floor(level), 0, max(shape.levels - 2, 0))
    blend, number = level - lower, functions.to_index(lower)
    taps = Taps([], [])
    for offset, weight in ((0, 1 - blend), (1, blend)):
        if offset >= shape.levels:
            break
        found = level_taps(shape, u, v, number + offset, face_start, functions)
        taps.texels += found.texels
        taps.weights += [weight * tap for tap in found.weights]
    return taps


def level_taps(
    shape: PyramidShape, u: Float, v: Float, level: Int, face_start: Int, functions: ArrayFunctions
) -> Taps:
    """The four taps of a query of one level.

    Args:
        level: a whole number, 0 to `shape.levels - 1`.
        face_start: first texel of the query's face.
    """
    if shape.is_apart:
        # At the middle of a texel the others weigh nothing.
        u = (functions.floor(u * shape.columns) + 0.5) / shape.columns
        v = (functions.floor(v * shape.rows) + 0.5) / shape.rows
    columns, rows = ([size[axis] for size in shape.sizes] for axis in (0, 1))
    start = face_start + functions.gather(shape.starts[:-1], level)
    return bilinear_taps(
        u, v, functions.gather(columns, level), functions.gather(rows, level), start, functions
    )


class DrjitFunctions:
    """`ArrayFunctions` of one backend of Dr.Jit; its tables are small and become selects."""

    def __init__(self, types: ArrayTypes) -> None:
        self._types = types

    def floor(self, value: Float) -> Float:
        return dr.floor(value)

    def clip(self, value: Float, low: float, high: float) -> Float:
        return clip(value, low, high)

    def to_index(self, value: Float) -> Int:
        return self._types.Int32(value)

    def gather(self, table: Sequence[int], index: Int) -> Int:
        found = self._types.Int32(table[0])
        for number, entry in enumerate(table[1:], 1):
            found = dr.select(index >= number, self._types.Int32(entry), found)
        return found

    def wrap(self, index: Int, count: Any) -> Int:
        # Counts are powers of two, for which this holds of negative numbers too.
        return index & (count - 1)


def fetch_texels(table: Float, taps: Taps, types: ArrayTypes) -> list[Float]:
    """The interpolated texel of a table of eight channels a texel."""
    sums = [types.Float(0)] * 8
    for texel, weight in zip(taps.texels, taps.weights, strict=True):
        # A texel is two loads of four numbers.
        row = types.UInt32(texel) * 2
        low, high = (dr.gather(types.Vector4, table, row + half) for half in (0, 1))
        sums = [dr.fma(weight, value, total) for value, total in zip([*low, *high], sums, strict=True)]
    return sums


def wrapped(u: Float, v: Float) -> tuple[Float, Float]:
    """A position in the first repeat, 0 to 1, for most digits; NaN becomes 0 before it is an index."""
    return clip(u - dr.floor(u), 0, 1), clip(v - dr.floor(v), 0, 1)
