"""Sums over footprints from summed-area tables of whole numbers: exact, in O(1), over cloth that repeats.

The footprint of this model is the axis-aligned box of size (W, H)·sqrt(1 − |r|), swept along the segment
(W, ±H)·sqrt|r|, where W²/12, H²/12 are the variances of the pixel's parallelogram along x and y and r is
their correlation, whose sign is that of the segment. Box and segment are independent, so their sum has
mean and covariance of the parallelogram, whatever its shape; for edges along the axes (r = 0) it is the
parallelogram. A place on the segment is drawn; the box around it is summed exactly.

The table T[r, c] has the sums of all texels below row r and left of column c. Of a box of whole texels from
(r0 + m0·R, c0 + n0·C) to (r1 + m1·R, c1 + n1·C) on a grid of C columns and R rows that repeats, the sum is

    T[r1, c1] − T[r1, c0] − T[r0, c1] + T[r0, c0] + (n1 − n0)(T[r1, C] − T[r0, C])
        + (m1 − m0)(T[R, c1] − T[R, c0]) + (m1 − m0)(n1 − n0) T[R, C]
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Array, Float, Mask, UInt, Vec2
from loomlight.core.backend import ArrayTypes, array_types, maximum, minimum, opaque
from loomlight.core.footprint import Footprint


@dataclass
class FootprintBox:
    """The box of a footprint, whose place on the segment is drawn, and its whole texels.

    Attributes:
        corner, size: lower left corner and size [2], millimetres.
        first: column and row of its first texel, within the repeat: UInt32 each.
        extent: its columns and rows, at least 1: Float each.
    """

    corner: Vec2
    size: Vec2
    first: tuple[UInt, UInt]
    extent: tuple[Float, Float]

    def at(self, s: Float, t: Float) -> Vec2:
        """The place of uniform numbers in [0, 1), millimetres [2]."""
        types = array_types(self.size)
        return types.Vector2(self.corner.x + s * self.size.x, self.corner.y + t * self.size.y)


def summed_areas(
    labels: NDArray[np.uint8], coefficients: NDArray[np.int8], parallax: NDArray[np.int8], clusters: int
) -> NDArray[Any]:
    """Tables of one face [rows + 1, columns + 1, (1 + n)·clusters + 4], int32.

    The first channels count the texels of each cluster, the next sum the coefficients over them, the last
    those of parallax over all texels.
    """
    rows, columns, count = coefficients.shape
    channels = (1 + count) * clusters
    table = np.zeros((rows + 1, columns + 1, channels + parallax.shape[2]), np.int32)
    table[1:, 1:, channels:] = parallax.cumsum(axis=0, dtype=np.int32).cumsum(axis=1, dtype=np.int32)
    for cluster in range(clusters):
        inside = labels == cluster
        for number in range(1 + count):
            values = inside.astype(np.int32)
            if number:
                values *= coefficients[:, :, number - 1]
            sums = values.cumsum(axis=0, dtype=np.int32).cumsum(axis=1, dtype=np.int32)
            table[1:, 1:, number * clusters + cluster] = sums
    return table


class FootprintSums:
    """The tables of both faces on one backend."""

    def __init__(
        self,
        table: UInt,
        columns: int,
        rows: int,
        channels: int,
        size: tuple[float, float],
        types: ArrayTypes,
    ) -> None:
        """
        Args:
            table: `ClusterTables.sums`.
            size: of the repeat, millimetres.
        """
        # Packets of clusters; that of parallax is the last one.
        self._packets = channels // 4 - 1
        self._table = table
        self._counts = [dr.opaque(types.Float, float(count)) for count in (columns, rows)]
        self._wholes = [dr.opaque(types.UInt32, count) for count in (columns, rows)]
        self._steps = opaque(types.Float, np.array(size) / (columns, rows))
        self._face = dr.opaque(types.UInt32, (columns + 1) * (rows + 1))

    def box(self, footprint: Footprint, offset: Vec2, place: Float) -> FootprintBox:
        """The box of a footprint.

        Args:
            offset: what its texels are shifted by, millimetres [2].
            place: on the segment, −1/2 to 1/2.
        """
        types = array_types(place)
        whole = footprint.box().size
        correlation = footprint.box_correlation()
        along = place * dr.sqrt(minimum(abs(correlation), 1))
        across = dr.sqrt(maximum(1 - abs(correlation), 0))
        corners, sizes, firsts, extents = [], [], [], []
        for axis, (step, count) in enumerate(zip(self._steps, self._counts, strict=True)):
            length = whole[axis] * across
            shift = along * whole[axis]
            if axis:
                shift = dr.copysign(1, correlation) * shift
            corner = footprint.centre[axis] + shift - 0.5 * length
            texels = maximum(dr.round(length / step), 1)
            first = dr.round((corner + 0.5 * length + offset[axis]) / step - 0.5 * texels)
            inside = first - dr.floor(first / count) * count
            # Rounding may make it the count itself.
            firsts.append(minimum(types.UInt32(maximum(inside, 0)), types.UInt32(count) - 1))
            corners.append(corner)
            sizes.append(length)
            extents.append(texels)
        return FootprintBox(
            types.Vector2(*corners), types.Vector2(*sizes), (firsts[0], firsts[1]), (extents[0], extents[1])
        )

    def texel(self, box: FootprintBox, s: Float, t: Float) -> UInt:
        """Index within the repeat of the box's texel at uniform numbers in [0, 1), row by row: UInt32."""
        found = []
        for share, first, extent, whole, count in zip(
            (s, t), box.first, box.extent, self._wholes, self._counts, strict=True
        ):
            types = array_types(share)
            number = minimum(dr.floor(share * extent), extent - 1)
            number -= dr.floor(number / count) * count
            index = first + minimum(types.UInt32(maximum(number, 0)), whole - 1)
            found.append(dr.select(index >= whole, index - whole, index))
        return found[1] * self._wholes[0] + found[0]

    def means(self, box: FootprintBox, back: Mask) -> list[Array]:
        """Means over the texels of a box of the channels of clusters, in packets of four (Vector4)."""
        return self._means(box, back, range(self._packets))

    def parallax(self, box: FootprintBox, back: Mask) -> Array:
        """Means over the texels of a box of the coefficients of parallax (Vector4)."""
        return self._means(box, back, range(self._packets, self._packets + 1))[0]

    def _means(self, box: FootprintBox, back: Mask, chosen: range) -> list[Array]:
        types = array_types(box.extent[0])
        turns, ends = [], []
        for first, extent, count, whole in zip(
            box.first, box.extent, self._counts, self._wholes, strict=True
        ):
            number = dr.floor(extent / count)
            rest = types.UInt32(maximum(extent - number * count, 0))
            last = first + rest
            wraps = last >= whole
            ends.append(dr.select(wraps, last - whole, last))
            turns.append(dr.select(wraps, number + 1, number))
        pitch = self._wholes[0] + 1
        start = dr.select(back, self._face, 0)
        packets = self._packets + 1
        scale = dr.rcp(box.extent[0] * box.extent[1])
        columns, rows = (box.first[0], ends[0], self._wholes[0]), (box.first[1], ends[1], self._wholes[1])
        entries = [[(start + row * pitch + column) * packets for column in columns] for row in rows]
        found = []
        for packet in chosen:
            ((a, b, right), (c, d, far_right), (up, far_up, all_of_it)) = [
                [dr.gather(types.Index4, self._table, entry + packet) for entry in row] for row in entries
            ]
            total = _signed(types, d - c - b + a)
            total += turns[0] * _signed(types, far_right - right)
            total += turns[1] * _signed(types, far_up - up)
            total += turns[0] * turns[1] * _signed(types, all_of_it)
            found.append(total * scale)
        return found


def _signed(types: ArrayTypes, packet: Array) -> Array:
    """A packet of unsigned numbers that wrapped around, as Floats."""
    return types.Vector4(*(types.Float(types.Int32(part)) for part in packet))
