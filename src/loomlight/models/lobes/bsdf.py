"""The BSDF of `lobes`: what a view sees of footprints, by groups of yarn points and, close up, by points."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, final

import drjit as dr

from loomlight.aggregate.footprint_albedos import FootprintAlbedos
from loomlight.core.arrays import Color3, Float, Mask, Vec2, Vec3
from loomlight.core.backend import array_types, maximum
from loomlight.core.footprint import Footprint
from loomlight.core.masked_branch import masked_branch
from loomlight.models.lobes.point_sampled import (
    point_sampled_components,
    point_sampled_hole,
    with_search_quality,
)
from loomlight.models.lobes.prefiltered import PrefilteredLobes, TableLookup, half_vector
from loomlight.models.lobes.proposal import Mixture, density, draw, energy_of, mixture_of, words_density
from loomlight.models.lobes.regimes import Regime
from loomlight.models.separable import Components, FamilyAlbedos, SeparableBsdf, tinted
from loomlight.scattering.point import Albedos, DirectionSample, PointModel, to_face_frame
from loomlight.yarn.visibility import first_hit

# Of all groups together; a view that sees none sees holes alone.
SMALLEST_WEIGHT = 1e-12


@dataclass
class GroupAnswer:
    """What footprints do to one light.

    Attributes:
        groups: the groups' part of the density of directions, not divided by `energy`.
        energy: of all groups.
    """

    components: Components
    groups: Float
    energy: Float


@final
class LobesBsdf(SeparableBsdf):
    """Footprints of one fabric as views see them."""

    def __init__(
        self,
        lobes: PrefilteredLobes,
        point_model: PointModel,
        means: FootprintAlbedos,
        regime: Regime,
        view: Vec3,
        footprint: Footprint,
        tint: Color3 | None,
    ) -> None:
        """
        Args:
            means: albedos of threads over footprints.
            tint: see `Model.at`.
        """
        super().__init__(view, footprint, point_model.appearance.sheen)
        self._lobes = lobes
        self._point_model = point_model
        self._means = means
        self._regime = regime
        self._tint = tint
        self._back = array_types(view.x).Bool(view.z < 0)

    @cached_property
    def _at(self) -> TableLookup:
        return self._lobes.lookup(self.footprint, to_face_frame(self.view, self._back), self._back)

    @cached_property
    def _sampled_model(self) -> PointModel:
        return with_search_quality(self._point_model, self._regime.threads)

    @cached_property
    def mixture(self) -> Mixture:
        """Probabilities by which directions are drawn, as far as they depend on no group."""
        blend = self._point_model.appearance.diffuse_blend
        return mixture_of(self.albedos, self.null_transmission, self._at.view, self.sheen, blend)

    @cached_property
    def hole(self) -> Float:
        """Share of the view rays that pass through."""
        points = point_sampled_hole(self._sampled_model, self._regime.points, self.view, self.footprint)
        return dr.lerp(points, self._lobes.hole(self._at), self._regime.prefiltered)

    @cached_property
    def albedos(self) -> FamilyAlbedos:
        """Mean albedos of the threads; close up, of those around the point that the middle ray meets.

        Close up the footprint is moved to where the middle ray meets a yarn, and that yarn and its fibres
        vary by chance as the fabric says; from afar variations cancel.
        """
        return tinted(self._mean_albedos(), self._tint)

    def _mean_albedos(self) -> FamilyAlbedos:
        means, model, footprint, back = self._means, self._point_model, self.footprint, self._back
        if not means.varied and not model.varies:
            return FamilyAlbedos(*means.over(footprint, back))
        types, surface, middle = array_types(self.view.x), model.surface, footprint.centre

        def meet(_: tuple[Any, Any, Any]) -> tuple[Any, Any, Any]:
            seen = to_face_frame(self.view, back)
            hit = first_hit(surface, middle.x, middle.y, seen, back, True, model.quality)
            counts = dr.select(hit.hole, 0, close)
            return dr.select(hit.hole, middle.x, hit.x), dr.select(hit.hole, middle.y, hit.y), counts

        close = 1 - self._regime.prefiltered
        start = middle.x, middle.y, types.Float(close)
        x, y, share = masked_branch(close > 0, start, meet, "lobes: middle ray")
        moved = types.Vector2(dr.lerp(middle.x, x, share), dr.lerp(middle.y, y, share))
        mean = means.over(replace(footprint, centre=moved), back)
        if not model.varies:
            return FamilyAlbedos(*mean)

        def vary(families: tuple[Albedos, Albedos]) -> tuple[Albedos, Albedos]:
            point = surface.surface(x, y, back)
            warp, weft = (
                _lerp_albedos(family, model.varied(point, family, x, y), dr.select(here, share, 0))
                for family, here in zip(families, (point.is_warp, ~point.is_warp), strict=True)
            )
            return warp, weft

        return FamilyAlbedos(*masked_branch(share > 0, mean, vary, "lobes: variation"))

    def components(self, light: Vec3, active: Mask = True) -> Components:
        """Components for a light; the hole comes with them."""
        return self._answers([light], None, active)[0].components

    def pdf(self, light: Vec3) -> Float:
        """Density of `sample` per solid angle, without delta, 1/sr."""
        return self.value_and_pdf(light)[1]

    def value_and_pdf(self, light: Vec3, active: Mask = True) -> tuple[Color3, Float]:
        """Both in one pass over the groups."""
        mixture = self.mixture
        (answer,) = self._answers([light], mixture)
        return self.composed(answer.components, light), self._density(mixture, answer, light)

    def sample(self, choice: Float, u: Vec2) -> DirectionSample:
        """Straight through the holes, else from one of the lobes."""
        light, is_null = self._draw(choice, u)
        (answer,) = self._answers([light], self.mixture)
        return self._weighed(light, is_null, answer)

    def value_pdf_and_sample(
        self, light: Vec3, choice: Float, u: Vec2
    ) -> tuple[Color3, Float, DirectionSample]:
        """All three: groups are read twice, once to draw and once to evaluate both lights."""
        drawn, is_null = self._draw(choice, u)
        given, answer = self._answers([light, drawn], self.mixture)
        value = self.composed(given.components, light)
        return value, self._density(self.mixture, given, light), self._weighed(drawn, is_null, answer)

    def _draw(self, choice: Float, u: Vec2) -> tuple[Vec3, Mask]:
        """A light direction, and whether it passes straight through."""
        facing, is_null = draw(self._lobes, self._at, self.mixture, self.sheen, choice, u)
        return to_face_frame(facing, self._back), is_null

    def _weighed(self, light: Vec3, is_null: Mask, answer: GroupAnswer) -> DirectionSample:
        pdf = dr.select(is_null, self.mixture.null, self._density(self.mixture, answer, light))
        value = self.composed(answer.components, light)
        # A ray goes straight through with the very share of light that does.
        weight = dr.select(is_null, 1, dr.select(pdf > 0, value / maximum(pdf, 1e-30), 0))
        return DirectionSample(light=light, pdf=pdf, weight=weight, is_null=is_null)

    def _density(self, mixture: Mixture, answer: GroupAnswer, light: Vec3) -> Float:
        facing = to_face_frame(light, self._back)
        return density(mixture, answer.groups, answer.energy, facing, self._at.view, self.sheen)

    def _answers(
        self, lights: Sequence[Vec3], mixture: Mixture | None, active: Mask = True
    ) -> list[GroupAnswer]:
        """What footprints do to each light, and with a mixture the groups' part of its density.

        Args:
            active: lanes where components are wanted; densities are computed in all.
        """
        weight = self._regime.prefiltered
        hole, prefiltered = self.prefiltered(lights, mixture, (weight > 0) & active)
        point_hole, sampled = point_sampled_components(
            self._sampled_model, self._regime.points, lights, self.view, self.footprint
        )
        # Components know the hole: nobody has to search for it again.
        self.__dict__.setdefault("hole", dr.lerp(point_hole, hole, weight))
        return [
            replace(answer, components=_lerp_components(points, answer.components, weight))
            for points, answer in zip(sampled, prefiltered, strict=True)
        ]

    def prefiltered(
        self, lights: Sequence[Vec3], mixture: Mixture | None, active: Mask
    ) -> tuple[Float, list[GroupAnswer]]:
        """The hole and the answers of the groups alone, in one pass over them.

        Args:
            mixture: by which directions are drawn; without one, densities are left out.
            active: lanes where components are wanted.
        """
        types = array_types(self.view.x)
        lobes, at = self._lobes, self._at
        facing = [to_face_frame(light, self._back) for light in lights]
        nodes = [lobes.light_nodes(at, light) for light in facing]
        halves = [half_vector(light, at.view) for light in facing]
        active = types.Bool(active) if mixture is None else types.Bool(True)

        def add(pair: Any, total: Float, energy: Float, *sums: Any) -> tuple[Any, ...]:
            words = lobes.seen(at, pair)
            added = list(sums)
            if mixture is not None:
                energy = energy + energy_of(words, mixture)
            for number, (light, around, half) in enumerate(zip(facing, nodes, halves, strict=True)):
                of_words = lobes.components(words, at, around, pair, light, half)
                first = 5 * number
                for word, (diffuse, specular) in zip(words, of_words, strict=True):
                    for place, part in ((first, diffuse), (first + 2, specular)):
                        added[place] = added[place] + dr.select(word.is_warp, part, 0)
                        added[place + 1] = added[place + 1] + dr.select(word.is_warp, 0, part)
                if mixture is not None:
                    added[first + 4] = added[first + 4] + sum(words_density(words, mixture, light, at.view))
            return pair + 1, total + sum(sum(word.weights) for word in words), energy, *added

        width = dr.width(self.view, list(lights), self.footprint.centre, self.footprint.duv_dx)
        zeros = [dr.zeros(types.Float, width) for _ in range(2 + 5 * len(lights))]
        _, total, energy, *sums = dr.while_loop(
            (dr.zeros(types.UInt32, width), *zeros),
            lambda pair, *rest: active & (pair < lobes.pairs),
            add,
            label="lobes: groups",
        )
        hole = lobes.hole(at)
        scale = (1 - hole) * dr.rcp(maximum(total, SMALLEST_WEIGHT))
        answers = []
        for first in range(0, len(sums), 5):
            components = Components(*(part * scale for part in sums[first : first + 4]))
            answers.append(GroupAnswer(components, sums[first + 4], energy))
        return hole, answers


def _lerp_albedos(first: Albedos, second: Albedos, weight: Float) -> Albedos:
    return Albedos(
        dr.lerp(first.diffuse_reflect, second.diffuse_reflect, weight),
        dr.lerp(first.diffuse_transmit, second.diffuse_transmit, weight),
        dr.lerp(first.specular_reflect, second.specular_reflect, weight),
        dr.lerp(first.specular_transmit, second.specular_transmit, weight),
    )


def _lerp_components(first: Components, second: Components, weight: Float) -> Components:
    return Components(
        dr.lerp(first.diffuse_warp, second.diffuse_warp, weight),
        dr.lerp(first.diffuse_weft, second.diffuse_weft, weight),
        dr.lerp(first.specular_warp, second.specular_warp, weight),
        dr.lerp(first.specular_weft, second.specular_weft, weight),
    )
