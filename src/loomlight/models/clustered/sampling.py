"""Importance sampling by lobes (zhu2024 5.1): clusters' fibre lobes, diffuse lobes, sheen, and straight on.

Densities come from the tables alone, never from the residual's random points, so they are those of the
sampled directions exactly. A cluster's lobe has its mean fibre direction, and a roughness that its spread
of fibre directions widens. Diffuse lobes are cosines about the macro normal.
"""

from __future__ import annotations

from dataclasses import dataclass

import drjit as dr

from loomlight.core.arrays import Array, Float, Mask, Vec2, Vec3
from loomlight.core.backend import array_types, channel_mean, maximum, minimum
from loomlight.models.clustered.base import DeviceTables, ViewedBase
from loomlight.models.separable import FamilyAlbedos
from loomlight.scattering.appearance import Sheen
from loomlight.scattering.directions import cosine_about
from loomlight.scattering.fibre import layer_albedo_estimate, pdf_specular, sample_specular
from loomlight.scattering.sheen import sample_sheen, sheen_pdf, sheen_transmittance

# Weight of diffuse reflection beside the albedos, so that black cloth has a lobe as well.
_MIN = 1e-3
# What passes straight on is drawn at most so often: a hole may be estimated to be 1 where light is scattered.
_MAX_NULL = 0.95


@dataclass
class LobeProbabilities:
    """Probabilities of lobes; all add up to 1.

    Attributes:
        clusters: of each cluster's fibre lobe.
        reflect, transmit: of the diffuse lobes.
        sheen: of the sheen.
        null: of passing straight on.
    """

    clusters: list[Float]
    reflect: Float
    transmit: Float
    sheen: Float
    null: Float


class LobeSampler:
    """Draws directions for one view of footprints, in the frame of the face that is seen."""

    def __init__(
        self,
        tables: DeviceTables,
        base: ViewedBase,
        means: list[Array],
        albedos: FamilyAlbedos,
        sheen: Sheen,
        hole: Float,
    ) -> None:
        types = array_types(base.view.x)
        self._base, self._sheen = base, sheen
        self._lobes = [base.lobe(types.UInt32(cluster)) for cluster in range(tables.clusters)]
        families = (albedos.warp, albedos.weft)
        specular: list[Float] = []
        reflect, transmit = types.Float(_MIN), types.Float(0)
        for cluster, lobe in enumerate(self._lobes):
            family = families[0 if cluster < tables.clusters // 2 else 1]
            share = maximum(means[cluster // 4][cluster % 4], 0)
            turned, through = layer_albedo_estimate(
                base.view, lobe.normal, lobe.tangent, lobe.roughness, types.Float(tables.optical_depth)
            )
            specular.append(
                share
                * (
                    channel_mean(family.specular_reflect) * turned
                    + channel_mean(family.specular_transmit) * through
                )
            )
            reflect += share * channel_mean(family.diffuse_reflect)
            transmit += share * channel_mean(family.diffuse_transmit)
        scattered = reflect + transmit
        for part in specular:
            scattered += part
        from_sheen = types.Float(0)
        if sheen.strength > 0:
            transmittance = sheen_transmittance(base.view, sheen.strength, sheen.roughness)
            from_sheen = (1 - transmittance) * dr.rcp(maximum(transmittance, 1e-3)) * maximum(scattered, 0.1)
        null = minimum(hole, _MAX_NULL)
        scale = (1 - null) * dr.rcp(scattered + from_sheen)
        self.probabilities = LobeProbabilities(
            [part * scale for part in specular], reflect * scale, transmit * scale, from_sheen * scale, null
        )

    def pdf(self, light: Vec3) -> Float:
        """Density of `sample` but for passing straight on, 1/sr."""
        of = self.probabilities
        density = dr.inv_pi * dr.select(light.z > 0, of.reflect, of.transmit) * abs(light.z)
        for probability, lobe in zip(of.clusters, self._lobes, strict=True):
            density += probability * pdf_specular(light, self._base.view, lobe.tangent, lobe.wide)
        if self._sheen.strength > 0:
            density += of.sheen * sheen_pdf(light, self._base.view, self._sheen.roughness)
        return density

    def sample(self, choice: Float, u: Vec2) -> tuple[Vec3, Mask]:
        """A direction, and whether it goes straight on."""
        types = array_types(choice)
        of, view = self.probabilities, self._base.view
        bound = types.Float(of.null)
        is_null = choice < bound
        tangent, wide = types.Vector3(1, 0, 0), types.Float(1)
        is_specular = types.Bool(False)
        for probability, lobe in zip(of.clusters, self._lobes, strict=True):
            chosen = (choice >= bound) & (choice < bound + probability)
            bound = bound + probability
            tangent = dr.select(chosen, lobe.tangent, tangent)
            wide = dr.select(chosen, lobe.wide, wide)
            is_specular |= chosen
        light = cosine_about(types.Vector3(0, 0, 1), u)
        light = dr.select((choice >= bound) & (choice < bound + of.transmit), -light, light)
        light = dr.select(is_specular, sample_specular(view, tangent, wide, u), light)
        if self._sheen.strength > 0:
            from_sheen = (choice >= bound + of.transmit) & (choice < bound + of.transmit + of.sheen)
            light = dr.select(from_sheen, sample_sheen(view, self._sheen.roughness, u), light)
        return dr.select(is_null, -view, light), is_null
