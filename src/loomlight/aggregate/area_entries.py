"""Entries of summed-area tables of integers, as gathers read them: one by one, or neighbours at once."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, UInt
from loomlight.core.backend import ArrayTypes, upload


class SingleEntries:
    """The summed-area table of a large draft, read entry by entry."""

    def __init__(self, areas: UInt, shape: tuple[int, ...], types: ArrayTypes) -> None:
        self._types = types
        self._padded = shape[2]
        self._pitch = dr.opaque(types.UInt32, shape[1])
        self._areas = areas

    def read(self, rows: Sequence[UInt], columns: Sequence[UInt]) -> Iterator[list[list[Float]]]:
        """For each number of an entry, a grid of entries: by column, then by row."""
        size = min(self._padded, 4)
        kind = self._types.Index2 if size == 2 else self._types.Index4
        for part in range(self._padded // size):
            values = []
            for column in columns:
                starts = [(row * self._pitch + column) * (self._padded // size) for row in rows]
                values.append([dr.gather(kind, self._areas, start + part) for start in starts])
            for number in range(size):
                yield [[entry[number] for entry in line] for line in values]


class PairedEntries:
    """The summed-area table of a smaller draft: neighbours along its rows are read at once.

    The last column, of the whole repeat, has no right neighbour: it is paired with its next row.
    """

    def __init__(self, areas: NDArray[np.uint32], types: ArrayTypes) -> None:
        self._types = types
        self._size = min(areas.shape[2], 4)
        self._parts = areas.shape[2] // self._size
        self._pitch = dr.opaque(types.UInt32, areas.shape[1] - 1)
        split = areas.reshape(*areas.shape[:2], self._parts, 1, self._size)
        self._pairs = upload(types.UInt32, np.concatenate([split[:, :-1], split[:, 1:]], axis=3))
        last = split[:, -1]
        self._last = upload(types.UInt32, np.concatenate([last[:-1], last[1:]], axis=2))
        self._all = [dr.opaque(types.UInt32, int(number)) for number in areas[-1, -1]]

    def read(self, rows: Sequence[UInt], columns: Sequence[UInt]) -> Iterator[list[list[Float]]]:
        """For each number of an entry, a grid of entries: by column, then by row."""
        size = self._size
        for part in range(self._parts):
            lines = [
                [self._pair(self._pairs, row * self._pitch + columns[first], part) for first in (0, 2)]
                for row in rows
            ]
            ends = [self._pair(self._last, rows[first], part) for first in (0, 2)]
            for number in range(size):
                grid = [
                    [line[pair][number + size * half] for line in lines]
                    for pair in range(2)
                    for half in range(2)
                ]
                last = [end[number + size * half] for end in ends for half in range(2)]
                yield [*grid, [*last, self._all[part * size + number]]]

    def _pair(self, table: Float, index: UInt, part: int) -> Float:
        """The numbers of two neighbours, concatenated."""
        types, index = self._types, index * self._parts + part
        if self._size == 2:
            return dr.gather(types.Index4, table, index)
        return dr.gather(types.Indices, table, index, shape=(2 * self._size, dr.width(index)))


Entries = SingleEntries | PairedEntries
