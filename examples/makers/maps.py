"""Writes the example pictures of maps over a garment: a badge to print, and where denim is worn.

python -m examples.makers.maps            # examples/maps/badge.png, worn.png
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw

EXAMPLES = Path(__file__).resolve().parents[1] / "maps"
# Drawn so many times larger, then averaged.
_SUPERSAMPLED = 4
_INK, _PAPER, _RED = (24, 38, 66, 255), (240, 232, 214, 255), (196, 62, 44, 255)


def badge(side: int = 360) -> Image.Image:
    """A round badge on nothing: strands that cross over and under."""
    whole = side * _SUPERSAMPLED
    picture = Image.new("RGBA", (whole, whole), (0, 0, 0, 0))
    draw = ImageDraw.Draw(picture)
    draw.ellipse((0, 0, whole - 1, whole - 1), fill=_INK)
    draw.ellipse([whole * share for share in (0.04, 0.04, 0.96, 0.96)], outline=_PAPER, width=whole // 60)
    step, half = whole * 0.16, whole * 0.052
    places = [whole / 2 + step * number for number in (-1.5, -0.5, 0.5, 1.5)]
    low, high = places[0] - step * 0.62, places[-1] + step * 0.62

    def strand(along_x: bool, place: float, first: float, last: float) -> None:
        across = (place - half, place + half)
        box = (first, across[0], last, across[1]) if along_x else (across[0], first, across[1], last)
        draw.rectangle(box, fill=_RED if along_x else _PAPER)

    for place in places:
        strand(False, place, low, high)
    for row, y in enumerate(places):
        strand(True, y, low, high)
        for column, x in enumerate(places):
            if (row + column) % 2 == 0:
                strand(False, x, y - step / 2, y + step / 2)
    return picture.resize((side, side), Image.Resampling.BOX)


def worn(side: int = 512) -> Image.Image:
    """How far dye is gone: paler in the middle, with whiskers where cloth has been creased."""
    y, x = np.mgrid[0:side, 0:side] / (side - 1) - 0.5
    share = 0.62 * np.exp(-np.square(x / 0.27) - np.square((y - 0.03) / 0.36))
    for number in range(8):
        place = 0.055 * (number - 4) + 0.012 * np.sin(3.1 * number)
        slope = 0.22 * (number - 3.5) / 4
        crease = y - place - slope * x - 0.25 * x * x
        length = 0.2 + 0.06 * np.cos(2.3 * number)
        share = np.maximum(share, 0.95 * _bump(crease, 0.007) * _bump(x, length))
    return Image.fromarray(np.rint(255 * np.clip(share, 0, 1)).astype(np.uint8))


def _bump(values: NDArray[np.float64], width: float) -> NDArray[np.float64]:
    bump: NDArray[np.float64] = np.exp(-np.square(values / width))
    return bump


def main() -> None:
    badge().save(EXAMPLES / "badge.png", optimize=True)
    worn().save(EXAMPLES / "worn.png", optimize=True)


if __name__ == "__main__":
    main()
