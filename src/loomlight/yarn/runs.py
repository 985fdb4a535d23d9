"""Runs: where each thread stays on top or underneath, packed into one 32-bit word a crossing and family.

A *run* is a maximal stretch of crossings over which a thread keeps its side; a run on top is a float.
The word at a crossing says all that the shape of the thread there depends on, so that evaluating a
draft of thousands of threads costs what a plain weave costs:

    bit  0       the thread is on top here
    bits 1–7     crossings between the start of its run and this one   (127: that many or more)
    bits 8–14    crossings between this one and the end of its run     (127: that many or more)
    bits 15–20   length of the run before, in crossings                (63: that many or more)
    bits 21–26   length of the run after                               (63: that many or more)
    bit  27      the thread never interlaces
    bits 28–31   the cell's maximum height, in 15ths of the family's highest (`threads.prepare_family`)

Counts saturate far beyond `MAX_ARC`, behind which a float is straight, so nothing is lost.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

MAX_OFFSET = 127
MAX_NEIGHBOUR = 63
# Crossings that one bent end of a float may take up at most; see the saturation above.
MAX_ARC = 28
CELL_MAX_LEVELS = 15


# Words that are processed at once: temporary arrays stay within caches.
_BLOCK = 1 << 16


def pack_runs(on_top: NDArray[np.bool_]) -> NDArray[np.uint32]:
    """Words [crossings, threads] of a family, from whether each thread is on top at each crossing.

    Both axes are periodic; column t holds the crossings of thread t in order.
    """
    on_top = np.ascontiguousarray(on_top)
    words = on_top.astype(np.uint32)
    straight = (on_top == on_top[:1]).all(axis=0)
    _add_counts(words, on_top, straight, 1, 15)
    _add_counts(words[::-1], on_top[::-1], straight, 8, 21)
    saturated = MAX_OFFSET << 1 | MAX_OFFSET << 8 | MAX_NEIGHBOUR << 15 | MAX_NEIGHBOUR << 21 | 1 << 27
    words[:, straight] = on_top[0, straight] | np.uint32(saturated)
    return words


def _add_counts(
    words: NDArray[np.uint32], on_top: NDArray[np.bool_], straight: NDArray[np.bool_], *bits: int
) -> None:
    """Adds to words the crossings since their run began, and the length of the run before, each at its bit.

    All threads take each step at once, which begins before the repeat, where each has begun two runs since.
    """
    starts = on_top != np.roll(on_top, 1, axis=0)
    crossings = len(starts)
    lead = 1
    while lead < crossings and not (straight | (starts[-lead:].sum(axis=0) > 1)).all():
        lead = min(2 * lead, crossings)
    # Crossings of the run so far, below 2¹⁶, and above them those of the run before.
    lengths = np.zeros(on_top.shape[1], np.uint32)

    def count(rows: slice) -> NDArray[np.uint32]:
        found = starts[rows] * np.uint32(16)
        for shifts in found:
            np.left_shift(lengths, shifts, out=lengths)
            shifts[:] = lengths
            np.add(lengths, 1, out=lengths)
        return found

    for rows in row_blocks(crossings, lengths.size, crossings - lead):
        count(rows)
    for rows in row_blocks(*on_top.shape):
        found = count(rows)
        words[rows] |= np.minimum(found & 0xFFFF, MAX_OFFSET) << bits[0]
        words[rows] |= np.minimum(found >> 16, MAX_NEIGHBOUR) << bits[1]


def row_blocks(rows: int, columns: int, start: int = 0) -> list[slice]:
    """Ranges of rows from `start`, each of `columns` words, that are processed at once."""
    step = max(1, _BLOCK // columns)
    return [slice(first, min(first + step, rows)) for first in range(start, rows, step)]
