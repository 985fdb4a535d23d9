"""Packed uint8x4: the bytes of four groups in one 32-bit word, interpolated two at a time (SWAR).

Weights are integers that sum to about 252. Of bytes 0 and 2 of a pack, 16 bits apart, each product with a
weight stays below 2¹⁶, and so does the sum over all nodes: one multiplication serves two bytes. That takes a
third of the operations of unpacking first, and errs by at most a 504th of the difference between nodes.
"""

from __future__ import annotations

from collections.abc import Sequence

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, UInt
from loomlight.core.backend import ArrayTypes

# Sum of all weights. Eight weights rounded up exceed it by at most 4, and 255·256 < 2¹⁶.
WEIGHT_SUM = 252
_EVEN_BYTES = 0x00FF00FF


def pack_count(per_family: int) -> int:
    """Packs of the groups of both families; each family begins with a pack of its own."""
    return 2 * -(-per_family // 4)


def byte_of_group(per_family: int) -> NDArray[np.intp]:
    """Index of each group's byte in its packs [2 K]."""
    group = np.arange(2 * per_family)
    return group % per_family + group // per_family * 4 * (pack_count(per_family) // 2)


class PackedWeights:
    """Interpolation weights of up to eight nodes, as integers."""

    def __init__(self, types: ArrayTypes, weights: Sequence[Float]) -> None:
        """Rounds weights, each ≥ 0, of sum 1."""
        self._types = types
        self._integers = [types.UInt32(dr.fma(weight, WEIGHT_SUM, 0.5)) for weight in weights]
        self._inverse_sum = dr.rcp(types.Float(sum(self._integers)))

    @property
    def shares(self) -> list[Float]:
        """The weights of the nodes as numbers of sum 1."""
        return [self._types.Float(weight) * self._inverse_sum for weight in self._integers]

    def interpolate(self, packs: Sequence[UInt]) -> list[Float]:
        """Weighted means of the four bytes of packs, one pack a node: four Floats, 0 to 255."""
        even = sum((pack & _EVEN_BYTES) * weight for pack, weight in zip(packs, self._integers, strict=True))
        odd = sum(
            ((pack >> 8) & _EVEN_BYTES) * weight for pack, weight in zip(packs, self._integers, strict=True)
        )
        return _unpack(self._types, even, odd, self._inverse_sum)


def mean_of_packs(types: ArrayTypes, packs: Sequence[UInt]) -> list[Float]:
    """Means of the four bytes of up to 256 packs: four Floats, 0 to 255."""
    even = sum(pack & _EVEN_BYTES for pack in packs)
    odd = sum((pack >> 8) & _EVEN_BYTES for pack in packs)
    return _unpack(types, even, odd, 1 / len(packs))


def _unpack(types: ArrayTypes, even: UInt, odd: UInt, scale: Float) -> list[Float]:
    """The four 16-bit sums of two 32-bit words, times a scale."""
    sums = (even & 0xFFFF, odd & 0xFFFF, even >> 16, odd >> 16)
    return [types.Float(part) * scale for part in sums]
