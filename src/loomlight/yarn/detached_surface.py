"""Cloth geometry whose shadows and outlines carry no derivatives.

Searches along rays are loops with discontinuous results: their derivatives would be wrong as well as dear.
Normals and tangents keep theirs.
"""

from __future__ import annotations

from typing import Any

import drjit as dr

from loomlight.yarn.flanks import SurfacePoint
from loomlight.yarn.geometry import CellBounds, Probe, YarnGeometry


class DetachedSurface:
    """Analytic geometry as a `Surface` whose heights carry no derivatives."""

    def __init__(self, geometry: YarnGeometry) -> None:
        self.geometry = geometry
        self.size = geometry.size
        self.extents: dict[type, Any] = {}

    @property
    def finest(self) -> tuple[float, float]:
        return self.geometry.finest

    @property
    def height_bounds(self) -> tuple[float, float]:
        return self.geometry.height_bounds

    def height(self, x: Any, y: Any, back: Any) -> tuple[Any, Any]:
        with dr.suspend_grad():
            return self.geometry.height(x, y, back)

    def max_heights(self, x: Any, y: Any, back: Any, right: Any, up: Any) -> list[tuple[float, Any]]:
        with dr.suspend_grad():
            return self.geometry.max_heights(x, y, back, right, up)

    def probe(self, x: Any, y: Any, back: Any, right: Any, up: Any) -> Probe:
        with dr.suspend_grad():
            return self.geometry.probe(x, y, back, right, up)

    def cell_bounds(self, x: Any, y: Any, back: Any, right: Any, up: Any) -> CellBounds:
        with dr.suspend_grad():
            return self.geometry.cell_bounds(x, y, back, right, up)

    def surface(self, x: Any, y: Any, back: Any, ray: Any = None) -> SurfacePoint:
        point = self.geometry.surface(x, y, back, ray)
        point.height = dr.detach(point.height)
        return point
