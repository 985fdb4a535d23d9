"""Roofs: how high the cloth rises ahead of each place, so that rays high above need not ask every cell.

Four 32-bit words for every two by two cells, one for each way that a ray may go: down or up the x axis, and
the y axis. A word has a byte for each of `ROOF_RADII`, whose lower half is of the front face. A level counts
as in `runs.py`, in 15ths of the higher family's highest.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

# In threads beyond a block, on the sides that a ray may reach.
ROOF_RADII = (1, 2, 4, 8)
ROOF_BLOCK = 2
# Ways that rays go: words of a block. A word's number is 1 where x rises, plus 2 where y rises.
WAYS = 4


def pack_roofs(words: NDArray[np.uint32]) -> NDArray[np.uint32]:
    """Roofs [picks / 2, ends / 2, 4 ways], rounded up, of the words of warp and weft [picks, ends, 2]."""
    levels = (words >> 28).astype(np.uint8)
    warp_on_top = (words[..., 0] & 1) == 1
    front = np.where(warp_on_top, levels[..., 0], levels[..., 1])
    behind = np.where(warp_on_top, levels[..., 1], levels[..., 0])
    faces = np.stack([front, behind])
    roofs = np.zeros((*(-(-count // ROOF_BLOCK) for count in front.shape), WAYS), np.uint32)
    for number, radius in enumerate(ROOF_RADII):
        for right in (False, True):
            columns = _highest(faces, 2, radius, right)
            for up in (False, True):
                front, behind = _highest(columns, 1, radius, up).astype(np.uint32)
                roofs[..., right + 2 * up] |= (front | behind << np.uint32(4)) << np.uint32(8 * number)
    return roofs


def _highest(levels: NDArray[np.uint8], axis: int, radius: int, ahead: bool) -> NDArray[np.uint8]:
    """Maxima of blocks of two cells and of what lies ahead of them, else behind, along a periodic axis."""
    levels = np.moveaxis(levels, axis, -1)
    count = levels.shape[-1]
    blocks = -(-count // ROOF_BLOCK)
    first = 0 if ahead else -radius
    found = levels.take(np.arange(first, first + ROOF_BLOCK * blocks + radius) % count, axis=-1)
    even, odd = found[..., 0::2], found[..., 1::2]
    pairs = np.maximum(even[..., : odd.shape[-1]], odd)
    highest = pairs[..., :blocks]
    for more in range(1, radius // 2 + 1):
        highest = np.maximum(highest, pairs[..., more : more + blocks])
    if radius % 2:
        highest = np.maximum(highest, even[..., -blocks:])
    return np.moveaxis(highest, -1, axis)
