"""The mean of the point model over so many points of each footprint: slow, and right in the mean.

Points lie at the places of `footprint_places.py`. Each point's view ray is followed with exact parallax, its
shadows are searched. A direction is drawn at one of the points; its density is the mean of all points'.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar, Self, final

import drjit as dr

from loomlight.core.arrays import Color3, Float, Mask, UInt, Vec2, Vec3
from loomlight.core.backend import ArrayTypes, array_types, clip, maximum, minimum
from loomlight.core.footprint import Footprint
from loomlight.core.settings import setting
from loomlight.fabric.fabric import Fabric
from loomlight.models.fabric_model import FabricModel, fabric_in_loom, fabric_source
from loomlight.models.footprint_places import FootprintPlaces, PrimitiveCell
from loomlight.models.interface import FootprintBsdf, Report
from loomlight.models.options import Options
from loomlight.models.random_numbers import hashed
from loomlight.scattering.point import DirectionSample, YarnPoint, YarnScattering
from loomlight.sources.kinds import Source
from loomlight.sources.loom_file import LoomFile
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.rays import upload_extent

DEFAULT_POINTS = 32
MAX_POINTS = 1 << 16


@final
class SamplesBsdf(FootprintBsdf):
    """Means over so many points of footprints, each with its own albedos."""

    def __init__(self, model: SampledModel, view: Vec3, footprint: Footprint, tint: Color3 | None) -> None:
        super().__init__(view, footprint)
        self._model, self._points, self._tint = model.point_model, model.options.points, tint
        # One pattern for all footprints may fall in step with the weave: a mean over pixels would be wrong.
        seed = hashed(view, footprint, self._model.surface.size)
        self._places = FootprintPlaces(model.cell, footprint, seed)

    @cached_property
    def hole(self) -> Float:
        """Share of the points that are holes."""
        return self._mean(lambda point: [dr.select(point.hole, array_types(point.x).Float(1), 0)])[0]

    @cached_property
    def null_transmission(self) -> Float:
        """Share of light that passes straight through the holes and the sheen over them."""
        return self._mean(lambda point: [self._model.straight_through(point, self.view)])[0]

    @property
    def diffuse_reflectance(self) -> Color3:
        """Mean diffuse albedo of the points, holes counted as 0."""
        return self._mean(lambda point: [dr.select(point.hole, 0, point.albedos.diffuse_reflect)])[0]

    def value_and_null_transmission(self, light: Vec3, active: Mask = True) -> tuple[Color3, Float]:
        """Both in one pass over the points; shadows are searched where light is reflected."""
        model, view = self._model, self.view
        value, through = self._mean(
            lambda point: [model.evaluate(point, light, view, active), model.straight_through(point, view)]
        )
        return value, through

    def value(self, light: Vec3, active: Mask = True) -> Color3:
        """Mean f·cos over the points, 1/sr."""
        return self.value_and_null_transmission(light, active)[0]

    def pdf(self, light: Vec3) -> Float:
        """Density of `sample` per solid angle, without delta, 1/sr."""
        return self._densities(light)[0]

    def sample(self, choice: Float, u: Vec2) -> DirectionSample:
        """A light direction at one of the points, straight through holes in proportion to them."""
        types = array_types(self.view.x)
        scaled = choice * self._points
        number = minimum(types.UInt32(scaled), self._points - 1)
        # What is left of the number after the choice of a point is uniform again.
        rest = clip(scaled - types.Float(number), 0, dr.one_minus_epsilon(types.Float))
        # Directions alone are wanted: an inactive lane searches no shadow for its weight.
        drawn = self._model.sample(self._point(number)[0], self.view, rest, u, active=False)
        density, passing = self._densities(drawn.light)
        pdf = dr.select(drawn.is_null, passing, density)
        value, through = self.value_and_null_transmission(drawn.light)
        weight = dr.select(pdf > 0, dr.select(drawn.is_null, through, value) / maximum(pdf, 1e-30), 0)
        return DirectionSample(light=drawn.light, pdf=pdf, weight=weight, is_null=drawn.is_null)

    def _densities(self, light: Vec3) -> list[Float]:
        """Density of `sample`, and its chance to pass through a hole: every point is drawn as often."""
        model, view = self._model, self.view
        return self._mean(
            lambda point: [model.pdf(point, light, view), model.straight_through(point, view)], weighed=False
        )

    def _point(self, number: UInt) -> tuple[YarnPoint, Float]:
        """A point and its weight."""
        place, weight = self._places.at(number)
        return self._model.locate(place.x, place.y, self.view, weight > 0, tint=self._tint), weight

    def _mean(self, measure: Callable[[YarnPoint], list[Any]], weighed: bool = True) -> list[Any]:
        """Means over the points of what `measure` finds."""

        def measured(number: UInt) -> list[Any]:
            point, weight = self._point(number)
            return [part * ((weight if weighed else 1) * (1 / self._points)) for part in measure(point)]

        def add(number: UInt, total: list[Any]) -> tuple[UInt, list[Any]]:
            return number + 1, [a + b for a, b in zip(total, measured(number), strict=True)]

        zero = array_types(self.view.x).UInt32(0)
        start = zero + 1, measured(zero)
        return list(dr.while_loop(start, lambda number, _: number < self._points, add)[1])


@dataclass(frozen=True, kw_only=True)
class SamplesOptions(Options):
    """Options of `samples`."""

    title: ClassVar[str] = "option of samples"

    points: int = setting(DEFAULT_POINTS, "Points of each footprint.", low=1, high=MAX_POINTS, stored=True)


@final
class SampledModel(FabricModel):
    """So many points of each footprint, spread evenly over the primitive cell of its pattern."""

    name = "samples"
    filters = True
    conserves_energy = True
    # Weights may add up to a little more than 1.
    estimates = True
    options_class = SamplesOptions
    options: SamplesOptions

    def __init__(self, fabric: Fabric, options: SamplesOptions | None = None) -> None:
        """A model of so many points."""
        super().__init__(fabric)
        self.options = options or SamplesOptions()
        self.point_model = YarnScattering(YarnGeometry(fabric.layout()), fabric.appearance())
        self.cell = PrimitiveCell(fabric.layout())

    @classmethod
    def for_source(
        cls, source: Source, options: SamplesOptions | None = None, report: Report | None = None
    ) -> Self:
        """The model of a fabric; raises InputError for what is none."""
        del report
        return cls(fabric_source(source, cls.name), options)

    def to_loom(self) -> LoomFile:
        """The fabric and the number of points."""
        return LoomFile(model=self.name, source=self.fabric, settings=self.options.stored())

    @classmethod
    def from_loom(cls, loom: LoomFile) -> Self:
        """The model of the fabric with as many points as the file says.

        Raises:
            InputError: another model's file, or a number of points that cannot be.
        """
        return cls(fabric_in_loom(loom, cls.name), SamplesOptions.of_loom(loom))

    def at(
        self, view: Vec3, footprint: Footprint, tint: Color3 | None = None, active: Mask = True
    ) -> SamplesBsdf:
        """The points of footprints as views see them."""
        del active
        return SamplesBsdf(self, view, footprint, tint)

    def upload(self, types: ArrayTypes) -> None:
        """Puts the yarns and their albedos on a backend."""
        super().upload(types)
        surface = self.point_model.surface
        assert isinstance(surface, YarnGeometry)
        surface.upload(types)
        upload_extent(surface, types)
        self.point_model.parameters(types)
        self.cell.on(types)
