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

from loomlight.core.backend import array_types
from loomlight.yarn.geometry import Probe, SurfacePoint


class Surface(Protocol):
    """A source of cloth geometry: analytic, or textures of one repeat."""

    size: tuple[float, float]

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
    """How finely rays are searched.

    Attributes:
        steps_per_thread: steps while crossing the finest thread.
        steps_per_relief: steps while falling through the whole relief of the cloth.
        refinements: halvings of the bracket around a hit, alternating with secant steps.
        steps: at most so many; a ray still undecided then counts as free.
    """

    steps_per_thread: float = 10.0
    steps_per_relief: float = 10.0
    refinements: int = 8
    steps: int = 1024


DEFAULT_QUALITY = SearchQuality()
REFERENCE_QUALITY = SearchQuality(steps_per_thread=48, steps_per_relief=48, refinements=20, steps=16384)

# A ray starts this share of the finest thread above its surface, or rounding would shadow it.
_LIFT = 2e-3


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


def _steps_per_length(surface: Surface, quality: SearchQuality, direction: Any) -> Any:
    """Steps per millimetre of ray that the search takes along a unit direction [3]."""
    fine_x, fine_y = surface.finest
    low, high = surface.height_bounds
    across = dr.maximum(dr.abs(direction.x) / fine_x, dr.abs(direction.y) / fine_y)
    relief = max(high - low, 1e-6)
    return dr.maximum(
        across * quality.steps_per_thread, dr.abs(direction.z) * (quality.steps_per_relief / relief)
    )


def _way_out(probe: Probe, direction: Any) -> Any:
    """Length of ray that leads just out of the probed cell along a direction [3] of any length."""
    across = dr.select(direction.x > 0, probe.to_right, probe.to_left) / dr.maximum(dr.abs(direction.x), 1e-9)
    along = dr.select(direction.y > 0, probe.to_upper, probe.to_lower) / dr.maximum(dr.abs(direction.y), 1e-9)
    return dr.maximum(dr.minimum(across, along), 0)


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

    Args:
        x, y: draft coordinates, millimetres.
        height: of the point, millimetres, on the face given by `back`.
        direction: unit vector [3] in the frame of that face; with z ≤ 0 nothing is visible.
        back: Bool, the face the height counts from.
        active: lanes to search; the others return False.
    """
    types = array_types(x)
    _, high = surface.height_bounds
    lift = _LIFT * min(surface.finest)
    step = dr.rcp(dr.maximum(_steps_per_length(surface, quality, direction), 1e-9))
    hop = 0.01 * step  # lands on the far side of a cell's border despite rounding
    start = types.Vector3(x, y, height + lift)
    # The first step is short: what hides a point is most often the yarn right beside it.
    distance = types.Float(0.25 * step)
    free = types.Bool(active) & (direction.z > 0)
    searching = types.Bool(free)
    back = types.Bool(back)
    count = types.UInt32(0)

    def below_top(distance: Any, free: Any, searching: Any, count: Any) -> Any:
        del distance, free, count
        return searching

    def advance(distance: Any, free: Any, searching: Any, count: Any) -> tuple[Any, ...]:
        point = start + direction * distance
        here = surface.probe(point.x, point.y, back)
        met = searching & ~here.hole & (here.height > point.z)
        free = free & ~met
        count = count + 1
        # The ray rises, so above the crest it stays above until it leaves the cell.
        ahead = dr.select(point.z > here.crest, _way_out(here, direction) + hop, 0)
        distance = distance + dr.maximum(ahead, step)
        searching = (
            searching & ~met & (dr.fma(direction.z, distance, start.z) < high) & (count < quality.steps)
        )
        return distance, free, searching, count

    state = (distance, free, searching & (start.z < high), count)
    state = dr.while_loop(state, below_top, advance, label="cloth: unoccluded")
    return state[1]


def first_hit(
    surface: Surface,
    x: Any,
    y: Any,
    view: Any,
    back: Any,
    active: Any = True,
    quality: SearchQuality = DEFAULT_QUALITY,
) -> Hit:
    """The first point of the cloth along the view ray that crosses the plane z = 0 at x, y.

    Exact parallax (zhu2024 eq. 2 without its table and clamp). Rays that meet a wall end at the edge of the
    yarn that stands there.

    Args:
        x, y: draft coordinates where the ray meets the plane of the crown lines, millimetres.
        view: unit vector [3] towards the eye in the frame of the face seen, z > 0.
        back: Bool, which face is seen.
    """
    types = array_types(x)
    low, high = surface.height_bounds
    back = types.Bool(back)
    vertical = dr.maximum(view.z, 1e-4)
    slope = types.Vector2(view.x / vertical, view.y / vertical)
    # The ray is followed by its height, which falls by `step` each time.
    rate = _steps_per_length(surface, quality, view) / vertical
    step = dr.rcp(dr.maximum(rate, 1e-9))
    active = types.Bool(active)

    def ground(height: Any) -> tuple[Any, Any]:
        level, hole = surface.height(dr.fma(slope.x, height, x), dr.fma(slope.y, height, y), back)
        return dr.select(hole, types.Float(-1e9), level), hole

    floor = low - (high - low)

    def is_searching(height: Any, previous: Any, searching: Any, count: Any) -> Any:
        del height, previous, count
        return searching

    def advance(height: Any, previous: Any, searching: Any, count: Any) -> tuple[Any, ...]:
        here = surface.probe(dr.fma(slope.x, height, x), dr.fma(slope.y, height, y), back)
        met = ~here.hole & (here.height >= height)
        count = count + 1
        searching = searching & ~met & (height > floor) & (count < quality.steps)
        # Above the crest the ray falls freely to it, or until it leaves the cell.
        fall = dr.minimum(height - here.crest, _way_out(here, towards) + 0.01 * step)
        following = height - dr.maximum(fall, step)
        return (
            dr.select(searching, following, height),
            dr.select(searching, height, previous),
            searching,
            count,
        )

    # Moving down, the ray runs against the view's slope.
    towards = types.Vector3(-slope.x, -slope.y, 0)
    top = types.Float(high + 0 * x)
    height, above, _, _ = dr.while_loop(
        (top, types.Float(top), types.Bool(active), types.UInt32(0)),
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
    hole = active & passes_through(surface, x, y, view, back, active, quality)
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
    lift = -_LIFT * min(surface.finest)
    zero = types.Float(lift)
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
    fine_x, fine_y = surface.finest
    _, high = surface.height_bounds
    step = dr.rcp(dr.maximum(dr.abs(cosine) / fine_x, dr.abs(sine) / fine_y) * quality.steps_per_thread)
    start = height + _LIFT * min(surface.finest)
    back = types.Bool(back)

    def could_rise(distance: Any, steepest: Any, count: Any) -> Any:
        return (high - start > steepest * distance) & (count < quality.steps)

    def advance(distance: Any, steepest: Any, count: Any) -> tuple[Any, ...]:
        level, hole = surface.height(dr.fma(cosine, distance, x), dr.fma(sine, distance, y), back)
        rise = dr.select(hole, types.Float(0), (level - start) / distance)
        return distance + step, dr.maximum(steepest, rise), count + 1

    # Without any rise the search would only end with the budget; 1e-3 is a horizon of 0.06°.
    state = (types.Float(0.5 * step), types.Float(1e-3 + 0 * x), types.UInt32(0))
    return dr.while_loop(state, could_rise, advance, label="cloth: horizon")[1]
