"""Drafts as pictures, the way weaving software draws them.

Above the drawdown stand the threading (shaft 1 lowest) and the warp's colours, to its right the treadling or
the liftplan and the weft's colours, in the corner the tie-up. Weaving software reads them from that corner:
end 1 on the right, pick 1 on top. Cloth lies in scenes with end 1 on the left and pick 1 at the bottom. A Z
twill rises to the right in both, as they are half a turn apart. The back is the cloth turned over sideways.
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass, replace
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import linear_to_srgb, parse_colour, srgb_to_linear
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.images import draw_by
from loomlight.weave.draft import Draft, LoomPlan, Threads
from loomlight.weave.layer_drafts import LayerDraft
from loomlight.weave.loom import derive_loom_plan, membership, moved_shafts
from loomlight.weave.palette import WARP_COLOUR, WEFT_COLOUR

Pixels = NDArray[np.uint8]
Face = Literal["front", "back"]
Origin = Literal["top-right", "top-left", "bottom-right", "bottom-left"]

MAXIMUM_PICTURE_SIDE_PX = 16384
# Pixels of a whole picture, 200 MB: as many as a draft of 4096 by 16384 threads has crossings.
MAXIMUM_PICTURE_PX = 1 << 26
# A plan that came with the draft is drawn up to a large dobby loom's; a derived one only while it explains.
MAXIMUM_DRAWN_SHAFTS = 64
MAXIMUM_DERIVED_SHAFTS = 32
_MAX_CELL_PX = 24
_COMFORTABLE_PX = 1100
# Large drafts get a larger picture, as long as that keeps their threads apart.
_LARGE_PX = 2400
_MIN_LEGIBLE_CELL_PX = 4
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
    draft: Draft,
    *,
    face: Face = "front",
    origin: Origin = "bottom-left",
    cell_px: int | None = None,
    repeats: int = 1,
) -> Pixels:
    """The interlacement alone: every thread as a band in its colour, the upper one whole.

    Args:
        draft: any draft; without colours a dark warp crosses a light weft.
        face: "front", or "back": turned over about a vertical line, so left and right change places.
        origin: the corner of end 1 and pick 1; pictures of drawdowns are read from the bottom left.
        cell_px: pixels a crossing; None chooses 1 to 24 by the size of the draft, or means of several
            crossings a pixel where that would be too large a picture.
        repeats: how often the repeat is drawn each way, >= 1.

    Returns:
        sRGB-encoded 8-bit pixels [height, width, 3].

    Raises:
        InputError: a picture of more than 16384 pixels a side or 67 million in all, another face or origin,
            or no repeats.

    Warns:
        LoomlightWarning: pixels are means of several crossings.
    """
    view = draft_view(draft, face, origin, (repeats, repeats))
    if cell_px is None and not _fits(view.warp_up.shape):
        return _reduced(view)
    return _interlacement(view, _cell(cell_px, view.warp_up.shape))


def draw_draft(
    draft: Draft,
    *,
    face: Face = "front",
    origin: Origin = "top-right",
    cell_px: int | None = None,
    repeats: int | None = None,
) -> Pixels:
    """The whole draft: drawdown, threading, tie-up, treadling or liftplan, and thread colours.

    A draft without a loom plan gets a derived one. Where that needs more than 32 shafts (64 if the draft
    brought it), or makes too large a picture, the drawdown and the colours are drawn alone.

    Args:
        draft: any draft; without colours a dark warp crosses a light weft.
        face: "front", or "back": turned over about a vertical line; the loom's parts turn with it.
        origin: the corner of end 1 and pick 1: weaving software has it beside threading and treadling.
        cell_px: pixels a crossing; see `draw_drawdown`.
        repeats: how often the repeat is drawn each way; None draws small ones until 24 threads show. The
            first repeat is outlined where there are more.

    Returns:
        sRGB-encoded 8-bit pixels [height, width, 3].

    Raises:
        InputError: as `draw_drawdown`.

    Warns:
        LoomlightWarning: pixels are means of several crossings.
    """
    if repeats is None:
        across, along = (max(1, -(-_LEGIBLE_THREADS // count)) for count in (draft.ends, draft.picks))
    else:
        across = along = repeats
    view = draft_view(draft, face, origin, (along, across))
    plan = drawn_plan(draft)
    parts = None if plan is None else loom_parts(plan, view)
    cells = _framed_cells(view, parts)
    if parts is not None and not _fits(cells) and cell_px is None:
        parts, cells = None, _framed_cells(view, None)
    if not _fits(cells) and cell_px is None:
        return _interlacement(view, 1) if _fits(view.warp_up.shape) else _reduced(view)
    return _framed(view, parts, _cell(cell_px, cells), outline=across * along > 1)


def draw_layer(
    draft: Draft,
    layer: LayerDraft,
    *,
    face: Face = "front",
    origin: Origin = "bottom-left",
    cell_px: int | None = None,
    repeats: int = 1,
) -> Pixels:
    """The interlacement of one layer alone, in which threads of several cloths may show; see `draw_drawdown`.

    Args:
        draft: the whole draft, whose colours the threads have.
        layer: the layer.
        face: as of `draw_drawdown`, as are the others.
        origin: the corner of end 1 and pick 1.
        cell_px: pixels a crossing.
        repeats: how often the repeat is drawn each way.

    Raises:
        InputError: as `draw_drawdown`.
    """
    bare = Draft(layer.warp_up)
    view = draft_view(bare, face, origin, (repeats, repeats))
    if cell_px is None and not _fits(view.warp_up.shape):
        raise InputError(
            f"The layer has {bare.ends} ends and {bare.picks} picks where cloths change places, too many to "
            f"draw one by one: pictures have at most {MAXIMUM_PICTURE_PX / 1e6:.0f} million pixels."
        )
    across, along = slice(None, None, -1 if view.first_on_right else 1), slice(None, None, -1)
    down = slice(None) if view.first_on_top else along
    shown = replace(
        view,
        warp=_encoded(draft.warp, draft.ends, _WARP),
        weft=_encoded(draft.weft, draft.picks, _WEFT),
        end=np.tile(layer.end, (repeats, repeats))[down, across],
        pick=np.tile(layer.pick, (repeats, repeats))[down, across],
    )
    return _interlacement(shown, _cell(cell_px, view.warp_up.shape))


# ------------------------------------------------------------------------------------------- what is drawn


@dataclass(frozen=True)
class DraftView:
    """The cloth as it is seen, row 0 at the top.

    Attributes:
        warp_up: bool [picks, ends].
        warp: encoded colours of the ends [ends, 3] in [0, 1].
        weft: encoded colours of the picks [picks, 3].
        repeat: picks and ends of one repeat.
        first_on_top: whether pick 1 is the uppermost, else the lowest.
        first_on_right: whether end 1 is the rightmost, else the leftmost.
        end: the end of each crossing [picks, ends], where it is not that of its column.
        pick: the pick of each crossing, likewise.
    """

    warp_up: NDArray[np.bool_]
    warp: NDArray[np.float32]
    weft: NDArray[np.float32]
    repeat: tuple[int, int]
    first_on_top: bool
    first_on_right: bool
    end: NDArray[np.uint16] | None = None
    pick: NDArray[np.uint16] | None = None

    def colours(self, row: int) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Of the ends [ends, 3] and of the pick, [3] or [ends, 3], of one row."""
        if self.end is None or self.pick is None:
            return self.warp, self.weft[row]
        return self.warp[self.end[row]], self.weft[self.pick[row]]


@dataclass(frozen=True)
class LoomParts:
    """The loom's tables in the order they are drawn, row 0 at the top; True is a filled cell."""

    threading: NDArray[np.bool_]
    tieup: NDArray[np.bool_] | None
    treadling: NDArray[np.bool_]


def draft_view(draft: Draft, face: str, origin: str, times: tuple[int, int]) -> DraftView:
    """The cloth of a draft as it is seen from a face, with end 1 and pick 1 in a corner.

    Args:
        times: how often the repeat is shown, along the warp and across it.

    Raises:
        InputError: another face or origin, no repeats, or more than 16384 threads.
    """
    if face not in ("front", "back"):
        raise InputError(f'The face "{face}" is not known; it is "front" or "back".')
    if origin not in get_args(Origin):
        raise InputError(f'The origin "{origin}" is not known; it is one of {", ".join(get_args(Origin))}.')
    if min(times) < 1:
        raise InputError(f"{min(times)} repeats cannot be drawn; at least 1 can.")
    picks, ends = draft.drawdown.shape
    if max(times) > 1 and max(picks * times[0], ends * times[1]) > MAXIMUM_PICTURE_SIDE_PX:
        raise InputError(
            f"{times[0]} repeats of {picks} picks and {times[1]} of {ends} ends are too many to draw; "
            f"at most {MAXIMUM_PICTURE_SIDE_PX} threads are drawn each way."
        )
    back = face == "back"
    # The cloth turned over has end 1 on the other side.
    top, right = origin.startswith("top"), origin.endswith("right") != back
    rows, columns = (slice(None, None, 1 if top else -1), slice(None, None, -1 if right else 1))
    warp_up = np.tile(draft.drawdown, times)[rows, columns]
    warp = np.tile(_encoded(draft.warp, ends, _WARP), (times[1], 1))[columns]
    weft = np.tile(_encoded(draft.weft, picks, _WEFT), (times[0], 1))[rows]
    return DraftView(~warp_up if back else warp_up, warp, weft, (picks, ends), top, right)


def _encoded(threads: Threads, count: int, default: NDArray[np.float64]) -> NDArray[np.float32]:
    colors = np.tile(default, (count, 1)) if threads.colors is None else threads.colors
    return linear_to_srgb(colors).astype(np.float32)


def drawn_plan(draft: Draft) -> LoomPlan | None:
    """The plan that is drawn around a drawdown, the draft's or a derived one; None of too many shafts."""
    plan = draft.loom
    if plan is None:
        try:
            plan = derive_loom_plan(draft, shaft_limit=MAXIMUM_DERIVED_SHAFTS)
        except InputError:
            return None
    return plan if max(plan.shafts, plan.treadles) <= MAXIMUM_DRAWN_SHAFTS else None


def loom_parts(plan: LoomPlan, view: DraftView) -> LoomParts:
    """The tables of a plan, turned as the view is."""
    picks, ends = view.warp_up.shape
    rows = slice(None, None, 1 if view.first_on_top else -1)
    columns = slice(None, None, -1 if view.first_on_right else 1)
    threading = _fill(membership(plan.threading, plan.shafts), ends).T[::-1, columns]
    if plan.tieup is None or plan.treadling is None:
        lifts = moved_shafts(replace(plan, tieup=None, treadling=None))
        return LoomParts(threading, None, _fill(lifts, picks)[rows])
    tieup = membership(plan.tieup, plan.shafts).T[::-1]
    pressed = membership(plan.treadling, len(plan.tieup))
    return LoomParts(threading, tieup, _fill(pressed, picks)[rows])


def _fill(rows: NDArray[np.bool_], count: int) -> NDArray[np.bool_]:
    return rows[np.arange(count) % len(rows)]


# --------------------------------------------------------------------------------------------------- sizes

# In cells: around everything, between the parts, and the breadth of a colour bar.
_MARGIN, _SPACE, _BAR = 1, 1, 1


def _framed_cells(view: DraftView, parts: LoomParts | None) -> tuple[int, int]:
    """Height and width of the whole picture in cells."""
    picks, ends = view.warp_up.shape
    above = _BAR + _SPACE + (0 if parts is None else parts.threading.shape[0] + _SPACE)
    beside = _BAR + _SPACE + (0 if parts is None else parts.treadling.shape[1] + _SPACE)
    return picks + above + 2 * _MARGIN, ends + beside + 2 * _MARGIN


def _cell(requested: int | None, cells: tuple[int, ...]) -> int:
    most = max(cells)
    if requested is None:
        comfortable = min(_MAX_CELL_PX, _COMFORTABLE_PX // most)
        return max(1, comfortable, min(_MIN_LEGIBLE_CELL_PX, _LARGE_PX // most))
    if requested >= 1 and _fits(cells, requested):
        return requested
    largest = next((cell for cell in range(MAXIMUM_PICTURE_SIDE_PX // most, 0, -1) if _fits(cells, cell)), 0)
    choices = {0: "leave it out for a smaller scale", 1: "1 pixel a crossing would do"}
    would_do = choices.get(largest, f"1 to {largest} pixels a crossing would do")
    raise InputError(
        f"cell_px = {requested} is out of range for a drawing of {cells[1]} x {cells[0]} crossings: pictures "
        f"have at most {MAXIMUM_PICTURE_SIDE_PX} pixels a side and {MAXIMUM_PICTURE_PX / 1e6:.0f} million in "
        f"all; {would_do}."
    )


def _fits(cells: tuple[int, ...], cell: int = 1) -> bool:
    """Whether a picture of so many cells, `cell` pixels each, is no larger than allowed."""
    # One pixel more than the cells themselves closes the last line of a grid.
    closing = 1 if cell > 1 else 0
    height, width = (count * cell + closing for count in cells)
    return max(height, width) <= MAXIMUM_PICTURE_SIDE_PX and height * width <= MAXIMUM_PICTURE_PX


# ------------------------------------------------------------------------------------------------- threads


def _interlacement(view: DraftView, cell: int) -> Pixels:
    """The drawdown in thread colours, `cell` pixels a crossing."""
    picks, ends = view.warp_up.shape
    pixels = np.empty((picks * cell, ends * cell, 3), dtype=np.uint8)
    for pick in range(picks):
        if cell < 3:
            warp, weft = view.colours(pick)
            row = _quantised(np.where(view.warp_up[pick, :, None], warp, weft))
            pixels[pick * cell : (pick + 1) * cell] = np.repeat(row, cell, axis=0)
        else:
            pixels[pick * cell : (pick + 1) * cell] = _one_pick(view, pick, cell)
    return pixels


def _reduced(view: DraftView) -> Pixels:
    """The drawdown with as few crossings a pixel as are allowed: means of linear colours."""
    picks, ends = view.warp_up.shape
    step = next(step for step in range(2, ends + picks) if _fits((-(-picks // step), -(-ends // step))))
    warnings.warn(
        f"{ends} ends and {picks} picks are too many to draw one by one: each pixel is the mean of "
        f"{step} x {step} crossings.",
        LoomlightWarning,
        stacklevel=3,
    )
    warp, weft = srgb_to_linear(view.warp), srgb_to_linear(view.weft)
    starts = np.arange(0, ends, step)
    count = np.diff(np.append(starts, ends))[:, None]
    rows = []
    for first in range(0, picks, step):
        up = view.warp_up[first : first + step]
        # Of each end: how often it is on top, and the sum of the picks that are on top of it.
        total = up.sum(axis=0)[:, None] * warp + (~up).T.astype(np.float64) @ weft[first : first + step]
        means = np.add.reduceat(total, starts, axis=0) / (count * len(up))
        rows.append(_quantised(linear_to_srgb(means).astype(np.float32)))
    return np.stack(rows)


def _one_pick(view: DraftView, pick: int, cell: int) -> Pixels:
    """The row of crossings of one pick, [cell, ends·cell, 3]."""
    picks, ends = view.warp_up.shape
    up = view.warp_up[pick]
    profile = _profile(cell)
    # Lighting along a thread: it darkens where it is about to dive under the next one.
    warp_light = _dive(up & ~view.warp_up[pick - 1], up & ~view.warp_up[(pick + 1) % picks], cell)
    weft_light = _dive(~up & np.roll(up, 1), ~up & np.roll(up, -1), cell)
    # Axes: row in the cell, end, column in the cell, colour.
    of_ends, of_pick = view.colours(pick)
    warp = of_ends[None, :, None] * (profile[None, None] * warp_light.T[:, :, None])[..., None]
    weft = of_pick.reshape(1, -1, 1, 3) * (profile[:, None, None] * weft_light[None])[..., None]
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


def _framed(view: DraftView, parts: LoomParts | None, cell: int, *, outline: bool) -> Pixels:
    picks, ends = view.warp_up.shape
    height, width = _framed_cells(view, parts)
    # Lines close the grids on the right and at the bottom, where cells are large enough to have lines.
    closing = 1 if cell > 1 else 0
    canvas = np.tile(_PAPER, (height * cell + closing, width * cell + closing, 1))
    top = height - _MARGIN - picks
    left = _MARGIN
    right = left + ends + _SPACE
    # Groups of threads are counted from end 1 and pick 1, shafts from the bottom, treadles from the left.
    from_right, from_top = view.first_on_right, view.first_on_top
    _put(canvas, _interlacement(view, cell), top, left, cell)
    _put(canvas, _bar(view.warp[None], cell, right=from_right), _MARGIN, left, cell)
    _put(canvas, _bar(view.weft[:, None], cell, top=from_top), top, width - _MARGIN - _BAR, cell)
    if parts is not None:
        above = _MARGIN + _BAR + _SPACE
        _put(canvas, _grid(parts.threading, cell, right=from_right), above, left, cell)
        _put(canvas, _grid(parts.treadling, cell, top=from_top), top, right, cell)
        if parts.tieup is not None:
            _put(canvas, _grid(parts.tieup, cell), above, right, cell)
    if outline:
        _outline(canvas, view, top, left, cell)
    return canvas


def _put(canvas: Pixels, part: Pixels, row: int, column: int, cell: int) -> None:
    y, x = row * cell, column * cell
    canvas[y : y + part.shape[0], x : x + part.shape[1]] = part


def _bar(colors: NDArray[np.float32], cell: int, *, right: bool = False, top: bool = False) -> Pixels:
    """Cells in thread colours, with lines between them where there is room; see `_rule`."""
    return _ruled(_quantised(colors), cell, right, top)


def _grid(filled: NDArray[np.bool_], cell: int, *, right: bool = False, top: bool = False) -> Pixels:
    """A table of the loom: ink where `filled`, with lines where there is room; see `_rule`."""
    return _ruled(np.where(filled[..., None], _INK, _EMPTY).astype(np.uint8), cell, right, top)


def _ruled(cells: Pixels, cell: int, right: bool, top: bool) -> Pixels:
    pixels = np.repeat(np.repeat(cells, cell, axis=0), cell, axis=1)
    if cell > 1:
        pixels = np.pad(pixels, ((0, 1), (0, 1), (0, 0)), mode="edge")
        _rule(pixels, cell, right, top)
    return pixels


def _rule(pixels: Pixels, cell: int, right: bool, top: bool) -> None:
    """Lines between cells, firmer around groups of four, counted from the right or left and top or bottom."""
    if cell < 4:
        pixels[[0, -1]] = _GROUP_LINE
        pixels[:, [0, -1]] = _GROUP_LINE
        return
    pixels[::cell] = _LINE
    pixels[:, ::cell] = _LINE
    group = _GROUP * cell
    pixels[:: group if top else -group] = _GROUP_LINE
    pixels[:, :: -group if right else group] = _GROUP_LINE
    pixels[[0, -1]] = _GROUP_LINE
    pixels[:, [0, -1]] = _GROUP_LINE


def _outline(canvas: Pixels, view: DraftView, top: int, left: int, cell: int) -> None:
    """A frame around the first repeat, in the corner of end 1 and pick 1."""
    (picks, ends), (all_picks, all_ends) = view.repeat, view.warp_up.shape
    first_row = top + (0 if view.first_on_top else all_picks - picks)
    first_column = left + (all_ends - ends if view.first_on_right else 0)
    thick = max(1, cell // 9)
    # Lines lie outside the cloth at its edges, and on both sides of the boundary within it.
    y, x = (
        (first * cell) - (thick if outer else thick // 2)
        for first, outer in ((first_row, view.first_on_top), (first_column, not view.first_on_right))
    )
    bottom, right = (
        (last * cell) - (0 if outer else thick // 2)
        for last, outer in (
            (first_row + picks, not view.first_on_top),
            (first_column + ends, view.first_on_right),
        )
    )
    canvas[y : y + thick, x : right + thick] = _REPEAT_LINE
    canvas[bottom : bottom + thick, x : right + thick] = _REPEAT_LINE
    canvas[y : bottom + thick, x : x + thick] = _REPEAT_LINE
    canvas[y : bottom + thick, right : right + thick] = _REPEAT_LINE


draw_by(Draft, draw_drawdown)
