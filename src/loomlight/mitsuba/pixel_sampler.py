"""Samples of pixels whose counts are data: Mitsuba's samplers are compiled anew for each number of samples.

Every number, and every pair of numbers, is a (0, 2)-sequence with Owen scrambling by hashes, shuffled anew
for each pair and pixel (Burley 2020, *Practical Hash-based Owen Scrambling*). So samples are stratified in
all dimensions, whether a picture takes them in one pass or in many.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr
import mitsuba as mi

from loomlight.core.arrays import Float, UInt
from loomlight.scattering.variation import hash_bits

# Of the matrix of Sobol's second dimension, Pascal's triangle modulo 2: shifts, and the bits that stay.
_PASCAL = ((16, 0x0000FFFF), (8, 0x00FF00FF), (4, 0x0F0F0F0F), (2, 0x33333333), (1, 0x55555555))


@dataclass
class PixelSampler:
    """Random numbers of samples, as far as integrators ask for them.

    Attributes:
        count: samples of each pixel in this pass.
        number: of the sample among all of its pixel: UInt32.
        key: of the pixel and the seed: UInt32.
        dimension: how many numbers or pairs were drawn: UInt32.
    """

    count: int
    number: Any
    key: Any
    dimension: Any

    @classmethod
    def of(cls, pixel: UInt, number: UInt, seed: Any, count: int) -> PixelSampler:
        """The sampler of samples by their pixels and their numbers in them; any 32-bit seed."""
        seed = dr.opaque(mi.UInt32, seed) if isinstance(seed, int) else mi.UInt32(seed)
        return cls(count, number, hash_bits(hash_bits(seed, mi.UInt32(0)), pixel), mi.UInt32(0))

    def sample_count(self) -> int:
        """Samples of each pixel in this pass."""
        return self.count

    def next_1d(self) -> Float:
        """A number in (0, 1)."""
        key, place = self._next()
        return _unit(_permuted(place, key))

    def next_2d(self) -> Any:
        """Two numbers in (0, 1)."""
        key, place = self._next()
        second = place
        for shift, kept in _PASCAL:
            second = second ^ ((second >> shift) & kept)
        return mi.Point2f(_unit(_permuted(place, key)), _unit(_permuted(second, hash_bits(key, key))))

    def _next(self) -> tuple[UInt, UInt]:
        """A key of the next dimension, and the place of the sample in its shuffled order."""
        self.dimension = self.dimension + 1
        key = hash_bits(self.key, self.dimension)
        return hash_bits(key, self.dimension), dr.brev(_permuted(dr.brev(self.number), key))


def _permuted(bits: UInt, key: UInt) -> UInt:
    """Owen scrambling of reversed bits: each depends on those below it alone (Laine and Karras 2011)."""
    bits = ((bits ^ (bits * 0x3D20ADEA)) + key) * ((key >> 16) | 1)
    bits = bits ^ (bits * 0x05526C56)
    return bits ^ (bits * 0x53A22864)


def _unit(reversed_bits: UInt) -> Float:
    """A number in (0, 1) of reversed bits: 23 of them and a half are exact."""
    return (mi.Float(dr.brev(reversed_bits) >> 9) + 0.5) * 2**-23
