"""The surface of layered cloth: planes of yarn upon one another, each seen through the holes of those before.

Every layer is the cloth of its own threads (`geometry.py`), which fill its plane. The planes are as far apart
as the highest yarns of both reach, so none cuts through another; z = 0 is in the middle of them all. Rays
follow one height field a face, that of the first layer which has yarn there: searches, shadows, holes and
parallax are those of `rays.py`. As everywhere in height fields, yarns are walls, here down to the next layer.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from copy import copy
from dataclasses import dataclass, fields, replace
from functools import reduce
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, FloatType, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, array_types, maximum, minimum, upload
from loomlight.yarn.cells import Cell, upload_family
from loomlight.yarn.flanks import Sheet, SurfacePoint, Tube, meet_tube
from loomlight.yarn.geometry import (
    CellBounds,
    Crossing,
    Probe,
    Relief,
    Run,
    Shown,
    YarnGeometry,
    next_outline,
    shown_surface,
)
from loomlight.yarn.layout import ClothLayout
from loomlight.yarn.planes import Choose, PlaneTables, choose_cell, chooser, first_of
from loomlight.yarn.quilt import QuiltRelief, quilted, wadding_of
from loomlight.yarn.tables import Scalars
from loomlight.yarn.threads import CELL_MAX_LEVELS, CELL_MAX_SHIFT, place_family, section_drop

# Ranks in a word, and bits of each: the largest is of layers that are absent, and where none shows.
_RANKS, _RANK_BITS = 8, 4
_ABSENT = (1 << _RANK_BITS) - 1


@dataclass
class _Order:
    """Which layer lies upon which at some places, as a face shows them.

    Attributes:
        ranks: of each layer, 0 first; `_ABSENT` where it is none of them.
        level: height of the plane, millimetres, of the layer chosen among those of some numbers.
    """

    ranks: list[UInt]
    level: Callable[[Choose, Sequence[int]], Float]


class _Placed:
    """What places the layers of one cloth on one backend.

    Attributes:
        starts: x and y where each layer's cells begin.
        planes, scalar: tables of the layers, and numbers of the fabric.
        threads: numbers in the draft of all layers' ends, and of picks, with the place of each layer's first.
        gains: largest height of each layer above its plane, as a share of that of the whole cloth.
        high, per_high: the latter and its inverse.
        highest_first: of each layer, front and back: the highest of its planes where it is first.
        ties: the ties of the cloth, whose planes follow those of the layers.
        finest_of_ties: smallest cell of the threads that tie, of each.
        dips: how deep the layer beneath each of them dives.
        tied: of each face, the highest of its ties as a share of the highest of all; None without any.
        quilt: the relief of quilted cloth; None without.
        lifts: by how much it moves each plane, millimetres.
    """

    def __init__(
        self,
        layout: ClothLayout,
        levels: NDArray[np.float64],
        highest: list[float],
        ties: list[_TieHeights],
        quilt: tuple[NDArray[np.float64], NDArray[np.float64], tuple[float, float]] | None,
        types: ArrayTypes,
    ) -> None:
        self._types = types
        planes = [*layout.layers, *(tied.layer for tied in layout.ties)]
        self.planes = PlaneTables([plane.layout for plane in planes], types)
        self.scalar = Scalars(types)
        high = highest[-1]
        self.starts = [[dr.opaque(types.Float, start) for start in plane.start] for plane in planes]
        self.threads = [
            (
                upload(types.UInt32, np.concatenate(threads).astype(np.uint32)),
                [
                    dr.opaque(types.UInt32, sum(len(part) for part in threads[:number]))
                    for number in range(len(threads))
                ],
            )
            for threads in zip(*((plane.ends, plane.picks) for plane in planes), strict=True)
        ]
        self.gains = [dr.opaque(types.Float, own / high) for own in highest[:-1]]
        self.high = dr.opaque(types.Float, high)
        self.per_high = dr.opaque(types.Float, 1 / high)
        self.ties = layout.ties
        self.finest_of_ties = []
        for tied in layout.ties:
            family = tied.layer.layout.warp if tied.is_warp else tied.layer.layout.weft
            self.finest_of_ties.append(dr.opaque(types.Float, place_family(family).finest))
        self.dips = [dr.opaque(types.Float, heights.dip) for heights in ties]
        self.tied: list[Float | None] = [None, None]
        for face in (False, True):
            tops = [heights.top for tied, heights in zip(layout.ties, ties, strict=True) if tied.back == face]
            self.tied[face] = dr.opaque(types.Float, max(tops) / high) if tops else None
        self.quilt = None
        if quilt is not None:
            heights, lifts, finest = quilt
            self.quilt = QuiltRelief(heights, layout.size, finest, types)
            self.lifts = [
                dr.opaque(types.Float, float(lifts[layer]))
                for layer in (*range(len(layout.layers)), *(tied.over for tied in layout.ties))
            ]
        self._levels = upload(types.Float, levels.ravel().astype(np.float32))
        self._count = len(layout.layers)
        self._level = [dr.opaque(types.Float, float(level)) for level in levels[0]]
        self.stacking = layout.stacking
        if self.stacking is None:
            return
        ranks = self.stacking.ranks
        last = ranks.max(axis=1, keepdims=True)
        of_faces = [np.where(ranks < 0, _ABSENT, side) for side in (ranks, last - ranks)]
        # Words of eight ranks each.
        words = np.pad(np.concatenate(of_faces).astype(np.uint32), ((0, 0), (0, -self._count % _RANKS)))
        words = words.reshape(2 * len(ranks), -1, _RANKS) << (_RANK_BITS * np.arange(_RANKS, dtype=np.uint32))
        self._words = words.shape[1]
        self._ranks = upload(types.UInt32, np.bitwise_or.reduce(words, axis=-1).ravel())
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
            levels = [side * level for level in self._level]
            return _Order(ranks, lambda choose, numbers: choose([levels[number] for number in numbers]))
        across, along = self.cells[0].locate(x), self.cells[1].locate(y)
        stack = dr.gather(types.UInt32, self._regions, along.thread * self._ends + across.thread)
        face = dr.select(back, self._stacks, types.UInt32(0))
        words = [
            dr.gather(types.UInt32, self._ranks, (stack + face) * self._words + word)
            for word in range(self._words)
        ]
        ranks = [(words[k // _RANKS] >> (_RANK_BITS * (k % _RANKS))) & _ABSENT for k in range(count)]

        def level(choose: Choose, numbers: Sequence[int]) -> Float:
            number = choose([types.UInt32(number) for number in numbers])
            return side * dr.gather(types.Float, self._levels, stack * count + number)

        return _Order(ranks, level)


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
        self._ties = [YarnGeometry(tied.layer.layout) for tied in layout.ties]
        straight = [all(family.is_straight for family in layer.families) for layer in self.layers]
        self._wadding = wadding_of(layout, straight)
        self._quilt = quilted(layout, self._wadding)
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
    def _lifts(self) -> NDArray[np.float64]:
        """How far quilting moves each layer towards the back where stitches hold it [layers], millimetres.

        Wadding is squeezed there: what lies before it moves by all of its thickness, what lies behind stays.
        """
        if self._quilt is None:
            return np.zeros(len(self.layers))
        thickness = np.where(self._wadding, 2 * self.reaches, 0.0)
        order = np.argsort(self.ranks[0])
        behind = np.empty(len(thickness))
        behind[order] = thickness.sum() - np.cumsum(thickness[order])
        return behind + thickness / 2

    def _tie_heights(self) -> list[_TieHeights]:
        """How high each of the ties rises and how low it reaches, and how deep what is beneath it dives."""
        scales = [float(np.max(np.asarray(scale))) for scale in self.height_scale]
        levels, ranks = self.levels, self.ranks
        found = []
        for tied, geometry in zip(self.layout.ties, self._ties, strict=True):
            own = 0 if tied.is_warp else 1
            family, scale = geometry.families[own], scales[own]
            words = geometry.words[0][..., own][tied.places]
            rise = scale * family.highest * float(words.max() >> CELL_MAX_SHIFT) / CELL_MAX_LEVELS
            last = ranks.max(axis=1)
            outermost = ranks[:, tied.over] == (last if tied.back else 0)
            side = -1 if tied.back else 1
            level = side * levels[outermost, tied.over]
            lift = float(self._lifts[tied.over])
            dip = scale * float(section_drop(family.half_width, family.half_width).max())
            drop = scale * float(family.edge_drop.max())
            found.append(
                _TieHeights(
                    float(level.max()) + rise + (lift if tied.back else 0),
                    float(level.min()) - drop - (0 if tied.back else lift),
                    dip,
                )
            )
        return found

    @property
    def height_bounds(self) -> tuple[float, float]:
        """No thread is ever lower or higher than this, millimetres, on either face."""
        low = np.array([layer.height_bounds[0] for layer in self.layers])
        levels, present, high = self.levels, self.ranks >= 0, self.reaches
        ties = self._tie_heights()
        for tied, heights in zip(self.layout.ties, ties, strict=True):
            low[tied.over] -= heights.dip
        lifts = self._lifts
        return (
            min(
                float((levels + low - lifts)[present].min()),
                float((low - levels)[present].min()),
                *(heights.bottom for heights in ties),
            ),
            max(
                float((levels + high)[present].max()),
                float((high - levels + lifts)[present].max()),
                *(heights.top for heights in ties),
            ),
        )

    def upload(self, types: ArrayTypes) -> None:
        """Puts all that points and probes read on a backend, which otherwise happens at first use."""
        placed = self._on(types)
        self._scales(placed)
        self._twists(placed)

    def _on(self, types: ArrayTypes) -> _Placed:
        levels, ties = self.levels, self._tie_heights()
        key = levels.tobytes() + repr(ties).encode()
        kept = self._placed.get(types.Float)
        if kept is None or kept[0] != key:
            highest = [layer.height_bounds[1] for layer in self.layers]
            highest.append(self.height_bounds[1])
            quilt = None if self._quilt is None else (self._quilt, self._lifts, self.finest)
            placed = _Placed(self.layout, levels, highest, ties, quilt, types)
            kept = self._placed[types.Float] = key, placed
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
            start = placed.starts[number]
            own = placed.planes.max_heights(
                number % len(self.layers), x - start[0], y - start[1], back, right, up
            )
            level = level * placed.per_high
            return [(radius, dr.fma(share, placed.gains[number], level)) for radius, share in own]

        if placed.stacking is not None:
            layers = [
                bounds(number, dr.select(back, behind, front))
                for number, (front, behind) in enumerate(placed.highest_first)
            ]
            found = [
                (ring[0][0], reduce(maximum, [share for _, share in ring]))
                for ring in zip(*layers, strict=True)
            ]
        else:
            order = placed.order(x, y, back)
            found = [
                (radius, dr.select(back, behind, front))
                for (radius, front), (_, behind) in zip(
                    bounds(0, order.level(first_of, [0])),
                    bounds(-1, order.level(first_of, [len(self.layers) - 1])),
                    strict=True,
                )
            ]
        for top, is_face in zip(placed.tied, (~back, back), strict=True):
            if top is not None:
                found = [(radius, dr.select(is_face, maximum(share, top), share)) for radius, share in found]
        if placed.quilt is not None:
            # What lies before the wadding moves with the relief, on the front.
            lift = dr.select(back, 0, placed.lifts[0] * placed.per_high)
            windows = placed.quilt.windows(x, y)
            found = [
                (radius, dr.fma(lift, highest, share))
                for (radius, share), highest in zip(found, windows, strict=True)
            ]
        return found

    def probe(self, x: Float, y: Float, back: Mask, right: Mask, up: Mask) -> Probe:
        """The surface at draft coordinates x, y (millimetres) for a search."""
        types = array_types(x)
        placed = self._on(types)
        here = self._locate(placed, x, y, back)
        point, run, (slope_x, slope_y), _ = self._evaluate(placed, here, x, y, back)
        shown, crossing = here.shown, here.shown.crossing
        bounds = self._cell_bounds(placed, here.order, here.cells, here.ties, x, y, back, right, up)
        # A layer before the one that shows is a hole here, and may begin ahead.
        far_x, far_y = (types.Float(1e6),) * 2 if placed.stacking is None else (bounds.side_x, bounds.side_y)
        edge_x = next_outline(crossing.warp, shown, run, ~shown.is_warp, right)
        edge_y = next_outline(crossing.weft, shown, run, shown.is_warp, up)
        for before, (warp, weft) in zip(here.found.before, here.cells, strict=False):
            edge_x = minimum(edge_x, dr.select(before, _outline_of_hole(warp, right), far_x))
            edge_y = minimum(edge_y, dr.select(before, _outline_of_hole(weft, up), far_y))
        for tie in here.ties:
            side_x, side_y = tie.sides(right, up)
            # Within its crossing a tie may begin beside its thread.
            next_x, next_y = (
                (dr.select(tie.here, _outline_of_hole(tie.warp, right), side_x), side_y)
                if tie.is_warp
                else (side_x, dr.select(tie.here, _outline_of_hole(tie.weft, up), side_y))
            )
            before = tie.on_face & ~tie.shows
            edge_x = minimum(edge_x, dr.select(before, next_x, 1e6))
            edge_y = minimum(edge_y, dr.select(before, next_y, 1e6))
        yarn = dr.select(
            shown.is_warp, types.UInt32(crossing.warp.thread) * 2 + 1, types.UInt32(crossing.weft.thread) * 2
        )
        return Probe(
            height=point.height,
            hole=here.found.nothing,
            slope_x=slope_x,
            slope_y=slope_y,
            # Among the numbers of yarns in one layer there is room for those of the others.
            yarn=yarn * len(here.cells) + here.found.number,
            cell_bounds=bounds,
            edge_x=minimum(edge_x, far_x),
            edge_y=minimum(edge_y, far_y),
        )

    def cell_bounds(self, x: Float, y: Float, back: Mask, right: Mask, up: Mask) -> CellBounds:
        """The part of `probe` that rays above the cell need: of the face's first layer, which is highest."""
        placed = self._on(array_types(x))
        order = placed.order(x, y, back)
        cells = self._cells(placed, x, y)
        ties = self._tied(placed, order, cells, back)
        return self._cell_bounds(placed, order, cells, ties, x, y, back, right, up)

    def _cell_bounds(
        self,
        placed: _Placed,
        order: _Order,
        cells: list[tuple[Cell, Cell]],
        ties: list[_Tied],
        x: Float,
        y: Float,
        back: Mask,
        right: Mask,
        up: Mask,
    ) -> CellBounds:
        types, layers = array_types(x), len(self.layers)
        if placed.stacking is None:
            numbers, masks = [0, layers - 1], [types.Bool(back)]
        else:
            numbers, masks = list(range(layers)), [rank == 0 for rank in order.ranks[1:]]
        choose = chooser(masks)
        warp, weft = (choose_cell(masks, [cells[number][family] for number in numbers]) for family in (0, 1))

        def chosen(values: Sequence[Any]) -> Any:
            return choose([values[number] for number in numbers])

        words = placed.planes.words_of(chosen, warp, weft)
        warp_above = ((words[0] & 1) == 1) ^ back
        levels = [chosen([of_plane[family] for of_plane in placed.planes.levels]) for family in (0, 1)]
        level = dr.select(warp_above, *(s * own for s, own in zip(self._scales(placed), levels, strict=True)))
        word = dr.select(warp_above, words[0], words[1])
        bounds = CellBounds(
            cell_max=dr.fma(types.Float(word >> CELL_MAX_SHIFT), level, order.level(choose, numbers)),
            side_x=dr.select(right, warp.above, warp.below),
            side_y=dr.select(up, weft.above, weft.below),
        )
        for number, tie in enumerate(ties, start=layers):
            own = 0 if tie.is_warp else 1
            scale = self._scales(placed)[own] * placed.planes.levels[number][own]
            top = dr.fma(types.Float(tie.word >> CELL_MAX_SHIFT), scale, order.level(first_of, [tie.over]))
            side_x, side_y = tie.sides(right, up)
            bounds = CellBounds(
                dr.select(tie.here, maximum(bounds.cell_max, top), bounds.cell_max),
                dr.select(tie.on_face, minimum(bounds.side_x, side_x), bounds.side_x),
                dr.select(tie.on_face, minimum(bounds.side_y, side_y), bounds.side_y),
            )
        if placed.quilt is not None:
            relief = placed.quilt.bounds(x, y, right, up)
            lift = dr.select(back, 0, placed.lifts[0])
            return CellBounds(
                dr.fma(lift, relief.cell_max, bounds.cell_max),
                minimum(bounds.side_x, relief.side_x),
                minimum(bounds.side_y, relief.side_y),
            )
        if placed.stacking is None:
            return bounds
        # The order is that of one crossing of the draft.
        across, along = placed.cells[0].locate(x), placed.cells[1].locate(y)
        return CellBounds(
            bounds.cell_max,
            minimum(bounds.side_x, dr.select(right, across.above, across.below)),
            minimum(bounds.side_y, dr.select(up, along.above, along.below)),
        )

    def surface(self, x: Float, y: Float, back: Mask, ray: tuple[Vec3, Float] | None = None) -> SurfacePoint:
        """The first yarn at draft coordinates x, y (millimetres); for `ray` see `YarnGeometry.surface`."""
        placed = self._on(array_types(x))
        here = self._locate(placed, x, y, back)
        point, _, _, tube = self._evaluate(placed, here, x, y, back)
        if ray is not None:
            meet_tube(point, tube, self._twist_of(placed, point.is_warp, back), ray)
        return point

    def sheets(self, x: Float, y: Float, back: Mask) -> list[Sheet]:
        """The layers behind what shows at draft coordinates x, y (millimetres), those next to it first."""
        types = array_types(x)
        placed = self._on(types)
        here = self._locate(placed, x, y, back)
        layers = []
        for number, (warp, weft) in enumerate(here.cells[: len(self.layers)]):
            words = placed.planes.words_at(number, warp, weft)
            above = ((words[0] & 1) == 1) ^ back
            rank = here.order.ranks[number]
            end, pick = (
                dr.gather(types.UInt32, threads, first[number] + cell.thread)
                for (threads, first), cell in zip(placed.threads, (warp, weft), strict=True)
            )
            layers.append(
                Sheet(
                    here.covered[number] & (here.found.tied | (rank > here.found.rank)) & (rank < _ABSENT),
                    _covers(warp) & (~_covers(weft) | above),
                    end,
                    pick,
                )
            )
        sheets = []
        for place in range(1, len(layers)):
            sheet = replace(layers[0], covered=layers[0].covered & (here.order.ranks[0] == place))
            for layer, rank in zip(layers[1:], here.order.ranks[1:], strict=True):
                sheet = _select(rank == place, layer, sheet)
            sheets.append(sheet)
        return sheets

    def _scales(self, placed: _Placed) -> tuple[Float, Float]:
        warp, weft = self.height_scale
        return placed.scalar("warp scale", warp), placed.scalar("weft scale", weft)

    def _twists(self, placed: _Placed) -> tuple[Float, Float]:
        warp, weft = self.twist
        return placed.scalar("warp twist", warp), placed.scalar("weft twist", weft)

    def _twist_of(self, placed: _Placed, is_warp: Mask, back: Mask) -> Float:
        """ψ of a family as a face shows it, radians."""
        twist = dr.select(is_warp, *self._twists(placed))
        return dr.select(back, -twist, twist)

    def _cells(self, placed: _Placed, x: Float, y: Float) -> list[tuple[Cell, Cell]]:
        """Cells of warp and weft in each layer, then of ties."""
        return [
            placed.planes.locate(number, x - start[0], y - start[1])
            for number, start in enumerate(placed.starts)
        ]

    def _locate(self, placed: _Placed, x: Float, y: Float, back: Mask) -> _Located:
        """Which layer shows at a place, and which thread of it: the cells of all layers tell."""
        order = placed.order(x, y, back)
        cells = self._cells(placed, x, y)
        covered = [_covers(warp) | _covers(weft) for warp, weft in cells[: len(self.layers)]]
        ties = self._tied(placed, order, cells, back)
        found = _Found.of(covered, order, [tie.shows for tie in ties])
        warp, weft = (
            choose_cell(found.is_shown, [of_layer[family] for of_layer in cells]) for family in (0, 1)
        )
        words = placed.planes.words_of(found.choose, warp, weft)
        crossing = Crossing(warp, weft, words, ((words[0] & 1) == 1) ^ back)
        is_warp = _covers(warp) & (~_covers(weft) | crossing.warp_above)
        word = dr.select(is_warp, words[0], words[1])
        shown = Shown(is_warp, found.nothing, ((word & 1) == 1) ^ back, word, crossing)
        return _Located(order, cells, covered, ties, found, shown)

    def _tied(
        self, placed: _Placed, order: _Order, cells: list[tuple[Cell, Cell]], back: Mask
    ) -> list[_Tied]:
        """The ties at a place, where their layer is the outermost of the face."""
        found = []
        for tied, (number, (warp, weft)) in zip(
            placed.ties, enumerate(cells[len(self.layers) :], start=len(self.layers)), strict=True
        ):
            finest = placed.finest_of_ties[number - len(self.layers)]
            on_face = back == tied.back
            if placed.stacking is not None:
                on_face &= order.ranks[tied.over] == 0
            words = placed.planes.words_at(number, warp, weft)
            word, crossed = (words[0], words[1]) if tied.is_warp else (words[1], words[0])
            here = on_face & (((word & 1) == 1) ^ back)
            shows = here & _covers(warp if tied.is_warp else weft)
            found.append(
                _Tied(tied.over, tied.is_warp, warp, weft, word, crossed, finest, on_face, here, shows)
            )
        return found

    def _relief(self, placed: _Placed, here: _Located, x: Float, y: Float, back: Mask) -> Relief | None:
        """How far the layer that shows is pushed down by what ties and quilts it; None without any ties."""
        if not here.ties:
            return None
        types = array_types(here.shown.crossing.warp.across)
        relief = Relief(types.Float(0), types.Float(0), types.Float(0))
        for tie, dip in zip(here.ties, placed.dips, strict=True):
            dips = tie.here & (here.found.number == tie.over)
            (across, slope_x), (along, slope_y) = _dimple(tie.warp), _dimple(tie.weft)
            relief.height -= dr.select(dips, dip * across * along, 0)
            relief.slope_x -= dr.select(dips, dip * slope_x * along, 0)
            relief.slope_y -= dr.select(dips, dip * across * slope_y, 0)
        if placed.quilt is not None:
            quilt, lift = placed.quilt.at(x, y), here.found.choose(placed.lifts)
            lift = dr.select(back, -lift, lift)
            relief.height = dr.fma(lift, quilt.height, relief.height)
            relief.slope_x = dr.fma(lift, quilt.slope_x, relief.slope_x)
            relief.slope_y = dr.fma(lift, quilt.slope_y, relief.slope_y)
        return relief

    def _evaluate(
        self, placed: _Placed, here: _Located, x: Float, y: Float, back: Mask
    ) -> tuple[SurfacePoint, Run, tuple[Float, Float], Tube]:
        """The one evaluation of the layer that shows, see `shown_surface`; threads are those of the draft."""
        types = array_types(x)
        found, crossing = here.found, here.shown.crossing
        tables = placed.planes.chosen(found.choose)
        twist = self._twist_of(placed, here.shown.is_warp, back)
        starts = [found.choose([start[axis] for start in placed.starts]) for axis in (0, 1)]
        local = x - starts[0], y - starts[1]
        relief = self._relief(placed, here, x, y, back)
        point, run, slopes, tube = shown_surface(
            tables, here.shown, local, self._scales(placed), twist, relief
        )
        numbers = [*range(len(self.layers)), *(tie.over for tie in here.ties)]
        level = here.order.level(found.choose, numbers)
        point.height, tube.height = point.height + level, tube.height + level
        point.plane = level if relief is None else level + relief.height
        owners = [*range(len(self.layers)), *(tied.own for tied in self.layout.ties)]
        point.layer = found.choose([types.UInt32(owner) for owner in owners])
        point.x, point.y = x, y
        point.warp_thread, point.weft_thread = (
            dr.gather(types.UInt32, threads, found.choose(first) + cell.thread)
            for (threads, first), cell in zip(placed.threads, (crossing.warp, crossing.weft), strict=True)
        )
        return point, run, slopes, tube


def _covers(cell: Cell) -> Mask:
    """Whether the thread covers the place in its cell."""
    return abs(cell.across) < cell.half_width


def _dimple(cell: Cell) -> tuple[Float, Float]:
    """1 in the middle of a cell, smoothly 0 at its ends, and its derivative."""
    per_size = dr.rcp(cell.below + cell.above)
    place = (cell.below - cell.above) * per_size
    rest = 1 - dr.square(place)
    return dr.square(rest), -8 * place * rest * per_size


def _outline_of_hole(cell: Cell, forwards: Mask) -> Float:
    """Distance along one axis to the next outline of a family that has a gap here."""
    across = dr.select(forwards, cell.across, -cell.across)
    ahead = dr.select(forwards, cell.above, cell.below)
    beyond = 2 * ahead + across - cell.half_width
    within = dr.select(across < -cell.half_width, -cell.half_width, cell.half_width) - across
    return dr.select(across >= cell.half_width, beyond, within)


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


@dataclass
class _Found:
    """Which of the layers shows.

    Attributes:
        rank: of the layer that shows; `_ABSENT` where none does.
        before: of each layer whether it lies before the one that shows, and has a hole there.
        nothing: no layer shows.
        is_shown: of each plane but the first, whether it is nearer than all that stand before it in the list.
        choose: chooses among the values of all planes that of the one that shows.
        number: of the plane that shows.
        tied: it is one of ties, which lie before all layers.
    """

    rank: UInt
    before: list[Mask]
    nothing: Mask
    is_shown: list[Mask]
    choose: Choose
    number: UInt
    tied: Mask

    @classmethod
    def of(cls, covered: Sequence[Mask], order: _Order, ties: Sequence[Mask]) -> _Found:
        """From where each layer has yarn, and where ties show."""
        ranks = [dr.select(yarn, rank, _ABSENT) for yarn, rank in zip(covered, order.ranks, strict=True)]
        best, is_shown = ranks[0], []
        for rank in ranks[1:]:
            is_shown.append(rank < best)
            best = dr.select(rank < best, rank, best)
        before = [rank < best for rank in order.ranks]
        nothing, types = best == _ABSENT, array_types(best)
        tied = reduce(lambda first, second: first | second, ties, types.Bool(False))
        if ties:
            before, nothing = [mask & ~tied for mask in before], nothing & ~tied
        choose = chooser([*is_shown, *ties])
        number = choose([types.UInt32(plane) for plane in range(len(covered) + len(ties))])
        return cls(best, before, nothing, [*is_shown, *ties], choose, number, tied)


@dataclass
class _Tied:
    """Ties at some places.

    Attributes:
        over, is_warp: see `Ties`.
        warp, weft: cells of their plane.
        word: run word of the thread that may tie.
        crossed: that of the thread which it would lie upon, whose runs end at ties.
        finest: smallest cell of the family that ties, millimetres.
        on_face: they may be seen on the face.
        here: this crossing is a tie.
        shows: its thread covers the place.
    """

    over: int
    is_warp: bool
    warp: Cell
    weft: Cell
    word: UInt
    crossed: UInt
    finest: Float
    on_face: Mask
    here: Mask
    shows: Mask

    def sides(self, right: Mask, up: Mask) -> tuple[Float, Float]:
        """Distances along x and y up to which there is a tie all the way, or none.

        Along its thread up to the end of the cell; along those that it crosses to where the run ends.
        """
        types = array_types(self.finest)
        forwards = right if self.is_warp else up
        # Of cells that are not there, and of the tie's own, only the rest of the cell counts.
        ahead = (self.crossed >> dr.select(forwards, types.UInt32(8), types.UInt32(1))) & 127
        beyond = self.finest * dr.select(self.here, 0, types.Float(ahead))
        side_x = dr.select(right, self.warp.above, self.warp.below)
        side_y = dr.select(up, self.weft.above, self.weft.below)
        return (side_x + beyond, side_y) if self.is_warp else (side_x, side_y + beyond)


@dataclass
class _TieHeights:
    """Heights of ties in millimetres: their highest and lowest, and how deep what is beneath them dives."""

    top: float
    bottom: float
    dip: float


@dataclass
class _Located:
    """What lies at some places.

    Attributes:
        order: of the layers.
        cells: of warp and weft in each layer, then of ties.
        covered: whether a layer has yarn there.
        ties: what may tie there.
        found, shown: the layer that shows, and its thread.
    """

    order: _Order
    cells: list[tuple[Cell, Cell]]
    covered: list[Mask]
    ties: list[_Tied]
    found: _Found
    shown: Shown


def _select(mask: Mask, first: Sheet, second: Sheet) -> Sheet:
    """Field by field."""
    return Sheet(
        *(dr.select(mask, getattr(first, entry.name), getattr(second, entry.name)) for entry in fields(Sheet))
    )


ClothGeometry = YarnGeometry | StackedGeometry


def cloth_geometry(layout: ClothLayout) -> ClothGeometry:
    """The surface of a cloth: of one plane, or of all its layers."""
    return StackedGeometry(layout) if layout.layers else YarnGeometry(layout)
