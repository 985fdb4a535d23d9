"""Contact sheets: cards of pictures with a title and some lines, as one picture or one page."""

from __future__ import annotations

import base64
import html
import io
import json
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from string import Template
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from loomlight.core.errors import InputError

Pixels = NDArray[np.uint8]

# Pixels of a sheet: what viewers still open.
MAX_SHEET_PX = 2**27
# Of the side of a picture: distances, and the sizes of title and lines.
_GAP, _TITLE, _LINE = 0.05, 0.088, 0.062
_PAPER, _INK, _FAINT = (250, 249, 246), (34, 36, 42), (104, 106, 112)
_PLAIN = str.maketrans({"²": "2", "×": "x", "\u2009": " ", "\u202f": " "})
# Width over height of a whole sheet that is pleasant to look at.
_PROPORTION = 1.5


@dataclass(frozen=True, eq=False)
class Card:
    """One thing on a sheet.

    Attributes:
        title: its name.
        lines: facts.
        pictures: by what they show, square 8-bit sRGB [n, n, 3] of one size.
    """

    title: str
    lines: Sequence[str]
    pictures: dict[str, Pixels]


def card_to_bytes(card: Card) -> bytes:
    """A card as a file of NumPy arrays, without pickled objects."""
    file = io.BytesIO()
    texts = np.frombuffer(json.dumps([card.title, *card.lines]).encode(), np.uint8)
    arrays: dict[str, Any] = card.pictures
    np.savez(file, texts, **arrays)
    return file.getvalue()


def card_from_bytes(content: bytes) -> Card:
    """The card of `card_to_bytes`."""
    with np.load(io.BytesIO(content), allow_pickle=False) as file:
        title, *lines = json.loads(file["arr_0"].tobytes())
        return Card(title, lines, {name: file[name] for name in file.files if name != "arr_0"})


def sheet_picture(cards: Sequence[Card]) -> Pixels:
    """The cards in rows and columns, 8-bit sRGB [height, width, 3].

    Raises:
        InputError: so many cards that the sheet would have more than 2²⁷ pixels.
    """
    side = next(iter(cards[0].pictures.values())).shape[0]
    gap = max(round(_GAP * side), 2)
    title, line = (ImageFont.load_default(max(round(share * side), 8)) for share in (_TITLE, _LINE))
    text_height = round(1.35 * side * (_TITLE + _LINE * max(len(card.lines) for card in cards)))
    width = len(cards[0].pictures) * (side + gap // 2) - gap // 2
    height = side + gap // 2 + text_height
    columns = _columns(len(cards), width + 2 * gap, height + 2 * gap)
    rows = -(-len(cards) // columns)
    whole = columns * (width + 2 * gap), rows * (height + 2 * gap)
    if whole[0] * whole[1] > MAX_SHEET_PX:
        raise InputError(
            f"A sheet of {len(cards)} cards would have {whole[0]} by {whole[1]} pixels: give a smaller size."
        )
    sheet = Image.new("RGB", whole, _PAPER)
    draw = ImageDraw.Draw(sheet)
    for number, card in enumerate(cards):
        x, y = (number % columns) * (width + 2 * gap) + gap, number // columns * (height + 2 * gap) + gap
        for place, picture in enumerate(card.pictures.values()):
            sheet.paste(Image.fromarray(picture), (x + place * (side + gap // 2), y))
        y += side + gap // 2
        draw.text((x, y), _fitting(card.title, title, width), _INK, font=title)
        y += round(1.35 * _TITLE * side)
        for text in card.lines:
            draw.text((x, y), _fitting(text, line, width), _FAINT, font=line)
            y += round(1.35 * _LINE * side)
    return np.asarray(sheet)


def sheet_page(cards: Sequence[Card], heading: str) -> str:
    """The cards as one HTML page that needs no other file."""
    articles = "\n".join(_article(card) for card in cards)
    page = Path(__file__).with_name("contact_sheet.html.in").read_text(encoding="utf-8")
    return Template(page).substitute(heading=html.escape(heading), articles=articles)


def _columns(count: int, width: int, height: int) -> int:
    """As many as make the sheet's proportion most pleasant."""

    def off(columns: int) -> float:
        return abs(np.log(columns * width / (-(-count // columns) * height) / _PROPORTION))

    return min(range(1, count + 1), key=off)


def _fitting(text: str, font: ImageFont.FreeTypeFont | ImageFont.ImageFont, width: int) -> str:
    """The text in characters that Pillow's own font has, cut at its end where it is wider than its place."""
    # It has no letters with accents: they lose these.
    letters = unicodedata.normalize("NFKD", text.translate(_PLAIN))
    text = "".join(letter for letter in letters if not unicodedata.combining(letter))
    if font.getlength(text) <= width:
        return text
    while text and font.getlength(f"{text}…") > width:
        text = text[:-1]
    return f"{text.rstrip()}…"


def _article(card: Card) -> str:
    pictures = "".join(
        f'<img src="data:image/png;base64,{_base64(picture)}" width="{picture.shape[1]}" '
        f'height="{picture.shape[0]}" alt="{html.escape(f"{card.title}: {shown}")}">'
        for shown, picture in card.pictures.items()
    )
    lines = "<br>".join(html.escape(line) for line in card.lines)
    return f"<article><div>{pictures}</div><h2>{html.escape(card.title)}</h2><p>{lines}</p></article>"


def _base64(picture: Pixels) -> str:
    file = io.BytesIO()
    Image.fromarray(picture).save(file, format="PNG", optimize=True)
    return base64.b64encode(file.getvalue()).decode("ascii")
