"""The point model of a fabric's repeat for rays in NumPy arrays: what trainings learn from."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Vec3
from loomlight.core.backend import array_types
from loomlight.core.llvm import llvm_float
from loomlight.fabric.fabric import Fabric
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry

_Floats = NDArray[np.float32]
# Rays in one launch.
_BATCH = 1 << 20


class FabricPoints:
    """Yarn points that view rays meet, without random threads: those vary over the whole cloth.

    Attributes:
        model: the point model.
        types: arrays of the backend that evaluates it.
    """

    def __init__(self, fabric: Fabric) -> None:
        appearance = fabric.appearance()
        variation = dataclasses.replace(appearance.variation, fibre_noise=0.0, colour_noise=0.0)
        plain = dataclasses.replace(appearance, variation=variation)
        self.model = YarnScattering(YarnGeometry(fabric.layout()), plain)
        self.types = array_types(llvm_float())

    def values(self, positions: _Floats, lights: _Floats, views: _Floats) -> _Floats:
        """f·cos [n, 3], 1/sr, of rays through positions [n, 2], millimetres.

        Args:
            lights, views: unit vectors [n, 3].
        """

        def evaluate(x: Float, y: Float, view: Vec3, light: Vec3) -> Any:
            return self.model.evaluate(self.model.locate(x, y, view), light, view).numpy().T

        return self._launched(evaluate, np.empty((len(positions), 3), np.float32), positions, views, lights)

    def straight_through(self, positions: _Floats, views: _Floats) -> _Floats:
        """1 where rays pass through holes, less under sheen, else 0 [n]."""

        def evaluate(x: Float, y: Float, view: Vec3) -> Any:
            return self.model.straight_through(self.model.locate(x, y, view), view).numpy()

        return self._launched(evaluate, np.empty(len(positions), np.float32), positions, views)

    def _launched(
        self, evaluate: Callable[..., Any], found: _Floats, positions: _Floats, *directions: _Floats
    ) -> _Floats:
        for first in range(0, len(positions), _BATCH):
            part = slice(first, first + _BATCH)
            x, y = (self.types.Float(np.ascontiguousarray(row)) for row in positions[part].T)
            vectors = (self.types.Vector3(np.ascontiguousarray(rows[part].T)) for rows in directions)
            found[part] = evaluate(x, y, *vectors)
        return found
