"""Makes examples/leather: maps of grained leather, a height field that `neumip` is trained of.

    python -m examples.makers.leather [FOLDER]

Grain is made of cells of two sizes, domed and parted by creases, with pores. Tops are burnished: lighter and
smoother than what lies between them.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.core.colour import linear_to_srgb, parse_colour

SIDE = 256  # pixels
_CELLS, _FINE_CELLS = 7, 17  # along a repeat
_COLOURS = ("#3a1c10", "#8c4f2a", "#a86a3c")  # of creases, sides and tops
_ROUGHNESS = 0.55, 0.3  # of creases and of tops
_SEED = 8

_Map = NDArray[np.float64]


def maps() -> tuple[_Map, _Map, _Map]:
    """Heights [SIDE, SIDE], 0 to 1, linear RGB [SIDE, SIDE, 3], and roughness of one repeat."""
    rng = np.random.default_rng(_SEED)
    v, u = np.meshgrid(*(2 * [(np.arange(SIDE) + 0.5) / SIDE]), indexing="ij")
    bend = [_noise(rng, 6) for _ in range(2)]
    u_bent, v_bent = u + 0.018 * bend[0], v + 0.018 * bend[1]
    first, second, number = _nearest(rng, u_bent, v_bent, _CELLS)
    border = (second - first) * _CELLS
    dome = np.tanh(2.6 * border) * (1 - 0.35 * (first * _CELLS) ** 2)
    dome *= (0.8 + 0.2 * rng.random(_CELLS**2))[number]
    small_first, small_second, _ = _nearest(rng, u_bent, v_bent, _FINE_CELLS)
    creases = np.tanh(2.2 * (small_second - small_first) * _FINE_CELLS)
    height = 0.78 * dome + 0.16 * creases * (0.4 + 0.6 * dome) + 0.025 * _noise(rng, 60)
    pores = _spots(rng, u, v, 110, 0.007)
    height = height + 0.06 * _noise(rng, 4) - 0.25 * pores
    height = (height - height.min()) / np.ptp(height)
    tone = np.clip(1.25 * height - 0.2 + 0.05 * _noise(rng, 10), 0, 1)[..., None]
    dark, middle, light = (parse_colour(colour, "colour") for colour in _COLOURS)
    colour = np.where(
        tone < 0.5, dark + 2 * tone * (middle - dark), middle + (2 * tone - 1) * (light - middle)
    )
    roughness = _ROUGHNESS[0] + tone[..., 0] * (_ROUGHNESS[1] - _ROUGHNESS[0])
    return height, np.clip(colour, 0, 1), roughness


def _nearest(rng: np.random.Generator, u: _Map, v: _Map, cells: int) -> tuple[_Map, _Map, NDArray[np.intp]]:
    """Distances to the nearest two of jittered points, in repeats, and the number of the nearest."""
    jitter = rng.random((cells, cells, 2))
    column, row = np.floor(u * cells).astype(int), np.floor(v * cells).astype(int)
    first, second = np.full_like(u, np.inf), np.full_like(u, np.inf)
    number = np.zeros(u.shape, np.intp)
    for i in (-2, -1, 0, 1, 2):
        for j in (-2, -1, 0, 1, 2):
            x, y = (column + i) % cells, (row + j) % cells
            point = jitter[y, x]
            distance = np.hypot(
                u - (column + i + point[..., 0]) / cells, v - (row + j + point[..., 1]) / cells
            )
            number = np.where(distance < first, y * cells + x, number)
            second = np.minimum(second, np.maximum(first, distance))
            first = np.minimum(first, distance)
    return first, second, number


def _spots(rng: np.random.Generator, u: _Map, v: _Map, count: int, radius: float) -> _Map:
    """Round hollows [SIDE, SIDE], 0 to 1, of a radius in repeats."""
    found = np.zeros_like(u)
    for x, y in rng.random((count, 2)):
        squared = ((u - x + 0.5) % 1 - 0.5) ** 2 + ((v - y + 0.5) % 1 - 0.5) ** 2
        found = np.maximum(found, np.exp(-0.5 * squared / radius**2))
    return found


def _noise(rng: np.random.Generator, waves: int) -> _Map:
    """Periodic noise [SIDE, SIDE] of mean 0 and deviation 1, with so many waves each way at most."""
    frequency = np.hypot(*np.meshgrid(*(2 * [np.fft.fftfreq(SIDE, 1 / SIDE)])))
    phases = np.exp(2j * np.pi * rng.random((SIDE, SIDE)))
    spectrum = np.where((frequency > 0) & (frequency <= waves), phases, 0)
    noise = np.fft.ifft2(spectrum).real
    return np.asarray(noise / noise.std())


def main(folder: Path) -> None:
    """Writes the maps; the height field file beside them is written by hand."""
    height, colour, roughness = maps()
    folder.mkdir(parents=True, exist_ok=True)
    # Row 0 of the maps is at y = 0, the bottom of a picture.
    Image.fromarray(np.rint(65535 * height[::-1]).astype(np.uint16)).save(folder / "height.png")
    for name, values in (("albedo", linear_to_srgb(colour)), ("roughness", roughness)):
        Image.fromarray(np.rint(255 * values[::-1]).astype(np.uint8)).save(folder / f"{name}.png")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path("examples/leather"))
