"""Albedos that create no energy: the map from what a person gives, and the check of what was given directly.

The fibre layer returns at most a share κ of the light when its albedo is 1, so that

    k_d_reflect + k_d_transmit + κ(Tρ)·max(k_s_reflect, k_s_transmit) ≤ 1    per channel

keeps every direction below 1 (docs/research/scattering.md has the reasoning and the scan). κ holds for
tangents perpendicular to the yarn's normal, which every source of geometry provides.

Cloth with light between its yarns loses nothing but what κ takes, and white yarns with a highlight would be
grey: seen from above, the layer returns half of κ. There the means of the layer bound what views of whole
cloth meet, whose yarns lean to all sides (`fibre.py:cloth_layer_bound`).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from loomlight.core.errors import InputError

# Light that a fibre reflects at its surface keeps its colour, light that crosses it takes the dye's. This
# share of the highlight is white.
WHITE_SHARE = 0.3
# What rounding of linear RGB triples written with six digits may add up to.
ALBEDO_TOLERANCE = 1e-5


class Albedos(NamedTuple):
    """Four albedos [n, 3], a row a thread, linear RGB, 0 to 1: the fields of `FamilyAppearance`."""

    diffuse_reflect: NDArray[np.float64]
    diffuse_transmit: NDArray[np.float64]
    specular_reflect: NDArray[np.float64]
    specular_transmit: NDArray[np.float64]


class LayerBound(NamedTuple):
    """Shares of the light that a fibre layer may return: of the larger and of the smaller of its two albedos.

    The layer takes larger·max(k_s_reflect, k_s_transmit) + smaller·min(k_s_reflect, k_s_transmit) of what
    diffuse terms may return.
    """

    larger: float
    smaller: float = 0.0

    def taken(self, first: NDArray[np.float64], second: NDArray[np.float64]) -> NDArray[np.float64]:
        """Energy that a layer of these albedos, reflected and transmitted in any order, takes; arrays too."""
        taken: NDArray[np.float64] = self.larger * np.maximum(first, second)
        return taken + self.smaller * np.minimum(first, second)


def layer_albedo_bound(optical_depth: float) -> float:
    """κ = (1 + e^{−Tρ})/2: no direction gets more than this share back from a layer of albedo 1, both sides.

    Tangent and normal are perpendicular. Half of what scatters at once leaves upwards; the other half
    crosses a depth of at least Tρ, since σ(ω) ≥ |ω·n_p| there.
    """
    return 0.5 * (1 + math.exp(-optical_depth))


def strongest_highlight(optical_depth: float) -> float:
    """Albedo of the highlight of white threads at specular 1, 0.58 to 1.

    The diffuse albedo is colour·(1 − κ·strength·(W + (1 − W)·colour)), W being `WHITE_SHARE`. It grows with
    the colour up to white as long as strength·κ·(2 − W) ≤ 1; κ is large where the layer is thin.
    """
    return min(1.0, 1 / ((2 - WHITE_SHARE) * layer_albedo_bound(optical_depth)))


def albedos_from_colour(
    colour: ArrayLike,
    specular: ArrayLike,
    translucency: ArrayLike,
    optical_depth: float = 2.0,
    bound: LayerBound | None = None,
) -> Albedos:
    """Albedos of threads from a colour, how strongly their fibres shine and how much light they let through.

    The highlight takes `WHITE_SHARE` white and the rest the colour, scaled by `specular`; the diffuse terms
    get the colour times the room that it leaves, split by `translucency`, which scales the highlight's
    transmission too. White threads use the bound up; dark ones stay far below it. In thin layers
    (Tρ below 1.74) the highlight is scaled down, so that all albedos grow with the colour; see
    `strongest_highlight`.

    Args:
        colour: [n, 3] or [3], linear RGB, 0 to 1.
        specular: [n] or a number, 0 to 1.
        translucency: [n] or a number, 0 to 1: share of the diffuse light that leaves on the far side.
        optical_depth: Tρ > 0.
        bound: of the layer; None is that of a yarn alone, `layer_albedo_bound`.
    """
    colour = np.atleast_2d(np.asarray(colour, dtype=np.float64))
    strength = np.asarray(specular, dtype=np.float64).reshape(-1, 1)
    share = np.asarray(translucency, dtype=np.float64).reshape(-1, 1)
    strength = strength * strongest_highlight(optical_depth)
    highlight = strength * (WHITE_SHARE + (1 - WHITE_SHARE) * colour)
    layer = bound or LayerBound(layer_albedo_bound(optical_depth))
    diffuse = colour * (1 - layer.taken(highlight, share * highlight))
    return Albedos((1 - share) * diffuse, share * diffuse, highlight, share * highlight)


def check_albedos(
    albedos: Albedos, family: str, optical_depth: float = 2.0, bound: LayerBound | None = None
) -> None:
    """Raises InputError unless the albedos are numbers from 0 to 1 within the energy bound.

    The message names `family`, the field, its thread and value, and the bound.

    Args:
        bound: see `albedos_from_colour`.
    """
    for name, values in albedos._asdict().items():
        good = (values >= 0) & (values <= 1)
        if not np.all(good):
            thread, channel = np.argwhere(~good)[0]
            raise InputError(
                f"{family}.{name} of thread {thread + 1} is {values[thread, channel]:.6g} in "
                f"{'RGB'[channel]}: an albedo lies between 0 and 1."
            )
    layer = bound or LayerBound(layer_albedo_bound(optical_depth))
    reflect, transmit = albedos.specular_reflect, albedos.specular_transmit
    diffuse = albedos.diffuse_reflect + albedos.diffuse_transmit
    total = diffuse + layer.taken(reflect, transmit)
    place = np.unravel_index(np.argmax(total), total.shape)
    if total[place] > 1 + ALBEDO_TOLERANCE:
        thread, channel = place
        larger, smaller = max(reflect[place], transmit[place]), min(reflect[place], transmit[place])
        names, numbers = "", ""
        if layer.smaller > 0:
            names = f" + {layer.smaller:.3f} × the smaller"
            numbers = f" + {layer.smaller:.3f} × {smaller:.6g}"
        raise InputError(
            f"{family}: diffuse_reflect + diffuse_transmit + {layer.larger:.3f} × the larger of "
            f"specular_reflect and specular_transmit{names} of thread {thread + 1} is {diffuse[place]:.6g} + "
            f"{layer.larger:.3f} × {larger:.6g}{numbers} = {total[place]:.6g} in {'RGB'[channel]}, and more "
            "than 1 would create light."
        )
