"""The name of a drawdown's weave, as `named_weave` reads it: plain, twill, satin, sateen, basket or rib."""

from __future__ import annotations

from collections import Counter

import numpy as np
from numpy.typing import NDArray

from loomlight.weave.structures import satin_steps

Structure = NDArray[np.bool_]

# Threads of the longest repeat that is looked for: twice as many show one.
_MAX_REPEAT = 32
_WINDOW, _MIN_WINDOW = 2 * _MAX_REPEAT, 8
# Windows that are looked at: of large drawdowns, and before smaller windows are tried.
_MAX_WINDOWS, _MIN_WINDOWS = 256, 8


def weave_name(warp_up: Structure, where: Structure | None = None) -> str | None:
    """The name of a drawdown's weave, after "mostly" if not all of it has that; None if most has no name.

    Args:
        warp_up: bool [picks, ends], True where the warp is on top; it repeats.
        where: the crossings that count, bool [picks, ends]; None: all.
    """
    if where is None:
        repeat = smallest_repeat(warp_up)
        if repeat is not None and (name := _name(repeat)) is not None:
            return name
        where = np.ones((1, 1), dtype=bool)
    counts: Counter[str | None] = Counter()
    for window in _windows(warp_up, where):
        inside = smallest_repeat(window, wraps=False)
        counts[None if inside is None else _name(inside)] += 1
    (name, count), *_ = counts.most_common(1) or [(None, 0)]
    if name is None or 2 * count <= counts.total():
        return None
    return name if count == counts.total() else f"mostly {name}"


def smallest_repeat(warp_up: Structure, wraps: bool = True) -> Structure | None:
    """The smallest part that repeats as this drawdown; None if it has more than 32 ends or picks.

    Args:
        warp_up: bool [picks, ends].
        wraps: whether the drawdown repeats, else it is a piece that shows the part at least twice.
    """
    sides = [_period(part, wraps) for part in (warp_up, warp_up.T)]
    picks, ends = sides
    return None if picks is None or ends is None else warp_up[:picks, :ends]


def _period(rows: Structure, wraps: bool) -> int | None:
    count = len(rows)
    for period in range(1, min(_MAX_REPEAT, count if wraps else count // 2) + 1):
        if wraps and count % period:
            continue
        if np.array_equal(rows[period:], rows[:-period]):
            return period
    return None


def _windows(warp_up: Structure, where: Structure) -> list[Structure]:
    """Pieces of a drawdown in which all crossings count; a family of few threads is repeated."""
    times = [1 if count >= _MIN_WINDOW else -(-_MIN_WINDOW // count) for count in warp_up.shape]
    cloth, counted = np.tile(warp_up, times), np.broadcast_to(where, warp_up.shape)
    counted = np.tile(counted, times)
    pieces: list[Structure] = []
    for side in (_WINDOW, 2 * _MIN_WINDOW, _MIN_WINDOW):
        height, width = (min(side, count) for count in cloth.shape)
        places = [
            (slice(down, down + height), slice(across, across + width))
            for down in range(0, cloth.shape[0] - height + 1, max(1, height // 2))
            for across in range(0, cloth.shape[1] - width + 1, max(1, width // 2))
        ]
        step = max(1, len(places) // _MAX_WINDOWS)
        pieces = [cloth[place] for place in places[::step] if counted[place].all()]
        if len(pieces) >= _MIN_WINDOWS:
            break
    return pieces


def _name(repeat: Structure) -> str | None:
    """The name of a weave of which this is one repeat."""
    picks, ends = repeat.shape
    if picks == ends == 1:
        return None
    return _grouped(repeat) or (_stepped(repeat) if picks == ends else None)


def _grouped(repeat: Structure) -> str | None:
    """Plain weave, basket or rib: plain weave whose threads are grouped."""
    of_picks, of_ends = _groups(repeat), _groups(repeat.T)
    if of_picks is None or of_ends is None:
        return None
    if of_picks == of_ends == (1, 1):
        return "plain"
    if of_ends == (1, 1):
        return f"warp rib {of_picks[0]}/{of_picks[1]}"
    if of_picks == (1, 1):
        return f"weft rib {of_ends[0]}/{of_ends[1]}"
    if of_picks[0] == of_picks[1] and of_ends[0] == of_ends[1]:
        return f"basket {of_ends[0]}/{of_picks[0]}"
    return None


def _groups(rows: Structure) -> tuple[int, int] | None:
    """The two groups of rows, larger first, if each row is the first one or its opposite, in two groups."""
    same = np.all(rows == rows[0], axis=1)
    if np.any(~same & ~np.all(rows != rows[0], axis=1)):
        return None
    if np.count_nonzero(same != np.roll(same, 1)) != 2:
        return None
    sizes = sorted((int(np.count_nonzero(same)), int(np.count_nonzero(~same))), reverse=True)
    return sizes[0], sizes[1]


def _stepped(repeat: Structure) -> str | None:
    """A twill or satin: each pick is the one before, so many ends further."""
    threads = len(repeat)
    steps = [
        step for step in range(1, threads) if np.array_equal(np.roll(repeat, (1, step), axis=(0, 1)), repeat)
    ]
    if not steps:
        return None
    ups = int(np.count_nonzero(repeat[0]))
    if 1 in steps or threads - 1 in steps:
        # Counts begin at an end that is up after one that is down, with the longest float on the face.
        row = repeat[0]
        starts = np.flatnonzero(row & ~np.roll(row, 1))
        turned = [_runs(np.roll(row, -int(start))) for start in starts]
        return f"twill {'/'.join(map(str, max(turned)))} {'z' if 1 in steps else 's'}"
    if ups in (1, threads - 1) and steps[0] in satin_steps(threads):
        return f"{'sateen' if ups == 1 else 'satin'} {threads}/{steps[0]}"
    return None


def _runs(row: NDArray[np.bool_]) -> tuple[int, ...]:
    """Lengths of the runs of a row that begins with one and ends with another kind."""
    edges = np.flatnonzero(np.diff(row)) + 1
    return tuple(np.diff([0, *edges.tolist(), len(row)]).tolist())
