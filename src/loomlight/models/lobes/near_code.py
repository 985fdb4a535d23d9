"""Close-ups as code of `lane_code`: `near.py` for batches of queries, whose rays are searched in company.

In a packet of lanes the longest search decides: of sixteen lanes seven idle on the way down to the cloth, ten
on the way to the light. Here the rays of a block of queries take turns. What is still searching after a few
samples is put on a pile, rays without those between that are done, and taken up again from its top, as many
at once as there are lanes. What was met is piled up too and shaded together. The searches and the formulas
are those of `yarn/visibility.py` and `scattering/`, written once.

Queries and answers are arrays [n]. A query is what `estimate_code` says, then the number of points (0: none),
side of the footprint in threads, and the share of what groups answer. Answers hold that, and are mixed with
the means over the points.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from llvmlite import ir

from loomlight.aggregate.components import lobes
from loomlight.core.arrays import fma, larger, lerp, opaque, rcp, select, smaller, uploaded
from loomlight.core.lane_code import Code, Vectors
from loomlight.core.lane_piles import Pile
from loomlight.core.lane_values import FLOAT, INDEX, TRUTH, WHOLE, Lanes, Vector
from loomlight.models.lobes.estimate_code import ANSWERS
from loomlight.models.lobes.estimate_code import QUERY as FAR_QUERY
from loomlight.models.lobes.near import MOST_POINTS, PLACES, quality_of
from loomlight.scattering.appearance import Appearance
from loomlight.scattering.point import YarnPoint, on_face, shadow_ray
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout
from loomlight.yarn.rays import Falling, FallingRay, Rising, RisingRay, falling_ray, rising_ray
from loomlight.yarn.search import SearchQuality, Trail, upload_extent
from loomlight.yarn.visibility import passes_through

QUERY = FAR_QUERY + 3
_POINTS, _THREADS, _FAR_SHARE = range(FAR_QUERY, QUERY)
# Vectors of a block: the more, the fewer lanes are idle as the last rays of a block are searched.
_VECTORS = 16
# Samples before rays are sorted for the first time, and from then on.
_FIRST_SAMPLES, _FIRST_TO_LIGHT, _SAMPLES = 2, 1, 2
_CHANNELS = ANSWERS


@dataclass(frozen=True)
class _Cloth:
    """What close-ups know of a fabric.

    Attributes:
        surface: where the threads lie.
        roughness: of warp and weft.
        diffuse_blend, optical_depth: see `Appearance`.
        places: of points, in shares of the footprint's edges, one after another: a table.
    """

    surface: YarnGeometry
    roughness: tuple[Any, Any]
    diffuse_blend: Any
    optical_depth: Any
    places: Any


def cloth_of(layout: ClothLayout, appearance: Appearance, types: Any) -> _Cloth:
    """What close-ups read of a fabric, on code that is written or as the numbers that it is to read."""
    # Of its own: what another geometry holds belongs to other code.
    surface = YarnGeometry(layout)
    surface.upload(types)
    upload_extent(surface, types)
    numbers = (
        appearance.warp.roughness,
        appearance.weft.roughness,
        appearance.diffuse_blend,
        appearance.optical_depth,
    )
    warp, weft, blend, depth = (opaque(types.Float, float(number)) for number in numbers)
    return _Cloth(surface, (warp, weft), blend, depth, uploaded(types.Float, np.array(PLACES)))


def near_code(layout: ClothLayout, appearance: Appearance, wide: Vectors) -> Code:
    """Code for a fabric, and for all whose families' threads are alike, or not, as its are."""
    code = Code("close_ups", replace(wide, of_block=_VECTORS))
    code.shares(QUERY + ANSWERS)
    writer = _Writer(code, cloth_of(layout, appearance, code.types))
    with code.blocks():
        writer.write()
    return code


@dataclass
class _Ray:
    """A view ray; see `FallingRay`."""

    x: Any
    y: Any
    slope_x: Any
    slope_y: Any
    step: Any
    back: Any


@dataclass
class _Sight:
    """A view ray that is searched.

    Attributes:
        query: its number in the block.
        height, leap, count, trail: how far the search has come; see `Falling`.
    """

    query: Any
    ray: _Ray
    height: Any
    leap: Any
    count: Any
    trail: Trail


@dataclass
class _End:
    """A view ray whose search is done.

    Attributes:
        query: its number in the block.
        height, leap, depth, rate, smooth: see `Falling`.
        last_clearance, last_rate: of the sample before; see `Trail`.
    """

    query: Any
    ray: _Ray
    height: Any
    leap: Any
    depth: Any
    rate: Any
    smooth: Any
    last_clearance: Any
    last_rate: Any


@dataclass
class _Met:
    """What a view ray has met.

    Attributes:
        query: its number in the block.
        x, y: where, millimetres.
        back: which face is seen.
    """

    query: Any
    x: Any
    y: Any
    back: Any


@dataclass
class _Gap:
    """A view ray that may pass through the cloth.

    Attributes:
        x, y: where it crosses the plane z = 0, millimetres.
        met: what it has met if it does not.
    """

    x: Any
    y: Any
    met: _Met


@dataclass
class _Light:
    """A ray to a light.

    Attributes:
        query: its number in the block.
        start, direction, step, back, roof: see `RisingRay`.
        is_warp: the yarn that it lights is of the warp.
        diffuse, specular: what counts of it where it arrives.
        distance, leap, count, trail: how far the search has come; see `Rising`.
    """

    query: Any
    start: Any
    direction: Any
    step: Any
    back: Any
    roof: Any
    is_warp: Any
    diffuse: Any
    specular: Any
    distance: Any
    leap: Any
    count: Any
    trail: Trail


class _Writer:
    """Writes the code of a block."""

    def __init__(self, code: Code, cloth: _Cloth) -> None:
        self._code, self._cloth = code, cloth
        self._block = code.vectors.block
        self._sums = code.stack(_CHANNELS * self._block)
        whole, number, no = (code.converted(0, kind) for kind in (WHOLE, FLOAT, TRUTH))
        space, trail = Vector(number, number, number), Trail(number, number, whole, no)
        place, ray = (number,) * 4, _Ray(*(number,) * 5, no)
        met = _Met(whole, number, number, no)
        kinds = (
            _Sight(whole, ray, number, number, whole, trail),
            _End(whole, ray, *place, no, number, number),
            _Gap(number, number, met),
            met,
            _Light(whole, space, space, number, no, number, no, *place, whole, trail),
        )
        piles = [Pile(code, like, self._block) for like in kinds]
        self._sights, self._ends, self._gaps, self._met, self._lights = piles

    def write(self) -> None:
        """Answers a block."""
        code = self._code
        for channel in range(_CHANNELS):
            with code.each_vector():
                code.store(code.number(0), code.element(self._sum(channel), code.lane))
        for pile in (self._sights, self._ends, self._gaps, self._met, self._lights):
            pile.clear()
        with code.loop(MOST_POINTS) as number, code.builder.if_then(self._has_points(number)):
            self._look(number)
            with code.as_long_as(self._sights.is_left):
                self._search()
            with code.as_long_as(self._ends.is_left):
                self._refine()
            with code.as_long_as(self._gaps.is_left):
                self._pass(number)
            with code.as_long_as(self._met.is_left):
                self._shade(number)
            with code.as_long_as(self._lights.is_left):
                self._search_lights()
        with code.each_vector():
            self._answer()

    def _sum(self, channel: int) -> ir.Value:
        return self._code.element(self._sums, channel * self._block)

    def _has_points(self, number: ir.Value) -> ir.Value:
        """Whether any query has more points than so many."""
        code = self._code
        found = code.variable(TRUTH)
        code.builder.store(TRUTH(0), found)
        with code.each_vector():
            more = code.is_anywhere(code.given(_POINTS) > code.counted(number))
            code.builder.store(code.builder.or_(code.builder.load(found), more), found)
        return code.builder.load(found)

    # Views.

    def _look(self, number: ir.Value) -> None:
        """Starts the view rays through a point of each query."""
        code = self._code
        places = code.array(self._cloth.places.array)
        s, t = (code.shared(places, code.builder.add(code.times(number, 2), INDEX(k))) for k in range(2))
        with code.each_vector():
            active = code.given(_POINTS) > code.counted(number)
            with code.builder.if_then(code.is_anywhere(active)):
                x, y, *edges = (code.given(k) for k in range(6))
                x, y = (fma(s, edges[k], fma(t, edges[2 + k], middle)) for k, middle in enumerate((x, y)))
                view, back = Vector(*(code.given(k) for k in (6, 7, 8))), code.given(9) > 0.5
                ray = falling_ray(self._cloth.surface, x, y, view, back, quality_of(code.given(_THREADS)))
                search = self._searched(ray, ray.started(active), _FIRST_SAMPLES)
                self._sort(code.numbered(code.lane), ray, search, active)

    def _search(self) -> None:
        """Goes on with view rays."""
        sight, there = self._sights.take()
        nothing, no = self._code.number(0), self._code.converted(False, TRUTH)
        search = Falling(sight.height, sight.leap, nothing, nothing, no, there, sight.count, sight.trail)
        ray = self._falling(sight.ray)
        self._sort(sight.query, ray, self._searched(ray, search, _SAMPLES), there)

    def _falling(self, of: _Ray) -> FallingRay:
        slope = Vector(of.slope_x, of.slope_y)
        return FallingRay(self._cloth.surface, of.x, of.y, slope, of.step, of.back, SearchQuality().steps)

    def _sort(self, query: Lanes, ray: FallingRay, now: Falling, there: Lanes) -> None:
        of_ray = _Ray(ray.x, ray.y, ray.slope.x, ray.slope.y, ray.step, ray.back)
        self._sights.put(_Sight(query, of_ray, now.height, now.leap, now.count, now.trail), now.searching)
        end = now.height, now.leap, now.depth, now.rate, now.smooth, now.trail.clearance, now.trail.rate
        self._ends.put(_End(query, of_ray, *end), there & ~now.searching)

    def _searched(self, ray: Any, search: Any, samples: int) -> Any:
        """A search after so many samples."""
        turns = self._code.converted(0, WHOLE)
        return self._code.while_loop(
            (search, turns),
            lambda state, turn: state.searching & (turn < samples),
            lambda state, turn: (ray.advanced(state), turn + 1),
        )[0]

    # What they meet.

    def _of_queries(self, first: int, query: Lanes) -> Vector:
        code = self._code
        found = [code.gathered_from(code.queries(first + axis), query) for axis in range(3)]
        return Vector(*found)

    def _refine(self) -> None:
        """Finds the points that views meet."""
        end, there = self._ends.take()
        query = select(there, end.query, 0)
        ray, no = self._falling(end.ray), self._code.converted(False, TRUTH)
        trail = Trail(end.last_clearance, end.last_rate, 0, no)
        search = Falling(end.height, end.leap, end.depth, end.rate, end.smooth, no, 0, trail)
        height = ray.refined(search, self._quality(query).refinements)
        x, y = fma(ray.slope.x, height, ray.x), fma(ray.slope.y, height, ray.y)
        found = _Met(query, x, y, ray.back)
        # What has met yarn above the plane does not pass it.
        in_gap = there & (height <= 0) & self._cloth.surface.height(ray.x, ray.y, ray.back)[1]
        self._gaps.put(_Gap(ray.x, ray.y, found), in_gap)
        self._met.put(found, there & ~in_gap)

    def _pass(self, number: ir.Value) -> None:
        """Which views pass through the cloth."""
        gap, there = self._gaps.take()
        query = select(there, gap.met.query, 0)
        view, quality = self._of_queries(6, query), self._quality(query)
        passes = passes_through(self._cloth.surface, gap.x, gap.y, view, gap.met.back, there, quality)
        self._add(ANSWERS - 1, query, self._share(number, query), passes)
        self._met.put(gap.met, there & ~passes)

    def _share(self, number: ir.Value, query: Lanes) -> Lanes:
        """How much a point counts."""
        points = self._code.gathered_from(self._code.queries(_POINTS), query)
        return smaller(points - self._code.counted(number), 1)

    def _quality(self, query: Lanes) -> SearchQuality:
        return quality_of(self._code.gathered_from(self._code.queries(_THREADS), query))

    def _shade(self, number: ir.Value) -> None:
        """What light does at the points that views meet, and whether it arrives."""
        cloth = self._cloth
        seen, there = self._met.take()
        query = select(there, seen.query, 0)
        view, light = self._of_queries(6, query), self._of_queries(10, query)
        quality, share = self._quality(query), self._share(number, query)
        x, y, back = seen.x, seen.y, seen.back
        met = cloth.surface.surface(x, y, back)
        roughness = select(met.is_warp, *cloth.roughness)
        point = YarnPoint(
            back, ~there, x, y, met.height, met.normal, met.tangent, met.is_warp, roughness, None
        )
        light, view = on_face(light, back), on_face(view, back)
        diffuse, specular = lobes(cloth, point, light, view)
        shadow = shadow_ray(cloth.surface, point, light)
        rising = rising_ray(cloth.surface, x, y, shadow.height, shadow.direction, shadow.back, quality)
        search = rising.started(there & shadow.searched & (shadow.direction.z > 0))
        scattered = met.is_warp, diffuse * share, specular * share
        self._light(query, rising, scattered, self._searched(rising, search, _FIRST_TO_LIGHT))

    def _search_lights(self) -> None:
        """Goes on with rays to lights."""
        light, there = self._lights.take()
        way = light.start, light.direction, light.step, light.back, light.roof
        ray = RisingRay(self._cloth.surface, *way, SearchQuality().steps)
        search = Rising(light.distance, light.leap, there, there, light.count, light.trail)
        scattered = light.is_warp, light.diffuse, light.specular
        self._light(light.query, ray, scattered, self._searched(ray, search, _SAMPLES))

    def _light(
        self, query: Lanes, ray: RisingRay, scattered: tuple[Lanes, Lanes, Lanes], now: Rising
    ) -> None:
        """Adds what arrives, and puts aside what is not known yet.

        Args:
            scattered: whether off the warp, and how much of both kinds.
        """
        way = ray.start, ray.direction, ray.step, ray.back, ray.roof
        so_far = now.distance, now.leap, now.count, now.trail
        self._lights.put(_Light(query, *way, *scattered, *so_far), now.searching)
        is_warp, diffuse, specular = scattered
        arrives = now.free & ~now.searching
        family = select(is_warp, self._code.converted(0, WHOLE), self._block)
        self._add(0, query + family, diffuse, arrives)
        self._add(2, query + family, specular, arrives)

    def _add(self, channel: int, place: Lanes, value: Lanes, where: Lanes) -> None:
        """Adds to sums, of which none is named twice."""
        code, sums = self._code, self._sum(channel)
        # Lanes that are not there may name any place.
        place = select(where, place, 0)
        code.scatter_to(sums, place, code.gathered_from(sums, place) + value, where)

    def _answer(self) -> None:
        """Mixes means over points with what groups answer."""
        code = self._code
        points, far_share = code.given(_POINTS), code.given(_FAR_SHARE)
        with code.builder.if_then(code.is_anywhere(points > 0)):
            inverse = rcp(larger(points, 1))
            for channel in range(_CHANNELS):
                near = code.load(code.element(self._sum(channel), code.lane)) * inverse
                far = code.given(QUERY + channel)
                code.answer(QUERY + channel, select(points > 0, lerp(near, far, far_share), far))
