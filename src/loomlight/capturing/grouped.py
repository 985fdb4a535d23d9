"""Threads that lie together: a pair of one colour that goes over and under as one looks like a single thread.

A basket and a rib of pairs have the drawdown of plain weave on a grid of half the sett. Which of both a
photograph shows its crossings do not say, but a render does: a pair has a groove along its middle, where a
single thread has its crown.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from loomlight.capturing.crossings import Crossings, find_crossings
from loomlight.capturing.thread_colours import ColourOrder, colour_orders, grouped_order
from loomlight.capturing.thread_grid import MIN_THREAD_PX, Plane, ThreadGrid
from loomlight.capturing.weave_match import Structure, WeaveFit, candidate_name

# Threads that may lie together as one.
MAX_GROUP = 4
# Pixels of each thread of a pair below which no groove between them is seen: means of many repeats show what
# a single thread of so few pixels does not. Larger groups are rare, and looked for where threads are wide.
_MIN_PAIRED_PX = 3.0


@dataclass(frozen=True, eq=False)
class Grouping:
    """A weave on a grid, whose threads are taken in groups of `times` (picks, ends) of a simpler weave.

    Attributes:
        orders: colours of warp and weft; those of a group are one.
    """

    fit: WeaveFit
    grid: ThreadGrid
    crossings: Crossings
    orders: tuple[ColourOrder, ColourOrder]
    times: tuple[int, int]


def core_of(encoded: Plane, fit: WeaveFit, grid: ThreadGrid, crossings: Crossings) -> Grouping:
    """The weave whose groups of neighbours that do the same are taken for one thread."""
    times = _together(fit.structure), _together(fit.structure.T)
    if times == (1, 1):
        return Grouping(fit, grid, crossings, colour_orders(crossings, fit.table(crossings.shape)), times)
    # A structure may begin within a group.
    ahead = [_ahead(rows, count) for rows, count in ((fit.structure, times[0]), (fit.structure.T, times[1]))]
    core = np.roll(fit.structure, (-ahead[0], -ahead[1]), (0, 1))[:: times[0], :: times[1]]
    offset = [(lead - shift) % count for lead, shift, count in zip(ahead, fit.shift, times, strict=True)]
    begin = [
        (off + shift - lead) % side // count
        for off, shift, lead, side, count in zip(
            offset, fit.shift, ahead, fit.structure.shape, times, strict=True
        )
    ]
    start = crossings.first[0] + offset[1], crossings.first[1] + offset[0]
    joined = grid.regrouped((1 / times[1], 1 / times[0]), (float(start[0]), float(start[1])))
    seen = find_crossings(encoded, joined)
    shift = (begin[0] + seen.first[1]) % core.shape[0], (begin[1] + seen.first[0]) % core.shape[1]
    found = WeaveFit(candidate_name(core) or "", core, shift, fit.score, fit.unsigned)
    return Grouping(found, joined, seen, colour_orders(seen, found.table(seen.shape)), times)


def groupings(core: Grouping, px: tuple[float, float], limit: int) -> Iterator[tuple[int, int]]:
    """How many picks and ends may lie together as one thread of a weave: where that makes a named weave.

    Args:
        px: pixels a pick and an end of the core.
        limit: of a group; what was found first is always among them.
    """
    for picks in range(1, MAX_GROUP + 1):
        for ends in range(1, MAX_GROUP + 1):
            found = (picks, ends) in ((1, 1), core.times)
            if found or (max(picks, ends) <= limit and _is_named(core, (picks, ends), px)):
                yield picks, ends


def _is_named(core: Grouping, times: tuple[int, int], px: tuple[float, float]) -> bool:
    """Whether groups make a weave with a name, of threads that are wide enough to be seen."""
    wide = all(
        count == 1 or size / count >= (_MIN_PAIRED_PX if count == 2 else MIN_THREAD_PX)
        for size, count in zip(px, times, strict=True)
    )
    return wide and candidate_name(_repeated(core.fit.structure, times)) is not None


def grouped(encoded: Plane, core: Grouping, times: tuple[int, int]) -> Grouping:
    """The weave of so many picks and ends in the place of each thread of a core."""
    if times == (1, 1):
        return Grouping(core.fit, core.grid, core.crossings, core.orders, times)
    structure = _repeated(core.fit.structure, times)
    grid = core.grid.regrouped((times[1], times[0]))
    seen = find_crossings(encoded, grid)
    ahead = [
        own - count * first
        for count, first, own in zip(times, core.crossings.first[::-1], seen.first[::-1], strict=True)
    ]
    shift = [
        (count * begin + more) % side
        for count, begin, more, side in zip(times, core.fit.shift, ahead, structure.shape, strict=True)
    ]
    name = candidate_name(structure) or ""
    fit = WeaveFit(name, structure, (shift[0], shift[1]), core.fit.score, core.fit.unsigned)
    warp = grouped_order(core.orders[0], times[1], ahead[1])
    weft = grouped_order(core.orders[1], times[0], ahead[0])
    return Grouping(fit, grid, seen, (warp, weft), times)


def _repeated(structure: Structure, times: tuple[int, int]) -> Structure:
    return structure.repeat(times[0], axis=0).repeat(times[1], axis=1)


def _together(structure: Structure) -> int:
    """How many neighbouring rows do the same, all over: 1 where any differs from its neighbours."""
    for count in range(min(MAX_GROUP, len(structure) // 2), 1, -1):
        if len(structure) % count == 0 and _ahead(structure, count) >= 0:
            return count
    return 1


def _ahead(structure: Structure, count: int) -> int:
    """Rows before the first whole group; -1 if rows are in no groups of so many."""
    for lead in range(count):
        groups = np.roll(structure, -lead, 0).reshape(-1, count, structure.shape[1])
        if (groups == groups[:, :1]).all():
            return lead
    return -1
