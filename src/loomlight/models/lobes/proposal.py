"""Directions from the lobes: a mixture over groups of their own lobes, and its exact density.

A group is drawn by its weight times what its family sends on; then one of three lobes of it: the fibre layer
about its mean fibre direction, as wide as the group's spread makes it; the diffuse term about its mean
normal; the same to the other side. A small share goes by the cosine, so that no direction that the cloth
answers to is left out. Sheen has a lobe of its own. Holes are passed by delta.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr

from loomlight.core.arrays import Float, Mask, Vec2, Vec3
from loomlight.core.backend import array_types, channel_mean, maximum, minimum
from loomlight.models.lobes.density import GroupLobe
from loomlight.models.lobes.prefiltered import PrefilteredLobes, SeenWord, TableLookup
from loomlight.models.separable import FamilyAlbedos
from loomlight.scattering.appearance import Sheen
from loomlight.scattering.diffuse import diffuse_pdf, sample_diffuse
from loomlight.scattering.fibre import pdf_specular, sample_specular
from loomlight.scattering.sheen import sample_sheen, sheen_pdf, sheen_transmittance

# Mean shares of the light that a fibre layer of albedo 1 sends back and lets through by scattering.
_LAYER_REFLECTS, _LAYER_TRANSMITS = 0.45, 0.25
# Kept for what lobes miss; black cloth draws by it alone.
_COSINE_SHARE = 0.05
_LEAST_ENERGY = 1e-6
# A box of half-width √3 s beside a lobe of width α.
SPREAD_WIDTH = 1.7


@dataclass
class Energies:
    """What one family sends on by each lobe."""

    specular: Float
    reflect: Float
    transmit: Float

    @property
    def total(self) -> Float:
        """Of all three."""
        return self.specular + self.reflect + self.transmit


@dataclass
class Mixture:
    """Probabilities of lobes that depend on neither the light nor the groups.

    Attributes:
        null: of passing straight through.
        sheen: of the sheen's lobe, of what does not pass.
        transmit: of the other side, of what is drawn by the cosine.
        warp, weft: energies of the families.
        blend: w of the diffuse lobes.
    """

    null: Float
    sheen: Float
    transmit: Float
    warp: Energies
    weft: Energies
    blend: float

    def family(self, is_warp: Mask) -> Energies:
        """Energies of the warp where `is_warp`, else of the weft."""
        return Energies(
            *(
                dr.select(is_warp, getattr(self.warp, name), getattr(self.weft, name))
                for name in ("specular", "reflect", "transmit")
            )
        )


def mixture_of(albedos: FamilyAlbedos, null: Float, view: Vec3, sheen: Sheen, blend: float) -> Mixture:
    """The mixture of a footprint and a view.

    Args:
        null: share of light that passes straight through, by which passing is drawn.
        view: unit vector [3] in the frame of the face seen.
        blend: w, the share of the yarn normal in the diffuse term.
    """
    types = array_types(view.x)

    def energies(family: Any) -> Energies:
        specular = _LAYER_REFLECTS * channel_mean(family.specular_reflect)
        specular += _LAYER_TRANSMITS * channel_mean(family.specular_transmit)
        return Energies(specular, channel_mean(family.diffuse_reflect), channel_mean(family.diffuse_transmit))

    warp, weft = energies(albedos.warp), energies(albedos.weft)
    from_sheen = types.Float(0)
    if sheen.strength > 0:
        reflected = 1 - sheen_transmittance(view, sheen.strength, sheen.roughness)
        from_sheen = reflected * dr.rcp(reflected + 0.5 * (warp.total + weft.total) + _LEAST_ENERGY)
    transmit = dr.select(warp.transmit + weft.transmit > 0, types.Float(0.5), 0)
    return Mixture(null, from_sheen, transmit, warp, weft, blend)


def energy_of(words: list[SeenWord], mixture: Mixture) -> Float:
    """Sum over the groups of words of weight times the energy of their family."""
    total: Float = 0
    for word in words:
        total = total + sum(word.weights) * mixture.family(word.is_warp).total
    return total


def words_density(words: list[SeenWord], mixture: Mixture, light: Vec3, view: Vec3) -> list[Float]:
    """What each word's groups add to the density, not divided by the energy of all: 1/sr."""
    found = []
    for word in words:
        energies = mixture.family(word.is_warp)
        total: Float = 0
        for weight, lobe in zip(word.weights, word.lobes, strict=True):
            tangent, roughness, normal = _frame(_GroupFrame.of(lobe))
            part = energies.specular * pdf_specular(light, view, tangent, roughness)
            part += energies.reflect * diffuse_pdf(light, normal, mixture.blend)
            part += energies.transmit * diffuse_pdf(-light, normal, mixture.blend)
            total = total + weight * part
        found.append(total)
    return found


def density(mixture: Mixture, groups: Float, energy: Float, light: Vec3, view: Vec3, sheen: Sheen) -> Float:
    """Density of the whole mixture without delta, 1/sr.

    Args:
        groups: sum of `words_density`.
        energy: sum of `energy_of`.
        light, view: unit vectors [3] in the frame of the face seen.
    """
    side = dr.select(light.z > 0, 1 - mixture.transmit, mixture.transmit)
    by_cosine = side * dr.abs(light.z) * dr.inv_pi
    found = dr.lerp(groups * dr.rcp(maximum(energy, _LEAST_ENERGY)), by_cosine, _cosine_share(energy))
    if sheen.strength > 0:
        found = dr.lerp(found, sheen_pdf(light, view, sheen.roughness), mixture.sheen)
    return (1 - mixture.null) * found


def draw(
    lobes: PrefilteredLobes, at: TableLookup, mixture: Mixture, sheen: Sheen, choice: Float, u: Vec2
) -> tuple[Vec3, Mask]:
    """A light direction [3] in the frame of the face seen, and whether it passes straight through.

    Args:
        choice: uniform number in [0, 1) that chooses group and lobe.
        u: uniform numbers in [0, 1).
    """
    types = array_types(at.view.x)
    view = at.view
    is_null = types.Bool(choice < mixture.null)
    rest = (choice - mixture.null) * dr.rcp(maximum(1 - mixture.null, 1e-6))
    from_sheen = rest < mixture.sheen
    rest = (rest - mixture.sheen) * dr.rcp(maximum(1 - mixture.sheen, 1e-6))
    # As though lobes had energy: the cosine is all there is where they have none.
    by_cosine = rest < _COSINE_SHARE
    to_groups = (rest - _COSINE_SHARE) / (1 - _COSINE_SHARE)
    drawn = _draw_group(lobes, at, mixture, to_groups)
    has_energy = drawn.energy > _LEAST_ENERGY
    tangent, roughness, normal = _frame(drawn.frame)
    energies = mixture.family(drawn.is_warp)
    aim = drawn.rest * energies.total
    light = sample_specular(view, tangent, roughness, u)
    diffuse = sample_diffuse(normal, types.Float(mixture.blend), u)
    reflects = aim < energies.specular + energies.reflect
    light = dr.select(aim < energies.specular, light, dr.select(reflects, diffuse, -diffuse))
    cosine = sample_diffuse(types.Vector3(0, 0, 1), types.Float(0), u)
    # What chose the cosine is uniform again on its share, and chooses the side.
    side = dr.select(has_energy, rest * (1 / _COSINE_SHARE), rest)
    light = dr.select(by_cosine | ~has_energy, dr.select(side < mixture.transmit, -cosine, cosine), light)
    if sheen.strength > 0:
        light = dr.select(from_sheen, sample_sheen(view, sheen.roughness, u), light)
    return dr.select(is_null, -view, light), is_null


def _cosine_share(energy: Float) -> Float:
    """Share of directions that are drawn by the cosine: all where groups have no energy."""
    return dr.select(energy > _LEAST_ENERGY, array_types(energy).Float(_COSINE_SHARE), 1)


@dataclass
class _GroupFrame:
    """What is kept of a group while groups are drawn from: moments that frame its lobes.

    Attributes:
        tangent, normal: means over the group [3].
        variance: of the fibre direction, along all axes together.
        roughness: α of its family.
    """

    tangent: Vec3
    normal: Vec3
    variance: Float
    roughness: Float

    @classmethod
    def of(cls, lobe: GroupLobe) -> _GroupFrame:
        return cls(lobe.tangent, lobe.normal, lobe.xx + lobe.yy + lobe.zz, lobe.roughness)


@dataclass
class _DrawnGroup:
    """A group that was drawn.

    Attributes:
        energy: of all groups.
        rest: uniform number in [0, 1) that is left of the choice.
    """

    frame: _GroupFrame
    is_warp: Mask
    energy: Float
    rest: Float


def _draw_group(lobes: PrefilteredLobes, at: TableLookup, mixture: Mixture, choice: Float) -> _DrawnGroup:
    """Draws a group by its energy in one pass over all: weighted reservoir sampling with one number.

    A group replaces the one kept with the probability of its energy among all so far; either outcome maps
    the number that decided back to [0, 1) (Chao 1982).
    """
    types = array_types(at.view.x)

    def visit(pair: Any, rest: Float, energy: Float, *kept: Any) -> tuple[Any, ...]:
        is_warp, *frame = kept
        for word in lobes.seen(at, pair):
            of_family = mixture.family(word.is_warp).total
            for weight, lobe in zip(word.weights, word.lobes, strict=True):
                own = weight * of_family
                energy = energy + own
                aim = rest * energy
                takes = aim < own
                # Where a group has all the energy so far, or none, nothing is left to divide by.
                quotient = dr.select(takes, aim, aim - own) * dr.rcp(
                    maximum(dr.select(takes, own, energy - own), 1e-30)
                )
                rest = dr.select(own > 0, minimum(quotient, dr.one_minus_epsilon(types.Float)), rest)
                is_warp = dr.select(takes, word.is_warp, is_warp)
                candidate = _GroupFrame.of(lobe)
                frame = [
                    dr.select(takes, mine, theirs)
                    for mine, theirs in zip(
                        (candidate.tangent, candidate.normal, candidate.variance, candidate.roughness),
                        frame,
                        strict=True,
                    )
                ]
        return pair + 1, rest, energy, is_warp, *frame

    width = dr.width(choice, at.view, at.coverage.nodes)
    start = (
        dr.zeros(types.UInt32, width),
        types.Float(choice),
        dr.zeros(types.Float, width),
        dr.full(types.Bool, False, width),
        types.Vector3(0, 1, 0),
        types.Vector3(0, 0, 1),
        dr.full(types.Float, 0, width),
        dr.full(types.Float, 1, width),
    )
    _, rest, energy, is_warp, *frame = dr.while_loop(
        start, lambda pair, *kept: pair < lobes.pairs, visit, label="lobes: draw a group"
    )
    return _DrawnGroup(_GroupFrame(*frame), is_warp, energy, rest)


def _frame(group: _GroupFrame) -> tuple[Vec3, Float, Vec3]:
    """Unit fibre direction, roughness of the group as a whole, and unit normal."""
    width = dr.sqrt(maximum(0.5 * group.variance, 0))
    roughness = minimum(dr.fma(SPREAD_WIDTH, width, group.roughness), 1)
    return dr.normalize(group.tangent), roughness, dr.normalize(group.normal)
