"""Procedural textures of the four layered materials: periodic maps, linear, from seeds.

All maps [side, side] repeat. Noise is a sum of waves with random phases, so that the same seed gives the same
picture at any resolution that holds its waves.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

Map = NDArray[np.float64]


def grid(side: int) -> tuple[Map, Map]:
    """u and v of the middles of texels [side, side]."""
    v, u = np.meshgrid(*(2 * [(np.arange(side) + 0.5) / side]), indexing="ij")
    return u, v


def noise(side: int, seed: int, across: float, along: float | None = None, falloff: float = 1.0) -> Map:
    """Noise [side, side] of mean 0 and deviation 1.

    Args:
        across, along: the most waves over u and over v; the same by default.
        falloff: amplitudes fall with the wave number to this power.
    """
    along = across if along is None else along
    rows, columns = (np.fft.fftfreq(side, 1 / side)[:, None], np.fft.fftfreq(side, 1 / side)[None])
    radius = np.hypot(rows / along, columns / across)
    number = np.hypot(rows, columns)
    near = (radius <= 1) & (number > 0)
    # Phases belong to waves, not to places in the array, which depend on its side.
    size = 2 * math.ceil(max(across, along)) + 1
    phases = np.random.default_rng(seed).random((size, size))
    phase = phases[np.int_(rows) % size, np.int_(columns) % size]
    amplitude = np.zeros_like(number)
    amplitude[near] = np.maximum(number[near], 1) ** -falloff
    field = np.fft.ifft2(amplitude * np.exp(2j * np.pi * phase)).real
    field -= field.mean()
    return np.asarray(field / field.std())


def step(value: Map, low: float, high: float) -> Map:
    """A smooth step from 0 at `low` to 1 at `high`."""
    t = np.clip((value - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


def fingerprint(side: int, centre: tuple[float, float], turn: float, size: float, seed: int) -> Map:
    """Ridges of a fingertip [side, side], 0 to 1, about a place of uv.

    Args:
        turn: of its long axis, radians.
        size: half its length in uv.
    """
    u, v = grid(side)
    x, y = ((part - middle + 0.5) % 1 - 0.5 for part, middle in zip((u, v), centre, strict=True))
    x, y = math.cos(turn) * x + math.sin(turn) * y, math.cos(turn) * y - math.sin(turn) * x
    x, y = x / (0.68 * size), y / size
    inside = step(-np.hypot(x, y), -1.0, -0.72)
    warp = 0.1 * noise(side, seed, 12)
    # Loops about a core below the middle, which open into arches.
    radius = np.hypot(x * (1.15 - 0.3 * y), y + 0.25 + 0.25 * x * x) + 0.35 * warp
    ridges = 0.5 + 0.5 * np.cos(2 * np.pi * 9 * radius)
    worn = step(noise(side, seed + 1, 24), -1.3, 0.4)
    return inside * worn * (0.35 + 0.65 * step(ridges, 0.25, 0.75))


def scratches(side: int, seed: int, count: int, width: float, spread: float = math.pi) -> Map:
    """Thin arcs [side, side], 0 to 1, of random places and directions.

    Args:
        width: of a scratch in uv.
        spread: of directions about u, radians.
    """
    rng = np.random.default_rng(seed)
    u, v = grid(side)
    found = np.zeros((side, side))
    for _ in range(count):
        turn, bend = rng.uniform(-spread / 2, spread / 2), rng.normal(0, 0.6)
        length, strength = rng.uniform(0.04, 0.22), rng.uniform(0.3, 1)
        x, y = ((part - rng.random() + 0.5) % 1 - 0.5 for part in (u, v))
        x, y = math.cos(turn) * x + math.sin(turn) * y, math.cos(turn) * y - math.sin(turn) * x
        y = y - bend * x * x
        line = step(-np.abs(y), -width, 0) * step(-np.abs(x), -length, -0.6 * length)
        found = np.maximum(found, strength * line)
    return found


def cracks(side: int, seed: int, cells: int, width: float) -> Map:
    """Crackle [side, side], 0 to 1: borders of the Voronoi cells of jittered points, `width` in uv."""
    rng = np.random.default_rng(seed)
    offsets = rng.random((cells, cells, 2))
    warp = 0.16 / cells
    u, v = grid(side)
    u, v = u + warp * noise(side, seed + 1, 4 * cells), v + warp * noise(side, seed + 2, 4 * cells)
    column, row = np.floor(u * cells).astype(int), np.floor(v * cells).astype(int)
    first, second = np.full((side, side), np.inf), np.full((side, side), np.inf)
    for i in (-2, -1, 0, 1, 2):
        for j in (-2, -1, 0, 1, 2):
            point = offsets[(row + j) % cells, (column + i) % cells]
            distance = np.hypot(
                u * cells - (column + i + point[..., 0]), v * cells - (row + j + point[..., 1])
            )
            second = np.minimum(second, np.maximum(first, distance))
            first = np.minimum(first, distance)
    return step(-(second - first) / cells, -width, 0)


def normal_map(height: Map, strength: float) -> NDArray[np.float64]:
    """A normal map [side, side, 3], 0 to 1 for −1 to 1, of a height in units of uv times `strength`."""
    side = len(height)
    slope_u = (np.roll(height, -1, 1) - np.roll(height, 1, 1)) * (strength * side / 2)
    slope_v = (np.roll(height, -1, 0) - np.roll(height, 1, 0)) * (strength * side / 2)
    normal = np.stack([-slope_u, -slope_v, np.ones_like(height)], axis=-1)
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    return np.asarray(0.5 + 0.5 * normal)


def mixed(low: tuple[float, ...], high: tuple[float, ...], share: Map) -> NDArray[np.float64]:
    """Colours [side, side, 3] between two."""
    return np.asarray(np.array(low) + share[..., None] * (np.array(high) - np.array(low)))
