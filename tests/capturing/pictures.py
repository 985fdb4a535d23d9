"""Pictures of cloth, drawn by a formula with round threads or rendered; and of what is no cloth."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.capturing.photographer import Light, photograph, straight
from loomlight.core.colour import linear_to_srgb
from loomlight.fabric import fabric_from_text

Colours = list[tuple[float, float, float]]
BLUE, CREAM, RED = (0.2, 0.3, 0.5), (0.85, 0.8, 0.7), (0.6, 0.15, 0.15)


def woven(
    drawdown: NDArray[np.bool_],
    *,
    px: tuple[float, float] = (16.0, 18.0),
    size: tuple[int, int] = (320, 320),
    turn: float = 0.0,
    warp: Colours | None = None,
    weft: Colours | None = None,
    noise: float = 0.01,
    light: float = 0.0,
    plies: float = 0.0,
) -> NDArray[np.float64]:
    """Encoded RGB [height, width, 3]: yarn is darker towards its sides, and a little towards where it dives.

    Args:
        px: pixels an end and a pick.
        turn: radians anticlockwise.
        light: by how much the left is darker than the right, as a share.
        plies: how dark the grooves between plies are, as a share; they lie alike in all threads.
    """
    width, height = size
    rows, columns = np.mgrid[0:height, 0:width]
    x = np.cos(turn) * columns + np.sin(turn) * (height - 1 - rows)
    y = -np.sin(turn) * columns + np.cos(turn) * (height - 1 - rows)
    u, v = x / px[0] + 100.3, y / px[1] + 100.6
    end, pick = np.floor(u).astype(int), np.floor(v).astype(int)
    up = drawdown[pick % drawdown.shape[0], end % drawdown.shape[1]]
    across, along = np.where(up, u - end, v - pick), np.where(up, v - pick, u - end)
    dives = np.where(
        up,
        ~drawdown[(pick + np.where(along > 0.5, 1, -1)) % drawdown.shape[0], end % drawdown.shape[1]],
        drawdown[pick % drawdown.shape[0], (end + np.where(along > 0.5, 1, -1)) % drawdown.shape[1]],
    )
    shade = 1 - 1.4 * np.square(across - 0.5) - 0.5 * dives * np.square(along - 0.5)
    # A groove crosses a thread in a third of a thread's width along it.
    groove = np.sin(np.pi * np.where(up, u - 0.31 * v, v + 0.31 * u)) / 0.35
    shade = shade * (1 - plies * np.exp(-np.square(groove)))
    of_warp, of_weft = np.array(warp or [BLUE]), np.array(weft or [CREAM])
    colour = np.where(up[..., None], of_warp[end % len(of_warp)], of_weft[pick % len(of_weft)])
    picture = colour * shade[..., None] * (1 - light * (1 - columns / width))[..., None]
    picture += noise * np.random.default_rng(1).standard_normal(picture.shape)
    return np.asarray(np.clip(picture, 0, 0.98))


def knitted(size: int = 320, px: float = 20.0) -> NDArray[np.float64]:
    """Encoded RGB of stockinette: columns of V shapes, all alike."""
    rows, columns = np.mgrid[0:size, 0:size]
    wale = columns / px - np.floor(columns / px)
    leg = rows / (0.8 * px) + 0.6 * np.abs(wale - 0.5)
    across = leg - np.floor(leg)
    shade = 0.45 + 0.4 * np.sin(np.pi * across) * np.clip(8 * np.abs(wale - 0.5), 0.3, 1)
    grain = 0.01 * np.random.default_rng(2).standard_normal((size, size))
    return np.asarray(np.clip(shade + grain, 0, 1)[..., None] * np.array([0.8, 0.75, 0.7]))


def save(path: Path, encoded: NDArray[np.float64], **options: object) -> Path:
    """Writes encoded RGB as a picture file."""
    Image.fromarray(np.rint(255 * encoded).astype(np.uint8)).save(path, **options)  # type: ignore[arg-type]
    return path


TWILL = """
weave = "twill 2/1"
ends_per_cm = 16
picks_per_cm = 14
yarn = "worsted"
[warp]
color = "#3a5a86"
[weft]
color = "#cfc3a8"
"""
# Of the cloth in the picture of it.
WIDTH_MM = 12.0


def photographed_twill(path: Path) -> Path:
    """Writes a photograph of a twill, as a camera with a flash would take it, and returns its path."""
    picture = photograph(fabric_from_text(TWILL), straight((300, 300), WIDTH_MM, 0.02), Light(), 4)
    return save(path, linear_to_srgb(picture))
