"""The distinct ones of many run words, and where each is among them: a draft's words are few."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Self

import numpy as np
from numpy.typing import NDArray

from loomlight.yarn.runs import row_blocks

# Words are looked up by halves, then by the pair of these. Tables of more numbers would not pay.
_LOW_BITS, _LOW_MASK, _HIGH_MASK = 15, (1 << 15) - 1, (1 << 13) - 1
MAX_TABLE = 1 << 24


def distinct_numbers(
    blocks: Iterable[NDArray[np.integer]], limit: int
) -> tuple[NDArray[np.intp], NDArray[np.intp], NDArray[np.intp]]:
    """The distinct ones of numbers below a limit, in order; the index of each [limit]; where each was met."""
    place, count = np.full(limit, -1, np.int32), 0
    for numbers in blocks:
        place[numbers] = np.arange(count, count + numbers.size, dtype=np.int32).reshape(numbers.shape)
        count += numbers.size
    values = np.flatnonzero(place >= 0)
    return values, np.cumsum(place >= 0) - 1, place[values].astype(np.intp)


@dataclass(frozen=True, eq=False)
class DistinctWords:
    """The distinct run words of a family, without cell maxima: tables of halves of words and of their pairs.

    Attributes:
        values: the words, in order.
    """

    values: NDArray[np.uint32]
    _low: NDArray[np.intp]
    _high: NDArray[np.intp]
    _index: NDArray[np.intp]

    @classmethod
    def of(cls, words: NDArray[np.uint32]) -> Self | None:
        """The distinct words of an array [n, m], which is read thrice; None of more than n."""
        blocks = [words[rows] for rows in row_blocks(*words.shape)]
        lows, low, _ = distinct_numbers((part & _LOW_MASK for part in blocks), _LOW_MASK + 1)
        highs, high, _ = distinct_numbers((part >> _LOW_BITS for part in blocks), 1 << 32 - _LOW_BITS)
        if lows.size * highs.size > MAX_TABLE:
            return None
        found = cls(np.empty(0, np.uint32), low, high * lows.size, np.empty(0, np.intp))
        met, index, _ = distinct_numbers(map(found._pairs, blocks), lows.size * highs.size)
        values = (highs[met // lows.size] << _LOW_BITS | lows[met % lows.size]).astype(np.uint32)
        return replace(found, values=values, _index=index) if met.size <= len(words) else None

    def indices(self, words: NDArray[np.uint32]) -> NDArray[np.intp]:
        """Where words, which are among the distinct ones, lie in `values`."""
        return self._index.take(self._pairs(words))

    def _pairs(self, words: NDArray[np.uint32]) -> NDArray[np.intp]:
        return self._high.take(words >> _LOW_BITS & _HIGH_MASK) + self._low.take(words & _LOW_MASK)
