"""The sheet of a capture: the photograph, a render in the same light, their difference, and the draft."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from loomlight.core.colour import linear_to_srgb
from loomlight.core.images import encoded
from loomlight.weave.draft import Draft
from loomlight.weave.drawing import draw_drawdown

Pixels = NDArray[np.uint8]

_SIDE, _GAP, _LINE = 480, 16, 17
_PAPER, _INK = (250, 249, 246), (34, 36, 42)
# Times that a difference is shown.
GAIN = 3
_MAX_THREADS = 48


def capture_sheet(
    photo: NDArray[np.float32], render: NDArray[np.float32], draft: Draft, lines: Sequence[str]
) -> Pixels:
    """The sheet, 8-bit sRGB [height, width, 3].

    Args:
        photo, render: linear RGB of one size.
        draft: with colours.
        lines: facts below.
    """
    off = np.abs(linear_to_srgb(photo) - linear_to_srgb(render)).mean(axis=-1, keepdims=True)
    difference = np.rint(255 * np.clip(GAIN * off, 0, 1)).astype(np.uint8).repeat(3, axis=2)
    pictures = {
        "photograph": encoded(photo),
        "render, threads laid as in the photograph": encoded(render),
        f"difference, {GAIN} times": difference,
        "draft": _drawdown(draft),
    }
    font = ImageFont.load_default(_LINE - 3)
    width = 2 * _SIDE + 3 * _GAP
    height = 2 * (_SIDE + _LINE + _GAP) + _GAP + _LINE * len(lines) + _GAP
    sheet = Image.new("RGB", (width, height), _PAPER)
    draw = ImageDraw.Draw(sheet)
    for number, (title, pixels) in enumerate(pictures.items()):
        x = _GAP + number % 2 * (_SIDE + _GAP)
        y = _GAP + number // 2 * (_SIDE + _LINE + _GAP)
        sheet.paste(Image.fromarray(_fitted(pixels)), (x, y))
        draw.text((x, y + _SIDE + 2), title, _INK, font=font)
    for number, line in enumerate(lines):
        draw.text((_GAP, height - _GAP - _LINE * (len(lines) - number)), line, _INK, font=font)
    return np.asarray(sheet)


def _fitted(pixels: Pixels) -> Pixels:
    """The middle square of a picture, in the size of the sheet's."""
    side = min(pixels.shape[:2])
    top, left = (pixels.shape[0] - side) // 2, (pixels.shape[1] - side) // 2
    square = Image.fromarray(pixels[top : top + side, left : left + side])
    return np.asarray(square.resize((_SIDE, _SIDE), Image.Resampling.LANCZOS))


def _drawdown(draft: Draft) -> Pixels:
    """The drawdown, repeated until it fills the square, or the first part of a large one."""
    threads = min(max(draft.ends, draft.picks, 16), _MAX_THREADS)
    cell = max(_SIDE // threads, 1)
    drawn = draw_drawdown(draft, cell_px=cell, repeats=-(-threads // min(draft.ends, draft.picks)))
    return np.ascontiguousarray(drawn[-threads * cell :, : threads * cell])
