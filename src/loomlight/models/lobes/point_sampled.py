"""The point-sampled regime: the mean of the point model over a few points of the footprint.

Points are spread evenly, the first at the centre, and their number grows with the footprint.

Discontinuities within a footprint are lines: outlines and edges of shadows. The offsets minimize, for any
number of points, the last one weighted by its fraction, the error of the area of a square on one side of a
random line (`tools/fits/near_points.py`): half the error of the plastic-number sequence (Roberts 2018), a
third with eight points.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from copy import copy
from dataclasses import dataclass

import drjit as dr

from loomlight.aggregate.components import components, light_visibility
from loomlight.core.arrays import Array, Float, UInt, Vec3
from loomlight.core.backend import ArrayTypes, array_types, clip, maximum, minimum
from loomlight.core.footprint import Footprint
from loomlight.models.separable import Components
from loomlight.scattering.interreflection import Blocked, Interreflection
from loomlight.scattering.point import YarnScattering, to_face_frame
from loomlight.yarn.layout import ClothLayout
from loomlight.yarn.rays import DEFAULT_QUALITY, SearchQuality
from loomlight.yarn.visibility import passes_through

MAX_POINTS = 8
# The most where groups have all the weight: with one point, irregular weaves err by .18 at 1.3 to 1.6
# threads.
MAX_POINTS_BESIDE_GROUPS = 4
# Points for every thread that a footprint is wide. With 16, errors of footprints under a thread are 6 to 15 %
# lower, and rows of pixels over all sizes take a tenth longer.
POINTS_PER_THREAD = 12.0
POINT_OFFSETS = (
    (0.0, 0.0),
    (-0.2301, 0.3567),
    (0.3681, -0.2294),
    (-0.2804, -0.344),
    (0.3466, 0.2886),
    (-0.3635, 0.0511),
    (0.0993, -0.357),
    (0.1071, 0.3288),
)
# Sides of footprints, in threads: below the first, yarns are searched as finely as by the point model; above
# the second with `COARSE_QUALITY`: nine hits in ten within 1/100 of a thread (median 1e-5), 99 in 100 within
# 1/20. Shadow rays take smaller steps: with 0.95 plain weave and satin are up to 4 % too bright, with 1.6
# 1.5 %.
FINEST_FOOTPRINT, COARSEST_FOOTPRINT = 1 / 32, 1 / 8
COARSE_QUALITY = SearchQuality(steps_per_thread=2.5, shadow_share=1.6, refinements=1)


def points_of(threads: Float, prefiltered: Float, samples: Float) -> Float:
    """Number of points that sample a footprint, 0 to `MAX_POINTS`; the last one is weighted by its fraction.

    Args:
        threads: side of the footprint, in threads.
        prefiltered: weight of the groups; the more they weigh, the fewer points are needed.
        samples: footprints averaged by a pixel, which divide its points among them.
    """
    most = dr.lerp(array_types(threads).Float(MAX_POINTS), MAX_POINTS_BESIDE_GROUPS, prefiltered)
    most = maximum(most * dr.rcp(array_types(threads).Float(samples)), 1)
    return dr.select(prefiltered < 1, clip(threads * POINTS_PER_THREAD, 1, most), 0)


def quality_of(size: Float) -> SearchQuality:
    """Quality of the search of yarns for footprints of a side, in threads."""
    types = array_types(size)
    detail = (math.log2(COARSEST_FOOTPRINT) - dr.log2(maximum(size, 1e-9))) * (
        1 / math.log2(COARSEST_FOOTPRINT / FINEST_FOOTPRINT)
    )
    detail = clip(detail, 0, 1)

    def between(coarse: float, fine: float) -> Float:
        return dr.fma(fine - coarse, detail, coarse)

    steps = between(COARSE_QUALITY.steps_per_thread, DEFAULT_QUALITY.steps_per_thread)
    return SearchQuality(
        steps,
        steps,
        shadow_share=between(COARSE_QUALITY.shadow_share, DEFAULT_QUALITY.shadow_share),
        refinements=types.UInt32(between(COARSE_QUALITY.refinements, DEFAULT_QUALITY.refinements) + 0.5),
    )


def with_search_quality(model: YarnScattering, size: Float) -> YarnScattering:
    """The model with the search quality of footprints of a side, in threads."""
    searched = copy(model)
    searched.quality = quality_of(size)
    return searched


@dataclass
class SampledPoints:
    """Means over the points of footprints; 0 without points.

    Attributes:
        hole: fraction of holes.
        components: for each light.
        blocked: blocked shares of the sky of warp and of weft; None without light between yarns.
    """

    hole: Float
    components: list[Components]
    blocked: tuple[Blocked, Blocked] | None


def point_sampled(
    model: YarnScattering,
    between: Interreflection | None,
    points: Float,
    lights: Sequence[Vec3],
    view: Vec3,
    footprint: Footprint,
) -> SampledPoints:
    """Means over a number of points."""

    size = footprint.spread_side if model.has_detail else None

    def measure(x: Float, y: Float) -> tuple[Float, ...]:
        point = model.locate(x, y, view, size=size)
        values = [dr.select(point.hole, array_types(view.x).Float(1), 0)]
        if between is not None:
            normal = point.normal if point.surface_normal is None else point.surface_normal
            blocked = between.blocked_at(point.is_warp, point.back, normal.z, point.height - point.plane)
            for family in (point.is_warp, ~point.is_warp):
                for part in (blocked.by_warp, blocked.by_weft, blocked.far):
                    values.append(dr.select(family & ~point.hole, part, 0))
        for light in lights:
            visible = model.visibility(point, light)
            values += components(model.appearance, point, light, view, visible)
            values.append(light_visibility(point, visible))
        return tuple(values)

    width = dr.width(view, list(lights), footprint.centre, points)
    shares = 0 if between is None else 6
    hole, *means = _mean(measure, 1 + shares + 5 * len(lights), footprint, points, width)
    blocked = None if between is None else (Blocked(*means[:3]), Blocked(*means[3:6]))
    parts = [Components(*means[first : first + 5]) for first in range(shares, len(means), 5)]
    return SampledPoints(hole, parts, blocked)


def point_sampled_hole(model: YarnScattering, points: Float, view: Vec3, footprint: Footprint) -> Float:
    """Fraction of a number of points that are holes; 0 without points."""
    types = array_types(view.x)

    def measure(x: Float, y: Float) -> tuple[Float, ...]:
        back = types.Bool(view.z < 0)
        is_null = passes_through(model.surface, x, y, to_face_frame(view, back), back, True, model.quality)
        return (dr.select(is_null, types.Float(1), 0),)

    width = dr.width(view, footprint.centre, points)
    return _mean(measure, 1, footprint, points, width)[0]


def _offset(types: ArrayTypes, number: UInt) -> tuple[Float, Float]:
    """Offset of a point from the centre, in units of the footprint's edges."""
    s, t = (types.Float(part) for part in POINT_OFFSETS[0])
    for other, (across, along) in enumerate(POINT_OFFSETS[1:], 1):
        s, t = dr.select(number == other, across, s), dr.select(number == other, along, t)
    return s, t


def _mean(
    measure: Callable[[Float, Float], tuple[Float, ...]],
    count: int,
    footprint: Footprint,
    points: Float,
    width: int,
) -> list[Float]:
    """Means of `count` Floats over the points of footprints."""
    types = array_types(points)

    def add(number: UInt, *sums: Float) -> tuple[Array, ...]:
        position = footprint.at(*_offset(types, number))
        weight = minimum(points - types.Float(number), 1)
        values = measure(position.x, position.y)
        return number + 1, *(dr.fma(weight, part, total) for part, total in zip(values, sums, strict=True))

    start = (dr.zeros(types.UInt32, width), *(dr.zeros(types.Float, width) for _ in range(count)))
    total = dr.while_loop(
        start, lambda number, *sums: types.Float(number) < points, add, label="lobes: points"
    )[1:]
    inverse = dr.rcp(maximum(points, 1))
    return [part * inverse for part in total]


# ---------------------------------------------------------------------------------------------------- regimes
# The two regimes of a footprint: point-sampled below a yarn, prefiltered above, and the blend between.
#
# Below a yarn, appearance depends on shadows and outlines, which the moments of groups do not resolve;
# above it, the groups have a smaller error than a few points.


# Sides of footprints in threads: below the first, points alone are used; above the second, groups alone.
# Where squares of the pyramid are wider than a thread, the unit is this fraction of their side instead.
BLEND_RANGE = 0.7, 2.0
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
