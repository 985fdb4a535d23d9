"""Binding points in floats that are too long, as where two structures of figured cloth meet."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.weave.structures import Structure

# A float is halved each time; the longest of 16384 threads is as short as any limit after 14.
_ROUNDS = 16
# Crossings whose floats are looked for at once.
_CROSSINGS_AT_ONCE = 1 << 23


def bind_floats(warp_up: Structure, limit: int, *, loose: NDArray[np.bool_] | None = None) -> Structure:
    """The structure with extra binding points in the floats longer than `limit`, on either face.

    Each is put as near the middle of its float as it can be without making a float of the other family
    too long.

    Args:
        warp_up: bool [picks, ends], which repeats both ways.
        limit: threads that a float may pass, >= 1.
        loose: bool [picks, ends], True where an extra weft lies free on the back of the cloth: no binding is
            put there, and floats of that weft that reach it stay as long as they are. None for nowhere.

    Raises:
        InputError: a float that no binding point can shorten.
    """
    bound = warp_up.copy()
    for _ in range(_ROUNDS):
        count = 0
        for threads_axis in (1, 0):
            cloth, free = (bound.T, None if loose is None else loose.T) if threads_axis else (bound, loose)
            floats = _long_floats(cloth, limit)
            if free is not None and threads_axis == 0:
                floats = [each for each in floats if not _is_loose(cloth, free, each)]
            for each in floats:
                _bind(cloth, free, limit, each)
            count += len(floats)
        if count == 0:
            return bound
    raise InputError(f"No binding keeps every float of the figure to {limit} threads; allow longer ones.")


# A thread, the position at which its float begins, and the length of the float. Threads are rows below, and
# positions the threads that they cross.
_Float = tuple[int, int, int]


def _long_floats(rows: NDArray[np.bool_], limit: int) -> list[_Float]:
    """All runs of equal values longer than `limit` in rows that repeat, by row and by where they begin."""
    count, size = rows.shape
    if size <= limit:
        return []
    found: list[_Float] = []
    step = max(1, _CROSSINGS_AT_ONCE // size)
    for first in range(0, count, step):
        # Memory goes along the threads that are crossed where `rows` is a transposed view.
        for thread, start, length in _runs_of_part(rows[first : first + step], limit):
            found.append((first + thread, start, length))
    return found


def _runs_of_part(rows: NDArray[np.bool_], limit: int) -> Iterator[_Float]:
    size = rows.shape[1]
    # Whether the value at each position and the next `limit` ones are equal, by doubling.
    same = rows == np.roll(rows, -1, axis=1)
    have = 1
    while have < limit:
        more = min(have, limit - have)
        same &= np.roll(same, -more, axis=1)
        have += more
    starts = _positions(same & ~np.roll(same, 1, axis=1))
    stops = _positions(same & ~np.roll(same, -1, axis=1))
    found = [(int(thread), 0, size) for thread in np.flatnonzero(same.all(axis=1))]
    if len(starts):
        # As many runs begin in a row as end there; one that passes the row's end does so at its first stop.
        thread, start = np.divmod(starts, size)
        at = np.searchsorted(stops, starts)
        is_over = (at >= len(stops)) | (stops[np.minimum(at, len(stops) - 1)] // size != thread)
        at = np.where(is_over, np.searchsorted(stops, thread * size), at)
        stop = stops[at] % size + np.where(is_over, size, 0)
        lengths = stop - start + 1 + limit
        found += zip(thread.tolist(), start.tolist(), lengths.tolist(), strict=True)
    return iter(sorted(found))


def _positions(marks: NDArray[np.bool_]) -> NDArray[np.intp]:
    """Places of marks, row · size + position, ascending."""
    row, position = np.nonzero(marks)
    return np.sort(row * marks.shape[1] + position)


def _is_loose(rows: NDArray[np.bool_], loose: NDArray[np.bool_], run: _Float) -> bool:
    """Whether a float of a pick lies on the back and reaches where it is free."""
    thread, start, length = run
    at = np.arange(start, start + length)
    return bool(rows[thread, start] and loose[thread].take(at, mode="wrap").any())


def _bind(rows: NDArray[np.bool_], loose: NDArray[np.bool_] | None, limit: int, run: _Float) -> None:
    """Flips one crossing of a long float; `rows` is a view of the cloth."""
    thread, start, length = run
    size = rows.shape[1]
    for at in _from_middle(start + 1, start + length - 1, start + length // 2):
        crossing = at % size
        if loose is not None and loose[thread, crossing]:
            continue
        rows[thread, crossing] = not rows[thread, crossing]
        if _is_short(rows[:, crossing], thread, limit):
            return
        rows[thread, crossing] = not rows[thread, crossing]


def _from_middle(first: int, end: int, middle: int) -> Iterator[int]:
    """The numbers from `first` to before `end`, those next to `middle` first, of two the smaller."""
    if first <= middle < end:
        yield middle
    for away in range(1, max(end - middle, middle - first + 1)):
        if first <= middle - away < end:
            yield middle - away
        if first <= middle + away < end:
            yield middle + away


def _is_short(across: NDArray[np.bool_], at: int, limit: int) -> bool:
    """Whether the float through position `at` of a thread that repeats is no longer than `limit`."""
    if across.size <= limit:
        return True
    near = across.take(np.arange(at - limit, at + limit + 1), mode="wrap")
    other = near != near[limit]
    before, after = other[:limit][::-1], other[limit + 1 :]
    run = 1 + sum(int(side.argmax()) if side.any() else limit for side in (before, after))
    return run <= limit
