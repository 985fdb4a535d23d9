"""Tables that shaders read: 32-bit words, and elements of networks, which all fabrics share."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from loomlight.models.texture.pyramid import PyramidShape
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
    """Tables that all fabrics append to.

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


def pyramid_fields(shape: PyramidShape, tables: Tables) -> dict[str, float]:
    """Fields of a trained source that describe its mip pyramid; appends the table of levels."""
    levels = [(start, *size) for start, size in zip(shape.starts, shape.sizes, strict=False)]
    return {
        "is_trained": 1,
        "levels": tables.words.add(np.array(levels, np.uint32)),
        "last_level": shape.levels - 1,
        "face_texels": shape.texels,
        "back": shape.faces - 1,
        "repeats_per_x": 1 / shape.width_mm,
        "repeats_per_y": 1 / shape.height_mm,
        "texels_per_mm": 1 / shape.footprint_mm,
    }


def packed_bytes(values: NDArray[np.generic]) -> Words:
    """Bytes as little-endian words, filled up with zeros at the end; at least one word."""
    flat = np.ascontiguousarray(values).ravel().view(np.uint8)
    return np.pad(flat, (0, -flat.size % 4 or 4 * (flat.size == 0))).view("<u4").astype(np.uint32)


def fill(record: np.void, values: dict[str, float]) -> None:
    """Writes values into the fields of a record by name."""
    for name, value in values.items():
        record[name] = value
