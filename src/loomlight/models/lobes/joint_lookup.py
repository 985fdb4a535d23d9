"""Reads the factors of `joint_visibility`: joint over independent visibility of a view and a light.

The table has a row for each face, side of the light, view or light, and node: 16 azimuths of the 8 rings of
`hemisphere`. A row has the terms of two ratios, of warp and weft.
"""

from __future__ import annotations

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, clip, upload
from loomlight.models.lobes.hemisphere import AZIMUTHS, RINGS, NodeTaps, node_taps

# Terms of a ratio, and ratios: of warp and weft. Specular terms have that of diffuse ones: one of their own
# makes no difference to means over repeats.
JOINT_TERMS, JOINT_RATIOS = 4, 2
JOINT_FACTORS = JOINT_TERMS * JOINT_RATIOS
# Every second azimuth of the hemisphere: as many as visibility needs from point to point.
JOINT_AZIMUTHS = AZIMUTHS // 2
JOINT_NODES = JOINT_AZIMUTHS * RINGS
# Factors are signed 16-bit numbers in units of 1/FACTOR_UNIT, from −8 to 8.
FACTOR_UNIT = 4096.0
# Ratios above it, of families that are hardly seen or lit, are not trusted.
MAX_JOINT_RATIO = 4.0


def packed_factors(factors: NDArray[np.float64]) -> NDArray[np.int16]:
    """Factors as 16-bit numbers."""
    return np.clip(np.rint(factors * FACTOR_UNIT), -32768, 32767).astype(np.int16)


class JointLookup:
    """The factors of one fabric on one backend."""

    def __init__(self, factors: NDArray[np.int16], types: ArrayTypes) -> None:
        """
        Args:
            factors: [2 faces, 2 sides, view or light, JOINT_NODES, JOINT_FACTORS]; see `joint_visibility`.
        """
        self._types = types
        self._factors = upload(types.Float, factors / FACTOR_UNIT)

    def taps(self, direction: Vec3) -> NodeTaps:
        """Nodes around a unit vector [3] in the frame of the face seen."""
        return node_taps(direction, JOINT_AZIMUTHS)

    def ratios(
        self, view: NodeTaps, light: NodeTaps, back: Mask, is_transmission: Mask
    ) -> tuple[Float, Float]:
        """Joint over independent means of (warp, weft), 0 to `MAX_JOINT_RATIO`.

        Args:
            view, light: their `taps`.
            back: the back is seen.
            is_transmission: light comes from the other side.
        """
        types = self._types
        side = dr.select(back, types.UInt32(2), types.UInt32(0)) + dr.select(
            is_transmission, types.UInt32(1), types.UInt32(0)
        )
        row = side * (2 * JOINT_NODES)
        of_view, of_light = self._read(view, row), self._read(light, row + JOINT_NODES)
        ratios = []
        for first in range(0, JOINT_FACTORS, JOINT_TERMS):
            total: Float = 1
            for number in range(first, first + JOINT_TERMS):
                total = dr.fma(of_view[number], of_light[number], total)
            ratios.append(clip(total, 0, MAX_JOINT_RATIO))
        return ratios[0], ratios[1]

    def _read(self, taps: NodeTaps, row: UInt) -> list[Float]:
        """The interpolated factors of the rows from `row` on."""
        width = dr.width(row, taps.nodes[0])
        sums: list[Float] = [0] * JOINT_FACTORS
        for node, share in zip(taps.nodes, taps.weights.shares, strict=True):
            read = dr.gather(self._types.Vectors, self._factors, row + node, shape=(JOINT_FACTORS, width))
            sums = [dr.fma(factor, share, total) for factor, total in zip(read, sums, strict=True)]
        return sums
