"""Sampling of directions: a mixture over groups of three lobes each, and its exact density.

A group is drawn in proportion to its weight times the albedo of its family; then one of its lobes: the fibre
layer about the mean fibre direction, widened by the spread of the group; the diffuse lobe about the mean
normal; the same on the other side. With a small probability the direction is cosine-distributed instead, so
that no direction of non-zero value has density 0. Sheen has a lobe of its own. Holes are null transmission.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr

from loomlight.core.arrays import Array, Float, Mask, UInt, Vec2, Vec3
from loomlight.core.backend import array_types, channel_mean, maximum, minimum
from loomlight.models.lobes.prefiltered import PrefilteredLobes, SeenPack, TableLookup
from loomlight.models.separable import FamilyAlbedos
from loomlight.scattering.appearance import Sheen
from loomlight.scattering.diffuse import diffuse_pdf, sample_diffuse
from loomlight.scattering.fibre import pdf_specular, sample_specular
from loomlight.scattering.sheen import sample_sheen, sheen_pdf, sheen_transmittance

# Mean fractions of the light that a fibre layer of albedo 1 reflects, and transmits by scattering.
LAYER_REFLECTS, LAYER_TRANSMITS = 0.45, 0.25
# Probability of the cosine lobe, which covers all directions; black cloth has this lobe alone.
COSINE_PROBABILITY = 0.05
# Smallest sum of weights that is divided by: not 0/0 of black cloth.
MIN_WEIGHT = 1e-6
# Added to α for each unit of the group's standard deviation s: a uniform interval has half-width √3 s.
SPREAD_WIDTH = 1.7


@dataclass
class LobeWeights:
    """Mixture weights of the lobes of one family: mean albedos, not normalized."""

    specular: Float
    reflect: Float
    transmit: Float

    @property
    def total(self) -> Float:
        """Sum of the three."""
        return self.specular + self.reflect + self.transmit


@dataclass
class Mixture:
    """Probabilities of lobes that depend on neither the light nor the groups.

    Attributes:
        null: of null transmission.
        sheen: of the sheen's lobe, given no null transmission.
        transmit: of the other side, given the cosine lobe.
        warp, weft: mixture weights of the families' lobes.
        blend: w of the diffuse lobes.
    """

    null: Float
    sheen: Float
    transmit: Float
    warp: LobeWeights
    weft: LobeWeights
    blend: float

    def family(self, is_warp: Mask) -> LobeWeights:
        """Mixture weights of the warp where `is_warp`, else of the weft."""
        return LobeWeights(
            *(
                dr.select(is_warp, getattr(self.warp, name), getattr(self.weft, name))
                for name in ("specular", "reflect", "transmit")
            )
        )


def mixture_of(albedos: FamilyAlbedos, null: Float, view: Vec3, sheen: Sheen, blend: float) -> Mixture:
    """The mixture of a footprint and a view.

    Args:
        null: null transmission, 0 to 1, which is also the probability of drawing it.
        view: unit vector [3] in the frame of the face seen.
        blend: w, the weight of the yarn normal in the diffuse term.
    """
    types = array_types(view.x)

    def lobe_weights(family: Any) -> LobeWeights:
        specular = LAYER_REFLECTS * channel_mean(family.specular_reflect)
        specular += LAYER_TRANSMITS * channel_mean(family.specular_transmit)
        return LobeWeights(
            specular, channel_mean(family.diffuse_reflect), channel_mean(family.diffuse_transmit)
        )

    warp, weft = lobe_weights(albedos.warp), lobe_weights(albedos.weft)
    sheen_probability = types.Float(0)
    if sheen.strength > 0:
        reflected = 1 - sheen_transmittance(view, sheen.strength, sheen.roughness)
        sheen_probability = reflected * dr.rcp(reflected + 0.5 * (warp.total + weft.total) + MIN_WEIGHT)
    transmit = dr.select(warp.transmit + weft.transmit > 0, types.Float(0.5), 0)
    return Mixture(null, sheen_probability, transmit, warp, weft, blend)


def total_weight(packs: list[SeenPack], mixture: Mixture) -> Float:
    """Sum over the groups of packs of weight times the lobe weights of their family."""
    total: Float = 0
    for pack in packs:
        total = total + sum(pack.weights) * mixture.family(pack.is_warp).total
    return total


def packs_density(packs: list[SeenPack], mixture: Mixture, light: Vec3, view: Vec3) -> Float:
    """The packs' part of the density, 1/sr, not divided by the total weight of all groups."""
    total: Float = 0
    for pack in packs:
        lobe_weights = mixture.family(pack.is_warp)
        for weight, lobe in zip(pack.weights, pack.lobes, strict=True):
            tangent, roughness, normal = _frame(lobe.tangent, lobe.normal, lobe.roughness)
            part = lobe_weights.specular * pdf_specular(light, view, tangent, roughness)
            part += lobe_weights.reflect * diffuse_pdf(light, normal, mixture.blend)
            part += lobe_weights.transmit * diffuse_pdf(-light, normal, mixture.blend)
            total = total + weight * part
    return total


def density(
    mixture: Mixture, groups: Float, weight_sum: Float, light: Vec3, view: Vec3, sheen: Sheen
) -> Float:
    """Density of the whole mixture without delta, 1/sr.

    Args:
        groups: sum of `packs_density`.
        weight_sum: sum of `total_weight`.
        light, view: unit vectors [3] in the frame of the face seen.
    """
    side = dr.select(light.z > 0, 1 - mixture.transmit, mixture.transmit)
    by_cosine = side * dr.abs(light.z) * dr.inv_pi
    by_groups = groups * dr.rcp(maximum(weight_sum, MIN_WEIGHT))
    pdf = dr.lerp(by_groups, by_cosine, _cosine_probability(weight_sum))
    if sheen.strength > 0:
        pdf = dr.lerp(pdf, sheen_pdf(light, view, sheen.roughness), mixture.sheen)
    return (1 - mixture.null) * pdf


def draw(
    lobes: PrefilteredLobes, at: TableLookup, mixture: Mixture, sheen: Sheen, choice: Float, u: Vec2
) -> tuple[Vec3, Mask]:
    """A light direction [3] in the frame of the face seen, and whether it is null transmission.

    Args:
        choice: uniform number in [0, 1) that chooses group and lobe.
        u: uniform numbers in [0, 1).
    """
    types = array_types(at.view.x)
    view = at.view
    is_null = types.Bool(choice < mixture.null)
    rest = (choice - mixture.null) * dr.rcp(maximum(1 - mixture.null, 1e-6))
    is_sheen = rest < mixture.sheen
    rest = (rest - mixture.sheen) * dr.rcp(maximum(1 - mixture.sheen, 1e-6))
    # Where no group has weight, the cosine lobe is drawn in any case.
    by_cosine = rest < COSINE_PROBABILITY
    to_groups = (rest - COSINE_PROBABILITY) / (1 - COSINE_PROBABILITY)
    drawn = _draw_group(lobes, at, mixture, to_groups)
    has_groups = drawn.weight_sum > MIN_WEIGHT
    tangent, roughness, normal = _frame(drawn.tangent, drawn.normal, lobes.roughness(drawn.is_warp))
    lobe_weights = mixture.family(drawn.is_warp)
    aim = drawn.rest * lobe_weights.total
    light = sample_specular(view, tangent, roughness, u)
    diffuse = sample_diffuse(normal, types.Float(mixture.blend), u)
    reflects = aim < lobe_weights.specular + lobe_weights.reflect
    light = dr.select(aim < lobe_weights.specular, light, dr.select(reflects, diffuse, -diffuse))
    cosine = sample_diffuse(types.Vector3(0, 0, 1), types.Float(0), u)
    # Given the cosine lobe, `rest` is uniform below its probability: rescaled, it chooses the side.
    side = dr.select(has_groups, rest * (1 / COSINE_PROBABILITY), rest)
    light = dr.select(by_cosine | ~has_groups, dr.select(side < mixture.transmit, -cosine, cosine), light)
    if sheen.strength > 0:
        light = dr.select(is_sheen, sample_sheen(view, sheen.roughness, u), light)
    return dr.select(is_null, -view, light), is_null


def _cosine_probability(weight_sum: Float) -> Float:
    """Probability of the cosine lobe: 1 where groups have no weight."""
    return dr.select(weight_sum > MIN_WEIGHT, array_types(weight_sum).Float(COSINE_PROBABILITY), 1)


@dataclass
class _DrawnGroup:
    """A group that was drawn.

    Attributes:
        tangent, normal: means over the group [3].
        weight_sum: sum of the mixture weights of all groups.
        rest: uniform number in [0, 1), rescaled from the choice.
    """

    tangent: Vec3
    normal: Vec3
    is_warp: Mask
    weight_sum: Float
    rest: Float


def _draw_group(lobes: PrefilteredLobes, at: TableLookup, mixture: Mixture, choice: Float) -> _DrawnGroup:
    """Draws a group by its mixture weight in one pass: weighted reservoir sampling (Chao 1982).

    A group replaces the one in the reservoir with probability (its weight)/(sum of weights so far); either
    outcome rescales the random number to [0, 1) again.
    """
    types = array_types(at.view.x)

    def visit(pair: UInt, rest: Float, weight_sum: Float, *reservoir: Array) -> tuple[Array, ...]:
        is_warp, tangent, normal = reservoir
        for pack in lobes.seen_packs(at, pair):
            family_weight = mixture.family(pack.is_warp).total
            for weight, lobe in zip(pack.weights, pack.lobes, strict=True):
                own = weight * family_weight
                weight_sum = weight_sum + own
                aim = rest * weight_sum
                takes = aim < own
                # Bounded: a group may have all the weight so far, or none.
                quotient = dr.select(takes, aim, aim - own) * dr.rcp(
                    maximum(dr.select(takes, own, weight_sum - own), 1e-30)
                )
                rest = dr.select(own > 0, minimum(quotient, dr.one_minus_epsilon(types.Float)), rest)
                is_warp = dr.select(takes, pack.is_warp, is_warp)
                tangent = dr.select(takes, lobe.tangent, tangent)
                normal = dr.select(takes, lobe.normal, normal)
        return pair + 1, rest, weight_sum, is_warp, tangent, normal

    width = dr.width(choice, at.view, at.coverage.nodes)
    start = (
        dr.zeros(types.UInt32, width),
        types.Float(choice),
        dr.zeros(types.Float, width),
        dr.full(types.Bool, False, width),
        types.Vector3(0, 1, 0),
        types.Vector3(0, 0, 1),
    )
    _, rest, weight_sum, is_warp, tangent, normal = dr.while_loop(
        start, lambda pair, *reservoir: pair < lobes.pairs, visit, label="lobes: draw a group"
    )
    return _DrawnGroup(tangent, normal, is_warp, weight_sum, rest)


def _frame(tangent: Vec3, normal: Vec3, roughness: Float) -> tuple[Vec3, Float, Vec3]:
    """Unit fibre direction, roughness of a group as a whole, and unit normal."""
    # Fibre directions are of unit length: what their mean lacks of it is the trace of their covariance.
    width = dr.sqrt(maximum(0.5 * (1 - dr.squared_norm(tangent)), 0))
    roughness = minimum(dr.fma(SPREAD_WIDTH, width, roughness), 1)
    return dr.normalize(tangent), roughness, dr.normalize(normal)
