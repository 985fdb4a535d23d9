"""Tables that shaders read: 32-bit words, and elements of networks, which all fabrics share."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core import tables as declarations
from loomlight.core.tables import Layer, Number, Packing, Shared, Size, Table
from loomlight.models.interface import ShaderTables
from loomlight.realtime.networks import Elements, NumberTable, packed_layer, packed_numbers

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
    """

    words: WordTable = field(default_factory=WordTable)
    numbers: NumberTable = field(default_factory=NumberTable)
    networks: dict[str, int] = field(default_factory=dict)


def write_tables(record: np.void, shown: ShaderTables, buffers: Tables) -> None:
    """Appends the tables that a model declares, and writes its record: numbers, and where tables begin.

    Given tables come first, in the order in which they are given.

    Args:
        record: the model's own, within that of a fabric.
    """
    declared = type(shown.tables).declarations
    own = [name for name in declared if name not in shown.given]
    for name in (*shown.given, *own):
        of = declared[name]
        value = shown.given[name] if name in shown.given else getattr(shown.tables, name)
        if isinstance(of, Table | Number) and of.words:
            if value is not None:
                shown_value = of.shown_of(value) if isinstance(of, Table) else value
                record[name] = _added(shown_value, of.words, buffers)
        elif isinstance(of, Size | Number) and of.kind:
            record[name] = value


def _added(value: Any, packing: Packing, buffers: Tables) -> int:
    """Appends a table; where it begins."""
    if packing == "words":
        return buffers.words.add(value)
    if packing == "bytes":
        return buffers.words.add(packed_bytes(value))
    if packing == "elements":
        return buffers.numbers.add(packed_numbers(value, value.dtype == np.float16))
    if not isinstance(value, Shared):
        return buffers.numbers.add(_packed_layers(value))
    if value.sha256 not in buffers.networks:
        buffers.networks[value.sha256] = buffers.numbers.add(_packed_layers(value.layers()))
    return buffers.networks[value.sha256]


def _packed_layers(layers: Sequence[Layer]) -> Elements:
    return np.concatenate([packed_layer(weight, bias, weight.dtype == np.float16) for weight, bias in layers])


def add_block(block: declarations.Tables, table: WordTable) -> int:
    """Appends all tables with words of a class as one block in their order; the index of the first word."""
    return table.add(np.concatenate([array.ravel() for array in block.tables_with_words().values()]))


def packed_bytes(values: NDArray[np.generic]) -> Words:
    """Bytes as little-endian words, filled up with zeros at the end; at least one word."""
    flat = np.ascontiguousarray(values).ravel().view(np.uint8)
    return np.pad(flat, (0, -flat.size % 4 or 4 * (flat.size == 0))).view("<u4").astype(np.uint32)


def fill(record: np.void, values: Mapping[str, float]) -> None:
    """Writes values into the fields of a record by name."""
    for name, value in values.items():
        record[name] = value
