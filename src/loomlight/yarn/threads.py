"""Properties of threads that the geometry needs beyond their runs, computed once in numpy.

A thread's *cell* reaches from the middle of the gap before it to the middle of the gap after it; a run
begins and ends in the middle of a gap. Positions are millimetres from the start of the repeat.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Self

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.yarn.layout import MIN_GAP, FamilyLayout

MAX_OFFSET = 127
MAX_NEIGHBOUR = 63
# Crossings that one bent end of a float may take up at most; see the saturation above.
MAX_ARC = 28
CELL_MAX_LEVELS = 15
# Millimetres: of threads that never interlace, so that shares of the highest crown mean something.
FLATTEST_CROWN = 1e-5
# Words hold them in their highest bits.
CELL_MAX_SHIFT = 28


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


# ---------------------------------------------------------------------------------------------------- threads


# The cross-section is an arc of ±80°: at 90° the variance of 1/n_z over it would be infinite.
SECTION_ANGLE = math.radians(80.0)
# Below this inclination (0.06°) an arc's radius outgrows float32; the thread is as good as straight.
MIN_INCLINATION = 1e-3
# Share of the largest inclination a run can take that is used: its arc keeps a positive length.
STEEPEST_SHARE = 0.95
# Threads finer than this share of the mean would need a finer index than is worth its memory.
FINEST_CELL = 1 / 64


@dataclass(frozen=True, eq=False)
class FamilyTables:
    """Arrays [n] over the threads of one family, millimetres and radians; heights before the scale β.

    Attributes:
        lower, upper: where a thread's cell begins and ends.
        centre, half_width: of the thread.
        inclination: U after clamping for the thread's shortest run.
        arc: longest half-length of a bent end.
        edge_drop: how far below the crown line at a float's boundary its lowest visible edge lies, ≥ 0.
        period: size of the repeat across this family.
        highest, lowest: bounds of the height of any thread, before β and without dives.
        distinct: the distinct run words, where the threads that are crossed are alike and words are few.
    """

    lower: NDArray[np.float64]
    upper: NDArray[np.float64]
    centre: NDArray[np.float64]
    half_width: NDArray[np.float64]
    inclination: NDArray[np.float64]
    arc: NDArray[np.float64]
    edge_drop: NDArray[np.float64]
    period: float
    highest: float
    lowest: float
    distinct: DistinctWords | None

    @cached_property
    def uniform(self) -> bool:
        """Whether all threads are alike, so that no table is needed."""
        rows = np.stack(
            [self.upper - self.lower, self.half_width, self.inclination, self.arc, self.edge_drop]
        )
        first = rows[:, :1]
        return bool((np.abs(rows - first) <= 1e-9 * np.abs(first)).all())

    @property
    def is_straight(self) -> bool:
        """Whether no thread interlaces."""
        return self.highest <= FLATTEST_CROWN

    @property
    def finest(self) -> float:
        """Size of the smallest cell, millimetres."""
        return float((self.upper - self.lower).min())


def section_drop(across: NDArray[np.float64], half_width: NDArray[np.float64]) -> NDArray[np.float64]:
    """Depth of the circular cross-section below its crown, mm, at `across` mm from the middle."""
    radius = half_width / math.sin(SECTION_ANGLE)
    return across**2 / (radius + np.sqrt(np.maximum(radius**2 - across**2, 0)))


def _cells(family: FamilyLayout) -> tuple[NDArray[np.float64], ...]:
    centre = np.cumsum(family.spacing) - family.spacing / 2
    half_width = np.minimum(family.width, (1 - MIN_GAP) * family.spacing) / 2
    period = family.spacing.sum()
    previous_edge = np.roll(centre + half_width, 1)
    previous_edge[0] -= period
    lower = (previous_edge + centre - half_width) / 2
    upper = np.append(lower[1:], lower[0] + period)
    if (upper - lower).min() < FINEST_CELL * period / lower.size:
        raise InputError(
            f"The finest thread takes up {1e3 * (upper - lower).min():.3g} µm, less than 1/64 of the mean of "
            f"{1e3 * period / lower.size:.3g} µm; give threads more even spacings."
        )
    return lower, upper, centre, half_width


def place_family(family: FamilyLayout) -> FamilyTables:
    """Where threads lie, without how they bend: those tables are 0."""
    lower, upper, centre, half_width = _cells(family)
    flat = np.zeros(lower.size)
    period = float(family.spacing.sum())
    return FamilyTables(lower, upper, centre, half_width, flat, flat, flat, period, 0.0, 0.0, None)


def prepare_family(family: FamilyLayout, crossing: FamilyLayout, words: NDArray[np.uint32]) -> FamilyTables:
    """Tables of `family`, whose threads cross those of `crossing`.

    Args:
        words: of its runs [crossings, n]. They get the cell maxima: how high each thread rises in the cell of
            each crossing, rounded up to 15ths of `highest`; rays above pass the cell by.

    Raises:
        InputError: spacings too uneven (a cell under 1/64 of the mean).
    """
    lower, upper, centre, half_width = _cells(family)
    cross_lower, cross_upper, cross_centre, cross_half = _cells(crossing)
    cross_period = float(crossing.spacing.sum())
    section = section_drop(half_width, half_width)
    shown = _ShownWords(words, _are_alike(cross_upper - cross_lower, cross_half))

    # Flatten threads whose shortest run has no room for an arc of the inclination that was asked for.
    shortest = np.full(lower.size, np.inf)
    for threads, part in shown.blocks():
        length = _run_ends(part, cross_lower, cross_upper, cross_period).length
        shortest[threads] = length.min(axis=1)
    # A run of length L leaves room for its arc while w·tan(v_max/2)·sin U < L.
    steepest = np.arcsin(np.minimum(STEEPEST_SHARE * shortest / (2 * section), 1.0))
    inclination = np.clip(np.minimum(family.inclination, steepest), MIN_INCLINATION, None)

    # Cut arcs to what floats and words can hold.
    finest_crossing = float((cross_upper - cross_lower).min())
    # A float rises by one width at most, and its ends stay within what the run words can tell.
    arc = np.minimum(2 * half_width / np.tan(inclination / 2), MAX_ARC * finest_crossing)

    # Find how high floats rise, and how deep the edges of runs dive.
    lowest_edge = 1.0  # in units of the section's drop
    highest = FLATTEST_CROWN
    gap_below = cross_centre - cross_half - cross_lower
    gap_above = cross_upper - cross_centre - cross_half
    for threads, part in shown.blocks():
        ends = _run_ends(part, cross_lower, cross_upper, cross_period)
        reach = np.minimum(ends.length / 2, arc[threads, None])
        rise = np.where(np.isfinite(ends.length), reach * np.tan(inclination[threads, None] / 2), 0.0)
        highest = max(highest, float(rise.max()))
        for is_end, neighbour, distance in (
            (ends.starts, ends.before, gap_below),
            (ends.finishes, ends.after, gap_above),
        ):
            other = np.minimum(neighbour / 2, arc[threads, None])
            depth = -_edge_height(
                np.broadcast_to(distance[: reach.shape[1]], reach.shape),
                reach,
                other,
                section[threads, None],
                inclination[threads, None],
            )
            depth = np.where(is_end, depth / section[threads, None], 0.0)
            lowest_edge = max(lowest_edge, float(depth.max()))
    # Round the maximum of every cell up to a share of that height, and put it into the words.
    cell_maxima = np.empty(shown.words.shape, np.uint8)
    for threads, part in shown.blocks():
        ends = _run_ends(part, cross_lower, cross_upper, cross_period)
        cell_max = _cell_max(ends, arc[threads, None], inclination[threads, None])
        cell_maxima[threads] = np.ceil(np.minimum(cell_max / max(highest, 1e-30) + 1e-6, 1) * CELL_MAX_LEVELS)
    shown.add_cell_maxima(cell_maxima)
    # Only a thread that interlaces ends low; the drop at the middle of a run is less than at its ends.
    lowest = -(highest + float(2 * section.max()))
    return FamilyTables(
        lower,
        upper,
        centre,
        half_width,
        inclination,
        arc,
        # One share for the family, so that threads alike in all else stay alike.
        lowest_edge * section,
        float(family.spacing.sum()),
        highest,
        lowest,
        shown.distinct,
    )


def _are_alike(*of_threads: NDArray[np.float64]) -> bool:
    return all(np.ptp(numbers) <= 1e-9 * abs(numbers[0]) for numbers in of_threads)


class _ShownWords:
    """Run words of each thread [n, m]: all, or the distinct ones where the threads they cross are alike."""

    def __init__(self, words: NDArray[np.uint32], are_alike: bool) -> None:
        self._all, self.words = words, words.T
        # The tables pay for themselves with a hundred crossings a thread.
        self.distinct = DistinctWords.of(words) if are_alike and len(words) > 100 else None
        if self.distinct is None:
            return
        values = self.distinct.values
        self._met = np.zeros((words.shape[1], values.size), bool)
        for rows in row_blocks(*words.shape):
            self._met.ravel()[self._places(rows)] = True
        count = self._met.sum(axis=1)
        self._filled = np.arange(count.max()) < count[:, None]
        self.words = np.repeat(words[0][:, None], count.max(), axis=1)
        self.words[self._filled] = values[np.nonzero(self._met)[1]]

    def blocks(self) -> Iterator[tuple[slice, NDArray[np.uint32]]]:
        """Threads and their words, in parts that fit caches."""
        for threads in row_blocks(*self.words.shape):
            yield threads, np.ascontiguousarray(self.words[threads])

    def add_cell_maxima(self, maxima: NDArray[np.uint8]) -> None:
        """Adds to all words their cells' maxima, given those of the words here [n, m]."""
        if self.distinct is None:
            for threads in row_blocks(*maxima.shape):
                self.words[threads] |= maxima[threads].astype(np.uint32) << np.uint32(CELL_MAX_SHIFT)
            return
        table = np.zeros(self._met.shape, np.uint32)
        table[self._met] = maxima[self._filled].astype(np.uint32) << np.uint32(CELL_MAX_SHIFT)
        for rows in row_blocks(*self._all.shape):
            self._all[rows] |= table.take(self._places(rows))

    def _places(self, rows: slice) -> NDArray[np.intp]:
        """Of the words of some crossings, flat indices into tables [n, distinct words]."""
        assert self.distinct is not None
        first = np.arange(len(self._met)) * self.distinct.values.size
        return first + self.distinct.indices(self._all[rows])


@dataclass(frozen=True, eq=False)
class _RunEnds:
    """Arrays [threads, crossings]: lengths in mm of the run at a crossing and of its neighbours."""

    length: NDArray[np.float64]
    before: NDArray[np.float64]
    after: NDArray[np.float64]
    starts: NDArray[np.bool_]
    finishes: NDArray[np.bool_]
    from_start: NDArray[np.float64]  # to the upper end of the crossing's cell
    to_end: NDArray[np.float64]  # from its lower end


def _run_ends(
    words: NDArray[np.uint32], lower: NDArray[np.float64], upper: NDArray[np.float64], period: float
) -> _RunEnds:
    count = lower.size
    here = np.arange(words.shape[1], dtype=np.int32)
    # Where cells begin, of all crossings that a word can tell of: one look-up each in place of a division.
    farthest = MAX_OFFSET + MAX_NEIGHBOUR + 2
    crossing = np.arange(-farthest, count + farthest)
    cell_starts = lower[crossing % count] + period * (crossing // count)

    def position(index: NDArray[np.int32]) -> NDArray[np.float64]:
        return cell_starts.take(index + farthest)

    signed = words.astype(np.int32)
    behind, ahead = (signed >> 1) & 127, (signed >> 8) & 127
    before, after = (signed >> 15) & 63, (signed >> 21) & 63
    straight = (signed >> 27 & 1) == 1
    start, finish = position(here - behind), position(here + ahead + 1)
    length = np.where(straight, np.inf, finish - start)
    return _RunEnds(
        length,
        start - position(here - behind - before),
        position(here + ahead + 1 + after) - finish,
        (behind == 0) & ~straight,
        (ahead == 0) & ~straight,
        position(here + 1) - start,
        finish - position(here),
    )


def _cell_max(
    ends: _RunEnds, arc: NDArray[np.float64], inclination: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Highest point of each thread's crown in each cell; 0 for threads that never interlace."""
    finite = np.where(np.isfinite(ends.length), ends.length, 0.0)
    reach = np.minimum(finite / 2, arc)
    farthest = np.minimum(np.minimum(ends.from_start, ends.to_end), finite / 2)
    along = np.maximum(reach - farthest, 0)
    radius = reach / np.sin(inclination)
    root = np.sqrt(np.maximum(radius**2 - along**2, 0))
    return reach * np.tan(inclination / 2) - along**2 / np.maximum(radius + root, 1e-30)


def _edge_height(
    distance: NDArray[np.float64],
    reach: NDArray[np.float64],
    other_reach: NDArray[np.float64],
    section: NDArray[np.float64],
    inclination: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Height of a float's edge `distance` from its boundary: the tube of `geometry.py`, at x = w/2."""
    finite = np.where(np.isfinite(reach), reach, 1.0)
    sine, half_tangent = np.sin(inclination), np.tan(inclination / 2)
    own = distance >= section * sine
    along = np.where(own, np.maximum(finite - distance, 0), other_reach + distance)
    sign = np.where(own, 1.0, -1.0)
    arc = np.where(own, finite, other_reach)
    radius = arc / sine - sign * section
    root = np.sqrt(np.maximum(radius**2 - along**2, 0))
    return sign * (arc * half_tangent - along**2 / (radius + root)) - section


# --------------------------------------------------------------------------------------------- distinct words
# The distinct ones of many run words, and where each is among them: a draft's words are few.


# Words are looked up by halves, then by the pair of these. Tables of more numbers would not pay.
_LOW_BITS, _LOW_MASK, _HIGH_MASK = 15, (1 << 15) - 1, (1 << 13) - 1
MAX_TABLE = 1 << 24


def distinct_numbers(
    blocks: Iterable[NDArray[np.integer]], limit: int
) -> tuple[NDArray[np.intp], NDArray[np.intp], NDArray[np.intp]]:
    """The distinct ones of numbers below a limit, in order; the index of each [limit]; where each was met."""
    place, count = np.full(limit, -1, np.int32), 0
    for numbers in blocks:
        place[numbers] = np.arange(count, count + numbers.size, dtype=np.int32).reshape(numbers.shape)
        count += numbers.size
    values = np.flatnonzero(place >= 0)
    return values, np.cumsum(place >= 0) - 1, place[values].astype(np.intp)


@dataclass(frozen=True, eq=False)
class DistinctWords:
    """The distinct run words of a family, without cell maxima: tables of halves of words and of their pairs.

    Attributes:
        values: the words, in order.
    """

    values: NDArray[np.uint32]
    _low: NDArray[np.intp]
    _high: NDArray[np.intp]
    _index: NDArray[np.intp]

    @classmethod
    def of(cls, words: NDArray[np.uint32]) -> Self | None:
        """The distinct words of an array [n, m], which is read thrice; None of more than n."""
        blocks = [words[rows] for rows in row_blocks(*words.shape)]
        lows, low, _ = distinct_numbers((part & _LOW_MASK for part in blocks), _LOW_MASK + 1)
        highs, high, _ = distinct_numbers((part >> _LOW_BITS for part in blocks), 1 << 32 - _LOW_BITS)
        if lows.size * highs.size > MAX_TABLE:
            return None
        found = cls(np.empty(0, np.uint32), low, high * lows.size, np.empty(0, np.intp))
        met, index, _ = distinct_numbers(map(found._pairs, blocks), lows.size * highs.size)
        values = (highs[met // lows.size] << _LOW_BITS | lows[met % lows.size]).astype(np.uint32)
        return replace(found, values=values, _index=index) if met.size <= len(words) else None

    def indices(self, words: NDArray[np.uint32]) -> NDArray[np.intp]:
        """Where words, which are among the distinct ones, lie in `values`."""
        return self._index.take(self._pairs(words))

    def _pairs(self, words: NDArray[np.uint32]) -> NDArray[np.intp]:
        return self._high.take(words >> _LOW_BITS & _HIGH_MASK) + self._low.take(words & _LOW_MASK)
