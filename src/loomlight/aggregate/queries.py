"""Query sets: footprints, lights and views that models are trained and evaluated on.

Directions are stratified over the hemispheres that the fabric admits, uniform in solid angle; positions are
uniform over the repeat, sizes log-uniform from 1/128 of the repeat (of 8 threads, for longer repeats) to 5
repeats. A set depends on its seed and step alone, so any step of a training can be drawn again.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.scattering.appearance import Appearance
from loomlight.yarn.layout import ClothLayout

BANDS = ("b0", "b1", "b2", "b3")
# 2.9° of elevation: more grazing directions see crests alone.
MIN_COSINE = 0.05
_MAX_REPEAT = 8
_MIN_FRACTION = 1 / 128
_MAX_REPEATS = 5.0


@dataclass(frozen=True)
class FabricScale:
    """Reference lengths of footprints, millimetres: geometric means of both directions.

    Attributes:
        thread: spacing of the threads.
        repeat: size of the repeat.
        extent: width and height of the repeat.
    """

    thread: float
    repeat: float
    extent: tuple[float, float]

    @property
    def size_range(self) -> tuple[float, float]:
        """Smallest and largest footprint of a query set."""
        return _MIN_FRACTION * min(self.repeat, _MAX_REPEAT * self.thread), _MAX_REPEATS * self.repeat

    def bands(self, sizes: NDArray[np.float64]) -> NDArray[np.intp]:
        """Index into `BANDS`: under a quarter yarn, to 2 yarns, to one repeat, above.

        Args:
            sizes: sides of footprints, millimetres, any shape.
        """
        bounds = [0.25 * self.thread, 2 * self.thread, max(self.repeat, 2 * self.thread)]
        return np.searchsorted(bounds, sizes, side="right")


def fabric_scale(layout: ClothLayout) -> FabricScale:
    """The lengths of a layout."""
    width, height = layout.size
    picks, ends = layout.warp_on_top.shape
    return FabricScale(math.sqrt(width / ends * height / picks), math.sqrt(width * height), (width, height))


@dataclass(frozen=True, eq=False)
class QuerySet:
    """Queries of n pairs of directions and m footprints each.

    Attributes:
        lights, views: unit vectors [l, 3] and [v, 3], z < 0 on the back.
        pairs: index of the light and of the view of each pair [n, 2].
        centres: of the footprints [n, m, 2], millimetres.
        sizes: sides of their squares [n, m], millimetres.
    """

    lights: NDArray[np.float64]
    views: NDArray[np.float64]
    pairs: NDArray[np.intp]
    centres: NDArray[np.float64]
    sizes: NDArray[np.float64]

    @property
    def boxes(self) -> NDArray[np.float64]:
        """Width and height of the squares [n, m, 2], millimetres."""
        return np.stack([self.sizes, self.sizes], axis=-1)


def admits_transmission(appearance: Appearance) -> bool:
    """Whether any thread transmits light by scattering."""
    families = (appearance.warp, appearance.weft)
    return any(bool(f.diffuse_transmit.any() or f.specular_transmit.any()) for f in families)


def query_set(
    scale: FabricScale,
    pairs: int,
    footprints: int,
    seed: int,
    step: int = 0,
    transmits: bool = False,
    back: bool = True,
    lights: int | None = None,
    views: int | None = None,
) -> QuerySet:
    """Draws a query set.

    Args:
        pairs, footprints: number of pairs, and of footprints for each.
        seed, step: of the random numbers.
        transmits: half of the pairs have light and view on different sides.
        back: half of the views see the back.
        lights, views: number of distinct directions; None is one for each pair. Pairs that share directions
            make slices cheap.

    Raises:
        InputError: no pairs or footprints, or too few directions to have one on every side.
    """
    light_count, view_count = lights or pairs, views or pairs
    view_sides = 2 if back else 1
    light_sides = 2 if back or transmits else 1
    if min(pairs, footprints) < 1 or light_count < light_sides or view_count < view_sides:
        raise InputError(
            f"{pairs} pairs of {footprints} footprints with {light_count} lights and {view_count} views: "
            f"give at least 1, 1, {light_sides} and {view_sides}."
        )
    rng = np.random.default_rng([seed, step])
    light_vectors = _over_sides(rng, light_count, light_sides)
    view_vectors = _over_sides(rng, view_count, view_sides)
    index = _balanced_pairs(rng, light_vectors, view_vectors, pairs, transmits)
    centres = rng.random((pairs, footprints, 2)) * scale.extent
    low, high = np.log(scale.size_range)
    strata = rng.permuted(np.tile(np.arange(footprints), (pairs, 1)), axis=1)
    sizes = np.exp(low + (high - low) * (strata + rng.random((pairs, footprints))) / footprints)
    return QuerySet(light_vectors, view_vectors, index, centres, sizes)


def stratified_hemisphere(rng: np.random.Generator, count: int) -> NDArray[np.float64]:
    """Unit vectors [count, 3] above the cloth, one in each of `count` cells of the same solid angle.

    The cells are rings of equal height, each split evenly in azimuth; elevations begin at `MIN_COSINE`.
    """
    rings = max(1, round(math.sqrt(count / math.pi)))
    bounds = np.round(np.linspace(0, count, rings + 1)).astype(int)
    vectors = np.empty((count, 3))
    for first, last in pairwise(bounds):
        cells = last - first
        height = (first + cells * (rng.permutation(cells) + rng.random(cells)) / cells) / count
        z = MIN_COSINE + (1 - MIN_COSINE) * height
        azimuth = 2 * math.pi * (np.arange(cells) + rng.random(cells)) / cells
        radius = np.sqrt(1 - z * z)
        vectors[first:last] = np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), z], axis=1)
    return vectors


def _over_sides(rng: np.random.Generator, count: int, sides: int) -> NDArray[np.float64]:
    """Stratified vectors, the front's first; with two sides half of them are the back's."""
    back_count = count // 2 if sides == 2 else 0
    parts = [stratified_hemisphere(rng, count - back_count)]
    if back_count:
        parts.append(stratified_hemisphere(rng, back_count) * [1, 1, -1])
    return np.concatenate(parts)


def _balanced_pairs(
    rng: np.random.Generator,
    lights: NDArray[np.float64],
    views: NDArray[np.float64],
    pairs: int,
    transmits: bool,
) -> NDArray[np.intp]:
    """Pairs [n, 2] of light and view, in which all views, and all lights of a side, occur equally often."""
    view = np.concatenate([rng.permutation(len(views)) for _ in range(math.ceil(pairs / len(views)))])[:pairs]
    crosses = np.zeros(pairs, bool)
    if transmits:
        for side in (False, True):
            chosen = np.flatnonzero((views[view, 2] < 0) == side)
            crosses[chosen[rng.permutation(len(chosen))[: len(chosen) // 2]]] = True
    light_is_back = (views[view, 2] < 0) ^ crosses
    light = np.empty(pairs, np.intp)
    for side in (False, True):
        slots = np.flatnonzero(light_is_back == side)
        deck = np.flatnonzero((lights[:, 2] < 0) == side)
        if len(slots):
            rounds = math.ceil(len(slots) / len(deck))
            light[slots] = np.concatenate([rng.permutation(deck) for _ in range(rounds)])[: len(slots)]
    return np.stack([light, view], axis=1)
