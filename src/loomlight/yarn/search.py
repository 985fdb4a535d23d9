"""Common parts of searches along rays: the surface, its quality, and control of steps."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol

import drjit as dr

from loomlight.core.arrays import Float, FloatType, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, array_types, maximum, minimum
from loomlight.core.masked_branch import masked_branch
from loomlight.yarn.flanks import SurfacePoint
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
