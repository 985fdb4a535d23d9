"""Answers to queries of sources that need no renderer: fabrics, measured BTFs, libraries of measured BRDFs.

Sources that have to be rendered are answered for by `loomlight.mitsuba`; `models/registry.py:BTFS` lists all.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from functools import cached_property
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Vec3
from loomlight.core.backend import array_types, upload, upload_vector
from loomlight.core.errors import InputError
from loomlight.core.llvm import llvm_float
from loomlight.fabric.fabric import Fabric
from loomlight.models.texture.pyramid import SIZE_OF_SIGMA, PyramidShape
from loomlight.models.texture.queries import Btf, EncodedBtf, Texels
from loomlight.scattering.point import YarnScattering
from loomlight.sources.btf import MeasuredBtf
from loomlight.sources.merl import MerlLibrary
from loomlight.yarn.stack import cloth_geometry

_Floats = NDArray[np.float32]

# ---------------------------------------------------------------------------------------------------- fabrics

# Rays in one launch.
_BATCH = 1 << 20
# Points of a texel of the finest level along each side, of which encoder inputs are means.
_POINTS = 4
# Least cosine of a normal of which there is a slope.
_MIN_COSINE = 0.3


class FabricBtf(EncodedBtf):
    """f·cos of the yarn points that rays meet, by the exact point model: sheen, shadows, transmission.

    Random threads are left out: those vary over the whole cloth.

    Attributes:
        transmits: whether yarns of either family let light through.
        has_holes: whether there are holes between the yarns.
        model: the point model.
        types: arrays of the backend that evaluates it.
    """

    faces = 2

    def __init__(self, fabric: Fabric) -> None:
        layout, appearance = fabric.layout(), fabric.appearance()
        self._size = fabric.repeat_mm
        families = appearance.warp, appearance.weft
        self.transmits = any(
            bool(np.any(albedo))
            for family in families
            for albedo in (family.diffuse_transmit, family.specular_transmit)
        )
        self.has_holes = layout.open_area > 0
        variation = dataclasses.replace(appearance.variation, fibre_noise=0.0, colour_noise=0.0)
        plain = dataclasses.replace(appearance, variation=variation)
        self.model = YarnScattering(cloth_geometry(layout), plain)
        self.types = array_types(llvm_float())

    @property
    def extent(self) -> tuple[float, float]:
        """Of the repeat, millimetres."""
        return self._size

    def values(self, points: _Floats, lights: _Floats, views: _Floats, seed: tuple[int, ...]) -> _Floats:
        """f·cos [n, 3]; see `Btf.values`. The point model is exact, so the seed is not used."""
        del seed

        def evaluate(x: Float, y: Float, view: Vec3, light: Vec3) -> Any:
            return self.model.evaluate(self.model.locate(x, y, view), light, view).numpy().T

        return self._launched(evaluate, np.empty((len(points), 3), np.float32), points, views, lights)

    def holes(self, points: _Floats, views: _Floats) -> _Floats:
        """1 where rays pass through holes, less under sheen, else 0 [n]; see `Btf.holes`."""

        def evaluate(x: Float, y: Float, view: Vec3) -> Any:
            return self.model.straight_through(self.model.locate(x, y, view), view).numpy()

        return self._launched(evaluate, np.empty(len(points), np.float32), points, views)

    def texels(self, resolution: int) -> FabricTexels:
        """The texels of the repeat; see `EncodedBtf.texels`."""
        return FabricTexels(self, resolution)

    def _launched(
        self, evaluate: Callable[..., Any], found: _Floats, points: _Floats, *directions: _Floats
    ) -> _Floats:
        for first in range(0, len(points), _BATCH):
            part = slice(first, first + _BATCH)
            x, y = (upload(self.types.Float, row) for row in points[part].T)
            vectors = (upload_vector(self.types.Vector3, rows[part].T) for rows in directions)
            found[part] = evaluate(x, y, *vectors)
        return found


class FabricTexels(Texels):
    """Texels of a fabric; inputs are means over them, without parallax, of what the surface is there."""

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

    def __init__(self, btf: FabricBtf, resolution: int) -> None:
        self._btf = btf
        self._shape = PyramidShape.of(btf.extent, resolution, btf.faces)
        self.resolution = (self._shape.columns, self._shape.rows)
        # Of a square texel of the same area.
        self.sigma = np.full(2, self._shape.texel_mm / SIZE_OF_SIGMA, np.float32)

    @cached_property
    def _finest(self) -> list[_Floats]:
        return [self._point_inputs(back=False), self._point_inputs(back=True)]

    @cached_property
    def slopes(self) -> _Floats:
        """Of yarns [2, 1, height, width, 2]; see `Texels.slopes`."""
        first = self.inputs.index("normal_x")
        normals = np.stack([means[..., first : first + 3] for means in self._finest])[:, None]
        return (-normals[..., :2] / np.maximum(normals[..., 2:], _MIN_COSINE)).astype(np.float32)

    def encoder_inputs(self, level: int, face: int = 0) -> _Floats:
        """Inputs [height, width, K]; see `Texels.encoder_inputs`."""
        means = self._finest[face]
        columns, rows = self._shape.sizes[level]
        high, wide = means.shape[0] // rows, means.shape[1] // columns
        grid = means.reshape(rows, high, columns, wide, -1)
        return np.ascontiguousarray(grid.mean(axis=(1, 3), dtype=np.float64), np.float32)

    def _point_inputs(self, back: bool) -> _Floats:
        """Inputs of the texels of the finest level [rows, columns, K]."""
        types, shape, model = self._btf.types, self._shape, self._btf.model
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


# ---------------------------------------------------------------------------------------------- measured BTFs

# Queries at once: their factors take 100 MB.
_PICTURE_BATCH = 1 << 16
# Cosine of directions at the horizon, where a sample of no height is a line.
_HORIZON = 0.02


class PictureBtf(Btf):
    """f·cos of measured pictures, their pixels interpolated bilinearly and repeated; nothing is seen through.

    A diffuser of albedo 1 facing the lamp has the pixel 1: f·cos is the pixel over π. Queries have the
    measured directions alone.
    """

    measured: tuple[_Floats, _Floats]

    def __init__(self, source: MeasuredBtf) -> None:
        """
        Raises:
            InputError: a file that is missing, damaged or no BTF.
        """
        self._source, self._pictures = source, source.pictures()
        directions = self._pictures.lights, self._pictures.views
        self._lights, self._views = (np.flatnonzero(part[:, 2] > _HORIZON) for part in directions)
        self.measured = directions[0][self._lights], directions[1][self._views]
        if not all(map(len, self.measured)):
            raise InputError(f"{source.path} is damaged: all of its directions are at the horizon.")

    @property
    def extent(self) -> tuple[float, float]:
        """Of what the pictures show, millimetres."""
        return self._source.size_mm

    def values(self, points: _Floats, lights: _Floats, views: _Floats, seed: tuple[int, ...]) -> _Floats:
        """f·cos [n, 3] of the pictures with the nearest directions; see `Btf.values`."""
        del seed
        found = np.empty((len(points), 3), np.float32)
        for first in range(0, len(points), _PICTURE_BATCH):
            part = slice(first, first + _PICTURE_BATCH)
            light, view = (
                (rows[part] @ known.T).argmax(axis=1)
                for rows, known in zip((lights, views), self.measured, strict=True)
            )
            found[part] = self._interpolated(self._lights[light], self._views[view], points[part])
        scale = np.float32(self._source.gain / math.pi)
        return found * (scale if self._source.cosine_included else scale * lights[:, 2:])

    def _interpolated(
        self, lights: NDArray[np.intp], views: NDArray[np.intp], positions: NDArray[np.float32]
    ) -> NDArray[np.float32]:
        """Pixels [n, 3] by numbers of light and view."""
        size = np.array([self._pictures.width, self._pictures.height])
        # Row 0 is at the top of a picture, and y = 0 at its bottom.
        texel = positions / np.array(self._source.size_mm, np.float32) * size - 0.5
        corner = np.floor(texel)
        blend = (texel - corner).astype(np.float32)
        total = np.zeros((len(positions), 3), np.float32)
        for right in (0, 1):
            for up in (0, 1):
                column, row = ((corner + np.array([right, up])).astype(np.intp) % size).T
                weight = np.abs(1 - right - blend[:, 0]) * np.abs(1 - up - blend[:, 1])
                pixel = self._pictures.pixels(lights, views, column, self._pictures.height - 1 - row)
                total += weight[:, None] * pixel
        return total


# --------------------------------------------------------------------------------------------- measured BRDFs


class MerlBtf(EncodedBtf):
    """f·cos of the BRDFs of a library, each in a cell of its grid; points are in repeats."""

    def __init__(self, source: MerlLibrary) -> None:
        self._source = source

    @property
    def extent(self) -> tuple[float, float]:
        """1: points are in repeats."""
        return 1.0, 1.0

    def values(self, points: _Floats, lights: _Floats, views: _Floats, seed: tuple[int, ...]) -> _Floats:
        """f·cos of the BRDFs that the points lie in."""
        del seed
        return self._source.evaluate(self._source.numbers_at(points), lights, views)

    def texels(self, resolution: int) -> MerlTexels:
        """A texel for each cell; see `EncodedBtf.texels`."""
        del resolution
        return MerlTexels(self._source)


class MerlTexels(Texels):
    """A texel and an input of the encoder for each BRDF, exact anywhere in it.

    zeltner2024 section 7.1 of the supplemental: measurements have no parameters that an encoder could take,
    so that it takes the index of the material, one-hot.
    """

    is_apart = True

    def __init__(self, source: MerlLibrary) -> None:
        self.inputs, self.resolution = source.names, source.grid
        self.sigma = np.zeros(2, np.float32)

    @property
    def slopes(self) -> _Floats:
        """Of a flat surface; see `Texels.slopes`."""
        return np.zeros((1, 1, 1, 1, 2), np.float32)

    def encoder_inputs(self, level: int, face: int = 0) -> _Floats:
        """Inputs [height, width, BRDFs]: 1 for the BRDF of a texel."""
        del level, face
        (columns, rows), count = self.resolution, len(self.inputs)
        return np.eye(count, dtype=np.float32)[np.arange(columns * rows) % count].reshape(
            rows, columns, count
        )
