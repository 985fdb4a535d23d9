"""Layouts of cloth, even and random."""

from __future__ import annotations

import math
import warnings
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import LoomlightWarning
from loomlight.fabric import load_fabric
from loomlight.yarn.layout import ClothLayout, FamilyLayout

_LAYERED = Path(__file__).parents[2] / "examples" / "layered"
PLAIN = np.array([[True, False], [False, True]])
TWILL = np.array([[(end - pick) % 4 != 0 for end in range(4)] for pick in range(4)])
SATIN = np.array([[(2 * end) % 5 != pick for end in range(5)] for pick in range(5)])


def even_layout(
    warp_on_top: NDArray[np.bool_],
    spacing: float = 0.4,
    gap: float = 0.2,
    inclination: float = 24.0,
    twist: float = -30.0,
    height_scale: float = 0.8,
) -> ClothLayout:
    """Equal warp and weft; angles in degrees, lengths in millimetres."""
    picks, ends = warp_on_top.shape

    def family(count: int) -> FamilyLayout:
        return FamilyLayout(
            np.full(count, spacing),
            np.full(count, spacing * (1 - gap)),
            math.radians(inclination),
            math.radians(twist),
            height_scale,
        )

    return ClothLayout(warp_on_top, family(ends), family(picks))


def layered_layout(name: str) -> ClothLayout:
    """The layout of one of the examples of layered cloth, without ties, which shaders do not draw."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", LoomlightWarning)  # that it has layers
        return replace(load_fabric(_LAYERED / f"{name}.wif").layout(), ties=())


def random_layout(rng: np.random.Generator, uneven: bool) -> ClothLayout:
    """Anything the layout admits: unequal setts, widths, inclinations and height scales."""
    picks, ends = rng.integers(1, 12, 2)
    warp_on_top = rng.random((picks, ends)) < rng.uniform(0.1, 0.9)

    def family(count: int) -> FamilyLayout:
        base = rng.uniform(0.1, 1)
        spacing = base * (rng.uniform(0.3, 1, count) if uneven else np.ones(count))
        width = spacing * (rng.uniform(0.2, 1.3, count) if uneven else rng.uniform(0.2, 1.1))
        return FamilyLayout(
            spacing,
            width,
            math.radians(rng.uniform(0, 80)),
            math.radians(rng.uniform(-89, 89)),
            rng.uniform(0.01, 2),
        )

    return ClothLayout(warp_on_top, family(int(ends)), family(int(picks)))
