"""Roofs: how high the cloth rises around each place, so that rays high above need not ask every cell.

One 32-bit word for every two by two cells: a byte for each of `ROOF_RADII`, whose lower half is of the front
face. A level counts as in `runs.py`, in 15ths of the higher family's highest.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

# In threads around a block. Each is at most twice the one before, or windows would have gaps.
ROOF_RADII = (1, 2, 4, 8)
ROOF_BLOCK = 2


def pack_roofs(words: NDArray[np.uint32]) -> NDArray[np.uint32]:
    """Roofs [picks / 2, ends / 2], rounded up, of the words of warp and weft [picks, ends, 2]."""
    levels = (words >> 28).astype(np.uint8)
    warp_on_top = (words[..., 0] & 1) == 1
    front = np.where(warp_on_top, levels[..., 0], levels[..., 1])
    behind = np.where(warp_on_top, levels[..., 1], levels[..., 0])
    faces = np.stack([front, behind])
    roofs = np.zeros([-(-count // ROOF_BLOCK) for count in front.shape], np.uint32)
    reached = 0
    for number, radius in enumerate(ROOF_RADII):
        faces = _widened(faces, radius - reached)
        reached = radius
        blocks = _of_blocks(faces).astype(np.uint32)
        roofs |= (blocks[0] | blocks[1] << 4) << np.uint32(8 * number)
    return roofs


def _widened(faces: NDArray[np.uint8], step: int) -> NDArray[np.uint8]:
    """Maxima of windows that reach `step` cells farther to all sides; both axes are periodic."""
    for axis in (1, 2):
        sides = np.roll(faces, step, axis), np.roll(faces, -step, axis)
        faces = np.maximum(faces, np.maximum(*sides))
    return faces


def _of_blocks(faces: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Maxima of blocks of cells; the last block of an odd number is of fewer."""
    missing = [-count % ROOF_BLOCK for count in faces.shape[1:]]
    padded = np.pad(faces, [(0, 0), *((0, more) for more in missing)], mode="edge")
    rows, columns = (count // ROOF_BLOCK for count in padded.shape[1:])
    return padded.reshape(2, rows, ROOF_BLOCK, columns, ROOF_BLOCK).max(axis=(2, 4))
