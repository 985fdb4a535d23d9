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
    bits 28–31   the cell's maximum height, in 15ths of the family's highest (see `with_cell_maxima`)

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


# Crossings of the threads that are processed at once: temporary arrays stay within caches.
_BLOCK = 1 << 16


def pack_runs(on_top: NDArray[np.bool_]) -> NDArray[np.uint32]:
    """Words [threads, crossings] of a family, from whether each thread is on top at each crossing.

    Both axes are periodic; row t holds the crossings of thread t in order.
    """
    words = np.empty(on_top.shape, dtype=np.uint32)
    for rows in thread_blocks(*on_top.shape):
        words[rows] = _pack_block(on_top[rows])
    return words


def thread_blocks(threads: int, crossings: int) -> list[slice]:
    """Ranges of threads, each of `crossings`, that are processed at once."""
    step = max(1, _BLOCK // crossings)
    return [slice(first, first + step) for first in range(0, threads, step)]


def _pack_block(on_top: NDArray[np.bool_]) -> NDArray[np.uint32]:
    crossings = on_top.shape[1]
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
    first_start = np.where(interlaces, starts.argmax(axis=1), 0).astype(np.int32)[:, None]
    following = np.where(following >= 2 * crossings, first_start + crossings, following)
    ahead = following - position - 1

    length = behind + ahead + 1
    previous, following = position - behind - 1, position + ahead + 1
    # Less than one repeat away: additions instead of remainders, which take as long as all else.
    previous += crossings * (previous < 0)
    following -= crossings * (following >= crossings)
    # Threads that never interlace have no runs; their words follow below.
    before = np.take_along_axis(length, np.maximum(previous, 0), axis=1)
    after = np.take_along_axis(length, np.minimum(following, crossings - 1), axis=1)

    word = on_top.astype(np.uint32)
    word |= np.minimum(behind, MAX_OFFSET).astype(np.uint32) << np.uint32(1)
    word |= np.minimum(ahead, MAX_OFFSET).astype(np.uint32) << np.uint32(8)
    word |= np.minimum(before, MAX_NEIGHBOUR).astype(np.uint32) << np.uint32(15)
    word |= np.minimum(after, MAX_NEIGHBOUR).astype(np.uint32) << np.uint32(21)
    straight = (
        on_top.astype(np.uint32)
        | np.uint32(MAX_OFFSET << 1)
        | np.uint32(MAX_OFFSET << 8)
        | np.uint32(MAX_NEIGHBOUR << 15)
        | np.uint32(MAX_NEIGHBOUR << 21)
        | np.uint32(1 << 27)
    )
    return np.where(interlaces[:, None], word, straight)


def with_cell_maxima(words: NDArray[np.uint32], cell_maxima: NDArray[np.uint8]) -> NDArray[np.uint32]:
    """The words with cell maxima [threads, crossings], levels 0 to 15, in their last four bits."""
    return words | cell_maxima.astype(np.uint32) << np.uint32(28)
