"""Reads weaving information files (WIF 1.1, and variants that programs write) into drafts.

What the specification leaves open is decided here:

- A draft has as many ends as [THREADING] lists, whatever [WARP] Threads declares beyond that: such threads
  are placeholders of an unfinished draft. Picks likewise.
- Where [LIFTPLAN] stands beside [TIEUP] and [TREADLING], the treadling is woven; if they differ, a warning
  says so, and both are kept. Picks that the treadling leaves empty and the liftplan lifts are the liftplan's.
- What no thread needs may be wrong and is passed over with a warning: a default or a unit that nothing uses,
  colours that no thread has, the plan that is not woven.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.weave.draft import MAXIMUM_THREADS, Draft, LoomPlan
from loomlight.weave.layers import warn_of_layers
from loomlight.weave.loom import moved_shafts, plan_drawdown
from loomlight.weave.wif_source import Entries, WifSource
from loomlight.weave.wif_text import WifText, read_wif_text, shortened
from loomlight.weave.wif_threads import (
    defaults_count_from_zero,
    read_family,
    read_palette,
    warn_of_thick_threads,
)
from loomlight.weave.wif_values import integer, number_set, thread_number, without_comment, yes_or_no

# Keys that this module interprets, by section; None for every key of the section.
_INTERPRETED: dict[str, set[str] | None] = {
    "CONTENTS": None,
    "NOTES": None,
    "THREADING": None,
    "TIEUP": None,
    "TREADLING": None,
    "LIFTPLAN": None,
    "COLOR TABLE": None,
    "COLOR PALETTE": {"RANGE", "ENTRIES"},
    "WIF": set(),
    "TEXT": {"TITLE"},
    "WEAVING": {"SHAFTS", "TREADLES", "RISING SHED"},
    **{family: {"THREADS", "COLOR", "UNITS", "SPACING", "THICKNESS"} for family in ("WARP", "WEFT")},
    **{
        f"{family} {what}": None for family in ("WARP", "WEFT") for what in ("COLORS", "SPACING", "THICKNESS")
    },
}


def read_wif(path: str | os.PathLike[str]) -> Draft:
    """The draft in a weaving information file.

    Lengths become millimetres and colours linear RGB. Notes, private sections and whatever else says
    nothing about the cloth are kept in `Draft.notes` and `Draft.source`, so that `write_wif` loses nothing.

    Raises:
        InputError: the file cannot be read or used; the message names section, key and value.

    Warns:
        LoomlightWarning: a value that is passed over.

    Source: Weaving Information File specification 1.1, 20 April 1997.
    """
    return draft_of(read_wif_text(Path(path)))


def draft_of(text: WifText) -> Draft:
    """The draft that the sections of a file describe; see `read_wif`."""
    declared = {family: _declared_threads(text, family) for family in ("WARP", "WEFT")}
    loom = _read_loom(text, declared)
    palette, color_range = read_palette(text)
    ends, picks = len(loom.threading), len(loom.treadling or loom.liftplan or ())
    first_default = 0 if defaults_count_from_zero(text, palette) else 1
    warp, warp_defaults = read_family(text, "WARP", ends, palette, first_default)
    weft, weft_defaults = read_family(text, "WEFT", picks, palette, first_default)
    warn_of_thick_threads(text, warp, weft)
    drawdown = plan_drawdown(loom)
    warn_of_layers(drawdown, text.file)
    return Draft(
        drawdown=drawdown,
        warp=warp,
        weft=weft,
        title=text.value("TEXT", "Title"),
        loom=loom,
        palette=palette,
        notes=_notes(text),
        source=WifSource(
            warp=replace(warp_defaults, threads=declared["WARP"]),
            weft=replace(weft_defaults, threads=declared["WEFT"]),
            color_range=color_range,
            entries=_other_entries(text),
            sections=_other_sections(text),
        ),
    )


# ---------------------------------------------------------------------------------------------- the loom


def _declared_threads(text: WifText, family: str) -> int | None:
    value = text.value(family, "Threads")
    if not without_comment(value):
        return None
    return integer(text, family, "Threads", value, 1, MAXIMUM_THREADS, "a number of threads")


def _read_sets(
    text: WifText, section: str, of: str, what: str, unused: str = ""
) -> dict[int, frozenset[int]]:
    """Sets by number; nothing, with a warning, of a faulty section that is `unused` for the reason given."""
    try:
        return {
            thread_number(text, section, key, value, f"the number of {of}"): number_set(
                text, section, key, value, what
            )
            for key, value in text.items(section)
        }
    except InputError as fault:
        if not unused:
            raise
        warnings.warn(
            f"{str(fault)[:-1]}; it is passed over, since {unused}.", LoomlightWarning, stacklevel=2
        )
        return {}


def _read_loom(text: WifText, declared: Mapping[str, int | None]) -> LoomPlan:
    if "THREADING" not in text.sections:
        raise InputError(
            f"{text.file}: the section [THREADING] is missing; it says which shaft carries each end."
        )
    threading = _read_sets(text, "THREADING", "an end", "shafts")
    treadling = _read_sets(text, "TREADLING", "a pick", "treadles")
    has_treadling = any(treadling.values())
    tieup = _read_sets(
        text, "TIEUP", "a treadle", "shafts", "" if has_treadling else "no pick presses a treadle"
    )
    treadled = any(tieup.values()) and has_treadling
    liftplan = _read_sets(text, "LIFTPLAN", "a pick", "shafts", "the treadling is woven" if treadled else "")
    if not any(threading.values()):
        raise InputError(f"{text.file}: [THREADING] puts no end on a shaft; each line is an end=its shaft.")
    if not treadled and not any(liftplan.values()):
        raise _nothing_lifts(text, tieup, treadling)

    shafts = _shaft_count(text, threading, tieup, liftplan)
    treadles = _treadle_count(text, tieup, treadling if treadled else {})
    ends = _thread_count(text, "WARP", "THREADING", threading, declared["WARP"])
    # Both plans, if there are two, cover the same picks.
    picks = max(
        _thread_count(text, "WEFT", section, sets, declared["WEFT"])
        for section, sets in (("TREADLING", treadling if treadled else {}), ("LIFTPLAN", liftplan))
        if sets
    )
    plan = LoomPlan(
        threading=_sequence(threading, ends),
        shafts=shafts,
        treadles=treadles,
        tieup=_sequence(tieup, treadles) if treadled else None,
        treadling=_sequence(treadling, picks) if treadled else None,
        liftplan=_sequence(liftplan, picks) if any(liftplan.values()) else None,
        rising_shed=yes_or_no(text, "WEAVING", "Rising Shed", default=True),
    )
    if plan.treadling is None or plan.liftplan is None:
        return plan
    _compare_plans(text, plan)
    return _completed(text, plan)


def _sequence(sets: Mapping[int, frozenset[int]], count: int) -> tuple[frozenset[int], ...]:
    nothing: frozenset[int] = frozenset()
    return tuple(sets.get(number, nothing) for number in range(1, count + 1))


def _nothing_lifts(
    text: WifText, tieup: Mapping[int, frozenset[int]], treadling: Mapping[int, frozenset[int]]
) -> InputError:
    for section, sets, needed, purpose in (
        ("TREADLING", treadling, "TIEUP", "which shafts each treadle moves"),
        ("TIEUP", tieup, "TREADLING", "which treadles each pick presses"),
    ):
        used = next((number for number, members in sets.items() if members), None)
        if used is not None:
            state = "is empty" if needed in text.sections else "is missing"
            return text.fault(
                section,
                str(used),
                text.value(section, str(used)),
                f"needs the section [{needed}], which {state}: it says {purpose}; "
                "a [LIFTPLAN] would do as well",
            )
    said = text.value("CONTENTS", "LIFTPLAN")
    contents = f" ([CONTENTS] says LIFTPLAN={shortened(said)})" if said else ""
    return InputError(
        f"{text.file}: [LIFTPLAN] is {'empty' if 'LIFTPLAN' in text.sections else 'missing'}{contents}, "
        "and so are [TIEUP] and [TREADLING]: one or the other must say which shafts each pick lifts."
    )


def _shaft_count(text: WifText, *tables: Mapping[int, frozenset[int]]) -> int:
    value = text.value("WEAVING", "Shafts")
    used = max(max(members, default=0) for sets in tables for members in sets.values())
    if not without_comment(value):
        return used
    declared = integer(text, "WEAVING", "Shafts", value, 0, MAXIMUM_THREADS, "a number of shafts")
    if 0 < declared < used:
        text.warn(
            "WEAVING", "Shafts", value, f"is too low: the draft uses shaft {used}, and so many are taken"
        )
    return max(declared, used)


def _treadle_count(
    text: WifText, tieup: Mapping[int, frozenset[int]], treadling: Mapping[int, frozenset[int]]
) -> int:
    value = text.value("WEAVING", "Treadles")
    declared = (
        integer(text, "WEAVING", "Treadles", value, 0, MAXIMUM_THREADS, "a number of treadles")
        if without_comment(value)
        else 0
    )
    treadles = max(declared, max((number for number, members in tieup.items() if members), default=0))
    for pick, pressed in treadling.items():
        if max(pressed, default=0) > treadles:
            raise text.fault(
                "TREADLING",
                str(pick),
                text.value("TREADLING", str(pick)),
                f"presses treadle {max(pressed)}, and [TIEUP] and [WEAVING] know {treadles}; "
                "tie that treadle up or press another",
            )
    return treadles


def _thread_count(
    text: WifText, family: str, section: str, sets: Mapping[int, frozenset[int]], declared: int | None
) -> int:
    used = max((number for number, members in sets.items() if members), default=0)
    if declared is None:
        return max(sets)
    if declared < used:
        text.warn(
            family,
            "Threads",
            text.value(family, "Threads"),
            f"is too low: [{section}] goes up to {used}, and so many are taken",
        )
    return max(used, max((number for number in sets if number <= declared), default=0))


def _compare_plans(text: WifText, plan: LoomPlan) -> None:
    by_treadles = plan_drawdown(plan)
    by_liftplan = plan_drawdown(replace(plan, tieup=None, treadling=None))
    pressed = np.array([bool(treadles) for treadles in plan.treadling or ()])
    different = np.flatnonzero((by_treadles != by_liftplan).any(axis=1) & pressed)
    if different.size:
        pick = str(different[0] + 1)
        text.warn(
            "LIFTPLAN",
            pick,
            text.value("LIFTPLAN", pick),
            f"differs from [TREADLING] {pick}={text.value('TREADLING', pick)} with [TIEUP]; "
            "the treadling is woven",
        )


def _completed(text: WifText, plan: LoomPlan) -> LoomPlan:
    """A plan whose treadling leaves picks to its liftplan, as one liftplan; any other as it is."""
    treadling, liftplan = plan.treadling or (), plan.liftplan or ()
    left = [pick for pick, lifted in enumerate(liftplan) if lifted and not treadling[pick]]
    if not left:
        return plan
    pick = str(left[0] + 1)
    text.warn(
        "LIFTPLAN",
        pick,
        text.value("LIFTPLAN", pick),
        f"is woven, as [TREADLING] presses nothing there; {len(left)} such picks are the liftplan's",
    )
    moved = moved_shafts(plan)
    lifts = tuple(
        lifted if pressed == frozenset() else frozenset((np.flatnonzero(row) + 1).tolist())
        for row, pressed, lifted in zip(moved, treadling, liftplan, strict=True)
    )
    return replace(plan, treadles=0, tieup=None, treadling=None, liftplan=lifts)


# --------------------------------------------------------------------------------------- everything else


def _notes(text: WifText) -> tuple[str, ...]:
    if "NOTES" not in text.sections:
        return ()
    return tuple(
        key if value is None else value if key.isdigit() else f"{key}={value}"
        for key, value in text.sections["NOTES"].entries
    )


def _other_entries(text: WifText) -> tuple[tuple[str, Entries], ...]:
    """Content of known sections that is not interpreted."""
    kept = []
    for name, keys in _INTERPRETED.items():
        if keys is None or name not in text.sections:
            continue
        entries = tuple(line for line in text.sections[name].entries if line[0].upper() not in keys)
        if entries:
            kept.append((name, entries))
    return tuple(kept)


def _other_sections(text: WifText) -> tuple[tuple[str, Entries], ...]:
    return tuple(
        (section.spelled, section.entries)
        for name, section in text.sections.items()
        if name not in _INTERPRETED
    )
