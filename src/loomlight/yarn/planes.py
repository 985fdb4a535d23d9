"""Tables of several planes of cloth on one backend, and the numbers of whichever plane each lane has chosen.

Where cloths lie upon one another, the cells of all planes say which has yarn at a place; the surface is then
evaluated once, with the numbers of that plane. Run words of all planes lie one behind the other.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np

from loomlight.core.arrays import Float, Int, Mask, UInt
from loomlight.core.backend import ArrayTypes, array_types, move, upload
from loomlight.yarn.cells import Cell, Count, UniformFamily, select_cell, thread_rows, upload_family
from loomlight.yarn.layout import ClothLayout
from loomlight.yarn.max_heights import TILE_CELLS, read_max_heights
from loomlight.yarn.tables import prepare_layout
from loomlight.yarn.threads import CELL_MAX_LEVELS, FamilyTables

# Of the values of all planes that of the plane of each lane.
Choose = Callable[[Sequence[Any]], Any]


def chooser(masks: Sequence[Mask]) -> Choose:
    """Chooses the first of some values, or a later one in the lanes of its mask; the last one of several."""

    def choose(values: Sequence[Any]) -> Any:
        found = values[0]
        for mask, value in zip(masks, values[1:], strict=True):
            if value is not found:
                found = dr.select(mask, value, found)
        return found

    return choose


def first_of(values: Sequence[Any]) -> Any:
    """Chooses the first of some values everywhere."""
    return values[0]


def choose_cell(masks: Sequence[Mask], cells: Sequence[Cell]) -> Cell:
    """The cell of the plane of each lane; see `chooser`."""
    found = cells[0]
    for mask, cell in zip(masks, cells[1:], strict=True):
        found = select_cell(mask, cell, found)
    return found


@dataclass
class ChosenUniform:
    """One family in the planes of lanes, whose threads are alike in each; see `UniformFamily`."""

    size: Float
    sine: Float
    half_tangent: Float
    arc: Float
    drop: Float
    is_uniform = True

    def span(self, thread: UInt, first: Int, last: Int) -> Float:
        del thread
        return array_types(self.size).Float(last - first) * self.size

    def bend(self, thread: UInt) -> tuple[Float, Float, Float]:
        del thread
        return self.sine, self.half_tangent, self.arc

    def edge_drop(self, thread: UInt, step: Int) -> Float:
        del thread, step
        return self.drop


@dataclass
class ChosenVaried:
    """One family in the planes of lanes, with a row of each thread in tables; see `VariedFamily`.

    Attributes:
        place, bend_rows: rows of all planes, one behind the other.
        base: the first row of the plane.
        count: threads of the plane.
        period: of the repeat, millimetres.
    """

    place: Float
    bend_rows: Float
    base: UInt
    count: Count
    period: Float
    is_uniform = False

    def span(self, thread: UInt, first: Int, last: Int) -> Float:
        return self._boundary(thread, last) - self._boundary(thread, first)

    def _boundary(self, thread: UInt, step: Int) -> Float:
        types = array_types(self.place)
        turns, inside = self._inside(thread, step)
        return dr.fma(turns, self.period, dr.gather(types.Float, self.place, inside * 4))

    def _inside(self, thread: UInt, step: Int) -> tuple[Float, UInt]:
        types = array_types(self.place)
        turns, inside = self.count.divide(types.Float(types.Int32(thread) + step))
        return turns, self.base + types.UInt32(inside)

    def bend(self, thread: UInt) -> tuple[Float, Float, Float]:
        row = dr.gather(array_types(self.place).Vector4, self.bend_rows, self.base + thread)
        return row[0], row[1], row[2]

    def edge_drop(self, thread: UInt, step: Int) -> Float:
        row = self._inside(thread, step)[1]
        return dr.gather(array_types(self.place).Float, self.bend_rows, row * 4 + 3)


class _FamilyOfPlanes:
    """One family in all planes."""

    def __init__(self, tables: Sequence[FamilyTables], types: ArrayTypes) -> None:
        self.located: list[Any] = [upload_family(of_plane, types) for of_plane in tables]
        self._uniform = [family for family in self.located if isinstance(family, UniformFamily)]
        if len(self._uniform) == len(self.located):
            return
        rows = [thread_rows(of_plane) for of_plane in tables]
        self._place, self._bend = (
            upload(types.Float, np.concatenate([of_plane[part] for of_plane in rows])) for part in (0, 1)
        )
        counts = [len(place) for place, _ in rows]
        self._bases = [dr.opaque(types.UInt32, sum(counts[:plane])) for plane in range(len(counts))]
        self._counts = [Count.of(count, types).numbers for count in counts]
        self._period = dr.opaque(types.Float, tables[0].period)

    def chosen(self, choose: Choose) -> ChosenUniform | ChosenVaried:
        """The family in the plane of each lane."""
        if len(self._uniform) == len(self.located):
            names = ("size", "sine", "half_tangent", "arc", "drop")
            return ChosenUniform(*(choose([getattr(f, name) for f in self._uniform]) for name in names))
        count = Count(*(choose(numbers) for numbers in zip(*self._counts, strict=True)))
        return ChosenVaried(self._place, self._bend, choose(self._bases), count, self._period)


@dataclass
class ChosenPlane:
    """Families of the plane of each lane, as `shown_surface` takes them."""

    warp: ChosenUniform | ChosenVaried
    weft: ChosenUniform | ChosenVaried


class PlaneTables:
    """The tables of planes of one cloth on one backend.

    Attributes:
        levels: of each plane, height of warp and weft in units of words' cell maxima, before β, millimetres.
    """

    def __init__(self, layouts: Sequence[ClothLayout], types: ArrayTypes) -> None:
        self._types = types
        tables = [prepare_layout(layout) for layout in layouts]
        self._warp = _FamilyOfPlanes([of_plane.warp for of_plane in tables], types)
        self._weft = _FamilyOfPlanes([of_plane.weft for of_plane in tables], types)
        crossings = np.cumsum([0] + [of_plane.words.size // 2 for of_plane in tables])
        self._words, words = move(
            types.UInt32, np.concatenate([of_plane.words.reshape(-1, 2) for of_plane in tables])
        )
        self._pyramids = []
        for number, of_plane in enumerate(tables):
            # Held once, on the CPU.
            part = words[crossings[number] : crossings[number + 1]]
            of_plane.words = part.reshape(of_plane.words.shape)
            pyramid, of_plane.max_heights = move(types.UInt32, of_plane.max_heights)
            self._pyramids.append((pyramid, dr.opaque(types.UInt32, of_plane.max_heights.shape[1])))
        self._bases = [dr.opaque(types.UInt32, int(first)) for first in crossings[:-1]]
        self._ends = [dr.opaque(types.UInt32, of_plane.words.shape[1]) for of_plane in tables]
        self.levels = [
            tuple(
                dr.opaque(types.Float, family.highest / CELL_MAX_LEVELS)
                for family in (of_plane.warp, of_plane.weft)
            )
            for of_plane in tables
        ]

    def locate(self, plane: int, x: Float, y: Float) -> tuple[Cell, Cell]:
        """The cells of warp and weft of a plane at its coordinates, millimetres."""
        return self._warp.located[plane].locate(x), self._weft.located[plane].locate(y)

    def chosen(self, choose: Choose) -> ChosenPlane:
        """Families of the plane of each lane."""
        return ChosenPlane(self._warp.chosen(choose), self._weft.chosen(choose))

    def words_of(self, choose: Choose, warp: Cell, weft: Cell) -> UInt:
        """Run words [2] of the crossing of two cells of the plane of each lane."""
        crossing = dr.fma(weft.thread, choose(self._ends), warp.thread) + choose(self._bases)
        return dr.gather(self._types.Index2, self._words, crossing)

    def words_at(self, plane: int, warp: Cell, weft: Cell) -> UInt:
        """Run words [2] of the crossing of two cells of a plane."""
        return self.words_of(lambda values: values[plane], warp, weft)

    def max_heights(
        self, plane: int, x: Float, y: Float, back: Mask, right: Mask, up: Mask
    ) -> list[tuple[float, Float]]:
        """Bounds of heights ahead of a plane's coordinates; see `YarnGeometry.max_heights`."""
        max_heights, columns = self._pyramids[plane]
        warp, weft = self.locate(plane, x, y)
        tile = weft.thread // TILE_CELLS * columns + warp.thread // TILE_CELLS
        return read_max_heights(max_heights, tile, back, right, up)
