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
from loomlight.core.arrays import Color3, Float, Mask, UInt, Vec2, Vec3
from loomlight.core.backend import array_types, maximum
from loomlight.core.footprint import Footprint
from loomlight.models.clustered.base import DeviceTables, LightTaps
from loomlight.models.clustered.random_numbers import uniform
from loomlight.models.clustered.sampling import LobeSampler
from loomlight.models.separable import Components, FamilyAlbedos, SeparableBsdf, shade, tinted
from loomlight.scattering.point import Albedos, DirectionSample, PointModel, YarnPoint, to_face_frame

# The plastic number's powers: points at multiples of these shares fill a square evenly (Roberts 2018).
_ACROSS, _ALONG = 0.7548776662466927, 0.5698402909980532


@dataclass
class ResidualPoint:
    """One sample of the residual.

    Attributes:
        point: the yarn point that the view ray meets.
        texel: index of the base's texel.
    """

    point: YarnPoint
    texel: UInt


@final
class ClusteredBsdf(SeparableBsdf):
    """Base and residual of footprints for one view each."""

    def __init__(
        self,
        tables: DeviceTables,
        model: PointModel,
        mean_albedos: FamilyAlbedos,
        samples: int,
        seed: UInt,
        view: Vec3,
        footprint: Footprint,
        tint: Color3 | None,
        active: Mask,
    ) -> None:
        """
        Args:
            mean_albedos: of the footprint, without tint.
            samples: yarn points; 0 leaves the residual out.
            seed: a random number a lane.
        """
        super().__init__(view, footprint, model.appearance.sheen)
        types = array_types(view.x)
        self._tables, self._model, self._samples, self._seed = tables, model, samples, seed
        self._tint, self._active = tint, active
        self._back = types.Bool(view.z < 0)
        self._mean_albedos = mean_albedos
        self._base = tables.seen_from(to_face_frame(view, self._back), self._back)
        self._box = tables.sums.box(footprint, self._base.offset, uniform(seed, 0) - 0.5)

    @cached_property
    def _means(self) -> list[Any]:
        return self._tables.sums.means(self._box, self._back)

    @cached_property
    def _points(self) -> list[ResidualPoint]:
        first = uniform(self._seed, 1), uniform(self._seed, 2)
        return [
            self._residual_point(
                *(start + number * step for start, step in zip(first, (_ACROSS, _ALONG), strict=True))
            )
            for number in range(self._samples)
        ]

    def _residual_point(self, s: Float, t: Float) -> ResidualPoint:
        s, t = s - dr.floor(s), t - dr.floor(t)
        place = self._box.at(s, t)
        point = self._model.locate(place.x, place.y, self.view, self._active)
        if self._tint is not None:
            point.albedos = Albedos(
                point.albedos.diffuse_reflect * self._tint,
                point.albedos.diffuse_transmit * self._tint,
                point.albedos.specular_reflect,
                point.albedos.specular_transmit,
            )
        return ResidualPoint(point, self._tables.sums.texel(self._box, s, t))

    @cached_property
    def hole(self) -> Float:
        """Share of the residual's points that are holes: unbiased, 0 to 1."""
        types = array_types(self.view.x)
        total = types.Float(0)
        for sample in self._points:
            total += dr.select(sample.point.hole, types.Float(1), 0)
        return total * (1 / max(self._samples, 1))

    @cached_property
    def albedos(self) -> FamilyAlbedos:
        """Mean albedos of the threads over the footprint, which the base is multiplied by."""
        return tinted(self._mean_albedos, self._tint)

    def components(self, light: Vec3, active: Mask = True) -> Components:
        """Base and residual of the components: unbiased estimates, of either sign."""
        taps = self._taps(light)
        total = self._base.over(self._means, taps)
        for sample in self._points:
            total = _combined(total, self._point_components(sample, light, active), 1 / self._samples)
            total = _combined(total, self._base.at_texel(sample.texel, taps), -1 / self._samples)
        return total

    def value(self, light: Vec3, active: Mask = True) -> Color3:
        """f·cos with the points' own albedos, 1/sr: an unbiased estimate, of either sign."""
        taps = self._taps(light)
        known = self._base.over(self._means, taps)
        through = light.z * self.view.z < 0
        own = array_types(self.view.x).Color3(0)
        for sample in self._points:
            found = self._point_components(sample, light, active)
            point = sample.point
            warp = dr.select(point.is_warp, found.diffuse_warp, found.diffuse_weft)
            fibres = dr.select(point.is_warp, found.specular_warp, found.specular_weft)
            of = point.albedos
            colour = dr.select(
                through,
                of.diffuse_transmit * warp + of.specular_transmit * fibres,
                of.diffuse_reflect * warp + of.specular_reflect * fibres,
            )
            own += colour * (1 / self._samples)
            known = _combined(known, self._base.at_texel(sample.texel, taps), -1 / self._samples)
            known.light_visibility += found.light_visibility * (1 / self._samples)
        return self.under_sheen(own + shade(known, self.albedos, through), known.light_visibility, light)

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
        return LobeSampler(self._tables, self._base, self._means, self.albedos, self.sheen, self.hole)

    def _taps(self, light: Vec3) -> LightTaps:
        return self._base.light_taps(to_face_frame(light, self._back))

    def _point_components(self, sample: ResidualPoint, light: Vec3, active: Mask) -> Components:
        point = sample.point
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
