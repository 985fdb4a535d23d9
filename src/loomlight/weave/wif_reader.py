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
from numpy.typing import NDArray

from loomlight.core.colour import srgb_to_linear
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.weave.draft import (
    MAXIMUM_THREADS,
    Draft,
    Entries,
    FamilyDefaults,
    LoomPlan,
    Threads,
    WifSource,
)
from loomlight.weave.layers import warn_of_layers
from loomlight.weave.loom import moved_shafts, plan_drawdown
from loomlight.weave.wif_text import (
    UNIT_MM,
    WifText,
    integer,
    integers,
    is_integer,
    length_mm,
    number_set,
    read_wif_text,
    shortened,
    thread_number,
    unit_mm,
    unit_name,
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


# ----------------------------------------------------------------------------- colours, spacings, thicknesses
# Colours, spacings and thicknesses of the threads in a weaving information file.


_A_TRIPLE = "a colour: write three whole numbers, as in 255,128,0"
_A_RANGE = "a range of colour components: write two whole numbers, as in 0,255"


def read_palette(text: WifText) -> tuple[NDArray[np.float64] | None, tuple[int, int]]:
    """Linear RGB [k, 3] of the colour table, None without one, and its range."""
    used = _used_colors(text)
    rows: dict[int, tuple[str, str, list[int]]] = {}
    passed_over: list[tuple[str, str, str]] = []
    for key, value in text.items("COLOR TABLE"):
        number = thread_number(text, "COLOR TABLE", key, value, "the number of a colour")
        try:
            rows[number] = key, value, integers(text, "COLOR TABLE", key, value, (3,), _A_TRIPLE)
        except InputError:
            if number in used:
                raise
            passed_over.append((key, value, f"is not {_A_TRIPLE}"))
    if not rows:
        return None, _unused_range(text)
    size = max(rows)
    gap = min((number for number in used if 1 <= number < size and number not in rows), default=None)
    if gap is not None:
        raise InputError(
            f"{text.file}: [COLOR TABLE] lacks the colour {gap}; its {len(rows)} colours are "
            f"numbered from 1 to {len(rows)} without gaps."
        )
    low, high = _color_range(text, highest=max(max(rgb) for _, _, rgb in rows.values()))
    table = np.full((size, 3), low, dtype=np.float64)
    for number, (key, value, rgb) in rows.items():
        if min(rgb) < low or max(rgb) > high:
            fault = f"leaves the range {low} to {high} that [COLOR PALETTE] Range gives"
            if number in used:
                raise text.fault("COLOR TABLE", key, value, fault)
            passed_over.append((key, value, fault))
        else:
            table[number - 1] = rgb
    for key, value, fault in passed_over[:1]:
        text.warn("COLOR TABLE", key, value, f"{fault}; it is passed over, as no thread has that colour")
    return srgb_to_linear((table - low) / (high - low)), (low, high)


def _used_colors(text: WifText) -> set[int]:
    """Numbers of the colours that a thread, or a default, names."""
    defaults = _default_colors(text)
    values = [value for family in ("WARP", "WEFT") for _, value in text.items(f"{family} COLORS")]
    first = (without_comment(value).partition(",")[0].strip() for value in values)
    used = {int(number) for number in first if is_integer(number)} | set(defaults)
    return used | {number + 1 for number in defaults} if 0 in defaults else used


def _default_colors(text: WifText) -> list[int]:
    """The numbers of colours that [WARP] and [WEFT] give all threads; less of what is no number."""
    values = (text.value(family, "Color") for family in ("WARP", "WEFT"))
    first = (without_comment(value).partition(",")[0].strip() for value in values)
    return [int(number) for number in first if is_integer(number)]


def defaults_count_from_zero(text: WifText, palette: NDArray[np.float64] | None) -> bool:
    """Whether the default colours count from 0, as a generator writes them beside a table from 1.

    That is so where one of them is 0, all counted so are in the table, and no thread has a colour of its own,
    whose number would count from 1.

    Warns:
        LoomlightWarning: they do.
    """
    stated = _default_colors(text)
    if palette is None or not stated or min(stated) != 0 or max(stated) >= len(palette):
        return False
    own = (value for family in ("WARP", "WEFT") for _, value in text.items(f"{family} COLORS"))
    if any(map(without_comment, own)):
        return False
    family = (
        "WARP" if without_comment(text.value("WARP", "Color")).partition(",")[0].strip() == "0" else "WEFT"
    )
    fault = "counts the colours of [COLOR TABLE] from 0, and the table from 1: defaults are read so"
    text.warn(family, "Color", text.value(family, "Color"), fault)
    return True


def _unused_range(text: WifText) -> tuple[int, int]:
    """The range of components where there is no table."""
    try:
        return _color_range(text, highest=0)
    except InputError:
        value = text.value("COLOR PALETTE", "Range")
        text.warn("COLOR PALETTE", "Range", value, "is passed over, since the file has no [COLOR TABLE]")
        return 0, 255


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


def read_family(
    text: WifText, family: str, count: int, palette: NDArray[np.float64] | None, first_default: int = 1
) -> tuple[Threads, FamilyDefaults]:
    """The threads of one family, and what the file says for all of them.

    Args:
        first_default: the number, 0 or 1, by which a default names the first colour of the table.
    """
    color_index, default_color, default_rgb = _read_colors(text, family, count, palette, first_default)
    spacing, default_spacing = _read_lengths(text, family, "Spacing", count)
    thickness, default_thickness = _read_lengths(text, family, "Thickness", count)
    colors = default_rgb
    if color_index is not None and palette is not None:
        colors = palette[color_index]
    threads = Threads(colors=colors, spacing_mm=spacing, thickness_mm=thickness, color_index=color_index)
    unit = text.value(family, "Units")
    if without_comment(unit) and unit_name(without_comment(unit)) not in UNIT_MM:
        text.warn(family, "Units", unit, "is no known unit; it is passed over, as no length is given in it")
        unit = ""
    defaults = FamilyDefaults(
        unit=without_comment(unit),
        color_index=default_color,
        spacing_mm=default_spacing,
        thickness_mm=default_thickness,
    )
    return threads, defaults


def warn_of_thick_threads(text: WifText, warp: Threads, weft: Threads) -> None:
    """Warns of ends and picks thicker than their spacings, which programs write that know neither.

    One family may be: wefts of a weft-faced cloth are beaten over one another.
    """
    told = []
    for name, threads in (("ends", warp), ("picks", weft)):
        if threads.thickness_mm is None or threads.spacing_mm is None:
            return
        thickness, spacing = float(np.median(threads.thickness_mm)), float(np.median(threads.spacing_mm))
        if thickness <= spacing:
            return
        told.append(f"{10 / spacing:.3g} {name}/cm, {spacing:.3g} mm apart and {thickness:.3g} mm thick")
    warnings.warn(
        f"{text.file}: its Thickness is above its Spacing, as programs write that know neither; read are "
        f"{' and '.join(told)}: if the cloth has others, give ends_per_cm and picks_per_cm in a fabric file.",
        LoomlightWarning,
        stacklevel=2,
    )


def _read_colors(
    text: WifText, family: str, count: int, palette: NDArray[np.float64] | None, first_default: int
) -> tuple[NDArray[np.intp] | None, int | None, NDArray[np.float64] | None]:
    """Palette index per thread and by default (0-based), or without a palette one colour [count, 3]."""
    section = f"{family} COLORS"
    own = [(key, value) for key, value in text.items(section) if without_comment(value)]
    default = text.value(family, "Color")
    parts = [part.strip() for part in without_comment(default).split(",")] if without_comment(default) else []
    # What is no colour is treated as one outside the table: it matters where a thread needs it.
    stated = list(map(int, parts)) if len(parts) in (0, 1, 4) and all(map(is_integer, parts)) else [0]
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
        if thread > count:
            continue
        # Some programs write "index,red,green,blue", as the specification has it for Color alone.
        color = integers(text, section, key, value, (1, 4), "the number of a colour")[0]
        if not 1 <= color <= size:
            raise text.fault(
                section, key, value, f"is not in [COLOR TABLE], which holds the colours 1 to {size}"
            )
        index[thread - 1] = color - 1
    if stated:
        stated = [stated[0] + 1 - first_default, *stated[1:]]
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
    own = [(key, value) for key, value in text.items(section) if without_comment(value)]
    default_value = text.value(family, what)
    if not own and not without_comment(default_value):
        return None, None
    unit = unit_mm(text, family)
    if unit is None:
        if not without_comment(text.value(family, "Spacing")) or what == "Spacing":
            text.warn(family, "Units", "", "is missing; the lengths are read as centimetres")
        unit = 10.0
    default = length_mm(text, family, what, default_value, unit)
    lengths = np.full(count, np.nan)
    for key, value in own:
        thread = thread_number(text, section, key, value, "the number of a thread")
        if thread <= count and (length := length_mm(text, section, key, value, unit)) is not None:
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
