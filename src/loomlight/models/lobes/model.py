"""Prefiltered fibre lobes as a multi-scale model: tables of one fabric, no training."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any, Self, final

import drjit as dr

from loomlight.aggregate.footprint_albedos import FootprintAlbedos
from loomlight.assets.loom_file import LoomFile
from loomlight.core.backend import ArrayTypes, array_types, clip, maximum
from loomlight.core.errors import InputError
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import llvm_float
from loomlight.core.masked_branch import masked_branch
from loomlight.fabric.fabric import Fabric
from loomlight.models.interface import FamilyAlbedos, Model, Response
from loomlight.models.lobes.estimate import Estimator, Place, half_vector
from loomlight.models.lobes.near import near_hole, near_responses, points_of, searched_for
from loomlight.models.lobes.proposal import (
    SMALLEST_WEIGHT,
    Shares,
    density,
    draw,
    energies_of,
    energies_where,
    energy_of,
    group_density,
    shares_of,
)
from loomlight.models.lobes.tables import LobeTables, bake_tables, tables_of_loom
from loomlight.scattering.point import Albedos, DirectionSample, PointModel, to_face_frame
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.search import upload_extent
from loomlight.yarn.visibility import first_hit

DEFAULT_GROUPS = 8
MOST_GROUPS = 64
# Footprints in threads: below the first points alone count, above the second groups alone. Where squares of
# the pyramid are wider than a thread, in units of this share of them.
_HAND_OVER = 0.6, 1.6
_SQUARE_SHARE = 0.8
_NEAREST = 1e-9
# Of one group: 24 for interpolation, 27 for variances, 21 for cosines, 8 for areas, 25 for the density, 15
# for attenuation.
_MULTIPLY_ADDS = 120


@final
class LobesModel(Model):
    """Groups of like yarn points, their lobes in closed form.

    Attributes:
        tables: what is baked.
        multiply_adds: of one query far away, as the formulas stand: twin.py has them.
        bytes_fetched: by one query far away, from tables that differ from place to place and direction to
            direction. The moments, 48 bytes a group, are the same for all queries of a face; what is fetched
            along with the bytes of holes is left out.
    """

    name = "lobes"
    filters = True
    conserves_energy = True

    def __init__(self, fabric: Fabric, tables: LobeTables) -> None:
        """A model of tables that are at hand; see `for_fabric`."""
        self.fabric = fabric
        self.tables = tables
        self._geometry = YarnGeometry(fabric.layout())
        self.point_model = PointModel(self._geometry, fabric.appearance())
        self._estimators: dict[type, Estimator] = {}
        self._sheen = fabric.appearance().sheen
        self._blend = fabric.appearance().diffuse_blend
        picks, ends = fabric.layout().warp_on_top.shape
        width, height = fabric.layout().size
        self._thread = math.sqrt(width / ends * height / picks)
        self._scales: dict[type, tuple[Any, Any]] = {}
        self.multiply_adds = _MULTIPLY_ADDS * 4 * tables.packs
        # Nine nodes of the pyramid, four of the view, four of the light.
        self.bytes_fetched = 4 * (9 * (tables.packs + 1) + 4 * (2 * tables.packs + 1) + 4 * 2 * tables.packs)

    @classmethod
    def for_fabric(cls, fabric: Fabric, groups: int = DEFAULT_GROUPS) -> Self:
        """The model of a fabric with so many groups of each family, 1 to 64, on average; see `find_groups`.

        Raises:
            InputError: fewer or more groups.
        """
        return cls(fabric, tables_of(fabric, groups))

    def upload(self, types: ArrayTypes) -> None:
        """Puts all but albedos on a backend, which otherwise happens at first use."""
        self._geometry.upload(types)
        upload_extent(self._geometry, types)
        self.point_model.parameters(types)
        self.estimator(types)
        self._scale(types)

    def to_loom(self) -> LoomFile:
        """The tables."""
        return LoomFile(
            model=self.name,
            fabric=self.fabric,
            tensors=self.tables.arrays(),
            settings={"base_size": self.tables.base_size},
        )

    @classmethod
    def from_loom(cls, loom: LoomFile) -> Self:
        """The model of the tables in a file.

        Raises:
            InputError: another model's file, or tables that do not belong together.
        """
        loom.require_model(cls.name)
        return cls(loom.fabric, tables_of_loom(loom))

    def evaluate(self, light: Any, view: Any, footprint: Footprint, active: Any = True) -> Response:
        """Components and hole of footprints; the hole alone where lanes are not active."""
        return self._answers([light], view, footprint, None, active)[0][0]

    def albedos(self, view: Any, footprint: Footprint) -> FamilyAlbedos:
        """Mean albedos of the threads; close up, of those around the point that the middle ray meets."""
        return self.albedos_from(self._albedos, view, footprint)

    @cached_property
    def _albedos(self) -> FootprintAlbedos:
        return FootprintAlbedos(self._geometry, self.fabric.appearance())

    def albedos_from(self, means: FootprintAlbedos, view: Any, footprint: Footprint) -> FamilyAlbedos:
        """`albedos` of threads of other colours.

        Close up the footprint is moved to where the middle ray meets a yarn, and that yarn and its fibres
        vary by chance as the fabric says; from afar variations cancel.
        """
        types = array_types(view.x)
        back = types.Bool(view.z < 0)
        varies = self.point_model.varies
        if not (means.varied or varies):
            return FamilyAlbedos(*means.over(footprint, back))
        surface, middle = self.point_model.surface, footprint.centre

        def meet(_: tuple[Any, Any, Any]) -> tuple[Any, Any, Any]:
            seen = to_face_frame(view, back)
            hit = first_hit(surface, middle.x, middle.y, seen, back, True, self.point_model.quality)
            counts = dr.select(hit.hole, 0, close)
            return dr.select(hit.hole, middle.x, hit.x), dr.select(hit.hole, middle.y, hit.y), counts

        close = 1 - self._far_share(footprint.spread_side)
        start = middle.x, middle.y, types.Float(close)
        x, y, share = masked_branch(close > 0, start, meet, "lobes: middle ray")
        moved = types.Vector2(dr.lerp(middle.x, x, share), dr.lerp(middle.y, y, share))
        mean = means.over(replace(footprint, centre=moved), back)
        if not varies:
            return FamilyAlbedos(*mean)

        def vary(families: tuple[Albedos, Albedos]) -> tuple[Albedos, Albedos]:
            point = surface.surface(x, y, back)
            warp, weft = (
                _faded(family, self.point_model.varied(point, family, x, y), dr.select(here, share, 0))
                for family, here in zip(families, (point.is_warp, ~point.is_warp), strict=True)
            )
            return warp, weft

        warp, weft = masked_branch(share > 0, mean, vary, "lobes: variation")
        return FamilyAlbedos(warp, weft)

    def sample(self, view: Any, footprint: Footprint, choice: Any, u: Any) -> DirectionSample:
        """Straight through the holes, else from one of the lobes."""
        albedos = self.albedos(view, footprint)
        shares = self.shares(albedos, view, footprint)
        return self.sample_with(albedos, shares, view, footprint, choice, u)

    def sample_with(
        self, albedos: FamilyAlbedos, shares: Shares, view: Any, footprint: Footprint, choice: Any, u: Any
    ) -> DirectionSample:
        """`sample` where mean albedos and shares are at hand already."""
        light, passes = self._drawn(shares, view, footprint, choice, u)
        answer = self._answers([light], view, footprint, shares)[0]
        return self._weighed(albedos, shares, view, light, passes, answer)

    def respond_and_sample(
        self,
        albedos: FamilyAlbedos,
        shares: Shares,
        light: Any,
        view: Any,
        footprint: Footprint,
        choice: Any,
        u: Any,
    ) -> tuple[Response, Any, DirectionSample]:
        """`evaluate` and `pdf` of a light, and a sample; yarns are searched once for both."""
        drawn, passes = self._drawn(shares, view, footprint, choice, u)
        first, second = self._answers([light, drawn], view, footprint, shares)
        pdf = self._density(shares, first[1], light, view)
        return first[0], pdf, self._weighed(albedos, shares, view, drawn, passes, second)

    def _drawn(self, shares: Shares, view: Any, footprint: Footprint, choice: Any, u: Any) -> tuple[Any, Any]:
        """A light direction, and whether it passes straight through."""
        types = array_types(view.x)
        place = self._place(footprint, view)
        facing, passes = draw(self.estimator(types), place, shares, self._sheen, self._blend, choice, u)
        return to_face_frame(facing, types.Bool(view.z < 0)), passes

    def _weighed(
        self,
        albedos: FamilyAlbedos,
        shares: Shares,
        view: Any,
        light: Any,
        passes: Any,
        answer: tuple[Response, Any],
    ) -> DirectionSample:
        response, of_groups = answer
        pdf = dr.select(passes, shares.through, self._density(shares, of_groups, light, view))
        value = self.composed(response, albedos, light, view)
        # A ray goes straight through with the very share of light that does.
        weight = dr.select(passes, 1, dr.select(pdf > 0, value / maximum(pdf, 1e-30), 0))
        return DirectionSample(light=light, pdf=pdf, weight=weight, passes=passes)

    def pdf(self, light: Any, view: Any, footprint: Footprint) -> Any:
        """Density of `sample` per solid angle, without delta: Float, 1/sr."""
        shares = self.shares(self.albedos(view, footprint), view, footprint)
        return self.response_and_pdf(shares, light, view, footprint)[1]

    def shares(self, albedos: FamilyAlbedos, view: Any, footprint: Footprint) -> Shares:
        """How directions are drawn for footprints that views see, whatever the light."""
        estimator, place = self.estimator(array_types(view.x)), self._place(footprint, view)
        energy = energy_of(estimator, place, energies_of(albedos))
        hole = self._hole(view, footprint, estimator.hole(place))
        return shares_of(place, albedos, energy, self.straight_through(view, hole), self._sheen)

    def response_and_pdf(
        self, shares: Shares, light: Any, view: Any, footprint: Footprint
    ) -> tuple[Response, Any]:
        """`evaluate` and `pdf` at the cost of little more than one."""
        response, of_groups = self._answers([light], view, footprint, shares)[0]
        return response, self._density(shares, of_groups, light, view)

    def hole(self, view: Any, footprint: Footprint) -> Any:
        """The hole of `evaluate`, which no light changes: Float."""
        far = self.estimator(array_types(view.x)).hole(self._place(footprint, view))
        return self._hole(view, footprint, far)

    def _hole(self, view: Any, footprint: Footprint, far: Any) -> Any:
        far_share = self._far_share(footprint.spread_side)
        return dr.lerp(near_hole(*self._points(footprint, far_share), view, footprint), far, far_share)

    def _answers(
        self,
        lights: Sequence[Any],
        view: Any,
        footprint: Footprint,
        shares: Shares | None,
        active: Any = True,
    ) -> list[tuple[Response, Any]]:
        """The response to each light, and with shares the groups' part of its density.

        Args:
            active: lanes where more is wanted than the hole, which is all that may be left out.
        """
        far_share = self._far_share(footprint.spread_side)
        far = self.far(lights, view, footprint, (far_share > 0) & active, shares)
        near = near_responses(*self._points(footprint, far_share), lights, view, footprint)
        return [
            (_mixed(close, response, far_share), of_groups)
            for close, (response, of_groups) in zip(near, far, strict=True)
        ]

    def _points(self, footprint: Footprint, far_share: Any) -> tuple[PointModel, Any]:
        """The point model for close-ups of footprints, and how many points they take."""
        threads, points = self._threads_and_points(footprint, far_share)
        return searched_for(self.point_model, threads), points

    def _threads_and_points(self, footprint: Footprint, far_share: Any) -> tuple[Any, Any]:
        """Side of footprints in threads, and how many points close-ups take."""
        size = footprint.spread_side
        threads = size * self._scale(array_types(size))[0]
        return threads, points_of(threads, far_share, footprint.samples)

    def _far_share(self, size: Any) -> Any:
        """How much the groups count, 0 to 1, smooth in the logarithm of the footprint's side."""
        low, high = (math.log2(bound) for bound in _HAND_OVER)
        level = dr.log2(maximum(size, _NEAREST)) - self._scale(array_types(size))[1]
        share = clip((level - low) * (1 / (high - low)), 0, 1)
        return dr.square(share) * dr.fma(-2, share, 3)

    def _scale(self, types: ArrayTypes) -> tuple[Any, Any]:
        """Threads a millimetre, and log2 of the length that the hand-over is measured by: opaque."""
        if types.Float not in self._scales:
            unit = max(self._thread, _SQUARE_SHARE * self.tables.base_size)
            numbers = 1 / self._thread, math.log2(unit)
            per_thread, level = (dr.opaque(types.Float, number) for number in numbers)
            self._scales[types.Float] = per_thread, level
        return self._scales[types.Float]

    def _place(self, footprint: Footprint, view: Any) -> Place:
        types = array_types(view.x)
        back = types.Bool(view.z < 0)
        return self.estimator(types).place(footprint, to_face_frame(view, back), back)

    def far(
        self, lights: Sequence[Any], view: Any, footprint: Footprint, active: Any, shares: Shares | None
    ) -> list[tuple[Response, Any]]:
        """What the groups say of each light, without points, and of its density where shares are given.

        Args:
            active: lanes where responses are wanted; densities are computed in all.
        """
        types = array_types(view.x)
        estimator, place = self.estimator(types), self._place(footprint, view)
        seen = place.view
        facing = [to_face_frame(light, place.back) for light in lights]
        nodes = [estimator.light_nodes(place, light) for light in facing]
        halves = [half_vector(light, seen) for light in facing]
        active = types.Bool(active) if shares is None else types.Bool(True)

        def add(pair: Any, total: Any, *sums: Any) -> tuple[Any, ...]:
            found = estimator.seen(place, pair)
            added = list(sums)
            for number, (light, at, half) in enumerate(zip(facing, nodes, halves, strict=True)):
                components = estimator.components(found, place, at, pair, light, half)
                for word, (diffuse, specular) in zip(found, components, strict=True):
                    parts = [dr.select(word.is_warp, diffuse, 0), dr.select(word.is_warp, 0, diffuse)]
                    parts += [dr.select(word.is_warp, specular, 0), dr.select(word.is_warp, 0, specular)]
                    of_groups: Any = 0
                    if shares is not None:
                        energies = energies_where(word.is_warp, shares)
                        for weight, lobe in zip(word.weights, word.lobes, strict=True):
                            of_groups = of_groups + group_density(
                                weight, lobe, energies, light, seen, self._blend
                            )
                    for place_of, part in enumerate((*parts, of_groups), 5 * number):
                        added[place_of] = added[place_of] + part
            return pair + 1, total + sum(sum(word.weights) for word in found), *added

        width = dr.width(view, list(lights), footprint.centre, footprint.duv_dx)
        start = (
            dr.zeros(types.UInt32, width),
            *(dr.zeros(types.Float, width) for _ in range(1 + 5 * len(lights))),
        )
        _, total, *sums = dr.while_loop(
            start, lambda pair, *rest: active & (pair < estimator.pairs), add, label="lobes: groups"
        )
        hole = estimator.hole(place)
        share = (1 - hole) * dr.rcp(maximum(total, SMALLEST_WEIGHT))
        answers = []
        for first in range(0, len(sums), 5):
            diffuse_warp, diffuse_weft, specular_warp, specular_weft = (
                part * share for part in sums[first : first + 4]
            )
            response = Response(diffuse_warp, diffuse_weft, specular_warp, specular_weft, hole)
            answers.append((response, sums[first + 4]))
        return answers

    def _density(self, shares: Shares, of_groups: Any, light: Any, view: Any) -> Any:
        back = array_types(view.x).Bool(view.z < 0)
        return density(shares, of_groups, to_face_frame(light, back), to_face_frame(view, back), self._sheen)

    def estimator(self, types: ArrayTypes) -> Estimator:
        """The tables on one backend, uploaded once."""
        if types.Float not in self._estimators:
            appearance = self.fabric.appearance()
            self._estimators[types.Float] = Estimator(
                self.tables,
                self.fabric.layout().size,
                (appearance.warp.roughness, appearance.weft.roughness),
                appearance.optical_depth,
                types,
            )
        return self._estimators[types.Float]


def tables_of(fabric: Fabric, groups: int) -> LobeTables:
    """Bakes the tables of a fabric with so many groups of each family, 1 to 64, on average.

    Raises:
        InputError: fewer or more groups.
    """
    if not 1 <= groups <= MOST_GROUPS:
        raise InputError(f"groups = {groups} is out of range: use 1 to {MOST_GROUPS}.")
    geometry = YarnGeometry(fabric.layout())
    return bake_tables(geometry, fabric.appearance().diffuse_blend, groups, llvm_float())


def _faded(albedos: Albedos, varied: Albedos, share: Any) -> Albedos:
    return Albedos(
        dr.lerp(albedos.diffuse_reflect, varied.diffuse_reflect, share),
        dr.lerp(albedos.diffuse_transmit, varied.diffuse_transmit, share),
        dr.lerp(albedos.specular_reflect, varied.specular_reflect, share),
        dr.lerp(albedos.specular_transmit, varied.specular_transmit, share),
    )


def _mixed(near: Response, far: Response, share: Any) -> Response:
    return Response(
        dr.lerp(near.diffuse_warp, far.diffuse_warp, share),
        dr.lerp(near.diffuse_weft, far.diffuse_weft, share),
        dr.lerp(near.specular_warp, far.specular_warp, share),
        dr.lerp(near.specular_weft, far.specular_weft, share),
        dr.lerp(near.hole, far.hole, share),
    )
