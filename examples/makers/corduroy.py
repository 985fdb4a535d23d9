"""Makes examples/corduroy: ribs of cut pile over a ground of yarns, of which `neumip` is trained.

    python -m examples.makers.corduroy [FOLDER]

A rib is a row of tufts. Each fibre of a tuft stands up from the binding in the middle of the rib, leans
out the more the farther it is from there, and ends on the rounded outline that shears leave. Between the
ribs the ground shows: picks that are bound by ends, in plain weave.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import parse_colour
from studies.instruments.fibre_tile import Curve, write_curves

RIB_MM, LENGTH_MM = 2.0, 2.4
_PILE_MM, _FRONT_MM = 0.9, 0.75  # height of a rib above the ground, and of most of what is seen of it
_HALF_WIDTH = 0.86  # of a rib, of half the spacing of ribs
_FIBRES = 1500
_RADIUS_MM = 0.019
_POINTS = 5  # control points of a fibre
_TUFTS = 8  # along a repeat
_PICKS, _ENDS, _GROUND_RADIUS_MM = 8, 8, 0.13  # even: plain weave goes on in the next repeat
_PILE, _GROUND = ("#b98a4e", "#a87a40"), "#7d5a30"
_SEED = 4

_Points = NDArray[np.float64]


def pile() -> list[list[Curve]]:
    """Fibres of one repeat in two shades, millimetres; z = 0 is the top of the ground."""
    rng = np.random.default_rng(_SEED)
    shades: list[list[Curve]] = [[], []]
    half = 0.5 * _HALF_WIDTH * RIB_MM
    for _ in range(_FIBRES):
        tuft = rng.integers(_TUFTS)
        # Where the tip is: across the rib −1 to 1, denser than its outline's projection at the sides.
        across = math.sin(0.5 * math.pi * rng.uniform(-1, 1))
        along = (tuft + 0.5 + 0.42 * rng.standard_normal()) * LENGTH_MM / _TUFTS
        top = _PILE_MM * math.sqrt(max(1 - across**2, 0.02)) * rng.uniform(0.9, 1.03)
        root = np.array([0.18 * across * half, (tuft + 0.5) * LENGTH_MM / _TUFTS, -0.05])
        root[1] += 0.4 * (along - root[1])
        tip = np.array([across * half, along, top])
        # Fibres rise first and lean out above.
        share = np.linspace(0, 1, _POINTS)[:, None]
        middle = np.array([0.55 * tip[0], 0.5 * (root[1] + tip[1]), 0.75 * top])
        middle += np.array([0.05, 0.05, 0.03]) * rng.standard_normal(3)
        points = (1 - share) ** 2 * root + 2 * share * (1 - share) * middle + share**2 * tip
        points[1:] += 0.012 * rng.standard_normal((_POINTS - 1, 3))
        points[:, 0] += 0.5 * RIB_MM
        # A cubic B-spline begins and ends a third within its outer points.
        points = np.concatenate([2 * points[:1] - points[1:2], points, 2 * points[-1:] - points[-2:-1]])
        shades[tuft % 2].append((points, _RADIUS_MM))
    return shades


def ground() -> list[Curve]:
    """Picks along x and ends along y of the ground, as single thick curves."""
    curves: list[Curve] = []
    for count, other, size, length, is_end in (
        (_PICKS, _ENDS, LENGTH_MM, RIB_MM, False),
        (_ENDS, _PICKS, RIB_MM, LENGTH_MM, True),
    ):
        steps = 6 * other
        along = np.arange(-1, steps + 2) * length / steps
        for number in range(count):
            place = np.full_like(along, (number + 0.5) * size / count)
            swing = np.cos(math.pi * (along / length * other - 0.5 + number + is_end))
            height = -2 * _GROUND_RADIUS_MM + 0.8 * _GROUND_RADIUS_MM * swing
            pair = (place, along) if is_end else (along, place)
            curves.append((np.stack([*pair, height], axis=1), _GROUND_RADIUS_MM))
    return curves


def main(folder: Path) -> None:
    """Writes the tile."""
    colours = [parse_colour(colour, "colour") for colour in (*_PILE, _GROUND)]
    groups = list(zip(colours, [*pile(), ground()], strict=True))
    heading = (
        "# Corduroy, fibre by fibre; docs/learned-materials.md says how to bake it.\n"
        "# The fibres are made by `python -m examples.makers.corduroy`.\n"
    )
    write_curves(
        folder, "corduroy.toml", (RIB_MM, LENGTH_MM), groups, digits=3, heading=heading, front_mm=_FRONT_MM
    )


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path("examples/corduroy"))
