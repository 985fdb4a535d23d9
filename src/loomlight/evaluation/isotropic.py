"""Cloth as isotropic BRDFs see it: means over its repeat and its turns, their error, and curves over angles.

A measured isotropic BRDF is what a flat piece of cloth shows on average, under all turns. The error of one
beside another is the rms of ln(f·cos + 0.001) over pairs of light and view to 80°. Curves tell cloth from
paint: albedo, what returns to the light and what the mirror's direction shows, each over the view's angle.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from drjit.llvm import Array2f, Array3f
from numpy.typing import NDArray

from loomlight.core.backend import upload_vector
from loomlight.core.footprint import Footprint
from loomlight.fabric.fabric import Fabric
from loomlight.models.lobes.model import LobesModel, LobesOptions
from loomlight.models.separable import FilteredBsdf

Floats = NDArray[np.float64]
# Added to f·cos before its logarithm, 1/sr.
FLOOR = 1e-3
# The cosine of the most grazing directions of pairs.
MIN_COSINE = float(np.cos(np.radians(80)))
# Angles of the views of curves, degrees.
VIEWS = (0.0, 15.0, 30.0, 45.0, 60.0, 75.0)
CURVES = ("albedo", "back", "mirror")


@dataclass(frozen=True)
class Pairs:
    """Unit vectors towards light and view, each [n, 3], all on the front."""

    light: Floats
    view: Floats

    def __len__(self) -> int:
        return len(self.light)

    @classmethod
    def drawn(cls, rng: np.random.Generator, count: int) -> Pairs:
        """Uniform over the hemisphere to 80°."""
        return cls(_above(rng, count), _above(rng, count))

    def turned(self, turns: int) -> Pairs:
        """The same under so many turns about z, one behind the other [turns · n]."""
        return Pairs(_turned(self.light, turns), _turned(self.view, turns))


def lobes_at(fabric: Fabric, pairs: Pairs) -> tuple[FilteredBsdf, Array3f]:
    """A mean of all that there is of a fabric for each view, by `lobes`, and the lights."""
    model = LobesModel.for_source(fabric, LobesOptions())
    width, height = fabric.repeat_mm
    count = len(pairs)
    light, view = (upload_vector(Array3f, vectors.T) for vectors in (pairs.light, pairs.view))
    zero = np.zeros(count, np.float32)
    # Ten repeats.
    sides = np.full(count, 10 * width, np.float32), np.full(count, 10 * height, np.float32)
    footprint = Footprint(Array2f(zero, zero), Array2f(sides[0], zero), Array2f(zero, sides[1]))
    at = model.at(view, footprint)
    assert isinstance(at, FilteredBsdf)
    return at, light


def turned_value(fabric: Fabric, pairs: Pairs, turns: int) -> Floats:
    """f·cos of a fabric, mean over so many turns [n, 3], 1/sr, by `lobes`."""

    def value(all_turns: Pairs) -> Floats:
        at, light = lobes_at(fabric, all_turns)
        return np.asarray(at.value(light), np.float64).T

    return mean_over_turns(value, pairs, turns)


def mean_over_turns(value: Callable[[Pairs], Floats], pairs: Pairs, turns: int) -> Floats:
    """The mean of values [n, 3] over so many turns."""
    mean: Floats = value(pairs.turned(turns)).reshape(turns, -1, 3).mean(axis=0)
    return mean


def logarithm(value: Floats) -> Floats:
    """ln(f·cos + 0.001)."""
    return np.log(np.maximum(value, 0) + FLOOR)


def rms(value: Floats, measured: Floats) -> float:
    """Of differences of `logarithm`, over pairs and channels."""
    return float(np.sqrt(np.mean((logarithm(value) - logarithm(measured)) ** 2)))


@dataclass(frozen=True)
class Angles:
    """Pairs of the error, then those of the curves, one behind the other.

    Attributes:
        pairs: all.
        errors: how many are for the error.
        lights: of each view of the albedo.
    """

    pairs: Pairs
    errors: int
    lights: int

    @classmethod
    def drawn(cls, errors: int, lights: int = 512) -> Angles:
        """Directions to 80° for the error, and those of the curves; always the same."""
        rng = np.random.default_rng(0)
        drawn = Pairs.drawn(rng, errors)
        angles = np.radians(VIEWS)
        views = np.stack([np.sin(angles), np.zeros(len(VIEWS)), np.cos(angles)], axis=1)
        # Light of a dome: their density is the cosine over π.
        u, azimuth = rng.random(lights), 2 * np.pi * rng.random(lights)
        dome = np.stack([np.sqrt(u) * np.cos(azimuth), np.sqrt(u) * np.sin(azimuth), np.sqrt(1 - u)], axis=1)
        return cls(
            Pairs(
                np.concatenate([drawn.light, np.tile(dome, (len(views), 1)), views, views * [-1, 1, 1]]),
                np.concatenate([drawn.view, np.repeat(views, lights, axis=0), views, views]),
            ),
            errors,
            lights,
        )

    def curves(self, value: Floats) -> dict[str, list[float]]:
        """Mean of channels by view: albedo, and f back to the light and in the mirror's direction, 1/sr."""
        grey = value.mean(axis=1)[self.errors :]
        count = len(VIEWS) * self.lights
        cosines = self.pairs.light[self.errors :, 2]
        albedo = np.pi * (grey[:count] / cosines[:count]).reshape(len(VIEWS), -1).mean(axis=1)
        back, mirror = (grey[count:] / cosines[count:]).reshape(2, -1)
        curves = zip(CURVES, (albedo, back, mirror), strict=True)
        return {name: [round(float(each), 5) for each in curve] for name, curve in curves}


def rise(curve: Sequence[float], angle: float) -> float:
    """Of a curve at an angle over that at 0°."""
    return curve[VIEWS.index(angle)] / curve[0]


def _above(rng: np.random.Generator, count: int) -> Floats:
    cosine, azimuth = rng.uniform(MIN_COSINE, 1, count), rng.uniform(0, 2 * np.pi, count)
    sine = np.sqrt(1 - cosine * cosine)
    return np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), cosine], axis=1)


def _turned(vectors: Floats, turns: int) -> Floats:
    """Vectors [n, 3] turned about z, [turns · n, 3]."""
    # Not by whole shares of a right angle: warp and weft would be met from the same sides over and over.
    angles = (np.arange(turns)[:, None] + 0.37) * (2 * np.pi / turns)
    x, y, z = vectors.T
    cosine, sine = np.cos(angles), np.sin(angles)
    turned = cosine * x - sine * y, sine * x + cosine * y, np.broadcast_to(z, (turns, len(vectors)))
    return np.stack([part.ravel() for part in turned], axis=1)
