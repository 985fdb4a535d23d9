"""Looms: the drawdown of a threading, a tie-up and a treadling, and a plan that weaves a given drawdown."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields, replace

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.weave.draft import MAXIMUM_THREADS, Draft, LoomPlan, Threads


def membership(sets: Sequence[frozenset[int]], count: int) -> NDArray[np.bool_]:
    """Sets of 1-based numbers as bool [len(sets), count]; numbers above `count` are left out."""
    table = np.zeros((len(sets), count), dtype=bool)
    for row, members in zip(table, sets, strict=True):
        numbers = np.fromiter(members, np.intp, len(members))
        row[numbers[numbers <= count] - 1] = True
    return table


def moved_shafts(plan: LoomPlan) -> NDArray[np.bool_]:
    """Which shafts each pick moves, bool [picks, shafts]; by the treadles if there are any.

    Raises:
        InputError: a plan with neither a liftplan nor tie-up and treadling.
    """
    if plan.tieup is not None and plan.treadling is not None:
        pressed = membership(plan.treadling, len(plan.tieup))
        return _any_product(pressed, membership(plan.tieup, plan.shafts))
    if plan.liftplan is None:
        raise InputError("The loom plan has neither a liftplan nor a tie-up with a treadling.")
    return membership(plan.liftplan, plan.shafts)


def plan_drawdown(plan: LoomPlan) -> NDArray[np.bool_]:
    """The drawdown that the plan weaves, bool [picks, ends], True where the warp is on top.

    An end is up on a rising shed if any of its shafts is lifted, and on a sinking shed unless any of its
    shafts is lowered; an end on no shaft stays down on the former and up on the latter.
    """
    moved = moved_shafts(plan)
    if all(len(shafts) <= 1 for shafts in plan.threading):
        # One shaft an end, as nearly every draft has it: copying columns spares a large product.
        padded = np.pad(moved, ((0, 0), (1, 0)))
        on_shaft = padded.take([max(shafts, default=0) for shafts in plan.threading], axis=1)
    else:
        on_shaft = _any_product(moved, membership(plan.threading, plan.shafts).T)
    return on_shaft if plan.rising_shed else ~on_shaft


def _any_product(left: NDArray[np.bool_], right: NDArray[np.bool_]) -> NDArray[np.bool_]:
    columns = right.astype(np.float32)
    product = np.empty((len(left), right.shape[1]), dtype=bool)
    # By parts: single precision takes four times the memory of the result.
    for first in range(0, len(left), _ROWS_AT_ONCE):
        rows = slice(first, first + _ROWS_AT_ONCE)
        product[rows] = left[rows].astype(np.float32) @ columns > 0
    return product


def derive_loom_plan(draft: Draft, shaft_limit: int | None = None) -> LoomPlan:
    """A plan for a rising shed that weaves the draft: equal ends share a shaft, equal picks a treadle.

    Shafts and treadles are numbered as they first occur. Where far more kinds of picks than shafts are
    needed the plan is a liftplan.

    Args:
        draft: any draft; its own plan, if there is one, is not looked at.
        shaft_limit: the most shafts there are; None for as many as are needed.

    Raises:
        InputError: more shafts are needed than there are, or more lifts than a file of a draft holds.
    """
    shaft_of_end, shed_ends = _in_order_of_occurrence(draft.drawdown.T)
    treadle_of_pick, shed_picks = _in_order_of_occurrence(draft.drawdown)
    shafts = len(shed_ends)
    if shaft_limit is not None and shafts > shaft_limit:
        raise InputError(
            f"The draft needs {shafts} shafts, since so many of its ends differ; "
            f"at most {shaft_limit} are allowed."
        )
    threading = tuple(frozenset({int(shaft) + 1}) for shaft in shaft_of_end)
    # sheds[treadle, shaft]: whether each kind of pick lifts the first end of each kind.
    sheds = draft.drawdown[np.ix_(shed_picks, shed_ends)]
    lifts_of_treadle = sheds.sum(axis=1)
    is_liftplan = len(sheds) > max(shafts, _TREADLES_AT_HAND)
    count = int(lifts_of_treadle[treadle_of_pick].sum() if is_liftplan else lifts_of_treadle.sum())
    if count > MAX_LIFTS:
        raise InputError(
            f"The draft needs {shafts} shafts and a plan of {count / 1e6:.0f} million lifts; a weaving "
            f"information file that is read again has {MAX_LIFTS / 1e6:.0f} million: keep it as a picture."
        )
    lifts = tuple(frozenset((np.flatnonzero(row) + 1).tolist()) for row in sheds)
    if is_liftplan:
        liftplan = tuple(lifts[treadle] for treadle in treadle_of_pick)
        return LoomPlan(threading=threading, shafts=shafts, liftplan=liftplan)
    return LoomPlan(
        threading=threading,
        shafts=shafts,
        treadles=len(lifts),
        tieup=lifts,
        treadling=tuple(frozenset({int(treadle) + 1}) for treadle in treadle_of_pick),
    )


_ROWS_AT_ONCE = 1024
# Shafts named by a liftplan, or by a tie-up: some 60 MB of text. Such files are read up to 64 MiB.
MAX_LIFTS = 12_000_000
# With more kinds of picks than both shafts and this, a treadling only repeats the liftplan at length.
_TREADLES_AT_HAND = 16


def _in_order_of_occurrence(rows: NDArray[np.bool_]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """For each row, the number of its kind; for each kind, its first row."""
    packed = np.packbits(rows, axis=1)
    kinds: dict[bytes, int] = {}
    number = np.array([kinds.setdefault(row.tobytes(), len(kinds)) for row in packed], dtype=np.intp)
    _, first = np.unique(number, return_index=True)
    return number, first


def with_loom_plan(draft: Draft, shaft_limit: int | None = None) -> Draft:
    """The draft with a loom plan: its own, or a derived one.

    Raises:
        InputError: more shafts are needed than `shaft_limit`.
    """
    return draft if draft.loom is not None else replace(draft, loom=derive_loom_plan(draft, shaft_limit))


def plan_that_weaves(draft: Draft) -> LoomPlan:
    """The draft's own loom plan if that weaves its drawdown, else a derived one.

    Raises:
        InputError: a derived one has more lifts than a file of a draft holds.
    """
    if draft.loom is not None:
        woven = plan_drawdown(draft.loom)
        if woven.shape == draft.drawdown.shape and np.array_equal(woven, draft.drawdown):
            return draft.loom
    return derive_loom_plan(draft)


def warped(draft: Draft, ends: int | None = None, picks: int | None = None) -> Draft:
    """The draft over so many ends and picks: its repeat over and over, the last time cut off.

    Args:
        ends: of the warp, 1 to 16384; None for one repeat.
        picks: of the cloth, likewise.

    Raises:
        InputError: a number out of range.
    """
    for name, count in (("ends", ends), ("picks", picks)):
        if count is not None and not 1 <= count <= MAXIMUM_THREADS:
            raise InputError(f"{count} {name} are out of range: write 1 to {MAXIMUM_THREADS}.")
    if (ends or draft.ends, picks or draft.picks) == (draft.ends, draft.picks):
        return draft
    end = np.arange(ends or draft.ends) % draft.ends
    pick = np.arange(picks or draft.picks) % draft.picks
    loom = draft.loom

    def chosen(sets: tuple[frozenset[int], ...] | None) -> tuple[frozenset[int], ...] | None:
        return None if sets is None else tuple(sets[at] for at in pick.tolist())

    if loom is not None:
        loom = replace(
            loom,
            threading=tuple(loom.threading[at] for at in end.tolist()),
            treadling=chosen(loom.treadling),
            liftplan=chosen(loom.liftplan),
        )
    return replace(
        draft,
        drawdown=draft.drawdown[np.ix_(pick, end)],
        warp=_of_order(draft.warp, end),
        weft=_of_order(draft.weft, pick),
        loom=loom,
    )


def _of_order(threads: Threads, order: NDArray[np.intp]) -> Threads:
    values = {field.name: getattr(threads, field.name) for field in fields(threads)}
    return Threads(**{name: None if value is None else value[order] for name, value in values.items()})
