"""The pyramid of neural textures: its shape, and where a query reads it (kuznetsov2021 section 3.2).

Level 0 is the finest; each further one has half the texels a side, down to one. A query of footprint size
s reads at level l = log2(s / texel), between two levels (eq. 3), with bilinear interpolation and wrap-around.
The size s is the side of the square that has the variance of the query's Gaussian, √12 σ.

The formulas take Dr.Jit arrays or torch tensors: what differs between them is `ArrayFunctions`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Protocol

from loomlight.core.arrays import Float, Int

# Channels of a texel of each of the two textures (Table 4).
CHANNELS = 7
# Below this cosine the parallax of eq. 6 grows no further.
SMALLEST_COSINE = 0.6
SIZE_OF_SIGMA = math.sqrt(12)


class ArrayFunctions(Protocol):
    """What the formulas need of an array library."""

    def floor(self, value: Float) -> Float: ...
    def clip(self, value: Float, low: float, high: float) -> Float: ...
    def to_index(self, value: Float) -> Int: ...
    def gather(self, table: Sequence[int], index: Int) -> Int: ...
    def wrap(self, index: Int, count: Any) -> Int: ...


@dataclass(frozen=True)
class PyramidShape:
    """How many texels the levels of a repeat have.

    Attributes:
        columns, rows: of level 0, powers of two.
        width_mm, height_mm: of the repeat.
        faces: 1, or 2 where front and back have textures of their own.
    """

    columns: int
    rows: int
    width_mm: float
    height_mm: float
    faces: int = 1

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
        return [
            (max(1, self.columns >> level), max(1, self.rows >> level))
            for level in range(int(math.log2(max(self.columns, self.rows))) + 1)
        ]

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
    def length_mm(self) -> float:
        """The unit of the ray depth: the geometric mean of both sides of the repeat."""
        return math.sqrt(self.width_mm * self.height_mm)

    @property
    def unit(self) -> tuple[float, float]:
        """The unit of the ray depth in repeats of x and of y."""
        return self.length_mm / self.width_mm, self.length_mm / self.height_mm


@dataclass
class Taps:
    """Texels that a query reads, with their weights; as many of each."""

    texels: list[Int]
    weights: list[Float]


def bilinear_taps(
    u: Float, v: Float, columns: Any, rows: Any, start: Any, functions: ArrayFunctions, weight: Any = 1.0
) -> Taps:
    """The four taps of one level.

    Args:
        u, v: position in repeats, any.
        columns, rows, start: of the level, numbers or one each query; `start` of the query's face.
        weight: that all taps are multiplied with.
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
            taps.weights.append(vertical * horizontal * weight)
    return taps


def trilinear_taps(
    shape: PyramidShape, u: Float, v: Float, level: Float, face_start: Int, functions: ArrayFunctions
) -> Taps:
    """The eight taps of a query (eq. 3).

    Args:
        level: log2 of the footprint's size in texels, any number.
        face_start: first texel of the query's face.
    """
    level = functions.clip(level, 0, shape.levels - 1)
    lower = functions.clip(functions.floor(level), 0, max(shape.levels - 2, 0))
    blend, number = level - lower, functions.to_index(lower)
    columns, rows = ([size[axis] for size in shape.sizes] for axis in (0, 1))
    taps = Taps([], [])
    for offset, weight in ((0, 1 - blend), (1, blend)):
        if offset >= shape.levels:
            break
        chosen = number + offset
        found = bilinear_taps(
            u,
            v,
            functions.gather(columns, chosen),
            functions.gather(rows, chosen),
            face_start + functions.gather(shape.starts[:-1], chosen),
            functions,
            weight,
        )
        taps.texels += found.texels
        taps.weights += found.weights
    return taps


def shifted(
    shape: PyramidShape, u: Float, v: Float, depth: Float, view_x: Float, view_y: Float, slope: Float
) -> tuple[Float, Float]:
    """The position of eq. 7, in repeats.

    Args:
        depth: r, in units of `PyramidShape.length_mm`.
        slope: 1 / max(cosine of the view, `SMALLEST_COSINE`).
    """
    across, along = shape.unit
    reach = depth * slope
    return u + reach * view_x * across, v + reach * view_y * along
