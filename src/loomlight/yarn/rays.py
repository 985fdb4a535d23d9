"""Rays that are searched for yarn sample by sample: down to the cloth, and up to a light.

They pass by cells that they stay above, and elsewhere advance in steps that neither cross more than a
fraction of a thread nor fall by more than a fraction of the cloth's relief. The sides of the yarns are walls:
a ray that enters a thread's outline below its surface has hit it. How long a search goes on is for the caller
to say, so that rays may also take turns (`models/lobes/near_code.py`).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import drjit as dr

from loomlight.core.backend import array_types, clip, maximum, minimum
from loomlight.yarn.geometry import Probe
from loomlight.yarn.search import SearchQuality, Stride, Surface, Trail, extent_of, no_trail, roof_along

# Of the cubic that tells where a ray meets a yarn, and the least of its rate, as a share of the mean.
_NEWTON_STEPS = 3
_FLATTEST = 0.1
# Further looks where samples do not stand right behind outlines.
_LOOKS_FOR_OUTLINES = 3


def rising_ray(
    surface: Surface, x: Any, y: Any, height: Any, direction: Any, back: Any, quality: SearchQuality
) -> RisingRay:
    """The ray from a point of the cloth along a direction; see `unoccluded`."""
    roof = roof_along(surface, extent_of(surface, array_types(x)), x, y, height, direction, back)
    return rising_below(surface, x, y, height, direction, back, roof, quality)


def rising_below(
    surface: Surface,
    x: Any,
    y: Any,
    height: Any,
    direction: Any,
    back: Any,
    roof: Any,
    quality: SearchQuality,
) -> RisingRay:
    """The same, where nothing on the ray's way is higher than the roof."""
    types = array_types(x)
    extent = extent_of(surface, types)
    step = dr.rcp(maximum(quality.shadow_share * extent.steps_per_length(quality, direction), 1e-9))
    start = types.Vector3(x, y, height + extent.lift)
    return RisingRay(surface, start, direction, step, types.Bool(back), roof, quality.steps)


@dataclass
class Rising:
    """How far the search along a ray to a light has come.

    Attributes:
        distance: from its start.
        leap: from the sample before.
        free: nothing has been met.
        searching: the search goes on.
        count: samples.
        trail: of the sample before.
    """

    distance: Any
    leap: Any
    free: Any
    searching: Any
    count: Any
    trail: Trail


@dataclass
class RisingRay:
    """A ray to a light, on which yarn is looked for.

    Attributes:
        start: where it begins [3], right above the cloth.
        direction: unit vector [3], z > 0.
        step: length of ray between samples at the most.
        back: Bool, the face heights count from.
        roof: nothing on the way is higher.
        samples: at most so many.
    """

    surface: Surface
    start: Any
    direction: Any
    step: Any
    back: Any
    roof: Any
    samples: Any

    @cached_property
    def _stride(self) -> Stride:
        return Stride(self.direction, self.step)

    def started(self, active: Any) -> Rising:
        """Before the first sample."""
        types = array_types(self.step)
        nothing = types.Float(0 * self.step)
        searching = active & (self.start.z < self.roof)
        return Rising(nothing, nothing, active, searching, types.UInt32(0), no_trail(types, self.step))

    def advanced(self, now: Rising) -> Rising:
        """After one more sample."""
        direction, stride = self.direction, self._stride
        point = self.start + direction * now.distance
        here = self.surface.probe(point.x, point.y, self.back, stride.right, stride.up)
        clearance = point.z - here.height
        rate = direction.z - here.slope_x * direction.x - here.slope_y * direction.y
        met = now.searching & ~here.hole & (clearance < 0)
        dips, way_back = now.trail.dip_before(clearance, rate, now.leap, here)
        # The ray rises, so above the crest it stays above until it leaves the cell.
        clears = point.z > here.block.crest
        trail = now.trail.followed_by(clearance, rate, here, clears, dips)
        near = stride.onwards(here, clearance, rate)
        onwards = dr.select(clears, maximum(stride.out(here.block), self.step), near)
        # Where a dip is likely the next sample goes back to its lowest point.
        distance = now.distance + dr.select(dips, -way_back, onwards)
        leap = dr.select(dips, now.leap - way_back, onwards)
        count = now.count + 1
        below = dr.fma(direction.z, distance, self.start.z) < self.roof
        searching = now.searching & ~met & below & (count < self.samples)
        return Rising(distance, leap, now.free & ~met, searching, count, trail)


def falling_ray(surface: Surface, x: Any, y: Any, view: Any, back: Any, quality: SearchQuality) -> FallingRay:
    """The view ray that crosses the plane z = 0 at x, y; see `first_hit`."""
    types = array_types(x)
    vertical = maximum(view.z, 1e-4)
    slope = types.Vector2(view.x / vertical, view.y / vertical)
    # The ray is followed by its height, which falls by `step` each time.
    rate = extent_of(surface, types).steps_per_length(quality, view) / vertical
    return FallingRay(surface, x, y, slope, dr.rcp(maximum(rate, 1e-9)), types.Bool(back), quality.steps)


@dataclass
class Falling:
    """How far the search down a view ray has come.

    Attributes:
        height: of the next sample, or of the last one, which lies below the cloth.
        leap: how far it lies below the sample before.
        depth: of the last sample, below the cloth.
        rate: of clearance there, as the ray falls.
        smooth: the yarn there is the one of the sample before, with no outline and no leap between.
        searching: the search goes on.
        count: samples.
        trail: of the sample before.
    """

    height: Any
    leap: Any
    depth: Any
    rate: Any
    smooth: Any
    searching: Any
    count: Any
    trail: Trail


@dataclass
class FallingRay:
    """A view ray on its way down to the cloth.

    Attributes:
        x, y: where it crosses the plane z = 0, millimetres.
        slope: how far it moves along x and y as it rises by a millimetre [2].
        step: how far it falls between samples at the most.
        back: Bool, which face is seen.
        samples: at most so many.
    """

    surface: Surface
    x: Any
    y: Any
    slope: Any
    step: Any
    back: Any
    samples: Any

    @cached_property
    def _stride(self) -> Stride:
        # Moving down, the ray runs against the view's slope.
        return Stride(-self.slope, self.step)

    def _place(self, height: Any) -> tuple[Any, Any]:
        return dr.fma(self.slope.x, height, self.x), dr.fma(self.slope.y, height, self.y)

    def started(self, active: Any) -> Falling:
        """Before the first sample, below what the ray passes high above."""
        types = array_types(self.x)
        top, stride = types.Float(self._roof_height()), self._stride

        def fall(height: Any, falling: Any, count: Any) -> tuple[Any, ...]:
            block = self.surface.block(*self._place(height), self.back, stride.right, stride.up)
            above, out = height - block.crest, stride.out(block)
            onwards = falling & (above > out) & (count < self.samples)
            return height - clip(above, 0, out), onwards, count + 1

        # Cells that rays pass above ask little: most are passed here, before the search for yarn begins.
        top = dr.while_loop(
            (top, active, types.UInt32(0)), lambda height, falling, count: falling, fall, label="cloth: fall"
        )[0]
        nothing, hop = types.Float(0 * top), types.Float(stride.hop)
        trail, no = no_trail(types, top), types.Bool(False)
        return Falling(top, hop, nothing, types.Float(nothing), no, active, types.UInt32(0), trail)

    def _roof_height(self) -> Any:
        types = array_types(self.x)
        extent = extent_of(self.surface, types)
        upwards = types.Vector3(self.slope.x, self.slope.y, 1)
        return roof_along(self.surface, extent, self.x, self.y, 0, upwards, self.back)

    def advanced(self, now: Falling) -> Falling:
        """After one more sample, in lanes that are searched."""
        extent, stride = extent_of(self.surface, array_types(self.x)), self._stride
        floor = extent.low - (extent.high - extent.low)
        here = self.surface.probe(*self._place(now.height), self.back, stride.right, stride.up)
        clearance = now.height - here.height
        met = ~here.hole & (clearance <= 0)
        rate = self._rate(here)
        dips, way_back = now.trail.dip_before(clearance, rate, now.leap, here)
        smooth = now.trail.known & ~here.hole & (now.trail.yarn == here.yarn)
        count = now.count + 1
        onwards = now.searching & ~met & (now.height > floor) & (count < self.samples)
        near = stride.onwards(here, clearance, rate)
        # Down to the crest the ray falls freely.
        free = minimum(stride.out(here.block), now.height - here.block.crest)
        trail = now.trail.followed_by(clearance, rate, here, free > near, dips | ~onwards)
        farther = maximum(free, near)
        # Where a dip is likely the next sample goes back to its lowest point.
        return Falling(
            dr.select(onwards, now.height + dr.select(dips, way_back, -farther), now.height),
            dr.select(onwards, dr.select(dips, now.leap - way_back, farther), now.leap),
            -clearance,
            rate,
            smooth,
            onwards,
            count,
            trail,
        )

    def _rate(self, here: Probe) -> Any:
        return dr.fma(here.slope_x, self.slope.x, dr.fma(here.slope_y, self.slope.y, -1))

    def refined(self, end: Falling, refinements: Any) -> Any:
        """Height at which the ray meets the cloth that lies below it at one sample and above it at the next.

        On one yarn that is the root of the cubic through both, from which `refinements` steps of Newton's
        lead on. Elsewhere the ray has passed an outline, right behind which it was sampled: looks come closer
        to the last sample.
        """
        types = array_types(self.x)
        extent, stride = extent_of(self.surface, types), self._stride
        relief, smooth, trail = extent.high - extent.low, end.smooth, end.trail
        looks = refinements + (0 if self.surface.tells_outlines else _LOOKS_FOR_OUTLINES)

        def refine(
            index: Any, above: Any, under: Any, above_gap: Any, under_gap: Any, side: Any, middle: Any
        ) -> tuple[Any, ...]:
            here = self.surface.probe(*self._place(middle), self.back, stride.right, stride.up)
            rate = self._rate(here)
            gap = clip(middle - dr.select(here.hole, types.Float(-1e9), here.height), -relief, relief)
            met = gap <= 0
            above, under = dr.select(met, above, middle), dr.select(met, middle, under)
            # Regula falsi: an end that stays twice counts half (the Illinois rule), so that both close in; at
            # walls, where the gap jumps, this comes to halving.
            above_gap = dr.select(met, dr.select(side > 0, 0.5 * above_gap, above_gap), gap)
            under_gap = dr.select(met, -gap, dr.select(side < 0, 0.5 * under_gap, under_gap))
            between = _between(above, under, above_gap, under_gap)
            rooted = clip(middle + gap / minimum(rate, -1e-6), under, above)
            return (
                index + 1,
                above,
                under,
                above_gap,
                under_gap,
                dr.select(met, types.Float(1), -1),
                dr.select(smooth, rooted, between),
            )

        under, length = end.height, end.leap
        above = under + length
        above_gap, under_gap = clip(trail.clearance, 0, relief), clip(end.depth, 0, relief)
        root = _cubic_root(above_gap, -under_gap, trail.rate * length, end.rate * length)
        middle = dr.select(smooth, dr.fma(-root, length, above), _between(above, under, above_gap, under_gap))
        start = (types.UInt32(0), above, under, above_gap, under_gap, types.Float(0 * above), middle)
        _, _, under, _, _, _, middle = dr.while_loop(
            start, lambda index, *rest: index < looks, refine, label="cloth: refine"
        )
        return dr.select(smooth, middle, under)


def _between(above: Any, under: Any, above_gap: Any, under_gap: Any) -> Any:
    """The height that a straight line suggests, kept off both ends, where gaps may jump."""
    share = clip(above_gap / maximum(above_gap + under_gap, 1e-20), 0.02, 0.98)
    return dr.fma(share, under - above, above)


def _cubic_root(start: Any, end: Any, start_rate: Any, end_rate: Any) -> Any:
    """Where in [0, 1] a cubic is 0 that starts above 0 and ends below; rates are of the whole interval."""
    gain = end - start
    cubic = start_rate + end_rate - 2 * gain
    bend = 3 * gain - 2 * start_rate - end_rate
    share = start * dr.rcp(maximum(-gain, 1e-20))
    for _ in range(_NEWTON_STEPS):
        value = dr.fma(dr.fma(dr.fma(cubic, share, bend), share, start_rate), share, start)
        rate = dr.fma(dr.fma(3 * cubic, share, 2 * bend), share, start_rate)
        # Where the cubic is flat, steps stay short.
        share = clip(share - value / minimum(rate, _FLATTEST * gain - 1e-20), 0, 1)
    return share
