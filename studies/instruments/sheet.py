"""Contact sheets: pictures in a grid with headings, row labels and captions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from loomlight.evaluation.metrics import PictureError
from studies.harness.study import Figures, Found, Pixels

_PAPER, _INK, _FAINT = (255, 255, 255), (20, 20, 20), (110, 110, 110)
_GAP, _MARGIN = 6, 14
_TITLE, _HEADING, _CAPTION = 20, 16, 13
# The one font that comes with Pillow has Latin letters only.
_SPELT = str.maketrans(
    {"α": "alpha", "β": "beta", "×": "x", "–": "-", "−": "-", "→": "to", "²": "^2", "³": "^3", "°": " deg"}
)


@dataclass(frozen=True, eq=False)
class Tile:
    """A picture of a sheet and what stands below it; no picture leaves the place empty."""

    picture: Pixels | None
    caption: str = ""


@dataclass(frozen=True)
class Row:
    """A row of tiles, and what stands above its left end."""

    label: str
    tiles: Sequence[Tile]


def contact_sheet(title: str, columns: Sequence[str], rows: Sequence[Row], note: str = "") -> Pixels:
    """The sheet [height, width, 3].

    Args:
        columns: headings of all rows; none leaves them out.
        note: below the title; its lines are wrapped.
    """
    widths, heights = _cells(columns, rows)
    width = max(2 * _MARGIN + sum(widths) + _GAP * (len(widths) - 1), 640)
    notes = _wrapped(note, width - 2 * _MARGIN)
    top = _MARGIN + _TITLE + 10 + (_CAPTION + 5) * len(notes) + (_HEADING + 10 if columns else 0)
    below = [_line(row.label, _HEADING) for row in rows]
    captions = [_line("".join(tile.caption for tile in row.tiles), _CAPTION) for row in rows]
    height = top + sum(below) + sum(heights) + sum(captions) + _GAP * len(rows) + _MARGIN
    sheet = Image.new("RGB", (width, height), _PAPER)
    draw = ImageDraw.Draw(sheet)
    _write(draw, (_MARGIN, _MARGIN), title, _TITLE)
    for number, line in enumerate(notes):
        _write(draw, (_MARGIN, _MARGIN + _TITLE + 8 + number * (_CAPTION + 5)), line, _CAPTION, _FAINT)
    lefts = [_MARGIN + sum(widths[:k]) + _GAP * k for k in range(len(widths))]
    for left, heading in zip(lefts, columns, strict=False):
        _write(draw, (left, top - _HEADING - 8), heading, _HEADING)
    for number, row in enumerate(rows):
        if row.label:
            _write(draw, (_MARGIN, top + 3), row.label, _HEADING)
        top += below[number]
        for left, tile in zip(lefts, row.tiles, strict=False):
            if tile.picture is not None:
                sheet.paste(Image.fromarray(tile.picture), (left, top))
            _write(draw, (left, top + heights[number] + 2), tile.caption, _CAPTION, _FAINT)
        top += heights[number] + captions[number] + _GAP
    return np.asarray(sheet)


class PictureTable:
    """Pictures in rows and columns: a sheet shows them, and single ones are kept as "ROW-COLUMN"."""

    def __init__(self, title: str, columns: Sequence[str]) -> None:
        self.title, self.columns = title, list(columns)
        self.rows: list[Row] = []
        self.pictures: dict[str, Pixels] = {}

    def add(self, label: str, tiles: Sequence[Tile], errors: Sequence[PictureError] = ()) -> None:
        """Adds a row.

        Args:
            tiles: one a column.
            errors: of the first columns, whose FLIP maps stand below, and are kept as "ROW-COLUMN-FLIP".
        """
        self.rows.append(Row(label, tiles))
        for column, tile in zip(self.columns, tiles, strict=True):
            if tile.picture is not None:
                self.pictures[f"{label}-{column}"] = tile.picture
        maps = [error.flip_picture for error in errors]
        for column, picture in zip(self.columns, maps, strict=False):
            self.pictures[f"{label}-{column}-FLIP"] = picture
        if maps:
            self.rows.append(Row("", [Tile(picture) for picture in maps]))

    def found(self, figures: Figures, note: str) -> Found:
        """Figures, and all pictures with a note on their sheet."""
        return Found(figures, contact_sheet(self.title, self.columns, self.rows, note), self.pictures)


def error_caption(error: PictureError) -> str:
    """What stands below a picture of its error."""
    return f"MSE {error.mse:.1e}, FLIP {error.flip:.3f}"


def in_two_rows(tiles: Sequence[Tile]) -> list[Row]:
    """Tiles without headings in two rows, the first no shorter than the second."""
    half = -(-len(tiles) // 2)
    return [Row("", tiles[:half]), Row("", tiles[half:])]


def _cells(columns: Sequence[str], rows: Sequence[Row]) -> tuple[list[int], list[int]]:
    """Widths of columns, which hold all that stands in them, and heights of pictures by row."""
    widths = [_length(heading, _HEADING) for heading in columns]
    widths += [0] * (max(len(row.tiles) for row in rows) - len(widths))
    heights = []
    for row in rows:
        sizes = [(0, 0) if tile.picture is None else tile.picture.shape[:2] for tile in row.tiles]
        heights.append(max(size[0] for size in sizes))
        for number, tile in enumerate(row.tiles):
            widths[number] = max(widths[number], sizes[number][1], _length(tile.caption, _CAPTION))
    return widths, heights


def _length(text: str, size: int) -> int:
    """Pixels that a text takes, and a little room after it."""
    return int(_font(size).getlength(_spelt(text))) + 8 if text else 0


def _line(text: str, size: int) -> int:
    return size + 8 if text else 0


def _write(
    draw: ImageDraw.ImageDraw,
    position: tuple[int, int],
    text: str,
    size: int,
    ink: tuple[int, int, int] = _INK,
) -> None:
    draw.text(position, _spelt(text), fill=ink, font=_font(size))


def _wrapped(text: str, width: int) -> list[str]:
    lines: list[str] = []
    for word in text.split():
        longer = f"{lines[-1]} {word}" if lines else word
        if lines and _length(longer, _CAPTION) <= width:
            lines[-1] = longer
        else:
            lines.append(word)
    return lines


def _font(size: int) -> ImageFont.FreeTypeFont | ImageFont.ImageFont:
    return ImageFont.load_default(size)


def _spelt(text: str) -> str:
    return text.translate(_SPELT)
