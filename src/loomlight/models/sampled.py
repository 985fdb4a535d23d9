"""Models that look at points of the footprint with the exact point model and average what they find.

Each point's view ray is followed with exact parallax, its shadows are searched. A direction is drawn at one
of the points; its density is the mean of all points' densities, and its weight value over that.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, fields
from typing import Any, final

import drjit as dr

from loomlight.aggregate.components import components
from loomlight.core.backend import array_types, clip, maximum, minimum
from loomlight.core.footprint import Footprint
from loomlight.fabric.fabric import Fabric
from loomlight.models.interface import FamilyAlbedos, Model, Response
from loomlight.scattering.point import Albedos, DirectionSample, PointModel, YarnPoint
from loomlight.yarn.geometry import YarnGeometry

# The plastic number's powers: points at multiples of these shares fill a square evenly (Roberts 2018).
_ACROSS, _ALONG = 0.7548776662466927, 0.5698402909980532


@dataclass
class _FamilySums:
    """Sums over points that show one family: how many, and their albedos."""

    points: Any
    albedos: Albedos


@dataclass
class _Sums:
    """Sums over the points of a footprint."""

    response: Response
    warp: _FamilySums
    weft: _FamilySums
    density: Any


class SampledModel(Model):
    """The mean of the point model over a fixed pattern of points in the footprint.

    Attributes:
        point_model: what each point is evaluated with; exact, sheen and variation included.
    """

    def __init__(self, fabric: Fabric) -> None:
        self.fabric = fabric
        self.point_model = PointModel(YarnGeometry(fabric.layout()), fabric.appearance())

    @property
    @abstractmethod
    def points(self) -> int:
        """How many points of a footprint are looked at, ≥ 1; a single one is the centre."""

    @final
    def evaluate(self, light: Any, view: Any, footprint: Footprint) -> Response:
        """Components and hole of footprints."""
        return self._over(view, footprint, lambda point: self._response(point, light, view))

    @final
    def albedos(self, view: Any, footprint: Footprint) -> FamilyAlbedos:
        """Mean albedos of the points that show each family; 0 where none does."""
        warp, weft = self._over(view, footprint, _shown)
        return FamilyAlbedos(_mean(warp), _mean(weft))

    @final
    def sample(self, view: Any, footprint: Footprint, choice: Any, u: Any) -> DirectionSample:
        """A light direction at one of the points, straight through holes in proportion to them."""
        types = array_types(view.x)
        scaled = choice * self.points
        number = minimum(types.UInt32(scaled), self.points - 1)
        # What is left of the number after the choice of a point is uniform again.
        rest = clip(scaled - types.Float(number), 0, dr.one_minus_epsilon(types.Float))
        point = self._point(number, view, footprint)
        # Directions alone are wanted: an inactive lane searches no shadow for its weight.
        drawn = self.point_model.sample(point, view, rest, u, active=False)
        sums = self._over(view, footprint, lambda at: self._everything(at, drawn.light, view))
        albedos = FamilyAlbedos(_mean(sums.warp), _mean(sums.weft))
        value = self.composed(sums.response, albedos, drawn.light, view)
        through = self.straight_through(view, sums.response.hole)
        pdf = dr.select(drawn.passes, through, sums.density)
        # A ray goes straight through with the very share of light that does.
        weight = dr.select(drawn.passes, 1, dr.select(pdf > 0, value / maximum(pdf, 1e-30), 0))
        return DirectionSample(light=drawn.light, pdf=pdf, weight=weight, passes=drawn.passes)

    @final
    def pdf(self, light: Any, view: Any, footprint: Footprint) -> Any:
        """Density of `sample` per solid angle, without delta: Float, 1/sr."""
        return self._over(view, footprint, lambda point: self.point_model.pdf(point, light, view))

    def _point(self, number: Any, view: Any, footprint: Footprint) -> YarnPoint:
        types = array_types(view.x)
        if self.points == 1:
            place = footprint.centre
        else:
            s, t = (types.Float(number) * share + 0.5 for share in (_ACROSS, _ALONG))
            place = footprint.at(s - dr.floor(s) - 0.5, t - dr.floor(t) - 0.5)
        return self.point_model.locate(place.x, place.y, view)

    def _response(self, point: YarnPoint, light: Any, view: Any) -> Response:
        types = array_types(view.x)
        visible = self.point_model.visibility(point, light)
        lobes = components(self.point_model.appearance, point, light, view, visible)
        diffuse_warp, diffuse_weft, specular_warp, specular_weft = lobes
        hole = dr.select(point.hole, types.Float(1), 0)
        return Response(diffuse_warp, diffuse_weft, specular_warp, specular_weft, hole)

    def _everything(self, point: YarnPoint, light: Any, view: Any) -> _Sums:
        warp, weft = _shown(point)
        return _Sums(self._response(point, light, view), warp, weft, self.point_model.pdf(point, light, view))

    def _over(self, view: Any, footprint: Footprint, measure: Callable[[YarnPoint], Any]) -> Any:
        """Mean over the points of what `measure` finds: Floats, or dataclasses and tuples of them."""
        types = array_types(view.x)
        first = measure(self._point(types.UInt32(0), view, footprint))
        if self.points == 1:
            return first

        def add(number: Any, total: Any) -> tuple[Any, Any]:
            found = measure(self._point(number, view, footprint))
            return number + 1, _combined(lambda a, b: a + b, total, found)

        start = types.UInt32(1), first
        _, total = dr.while_loop(start, lambda number, total: number < self.points, add)
        return _combined(lambda part: part * (1 / self.points), total)


def _shown(point: YarnPoint) -> tuple[_FamilySums, _FamilySums]:
    """What a point adds to the sums of (warp, weft)."""
    types = array_types(point.x)

    def family(shows: Any) -> _FamilySums:
        points = dr.select(shows, types.Float(1), 0)
        return _FamilySums(points, _combined(lambda part: part * points, point.albedos))

    return family(point.is_warp & ~point.hole), family(~point.is_warp & ~point.hole)


def _mean(sums: _FamilySums) -> Albedos:
    share = dr.select(sums.points > 0, dr.rcp(maximum(sums.points, 1e-6)), 0)
    return _combined(lambda part: part * share, sums.albedos)


def _combined(operation: Callable[..., Any], *trees: Any) -> Any:
    """`operation` on the arrays of equal dataclasses and tuples, leaf by leaf."""
    if isinstance(trees[0], tuple):
        return tuple(_combined(operation, *parts) for parts in zip(*trees, strict=True))
    if hasattr(trees[0], "__dataclass_fields__"):
        names = [part.name for part in fields(trees[0])]
        return type(trees[0])(
            **{name: _combined(operation, *(getattr(tree, name) for tree in trees)) for name in names}
        )
    return operation(*trees)
