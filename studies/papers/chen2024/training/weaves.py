"""Weaves that the network is trained on beside the paper's seven: named ones and random ones.

Held-out evaluation weaves (`HELD_OUT_WEAVES`) and their turned, mirrored and shifted copies are never drawn.
"""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from loomlight.weave.draft import Draft
from loomlight.weave.named import named_weave

# The seven weaves of chen2024 5.1 as drafts: ends × picks of one repeat.
PAPER_WEAVES = {
    "plain": "plain",
    "twill 3×3": "twill 2/1",
    "twill 5×5": "twill 3/2",
    "twill 8×8": "twill 5/3",
    "satin 5×5": "satin 5/2",
    "satin 8×8": "satin 8/3",
    "satin 5×10": "satin 5×10",
}


# Weaves of the query benchmark (evaluation) that no training may see.
HELD_OUT_WEAVES = (
    "twill 4/4",
    "basket 2/2",
    "herringbone 2/2 8",
    "houndstooth 4",
    "diamond figure 48",
    "waffle 8",
    "twill 2/2",
    "crepe",
    "warp rib 2/2",
    "satin 7/2",
    "diamond 2/2 8",
    "twill 3/1 s",
)
# Repeats that are drawn: an encoder's cost grows with their area.
_MAX_RANDOM = 12


def paper_draft(name: str) -> Draft:
    """One of `PAPER_WEAVES` as a draft."""
    if name != "satin 5×10":
        return named_weave(PAPER_WEAVES[name])
    # Two picks a shed: the five-end satin on ten picks.
    return Draft(np.repeat(named_weave("satin 5/2").drawdown, 2, axis=0))


def training_draft(rng: np.random.Generator, weaves: str) -> Draft:
    """A draft to train on: of the paper's seven ("paper"), or half of them, half of others ("all")."""
    names = list(PAPER_WEAVES)
    if weaves == "paper" or rng.random() < 0.5:
        return paper_draft(names[rng.integers(len(names))])
    while True:
        draft = _other(rng)
        if _class_of(draft.drawdown) not in _held_out():
            return draft


def _other(rng: np.random.Generator) -> Draft:
    kind = rng.choice(["twill", "satin", "block", "shafts"], p=[0.35, 0.2, 0.15, 0.3])
    if kind == "twill":
        parts = rng.integers(1, 5, 2 * rng.integers(1, 3))
        turn = rng.choice(["z", "s"])
        return named_weave(f"twill {'/'.join(map(str, parts))} {turn}")
    if kind == "satin":
        ends = int(rng.choice([5, 7, 8, 9, 10, 11, 12]))
        drawn = named_weave(f"satin {ends}")
        return drawn if rng.random() < 0.5 else Draft(~drawn.drawdown)
    if kind == "block":
        across, along = rng.integers(1, 4, 2)
        return Draft(np.kron(np.array([[True, False], [False, True]]), np.ones((along, across), bool)))
    return Draft(_from_shafts(rng))


def _from_shafts(rng: np.random.Generator) -> NDArray[np.bool_]:
    """A random drawdown as few shafts weave it: rows and columns of a small random matrix, in some order."""
    while True:
        shafts, treadles = rng.integers(2, 7, 2)
        lifts = rng.random((treadles, shafts)) < rng.uniform(0.35, 0.65)
        ends, picks = rng.integers(3, _MAX_RANDOM + 1, 2)
        drawdown = lifts[rng.integers(treadles, size=picks)][:, rng.integers(shafts, size=ends)]
        ups = [drawdown.mean(axis) for axis in (0, 1)]
        if all(((up > 0) & (up < 1)).all() for up in ups):  # every thread interlaces
            return drawdown


@cache
def _held_out() -> frozenset[bytes]:
    drawdowns = (named_weave(name).drawdown for name in HELD_OUT_WEAVES)
    return frozenset(_class_of(drawdown) for drawdown in drawdowns if max(drawdown.shape) <= 16)


def _class_of(drawdown: NDArray[np.bool_]) -> bytes:
    """The same bytes for all turned, mirrored, shifted and inverted copies of a drawdown."""
    copies: list[bytes] = []
    for pattern in (drawdown, ~drawdown):
        for turns in range(4):
            turned = np.rot90(pattern, turns)
            # A quarter turn swaps the families, so what was on top is beneath.
            turned = ~turned if turns % 2 else turned
            for copy in (turned, turned[:, ::-1]):
                rows, columns = copy.shape
                for row in range(rows):
                    shifted = np.roll(copy, row, 0)
                    copies.extend(
                        np.roll(shifted, column, 1).tobytes() + bytes([rows % 251, columns % 251])
                        for column in range(columns)
                    )
    return min(copies)
