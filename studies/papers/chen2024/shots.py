"""Scenes of the figures: the pieces of cloth of the image benchmark, framed as the paper's figures are."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from loomlight.mitsuba import ClothMesh, shapes
from loomlight.mitsuba.measured_scenes import MeasuredShot

_ABOVE = (0.35, 0.55, 1.0)

# Near enough to see the weave, far enough for it to alias.
DRAPE = MeasuredShot((shapes.drape,), _ABOVE, (-0.6, 0.75, 0.6), yarns=2.5, zoom=2.2)
# Width and height of the curtain in metres, its folds, and their steepest slope.
_SIZE, _FOLDS, _SLOPE = (0.2, 0.12), 4, 0.8


def curtain() -> ClothMesh:
    """Cloth of 0.2 m by 0.12 m that hangs in four folds across x, facing +z; u to the right, v up.

    Folds are sines; u is the length along them, so the cloth is not stretched.
    """
    line = np.linspace(0, 1, 4001)
    angle = 2 * np.pi * _FOLDS * line
    # Per unit of width.
    length = np.concatenate([[0], np.cumsum(np.hypot(1, _SLOPE * np.cos(angle[1:] - angle[1] / 2)))])
    width = _SIZE[0] / (length[-1] / (len(line) - 1))
    depth = _SLOPE * width / (2 * np.pi * _FOLDS)

    def hung(u: NDArray[np.float64], v: NDArray[np.float64]) -> tuple[NDArray[np.float64], ...]:
        place = np.interp(u, length / length[-1], line)
        return (
            width * (place - 0.5),
            _SIZE[1] * (v - 0.5),
            depth * np.sin(2 * np.pi * _FOLDS * place),
        )

    return shapes.grid_surface(513, hung, "curtain")


# Some folds turn towards the light, which stands to the side and behind, and others away from it.
BACKLIT = MeasuredShot((curtain,), (0.25, 0.1, 1.0), (-1.0, 0.3, -0.55), yarns=2.5, zoom=1.15)
CLOSE = MeasuredShot((shapes.drape,), _ABOVE, (-0.6, 0.75, 0.6), yarns=0.15, zoom=3.0)
CYLINDER = MeasuredShot((shapes.cylinder,), (0.0, 0.0, 1.0), (-0.3, 0.6, 0.8), yarns=2.0, zoom=1.2)
BALL = MeasuredShot((shapes.sphere,), (0.0, 0.0, 1.0), (-0.45, 0.6, 0.75), yarns=2.0)


def _ball_at(column: int, row: int) -> Callable[[], ClothMesh]:
    """The ball, moved by whole places to the right and up."""

    def moved() -> ClothMesh:
        ball = shapes.sphere()
        offset = np.array([column * _APART[0], row * _APART[1], 0.0])
        return ClothMesh(ball.positions + offset, ball.normals, ball.uv, ball.triangles, ball.name)

    return moved


_APART = (0.28, 0.205)
# The camera frames the first one, in the middle.
_POSITIONS = sorted(
    ((column, row) for row in (1, 0, -1) for column in (-1, 0, 1)), key=lambda position: position != (0, 0)
)
NINE = MeasuredShot(
    tuple(_ball_at(*position) for position in _POSITIONS),
    (0.0, 0.0, 1.0),
    (-0.45, 0.6, 0.75),
    yarns=2.5,
    zoom=0.33,
)
