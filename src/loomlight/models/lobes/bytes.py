"""Interpolation of bytes that lie four to a word, two at a time.

Weights are whole 252nds. Of the bytes 0 and 2 of a word, 16 bits apart, each product with a weight stays
below 2¹⁶, and so does their sum over all nodes: one multiplication serves two bytes. That is a third of the
operations of taking every byte out first, and moves nothing by more than a 504th of what nodes differ by.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import drjit as dr

from loomlight.core.backend import ArrayTypes

# Eight weights rounded up exceed their sum by 4 at the most, and 255·256 < 2¹⁶.
UNITS = 252
_EVEN = 0x00FF00FF


class ByteWeights:
    """Shares of up to eight nodes, whole units."""

    def __init__(self, types: ArrayTypes, weights: Sequence[Any]) -> None:
        """Rounds weights (Float each, ≥ 0, sum 1)."""
        self._types = types
        self._units = [types.UInt32(dr.fma(weight, UNITS, 0.5)) for weight in weights]
        self._inverse = dr.rcp(types.Float(sum(self._units)))

    def interpolated(self, words: Sequence[Any]) -> list[Any]:
        """Means of the four bytes of words, one word a node: four Floats, 0 to 255."""
        even = sum((word & _EVEN) * unit for word, unit in zip(words, self._units, strict=True))
        odd = sum(((word >> 8) & _EVEN) * unit for word, unit in zip(words, self._units, strict=True))
        return _parted(self._types, even, odd, self._inverse)


def mean_bytes(types: ArrayTypes, words: Sequence[Any]) -> list[Any]:
    """Means of the four bytes of up to 256 words that count alike: four Floats, 0 to 255."""
    even = sum(word & _EVEN for word in words)
    odd = sum((word >> 8) & _EVEN for word in words)
    return _parted(types, even, odd, 1 / len(words))


def _parted(types: ArrayTypes, even: Any, odd: Any, scale: Any) -> list[Any]:
    """The four sums that lie 16 bits apart in two words, times a scale."""
    pairs = (even & 0xFFFF, odd & 0xFFFF, even >> 16, odd >> 16)
    return [types.Float(pair) * scale for pair in pairs]
