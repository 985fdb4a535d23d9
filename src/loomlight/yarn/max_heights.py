"""How high yarns rise near a crossing: a pyramid of maxima each way, by which rays pass over cells."""

from __future__ import annotations

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Mask, UInt
from loomlight.core.backend import array_types
from loomlight.yarn.threads import (
    CELL_MAX_LEVELS,
)

# Windows, in threads beyond a tile, on the sides that a ray may reach.
PYRAMID_RADII = (1, 2, 4, 8)
TILE_CELLS = 2
# Cells around those of some tiles that their windows reach, and tiles that are processed at once.
_MARGIN = PYRAMID_RADII[-1]
_BLOCK = 1 << 16
# Words of a tile. A word's number is 1 where x grows along the ray, plus 2 where y grows.
QUADRANTS = 4


def pack_max_heights(words: NDArray[np.uint32]) -> NDArray[np.uint32]:
    """The pyramid [⌈picks / 2⌉, ⌈ends / 2⌉, 4], from the words of warp and weft [picks, ends, 2]."""
    picks, ends = words.shape[:2]
    along, across = -(-picks // TILE_CELLS), -(-ends // TILE_CELLS)
    max_heights = np.empty((along, across, QUADRANTS), np.uint32)
    bytes_of_words = words.astype("<u4", copy=False).view(np.uint8).reshape(picks, ends, 2, 4)
    step = max(1, _BLOCK // across)
    for first in range(0, along, step):
        last = min(first + step, along)
        near = np.arange(TILE_CELLS * first - _MARGIN, TILE_CELLS * last + _MARGIN) % picks
        max_heights[first:last] = _pack_rows(bytes_of_words, near, last - first, across)
    return max_heights


def _pack_rows(
    bytes_of_words: NDArray[np.uint8], near: NDArray[np.intp], along: int, across: int
) -> NDArray[np.uint32]:
    """Some rows of the pyramid, from the words of picks near them, with `_MARGIN` more at either end."""
    warp, weft = (bytes_of_words[near, :, family, 3] >> 4 for family in (0, 1))
    # Where the warp is on top, its level is the front's: selection by bits takes a tenth of the time.
    swapped = (warp ^ weft) & -(bytes_of_words[near, :, 0, 0] & 1)
    faces = np.stack([weft ^ swapped, warp ^ swapped])
    margins = np.arange(-_MARGIN, TILE_CELLS * across + _MARGIN) % warp.shape[1]
    even, odd = (faces[..., margins[first::TILE_CELLS]].transpose(2, 0, 1) for first in (0, 1))
    max_heights = np.empty((along, across, QUADRANTS, len(PYRAMID_RADII)), np.uint8)
    for number, radius in enumerate(PYRAMID_RADII):
        for right in (False, True):
            columns = _highest(even, odd, radius, right).transpose(2, 1, 0)
            for up in (False, True):
                front, behind = _highest(columns[0::2], columns[1::2], radius, up).swapaxes(0, 1)
                max_heights[..., right + 2 * up, number] = front | behind << 4
    return max_heights.view("<u4")[..., 0]


def _highest(even: NDArray[np.uint8], odd: NDArray[np.uint8], radius: int, ahead: bool) -> NDArray[np.uint8]:
    """Maxima of tiles and of `radius` cells ahead of them, else behind them, along the first axis.

    Args:
        even, odd: the two cells of each tile along that axis, with those of `_MARGIN` cells at either end.
    """
    margin = _MARGIN // TILE_CELLS

    def beside(cells: NDArray[np.uint8], tiles: int) -> NDArray[np.uint8]:
        first = margin + (tiles if ahead else -tiles)
        return cells[first : first + len(cells) - 2 * margin]

    pairs = np.maximum(even, odd)
    highest = beside(pairs, 0)
    for tiles in range(1, radius // TILE_CELLS + 1):
        highest = np.maximum(highest, beside(pairs, tiles))
    return np.maximum(highest, beside(even if ahead else odd, 1)) if radius % TILE_CELLS else highest


def read_max_heights(
    max_heights: UInt, tile: UInt, back: Mask, right: Mask, up: Mask
) -> list[tuple[float, Float]]:
    """Distances and bounds of heights ahead of a tile of a pyramid; see `rays.Surface.max_heights`."""
    types = array_types(tile)
    # All four at once: Dr.Jit fetches 16 bytes in a row sooner than 4 by themselves.
    words = dr.gather(types.Index4, max_heights, tile)
    word = dr.select(up, dr.select(right, words[3], words[2]), dr.select(right, words[1], words[0]))
    word = word >> dr.select(back, types.UInt32(4), types.UInt32(0))
    return [
        (float(radius), types.Float((word >> 8 * number) & 15) * (1 / CELL_MAX_LEVELS))
        for number, radius in reversed(list(enumerate(PYRAMID_RADII)))
    ]
