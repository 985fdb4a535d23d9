"""Makes examples/twisted-wool: maps of rows of two-ply wool, of which `neumip` is trained.

    python -m examples.makers.twisted_wool [FOLDER]

A yarn is two plies that twist about each other, with fibres along the plies; fibres vary by periodic noise.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.core.colour import linear_to_srgb, parse_colour

SIDE = 256  # pixels
YARNS, TURNS = 5, 4  # of a repeat: yarns across, and half turns of each along
_FIBRES = 14  # of a ply
_SEED = 5
_COLOURS = ("#b9a58a", "#8a6f52")  # of the two plies

_Map = NDArray[np.float64]


def maps() -> tuple[_Map, _Map]:
    """Heights [SIDE, SIDE], 0 to 1, and linear RGB [SIDE, SIDE, 3] of one repeat."""
    rng = np.random.default_rng(_SEED)
    v, u = np.meshgrid(*(2 * [(np.arange(SIDE) + 0.5) / SIDE]), indexing="ij")
    yarn = np.floor(u * YARNS)
    across = 2 * (u * YARNS - yarn) - 1  # −1 to 1 over a yarn
    phase = rng.random(YARNS)[yarn.astype(int)]
    height, colour = np.zeros_like(u), np.zeros((SIDE, SIDE, 3))
    strays = _noise(rng, 24, 6)
    for ply in (0, 1):
        # The centre of a ply swings across the yarn, and rises where it crosses over the other.
        angle = np.pi * (TURNS * v + ply) + 2 * np.pi * phase
        centre, rise = 0.42 * np.sin(angle), 0.5 + 0.5 * np.cos(angle)
        offset = (across - centre) / 0.58
        body = np.sqrt(np.clip(1 - offset**2, 0, None))
        # Fibres wind around the ply: where they are depends on the angle around it.
        around = np.arcsin(np.clip(offset, -1, 1)) / np.pi
        fibre = np.cos(2 * np.pi * (_FIBRES * around + 2 * TURNS * v) + 2.5 * strays)
        top = np.where(body > 0, 0.25 + 0.3 * rise + 0.4 * body + 0.02 * fibre * body, 0)
        wins = top > height
        shade = 0.85 + 0.15 * fibre + 0.12 * strays
        albedo = np.clip(parse_colour(_COLOURS[ply], "colour") * shade[..., None], 0, 1)
        colour = np.where(wins[..., None], albedo, colour)
        height = np.maximum(height, top)
    bare = height <= 0
    colour[bare] = 0.3 * parse_colour(_COLOURS[1], "colour")
    height += 0.015 * strays * ~bare
    return (height - height.min()) / np.ptp(height), colour


def _noise(rng: np.random.Generator, across: int, along: int) -> _Map:
    """Periodic noise [SIDE, SIDE] of mean 0 and deviation 1, with so many waves each way at most."""
    spectrum = np.zeros((SIDE, SIDE), complex)
    rows, columns = (np.fft.fftfreq(SIDE, 1 / SIDE)[:, None], np.fft.fftfreq(SIDE, 1 / SIDE)[None])
    near = (np.abs(rows) <= along) & (np.abs(columns) <= across)
    spectrum[near] = np.exp(2j * np.pi * rng.random(int(near.sum())))
    noise = np.fft.ifft2(spectrum).real
    noise -= noise.mean()
    return np.asarray(noise / noise.std())


def main(folder: Path) -> None:
    """Writes both maps; the height field file beside them is written by hand."""
    height, colour = maps()
    folder.mkdir(parents=True, exist_ok=True)
    # Row 0 of the maps is at y = 0, the bottom of a picture.
    Image.fromarray(np.rint(65535 * height[::-1]).astype(np.uint16)).save(folder / "height.png")
    Image.fromarray(np.rint(255 * linear_to_srgb(colour[::-1])).astype(np.uint8)).save(folder / "albedo.png")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path("examples/twisted-wool"))
