"""The studio, the light of pictures that name no other: a key light with direction, a back light and a dome.

A key from the side at half height rakes over yarns and folds, and is narrow enough to draw both; the dome
leaves shadows legible. The back light stands opposite the key, at its height, where cloth that hangs or
lies gleams at grazing angles. Public numbers are those of the page too (`web/editor/src/view/studio.ts`).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

# Where the key stands by default, degrees: 0 is the front, 90 the right; above the horizon.
STUDIO_AZIMUTH, STUDIO_ELEVATION = -56, 33
# Of the round key and back lights, degrees from their middle to where they have faded to a half and, around
# there, from full to none.
KEY_RADIUS, KEY_EDGE = 5.0, 2.0
BACK_RADIUS, BACK_EDGE = 12.0, 4.0
# Of the irradiance of a card that faces the key, the dome's share; the rest is the key's own. And what the
# back light gives a card that faces it, in the same unit.
FILL_SHARE, BACK_SHARE = 0.1, 0.25
# Of the paper that cloth stands on: white cloth stands out from it, and what it throws back into folds leaves
# them their shadows. And how much of that light reaches cloth, which shades the paper around it.
PAPER, PAPER_SHARE = 0.6, 0.5
_ROWS = 128


def studio_radiance(direction: NDArray[np.float64], *, paper: bool = False) -> NDArray[np.float32]:
    """Latitude-longitude radiance [128, 256, 3] of the studio whose key light stands at the unit `direction`.

    All of it is grey, so that a grey card looks grey; a white card that faces the key shows a radiance of 1.

    Args:
        paper: light from below stands for that of paper, in renderers that follow no reflections; without,
            nothing comes from below the horizon, where the built-in scenes have a ground.
    """
    towards, solid_angle = _texels()
    y = towards[..., 1]
    above = (y > 0).astype(np.float64)

    def irradiance(radiance: NDArray[np.float64], normal: NDArray[np.float64]) -> float:
        return float((radiance * np.clip(towards @ normal, 0, None) * solid_angle).sum())

    def disc(normal: NDArray[np.float64], radius: float, edge: float) -> NDArray[np.float64]:
        """Of a card that faces it the irradiance is 1."""
        off = np.degrees(np.arccos(np.clip(towards @ normal, -1, 1)))
        radiance = above * np.clip((radius - off) / edge + 0.5, 0, 1)
        return np.asarray(radiance / irradiance(radiance, normal))

    dome = above * (0.5 + 0.5 * y)
    total = (
        (1 - FILL_SHARE) * disc(direction, KEY_RADIUS, KEY_EDGE)
        + FILL_SHARE * dome / irradiance(dome, direction)
        + BACK_SHARE * disc(direction * [-1, 1, -1], BACK_RADIUS, BACK_EDGE)
    )
    if paper:
        total += (1 - above) * PAPER_SHARE * PAPER * irradiance(total, np.array([0.0, 1.0, 0.0])) / np.pi
    total *= np.pi / irradiance(total, direction)
    return np.repeat(total[..., None], 3, axis=-1).astype(np.float32)


def paper_radiance(radiance: NDArray[np.float32], normal: NDArray[np.float64]) -> float:
    """Radiance of unshaded paper that faces the unit `normal` in the light of `studio_radiance`."""
    towards, solid_angle = _texels()
    irradiance = radiance[..., 0] * np.clip(towards @ normal, 0, None) * solid_angle
    return PAPER / np.pi * float(irradiance.sum())


def _texels() -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Directions [128, 256, 3] of the picture of the studio, and their solid angles, of each row alike."""
    rows, columns = _ROWS, 2 * _ROWS
    polar = (np.arange(rows) + 0.5) / rows * np.pi
    around = (np.arange(columns) + 0.5) / columns * 2 * np.pi
    # Mitsuba's envmap: up is +y, and columns turn from -z over +x.
    x, y = np.sin(polar)[:, None] * np.sin(around), np.cos(polar)[:, None] + 0 * around
    towards = np.stack([x, y, -np.sin(polar)[:, None] * np.cos(around)], axis=-1)
    return towards, np.sin(polar)[:, None] * (np.pi / rows) * (2 * np.pi / columns)
