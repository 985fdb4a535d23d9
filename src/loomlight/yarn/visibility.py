"""What light and eye can reach: exact searches along rays over the analytic height field.

Rays pass by cells that they stay above, and elsewhere advance in steps that neither cross more than a
fraction of a thread nor fall by more than a fraction of the cloth's relief. A hit is bracketed and refined,
so results hold at any zoom and the cost does not grow with the draft. The sides of the yarns are walls: a
ray that enters a thread's outline below its surface has hit it. A ray passes through a *hole* when it meets
nothing above the plane z = 0 from the front and nothing below it from the back, so both faces agree about
which rays pass.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Protocol

from loomlight.core.arrays import (
    array_types,
    clipped,
    fma,
    larger,
    opaque,
    rcp,
    select,
    sincos,
    smaller,
    sqrt,
    square,
    while_loop,
)
from loomlight.core.backend import ArrayTypes
from loomlight.core.lanes import changed_where
from loomlight.yarn.geometry import Block, Probe, SurfacePoint


class Surface(Protocol):
    """A source of cloth geometry: analytic, or textures of one repeat."""

    size: tuple[float, float]
    extents: dict[type, Any]  # what searches keep of it
    tells_outlines: bool  # probes know the distance to the next outline, else it is as far as can be

    @property
    def finest(self) -> tuple[float, float]:
        """Smallest extent that a search must not step over, along x and y, millimetres."""

    @property
    def height_bounds(self) -> tuple[float, float]:
        """Bounds of all heights on either face, millimetres."""

    def height(self, x: Any, y: Any, back: Any) -> tuple[Any, Any]:
        """Height and hole at draft coordinates, millimetres."""

    def roofs(self, x: Any, y: Any, back: Any, right: Any, up: Any) -> list[tuple[float, Any]]:
        """Distances along x and y in units of `finest`, and bounds of heights within them, the widest first.

        They hold for searches that go up the x and the y axis or down. Bounds are shares of the upper one of
        `height_bounds`.
        """

    def probe(self, x: Any, y: Any, back: Any, right: Any, up: Any) -> Probe:
        """What searches need at draft coordinates, millimetres, that go up the x and the y axis or down."""

    def block(self, x: Any, y: Any, back: Any, right: Any, up: Any) -> Block:
        """`probe`'s part that rays need which pass above."""

    def surface(self, x: Any, y: Any, back: Any) -> SurfacePoint:
        """Everything known of the point at draft coordinates, millimetres."""


@dataclass(frozen=True)
class SearchQuality:
    """How finely rays are searched; all but `steps` may be Dr.Jit arrays, a number a lane.

    Attributes:
        steps_per_thread: steps while crossing the finest thread.
        steps_per_relief: steps while falling through the whole relief of the cloth.
        shadow_share: shadow rays take this share of the steps.
        refinements: looks at the cloth around a hit beyond the two samples that found it.
        steps: at most so many; a ray still undecided then counts as free.
    """

    steps_per_thread: Any = 5.0
    steps_per_relief: Any = 8.0
    shadow_share: Any = 1.0
    refinements: Any = 2
    steps: int = 1024


DEFAULT_QUALITY = SearchQuality()
REFERENCE_QUALITY = SearchQuality(48, 48, refinements=20, steps=16384)

# A ray starts this share of the finest thread above its surface, or rounding would shadow it.
_LIFT = 2e-3
# Dips are looked for down to this share of the interval between two samples.
_NARROWEST = 0.02
# How far past an outline the next sample lies, in steps.
_HOP = 5e-3
# Of the cubic that tells where a ray meets a yarn, and the least of its rate, as a share of the mean.
_NEWTON_STEPS = 3
_FLATTEST = 0.1
# Further looks where samples do not stand right behind outlines.
_LOOKS_FOR_OUTLINES = 3


@dataclass
class Hit:
    """Where a view ray meets the cloth.

    Attributes:
        x, y: draft coordinates of the yarn point, millimetres.
        hole: the ray passes through the cloth.
        height: where the ray ends. On continuous yarn that is the surface; on a wall, below its upper edge.
    """

    x: Any
    y: Any
    hole: Any
    height: Any


class _Extent:
    """The lengths of a surface that searches are measured by, opaque: fabrics share the kernels.

    Attributes:
        lengths: the finest extents along x and y, and bounds of heights, as numbers.
        low, high: bounds of all heights, millimetres.
        lift: how far above its surface a ray starts.
    """

    def __init__(self, lengths: tuple[float, float, float, float], types: ArrayTypes) -> None:
        self.lengths = lengths
        fine_x, fine_y, low, high = lengths
        self.low, self.high = opaque(types.Float, low), opaque(types.Float, high)
        self.lift = opaque(types.Float, _LIFT * min(fine_x, fine_y))
        self._per_x, self._per_y = opaque(types.Float, 1 / fine_x), opaque(types.Float, 1 / fine_y)
        self._per_relief = opaque(types.Float, 1 / max(high - low, 1e-6))

    def threads(self, x: Any, y: Any) -> Any:
        """How many of the finest threads a length along x and y (millimetres, any sign) crosses at most."""
        return larger(abs(x) * self._per_x, abs(y) * self._per_y)

    def steps_per_length(self, quality: SearchQuality, direction: Any) -> Any:
        """Steps per millimetre of ray that the search takes along a unit direction [3]."""
        return larger(
            self.threads(direction.x, direction.y) * quality.steps_per_thread,
            abs(direction.z) * self._per_relief * quality.steps_per_relief,
        )


def _extent_of(surface: Surface, types: ArrayTypes) -> _Extent:
    """The extent of a surface, uploaded once, until its heights are edited."""
    lengths = *surface.finest, *surface.height_bounds
    kept: _Extent | None = surface.extents.get(types.Float)
    if kept is None or kept.lengths != lengths:
        kept = surface.extents[types.Float] = _Extent(lengths, types)
    return kept


def upload_extent(surface: Surface, types: ArrayTypes) -> None:
    """Puts what searches keep of a surface on a backend, which otherwise happens at first use."""
    _extent_of(surface, types)


def _roof(surface: Surface, extent: _Extent, x: Any, y: Any, height: Any, direction: Any, back: Any) -> Any:
    """A height that the cloth stays below along a ray, as far as the ray itself is above x, y, `height`.

    Args:
        direction: along the ray [3], z > 0; of any length.
    """
    threads = extent.threads(direction.x, direction.y) / direction.z
    roof = extent.high
    for radius, share in surface.roofs(x, y, back, direction.x > 0, direction.y > 0):
        reached = (roof - height) * threads <= radius
        roof = select(reached, smaller(roof, share * extent.high), roof)
    return roof


@dataclass
class Trail:
    """The last sample of a ray: its clearance (1e9 in a hole), the rate of that, and whether dips may follow.

    A cubic through it and the next sample finds where rays dip into a yarn's back between the two; without
    it the shadows and outlines of smooth yarns would be scalloped.
    """

    clearance: Any
    rate: Any
    yarn: Any
    known: Any

    def dip_before(self, clearance: Any, rate: Any, step: Any, here: Probe) -> tuple[Any, Any]:
        """Whether the cubic to this sample, `step` after the last, dips below the yarn, and how far back."""
        types = array_types(clearance)
        falls = self.known & ~here.hole & (self.yarn == here.yarn) & (self.rate < 0) & (rate > 0)
        fall, rise = self.rate * step, rate * step
        # The cubic stays between its ends and Bézier's two points, which few samples have below the yarn.
        may_dip = falls & ((fma(3, self.clearance, fall) < 0) | (fma(3, clearance, -rise) < 0))

        def look(_: tuple[Any, Any]) -> tuple[Any, Any]:
            # Where the cubic's rate, a parabola over the step, turns from falling to rising.
            gain = clearance - self.clearance
            bend, linear = 3 * (fall + rise - 2 * gain), 6 * gain - 4 * fall - 2 * rise
            root = sqrt(larger(fma(linear, linear, -4 * bend * fall), 0))
            share = -2 * fall / larger(linear + root, 1e-20)
            rest = 1 - share
            start = (self.clearance * fma(2, share, 1) + fall * share) * square(rest)
            end = (clearance * fma(2, rest, 1) - rise * rest) * square(share)
            # A share of the interval that leads no further has been looked at.
            inside = (share > _NARROWEST) & (rest > _NARROWEST)
            return inside & (start + end < 0), rest * step

        # The next sample would wait for a root and a quotient, a third of what one takes.
        return changed_where(may_dip, (types.Bool(False), types.Float(0)), look, "cloth: dip")

    def followed_by(self, clearance: Any, rate: Any, here: Probe, leaps: Any, stays: Any) -> Trail:
        """The trail after a sample, or this one where it `stays`.

        Nothing comes between over leaps, which are too long for a cubic to tell.
        """
        return Trail(
            select(stays, self.clearance, select(here.hole, 1e9, clearance)),
            select(stays, self.rate, rate),
            select(stays, self.yarn, here.yarn),
            select(stays, self.known, ~here.hole & ~leaps),
        )


def _no_trail(types: ArrayTypes, like: Any) -> Trail:
    zero = types.Float(0 * like)
    return Trail(zero, types.Float(zero), types.UInt32(0), types.Bool(False))


class _Stride:
    """How far a ray may go from one sample to the next: one step, or less.

    Attributes:
        step: length of ray, along a direction [3] that need not be of length 1.
        right, up: whether it goes up the x and the y axis.
        hop: how far behind an outline the ray lands, despite rounding.
    """

    def __init__(self, direction: Any, step: Any) -> None:
        self.step = step
        self.hop = _HOP * step
        self._per_x = rcp(larger(abs(direction.x), 1e-9))
        self._per_y = rcp(larger(abs(direction.y), 1e-9))
        self.right, self.up = direction.x > 0, direction.y > 0

    def out(self, block: Block) -> Any:
        """Length of ray out of the cell."""
        return larger(smaller(block.side_x * self._per_x, block.side_y * self._per_y), 0) + self.hop

    def onwards(self, probe: Probe, clearance: Any, rate: Any) -> Any:
        """Length of ray to the next sample.

        It is one step ahead, or less where that would pass an outline: what stands behind it may
        be a wall. A ray that sinks towards its yarn (`clearance` above it, changing at `rate`) fast enough to
        meet it on the way stops short of the outline first, or it could leave unseen through its flank.
        """
        edge = smaller(probe.edge_x * self._per_x, probe.edge_y * self._per_y)
        sinks = ~probe.hole & (fma(rate, edge, clearance) < 0) & (edge > 2 * self.hop)
        beside = select(sinks, edge - self.hop, larger(edge, 0) + self.hop)
        return smaller(self.step, beside)


def unoccluded(
    surface: Surface,
    x: Any,
    y: Any,
    height: Any,
    direction: Any,
    back: Any,
    active: Any = True,
    quality: SearchQuality = DEFAULT_QUALITY,
) -> Any:
    """Whether nothing stands between a point of the cloth and a direction: Bool.

    What lies below the tangent plane of the point is for the caller to leave out.

    Args:
        x, y: draft coordinates, millimetres.
        height: of the point, millimetres, on the face given by `back`.
        direction: unit vector [3] in the frame of that face; with z ≤ 0 nothing is visible.
        back: Bool, the face the height counts from.
        active: lanes to search; the others return False.
    """
    ray = rising_ray(surface, x, y, height, direction, back, quality)
    start = ray.started(array_types(x).Bool(active) & (direction.z > 0))
    return _free(ray, start)


def _rises_free(
    surface: Surface,
    x: Any,
    y: Any,
    height: Any,
    direction: Any,
    back: Any,
    roof: Any,
    active: Any,
    quality: SearchQuality,
) -> Any:
    """`unoccluded`, where nothing on the ray's way is higher than the roof."""
    ray = _rising_ray(surface, x, y, height, direction, back, roof, quality)
    return _free(ray, ray.started(array_types(x).Bool(active) & (direction.z > 0)))


def _free(ray: RisingRay, start: Rising) -> Any:
    """Whether nothing is met."""
    return while_loop(
        (start,), lambda state: state.searching, lambda state: (ray.advanced(state),), "cloth: unoccluded"
    )[0].free


def rising_ray(
    surface: Surface, x: Any, y: Any, height: Any, direction: Any, back: Any, quality: SearchQuality
) -> RisingRay:
    """The ray from a point of the cloth along a direction; see `unoccluded`."""
    roof = _roof(surface, _extent_of(surface, array_types(x)), x, y, height, direction, back)
    return _rising_ray(surface, x, y, height, direction, back, roof, quality)


def _rising_ray(
    surface: Surface,
    x: Any,
    y: Any,
    height: Any,
    direction: Any,
    back: Any,
    roof: Any,
    quality: SearchQuality,
) -> RisingRay:
    types = array_types(x)
    extent = _extent_of(surface, types)
    step = rcp(larger(quality.shadow_share * extent.steps_per_length(quality, direction), 1e-9))
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
    def _stride(self) -> _Stride:
        return _Stride(self.direction, self.step)

    def started(self, active: Any) -> Rising:
        """Before the first sample."""
        types = array_types(self.step)
        nothing = types.Float(0 * self.step)
        searching = active & (self.start.z < self.roof)
        return Rising(nothing, nothing, active, searching, types.UInt32(0), _no_trail(types, self.step))

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
        onwards = select(clears, larger(stride.out(here.block), self.step), near)
        # Where a dip is likely the next sample goes back to its lowest point.
        distance = now.distance + select(dips, -way_back, onwards)
        leap = select(dips, now.leap - way_back, onwards)
        count = now.count + 1
        below = fma(direction.z, distance, self.start.z) < self.roof
        searching = now.searching & ~met & below & (count < self.samples)
        return Rising(distance, leap, now.free & ~met, searching, count, trail)


def first_hit(
    surface: Surface,
    x: Any,
    y: Any,
    view: Any,
    back: Any,
    active: Any = True,
    quality: SearchQuality = DEFAULT_QUALITY,
    passing: bool = True,
) -> Hit:
    """The first point of the cloth along the view ray that crosses the plane z = 0 at x, y.

    Exact parallax (zhu2024 eq. 2 without its table and clamp). Rays that meet a wall end at the edge of the
    yarn that stands there.

    Args:
        x, y: draft coordinates where the ray meets the plane of the crown lines, millimetres.
        view: unit vector [3] towards the eye in the frame of the face seen, z > 0.
        back: Bool, which face is seen.
        passing: look whether rays pass through; if not, none is said to.
    """
    ray = falling_ray(surface, x, y, view, back, quality)
    active = array_types(x).Bool(active)
    state = while_loop(
        (ray.started(active),),
        lambda state: state.searching,
        lambda state: (ray.advanced(state),),
        "cloth: first hit",
    )[0]
    height = ray.refined(state, quality.refinements)
    hole = array_types(x).Bool(False)
    if passing:
        # What has met yarn above the plane does not pass it.
        hole = passes_through(surface, x, y, view, ray.back, active & (height <= 0), quality)
    return Hit(fma(ray.slope.x, height, x), fma(ray.slope.y, height, y), hole, height)


def falling_ray(surface: Surface, x: Any, y: Any, view: Any, back: Any, quality: SearchQuality) -> FallingRay:
    """The view ray that crosses the plane z = 0 at x, y; see `first_hit`."""
    types = array_types(x)
    vertical = larger(view.z, 1e-4)
    slope = types.Vector2(view.x / vertical, view.y / vertical)
    # The ray is followed by its height, which falls by `step` each time.
    rate = _extent_of(surface, types).steps_per_length(quality, view) / vertical
    return FallingRay(surface, x, y, slope, rcp(larger(rate, 1e-9)), types.Bool(back), quality.steps)


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
    def _stride(self) -> _Stride:
        # Moving down, the ray runs against the view's slope.
        return _Stride(-self.slope, self.step)

    def _place(self, height: Any) -> tuple[Any, Any]:
        return fma(self.slope.x, height, self.x), fma(self.slope.y, height, self.y)

    def started(self, active: Any) -> Falling:
        """Before the first sample, below what the ray passes high above."""
        types = array_types(self.x)
        top, stride = types.Float(self._roof()), self._stride

        def fall(height: Any, falling: Any, count: Any) -> tuple[Any, ...]:
            block = self.surface.block(*self._place(height), self.back, stride.right, stride.up)
            above, out = height - block.crest, stride.out(block)
            onwards = falling & (above > out) & (count < self.samples)
            return height - clipped(above, 0, out), onwards, count + 1

        # Cells that rays pass above ask little: most are passed here, before the search for yarn begins.
        top = while_loop(
            (top, active, types.UInt32(0)), lambda height, falling, count: falling, fall, "cloth: fall"
        )[0]
        nothing, hop = types.Float(0 * top), types.Float(stride.hop)
        trail, no = _no_trail(types, top), types.Bool(False)
        return Falling(top, hop, nothing, types.Float(nothing), no, active, types.UInt32(0), trail)

    def _roof(self) -> Any:
        types = array_types(self.x)
        extent = _extent_of(self.surface, types)
        upwards = types.Vector3(self.slope.x, self.slope.y, 1)
        return _roof(self.surface, extent, self.x, self.y, 0, upwards, self.back)

    def advanced(self, now: Falling) -> Falling:
        """After one more sample, in lanes that are searched."""
        extent, stride = _extent_of(self.surface, array_types(self.x)), self._stride
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
        free = smaller(stride.out(here.block), now.height - here.block.crest)
        trail = now.trail.followed_by(clearance, rate, here, free > near, dips | ~onwards)
        farther = larger(free, near)
        # Where a dip is likely the next sample goes back to its lowest point.
        return Falling(
            select(onwards, now.height + select(dips, way_back, -farther), now.height),
            select(onwards, select(dips, now.leap - way_back, farther), now.leap),
            -clearance,
            rate,
            smooth,
            onwards,
            count,
            trail,
        )

    def _rate(self, here: Probe) -> Any:
        return fma(here.slope_x, self.slope.x, fma(here.slope_y, self.slope.y, -1))

    def refined(self, end: Falling, refinements: Any) -> Any:
        """Height at which the ray meets the cloth that lies below it at one sample and above it at the next.

        On one yarn that is the root of the cubic through both, from which `refinements` steps of Newton's
        lead on. Elsewhere the ray has passed an outline, right behind which it was sampled: looks come closer
        to the last sample.
        """
        types = array_types(self.x)
        extent, stride = _extent_of(self.surface, types), self._stride
        relief, smooth, trail = extent.high - extent.low, end.smooth, end.trail
        looks = refinements + (0 if self.surface.tells_outlines else _LOOKS_FOR_OUTLINES)

        def refine(
            index: Any, above: Any, under: Any, above_gap: Any, under_gap: Any, side: Any, middle: Any
        ) -> tuple[Any, ...]:
            here = self.surface.probe(*self._place(middle), self.back, stride.right, stride.up)
            rate = self._rate(here)
            gap = clipped(middle - select(here.hole, types.Float(-1e9), here.height), -relief, relief)
            met = gap <= 0
            above, under = select(met, above, middle), select(met, middle, under)
            # Regula falsi: an end that stays twice counts half (the Illinois rule), so that both close in; at
            # walls, where the gap jumps, this comes to halving.
            above_gap = select(met, select(side > 0, 0.5 * above_gap, above_gap), gap)
            under_gap = select(met, -gap, select(side < 0, 0.5 * under_gap, under_gap))
            between = _between(above, under, above_gap, under_gap)
            rooted = clipped(middle + gap / smaller(rate, -1e-6), under, above)
            return (
                index + 1,
                above,
                under,
                above_gap,
                under_gap,
                select(met, types.Float(1), -1),
                select(smooth, rooted, between),
            )

        under, length = end.height, end.leap
        above = under + length
        above_gap, under_gap = clipped(trail.clearance, 0, relief), clipped(end.depth, 0, relief)
        root = _cubic_root(above_gap, -under_gap, trail.rate * length, end.rate * length)
        middle = select(smooth, fma(-root, length, above), _between(above, under, above_gap, under_gap))
        start = (types.UInt32(0), above, under, above_gap, under_gap, types.Float(0 * above), middle)
        _, _, under, _, _, _, middle = while_loop(
            start, lambda index, *rest: index < looks, refine, "cloth: refine"
        )
        return select(smooth, middle, under)


def _between(above: Any, under: Any, above_gap: Any, under_gap: Any) -> Any:
    """The height that a straight line suggests, kept off both ends, where gaps may jump."""
    share = clipped(above_gap / larger(above_gap + under_gap, 1e-20), 0.02, 0.98)
    return fma(share, under - above, above)


def _cubic_root(start: Any, end: Any, start_rate: Any, end_rate: Any) -> Any:
    """Where in [0, 1] a cubic is 0 that starts above 0 and ends below; rates are of the whole interval."""
    gain = end - start
    cubic = start_rate + end_rate - 2 * gain
    bend = 3 * gain - 2 * start_rate - end_rate
    share = start * rcp(larger(-gain, 1e-20))
    for _ in range(_NEWTON_STEPS):
        value = fma(fma(fma(cubic, share, bend), share, start_rate), share, start)
        rate = fma(fma(3 * cubic, share, 2 * bend), share, start_rate)
        # Where the cubic is flat, steps stay short.
        share = clipped(share - value / smaller(rate, _FLATTEST * gain - 1e-20), 0, 1)
    return share


def passes_through(
    surface: Surface,
    x: Any,
    y: Any,
    view: Any,
    back: Any,
    active: Any = True,
    quality: SearchQuality = DEFAULT_QUALITY,
) -> Any:
    """Whether the line through x, y on the plane z = 0 along `view` meets no yarn at all: Bool.

    The same for a direction and its opposite seen from the other face, so delta transmission is reciprocal.
    """
    types = array_types(x)
    back = types.Bool(back)
    _, hole = surface.height(x, y, back)
    candidate = types.Bool(active) & hole
    # Unlifted again: the ray starts on the plane.
    extent = _extent_of(surface, types)
    zero, high = -extent.lift, extent.high
    in_front = _rises_free(surface, x, y, zero, view, back, high, candidate, quality)
    # Seen from the other face the line goes on along (−x, −y, +z) of its mirrored frame.
    onwards = types.Vector3(-view.x, -view.y, view.z)
    behind = _rises_free(surface, x, y, zero, onwards, ~back, high, candidate & in_front, quality)
    return candidate & in_front & behind


def horizon(
    surface: Surface,
    x: Any,
    y: Any,
    height: Any,
    azimuth: Any,
    back: Any,
    quality: SearchQuality = DEFAULT_QUALITY,
) -> Any:
    """Tangent of the elevation below which the cloth hides the sky along an azimuth (radians), ≥ 0.

    Searched outwards until even the highest yarn could no longer raise it.
    """
    types = array_types(x)
    outwards: tuple[Any, Any] = sincos(azimuth)
    sine, cosine = outwards
    extent = _extent_of(surface, types)
    high = extent.high
    step = rcp(extent.threads(cosine, sine) * quality.steps_per_thread)
    start = height + extent.lift
    back = types.Bool(back)

    def could_rise(distance: Any, steepest: Any, count: Any) -> Any:
        return (high - start > steepest * distance) & (count < quality.steps)

    def advance(distance: Any, steepest: Any, count: Any) -> tuple[Any, ...]:
        level, hole = surface.height(fma(cosine, distance, x), fma(sine, distance, y), back)
        rise = select(hole, types.Float(0), (level - start) / distance)
        return distance + step, larger(steepest, rise), count + 1

    # The yarn itself hides what lies below its tangent plane. Without any rise the search would only end
    # with the budget; 1e-3 is a horizon of 0.06°.
    here = surface.probe(x, y, back, cosine > 0, sine > 0)
    own = fma(here.slope_x, cosine, here.slope_y * sine)
    state = (types.Float(0.25 * step), larger(own, 1e-3), types.UInt32(0))
    return while_loop(state, could_rise, advance, label="cloth: horizon")[1]
