"""Base plus residual over footprints (zhu2024 eq. 8): unbiased for the surface of texels, from a few of them.

With f the surface, b the base, and the texel y uniform in the footprint's box,

    mean of f over the box = mean of b over the box + E[f(y) − b(y)]

where the first mean is exact. Colours of threads are the texels' own: value = shade(base, ᾱ) + mean of
(value(y) − shade(b(y), ᾱ)) for any albedos ᾱ.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any, final

import drjit as dr

from loomlight.aggregate.footprint_albedos import FootprintAlbedos
from loomlight.core.arrays import Color3, Float, Mask, UInt, Vec2, Vec3
from loomlight.core.backend import array_types, clip, maximum, minimum
from loomlight.core.footprint import Footprint
from loomlight.models.between_yarns import Bounced
from loomlight.models.clustered.base import DeviceTables, TexelTerms
from loomlight.models.clustered.sampling import LobeSampler
from loomlight.models.random_numbers import uniform
from loomlight.models.separable import Components, Evaluation, FilteredBsdf, shade
from loomlight.scattering.point import DirectionSample, YarnScattering, to_face_frame

# Between seeds of points: odd, so that no two are the same.
POINT_SEED_STEP = 0x632BE5AB


@dataclass
class Estimate:
    """An estimate for one light.

    Attributes:
        components: base and residual.
        colour: f·cos of sampled texels with their own albedos, 1/sr; of either sign.
        rest: components that mean albedos multiply, so that the value is `colour` plus their colour.
    """

    components: Components
    colour: Color3
    rest: Components


@final
class ClusteredBsdf(FilteredBsdf):
    """Base and residual of footprints for one view each."""

    def __init__(
        self,
        tables: DeviceTables,
        model: YarnScattering,
        means: FootprintAlbedos,
        samples: int,
        controlled: bool,
        seed: UInt,
        view: Vec3,
        footprint: Footprint,
        tint: Color3 | None,
        active: Mask,
    ) -> None:
        """
        Args:
            samples: texels of the residual; 0 leaves it out.
            controlled: False leaves out the base and estimates everything from the texels.
            seed: a random number a lane.
        """
        super().__init__(means, model.appearance.sheen, view, footprint, tint)
        self._tables, self._model, self._samples, self._seed = tables, model, samples, seed
        self._controlled = controlled
        self._active = active
        seen = to_face_frame(view, self._back)
        self._base = tables.seen_from(seen, self._back)
        self._box = tables.box(footprint, seen, self._back, uniform(seed, 0) - 0.5)

    @cached_property
    def _cluster_means(self) -> list[Any]:
        return self._tables.sums.means(self._box, self._back)

    @cached_property
    def _texels(self) -> list[UInt]:
        """Texels of the residual: uniform in the box and independent.

        Points of a lattice would be more even, but fall on like places of satins, whose floats form lattices
        too.
        """
        found = []
        for number in range(self._samples):
            seed = self._seed + array_types(self.view.x).UInt32(number) * POINT_SEED_STEP
            found.append(self._tables.sums.texel(self._box, uniform(seed, 1), uniform(seed, 2)))
        return found

    @cached_property
    def hole(self) -> Float:
        """Share of the texels that are holes, 0 to 1: no estimate."""
        warp, weft = self._base.shown_over(self._cluster_means)
        return clip(1 - warp - weft, 0, 1)

    def bounced(self, evaluation: Evaluation) -> Bounced | None:
        """Albedos of light between yarns by the families' shares of the texels: no estimate."""
        del evaluation
        if self.between is None:
            return None
        return self.between.of_shares(*self._base.shown_over(self._cluster_means))

    def evaluate(self, light: Vec3, active: Mask = True) -> Evaluation:
        """Base and residual of the components: unbiased estimates, of either sign."""
        del active
        return Evaluation(self._estimate(light).components, self.hole)

    def value(self, light: Vec3, active: Mask = True) -> Color3:
        """f·cos with the texels' own albedos, 1/sr: an unbiased estimate, of either sign."""
        return self.value_and_null_transmission(light, active)[0]

    def value_and_null_transmission(self, light: Vec3, active: Mask = True) -> tuple[Color3, Float]:
        """Both."""
        del active
        found = self._estimate(light)
        through = light.z * self.view.z < 0
        # Of families whose threads are alike, mean albedos are the threads' own, and carry derivatives.
        warp, weft = self._alike
        own, rest = found.components, found.rest
        known = Components(
            own.diffuse_warp if warp else rest.diffuse_warp,
            own.diffuse_weft if weft else rest.diffuse_weft,
            own.specular_warp if warp else rest.specular_warp,
            own.specular_weft if weft else rest.specular_weft,
            own.light_visibility,
        )
        evaluation = Evaluation(own, self.hole)
        body = found.colour + shade(known, self.albedos, through) + self.bounced_value(evaluation, light)
        return self.under_sheen(body, evaluation, light), self.null_transmission

    def _estimate(self, light: Vec3) -> Estimate:
        """Base and residual for one light."""
        types = array_types(self.view.x)
        taps = self._base.light_taps(to_face_frame(light, self._back))
        nothing = Components(*(types.Float(0) for _ in fields(Components)))
        base = self._base.over(self._cluster_means, taps) if self._controlled else nothing
        total = Estimate(base, types.Color3(0), base)
        for texel in self._texels:
            terms = self._base.at_texel(texel, taps)
            known = terms.known if self._controlled else nothing
            share = 1 / self._samples
            total.rest = _combined(total.rest, known, -share)
            total.components = _combined(_combined(total.components, terms.own, share), known, -share)
            total.colour += self._colour(terms, taps.transmits) * share
        return total

    @cached_property
    def _alike(self) -> tuple[bool, bool]:
        """Whether all texels of warp and of weft have the albedos of their family."""
        warp, weft = self._model.parameters(array_types(self.view.x))
        return warp.alike, weft.alike

    def _colour(self, terms: TexelTerms, transmits: Mask) -> Color3:
        """f·cos of a texel of a family whose threads differ, with the albedos of its thread."""
        types = array_types(self.view.x)
        total = types.Color3(0)
        own = terms.own
        parts = ((own.diffuse_warp, own.specular_warp), (own.diffuse_weft, own.specular_weft))
        families = self._model.parameters(types)
        for alike, family, (diffuse, specular) in zip(self._alike, families, parts, strict=True):
            if alike:
                continue
            # The number of a thread of the other family may be larger.
            thread = minimum(terms.thread, types.UInt32(family.threads - 1))
            of_diffuse, of_specular = (
                dr.select(transmits, family.albedo(number + 1, thread), family.albedo(number, thread))
                for number in (0, 2)
            )
            tint = 1 if self._tint is None else self._tint
            total += of_diffuse * tint * diffuse + of_specular * specular
        return total

    def pdf(self, light: Vec3) -> Float:
        """Density of `sample` per solid angle, without delta, 1/sr."""
        return self._sampler.pdf(to_face_frame(light, self._back))

    def sample(self, choice: Float, u: Vec2) -> DirectionSample:
        """A light direction by one of the lobes, or straight through holes."""
        facing, is_null = self._sampler.sample(choice, u)
        light = to_face_frame(facing, self._back)
        pdf = dr.select(is_null, self._sampler.probabilities.null, self._sampler.pdf(facing))
        value = dr.select(is_null, self.null_transmission, self.value(light, ~is_null & self._active))
        weight = dr.select(pdf > 0, value / maximum(pdf, 1e-30), 0)
        return DirectionSample(light=light, pdf=pdf, weight=weight, is_null=is_null)

    @cached_property
    def _sampler(self) -> LobeSampler:
        return LobeSampler(self._tables, self._base, self._cluster_means, self.albedos, self.sheen, self.hole)


def _combined(first: Components, second: Components, scale: float) -> Components:
    """first + scale·second."""
    return Components(
        *(dr.fma(getattr(second, part.name), scale, getattr(first, part.name)) for part in fields(Components))
    )
