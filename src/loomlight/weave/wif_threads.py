"""Colours, spacings and thicknesses of the threads in a weaving information file."""

from __future__ import annotations

import warnings

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import srgb_to_linear
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.weave.draft import Threads
from loomlight.weave.wif_source import FamilyDefaults
from loomlight.weave.wif_text import WifText
from loomlight.weave.wif_values import (
    UNIT_MM,
    integers,
    is_integer,
    length_mm,
    thread_number,
    unit_mm,
    unit_name,
    without_comment,
)

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
