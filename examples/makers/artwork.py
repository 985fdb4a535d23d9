"""Writes the artworks in examples/artwork: pictures of few colours, each of which is a weave.

`peonies.png` is a damask in five shades, from weft-faced to warp-faced. `waves.png` is of two wefts: waves of
the ground's weaves, and suns and spray of an extra weft. Both repeat both ways.
Run: python -m examples.makers.artwork
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.core.files import replacing

OUTPUT = Path(__file__).resolve().parents[1] / "artwork"
# Ends and rows of both.
WIDTH, HEIGHT = 2400, 3600
# Weft-faced to warp-faced: sateen, two twills between, satin, and the twill of leaves.
SHADES = ("#f4efe2", "#dfb9b4", "#b9737c", "#7a1f33", "#5d6b3f")
GROUND, LIGHT, MIDDLE, DARK, LEAF = range(5)
# Sea by three weaves, foam, and the extra weft's gold.
SEA = ("#1d2f55", "#31548a", "#6f9bc0", "#eef2ee", "#d8a023")
DEEP, SWELL, CREST, FOAM, GOLD = range(5)

Plane = NDArray[np.float64]
Index = NDArray[np.uint8]


def main(folder: Path = OUTPUT) -> None:
    """Writes both artworks."""
    for name, index, palette in (("peonies", peonies(), SHADES), ("waves", waves(), SEA)):
        # Drawn from the lowest row; pictures begin with the highest.
        picture = Image.fromarray(index[::-1])
        picture.putpalette([int(colour[at : at + 2], 16) for colour in palette for at in (1, 3, 5)])
        with replacing(folder / f"{name}.png") as temporary:
            picture.save(temporary, optimize=True)


def _away(size: int, centre: float) -> Plane:
    """Distance in threads from a centre to each thread of a repeat, the shorter way round, signed."""
    threads = np.arange(size, dtype=np.float64)
    return (threads + 0.5 - centre + size / 2) % size - size / 2


def _polar(x: float, y: float) -> tuple[Plane, Plane]:
    """Distance and angle of every crossing from a place, as the cloth repeats.

    A row is half as far again as an end, as the cloth has more ends than rows a centimetre.
    """
    across, along = _away(WIDTH, x)[None], 1.5 * _away(HEIGHT, y)[:, None]
    return np.hypot(across, along), np.arctan2(along, across)


# ------------------------------------------------------------------------------------------------ a damask


def peonies() -> Index:
    """Large and small peonies in half drop, with leaves between, by shade."""
    index = np.full((HEIGHT, WIDTH), GROUND, np.uint8)
    for row, column in ((0, 0), (1, 1)):
        x, y = WIDTH * (0.25 + 0.5 * column), HEIGHT * (0.25 + 0.5 * row)
        for leaf in range(9):
            _leaf(index, x, y, 2 * np.pi * (leaf + 0.35) / 9)
        _peony(index, x, y, 690, turn=0.4 * row)
    for row, column in ((0, 1), (1, 0)):
        x, y = WIDTH * (0.25 + 0.5 * column), HEIGHT * (0.25 + 0.5 * row)
        for leaf in range(7):
            _leaf(index, x, y, 2 * np.pi * (leaf + 0.7) / 7, length=560, breadth=85)
        _peony(index, x, y, 400, turn=0.9)
    return index


def _peony(index: Index, x: float, y: float, radius: float, turn: float) -> None:
    """Rings of petals, the outermost first; each goes from light at its rim to dark at its root."""
    away, angle = _polar(x, y)
    for ring, (outer, petals) in enumerate(((1.0, 11), (0.78, 9), (0.57, 8), (0.36, 6))):
        phase = (angle + turn + 0.5 * ring) * petals / (2 * np.pi)
        across = np.abs(phase - np.rint(phase)) * 2
        # A petal's rim is round, with a notch in its middle.
        rim = radius * outer * (1 - 0.22 * across**3 - 0.05 * np.exp(-((across / 0.12) ** 2)))
        depth = 1 - away / rim
        inside = depth > 0
        # Lines from the root; petals end in a thin light edge.
        veined = depth + 0.05 * np.cos(10 * np.pi * across) * (1 - depth)
        shade = np.select([veined < 0.035, veined < 0.14, veined < 0.27], [GROUND, LIGHT, MIDDLE], DARK)
        np.copyto(index, shade.astype(np.uint8), where=inside)
    heart = away < radius * 0.15
    seeds = (np.cos(away / radius * 150) * np.cos(9 * angle)) > 0.1
    np.copyto(index, np.where(seeds, GROUND, MIDDLE).astype(np.uint8), where=heart)


def _leaf(
    index: Index, x: float, y: float, degrees: float, length: float = 980, breadth: float = 130
) -> None:
    """A leaf that points away from a flower, with its veins left open."""
    across, along = _away(WIDTH, x)[None], 1.5 * _away(HEIGHT, y)[:, None]
    u = (across * np.cos(degrees) + along * np.sin(degrees)) / length
    v = across * -np.sin(degrees) + along * np.cos(degrees) - 90 * np.clip(u, 0, 1) ** 2
    half = breadth * np.sin(np.pi * np.clip(u, 0, 1) ** 1.3) ** 0.8
    inside = (u > 0) & (u < 1) & (np.abs(v) < half)
    ribs = np.abs((u * length - 0.8 * np.abs(v)) % 46 - 23) < 3.5
    vein = (np.abs(v) < 5) | (ribs & (np.abs(v) < 0.85 * half))
    shade = np.where(vein, GROUND, np.where(v > 0, LEAF, MIDDLE))
    np.copyto(index, shade.astype(np.uint8), where=inside)


# ---------------------------------------------------------------------------------- waves, with an extra weft


def waves() -> Index:
    """Scales of concentric arcs, row above row, with suns in two bands and spray in their crests."""
    step, rise = 300, 100
    rows = HEIGHT // rise
    # From the top, so that each row lies over the one above it; from two rows above the repeat to two below,
    # whose scales reach into it.
    sea = np.full((HEIGHT + 4 * rise, WIDTH), DEEP, np.uint8)
    for row in range(rows + 1, -3, -1):
        for column in range(WIDTH // step):
            _scale(sea, (column + 0.5 * (row % 2)) * step, (row + 2) * rise, step / 2, row)
    index = sea[2 * rise : -2 * rise]
    for x, y in ((600, 900), (1800, 2700)):
        _sun(index, x, y)
    return index


def _scale(index: Index, x: float, y: float, radius: float, row: int) -> None:
    """One scale: arcs around a point at its lower end, only what is drawn of it looked at."""
    across, along = _away(WIDTH, x), 1.5 * (np.arange(len(index)) + 0.5 - y)
    columns = np.flatnonzero(np.abs(across) < radius)
    lines = np.flatnonzero((along >= -radius) & (along < radius))
    away = np.hypot(across[columns][None], along[lines][:, None]) / radius
    bands = np.select(
        [away > 0.93, away > 0.78, away > 0.68, away > 0.5, away > 0.41, away > 0.22],
        [FOAM, SWELL, FOAM, CREST, FOAM, SWELL],
        DEEP,
    ).astype(np.uint8)
    # A drop of spray in the crests of every sixth row.
    if row % 6 == 0:
        drop = np.hypot(across[columns][None], along[lines][:, None] - 0.86 * radius) < 9
        bands = np.where(drop, GOLD, bands).astype(np.uint8)
    places = np.ix_(lines, columns)
    index[places] = np.where(away < 1, bands, index[places])


def _sun(index: Index, x: float, y: float) -> None:
    """A disc with rays, which covers the waves."""
    away, angle = _polar(x, y)
    rays = (np.cos(24 * angle) > 0.2) & (away > 330) & (away < 330 + 90 * (1 + np.cos(12 * angle)))
    ring = (away > 272) & (away < 300)
    disc = away < 250
    halo = away < 318
    np.copyto(index, np.uint8(DEEP), where=halo)
    np.copyto(index, np.uint8(GOLD), where=disc | ring | rays)


if __name__ == "__main__":
    main()
