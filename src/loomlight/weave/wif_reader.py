"""Reads weaving information files (WIF 1.1, and variants that programs write) into drafts.

What the specification leaves open is decided here:

- A draft has as many ends as [THREADING] lists, whatever [WARP] Threads declares beyond that: such threads
  are placeholders of an unfinished draft. Picks likewise.
- Where [LIFTPLAN] stands beside [TIEUP] and [TREADLING], the treadling is woven; if they differ, a warning
  says so, and both are kept.
- A default that no thread needs may be wrong: it is passed over with a warning.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import srgb_to_linear
from loomlight.core.errors import InputError
from loomlight.weave.draft import MAXIMUM_THREADS, Draft, LoomPlan, Threads
from loomlight.weave.loom import plan_drawdown
from loomlight.weave.wif_source import Entries, FamilyDefaults, WifSource
from loomlight.weave.wif_text import WifText, read_wif_text
from loomlight.weave.wif_values import (
    integer,
    integers,
    length_mm,
    number_set,
    thread_number,
    unit_mm,
    without_comment,
    yes_or_no,
)

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

_A_TRIPLE = "a colour: write three whole numbers, as in 255,128,0"
_A_RANGE = "a range of colour components: write two whole numbers, as in 0,255"
_A_COLOR = "a colour: write its number in [COLOR TABLE]"


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
    palette, color_range = _read_palette(text)
    ends, picks = len(loom.threading), len(loom.treadling or loom.liftplan or ())
    warp, warp_defaults = _read_family(text, "WARP", ends, palette)
    weft, weft_defaults = _read_family(text, "WEFT", picks, palette)
    return Draft(
        drawdown=plan_drawdown(loom),
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


def _read_sets(text: WifText, section: str, of: str, what: str) -> dict[int, frozenset[int]]:
    return {
        thread_number(text, section, key, value, f"the number of {of}"): number_set(
            text, section, key, value, what
        )
        for key, value in text.items(section)
    }


def _read_loom(text: WifText, declared: Mapping[str, int | None]) -> LoomPlan:
    if "THREADING" not in text.sections:
        raise InputError(
            f"{text.file}: the section [THREADING] is missing; it says which shaft carries each end."
        )
    threading = _read_sets(text, "THREADING", "an end", "shafts")
    tieup = _read_sets(text, "TIEUP", "a treadle", "shafts")
    treadling = _read_sets(text, "TREADLING", "a pick", "treadles")
    liftplan = _read_sets(text, "LIFTPLAN", "a pick", "shafts")
    if not any(threading.values()):
        raise InputError(f"{text.file}: [THREADING] puts no end on a shaft; each line is an end=its shaft.")
    treadled = any(tieup.values()) and any(treadling.values())
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
    if plan.treadling is not None and plan.liftplan is not None:
        _compare_plans(text, plan)
    return plan


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
    contents = f" ([CONTENTS] says LIFTPLAN={said})" if said else ""
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
    different = np.flatnonzero((by_treadles != by_liftplan).any(axis=1))
    if different.size:
        pick = str(different[0] + 1)
        text.warn(
            "LIFTPLAN",
            pick,
            text.value("LIFTPLAN", pick),
            f"differs from [TREADLING] {pick}={text.value('TREADLING', pick)} with [TIEUP]; "
            "the treadling is woven",
        )


# ------------------------------------------------------------------------------------------- the threads


def _read_palette(text: WifText) -> tuple[NDArray[np.float64] | None, tuple[int, int]]:
    """Linear RGB [k, 3] of the colour table, None without one, and its range."""
    components = {
        thread_number(text, "COLOR TABLE", key, value, "the number of a colour"): (
            key,
            value,
            integers(text, "COLOR TABLE", key, value, (3,), _A_TRIPLE),
        )
        for key, value in text.items("COLOR TABLE")
    }
    if not components:
        return None, _color_range(text, highest=0)
    for number in range(1, len(components) + 1):
        if number not in components:
            raise InputError(
                f"{text.file}: [COLOR TABLE] lacks the colour {number}; its {len(components)} colours are "
                f"numbered from 1 to {len(components)} without gaps."
            )
    low, high = _color_range(text, highest=max(max(rgb) for _, _, rgb in components.values()))
    for key, value, rgb in components.values():
        if min(rgb) < low or max(rgb) > high:
            raise text.fault(
                "COLOR TABLE",
                key,
                value,
                f"leaves the range {low} to {high} that [COLOR PALETTE] Range gives",
            )
    table = np.array([components[number + 1][2] for number in range(len(components))], dtype=np.float64)
    return srgb_to_linear((table - low) / (high - low)), (low, high)


def _color_range(text: WifText, highest: int) -> tuple[int, int]:
    value = text.value("COLOR PALETTE", "Range")
    form = text.value("COLOR PALETTE", "Form")
    if form and without_comment(form).upper() != "RGB":
        text.warn("COLOR PALETTE", "Form", form, "is not known; the colours are read as RGB")
    if without_comment(value):
        low, high = integers(text, "COLOR PALETTE", "Range", value, (2,), _A_RANGE)
        if low >= high:
            raise text.fault(
                "COLOR PALETTE", "Range", value, "is no range: the first number must be the lower"
            )
        return low, high
    if highest > 255:
        raise text.fault(
            "COLOR PALETTE",
            "Range",
            value,
            f"is missing, and [COLOR TABLE] goes up to {highest}: "
            "give the lowest and highest component, as in 0,255",
        )
    if "COLOR TABLE" in text.sections:
        text.warn("COLOR PALETTE", "Range", value, "is missing; the colours are read as 0 to 255")
    return 0, 255


def _read_family(
    text: WifText, family: str, count: int, palette: NDArray[np.float64] | None
) -> tuple[Threads, FamilyDefaults]:
    color_index, default_color, default_rgb = _read_colors(text, family, count, palette)
    spacing, default_spacing = _read_lengths(text, family, "Spacing", count)
    thickness, default_thickness = _read_lengths(text, family, "Thickness", count)
    colors = default_rgb
    if color_index is not None and palette is not None:
        colors = palette[color_index]
    threads = Threads(colors=colors, spacing_mm=spacing, thickness_mm=thickness, color_index=color_index)
    defaults = FamilyDefaults(
        unit=without_comment(text.value(family, "Units")),
        color_index=default_color,
        spacing_mm=default_spacing,
        thickness_mm=default_thickness,
    )
    return threads, defaults


def _read_colors(
    text: WifText, family: str, count: int, palette: NDArray[np.float64] | None
) -> tuple[NDArray[np.intp] | None, int | None, NDArray[np.float64] | None]:
    """Palette index per thread and by default (0-based), or without a palette one colour [count, 3]."""
    section = f"{family} COLORS"
    own = [(key, value) for key, value in text.items(section) if without_comment(value)]
    default = text.value(family, "Color")
    stated = integers(text, family, "Color", default, (1, 4), _A_COLOR) if without_comment(default) else []
    if palette is None:
        if own:
            raise text.fault(
                section, *own[0], "names a colour of [COLOR TABLE], and the file has none; add it"
            )
        return None, None, _stated_rgb(text, family, stated, count)

    size = len(palette)
    index = np.full(count, -1, dtype=np.intp)
    for key, value in own:
        thread = thread_number(text, section, key, value, "the number of a thread")
        color = integers(text, section, key, value, (1,), "the number of a colour")[0]
        if not 1 <= color <= size:
            raise text.fault(
                section, key, value, f"is not in [COLOR TABLE], which holds the colours 1 to {size}"
            )
        if thread <= count:
            index[thread - 1] = color - 1
    return _with_default_color(text, family, index, stated, size)


def _with_default_color(
    text: WifText, family: str, index: NDArray[np.intp], stated: list[int], size: int
) -> tuple[NDArray[np.intp] | None, int | None, None]:
    without = np.flatnonzero(index < 0)
    default = text.value(family, "Color")
    if stated and 1 <= stated[0] <= size:
        index[without] = stated[0] - 1
        return index, stated[0] - 1, None
    if without.size == index.size and not stated:
        return None, None, None
    if without.size:
        raise text.fault(
            family,
            "Color",
            default,
            f"{'is not in [COLOR TABLE]' if stated else 'is missing'}, and thread {without[0] + 1} "
            f"has no colour of its own in [{family} COLORS]; give a colour from 1 to {size}",
        )
    if stated:
        text.warn(
            family,
            "Color",
            default,
            f"is not in [COLOR TABLE], which holds 1 to {size}; it is passed over, since every thread has a "
            "colour of its own",
        )
    return index, None, None


def _stated_rgb(text: WifText, family: str, stated: list[int], count: int) -> NDArray[np.float64] | None:
    """The colour of "Color=index,red,green,blue" for every thread, where there is no table."""
    if len(stated) != 4:
        if stated:
            default = text.value(family, "Color")
            text.warn(family, "Color", default, "is passed over, since the file has no [COLOR TABLE]")
        return None
    low, high = _color_range(text, highest=max(stated[1:]))
    if min(stated[1:]) < low or max(stated[1:]) > high:
        raise text.fault(family, "Color", text.value(family, "Color"), f"leaves the range {low} to {high}")
    rgb = srgb_to_linear((np.array(stated[1:], dtype=np.float64) - low) / (high - low))
    return np.tile(rgb, (count, 1))


def _read_lengths(
    text: WifText, family: str, what: str, count: int
) -> tuple[NDArray[np.float64] | None, float | None]:
    """Millimetres per thread, None if the file does not say for all, and the default."""
    section = f"{family} {what.upper()}"
    unit = unit_mm(text, family)
    own = [(key, value) for key, value in text.items(section) if without_comment(value)]
    default_value = text.value(family, what)
    if unit is None and (own or without_comment(default_value)):
        if not without_comment(text.value(family, "Spacing")) or what == "Spacing":
            text.warn(family, "Units", "", "is missing; the lengths are read as centimetres")
        unit = 10.0
    default = length_mm(text, family, what, default_value, unit or 10.0)
    lengths = np.full(count, np.nan)
    for key, value in own:
        thread = thread_number(text, section, key, value, "the number of a thread")
        length = length_mm(text, section, key, value, unit or 10.0)
        if thread <= count and length is not None:
            lengths[thread - 1] = length
    without = np.flatnonzero(np.isnan(lengths))
    if default is not None:
        lengths[without] = default
    elif without.size:
        if without.size < count:
            text.warn(
                section,
                *own[0],
                f"and the rest of this section is passed over: thread {without[0] + 1} is not in it, "
                f"and [{family}] {what} gives no default",
            )
        return None, None
    return lengths, default


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
