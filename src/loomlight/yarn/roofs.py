"""Roofs: how high the cloth rises ahead of each place, so that rays high above need not ask every cell.

Four 32-bit words for every two by two cells, one for each way that a ray may go: down or up the x axis, and
the y axis. A word has a byte for each of `ROOF_RADII`, whose lower half is of the front face. A level counts
as in `runs.py`, in 15ths of the higher family's highest.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

# In threads beyond a block, on the sides that a ray may reach. Each is twice the one before, or windows would
# have gaps.
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
    for right in (False, True):
        across = faces
        for number, radius in enumerate(ROOF_RADII):
            across = _farther(across, radius, 2, right)
            columns = _of_blocks(across, 2)
            for up in (False, True):
                along = columns
                for reached in ROOF_RADII[: number + 1]:
                    along = _farther(along, reached, 1, up)
                front, behind = _of_blocks(along, 1).astype(np.uint32)
                roofs[..., right + 2 * up] |= (front | behind << np.uint32(4)) << np.uint32(8 * number)
    return roofs


def _farther(maxima: NDArray[np.uint8], radius: int, axis: int, ahead: bool) -> NDArray[np.uint8]:
    """Maxima of windows that reach `radius` cells ahead (else back), of those that reach half as far."""
    shift = max(radius // 2, 1)
    return np.maximum(maxima, np.roll(maxima, -shift if ahead else shift, axis))


def _of_blocks(maxima: NDArray[np.uint8], axis: int) -> NDArray[np.uint8]:
    """Maxima of blocks of cells along an axis; the last block of an odd number is of fewer."""
    return np.maximum.reduceat(maxima, np.arange(0, maxima.shape[axis], ROOF_BLOCK), axis)
