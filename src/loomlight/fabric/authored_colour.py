"""Colours as cloth shows them: what a flat cloth woven of one yarn alone reflects, and the inverse of that.

The instrument is the one of textile laboratories, d/8° (CIE 15:2018): a white sky over the cloth, a view 8°
from the normal, nothing behind. The reflectance is what the point model with light between yarns returns
there (`scattering/interreflection.py`), by channels; it grows with the colour that albedos are made of, so
halving intervals inverts it.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from loomlight.scattering.albedo import albedos_from_colour
from loomlight.scattering.fibre import cloth_layer_bound, mean_layer_shares
from loomlight.scattering.interreflection import scattered, solved_interior
from loomlight.scattering.openness import Openness

# Halvings of [0, 1]: errors are below a step of 16-bit colours.
HALVINGS = 20


def shown_colour(
    colour: NDArray[np.float64],
    specular: float,
    translucency: float,
    openness: Openness,
    family: int,
    roughness: float,
    optical_depth: float,
) -> NDArray[np.float64]:
    """Linear RGB reflectance [n, 3] of cloth woven of a yarn alone whose albedos are made of `colour` [n, 3].

    Args:
        specular, translucency: of the yarn, 0 to 1.
        openness: of the cloth.
        family: 0 for warp, 1 for weft.
        roughness: α of the yarn.
        optical_depth: Tρ of its fibre layer.
    """
    bound = cloth_layer_bound(roughness, optical_depth)
    albedos = albedos_from_colour(colour, specular, translucency, optical_depth, bound)
    shares = tuple(float(share) for share in mean_layer_shares(roughness, optical_depth))
    yarn = scattered(*albedos, shares)
    front, behind = solved_interior(yarn, yarn, openness.interior, openness.meets, openness.blocks)
    seen, far = openness.facing
    return np.asarray(
        seen * albedos.diffuse_reflect
        + openness.facing_layer[family, 0] * albedos.specular_reflect
        + (1 - seen) * yarn.back * front.mean
        + (1 - far) * yarn.through * behind.leaked
    )


def colour_for(
    shown: NDArray[np.float64],
    specular: float,
    translucency: float,
    openness: Openness,
    family: int,
    roughness: float,
    optical_depth: float,
) -> NDArray[np.float64]:
    """The colour [n, 3] that albedos are made of so that cloth shows `shown` [n, 3], linear RGB.

    Colours brighter or darker than the cloth can be become the nearest in each channel: 1 or 0. Other
    arguments are those of `shown_colour`.
    """
    distinct, places = np.unique(shown, axis=0, return_inverse=True)
    low, high = np.zeros_like(distinct), np.ones_like(distinct)
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        is_dark = (
            shown_colour(middle, specular, translucency, openness, family, roughness, optical_depth)
            < distinct
        )
        low, high = np.where(is_dark, middle, low), np.where(is_dark, high, middle)
    found: NDArray[np.float64] = (0.5 * (low + high))[places.ravel()]
    return found
