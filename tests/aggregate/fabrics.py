"""Fabrics for the tests of this folder."""

from __future__ import annotations

import math

import numpy as np

from loomlight.fabric import fabric_from_text
from loomlight.scattering.appearance import Appearance, FamilyAppearance, Sheen
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout, FamilyLayout

NAMES = ("plain", "twill 3/1", "satin 5/2", "basket 2/2", "uneven")


def woven(name: str, roughness: tuple[float, float] = (0.3, 0.3), sheen: float = 0.0) -> YarnScattering:
    """A fabric whose threads all differ in colour, translucent: a weave by name, or an uneven draft."""
    rng = np.random.default_rng(len(name))
    layout = _uneven(rng) if name == "uneven" else fabric_from_text(name).layout()
    picks, ends = layout.warp_on_top.shape

    def family(count: int, alpha: float) -> FamilyAppearance:
        colour = rng.random((count, 3))
        return FamilyAppearance(0.3 * colour, 0.2 * colour, 0.4 * colour, 0.3 * colour, alpha)

    appearance = Appearance(family(ends, roughness[0]), family(picks, roughness[1]), sheen=Sheen(sheen, 0.4))
    return YarnScattering(YarnGeometry(layout), appearance)


def _uneven(rng: np.random.Generator) -> ClothLayout:
    warp_on_top = np.array([[1, 0, 0], [1, 1, 0], [0, 1, 1], [0, 0, 1]], bool)

    def family(count: int, spacing: float, inclination: float, twist: float, scale: float) -> FamilyLayout:
        spacings = spacing * rng.uniform(0.7, 1, count)
        widths = spacings * rng.uniform(0.6, 0.9, count)
        return FamilyLayout(spacings, widths, math.radians(inclination), math.radians(twist), scale)

    return ClothLayout(warp_on_top, family(3, 0.4, 30, -30, 0.7), family(4, 0.55, 20, 15, 1.2))
