"""Tables that shaders read: 32-bit words, and elements of networks, which all fabrics share."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from loomlight.realtime.networks import NumberTable

Words = NDArray[np.uint32]


class WordTable:
    """Tables of 32-bit words, one behind the other."""

    def __init__(self) -> None:
        self._parts: list[Words] = []
        self.size = 0

    def add(self, values: NDArray[np.generic]) -> int:
        """Appends unsigned integers as they are or numbers as float32; the index of the first word."""
        kind = np.uint32 if np.issubdtype(values.dtype, np.integer) else np.float32
        words = np.ascontiguousarray(values, dtype=kind).ravel().view(np.uint32)
        first = self.size
        self._parts.append(words)
        self.size += words.size
        return first

    def reserve(self, count: int) -> int:
        """Appends so many words of 0; the index of the first."""
        return self.add(np.zeros(count, np.uint32))

    def words(self) -> Words:
        """All of them; at least one, as no buffer is empty."""
        return np.concatenate(self._parts) if self._parts else np.zeros(1, np.uint32)


@dataclass
class Tables:
    """What fabrics append to.

    Attributes:
        words: tables of words.
        numbers: networks and texels.
        networks: first elements of networks that several fabrics share, by checksum.
        half: texels of networks in half precision, else in single precision.
    """

    words: WordTable = field(default_factory=WordTable)
    numbers: NumberTable = field(default_factory=NumberTable)
    networks: dict[str, int] = field(default_factory=dict)
    half: bool = True


def fill(record: np.void, values: dict[str, float]) -> None:
    """Writes values into the fields of a record by name."""
    for name, value in values.items():
        record[name] = value
