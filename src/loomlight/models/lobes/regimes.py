"""The two regimes of a footprint: point-sampled below a yarn, prefiltered above, and the blend between.

Below a yarn, appearance depends on shadows and outlines, which the moments of groups do not resolve; above
it, the groups have a smaller error than a few points.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import drjit as dr

from loomlight.core.arrays import Float
from loomlight.core.backend import ArrayTypes, array_types, clip, maximum
from loomlight.core.footprint import Footprint
from loomlight.models.lobes.point_sampled import points_of
from loomlight.yarn.layout import ClothLayout

# Sides of footprints in threads: below the first, points alone are used; above the second, groups alone.
# Where squares of the pyramid are wider than a thread, the unit is this fraction of their side instead.
BLEND_RANGE = 0.6, 1.6
SQUARE_SCALE = 0.8
# Smallest side of a footprint, millimetres: not log₂ 0.
MIN_FOOTPRINT_SIDE = 1e-9


@dataclass
class Regime:
    """Weights of the two regimes that evaluate a footprint.

    Attributes:
        prefiltered: weight of the groups, 0 to 1; points have the rest.
        threads: side of the footprint, in threads.
        points: number of points evaluated; the last one is weighted by its fraction; 0 is none.
    """

    prefiltered: Float
    threads: Float
    points: Float


class RegimeScale:
    """The lengths that separate the regimes of one fabric, on one backend."""

    def __init__(self, layout: ClothLayout, square: float, types: ArrayTypes) -> None:
        """
        Args:
            square: side of the squares of the pyramid's first level, millimetres.
        """
        picks, ends = layout.warp_on_top.shape
        width, height = layout.size
        thread = math.sqrt(width / ends * height / picks)
        unit = max(thread, SQUARE_SCALE * square)
        self._threads_per_mm = dr.opaque(types.Float, 1 / thread)
        self._unit_level = dr.opaque(types.Float, math.log2(unit))

    def of(self, footprint: Footprint) -> Regime:
        """The regime of footprints: the weight is smooth in the logarithm of their side."""
        side = footprint.spread_side
        low, high = (math.log2(bound) for bound in BLEND_RANGE)
        level = dr.log2(maximum(side, MIN_FOOTPRINT_SIDE)) - self._unit_level
        ramp = clip((level - low) * (1 / (high - low)), 0, 1)
        prefiltered = dr.square(ramp) * dr.fma(-2, ramp, 3)
        threads = array_types(side).Float(side * self._threads_per_mm)
        return Regime(prefiltered, threads, points_of(threads, prefiltered, footprint.samples))
