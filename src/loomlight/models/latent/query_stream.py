"""The queries of a training, drawn in parts, each of which depends on the seed and its number alone.

Positions are uniform over the repeat. Levels are whole numbers; fine ones are more frequent, as they have
more texels. Views are half uniform in solid angle, half uniform on the projected disk. Half of the lights are
drawn alike; the others by half vectors close to a normal of the footprint, which find highlights.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.models.latent.queries import SIZE_OF_SIGMA, Reflectance
from loomlight.models.query_parts import MIN_COSINE, PART, QueryArrays, draw_directions

_Floats = NDArray[np.float32]
# Share of queries whose level is uniform; the others' density quarters with each level, as texels do.
_UNIFORM_LEVELS = 0.5
# Share of lights drawn by half vectors, and the bounds of the roughnesses of their Trowbridge–Reitz
# distributions, which are uniform in the logarithm.
_BY_HALF_VECTOR, _ALPHAS = 0.5, (0.02, 0.7)
# Key that separates the random numbers of queries from those of batches.
_STREAM = 3


@dataclass(frozen=True, eq=False)
class Queries(QueryArrays):
    """Queries and their values.

    Attributes:
        positions: in repeats [n, 2], 0 to 1.
        levels: whole numbers [n].
        lights, views: unit vectors [n, 3] in the frame of the face that is seen, z > 0.
        faces: 0 for the front, 1 for the back [n].
        values: f·cos, linear RGB [n, 3], 1/sr.
    """

    positions: _Floats
    levels: NDArray[np.uint8]
    lights: _Floats
    views: _Floats
    faces: NDArray[np.uint8]
    values: _Floats


class QueryStream:
    """Queries of a source."""

    def __init__(self, reflectance: Reflectance, levels: int, samples: int, seed: int) -> None:
        """
        Args:
            levels: of the pyramid.
            samples: estimates of which a value is the mean.
        """
        self._reflectance, self._levels, self._seed = reflectance, levels, seed
        # Of exact values one estimate is enough.
        self._samples = 1 if reflectance.is_apart else samples

    def part(self, number: int, count: int = PART) -> Queries:
        """The queries of one part."""
        key = (self._seed, _STREAM, number)
        rng = np.random.default_rng(key)
        positions = rng.random((count, 2), np.float32)
        levels = draw_levels(rng, count, self._levels)
        views = draw_directions(rng, count)
        faces = rng.integers(self._reflectance.faces, size=count, dtype=np.uint8)
        lights = draw_lights(rng, views, self._slopes(rng, positions, levels, faces))
        turn = np.where(faces == 1, -1, 1).astype(np.float32)[:, None]
        to_face = np.concatenate([np.ones_like(turn), np.ones_like(turn), turn], axis=1)

        def repeated(rows: _Floats) -> _Floats:
            return np.repeat(rows, self._samples, axis=0)

        estimates = self._reflectance.values(
            repeated(positions),
            repeated(levels.astype(np.float32)),
            repeated(lights * to_face),
            repeated(views * to_face),
            key,
        )
        values = estimates.reshape(count, self._samples, 3).mean(axis=1, dtype=np.float32)
        return Queries(positions, levels, lights, views, faces, values)

    def _slopes(
        self,
        rng: np.random.Generator,
        positions: _Floats,
        levels: NDArray[np.uint8],
        faces: NDArray[np.uint8],
    ) -> _Floats:
        """Slopes [n, 2] of one normal of each footprint."""
        count, slopes = len(positions), self._reflectance.slopes
        spread = rng.standard_normal((count, 2), np.float32) * np.exp2(levels)[:, None] / SIZE_OF_SIGMA
        rows, columns = slopes.shape[2:4]
        texel = np.floor(positions * np.array([columns, rows]) + spread).astype(np.intp)
        maps = rng.integers(slopes.shape[1], size=count)
        drawn: _Floats = slopes[faces, maps, texel[:, 1] % rows, texel[:, 0] % columns]
        return drawn


def draw_lights(rng: np.random.Generator, views: _Floats, slopes: _Floats | float = 0.0) -> _Floats:
    """Lights [n, 3] with z > 0, for views and normals (-slopes, 1) [n, 2]."""
    count = len(views)
    lights = draw_directions(rng, count)
    low, high = np.log(_ALPHAS)
    alpha = np.exp(rng.uniform(low, high, count))
    u, azimuth = rng.random(count), 2 * math.pi * rng.random(count)
    # Slopes of a Trowbridge–Reitz distribution: tan² = α² u / (1 − u).
    tangent = alpha * np.sqrt(u / (1 - u))
    about = slopes + tangent[:, None] * np.stack([np.cos(azimuth), np.sin(azimuth)], axis=1)
    halves = np.concatenate([-about, np.ones((count, 1))], axis=1)
    halves /= np.linalg.norm(halves, axis=1, keepdims=True)
    mirrored = 2 * (views * halves).sum(axis=1, keepdims=True) * halves - views
    chosen = (rng.random(count) < _BY_HALF_VECTOR) & (mirrored[:, 2] > MIN_COSINE)
    return np.where(chosen[:, None], mirrored, lights).astype(np.float32)


def draw_levels(rng: np.random.Generator, count: int, levels: int) -> NDArray[np.uint8]:
    """Whole numbers [count] below `levels`: half uniform, half in proportion to texels."""
    texels = 0.25 ** np.arange(levels)
    shares = _UNIFORM_LEVELS / levels + (1 - _UNIFORM_LEVELS) * texels / texels.sum()
    return rng.choice(levels, count, p=shares).astype(np.uint8)
