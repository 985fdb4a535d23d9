"""Makes examples/jersey: a knit of fibres, of which `neumip` is trained.

    python -m examples.makers.jersey [FOLDER]

The yarn of a course runs along the loop curve of plain knitting, x = t + a·sin 2t, y = h·cos t, z = −d·cos 2t
for a wale of 2π: legs on the front, heads and feet behind them. Courses lie so close that each one's legs
pass through the heads of the one below. Fibres lie along their yarn, as in soft roving, and wander; some
leave it in arcs, as the hairs of wool do.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import parse_colour
from studies.instruments.fibre_tile import Curve, write_curves

WALE_MM, COURSE_MM = 1.5, 1.05
WALES, COURSES = 2, 4
_SWELL, _HEIGHT, _DEPTH, _RADIUS = 1.32, 3.6, 1.15, 1.2  # of a wale of 2π: a, h, d, and of the yarn
_FIBRES, _HAIRS = 44, 7  # of a yarn, and how many of them stray
_FRONT_MM = 0.42  # where most of the yarn that is seen lies
_POINTS = 22  # control points of a wale
_PACKING = 0.6
_WANDERING, _HAIRINESS = 0.07, 0.4
_COLOURS = ("#a8452f", "#dcc9a6")  # of two courses each
_SEED = 3

_Points = NDArray[np.float64]


def jersey() -> list[list[Curve]]:
    """The curves of each colour in one repeat, millimetres; z = 0 is the middle of the cloth."""
    rng = np.random.default_rng(_SEED)
    unit = WALE_MM / (2 * math.pi)
    stripes: list[list[Curve]] = [[] for _ in _COLOURS]
    # A cubic B-spline of n + 3 points has n parts; one begins at its second point.
    t = np.arange(-1, WALES * _POINTS + 2) * 2 * math.pi / _POINTS
    line = np.stack([t + _SWELL * np.sin(2 * t), _HEIGHT * np.cos(t), -_DEPTH * np.cos(2 * t)], axis=-1)
    across, up = _frames(t)
    radius = unit * _RADIUS * math.sqrt(_PACKING / _FIBRES)
    for course in range(COURSES):
        shift = np.array([0.0, (course + 0.5) * COURSE_MM, 0.0])
        for fibre in range(_FIBRES):
            turning, swelling, leaving = _waves(rng, t / (2 * math.pi * WALES))
            angle = fibre * math.pi * (3 - math.sqrt(5)) + _WANDERING * 4 * turning + course
            reach = math.sqrt((fibre + 0.5) / _FIBRES) * (1 + _WANDERING * swelling)
            # The outermost leave the yarn where the wave is high.
            if fibre > _FIBRES - _HAIRS:
                reach = reach + _HAIRINESS * np.clip(leaving - 1, 0, None) ** 2
            place = reach[:, None] * (np.cos(angle)[:, None] * across + np.sin(angle)[:, None] * up)
            points = unit * (line + _RADIUS * place) + shift
            stripes[2 * course // COURSES].append((points, radius))
    return stripes


def _frames(t: _Points) -> tuple[_Points, _Points]:
    """Unit vectors across the yarn in the plane of the cloth, and upwards, [n, 3] each."""
    along = np.stack(
        [1 + 2 * _SWELL * np.cos(2 * t), -_HEIGHT * np.sin(t), 2 * _DEPTH * np.sin(2 * t)], axis=-1
    )
    along /= np.linalg.norm(along, axis=-1, keepdims=True)
    across = np.cross(np.array([0.0, 0.0, 1.0]), along)
    across /= np.linalg.norm(across, axis=-1, keepdims=True)
    return across, np.cross(along, across)


def _waves(rng: np.random.Generator, places: _Points) -> _Points:
    """Three periodic waves [3, n] of deviation 1 at places in periods."""
    found = np.zeros((3, len(places)))
    for number in range(1, 6):
        phases = 2 * math.pi * rng.random((3, 1))
        found += np.sin(2 * math.pi * number * places + phases)
    return found * math.sqrt(2 / 5)


def main(folder: Path) -> None:
    """Writes the tile."""
    colours = [parse_colour(colour, "colour") for colour in _COLOURS]
    groups = list(zip(colours, jersey(), strict=True))
    heading = (
        "# Jersey of woollen loops; docs/learned-materials.md says how to bake it.\n"
        "# The fibres are made by `python -m examples.makers.jersey`.\n"
    )
    size = WALES * WALE_MM, COURSES * COURSE_MM
    write_curves(folder, "jersey.toml", size, groups, digits=4, heading=heading, front_mm=_FRONT_MM)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path("examples/jersey"))
