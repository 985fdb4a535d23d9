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

from loomlight.core.backend import array_types, channel_mean, maximum, minimum
from loomlight.models.interface import FamilyAlbedos
from loomlight.models.lobes.density import GroupLobe
from loomlight.models.lobes.estimate import Estimator, Place
from loomlight.scattering.appearance import Sheen
from loomlight.scattering.diffuse import diffuse_pdf, sample_diffuse
from loomlight.scattering.fibre import pdf_specular, sample_specular
from loomlight.scattering.sheen import sample_sheen, sheen_pdf, sheen_transmittance

# Mean shares of the light that a fibre layer of albedo 1 sends back and lets through by scattering.
_LAYER_REFLECTS, _LAYER_TRANSMITS = 0.45, 0.25
# Kept for what lobes miss; black cloth draws by it alone.
_COSINE_SHARE = 0.05
_LEAST_ENERGY = 1e-6
# Of all groups together; a view that sees none sees holes alone.
SMALLEST_WEIGHT = 1e-12
# A box of half-width √3 s beside a lobe of width α.
SPREAD_WIDTH = 1.7


@dataclass
class Energies:
    """What one family sends on by each lobe, Float each."""

    specular: Any
    reflect: Any
    transmit: Any

    @property
    def total(self) -> Any:
        """Of all three."""
        return self.specular + self.reflect + self.transmit


@dataclass
class Shares:
    """Probabilities that no light direction changes: Float each.

    Attributes:
        through: of passing straight through.
        sheen: of the sheen's lobe, of what does not pass.
        cosine: of the cosine, of what is left.
        transmit: of the other side, by the cosine.
        warp, weft: energies of the families.
        total: sum over groups of weight times energy.
    """

    through: Any
    sheen: Any
    cosine: Any
    transmit: Any
    warp: Energies
    weft: Energies
    total: Any


def energies_of(albedos: FamilyAlbedos) -> tuple[Energies, Energies]:
    """Energies of (warp, weft)."""

    def of(family: Any) -> Energies:
        specular = _LAYER_REFLECTS * channel_mean(family.specular_reflect)
        specular += _LAYER_TRANSMITS * channel_mean(family.specular_transmit)
        return Energies(specular, channel_mean(family.diffuse_reflect), channel_mean(family.diffuse_transmit))

    return of(albedos.warp), of(albedos.weft)


def energy_of(estimator: Estimator, place: Place, families: tuple[Energies, Energies]) -> Any:
    """Sum over groups of weight times the energy of their family: Float."""
    types = array_types(place.view.x)
    warp, weft = (family.total for family in families)

    def add(pair: Any, energy: Any) -> tuple[Any, Any]:
        for seen in estimator.seen(place, pair):
            own = dr.select(seen.is_warp, types.Float(warp), weft)
            energy = dr.fma(sum(seen.weights), own, energy)
        return pair + 1, energy

    width = dr.width(place.view, place.coverage.nodes, types.Float(warp), types.Float(weft))
    start = dr.zeros(types.UInt32, width), dr.zeros(types.Float, width)
    return dr.while_loop(start, lambda pair, energy: pair < estimator.pairs, add, label="lobes: energy")[1]


def shares_of(place: Place, albedos: FamilyAlbedos, total: Any, through: Any, sheen: Sheen) -> Shares:
    """Shares of a footprint and a view.

    Args:
        total: sum over groups of weight times energy.
        through: share of light that passes straight through, by which passing is drawn.
    """
    types = array_types(place.view.x)
    warp, weft = energies_of(albedos)
    from_sheen = types.Float(0)
    if sheen.strength > 0:
        reflected = 1 - sheen_transmittance(place.view, sheen.strength, sheen.roughness)
        from_sheen = reflected * dr.rcp(reflected + 0.5 * (warp.total + weft.total) + _LEAST_ENERGY)
    cosine = dr.select(total > _LEAST_ENERGY, types.Float(_COSINE_SHARE), 1)
    transmit = dr.select(warp.transmit + weft.transmit > 0, types.Float(0.5), 0)
    return Shares(through, from_sheen, cosine, transmit, warp, weft, maximum(total, _LEAST_ENERGY))


def energies_where(is_warp: Any, shares: Shares) -> Energies:
    """Energies of the warp where `is_warp`, else of the weft."""
    return Energies(
        *(
            dr.select(is_warp, getattr(shares.warp, name), getattr(shares.weft, name))
            for name in ("specular", "reflect", "transmit")
        )
    )


def group_density(weight: Any, lobe: GroupLobe, energies: Energies, light: Any, view: Any, blend: Any) -> Any:
    """What one group adds to the density, not divided by the total: Float, 1/sr."""
    tangent, roughness, normal = _frame(lobe)
    found = energies.specular * pdf_specular(light, view, tangent, roughness)
    found += energies.reflect * diffuse_pdf(light, normal, blend)
    found += energies.transmit * diffuse_pdf(-light, normal, blend)
    return weight * found


def density(shares: Shares, of_groups: Any, light: Any, view: Any, sheen: Sheen) -> Any:
    """Density of the whole mixture without delta: Float, 1/sr.

    Args:
        of_groups: sum of `group_density`.
    """
    side = dr.select(light.z > 0, 1 - shares.transmit, shares.transmit)
    found = dr.lerp(of_groups * dr.rcp(shares.total), side * dr.abs(light.z) * dr.inv_pi, shares.cosine)
    if sheen.strength > 0:
        found = dr.lerp(found, sheen_pdf(light, view, sheen.roughness), shares.sheen)
    return (1 - shares.through) * found


def draw(
    estimator: Estimator, place: Place, shares: Shares, sheen: Sheen, blend: Any, choice: Any, u: Any
) -> tuple[Any, Any]:
    """A light direction [3] in the frame of the face seen, and whether it passes straight through.

    Args:
        choice: uniform number in [0, 1) that chooses group and lobe.
        u: Vector2 of uniform numbers in [0, 1).
    """
    types = array_types(place.view.x)
    view = place.view
    passes = types.Bool(choice < shares.through)
    rest = (choice - shares.through) * dr.rcp(maximum(1 - shares.through, 1e-6))
    from_sheen = rest < shares.sheen
    rest = (rest - shares.sheen) * dr.rcp(maximum(1 - shares.sheen, 1e-6))
    by_cosine = rest < shares.cosine
    rest = (rest - shares.cosine) * dr.rcp(maximum(1 - shares.cosine, 1e-6))
    aim = rest * shares.total
    lobe, tangent, roughness, normal = _drawn_group(estimator, place, shares, aim)
    light = sample_specular(view, tangent, roughness, u)
    diffuse = sample_diffuse(normal, types.Float(blend), u)
    light = dr.select(lobe == _SPECULAR, light, dr.select(lobe == _REFLECT, diffuse, -diffuse))
    cosine = sample_diffuse(types.Vector3(0, 0, 1), types.Float(0), u)
    # What chose the cosine is uniform again on its share, and chooses the side.
    far = (rest + shares.cosine * dr.rcp(maximum(1 - shares.cosine, 1e-6))) * (
        maximum(1 - shares.cosine, 1e-6) * dr.rcp(shares.cosine)
    ) < shares.transmit
    light = dr.select(by_cosine, dr.select(far, -cosine, cosine), light)
    if sheen.strength > 0:
        light = dr.select(from_sheen, sample_sheen(view, sheen.roughness, u), light)
    return dr.select(passes, -view, light), passes


_SPECULAR, _REFLECT, _TRANSMIT = 0, 1, 2


def _drawn_group(estimator: Estimator, place: Place, shares: Shares, aim: Any) -> tuple[Any, Any, Any, Any]:
    """Lobe, mean fibre direction, roughness and mean normal of the group where the running sum is `aim`."""
    types = array_types(place.view.x)

    def search(pair: Any, left: Any, lobe: Any, tangent: Any, roughness: Any, normal: Any) -> tuple[Any, ...]:
        groups = [
            (weight, found, energies_where(seen.is_warp, shares))
            for seen in estimator.seen(place, pair)
            for weight, found in zip(seen.weights, seen.lobes, strict=True)
        ]
        for weight, found, energies in groups:
            own_tangent, own_roughness, own_normal = _frame(found)
            here = (left >= 0) & (weight > 0)
            tangent = dr.select(here, own_tangent, tangent)
            roughness = dr.select(here, own_roughness, roughness)
            normal = dr.select(here, own_normal, normal)
            inside = left
            third = dr.select(inside < weight * (energies.specular + energies.reflect), _REFLECT, _TRANSMIT)
            lobe = dr.select(
                here, dr.select(inside < weight * energies.specular, types.UInt32(_SPECULAR), third), lobe
            )
            left = dr.select(left >= 0, left - weight * energies.total, left)
        return pair + 1, left, lobe, tangent, roughness, normal

    width = dr.width(aim, place.view, place.coverage.nodes)
    start = (
        dr.zeros(types.UInt32, width),
        types.Float(aim),
        dr.full(types.UInt32, _REFLECT, width),
        types.Vector3(0, 1, 0),
        dr.full(types.Float, 1, width),
        types.Vector3(0, 0, 1),
    )
    found = dr.while_loop(
        start,
        lambda pair, left, *rest: (pair < estimator.pairs) & (left >= 0),
        search,
        label="lobes: draw a group",
    )
    return found[2], found[3], found[4], found[5]


def _frame(lobe: GroupLobe) -> tuple[Any, Any, Any]:
    """Unit fibre direction, roughness of the group as a whole, and unit normal."""
    variance = 0.5 * (lobe.xx + lobe.yy + lobe.zz)
    width = dr.sqrt(maximum(variance, 0))
    roughness = minimum(dr.fma(SPREAD_WIDTH, width, lobe.roughness), 1)
    return dr.normalize(lobe.tangent), roughness, dr.normalize(lobe.normal)
