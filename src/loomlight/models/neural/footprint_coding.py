"""Inputs of the decoder from a footprint: taps of the latent field, position in the repeat, and size.

Lengths are in threads. Levels 0 to 3 of the latent field have 8, 4, 2 and 1 texels a thread; the next are
running means over 2, 4, 8 … threads, a texel a thread; the last is the mean of the repeat, one texel. A
footprint reads two levels, bilinearly each. Formulas serve NumPy, Dr.Jit and kernels: `arrays` is the module
of array functions.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Vec2
from loomlight.core.backend import array_types, maximum
from loomlight.core.footprint import Footprint
from loomlight.models.neural.architecture import NetworkTable
from loomlight.yarn.layout import ClothLayout

FINEST_LEVEL = 3  # levels finer than one texel a thread
PACKET = 16  # numbers of a texel that are loaded at once: a cache line
# Ratio of squared length to squared width up to which taps lie along both edges.
MAX_COMPACTNESS = 5.5
# Footprints of at least so many repeats read the mean of the repeat.
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
    for finer in range(FINEST_LEVEL, -1, -1):
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
    level_position = np.clip(np.log2(np.maximum(size, 1e-6)) + FINEST_LEVEL, 0, len(levels) - 1).astype(
        np.float32
    )
    lower = np.minimum(level_position.astype(np.int64), len(levels) - 2)
    blend = level_position - lower
    index = np.empty((len(x), 8), np.int64)
    weight = np.empty((len(x), 8), np.float32)
    for side in range(2):
        level = lower + side
        u = x * per_thread[level] - corner[level]
        v = y * per_thread[level] - corner[level]
        column, row = np.floor(u), np.floor(v)
        right, up = u - column, v - row
        level_weight = blend if side else 1 - blend
        lines = []
        for number, count in ((column.astype(np.int64), columns[level]), (row.astype(np.int64), rows[level])):
            lower_index = number % count
            upper_index = lower_index + 1
            # A remainder takes longer than all else here.
            lines.append((lower_index, np.where(upper_index == count, 0, upper_index)))
        for tap in range(4):
            index[:, 4 * side + tap] = first[level] + lines[1][tap // 2] * columns[level] + lines[0][tap % 2]
            across = right if tap % 2 else 1 - right
            along = up if tap // 2 else 1 - up
            weight[:, 4 * side + tap] = level_weight * across * along
    return index, weight


def log_fraction(size: Float, smallest: float, largest: float, arrays: Any = np) -> Float:
    """Position of a size between two others on a logarithmic scale, clipped to 0 to 1.

    Args:
        arrays: the module of the array's functions, numpy or drjit.
    """
    return arrays.clip(arrays.log(size / smallest) / math.log(largest / smallest), 0, 1)


# Smallest and largest footprint of "field", in threads; of "vector", in repeats, the smallest of at most
# `_MAX` threads. They are those of the query benchmark.
FIELD_SIZES = 1 / 64, 80.0
_REPEATS = 1 / 128, 5.0
# Sizes in threads at which the weight of a fabric's correction begins to rise from 0, and at which it is 1.
CORRECTED_SIZES = 1.0, 4.0
_MAX = 8.0


@dataclass
class AnisotropicTaps:
    """Anisotropic taps of a footprint, in threads: one, or four at centre ± first ± second.

    Attributes:
        x, y: centre of the taps.
        side: of a tap, which is a square.
        first_x, first_y, second_x, second_y: steps from the centre; all 0 where the footprint has one tap.
    """

    x: Float
    y: Float
    side: Float
    first_x: Float
    first_y: Float
    second_x: Float
    second_y: Float

    def numbers(self) -> tuple[Float, ...]:
        """All seven."""
        return self.x, self.y, self.side, self.first_x, self.first_y, self.second_x, self.second_y

    def size(self, arrays: Any) -> Float:
        """The side of a square of the taps' area, an input of the decoder: twelve variances, to ¼.

        Args:
            arrays: the module of array functions, drjit or a kernel's `SimdMath`.
        """
        square = arrays.square(self.side)
        across, along = (
            arrays.fma(12.0, arrays.fma(first, first, arrays.square(second)), square)
            for first, second in ((self.first_x, self.second_x), (self.first_y, self.second_y))
        )
        mixed = 12.0 * arrays.fma(self.first_x, self.first_y, self.second_x * self.second_y)
        # The determinant is at least side⁴, but for rounding.
        area = arrays.maximum(across * along - arrays.square(mixed), arrays.square(square))
        return arrays.sqrt(arrays.sqrt(area))

    def place(self, number: Float, arrays: Any) -> tuple[Float, Float]:
        """Centre of tap `number`, 0 to 3: a float; of lanes with one tap, all are at the centre."""
        half = arrays.floor(0.5 * number)
        first, second = 2.0 * half - 1.0, 2.0 * number - 4.0 * half - 1.0
        return (
            arrays.fma(first, self.first_x, arrays.fma(second, self.second_x, self.x)),
            arrays.fma(first, self.first_y, arrays.fma(second, self.second_y, self.y)),
        )


def taps_of_footprint(footprint: Footprint, least: float) -> tuple[Float, Vec2, Vec2]:
    """Side of a tap and both steps [2] for a footprint, in its own unit of length; see `AnisotropicTaps`.

    Long footprints have a row of four (`Footprint.anisotropic_taps`). Others that are large enough have two
    along either edge: like the pixel's box, these vanish where threads have an odd number of periods along an
    edge and alias with the pixels. One square does not if it lies askew, and pictures show rings of moiré.

    Args:
        least: smallest side of the four taps. Latents of at least a thread are means of those of threads, so
            that their means are latents too; smaller ones are not.
    """
    types = array_types(footprint.area)
    side, step = footprint.anisotropic_taps()
    a, b = footprint.duv_dx, footprint.duv_dy
    total = dr.squared_norm(a) + dr.squared_norm(b)
    # Squared length and width, as in `Footprint.anisotropic_taps`: their sum and product.
    longest = 0.5 * (total + dr.sqrt(maximum(dr.square(total) - 4 * dr.square(footprint.area), 0)))
    is_compact = (longest < MAX_COMPACTNESS * (total - longest)) & (total > 8 * least**2)

    def steps(edge: Vec2, share: float) -> Vec2:
        compact, row = 0.25 * edge, share * step
        return types.Vector2(dr.select(is_compact, compact.x, row.x), dr.select(is_compact, compact.y, row.y))

    # A quarter of the variance is the taps' own: 12 (a/4)² is three quarters of a². A row is ±1 ± ½ steps.
    first, second = steps(a, 1), steps(b, 0.5)
    return dr.select(is_compact, dr.sqrt(0.125 * total), side), first, second


def footprint_coordinates(
    table: NetworkTable, picks: int, ends: int, x: Float, y: Float, size: Float, arrays: Any = np
) -> tuple[Float, Float, Float]:
    """Position x, y and size of footprints for the decoder, each 0 to 1.

    With latents of kind "field" positions are within a thread, as latents differ between threads; with
    "vector" they are within the repeat.

    Args:
        picks, ends: of the repeat.
        x, y, size: centre and side of footprints, in threads.
        arrays: the module of the arrays' functions, numpy or drjit.
    """
    size = arrays.maximum(size, 1e-6)
    if table.latent == "field":
        return x - arrays.floor(x), y - arrays.floor(y), log_fraction(size, *FIELD_SIZES, arrays)
    repeat = math.sqrt(picks * ends)
    smallest, largest = min(repeat, _MAX) * _REPEATS[0], repeat * _REPEATS[1]
    u, v = x / ends, y / picks
    return u - arrays.floor(u), v - arrays.floor(v), log_fraction(size, smallest, largest, arrays)


def fine_tuning_weight(size: Float, arrays: Any = np) -> Float:
    """Weight of a fabric's correction of the last layer, 0 to 1, for latents of kind "field".

    Args:
        size: the last of `footprint_coordinates`.
    """
    first, full = (float(log_fraction(threads, *FIELD_SIZES)) for threads in CORRECTED_SIZES)
    return arrays.clip((size - first) * (1 / (full - first)), 0, 1)


def footprints_in_threads(
    layout: ClothLayout, centres: NDArray[np.float64], sizes: NDArray[np.float64]
) -> NDArray[np.float32]:
    """Footprints [..., 3], position and side in threads, from centres [..., 2] and sides [...] in mm."""
    width, height = layout.size
    picks, ends = layout.warp_on_top.shape
    return np.stack(
        [centres[..., 0] * (ends / width), centres[..., 1] * (picks / height), sizes / mean_pitch(layout)], -1
    ).astype(np.float32)


def mean_pitch(layout: ClothLayout) -> float:
    """Geometric mean of the spacings of both families, millimetres: the unit of footprints."""
    width, height = layout.size
    picks, ends = layout.warp_on_top.shape
    return math.sqrt(width / ends * height / picks)
