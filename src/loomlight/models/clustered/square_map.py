"""Directions of the hemisphere on a square, equal areas to equal areas (Shirley and Chiu 1997).

A direction (x, y, z ≥ 0) lies on the unit disc at (x, y)/sqrt(1 + z), at radius sqrt(1 − z), which keeps
areas; the disc is mapped to the square [−1, 1]² by rings. Bins of equal size on the square are of equal
solid angle.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, UInt, Vec3
from loomlight.core.backend import array_types, clip, maximum, minimum

BINS = 32


def bin_directions(u: NDArray[np.float64], v: NDArray[np.float64]) -> NDArray[np.float64]:
    """Directions [..., 3] of points of the square, −1 to 1."""
    steep = np.abs(u) >= np.abs(v)
    radius = np.where(steep, u, v)
    ratio = np.where(steep, v, u) / np.where(radius == 0, 1, radius)
    cosine, sine = np.cos(math.pi / 4 * ratio), np.sin(math.pi / 4 * ratio)
    disc = np.stack([np.where(steep, cosine, sine), np.where(steep, sine, cosine)], axis=-1)
    disc *= radius[..., None]
    stretch = np.sqrt(2 - radius**2)
    return np.concatenate([disc * stretch[..., None], (1 - radius**2)[..., None]], axis=-1)


def bin_centres(bins: int = BINS) -> NDArray[np.float64]:
    """Directions of the middles of all bins [bins², 3], rows of v."""
    middle = (np.arange(bins) + 0.5) * (2 / bins) - 1
    v, u = np.meshgrid(middle, middle, indexing="ij")
    return bin_directions(u.ravel(), v.ravel())


@dataclass
class BinTaps:
    """The four bins around a direction and their bilinear weights, which add up to 1."""

    bins: tuple[UInt, UInt, UInt, UInt]
    weights: tuple[Float, Float, Float, Float]

    def read(self, kind: Any, table: Float, first: UInt, stride: int, offset: UInt) -> Any:
        """Interpolated entries, a Float or a packet `kind` of them.

        Args:
            first: index of the table's first bin, in bins.
            stride: entries a bin, of the size of `kind`.
            offset: entry within the bin.
        """
        total: Any = 0
        for number, weight in zip(self.bins, self.weights, strict=True):
            total += dr.gather(kind, table, (first + number) * stride + offset) * weight
        return total


def bin_taps(direction: Vec3, bins: int = BINS) -> BinTaps:
    """The bins around a direction with z ≥ 0; at the border of the square it is clamped."""
    types = array_types(direction.x)
    radius = dr.sqrt(maximum(1 - direction.z, 0))
    across, along = abs(direction.x), abs(direction.y)
    steep = across >= along
    smaller, larger = minimum(across, along), maximum(across, along)
    turn = dr.atan2(smaller, maximum(larger, 1e-12)) * (4 / math.pi)
    u = dr.copysign(dr.select(steep, radius, radius * turn), direction.x)
    v = dr.copysign(dr.select(steep, radius * turn, radius), direction.y)
    column, across = _tap(u, bins)
    row, along = _tap(v, bins)
    corner = row * bins + column
    return BinTaps(
        (corner, corner + 1, corner + bins, corner + (bins + 1)),
        ((1 - across) * (1 - along), across * (1 - along), (1 - across) * along, types.Float(across * along)),
    )


def _tap(position: Float, bins: int) -> tuple[UInt, Float]:
    """The lower one of two bins and the weight of the upper one."""
    types = array_types(position)
    place = clip((position + 1) * (bins / 2) - 0.5, 0, bins - 1)
    lower = minimum(types.UInt32(place), types.UInt32(bins - 2))
    return lower, place - types.Float(lower)
