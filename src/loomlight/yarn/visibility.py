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
from typing import Any, Protocol

import drjit as dr

from loomlight.core.backend import ArrayTypes, array_types
from loomlight.yarn.geometry import Probe, SurfacePoint


class Surface(Protocol):
    """A source of cloth geometry: analytic, or textures of one repeat."""

    size: tuple[float, float]
    extents: dict[type, Any]  # what searches keep of it

    @property
    def finest(self) -> tuple[float, float]:
        """Smallest extent that a search must not step over, along x and y, millimetres."""

    @property
    def height_bounds(self) -> tuple[float, float]:
        """Bounds of all heights on either face, millimetres."""

    def height(self, x: Any, y: Any, back: Any) -> tuple[Any, Any]:
        """Height and hole at draft coordinates, millimetres."""

    def probe(self, x: Any, y: Any, back: Any) -> Probe:
        """What searches along rays need at draft coordinates, millimetres."""

    def surface(self, x: Any, y: Any, back: Any) -> SurfacePoint:
        """Everything known of the point at draft coordinates, millimetres."""


@dataclass(frozen=True)
class SearchQuality:
    """How finely rays are searched; the first two and `refinements` may be Dr.Jit arrays, a number a lane.

    Attributes:
        steps_per_thread: steps while crossing the finest thread.
        steps_per_relief: steps while falling through the whole relief of the cloth.
        shadow_share: shadow rays take this share of the steps. They need no position, and outlines and the
            cubic between samples find what steps alone miss: 5 a thread judge 0.1 % of lights wrongly.
        refinements: halvings of the bracket around a hit, alternating with secant steps.
        steps: at most so many; a ray still undecided then counts as free.
    """

    steps_per_thread: Any = 8.0
    steps_per_relief: Any = 8.0
    shadow_share: float = 0.6
    refinements: Any = 8
    steps: int = 1024


DEFAULT_QUALITY = SearchQuality()
REFERENCE_QUALITY = SearchQuality(48, 48, shadow_share=1, refinements=20, steps=16384)

# A ray starts this share of the finest thread above its surface, or rounding would shadow it.
_LIFT = 2e-3
# How far past an outline the next sample lies, in steps.
_HOP = 5e-3


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
        return dr.maximum(dr.abs(x) * self._per_x, dr.abs(y) * self._per_y)

    def steps_per_length(self, quality: SearchQuality, direction: Any) -> Any:
        """Steps per millimetre of ray that the search takes along a unit direction [3]."""
        return dr.maximum(
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


@dataclass
class _Trail:
    """The last clearance of a ray above a yarn and its rate: with the next they tell how low it came between.

    A cubic through both finds rays that dip into a yarn's back between two samples; without it the shadows
    and outlines of smooth yarns would be scalloped.
    """

    clearance: Any
    rate: Any
    yarn: Any
    known: Any

    def lowest_before(self, clearance: Any, rate: Any, step: Any, here: Probe) -> tuple[Any, Any]:
        """Lowest clearance since the last sample, `step` ago, and how far back it is; 1e9 if at the ends."""
        known = self.known & ~here.hole & (self.yarn == here.yarn) & (self.rate < 0) & (rate > 0)
        share = self.rate / dr.minimum(self.rate - rate, -1e-20)
        rest = 1 - share
        start = (self.clearance * dr.fma(2, share, 1) + step * self.rate * share) * dr.square(rest)
        end = (clearance * dr.fma(2, rest, 1) - step * rate * rest) * dr.square(share)
        return dr.select(known, start + end, 1e9), rest * step


def _trail(clearance: Any, rate: Any, here: Probe, leaps: Any) -> _Trail:
    """The trail after a sample. Nothing comes between over leaps, which are too long for a cubic to tell."""
    types = array_types(clearance)
    known = ~here.hole & ~leaps
    return _Trail(types.Float(clearance), types.Float(rate), types.UInt32(here.yarn), known)


def _no_trail(types: ArrayTypes, like: Any) -> _Trail:
    zero = types.Float(0 * like)
    return _Trail(zero, types.Float(zero), types.UInt32(0), types.Bool(False))


def _advance(probe: Probe, direction: Any, clearance: Any, rate: Any, step: Any) -> tuple[Any, Any]:
    """Lengths of ray along a direction [3], which need not be 1, to the next sample and out of the cell.

    The next sample is one step ahead, or less where that would pass an outline: what stands behind it may be
    a wall. A ray that sinks towards its yarn (`clearance` above it, changing at `rate`) fast enough to meet
    it on the way stops short of the outline first, or it could leave unseen through the yarn's flank.
    """
    per_x, per_y = (
        dr.rcp(dr.maximum(dr.abs(direction.x), 1e-9)),
        dr.rcp(dr.maximum(dr.abs(direction.y), 1e-9)),
    )
    right, up = direction.x > 0, direction.y > 0
    out = dr.minimum(
        dr.select(right, probe.to_right, probe.to_left) * per_x,
        dr.select(up, probe.to_upper, probe.to_lower) * per_y,
    )
    edge = dr.minimum(
        dr.select(right, probe.edge_right, probe.edge_left) * per_x,
        dr.select(up, probe.edge_upper, probe.edge_lower) * per_y,
    )
    # The hop lands on the far side despite rounding.
    hop = _HOP * step
    sinks = ~probe.hole & (dr.fma(rate, edge, clearance) < 0) & (edge > 2 * hop)
    beside = dr.select(sinks, edge - hop, dr.maximum(edge, 0) + hop)
    return dr.minimum(step, beside), dr.maximum(out, 0) + hop


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
    types = array_types(x)
    extent = _extent_of(surface, types)
    high = extent.high
    rate = quality.shadow_share * extent.steps_per_length(quality, direction)
    step = dr.rcp(dr.maximum(rate, 1e-9))
    start = types.Vector3(x, y, height + extent.lift)
    distance = types.Float(0 * x)
    free = types.Bool(active) & (direction.z > 0)
    searching = types.Bool(free)
    back = types.Bool(back)
    count = types.UInt32(0)

    def is_searching(distance: Any, leap: Any, free: Any, searching: Any, count: Any, trail: Any) -> Any:
        del distance, leap, free, count, trail
        return searching

    def advance(
        distance: Any, leap: Any, free: Any, searching: Any, count: Any, trail: Any
    ) -> tuple[Any, ...]:
        point = start + direction * distance
        here = surface.probe(point.x, point.y, back)
        clearance = point.z - here.height
        rate = direction.z - here.slope_x * direction.x - here.slope_y * direction.y
        dips = trail.lowest_before(clearance, rate, leap, here)[0] < 0
        met = searching & ~here.hole & ((clearance < 0) | dips)
        # The ray rises, so above the crest it stays above until it leaves the cell.
        clears = point.z > here.crest
        trail = _trail(clearance, rate, here, clears)
        near, out = _advance(here, direction, clearance, rate, step)
        leap = dr.select(clears, dr.maximum(out, step), near)
        distance = distance + leap
        count = count + 1
        searching = (
            searching & ~met & (dr.fma(direction.z, distance, start.z) < high) & (count < quality.steps)
        )
        return distance, leap, free & ~met, searching, count, trail

    state = (distance, types.Float(distance), free, searching & (start.z < high), count, _no_trail(types, x))
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
    vertical = dr.maximum(view.z, 1e-4)
    slope = types.Vector2(view.x / vertical, view.y / vertical)
    # The ray is followed by its height, which falls by `step` each time.
    rate = extent.steps_per_length(quality, view) / vertical
    step = dr.rcp(dr.maximum(rate, 1e-9))
    active = types.Bool(active)

    def ground(height: Any) -> tuple[Any, Any]:
        level, hole = surface.height(dr.fma(slope.x, height, x), dr.fma(slope.y, height, y), back)
        return dr.select(hole, types.Float(-1e9), level), hole

    floor = low - (high - low)

    def is_searching(height: Any, previous: Any, leap: Any, searching: Any, count: Any, trail: Any) -> Any:
        del height, previous, leap, count, trail
        return searching

    def advance(
        height: Any, previous: Any, leap: Any, searching: Any, count: Any, trail: Any
    ) -> tuple[Any, ...]:
        here = surface.probe(dr.fma(slope.x, height, x), dr.fma(slope.y, height, y), back)
        clearance = height - here.height
        met = ~here.hole & (clearance <= 0)
        rate = -1 - here.slope_x * towards.x - here.slope_y * towards.y
        lowest, to_lowest = trail.lowest_before(clearance, rate, leap, here)
        dipped = searching & ~met & (lowest < 0)
        count = count + 1
        onwards = searching & ~met & ~dipped & (height > floor) & (count < quality.steps)
        # Down to the crest the ray falls freely.
        near, out = _advance(here, towards, clearance, rate, step)
        free = dr.minimum(out, height - here.crest)
        trail = _trail(clearance, rate, here, free > near)
        fall = dr.maximum(free, near)
        return (
            dr.select(onwards, height - fall, dr.select(dipped, height + to_lowest, height)),
            dr.select(onwards, height, previous),
            dr.select(onwards, fall, leap),
            onwards,
            count,
            trail,
        )

    # Moving down, the ray runs against the view's slope.
    towards = types.Vector3(-slope.x, -slope.y, 0)
    top = types.Float(high + 0 * x)
    height, above, _, _, _, _ = dr.while_loop(
        (top, types.Float(top), types.Float(step), types.Bool(active), types.UInt32(0), _no_trail(types, x)),
        is_searching,
        advance,
        label="cloth: first hit",
    )

    under = types.Float(height)
    above_gap, _ = ground(above)
    above_gap = dr.maximum(above - above_gap, 0)
    under_gap, _ = ground(under)
    under_gap = dr.maximum(under_gap - under, 0)

    def refine(
        index: Any, above: Any, under: Any, above_gap: Any, under_gap: Any
    ) -> tuple[Any, Any, Any, Any, Any]:
        # Halving is right at walls, where the gap jumps; the secant is fast on smooth yarn.
        share = dr.clip(above_gap / dr.maximum(above_gap + under_gap, 1e-20), 0.02, 0.98)
        share = dr.select((index & 1) == 0, types.Float(0.5), share)
        middle = dr.fma(share, under - above, above)
        level, _ = ground(middle)
        met = level >= middle
        return (
            index + 1,
            dr.select(met, above, middle),
            dr.select(met, middle, under),
            dr.select(met, above_gap, middle - level),
            dr.select(met, level - middle, under_gap),
        )

    count = quality.refinements
    state = dr.while_loop(
        (types.UInt32(0), above, under, above_gap, under_gap),
        lambda index, *rest: index < count,
        refine,
        label="cloth: refine",
    )
    under = state[2]
    hole = types.Bool(False)
    if passing:
        # What has met yarn above the plane does not pass it.
        hole = passes_through(surface, x, y, view, back, active & (under <= 0), quality)
    return Hit(dr.fma(slope.x, under, x), dr.fma(slope.y, under, y), hole, under)


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
    zero = -_extent_of(surface, types).lift
    in_front = unoccluded(surface, x, y, zero, view, back, candidate, quality)
    # Seen from the other face the line goes on along (−x, −y, +z) of its mirrored frame.
    onwards = types.Vector3(-view.x, -view.y, view.z)
    behind = unoccluded(surface, x, y, zero, onwards, ~back, candidate & in_front, quality)
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
        return distance + step, dr.maximum(steepest, rise), count + 1

    # The yarn itself hides what lies below its tangent plane. Without any rise the search would only end
    # with the budget; 1e-3 is a horizon of 0.06°.
    here = surface.probe(x, y, back)
    own = dr.fma(here.slope_x, cosine, here.slope_y * sine)
    state = (types.Float(0.25 * step), dr.maximum(own, 1e-3), types.UInt32(0))
    return dr.while_loop(state, could_rise, advance, label="cloth: horizon")[1]
