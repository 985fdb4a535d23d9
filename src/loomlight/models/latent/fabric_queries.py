"""The reflectance of a fabric: the exact point model, sheen and shadows included; holes are black."""

from __future__ import annotations

from functools import cached_property

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.fabric.fabric import Fabric
from loomlight.models.fabric_points import FabricPoints
from loomlight.models.mip_pyramid import SIZE_OF_SIGMA, PyramidShape

_Floats = NDArray[np.float32]
# Points of a texel of the finest level along each side, of which encoder inputs are means.
_POINTS = 4
# Least cosine of a normal of which there is a slope.
_MIN_COSINE = 0.3


class FabricReflectance:
    """f·cos of the yarn points that rays meet; see `queries.Reflectance`.

    Inputs of the encoder are means over texels, without parallax, of what the surface is there.
    """

    inputs = (
        "is_warp",
        "hole",
        "height",
        *(f"normal_{axis}" for axis in "xyz"),
        # LEAN moments: squares that the means of normals lose.
        "normal_xx",
        "normal_xy",
        "normal_yy",
        *(f"tangent_{axis}" for axis in "xyz"),
        *(f"diffuse_{channel}" for channel in "rgb"),
        *(f"specular_{channel}" for channel in "rgb"),
        "roughness",
    )
    faces = 2
    is_apart = False

    def __init__(self, fabric: Fabric, resolution: int) -> None:
        """
        Args:
            resolution: texels along the longer side of the repeat, a power of two.
        """
        self._points = FabricPoints(fabric)
        self._shape = PyramidShape.of(fabric.repeat_mm, resolution, self.faces)
        self.resolution = (self._shape.columns, self._shape.rows)

    @cached_property
    def _finest(self) -> list[_Floats]:
        return [self._point_inputs(back=False), self._point_inputs(back=True)]

    @cached_property
    def slopes(self) -> _Floats:
        """Of yarns [2, 1, height, width, 2]; see `Reflectance.slopes`."""
        first = self.inputs.index("normal_x")
        normals = np.stack([means[..., first : first + 3] for means in self._finest])[:, None]
        return (-normals[..., :2] / np.maximum(normals[..., 2:], _MIN_COSINE)).astype(np.float32)

    def values(
        self, positions: _Floats, levels: _Floats, lights: _Floats, views: _Floats, seed: tuple[int, ...]
    ) -> _Floats:
        """f·cos [n, 3] of one point of each footprint; see `Reflectance.values`."""
        rng = np.random.default_rng(seed)
        extent = np.array([self._shape.width_mm, self._shape.height_mm], np.float32)
        sigmas = (self._shape.texel_mm / SIZE_OF_SIGMA * np.exp2(levels)).astype(np.float32)
        points = positions * extent + sigmas[:, None] * rng.standard_normal(positions.shape, np.float32)
        return self._points.values(points, lights, views)

    def encoder_inputs(self, level: int, face: int = 0) -> _Floats:
        """Inputs [height, width, K]; see `Reflectance.encoder_inputs`."""
        means = self._finest[face]
        columns, rows = self._shape.sizes[level]
        high, wide = means.shape[0] // rows, means.shape[1] // columns
        grid = means.reshape(rows, high, columns, wide, -1)
        return np.ascontiguousarray(grid.mean(axis=(1, 3), dtype=np.float64), np.float32)

    def _point_inputs(self, back: bool) -> _Floats:
        """Inputs of the texels of the finest level [rows, columns, K]."""
        types, shape, model = self._points.types, self._shape, self._points.model
        columns, rows = _POINTS * shape.columns, _POINTS * shape.rows
        number = dr.arange(types.UInt32, columns * rows)
        row = number // columns
        x = (types.Float(number - row * columns) + 0.5) * (shape.width_mm / columns)
        y = (types.Float(row) + 0.5) * (shape.height_mm / rows)
        is_back = dr.full(types.Bool, back, columns * rows)
        hole = model.surface.surface(x, y, is_back).hole
        point = model.at(x, y, is_back, hole)
        normal, tangent, albedos = point.normal, point.tangent, point.albedos
        channels = [
            dr.select(point.is_warp, 1.0, -1.0),
            dr.select(hole, 1.0, -1.0),
            # Heights are a few tenths of the finest thread's width.
            types.Float(point.height) / min(model.surface.finest),
            *normal,
            *(normal[a] * normal[b] for a, b in ((0, 0), (0, 1), (1, 1))),
            *tangent,
            *(2 * channel - 1 for channel in albedos.diffuse_reflect),
            *(2 * channel - 1 for channel in albedos.specular_reflect),
            2 * types.Float(point.roughness) - 1,
        ]
        # Nothing below holes means anything but that they are holes.
        channels[2:] = [dr.select(hole, 0, channel) for channel in channels[2:]]
        flat = np.stack([np.broadcast_to(c.numpy(), columns * rows) for c in map(types.Float, channels)])
        grid = flat.reshape(len(self.inputs), shape.rows, _POINTS, shape.columns, _POINTS)
        return np.ascontiguousarray(np.moveaxis(grid.mean(axis=(2, 4)), 0, -1), np.float32)
