"""The surface of layered cloth: planes of yarn upon one another, each seen through the holes of those before.

Every layer is the cloth of its own threads (`geometry.py`), which fill its plane. The planes are as far apart
as the highest yarns of both reach, so none cuts through another; z = 0 is in the middle of them all. Rays
follow one height field a face, that of the first layer which has yarn there: searches, shadows, holes and
parallax are those of `rays.py`. As everywhere in height fields, yarns are walls, here down to the next layer.
"""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass, fields, replace
from functools import reduce
from typing import Any, TypeVar

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, FloatType, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, array_types, maximum, minimum, upload
from loomlight.yarn.flanks import Sheet, SurfacePoint, Tube, meet_tube
from loomlight.yarn.geometry import CellBounds, Probe, YarnGeometry, upload_family
from loomlight.yarn.layout import ClothLayout
from loomlight.yarn.threads import CELL_MAX_LEVELS, CELL_MAX_SHIFT, place_family

_Record = TypeVar("_Record", SurfacePoint, Tube, Probe)


@dataclass
class _Order:
    """Which layer lies upon which at some places, as a face shows them.

    Attributes:
        ranks: of each layer, 0 first; more than there are layers where it is absent.
        levels: height of its plane, millimetres.
    """

    ranks: list[UInt]
    levels: list[Float]


class _Placed:
    """What places the layers of one cloth on one backend.

    Attributes:
        starts: x and y where each layer's cells begin.
        threads: numbers in the draft of each layer's ends and picks.
        gains: largest height of each layer above its plane, as a share of that of the whole cloth.
        high, per_high: the latter and its inverse.
        highest_first: of each layer, front and back: the highest of its planes where it is first.
    """

    def __init__(
        self, layout: ClothLayout, levels: NDArray[np.float64], highest: list[float], types: ArrayTypes
    ) -> None:
        self._types = types
        high = highest[-1]
        self.starts = [[dr.opaque(types.Float, start) for start in layer.start] for layer in layout.layers]
        self.threads = [
            [upload(types.UInt32, np.asarray(part, np.uint32)) for part in (layer.ends, layer.picks)]
            for layer in layout.layers
        ]
        self.gains = [dr.opaque(types.Float, own / high) for own in highest[:-1]]
        self.high = dr.opaque(types.Float, high)
        self.per_high = dr.opaque(types.Float, 1 / high)
        self._levels = upload(types.Float, levels.ravel().astype(np.float32))
        self._count = len(layout.layers)
        self._level = [dr.opaque(types.Float, float(level)) for level in levels[0]]
        self.stacking = layout.stacking
        if self.stacking is None:
            return
        ranks = self.stacking.ranks
        last = ranks.max(axis=1, keepdims=True)
        of_faces = [np.where(ranks < 0, 255, side) for side in (ranks, last - ranks)]
        self._ranks = upload(types.UInt32, np.stack(of_faces).astype(np.uint32).ravel())
        self._stacks = dr.opaque(types.UInt32, len(ranks))
        self.cells = [upload_family(place_family(family), types) for family in (layout.warp, layout.weft)]
        self._ends = dr.opaque(types.UInt32, layout.warp_on_top.shape[1])
        self._regions = upload(types.UInt32, self.stacking.regions.ravel().astype(np.uint32))
        self.highest_first = [
            [dr.opaque(types.Float, float(level)) for level in of_layer]
            for of_layer in _highest_first(ranks, levels)
        ]

    def order(self, x: Float, y: Float, back: Mask) -> _Order:
        """The order of layers at draft coordinates x, y (millimetres)."""
        types, count = self._types, self._count
        side = dr.select(back, types.Float(-1), types.Float(1))
        if self.stacking is None:
            ranks = [dr.select(back, types.UInt32(count - 1 - k), types.UInt32(k)) for k in range(count)]
            return _Order(ranks, [side * level for level in self._level])
        across, along = self.cells[0].locate(x), self.cells[1].locate(y)
        stack = dr.gather(types.UInt32, self._regions, along.thread * self._ends + across.thread)
        face = dr.select(back, self._stacks, types.UInt32(0))
        return _Order(
            [dr.gather(types.UInt32, self._ranks, (stack + face) * count + k) for k in range(count)],
            [side * dr.gather(types.Float, self._levels, stack * count + k) for k in range(count)],
        )


def _highest_first(ranks: NDArray[np.int8], levels: NDArray[np.float64]) -> NDArray[np.float64]:
    """Of each layer where it is the first of a face: the highest of its planes, else −∞ [layers, 2]."""
    last = ranks.max(axis=1, keepdims=True)
    faces = [
        np.where(first, side * levels, -np.inf).max(axis=0)
        for side, first in ((1, ranks == 0), (-1, (ranks >= 0) & (ranks == last)))
    ]
    return np.stack(faces, axis=1)


class StackedGeometry:
    """Analytic geometry of layered cloth: a `Surface`, see `YarnGeometry` for what its methods return.

    Attributes:
        layout: what it was made from; it has layers.
        size: width and height of the repeat, millimetres.
        layers: the geometry of each.
    """

    def __init__(self, layout: ClothLayout) -> None:
        self.layout = layout
        self.size = layout.size
        self.layers = [YarnGeometry(layer.layout) for layer in layout.layers]
        self._shares = [_highest_shown(self, number) for number in range(len(self.layers))]
        self._placed: dict[type, tuple[bytes, _Placed]] = {}
        self.extents: dict[FloatType, Any] = {}

    @property
    def height_scale(self) -> tuple[Float, Float]:
        """β of (warp, weft) in all layers."""
        return self.layers[0].height_scale

    @height_scale.setter
    def height_scale(self, scale: tuple[Float, Float]) -> None:
        self._change("height_scale", scale)

    @property
    def twist(self) -> tuple[Float, Float]:
        """ψ of (warp, weft) in all layers, radians."""
        return self.layers[0].twist

    @twist.setter
    def twist(self, twist: tuple[Float, Float]) -> None:
        self._change("twist", twist)

    def _change(self, name: str, value: tuple[Float, Float]) -> None:
        # Copies of this geometry share its layers until one of them is edited.
        self.layers = [copy(layer) for layer in self.layers]
        for layer in self.layers:
            setattr(layer, name, value)

    @property
    def finest(self) -> tuple[float, float]:
        """Smallest cell of warp and weft threads of any layer, millimetres."""
        warp, weft = zip(*(layer.finest for layer in self.layers), strict=True)
        return min(warp), min(weft)

    @property
    def ranks(self) -> NDArray[np.int8]:
        """Of each layer in each stack, see `Stacking` [stacks, layers]."""
        if self.layout.stacking is not None:
            return self.layout.stacking.ranks
        return np.arange(len(self.layers), dtype=np.int8)[None]

    @property
    def reaches(self) -> NDArray[np.float64]:
        """How high each layer's yarns rise above its plane where it is a layer of the cloth [layers], mm.

        Straight yarns do not rise; they are as thick as their sections drop.
        """
        scales = [float(np.max(np.asarray(scale))) for scale in self.height_scale]
        return np.array(
            [
                max(
                    scale
                    * (float(family.edge_drop.max()) / 2 if family.is_straight else family.highest * share)
                    for family, scale, share in zip(layer.families, scales, shares, strict=True)
                )
                for layer, shares in zip(self.layers, self._shares, strict=True)
            ]
        )

    @property
    def levels(self) -> NDArray[np.float64]:
        """z of the plane of each layer in each stack [stacks, layers], mm; 0 where it is none of it."""
        reaches = self.reaches
        levels = np.zeros(self.ranks.shape)
        for stack, ranks in enumerate(self.ranks):
            order = np.argsort(np.where(ranks < 0, 127, ranks), kind="stable")[: np.count_nonzero(ranks >= 0)]
            # Each plane is as far below the one before as both reach.
            reach = reaches[order]
            depth = 2 * np.cumsum(reach) - reach
            levels[stack, order] = reach.sum() - depth
        return levels

    @property
    def highest_first(self) -> NDArray[np.float64]:
        """Highest plane of each layer where it is the first of a face, else −∞ [layers, 2], millimetres."""
        return _highest_first(self.ranks, self.levels)

    @property
    def height_bounds(self) -> tuple[float, float]:
        """No thread is ever lower or higher than this, millimetres, on either face."""
        low = np.array([layer.height_bounds[0] for layer in self.layers])
        levels, present, high = self.levels, self.ranks >= 0, self.reaches
        return (
            min(float((side * levels + low)[present].min()) for side in (1, -1)),
            max(float((side * levels + high)[present].max()) for side in (1, -1)),
        )

    def upload(self, types: ArrayTypes) -> None:
        """Puts all that points and probes read on a backend, which otherwise happens at first use."""
        for layer in self.layers:
            layer.upload(types)
        self._on(types)

    def _on(self, types: ArrayTypes) -> _Placed:
        levels = self.levels
        kept = self._placed.get(types.Float)
        if kept is None or kept[0] != levels.tobytes():
            highest = [layer.height_bounds[1] for layer in self.layers]
            placed = _Placed(self.layout, levels, [*highest, self.height_bounds[1]], types)
            kept = self._placed[types.Float] = levels.tobytes(), placed
        return kept[1]

    def height(self, x: Float, y: Float, back: Mask) -> tuple[Float, Mask]:
        """Height of the first yarn and whether there is none, at draft coordinates x, y in millimetres."""
        point = self.surface(x, y, back)
        return point.height, point.hole

    def max_heights(self, x: Float, y: Float, back: Mask, right: Mask, up: Mask) -> list[tuple[float, Float]]:
        """Bounds of heights ahead of draft coordinates x, y (mm): those of the first layer of the face.

        Where layers change places they are those of the highest that is first somewhere.
        """
        placed = self._on(array_types(x))

        def bounds(number: int, level: Float) -> list[tuple[float, Float]]:
            start, layer = placed.starts[number], self.layers[number]
            own = layer.max_heights(x - start[0], y - start[1], back, right, up)
            level = level * placed.per_high
            return [(radius, dr.fma(share, placed.gains[number], level)) for radius, share in own]

        if placed.stacking is not None:
            layers = [
                bounds(number, dr.select(back, behind, front))
                for number, (front, behind) in enumerate(placed.highest_first)
            ]
            return [
                (ring[0][0], reduce(maximum, [share for _, share in ring]))
                for ring in zip(*layers, strict=True)
            ]
        order = placed.order(x, y, back)
        return [
            (radius, dr.select(back, behind, front))
            for (radius, front), (_, behind) in zip(
                bounds(0, order.levels[0]), bounds(-1, order.levels[-1]), strict=True
            )
        ]

    def probe(self, x: Float, y: Float, back: Mask, right: Mask, up: Mask) -> Probe:
        """The surface at draft coordinates x, y (millimetres) for a search."""
        types = array_types(x)
        placed = self._on(types)
        order = placed.order(x, y, back)
        probes = [
            layer.probe(x - start[0], y - start[1], back, right, up)
            for layer, start in zip(self.layers, placed.starts, strict=True)
        ]
        found = _Found.of(probes, order)
        for number, (here, level) in enumerate(zip(probes, order.levels, strict=True)):
            here.height = here.height + level
            # Among the numbers of yarns in one layer there is room for those of the others.
            here.yarn = here.yarn * len(self.layers) + number
        shown = found.shown(probes)
        bounds = self._cell_bounds(placed, order, x, y, back, right, up, probes)
        for axis, side in (("edge_x", bounds.side_x), ("edge_y", bounds.side_y)):
            # A layer before the one that shows is a hole here, and may begin ahead.
            far = types.Float(1e6) if placed.stacking is None else side
            edges = [
                dr.select(seen, getattr(here, axis), far)
                for here, seen in zip(probes, found.before, strict=True)
            ]
            setattr(shown, axis, reduce(minimum, edges, far))
        return replace(shown, hole=found.nothing, cell_bounds=bounds)

    def cell_bounds(self, x: Float, y: Float, back: Mask, right: Mask, up: Mask) -> CellBounds:
        """The part of `probe` that rays above the cell need: of the face's first layer, which is highest."""
        placed = self._on(array_types(x))
        return self._cell_bounds(placed, placed.order(x, y, back), x, y, back, right, up, None)

    def _cell_bounds(
        self,
        placed: _Placed,
        order: _Order,
        x: Float,
        y: Float,
        back: Mask,
        right: Mask,
        up: Mask,
        probes: Sequence[Probe] | None,
    ) -> CellBounds:
        def bounds(number: int) -> CellBounds:
            start = placed.starts[number]
            own = (
                self.layers[number].cell_bounds(x - start[0], y - start[1], back, right, up)
                if probes is None
                else probes[number].cell_bounds
            )
            return replace(own, cell_max=own.cell_max + order.levels[number])

        if placed.stacking is None:
            return _select(back, bounds(-1), bounds(0))
        first = bounds(0)
        for number in range(1, len(self.layers)):
            first = _select(order.ranks[number] == 0, bounds(number), first)
        # The order is that of one crossing of the draft.
        across, along = placed.cells[0].locate(x), placed.cells[1].locate(y)
        return CellBounds(
            first.cell_max,
            minimum(first.side_x, dr.select(right, across.above, across.below)),
            minimum(first.side_y, dr.select(up, along.above, along.below)),
        )

    def surface(self, x: Float, y: Float, back: Mask, ray: tuple[Vec3, Float] | None = None) -> SurfacePoint:
        """The first yarn at draft coordinates x, y (millimetres); for `ray` see `YarnGeometry.surface`."""
        types = array_types(x)
        points, tubes, order = self._points(x, y, back)
        found = _Found.of(points, order)
        point = found.shown(points)
        point.hole = found.nothing
        if ray is not None:
            meet_tube(point, found.shown(tubes), self.layers[0].twist_of(point.is_warp, back, types), ray)
        return point

    def sheets(self, x: Float, y: Float, back: Mask) -> list[Sheet]:
        """The layers behind what shows at draft coordinates x, y (millimetres), those next to it first."""
        points, _, order = self._points(x, y, back)
        found = _Found.of(points, order)
        layers = [
            Sheet(
                ~point.hole & (rank > found.rank) & (rank < _ABSENT),
                point.is_warp,
                point.warp_thread,
                point.weft_thread,
            )
            for point, rank in zip(points, order.ranks, strict=True)
        ]
        sheets = []
        for place in range(1, len(layers)):
            sheet = replace(layers[0], covered=layers[0].covered & (order.ranks[0] == place))
            for layer, rank in zip(layers[1:], order.ranks[1:], strict=True):
                sheet = _select(rank == place, layer, sheet)
            sheets.append(sheet)
        return sheets

    def _points(self, x: Float, y: Float, back: Mask) -> tuple[list[SurfacePoint], list[Tube], _Order]:
        types = array_types(x)
        placed = self._on(types)
        order = placed.order(x, y, back)
        points, tubes = [], []
        for layer, start, (ends, picks), level in zip(
            self.layers, placed.starts, placed.threads, order.levels, strict=True
        ):
            point, tube = layer.surface_and_tube(x - start[0], y - start[1], back)
            point.height, tube.height = point.height + level, tube.height + level
            point.warp_thread = dr.gather(types.UInt32, ends, point.warp_thread)
            point.weft_thread = dr.gather(types.UInt32, picks, point.weft_thread)
            point.x, point.y = x, y
            points.append(point)
            tubes.append(tube)
        return points, tubes, order


def _highest_shown(stack: StackedGeometry, number: int) -> tuple[float, float]:
    """Highest warp and weft of a layer where it is one of the cloth, as shares of the highest anywhere.

    Elsewhere its threads are others' layers, and float as none of its own do.
    """
    layout, layer = stack.layout, stack.layout.layers[number]
    words = stack.layers[number].words[0].reshape(-1, 2)
    if layout.stacking is not None:
        here = layout.stacking.ranks[:, number] >= 0
        shown = here[layout.stacking.regions[np.ix_(layer.picks, layer.ends)]]
        # Cells of the layer are wider than those of the draft, and reach into the regions beside.
        for axis in (0, 1):
            shown = shown | np.roll(shown, 1, axis) | np.roll(shown, -1, axis)
        words = words[shown.ravel()]
    warp, weft = (words.max(axis=0, initial=0) >> CELL_MAX_SHIFT) / CELL_MAX_LEVELS
    return float(warp), float(weft)


# More than the rank of any layer: of those that are absent, and where none shows.
_ABSENT = 255


@dataclass
class _Found:
    """Which of the layers shows.

    Attributes:
        rank: of the layer that shows; `_ABSENT` where none does.
        before: of each layer whether it is the one that shows, or one before it, which has a hole there.
        nothing: no layer shows.
        is_shown: of each layer but the first, whether it is nearer than all that stand before it in the list.
    """

    rank: UInt
    before: list[Mask]
    nothing: Mask
    is_shown: list[Mask]

    @classmethod
    def of(cls, records: Sequence[Any], order: _Order) -> _Found:
        """From the holes of all layers at some places."""
        ranks = [
            dr.select(record.hole, _ABSENT, rank) for record, rank in zip(records, order.ranks, strict=True)
        ]
        best, is_shown = ranks[0], []
        for rank in ranks[1:]:
            is_shown.append(rank < best)
            best = dr.select(rank < best, rank, best)
        return cls(best, [rank <= best for rank in order.ranks], best == _ABSENT, is_shown)

    def shown(self, records: Sequence[_Record]) -> _Record:
        """The record of the layer that shows; of the first where none does."""
        found = records[0]
        for record, nearer in zip(records[1:], self.is_shown, strict=True):
            found = _select(nearer, record, found)
        return found


def _select(mask: Mask, first: Any, second: Any) -> Any:
    """Field by field, of two records of a class."""
    kind = type(first)
    chosen = {}
    for entry in fields(kind):
        one, other = getattr(first, entry.name), getattr(second, entry.name)
        nested = isinstance(one, CellBounds)
        chosen[entry.name] = _select(mask, one, other) if nested else dr.select(mask, one, other)
    return kind(**chosen)


ClothGeometry = YarnGeometry | StackedGeometry


def cloth_geometry(layout: ClothLayout) -> ClothGeometry:
    """The surface of a cloth: of one plane, or of all its layers."""
    return StackedGeometry(layout) if layout.layers else YarnGeometry(layout)
