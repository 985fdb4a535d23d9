"""Anisotropic lookups in the coverage pyramid: the fraction of a footprint that each group covers.

A footprint is the mean of nine taps, three along each of its edges, each at the nearest node of the pyramid,
as anisotropic filtering reads mip maps: footprints are elongated and rotated against the threads, and one
square tap does not fit them.

A pixel's box filter has zeros at the frequencies f of the pixel grid, where f·a and f·b are integers (not
both 0) for its edges a and b: threads near such a frequency would alias to long waves, but vanish from the
box. Nine equal taps a third of the edges apart have the same zeros, except where both integers are multiples
of 3, which the taps' own filter damps. So all taps of a footprint are of one level: taps of two levels fill
the zeros, and pictures show rings of moiré.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Mask, UInt
from loomlight.core.backend import ArrayTypes, clip, maximum, minimum, upload
from loomlight.core.footprint import Footprint
from loomlight.models.lobes.packed_uint8 import mean_of_packs

# Variance of the first level's tent filters over that of the square they stand for: at 1 estimates err 1.5 %
# more, at 1.6 they lose contrast.
TENT_VARIANCE = 1.3
# Positions of the taps in units of the footprint's edges.
TAP_OFFSETS = tuple((i / 3, j / 3) for i in (-1, 0, 1) for j in (-1, 0, 1))
# Largest side of a tap over that of the footprint; the smallest is half of it. Pictures of three fabrics have
# the same error from 0.6 to 0.75; smaller taps damp threads at three times the pixels' frequency too little.
TAP_SIZE = 0.68
# The least spacing of the taps, in units of `base_size`: that of the first level's nodes.
MIN_TAP_SPACING = 1 / 3
# Smallest extent of a footprint that is divided by, in units of `base_size`.
MIN_FOOTPRINT = 1e-6


@dataclass
class CoverageTaps:
    """Nodes of the pyramid whose mean stands for a footprint.

    Attributes:
        nodes: their indices.
    """

    nodes: list[UInt]


class CoverageLookup:
    """The coverage pyramid on one backend.

    CPUs load contiguous words at once and gather single words one by one. So groups are loaded two packs at a
    time, and holes, whose bytes are stored apart, eight nodes at a time, of which one is used.

    Attributes:
        pack_pairs: pairs of packs of groups a node.
    """

    def __init__(
        self,
        base_size: float,
        levels: NDArray[np.int64],
        table: NDArray[np.uint8],
        repeat: tuple[float, float],
        types: ArrayTypes,
    ) -> None:
        """Uploads a pyramid.

        Args:
            base_size, levels, table: see `CoveragePyramid`.
            repeat: width and height of the repeat, millimetres.
        """
        self._types = types
        self._inverse_size = dr.opaque(types.Float, 1 / base_size)
        self._inverse_repeat = [dr.opaque(types.Float, 1 / side) for side in repeat]
        self._last_level = dr.opaque(types.Float, len(levels) - 1)
        self._face = dr.opaque(types.UInt32, table.shape[1])
        # Node indices stay below 2²⁴, which float32 holds exactly.
        self._levels = upload(types.Float, np.pad(levels, ((0, 0), (0, 1))).astype(np.float32))
        self.pack_pairs = (table.shape[2] - 4) // 8
        self._row = dr.opaque(types.UInt32, self.pack_pairs)
        self._groups = upload(types.UInt32, np.ascontiguousarray(table[..., :-4]).view("<u4"))
        holes = table[..., -4].ravel()
        self._holes = upload(types.UInt32, np.pad(holes, (0, -holes.size % 8)).view("<u4"))

    def taps(self, footprint: Footprint, back: Mask) -> CoverageTaps:
        """Nodes that stand for a footprint, millimetres, of the face that is seen."""
        types = self._types
        level, spacing = self._level_and_spacing(footprint)
        first, columns, rows, _ = dr.gather(types.Vector4, self._levels, types.UInt32(level))
        start = dr.select(back, self._face, 0)
        nodes = self._nodes(footprint, spacing, first, columns, rows)
        return CoverageTaps([start + types.UInt32(node) for node in nodes])

    def groups(self, taps: CoverageTaps, pack_pair: UInt) -> list[list[Float]]:
        """Means over the taps of the bytes of two packs, 0 to 255: twice four Floats."""
        packs = [
            dr.gather(self._types.Index2, self._groups, dr.fma(node, self._row, pack_pair))
            for node in taps.nodes
        ]
        return [mean_of_packs(self._types, [pair[half] for pair in packs]) for half in range(2)]

    def holes(self, taps: CoverageTaps) -> Float:
        """Mean over the taps of the byte of holes, 0 to 255."""
        total = self._types.UInt32(0)
        for node in taps.nodes:
            packs = dr.gather(self._types.Index2, self._holes, node >> 3)
            total += (dr.select((node & 4) == 4, packs.y, packs.x) >> ((node & 3) << 3)) & 255
        return self._types.Float(total) * (1 / len(taps.nodes))

    def _level_and_spacing(self, footprint: Footprint) -> tuple[Float, Float]:
        """The pyramid level of a footprint's taps, and their spacing.

        Returns:
            the level, an integer; and the spacing of the taps in units of a third of the footprint. The
            spacing is below 1 where taps are nearly as large as the footprint, so that their union is not too
            wide, but no less than the spacing of nodes: nine taps at one node would show as steps.
        """
        relative = footprint.spread_side * self._inverse_size
        level: Float = dr.log2(maximum(TAP_SIZE * relative, 1))
        level = minimum(dr.floor(level), self._last_level)
        inverse = dr.rcp(maximum(relative, MIN_FOOTPRINT))
        spacing = dr.sqrt(clip(TENT_VARIANCE * (1 - dr.square(inverse)), 0, 1))
        return level, minimum(maximum(spacing, MIN_TAP_SPACING * inverse), 1)

    def _nodes(
        self, footprint: Footprint, spacing: Float, first: Float, columns: Float, rows: Float
    ) -> Iterator[Float]:
        """Indices of the nodes at `TAP_OFFSETS`, integers.

        Args:
            first, columns, rows: first node, columns and rows of the level.
        """
        across, along = self._inverse_repeat
        x, y = footprint.centre.x * across, footprint.centre.y * along
        first_x, second_x = (spacing * edge.x * across for edge in (footprint.duv_dx, footprint.duv_dy))
        first_y, second_y = (spacing * edge.y * along for edge in (footprint.duv_dx, footprint.duv_dy))
        for s, t in TAP_OFFSETS:
            column = _wrapped_cell(dr.fma(s, first_x, dr.fma(t, second_x, x)), columns)
            row = _wrapped_cell(dr.fma(s, first_y, dr.fma(t, second_y, y)), rows)
            yield dr.fma(row, columns, column) + first


def _wrapped_cell(position: Float, count: Float) -> Float:
    """Index of the cell, of so many along the repeat, that holds a position in units of the repeat."""
    return minimum(dr.floor((position - dr.floor(position)) * count), count - 1)
