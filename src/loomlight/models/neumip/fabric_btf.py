"""The BTF of a fabric: the exact point model, sheen, shadows and transmission included."""

from __future__ import annotations

import dataclasses

import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import array_types
from loomlight.core.llvm import llvm_float
from loomlight.fabric.fabric import Fabric
from loomlight.scattering.point import PointModel
from loomlight.yarn.geometry import YarnGeometry

# Rays in one launch.
_BATCH = 1 << 20


class FabricBtf:
    """f·cos of the yarn points that rays meet.

    Attributes:
        faces: 2.
        transmits: whether yarns of either family let light through.
        has_holes: whether there are holes between the yarns.
    """

    faces = 2

    def __init__(self, fabric: Fabric) -> None:
        layout, appearance = fabric.layout(), fabric.appearance()
        families = appearance.warp, appearance.weft
        self.transmits = any(
            bool(np.any(albedo))
            for family in families
            for albedo in (family.diffuse_transmit, family.specular_transmit)
        )
        self.has_holes = layout.open_area > 0
        # A repeat has no random threads: those vary over the whole cloth.
        plain = dataclasses.replace(
            appearance,
            variation=dataclasses.replace(appearance.variation, fibre_noise=0.0, colour_noise=0.0),
        )
        self._model = PointModel(YarnGeometry(layout), plain)
        self._types = array_types(llvm_float())

    def values(
        self,
        positions: NDArray[np.float32],
        lights: NDArray[np.float32],
        views: NDArray[np.float32],
        seed: tuple[int, ...],
    ) -> NDArray[np.float32]:
        """f·cos [n, 3]; see `Btf.values`. The point model is exact, so the seed is not used."""
        del seed
        found = np.empty((len(positions), 3), np.float32)
        for first in range(0, len(positions), _BATCH):
            part = slice(first, first + _BATCH)
            x, y = (self._types.Float(np.ascontiguousarray(row)) for row in positions[part].T)
            light, view = (
                self._types.Vector3(np.ascontiguousarray(rows[part].T)) for rows in (lights, views)
            )
            point = self._model.locate(x, y, view)
            found[part] = self._model.evaluate(point, light, view).numpy().T
        return found

    def holes(self, positions: NDArray[np.float32], views: NDArray[np.float32]) -> NDArray[np.float32]:
        """1 in holes, less under sheen, else 0 [n]; see `Btf.holes`."""
        found = np.empty(len(positions), np.float32)
        for first in range(0, len(positions), _BATCH):
            part = slice(first, first + _BATCH)
            x, y = (self._types.Float(np.ascontiguousarray(row)) for row in positions[part].T)
            view = self._types.Vector3(np.ascontiguousarray(views[part].T))
            point = self._model.locate(x, y, view)
            found[part] = self._model.straight_through(point, view).numpy()
        return found
