"""Shadows of yarns by tabulated horizons in place of the search along the light ray."""

from __future__ import annotations

import drjit as dr
import numpy as np

from loomlight.core.arrays import Float, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, array_types, minimum
from loomlight.scattering.appearance import Appearance
from loomlight.scattering.point import YarnPoint, YarnScattering, shadow_query
from loomlight.yarn.rays import Surface
from loomlight.yarn.visibility import AZIMUTHS, HorizonMap


class TabulatedScattering(YarnScattering):
    """Scattering at single points whose visibility is looked up."""

    def __init__(self, surface: Surface, appearance: Appearance, table: HorizonMap) -> None:
        super().__init__(surface, appearance)
        self._table = table

    def visibility(self, point: YarnPoint, light: Vec3, active: Mask = True) -> Mask:
        """Whether the horizons leave the light free of the point: Bool."""
        ray = shadow_query(self.surface, point, light)
        free = unoccluded(self._table, point.x, point.y, ray.direction, ray.back)
        return (free & ray.searched & active) | point.hole


def unoccluded(table: HorizonMap, x: Float, y: Float, direction: Vec3, back: Mask) -> Mask:
    """Whether the cloth leaves the direction free at draft coordinates (millimetres): Bool.

    Args:
        direction: unit vector [3] in the frame of the face given by `back`.
    """
    types = array_types(x)
    columns, rows = table.resolution
    column = _texel(types, x / table.size[0], columns)
    row = _texel(types, y / table.size[1], rows)
    face = dr.select(types.Bool(back), types.UInt32(rows * columns), types.UInt32(0))
    # Four azimuths share one word of the table.
    turns = dr.atan2(direction.y, direction.x) * (AZIMUTHS / dr.two_pi)
    turns = dr.select(turns < 0, turns + AZIMUTHS, turns)
    whole = dr.floor(turns)
    first = types.UInt32(whole) & (AZIMUTHS - 1)
    texel = (face + row * columns + column) * (AZIMUTHS // 4)
    words = types.UInt32(np.ascontiguousarray(table.sine).view("<u4").ravel())

    def sine_at(azimuth: UInt) -> Float:
        word = dr.gather(types.UInt32, words, texel + (azimuth >> 2))
        return types.Float((word >> ((azimuth & 3) << 3)) & 255) * (1 / 255)

    level = dr.lerp(sine_at(first), sine_at((first + 1) & (AZIMUTHS - 1)), turns - whole)
    return (direction.z > 0) & (direction.z >= level)


def _texel(types: ArrayTypes, turns: Float, count: int) -> UInt:
    share = turns - dr.floor(turns)
    return minimum(types.UInt32(share * count), count - 1)
