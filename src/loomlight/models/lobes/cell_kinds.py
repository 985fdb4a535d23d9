"""Coverage of the cells of large drafts, counted by kinds of crossings.

Where threads are all alike, the surface within a crossing depends on its two run words alone, and the
crossings of a draft are of few kinds. The groups of each kind are counted once; a cell is the sum of its
crossings, those at its sides by the part that lies in it.
"""

from __future__ import annotations

from dataclasses import dataclass

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import upload
from loomlight.core.parallel_map import parallel_map
from loomlight.models.lobes.cloth_samples import GOLDEN_FRACTION, LATTICE_SHIFT, UploadedCloth
from loomlight.models.lobes.groups import NearestGroup
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.threads import MAX_TABLE, DistinctWords, distinct_numbers, row_blocks

# Points of each kind and face.
KIND_POINTS = 610
# Crossings of a kind on average, at least: with fewer, texels of all crossings are counted as soon.
MIN_CROSSINGS = 64
# What the counts of a cell add up to.
CELL_COUNT = 255
# Kinds whose points are counted at once.
_BATCH = 1 << 14


@dataclass(frozen=True, eq=False)
class CrossingKinds:
    """The kinds of a draft's crossings: pairs of run words.

    Attributes:
        places: number of a crossing of each kind, row by row.
    """

    words: NDArray[np.uint32]
    distinct: tuple[DistinctWords, DistinctWords]
    indices: NDArray[np.intp]
    places: NDArray[np.intp]

    @classmethod
    def find(cls, geometry: YarnGeometry) -> CrossingKinds | None:
        """The kinds of crossings; None where threads differ, or crossings too much."""
        warp, weft = geometry.families
        if warp.distinct is None or weft.distinct is None or not (warp.uniform and weft.uniform):
            return None
        words, distinct = geometry.words[0], (warp.distinct, weft.distinct)
        count = warp.distinct.values.size * weft.distinct.values.size
        if count > MAX_TABLE:
            return None
        pairs = (_pairs(words[rows], *distinct) for rows in row_blocks(*words.shape[:2]))
        _, indices, places = distinct_numbers(pairs, count)
        is_few = places.size * MIN_CROSSINGS <= words[..., 0].size
        return cls(words, distinct, indices, places) if is_few else None

    def of_pick(self, pick: int) -> NDArray[np.intp]:
        """The kinds of the crossings of a pick [ends]."""
        return self.indices.take(_pairs(self.words[pick], *self.distinct))


def _pairs(words: NDArray[np.uint32], warp: DistinctWords, weft: DistinctWords) -> NDArray[np.intp]:
    return warp.indices(words[..., 0]) * weft.values.size + weft.indices(words[..., 1])


def count_by_kinds(
    cloth: UploadedCloth, nearest: NearestGroup, kinds: CrossingKinds, shape: tuple[int, int, int, int]
) -> NDArray[np.uint8]:
    """Counts of each group in each cell, which add up to `CELL_COUNT`.

    Args:
        shape: of the result: 2 faces, rows, columns, bytes of a cell.
    """
    _, rows, columns, size = shape
    per_kind = _points_by_group(cloth, nearest, kinds.places, size) * np.float32(CELL_COUNT / KIND_POINTS)
    picks, ends = kinds.words.shape[:2]
    (pick_of, high), (end_of, wide) = _overlaps(picks, rows), _overlaps(ends, columns)
    # Rounded up as often as their fraction says: shares below half a count are not lost.
    levels = (np.arange(columns * 2 * size, dtype=np.uint32) * np.uint32(GOLDEN_FRACTION)).astype(np.float32)
    levels = levels.reshape(columns, 2 * size) / np.float32(2**32)
    counts = np.empty(shape, np.uint8)

    def count_row(row: int) -> None:
        line = np.zeros((ends, 2 * size), np.float32)
        for pick, share in zip(pick_of[row], high[row], strict=True):
            line += per_kind.take(kinds.of_pick(pick), axis=0) * share
        cells = levels + np.float32(row * LATTICE_SHIFT[0] % 2**32 / 2**32)
        cells -= np.floor(cells)
        for end, share in zip(end_of.T, wide.T, strict=True):
            cells += line.take(end, axis=0) * share[:, None]
        np.minimum(cells, CELL_COUNT, out=cells)
        counts[:, row] = cells.astype(np.uint8).reshape(columns, 2, size).swapaxes(0, 1)

    parallel_map(count_row, range(rows))
    return counts


def _overlaps(threads: int, cells: int) -> tuple[NDArray[np.intp], NDArray[np.float32]]:
    """Threads that may lie in each cell along an axis, and the share of the cell that each takes up."""
    cell = np.arange(cells)[:, None]
    thread = cell * threads // cells + np.arange(-(-threads // cells) + 1)
    # In parts of a thread, `cells` of them.
    end = np.minimum((thread + 1) * cells, (cell + 1) * threads)
    shared = np.maximum(end - np.maximum(thread * cells, cell * threads), 0)
    return np.minimum(thread, threads - 1), (shared / threads).astype(np.float32)


def _points_by_group(
    cloth: UploadedCloth, nearest: NearestGroup, places: NDArray[np.intp], size: int
) -> NDArray[np.float32]:
    """How many of the `KIND_POINTS` of each kind lie in each group, by byte [kinds, 2 faces · `size`]."""
    types = cloth.types
    picks, ends = cloth.geometry.layout.warp_on_top.shape
    width, height = (dr.opaque(types.Float, side) for side in cloth.geometry.size)
    x_step, y_step = (dr.opaque(types.Float, 1 / count) for count in (ends, picks))
    row = dr.opaque(types.UInt32, size)
    found = []
    for first in range(0, places.size, _BATCH):
        part = places[first : first + _BATCH]
        counts = dr.zeros(types.UInt32, part.size * 2 * size)
        lane = dr.arange(types.UInt32, part.size * 2 * KIND_POINTS)
        point, side = lane % KIND_POINTS, lane // KIND_POINTS
        kind = (side >> 1) + dr.opaque(types.UInt32, first)
        pick, end = (
            dr.gather(types.Float, upload(types.Float, at), side >> 1) for at in np.divmod(part, ends)
        )
        # A lattice, shifted from kind to kind.
        u, v = (
            types.Float((point * step + kind * shift) >> 8) * 2**-24
            for step, shift in zip((2**32 // KIND_POINTS, GOLDEN_FRACTION), LATTICE_SHIFT, strict=True)
        )
        back = (side & 1) == 1
        surface = cloth.geometry.surface((end + u) * x_step * width, (pick + v) * y_step * height, back)
        dr.scatter_add(counts, types.UInt32(1), side * row + nearest.find_byte(back, surface))
        found.append(counts.numpy().reshape(part.size, 2 * size))
    return np.concatenate(found).astype(np.float32)
