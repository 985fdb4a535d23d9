"""Drafts on paper, as PDF of lines and areas: as large as the cloth, with rulers in centimetres and inches.

A drawing larger than the paper goes over several sheets, which are laid edge to edge. As on a screen
(`drawing.py`), the threading stands above the drawdown and the treadling beside it.
"""

from __future__ import annotations

import math
import os
from dataclasses import dataclass
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.core.extras import import_extra
from loomlight.core.files import replacing
from loomlight.weave.draft import Draft
from loomlight.weave.drawing import DraftView, Face, LoomParts, Origin, draft_view, drawn_plan, loom_parts
from loomlight.weave.textile import CM_PER_INCH, DEFAULT_SETT_PER_CM, per_inch, sett_per_cm

Paper = Literal["a4", "a3", "a2", "a1", "a0", "letter", "legal", "tabloid"]
# Upright, millimetres: ISO 216, and ANSI's.
PAPERS_MM: dict[str, tuple[float, float]] = {
    "a4": (210, 297), "a3": (297, 420), "a2": (420, 594), "a1": (594, 841), "a0": (841, 1189),
    "letter": (215.9, 279.4), "legal": (215.9, 355.6), "tabloid": (279.4, 431.8),
}  # fmt: skip
MAX_SHEETS = 100
# Areas that are drawn, some 30 bytes each in the file.
MAX_AREAS = 2_000_000
_POINTS_PER_MM = 72 / 25.4
# Millimetres on paper: around a sheet, which printers leave blank; a shaft's or treadle's row; between parts.
_EDGE, _ROW, _SPACE = 12.0, 3.0, 2.0
_RULER, _HEADING, _HEADING_WIDTH, _TEXT = 7.0, 12.0, 120.0, 2.6
# Closer ticks run together.
_CLOSEST_TICKS = 0.7
# Of a thread's spacing: what is left open on each side, so that threads are told apart.
_OPEN = 0.06
_GROUND, _LINE, _INK = "#4a4a4a", "#9a9a9a", "#000000"


def write_draft_pdf(
    draft: Draft,
    path: str | os.PathLike[str],
    *,
    scale: float = 1.0,
    paper: Paper = "a4",
    face: Face = "front",
    origin: Origin = "top-right",
    drawdown: bool = False,
) -> None:
    """Writes a draft as PDF, so large that the cloth would cover its drawdown.

    Args:
        draft: any; `loom.warped` makes one of a whole warp. Without spacings it has 20 threads a centimetre.
        scale: times the size of the cloth, 0.01 to 100; the rulers measure cloth at any scale.
        paper: of a sheet, upright or lying, whichever takes fewer.
        face: the side that is seen.
        origin: the corner of end 1 and pick 1.
        drawdown: leave out threading, tie-up and treadling.

    Raises:
        InputError: a scale, face, origin or paper that is none, more than 100 sheets or 2 million areas, or
            a file that cannot be written.
        MissingDependencyError: reportlab is not installed.
    """
    if not 0.01 <= scale <= 100:
        raise InputError(f"The scale {scale:g} is out of range: write 0.01 to 100; 1 is the cloth's size.")
    if paper not in PAPERS_MM:
        raise InputError(f'The paper "{paper}" is not known: write one of {", ".join(get_args(Paper))}.')
    sheet = _laid_out(draft, scale, face, origin, drawdown)
    lying, columns, rows = _sheets(sheet, PAPERS_MM[paper])
    if columns * rows > MAX_SHEETS:
        raise InputError(
            f"At scale {scale:g} the draft covers {columns * rows} sheets of {paper}; at most {MAX_SHEETS} "
            "are printed: give larger paper, a smaller scale, or fewer ends and picks."
        )
    canvas_module = import_extra("reportlab.pdfgen.canvas", "print", "A draft as PDF")
    size = PAPERS_MM[paper][::-1] if lying else PAPERS_MM[paper]
    with replacing(path) as temporary:
        canvas = canvas_module.Canvas(str(temporary), pagesize=[side * _POINTS_PER_MM for side in size])
        canvas.setTitle(draft.title or "draft")
        canvas.setCreator("loomlight")
        # Drawn once; sheets show parts of it.
        canvas.beginForm("draft", 0, 0, sheet.width * _POINTS_PER_MM, sheet.height * _POINTS_PER_MM)
        _draw(_Pen(canvas, sheet.height), sheet, _heading(draft, sheet, scale))
        canvas.endForm()
        for number in range(columns * rows):
            row, column = divmod(number, columns)
            _show_part(canvas, sheet, size, column, row)
            _say(canvas, size, f"{number + 1} of {columns * rows}: row {row + 1}, column {column + 1}")
            canvas.showPage()
        canvas.save()


# -------------------------------------------------------------------------------------------- where all lies


@dataclass(frozen=True, eq=False)
class _Sheet:
    """A drawing in millimetres on paper, from its upper left corner, x to the right and y downwards.

    Attributes:
        view: the cloth.
        parts: of the loom; None for the drawdown alone.
        x: edges of the ends as they are seen, from the left [ends + 1].
        y: edges of the picks, from the top [picks + 1].
        scale: millimetres on paper a millimetre of cloth.
        width: of all.
        height: of all.
    """

    view: DraftView
    parts: LoomParts | None
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    scale: float
    width: float
    height: float


def _laid_out(draft: Draft, scale: float, face: Face, origin: Origin, drawdown: bool) -> _Sheet:
    view = draft_view(draft, face, origin, (1, 1))
    plan = None if drawdown else drawn_plan(draft)
    parts = None if plan is None else loom_parts(plan, view)
    areas = draft.picks + _count_floats(view.warp_up)
    if areas > MAX_AREAS:
        raise InputError(
            f"The draft would be drawn of {areas / 1e6:.3g} million areas, and at most "
            f"{MAX_AREAS / 1e6:.0f} million are printed: give fewer ends and picks, or draw it as a picture."
        )
    spacing = []
    for threads, count, is_turned in (
        (draft.warp, draft.ends, view.first_on_right),
        (draft.weft, draft.picks, not view.first_on_top),
    ):
        each = threads.spacing_mm
        each = np.full(count, 10 / DEFAULT_SETT_PER_CM) if each is None else each
        spacing.append(scale * (each[::-1] if is_turned else each))
    above = _HEADING + (0 if parts is None else len(parts.threading) * _ROW + _SPACE) + _ROW + _SPACE
    beside = _SPACE + _ROW + (0 if parts is None else _SPACE + parts.treadling.shape[1] * _ROW)
    x = 2 * _RULER + np.concatenate([[0], np.cumsum(spacing[0])])
    y = above + np.concatenate([[0], np.cumsum(spacing[1])])
    width = max(float(x[-1]) + beside, _HEADING_WIDTH)
    return _Sheet(view, parts, x, y, scale, width, float(y[-1]) + 2 * _RULER + 1)


def _count_floats(warp_up: NDArray[np.bool_]) -> int:
    starts = warp_up.copy()
    starts[1:] &= ~warp_up[:-1]
    return int(starts.sum())


def _sheets(sheet: _Sheet, paper: tuple[float, float]) -> tuple[bool, int, int]:
    """Whether paper lies, and columns and rows of it: as few sheets as can be, upright if as many."""
    found = []
    for lying in (False, True):
        width, height = (side - 2 * _EDGE for side in (paper[::-1] if lying else paper))
        found.append((lying, math.ceil(sheet.width / width), math.ceil(sheet.height / height)))
    return min(found, key=lambda each: each[1] * each[2])


def _show_part(canvas: Any, sheet: _Sheet, size: tuple[float, float], column: int, row: int) -> None:
    """One sheet's part of the drawing, with a frame along which sheets are cut and joined."""
    width, height = size[0] - 2 * _EDGE, size[1] - 2 * _EDGE
    canvas.saveState()
    window = canvas.beginPath()
    window.rect(*(_POINTS_PER_MM * length for length in (_EDGE, _EDGE, width, height)))
    canvas.clipPath(window, stroke=0, fill=0)
    canvas.translate(
        _POINTS_PER_MM * (_EDGE - column * width),
        _POINTS_PER_MM * (size[1] - _EDGE - sheet.height + row * height),
    )
    canvas.doForm("draft")
    canvas.restoreState()
    if sheet.width > width or sheet.height > height:
        canvas.setLineWidth(0.2)
        canvas.rect(*(_POINTS_PER_MM * length for length in (_EDGE, _EDGE, width, height)))


def _say(canvas: Any, size: tuple[float, float], text: str) -> None:
    canvas.setFont("Helvetica", _TEXT * _POINTS_PER_MM)
    canvas.drawRightString((size[0] - _EDGE) * _POINTS_PER_MM, (_EDGE - 5) * _POINTS_PER_MM, f"sheet {text}")


def _heading(draft: Draft, sheet: _Sheet, scale: float) -> list[str]:
    """What stands above the draft."""
    size = (float(edges[-1] - edges[0]) / scale / 10 for edges in (sheet.x, sheet.y))
    width, height = size
    setts = []
    for name, threads in (("ends", draft.warp), ("picks", draft.weft)):
        sett = sett_per_cm(threads) or DEFAULT_SETT_PER_CM
        setts.append(f"{sett:.3g} {name}/cm ({per_inch(sett):.3g} {'epi' if name == 'ends' else 'ppi'})")
    return [
        " ".join(draft.title.split())[:80] or "untitled",
        f"{draft.ends} ends, {draft.picks} picks; {', '.join(setts)}",
        f"{width:.3g} x {height:.3g} cm ({width / CM_PER_INCH:.3g} x {height / CM_PER_INCH:.3g} in), "
        + ("as large as the cloth" if scale == 1 else f"{scale:g} times the size of the cloth"),
    ]


# --------------------------------------------------------------------------------------------------- drawing


class _Pen:
    """Draws in millimetres from the upper left corner of a drawing so high."""

    def __init__(self, canvas: Any, height: float) -> None:
        self._canvas, self._height = canvas, height

    def ink(self, colour: str) -> None:
        """What areas and texts are filled with from here on."""
        self._canvas.setFillColor(colour)

    def area(self, left: float, top: float, right: float, bottom: float) -> None:
        """Fills an area."""
        lengths = (left, self._height - bottom, right - left, bottom - top)
        self._canvas.rect(*(_POINTS_PER_MM * length for length in lengths), stroke=0, fill=1)

    def line(self, left: float, top: float, right: float, bottom: float) -> None:
        """A thin line."""
        ends = (left, self._height - top, right, self._height - bottom)
        self._canvas.line(*(_POINTS_PER_MM * length for length in ends))

    def text(self, x: float, y: float, text: str, *, size: float = _TEXT, is_centred: bool = False) -> None:
        """A line of text on a baseline."""
        self._canvas.setFont("Helvetica", size * _POINTS_PER_MM)
        # The fonts that every reader of PDF has know Latin letters alone.
        shown = text.encode("cp1252", "replace").decode("cp1252")
        draw = self._canvas.drawCentredString if is_centred else self._canvas.drawString
        draw(x * _POINTS_PER_MM, (self._height - y) * _POINTS_PER_MM, shown)

    def lines(self, colour: str, width: float) -> None:
        """How lines are drawn from here on."""
        self._canvas.setStrokeColor(colour)
        self._canvas.setLineWidth(width * _POINTS_PER_MM)


def _draw(pen: _Pen, sheet: _Sheet, heading: list[str]) -> None:
    pen.ink(_INK)
    for number, line in enumerate(heading):
        pen.text(0, 3 + 3.2 * number, line, size=_TEXT if number else 3.2)
    _draw_threads(pen, sheet)
    _draw_colours(pen, sheet)
    if sheet.parts is not None:
        _draw_loom(pen, sheet, sheet.parts)
    _draw_rulers(pen, sheet)


def _hex(encoded: NDArray[np.float32]) -> str:
    red, green, blue = np.rint(encoded * 255).astype(int).tolist()
    return f"#{red:02x}{green:02x}{blue:02x}"


def _draw_threads(pen: _Pen, sheet: _Sheet) -> None:
    """Every pick from side to side, and over it the floats of the ends."""
    view, x, y = sheet.view, sheet.x, sheet.y
    pen.ink(_GROUND)
    pen.area(x[0], y[0], x[-1], y[-1])
    inset = _OPEN * np.diff(y)
    for pick, colour in enumerate(view.weft):
        pen.ink(_hex(colour))
        pen.area(x[0], y[pick] + inset[pick], x[-1], y[pick + 1] - inset[pick])
    inset = _OPEN * np.diff(x)
    for end, colour in enumerate(view.warp):
        pen.ink(_hex(colour))
        column = np.concatenate([[False], view.warp_up[:, end], [False]]).astype(np.int8)
        turns = np.diff(column)
        for first, last in zip(np.flatnonzero(turns > 0), np.flatnonzero(turns < 0), strict=True):
            pen.area(x[end] + inset[end], y[first], x[end + 1] - inset[end], y[last])


def _draw_colours(pen: _Pen, sheet: _Sheet) -> None:
    """A bar of the ends' colours above the drawdown, and one of the picks' beside it."""
    view, x, y = sheet.view, sheet.x, sheet.y
    for end, colour in enumerate(view.warp):
        pen.ink(_hex(colour))
        pen.area(x[end], y[0] - _SPACE - _ROW, x[end + 1], y[0] - _SPACE)
    for pick, colour in enumerate(view.weft):
        pen.ink(_hex(colour))
        pen.area(x[-1] + _SPACE, y[pick], x[-1] + _SPACE + _ROW, y[pick + 1])


def _draw_loom(pen: _Pen, sheet: _Sheet, parts: LoomParts) -> None:
    """Threading above the warp's colours, treadling beside the weft's, the tie-up in the corner."""
    x, y = sheet.x, sheet.y
    shafts, treadles = len(parts.threading), parts.treadling.shape[1]
    top, left = y[0] - 2 * _SPACE - _ROW - shafts * _ROW, x[-1] + 2 * _SPACE + _ROW
    rows = top + _ROW * np.arange(shafts + 1)
    columns = left + _ROW * np.arange(treadles + 1)
    tables = [(parts.threading, x, rows), (parts.treadling, columns, y)]
    if parts.tieup is not None:
        tables.append((parts.tieup, columns, rows))
    pen.ink(_INK)
    for table, across, down in tables:
        _draw_table(pen, table, across, down)
    for shaft in range(shafts):
        pen.text(x[0] - 4, rows[shafts - shaft] - 0.6, str(shaft + 1), size=2)


def _draw_table(
    pen: _Pen, table: NDArray[np.bool_], across: NDArray[np.float64], down: NDArray[np.float64]
) -> None:
    """Filled cells, and a grid with every fourth line darker; lines that would run together are left out."""
    for row, column in np.argwhere(table).tolist():
        pen.area(across[column], down[row], across[column + 1], down[row + 1])
    for edges, other, is_upright in ((across, down, True), (down, across, False)):
        step = 1 if np.diff(edges).min() >= _CLOSEST_TICKS else 4
        for number in range(0, len(edges), step):
            pen.lines(_INK if number % 4 == 0 else _LINE, 0.1)
            at = edges[number]
            pen.line(*((at, other[0], at, other[-1]) if is_upright else (other[0], at, other[-1], at)))


def _draw_rulers(pen: _Pen, sheet: _Sheet) -> None:
    """Centimetres next to the cloth and inches outside them, below it and on its left, from thread 1."""
    pen.ink(_INK)
    pen.lines(_INK, 0.1)
    x, y, view = sheet.x, sheet.y, sheet.view
    for number, (unit_mm, steps) in enumerate(((10.0, (10, 2, 1)), (10 * CM_PER_INCH, (8, 4, 2, 1)))):
        below, beside = y[-1] + 0.5 + number * _RULER, x[0] - 0.5 - number * _RULER
        pen.line(x[0], below, x[-1], below)
        pen.line(beside, y[0], beside, y[-1])
        for at, length, label in _ticks(float(x[-1] - x[0]), unit_mm * sheet.scale, steps):
            place = x[-1] - at if view.first_on_right else x[0] + at
            pen.line(place, below, place, below + length)
            if label:
                pen.text(place, below + length + 2.2, label, size=2.2, is_centred=True)
        for at, length, label in _ticks(float(y[-1] - y[0]), unit_mm * sheet.scale, steps):
            place = y[0] + at if view.first_on_top else y[-1] - at
            pen.line(beside, place, beside - length, place)
            if label:
                pen.text(beside - length - 1.4, place + 0.8, label, size=2.2, is_centred=True)
        unit = "in" if number else "cm"
        pen.text(x[-1] + 1, below + 3, unit, size=2.2)


def _ticks(length: float, unit: float, steps: tuple[int, ...]) -> list[tuple[float, float, str]]:
    """Places, lengths and labels of ticks over `length`, all millimetres on paper.

    Args:
        unit: of the ruler, on paper.
        steps: parts of a unit, finest first; the finest that does not run together is drawn.
    """
    parts = next((count for count in steps if unit / count >= _CLOSEST_TICKS), 1)
    # Where whole units are too close for their numbers, every second, fifth or tenth has one.
    every = next(count for count in (1, 2, 5, 10, 20, 50, 100, 1000, 10**9) if unit * count >= 5)
    found = []
    # A unit more than a hair too long still has its last tick.
    for number in range(int(length / unit * parts + 1e-9) + 1):
        whole, part = divmod(number, parts)
        is_half = parts % 2 == 0 and part == parts // 2
        tick = 3.0 if part == 0 else 2.0 if is_half else 1.2
        found.append((number * unit / parts, tick, str(whole) if part == 0 and whole % every == 0 else ""))
    return found
