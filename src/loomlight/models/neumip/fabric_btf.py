"""The BTF of a fabric: the exact point model, sheen, shadows and transmission included."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from loomlight.fabric.fabric import Fabric
from loomlight.models.fabric_points import FabricPoints


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
        self._points = FabricPoints(fabric)

    def values(
        self,
        positions: NDArray[np.float32],
        lights: NDArray[np.float32],
        views: NDArray[np.float32],
        seed: tuple[int, ...],
    ) -> NDArray[np.float32]:
        """f·cos [n, 3]; see `Btf.values`. The point model is exact, so the seed is not used."""
        del seed
        return self._points.values(positions, lights, views)

    def holes(self, positions: NDArray[np.float32], views: NDArray[np.float32]) -> NDArray[np.float32]:
        """1 in holes, less under sheen, else 0 [n]; see `Btf.holes`."""
        return self._points.straight_through(positions, views)
