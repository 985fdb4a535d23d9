"""Ray marching through the height field of the cloth: shadow rays up to a light, view rays down to the cloth.

Rays skip cells whose maximum they stay above. Elsewhere a step crosses at most a fraction of a thread and
falls by at most a fraction of the cloth's relief. The sides of the yarns are walls: a ray that enters a
thread's outline below its surface has hit it. A ray holds what does not change, its state what a step
changes; the loop is the caller's (`visibility.py`).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Protocol

import drjit as dr

from loomlight.core.arrays import Float, FloatType, Mask, UInt, Vec2, Vec3
from loomlight.core.backend import ArrayTypes, array_types, clip, masked_branch, maximum, minimum
from loomlight.yarn.flanks import Sheet, SurfacePoint
from loomlight.yarn.geometry import CellBounds, Probe

# Rays start above the surface by this fraction of the finest thread, so that rounding does not shadow it.
LIFT = 2e-3
# A dip closer to a sample than this fraction of the step is that sample.
NARROWEST_DIP = 0.02
# How far behind an outline the next sample is placed, in steps.
OUTLINE_EPSILON = 5e-3


class Surface(Protocol):
    """A source of cloth geometry."""

    size: tuple[float, float]
    extents: dict[FloatType, Any]  # cache of `extent_of`

    @property
    def finest(self) -> tuple[float, float]:
        """Smallest extent that a search must not step over, along x and y, millimetres."""

    @property
    def height_bounds(self) -> tuple[float, float]:
        """Bounds of all heights on either face, millimetres."""

    def height(self, x: Float, y: Float, back: Mask) -> tuple[Float, Mask]:
        """Height and hole at draft coordinates, millimetres."""

    def max_heights(self, x: Float, y: Float, back: Mask, right: Mask, up: Mask) -> list[tuple[float, Float]]:
        """Bounds of heights ahead of a position, the widest window first: (distance, bound).

        Args:
            right, up: whether the search goes towards larger x and larger y.

        Returns:
            distances along x and y in units of `finest`, and bounds as fractions of the upper one of
            `height_bounds`.
        """

    def probe(self, x: Float, y: Float, back: Mask, right: Mask, up: Mask) -> Probe:
        """The surface at draft coordinates (millimetres), for a search; `right` and `up` as above."""

    def cell_bounds(self, x: Float, y: Float, back: Mask, right: Mask, up: Mask) -> CellBounds:
        """The part of `probe` that rays above the cell need."""

    def surface(self, x: Float, y: Float, back: Mask, ray: tuple[Vec3, Float] | None = None) -> SurfacePoint:
        """The point at draft coordinates, millimetres; for `ray` see `YarnGeometry.surface`."""

    def sheets(self, x: Float, y: Float, back: Mask) -> list[Sheet]:
        """What lies behind the yarn that shows at draft coordinates, millimetres, next to it first."""


@dataclass(frozen=True)
class SearchQuality:
    """Resolution of ray searches. All fields but `steps` may be Dr.Jit arrays.

    Attributes:
        steps_per_thread: steps while crossing the finest thread.
        steps_per_relief: steps while falling through the whole relief of the cloth.
        shadow_share: fraction of these steps that shadow rays take.
        refinements: evaluations of the surface after a hit is bracketed.
        steps: most samples of a ray; one that has hit nothing by then is free.
    """

    steps_per_thread: Float = 5.0
    steps_per_relief: Float = 8.0
    shadow_share: Float = 1.0
    refinements: UInt = 2
    steps: int = 1024


DEFAULT_QUALITY = SearchQuality()
REFERENCE_QUALITY = SearchQuality(48, 48, refinements=20, steps=16384)


class Extent:
    """Lengths that steps are measured by, opaque to Dr.Jit so that all fabrics share kernels.

    Attributes:
        lengths: the finest extents along x and y, and bounds of heights, as numbers.
        low, high: bounds of all heights, millimetres.
        lift: distance of a ray's origin above the surface, millimetres.
    """

    def __init__(self, lengths: tuple[float, float, float, float], types: ArrayTypes) -> None:
        self.lengths = lengths
        fine_x, fine_y, low, high = lengths
        self.low, self.high = dr.opaque(types.Float, low), dr.opaque(types.Float, high)
        self.lift = dr.opaque(types.Float, LIFT * min(fine_x, fine_y))
        self._per_x, self._per_y = dr.opaque(types.Float, 1 / fine_x), dr.opaque(types.Float, 1 / fine_y)
        self._per_relief = dr.opaque(types.Float, 1 / max(high - low, 1e-6))

    def threads(self, x: Float, y: Float) -> Float:
        """Upper bound of the threads that a path of lengths x and y (millimetres, any sign) crosses."""
        return maximum(abs(x) * self._per_x, abs(y) * self._per_y)

    def steps_per_length(self, quality: SearchQuality, direction: Vec3) -> Float:
        """Steps per millimetre of ray along a unit direction [3]."""
        return maximum(
            self.threads(direction.x, direction.y) * quality.steps_per_thread,
            abs(direction.z) * self._per_relief * quality.steps_per_relief,
        )


def extent_of(surface: Surface, types: ArrayTypes) -> Extent:
    """The extent of a surface, uploaded at first use and after an edit of its heights."""
    lengths = *surface.finest, *surface.height_bounds
    kept: Extent | None = surface.extents.get(types.Float)
    if kept is None or kept.lengths != lengths:
        kept = surface.extents[types.Float] = Extent(lengths, types)
    return kept


def upload_extent(surface: Surface, types: ArrayTypes) -> None:
    """Uploads the extent now; see `extent_of`."""
    extent_of(surface, types)


def max_height_along(
    surface: Surface, extent: Extent, x: Float, y: Float, height: Float, direction: Vec3, back: Mask
) -> Float:
    """Bound of heights (millimetres) that a ray from x, y, `height` meets before it is above that bound.

    Args:
        direction: of the ray [3], z > 0; of any length.
    """
    threads = extent.threads(direction.x, direction.y) / direction.z
    max_height = extent.high
    for radius, share in surface.max_heights(x, y, back, direction.x > 0, direction.y > 0):
        reached = (max_height - height) * threads <= radius
        max_height = dr.select(reached, minimum(max_height, share * extent.high), max_height)
    return max_height


@dataclass
class PreviousSample:
    """The previous sample of a ray.

    The cubic Hermite interpolant to the next sample finds rays that graze a yarn between the two; without it
    shadows and outlines of smooth yarns would be scalloped.

    Attributes:
        clearance: height of the ray above the cloth, millimetres; 1e9 in a hole.
        rate: derivative of clearance along the ray.
        yarn: number of the yarn; see `Probe`.
        known: whether the interpolant is valid.
    """

    clearance: Float
    rate: Float
    yarn: UInt
    known: Mask

    def dip_before(self, clearance: Float, rate: Float, step: Float, here: Probe) -> tuple[Mask, Float]:
        """Whether the cubic to the sample `step` ahead dips below the yarn, and how far before the sample."""
        types = array_types(clearance)
        falls = self.known & ~here.hole & (self.yarn == here.yarn) & (self.rate < 0) & (rate > 0)
        fall, rise = self.rate * step, rate * step
        # The cubic lies in the convex hull of its Bézier points, and few samples have one below the yarn.
        may_dip = falls & ((dr.fma(3, self.clearance, fall) < 0) | (dr.fma(3, clearance, -rise) < 0))

        def look(_: tuple[Mask, Float]) -> tuple[Mask, Float]:
            # The minimum of the cubic: the upward zero crossing of its derivative, a parabola.
            gain = clearance - self.clearance
            bend, linear = 3 * (fall + rise - 2 * gain), 6 * gain - 4 * fall - 2 * rise
            root = dr.sqrt(maximum(dr.fma(linear, linear, -4 * bend * fall), 0))
            share = -2 * fall / maximum(linear + root, 1e-20)
            rest = 1 - share
            start = (self.clearance * dr.fma(2, share, 1) + fall * share) * dr.square(rest)
            end = (clearance * dr.fma(2, rest, 1) - rise * rest) * dr.square(share)
            # A minimum at an end of the step is a sample that was taken.
            inside = (share > NARROWEST_DIP) & (rest > NARROWEST_DIP)
            return inside & (start + end < 0), rest * step

        # The branch skips a root and a quotient, a third of the cost of a sample.
        return masked_branch(may_dip, (types.Bool(False), types.Float(0)), look, "cloth: dip")

    def after_sample(
        self, clearance: Float, rate: Float, here: Probe, is_cell_exit: Mask, stays: Mask
    ) -> PreviousSample:
        """The sample that was just taken, or this one where it `stays`.

        Steps over whole cells are too long for the interpolant, so it is not known after them.
        """
        return PreviousSample(
            dr.select(stays, self.clearance, dr.select(here.hole, 1e9, clearance)),
            dr.select(stays, self.rate, rate),
            dr.select(stays, self.yarn, here.yarn),
            dr.select(stays, self.known, ~here.hole & ~is_cell_exit),
        )


def no_previous_sample(types: ArrayTypes, like: Float) -> PreviousSample:
    zero = types.Float(0 * like)
    return PreviousSample(zero, types.Float(zero), types.UInt32(0), types.Bool(False))


class StepControl:
    """Step size control: how far a ray goes from one sample to the next.

    Attributes:
        step: longest step, in units of the direction [3], which need not be a unit vector.
        right, up: whether the ray goes towards larger x and larger y.
        epsilon: distance behind an outline at which the next sample is placed.
    """

    def __init__(self, direction: Vec3, step: Float) -> None:
        self.step = step
        self.epsilon = OUTLINE_EPSILON * step
        self._per_x = dr.rcp(maximum(abs(direction.x), 1e-9))
        self._per_y = dr.rcp(maximum(abs(direction.y), 1e-9))
        self.right, self.up = direction.x > 0, direction.y > 0

    def to_cell_exit(self, bounds: CellBounds) -> Float:
        """Length of ray to just behind the cell's boundary."""
        return maximum(minimum(bounds.side_x * self._per_x, bounds.side_y * self._per_y), 0) + self.epsilon

    def to_next_sample(self, probe: Probe, clearance: Float, rate: Float) -> Float:
        """Length of ray to the next sample.

        A step ends right behind the next outline, where a wall may stand. A ray whose `clearance`, changing
        at `rate`, would be negative by then stops just before the outline first; it could leave the yarn
        through its flank otherwise.
        """
        edge = minimum(probe.edge_x * self._per_x, probe.edge_y * self._per_y)
        sinks = ~probe.hole & (dr.fma(rate, edge, clearance) < 0) & (edge > 2 * self.epsilon)
        beside = dr.select(sinks, edge - self.epsilon, maximum(edge, 0) + self.epsilon)
        return minimum(self.step, beside)


# ---------------------------------------------------------------------------------- shadow rays and view rays


# Newton steps on the cubic whose root is the intersection, and the least slope they divide by, as a share of
# the cubic's mean slope.
NEWTON_STEPS = 3
FLATTEST_SHARE = 0.1


def shadow_ray(
    surface: Surface, x: Float, y: Float, height: Float, direction: Vec3, back: Mask, quality: SearchQuality
) -> ShadowRay:
    """The shadow ray from a point of the cloth along a direction; see `visibility.unoccluded`."""
    max_height = max_height_along(surface, extent_of(surface, array_types(x)), x, y, height, direction, back)
    return shadow_ray_below(surface, x, y, height, direction, back, max_height, quality)


def shadow_ray_below(
    surface: Surface,
    x: Float,
    y: Float,
    height: Float,
    direction: Vec3,
    back: Mask,
    max_height: Float,
    quality: SearchQuality,
) -> ShadowRay:
    """`shadow_ray` with a known bound of all heights along the ray, `max_height` (millimetres)."""
    types = array_types(x)
    extent = extent_of(surface, types)
    step = dr.rcp(maximum(quality.shadow_share * extent.steps_per_length(quality, direction), 1e-9))
    start = types.Vector3(x, y, height + extent.lift)
    return ShadowRay(surface, start, direction, step, types.Bool(back), max_height, quality.steps)


@dataclass
class ShadowRayState:
    """State of the search along a shadow ray.

    Attributes:
        distance: of the next sample from the start, millimetres.
        last_step: length from the previous sample to the next one, millimetres.
        free: nothing has been hit.
        searching: the search goes on.
        count: samples so far.
        previous: the previous sample.
    """

    distance: Float
    last_step: Float
    free: Mask
    searching: Mask
    count: UInt
    previous: PreviousSample


@dataclass
class ShadowRay:
    """A ray from the cloth to a light.

    Attributes:
        start: origin [3], a small distance above the cloth, millimetres.
        direction: unit vector [3], z > 0.
        step: longest distance between samples, millimetres.
        back: the face that heights are measured from.
        max_height: bound of all heights along the ray, millimetres.
        samples: most samples to take.
    """

    surface: Surface
    start: Float
    direction: Vec3
    step: Float
    back: Mask
    max_height: Float
    samples: UInt

    @cached_property
    def _steps(self) -> StepControl:
        return StepControl(self.direction, self.step)

    def initial_state(self, active: Mask) -> ShadowRayState:
        """The state before the first sample."""
        types = array_types(self.step)
        nothing = types.Float(0 * self.step)
        searching = active & (self.start.z < self.max_height)
        return ShadowRayState(
            nothing, nothing, active, searching, types.UInt32(0), no_previous_sample(types, self.step)
        )

    def next_state(self, now: ShadowRayState) -> ShadowRayState:
        """The state after one more sample."""
        direction, steps = self.direction, self._steps
        point = self.start + direction * now.distance
        here = self.surface.probe(point.x, point.y, self.back, steps.right, steps.up)
        clearance = point.z - here.height
        rate = direction.z - here.slope_x * direction.x - here.slope_y * direction.y
        met = now.searching & ~here.hole & (clearance < 0)
        dips, way_back = now.previous.dip_before(clearance, rate, now.last_step, here)
        # The ray rises: once above the cell's maximum, it stays above until it leaves the cell.
        clears = point.z > here.cell_bounds.cell_max
        previous = now.previous.after_sample(clearance, rate, here, clears, dips)
        near = steps.to_next_sample(here, clearance, rate)
        ahead = dr.select(clears, maximum(steps.to_cell_exit(here.cell_bounds), self.step), near)
        # Where the cubic dips below the yarn, the next sample goes back to its lowest point.
        distance = now.distance + dr.select(dips, -way_back, ahead)
        last_step = dr.select(dips, now.last_step - way_back, ahead)
        count = now.count + 1
        below = dr.fma(direction.z, distance, self.start.z) < self.max_height
        searching = now.searching & ~met & below & (count < self.samples)
        return ShadowRayState(distance, last_step, now.free & ~met, searching, count, previous)


def view_ray(surface: Surface, x: Float, y: Float, view: Vec3, back: Mask, quality: SearchQuality) -> ViewRay:
    """The view ray that crosses the plane z = 0 at x, y; see `visibility.first_hit`."""
    types = array_types(x)
    vertical = maximum(view.z, 1e-4)
    slope = types.Vector2(view.x / vertical, view.y / vertical)
    # The parameter of the ray is its height, which falls by `step` at most.
    rate = extent_of(surface, types).steps_per_length(quality, view) / vertical
    return ViewRay(surface, x, y, slope, dr.rcp(maximum(rate, 1e-9)), types.Bool(back), quality.steps)


@dataclass
class ViewRayState:
    """State of the search down a view ray.

    Attributes:
        height: of the next sample; after the search, of the last sample, below the cloth; millimetres.
        last_step: by how much that is below the previous sample.
        depth: of the last sample below the cloth, millimetres.
        rate: derivative of clearance there, as the ray falls.
        smooth: the last two samples are on one yarn, with no outline and no skipped cell between them.
        searching: the search goes on.
        count: samples so far.
        previous: the previous sample.
    """

    height: Float
    last_step: Float
    depth: Float
    rate: Float
    smooth: Mask
    searching: Mask
    count: UInt
    previous: PreviousSample


@dataclass
class ViewRay:
    """A ray from the eye down to the cloth.

    Attributes:
        x, y: where it crosses the plane z = 0, millimetres.
        slope: dx/dz and dy/dz along the ray [2].
        step: largest fall between samples, millimetres.
        back: the face that is seen.
        samples: most samples to take.
    """

    surface: Surface
    x: Float
    y: Float
    slope: Vec2
    step: Float
    back: Mask
    samples: UInt

    @cached_property
    def _steps(self) -> StepControl:
        # The ray goes down, against the slope.
        return StepControl(-self.slope, self.step)

    def _place(self, height: Float) -> tuple[Float, Float]:
        return dr.fma(self.slope.x, height, self.x), dr.fma(self.slope.y, height, self.y)

    def initial_state(self, active: Mask) -> ViewRayState:
        """The state before the first sample, below all cells that the ray passes far above."""
        types = array_types(self.x)
        top, steps = types.Float(self._max_height()), self._steps

        def fall(height: Float, searching: Mask, count: UInt) -> tuple[Any, ...]:
            bounds = self.surface.cell_bounds(*self._place(height), self.back, steps.right, steps.up)
            above, exit_step = height - bounds.cell_max, steps.to_cell_exit(bounds)
            goes_on = searching & (above > exit_step) & (count < self.samples)
            return height - clip(above, 0, exit_step), goes_on, count + 1

        # Bounds of cells are cheap: most cells are skipped here, before the surface is evaluated.
        top = dr.while_loop(
            (top, active, types.UInt32(0)),
            lambda height, searching, count: searching,
            fall,
            label="cloth: fall",
        )[0]
        nothing, epsilon = types.Float(0 * top), types.Float(steps.epsilon)
        previous, no = no_previous_sample(types, top), types.Bool(False)
        return ViewRayState(
            top, epsilon, nothing, types.Float(nothing), no, active, types.UInt32(0), previous
        )

    def _max_height(self) -> Float:
        types = array_types(self.x)
        extent = extent_of(self.surface, types)
        upwards = types.Vector3(self.slope.x, self.slope.y, 1)
        return max_height_along(self.surface, extent, self.x, self.y, 0, upwards, self.back)

    def next_state(self, now: ViewRayState) -> ViewRayState:
        """The state after one more sample."""
        extent, steps = extent_of(self.surface, array_types(self.x)), self._steps
        floor = extent.low - (extent.high - extent.low)
        here = self.surface.probe(*self._place(now.height), self.back, steps.right, steps.up)
        clearance = now.height - here.height
        met = ~here.hole & (clearance <= 0)
        rate = self._rate(here)
        dips, way_back = now.previous.dip_before(clearance, rate, now.last_step, here)
        smooth = now.previous.known & ~here.hole & (now.previous.yarn == here.yarn)
        count = now.count + 1
        goes_on = now.searching & ~met & (now.height > floor) & (count < self.samples)
        near = steps.to_next_sample(here, clearance, rate)
        # Down to the cell's maximum nothing can be hit.
        free = minimum(steps.to_cell_exit(here.cell_bounds), now.height - here.cell_bounds.cell_max)
        previous = now.previous.after_sample(clearance, rate, here, free > near, dips | ~goes_on)
        farther = maximum(free, near)
        # Where the cubic dips below the yarn, the next sample goes back to its lowest point.
        return ViewRayState(
            dr.select(goes_on, now.height + dr.select(dips, way_back, -farther), now.height),
            dr.select(goes_on, dr.select(dips, now.last_step - way_back, farther), now.last_step),
            -clearance,
            rate,
            smooth,
            goes_on,
            count,
            previous,
        )

    def _rate(self, here: Probe) -> Float:
        return dr.fma(here.slope_x, self.slope.x, dr.fma(here.slope_y, self.slope.y, -1))

    def refined_height(self, end: ViewRayState, refinements: UInt) -> Float:
        """Height of the intersection between the last two samples, above the cloth and below; millimetres.

        On one yarn it is the root of the cubic through both samples, polished by `refinements` Newton steps.
        Elsewhere the ray has crossed an outline, right behind which the last sample lies: regula falsi
        narrows the interval.
        """
        types = array_types(self.x)
        extent, steps = extent_of(self.surface, types), self._steps
        relief, smooth, previous = extent.high - extent.low, end.smooth, end.previous

        def refine(
            index: UInt,
            above: Float,
            under: Float,
            above_gap: Float,
            under_gap: Float,
            side: Float,
            middle: Float,
        ) -> tuple[Any, ...]:
            here = self.surface.probe(*self._place(middle), self.back, steps.right, steps.up)
            rate = self._rate(here)
            gap = clip(middle - dr.select(here.hole, types.Float(-1e9), here.height), -relief, relief)
            met = gap <= 0
            above, under = dr.select(met, above, middle), dr.select(met, middle, under)
            # The Illinois rule halves the weight of an end that stays twice, so that both ends close in. At
            # walls, where the gap jumps, this is bisection.
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

        # Begin with the root of the cubic, or where both clearances say, and narrow.
        under, length = end.height, end.last_step
        above = under + length
        above_gap, under_gap = clip(previous.clearance, 0, relief), clip(end.depth, 0, relief)
        root = _cubic_root(above_gap, -under_gap, previous.rate * length, end.rate * length)
        middle = dr.select(smooth, dr.fma(-root, length, above), _between(above, under, above_gap, under_gap))
        start = (types.UInt32(0), above, under, above_gap, under_gap, types.Float(0 * above), middle)
        _, _, under, _, _, _, middle = dr.while_loop(
            start, lambda index, *rest: index < refinements, refine, label="cloth: refine"
        )
        return dr.select(smooth, middle, under)


def _between(above: Float, under: Float, above_gap: Float, under_gap: Float) -> Float:
    """The root of the line through both ends, kept away from them, as gaps may jump there."""
    share = clip(above_gap / maximum(above_gap + under_gap, 1e-20), 0.02, 0.98)
    return dr.fma(share, under - above, above)


def _cubic_root(start: Float, end: Float, start_rate: Float, end_rate: Float) -> Float:
    """Root in [0, 1] of the cubic Hermite interpolant of `start` > 0 and `end` < 0 with these slopes."""
    gain = end - start
    cubic = start_rate + end_rate - 2 * gain
    bend = 3 * gain - 2 * start_rate - end_rate
    share = start * dr.rcp(maximum(-gain, 1e-20))
    for _ in range(NEWTON_STEPS):
        value = dr.fma(dr.fma(dr.fma(cubic, share, bend), share, start_rate), share, start)
        rate = dr.fma(dr.fma(3 * cubic, share, 2 * bend), share, start_rate)
        # The bound keeps steps short where the cubic is flat.
        share = clip(share - value / minimum(rate, FLATTEST_SHARE * gain - 1e-20), 0, 1)
    return share
