"""Five height fields of the character of kuznetsov2021's, as formulas; the paper's are not public.

Each is one periodic repeat of 10 × 10 mm with maps of height, albedo and roughness. Row 0 of a map is at
y = 0.
`python -m examples.makers.heightfields` writes them as height field files.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import parse_colour
from loomlight.sources.heightfield import Heightfield

SIDE = 256  # texels of a map
REPEAT_MM = 10.0

_Map = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class _Maps:
    """Maps of one repeat.

    Attributes:
        height: any range [side, side].
        albedo: linear RGB [side, side, 3].
        roughness: of the principled BSDF [side, side], or one for all.
    """

    height: _Map
    albedo: _Map
    roughness: _Map | float


@dataclass(frozen=True)
class _Recipe:
    """A material.

    Attributes:
        maps: of a repeat with so many texels a side.
        height_mm: from its lowest to its highest point.
        specular: reflectance at normal incidence is 8 % of it.
    """

    maps: Callable[[int], _Maps]
    height_mm: float
    specular: float


def twisted_wool(side: int) -> _Maps:
    """Rows of yarns, each of two plies that twist about each other, with fibres along the plies."""
    yarns, turns, fibres = 5, 4, 14  # turns are half turns of a repeat, fibres those of a ply
    rng = np.random.default_rng(5)
    u, v = _grid(side)
    yarn = np.floor(u * yarns)
    across = 2 * (u * yarns - yarn) - 1  # −1 to 1 over a yarn
    phase = rng.random(yarns)[yarn.astype(int)]
    height, albedo = np.zeros_like(u), np.zeros((side, side, 3))
    strays = _stretched_noise(rng, side, 24, 6)
    colours = [parse_colour(colour, "colour") for colour in ("#b9a58a", "#8a6f52")]
    for ply, colour in enumerate(colours):
        # The centre of a ply swings across the yarn, and rises where it crosses over the other.
        angle = np.pi * (turns * v + ply) + 2 * np.pi * phase
        centre, rise = 0.42 * np.sin(angle), 0.5 + 0.5 * np.cos(angle)
        offset = (across - centre) / 0.58
        body = np.sqrt(np.clip(1 - offset**2, 0, None))
        # Fibres wind around the ply: where they are depends on the angle around it.
        around = np.arcsin(np.clip(offset, -1, 1)) / np.pi
        fibre = np.cos(2 * np.pi * (fibres * around + 2 * turns * v) + 2.5 * strays)
        top = np.where(body > 0, 0.25 + 0.3 * rise + 0.4 * body + 0.02 * fibre * body, 0)
        shade = 0.85 + 0.15 * fibre + 0.12 * strays
        wins = (top > height)[..., None]
        albedo = np.where(wins, np.clip(colour * shade[..., None], 0, 1), albedo)
        height = np.maximum(height, top)
    bare = height <= 0
    albedo[bare] = 0.3 * colours[1]
    height += 0.015 * strays * ~bare
    return _Maps(height, albedo, 0.65)


def straight_wool(side: int) -> _Maps:
    """Parallel flat yarns of one ply, with fibres along them and a few that stray."""
    yarns, fibres = 8, 9
    rng = np.random.default_rng(11)
    u, v = _grid(side)
    wave = 0.012 * np.sin(2 * np.pi * v + 1.3) + 0.01 * _stretched_noise(rng, side, 6, 4)
    place = u * yarns + yarns * wave
    yarn = np.floor(place)
    across = 2 * (place - yarn) - 1
    tone = rng.normal(1, 0.06, yarns)[yarn.astype(int) % yarns]
    body = np.sqrt(np.clip(1 - (0.96 * across) ** 2, 0, None))
    strays = _stretched_noise(rng, side, 60, 5)
    fibre = np.cos(2 * np.pi * fibres * np.arcsin(np.clip(across, -1, 1)) / np.pi + 1.2 * strays)
    height = 0.72 * body + 0.07 * fibre * body + 0.035 * strays
    shade = tone * (0.9 + 0.1 * fibre + 0.08 * strays)
    colour = parse_colour("#7d8fa6", "colour")
    return _Maps(height, np.clip(colour * shade[..., None], 0, 1), 0.7)


def turtle_shell(side: int) -> _Maps:
    """Domed plates with growth rings, deep grooves between them: dark, and smoother than cloth."""
    rng = np.random.default_rng(23)
    u, v = _grid(side)
    columns = 3
    centres = [
        ((column + 0.5 * (row % 2) + 0.5) / columns, (row + 0.5) / 4)
        for row in range(4)
        for column in range(columns)
    ]
    points = np.array(centres) + rng.uniform(-0.035, 0.035, (len(centres), 2))
    bend = 0.008 * np.stack([_rough_noise(rng, side, 1.8) for _ in range(2)])
    plate, nearest, second = _nearest_points(u + bend[0], v + bend[1], points)
    edge = second - nearest  # 0 on the groove
    groove = 1 - np.exp(-((edge / 0.045) ** 2))
    dome = np.clip(1 - (nearest / 0.24) ** 2, 0, None)
    rings = np.cos(2 * np.pi * edge / 0.037) * np.exp(-(((edge - 0.11) / 0.09) ** 2))
    grain = _rough_noise(rng, side, 1.3)
    height = groove * (0.62 + 0.3 * dome + 0.035 * rings) + 0.012 * grain
    tones = rng.uniform(0.75, 1.2, len(points))[plate]
    dark, light = (parse_colour(colour, "colour") for colour in ("#3a2a16", "#a07a3c"))
    mix = np.clip(0.55 * dome + 0.12 * rings + 0.14 * grain, 0, 1)[..., None]
    albedo = (dark + mix * (light - dark)) * (tones * (0.35 + 0.65 * groove))[..., None]
    return _Maps(height, np.clip(albedo, 0, 1), 0.32 + 0.25 * (1 - groove))


def cliff_rock(side: int) -> _Maps:
    """Tilted layers that have broken off in steps, with cracks and grit."""
    rng = np.random.default_rng(37)
    u, v = _grid(side)
    large, middle = _rough_noise(rng, side, 2.2), _rough_noise(rng, side, 1.6)
    # Steps of the layers: integer waves across the repeat, so that they meet at its edges.
    layers = 4 * v + u + 0.55 * large + 0.08 * middle
    step = layers - np.floor(layers)
    face = np.clip(step / 0.72, 0, 1) - np.clip((step - 0.82) / 0.18, 0, 1)
    cracks = np.exp(-((np.abs(_rough_noise(rng, side, 1.9)) / 0.07) ** 2))
    grit = _rough_noise(rng, side, 0.9)
    height = 0.55 * face + 0.16 * large + 0.045 * middle + 0.022 * grit - 0.16 * cracks
    tone = 0.85 + 0.14 * middle + 0.1 * grit - 0.35 * cracks + 0.12 * face
    warm, cool = (parse_colour(colour, "colour") for colour in ("#a58a70", "#7c7a78"))
    mix = (0.5 + 0.5 * np.tanh(1.4 * large))[..., None]
    return _Maps(height, np.clip((cool + mix * (warm - cool)) * tone[..., None], 0.02, 1), 0.85)


def insulation_foam(side: int) -> _Maps:
    """Foam that has risen in mounds of many sizes, with deep crevices between them."""
    rng = np.random.default_rng(53)
    u, v = _grid(side)
    height, albedo = np.full_like(u, 0.05), np.zeros((side, side, 3))
    colour = parse_colour("#e3cf8c", "colour")
    albedo[:] = 0.45 * colour
    bend = [0.012 * _rough_noise(rng, side, 1.7) for _ in range(2)]
    for radius, count in ((0.17, 12), (0.11, 26), (0.07, 60), (0.035, 60)):
        for x, y in rng.random((count, 2)):
            dx, dy = (_wrapped(part) for part in (u + bend[0] - x, v + bend[1] - y))
            squared = 1 - (dx**2 + dy**2) / radius**2
            base = rng.uniform(0.1, 0.5)
            tone = rng.uniform(0.85, 1.08)
            top = np.where(squared > 0, base + 2.4 * radius * np.sqrt(np.clip(squared, 0, None)), 0)
            wins = top > height
            albedo = np.where(wins[..., None], tone * colour, albedo)
            height = np.maximum(height, top)
    pores = _rough_noise(rng, side, 0.7)
    height = height + 0.008 * pores
    return _Maps(height, np.clip(albedo * (1 + 0.05 * pores[..., None]), 0, 1), 0.75)


RECIPES: dict[str, _Recipe] = {
    "twisted wool": _Recipe(twisted_wool, 1.4, 0.3),
    "straight wool": _Recipe(straight_wool, 0.45, 0.3),
    "turtle shell": _Recipe(turtle_shell, 1.3, 0.5),
    "cliff rock": _Recipe(cliff_rock, 1.8, 0.3),
    "insulation foam": _Recipe(insulation_foam, 2.0, 0.3),
}


def paper_heightfield(name: str, side: int = SIDE) -> Heightfield:
    """A material of the paper's Table 2.

    Args:
        name: of `RECIPES`.
        side: texels of its maps.
    """
    recipe = RECIPES[name]
    maps = recipe.maps(side)
    height = (maps.height - maps.height.min()) / np.ptp(maps.height)
    return Heightfield(
        name,
        (REPEAT_MM, REPEAT_MM),
        recipe.height_mm,
        recipe.specular,
        height.astype(np.float32).clip(0, 1),
        maps.albedo.astype(np.float32).clip(0, 1),
        np.clip(np.atleast_2d(maps.roughness), 0.01, 1).astype(np.float32),
        np.zeros((1, 1), np.float32),
    )


def _grid(side: int) -> tuple[_Map, _Map]:
    """u and v of the centres of texels [side, side], 0 to 1."""
    v, u = np.meshgrid(*(2 * [(np.arange(side) + 0.5) / side]), indexing="ij")
    return u, v


def _wrapped(distance: _Map) -> _Map:
    """The shortest distance along an axis of the repeat, −½ to ½."""
    return distance - np.rint(distance)


def _nearest_points(u: _Map, v: _Map, points: _Map) -> tuple[NDArray[np.intp], _Map, _Map]:
    """The nearest of some points [n, 2], and the distances of the nearest two, in repeats [side, side]."""
    distances: _Map = np.stack([np.hypot(_wrapped(u - x), _wrapped(v - y)) for x, y in points])
    ordered: _Map = np.sort(distances, axis=0)
    return np.argmin(distances, axis=0), ordered[0], ordered[1]


def _stretched_noise(rng: np.random.Generator, side: int, across: int, along: int) -> _Map:
    """Periodic noise of mean 0 and deviation 1, with so many waves of each direction at most."""
    rows, columns = _waves(side)
    near = (np.abs(rows) <= along) & (np.abs(columns) <= across)
    spectrum = np.zeros((side, side), complex)
    spectrum[near] = np.exp(2j * np.pi * rng.random(int(near.sum())))
    return _standardised(spectrum)


def _rough_noise(rng: np.random.Generator, side: int, slope: float) -> _Map:
    """Periodic noise of mean 0 and deviation 1 whose amplitude falls with that power of the frequency.

    The same at every size of the map: the waves up to 64 a repeat have phases of their own.
    """
    rows, columns = _waves(side)
    most = 64
    phases = rng.random((2 * most + 1, 2 * most + 1))
    frequency = np.hypot(rows, columns)
    near = (frequency > 0) & (frequency <= min(most, side // 2 - 1))
    places = [np.broadcast_to(part.astype(int) + most, near.shape)[near] for part in (rows, columns)]
    spectrum = np.zeros((side, side), complex)
    spectrum[near] = frequency[near] ** -slope * np.exp(2j * np.pi * phases[places[0], places[1]])
    return _standardised(spectrum)


def _waves(side: int) -> tuple[_Map, _Map]:
    """Waves a repeat of each entry of a spectrum: [side, 1] and [1, side]."""
    waves = np.fft.fftfreq(side, 1 / side)
    return np.asarray(waves[:, None], np.float64), np.asarray(waves[None], np.float64)


def _standardised(spectrum: NDArray[np.complexfloating]) -> _Map:
    noise = np.fft.ifft2(spectrum).real
    noise -= noise.mean()
    return np.asarray(noise / noise.std())
