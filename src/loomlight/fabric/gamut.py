"""Colours that cloth of a yarn cannot show: one sentence each, with the difference that an eye sees."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import delta_e_2000, lab_of_linear, lab_of_text, parse_colour, to_hex
from loomlight.core.errors import LoomlightWarning
from loomlight.fabric.authored_colour import colour_for, shown_colour
from loomlight.fabric.defaults import ROUGHNESS, SPECULAR, TRANSLUCENCY
from loomlight.fabric.file import FabricFile, YarnTable
from loomlight.fabric.thread_order import colours_in_order

if TYPE_CHECKING:
    from loomlight.scattering.openness import Openness

# CIEDE2000 below which a difference is hardly seen on cloth.
_TOLERANCE = 2.0


def warn_of_colours_out_of_reach(fields: FabricFile, optical_depth: float, openness: Openness) -> None:
    """Warns of each family whose `color` cloth woven of it alone cannot show within ΔE2000 of 2."""
    for family, name in enumerate(("warp", "weft")):
        sentence = _sentence(getattr(fields, name), name, family, optical_depth, openness)
        if sentence:
            warnings.warn(sentence, LoomlightWarning, stacklevel=2)


def _sentence(
    table: YarnTable, name: str, family: int, optical_depth: float, openness: Openness
) -> str | None:
    """Of the colour that is farthest out of reach; None where all are within."""
    if table.color is None:
        return None
    listed = colours_in_order(table.color, f"{name}.color")
    yarn = (
        SPECULAR if table.specular is None else table.specular,
        TRANSLUCENCY if table.translucency is None else table.translucency,
        openness,
        family,
        ROUGHNESS if table.roughness is None else table.roughness,
        optical_depth,
    )
    wanted = np.array([parse_colour(colour, f"{name}.color") for colour in listed])
    shown = shown_colour(colour_for(wanted, *yarn), *yarn)
    differences = delta_e_2000(_labs(listed, wanted, name), lab_of_linear(shown))
    worst = int(np.argmax(differences))
    if differences[worst] <= _TOLERANCE:
        return None
    return (
        f"{name}.color = {_written(listed[worst])} is out of reach of cloth of this yarn: it shows "
        f"{to_hex(shown[worst])}, a difference (CIEDE2000) of {differences[worst]:.1f}; "
        f"{_advice(wanted[worst], shown[worst])}."
    )


def _advice(wanted: NDArray[np.float64], shown: NDArray[np.float64]) -> str:
    if shown.sum() > wanted.sum():
        return "a lower specular lets it be darker"
    return "a lower specular or translucency lets it be brighter"


def _labs(listed: list[object], wanted: NDArray[np.float64], name: str) -> NDArray[np.float64]:
    """L*a*b* of colours as they are written, which may lie outside the gamut of RGB [n, 3]."""
    written = [lab_of_text(colour, f"{name}.color") for colour in listed]
    return np.array(
        [lab_of_linear(linear) if lab is None else lab for lab, linear in zip(written, wanted, strict=True)]
    )


def _written(colour: object) -> str:
    return f'"{colour}"' if isinstance(colour, str) else str(colour)
