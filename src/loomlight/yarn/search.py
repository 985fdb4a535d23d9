"""What searches along rays share: what they ask of the cloth, how finely, and how far they may step."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol

import drjit as dr

from loomlight.core.backend import ArrayTypes, array_types, maximum, minimum
from loomlight.core.masked_branch import masked_branch
from loomlight.yarn.geometry import Block, Probe, SurfacePoint

# A ray starts this share of the finest thread above its surface, or rounding would shadow it.
_LIFT = 2e-3
# Dips are looked for down to this share of the interval between two samples.
_NARROWEST = 0.02
# How far past an outline the next sample lies, in steps.
_HOP = 5e-3


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


class Extent:
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
        return maximum(abs(x) * self._per_x, abs(y) * self._per_y)

    def steps_per_length(self, quality: SearchQuality, direction: Any) -> Any:
        """Steps per millimetre of ray that the search takes along a unit direction [3]."""
        return maximum(
            self.threads(direction.x, direction.y) * quality.steps_per_thread,
            abs(direction.z) * self._per_relief * quality.steps_per_relief,
        )


def extent_of(surface: Surface, types: ArrayTypes) -> Extent:
    """The extent of a surface, uploaded once, until its heights are edited."""
    lengths = *surface.finest, *surface.height_bounds
    kept: Extent | None = surface.extents.get(types.Float)
    if kept is None or kept.lengths != lengths:
        kept = surface.extents[types.Float] = Extent(lengths, types)
    return kept


def upload_extent(surface: Surface, types: ArrayTypes) -> None:
    """Puts what searches keep of a surface on a backend, which otherwise happens at first use."""
    extent_of(surface, types)


def roof_along(
    surface: Surface, extent: Extent, x: Any, y: Any, height: Any, direction: Any, back: Any
) -> Any:
    """A height that the cloth stays below along a ray, as far as the ray itself is above x, y, `height`.

    Args:
        direction: along the ray [3], z > 0; of any length.
    """
    threads = extent.threads(direction.x, direction.y) / direction.z
    roof = extent.high
    for radius, share in surface.roofs(x, y, back, direction.x > 0, direction.y > 0):
        reached = (roof - height) * threads <= radius
        roof = dr.select(reached, minimum(roof, share * extent.high), roof)
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
        may_dip = falls & ((dr.fma(3, self.clearance, fall) < 0) | (dr.fma(3, clearance, -rise) < 0))

        def look(_: tuple[Any, Any]) -> tuple[Any, Any]:
            # Where the cubic's rate, a parabola over the step, turns from falling to rising.
            gain = clearance - self.clearance
            bend, linear = 3 * (fall + rise - 2 * gain), 6 * gain - 4 * fall - 2 * rise
            root = dr.sqrt(maximum(dr.fma(linear, linear, -4 * bend * fall), 0))
            share = -2 * fall / maximum(linear + root, 1e-20)
            rest = 1 - share
            start = (self.clearance * dr.fma(2, share, 1) + fall * share) * dr.square(rest)
            end = (clearance * dr.fma(2, rest, 1) - rise * rest) * dr.square(share)
            # A share of the interval that leads no further has been looked at.
            inside = (share > _NARROWEST) & (rest > _NARROWEST)
            return inside & (start + end < 0), rest * step

        # The next sample would wait for a root and a quotient, a third of what one takes.
        return masked_branch(may_dip, (types.Bool(False), types.Float(0)), look, "cloth: dip")

    def followed_by(self, clearance: Any, rate: Any, here: Probe, leaps: Any, stays: Any) -> Trail:
        """The trail after a sample, or this one where it `stays`.

        Nothing comes between over leaps, which are too long for a cubic to tell.
        """
        return Trail(
            dr.select(stays, self.clearance, dr.select(here.hole, 1e9, clearance)),
            dr.select(stays, self.rate, rate),
            dr.select(stays, self.yarn, here.yarn),
            dr.select(stays, self.known, ~here.hole & ~leaps),
        )


def no_trail(types: ArrayTypes, like: Any) -> Trail:
    zero = types.Float(0 * like)
    return Trail(zero, types.Float(zero), types.UInt32(0), types.Bool(False))


class Stride:
    """How far a ray may go from one sample to the next: one step, or less.

    Attributes:
        step: length of ray, along a direction [3] that need not be of length 1.
        right, up: whether it goes up the x and the y axis.
        hop: how far behind an outline the ray lands, despite rounding.
    """

    def __init__(self, direction: Any, step: Any) -> None:
        self.step = step
        self.hop = _HOP * step
        self._per_x = dr.rcp(maximum(abs(direction.x), 1e-9))
        self._per_y = dr.rcp(maximum(abs(direction.y), 1e-9))
        self.right, self.up = direction.x > 0, direction.y > 0

    def out(self, block: Block) -> Any:
        """Length of ray out of the cell."""
        return maximum(minimum(block.side_x * self._per_x, block.side_y * self._per_y), 0) + self.hop

    def onwards(self, probe: Probe, clearance: Any, rate: Any) -> Any:
        """Length of ray to the next sample.

        It is one step ahead, or less where that would pass an outline: what stands behind it may
        be a wall. A ray that sinks towards its yarn (`clearance` above it, changing at `rate`) fast enough to
        meet it on the way stops short of the outline first, or it could leave unseen through its flank.
        """
        edge = minimum(probe.edge_x * self._per_x, probe.edge_y * self._per_y)
        sinks = ~probe.hole & (dr.fma(rate, edge, clearance) < 0) & (edge > 2 * self.hop)
        beside = dr.select(sinks, edge - self.hop, maximum(edge, 0) + self.hop)
        return minimum(self.step, beside)
