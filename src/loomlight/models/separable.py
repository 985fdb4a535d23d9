"""BSDFs that keep albedos apart: components free of albedos, mean albedos, and their sum (chen2024 eq. 8)."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import final

import drjit as dr

from loomlight.aggregate.footprint_albedos import FootprintAlbedos
from loomlight.core.arrays import Color3, Float, Mask, Vec3
from loomlight.core.backend import array_types, maximum, minimum
from loomlight.core.footprint import Footprint
from loomlight.models.between_yarns import BetweenYarns, Bounced
from loomlight.models.interface import FootprintBsdf
from loomlight.scattering.appearance import Appearance, Sheen
from loomlight.scattering.grazing import NO_RISE, Grazing
from loomlight.scattering.interreflection import Blocked
from loomlight.scattering.irregularity import IrregularYarns, Yarns
from loomlight.scattering.point import Albedos, Tint, towards_grazing
from loomlight.scattering.point import tinted as tinted_family
from loomlight.scattering.sheen import sheen_transmittance, sheen_with_transmittance


@dataclass
class Components:
    """Response of a footprint to light, free of albedos (chen2024 eq. 7): Float each, 1/sr but the last.

    Means over the view rays through the footprint, holes counted as 0, cosine and shadows included; of
    reflection or of transmission by the side of the light.

    Attributes:
        light_visibility: fraction of the view rays that meet yarn which the light reaches, 0 to 1; with the
            hole it scales the sheen.
    """

    diffuse_warp: Float
    diffuse_weft: Float
    specular_warp: Float
    specular_weft: Float
    light_visibility: Float

    @classmethod
    def of(cls, terms: Sequence[Float], light_visibility: Float) -> Components:
        """From the four components in their order."""
        diffuse_warp, diffuse_weft, specular_warp, specular_weft = terms
        return cls(diffuse_warp, diffuse_weft, specular_warp, specular_weft, light_visibility)


@dataclass
class Evaluation:
    """A footprint under one light: all that the search for its yarns finds.

    Attributes:
        components: for the light.
        hole: share of the view rays that pass straight through, 0 to 1.
        blocked: shares of the sky that yarn blocks at sampled points of warp and of weft; None without such
            points, or without light between yarns.
    """

    components: Components
    hole: Float
    blocked: tuple[Blocked, Blocked] | None = None


@dataclass
class FamilyAlbedos:
    """Mean albedos of the threads that a footprint shows, a family each, linear RGB."""

    warp: Albedos
    weft: Albedos


class SeparableBsdf(FootprintBsdf):
    """A BSDF of yarns of two families under a sheen.

    Attributes:
        sheen: of the fabric; strength 0 is none.
        grazing: how its highlights rise.
    """

    def __init__(self, view: Vec3, footprint: Footprint, sheen: Sheen, grazing: Grazing = NO_RISE) -> None:
        super().__init__(view, footprint)
        self.sheen, self.grazing = sheen, grazing

    @property
    @abstractmethod
    def albedos(self) -> FamilyAlbedos:
        """Mean albedos as the view shows them, tinted."""

    def albedos_for(self, light: Vec3) -> FamilyAlbedos:
        """`albedos` as a light shows them: another one may show other yarns."""
        del light
        return self.albedos

    @abstractmethod
    def evaluate(self, light: Vec3, active: Mask = True) -> Evaluation:
        """Components for a light and the hole; anything in lanes that are not active."""

    @final
    def components(self, light: Vec3, active: Mask = True) -> Components:
        """Components for a light; anything in lanes that are not active."""
        return self.evaluate(light, active).components

    @property
    def shown(self) -> tuple[Float, Float]:
        """How much of warp and of weft the view shows, both times one factor."""
        found = self.evaluate(self.view).components
        return found.diffuse_warp, found.diffuse_weft

    @property
    def between(self) -> BetweenYarns | None:
        """Light between yarns; None without."""
        return None

    def bounced(self, evaluation: Evaluation) -> Bounced | None:
        """Albedos of light between yarns, reflected and transmitted, over the footprint; None without.

        Args:
            evaluation: of the light; see `BetweenYarns.far`.
        """
        if self.between is None:
            return None
        components = evaluation.components
        return self.between.far(components.diffuse_warp, components.diffuse_weft, evaluation.hole)

    @property
    def null_transmission(self) -> Float:
        """Share of light that passes straight through: the hole, less what sheen takes."""
        return self.null_transmission_of(self.hole)

    @final
    def null_transmission_of(self, hole: Float) -> Float:
        """Share of light that passes straight through a hole, 0 to 1, and the sheen over it."""
        if self.sheen.strength <= 0:
            return hole
        view = self.to_seen_face(self.view)
        return hole * sheen_transmittance(view, self.sheen.strength, self.sheen.roughness)

    @property
    def diffuse_reflectance(self) -> Color3:
        """Mean diffuse albedo of both families over the footprint, holes counted as 0."""
        warp, weft = self.albedos.warp, self.albedos.weft
        return 0.5 * (warp.diffuse_reflect + weft.diffuse_reflect) * (1 - self.hole)

    def value(self, light: Vec3, active: Mask = True) -> Color3:
        """f·cos with albedos and sheen, 1/sr; anything in lanes that are not active."""
        return self.composed(self.evaluate(light, active), light)

    def value_and_null_transmission(self, light: Vec3, active: Mask = True) -> tuple[Color3, Float]:
        """Both, of one evaluation."""
        evaluation = self.evaluate(light, active)
        return self.composed(evaluation, light), self.null_transmission_of(evaluation.hole)

    @final
    def composed(self, evaluation: Evaluation, light: Vec3) -> Color3:
        """`value` of an evaluation that is at hand, 1/sr."""
        body = shade(evaluation.components, self.albedos_towards(light), light.z * self.view.z < 0)
        return self.under_sheen(body + self.bounced_value(evaluation, light), evaluation, light)

    @final
    def albedos_towards(self, light: Vec3) -> FamilyAlbedos:
        """`albedos` as they count for a light, whose highlights rise towards grazing."""
        albedos = self.albedos_for(light)
        return FamilyAlbedos(
            *(
                towards_grazing(family, self.grazing, light, self.view)
                for family in (albedos.warp, albedos.weft)
            )
        )

    @property
    def albedos_in_mirror(self) -> FamilyAlbedos:
        """`albedos` with the rise of the mirror's direction, by which samplers choose lobes."""
        if self.grazing.gain <= 0:
            return self.albedos
        rise = self.grazing.rise_towards(self.view)
        return FamilyAlbedos(
            *(
                replace(family, specular_reflect=family.specular_reflect + rise)
                for family in (self.albedos.warp, self.albedos.weft)
            )
        )

    @final
    def bounced_value(self, evaluation: Evaluation, light: Vec3) -> Color3:
        """f·cos of light between yarns, 1/sr: diffuse about the cloth's normal, and no shadow falls on it."""
        bounced = self.bounced(evaluation)
        if bounced is None:
            return array_types(light.x).Color3(0)
        reflected, transmitted = bounced
        cosine = abs(light.z) * dr.inv_pi
        if self.grazing.gain > 0:
            cosine *= self.grazing.kept(light, self.view)
        return dr.select(light.z * self.view.z < 0, transmitted, reflected) * cosine

    @final
    def under_sheen(self, body: Color3, evaluation: Evaluation, light: Vec3) -> Color3:
        """f·cos of cloth whose yarns scatter `body` (1/sr), with the sheen over it, 1/sr."""
        if self.sheen.strength <= 0:
            return body
        # A function of the macro normal alone, shadowed like everything else at a point (zhu2024 eq. 3–5):
        # over a footprint it is scaled by what light reaches. Fly-away fibres stand over holes too.
        lobe, transmittance = sheen_with_transmittance(
            self.to_seen_face(light), self.to_seen_face(self.view), self.sheen.strength, self.sheen.roughness
        )
        lit = evaluation.components.light_visibility + evaluation.hole
        return transmittance * body + lit * lobe


class FilteredBsdf(SeparableBsdf):
    """A BSDF of yarns whose albedos are means over the threads of footprints."""

    def __init__(
        self,
        means: FootprintAlbedos,
        irregular: IrregularYarns,
        appearance: Appearance,
        view: Vec3,
        footprint: Footprint,
        tint: Tint | None,
    ) -> None:
        """
        Args:
            means: albedos of threads over footprints.
            irregular: how yarns vary along themselves.
            appearance: of the fabric, whose sheen and rise of highlights count.
            tint: see `Model.at`.
        """
        super().__init__(view, footprint, appearance.sheen, appearance.grazing)
        self._alpha = appearance.warp.roughness, appearance.weft.roughness
        self._means, self._irregular, self._tint = means, irregular, tint
        self._back = array_types(view.x).Bool(view.z < 0)

    @cached_property
    def albedos(self) -> FamilyAlbedos:
        """Mean albedos of the threads over footprints, without parallax."""
        mean = FamilyAlbedos(*self._means.over(self.footprint, self._back))
        return tinted(self.irregular_albedos(mean), self._tint)

    @property
    def roughness(self) -> Float:
        """α of the families' fibres, each by how much the view shows of it, 0 to 1."""
        warp, weft = (maximum(part, 0) for part in self.shown)
        share = dr.select(warp + weft > 0, warp / maximum(warp + weft, 1e-30), 0.5)
        return dr.lerp(array_types(share).Float(self._alpha[1]), self._alpha[0], share)

    @property
    def coloured_footprint(self) -> Footprint:
        """The footprint whose threads are seen, for their colours."""
        return self.footprint

    @cached_property
    def yarns(self) -> Yarns | None:
        """The yarns over the footprint; None where all are even."""
        if not self._irregular.is_on:
            return None
        with dr.suspend_grad():
            return self._irregular.over(self.coloured_footprint, self._back)

    @final
    def irregular_albedos(self, albedos: FamilyAlbedos) -> FamilyAlbedos:
        """Mean albedos of even yarns as the yarns of the footprint show them."""
        if self.yarns is None:
            return albedos
        process = self._irregular.on(array_types(self.view.x))
        families = tuple(
            (part.diffuse_reflect, part.diffuse_transmit, part.specular_reflect, part.specular_transmit)
            for part in (albedos.warp, albedos.weft)
        )
        return FamilyAlbedos(
            *(Albedos(*part) for part in process.toned((families[0], families[1]), self.yarns))
        )

    @final
    def irregular_hole(self, hole: Float) -> Float:
        """The hole of even yarns as the yarns of the footprint leave it, 0 to 1."""
        return hole if self.yarns is None else minimum(hole * self.yarns.shares[2], 1)

    @final
    def irregular_evaluation(self, even: Evaluation) -> Evaluation:
        """What a footprint of even yarns does to a light, with the shares that its families have."""
        if self.yarns is None:
            return even
        warp, weft, _ = self.yarns.shares
        hole, old = self.irregular_hole(even.hole), even.components
        lit = old.light_visibility * (1 - hole) * dr.rcp(maximum(1 - even.hole, 1e-6))
        components = Components(
            warp * old.diffuse_warp,
            weft * old.diffuse_weft,
            warp * old.specular_warp,
            weft * old.specular_weft,
            lit,
        )
        return Evaluation(components, hole, even.blocked)

    @cached_property
    def between(self) -> BetweenYarns | None:
        """Light between yarns; None without."""
        albedos, seen = self.albedos, self.to_seen_face(self.view)
        return BetweenYarns.of(self._means, (albedos.warp, albedos.weft), self._tint, seen, self._back)


def shade(components: Components, albedos: FamilyAlbedos, is_transmission: Mask) -> Color3:
    """f·cos of components and albedos (chen2024 eq. 8), 1/sr, without sheen.

    Args:
        is_transmission: light and view lie on different sides.
    """
    warp, weft = albedos.warp, albedos.weft
    reflected = (
        warp.diffuse_reflect * components.diffuse_warp
        + weft.diffuse_reflect * components.diffuse_weft
        + warp.specular_reflect * components.specular_warp
        + weft.specular_reflect * components.specular_weft
    )
    transmitted = (
        warp.diffuse_transmit * components.diffuse_warp
        + weft.diffuse_transmit * components.diffuse_weft
        + warp.specular_transmit * components.specular_warp
        + weft.specular_transmit * components.specular_weft
    )
    return dr.select(is_transmission, transmitted, reflected)


def tinted(albedos: FamilyAlbedos, tint: Tint | None) -> FamilyAlbedos:
    """Albedos whose diffuse terms are multiplied with a tint; None leaves them."""
    if tint is None:
        return albedos
    return FamilyAlbedos(tinted_family(albedos.warp, tint.warp), tinted_family(albedos.weft, tint.weft))
