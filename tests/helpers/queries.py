"""Queries of models: lights, views and footprints."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from drjit.llvm.ad import Array3f
from numpy.typing import NDArray

from loomlight.core.footprint import Footprint
from loomlight.fabric import Fabric
from tests.helpers.arrays import pairs, vectors
from tests.helpers.directions import directions


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


def queries(cloth: Fabric, count: int, seed: int, smallest: float = 0.1) -> Queries:
    """Both sides, reflection and transmission; parallelograms from `smallest` of a thread to 3 repeats."""
    rng = np.random.default_rng(seed)
    extent = np.asarray(cloth.repeat_mm)
    thread = float(cloth.layout().warp.spacing.mean())
    size = np.exp(rng.uniform(math.log(smallest * thread), math.log(3 * extent.max()), count))
    turn, shear = rng.uniform(0, 2 * math.pi, count), rng.uniform(-0.6, 0.6, count)
    along = np.stack([np.cos(turn), np.sin(turn)], axis=1)
    across = np.stack([-along[:, 1], along[:, 0]], axis=1) * rng.uniform(0.3, 1, (count, 1))
    edges = np.stack([along, across + shear[:, None] * along], axis=1) * size[:, None, None]
    centres = rng.uniform(-1, 2, (count, 2)) * extent
    return Queries(directions(rng, count), directions(rng, count), centres, edges)
