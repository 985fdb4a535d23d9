"""The BSDF of `lobes` for one view: prefiltered groups of large footprints, point samples of small ones."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property
from typing import Any, TypeVar, final

import drjit as dr

from loomlight.aggregate.footprint_albedos import FootprintAlbedos
from loomlight.aggregate.layered_albedos import LayeredAlbedos
from loomlight.core.arrays import Array, Color3, Float, Mask, UInt, Vec2, Vec3
from loomlight.core.backend import array_types, channel_mean, masked_branch, maximum, minimum
from loomlight.core.footprint import Footprint
from loomlight.models.between_yarns import Bounced
from loomlight.models.lobes.point_sampled import (
    Regime,
    point_sampled,
    point_sampled_hole,
    with_search_quality,
)
from loomlight.models.lobes.prefiltered import PrefilteredLobes, SeenPack, TableLookup, half_vector
from loomlight.models.separable import Components, Evaluation, FamilyAlbedos, FilteredBsdf, tinted
from loomlight.scattering.appearance import Sheen
from loomlight.scattering.diffuse import diffuse_pdf, sample_diffuse
from loomlight.scattering.fibre import mean_layer_shares, pdf_specular, sample_specular
from loomlight.scattering.irregularity import IrregularYarns
from loomlight.scattering.point import (
    Albedos,
    DirectionSample,
    Tint,
    YarnScattering,
    colours_of,
    to_face_frame,
)
from loomlight.scattering.sheen import sample_sheen, sheen_pdf, sheen_transmittance
from loomlight.yarn.visibility import first_hit

# --------------------------------------------------------------------------------------------------- proposal
# Sampling of directions: a mixture over groups of three lobes each, and its exact density.
#
# A group is drawn in proportion to its weight times the albedo of its family; then one of its lobes: the
# fibre layer about the mean fibre direction, widened by the spread of the group; the diffuse lobe about the
# mean normal; the same on the other side. With a small probability the direction is cosine-distributed
# instead, so that no direction of non-zero value has density 0. Sheen has a lobe of its own. Holes are null
# transmission.


# Mean fractions of the light that a fibre layer of albedo 1 reflects, and transmits by scattering.
PROPOSAL_LAYER_REFLECTS, PROPOSAL_LAYER_TRANSMITS = 0.45, 0.25
# Probability of the cosine lobe, which covers all directions; black cloth has this lobe alone.
PROPOSAL_COSINE_PROBABILITY = 0.05
# Smallest sum of weights that is divided by: not 0/0 of black cloth.
PROPOSAL_MIN_WEIGHT = 1e-6
# Added to α for each unit of the group's standard deviation s: a uniform interval has half-width √3 s.
PROPOSAL_SPREAD_WIDTH = 1.7


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
        specular = PROPOSAL_LAYER_REFLECTS * channel_mean(family.specular_reflect)
        specular += PROPOSAL_LAYER_TRANSMITS * channel_mean(family.specular_transmit)
        return LobeWeights(
            specular, channel_mean(family.diffuse_reflect), channel_mean(family.diffuse_transmit)
        )

    warp, weft = lobe_weights(albedos.warp), lobe_weights(albedos.weft)
    sheen_probability = types.Float(0)
    if sheen.strength > 0:
        reflected = 1 - sheen_transmittance(view, sheen.strength, sheen.roughness)
        sheen_probability = reflected * dr.rcp(
            reflected + 0.5 * (warp.total + weft.total) + PROPOSAL_MIN_WEIGHT
        )
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
    by_groups = groups * dr.rcp(maximum(weight_sum, PROPOSAL_MIN_WEIGHT))
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
    by_cosine = rest < PROPOSAL_COSINE_PROBABILITY
    to_groups = (rest - PROPOSAL_COSINE_PROBABILITY) / (1 - PROPOSAL_COSINE_PROBABILITY)
    drawn = _draw_group(lobes, at, mixture, to_groups)
    has_groups = drawn.weight_sum > PROPOSAL_MIN_WEIGHT
    tangent, roughness, normal = _frame(drawn.tangent, drawn.normal, lobes.roughness(drawn.is_warp))
    lobe_weights = mixture.family(drawn.is_warp)
    aim = drawn.rest * lobe_weights.total
    light = sample_specular(view, tangent, roughness, u)
    diffuse = sample_diffuse(normal, types.Float(mixture.blend), u)
    reflects = aim < lobe_weights.specular + lobe_weights.reflect
    light = dr.select(aim < lobe_weights.specular, light, dr.select(reflects, diffuse, -diffuse))
    cosine = sample_diffuse(types.Vector3(0, 0, 1), types.Float(0), u)
    # Given the cosine lobe, `rest` is uniform below its probability: rescaled, it chooses the side.
    side = dr.select(has_groups, rest * (1 / PROPOSAL_COSINE_PROBABILITY), rest)
    light = dr.select(by_cosine | ~has_groups, dr.select(side < mixture.transmit, -cosine, cosine), light)
    if sheen.strength > 0:
        light = dr.select(is_sheen, sample_sheen(view, sheen.roughness, u), light)
    return dr.select(is_null, -view, light), is_null


def _cosine_probability(weight_sum: Float) -> Float:
    """Probability of the cosine lobe: 1 where groups have no weight."""
    return dr.select(
        weight_sum > PROPOSAL_MIN_WEIGHT, array_types(weight_sum).Float(PROPOSAL_COSINE_PROBABILITY), 1
    )


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
    roughness = minimum(dr.fma(PROPOSAL_SPREAD_WIDTH, width, roughness), 1)
    return dr.normalize(tangent), roughness, dr.normalize(normal)


# ------------------------------------------------------------------------------------------------------- bsdf


# Smallest sum of the groups' weights; a view that sees no group sees holes alone.
MIN_GROUP_WEIGHT = 1e-12
Parts = TypeVar("Parts", Albedos, Components)


@dataclass
class GroupSums:
    """Sums over the groups of a footprint for one light.

    Attributes:
        density: the groups' part of the density of directions, not divided by `weight_sum`.
        weight_sum: sum of the mixture weights of all groups.
    """

    components: Components
    density: Float
    weight_sum: Float


@final
class LobesBsdf(FilteredBsdf):
    """Footprints of one fabric as views see them."""

    def __init__(
        self,
        lobes: PrefilteredLobes,
        point_model: YarnScattering,
        means: FootprintAlbedos,
        irregular: IrregularYarns,
        regime: Regime,
        view: Vec3,
        footprint: Footprint,
        tint: Tint | None,
    ) -> None:
        """See `FilteredBsdf`."""
        super().__init__(means, irregular, point_model.appearance, view, footprint, tint)
        self._lobes = lobes
        self._point_model = point_model
        self._regime = regime

    @cached_property
    def _at(self) -> TableLookup:
        return self._lobes.lookup(self.footprint, to_face_frame(self.view, self._back), self._back)

    @cached_property
    def _sampled_model(self) -> YarnScattering:
        return with_search_quality(self._point_model, self._regime.threads)

    @cached_property
    def mixture(self) -> Mixture:
        """Probabilities of the lobes that do not depend on the group."""
        blend = self._point_model.appearance.diffuse_blend
        # Densities carry no derivatives: sums over groups are loops.
        albedos = dr.detach(self.albedos_in_mirror)
        return mixture_of(albedos, self.null_transmission, self._at.view, self.sheen, blend)

    @cached_property
    def hole(self) -> Float:
        """Fraction of the view rays that pass through holes, 0 to 1."""
        points = point_sampled_hole(self._sampled_model, self._regime.points, self.view, self.footprint)
        even = dr.lerp(points, self._lobes.hole(self._at), self._regime.prefiltered)
        return self.irregular_hole(even)

    @cached_property
    def albedos(self) -> FamilyAlbedos:
        """Mean albedos of the threads in the footprint.

        In the point-sampled regime the fabric's random variation is evaluated where the central ray hits. In
        the prefiltered regime variations average out.
        """
        if self._layered is not None:
            return self._shown(FamilyAlbedos(*self._layered.albedos))
        return self._shown(FamilyAlbedos(*self._means.over(self.coloured_footprint, self._back)))

    def albedos_for(self, light: Vec3) -> FamilyAlbedos:
        """The same as a light shows them: in layered cloth it reaches those behind more or less."""
        if self._layered is None:
            return self.albedos
        return self._shown(FamilyAlbedos(*self._layered.towards(to_face_frame(light, self._back))))

    def _shown(self, mean: FamilyAlbedos) -> FamilyAlbedos:
        """Mean albedos of even yarns as the yarns of the footprint show them, tinted."""
        mean = self.irregular_albedos(mean)
        if self._varies:
            mean = self._varied(mean)
        return tinted(mean, self._tint)

    @cached_property
    def _layered(self) -> LayeredAlbedos | None:
        """Mean albedos of layered cloth; None of cloth in one plane."""
        if self._means.seen is None:
            return None
        layered = self._means.layered(self.coloured_footprint, self._at.view, self._back)
        # In close-ups the layer alone counts that the central ray meets.
        x, y, _, weight = self._central
        layer = self._point_model.surface.surface(x, y, self._back).layer
        return layered.of_layer(layer, weight)

    @property
    def _size(self) -> Float | None:
        """Side of the footprint that the yarns' detail is filtered with; None without detail."""
        return self.footprint.spread_side if self._point_model.has_detail else None

    @property
    def _varies(self) -> bool:
        """Whether albedos vary by chance or by what yarns show close up."""
        return self._point_model.varies_at(self._size)

    @cached_property
    def _central(self) -> tuple[Float, Float, Float, Float]:
        """Where the central ray hits: x, y, height, and its weight, 0 in holes and in the prefiltered regime.

        Without a weight, x and y are the footprint's centre.
        """
        model, centre = self._point_model, self.footprint.centre
        types = array_types(self.view.x)
        point_weight = 1 - self._regime.prefiltered
        view = to_face_frame(self.view, self._back)

        def intersect(_: tuple[Float, ...]) -> tuple[Float, ...]:
            hit = first_hit(model.surface, centre.x, centre.y, view, self._back, True, model.quality)
            x, y = dr.select(hit.hole, centre.x, hit.x), dr.select(hit.hole, centre.y, hit.y)
            return x, y, hit.height, dr.select(hit.hole, 0, point_weight)

        start = centre.x, centre.y, types.Float(0 * point_weight), types.Float(point_weight)
        x, y, height, weight = masked_branch(point_weight > 0, start, intersect, "lobes: central ray")
        return x, y, height, weight

    @cached_property
    def coloured_footprint(self) -> Footprint:
        """Centred where the central ray hits, in the point-sampled regime: colours stay on their threads."""
        if not (self._means.varied or self._means.seen or self._varies or self._irregular.is_on):
            return self.footprint
        x, y, _, weight = self._central
        centre = self.footprint.centre
        shifted = array_types(x).Vector2(dr.lerp(centre.x, x, weight), dr.lerp(centre.y, y, weight))
        return replace(self.footprint, centre=shifted)

    def _varied(self, mean: FamilyAlbedos) -> FamilyAlbedos:
        """Mean albedos varied by chance, and by what yarns show close up, where the central ray hits."""
        x, y, height, weight = self._central
        model, back, size = self._point_model, self._back, self._size
        view = to_face_frame(self.view, back)

        def vary(families: tuple[Albedos, Albedos]) -> tuple[Albedos, Albedos]:
            point = model.surface.surface(x, y, back, (view, height))
            hairs = model.hairs(point, back, size)
            hair = None if hairs is None else hairs.seen(view)
            is_warp = point.is_warp if hair is None else hair.family(point.is_warp)
            warp, weft = (
                _lerp(old, model.varied(point, old, back, size, hair), dr.select(shown, weight, 0))
                for old, shown in zip(families, (is_warp, ~is_warp), strict=True)
            )
            return warp, weft

        return FamilyAlbedos(*masked_branch(weight > 0, (mean.warp, mean.weft), vary, "lobes: variation"))

    def bounced(self, evaluation: Evaluation) -> Bounced | None:
        """Albedos of light between yarns: of the points of close-ups, of the families' means farther away."""
        far = super().bounced(evaluation)
        if self.between is None or far is None or evaluation.blocked is None:
            return self._with_behind(far)
        of_points = self.between.of_families(*evaluation.blocked)
        weight = self._regime.prefiltered
        return self._with_behind(
            (dr.lerp(of_points[0], far[0], weight), dr.lerp(of_points[1], far[1], weight))
        )

    def _with_behind(self, between: Bounced | None) -> Bounced | None:
        """With the light of layers behind those that show."""
        if self._layered is None:
            return between
        types = array_types(self.view.x)
        appearance = self._point_model.appearance
        depth = types.Float(appearance.optical_depth)
        shares = [
            mean_layer_shares(family.roughness, depth)[1] for family in self._point_model.parameters(types)
        ]
        reflected, transmitted = (types.Color3(0),) * 2 if between is None else between
        for found, colour in zip(self._layered.behind(shares), colours_of(self._tint), strict=True):
            tint = types.Color3(1) if colour is None else colour
            reflected, transmitted = (
                reflected + found.reflected * tint,
                transmitted + found.transmitted * tint,
            )
        return reflected, transmitted

    def evaluate(self, light: Vec3, active: Mask = True) -> Evaluation:
        """Components for a light, 1/sr, and the hole, in one pass over the groups."""
        return self._evaluate([light], None, active)[0][0]

    def pdf(self, light: Vec3) -> Float:
        """Density of `sample` per solid angle, without delta, 1/sr."""
        return self.value_and_pdf(light)[1]

    def value_and_pdf(self, light: Vec3, active: Mask = True) -> tuple[Color3, Float]:
        """Value and density of a light, in one pass over the groups."""
        ((evaluation, sums),) = self._evaluate([light], self.mixture)
        return self.composed(evaluation, light), self._density(sums, light)

    def sample(self, choice: Float, u: Vec2) -> DirectionSample:
        """A direction: null transmission through holes, else a direction from one of the lobes."""
        light, is_null = self._draw(choice, u)
        (result,) = self._evaluate([light], self.mixture)
        return self._weighed(light, is_null, *result)

    def value_pdf_sample_and_null_transmission(
        self, light: Vec3, choice: Float, u: Vec2
    ) -> tuple[Color3, Float, DirectionSample, Float]:
        """All four in two passes over the groups: one draws, one evaluates both lights."""
        drawn, is_null = self._draw(choice, u)
        (evaluation, sums), of_drawn = self._evaluate([light, drawn], self.mixture)
        value, sample = self.composed(evaluation, light), self._weighed(drawn, is_null, *of_drawn)
        return value, self._density(sums, light), sample, self.null_transmission

    def _draw(self, choice: Float, u: Vec2) -> tuple[Vec3, Mask]:
        """A light direction, and whether it is null transmission."""
        facing, is_null = draw(self._lobes, self._at, self.mixture, self.sheen, choice, u)
        return to_face_frame(facing, self._back), is_null

    def _weighed(
        self, light: Vec3, is_null: Mask, evaluation: Evaluation, sums: GroupSums
    ) -> DirectionSample:
        pdf = dr.select(is_null, self.mixture.null, self._density(sums, light))
        value = self.composed(evaluation, light)
        # Null transmission is drawn with the probability of its transmittance.
        weight = dr.select(is_null, 1, dr.select(pdf > 0, value / maximum(pdf, 1e-30), 0))
        return DirectionSample(light=light, pdf=pdf, weight=weight, is_null=is_null)

    def _density(self, sums: GroupSums, light: Vec3) -> Float:
        facing = to_face_frame(light, self._back)
        return density(self.mixture, sums.density, sums.weight_sum, facing, self._at.view, self.sheen)

    def _evaluate(
        self, lights: Sequence[Vec3], mixture: Mixture | None, active: Mask = True
    ) -> list[tuple[Evaluation, GroupSums]]:
        """Both regimes for each light, and the sums over the groups, with a mixture for its density.

        Args:
            active: lanes whose components are used; densities are computed in all lanes.
        """
        weight = self._regime.prefiltered
        hole, prefiltered = self.prefiltered(lights, mixture, (weight > 0) & active)
        points = point_sampled(
            self._sampled_model,
            self._means.between_yarns(array_types(self.view.x)),
            self._regime.points,
            lights,
            self.view,
            self.footprint,
        )
        hole = dr.lerp(points.hole, hole, weight)
        return [
            (
                self.irregular_evaluation(
                    Evaluation(_lerp(sampled, sums.components, weight), hole, points.blocked)
                ),
                sums,
            )
            for sampled, sums in zip(points.components, prefiltered, strict=True)
        ]

    def prefiltered(
        self, lights: Sequence[Vec3], mixture: Mixture | None, active: Mask
    ) -> tuple[Float, list[GroupSums]]:
        """The hole and the sums over the groups for each light, in one pass over the groups.

        Args:
            mixture: lobe probabilities; None computes no densities.
            active: lanes whose components are used.
        """
        types = array_types(self.view.x)
        lobes, at = self._lobes, self._at
        facing = [to_face_frame(light, self._back) for light in lights]
        nodes = [lobes.light_nodes(at, light) for light in facing]
        halves = [half_vector(light, at.view) for light in facing]
        active = types.Bool(active) if mixture is None else types.Bool(True)

        def add(pair: UInt, total: Float, weight_sum: Float, *sums: Float) -> tuple[Array, ...]:
            packs = lobes.seen_packs(at, pair)
            added = list(sums)
            if mixture is not None:
                weight_sum = weight_sum + total_weight(packs, mixture)
            for number, (light, around, half) in enumerate(zip(facing, nodes, halves, strict=True)):
                of_packs = lobes.components(packs, at, around, pair, light, half)
                first = 7 * number
                for pack, of_pack in zip(packs, of_packs, strict=True):
                    for index, part in zip(range(first, first + 6, 2), of_pack, strict=True):
                        added[index] = added[index] + dr.select(pack.is_warp, part, 0)
                        added[index + 1] = added[index + 1] + dr.select(pack.is_warp, 0, part)
                if mixture is not None:
                    added[first + 6] = added[first + 6] + packs_density(packs, mixture, light, at.view)
            return pair + 1, total + sum(sum(pack.weights) for pack in packs), weight_sum, *added

        width = dr.width(self.view, list(lights), self.footprint.centre, self.footprint.duv_dx)
        zeros = [dr.zeros(types.Float, width) for _ in range(2 + 7 * len(lights))]
        _, total, weight_sum, *sums = dr.while_loop(
            (dr.zeros(types.UInt32, width), *zeros),
            lambda pair, *rest: active & (pair < lobes.pairs),
            add,
            label="lobes: groups",
        )
        hole = lobes.hole(at)
        scale = (1 - hole) * dr.rcp(maximum(total, MIN_GROUP_WEIGHT))
        results = []
        for number, light in enumerate(facing):
            ratios = lobes.ratios(at, light)
            *parts, of_density = sums[7 * number : 7 * (number + 1)]
            joint = [part * (ratios[number % 2] * scale) for number, part in enumerate(parts)]
            components = Components.of(joint[:4], minimum(joint[4] + joint[5], 1 - hole))
            results.append(GroupSums(components, of_density, weight_sum))
        return hole, results


def _lerp(first: Parts, second: Parts, weight: Float) -> Parts:
    """Between two dataclasses of numbers or colours."""
    names = (field.name for field in fields(first))
    return type(first)(*(dr.lerp(getattr(first, name), getattr(second, name), weight) for name in names))
