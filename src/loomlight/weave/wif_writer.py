"""Writes drafts as weaving information files (WIF 1.1), without losing content of the original file."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterable
from importlib.metadata import PackageNotFoundError, version

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import linear_to_srgb, srgb_to_linear
from loomlight.core.files import replacing
from loomlight.weave.draft import Draft, FamilyDefaults, Threads, WifSource
from loomlight.weave.loom import plan_that_weaves
from loomlight.weave.palette import ThreadPalette, thread_palette
from loomlight.weave.wif_text import UNIT_MM, unit_name

Sections = dict[str, list[tuple[str, str | None]]]


def write_wif(draft: Draft, path: str | os.PathLike[str]) -> None:
    """Writes a draft with its colours, spacings, notes and private sections.

    A draft that has no loom plan, or one that no longer weaves its drawdown, gets a derived one, with as
    many shafts as it needs. Colours are written in the range of the file they came from, otherwise in 0 to
    255 or, where that would round them, 0 to 65535. Reading the file gives the same draft.

    Raises:
        InputError: the file cannot be written.

    Source: Weaving Information File specification 1.1, 20 April 1997.
    """
    with replacing(path) as temporary:
        temporary.write_text(wif_text_of(draft), encoding="utf-8", errors="replace", newline="")


def wif_text_of(draft: Draft) -> str:
    """The text that `write_wif` writes."""
    source = draft.source or WifSource()
    loom = plan_that_weaves(draft)
    palette = thread_palette(draft)
    sections: Sections = {
        "WEAVING": [
            ("Shafts", str(loom.shafts)),
            ("Treadles", str(loom.treadles)),
            ("Rising Shed", "true" if loom.rising_shed else "false"),
        ],
        "WARP": [("Threads", str(max(draft.ends, source.warp.threads or 0)))],
        "WEFT": [("Threads", str(max(draft.picks, source.weft.threads or 0)))],
        "TEXT": [("Title", _one_line(draft.title))] if draft.title.strip() else [],
        "NOTES": [(str(number), _one_line(note)) for number, note in enumerate(draft.notes, start=1)],
        **_color_sections(palette, source),
        "THREADING": _sets(loom.threading),
        "TIEUP": _sets(loom.tieup or ()),
        "TREADLING": _sets(loom.treadling or ()),
        "LIFTPLAN": _sets(loom.liftplan or ()),
    }
    for family, threads, index, defaults in (
        ("WARP", draft.warp, palette.warp, source.warp),
        ("WEFT", draft.weft, palette.weft, source.weft),
    ):
        known = defaults if draft.source is not None else None
        _add_colors(sections, family, index, known if palette.original else None)
        _add_lengths(sections, family, threads, known)
    for name, entries in source.entries:
        sections.setdefault(name, []).extend(entries)
    return _joined(sections, source)


def _joined(sections: Sections, source: WifSource) -> str:
    head: Sections = {"WIF": sections.pop("WIF", []) or _own_header(), "CONTENTS": []}
    written = {name: lines for name, lines in sections.items() if lines}
    others = [(name, list(entries)) for name, entries in source.sections]
    head["CONTENTS"] = [(name, "true") for name in (*written, *(name for name, _ in others))]
    blocks = [_block(name, lines) for name, lines in (*head.items(), *written.items(), *others)]
    return "\r\n".join(blocks)


def _block(name: str, lines: Iterable[tuple[str, str | None]]) -> str:
    shown = [key if value is None else f"{key}={value}" for key, value in lines]
    return "\r\n".join([f"[{name}]", *shown, ""])


def _own_header() -> list[tuple[str, str | None]]:
    try:
        ours = version("loomlight")
    except PackageNotFoundError:
        ours = "unknown"
    # The specification requires this date and this address, those of its own version.
    return [
        ("Version", "1.1"),
        ("Date", "April 20, 1997"),
        ("Developers", "wif@mhsoft.com"),
        ("Source Program", "loomlight"),
        ("Source Version", ours),
    ]


def _one_line(text: str) -> str:
    return " ".join(text.replace("\r", "\n").split("\n")).strip()


def _sets(members: Iterable[frozenset[int]]) -> list[tuple[str, str | None]]:
    return [
        (str(number), ",".join(map(str, sorted(chosen))) or "0")
        for number, chosen in enumerate(members, start=1)
    ]


def _color_sections(palette: ThreadPalette, source: WifSource) -> Sections:
    if not len(palette.colors):
        return {}
    low, high = _exact_range(palette.colors, source.color_range)
    table = _components(palette.colors, low, high)
    return {
        "COLOR PALETTE": [("Entries", str(len(table))), ("Range", f"{low},{high}")],
        "COLOR TABLE": [(str(row), ",".join(map(str, color))) for row, color in enumerate(table.tolist(), 1)],
    }


def _components(colors: NDArray[np.float64], low: int, high: int) -> NDArray[np.int64]:
    return np.rint(linear_to_srgb(colors) * (high - low) + low).astype(np.int64)


def _exact_range(colors: NDArray[np.float64], first: tuple[int, int]) -> tuple[int, int]:
    """The first range whose integers reproduce the colours; the finest one if none does."""
    finest = (0, 65535)
    for low, high in (first, (0, 255)):
        decoded = srgb_to_linear((_components(colors, low, high) - low) / (high - low))
        if np.allclose(decoded, colors, rtol=0, atol=1e-9):
            return low, high
    return finest


def _add_colors(
    sections: Sections, family: str, index: NDArray[np.intp] | None, known: FamilyDefaults | None
) -> None:
    if index is None:
        return
    default = Counter(index.tolist()).most_common(1)[0][0] if known is None else known.color_index
    if default is not None:
        sections[family].append(("Color", str(default + 1)))
    sections[f"{family} COLORS"] = [
        (str(thread), str(row + 1)) for thread, row in enumerate(index.tolist(), 1) if row != default
    ]


def _add_lengths(sections: Sections, family: str, threads: Threads, known: FamilyDefaults | None) -> None:
    spelled = known.unit if known is not None and known.unit else "Centimeters"
    unit = UNIT_MM[unit_name(spelled)]
    measured = threads.spacing_mm is not None or threads.thickness_mm is not None
    if measured or (known is not None and known.unit):
        sections[family].append(("Units", spelled))
    for what, lengths, stated in (
        ("Spacing", threads.spacing_mm, known.spacing_mm if known else None),
        ("Thickness", threads.thickness_mm, known.thickness_mm if known else None),
    ):
        if lengths is None:
            continue
        default = Counter(lengths.tolist()).most_common(1)[0][0] if known is None else stated
        if default is not None:
            sections[family].append((what, decimal_text(default, unit)))
        sections[f"{family} {what.upper()}"] = [
            (str(thread), decimal_text(length, unit))
            for thread, length in enumerate(lengths.tolist(), 1)
            if length != default
        ]


def decimal_text(length_mm: float, unit: float) -> str:
    """The shortest decimal that is `length_mm` again when multiplied by `unit`."""
    quotient = length_mm / unit
    for digits in range(1, 18):
        text = f"{quotient:.{digits}g}"
        if float(text) * unit == length_mm:
            return text
    neighbours = (np.nextafter(quotient, -np.inf), np.nextafter(quotient, np.inf))
    exact = (float(value) for value in neighbours if float(value) * unit == length_mm)
    return repr(next(exact, quotient))
