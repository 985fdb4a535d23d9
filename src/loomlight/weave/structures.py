"""Weave structures as periodic matrices, bool [picks, ends], True where the warp is on top.

Diagonals are named as they are drawn on the face, pick 1 at the bottom: Z rises to the right, S to the
left. The notation a/b counts along a pick from end 1: a ends up, then b ends down.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import gcd

import numpy as np
from numpy.typing import NDArray

Structure = NDArray[np.bool_]
# Ends, and picks, of a weave that is made from its name: a short text should not take all memory.
MAXIMUM_NAMED_THREADS = 4096


def plain() -> Structure:
    """Plain weave, also called tabby: over one, under one."""
    return np.eye(2, dtype=bool)


def _up_and_down(parts: Sequence[int]) -> NDArray[np.bool_]:
    return np.repeat(np.arange(len(parts)) % 2 == 0, parts)


def twill(parts: Sequence[int], *, z: bool = True) -> Structure:
    """A twill whose pick 1 goes up, down, up, down by `parts`; each next pick is one end further.

    Args:
        parts: an even number of lengths >= 1, such as (2, 1) or (2, 1, 1, 2).
        z: whether the diagonal rises to the right.
    """
    return twill_of(np.arange(sum(parts)), np.arange(sum(parts)), parts, z=z)


def twill_of(
    threading: NDArray[np.intp], treadling: NDArray[np.intp], parts: Sequence[int], *, z: bool = True
) -> Structure:
    """A twill that is threaded and treadled in another order: entry (j, i) of the result is entry
    (treadling[j], threading[i]) of the straight twill."""
    first_pick = _up_and_down(parts)
    shift = treadling if z else -treadling
    return first_pick[(threading[None, :] - shift[:, None]) % first_pick.size]


def satin_steps(ends: int) -> list[int]:
    """The steps that make a regular satin: coprime with the ends, neither 1 nor ends − 1."""
    return [step for step in range(2, ends - 1) if gcd(step, ends) == 1]


def spread_satin_step(ends: int) -> int | None:
    """The step whose binding points lie furthest apart; None if no regular satin has so many ends."""

    def nearest_squared(step: int) -> int:
        rise = np.arange(1, ends)
        run = (rise * step + ends // 2) % ends - ends // 2
        return int(np.min(np.minimum(rise, ends - rise) ** 2 + run**2))

    return max(satin_steps(ends), key=lambda step: (nearest_squared(step), -step), default=None)


def sateen(ends: int, step: int) -> Structure:
    """Weft-faced satin: one end up on each pick, each next pick `step` ends further."""
    return np.asarray((np.arange(ends)[None, :] - step * np.arange(ends)[:, None]) % ends == 0)


def satin(ends: int, step: int) -> Structure:
    """Warp-faced satin: one end down on each pick, each next pick `step` ends further."""
    return ~sateen(ends, step)


def basket(ends_together: int, picks_together: int) -> Structure:
    """Plain weave of groups: so many neighbouring ends work as one, and so many picks."""
    return np.repeat(np.repeat(plain(), picks_together, axis=0), ends_together, axis=1)


def warp_rib(over: int, under: int) -> Structure:
    """Every end floats over so many picks and under so many; neighbouring ends are opposite."""
    one_end = _up_and_down((over, under))
    return np.stack([one_end, ~one_end], axis=1)


def weft_rib(over: int, under: int) -> Structure:
    """Every pick floats over so many ends and under so many; neighbouring picks are opposite."""
    return ~warp_rib(over, under).T


def herringbone(parts: Sequence[int], leg: int) -> Structure:
    """A twill that turns every `leg` ends, with a cut: the ends that meet at a turn are opposite."""
    period = sum(parts)
    up = np.arange(leg)
    down = leg - 1 + period // 2 - np.arange(leg)
    return twill_of(np.concatenate([up, down]), np.arange(period), parts)


def pointed(leg: int) -> NDArray[np.intp]:
    """The numbers 0 to `leg` and back to 1: a point draw, or a point treadling."""
    return np.abs((np.arange(2 * leg) + leg) % (2 * leg) - leg)


def diamond_twill(parts: Sequence[int], leg: int) -> Structure:
    """A twill that turns every `leg` ends and every `leg` picks, on a single thread each time."""
    return twill_of(pointed(leg), pointed(leg), parts)


def waffle(half: int) -> Structure:
    """Waffle weave: cells of 2·`half` ends and picks, plain in the middle, floats around the rim.

    Point draw on half + 1 shafts; pick t lifts shaft 0 to t − 1 and the one after its own.
    """
    shafts = pointed(half)
    treadle, shaft = shafts[:, None], shafts[None, :]
    return np.asarray((shaft < treadle) | (shaft == treadle + 1))


# An eight-shaft crêpe of our own: plain weave with four crossings a quadrant turned about, no float over 3.
_CREPE = """
    x.x..x.x
    .xx.x.x.
    x..x.xx.
    .x.xx..x
    x.x.x.x.
    .x.x..xx
    .xx.xx..
    x..x.x.x
"""


def crepe() -> Structure:
    """A crêpe: short floats scattered so that no line shows."""
    rows = [[mark == "x" for mark in line.strip()] for line in _CREPE.strip().splitlines()]
    return np.array(rows[::-1], dtype=bool)
