"""The point model as a multi-scale model: yarn points of the footprint, as view rays meet them.

- `point` looks at the one at the footprint's centre, whatever the size: exact there, aliased where threads
  are small.
- `samples` is the same with so many points spread over the footprint, in place of the one at its centre:
  slow, and right in the mean. Each view ray is followed with exact parallax, its shadows are searched.
  A direction is drawn at one of the points; its density is the mean of all points'.
"""

from __future__ import annotations

from collections.abc import Callable
from copy import copy
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, ClassVar, Self, final

import drjit as dr
import numpy as np

from loomlight.aggregate.components import components, light_visibility
from loomlight.core.arrays import Color3, Float, Mask, UInt, Vec2, Vec3
from loomlight.core.backend import ArrayTypes, array_types, clip, maximum, minimum
from loomlight.core.fleet import Report
from loomlight.core.footprint import Footprint
from loomlight.core.settings import setting
from loomlight.fabric.fabric import Fabric
from loomlight.models.between_yarns import Bounced
from loomlight.models.fabric_model import (
    ALBEDOS,
    FAMILIES,
    FabricModel,
    colour_parameters,
    fabric_in_loom,
    fabric_source,
    number_of,
    parameter_of,
    recolour,
)
from loomlight.models.interface import FootprintBsdf, Values
from loomlight.models.options import Options
from loomlight.models.random_numbers import hashed, uniform
from loomlight.models.separable import Components, Evaluation, FamilyAlbedos, SeparableBsdf
from loomlight.scattering.grazing import Grazing
from loomlight.scattering.point import (
    Albedos,
    DirectionSample,
    Tint,
    YarnPoint,
    YarnScattering,
    to_face_frame,
)
from loomlight.sources.kinds import Source
from loomlight.sources.loom_file import LoomFile
from loomlight.yarn.geometry import DetachedSurface
from loomlight.yarn.layout import ClothLayout, primitive_cell
from loomlight.yarn.rays import upload_extent
from loomlight.yarn.stack import cloth_geometry
from loomlight.yarn.visibility import first_hit

_BENDS = ("height_scale", "twist")
_SHEEN = ("sheen.strength", "sheen.roughness")
# What the rise of highlights follows from, of each family.
_RISE = ("specular_grazing", "roughness")
DEFAULT_POINTS = 32
MAX_POINTS = 1 << 16


@final
class PointBsdf(SeparableBsdf):
    """The yarn points that view rays through the centres of footprints meet."""

    def __init__(
        self, model: YarnScattering, view: Vec3, footprint: Footprint, tint: Tint | None, active: Mask
    ) -> None:
        super().__init__(view, footprint, model.appearance.sheen, model.grazing)
        self._model = model
        centre, back = footprint.centre, array_types(view.x).Bool(view.z < 0)
        # Derivatives of where a ray meets yarn would be wrong as well as dear.
        with dr.suspend_grad():
            seen = to_face_frame(view, back)
            hit = first_hit(model.surface, centre.x, centre.y, seen, back, active, model.quality)
        size = footprint.spread_side if model.has_detail else None
        self.point = model.at(hit.x, hit.y, back, hit.hole, size, tint, (seen, hit.height))

    @cached_property
    def hole(self) -> Float:
        """1 where the ray passes through, else 0."""
        return dr.select(self.point.hole, array_types(self.view.x).Float(1), 0)

    @property
    def null_transmission(self) -> Float:
        """1 in a hole, less under sheen, else 0."""
        return self._model.straight_through(self.point, self.view)

    @property
    def diffuse_reflectance(self) -> Color3:
        """The diffuse albedo of the yarn that shows."""
        return dr.select(self.point.hole, 0, self.point.albedos.diffuse_reflect)

    @property
    def shown(self) -> tuple[Float, Float]:
        """1 of the family whose yarn shows, 0 of the other one; both 0 in holes."""
        types = array_types(self.view.x)
        warp, weft = (self.point.is_warp & ~self.point.hole, ~self.point.is_warp & ~self.point.hole)
        return dr.select(warp, types.Float(1), 0), dr.select(weft, types.Float(1), 0)

    @property
    def roughness(self) -> Float:
        """α of the yarn that shows."""
        return self.point.roughness

    @property
    def albedos(self) -> FamilyAlbedos:
        """Albedos of the thread that shows; 0 for the other family."""
        return families_of(self.point)

    def evaluate(self, light: Vec3, active: Mask = True) -> Evaluation:
        """Components of the yarn point, of one family."""
        visible = self._model.visibility(self.point, light, active)
        found = Components.of(
            components(self._model.appearance, self.point, light, self.view, visible),
            light_visibility(self.point, visible),
        )
        return Evaluation(found, self.hole)

    def bounced(self, evaluation: Evaluation) -> Bounced | None:
        """Albedos of light between yarns at the point."""
        del evaluation
        bounced: Bounced | None = self.point.bounced
        return bounced

    def value(self, light: Vec3, active: Mask = True) -> Color3:
        """f·cos with derivatives, 1/sr; 0 in lanes that are not active."""
        return self._model.evaluate(self.point, light, self.view, active)

    def value_and_null_transmission(self, light: Vec3, active: Mask = True) -> tuple[Color3, Float]:
        """Both."""
        return self.value(light, active), self.null_transmission

    def pdf(self, light: Vec3) -> Float:
        """Density of `sample` per solid angle, without delta, 1/sr."""
        return self._model.pdf(self.point, light, self.view)

    def sample(self, choice: Float, u: Vec2) -> DirectionSample:
        """A light direction by one of the yarn's lobes, straight through in holes."""
        return self._model.sample(self.point, self.view, choice, u)


def families_of(point: YarnPoint) -> FamilyAlbedos:
    """Albedos of the thread that a point shows for its family, 0 for the other; 0 in holes."""
    types = array_types(point.x)

    def family(shows: Mask) -> Albedos:
        share = dr.select(shows & ~point.hole, types.Float(1), 0)
        return Albedos(*(getattr(point.albedos, name) * share for name in ALBEDOS))

    return FamilyAlbedos(family(point.is_warp), family(~point.is_warp))


@final
class SamplesBsdf(FootprintBsdf):
    """Means over so many points of footprints, each with its own albedos."""

    def __init__(self, model: SampledModel, view: Vec3, footprint: Footprint, tint: Tint | None) -> None:
        super().__init__(view, footprint)
        self._model, self._points, self._tint = model.point_model, model.options.points, tint
        self._irregular = model.irregular
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

    @property
    def roughness(self) -> Float:
        """Mean α of the yarn at the points, but those that are holes."""
        total, seen = self._mean(
            lambda point: [dr.select(point.hole, 0, part) for part in (point.roughness, 1)]
        )
        return total / maximum(seen, 1e-6)

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
        place = self._irregular.place(place)
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


class YarnPointModel(FabricModel):
    """A model that looks at points of the footprint.

    Scene parameters: ``warp.roughness``, ``warp.height_scale``, ``warp.twist`` (radians), the albedos
    ``warp.diffuse_reflect`` …, ``warp.specular_grazing`` and ``warp.color``, the same of ``weft``;
    ``sheen.strength`` and ``sheen.roughness`` where there is sheen. Where threads of a family differ, they
    are arrays ``warp.colors`` and ``warp.albedos``: a row a thread, four albedos a row, four numbers an
    albedo of which the last is unused. Of `point` all but colours and the rise towards grazing are
    differentiable; shadows and holes are held fixed.
    """

    conserves_energy = True

    def __init__(self, fabric: Fabric, options: Options | None = None) -> None:
        super().__init__(fabric)
        self.options = options or self.options_class()
        self._geometry = cloth_geometry(fabric.layout())
        self.point_model = YarnScattering(
            DetachedSurface(self._geometry), fabric.appearance(), irregular=self.irregular
        )

    @classmethod
    def for_source(cls, source: Source, options: Options | None = None, report: Report | None = None) -> Self:
        """The model of a fabric; nothing is baked.

        Raises:
            InputError: no fabric.
        """
        del report
        return cls(fabric_source(source, cls.name), options)

    def to_loom(self) -> LoomFile:
        """The fabric and the options."""
        return LoomFile(model=self.name, source=self.fabric, settings=self.options.stored())

    @classmethod
    def from_loom(cls, loom: LoomFile) -> Self:
        """The model of the fabric with the options that the file says.

        Raises:
            InputError: another model's file, or an option that cannot be.
        """
        return cls(fabric_in_loom(loom, cls.name), cls.options_class.of_loom(loom))

    def upload(self, types: ArrayTypes) -> None:
        """Puts the yarns and their parameters on a backend."""
        super().upload(types)
        self._geometry.upload(types)
        upload_extent(self.point_model.surface, types)
        self.point_model.parameters(types)
        self.point_model.detail(types)

    def parameters(self, types: ArrayTypes) -> Values:
        """Arrays of the model: with one that is `bound_to` them, edits show at once, with derivatives."""
        found: dict[str, Any] = {}
        families = self.point_model.parameters(types)
        for number, (name, family) in enumerate(zip(FAMILIES, families, strict=True)):
            found[f"{name}.roughness"] = family.roughness
            for bend in _BENDS:
                value = getattr(self._geometry, bend)[number]
                found[f"{name}.{bend}"] = dr.opaque(types.Float, float(value))
            if family.table is not None:
                found[f"{name}.albedos"] = family.table
            else:
                found |= {f"{name}.{part}": value for part, value in zip(ALBEDOS, family.shared, strict=True)}
        if self.point_model.sheen is not None:
            # Literals until they are edited: the sheen's closed form is cheaper with a literal roughness.
            for name, value in zip(_SHEEN, self.point_model.sheen, strict=True):
                found[name] = types.Float(float(value))
        shown = {name: parameter_of(name, value, differentiable=True) for name, value in found.items()}
        for name in FAMILIES:
            gain = getattr(self.fabric.appearance(), name).specular_grazing
            shown[f"{name}.{_RISE[0]}"] = parameter_of(_RISE[0], types.Float(gain))
        return {**shown, **colour_parameters(self.fabric, types)}

    def bound_to(self, values: Values) -> Self:
        """The model that reads parameters from arrays; derivatives of these may be switched on later."""
        bound, geometry, point_model = copy(self), copy(self._geometry), copy(self.point_model)
        arrays = {name: parameter.value for name, parameter in values.items()}
        geometry.height_scale, geometry.twist = (
            (arrays[f"warp.{bend}"], arrays[f"weft.{bend}"]) for bend in _BENDS
        )
        point_model.surface = DetachedSurface(geometry)
        if point_model.sheen is not None:
            strength, roughness = (arrays[name] for name in _SHEEN)
            point_model.sheen = strength, roughness
        bound._geometry, bound.point_model = geometry, point_model
        return bound

    def updated(self, values: Values, changed: frozenset[str]) -> Self:
        """The same model, whose albedos follow edited colours; another one if highlights rise otherwise."""
        changed |= recolour(self.fabric, values, changed)
        types = array_types(values["warp.roughness"].value)
        for name, family in zip(FAMILIES, self.point_model.parameters(types), strict=True):
            if f"{name}.albedos" in changed:
                family.follow_table()
        if not changed & {f"{name}.{part}" for name in FAMILIES for part in _RISE}:
            return self
        gain, roughness = (
            sum(number_of(values[f"{name}.{part}"]) for name in FAMILIES) / 2 for part in _RISE
        )
        grazing = Grazing.of(gain, roughness)
        model, model.point_model = copy(self), copy(self.point_model)
        if gain > 0:
            # The loss follows the roughness, which optimisers edit at every step: a literal is compiled.
            grazing = Grazing(gain, dr.opaque(types.Float, grazing.loss))
        model.point_model.grazing = grazing
        return model

    def literals(self) -> tuple[float, ...]:
        """How highlights rise."""
        return (self.point_model.grazing.gain,)


@final
class PointModel(YarnPointModel):
    """One point of the footprint, at its centre: exact there, aliased where threads are small."""

    name = "point"
    filters = False

    def among_irregular(self, footprint: Footprint) -> Footprint:
        """The one point that is looked at moves, whatever the size."""
        return replace(footprint, centre=self.irregular.place(footprint.centre))

    def at(
        self, view: Vec3, footprint: Footprint, tint: Tint | None = None, active: Mask = True
    ) -> PointBsdf:
        """The yarn points at the centres of footprints as views see them."""
        return PointBsdf(self.point_model, view, footprint, tint, active)


@dataclass(frozen=True, kw_only=True)
class SamplesOptions(Options):
    """Options of `samples`."""

    title: ClassVar[str] = "option of samples"

    points: int = setting(DEFAULT_POINTS, "Points of each footprint.", low=1, high=MAX_POINTS, stored=True)


@final
class SampledModel(YarnPointModel):
    """So many points of each footprint, spread evenly over the primitive cell of its pattern."""

    name = "samples"
    filters = True
    # Weights may add up to a little more than 1.
    estimates = True
    options_class = SamplesOptions
    options: SamplesOptions

    def among_irregular(self, footprint: Footprint) -> Footprint:
        """Each point moves by itself; see `SamplesBsdf`."""
        return footprint

    @cached_property
    def cell(self) -> PrimitiveCell:
        """The cell of the pattern, which footprints repeat."""
        return PrimitiveCell(self.fabric.layout())

    def at(
        self, view: Vec3, footprint: Footprint, tint: Tint | None = None, active: Mask = True
    ) -> SamplesBsdf:
        """The points of footprints as views see them."""
        del active
        return SamplesBsdf(self, view, footprint, tint)

    def upload(self, types: ArrayTypes) -> None:
        """Puts the yarns, their parameters and the cell of their pattern on a backend."""
        super().upload(types)
        self.cell.on(types)

    def parameters(self, types: ArrayTypes) -> Values:
        """Those of all; no derivatives go through the loop over the points."""
        found = super().parameters(types)
        return {name: replace(parameter, differentiable=False) for name, parameter in found.items()}


# ------------------------------------------------------------------------------------ places in a footprint
# Places of points in footprints, stratified over the pattern's primitive cell.
#
# What a cloth does to light repeats with its primitive cell (`yarn/layout.py`). A point c of the cell, of
# area C, has n(c) translates in a footprint P, so ∫_P f dx / |P| = C/|P| ∫ n(c) f(c) dc / C. Points c
# spread evenly over the cell, each moved to one of its n(c) translates and weighed by n(c)·C/|P|, estimate
# the mean over the footprint without bias, whatever does not repeat (colours, chance) included, and see
# every part of the pattern equally often. Footprints of few cells take points spread over themselves.
#
# Translates are counted row by row of the cell's first shift. Footprints of more rows are cut into equal
# parallelograms, of which each point takes one.


# Cells of the smallest footprint whose points are spread over the cell: with fewer, weights differ too much.
MIN_CELLS = 1.5
# Rows of translates that an edge of a part passes; a part has at most twice as many.
_EDGE_ROWS = 3
# An edge along the rows is turned by so many rows: a hundred-thousandth of a part is missed.
_LEAST_SLOPE = 1e-5
# Powers of the root of x⁶ = x + 1, in units of 2⁻³²: multiples fill a cube evenly (Roberts 2018). Two of its
# dimensions are the place in the cell, two the part, one the translate.
_SHARES = tuple(round(2**32 * 1.1347241384015194**-power) for power in range(1, 6))


class PrimitiveCell:
    """The primitive cell of one cloth on any backend; `shifts` are its two shifts [2, 2], millimetres."""

    def __init__(self, layout: ClothLayout) -> None:
        self.shifts = primitive_cell(layout)
        self._uploaded: dict[type, list[Any]] = {}

    def on(self, types: ArrayTypes) -> list[Any]:
        """Matrices from cells to millimetres and back, four numbers each, row by row."""
        if types.Float not in self._uploaded:
            numbers = np.stack([self.shifts.T, np.linalg.inv(self.shifts.T)]).ravel()
            self._uploaded[types.Float] = [dr.opaque(types.Float, float(number)) for number in numbers]
        return self._uploaded[types.Float]


class FootprintPlaces:
    """Points of footprints and their weights; a seed a footprint moves them."""

    def __init__(self, cell: PrimitiveCell, footprint: Footprint, seed: UInt) -> None:
        types = array_types(footprint.centre.x)
        matrices = cell.on(types)
        self._footprint, self._to_mm, to_cells = footprint, matrices[:4], matrices[4:]
        self._starts = [uniform(seed, dimension) for dimension in range(len(_SHARES))]
        edges = [_times(to_cells, edge) for edge in (footprint.duv_dx, footprint.duv_dy)]
        self.on_cell = abs(edges[0].x * edges[1].y - edges[0].y * edges[1].x) >= MIN_CELLS
        self._counts = [maximum(dr.ceil(abs(edge.y) * (1 / _EDGE_ROWS)), 1) for edge in edges]
        parts = [edge / count for edge, count in zip(edges, self._counts, strict=True)]
        self._edges = first, second = [
            types.Vector2(edge.x, dr.copysign(maximum(abs(edge.y), _LEAST_SLOPE), edge.y)) for edge in parts
        ]
        area = first.x * second.y - first.y * second.x
        self._cells = abs(area)
        self._corner = _times(to_cells, footprint.centre)
        for edge, count in zip(self._edges, self._counts, strict=True):
            self._corner -= 0.5 * count * edge
        # Of a part: where its rows begin, and the two strips between opposite edges as x of a row at y.
        self._bottom = minimum(first.y, 0) + minimum(second.y, 0)
        self._strips = [(second.x / second.y, area / second.y), (first.x / first.y, -area / first.y)]

    def at(self, number: UInt) -> tuple[Vec2, Float]:
        """Place of a point, millimetres [2], and its weight."""
        types = array_types(self._cells)
        turns = [
            start + types.Float(number * share >> 8) * 2**-24
            for start, share in zip(self._starts, _SHARES, strict=True)
        ]
        u, v, *part, translate = (turn - dr.floor(turn) for turn in turns)
        corner = self._corner
        for share, count, edge in zip(part, self._counts, self._edges, strict=True):
            corner = corner + minimum(dr.floor(share * count), count - 1) * edge
        from_corner = types.Vector2(u, v) - corner
        from_corner -= dr.floor(from_corner)
        bottom = dr.ceil(self._bottom - from_corner.y)
        rows, total = [], types.Float(0)
        for row in range(2 * _EDGE_ROWS):
            y = from_corner.y + bottom + row
            begins = [dr.fma(slope, y, minimum(width, 0)) for slope, width in self._strips]
            end = minimum(*(low + abs(width) for low, (_, width) in zip(begins, self._strips, strict=True)))
            start = dr.ceil(maximum(*begins) - from_corner.x)
            count = maximum(dr.ceil(end - from_corner.x) - start, 0)
            rows.append((start, count))
            total += count
        chosen = minimum(dr.floor(translate * total), total - 1)
        x, y = types.Float(0), types.Float(0)
        for row, (start, count) in enumerate(rows):
            here = (chosen >= 0) & (chosen < count)
            x, y = dr.select(here, start + chosen, x), dr.select(here, bottom + row, y)
            chosen -= count
        place = _times(self._to_mm, corner + from_corner + types.Vector2(x, y))
        spread = self._footprint.at(u - 0.5, v - 0.5)
        return dr.select(self.on_cell, place, spread), dr.select(self.on_cell, total / self._cells, 1)


def _times(matrix: list[Any], vector: Vec2) -> Vec2:
    a, b, c, d = matrix
    return type(vector)(a * vector.x + b * vector.y, c * vector.x + d * vector.y)
