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
# Crossings of a drawdown that are looked at once, to fit caches.
_CROSSINGS_AT_ONCE = 1 << 18


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
    picks, ends = drawdown.shape
    same, opposite = np.ones((2, ends), bool)
    of_four = of_eight = 0
    step = max(1, _CROSSINGS_AT_ONCE // ends)
    for first in range(0, picks, step):
        near = drawdown[np.arange(first - 1, min(first + step, picks) + 1) % picks]
        here, below, above = near[1:-1], near[:-2], near[2:]
        beside = here != np.roll(here, 1, axis=1)
        same &= ~beside.any(axis=0)
        opposite &= beside.all(axis=0)
        alone = beside & (here != np.roll(here, -1, axis=1)) & (here != below) & (here != above)
        of_four += int(alone.sum())
        for diagonal in (np.roll(row, shift, axis=1) for row in (below, above) for shift in (1, -1)):
            alone &= here != diagonal
        of_eight += int(alone.sum())
    if (same | opposite).all():
        return Structure.PLAIN
    return Structure.SATIN if of_four * 50 >= drawdown.size and 2 * of_eight >= of_four else Structure.TWILL


def bends_of(drawdown: NDArray[np.bool_]) -> tuple[Bend, Bend]:
    """Default bends of warp and weft; in a weft-faced satin the weft takes the warp's."""
    structure = structure_of(drawdown)
    warp, weft = _BENDS[structure]
    weft_faced = drawdown.mean() < 0.5
    return (weft, warp) if structure is Structure.SATIN and weft_faced else (warp, weft)
