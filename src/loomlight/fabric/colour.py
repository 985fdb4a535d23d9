"""Albedos of yarns, a row a thread, from the colours that cloth shows; and colours that cloth cannot show."""

from __future__ import annotations

import warnings
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import delta_e_2000, lab_of_linear, lab_of_text, parse_colour, to_hex
from loomlight.core.errors import LoomlightWarning
from loomlight.fabric.fields import FabricFile, colours_in_order
from loomlight.fabric.resolve import NEP_COLOUR, ResolvedFabric, ResolvedFamily
from loomlight.scattering.albedo import LayerBound, albedos_from_colour, check_albedos
from loomlight.scattering.appearance import FamilyAppearance, Irregularity
from loomlight.scattering.fibre import cloth_layer_bound, mean_layer_shares
from loomlight.scattering.interreflection import scattered, solved_interior
from loomlight.scattering.openness import Openness

# Reflectance of the deepest dye: of black, none would be left to fade.
DARKEST = 2e-3
# How much faster dye goes at first than at the end, and the share that no rubbing takes off.
FADING, TRACE = 8.0, 0.02


def family_appearance(
    family: ResolvedFamily, name: str, optical_depth: float, openness: Openness | None
) -> FamilyAppearance:
    """Appearance of the threads of a family, "warp" or "weft".

    A tint only takes from the highlight, so it keeps the energy bound.

    Args:
        openness: of the cloth, by which colours are those that cloth shows, unless they are albedos; None
            makes albedos of them.

    Raises:
        InputError: explicit albedos that together send back more light than arrives.
    """
    colours, bound = faded(family.colours, family.worn), None
    if openness is not None:
        bound = cloth_layer_bound(family.roughness, optical_depth)
        if not family.are_albedos:
            colours = colour_for(colours, *_yarn(family, name, optical_depth, openness))
    albedos = albedos_from_colour(colours, family.specular, family.translucency, optical_depth, bound)
    albedos = albedos._replace(
        specular_reflect=albedos.specular_reflect * family.specular_tint,
        specular_transmit=albedos.specular_transmit * family.specular_tint,
    )
    rows = {key: np.tile(value, (len(colours), 1)) for key, value in family.given_albedos.items()}
    albedos = albedos._replace(**rows)
    check_albedos(albedos, name, optical_depth, bound)
    return FamilyAppearance(
        **albedos._asdict(),
        roughness=family.roughness,
        specular_grazing=family.specular_grazing,
        detail=family.detail,
        irregularity=_irregularity(family, name, optical_depth, openness, bound),
    )


def _irregularity(
    family: ResolvedFamily,
    name: str,
    optical_depth: float,
    openness: Openness | None,
    bound: LayerBound | None,
) -> Irregularity:
    """That of a family with the albedo of its neps: knots so thick that no light goes through."""
    if not family.irregularity.neps > 0:
        return family.irregularity
    colour = family.nep_colour[None]
    if openness is not None:
        knot = replace(family, translucency=0.0)
        colour = colour_for(colour, *_yarn(knot, name, optical_depth, openness))
    albedos = albedos_from_colour(colour, family.specular, 0.0, optical_depth, bound)
    red, green, blue = (float(channel) for channel in albedos.diffuse_reflect[0])
    return replace(family.irregularity, nep_albedo=(red, green, blue))


def _yarn(
    family: ResolvedFamily, name: str, optical_depth: float, openness: Openness
) -> tuple[float, float, Openness, int, float, float]:
    """The arguments of `shown_colour` after the colour."""
    number = ("warp", "weft").index(name)
    return family.specular, family.translucency, openness, number, family.roughness, optical_depth


def faded(colours: NDArray[np.float64], worn: float) -> NDArray[np.float64]:
    """Colours [n, 3] of threads rubbed as much as `worn` says, 0 to 1; at the end a trace of dye stays.

    Dye adds to how much fibres absorb for what they scatter, K/S = (1 − R)²/2R (Kubelka and Munk 1931). How
    much is left makes lightness grow in even steps.
    """
    if worn == 0:
        return colours
    left = (1 - worn) / (1 + FADING * worn) + TRACE * worn
    undyed = absorption(parse_colour(NEP_COLOUR, "undyed fibres"))
    ratio = undyed + left * (absorption(np.maximum(colours, DARKEST)) - undyed)
    found: NDArray[np.float64] = 1 + ratio - np.sqrt(ratio * (ratio + 2))
    return found


def absorption(colours: NDArray[np.float64]) -> NDArray[np.float64]:
    """K/S of reflectances above 0."""
    ratio: NDArray[np.float64] = np.square(1 - colours) / (2 * colours)
    return ratio


# -------------------------------------------------------------------------------- colours as cloth shows them
# What a flat cloth woven of one yarn alone reflects, and the inverse of that.
#
# The instrument is the one of textile laboratories, d/8° (CIE 15:2018): a white sky over the cloth, a view
# 8° from the normal, nothing behind. The reflectance is what the point model with light between yarns
# returns there (`scattering/interreflection.py`), by channels; it grows with the colour that albedos are
# made of, so halving intervals inverts it.


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


# ----------------------------------------------------------------------------- colours that cloth cannot show
# One sentence each, with the difference that an eye sees.


# CIEDE2000 below which a difference is hardly seen on cloth.
_TOLERANCE = 2.0


def warn_of_colours_out_of_reach(fields: FabricFile, resolved: ResolvedFabric, openness: Openness) -> None:
    """Warns of each family whose `color` cloth woven of it alone cannot show within ΔE2000 of 2."""
    for name in ("warp", "weft"):
        yarn = _yarn(getattr(resolved, name), name, resolved.optical_depth, openness)
        sentence = _sentence(getattr(fields, name).color, name, yarn)
        if sentence:
            warnings.warn(sentence, LoomlightWarning, stacklevel=2)


def _sentence(color: object, name: str, yarn: tuple[float, float, Openness, int, float, float]) -> str | None:
    """Of the colour that is farthest out of reach; None where all are within."""
    if color is None:
        return None
    listed = colours_in_order(color, f"{name}.color")
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
