"""What light and eye can reach: exact searches along rays over the analytic height field.

Rays pass by cells that they stay above, and elsewhere advance in steps that neither cross more than a
fraction of a thread nor fall by more than a fraction of the cloth's relief. A hit is bracketed and refined,
so results hold at any zoom and the cost does not grow with the draft. The sides of the yarns are walls: a
ray that enters a thread's outline below its surface has hit it. A ray passes through a *hole* when it meets
nothing above the plane z = 0 from the front and nothing below it from the back, so both faces agree about
which rays pass.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

import drjit as dr

from loomlight.core.backend import ArrayTypes, array_types, clipped, larger, smaller
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
        self.low, self.high = dr.opaque(types.Float, low), dr.opaque(types.Float, high)
        self.lift = dr.opaque(types.Float, _LIFT * min(fine_x, fine_y))
        self._per_x, self._per_y = dr.opaque(types.Float, 1 / fine_x), dr.opaque(types.Float, 1 / fine_y)
        self._per_relief = dr.opaque(types.Float, 1 / max(high - low, 1e-6))

    def threads(self, x: Any, y: Any) -> Any:
        """How many of the finest threads a length along x and y (millimetres, any sign) crosses at most."""
        return larger(dr.abs(x) * self._per_x, dr.abs(y) * self._per_y)

    def steps_per_length(self, quality: SearchQuality, direction: Any) -> Any:
        """Steps per millimetre of ray that the search takes along a unit direction [3]."""
        return larger(
            self.threads(direction.x, direction.y) * quality.steps_per_thread,
            dr.abs(direction.z) * self._per_relief * quality.steps_per_relief,
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
        roof = dr.select(reached, smaller(roof, share * extent.high), roof)
    return roof


@dataclass
class _Trail:
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
        may_dip = falls & ((dr.fma(3, self.clearance, fall) < 0) | (dr.fma(3, clearance, -rise) < 0))

        def look(_: tuple[Any, Any]) -> tuple[Any, Any]:
            # Where the cubic's rate, a parabola over the step, turns from falling to rising.
            gain = clearance - self.clearance
            square, linear = 3 * (fall + rise - 2 * gain), 6 * gain - 4 * fall - 2 * rise
            root = dr.sqrt(larger(dr.fma(linear, linear, -4 * square * fall), 0))
            share = -2 * fall / larger(linear + root, 1e-20)
            rest = 1 - share
            start = (self.clearance * dr.fma(2, share, 1) + fall * share) * dr.square(rest)
            end = (clearance * dr.fma(2, rest, 1) - rise * rest) * dr.square(share)
            # A share of the interval that leads no further has been looked at.
            inside = (share > _NARROWEST) & (rest > _NARROWEST)
            return inside & (start + end < 0), rest * step

        # The next sample would wait for a root and a quotient, a third of what one takes.
        return changed_where(may_dip, (types.Bool(False), types.Float(0)), look, "cloth: dip")

    def followed_by(self, clearance: Any, rate: Any, here: Probe, leaps: Any, stays: Any) -> _Trail:
        """The trail after a sample, or this one where it `stays`.

        Nothing comes between over leaps, which are too long for a cubic to tell.
        """
        return _Trail(
            dr.select(stays, self.clearance, dr.select(here.hole, 1e9, clearance)),
            dr.select(stays, self.rate, rate),
            dr.select(stays, self.yarn, here.yarn),
            dr.select(stays, self.known, ~here.hole & ~leaps),
        )


def _no_trail(types: ArrayTypes, like: Any) -> _Trail:
    zero = types.Float(0 * like)
    return _Trail(zero, types.Float(zero), types.UInt32(0), types.Bool(False))


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
        self._per_x = dr.rcp(larger(dr.abs(direction.x), 1e-9))
        self._per_y = dr.rcp(larger(dr.abs(direction.y), 1e-9))
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
        sinks = ~probe.hole & (dr.fma(rate, edge, clearance) < 0) & (edge > 2 * self.hop)
        beside = dr.select(sinks, edge - self.hop, larger(edge, 0) + self.hop)
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
    extent = _extent_of(surface, array_types(x))
    roof = _roof(surface, extent, x, y, height, direction, back)
    return _rises_free(surface, x, y, height, direction, back, roof, active, quality)


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
    types = array_types(x)
    extent = _extent_of(surface, types)
    back = types.Bool(back)
    rate = quality.shadow_share * extent.steps_per_length(quality, direction)
    step = dr.rcp(larger(rate, 1e-9))
    stride = _Stride(direction, step)
    start = types.Vector3(x, y, height + extent.lift)
    distance = types.Float(0 * x)
    free = types.Bool(active) & (direction.z > 0)
    searching = types.Bool(free)
    count = types.UInt32(0)

    def is_searching(distance: Any, leap: Any, free: Any, searching: Any, count: Any, trail: Any) -> Any:
        del distance, leap, free, count, trail
        return searching

    def advance(
        distance: Any, leap: Any, free: Any, searching: Any, count: Any, trail: Any
    ) -> tuple[Any, ...]:
        point = start + direction * distance
        here = surface.probe(point.x, point.y, back, stride.right, stride.up)
        clearance = point.z - here.height
        rate = direction.z - here.slope_x * direction.x - here.slope_y * direction.y
        met = searching & ~here.hole & (clearance < 0)
        dips, way_back = trail.dip_before(clearance, rate, leap, here)
        # The ray rises, so above the crest it stays above until it leaves the cell.
        clears = point.z > here.block.crest
        trail = trail.followed_by(clearance, rate, here, clears, dips)
        near = stride.onwards(here, clearance, rate)
        onwards = dr.select(clears, larger(stride.out(here.block), step), near)
        # Where a dip is likely the next sample goes back to its lowest point.
        distance = distance + dr.select(dips, -way_back, onwards)
        leap = dr.select(dips, leap - way_back, onwards)
        count = count + 1
        searching = (
            searching & ~met & (dr.fma(direction.z, distance, start.z) < roof) & (count < quality.steps)
        )
        return distance, leap, free & ~met, searching, count, trail

    state = (distance, types.Float(distance), free, searching & (start.z < roof), count, _no_trail(types, x))
    state = dr.while_loop(state, is_searching, advance, label="cloth: unoccluded")
    return state[2]


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
    types = array_types(x)
    extent = _extent_of(surface, types)
    low, high = extent.low, extent.high
    back = types.Bool(back)
    vertical = larger(view.z, 1e-4)
    slope = types.Vector2(view.x / vertical, view.y / vertical)
    # The ray is followed by its height, which falls by `step` each time.
    rate = extent.steps_per_length(quality, view) / vertical
    step = dr.rcp(larger(rate, 1e-9))
    active = types.Bool(active)

    def fall(height: Any, falling: Any, count: Any) -> tuple[Any, ...]:
        block = surface.block(
            dr.fma(slope.x, height, x), dr.fma(slope.y, height, y), back, stride.right, stride.up
        )
        above, out = height - block.crest, stride.out(block)
        return height - clipped(above, 0, out), falling & (above > out) & (count < quality.steps), count + 1

    def ground(height: Any) -> tuple[Any, Any]:
        here = surface.probe(
            dr.fma(slope.x, height, x), dr.fma(slope.y, height, y), back, stride.right, stride.up
        )
        rate = dr.fma(here.slope_x, slope.x, dr.fma(here.slope_y, slope.y, -1))
        return dr.select(here.hole, types.Float(-1e9), here.height), rate

    floor = low - (high - low)
    # Moving down, the ray runs against the view's slope.
    stride = _Stride(-slope, step)

    def is_searching(height: Any, end: _End, leap: Any, searching: Any, count: Any, trail: Any) -> Any:
        del height, end, leap, count, trail
        return searching

    def advance(height: Any, end: _End, leap: Any, searching: Any, count: Any, trail: Any) -> tuple[Any, ...]:
        here = surface.probe(
            dr.fma(slope.x, height, x), dr.fma(slope.y, height, y), back, stride.right, stride.up
        )
        clearance = height - here.height
        met = ~here.hole & (clearance <= 0)
        rate = dr.fma(here.slope_x, slope.x, dr.fma(here.slope_y, slope.y, -1))
        dips, way_back = trail.dip_before(clearance, rate, leap, here)
        smooth = trail.known & ~here.hole & (trail.yarn == here.yarn)
        count = count + 1
        onwards = searching & ~met & (height > floor) & (count < quality.steps)
        near = stride.onwards(here, clearance, rate)
        # Down to the crest the ray falls freely.
        free = smaller(stride.out(here.block), height - here.block.crest)
        trail = trail.followed_by(clearance, rate, here, free > near, dips | ~onwards)
        farther = larger(free, near)
        # Where a dip is likely the next sample goes back to its lowest point.
        return (
            dr.select(onwards, height + dr.select(dips, way_back, -farther), height),
            _End(dr.select(onwards & ~dips, height, end.previous), -clearance, rate, smooth),
            dr.select(onwards, dr.select(dips, leap - way_back, farther), leap),
            onwards,
            count,
            trail,
        )

    top = types.Float(_roof(surface, extent, x, y, 0, types.Vector3(slope.x, slope.y, 1), back))
    # Cells that rays pass above ask little: most are passed here, before the search for yarn begins.
    top = dr.while_loop(
        (top, active, types.UInt32(0)),
        lambda height, falling, count: falling,
        fall,
        label="cloth: fall",
    )[0]
    nothing = types.Float(0 * top)
    start = _End(top + stride.hop, nothing, types.Float(nothing), types.Bool(False))
    under, end, _, _, _, trail = dr.while_loop(
        (top, start, types.Float(step), types.Bool(active), types.UInt32(0), _no_trail(types, x)),
        is_searching,
        advance,
        label="cloth: first hit",
    )
    looks = quality.refinements + (0 if surface.tells_outlines else _LOOKS_FOR_OUTLINES)
    under = _refined(ground, under, end, trail, high - low, looks)
    hole = types.Bool(False)
    if passing:
        # What has met yarn above the plane does not pass it.
        hole = passes_through(surface, x, y, view, back, active & (under <= 0), quality)
    return Hit(dr.fma(slope.x, under, x), dr.fma(slope.y, under, y), hole, under)


@dataclass
class _End:
    """Where a ray that falls has met the cloth, as the last sample has it.

    Attributes:
        previous: height of the sample before, above the cloth.
        depth: below the cloth.
        rate: of clearance as the ray falls.
        smooth: the yarn is the one of the sample before, with no outline and no leap between.
    """

    previous: Any
    depth: Any
    rate: Any
    smooth: Any


def _refined(
    ground: Callable[[Any], tuple[Any, Any]], under: Any, end: _End, trail: _Trail, relief: Any, count: Any
) -> Any:
    """Height at which a ray meets the cloth that lies below it at one sample and above it at the next.

    On one yarn that is the root of the cubic through both, from which `count` steps of Newton's lead on.
    Elsewhere the ray has passed an outline, right behind which it was sampled: looks come closer to the last
    sample.

    Args:
        ground: height of the cloth where the ray has fallen to a height, and the rate of clearance there.
        under: height of the last sample.
        trail: of the sample before.
    """
    types = array_types(under)
    smooth = end.smooth

    def refine(
        index: Any, above: Any, under: Any, above_gap: Any, under_gap: Any, side: Any, middle: Any
    ) -> tuple[Any, ...]:
        level, rate = ground(middle)
        gap = clipped(middle - level, -relief, relief)
        met = gap <= 0
        above, under = dr.select(met, above, middle), dr.select(met, middle, under)
        # Regula falsi: an end that stays twice counts half (the Illinois rule), so that both close in; at
        # walls, where the gap jumps, this comes to halving.
        above_gap = dr.select(met, dr.select(side > 0, 0.5 * above_gap, above_gap), gap)
        under_gap = dr.select(met, -gap, dr.select(side < 0, 0.5 * under_gap, under_gap))
        between = _between(above, under, above_gap, under_gap)
        rooted = clipped(middle + gap / smaller(rate, -1e-6), under, above)
        return (
            index + 1,
            above,
            under,
            above_gap,
            under_gap,
            dr.select(met, types.Float(1), -1),
            dr.select(smooth, rooted, between),
        )

    above = end.previous
    above_gap, under_gap = clipped(trail.clearance, 0, relief), clipped(end.depth, 0, relief)
    length = above - under
    root = _cubic_root(above_gap, -under_gap, trail.rate * length, end.rate * length)
    middle = dr.select(smooth, dr.fma(-root, length, above), _between(above, under, above_gap, under_gap))
    _, _, under, _, _, _, middle = dr.while_loop(
        (types.UInt32(0), above, under, above_gap, under_gap, types.Float(0 * above), middle),
        lambda index, *rest: index < count,
        refine,
        label="cloth: refine",
    )
    return dr.select(smooth, middle, under)


def _between(above: Any, under: Any, above_gap: Any, under_gap: Any) -> Any:
    """The height that a straight line suggests, kept off both ends, where gaps may jump."""
    share = clipped(above_gap / larger(above_gap + under_gap, 1e-20), 0.02, 0.98)
    return dr.fma(share, under - above, above)


def _cubic_root(start: Any, end: Any, start_rate: Any, end_rate: Any) -> Any:
    """Where in [0, 1] a cubic is 0 that starts above 0 and ends below; rates are of the whole interval."""
    gain = end - start
    cubic = start_rate + end_rate - 2 * gain
    square = 3 * gain - 2 * start_rate - end_rate
    share = start * dr.rcp(larger(-gain, 1e-20))
    for _ in range(_NEWTON_STEPS):
        value = dr.fma(dr.fma(dr.fma(cubic, share, square), share, start_rate), share, start)
        rate = dr.fma(dr.fma(3 * cubic, share, 2 * square), share, start_rate)
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
    outwards: tuple[Any, Any] = dr.sincos(azimuth)
    sine, cosine = outwards
    extent = _extent_of(surface, types)
    high = extent.high
    step = dr.rcp(extent.threads(cosine, sine) * quality.steps_per_thread)
    start = height + extent.lift
    back = types.Bool(back)

    def could_rise(distance: Any, steepest: Any, count: Any) -> Any:
        return (high - start > steepest * distance) & (count < quality.steps)

    def advance(distance: Any, steepest: Any, count: Any) -> tuple[Any, ...]:
        level, hole = surface.height(dr.fma(cosine, distance, x), dr.fma(sine, distance, y), back)
        rise = dr.select(hole, types.Float(0), (level - start) / distance)
        return distance + step, larger(steepest, rise), count + 1

    # The yarn itself hides what lies below its tangent plane. Without any rise the search would only end
    # with the budget; 1e-3 is a horizon of 0.06°.
    here = surface.probe(x, y, back, cosine > 0, sine > 0)
    own = dr.fma(here.slope_x, cosine, here.slope_y * sine)
    state = (types.Float(0.25 * step), larger(own, 1e-3), types.UInt32(0))
    return dr.while_loop(state, could_rise, advance, label="cloth: horizon")[1]
