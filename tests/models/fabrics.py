"""Fabrics and queries that every model is tried on."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from drjit.llvm.ad import Array2f, Array3f, Float
from numpy.typing import NDArray

from loomlight.core.footprint import Footprint
from loomlight.fabric import Fabric, fabric_from_text

TEXTS = {
    "plain": 'weave = "plain"\ngap = 0.3',
    "coloured twill": """
        weave = "twill 3/1"
        [warp]
        color = ["#c02020", "#2040c0", "#e0e0d0"]
        [weft]
        color = "#806020"
        """,
    "translucent satin": """
        weave = "satin 5/2"
        [warp]
        translucency = 0.6
        roughness = 0.5
        [weft]
        translucency = 0.4
        """,
    "with sheen": """
        weave = "twill 2/2"
        [sheen]
        strength = 0.7
        roughness = 0.4
        """,
    "irregular": """
        weave = "plain"
        gap = 0.25
        [warp]
        yarn = "linen"
        melange = 0.2
        [weft]
        yarn = "woollen"
        neps = 30
        nep_color = "#a02010"
        [variation]
        irregularity = 1.5
        """,
}
# All the light that the energy bound admits is sent on, half of it to the far side.
WHITE = """
    weave = "twill 2/1"
    [warp]
    color = [1.0, 1.0, 1.0]
    translucency = 0.5
    [weft]
    color = [1.0, 1.0, 1.0]
    translucency = 0.5
    [sheen]
    strength = 0.5
    """


def fabric(name: str) -> Fabric:
    """A fabric of `TEXTS`."""
    return fabric_from_text(TEXTS[name])


@dataclass
class Queries:
    """n lights, views and footprints, as numpy arrays: any lanes can be taken out of them.

    Attributes:
        lights, views: unit vectors [n, 3].
        centres: [n, 2], millimetres.
        edges: duv_dx and duv_dy [n, 2, 2], millimetres.
    """

    lights: NDArray[np.float64]
    views: NDArray[np.float64]
    centres: NDArray[np.float64]
    edges: NDArray[np.float64]

    def __getitem__(self, lanes: Any) -> Queries:
        return Queries(self.lights[lanes], self.views[lanes], self.centres[lanes], self.edges[lanes])

    def __len__(self) -> int:
        return len(self.lights)

    @property
    def light(self) -> Array3f:
        """The lights on a device."""
        return vectors(self.lights)

    @property
    def view(self) -> Array3f:
        """The views on a device."""
        return vectors(self.views)

    @property
    def footprint(self) -> Footprint:
        """The footprints on a device."""
        return Footprint(*(pairs(part) for part in (self.centres, self.edges[:, 0], self.edges[:, 1])))

    def moved(self, by: tuple[float, float]) -> Queries:
        """The same queries elsewhere on the cloth."""
        return Queries(self.lights, self.views, self.centres + np.asarray(by), self.edges)


def vectors(values: NDArray[np.float64]) -> Array3f:
    """Vectors [n, 3] on a device."""
    return Array3f(np.ascontiguousarray(values.T, np.float32))


def pairs(values: NDArray[np.float64]) -> Array2f:
    """Points [n, 2] on a device."""
    return Array2f(np.ascontiguousarray(values.T, np.float32))


def numbers(rng: np.random.Generator, count: int) -> tuple[Float, Array2f]:
    """What samplers take: uniform numbers, and pairs of them."""
    return Float(rng.random(count, np.float32)), Array2f(rng.random((2, count), np.float32))


def directions(rng: np.random.Generator, count: int) -> NDArray[np.float64]:
    """Unit vectors [count, 3] on both sides, uniform above 6° of elevation."""
    z = rng.uniform(0.1, 1, count) * rng.choice([-1.0, 1.0], count)
    azimuth = rng.uniform(0, 2 * math.pi, count)
    radius = np.sqrt(1 - z**2)
    return np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), z], axis=1)


def queries(cloth: Fabric, count: int, seed: int) -> Queries:
    """Both sides, reflection and transmission; parallelograms from a tenth of a thread to 3 repeats."""
    rng = np.random.default_rng(seed)
    extent = np.asarray(cloth.repeat_mm)
    thread = float(cloth.layout().warp.spacing.mean())
    size = np.exp(rng.uniform(math.log(0.1 * thread), math.log(3 * extent.max()), count))
    turn, shear = rng.uniform(0, 2 * math.pi, count), rng.uniform(-0.6, 0.6, count)
    along = np.stack([np.cos(turn), np.sin(turn)], axis=1)
    across = np.stack([-along[:, 1], along[:, 0]], axis=1) * rng.uniform(0.3, 1, (count, 1))
    edges = np.stack([along, across + shear[:, None] * along], axis=1) * size[:, None, None]
    centres = rng.uniform(-1, 2, (count, 2)) * extent
    return Queries(directions(rng, count), directions(rng, count), centres, edges)
