"""Slices: the integrand of one pair of light and view over a whole repeat, evaluated once.

Its summed-area tables give the exact mean over any box, so one slice serves thousands of queries without
noise. Intersections are computed once per view, and shadows once per light where they are mapped.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Literal

import drjit as dr
import numpy as np
from numpy.typing import ArrayLike, NDArray

from loomlight.aggregate.components import (
    CHANNELS,
    COLOURS,
    LIGHT_VISIBILITY,
    ViewHits,
    colours,
    components,
    light_visibility,
    trace_views,
    without_sheen_and_variation,
)
from loomlight.aggregate.tables import (
    TEXELS_PER_THREAD,
    Grid,
    TexelBoxes,
    box_means,
    divide,
    fabric_grid,
    summed_areas,
    texel_boxes,
)
from loomlight.core.arrays import Float, FloatType, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, array_types, maximum, upload
from loomlight.core.errors import InputError
from loomlight.scattering.point import Albedos, YarnPoint, YarnScattering, to_face_frame
from loomlight.yarn.visibility import unoccluded

# Texels evaluated in one launch: bounds the memory to some 300 MB, or to that of a single slice.
_BATCH = 1 << 21


@dataclass(frozen=True, eq=False)
class Slice:
    """The integrand of one pair of light and view.

    Attributes:
        grid: where its rays cross the plane z = 0.
        channels: names, the five of `CHANNELS`, then those of `FabricSlices` that were chosen.
        values: [channels, rows, columns]; components and colours in 1/sr, the hole as 0 or 1.
    """

    grid: Grid
    channels: tuple[str, ...]
    values: NDArray[np.float32]
    _table: Float
    _float_type: FloatType

    def box_means(self, centres: ArrayLike, sizes: ArrayLike) -> NDArray[np.float64]:
        """Means over axis-aligned boxes [n, channels], exact for the slice's texels.

        Args:
            centres, sizes: [n, 2] millimetres; boxes are at least 1/100 of a texel wide and high.
        """
        types = array_types(self._float_type)
        boxes = texel_boxes(self.grid, np.asarray(centres), np.asarray(sizes), self._float_type)
        entries = (self.grid.columns + 1) * (self.grid.rows + 1)
        means = [
            box_means(self._table, dr.opaque(types.UInt32, channel * entries), self.grid, boxes).numpy()
            for channel in range(len(self.channels))
        ]
        return np.stack(means, axis=1)


@dataclass(frozen=True, eq=False)
class SliceBatch:
    """Slices evaluated together.

    Attributes:
        pairs: indices of the slices among the requested pairs [n].
        channels: an array a channel but the hole, n slices one after another, texels row by row: Float.
        holes: 0 or 1 for each view of the batch, likewise: Float.
        hole_of: index of each pair's view among the views of the batch [n].
    """

    pairs: NDArray[np.intp]
    channels: list[Float]
    holes: Float
    hole_of: NDArray[np.intp]


class FabricSlices:
    """Makes slices of one fabric.

    Attributes:
        model: the point model, without sheen and procedural variation.
        grid: of every slice.
        channels: names of the channels.
    """

    def __init__(
        self,
        model: YarnScattering,
        float_type: FloatType,
        texels_per_thread: float = TEXELS_PER_THREAD,
        shadows: Literal["searched", "mapped"] = "searched",
        with_colours: bool = False,
        with_light_visibility: bool = False,
    ) -> None:
        """Prepares a grid; nothing is evaluated yet.

        Args:
            float_type: the Dr.Jit Float type to compute with.
            texels_per_thread: at least so many across the finest thread of each family.
            shadows: "searched" evaluates the model's visibility for every point and light (exact, or by the
                model's horizon map); "mapped" searches each light once on the grid, and points read the
                nearest texel.
            with_colours: adds red, green and blue with the albedos of the threads and light between them.
            with_light_visibility: adds the share of yarn that light reaches, by which sheen is scaled.

        Raises:
            InputError: more than 16 million texels.
        """
        self.model = without_sheen_and_variation(model, between_yarns=with_colours)
        self.grid = fabric_grid(model.surface, texels_per_thread)
        self.channels = CHANNELS + (COLOURS if with_colours else ())
        self.channels += (LIGHT_VISIBILITY,) if with_light_visibility else ()
        self._mapped = shadows == "mapped"
        self._float_type = float_type
        self._types = array_types(float_type)

    def slice(self, light: ArrayLike, view: ArrayLike) -> Slice:
        """The slice of unit vectors `light` and `view` [3], z < 0 on the back."""
        batch = next(self.batches(np.asarray(light), np.asarray(view), [[0, 0]]))
        ordered = [*batch.channels[:4], batch.holes, *batch.channels[4:]]
        joined = dr.concat(ordered)
        values = joined.numpy().reshape(len(ordered), self.grid.rows, self.grid.columns)
        table = summed_areas(joined, self.grid.columns, self.grid.rows)
        return Slice(self.grid, self.channels, values, table, self._float_type)

    def box_means(
        self, lights: ArrayLike, views: ArrayLike, pairs: ArrayLike, centres: ArrayLike, sizes: ArrayLike
    ) -> NDArray[np.float32]:
        """Means over many boxes of many slices [n, m, channels], each slice dropped after use.

        Args:
            lights, views: unit vectors [l, 3] and [v, 3]; pairs that share one share its computation.
            pairs: index of the light and of the view of each slice [n, 2].
            centres, sizes: boxes of each slice [n, m, 2], or those that all slices share [m, 2], millimetres.
        """
        centres, sizes = np.asarray(centres, np.float64), np.asarray(sizes, np.float64)
        shared = None
        if centres.ndim == 2:
            shared = texel_boxes(self.grid, centres, sizes, self._float_type)
            dr.eval(shared)
        count, boxes_each = len(np.asarray(pairs)), centres.shape[-2]
        result = np.empty((count, boxes_each, len(self.channels)), np.float32)
        for batch in self.batches(lights, views, pairs):
            lanes = len(batch.pairs) * boxes_each
            slot, number = divide(dr.arange(self._types.UInt32, lanes), boxes_each)
            if shared is not None:
                boxes = shared.at(number)
            else:
                own = centres[batch.pairs].reshape(-1, 2), sizes[batch.pairs].reshape(-1, 2)
                boxes = texel_boxes(self.grid, *own, self._float_type)
            result[batch.pairs] = self._read(batch, slot, boxes).reshape(-1, *result.shape[1:])
        return result

    def _read(self, batch: SliceBatch, slot: UInt, boxes: TexelBoxes) -> NDArray[np.float32]:
        """Means over boxes of the batch's slices number `slot`, channel by channel for each box."""
        types = self._types
        view = dr.gather(types.UInt32, upload(types.UInt32, batch.hole_of.astype(np.uint32)), slot)
        channels = [(channel, slot) for channel in batch.channels]
        channels.insert(4, (batch.holes, view))
        entries = dr.opaque(types.UInt32, (self.grid.rows + 1) * (self.grid.columns + 1))
        means = dr.empty(types.Float, dr.width(slot) * len(channels))
        first = dr.arange(types.UInt32, dr.width(slot)) * len(channels)
        for index, (values, number) in enumerate(channels):
            table = summed_areas(values, self.grid.columns, self.grid.rows)
            mean = types.Float(box_means(table, number * entries, self.grid, boxes))
            dr.scatter(means, mean, first + dr.opaque(types.UInt32, index))
            dr.eval(means)
        return means.numpy()

    def batches(self, lights: ArrayLike, views: ArrayLike, pairs: ArrayLike) -> Iterator[SliceBatch]:
        """Evaluates slices in batches that fit memory, not in the order of the pairs.

        Args:
            lights, views: unit vectors [l, 3] and [v, 3].
            pairs: index of the light and of the view of each slice [n, 2].
        """
        light_vectors = _unit_vectors(lights)
        view_vectors = _unit_vectors(views)
        index = np.asarray(pairs, np.intp).reshape(-1, 2)
        maps = None
        if self._mapped:
            maps = ShadowMaps(self.model, self.grid, light_vectors, self._float_type)
        at_once = max(1, _BATCH // self.grid.texels)
        for chosen, transmits in _by_side(light_vectors, view_vectors, index):
            for first in range(0, len(chosen), at_once):
                part = chosen[first : first + at_once]
                yield self._evaluate(light_vectors, view_vectors, index, part, transmits, maps)

    def _evaluate(
        self,
        lights: NDArray[np.float64],
        views: NDArray[np.float64],
        pairs: NDArray[np.intp],
        part: NDArray[np.intp],
        transmits: bool,
        maps: ShadowMaps | None,
    ) -> SliceBatch:
        types, grid = self._types, self.grid
        used, hole_of = np.unique(pairs[part, 1], return_inverse=True)
        view_vectors = self._vectors(views[used])
        hits = self._trace(view_vectors, len(used), maps)

        pair, texel = divide(dr.arange(types.UInt32, len(part) * grid.texels), grid.texels)
        view_index = dr.gather(types.UInt32, upload(types.UInt32, hole_of.astype(np.uint32)), pair)
        light_index = dr.gather(types.UInt32, upload(types.UInt32, pairs[part, 0].astype(np.uint32)), pair)
        index = view_index * dr.opaque(types.UInt32, grid.texels) + texel
        point = _gathered(hits.point, index)
        light = dr.gather(types.Vector3, self._vectors(lights), light_index)
        view = dr.gather(types.Vector3, view_vectors, view_index)
        if maps is None:
            visible = self.model.visibility(point, light)
        else:
            nearest = dr.gather(types.UInt32, hits.shadow_texel, index)
            visible = maps.at(light_index, nearest)
        appearance = self.model.appearance
        channels = list(components(appearance, point, light, view, visible, transmits))
        if COLOURS[0] in self.channels:
            channels += list(colours(appearance, point, light, view, visible, transmits))
        if LIGHT_VISIBILITY in self.channels:
            channels.append(light_visibility(point, visible))
        holes = dr.select(hits.point.hole, types.Float(1), 0)
        dr.eval(channels, holes)
        return SliceBatch(part, channels, holes, hole_of)

    def _trace(self, views: Vec3, count: int, maps: ShadowMaps | None) -> _HitField:
        types, grid = self._types, self.grid
        number, texel = divide(dr.arange(types.UInt32, count * grid.texels), grid.texels)
        x, y = grid.points(types, texel)
        view = dr.gather(types.Vector3, views, number)
        hits = trace_views(self.model, x, y, view)
        shadow_texel = None if maps is None else _shadow_texel(maps, hits, view)
        dr.eval(hits.point, shadow_texel)
        return _HitField(hits.point, shadow_texel)

    def _vectors(self, directions: NDArray[np.float64]) -> Vec3:
        return upload_vectors(directions, self._types)


@dataclass
class _HitField:
    """Hits of the rays of some views, view by view."""

    point: YarnPoint
    shadow_texel: UInt


def _shadow_texel(maps: ShadowMaps, hits: ViewHits, view: Vec3) -> UInt:
    """Texels of the shadow maps for yarn points.

    A ray that hit a wall ends at the edge of a yarn, and half of the texels around it are of the yarn below,
    in its shadow. One texel further along the ray is on the yarn itself.
    """
    types = array_types(hits.point.x)
    length = dr.rsqrt(maximum(dr.square(view.x) + dr.square(view.y), 1e-12))
    step_x, step_y = (dr.opaque(types.Float, step) for step in maps.grid.step)
    further = dr.select(hits.wall, dr.select(hits.foot, types.Float(-1), 1), 0) * length
    return maps.texel(hits.x - further * view.x * step_x, hits.y - further * view.y * step_y)


def _unit_vectors(directions: ArrayLike) -> NDArray[np.float64]:
    vectors = np.asarray(directions, np.float64).reshape(-1, 3)
    lengths = np.linalg.norm(vectors, axis=1, keepdims=True)
    if not (np.isfinite(lengths).all() and (lengths > 0).all() and (vectors[:, 2] != 0).all()):
        raise InputError("Directions of light and view are finite vectors that do not lie in the cloth.")
    return vectors / lengths


def _by_side(
    lights: NDArray[np.float64], views: NDArray[np.float64], pairs: NDArray[np.intp]
) -> Iterator[tuple[NDArray[np.intp], bool]]:
    """Pairs by kernel, ordered by view: reflecting pairs, and transmitting ones."""
    transmits = lights[pairs[:, 0], 2] * views[pairs[:, 1], 2] < 0
    order = np.argsort(pairs[:, 1], kind="stable")
    for side in (False, True):
        chosen = order[transmits[order] == side]
        if len(chosen):
            yield chosen, side


def _gathered(point: YarnPoint, index: UInt) -> YarnPoint:
    """The yarn points at `index`; attributes that are not used are never gathered."""

    def gather(value: Any) -> Any:
        if dr.depth_v(value) > 1:
            return type(value)(*(gather(part) for part in value))
        # A value that all points share has width 1.
        return value if dr.width(value) == 1 else dr.gather(type(value), value, index)

    albedos = point.albedos
    return YarnPoint(
        back=gather(point.back),
        hole=gather(point.hole),
        x=gather(point.x),
        y=gather(point.y),
        height=gather(point.height),
        plane=gather(point.plane),
        normal=gather(point.normal),
        tangent=gather(point.tangent),
        is_warp=gather(point.is_warp),
        roughness=gather(point.roughness),
        albedos=Albedos(
            gather(albedos.diffuse_reflect),
            gather(albedos.diffuse_transmit),
            gather(albedos.specular_reflect),
            gather(albedos.specular_transmit),
        ),
        bounced=None if point.bounced is None else (gather(point.bounced[0]), gather(point.bounced[1])),
    )


# ------------------------------------------------------------------------------------------------ shadow maps
# Shadow maps: visibility of points of the cloth, tabulated once per light for all views.
#
# The search along shadow rays is the largest cost of a slice. Where pairs share lights, it is done once a
# light, on a grid of points of the face that the light is on. Yarn points read their nearest texel, which
# moves shadow edges by up to half a texel.


_SHADOW_BATCH = 1 << 22


class ShadowMaps:
    """Visibility of several lights over one repeat of cloth.

    Attributes:
        grid: of the points, one repeat.
        visible: Bool, [lights, rows, columns] flattened.
    """

    def __init__(
        self, model: YarnScattering, grid: Grid, lights: NDArray[np.float64], float_type: FloatType
    ) -> None:
        """Computes the maps of unit vectors `lights` [n, 3], z < 0 from behind."""
        types = array_types(float_type)
        self.grid = grid
        directions = upload_vectors(lights, types)
        total = len(lights) * grid.texels
        self.visible = dr.empty(types.Bool, total)
        for first in range(0, total, _SHADOW_BATCH):
            lane = dr.arange(types.UInt32, first, min(first + _SHADOW_BATCH, total))
            index, texel = divide(lane, grid.texels)
            light = dr.gather(types.Vector3, directions, index)
            x, y = grid.points(types, texel)
            back = light.z < 0
            point = model.surface.surface(x, y, back)
            facing = to_face_frame(light, back)
            # The yarn itself occludes lights below its tangent plane.
            rises = dr.dot(point.normal, facing) > 0
            visible = unoccluded(model.surface, x, y, point.height, facing, back, rises, model.quality)
            dr.scatter(self.visible, visible, lane)
        dr.eval(self.visible)

    def texel(self, x: Float, y: Float) -> UInt:
        """The texel of draft coordinates, millimetres: UInt32."""
        return self.grid.nearest(array_types(x), x, y)

    def at(self, light: Vec3, texel: UInt) -> Mask:
        """Whether light number `light` (UInt32) reaches a texel: Bool."""
        texels = dr.opaque(type(texel), self.grid.texels)
        return dr.gather(type(self.visible), self.visible, light * texels + texel)


def upload_vectors(directions: NDArray[np.float64], types: ArrayTypes) -> Vec3:
    """Vectors [n, 3] as a Vector3 of n lanes, axis by axis: one array would compile n into the kernels."""
    return types.Vector3(*(upload(types.Float, axis.astype(np.float32)) for axis in directions.T))
