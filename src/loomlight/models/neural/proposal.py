"""Sampling of directions: a mixture of five lobes, and its exact density.

The network's highlights lie about its lobe basis, so each family has a fibre lobe (Heitz et al. 2015): the
fibres on a yarn's crown, with a roughness that covers the spread of the basis. A fibre in free space scatters
to both sides alike; cloth does not, so that directions of this lobe are mirrored to a side that is drawn in
proportion to the albedos of both. The cone of a fibre along the surface is its own mirror image. The rest is
drawn by the cosine on either side, in proportion to albedos. The network does not know that f·cos is 0 at the
horizon, where the density of the cosine is: a uniform lobe on either side bounds value over density there.
The normal of the reflected cosine turns towards the view, as what is seen of yarns does.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from importlib.resources import files

import drjit as dr
import numpy as np
from safetensors import SafetensorError
from safetensors.numpy import load

from loomlight.core.arrays import Float, FloatType, Mask, Vec2, Vec3
from loomlight.core.backend import array_types, channel_mean, clip, maximum
from loomlight.core.errors import InputError
from loomlight.models.networks import Layers, LearnedProposal, ReluNetwork
from loomlight.models.neural.codings import Fibre
from loomlight.models.neural.weights import Weights
from loomlight.models.separable import FamilyAlbedos
from loomlight.scattering.appearance import Sheen
from loomlight.scattering.directions import cosine_about, uniform_on_sphere
from loomlight.scattering.fibre import pdf_specular, sample_specular
from loomlight.scattering.lobe_mixture import TwoSidedLobes
from loomlight.scattering.sheen import sheen_transmittance

# Probability of the uniform lobe, given neither null transmission nor a fibre lobe: weights are bounded by
# 2π/0.1 times the value on the side that is drawn.
UNIFORM_PROBABILITY = 0.1
# Largest probability of the fibre lobes: half of the directions are drawn by lobes that cover all.
MAX_FIBRE_PROBABILITY = 0.5
# Slope of the diffuse lobe's normal over the sine of the view's angle.
DIFFUSE_TILT = 0.2
# Smallest probability of a side, given a fibre lobe.
MIN_SIDE_PROBABILITY = 0.02
# Not 0/0: black cloth reflects nothing, but a direction has to be drawn.
MIN_WEIGHT = 1e-6


@dataclass
class Proposal:
    """The mixture of a footprint and a view, in the frame of the face that is seen.

    Attributes:
        null: probability of null transmission.
        warp, weft: probabilities of the families' fibre lobes, given no null transmission.
        fibres_reflect: probability of the side of the view, given a family's fibre lobe.
        reflect: probability of the side of the view, given one of the other lobes.
        view: unit vector [3], z > 0.
        tangents: unit fibre directions [3] of both families.
        roughness: α of their lobes.
    """

    null: Float
    warp: Float
    weft: Float
    fibres_reflect: tuple[Float, Float]
    reflect: Float
    view: Vec3
    tangents: tuple[Vec3, Vec3]
    roughness: tuple[Float, Float]

    def density(self, light: Vec3) -> Float:
        """Density of `draw` per solid angle, without delta, 1/sr.

        Args:
            light: unit vector [3] in the frame of the face that is seen.
        """
        mirrored = array_types(self.view.x).Vector3(light.x, light.y, -light.z)
        fibres = [
            probability
            * dr.select(light.z > 0, to_view, 1 - to_view)
            * sum(pdf_specular(either, self.view, tangent, roughness) for either in (light, mirrored))
            for probability, to_view, tangent, roughness in zip(
                (self.warp, self.weft), self.fibres_reflect, self.tangents, self.roughness, strict=True
            )
        ]
        side = dr.select(light.z > 0, self.reflect, 1 - self.reflect)
        normal = self._diffuse_normal
        cosine = maximum(dr.dot(light, normal), 0) + maximum(dr.dot(mirrored, normal), 0)
        cosine = dr.select(light.z > 0, cosine, -light.z)
        over_side = dr.lerp(cosine * dr.inv_pi, 0.5 * dr.inv_pi, UNIFORM_PROBABILITY)
        return (1 - self.null) * (sum(fibres) + (1 - self.warp - self.weft) * side * over_side)

    def draw(self, choice: Float, u: Vec2) -> tuple[Vec3, Mask]:
        """A light direction [3] in the frame of the face that is seen, and whether it is null transmission.

        Args:
            choice: uniform number in [0, 1) that chooses the lobe.
            u: uniform numbers in [0, 1).
        """
        types = array_types(self.view.x)
        is_null = types.Bool(choice < self.null)
        rest = (choice - self.null) * dr.rcp(maximum(1 - self.null, MIN_WEIGHT))
        is_warp, fibres = rest < self.warp, self.warp + self.weft
        # Given the family, the number is uniform again, and chooses the side.
        share_of_family = dr.select(
            is_warp,
            rest * dr.rcp(maximum(self.warp, MIN_WEIGHT)),
            (rest - self.warp) * dr.rcp(maximum(self.weft, MIN_WEIGHT)),
        )
        warp, weft = (
            sample_specular(self.view, tangent, roughness, u)
            for tangent, roughness in zip(self.tangents, self.roughness, strict=True)
        )
        by_fibres = dr.select(is_warp, warp, weft)
        height = dr.abs(by_fibres.z)
        to_view = share_of_family < dr.select(is_warp, *self.fibres_reflect)
        by_fibres = types.Vector3(by_fibres.x, by_fibres.y, dr.select(to_view, height, -height))
        over = (rest - fibres) * dr.rcp(maximum(1 - fibres, MIN_WEIGHT))
        reflects = over < self.reflect
        # Given the side, the number is uniform again.
        share = dr.select(
            reflects,
            over * dr.rcp(maximum(self.reflect, MIN_WEIGHT)),
            (over - self.reflect) * dr.rcp(maximum(1 - self.reflect, MIN_WEIGHT)),
        )
        up = types.Vector3(0, 0, 1)
        cosine, uniform = cosine_about(dr.select(reflects, self._diffuse_normal, up), u), uniform_on_sphere(u)
        light = dr.select(share < UNIFORM_PROBABILITY, uniform, cosine)
        light.z = dr.abs(light.z)
        light = dr.select(reflects, light, types.Vector3(light.x, light.y, -light.z))
        light = dr.select(rest < fibres, by_fibres, light)
        return dr.select(is_null, -self.view, light), is_null

    @property
    def _diffuse_normal(self) -> Vec3:
        """The mean normal of what is seen of yarns, which turns towards the view."""
        types = array_types(self.view.x)
        return dr.normalize(types.Vector3(DIFFUSE_TILT * self.view.x, DIFFUSE_TILT * self.view.y, 1))


def proposal_of(
    albedos: FamilyAlbedos,
    null: Float,
    sheen: float,
    layer_albedo: float,
    view: Vec3,
    fibres: tuple[Fibre, Fibre],
    roughness: tuple[Float, Float],
) -> Proposal:
    """The mixture of a footprint and a view.

    Args:
        albedos: means over the footprint.
        null: null transmission, 0 to 1, which is also the probability of drawing it.
        sheen: its strength, 0 to 1.
        layer_albedo: largest share of the light that a fibre layer of albedo 1 returns.
        view: unit vector [3] in the frame of the face that is seen.
        fibres: on the crowns of both families, in that frame.
        roughness: α of the families' fibre lobes.
    """
    types = array_types(view.x)

    def sums(term: str) -> Float:
        return channel_mean(getattr(albedos.warp, term)) + channel_mean(getattr(albedos.weft, term))

    reflects = [channel_mean(family.specular_reflect) for family in (albedos.warp, albedos.weft)]
    both = [
        one + channel_mean(family.specular_transmit)
        for one, family in zip(reflects, (albedos.warp, albedos.weft), strict=True)
    ]
    warp, weft = (layer_albedo * sum_of_sides for sum_of_sides in both)
    first, second = (
        # Neither side is left out: the network may say something of it.
        clip(one * dr.rcp(sum_of_sides + MIN_WEIGHT), MIN_SIDE_PROBABILITY, 1 - MIN_SIDE_PROBABILITY)
        for one, sum_of_sides in zip(reflects, both, strict=True)
    )
    up = sums("diffuse_reflect") + layer_albedo * sums("specular_reflect") + sheen
    down = sums("diffuse_transmit") + layer_albedo * sums("specular_transmit")
    scale = MAX_FIBRE_PROBABILITY * dr.rcp(up + down + MIN_WEIGHT)
    return Proposal(
        null,
        warp * scale,
        weft * scale,
        (first, second),
        (up + MIN_WEIGHT) * dr.rcp(up + down + MIN_WEIGHT),
        view,
        tuple(types.Vector3(fibre.x, fibre.y, 0) for fibre in fibres),
        roughness,
    )


# -------------------------------------------------------------------------------------------- sampler network
# The sampler network of all fabrics: what it sees of a footprint and a view, and its weights.
#
# It sees what a view fixes: the decoder's first angular layer without the light's part, the view, the
# fibres of both families and the albedos' shares; `models/networks.py` says what it describes.


# Beside the decoder's activations: view, fibres of two families (x, y, α), shares of eight albedos.
FURTHER_INPUTS = 3 + 6 + 8
# Largest probability of the sheen's lobe: weights of what is below stay bounded.
_MAX_SHEEN = 0.8
# Order of the terms of an albedo, of warp and then of weft.
_TERMS = ("diffuse_reflect", "diffuse_transmit", "specular_reflect", "specular_transmit")
_FILE = "neural_sampler.safetensors"
_TINY = 1e-6


def neural_proposal(
    network: ReluNetwork,
    angular: Sequence[Float],
    albedos: FamilyAlbedos,
    null: Float,
    sheen: Sheen,
    view: Vec3,
    fibres: tuple[Fibre, Fibre],
) -> LearnedProposal:
    """The proposal of a footprint and a view.

    Args:
        angular: the decoder's first angular layer without the light's part.
        albedos: means over the footprint.
        null: null transmission, 0 to 1, which is also the probability of drawing it.
        sheen: of the fabric; strength 0 is none.
        view: unit vector [3] in the frame of the face that is seen.
        fibres: on the crowns of both families, in that frame.
    """
    terms = [
        channel_mean(getattr(family, term)) for family in (albedos.warp, albedos.weft) for term in _TERMS
    ]
    further = further_inputs([*view], [(fibre.x, fibre.y, fibre.roughness) for fibre in fibres], terms)
    lobes = TwoSidedLobes.of(network([*angular, *further]))
    if sheen.strength <= 0:
        return LearnedProposal(null, lobes, view)
    reflected = 1 - sheen_transmittance(view, sheen.strength, sheen.roughness)
    # A place shows one family, so its albedos are half of the sum.
    share = reflected * dr.rcp(reflected + 0.5 * sum(terms) + _TINY)
    return LearnedProposal(null, lobes, view, (_MAX_SHEEN * share, sheen.roughness))


def further_inputs(
    view: Sequence[Float], fibres: Sequence[tuple[Float, Float, Float]], albedos: Sequence[Float]
) -> list[Float]:
    """The inputs after the decoder's activations: `FURTHER_INPUTS` numbers.

    Args:
        fibres: direction (x, y) and α of both families.
        albedos: means over colours, in the order of `FamilyAlbedos`' terms, of warp and then of weft.
    """
    inverse = 1 / (sum(albedos) + _TINY)
    return [*view, *(number for fibre in fibres for number in fibre), *(term * inverse for term in albedos)]


@cache
def sampler_layers(weights: Weights) -> Layers | None:
    """The sampler of the package; None for a decoder that it was not trained for.

    Raises:
        InputError: its file is damaged.
    """
    content = files("loomlight.models.neural").joinpath("weights", _FILE).read_bytes()
    try:
        tensors = load(content)
    except SafetensorError as error:
        raise InputError(f"{_FILE} is damaged ({error}): install the package again.") from error
    if bytes(tensors["network"]).hex() != weights.sha256:
        return None
    return [
        (tensors[f"{number}.weight"].astype(np.float32), tensors[f"{number}.bias"].astype(np.float32))
        for number in range((len(tensors) - 1) // 2)
    ]


@cache
def sampler_of(weights: Weights, float_type: FloatType) -> ReluNetwork | None:
    """`sampler_layers` on one backend; all fabrics share it."""
    layers = sampler_layers(weights)
    return None if layers is None else ReluNetwork(layers, float_type)
