"""Runs: where each thread stays on top or underneath, packed into one 32-bit word a crossing and family.

A *run* is a maximal stretch of crossings over which a thread keeps its side; a run on top is a float.
The word at a crossing says all that the shape of the thread there depends on, so that evaluating a
draft of thousands of threads costs what a plain weave costs:

    bit  0       the thread is on top here
    bits 1–8     crossings between the start of its run and this one   (255: that many or more)
    bits 9–16    crossings between this one and the end of its run     (255: that many or more)
    bits 17–23   length of the run before, in crossings                (127: that many or more)
    bits 24–30   length of the run after                               (127: that many or more)
    bit  31      the thread never interlaces

Counts saturate far beyond `LONGEST_ARC`, behind which a float is straight, so nothing is lost.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

LONGEST_OFFSET = 255
LONGEST_NEIGHBOUR = 127
# Crossings that one bent end of a float may take up at most; see the saturation above.
LONGEST_ARC = 60


# Threads packed at once: keeps the temporary arrays of a 4096 by 4096 draft below 50 MB.
_BLOCK = 256


def pack_runs(on_top: NDArray[np.bool_]) -> NDArray[np.uint32]:
    """Words [threads, crossings] of a family, from whether each thread is on top at each crossing.

    Both axes are periodic; row t holds the crossings of thread t in order.
    """
    words = np.empty(on_top.shape, dtype=np.uint32)
    for first in range(0, on_top.shape[0], _BLOCK):
        words[first : first + _BLOCK] = _pack_block(on_top[first : first + _BLOCK])
    return words


def _pack_block(on_top: NDArray[np.bool_]) -> NDArray[np.uint32]:
    threads, crossings = on_top.shape
    interlaces = (on_top != on_top[:, :1]).any(axis=1)
    starts = on_top != np.roll(on_top, 1, axis=1)
    position = np.arange(crossings, dtype=np.int32)

    # The latest start at or before each crossing; what precedes the first one wraps to the last.
    last_start = np.maximum.accumulate(np.where(starts, position, -1), axis=1)
    wrapped = np.where(last_start < 0, last_start.max(axis=1, keepdims=True) - crossings, last_start)
    behind = position - wrapped
    next_start = np.minimum.accumulate(np.where(starts, position, 2 * crossings)[:, ::-1], axis=1)[:, ::-1]
    following = np.roll(next_start, -1, axis=1)
    following[:, -1] = 2 * crossings
    first_start = np.where(interlaces, starts.argmax(axis=1), 0)[:, None]
    following = np.where(following >= 2 * crossings, first_start + crossings, following)
    ahead = following - position - 1

    length = behind + ahead + 1
    rows = np.arange(threads)[:, None]
    before = length[rows, (position - behind - 1) % crossings]
    after = length[rows, (position + ahead + 1) % crossings]

    word = on_top.astype(np.uint32)
    word |= np.minimum(behind, LONGEST_OFFSET).astype(np.uint32) << np.uint32(1)
    word |= np.minimum(ahead, LONGEST_OFFSET).astype(np.uint32) << np.uint32(9)
    word |= np.minimum(before, LONGEST_NEIGHBOUR).astype(np.uint32) << np.uint32(17)
    word |= np.minimum(after, LONGEST_NEIGHBOUR).astype(np.uint32) << np.uint32(24)
    straight = (
        on_top.astype(np.uint32)
        | np.uint32(LONGEST_OFFSET << 1)
        | np.uint32(LONGEST_OFFSET << 9)
        | np.uint32(LONGEST_NEIGHBOUR << 17)
        | np.uint32(LONGEST_NEIGHBOUR << 24)
        | np.uint32(1 << 31)
    )
    return np.where(interlaces[:, None], word, straight)
