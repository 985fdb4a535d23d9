"""Colour-and-weave effects: a simple structure and an order of colours that together make a figure.

Index 0 of a colour order is the dark colour, 1 the light one.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import lcm

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import parse_colour
from loomlight.weave.draft import Draft
from loomlight.weave.palette import from_palette, runs
from loomlight.weave.structures import Structure, plain, twill

CHARCOAL_AND_CREAM = ("#23262e", "#ece4d3")
INDIGO_AND_ECRU = ("#22335c", "#e6dfce")
NAVY_AND_CHALK = ("#1d2536", "#c9ccd2")
BLUE_AND_WHITE = ("#3a6ea8", "#f2f0ea")


@dataclass(frozen=True, eq=False)
class Effect:
    """A structure with colour orders; both repeat until they fit together.

    Attributes:
        structure: bool [picks, ends].
        warp_order: palette index per end; its length is the colour repeat.
        weft_order: palette index per pick.
        palette: sRGB hex of the default colours.
    """

    structure: Structure
    warp_order: NDArray[np.intp]
    weft_order: NDArray[np.intp]
    palette: tuple[str, ...] = CHARCOAL_AND_CREAM

    @property
    def repeat(self) -> tuple[int, int]:
        """Picks and ends after which structure and colours repeat together."""
        picks, ends = self.structure.shape
        return lcm(picks, self.weft_order.size), lcm(ends, self.warp_order.size)

    def draft(self, title: str) -> Draft:
        """The effect as a draft of one full repeat, in its default colours."""
        picks, ends = self.repeat
        palette = np.array([parse_colour(color, "palette") for color in self.palette])
        rows, columns = self.structure.shape
        return Draft(
            drawdown=np.tile(self.structure, (picks // rows, ends // columns)),
            warp=from_palette(ends, self.warp_order, palette),
            weft=from_palette(picks, self.weft_order, palette),
            title=title,
            palette=palette,
        )


def houndstooth(width: int) -> Effect:
    """2/2 twill with `width` dark and `width` light threads both ways; 4 makes the classic tooth."""
    order = runs((0, width), (1, width))
    return Effect(twill((2, 2)), order, order)


def hairline() -> Effect:
    """Plain weave, one dark and one light: every end covers its own colour, which gives fine lines."""
    return Effect(plain(), runs((0, 1), (1, 1)), runs((1, 1), (0, 1)), NAVY_AND_CHALK)


def log_cabin(width: int) -> Effect:
    """Plain weave of alternating dark and light, whose order flips every `width` threads."""
    alternate = np.arange(width, dtype=np.intp) % 2
    order = np.concatenate([alternate, 1 - alternate])
    return Effect(plain(), order, order)


def glen_check(groups: int) -> Effect:
    """Glen Urquhart check: 2/2 twill, `groups` of four dark and four light beside as wide a field of two
    and two."""
    order = np.concatenate([runs((0, 4), (1, 4))] * groups + [runs((0, 2), (1, 2))] * (2 * groups))
    return Effect(twill((2, 2)), order, order)


def shepherds_check(width: int) -> Effect:
    """Even checks in 2/2 twill: solid squares joined by diagonal half-tones; 8 and wider show as checks."""
    return Effect(twill((2, 2)), runs((0, width), (1, width)), runs((0, width), (1, width)))


def gingham(width: int) -> Effect:
    """Even checks in plain weave."""
    order = runs((0, width), (1, width))
    return Effect(plain(), order, order, BLUE_AND_WHITE)


def pinstripe(width: int) -> Effect:
    """2/1 twill in the dark colour with one light end in every `width`."""
    return Effect(twill((2, 1)), runs((0, width - 1), (1, 1)), runs((0, 1)), NAVY_AND_CHALK)


def denim() -> Effect:
    """3/1 twill, indigo warp, undyed weft."""
    return Effect(twill((3, 1)), runs((0, 1)), runs((1, 1)), INDIGO_AND_ECRU)


def chambray() -> Effect:
    """Plain weave, coloured warp, white weft."""
    return Effect(plain(), runs((0, 1)), runs((1, 1)), BLUE_AND_WHITE)
