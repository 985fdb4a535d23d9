"""A directional max-height pyramid, by which rays high above the cloth skip cells.

Each tile of two by two cells has four 32-bit words, one for each quadrant of ray directions: towards smaller
or larger x, and y. A word has a byte for each window of `PYRAMID_RADII`: the maximum of the front face in the
lower half, of the back in the upper. Levels are 15ths of the higher family's highest point; see `runs.py`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

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
    step = max(1, _BLOCK // across)
    for first in range(0, along, step):
        last = min(first + step, along)
        near = np.arange(TILE_CELLS * first - _MARGIN, TILE_CELLS * last + _MARGIN) % picks
        max_heights[first:last] = _pack_rows(words[near], last - first, across)
    return max_heights


def _pack_rows(words: NDArray[np.uint32], along: int, across: int) -> NDArray[np.uint32]:
    """Some rows of the pyramid, from words with a margin of `_MARGIN` picks at either end."""
    levels = (words >> 28).astype(np.uint8)
    warp_on_top = (words[..., 0] & 1) == 1
    front = np.where(warp_on_top, levels[..., 0], levels[..., 1])
    behind = np.where(warp_on_top, levels[..., 1], levels[..., 0])
    ends = front.shape[1]
    margins = np.arange(-_MARGIN, TILE_CELLS * across + _MARGIN) % ends
    faces = np.stack([front, behind])[:, :, margins]
    max_heights = np.zeros((along, across, QUADRANTS), np.uint32)
    for number, radius in enumerate(PYRAMID_RADII):
        for right in (False, True):
            columns = _highest(faces, 2, radius, right)
            for up in (False, True):
                front, behind = _highest(columns, 1, radius, up).astype(np.uint32)
                max_heights[..., right + 2 * up] |= (front | behind << np.uint32(4)) << np.uint32(8 * number)
    return max_heights


def _highest(levels: NDArray[np.uint8], axis: int, radius: int, ahead: bool) -> NDArray[np.uint8]:
    """Maxima of tiles and of `radius` cells ahead of them, else behind them, along an axis with margins."""
    levels = np.moveaxis(levels, axis, -1)
    tiles = levels.shape[-1] // TILE_CELLS - _MARGIN
    first = _MARGIN - (0 if ahead else radius)
    found = levels[..., first : first + TILE_CELLS * tiles + radius]
    even, odd = found[..., 0::2], found[..., 1::2]
    pairs = np.maximum(even[..., : odd.shape[-1]], odd)
    highest = pairs[..., :tiles]
    for more in range(1, radius // 2 + 1):
        highest = np.maximum(highest, pairs[..., more : more + tiles])
    if radius % 2:
        highest = np.maximum(highest, even[..., -tiles:])
    return np.moveaxis(highest, -1, axis)
