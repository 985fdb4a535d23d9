"""Defaults of a fabric file: values that depend on the weave, and values that do not.

Inclination and twist are those commonly suggested for the three basic weaves (Jin et al. 2022); to a draft
that has no name they apply by its structure.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import NDArray

GAP = 0.2
SPECULAR = 0.4
TRANSLUCENCY = 0.1
ROUGHNESS = 0.3
HEIGHT_SCALE = 1.0
# S twist, against the Z twist of the singles.
PLY_TWIST_DEG = 24.0
DIFFUSE_BLEND = 0.5
OPTICAL_DEPTH = 2.0


class Structure(Enum):
    """Which basic weave a drawdown resembles most."""

    PLAIN = "plain"
    TWILL = "twill"
    SATIN = "satin"


@dataclass(frozen=True)
class Bend:
    """Bend of one family: inclination of a float's ends and twist of the fibres, degrees."""

    inclination_deg: float
    twist_deg: float


_BENDS = {
    Structure.PLAIN: (Bend(22, 0), Bend(16, 0)),
    Structure.TWILL: (Bend(24, -30), Bend(24, -30)),
    Structure.SATIN: (Bend(60, 0), Bend(35, 0)),
}


def structure_of(drawdown: NDArray[np.bool_]) -> Structure:
    """The structure of a drawdown [picks, ends].

    Plain: each end crosses like its neighbour or exactly the other way (tabby, basket, rib). Satin: most
    points that stand alone among their four neighbours stand alone among all eight. Twill: all else.
    """
    beside = np.roll(drawdown, 1, axis=1)
    alike = (drawdown == beside).all(axis=0) | (drawdown != beside).all(axis=0)
    if alike.all():
        return Structure.PLAIN
    alone_of_four = _differs_from(drawdown, [(0, 1), (0, -1), (1, 0), (-1, 0)])
    alone_of_eight = alone_of_four & _differs_from(drawdown, [(1, 1), (1, -1), (-1, 1), (-1, -1)])
    many = alone_of_four.sum() * 50 >= drawdown.size
    return Structure.SATIN if many and 2 * alone_of_eight.sum() >= alone_of_four.sum() else Structure.TWILL


def bends_of(drawdown: NDArray[np.bool_]) -> tuple[Bend, Bend]:
    """Default bends of warp and weft; in a weft-faced satin the weft takes the warp's."""
    structure = structure_of(drawdown)
    warp, weft = _BENDS[structure]
    weft_faced = drawdown.mean() < 0.5
    return (weft, warp) if structure is Structure.SATIN and weft_faced else (warp, weft)


def _differs_from(drawdown: NDArray[np.bool_], shifts: list[tuple[int, int]]) -> NDArray[np.bool_]:
    different = np.ones_like(drawdown)
    for shift in shifts:
        different &= drawdown != np.roll(drawdown, shift, axis=(0, 1))
    return different
