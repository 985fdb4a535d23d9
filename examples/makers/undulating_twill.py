"""Writes examples/undulating-twill.wif, a draft of our own: a fancy twill on 24 shafts whose lines undulate.

The threading runs up the shafts now slowly, ends staying on a shaft, now fast; treadles follow in order, so
that the twill's lines bend. Colours of the warp change where the lines turn.
Run: python -m examples.makers.undulating_twill
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import parse_colour
from loomlight.weave.draft import Draft, LoomPlan, Threads
from loomlight.weave.loom import plan_drawdown
from loomlight.weave.wif_writer import write_wif

OUTPUT = Path(__file__).resolve().parents[1] / "undulating-twill.wif"
SHAFTS = 24
# Ends and picks of a repeat: five times (unevenly) and four times through all shafts.
ENDS, PICKS = 144, 96
# How a treadle's shafts go up and down, from shaft 1.
TIEUP = (3, 2, 1, 2, 2, 3, 1, 2, 1, 3, 2, 2)
# Of the mean rise of the threading, how far it departs from it: to between 0.46 and 1.21 shafts an end.
SWAY = 0.45
PALETTE = ("#1f3a5f", "#2f7275", "#c8693f", "#efe6d3")
SETT_MM = 0.5


def undulating_twill() -> Draft:
    """The draft, with its threading, tie-up, treadling, colours and sett."""
    along = (np.arange(ENDS) + 0.5) / ENDS
    shaft = _rounds(along, ENDS // SHAFTS - 1) % SHAFTS
    treadle = np.arange(PICKS) % SHAFTS
    raised = np.repeat(np.arange(len(TIEUP)) % 2 == 0, TIEUP)
    plan = LoomPlan(
        threading=tuple(frozenset({int(number) + 1}) for number in shaft),
        shafts=SHAFTS,
        treadles=SHAFTS,
        tieup=tuple(
            frozenset(int(number) + 1 for number in np.flatnonzero(np.roll(raised, treadle)))
            for treadle in range(SHAFTS)
        ),
        treadling=tuple(frozenset({int(number) + 1}) for number in treadle),
    )
    palette = np.array([parse_colour(colour, "palette") for colour in PALETTE])
    of_end = _stripes(along)
    of_pick = np.full(PICKS, 3)
    return Draft(
        drawdown=plan_drawdown(plan),
        warp=Threads(palette[of_end], np.full(ENDS, SETT_MM), None, of_end),
        weft=Threads(palette[of_pick], np.full(PICKS, SETT_MM), None, of_pick),
        title="Undulating twill",
        loom=plan,
        palette=palette,
        notes=(
            "A fancy twill on 24 shafts with an undulating threading.",
            "Made for loomlight; use it freely.",
        ),
    )


def _rounds(along: NDArray[np.float64], times: int) -> NDArray[np.intp]:
    """Shafts, from 0, of a threading that rises so many times through all shafts, now slowly and now fast."""
    swing = SWAY * np.sin(4 * np.pi * along) / (4 * np.pi)
    return np.floor((along - swing) * times * SHAFTS).astype(np.intp)


def _stripes(along: NDArray[np.float64]) -> NDArray[np.intp]:
    """Indigo where the lines run flat, petrol where they are steep, two ends of copper between."""
    phase = (2 * along) % 1
    of_end = np.where((phase > 0.25) & (phase < 0.75), 1, 0)
    turns = np.flatnonzero(np.diff(of_end))
    for turn in turns:
        of_end[turn : turn + 2] = 2
    return of_end.astype(np.intp)


if __name__ == "__main__":
    write_wif(undulating_twill(), OUTPUT)
