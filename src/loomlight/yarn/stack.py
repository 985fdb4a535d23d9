"""The surface of layered cloth: planes of yarn upon one another, each seen through the holes of those before.

Every layer is the cloth of its own threads (`geometry.py`), which fill its plane. The planes are as far apart
as the highest yarns of both reach, so none cuts through another; z = 0 is in the middle of them all. Rays
follow one height field a face, that of the first layer which has yarn there: searches, shadows, holes and
parallax are those of `rays.py`. As everywhere in height fields, yarns are walls, here down to the next layer.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from copy import copy
from dataclasses import fields, replace
from functools import reduce
from typing import Any, TypeVar

import drjit as dr
import numpy as np

from loomlight.core.arrays import Float, FloatType, Mask, Vec3
from loomlight.core.backend import ArrayTypes, array_types, minimum, upload
from loomlight.yarn.flanks import Sheet, SurfacePoint, Tube, meet_tube
from loomlight.yarn.geometry import CellBounds, Probe, YarnGeometry
from loomlight.yarn.layout import ClothLayout, Layer

_Record = TypeVar("_Record", SurfacePoint, Tube, Probe)


class _Placed:
    """What places one layer among the others, on one backend.

    Attributes:
        level: z of its plane, millimetres.
        gain, front, behind: a share s of the layer's own largest height is s·gain plus one of the others, as
            either face is seen, of the largest height of the cloth.
        start: see `Layer`.
        ends, picks: numbers in the draft of its threads.
    """

    def __init__(
        self, layer: Layer, level: float, highest: float, of_cloth: float, types: ArrayTypes
    ) -> None:
        self.level, self.gain, self.front, self.behind = (
            dr.opaque(types.Float, number)
            for number in (level, highest / of_cloth, level / of_cloth, -level / of_cloth)
        )
        self.start = [dr.opaque(types.Float, start) for start in layer.start]
        self.ends, self.picks = (
            upload(types.UInt32, np.asarray(threads, np.uint32)) for threads in (layer.ends, layer.picks)
        )


class StackedGeometry:
    """Analytic geometry of layered cloth: a `Surface`, see `YarnGeometry` for what its methods return.

    Attributes:
        layout: what it was made from; it has layers.
        size: width and height of the repeat, millimetres.
        layers: the geometry of each, the front one first.
    """

    def __init__(self, layout: ClothLayout) -> None:
        self.layout = layout
        self.size = layout.size
        self.layers = [YarnGeometry(layer.layout) for layer in layout.layers]
        self._placed: dict[type, tuple[tuple[float, ...], list[_Placed]]] = {}
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
    def levels(self) -> list[float]:
        """z of the plane of each layer, millimetres, descending."""
        highest = [layer.height_bounds[1] for layer in self.layers]
        below_top = np.cumsum(highest) + np.concatenate([[0], np.cumsum(highest)[:-1]])
        return [float(sum(highest) - depth) for depth in below_top]

    @property
    def height_bounds(self) -> tuple[float, float]:
        """No thread is ever lower or higher than this, millimetres, on either face."""
        bounds, levels = [layer.height_bounds for layer in self.layers], self.levels
        return (
            min(levels[-1] + bounds[-1][0], -levels[0] + bounds[0][0]),
            max(levels[0] + bounds[0][1], -levels[-1] + bounds[-1][1]),
        )

    def upload(self, types: ArrayTypes) -> None:
        """Puts all that points and probes read on a backend, which otherwise happens at first use."""
        for layer in self.layers:
            layer.upload(types)
        self._on(types)

    def _on(self, types: ArrayTypes) -> list[_Placed]:
        levels = tuple(self.levels)
        kept = self._placed.get(types.Float)
        if kept is None or kept[0] != levels:
            highest = [layer.height_bounds[1] for layer in self.layers]
            of_cloth = self.height_bounds[1]
            kept = (
                levels,
                [
                    _Placed(layer, level, own, of_cloth, types)
                    for layer, level, own in zip(self.layout.layers, levels, highest, strict=True)
                ],
            )
            self._placed[types.Float] = kept
        return kept[1]

    def height(self, x: Float, y: Float, back: Mask) -> tuple[Float, Mask]:
        """Height of the first yarn and whether there is none, at draft coordinates x, y in millimetres."""
        point = self.surface(x, y, back)
        return point.height, point.hole

    def max_heights(self, x: Float, y: Float, back: Mask, right: Mask, up: Mask) -> list[tuple[float, Float]]:
        """Bounds of heights ahead of draft coordinates x, y (mm): those of the first layer of the face."""

        def bounds(number: int) -> list[tuple[float, Float]]:
            placed, layer = self._on(array_types(x))[number], self.layers[number]
            own = layer.max_heights(x - placed.start[0], y - placed.start[1], back, right, up)
            offset = placed.front if number == 0 else placed.behind
            return [(radius, dr.fma(share, placed.gain, offset)) for radius, share in own]

        return [
            (radius, dr.select(back, behind, front))
            for (radius, front), (_, behind) in zip(bounds(0), bounds(-1), strict=True)
        ]

    def probe(self, x: Float, y: Float, back: Mask, right: Mask, up: Mask) -> Probe:
        """The surface at draft coordinates x, y (millimetres) for a search."""

        def probe(number: int, layer: YarnGeometry, placed: _Placed) -> Probe:
            here = layer.probe(x - placed.start[0], y - placed.start[1], back, right, up)
            level = dr.select(back, -placed.level, placed.level)
            bounds = replace(here.cell_bounds, cell_max=here.cell_bounds.cell_max + level)
            # Among the numbers of yarns in one layer there is room for those of the others.
            yarn = here.yarn * len(self.layers) + number
            return replace(here, height=here.height + level, yarn=yarn, cell_bounds=bounds)

        probes = self._each(array_types(x), probe)
        holes = [here.hole for here in probes]
        before = _are_before(holes, back)
        shown = _first(probes, holes, before)
        far = array_types(x).Float(1e6)
        for axis in ("edge_x", "edge_y"):
            # A layer before the one that shows is a hole here, and may begin ahead.
            edges = [
                dr.select(seen, getattr(here, axis), far) for here, seen in zip(probes, before, strict=True)
            ]
            setattr(shown, axis, reduce(minimum, edges))
        shown.hole = _all(holes)
        shown.cell_bounds = _select(back, probes[-1].cell_bounds, probes[0].cell_bounds)
        return shown

    def cell_bounds(self, x: Float, y: Float, back: Mask, right: Mask, up: Mask) -> CellBounds:
        """The part of `probe` that rays above the cell need: of the face's first layer, which is highest."""

        def bounds(number: int, sign: int) -> CellBounds:
            placed = self._on(array_types(x))[number]
            here = self.layers[number].cell_bounds(x - placed.start[0], y - placed.start[1], back, right, up)
            return replace(here, cell_max=here.cell_max + sign * placed.level)

        return _select(back, bounds(-1, -1), bounds(0, 1))

    def surface(self, x: Float, y: Float, back: Mask, ray: tuple[Vec3, Float] | None = None) -> SurfacePoint:
        """The first yarn at draft coordinates x, y (millimetres); for `ray` see `YarnGeometry.surface`."""
        types = array_types(x)
        found = self._found(x, y, back)
        holes = [point.hole for point, _ in found]
        before = _are_before(holes, back)
        point = _first([point for point, _ in found], holes, before)
        point.hole = _all(holes)
        if ray is not None:
            tube = _first([tube for _, tube in found], holes, before)
            meet_tube(point, tube, self.layers[0].twist_of(point.is_warp, back, types), ray)
        return point

    def sheets(self, x: Float, y: Float, back: Mask) -> list[Sheet]:
        """The layers behind what shows at draft coordinates x, y (millimetres), those next to it first.

        From behind the order is the other way round, so each layer is there twice, once for either face.
        """
        points = [point for point, _ in self._found(x, y, back)]
        before = _are_before([point.hole for point in points], back)

        def sheet(point: SurfacePoint, seen: Mask, face: Mask) -> Sheet:
            covered = ~point.hole & ~seen & face
            return Sheet(covered, point.is_warp, point.warp_thread, point.weft_thread)

        pairs = list(zip(points, before, strict=True))
        return [sheet(*pair, ~back) for pair in pairs[1:]] + [sheet(*pair, back) for pair in pairs[-2::-1]]

    def _found(self, x: Float, y: Float, back: Mask) -> list[tuple[SurfacePoint, Tube]]:
        types = array_types(x)

        def look(number: int, layer: YarnGeometry, placed: _Placed) -> tuple[SurfacePoint, Tube]:
            point, tube = layer.surface_and_tube(x - placed.start[0], y - placed.start[1], back)
            level = dr.select(back, -placed.level, placed.level)
            point.height, tube.height = point.height + level, tube.height + level
            point.warp_thread = dr.gather(types.UInt32, placed.ends, point.warp_thread)
            point.weft_thread = dr.gather(types.UInt32, placed.picks, point.weft_thread)
            point.x, point.y = x, y
            return point, tube

        return self._each(types, look)

    def _each(self, types: ArrayTypes, look: Callable[[int, YarnGeometry, _Placed], Any]) -> list[Any]:
        placed = self._on(types)
        return [look(number, layer, placed[number]) for number, layer in enumerate(self.layers)]


def _are_before(holes: Sequence[Mask], back: Mask) -> list[Mask]:
    """Of each layer whether all layers that the face shows before it have holes there."""
    count = len(holes)
    from_front = [_all(holes[:number]) for number in range(count)]
    from_back = [_all(holes[number + 1 :]) for number in range(count)]
    return [(~back & front) | (back & behind) for front, behind in zip(from_front, from_back, strict=True)]


def _all(masks: Sequence[Mask]) -> Any:
    """Whether all are true; true of none."""
    found: Any = True
    for mask in masks:
        found = mask if found is True else found & mask
    return found


def _first(records: Sequence[_Record], holes: Sequence[Mask], before: Sequence[Mask]) -> _Record:
    """The record of the layer that shows: it is no hole, and those before it are."""
    found = records[0]
    for record, hole, seen in zip(records[1:], holes[1:], before[1:], strict=True):
        found = _select(seen & ~hole, record, found)
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
