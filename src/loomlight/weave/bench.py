"""Lists that a weaver works from: heddles a shaft, the threading, the treadling; as plain text."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import to_hex
from loomlight.core.errors import InputError
from loomlight.weave.draft import Draft, LoomPlan
from loomlight.weave.loom import plan_that_weaves

_MAX_GROUP = 100


def heddle_counts(plan: LoomPlan) -> list[int]:
    """Heddles on each shaft, from shaft 1: an end on several shafts has one on each of them."""
    counts = np.zeros(plan.shafts + 1, np.intp)
    for shafts in plan.threading:
        counts[list(shafts)] += 1
    found: list[int] = counts[1:].tolist()
    return found


def heddle_text(draft: Draft) -> str:
    """Heddle counts of a warp, a line a shaft."""
    plan = plan_that_weaves(draft)
    counts = heddle_counts(plan)
    lines = [f"{_title(draft)}: {_counted(draft.ends, 'end')} on {_counted(plan.shafts, 'shaft')}"]
    digits = len(str(plan.shafts)), len(str(max(counts, default=0)))
    for shaft, count in enumerate(counts, start=1):
        lines.append(f"shaft {shaft:{digits[0]}}: {count:{digits[1]}} heddles")
    lines.append(f"in all: {_counted(sum(counts), 'heddle')}")
    loose = sum(not shafts for shafts in plan.threading)
    if loose:
        lines.append(f"on no shaft: {_counted(loose, 'end')}")
    return "\n".join(lines)


def threading_text(draft: Draft, group: int = 8) -> str:
    """The threading from end 1, `group` ends a line: numbers of the ends, their shafts, their colours.

    An end on several shafts reads 1+3, one on none -. Lines that repeat are written out, as they are ticked
    off one by one.

    Raises:
        InputError: a group outside 1 to 100.
    """
    plan = plan_that_weaves(draft)
    head = f"Threading of {_title(draft)}: {_counted(draft.ends, 'end')} on {_counted(plan.shafts, 'shaft')}"
    return "\n".join([head, *_listed(plan.threading, draft.warp.colors, group, "ends")])


def treadling_text(draft: Draft, group: int = 8) -> str:
    """The tie-up, and the treadling from pick 1; or the shafts that each pick lifts.

    Raises:
        InputError: a group outside 1 to 100.
    """
    plan = plan_that_weaves(draft)
    moves = "lifts" if plan.rising_shed else "lowers"
    head = f"{_title(draft)}: {_counted(draft.picks, 'pick')}"
    if plan.tieup is None or plan.treadling is None:
        assert plan.liftplan is not None  # a plan that weaves has one or the other
        lines = [f"Lift plan of {head}; each {moves} these shafts"]
        return "\n".join([*lines, *_listed(plan.liftplan, draft.weft.colors, 1, "picks", " ")])
    lines = [f"Tie-up of {_title(draft)}"]
    for treadle, shafts in enumerate(plan.tieup, start=1):
        lines.append(f"treadle {treadle} {moves} {_numbers(shafts, ' ')}")
    lines += ["", f"Treadling of {head} on {_counted(len(plan.tieup), 'treadle')}"]
    return "\n".join([*lines, *_listed(plan.treadling, draft.weft.colors, group, "picks")])


def _title(draft: Draft) -> str:
    return " ".join(draft.title.split()) or "untitled"


def _counted(count: int, name: str) -> str:
    return f"{count} {name}{'' if count == 1 else 's'}"


def _numbers(members: frozenset[int], joint: str) -> str:
    return joint.join(map(str, sorted(members))) or "-"


def _listed(
    sets: Sequence[frozenset[int]],
    colors: NDArray[np.float64] | None,
    group: int,
    threads: str,
    joint: str = "+",
) -> Iterator[str]:
    """A line for so many threads: which they are, the numbers of each, and runs of their colours."""
    if not 1 <= group <= _MAX_GROUP:
        raise InputError(f"{group} {threads} a line are out of range: write 1 to {_MAX_GROUP}.")
    digits = len(str(len(sets)))
    columns = [_numbers(members, joint) for members in sets]
    width = max(map(len, columns))
    side = "<" if group == 1 else ">"
    names = None if colors is None else [to_hex(color) for color in colors]
    for first in range(0, len(sets), group):
        last = min(first + group, len(sets))
        which = f"{first + 1:{digits}}" if group == 1 else f"{first + 1:{digits}}-{last:<{digits}}"
        line = f"{which}  " + " ".join(f"{column:{side}{width}}" for column in columns[first:last])
        if names is not None:
            runs = ((len(list(run)), name) for name, run in groupby(names[first:last]))
            missing = (group - (last - first)) * (width + 1)
            line += " " * (missing + 2) + ", ".join(f"{count} {name}" for count, name in runs)
        yield line.rstrip()
