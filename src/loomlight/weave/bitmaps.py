"""Bitmaps that jacquard looms take: a pixel a crossing, black and white alone; one a cloth, or one a weft.

By weavers' habit black lifts the warp (Schlein and Ziek, The Woven Pixel, 2006, ch. 4). Programs differ in
that, and in where the first pick and the first end lie; `BitmapLayout` says each.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.core.colour import parse_colour
from loomlight.core.errors import InputError
from loomlight.core.files import replacing_all
from loomlight.core.images import picture_size, read_picture_rows, require_pixel_suffix
from loomlight.weave.draft import MAXIMUM_THREADS, Draft, Threads
from loomlight.weave.palette import WARP_COLOUR, WEFT_COLOUR

BITMAP_SUFFIXES = (".png", ".bmp", ".tif", ".tiff")
MAX_WEFTS = 16
_FORMATS = {".png": "PNG", ".bmp": "BMP", ".tif": "TIFF", ".tiff": "TIFF"}
# How far a pixel may be from black or white, of 1: what JPEG or a colour profile does to them is less.
_PURE = 0.1
# Of wefts that a bitmap knows by number alone, sRGB: those that are told apart most easily come first.
WEFT_COLOURS = (
    WEFT_COLOUR, "#b3352c", "#d8a023", "#3f7d4e", "#2f6f9f", "#8a4f8f", "#c7703a", "#6b6b6b",
    "#88a04a", "#4aa3a0", "#d27f96", "#7a5a3c", "#a9b8c9", "#5c4a8a", "#c2b280", "#1f1f1f",
)  # fmt: skip


@dataclass(frozen=True)
class BitmapLayout:
    """How a bitmap is read.

    Attributes:
        lifted: colour of pixels where the warp is lifted.
        first_pick: edge at which pick 1 lies.
        first_end: edge at which end 1 lies.
    """

    lifted: Literal["black", "white"] = "black"
    first_pick: Literal["bottom", "top"] = "bottom"
    first_end: Literal["left", "right"] = "left"

    def turned(self, pixels: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """Crossings [picks, ends] of black pixels [height, width], or the other way round."""
        rows = slice(None, None, -1 if self.first_pick == "bottom" else 1)
        columns = slice(None, None, -1 if self.first_end == "right" else 1)
        turned = pixels[rows, columns]
        return turned if self.lifted == "black" else ~turned


def read_bitmap(path: str | os.PathLike[str], layout: BitmapLayout | None = None) -> NDArray[np.bool_]:
    """The crossings of a bitmap, bool [picks, ends], True where the warp is lifted.

    Args:
        path: PNG, BMP, TIFF or another picture of black and white pixels, at most 16384 each way.
        layout: None for black that lifts, pick 1 at the bottom, end 1 on the left.

    Raises:
        InputError: no picture, one that is too large, or pixels that are neither black nor white.
    """
    width, height = picture_size(path)
    if max(width, height) > MAXIMUM_THREADS:
        raise InputError(
            f"{path} has {width} x {height} pixels; a bitmap has one pixel a crossing, "
            f"and at most {MAXIMUM_THREADS} ends and picks can be used."
        )
    parts = []
    for part in read_picture_rows(path):
        black = part.sum(axis=2) < 3 * 0.5
        other = (np.abs(part - ~black[..., None]) > _PURE).any(axis=2)
        if other.any():
            first = part[other][0]
            raise InputError(
                f"{path} holds pixels that are neither black nor white, the first of them "
                f"{_hex(first)}: save it as a bitmap of 1 bit, or split it at a threshold."
            )
        parts.append(black)
    black = np.concatenate(parts)
    return np.ascontiguousarray((layout or BitmapLayout()).turned(black))


def _hex(encoded: NDArray[np.float64]) -> str:
    red, green, blue = np.rint(encoded * 255).astype(int).tolist()
    return f"#{red:02x}{green:02x}{blue:02x}"


def write_bitmaps(
    bitmaps: Sequence[tuple[str | os.PathLike[str], NDArray[np.bool_]]], layout: BitmapLayout | None = None
) -> None:
    """Writes crossings [picks, ends] as bitmaps of 1 bit, by suffix .png, .bmp, .tif or .tiff: all or none.

    Raises:
        InputError: another suffix, or a path that cannot be written.
    """
    for path, _ in bitmaps:
        require_pixel_suffix(path, BITMAP_SUFFIXES)
    with replacing_all([path for path, _ in bitmaps]) as temporaries:
        for temporary, (path, warp_up) in zip(temporaries, bitmaps, strict=True):
            black = (layout or BitmapLayout()).turned(warp_up)
            # Of 8 bits first: Pillow packs them itself, whatever the width.
            picture = Image.fromarray(np.where(black, 0, 255).astype(np.uint8)).convert("1", dither=None)
            picture.save(temporary, format=_FORMATS[Path(path).suffix.lower()])


# ----------------------------------------------------------------------------------------------- one a weft
# A loom of several wefts takes each from a shuttle of its own. A bitmap a weft holds that weft's picks alone,
# in their order; in which order the wefts follow one another is said beside them.


@dataclass(frozen=True, eq=False)
class WeftBitmap:
    """The picks of one weft.

    Attributes:
        color: linear RGB [3]; None if the draft has no colours.
        warp_up: bool [picks, ends], True where the warp is lifted.
    """

    color: NDArray[np.float64] | None
    warp_up: NDArray[np.bool_]


def split_wefts(draft: Draft) -> tuple[list[WeftBitmap], list[int]]:
    """The picks of each weft, and the order of wefts, 1-based, that repeats: picks of one colour are a weft.

    Raises:
        InputError: more than 16 wefts.
    """
    weft = _weft_of_pick(draft)
    count = int(weft.max()) + 1
    if count > MAX_WEFTS:
        raise InputError(
            f"The draft has wefts of {count} colours; looms have up to {MAX_WEFTS} shuttles: "
            "write one bitmap of all picks instead."
        )
    colors = draft.weft.colors
    bitmaps = []
    for number in range(count):
        picks = np.flatnonzero(weft == number)
        bitmaps.append(WeftBitmap(None if colors is None else colors[picks[0]], draft.drawdown[picks]))
    return bitmaps, (weft[: _period(weft)] + 1).tolist()


def _weft_of_pick(draft: Draft) -> NDArray[np.intp]:
    """The weft of each pick, numbered by first appearance."""
    if draft.weft.colors is None:
        return np.zeros(draft.picks, np.intp)
    kinds: dict[tuple[float, ...], int] = {}
    return np.array([kinds.setdefault(tuple(color), len(kinds)) for color in draft.weft.colors.tolist()])


def _period(values: NDArray[np.intp]) -> int:
    """The shortest beginning that repeats to all values; the last time may be cut off."""
    starts = np.flatnonzero(values == values[0])[1:].tolist()
    return next((at for at in starts if np.array_equal(values[at:], values[:-at])), len(values))


def draft_of_wefts(wefts: Sequence[NDArray[np.bool_]], order: Sequence[int] = (), title: str = "") -> Draft:
    """The draft of bitmaps, one a weft.

    Args:
        wefts: crossings [picks, ends] of each weft's picks.
        order: 1-based numbers of the wefts in the order of picks, which repeats; empty: each in turn.
        title: of the draft.

    Returns:
        A draft whose wefts have a colour each, so that others can take their places: `weft.color` of a fabric
        file lists as many.

    Raises:
        InputError: bitmaps of different widths or no picks, more than 16, or an order that does not fit them.
    """
    if not 1 <= len(wefts) <= MAX_WEFTS:
        raise InputError(f"There are {len(wefts)} bitmaps of wefts; 1 to {MAX_WEFTS} can be woven.")
    widths = [bitmap.shape[1] for bitmap in wefts]
    if len(set(widths)) > 1:
        raise InputError(
            f"The bitmaps of wefts have {', '.join(map(str, widths))} ends; all need as many as the warp has."
        )
    cycle = np.asarray(order or range(1, len(wefts) + 1), np.intp) - 1
    if set(cycle.tolist()) != set(range(len(wefts))):
        raise InputError(
            f"The order of wefts {order_text(order)} is none of {len(wefts)} bitmaps: "
            f"it names each of 1 to {len(wefts)}, and no other."
        )
    picks = [len(bitmap) for bitmap in wefts]
    weft = np.resize(cycle, sum(picks))
    expected = np.bincount(weft, minlength=len(wefts)).tolist()
    if expected != picks:
        raise InputError(
            f"The bitmaps of wefts have {', '.join(map(str, picks))} picks, but the order "
            f"{order_text((cycle + 1).tolist())} takes {', '.join(map(str, expected))} of so many."
        )
    drawdown = np.empty((len(weft), widths[0]), bool)
    for number, bitmap in enumerate(wefts):
        drawdown[weft == number] = bitmap
    palette = weft_palette(len(wefts))
    return Draft(
        drawdown,
        Threads(palette[[0] * widths[0]], color_index=np.zeros(widths[0], np.intp)),
        Threads(palette[weft + 1], color_index=weft + 1),
        title=title,
        palette=palette,
    )


def weft_palette(wefts: int) -> NDArray[np.float64]:
    """A colour for the warp and one for each weft, linear RGB [wefts + 1, 3], to tell them apart."""
    return np.array([parse_colour(colour, "weft") for colour in (WARP_COLOUR, *WEFT_COLOURS[:wefts])])


def order_text(order: Sequence[int]) -> str:
    """An order of wefts as text: "1 1 2", runs of three and more as "40x1 2"."""
    runs: list[list[int]] = []
    for weft in order:
        if runs and runs[-1][1] == weft:
            runs[-1][0] += 1
        else:
            runs.append([1, weft])
    return " ".join(f"{count}x{weft}" if count > 2 else " ".join([str(weft)] * count) for count, weft in runs)


def parse_order(text: str, option: str = "order") -> list[int]:
    """An order of wefts from text such as "1 1 2" or "40x1 2"; commas do as well as spaces.

    Raises:
        InputError: anything else, or more than 16384 picks.
    """
    order: list[int] = []
    for part in text.replace(",", " ").split():
        count, times, weft = part.lower().replace("×", "x").rpartition("x")
        known = weft.isascii() and weft.isdecimal() and len(weft) < 3
        counted = not times or (count.isascii() and count.isdecimal() and len(count) < 6 and int(count) > 0)
        if not known or not counted or not 1 <= int(weft) <= MAX_WEFTS:
            raise InputError(
                f'{option} "{text[:60]}" is not understood: write the numbers of wefts, 1 to {MAX_WEFTS}, in '
                "the order of picks, such as 1 1 2, or 40x1 2 for runs."
            )
        order += [int(weft)] * int(count or 1)
        if len(order) > MAXIMUM_THREADS:
            raise InputError(f"{option} has more than {MAXIMUM_THREADS} picks, which no repeat may have.")
    if not order:
        raise InputError(f'{option} "" is empty: write the numbers of wefts in the order of picks, as 1 1 2.')
    return order
