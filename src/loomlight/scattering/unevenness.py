"""Where threads run in cloth: no yarn is a ruled line.

Every family's coordinate across its threads moves by noise of mean 0 that is smooth along them, in cells of a
thread and of half of one that repeat nowhere: threads wander, and are thick here and thin there.
"""

from __future__ import annotations

import math

import drjit as dr

from loomlight.core.arrays import Float, UInt, Vec2
from loomlight.core.backend import ArrayTypes, array_types, opaque
from loomlight.scattering.appearance import Appearance
from loomlight.scattering.variation import hash_bits, hash_key

# Largest displacement at slub = 1, in spacings; it grows with the root of `slub`.
UNEVENNESS = 0.2
# Cells along threads, in spacings; those of the second octave are half of it.
UNEVEN_CELL = 4.0
UNEVEN_STREAM = 0x2545F491


class Unevenness:
    """How the threads of one fabric wander; `spacings` are mean distances in warp and weft, millimetres."""

    def __init__(self, appearance: Appearance, spacings: tuple[float, float]) -> None:
        slubs = (appearance.warp.detail.slub, appearance.weft.detail.slub)
        self._is_on = max(slubs) > 0
        amounts = [UNEVENNESS * math.sqrt(slub) * size for slub, size in zip(slubs, spacings, strict=True)]
        self._numbers = amounts, spacings, appearance.variation.seed
        self._uploaded: dict[type, tuple[Vec2, Vec2, UInt]] = {}

    def upload(self, types: ArrayTypes) -> tuple[Vec2, Vec2, UInt]:
        """Amounts and spacings of both families, millimetres, and the seed, on a backend."""
        if types.Float not in self._uploaded:
            pairs = [
                types.Vector2(*(opaque(types.Float, size) for size in pair)) for pair in self._numbers[:2]
            ]
            self._uploaded[types.Float] = *pairs, opaque(types.UInt32, self._numbers[2])
        return self._uploaded[types.Float]

    def place(self, centre: Vec2) -> Vec2:
        """Where in the draft the cloth at a place [2] is, both in millimetres."""
        if not self._is_on:
            return centre
        types = array_types(centre.x)
        amounts, spacings, seed = self.upload(types)
        keys = [hash_key(types.UInt32(family), seed ^ UNEVEN_STREAM) for family in (0, 1)]
        warp = _noise(keys[0], centre.x / spacings.x, centre.y / spacings.x)
        weft = _noise(keys[1], centre.y / spacings.y, centre.x / spacings.y)
        return dr.fma(amounts, types.Vector2(warp, weft), centre)


def _noise(key: UInt, across: Float, along: Float) -> Float:
    """Two octaves of noise in ±1 at a place in spacings: one moves threads, the other their edges."""
    first = _smooth(key, across, along * (1 / UNEVEN_CELL))
    return (2 / 3) * first + (1 / 3) * _smooth(key + 1, 2 * across + 0.5, along * (2 / UNEVEN_CELL))


def _smooth(key: UInt, across: Float, along: Float) -> Float:
    """Noise in ±1, smooth between the corners of unit cells."""
    types = array_types(across)
    column, row = dr.floor(across), dr.floor(along)
    s, t = across - column, along - row
    s, t = dr.square(s) * dr.fma(-2, s, 3), dr.square(t) * dr.fma(-2, t, 3)
    cell = types.UInt32(types.Int32(column)) * 65536 + types.UInt32(types.Int32(row))

    def corner(step: int) -> Float:
        return dr.fma(types.Float(hash_bits(key, cell + step) >> 9), 2**-22, -1)

    return dr.lerp(dr.lerp(corner(0), corner(65536), s), dr.lerp(corner(1), corner(65537), s), t)
