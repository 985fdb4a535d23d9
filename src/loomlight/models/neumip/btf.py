"""Queries of a multi-resolution BTF: what a training learns from, keyed by a seed and a number.

M(u, σ, light, view) is the mean of f·cos over a Gaussian of standard deviation σ (kuznetsov2021 eq. 1, times
the cosine of the light as everywhere in this package). Positions are uniform over the repeat; directions are
half uniform in solid angle, half uniform on the projected disk; sizes favour fine levels, which have more
texels.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from loomlight.models.mip_pyramid import SIZE_OF_SIGMA, PyramidShape
from loomlight.models.neumip.fabric_btf import FabricBtf
from loomlight.models.neumip.measured_btf import PictureBtf
from loomlight.models.query_parts import PART, QueryArrays, draw_directions
from loomlight.models.query_sources import QuerySources

_Floats = NDArray[np.float32]
# Share of queries whose level is uniform; the others' density halves with each level.
_UNIFORM_LEVELS = 0.4
# Footprints of twice the repeat are means of the whole.
_LEVELS_BEYOND = 1.0
# Share of queries whose light is on the other side, where light passes.
TRANSMISSION_SHARE = 0.4
# Keys that separate the random numbers of queries from those of batches.
_STREAM = 3


class Btf(Protocol):
    """The finest BTF B of a source; its means over Gaussians are the truth of a training.

    Attributes:
        faces: 2 where front and back differ, else 1.
        transmits: whether light from the other side is seen.
        has_holes: whether rays pass straight through.
    """

    faces: int
    transmits: bool
    has_holes: bool

    def values(
        self,
        positions: NDArray[np.float32],
        lights: NDArray[np.float32],
        views: NDArray[np.float32],
        seed: tuple[int, ...],
    ) -> NDArray[np.float32]:
        """f·cos of single rays, linear RGB [n, 3], 1/sr; or unbiased estimates of it.

        Args:
            positions: on the reference plane [n, 2], millimetres.
            lights, views: unit vectors [n, 3]; z < 0 is the back. On the same side, unless light is
                transmitted.
            seed: of the random numbers of the estimates.
        """

    def holes(self, positions: NDArray[np.float32], views: NDArray[np.float32]) -> NDArray[np.float32]:
        """Share of light that passes straight through towards views [n], 0 to 1; asked if `has_holes`."""


# Of fabrics and pictures by this package; of what has to be path traced by `loomlight.mitsuba`.
BTFS = QuerySources[Btf]("neumip", {"fabric": FabricBtf, "btf": PictureBtf})


@dataclass(frozen=True, eq=False)
class Queries(QueryArrays):
    """Queries and their values.

    Attributes:
        positions: in repeats [n, 2], 0 to 1.
        levels: log2 of the footprint's size over `PyramidShape.footprint_mm` [n].
        lights, views: x and y of unit vectors [n, 2] in the frame of the face that is seen.
        faces: 0 for the front, 1 for the back [n].
        is_transmission: 1 for lights on the other side, else 0 [n].
        values: f·cos, linear RGB [n, 3], 1/sr.
        holes: share of light that passes straight through towards the view [n], 0 to 1.
    """

    positions: _Floats
    levels: _Floats
    lights: _Floats
    views: _Floats
    faces: NDArray[np.uint8]
    is_transmission: NDArray[np.uint8]
    values: _Floats
    holes: _Floats


class QueryStream:
    """Queries of a source in parts, each of which depends on the seed and its number alone."""

    def __init__(self, btf: Btf, shape: PyramidShape, samples: tuple[int, int], seed: int) -> None:
        """
        Args:
            samples: rays of a query of a texel, and at most; between them as many as its side is long.
        """
        self._btf, self._shape, self._samples, self._seed = btf, shape, samples, seed

    def part(self, number: int, count: int = PART) -> Queries:
        """The queries of one part."""
        rng = np.random.default_rng([self._seed, _STREAM, number])
        positions = rng.random((count, 2), np.float32)
        finer = math.log2(self._shape.footprint_texels)
        levels = draw_levels(rng, count, self._shape.levels - 1 + finer)
        lights, views = draw_directions(rng, count), draw_directions(rng, count)
        # A measured BTF has lights and views of its own.
        if (measured := getattr(self._btf, "measured", None)) is not None:
            lights, views = (known[rng.integers(len(known), size=count)] for known in measured)
        faces = rng.integers(self._btf.faces, size=count, dtype=np.uint8)
        extent = np.array([self._shape.width_mm, self._shape.height_mm], np.float32)
        texels = np.exp2(levels)
        counts = np.minimum(np.ceil(self._samples[0] * texels).astype(np.intp), self._samples[1])
        ends = np.cumsum(counts)
        # A number of rays that few parts differ in: Dr.Jit compiles anew for another one.
        query = np.repeat(np.arange(count), counts)
        query = np.pad(query, (0, -len(query) % max(1, count // 4)))
        sigmas = self._shape.texel_mm / SIZE_OF_SIGMA * texels
        offsets = rng.standard_normal((len(query), 2), np.float32)
        points = np.asarray((positions * extent)[query] + sigmas[query, None] * offsets, np.float32)
        levels -= np.float32(finer)
        is_transmission = np.zeros(count, np.uint8)
        if self._btf.transmits:
            is_transmission = (rng.random(count) < TRANSMISSION_SHARE).astype(np.uint8)
        is_back, mirror = (faces == 1)[:, None], np.array([1, 1, -1], np.float32)
        of_view = np.where(is_back, mirror * views, views)
        of_light = np.where(is_back ^ (is_transmission == 1)[:, None], mirror * lights, lights)
        found = self._btf.values(points, of_light[query], of_view[query], (self._seed, _STREAM, number))
        starts, number_of = ends - counts, counts.astype(np.float32)
        values = np.add.reduceat(found[: ends[-1]], starts) / number_of[:, None]
        holes = np.zeros(count, np.float32)
        if self._btf.has_holes:
            holes = np.add.reduceat(self._btf.holes(points, of_view[query])[: ends[-1]], starts) / number_of
        lights, views = lights[:, :2].copy(), views[:, :2].copy()
        return Queries(positions, levels, lights, views, faces, is_transmission, values, holes)


def draw_levels(rng: np.random.Generator, count: int, coarsest: float) -> _Floats:
    """Levels [count] from 0 to one beyond the coarsest, fine ones more often."""
    top = coarsest + _LEVELS_BEYOND
    u = rng.random(count)
    uniform = u * top
    falling = -np.log2(1 - u * (1 - 2.0**-top))
    return np.where(rng.random(count) < _UNIFORM_LEVELS, uniform, falling).astype(np.float32)


def light_density(queries: Queries, measured: bool) -> _Floats:
    """Density of the lights of queries on their side [n], 1/sr.

    Args:
        measured: of a BTF's own lights, which are taken as spread evenly.
    """
    if measured:
        return np.full(len(queries), 1 / (2 * math.pi), np.float32)
    cosines = np.sqrt(np.maximum(1 - np.square(queries.lights).sum(axis=1), 1e-4))
    # Half of them 1/2π, half cosine/π; the lowest cosine changes both by a fiftieth.
    return np.asarray(0.5 * (1 / (2 * np.pi) + cosines / np.pi), np.float32)
