"""Drafts as pictures, the way weaving software draws them.

The drawdown has end 1 on the left and pick 1 at the bottom, so that a Z twill rises to the right. Above it
stand the threading (shaft 1 lowest) and the warp's colours, to its right the treadling or the liftplan and
the weft's colours, in the corner the tie-up. The back is the cloth turned over sideways.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import linear_to_srgb, parse_colour
from loomlight.core.errors import InputError
from loomlight.weave.draft import Draft, LoomPlan, Threads
from loomlight.weave.loom import derive_loom_plan, membership, moved_shafts
from loomlight.weave.palette import WARP_COLOUR, WEFT_COLOUR

Pixels = NDArray[np.uint8]
Face = Literal["front", "back"]

MAXIMUM_PICTURE_PX = 4096
# A plan that came with the draft is drawn up to a large dobby loom's; a derived one only while it explains.
MAXIMUM_DRAWN_SHAFTS = 64
MAXIMUM_DERIVED_SHAFTS = 32
_LARGEST_CELL_PX = 24
_COMFORTABLE_PX = 1100
# Large drafts get a larger picture, as long as that keeps their threads apart.
_LARGE_PX = 2400
_SMALLEST_LEGIBLE_CELL_PX = 4
# Small repeats are drawn several times until the eye sees a cloth.
_LEGIBLE_THREADS = 24

_WARP = parse_colour(WARP_COLOUR, "warp")
_WEFT = parse_colour(WEFT_COLOUR, "weft")
_PAPER = np.array([252, 251, 248], dtype=np.uint8)
_EMPTY = np.array([255, 255, 255], dtype=np.uint8)
_INK = np.array([44, 46, 54], dtype=np.uint8)
_LINE = np.array([216, 213, 206], dtype=np.uint8)
_GROUP_LINE = np.array([176, 172, 164], dtype=np.uint8)
_REPEAT_LINE = np.array([196, 62, 48], dtype=np.uint8)
_GROUP = 4


def draw_drawdown(
    draft: Draft, *, face: Face = "front", cell_px: int | None = None, repeats: int = 1
) -> Pixels:
    """The interlacement alone: every thread as a band in its colour, the upper one whole.

    Args:
        draft: any draft; without colours a dark warp crosses a light weft.
        face: "front", or "back": turned over about a vertical line, so left and right change places.
        cell_px: pixels a crossing; None chooses 1 to 24 by the size of the draft.
        repeats: how often the repeat is drawn each way, >= 1.

    Returns:
        sRGB-encoded 8-bit pixels [height, width, 3].

    Raises:
        InputError: a picture of more than 4096 pixels, another face, or no repeats.
    """
    view = _view(draft, face, (repeats, repeats))
    cell = _cell(cell_px, max(view.warp_up.shape), limit=MAXIMUM_PICTURE_PX)
    return _interlacement(view, cell)


def draw_draft(
    draft: Draft, *, face: Face = "front", cell_px: int | None = None, repeats: int | None = None
) -> Pixels:
    """The whole draft: drawdown, threading, tie-up, treadling or liftplan, and thread colours.

    A draft without a loom plan gets a derived one. Where that needs more than 32 shafts (64 if the draft
    brought it), or has no room in 4096 pixels, the drawdown and the colours are drawn alone.

    Args:
        draft: any draft; without colours a dark warp crosses a light weft.
        face: "front", or "back": turned over about a vertical line; the loom's parts turn with it.
        cell_px: pixels a crossing; None chooses 1 to 24 by the size of the draft.
        repeats: how often the repeat is drawn each way; None draws small ones until 24 threads show. The
            first repeat is outlined where there are more.

    Returns:
        sRGB-encoded 8-bit pixels [height, width, 3], at most 4096 each way.

    Raises:
        InputError: a picture of more than 4096 pixels, another face, or no repeats.
    """
    if repeats is None:
        across, along = (max(1, -(-_LEGIBLE_THREADS // count)) for count in (draft.ends, draft.picks))
    else:
        across = along = repeats
    view = _view(draft, face, (along, across))
    plan = _plan(draft)
    parts = None if plan is None else _loom_parts(plan, view, face)
    cells = _framed_cells(view, parts)
    if parts is not None and max(cells) > MAXIMUM_PICTURE_PX and cell_px is None:
        parts, cells = None, _framed_cells(view, None)
    if max(cells) > MAXIMUM_PICTURE_PX and cell_px is None:
        return _interlacement(view, 1)
    cell = _cell(cell_px, max(cells), limit=MAXIMUM_PICTURE_PX)
    return _framed(view, parts, cell, outline=across * along > 1)


# ------------------------------------------------------------------------------------------- what is drawn


@dataclass(frozen=True)
class _View:
    """The cloth as it is seen, row 0 at the top.

    Attributes:
        warp_up: bool [picks, ends].
        warp: encoded colours of the ends [ends, 3] in [0, 1].
        weft: encoded colours of the picks [picks, 3].
        repeat: picks and ends of one repeat.
    """

    warp_up: NDArray[np.bool_]
    warp: NDArray[np.float32]
    weft: NDArray[np.float32]
    repeat: tuple[int, int]


@dataclass(frozen=True)
class _LoomParts:
    """The loom's tables in the order they are drawn, row 0 at the top; True is a filled cell."""

    threading: NDArray[np.bool_]
    tieup: NDArray[np.bool_] | None
    treadling: NDArray[np.bool_]


def _view(draft: Draft, face: str, times: tuple[int, int]) -> _View:
    if face not in ("front", "back"):
        raise InputError(f'The face "{face}" is not known; it is "front" or "back".')
    if min(times) < 1:
        raise InputError(f"{min(times)} repeats cannot be drawn; at least 1 can.")
    picks, ends = draft.drawdown.shape
    if max(picks * times[0], ends * times[1]) > MAXIMUM_PICTURE_PX:
        raise InputError(
            f"{times[0]} repeats of {picks} picks and {times[1]} of {ends} ends are too many to draw; "
            f"at most {MAXIMUM_PICTURE_PX} threads are drawn each way."
        )
    warp_up = np.tile(draft.drawdown, times)[::-1]
    warp = np.tile(_encoded(draft.warp, ends, _WARP), (times[1], 1))
    weft = np.tile(_encoded(draft.weft, picks, _WEFT), (times[0], 1))[::-1]
    if face == "back":
        warp_up, warp = ~warp_up[:, ::-1], warp[::-1]
    return _View(warp_up, warp, weft, (picks, ends))


def _encoded(threads: Threads, count: int, default: NDArray[np.float64]) -> NDArray[np.float32]:
    colors = np.tile(default, (count, 1)) if threads.colors is None else threads.colors
    return linear_to_srgb(colors).astype(np.float32)


def _plan(draft: Draft) -> LoomPlan | None:
    plan = draft.loom
    if plan is None:
        try:
            plan = derive_loom_plan(draft, shaft_limit=MAXIMUM_DERIVED_SHAFTS)
        except InputError:
            return None
    return plan if max(plan.shafts, plan.treadles) <= MAXIMUM_DRAWN_SHAFTS else None


def _loom_parts(plan: LoomPlan, view: _View, face: str) -> _LoomParts:
    picks, ends = view.warp_up.shape
    threading = _fill(membership(plan.threading, plan.shafts), ends).T[::-1]
    if face == "back":
        threading = threading[:, ::-1]
    if plan.tieup is None or plan.treadling is None:
        lifts = moved_shafts(replace(plan, tieup=None, treadling=None))
        return _LoomParts(threading, None, _fill(lifts, picks)[::-1])
    tieup = membership(plan.tieup, plan.shafts).T[::-1]
    pressed = membership(plan.treadling, len(plan.tieup))
    return _LoomParts(threading, tieup, _fill(pressed, picks)[::-1])


def _fill(rows: NDArray[np.bool_], count: int) -> NDArray[np.bool_]:
    return rows[np.arange(count) % len(rows)]


# --------------------------------------------------------------------------------------------------- sizes

# In cells: around everything, between the parts, and the breadth of a colour bar.
_MARGIN, _SPACE, _BAR = 1, 1, 1


def _framed_cells(view: _View, parts: _LoomParts | None) -> tuple[int, int]:
    """Height and width of the whole picture in cells."""
    picks, ends = view.warp_up.shape
    above = _BAR + _SPACE + (0 if parts is None else parts.threading.shape[0] + _SPACE)
    beside = _BAR + _SPACE + (0 if parts is None else parts.treadling.shape[1] + _SPACE)
    return picks + above + 2 * _MARGIN, ends + beside + 2 * _MARGIN


def _cell(requested: int | None, cells: int, limit: int) -> int:
    if requested is None:
        comfortable = min(_LARGEST_CELL_PX, _COMFORTABLE_PX // cells)
        return max(1, comfortable, min(_SMALLEST_LEGIBLE_CELL_PX, _LARGE_PX // cells))
    # One pixel more than the cells themselves closes the last line of a grid.
    if requested < 1 or requested * cells + 1 > limit:
        raise InputError(
            f"cell_px = {requested} is out of range for this draft: a picture holds {limit} pixels, "
            f"which is 1 to {max(1, (limit - 1) // cells)} pixels a crossing."
        )
    return requested


# ------------------------------------------------------------------------------------------------- threads


def _interlacement(view: _View, cell: int) -> Pixels:
    """The drawdown in thread colours, `cell` pixels a crossing."""
    if cell < 3:
        flat = np.where(view.warp_up[..., None], view.warp[None, :], view.weft[:, None])
        return np.repeat(np.repeat(_quantised(flat), cell, axis=0), cell, axis=1)
    picks, ends = view.warp_up.shape
    pixels = np.empty((picks * cell, ends * cell, 3), dtype=np.uint8)
    for pick in range(picks):
        pixels[pick * cell : (pick + 1) * cell] = _one_pick(view, pick, cell)
    return pixels


def _one_pick(view: _View, pick: int, cell: int) -> Pixels:
    """The row of crossings of one pick, [cell, ends·cell, 3]."""
    picks, ends = view.warp_up.shape
    up = view.warp_up[pick]
    profile = _profile(cell)
    # Lighting along a thread: it darkens where it is about to dive under the next one.
    warp_light = _dive(up & ~view.warp_up[pick - 1], up & ~view.warp_up[(pick + 1) % picks], cell)
    weft_light = _dive(~up & np.roll(up, 1), ~up & np.roll(up, -1), cell)
    # Axes: row in the cell, end, column in the cell, colour.
    warp = view.warp[None, :, None] * (profile[None, None] * warp_light.T[:, :, None])[..., None]
    weft = view.weft[pick] * (profile[:, None, None] * weft_light[None])[..., None]
    under = np.float32(0.42)
    warp_here, weft_here = (profile > 0)[None, None, :, None], (profile > 0)[:, None, None, None]
    when_up = np.where(warp_here, warp, under * weft)
    when_down = np.where(weft_here, weft, under * warp)
    return _quantised(np.where(up[None, :, None, None], when_up, when_down).reshape(cell, ends * cell, 3))


def _profile(cell: int) -> NDArray[np.float32]:
    """Brightness across a thread, 0 in the gap beside it."""
    gap = max(1, round(cell * 0.12))
    before = gap // 2
    width = cell - gap
    across = (np.arange(width) + 0.5) / width * 2 - 1
    round_light = 0.74 + 0.26 * np.sqrt(1 - 0.9 * across**2) if cell >= 6 else np.ones(width)
    profile = np.zeros(cell, dtype=np.float32)
    profile[before : before + width] = round_light
    return profile


def _dive(before: NDArray[np.bool_], after: NDArray[np.bool_], cell: int) -> NDArray[np.float32]:
    """Brightness along a crossing [n, cell]; `before` and `after`: the thread goes under there."""
    if cell < 6:
        return np.ones((before.size, cell), dtype=np.float32)
    along = (np.arange(cell) + 0.5) / cell
    shade = (0.34 * np.clip(1 - along / 0.45, 0, 1) ** 2).astype(np.float32)
    dark = before[:, None] * shade[None] + after[:, None] * shade[None, ::-1]
    return (1 - dark).astype(np.float32)


def _quantised(encoded: NDArray[np.float32]) -> Pixels:
    return np.rint(np.clip(encoded, 0, 1) * 255).astype(np.uint8)


# --------------------------------------------------------------------------------------------------- frame


def _framed(view: _View, parts: _LoomParts | None, cell: int, *, outline: bool) -> Pixels:
    picks, ends = view.warp_up.shape
    rows, columns = _framed_cells(view, parts)
    canvas = np.tile(_PAPER, (rows * cell + 1, columns * cell + 1, 1))
    top = rows - _MARGIN - picks
    left = _MARGIN
    right = left + ends + _SPACE
    _put(canvas, _interlacement(view, cell), top, left, cell)
    _put(canvas, _bar(view.warp[None], cell), _MARGIN, left, cell)
    _put(canvas, _bar(view.weft[:, None], cell), top, columns - _MARGIN - _BAR, cell)
    if parts is not None:
        above = _MARGIN + _BAR + _SPACE
        _put(canvas, _grid(parts.threading, cell), above, left, cell)
        _put(canvas, _grid(parts.treadling, cell), top, right, cell)
        if parts.tieup is not None:
            _put(canvas, _grid(parts.tieup, cell), above, right, cell)
    if outline:
        _outline(canvas, view, top, left, cell)
    return canvas


def _put(canvas: Pixels, part: Pixels, row: int, column: int, cell: int) -> None:
    y, x = row * cell, column * cell
    canvas[y : y + part.shape[0], x : x + part.shape[1]] = part


def _bar(colors: NDArray[np.float32], cell: int) -> Pixels:
    """Cells in thread colours, with lines between them where there is room."""
    pixels = np.repeat(np.repeat(_quantised(colors), cell, axis=0), cell, axis=1)
    pixels = np.pad(pixels, ((0, 1), (0, 1), (0, 0)), mode="edge")
    _rule(pixels, cell)
    return pixels


def _grid(filled: NDArray[np.bool_], cell: int) -> Pixels:
    """A table of the loom: ink where `filled`, with lines where there is room."""
    inked = np.where(filled[..., None], _INK, _EMPTY)
    pixels = np.repeat(np.repeat(inked, cell, axis=0), cell, axis=1).astype(np.uint8)
    pixels = np.pad(pixels, ((0, 1), (0, 1), (0, 0)), mode="edge")
    _rule(pixels, cell)
    return pixels


def _rule(pixels: Pixels, cell: int) -> None:
    """Lines between cells, firmer around groups of four counted from the lower left."""
    if cell < 4:
        pixels[[0, -1]] = _GROUP_LINE
        pixels[:, [0, -1]] = _GROUP_LINE
        return
    height, width = pixels.shape[:2]
    pixels[::cell] = _LINE
    pixels[:, ::cell] = _LINE
    pixels[height - 1 :: -_GROUP * cell] = _GROUP_LINE
    pixels[:, :: _GROUP * cell] = _GROUP_LINE
    pixels[0] = _GROUP_LINE
    pixels[:, width - 1] = _GROUP_LINE


def _outline(canvas: Pixels, view: _View, top: int, left: int, cell: int) -> None:
    """A frame around the first repeat, lower left."""
    picks, ends = view.repeat
    thick = max(1, cell // 9)
    bottom = (top + view.warp_up.shape[0]) * cell
    y, x, right = bottom - picks * cell, left * cell, (left + ends) * cell
    canvas[y - thick // 2 : y - thick // 2 + thick, x : right + 1] = _REPEAT_LINE
    canvas[bottom : bottom + thick, x : right + 1] = _REPEAT_LINE
    canvas[y : bottom + thick, x - thick : x] = _REPEAT_LINE
    canvas[y : bottom + thick, right - thick // 2 : right - thick // 2 + thick] = _REPEAT_LINE
