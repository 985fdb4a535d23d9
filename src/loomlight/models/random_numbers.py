"""Random numbers of a footprint without a sampler: a hash of what the question is made of.

A BSDF is handed no random numbers for its values. Samples of a pixel ask with rays of their own, so the bits
of view and footprint differ from sample to sample, and a good hash of them is as uniform as a generator's
numbers. Positions enter as fractions of the repeat, so that cloth repeats in its noise too.
"""

from __future__ import annotations

import drjit as dr

from loomlight.core.arrays import Float, UInt, Vec3
from loomlight.core.backend import array_types
from loomlight.core.footprint import Footprint

# Positions are told apart in so many steps a repeat; rounding of float32 moves few to a neighbour.
HASH_STEPS = 4096.0
# Of MurmurHash3's finalizer (Appleby 2011).
_FIRST, _SECOND = 0x85EBCA6B, 0xC2B2AE35


def hashed(view: Vec3, footprint: Footprint, size: tuple[Float, Float]) -> UInt:
    """A hash of a view and a footprint: UInt32.

    Args:
        size: of the repeat, millimetres.
    """
    types = array_types(view.x)
    found = types.UInt32(0x9E3779B9)
    for axis, extent in enumerate(size):
        turns = footprint.centre[axis] / extent
        found = _mixed(found ^ types.UInt32((turns - dr.floor(turns)) * HASH_STEPS))
    for number in (*view, *footprint.duv_dx, *footprint.duv_dy):
        # −0 and 0 are the same number.
        found = _mixed(found ^ dr.reinterpret_array(types.UInt32, types.Float(number) + 0.0))
    return found


def uniform(seed: UInt, dimension: int) -> Float:
    """A number in [0, 1) for each dimension of a hash."""
    types = array_types(dr.float32_array_t(type(seed)))
    return types.Float(_mixed(seed + (dimension + 1) * 0x9E3779B9 % 2**32) >> 8) * 2**-24


def _mixed(number: UInt) -> UInt:
    number = (number ^ (number >> 16)) * _FIRST
    number = (number ^ (number >> 13)) * _SECOND
    return number ^ (number >> 16)
