"""Base plus residual over footprints (zhu2024 eq. 8): unbiased, from a few yarn points.

With the yarn point that the view ray through x meets, f(x) its components, b the base, and x and the texel y
drawn together, each uniform in the footprint's box,

    E[f(x)] = mean of b over the box + E[f(x) − b(y)]

whatever b is: the base's mean is exact for the very texels that y is drawn of. Colours of threads are the
points' own: value = shade(base, ᾱ) + mean of (value(x) − shade(b(y), ᾱ)) for any albedos ᾱ.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any, final

import drjit as dr

from loomlight.aggregate.components import components, light_visibility
from loomlight.aggregate.footprint_albedos import FootprintAlbedos
from loomlight.core.arrays import Color3, Float, Mask, UInt, Vec2, Vec3
from loomlight.core.backend import array_types, clip, maximum
from loomlight.core.footprint import Footprint
from loomlight.models.between_yarns import Bounced
from loomlight.models.clustered.base import DeviceTables, LightTaps
from loomlight.models.clustered.sampling import LobeSampler
from loomlight.models.clustered.texels import TexelPoint
from loomlight.models.random_numbers import uniform
from loomlight.models.separable import (
    Components,
    Evaluation,
    FilteredBsdf,
    shade,
)
from loomlight.scattering.point import YarnScattering
from loomlight.scattering.yarn_point import DirectionSample, YarnPoint, to_face_frame

# Between seeds of points: odd, so that no two are the same.
POINT_SEED_STEP = 0x632BE5AB


@dataclass
class ResidualPoint:
    """One sample of the residual.

    Attributes:
        point: the yarn point that the view ray meets.
        texel: index of the base's texel at the same place of the footprint.
        texel_point: the texel that the view ray meets in the texel model.
    """

    point: YarnPoint
    texel: UInt
    texel_point: TexelPoint


@dataclass
class Estimate:
    """An estimate for one light.

    Attributes:
        components: base and residual.
        colour: f·cos of sampled points with their own albedos, 1/sr; of either sign.
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
        texels: int,
        seed: UInt,
        view: Vec3,
        footprint: Footprint,
        tint: Color3 | None,
        active: Mask,
    ) -> None:
        """
        Args:
            samples: yarn points; 0 leaves the residual out.
            texels: points of the texel model; 0 leaves it out.
            seed: a random number a lane.
        """
        super().__init__(means, model.appearance.sheen, view, footprint, tint)
        self._tables, self._model, self._samples, self._seed = tables, model, samples, seed
        self._texels = texels
        self._active = active
        self._base = tables.seen_from(
            to_face_frame(view, self._back), self._back, trusted=samples + texels > 0
        )
        self._box = tables.sums.box(footprint, self._base.offset, uniform(seed, 0) - 0.5)

    @cached_property
    def _cluster_means(self) -> list[Any]:
        return self._tables.sums.means(self._box, self._back)

    @cached_property
    def _points(self) -> list[ResidualPoint]:
        return [self._residual_point(number) for number in range(self._samples)]

    def _shares(self, number: UInt | int, dimension: int) -> tuple[Float, Float]:
        """Where in the box, as shares of its sides, a point lies: uniform and independent.

        Points of a lattice would be more even in the box, but fall on like places of satins, whose floats
        form lattices as well.

        Args:
            dimension: the first of its two random numbers.
        """
        seed = self._seed + array_types(self.view.x).UInt32(number) * POINT_SEED_STEP
        return uniform(seed, dimension), uniform(seed, dimension + 1)

    def _residual_point(self, number: int) -> ResidualPoint:
        s, t = self._shares(number, 1)
        place = self._box.at(s, t)
        point = self._model.locate(place.x, place.y, self.view, self._active, tint=self._tint)
        return ResidualPoint(
            point,
            self._tables.sums.texel(self._box, s, t),
            self._tables.texels.meet(place, self._base.view, self._back),
        )

    @cached_property
    def hole(self) -> Float:
        """Share of the residual's points that are holes: unbiased, 0 to 1.

        Without points the share of the base's texels.
        """
        types = array_types(self.view.x)
        if not self._samples:
            covered = types.Float(0)
            for packet in self._cluster_means[: self._tables.clusters // 4]:
                covered += packet.x + packet.y + packet.z + packet.w
            return clip(1 - covered, 0, 1)
        total = types.Float(0)
        for sample in self._points:
            total += dr.select(sample.point.hole, types.Float(1), 0)
        return total * (1 / self._samples)

    def bounced(self, evaluation: Evaluation) -> Bounced | None:
        """Albedos of light between yarns: with points unbiased, and of either sign; without, the base's."""
        del evaluation
        return self._bounced

    @cached_property
    def _bounced(self) -> Bounced | None:
        """Base and residual of `bounced`, which no light changes.

        The base of a texel is what the view's mean point of its family has.
        """
        if self.between is None:
            return None
        trusted = self._samples > 0
        warp, weft = self._base.shown_over(self._cluster_means, trusted)
        for sample in self._points:
            of_warp, of_weft = self._base.shown_at_texel(sample.texel, trusted)
            warp, weft = warp - of_warp / self._samples, weft - of_weft / self._samples
        reflected, transmitted = self.between.of_shares(warp, weft)
        for sample in self._points:
            of_point = sample.point.bounced
            reflected += of_point[0] * (1 / self._samples)
            transmitted += of_point[1] * (1 / self._samples)
        return reflected, transmitted

    def evaluate(self, light: Vec3, active: Mask = True) -> Evaluation:
        """Base and residual of the components: unbiased estimates, of either sign."""
        return Evaluation(self._estimate(light, active).components, self.hole)

    def value(self, light: Vec3, active: Mask = True) -> Color3:
        """f·cos with the points' own albedos, 1/sr: an unbiased estimate, of either sign."""
        return self.value_and_null_transmission(light, active)[0]

    def value_and_null_transmission(self, light: Vec3, active: Mask = True) -> tuple[Color3, Float]:
        """Both, of the same points."""
        found = self._estimate(light, active)
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

    def _estimate(self, light: Vec3, active: Mask) -> Estimate:
        """Base and both steps of the residual for one light."""
        types = array_types(self.view.x)
        taps = self._base.light_taps(to_face_frame(light, self._back))
        base = self._base.over(self._cluster_means, taps)
        if self._texels:
            texels, known = self._texel_sums(taps)
            base = _combined(base, known, -1 / self._texels)
            total = Estimate(
                _combined(base, texels.components, 1 / self._texels), texels.colour * (1 / self._texels), base
            )
        else:
            total = Estimate(base, types.Color3(0), base)
        for sample in self._points:
            exact = self._point_components(sample.point, light, active)
            colour = self._point_colour(sample.point, exact, taps.transmits)
            if self._texels:
                near = self._texel_components(sample.texel_point, taps)
                colour -= self._texel_colour(sample.texel_point, near, taps.transmits)
            else:
                near = self._base.at_texel(sample.texel, taps)
                total.rest = _combined(total.rest, near, -1 / self._samples)
            difference = _combined(exact, near, -1)
            total.components = _combined(total.components, difference, 1 / self._samples)
            total.colour += colour * (1 / self._samples)
        return total

    @cached_property
    def _texel_hits(self) -> list[UInt]:
        """The texels of the texel model's points, met once for all lights.

        In registers: kernels whose symbolic calls hold local arrays are not compiled.
        """
        types = array_types(self.view.x)

        def meet(number: UInt, hits: list[UInt]) -> tuple[UInt, list[UInt]]:
            place = self._box.at(*self._shares(number, 3))
            found = self._tables.texels.hit(place, self._base.view, self._back)
            return number + 1, [dr.select(number == index, found, hit) for index, hit in enumerate(hits)]

        width = dr.width(self.view, self._box.corner, self._seed)
        start = [dr.zeros(types.UInt32, width) for _ in range(self._texels)]
        met: tuple[UInt, list[UInt]] = dr.while_loop(
            (dr.zeros(types.UInt32, width), start),
            lambda number, hits: number < self._texels,
            meet,
            label="clustered: hits",
        )
        return met[1]

    def _texel_sums(self, taps: LightTaps) -> tuple[Estimate, Components]:
        """Sums over many points of the texel model, and of the base at their texels."""
        types = array_types(self.view.x)

        def add(
            number: UInt, found: Components, colour: Color3, known: Components, hits: list[UInt]
        ) -> tuple[Any, ...]:
            hit = hits[0]
            for index, other in enumerate(hits[1:], start=1):
                hit = dr.select(number == index, other, hit)
            point = self._tables.texels.point(hit)
            of_point = self._texel_components(point, taps)
            colour = colour + self._texel_colour(point, of_point, taps.transmits)
            texel = self._tables.sums.texel(self._box, *self._shares(number, 3))
            of_base = self._base.at_texel(texel, taps)
            return number + 1, _combined(found, of_point, 1), colour, _combined(known, of_base, 1), hits

        width = dr.width(self.view, taps.facing, self._box.corner, self._seed)

        def zeros() -> Components:
            return Components(*(dr.zeros(types.Float, width) for _ in fields(Components)))

        start = (dr.zeros(types.UInt32, width), zeros(), dr.zeros(types.Color3, width), zeros())
        _, found, colour, known, _ = dr.while_loop(
            (*start, self._texel_hits),
            lambda number, *rest: number < self._texels,
            add,
            label="clustered: texels",
        )
        return Estimate(found, colour, found), known

    def _texel_components(self, point: TexelPoint, taps: LightTaps) -> Components:
        diffuse, specular, lit = self._tables.texels.lobes(point, taps.facing, self._base.view)
        of_diffuse, of_specular = self._base.texel_trust
        diffuse, specular, lit = diffuse * of_diffuse, specular * of_specular, lit * of_diffuse
        return Components(
            dr.select(point.is_warp, diffuse, 0),
            dr.select(point.is_warp, 0, diffuse),
            dr.select(point.is_warp, specular, 0),
            dr.select(point.is_warp, 0, specular),
            lit,
        )

    @cached_property
    def _alike(self) -> tuple[bool, bool]:
        """Whether all points of warp and of weft have the albedos of their family."""
        warp, weft = self._model.parameters(array_types(self.view.x))
        return warp.alike and not self._model.varies, weft.alike and not self._model.varies

    def _differing(self, found: Components) -> tuple[Float, Float]:
        """Diffuse and specular component of families whose points differ in colour."""
        warp, weft = (0.0 if alike else 1.0 for alike in self._alike)
        return (
            found.diffuse_warp * warp + found.diffuse_weft * weft,
            found.specular_warp * warp + found.specular_weft * weft,
        )

    def _texel_colour(self, point: TexelPoint, found: Components, transmits: Mask) -> Color3:
        if all(self._alike):
            return array_types(self.view.x).Color3(0)
        of_diffuse, of_specular = self._tables.texels.colour(self._model, point, transmits, self._tint)
        diffuse, specular = self._differing(found)
        return of_diffuse * diffuse + of_specular * specular

    def _point_colour(self, point: YarnPoint, found: Components, transmits: Mask) -> Color3:
        if all(self._alike):
            return array_types(self.view.x).Color3(0)
        of = point.albedos
        diffuse, specular = self._differing(found)
        return dr.select(
            transmits,
            of.diffuse_transmit * diffuse + of.specular_transmit * specular,
            of.diffuse_reflect * diffuse + of.specular_reflect * specular,
        )

    def pdf(self, light: Vec3) -> Float:
        """Density of `sample` per solid angle, without delta, 1/sr."""
        return self._sampler.pdf(to_face_frame(light, self._back))

    def sample(self, choice: Float, u: Vec2) -> DirectionSample:
        """A light direction by one of the lobes, or straight through holes."""
        facing, is_null = self._sampler.sample(choice, u)
        light = to_face_frame(facing, self._back)
        pdf = dr.select(is_null, self._sampler.probabilities.null, self._sampler.pdf(facing))
        value = self.value(light, ~is_null & self._active)
        value = dr.select(is_null, self.null_transmission, value)
        weight = dr.select(pdf > 0, value / maximum(pdf, 1e-30), 0)
        return DirectionSample(light=light, pdf=pdf, weight=weight, is_null=is_null)

    @cached_property
    def _sampler(self) -> LobeSampler:
        return LobeSampler(self._tables, self._base, self._cluster_means, self.albedos, self.sheen, self.hole)

    def _point_components(self, point: YarnPoint, light: Vec3, active: Mask) -> Components:
        visible = self._model.visibility(point, light, active)
        return Components.of(
            components(self._model.appearance, point, light, self.view, visible),
            light_visibility(point, visible),
        )


def _combined(first: Components, second: Components, scale: float) -> Components:
    """first + scale·second."""
    return Components(
        *(dr.fma(getattr(second, part.name), scale, getattr(first, part.name)) for part in fields(Components))
    )
