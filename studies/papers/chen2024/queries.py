"""The queries of chen2024 5.1 for a material: every pair of directions over every footprint.

Footprint centres are stratified in 8×8 cells of the repeat. About each there are 10 sizes between the
smallest footprint (1/128 of the repeat; the paper begins at 0) and one repeat, and 10 between one and five
repeats, stratified. Directions are stratified in x and y, 8×8 cells of [−1, 1]² for lights and for views;
those outside the unit disc are no directions: about 50 × 50 pairs are left, so 2500 × 1280 = 3.2 million
queries with the light on the side of the view (BRDF), and as many with other lights behind the cloth (BTDF).
All pairs have the same footprints, so one slice serves 1280 queries, and visibility takes 50 traced views and
100 traced lights.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.aggregate.queries import MIN_COSINE, FabricScale, fabric_scale
from loomlight.aggregate.slices import FabricSlices
from loomlight.aggregate.tables import TEXELS_PER_THREAD
from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from studies.papers.chen2024.materials import paper_material

_CELLS = 8
_SIZES = 10  # in each of the two ranges
_MAX_REPEATS = 5
_TEXELS_PER_REPEAT = 128
FULL_QUERIES = 2 * 2500 * _CELLS**2 * 2 * _SIZES
# Fewer would leave fewer than 8 pairs to each of 128 footprints.
MIN_QUERIES = 1024


@dataclass(frozen=True, eq=False)
class MaterialQueries:
    """Queries of one material: each of n pairs of directions over each of m footprints.

    Attributes:
        lights, views: unit vectors [l, 3] and [v, 3], z < 0 behind the cloth; all views are in front.
        pairs: index of the light and of the view of each pair [n, 2].
        centres: of the footprints [m, 2], millimetres.
        sizes: sides of their squares [m], millimetres.
    """

    lights: NDArray[np.float32]
    views: NDArray[np.float32]
    pairs: NDArray[np.uint16]
    centres: NDArray[np.float32]
    sizes: NDArray[np.float32]

    @property
    def count(self) -> int:
        """Number of queries."""
        return len(self.pairs) * len(self.sizes)

    @property
    def transmits(self) -> NDArray[np.bool_]:
        """Whether light and view of each pair lie on different sides [n]."""
        return self.lights[self.pairs[:, 0], 2] * self.views[self.pairs[:, 1], 2] < 0


def material_queries(number: int, seed: int = 0, queries: int = FULL_QUERIES) -> MaterialQueries:
    """The queries of material `number` in the set of `seed`.

    Args:
        queries: approximate number. Fewer queries have fewer sizes a centre and, in the same proportion,
            fewer of the pairs; all 64 centres stay.

    Raises:
        InputError: no such material, or fewer than 1024 queries.
    """
    return fabric_queries(paper_material(number, seed), [seed, number], queries)


def fabric_queries(fabric: Fabric, seed: list[int], queries: int = FULL_QUERIES) -> MaterialQueries:
    """The queries of any fabric; they depend on it and on the numbers of `seed` alone.

    Raises:
        InputError: fewer than 1024 queries.
    """
    if queries < MIN_QUERIES:
        raise InputError(f"{queries} queries a material are too few: give at least {MIN_QUERIES}.")
    rng = np.random.default_rng([*seed, 1])
    scale = fabric_scale(fabric.layout())
    sizes_each = int(np.clip(round(_SIZES * np.sqrt(queries / FULL_QUERIES)), 1, _SIZES))
    centres, sizes = _footprints(rng, scale, sizes_each)
    views = _directions(rng)
    lights = [_directions(rng), _directions(rng) * np.asarray([1, 1, -1], np.float32)]
    pairs = _pairs([len(side) for side in lights], len(views))
    pair_count = round(queries / len(sizes))
    if queries < FULL_QUERIES and pair_count < len(pairs):
        pairs = pairs[np.sort(rng.permutation(len(pairs))[:pair_count])]
    used_lights, light = np.unique(pairs[:, 0], return_inverse=True)
    used_views, view = np.unique(pairs[:, 1], return_inverse=True)
    return MaterialQueries(
        np.concatenate(lights)[used_lights],
        views[used_views],
        np.stack([light, view], axis=-1).astype(np.uint16),
        centres,
        sizes,
    )


def slice_means(
    fabric: Fabric,
    queries: MaterialQueries,
    float_type: type,
    texels_per_thread: float | None = None,
) -> NDArray[np.float32]:
    """Means of slices over the footprints of queries [n, m, 5]: C_warp, C_weft, S_warp, S_weft, 1/sr; hole.

    Args:
        float_type: the Dr.Jit Float type to compute with.
        texels_per_thread: of the slices' grid, at least. None is 32, and 128 a repeat: a texel is then no
            larger than the smallest footprint.
    """
    model = YarnScattering(YarnGeometry(fabric.layout()), fabric.appearance())
    if texels_per_thread is None:
        texels_per_thread = max(
            TEXELS_PER_THREAD, _TEXELS_PER_REPEAT / min(fabric.layout().warp_on_top.shape)
        )
    slices = FabricSlices(model, float_type, texels_per_thread, shadows="mapped")
    boxes = np.stack([queries.sizes, queries.sizes], axis=-1)
    return slices.box_means(queries.lights, queries.views, queries.pairs, queries.centres, boxes)


def _footprints(
    rng: np.random.Generator, scale: FabricScale, sizes_each: int
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Centres [m, 2] and sizes [m]: a centre a cell, two times `sizes_each` sizes a centre."""
    x, y = _in_cells(rng)
    centres = np.stack([x * scale.extent[0], y * scale.extent[1]], axis=-1)
    smallest = scale.size_range[0]
    ranges = ((smallest, scale.repeat), (scale.repeat, _MAX_REPEATS * scale.repeat))
    strata = np.arange(sizes_each)
    drawn = [
        low + (high - low) * (strata + rng.random((len(centres), sizes_each))) / sizes_each
        for low, high in ranges
    ]
    sizes = np.concatenate(drawn, axis=1)
    repeated = np.repeat(centres, sizes.shape[1], axis=0)
    return repeated.astype(np.float32), sizes.ravel().astype(np.float32)


def _directions(rng: np.random.Generator) -> NDArray[np.float32]:
    """Unit vectors [about 50, 3] in front of the cloth: those of 64 draws that are directions."""
    x, y = (2 * value - 1 for value in _in_cells(rng))
    square = x**2 + y**2
    valid = square <= 1 - MIN_COSINE**2
    vectors = np.stack([x, y, np.sqrt(np.where(valid, 1 - square, 0))], axis=-1)[valid]
    return vectors.astype(np.float32)


def _in_cells(rng: np.random.Generator) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """A draw in each of 8×8 cells of the unit square: x and y [64]."""
    row, column = np.divmod(np.arange(_CELLS**2), _CELLS)
    return (column + rng.random(_CELLS**2)) / _CELLS, (row + rng.random(_CELLS**2)) / _CELLS


def _pairs(lights: list[int], views: int) -> NDArray[np.intp]:
    """Every light with every view [n, 2], lights of one side after those of the other."""
    return np.stack(np.divmod(np.arange(sum(lights) * views), views), axis=-1)
