"""Any Mitsuba texture as a pyramid of means, so that it can be read over a footprint.

Mitsuba's textures are read at points: a print on cloth seen from afar would need many samples a pixel.
"""

from __future__ import annotations

from typing import Any

import drjit as dr
import mitsuba as mi

from loomlight.core.backend import clip, maximum, minimum

# Texels of the finest level, each side; the texture itself is read where footprints are smaller.
_SIDE = 1024
# Reads of the texture for each of these texels, each side.
_READS = 2


class FilteredTexture:
    """The means of a texture over squares of 1/1024, 1/512 … 1 of its uv, which repeats."""

    def __init__(self, texture: Any) -> None:
        """Reads the texture over one unit of uv."""
        self._texture = texture
        level = _means(_finest(texture), _SIDE * _READS, _READS)
        side = _SIDE
        parts, first, self._first = [level], 0, []
        while side > 1:
            self._first.append(first)
            first += side * side
            level, side = _means(level, side, 2), side // 2
            parts.append(level)
        self._first.append(first)
        planes = [dr.concat([part[channel] for part in parts]) for channel in range(3)]
        self._planes = mi.Color3f(*planes)
        self._starts = mi.UInt32(self._first)
        self._levels = dr.opaque(mi.UInt32, len(self._first) - 1)
        dr.eval(self._planes, self._starts)

    def over(self, si: mi.SurfaceInteraction3f, duv_dx: Any, duv_dy: Any, active: Any) -> Any:
        """Mean about si.uv with the variance of the square of a footprint's area, side²/12: Color3f.

        Args:
            duv_dx, duv_dy: the footprint's edges in uv.
        """
        area = dr.abs(duv_dx.x * duv_dy.y - duv_dx.y * duv_dy.x)
        # Levels above the finest. Interpolating means over w makes boxes of w and tents of w, of w²/12 + w²/6
        # in all: squares of side²/12 are those of w = side/√3.
        level = 0.5 * dr.log2(maximum(area, 1e-20) * (_SIDE**2 / 3))
        place = clip(level, 0, mi.Float(self._levels))
        lower = minimum(mi.UInt32(place), self._levels - 1)
        # Variances of levels are 1 : 4, and those of mixtures are means of them.
        upper = (dr.exp2(2 * (place - mi.Float(lower))) - 1) * (1 / 3)
        filtered = dr.lerp(self._at(lower, si.uv), self._at(lower + 1, si.uv), upper)
        # Between a point and the finest level's mean there is no further level.
        share = clip(level + 1, 0, 1)
        return dr.lerp(mi.Color3f(self._texture.eval(si, active)), filtered, share)

    def _at(self, level: Any, uv: Any) -> Any:
        """Bilinear reading of one level."""
        side = mi.UInt32(_SIDE) >> level
        start = dr.gather(mi.UInt32, self._starts, level)
        x, y = uv.x * mi.Float(side) - 0.5, uv.y * mi.Float(side) - 0.5
        column, row = dr.floor(x), dr.floor(y)
        right, up = x - column, y - row
        mask = mi.Int32(side) - 1
        total = mi.Color3f(0)
        for tap in range(4):
            c = (mi.Int32(column) + tap % 2) & mask
            r = (mi.Int32(row) + tap // 2) & mask
            weight = (right if tap % 2 else 1 - right) * (up if tap // 2 else 1 - up)
            total += weight * dr.gather(mi.Color3f, self._planes, start + mi.UInt32(r) * side + mi.UInt32(c))
        return total


def _finest(texture: Any) -> Any:
    """The texture at the middles of fine texels."""
    side = _SIDE * _READS
    number: Any = dr.arange(mi.UInt32, side * side)
    si = dr.zeros(mi.SurfaceInteraction3f, side * side)
    si.uv = mi.Point2f((number % side + 0.5) / side, (number // side + 0.5) / side)
    with dr.suspend_grad():
        return mi.Color3f(texture.eval(si))


def _means(level: Any, side: int, group: int) -> Any:
    """Means over groups of texels, each side."""
    coarse = side // group
    number = dr.arange(mi.UInt32, coarse * coarse)
    corner: Any = (number // coarse) * (group * side) + (number % coarse) * group
    total = mi.Color3f(0)
    for row in range(group):
        for column in range(group):
            total += dr.gather(mi.Color3f, level, corner + row * side + column)
    total *= 1 / group**2
    dr.eval(total)
    return total
