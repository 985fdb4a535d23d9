"""The mean of the point model over many points of the footprint: slow, and right in the mean.

Each point's view ray is followed with exact parallax, its shadows are searched. A direction is drawn at one
of the points; its density is the mean of all points' densities, and its weight value over that.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any, Self, final

import drjit as dr

from loomlight.aggregate.components import components, light_visibility
from loomlight.assets.loom_file import LoomFile
from loomlight.assets.sources import Source
from loomlight.core.arrays import Color3, Float, Mask, UInt, Vec2, Vec3
from loomlight.core.backend import ArrayTypes, array_types, clip, maximum, minimum
from loomlight.core.errors import InputError
from loomlight.core.footprint import Footprint
from loomlight.fabric.fabric import Fabric
from loomlight.models.between_yarns import Bounced
from loomlight.models.fabric_model import FabricModel, fabric_in_loom, fabric_source
from loomlight.models.interface import Option
from loomlight.models.point import families_of
from loomlight.models.random_numbers import hashed, uniform
from loomlight.models.separable import Components, Evaluation, FamilyAlbedos, SeparableBsdf
from loomlight.scattering.point import YarnScattering
from loomlight.scattering.yarn_point import Albedos, DirectionSample, YarnPoint
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.search import upload_extent

DEFAULT_POINTS = 32
MAX_POINTS = 1 << 16
# The plastic number's powers, in units of 2⁻³²: multiples of them fill a square evenly (Roberts 2018).
_SHARES = (3242174889, 2447445414)


@dataclass
class _Shown:
    """Means over the points of all that no light changes.

    Attributes:
        hole: share of points that are holes.
        warp_share, weft_share: shares of points that show each family.
        albedos: sums over each family's points, over the number of all points.
        bounced: albedos of light between yarns; None without.
    """

    hole: Float
    warp_share: Float
    weft_share: Float
    albedos: FamilyAlbedos
    bounced: Bounced | None


@final
class SamplesBsdf(SeparableBsdf):
    """Means over so many points of footprints."""

    def __init__(
        self, model: YarnScattering, points: int, view: Vec3, footprint: Footprint, tint: Color3 | None
    ) -> None:
        super().__init__(view, footprint, model.appearance.sheen)
        self._model = model
        self._points = points
        self._tint = tint
        # One pattern for all footprints may fall in step with the weave: a mean over pixels would be wrong.
        self._seed = hashed(view, footprint, model.surface.size)

    @cached_property
    def _shown(self) -> _Shown:
        def measure(point: YarnPoint) -> _Shown:
            one = array_types(point.x).Float(1)
            return _Shown(
                dr.select(point.hole, one, 0),
                dr.select(point.is_warp & ~point.hole, one, 0),
                dr.select(~point.is_warp & ~point.hole, one, 0),
                families_of(point),
                point.bounced,
            )

        found: _Shown = self._mean(measure)
        return found

    @property
    def hole(self) -> Float:
        """Share of the points that are holes."""
        return self._shown.hole

    @cached_property
    def albedos(self) -> FamilyAlbedos:
        """Mean albedos of the points that show each family; 0 where none does."""
        shown = self._shown

        def of_family(sums: Albedos, points: Float) -> Albedos:
            scale = dr.select(points > 0, dr.rcp(maximum(points, 1e-9)), 0)
            found: Albedos = _combined(lambda part: part * scale, sums)
            return found

        return FamilyAlbedos(
            of_family(shown.albedos.warp, shown.warp_share), of_family(shown.albedos.weft, shown.weft_share)
        )

    def bounced(self, evaluation: Evaluation) -> Bounced | None:
        """Mean albedos of light between yarns of the points."""
        del evaluation
        return self._shown.bounced

    def evaluate(self, light: Vec3, active: Mask = True) -> Evaluation:
        """Mean components over the points."""
        return Evaluation(self._mean(lambda point: self._components(point, light, active)), self.hole)

    def pdf(self, light: Vec3) -> Float:
        """Density of `sample` per solid angle, without delta, 1/sr."""
        return self._mean(lambda point: self._model.pdf(point, light, self.view))

    def value_and_pdf(self, light: Vec3, active: Mask = True) -> tuple[Color3, Float]:
        """Both in one pass over the points."""
        found, pdf = self._mean(
            lambda point: (
                self._components(point, light, active),
                self._model.pdf(point, light, self.view),
            )
        )
        return self.composed(Evaluation(found, self.hole), light), pdf

    def sample(self, choice: Float, u: Vec2) -> DirectionSample:
        """A light direction at one of the points, straight through holes in proportion to them."""
        types = array_types(self.view.x)
        scaled = choice * self._points
        number = minimum(types.UInt32(scaled), self._points - 1)
        # What is left of the number after the choice of a point is uniform again.
        rest = clip(scaled - types.Float(number), 0, dr.one_minus_epsilon(types.Float))
        # Directions alone are wanted: an inactive lane searches no shadow for its weight.
        drawn = self._model.sample(self._point(number), self.view, rest, u, active=False)
        value, density = self.value_and_pdf(drawn.light)
        pdf = dr.select(drawn.is_null, self.null_transmission, density)
        # A ray goes straight through with the very share of light that does.
        weight = dr.select(drawn.is_null, 1, dr.select(pdf > 0, value / maximum(pdf, 1e-30), 0))
        return DirectionSample(light=drawn.light, pdf=pdf, weight=weight, is_null=drawn.is_null)

    def _components(self, point: YarnPoint, light: Vec3, active: Mask) -> Components:
        visible = self._model.visibility(point, light, active)
        return Components.of(
            components(self._model.appearance, point, light, self.view, visible),
            light_visibility(point, visible),
        )

    def _point(self, number: UInt) -> YarnPoint:
        types = array_types(self.view.x)
        place = self.footprint.centre
        if self._points > 1:
            s, t = (
                uniform(self._seed, axis) + types.Float(number * share >> 8) * 2**-24
                for axis, share in enumerate(_SHARES)
            )
            place = self.footprint.at(s - dr.floor(s) - 0.5, t - dr.floor(t) - 0.5)
        return self._model.locate(place.x, place.y, self.view, tint=self._tint)

    def _mean(self, measure: Callable[[YarnPoint], Any]) -> Any:
        """Mean over the points of what `measure` finds: Floats, or dataclasses and tuples of them."""
        types = array_types(self.view.x)
        first = measure(self._point(types.UInt32(0)))
        if self._points == 1:
            return first

        def add(number: UInt, total: Any) -> tuple[Any, Any]:
            return number + 1, _combined(lambda a, b: a + b, total, measure(self._point(number)))

        start = types.UInt32(1), first
        _, total = dr.while_loop(start, lambda number, total: number < self._points, add)
        return _combined(lambda part: part * (1 / self._points), total)


def _combined(operation: Callable[..., Any], *trees: Any) -> Any:
    """`operation` on the arrays of equal dataclasses and tuples, leaf by leaf."""
    if trees[0] is None:
        return None
    if isinstance(trees[0], tuple):
        return tuple(_combined(operation, *parts) for parts in zip(*trees, strict=True))
    if hasattr(trees[0], "__dataclass_fields__"):
        names = [part.name for part in fields(trees[0])]
        return type(trees[0])(
            **{name: _combined(operation, *(getattr(tree, name) for tree in trees)) for name in names}
        )
    return operation(*trees)


@final
class SampledModel(FabricModel):
    """So many points, spread evenly over the footprint in a pattern that each footprint moves elsewhere."""

    name = "samples"
    filters = True
    conserves_energy = True
    options = (Option("points", int, f"a whole number from 1 to {MAX_POINTS}", 1, MAX_POINTS),)

    def __init__(self, fabric: Fabric, points: int = DEFAULT_POINTS) -> None:
        """A model of `points` points, 1 to 65536.

        Raises:
            InputError: fewer or more points.
        """
        super().__init__(fabric)
        if not 1 <= points <= MAX_POINTS:
            raise InputError(f"points = {points} is out of range: use 1 to {MAX_POINTS}.")
        self.points = points
        self.point_model = YarnScattering(YarnGeometry(fabric.layout()), fabric.appearance())

    @classmethod
    def for_source(cls, source: Source, points: int = DEFAULT_POINTS) -> Self:
        """The model of a fabric with so many points, 32 by default; nothing is baked.

        Raises:
            InputError: no fabric, or fewer or more points than 1 to 65536.
        """
        return cls(fabric_source(source, cls.name), points)

    def to_loom(self) -> LoomFile:
        """The fabric and the number of points."""
        return LoomFile(model=self.name, source=self.fabric, settings={"points": self.points})

    @classmethod
    def from_loom(cls, loom: LoomFile) -> Self:
        """The model of the fabric with as many points as the file says.

        Raises:
            InputError: another model's file, or a number of points that cannot be.
        """
        return cls(fabric_in_loom(loom, cls.name), loom.setting("points", int))

    def with_source(self, source: Source) -> Self:
        """The model of another fabric with as many points."""
        return type(self).for_source(source, self.points)

    def at(
        self, view: Vec3, footprint: Footprint, tint: Color3 | None = None, active: Mask = True
    ) -> SamplesBsdf:
        """The points of footprints as views see them."""
        del active
        return SamplesBsdf(self.point_model, self.points, view, footprint, tint)

    def upload(self, types: ArrayTypes) -> None:
        """Puts the yarns and their albedos on a backend."""
        surface = self.point_model.surface
        assert isinstance(surface, YarnGeometry)
        surface.upload(types)
        upload_extent(surface, types)
        self.point_model.parameters(types)
