"""Layers of a drawdown: cloths that lie upon one another, extra threads, and where they change places.

A drawdown says which of two crossing threads is on top, and never which of two ends, or of two picks, is.
Yet two picks side by side bar each other's way: some end passes over the one and under the other, some end
the other way round. Where no end does so, the one can slide over the other, and on the loom it does: the reed
packs as many picks upon one another as the ends between them allow. Hence

- *levels*: in a small window, threads of a family are sorted by how often they are on top, and split where
  those above slide over those below (`_levels`);
- *systems*: threads that are at one level in all windows, ends and picks together where they interlace with
  each other alone: a cloth, or the extra ends or picks of one (`_thread_systems`);
- *order*: of two systems, at each crossing, from the crossings around (`_Evidence`): one above the other, or
  woven as one. Where the order changes, cloths change places, and a region ends.

A single crossing against the order binds one cloth to the other: a stitch. What no thread at all binds
together is `layer_sizes`, which is exact and needs no window.
"""

from __future__ import annotations

import warnings
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import LoomlightWarning

Bits = NDArray[np.bool_]
Indices = NDArray[np.intp]

# Windows in which levels are looked for, in threads, from the one that is trusted most.
_WINDOWS = (64, 32, 16, 8)
# Threads above may be below those that they slide over at this share of the places where they differ, which
# stitches are. Of the ten layered drafts in examples/makers it is 0.13 at most (wadding of the piqué); of the
# named weaves, which are single cloths, at least 0.2.
_MAX_CONTRARY = 0.16
# Where they do not differ, both are on top or both are not: of a rib's threads, which are no layers, never.
# It is so at this share of all places, and at this many times those where they are below.
_MIN_EQUAL, _EQUAL_OF_CONTRARY = 1 / 16, 2
# Neighbouring levels differ by at least this share of a window, and by two places, in how often their threads
# are on top. Satin upon sateen, of eight ends each, differs least: by a quarter of the share of their ends.
_MIN_GAP = 1 / 16
# The largest gap between threads of one level, in mean gaps.
_MAX_UNEVEN = 2.5
_MAX_LEVELS = 8
_MAX_SYSTEMS = 8
# Threads of the longest turn in which systems follow one another.
_MAX_TURN = 48
# Of a system's crossings with another, at least so many tell their order; otherwise the two are woven as one.
_MIN_ORDERED = 0.05
# Of places beside one that tells an order, at least so many tell the same.
_MIN_LIKE = 0.75
# How many times more must be told by smaller windows, if they are to be believed.
_MUCH_BETTER = 1.2
# Share of windows and threads that tell, of windows after which smaller ones are not looked at.
_GOOD = 0.5
# Windows that are looked at of one size, and at least of each row of them.
_MAX_WINDOWS, _MIN_IN_ROW = 4096, 16
# Share of threads that are set right by the turn of all others.
_MAX_OUT_OF_TURN = 0.05
# Share of the crossings that a stack has at least.
_MIN_SHARE = 0.01
# Threads at the rim of a region that belong to the one beside it, so many at most: a float over so many
# threads says so, if it is more than so many times the longest one that the thread would have there.
_MAX_RIM, _LONG_FLOAT, _MUCH_LONGER = 2, 4, 2
# Rows of crossings that are looked at together.
ROWS_AT_ONCE = 512


@dataclass(frozen=True, eq=False)
class ThreadSystem:
    """Threads that are at one level wherever they lie side by side.

    Attributes:
        ends: its ends, 0-based, rising [n]; of extra wefts none.
        picks: its picks, 0-based, rising [m]; of extra warps none.
        host: for extra ends or picks, the cloth that they are bound to; None for a cloth, and without one.
    """

    ends: Indices
    picks: Indices
    host: int | None = None

    @property
    def kind(self) -> Literal["cloth", "extra warp", "extra weft"]:
        """A cloth has ends and picks; extra threads have those of their host across them."""
        if self.ends.size and self.picks.size:
            return "cloth"
        return "extra warp" if self.ends.size else "extra weft"


# The systems of each layer from the front; those of one layer are woven as one cloth.
Stack = tuple[tuple[int, ...], ...]


@dataclass(frozen=True, eq=False)
class Layers:
    """The layers of a drawdown.

    Attributes:
        systems: the cloths and extra threads, in the order of their first threads.
        stacks: which system lies upon which, by region; the first takes up most of the cloth.
        regions: uint8 [picks, ends], the index of the stack at each crossing.
    """

    systems: tuple[ThreadSystem, ...]
    stacks: tuple[Stack, ...]
    regions: NDArray[np.uint8]

    @property
    def depth(self) -> int:
        """Layers where most lie upon one another; 1 for cloth of a single layer."""
        return max(len(stack) for stack in self.stacks)

    def shares(self) -> NDArray[np.float64]:
        """Share of the crossings that each stack has, [stacks]."""
        counts = np.bincount(self.regions.ravel(), minlength=len(self.stacks))
        return counts / self.regions.size


def find_layers(warp_up: Bits) -> Layers:
    """The layers of a drawdown; cloth of a single layer has one system, in one region.

    Args:
        warp_up: bool [picks, ends], True where the warp is on top; it repeats.
    """
    ends, picks = warp_up.shape[1], warp_up.shape[0]
    of_end, of_pick = _thread_systems(warp_up)
    if max(of_end.max(initial=-1), of_pick.max(initial=-1)) < 1:
        return single_layer(picks, ends)
    return _stacked(warp_up, _systems(warp_up, of_end, of_pick))


def single_layer(picks: int, ends: int) -> Layers:
    """Cloth of one layer, of so many picks and ends."""
    whole = np.broadcast_to(np.uint8(0), (picks, ends))
    return Layers((ThreadSystem(np.arange(ends), np.arange(picks)),), (((0,),),), whole)


# ----------------------------------------------------------------------------------------- levels in a window


@dataclass(frozen=True, eq=False)
class _Classes:
    """Threads of one level in one window; ends are numbered first, then picks.

    Attributes:
        thread: numbers of threads [k].
        class_: class of each [k].
        window: window of each class [classes].
        share: windows that hold these levels, of all.
    """

    thread: Indices
    class_: Indices
    window: Indices
    share: float


def _classes(warp_up: Bits, side: int) -> _Classes | None:
    """The classes of those windows of about `side` threads that hold the levels that most windows hold.

    None if hardly any window holds several.
    """
    picks, ends = warp_up.shape
    pick_starts, height = _window_starts(picks, side)
    end_starts, width = _window_starts(ends, side)
    columns = (end_starts[:, None] + np.arange(width)) % ends
    rows = (pick_starts[:, None] + np.arange(height)) % picks
    # Of a large draft every few windows, other ones in each row.
    in_row = max(_MIN_IN_ROW, _MAX_WINDOWS // len(rows))
    every = -(-len(columns) // in_row)
    window_count = len(rows) * len(columns[::every])
    # Levels of the windows that hold several: place, of ends, of picks.
    found: list[tuple[int, int, Indices, Indices]] = []
    # Small windows hold by chance what large ones do not.
    least = 0.05 if side > _WINDOWS[-1] else 0.2
    # A few rows of windows tell whether it is worth looking at all.
    trial = range(0, len(rows), max(1, len(rows) // 16))
    for done, down in enumerate([*trial, *sorted(set(range(len(rows))) - set(trial))]):
        if done == len(trial) and len(found) < least / 2 * done * len(columns[::every]):
            return None
        chosen = np.arange(down % every, len(columns), every)
        up = warp_up[rows[down]][:, columns[chosen]].transpose(1, 0, 2).astype(np.float32)
        of_pick, of_end = _levels(1 - up), _levels(up.transpose(0, 2, 1))
        several = (of_pick.max(axis=1) > 0) | (of_end.max(axis=1) > 0)
        found += [(down, int(chosen[at]), of_end[at], of_pick[at]) for at in np.flatnonzero(several)]
    if not found:
        return None
    kinds = Counter((int(of_end.max()) + 1, int(of_pick.max()) + 1) for _, _, of_end, of_pick in found)
    most = max(kinds.values())
    # Levels of both families tell more than those of one; figures and stitches make more here and there.
    kind = max(kinds, key=lambda kind: (min(kind) > 1 and 4 * kinds[kind] >= most, kinds[kind]))
    if kinds[kind] < least * window_count:
        return None
    threads, classes, windows = [], [], []
    count = 0
    for window, (down, across, of_end, of_pick) in enumerate(found):
        if (of_end.max() + 1, of_pick.max() + 1) != kind:
            continue
        up = warp_up[np.ix_(rows[down], columns[across])]
        for number, thread in zip(
            _linked(up, of_end, of_pick), (columns[across], ends + rows[down]), strict=True
        ):
            told = number >= 0
            threads.append(thread[told])
            classes.append(count + number[told])
        here = int(max(part.max(initial=-1) for part in classes[-2:])) + 1 - count
        windows.append(np.full(here, window))
        count += here
    share = kinds[kind] / window_count
    return _Classes(np.concatenate(threads), np.concatenate(classes), np.concatenate(windows), share)


def _window_starts(count: int, side: int) -> tuple[Indices, int]:
    """First threads of windows along one family, and their side: whole repeats where these are small."""
    if count <= side:
        return np.zeros(1, np.intp), count * -(-side // count)
    # Small drafts are seen from more places, as figures of theirs may have few threads.
    step = max(1, side // 4) if count <= 256 else side // 2 if count <= 1024 else side
    return np.arange(0, count, step), side


def _levels(over: NDArray[np.float32]) -> Indices:
    """Levels of the threads of one family, 0 in front [windows, threads].

    Args:
        over: 1 where a thread is on top, else 0 [windows, threads, crossings].
    """
    windows, threads, crossings = over.shape
    level = np.zeros((windows, threads), np.intp)
    times = over.sum(axis=2)
    order = np.argsort(-times, axis=1, kind="stable")
    sorted_times = np.take_along_axis(times, order, axis=1)
    gap = sorted_times[:, :-1] - sorted_times[:, 1:]
    window, last = np.nonzero(gap >= max(2, _MIN_GAP * crossings))
    if window.size == 0:
        return level
    behind = times[window] < sorted_times[window, last][:, None]
    # Levels alternate across the whole window; a figure beside its ground does not.
    alternates = _alternate(behind)
    window, behind = window[alternates], behind[alternates]
    above, below, equal = _near_pairs(over, window, behind)
    told = (below <= _MAX_CONTRARY * above) & (_EQUAL_OF_CONTRARY * below <= equal)
    told &= equal >= _MIN_EQUAL * (above + below + equal)
    np.add.at(level, window[told], behind[told])
    level[level.max(axis=1) >= _MAX_LEVELS] = 0
    return level


def _alternate(behind: Bits) -> Bits:
    """Whether threads of the fewer kind lie among the others all over a window [windows], evenly enough."""
    threads = behind.shape[1]
    count = np.count_nonzero(behind, axis=1)
    few = np.where((2 * count <= threads)[:, None], behind, ~behind)
    count = np.minimum(count, threads - count)
    place = np.arange(threads)
    before = np.maximum.accumulate(np.where(few, place, -1), axis=1)
    # Threads since the last one, up to the next one or the window's edge.
    gap = np.max(
        np.where(few, place - np.roll(before, 1, axis=1), place - before), axis=1, where=place > 0, initial=0
    )
    gap = np.maximum(gap, np.where(few[:, 0], 0, np.argmax(few, axis=1) + 1))
    changes = np.count_nonzero(few[:, 1:] != few[:, :-1], axis=1)
    return (changes >= 3) & (gap * count <= _MAX_UNEVEN * threads)


def _near_pairs(
    over: NDArray[np.float32], window: Indices, behind: Bits
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """How often threads in front are above, below and like those behind beside them, of each split [splits].

    Each thread of the fewer kind is compared with the nearest of the other kind on either side.
    """
    threads, crossings = over.shape[1:]
    # How often a thread is on top where another is not [windows, threads, threads].
    higher = over @ (1 - over).transpose(0, 2, 1)
    place = np.arange(threads)
    few_behind = 2 * np.count_nonzero(behind, axis=1) <= threads
    few = np.where(few_behind[:, None], behind, ~behind)
    before = np.maximum.accumulate(np.where(few, -1, place), axis=1)
    after = np.minimum.accumulate(np.where(few, threads, place)[:, ::-1], axis=1)[:, ::-1]
    of_few, of_other, compared = (np.zeros(len(window)) for _ in range(3))
    for near in (before, after):
        known = few & (near >= 0) & (near < threads)
        other = np.clip(near, 0, threads - 1)
        of_few += np.sum(higher[window[:, None], place, other] * known, axis=1)
        of_other += np.sum(higher[window[:, None], other, place] * known, axis=1)
        compared += crossings * np.count_nonzero(known, axis=1)
    above, below = np.where(few_behind, (of_other, of_few), (of_few, of_other))
    return above, below, compared - above - below


def _linked(up: Bits, of_end: Indices, of_pick: Indices) -> tuple[Indices, Indices]:
    """Classes of one window's ends and picks, numbered together; −1 for a family of one level.

    A level of ends and one of picks are one cloth if they interlace with each other and hardly with others.
    """
    end_levels, pick_levels = int(of_end.max()) + 1, int(of_pick.max()) + 1
    if end_levels == 1:
        return np.full(of_end.shape, -1), of_pick
    if pick_levels == 1:
        return of_end, np.full(of_pick.shape, -1)
    ends, picks = np.eye(end_levels)[of_end], np.eye(pick_levels)[of_pick]
    mean = picks.T @ up @ ends / np.outer(picks.sum(axis=0), ends.sum(axis=0))
    rarer = np.minimum(mean, 1 - mean)
    class_of_end = pick_levels + np.arange(end_levels)
    for end in range(end_levels):
        pick = int(rarer[:, end].argmax())
        others = [*np.delete(rarer[pick], end), *np.delete(rarer[:, end], pick)]
        if rarer[pick, end] >= max(0.04, 2 * max(others)):
            class_of_end[end] = pick
    return class_of_end[of_end], of_pick


# --------------------------------------------------------------------------------------------------- systems


def _thread_systems(warp_up: Bits) -> tuple[Indices, Indices]:
    """The system of each end and pick, from 0; −1 where no window tells."""
    picks, ends = warp_up.shape
    best, best_score = np.full(ends + picks, -1, np.intp), 0.0
    for side in _WINDOWS:
        classes = _classes(warp_up, side)
        if classes is None:
            continue
        found = _propagated(classes, ends + picks)
        # Larger windows err less, unless figures are smaller than they.
        score = classes.share * float(np.mean(found >= 0))
        if score > _MUCH_BETTER * best_score:
            best, best_score = found, score
        if best_score > _GOOD:
            break
    return best[:ends], best[ends:]


def _propagated(classes: _Classes, threads: int) -> Indices:
    """Systems of threads [threads] by majority: of its classes for a thread, of its threads for a class."""
    system = np.full(threads, -1, np.intp)
    class_count = len(classes.window)
    size = np.bincount(classes.class_, minlength=class_count)
    of_class = np.full(class_count, -1, np.intp)
    count = 0
    while count < _MAX_SYSTEMS:
        # A window of the most classes of which nothing is known begins new systems.
        free = np.bincount(classes.class_, system[classes.thread] < 0, class_count) >= 0.8 * size
        free &= of_class < 0
        if not free.any():
            break
        window = np.bincount(classes.window, free).argmax()
        fresh = np.flatnonzero(free & (classes.window == window))[: _MAX_SYSTEMS - count]
        of_class[fresh] = count + np.arange(len(fresh))
        count += len(fresh)
        for _ in range(64):
            found = _majority_of_threads(classes, of_class, (threads, count))
            votes = _votes(classes.class_, found[classes.thread], (class_count, count))
            most, total = votes.max(axis=1), votes.sum(axis=1)
            clear = (total >= np.minimum(3, size)) & (5 * most >= 4 * total)
            told = np.where(clear, votes.argmax(axis=1), np.where(total == 0, of_class, -1))
            _drop_twins(told, most, classes.window)
            if np.array_equal(found, system) and np.array_equal(told, of_class):
                break
            system, of_class = found, told
    return system


def _majority_of_threads(classes: _Classes, of_class: Indices, shape: tuple[int, int]) -> Indices:
    """The system of most classes of each thread [threads], −1 without one; of `shape` threads and systems.

    A class speaks for its system, and against those of the other classes of its window.
    """
    threads, count = shape
    votes = _votes(classes.thread, of_class[classes.class_], shape)
    in_window = _votes(classes.window, of_class, (int(classes.window.max()) + 1, count))
    own = of_class[classes.class_]
    against = np.empty(shape)
    for system in range(count):
        others = in_window[classes.window[classes.class_], system] - (own == system)
        against[:, system] = np.bincount(classes.thread, others, threads)
    net = votes - against
    # Half of the classes that speak at all are enough.
    clear = (net.max(axis=1) > 0) & (2 * net.max(axis=1) >= votes.sum(axis=1))
    return np.where(clear, net.argmax(axis=1), -1)


def _votes(voter: Indices, choice: Indices, shape: tuple[int, int]) -> Indices:
    """How often each voter chose each system, of `shape`; −1 is no choice."""
    told = choice >= 0
    flat = voter[told] * shape[1] + choice[told]
    return np.bincount(flat, minlength=shape[0] * shape[1]).reshape(shape)


def _drop_twins(of_class: Indices, votes: Indices, window: Indices) -> None:
    """Of classes of one window that were taken for the same system, forgets all but the one of most votes."""
    told = np.flatnonzero(of_class >= 0)
    told = told[np.argsort(-votes[told], kind="stable")]
    key = window[told] * _MAX_SYSTEMS + of_class[told]
    first = np.zeros(len(told), bool)
    first[np.unique(key, return_index=True)[1]] = True
    of_class[told[~first]] = -1


def _by_turn(of_thread: Indices) -> Indices:
    """Systems of one family [threads], joined and completed by the turn in which they follow one another.

    Where figures part the cloth, the same threads may have been found twice. Threads in a fixed turn, one of
    each system or two of one and one of another, are of one system.
    """
    told = np.flatnonzero(of_thread >= 0)
    names, system = np.unique(of_thread[told], return_inverse=True)
    threads, count = len(of_thread), len(names)
    apart = _alternating(system, count)
    best: tuple[int, Indices, Indices] | None = None
    for turn in range(2, min(_MAX_TURN, threads // 2) + 1):
        table = _votes(told % turn, system, (turn, count))
        shown = table >= np.maximum(1, 0.15 * table.sum(axis=1, keepdims=True))
        joint = _components(shown.T.astype(np.intp) @ shown.astype(np.intp) > 0)
        if np.any(apart & (joint[:, None] == joint[None])):
            continue
        if best is None or joint.max() < best[1].max():
            best = turn, joint, table
    if best is None:
        return of_thread
    turn, joint, table = best
    # The smallest number of each joint stands for it.
    first = np.array([names[joint == one].min() for one in joint])
    of_turn = first[table.argmax(axis=1)]
    of_turn[table.sum(axis=1) == 0] = -1
    found = of_turn[np.arange(threads) % turn]
    # Few threads out of turn are mistakes; many are an order that has no turn.
    if np.count_nonzero(found[told] != first[system]) > _MAX_OUT_OF_TURN * len(told):
        found[told] = first[system]
    return found


def _alternating(system: Indices, count: int) -> Bits:
    """Which systems lie among one another, bool [count, count], of the systems of threads in their order."""
    apart = np.zeros((count, count), bool)
    for one in range(count):
        for other in range(one):
            alone = system[(system == one) | (system == other)]
            changes = np.count_nonzero(alone != np.roll(alone, 1))
            fewer = min(np.count_nonzero(alone == one), np.count_nonzero(alone == other))
            # In turns of up to six of each; a figure has more.
            apart[one, other] = apart[other, one] = 3 * changes >= fewer
    return apart


def _components(linked: Bits) -> Indices:
    """The component of each node of a symmetric graph, bool [n, n], from 0."""
    reach = linked | np.eye(len(linked), dtype=bool)
    for _ in range(len(linked).bit_length()):
        reach = reach.astype(np.intp) @ reach.astype(np.intp) > 0
    return np.unique(reach.argmax(axis=1), return_inverse=True)[1]


def _systems(warp_up: Bits, of_end: Indices, of_pick: Indices) -> list[ThreadSystem]:
    """The systems that have these threads, in the order of their first ones; threads of none go to a host."""
    of_end, of_pick = of_end.copy(), of_pick.copy()
    for of_family in (of_end, of_pick):
        if np.any(of_family >= 0):
            before = of_family.copy()
            of_family[:] = _by_turn(of_family)
            for old in np.unique(before[before >= 0]):
                new = of_family[before == old][0]
                of_end[of_end == old] = new
                of_pick[of_pick == old] = new
    # Threads that nowhere lie upon others of their family are the host's; without one, the cloth's.
    for of_family, of_other, up in ((of_end, of_pick, warp_up), (of_pick, of_end, warp_up.T)):
        untold = np.flatnonzero(of_family < 0)
        if untold.size == 0:
            continue
        known = np.unique(of_other[of_other >= 0])
        interlaced = []
        for system in known:
            mean = float(up[of_other == system][:, untold].mean())
            interlaced.append((round(min(mean, 1 - mean), 2), np.count_nonzero(of_other == system)))
        of_family[untold] = known[max(range(len(known)), key=lambda at: interlaced[at])] if known.size else 0
    found = []
    for system in sorted(
        set(of_end.tolist()) | set(of_pick.tolist()),
        key=lambda system: [np.flatnonzero(np.append(of == system, True))[0] for of in (of_end, of_pick)],
    ):
        found.append(ThreadSystem(np.flatnonzero(of_end == system), np.flatnonzero(of_pick == system)))
    return found


# ----------------------------------------------------------------------------------------------------- order


def _stacked(warp_up: Bits, systems: list[ThreadSystem]) -> Layers:
    """Layers of these systems, of which those that are woven as one everywhere are joined."""
    systems = _joined_where_no_order(warp_up, systems)
    if len(systems) == 1:
        return single_layer(*warp_up.shape)
    count = len(systems)
    pairs = [(i, j) for i in range(count) for j in range(i + 1, count)]
    # Orders of all pairs at each crossing, as a number to base 3 that is kept small.
    code = np.zeros(warp_up.shape, np.uint16)
    known: list[tuple[int, ...]] = [()]
    for i, j in pairs:
        evidence = _Evidence(warp_up, systems[i], systems[j])
        joined = sum(int(np.count_nonzero(order == 0)) for _, order in evidence.orders())
        # What is woven as one at few crossings is the corner of figures that meet there.
        evidence.can_join = joined >= _MIN_SHARE * warp_up.size
        here = [(*orders, order) for orders in known for order in (-1, 0, 1)]
        counts = np.zeros(len(here), np.int64)
        for rows, order in evidence.orders():
            code[rows] = 3 * code[rows] + (order + 1)
            counts += np.bincount(code[rows].ravel(), minlength=len(here))
        kept = np.flatnonzero(counts)
        renamed = np.zeros(len(here), np.uint16)
        renamed[kept] = np.arange(len(kept))
        code = renamed[code]
        known = [here[at] for at in kept]
        shares = counts[kept]
    stacks = [
        _stack_of(count, pairs, orders) if share >= _MIN_SHARE * code.size else None
        for orders, share in zip(known, shares, strict=True)
    ]
    ranked = sorted((at for at, stack in enumerate(stacks) if stack), key=lambda at: -int(shares[at]))
    clear = sum(int(shares[at]) for at in ranked)
    if 2 * clear < code.size:
        return single_layer(*warp_up.shape)
    # An order of few crossings, or that no stack has, is that of an edge: it becomes the one most like it.
    table = np.zeros(len(known), np.uint8)
    chosen: list[Stack] = []
    for at in ranked:
        stack = stacks[at]
        assert stack is not None
        if stack not in chosen:
            chosen.append(stack)
        table[at] = chosen.index(stack)
    for at, stack in enumerate(stacks):
        if stack is None:
            like = min(
                ranked, key=lambda other: sum(a != b for a, b in zip(known[at], known[other], strict=True))
            )
            table[at] = table[like]
    regions = _by_floats(warp_up, systems, chosen, table[code])
    return Layers(tuple(_hosted(warp_up, systems)), tuple(chosen), regions)


def _by_floats(
    warp_up: Bits, systems: list[ThreadSystem], stacks: list[Stack], regions: NDArray[np.uint8]
) -> NDArray[np.uint8]:
    """The regions, without threads at their rims that float there and interlace in the layers beside.

    Where all threads weave as one, a pick of one of the cloths may lie over all ends of the other, as it does
    where that lies behind: only its own cloth, in which it would float from rim to rim, tells.
    """
    group = np.zeros((len(stacks), len(systems)), np.int8)
    for stack, groups in enumerate(stacks):
        for number, members in enumerate(groups):
            group[stack, list(members)] = number
    # Where cloths but change places, threads interlace with the same ones.
    same = group[:, :, None] == group[:, None]
    if (same == same[0]).all():
        return regions
    of_end, of_pick = (np.zeros(count, np.intp) for count in warp_up.shape[::-1])
    for number, system in enumerate(systems):
        of_end[system.ends], of_pick[system.picks] = number, number
    for _ in range(_MAX_RIM):
        mended = _mended_rims(warp_up, group[:, of_pick], group[:, of_end], regions)
        mended = _mended_rims(warp_up.T, group[:, of_end], group[:, of_pick], mended.T).T
        if np.array_equal(mended, regions):
            break
        regions = mended
    return np.ascontiguousarray(regions)


def _mended_rims(
    up: Bits, of_row: NDArray[np.int8], of_column: NDArray[np.int8], regions: NDArray[np.uint8]
) -> NDArray[np.uint8]:
    """Regions without rows of crossings at their rims in which a row's thread only floats.

    Args:
        up: crossings, with the threads that may float along the second axis.
        of_row, of_column: layer of each thread in each stack [stacks, threads].
    """
    mended = regions.copy()
    for step in (1, -1):
        beside = np.roll(regions, step, axis=0)
        row, column = np.nonzero(regions != beside)
        if row.size == 0:
            continue
        here, there = regions[row, column], beside[row, column]
        apart = (np.diff(row) != 0) | (np.diff(column) != 1) | (np.diff(here) != 0) | (np.diff(there) != 0)
        part = np.concatenate([[0], np.cumsum(apart)])
        longest = [
            _longest_floats(part, up[row, column], of_row[stack, row] == of_column[stack, column])
            for stack in (here, there)
        ]
        floats = (longest[0] >= _LONG_FLOAT) & (longest[0] > _MUCH_LONGER * longest[1]) & (longest[1] > 0)
        moved = floats[part]
        mended[row[moved], column[moved]] = there[moved]
    return mended


def _longest_floats(part: Indices, up: Bits, own: Bits) -> Indices:
    """Threads under the longest float of each part [parts], of crossings in order, by those of its own layer.

    Args:
        part: of each crossing, rising from 0.
        own: whether both threads lie in one layer.
    """
    of_part, value = part[own], up[own]
    begins = np.flatnonzero(np.concatenate([[True], (np.diff(of_part) != 0) | (value[1:] != value[:-1])]))
    longest = np.zeros(int(part[-1]) + 1, np.intp)
    if of_part.size:
        np.maximum.at(longest, of_part[begins], np.diff(np.append(begins, of_part.size)))
    return longest


def _stack_of(count: int, pairs: list[tuple[int, int]], orders: tuple[int, ...]) -> Stack | None:
    """The stack of systems whose pairs have these orders; None if there is none."""
    above = np.zeros((count, count), bool)
    joined = np.eye(count, dtype=bool)
    for (i, j), order in zip(pairs, orders, strict=True):
        joined[i, j] = joined[j, i] = order == 0
        above[i, j], above[j, i] = order > 0, order < 0
    group = _components(joined)
    groups = int(group.max()) + 1
    member = np.eye(groups, dtype=np.intp)[group]
    higher = member.T @ above @ member > 0
    if np.any(higher & higher.T) or np.any(np.diag(higher)):
        return None
    rank = np.count_nonzero(higher, axis=0)
    if len(set(rank.tolist())) < groups:
        return None
    return tuple(tuple(np.flatnonzero(group == at).tolist()) for at in np.argsort(rank))


def _joined_where_no_order(warp_up: Bits, systems: list[ThreadSystem]) -> list[ThreadSystem]:
    """The systems, of which two are joined if hardly a crossing of theirs tells an order."""
    count = len(systems)
    joined = np.eye(count, dtype=bool)
    for i in range(count):
        for j in range(i + 1, count):
            share = _Evidence(warp_up, systems[i], systems[j]).ordered_share()
            joined[i, j] = joined[j, i] = share < _MIN_ORDERED
    group = _components(joined)
    return [
        ThreadSystem(
            np.sort(np.concatenate([systems[at].ends for at in np.flatnonzero(group == one)])),
            np.sort(np.concatenate([systems[at].picks for at in np.flatnonzero(group == one)])),
        )
        for one in dict.fromkeys(group.tolist())
    ]


def _hosted(warp_up: Bits, systems: list[ThreadSystem]) -> list[ThreadSystem]:
    """The systems; those of one family with the cloth that they interlace with most."""
    hosted = []
    cloths = [at for at, system in enumerate(systems) if system.kind == "cloth"]
    for system in systems:
        host = None
        if system.kind != "cloth" and cloths:

            def interlaced(cloth: int, system: ThreadSystem = system) -> float:
                across = systems[cloth]
                rows, columns = (
                    (system.picks, across.ends) if system.picks.size else (across.picks, system.ends)
                )
                mean = float(warp_up[np.ix_(rows, columns)].mean())
                return min(mean, 1 - mean)

            host = max(cloths, key=interlaced)
        hosted.append(replace(system, host=host))
    return hosted


class _Evidence:
    """What crossings say of the order of two systems, and the order that follows from those around."""

    def __init__(self, warp_up: Bits, one: ThreadSystem, other: ThreadSystem) -> None:
        self.warp_up = warp_up
        self.can_join = True
        picks, ends = warp_up.shape
        self.of_end, self.of_pick = np.zeros(ends, np.int8), np.zeros(picks, np.int8)
        for mark, system in ((1, one), (2, other)):
            self.of_end[system.ends] = mark
            self.of_pick[system.picks] = mark
        kinds = {one.kind, other.kind}
        # Ends of a host bind extra picks, so that crossings with them say less than picks beside them.
        self.by_picks = "extra weft" in kinds and bool(one.picks.size and other.picks.size)
        self.by_ends = "extra warp" in kinds and bool(one.ends.size and other.ends.size) and not self.by_picks
        self.height = _evidence_side([one.picks, other.picks], picks)
        self.width = _evidence_side([one.ends, other.ends], ends)
        self.near = [
            _nearest(self.of_pick if self.by_picks else self.of_end, step)
            for step in (1, -1)
            if self.by_picks or self.by_ends
        ]

    def orders(self) -> Iterator[tuple[slice, NDArray[np.int8]]]:
        """By strips of picks: 1 where the first system lies above, −1 below, 0 where they are one cloth."""
        for first in range(0, len(self.warp_up), ROWS_AT_ONCE):
            rows = slice(first, min(len(self.warp_up), first + ROWS_AT_ONCE))
            yield rows, self._order(rows)

    def _order(self, rows: slice) -> NDArray[np.int8]:
        height, width = self.height, self.width
        margin = 2 * height + 2
        picks = len(self.warp_up)
        around = np.arange(rows.start - margin, rows.stop + margin) % picks
        above, below = self._votes(around)
        for_one, for_other = (_box(votes, height // 2, width // 2) for votes in (above, below))
        lead, total = for_one - for_other, for_one + for_other
        unclear = (3 * np.abs(lead) < total) & (total > 0)
        inner = slice(margin, margin + rows.stop - rows.start)
        wide_lead = _box(above - below, height, width)[inner]
        order = np.sign(np.where(lead[inner] != 0, lead[inner], wide_lead)).astype(np.int8)
        if self.can_join and unclear.any():
            share = _box(unclear.astype(np.int8), height, width)[inner]
            among = _box((total > 0).astype(np.int8), height, width)[inner]
            order[share > 0.55 * among] = 0
        return order

    def ordered_share(self) -> float:
        """Share of blocks, of the two systems' picks and ends, that tell an order; 0 if it is a patchwork."""
        picks, ends = self.warp_up.shape
        strip = max(1, ROWS_AT_ONCE // self.height) * self.height
        orders, told = [], 0
        for first in range(0, picks, strip):
            rows = np.arange(first, min(picks, first + strip))
            above, below = (
                np.add.reduceat(
                    np.add.reduceat(votes, np.arange(0, len(rows), self.height), axis=0, dtype=np.int32),
                    np.arange(0, ends, self.width),
                    axis=1,
                )
                for votes in self._votes(rows)
            )
            clear = 3 * np.abs(above - below) >= np.maximum(1, above + below)
            orders.append(np.sign(above - below) * clear)
            told += int(np.count_nonzero(above + below))
        order = np.concatenate(orders)
        ordered = np.count_nonzero(order)
        # Of neighbours of a block with an order, those with the same.
        same = sum(np.count_nonzero((order == np.roll(order, 1, axis)) & (order != 0)) for axis in (0, 1))
        return ordered / max(1, told) if same >= _MIN_LIKE * 2 * ordered else 0.0

    def _votes(self, around: Indices) -> tuple[NDArray[np.int8], NDArray[np.int8]]:
        """1 where a crossing says that the first system lies above, and where it says below."""
        up = self.warp_up[around]
        if self.by_picks:
            return self._beside(
                ~up,
                ~self.warp_up[self.near[0]][around],
                ~self.warp_up[self.near[1]][around],
                (self.of_pick[around] == 1)[:, None],
            )
        if self.by_ends:
            return self._beside(up, up[:, self.near[0]], up[:, self.near[1]], (self.of_end == 1)[None])
        pick, end = self.of_pick[around][:, None], self.of_end[None]
        first_end, second_end = (end == 1) & (pick == 2), (end == 2) & (pick == 1)
        return (
            ((first_end & up) | (second_end & ~up)).astype(np.int8),
            ((first_end & ~up) | (second_end & up)).astype(np.int8),
        )

    @staticmethod
    def _beside(
        over: Bits, after: Bits, before: Bits, is_first: Bits
    ) -> tuple[NDArray[np.int8], NDArray[np.int8]]:
        above = ((over & ~after).astype(np.int8) + (over & ~before)) * is_first
        below = ((~over & after).astype(np.int8) + (~over & before)) * is_first
        return above, below


def _nearest(mark: NDArray[np.int8], step: int) -> Indices:
    """For each thread of the first system the nearest of the second, after it (step 1) or before it (−1)."""
    threads = len(mark)
    second = np.flatnonzero(mark == 2)
    place = np.arange(threads)
    after = second[np.searchsorted(second, place) % len(second)]
    return after if step > 0 else second[np.searchsorted(second, place) - 1]


def _evidence_side(families: list[Indices], threads: int) -> int:
    """Threads, an even number, among which two of either system lie."""
    gaps = [np.median(np.diff(family)) for family in families if family.size > 1]
    return min(2 * round(max([2.0, *gaps])), 2 * max(1, threads // 2))


def _box(values: NDArray[np.int8], down: int, across: int) -> NDArray[np.integer]:
    """Sums around each value [rows, columns]: `down` and `across` to either side, those at the rim half.

    Columns repeat. Rows do not: the first and last `down` are of no use. Sums are twice as large.
    """
    rows, columns = values.shape
    # Four times the values, of at most 2, in a window.
    small = 32 * down * across < np.iinfo(np.int16).max
    padded = np.pad(values, ((down, down), (0, 0))).astype(np.int16 if small else np.int32)
    of_rows = _running(padded, 2 * down)
    of_rows = of_rows[:rows] + of_rows[1 : rows + 1]
    wrapped = of_rows[:, np.arange(-across, columns + across) % columns]
    of_columns = _running(wrapped.T, 2 * across).T
    return of_columns[:, :columns] + of_columns[:, 1 : columns + 1]


def _running(values: NDArray, length: int) -> NDArray:
    """Sums of `length` rows from each row on, by sums of 1, 2, 4 … of them."""
    count = len(values) - length + 1
    total, power, size, start = None, values, 1, 0
    while length:
        if length & 1:
            part = power[start : start + count]
            total = part if total is None else total + part
            start += size
        length >>= 1
        if length:
            power, size = power[:-size] + power[size:], 2 * size
    assert total is not None
    return total


# ----------------------------------------------------------------------- layers that no thread binds together
#
# Lifting a thread lifts every thread above it. A drawdown falls apart where some ends and picks can be lifted
# off all others; since every end of a repeat crosses every pick, one repeat does so as endless cloth does.


def layer_sizes(warp_up: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Ends and picks of each layer of a drawdown, from the top; threads that never interlace are in none.

    Let t ends and s of m picks be lifted off. Those ends pass over all m − s other picks, and those picks are
    below no other end, so that Σ (picks below those ends) − Σ (ends above those picks) = t·(m − s), which no
    other choice exceeds. Hence the ends that pass over most picks and the picks below fewest ends tell.

    Source: C. R. J. Clapham, When a fabric hangs together, Bull. London Math. Soc. 12 (1980).
    """
    picks, ends = warp_up.shape
    below_end = np.sort(np.count_nonzero(warp_up, axis=0))
    above_pick = np.sort(np.count_nonzero(warp_up, axis=1))
    lifted = np.arange(picks + 1)
    # Ends that pass over more than the other picks, and over as many: the latter lie upon them, or are loose.
    least = ends - np.searchsorted(below_end, picks - lifted, side="right")
    most = ends - np.searchsorted(below_end, picks - lifted, side="left")
    of_ends = np.concatenate([[0], np.cumsum(below_end[::-1])])[least]
    of_picks = np.concatenate([[0], np.cumsum(above_pick)])
    apart = np.flatnonzero(of_ends - of_picks == least * (picks - lifted))
    sizes = zip((least[apart[1:]] - most[apart[:-1]]).tolist(), np.diff(apart).tolist(), strict=True)
    return [(of_layer, in_layer) for of_layer, in_layer in sizes if of_layer > 0 and in_layer > 0]


def warn_of_layers(warp_up: NDArray[np.bool_], file: str) -> None:
    """Warns in a sentence, which begins with the file, of a drawdown that holds layers."""
    sizes = layer_sizes(warp_up)
    if len(sizes) > 1:
        (ends, picks), (under_ends, under_picks) = sizes[:2]
        warnings.warn(
            f"{file} holds {len(sizes)} layers of cloth that no thread binds together ({ends} ends and "
            f"{picks} picks lie above {under_ends} ends and {under_picks} picks); neural "
            "and clustered do not take it, and pages without Python show a single plane.",
            LoomlightWarning,
            stacklevel=3,
        )
