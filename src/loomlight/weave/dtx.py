"""Writes drafts as Fiberworks files (.dtx); `load.py` reads them.

The format holds less than a draft: one shaft an end, colours of 8 bits, spacings in whole multiples of
0.53 mm, no thickness. What it cannot hold is rounded, with a warning, or derived anew.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable
from dataclasses import replace
from importlib.metadata import PackageNotFoundError, version

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import linear_to_srgb, parse_colour
from loomlight.core.errors import LoomlightWarning
from loomlight.core.files import replacing
from loomlight.weave.draft import Draft, LoomPlan, Threads
from loomlight.weave.loom import derive_loom_plan, membership, plan_that_weaves
from loomlight.weave.palette import WARP_COLOUR, WEFT_COLOUR, ThreadPalette, thread_palette

# A spacing of 1 in the file.
UNIT_MM = 0.53
# Rounding of spacings that goes without a word: what a reed does to them is more.
_UNNOTICED = 0.05
_NUMBERS_A_LINE = 20

Section = tuple[str, list[str]]


def write_dtx(draft: Draft, path: str | os.PathLike[str]) -> None:
    """Writes a draft with its colours, spacings, title and notes.

    A draft without a plan, or whose plan has ends on several shafts or on none, gets a derived one, with as
    many shafts as it needs.

    Raises:
        InputError: the file cannot be written.

    Warns:
        LoomlightWarning: spacings are rounded by more than 5 %, or there are thicknesses.
    """
    text, lost = dtx_text_of(draft)
    for sentence in lost:
        warnings.warn(f"{path}: {sentence}", LoomlightWarning, stacklevel=2)
    with replacing(path) as temporary:
        temporary.write_text(text, encoding="utf-8", errors="replace", newline="")


def dtx_text_of(draft: Draft) -> tuple[str, list[str]]:
    """The text that `write_dtx` writes, and sentences about what it does not hold."""
    plan = _writable_plan(draft)
    palette = _palette(draft)
    lost = [
        sentence
        for name, threads in (("warp", draft.warp), ("weft", draft.weft))
        for sentence in _lost(name, threads)
    ]
    sections: list[Section] = [
        ("Imprint", [f"loomlight {_own_version()}"]),
        ("Info", _info(draft, plan)),
        ("Threading", _wrapped(str(max(shafts, default=0)) for shafts in plan.threading)),
        *_lifts(plan),
        ("Color Palet", [",".join(map(str, color)) for color in _bytes(palette.colors)]),
    ]
    for name, index in (("Warp", palette.warp), ("Weft", palette.weft)):
        if index is not None:
            sections.append((f"{name} Colors", _wrapped(map(str, index.tolist()))))
    for name, threads in (("Warp", draft.warp), ("Weft", draft.weft)):
        if threads.spacing_mm is not None:
            sections.append((f"{name} Spacing", _wrapped(map(str, _units(threads.spacing_mm).tolist()))))
    if draft.notes:
        sections.append(("Notes", [_plain(note) for note in draft.notes]))
    head: list[Section] = [
        ("StartDTX", ["%%version 1"]),
        ("Description", [_plain(draft.title) or "untitled"]),
        ("Contents", [*(name for name, _ in sections), "EndDTX"]),
    ]
    blocks = ["\r\n".join([f"@@{name}", *lines, ""]) for name, lines in (*head, *sections, ("EndDTX", []))]
    return "\r\n".join(blocks), lost


def _writable_plan(draft: Draft) -> LoomPlan:
    """A plan with one shaft an end, and no last pick that names nothing: readers take that for a blank."""
    plan = plan_that_weaves(draft)
    if any(len(shafts) != 1 for shafts in plan.threading) or (plan.treadling and not plan.treadling[-1]):
        plan = derive_loom_plan(draft)
    return plan if plan.liftplan is None or plan.liftplan[-1] else _treadled(plan, plan.liftplan)


def _treadled(plan: LoomPlan, liftplan: tuple[frozenset[int], ...]) -> LoomPlan:
    """The plan with a treadle for each kind of lift."""
    kinds: dict[frozenset[int], int] = {}
    treadling = tuple(frozenset({kinds.setdefault(lift, len(kinds)) + 1}) for lift in liftplan)
    return replace(plan, treadles=len(kinds), tieup=tuple(kinds), treadling=treadling, liftplan=None)


def _own_version() -> str:
    try:
        return version("loomlight")
    except PackageNotFoundError:
        return "0"


def _info(draft: Draft, plan: LoomPlan) -> list[str]:
    counts = {"shafts": plan.shafts, "treadles": plan.treadles, "ends": draft.ends, "picks": draft.picks}
    return [f"%%{name} {count}" for name, count in counts.items()]


def _lifts(plan: LoomPlan) -> list[Section]:
    """Tie-up and treadling, or the liftplan; a row of the tie-up is a shaft, the first one the last."""
    sinking = [] if plan.rising_shed else ["%%%%sinking"]
    if plan.tieup is not None and plan.treadling is not None:
        tied = membership(plan.tieup, plan.shafts).T[::-1]
        pressed = (",".join(map(str, sorted(treadles))) or "0" for treadles in plan.treadling)
        return [("Tieup", [*sinking, *_bits(tied)]), ("Treadling", _wrapped(pressed))]
    assert plan.liftplan is not None  # a plan that weaves has one or the other
    return [("Liftplan", [*sinking, *_bits(membership(plan.liftplan, plan.shafts))])]


def _bits(rows: NDArray[np.bool_]) -> list[str]:
    return ["".join("1" if bit else "0" for bit in row) for row in rows.tolist()]


def _wrapped(numbers: Iterable[str]) -> list[str]:
    held = list(numbers)
    return [" ".join(held[at : at + _NUMBERS_A_LINE]) for at in range(0, len(held), _NUMBERS_A_LINE)]


def _palette(draft: Draft) -> ThreadPalette:
    """The draft's palette; of one without colours those that it is drawn in, as a reader needs some."""
    palette = thread_palette(draft)
    if len(palette.colors):
        return palette
    colors = np.array([parse_colour(WARP_COLOUR, "warp"), parse_colour(WEFT_COLOUR, "weft")])
    warp, weft = (np.full(count, row, np.intp) for row, count in enumerate((draft.ends, draft.picks)))
    return ThreadPalette(colors, warp, weft, original=False)


def _bytes(colors: NDArray[np.float64]) -> list[list[int]]:
    found: list[list[int]] = np.rint(linear_to_srgb(colors) * 255).astype(int).tolist()
    return found


def _units(spacing_mm: NDArray[np.float64]) -> NDArray[np.int64]:
    return np.maximum(np.rint(spacing_mm / UNIT_MM), 1).astype(np.int64)


def _lost(family: str, threads: Threads) -> list[str]:
    sentences = []
    if threads.spacing_mm is not None:
        off = np.abs(_units(threads.spacing_mm) * UNIT_MM / threads.spacing_mm - 1)
        worst = int(off.argmax())
        if off[worst] > _UNNOTICED:
            given = threads.spacing_mm[worst]
            sentences.append(
                f"spacings in .dtx are multiples of {UNIT_MM} mm: {given:.3g} mm of the {family} is written "
                f"as {_units(given[None])[0] * UNIT_MM:.3g} mm."
            )
    if threads.thickness_mm is not None:
        sentences.append(f"the thickness of the {family} is left out, which .dtx has no place for.")
    return sentences


def _plain(text: str) -> str:
    """One line that is no mark of the format."""
    line = " ".join(text.split())
    return f"- {line}" if line.startswith(("@@", "%%")) else line
