"""Writes two artworks of several wefts in examples/artwork: pictures whose colours are weaves.

`jamdani.png` is sheer muslin whose flowers an extra weft draws, in bands: between them it is not woven, and
light comes through. `pomegranates.png` is a lampas of three wefts, each of which shows where the others lie
on the back. Both repeat both ways. Run: python -m examples.makers.brocades
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.core.files import replacing

OUTPUT = Path(__file__).resolve().parents[1] / "artwork"
# Muslin; flowers and leaves of the extra weft, their veins, and edges that are bound more closely.
MUSLIN = ("#f6f1e7", "#b3352c", "#e08a6b", "#7d1f26")
CLEAR, PETAL, VEIN, EDGE = range(4)
# The ground in a satin and in a twill, gold, gold that is bound more closely, green.
LAMPAS = ("#14213d", "#31456e", "#d8a023", "#8a6414", "#3f7d4e")
GROUND, TRELLIS, GOLD, SEAM, GREEN = range(5)

Plane = NDArray[np.float64]
Index = NDArray[np.uint8]


@dataclass(frozen=True)
class Repeat:
    """The pixels of a design that repeats.

    Attributes:
        ends: columns.
        rows: of pixels.
        row: height of a row, of the width of an end.
        scale: ends of a unit in which the design is drawn.
    """

    ends: int
    rows: int
    row: float
    scale: float

    @property
    def size(self) -> tuple[float, float]:
        """Of the repeat, in units of the design."""
        return self.ends / self.scale, self.row * self.rows / self.scale

    def from_place(self, across: float, along: float) -> tuple[Plane, Plane]:
        """How far each pixel lies right of a place and above it, in units, the shorter way round.

        Args:
            across, along: the place, in repeats.
        """
        right = ((np.arange(self.ends) + 0.5) / self.ends - across + 0.5) % 1 - 0.5
        above = ((np.arange(self.rows) + 0.5) / self.rows - along + 0.5) % 1 - 0.5
        width, height = self.size
        x, y = np.broadcast_arrays(width * right[None], height * above[:, None])
        return x, y

    def blank(self, colour: int) -> Index:
        return np.full((self.rows, self.ends), colour, np.uint8)


JAMDANI = Repeat(ends=800, rows=720, row=1.25, scale=0.5)
POMEGRANATES = Repeat(ends=640, rows=800, row=1.2, scale=0.5)


def main(folder: Path = OUTPUT) -> None:
    """Writes both artworks."""
    for name, index, palette in (
        ("jamdani", jamdani(JAMDANI), MUSLIN),
        ("pomegranates", pomegranates(POMEGRANATES), LAMPAS),
    ):
        # Drawn from the lowest row; pictures begin with the highest.
        picture = Image.fromarray(index[::-1])
        picture.putpalette([int(colour[at : at + 2], 16) for colour in palette for at in (1, 3, 5)])
        with replacing(folder / f"{name}.png") as temporary:
            picture.save(temporary, optimize=True)


def _turned(x: Plane, y: Plane, angle: float) -> tuple[Plane, Plane]:
    """Coordinates along a direction, radians from the right, and to its left."""
    return x * np.cos(angle) + y * np.sin(angle), y * np.cos(angle) - x * np.sin(angle)


def _put(index: Index, inside: NDArray[np.bool_], colour: int) -> None:
    np.copyto(index, np.uint8(colour), where=inside)


# ---------------------------------------------------------------------------------- muslin with an extra weft


def jamdani(repeat: Repeat) -> Index:
    """Two bands of sprays in half drop, and a border of lozenges between narrow lines."""
    index = repeat.blank(CLEAR)
    for along, shift in ((0.23, 0.0), (0.48, 0.5)):
        for column in range(4):
            _spray(index, repeat, ((column + 0.25 + shift) / 4, along), lean=1 if column % 2 else -1)
    _border(index, repeat, 0.79)
    return index


def _spray(index: Index, repeat: Repeat, place: tuple[float, float], lean: int) -> None:
    """A flower of six petals on a bent stem with two leaves, which leans to a side."""
    x, y = repeat.from_place(*place)
    x = lean * x
    stem = np.abs(x - 0.0022 * (y + 20) ** 2) < 5
    _put(index, stem & (y > -120) & (y < 20), EDGE)
    for height, angle in ((-80, 0.5), (-50, 2.5)):
        along, beside = _turned(x - 0.0022 * (height + 20) ** 2, y - height, angle)
        half = 18 * np.sin(np.pi * np.clip(along / 95, 0, 1)) ** 0.8
        inside = (along > 0) & (along < 95) & (np.abs(beside) < half)
        _put(index, inside, PETAL)
        _put(index, inside & (np.abs(beside) < 3.5), VEIN)
    up = y - 62
    away, around = np.hypot(x, up), np.arctan2(up, x)
    lobes = 62 + 22 * np.cos(6 * around)
    _put(index, away < lobes, EDGE)
    _put(index, away < lobes - 8, PETAL)
    _put(index, (away < lobes - 20) & (np.abs(np.sin(3 * around)) * away < 5), VEIN)
    _put(index, away < 22, EDGE)
    _put(index, away < 13, VEIN)


def _border(index: Index, repeat: Repeat, along: float) -> None:
    """Lozenges within lozenges, a line of beads and a solid line above and below."""
    x, y = repeat.from_place(0, along)
    pitch = repeat.size[0] / 10
    in_cell = np.abs((x + pitch / 2) % pitch - pitch / 2)
    lozenge = in_cell + np.abs(y)
    for size, colour in ((78, EDGE), (68, PETAL), (48, VEIN), (38, PETAL), (18, EDGE)):
        _put(index, lozenge < size, colour)
    for side in (-1, 1):
        bead = np.hypot((x % 40) - 20, y - side * 104)
        _put(index, bead < 12, PETAL)
        _put(index, np.abs(y - side * 132) < 8, EDGE)


# ----------------------------------------------------------------------------------- a lampas of three wefts


def pomegranates(repeat: Repeat) -> Index:
    """Pomegranates in an ogival trellis of leaves, in half drop."""
    index = repeat.blank(GROUND)
    width, height = repeat.size
    # Waves of opposite phase, two of each a repeat, make the ogees.
    x, y = repeat.from_place(0, 0)
    wave = width / 4 * np.cos(2 * np.pi * y / height)
    for sign in (-1, 1):
        from_band = np.abs((x - sign * wave + width / 4) % (width / 2) - width / 4)
        _put(index, from_band < 26, GREEN)
        _put(index, from_band < 17, TRELLIS)
        _put(index, (from_band < 17) & ((y % 48) < 14), GOLD)
    for number in range(8):
        half_drop, across, along = number % 2 / 4, number // 2 % 2 / 2, number // 4 / 2
        _pomegranate(index, repeat, (across + half_drop, along + half_drop))
    return index


def _pomegranate(index: Index, repeat: Repeat, place: tuple[float, float]) -> None:
    """A fruit that is open, with its seeds, a crown above it and leaves around its foot."""
    x, y = repeat.from_place(*place)
    x_beside = np.abs(x)
    for angle in (-0.9, 0.25, 0.95):
        along, beside = _turned(x_beside, y + 130, angle)
        bent = beside - 24 * np.sin(along / 70)
        half = 40 * np.sin(np.pi * np.clip(along / 225, 0, 1)) ** 0.7
        inside = (along > 0) & (along < 225) & (np.abs(bent) < half)
        rib = np.abs(bent) < 5
        _put(index, inside, GREEN)
        _put(index, inside & (rib | ((along - np.abs(bent)) % 36 < 6)), TRELLIS)
    for lean in (-0.45, 0.0, 0.45):
        along, beside = _turned(x, y - 110, np.pi / 2 + lean)
        half = 30 * (1 - np.clip(along / 140, 0, 1)) ** 0.6
        _put(index, (along > 0) & (along < 140) & (np.abs(beside) < half), GOLD)
        _put(index, (along > 0) & (along < 140) & (np.abs(np.abs(beside) - half) < 5), SEAM)
    rim = np.hypot(x / 150, y / 165)
    _put(index, rim < 1, SEAM)
    _put(index, rim < 0.93, GOLD)
    # A cut through which its seeds are seen.
    cut = np.hypot(x / 78, (y + 8) / 118)
    _put(index, cut < 1, SEAM)
    _put(index, cut < 0.92, GROUND)
    column = np.floor(y / 30)
    seed = np.hypot((x + 15 * (column % 2)) % 30 - 15, y % 30 - 15)
    _put(index, (cut < 0.84) & (seed < 11), GOLD)
    _put(index, (cut < 0.84) & (seed < 5), SEAM)
    bulge = 0.35 + np.sqrt(np.clip(1 - (y / 165) ** 2, 0, 1))
    _put(index, (rim < 0.9) & (cut > 1.1) & ((x_beside / bulge) % 44 < 6), SEAM)


if __name__ == "__main__":
    main()
