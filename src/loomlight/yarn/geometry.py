"""The surface of woven cloth at any point: which thread shows, how high it is and how its fibres run.

Each thread is a tube whose centre line is made of torus arcs and straight pieces. Across it a circular
arc of ±80°, along it an arc upwards on top and downwards underneath, so that height and slope are
continuous through every interlacing: unlike the published segment (Irawan and Marschner 2012) its
normals belong to its heights, so shadows and parallax agree with shading.

With x across and s the distance from the nearest end of the run, m = a − sqrt(a² − x²) the drop of the
cross-section (a = w/(2 sin v_max)), h the half-length of the bent end and U the inclination:

    on top       ρ = h/sin U − m,  z = +(h·tan(U/2) − y²/(ρ + sqrt(ρ² − y²))) − m,   y = max(h − s, 0)
    underneath   ρ = h/sin U + m,  z = −(h·tan(U/2) − y²/(ρ + sqrt(ρ² − y²))) − m

Within s < m·sin U of its end a float's flank already belongs to the arc of the run beneath. Heights are
scaled by β. Below a thread on top the other one *dives* by that thread's lowest edge, smoothly across the
gap, so it never stands above it. From below everything is mirrored; see `core/footprint.py`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import product
from typing import Any, Self
from weakref import WeakKeyDictionary

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, FloatType, Int, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, array_types, clip, maximum, minimum, move, upload
from loomlight.yarn.flanks import Sheet, SurfacePoint, Tube, filled_share, meet_tube
from loomlight.yarn.layout import ClothLayout
from loomlight.yarn.threads import (
    CELL_MAX_LEVELS,
    CELL_MAX_SHIFT,
    SECTION_ANGLE,
    FamilyTables,
    pack_runs,
    prepare_family,
)

# Windows, in threads beyond a tile, on the sides that a ray may reach.
PYRAMID_RADII = (1, 2, 4, 8)
TILE_CELLS = 2
# Cells around those of some tiles that their windows reach, and tiles that are processed at once.
_MARGIN = PYRAMID_RADII[-1]
_BLOCK = 1 << 16
# Words of a tile. A word's number is 1 where x grows along the ray, plus 2 where y grows.
QUADRANTS = 4


def pack_max_heights(words: NDArray[np.uint32]) -> NDArray[np.uint32]:
    """The pyramid [⌈picks / 2⌉, ⌈ends / 2⌉, 4], from the words of warp and weft [picks, ends, 2]."""
    picks, ends = words.shape[:2]
    along, across = -(-picks // TILE_CELLS), -(-ends // TILE_CELLS)
    max_heights = np.empty((along, across, QUADRANTS), np.uint32)
    bytes_of_words = words.astype("<u4", copy=False).view(np.uint8).reshape(picks, ends, 2, 4)
    step = max(1, _BLOCK // across)
    for first in range(0, along, step):
        last = min(first + step, along)
        near = np.arange(TILE_CELLS * first - _MARGIN, TILE_CELLS * last + _MARGIN) % picks
        max_heights[first:last] = _pack_rows(bytes_of_words, near, last - first, across)
    return max_heights


def _pack_rows(
    bytes_of_words: NDArray[np.uint8], near: NDArray[np.intp], along: int, across: int
) -> NDArray[np.uint32]:
    """Some rows of the pyramid, from the words of picks near them, with `_MARGIN` more at either end."""
    warp, weft = (bytes_of_words[near, :, family, 3] >> 4 for family in (0, 1))
    # Where the warp is on top, its level is the front's: selection by bits takes a tenth of the time.
    swapped = (warp ^ weft) & -(bytes_of_words[near, :, 0, 0] & 1)
    faces = np.stack([weft ^ swapped, warp ^ swapped])
    margins = np.arange(-_MARGIN, TILE_CELLS * across + _MARGIN) % warp.shape[1]
    even, odd = (faces[..., margins[first::TILE_CELLS]].transpose(2, 0, 1) for first in (0, 1))
    max_heights = np.empty((along, across, QUADRANTS, len(PYRAMID_RADII)), np.uint8)
    for number, radius in enumerate(PYRAMID_RADII):
        for right in (False, True):
            columns = _highest(even, odd, radius, right).transpose(2, 1, 0)
            for up in (False, True):
                front, behind = _highest(columns[0::2], columns[1::2], radius, up).swapaxes(0, 1)
                max_heights[..., right + 2 * up, number] = front | behind << 4
    return max_heights.view("<u4")[..., 0]


def _highest(even: NDArray[np.uint8], odd: NDArray[np.uint8], radius: int, ahead: bool) -> NDArray[np.uint8]:
    """Maxima of tiles and of `radius` cells ahead of them, else behind them, along the first axis.

    Args:
        even, odd: the two cells of each tile along that axis, with those of `_MARGIN` cells at either end.
    """
    margin = _MARGIN // TILE_CELLS

    def beside(cells: NDArray[np.uint8], tiles: int) -> NDArray[np.uint8]:
        first = margin + (tiles if ahead else -tiles)
        return cells[first : first + len(cells) - 2 * margin]

    pairs = np.maximum(even, odd)
    highest = beside(pairs, 0)
    for tiles in range(1, radius // TILE_CELLS + 1):
        highest = np.maximum(highest, beside(pairs, tiles))
    return np.maximum(highest, beside(even if ahead else odd, 1)) if radius % TILE_CELLS else highest


# ----------------------------------------------------------------------------------- the thread at a position
# Finding the thread at a position, and what the geometry asks about it, on one Dr.Jit backend.
#
# What differs between fabrics is opaque to the kernels, counts of threads included, so all fabrics share
# them.


@dataclass
class Cell:
    """Where a coordinate falls among the threads of one family.

    Attributes:
        thread: index of the thread whose cell it is: UInt32.
        number: the same as a Float, known sooner.
        across: distance from the middle of that thread, signed, millimetres.
        half_width: of that thread.
        below, above: distances to the ends of the cell.
    """

    thread: UInt
    number: Float
    across: Float
    half_width: Float
    below: Float
    above: Float


class Count:
    """A number of threads or texels to count around with: opaque, so that kernels do not depend on it."""

    def __init__(self, number: Float, inverse: Float, half_inverse: Float) -> None:
        self.numbers = number, inverse, half_inverse
        self._number, self._inverse, self._half_inverse = self.numbers

    @classmethod
    def of(cls, number: int, types: ArrayTypes) -> Self:
        """Of a number on one backend."""
        number_, inverse, half = (
            dr.opaque(types.Float, value) for value in (number, 1 / number, 0.5 / number)
        )
        return cls(number_, inverse, half)

    def divide(self, index: UInt) -> tuple[Float, Float]:
        """Whole turns, rounded down, and the remainder ≥ 0 of whole numbers of any sign: Float each.

        Exact up to 4 million, where coordinates in single precision tell threads apart no longer.
        """
        turns = dr.floor(dr.fma(index, self._inverse, self._half_inverse))
        return turns, dr.fma(-turns, self._number, index)


def select_cell(first_one: Mask, first: Cell, second: Cell) -> Cell:
    """`first` where `first_one`, else `second`."""
    return Cell(
        dr.select(first_one, first.thread, second.thread),
        dr.select(first_one, first.number, second.number),
        dr.select(first_one, first.across, second.across),
        dr.select(first_one, first.half_width, second.half_width),
        dr.select(first_one, first.below, second.below),
        dr.select(first_one, first.above, second.above),
    )


class UniformFamily:
    """Threads that are all alike: arithmetic instead of tables."""

    is_uniform = True

    def __init__(self, tables: FamilyTables, types: ArrayTypes) -> None:
        self.count = Count.of(tables.lower.size, types)
        self._last = dr.opaque(types.Float, tables.lower.size - 1)
        size = float(tables.upper[0] - tables.lower[0])
        self.size = dr.opaque(types.Float, size)
        self.inverse_size = dr.opaque(types.Float, 1 / size)
        self.half_width = dr.opaque(types.Float, float(tables.half_width[0]))
        self.arc = dr.opaque(types.Float, float(tables.arc[0]))
        self.drop = dr.opaque(types.Float, float(tables.edge_drop[0]))
        inclination = float(tables.inclination[0])
        self.sine = dr.opaque(types.Float, math.sin(inclination))
        self.half_tangent = dr.opaque(types.Float, math.tan(inclination / 2))
        self._types = types

    def locate(self, position: Float) -> Cell:
        """The cell of a position in millimetres, any number of repeats away."""
        cells = position * self.inverse_size
        whole = dr.floor(cells)
        below = dr.fma(-whole, self.size, position)
        # Whatever comes in, there is such a thread: positions that are no number would read any memory.
        number = clip(self.count.divide(whole)[1], 0, self._last)
        return Cell(
            self._types.UInt32(number),
            number,
            below - 0.5 * self.size,
            self.half_width,
            below,
            self.size - below,
        )

    def span(self, thread: UInt, first: Int, last: Int) -> Float:
        """Length from the lower boundary of cell thread + first to that of thread + last."""
        del thread
        return self._types.Float(last - first) * self.size

    def bend(self, thread: UInt) -> tuple[Float, Float, Float]:
        """Sine of the inclination, tangent of half of it, and the arc's half-length."""
        del thread
        return self.sine, self.half_tangent, self.arc

    def edge_drop(self, thread: UInt, step: Int) -> Float:
        """Edge drop of thread + step, step in −1..1."""
        del thread, step
        return self.drop


class VariedFamily:
    """Threads that differ: a table by position finds the thread, tables by thread tell what it is."""

    is_uniform = False

    def __init__(self, tables: FamilyTables, types: ArrayTypes) -> None:
        self.count = Count.of(tables.lower.size, types)
        self._last = dr.opaque(types.UInt32, tables.lower.size - 1)
        self._types = types
        self.start = dr.opaque(types.Float, float(tables.lower[0]))
        self.period = dr.opaque(types.Float, tables.period)
        self.inverse_period = dr.opaque(types.Float, 1 / tables.period)
        lower = tables.lower - tables.lower[0]
        bins = math.ceil(tables.period / tables.finest) + 1
        edges = np.arange(bins) * (tables.period / bins)
        first = np.searchsorted(lower, edges, side="right") - 1
        self.bins = dr.opaque(types.Float, bins)
        self._last_bin = dr.opaque(types.UInt32, bins - 1)
        self._first = upload(types.UInt32, first.astype(np.uint32))
        self._place, self._bend = (upload(types.Float, rows) for rows in thread_rows(tables))

    def _row(self, table: Float, thread: UInt) -> Any:
        return dr.gather(self._types.Vector4, table, thread)

    def locate(self, position: Float) -> Cell:
        UInt32 = self._types.UInt32
        turns = (position - self.start) * self.inverse_period
        turns -= dr.floor(turns)
        local = turns * self.period
        slot = minimum(UInt32(turns * self.bins), self._last_bin)
        thread = dr.gather(UInt32, self._first, slot)
        upper = dr.gather(self._types.Float, self._place, thread * 4 + 1)
        # A bin is no wider than the smallest cell, so it meets two cells at most; rounding may add one.
        thread = minimum(thread + dr.select(local >= upper, UInt32(1), UInt32(0)), self._last)
        lower, upper, centre, half_width = self._row(self._place, thread)
        return Cell(
            thread, self._types.Float(thread), local - centre, half_width, local - lower, upper - local
        )

    def span(self, thread: UInt, first: Int, last: Int) -> Float:
        return self._boundary(thread, last) - self._boundary(thread, first)

    def _boundary(self, thread: UInt, step: Int) -> Float:
        turns, inside = self.count.divide(self._types.Float(self._types.Int32(thread) + step))
        lower = dr.gather(self._types.Float, self._place, self._types.UInt32(inside) * 4)
        return dr.fma(turns, self.period, lower)

    def bend(self, thread: UInt) -> tuple[Float, Float, Float]:
        row = self._row(self._bend, thread)
        return row[0], row[1], row[2]

    def edge_drop(self, thread: UInt, step: Int) -> Float:
        inside = self.count.divide(self._types.Float(self._types.Int32(thread) + step))[1]
        return dr.gather(self._types.Float, self._bend, self._types.UInt32(inside) * 4 + 3)


Family = UniformFamily | VariedFamily


def thread_rows(tables: FamilyTables) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Numbers of each thread: where it lies, and how it bends [n, 4]."""
    first = tables.lower[0]
    place = [tables.lower - first, tables.upper - first, tables.centre - first, tables.half_width]
    bend = [np.sin(tables.inclination), np.tan(tables.inclination / 2), tables.arc, tables.edge_drop]
    return np.stack(place, axis=1), np.stack(bend, axis=1)


def span_along(is_warp: Mask, thread: UInt, warp: Any, weft: Any) -> Callable[[Float, Int, Int], Float]:
    """A length (millimetres) plus `span` of the family that a thread of warp (else weft) crosses.

    Args:
        thread: the crossing that is counted from.
        warp, weft: families, or what takes their place (`planes.py`).
    """
    if warp.is_uniform and weft.is_uniform:
        size = dr.select(is_warp, weft.size, warp.size)
        return lambda length, first, last: dr.fma(array_types(size).Float(last - first), size, length)
    return lambda length, first, last: (
        length + dr.select(is_warp, weft.span(thread, first, last), warp.span(thread, first, last))
    )


def upload_family(tables: FamilyTables, types: ArrayTypes) -> Family:
    """The family on one backend: without tables where its threads are alike."""
    return UniformFamily(tables, types) if tables.uniform else VariedFamily(tables, types)


# ----------------------------------------------------------------------------------------- tables of a layout
# Tables of a layout that `geometry` reads: prepared in numpy once per layout, uploaded once per backend.


# Whole numbers that float32 tells apart.
_MAX_EXACT = 1 << 24
# Sides of the tiles in which words are transposed.
_TILE = 64


@dataclass
class LayoutTables:
    """Tables of warp and weft, words of both at each crossing [picks, ends, 2], max-height pyramid."""

    warp: FamilyTables
    weft: FamilyTables
    words: NDArray[np.uint32]
    max_heights: NDArray[np.uint32]
    _uploaded: dict[type, tuple[UInt, UInt]] = field(default_factory=dict)

    def upload(self, types: ArrayTypes) -> tuple[UInt, UInt]:
        """Words and pyramid on a backend."""
        if types.UInt32 not in self._uploaded:
            words, self.words = move(types.UInt32, self.words)
            max_heights, self.max_heights = move(types.UInt32, self.max_heights)
            self._uploaded[types.UInt32] = words, max_heights
        return self._uploaded[types.UInt32]


# Tables of all layouts in memory: the models of a fabric share its layout, and a draft of 4096 by 4096
# threads takes seconds. An edit of heights or twist makes another layout with the same threads.
_cache: WeakKeyDictionary[ClothLayout, LayoutTables] = WeakKeyDictionary()


def prepare_layout(layout: ClothLayout) -> LayoutTables:
    """Its tables, computed once for layouts that differ at most in height scales and twist."""
    found = _cache.get(layout)
    if found is None:
        same = (tables for other, tables in list(_cache.items()) if _has_same_threads(layout, other))
        found = _cache[layout] = next(same, None) or _prepare(layout)
    return found


def _has_same_threads(first: ClothLayout, second: ClothLayout) -> bool:
    """Whether two layouts differ at most in height scales and twist."""
    families = (first.warp, second.warp), (first.weft, second.weft)
    return np.array_equal(first.warp_on_top, second.warp_on_top) and all(
        a.inclination == b.inclination
        and np.array_equal(a.spacing, b.spacing)
        and np.array_equal(a.width, b.width)
        for a, b in families
    )


def _prepare(layout: ClothLayout) -> LayoutTables:
    on_top = layout.warp_on_top
    words = np.empty((*on_top.shape, 2), np.uint32)
    of_family = pack_runs(on_top)
    warp = prepare_family(layout.warp, layout.weft, of_family)
    words[..., 0] = of_family
    of_family = pack_runs(~on_top.T)
    weft = prepare_family(layout.weft, layout.warp, of_family)
    # Square tiles: whole rows of one array are columns of the other, which caches do not hold.
    tiles = [[slice(first, first + _TILE) for first in range(0, count, _TILE)] for count in on_top.shape]
    for picks, ends in product(*tiles):
        words[picks, ends, 1] = of_family[ends, picks].T
    del of_family
    return LayoutTables(warp, weft, words, pack_max_heights(words))


class DeviceTables:
    """The tables of a layout on one backend. Numbers are opaque to Dr.Jit: all fabrics share kernels."""

    def __init__(self, layout: ClothLayout, types: ArrayTypes) -> None:
        tables = prepare_layout(layout)
        self.warp: Any = upload_family(tables.warp, types)
        self.weft: Any = upload_family(tables.weft, types)
        self.words, self.max_heights = tables.upload(types)
        # Single precision, which is faster, tells the words of 4096 by 4096 crossings apart.
        exact = types.Float if layout.warp_on_top.size <= _MAX_EXACT else types.UInt32
        self.ends: Any = dr.opaque(exact, tables.words.shape[1])
        self.max_height_columns = dr.opaque(types.UInt32, tables.max_heights.shape[1])
        self.scalar = Scalars(types)


class Scalars:
    """Numbers of a fabric by name, as opaque Floats of one backend; Dr.Jit scalars as they are."""

    def __init__(self, types: ArrayTypes) -> None:
        self._float = types.Float
        self._kept: dict[str, tuple[float, Float]] = {}

    def __call__(self, name: str, value: Float) -> Float:
        if not isinstance(value, int | float):
            return self._float(value)
        # By name: two equal numbers under one name would be one variable, and kernels would differ.
        if name not in self._kept or self._kept[name][0] != value:
            self._kept[name] = value, dr.opaque(self._float, value)
        return self._kept[name][1]


# ------------------------------------------------------------------------------------------------ the surface


@dataclass
class CellBounds:
    """Bounds of the cell of a position, for rays that pass above it.

    Attributes:
        cell_max: bound of heights in the cell, millimetres.
        side_x, side_y: distances to its sides along x and y in the direction of the search, ≥ 0, millimetres.
    """

    cell_max: Float
    side_x: Float
    side_y: Float


@dataclass
class Probe:
    """The surface at one sample of a search along a ray.

    Attributes:
        height, hole: see `SurfacePoint`.
        slope_x, slope_y: derivatives of the height along x and y.
        yarn: a number that differs between neighbouring yarns: within one, heights are smooth.
        cell_bounds: the cell of the sample.
        edge_x, edge_y: distances in the direction of the search, millimetres, to the next outline: where
            another thread may show, or where this one begins to dive or is halfway down.
    """

    height: Float
    hole: Mask
    slope_x: Float
    slope_y: Float
    yarn: UInt
    cell_bounds: CellBounds
    edge_x: Float
    edge_y: Float


@dataclass
class Shown:
    """The thread that shows at a point, and the facts of its run that shape it there."""

    is_warp: Mask
    hole: Mask
    on_top: Mask
    word: UInt
    crossing: Crossing


@dataclass
class Crossing:
    """Where two threads cross, and the cells of both around a point."""

    warp: Cell
    weft: Cell
    words: UInt
    warp_above: Mask  # the warp is on top here, whether or not its yarn covers the point


def read_max_heights(
    max_heights: UInt, tile: UInt, back: Mask, right: Mask, up: Mask
) -> list[tuple[float, Float]]:
    """Distances and bounds of heights ahead of a tile of a pyramid; see `rays.Surface.max_heights`."""
    types = array_types(tile)
    # All four at once: Dr.Jit fetches 16 bytes in a row sooner than 4 by themselves.
    words = dr.gather(types.Index4, max_heights, tile)
    word = dr.select(up, dr.select(right, words[3], words[2]), dr.select(right, words[1], words[0]))
    word = word >> dr.select(back, types.UInt32(4), types.UInt32(0))
    return [
        (float(radius), types.Float((word >> 8 * number) & 15) * (1 / CELL_MAX_LEVELS))
        for number, radius in reversed(list(enumerate(PYRAMID_RADII)))
    ]


class YarnGeometry:
    """Analytic geometry of one layout of cloth, for any Dr.Jit backend.

    Attributes:
        layout: what it was made from.
        size: width and height of the repeat, millimetres.
        height_scale: β of (warp, weft); numbers, or Dr.Jit scalars when gradients are wanted.
        twist: ψ of (warp, weft), radians; likewise.
    """

    def __init__(self, layout: ClothLayout) -> None:
        self.layout = layout
        self.size = layout.size
        self.height_scale: tuple[Float, Float] = (layout.warp.height_scale, layout.weft.height_scale)
        self.twist: tuple[Float, Float] = (layout.warp.twist, layout.weft.twist)
        tables = prepare_layout(layout)
        self._warp, self._weft = tables.warp, tables.weft
        self._uploaded: dict[type, DeviceTables] = {}
        self.extents: dict[FloatType, Any] = {}

    @property
    def families(self) -> tuple[FamilyTables, FamilyTables]:
        """Where the threads of warp and weft lie."""
        return self._warp, self._weft

    @property
    def words(self) -> tuple[NDArray[np.uint32], NDArray[np.uint32]]:
        """Run words of warp and weft at each crossing [picks, ends, 2], and the max-height pyramid."""
        tables = prepare_layout(self.layout)
        return tables.words, tables.max_heights

    @property
    def finest(self) -> tuple[float, float]:
        """Smallest cell of warp and weft threads, millimetres."""
        return self._warp.finest, self._weft.finest

    @property
    def height_bounds(self) -> tuple[float, float]:
        """No thread is ever lower or higher than this, millimetres, on either face."""
        scales = [float(np.max(np.asarray(scale))) for scale in self.height_scale]
        families = (self._warp, self._weft)
        highest = max(f.highest * s for f, s in zip(families, scales, strict=True))
        dive = max(float(f.edge_drop.max()) * s for f, s in zip(families, scales, strict=True))
        lowest = min(f.lowest * s for f, s in zip(families, scales, strict=True))
        return lowest - dive, highest

    def _tables(self, types: ArrayTypes) -> DeviceTables:
        if types.Float not in self._uploaded:
            self._uploaded[types.Float] = DeviceTables(self.layout, types)
        return self._uploaded[types.Float]

    def upload(self, types: ArrayTypes) -> None:
        """Puts all that points and probes read on a backend, which otherwise happens at first use."""
        self._numbers(self._tables(types))

    def _numbers(self, tables: DeviceTables) -> dict[str, Float]:
        """Numbers of the fabric by name, as `Scalars` has them."""
        numbers = {
            "warp scale": self.height_scale[0],
            "weft scale": self.height_scale[1],
            "warp twist": self.twist[0],
            "weft twist": self.twist[1],
            "warp level": self._warp.highest / CELL_MAX_LEVELS,
            "weft level": self._weft.highest / CELL_MAX_LEVELS,
        }
        return {name: tables.scalar(name, number) for name, number in numbers.items()}

    def height(self, x: Float, y: Float, back: Mask) -> tuple[Float, Mask]:
        """Height of the cloth and whether there is a hole, at draft coordinates x, y in millimetres.

        Args:
            back: Bool, seen from behind; heights then count away from the cloth on that side.
        """
        point = self.surface(x, y, back)
        return point.height, point.hole

    def max_heights(self, x: Float, y: Float, back: Mask, right: Mask, up: Mask) -> list[tuple[float, Float]]:
        """Bounds of heights ahead of draft coordinates x, y (millimetres); see `search.Surface`."""
        tables = self._tables(array_types(x))
        column, row = tables.warp.locate(x).thread, tables.weft.locate(y).thread
        tile = row // TILE_CELLS * tables.max_height_columns + column // TILE_CELLS
        return read_max_heights(tables.max_heights, tile, back, right, up)

    def probe(self, x: Float, y: Float, back: Mask, right: Mask, up: Mask) -> Probe:
        """The surface at draft coordinates x, y (millimetres) for a search; see `search.Surface.probe`."""
        types = array_types(x)
        point, shown, run, (slope_x, slope_y), _ = self._surface(x, y, back)
        crossing = shown.crossing
        return Probe(
            height=point.height,
            hole=point.hole,
            slope_x=slope_x,
            slope_y=slope_y,
            yarn=dr.select(
                point.is_warp, types.UInt32(point.warp_thread) * 2 + 1, types.UInt32(point.weft_thread) * 2
            ),
            cell_bounds=self._cell_bounds(crossing, types, right, up),
            edge_x=next_outline(crossing.warp, shown, run, ~shown.is_warp, right),
            edge_y=next_outline(crossing.weft, shown, run, shown.is_warp, up),
        )

    def cell_bounds(self, x: Float, y: Float, back: Mask, right: Mask, up: Mask) -> CellBounds:
        """The part of `probe` that rays above the cell need, a sixth of its cost."""
        types = array_types(x)
        return self._cell_bounds(_cross(self._tables(types), types, x, y, back), types, right, up)

    def _cell_bounds(self, crossing: Crossing, types: ArrayTypes, right: Mask, up: Mask) -> CellBounds:
        numbers = self._numbers(self._tables(types))
        levels = dr.select(
            crossing.warp_above,
            numbers["warp scale"] * numbers["warp level"],
            numbers["weft scale"] * numbers["weft level"],
        )
        word = dr.select(crossing.warp_above, crossing.words[0], crossing.words[1])
        return CellBounds(
            cell_max=types.Float(word >> CELL_MAX_SHIFT) * levels,
            side_x=dr.select(right, crossing.warp.above, crossing.warp.below),
            side_y=dr.select(up, crossing.weft.above, crossing.weft.below),
        )

    def surface(self, x: Float, y: Float, back: Mask, ray: tuple[Vec3, Float] | None = None) -> SurfacePoint:
        """The point of the cloth above draft coordinates x, y (millimetres, any number of repeats).

        Args:
            x, y: Float arrays, along the weft and along the warp.
            back: Bool, seen from behind.
            ray: unit vector [3] towards the eye, z > 0, and the height where a ray from there has ended; the
                point is where it meets the yarn's tube (`flanks.py`), which walls and dives cut off.
        """
        point, tube = self.surface_and_tube(x, y, back)
        if ray is not None:
            meet_tube(point, tube, self.twist_of(point.is_warp, back, array_types(x)), ray)
        return point

    def surface_and_tube(self, x: Float, y: Float, back: Mask) -> tuple[SurfacePoint, Tube]:
        """The point of the cloth above draft coordinates x, y (millimetres), and its yarn around it."""
        point, _, _, _, tube = self._surface(x, y, back)
        return point, tube

    def sheets(self, x: Float, y: Float, back: Mask) -> list[Sheet]:
        """What lies behind the yarn that shows: nothing, in one plane."""
        del x, y, back
        return []

    def twist_of(self, is_warp: Mask, back: Mask, types: ArrayTypes) -> Float:
        """ψ of a family as a face shows it, radians."""
        numbers = self._numbers(self._tables(types))
        twist = dr.select(is_warp, numbers["warp twist"], numbers["weft twist"])
        return dr.select(back, -twist, twist)

    def _surface(
        self, x: Float, y: Float, back: Mask
    ) -> tuple[SurfacePoint, Shown, Run, tuple[Float, Float], Tube]:
        # Find the thread on top, the run that it is in, and the numbers of its family.
        types = array_types(x)
        tables = self._tables(types)
        shown = _show(tables, types, x, y, back)
        numbers = self._numbers(tables)
        scales = numbers["warp scale"], numbers["weft scale"]
        twist = self.twist_of(shown.is_warp, back, types)
        point, run, slopes, tube = shown_surface(tables, shown, (x, y), scales, twist)
        return point, shown, run, slopes, tube


@dataclass
class Relief:
    """A height on which the cloth lies at a place.

    Attributes:
        height: millimetres.
        slope_x, slope_y: its derivatives.
    """

    height: Float
    slope_x: Float
    slope_y: Float


def shown_surface(
    tables: Any,
    shown: Shown,
    place: tuple[Float, Float],
    scales: tuple[Float, Float],
    twist: Float,
    relief: Relief | None = None,
) -> tuple[SurfacePoint, Run, tuple[Float, Float], Tube]:
    """The surface of the thread that shows at a place, its run there, slopes along x and y, and its yarn.

    Args:
        tables: families `warp` and `weft`.
        place: draft coordinates x, y, millimetres.
        scales: β of warp and weft.
        twist: ψ of the thread, radians.
        relief: what it lies on; None for the plane.
    """
    x, y = place
    types = array_types(x)
    is_warp = shown.is_warp
    warp_beta, weft_beta = scales
    beta = dr.select(is_warp, warp_beta, weft_beta)
    other_beta = dr.select(is_warp, weft_beta, warp_beta)

    # The thread's own cell gives its cross-section, the cell of the thread it crosses the way along.
    own = select_cell(is_warp, shown.crossing.warp, shown.crossing.weft)
    crossed = select_cell(is_warp, shown.crossing.weft, shown.crossing.warp)
    run = _unpack(types, tables, shown, own, crossed)

    # Find the drop of its cross-section. Searches wait for each sample: sections of both threads are
    # worked out while the words are fetched that tell which of them shows.
    warp_section, weft_section = (_section(cell) for cell in (shown.crossing.warp, shown.crossing.weft))
    section = dr.select(is_warp, warp_section.drop, weft_section.drop)
    section_slope = dr.select(is_warp, warp_section.slope, weft_section.slope)

    # Find how far its centre line has fallen along the arc, and both slopes. A float's flank close to its
    # end lies on the arc of the run that follows underneath.
    flank = shown.on_top & (run.distance < section * run.sine)
    over = shown.on_top & ~flank
    arc = dr.select(flank, run.other_reach, run.reach)
    along = dr.select(flank, arc + run.distance, maximum(arc - run.distance, 0))
    sign = dr.select(over, types.Float(1), types.Float(-1))
    bow = arc * dr.rcp(run.sine) - sign * section
    root_square = maximum(dr.fma(bow, bow, -dr.square(along)), 1e-20)
    inverse_root = dr.rsqrt(root_square)
    bent = along > 0
    fall = dr.square(along) / dr.fma(root_square, inverse_root, bow)
    slope_across = section_slope * dr.select(bent, bow * inverse_root, 1)
    outwards = dr.select(shown.on_top, types.Float(1), types.Float(-1)) * along * inverse_root
    slope_along = dr.select(bent, outwards, 0) * dr.select(run.near_start, types.Float(1), types.Float(-1))

    # Let a thread underneath dive below the ones that cover it, and add up heights and slopes.
    dive, dive_slope, filled = _dive(types, tables, shown, run, crossed, other_beta)
    bend = dr.select(run.straight, 0, beta * sign)
    level = dr.fma(bend, arc * run.half_tangent, dr.fma(-beta, section, -dive))
    height = dr.fma(-bend, fall, level)
    p = beta * slope_across
    q = dr.fma(beta, slope_along, -dive_slope)
    if relief is not None:
        height += relief.height
        p += dr.select(is_warp, relief.slope_x, relief.slope_y)
        q += dr.select(is_warp, relief.slope_y, relief.slope_x)

    # Turn the fibres by the twist. Weft local frame: its y runs along −x, a proper rotation, so the twist
    # keeps its sign.
    turn = dr.select(is_warp, types.Float(1), types.Float(-1))
    horizontal_across, horizontal_along = _fibre_direction(slope_across, turn * slope_along, twist)
    lifted = dr.fma(p, horizontal_across, turn * q * horizontal_along)
    tangent = types.Vector3(
        dr.select(is_warp, horizontal_across, -horizontal_along),
        dr.select(is_warp, horizontal_along, horizontal_across),
        lifted,
    )
    slope_x, slope_y = dr.select(is_warp, p, q), dr.select(is_warp, q, p)
    # Unroll the section, for coordinates that fibres and plies run along.
    radius = own.half_width / math.sin(SECTION_ANGLE)
    across = dr.select(is_warp, warp_section.across, weft_section.across)
    unrolled = radius * dr.asin(clip(across / radius, -1, 1))
    lengthwise = dr.select(is_warp, y, -x)
    sine, cosine = dr.sincos(twist)
    point = SurfacePoint(
        hole=shown.hole,
        is_warp=is_warp,
        warp_thread=shown.crossing.warp.thread,
        weft_thread=shown.crossing.weft.thread,
        height=height,
        normal=dr.normalize(types.Vector3(-slope_x, -slope_y, 1)),
        tangent=dr.normalize(tangent),
        across=across,
        fibre_across=dr.fma(unrolled, cosine, lengthwise * sine),
        fibre_along=dr.fma(lengthwise, cosine, -unrolled * sine),
        x=x,
        y=y,
        depth=types.Float(0),
        plane=types.Float(0),
        shown_share=dr.select(shown.on_top, run.share, 1 - run.share),
    )
    slope = dr.fma(-(1 - filled) * dr.rcp(beta), dive_slope, slope_along)
    if relief is not None:
        slope += dr.rcp(beta) * dr.select(is_warp, relief.slope_y, relief.slope_x)
    tube = Tube(radius, across, slope, beta, dr.fma(filled, dive, height))
    return point, run, (slope_x, slope_y), tube


@dataclass
class _Section:
    """The cross-section of a thread at a place in its cell."""

    across: Float  # distance from its middle, at most half its width, signed
    drop: Float  # below the crown
    slope: Float


def _section(cell: Cell) -> _Section:
    radius = cell.half_width / math.sin(SECTION_ANGLE)
    across = clip(cell.across, -cell.half_width, cell.half_width)
    lateral_square = dr.fma(radius, radius, -dr.square(across))
    inverse_lateral = dr.rsqrt(lateral_square)
    return _Section(across, dr.fma(-lateral_square, inverse_lateral, radius), -across * inverse_lateral)


@dataclass
class Run:
    """The run of the shown thread, unpacked."""

    distance: Float  # from the nearer end of the run
    near_start: Mask
    from_start: Float
    to_end: Float
    reach: Float  # half-length of this run's bent ends
    other_reach: Float  # the same of the run beyond the nearer end
    sine: Float
    half_tangent: Float
    straight: Mask
    share: Float  # of it in itself and half of the runs before and after, by crossings
    first_crossing: UInt
    last_crossing: UInt


def _show(tables: DeviceTables, types: ArrayTypes, x: Float, y: Float, back: Mask) -> Shown:
    crossing = _cross(tables, types, x, y, back)
    warp, weft = crossing.warp, crossing.weft
    in_warp = abs(warp.across) < warp.half_width
    in_weft = abs(weft.across) < weft.half_width
    is_warp = in_warp & (~in_weft | crossing.warp_above)
    word = dr.select(is_warp, crossing.words[0], crossing.words[1])
    on_top = ((word & 1) == 1) ^ back
    return Shown(is_warp, ~in_warp & ~in_weft, on_top, word, crossing)


def _cross(tables: DeviceTables, types: ArrayTypes, x: Float, y: Float, back: Mask) -> Crossing:
    warp, weft = tables.warp.locate(x), tables.weft.locate(y)
    if dr.is_integral_v(tables.ends):
        word = dr.fma(weft.thread, tables.ends, warp.thread)
    else:
        word = types.UInt32(dr.fma(weft.number, tables.ends, warp.number))
    words = dr.gather(types.Index2, tables.words, word)
    return Crossing(warp, weft, words, ((words[0] & 1) == 1) ^ back)


def _unpack(types: ArrayTypes, tables: DeviceTables, shown: Shown, own: Cell, crossed: Cell) -> Run:
    word = shown.word
    behind = types.Int32((word >> 1) & 127)
    ahead = types.Int32((word >> 8) & 127)
    before = types.Int32((word >> 15) & 63)
    after = types.Int32((word >> 21) & 63)
    straight = ((word >> 27) & 1) == 1

    span = span_along(shown.is_warp, crossed.thread, tables.warp, tables.weft)

    from_start = span(crossed.below, -behind, types.Int32(0))
    to_end = span(crossed.above, types.Int32(1), ahead + 1)
    near_start = from_start < to_end
    other = dr.select(near_start, span(0, -behind - before, -behind), span(0, ahead + 1, ahead + 1 + after))
    bends = [tables.warp.bend(shown.crossing.warp.thread), tables.weft.bend(shown.crossing.weft.thread)]
    sine, half_tangent, arc = (dr.select(shown.is_warp, a, b) for a, b in zip(*bends, strict=True))
    far = types.Float(1e6)
    crossings, beside = types.Float(behind + ahead + 1), types.Float(before + after)
    return Run(
        distance=dr.select(straight, far, minimum(from_start, to_end)),
        near_start=near_start,
        from_start=from_start,
        to_end=to_end,
        reach=minimum(0.5 * (from_start + to_end), arc),
        other_reach=minimum(0.5 * other, arc),
        sine=sine,
        half_tangent=half_tangent,
        straight=straight,
        share=crossings * dr.rcp(dr.fma(0.5, beside, crossings)),
        first_crossing=behind == 0,
        last_crossing=ahead == 0,
    )


def next_outline(cell: Cell, shown: Shown, run: Run, lengthwise: Mask, forwards: Mask) -> Float:
    """Distance along one axis to where another thread may show, or the shown one begins or ceases to dive.

    Args:
        cell: of the family that is counted along this axis.
        lengthwise: the thread that shows runs along it.
        forwards: up the axis, else down.
    """
    across = dr.select(forwards, cell.across, -cell.across)
    ahead = dr.select(forwards, cell.above, cell.below)
    ends = dr.select(forwards, run.last_crossing, run.first_crossing)
    began = dr.select(forwards, run.first_crossing, run.last_crossing)
    before, behind = across < -cell.half_width, across >= cell.half_width
    # A float stays on top up to the end of its run, but dives in the gap where that begins. A thread
    # underneath shows in the gap, as far as the next outline, and is level there if it stays underneath; and
    # holes are as wide. A gap reaches equally far into both cells.
    stays = lengthwise & ~ends & ~shown.hole
    floats = stays & shown.on_top & ~(began & before)
    level = shown.hole | (stays & ~shown.on_top)
    outline = dr.select(before, -cell.half_width, cell.half_width) - across
    beyond = dr.select(level, 2 * ahead + across - cell.half_width, ahead)
    edge = dr.select(behind, beyond, outline)
    return dr.select(floats, dr.select(forwards, run.to_end, run.from_start), edge)


def _dive(
    types: ArrayTypes, tables: DeviceTables, shown: Shown, run: Run, crossed: Cell, other_beta: Float
) -> tuple[Float, Float, Float]:
    """Depth by which the thread is pushed down here, its slope along the axis, and `filled_share`."""
    low_side = crossed.below < crossed.above
    distance = minimum(crossed.below, crossed.above)
    # A gap reaches equally far into both cells that share it.
    half_gap = (
        dr.select(low_side, crossed.below - crossed.across, crossed.above + crossed.across)
        - crossed.half_width
    )
    step = dr.select(low_side, types.Int32(-1), types.Int32(1))
    turns_over = dr.select(low_side, run.first_crossing, run.last_crossing)

    def drop(offset: Float) -> Float:
        thread = crossed.thread
        return other_beta * dr.select(
            shown.is_warp, tables.weft.edge_drop(thread, offset), tables.warp.edge_drop(thread, offset)
        )

    here = dr.select(shown.on_top, 0, drop(types.Int32(0)))
    beyond = dr.select(shown.on_top ^ turns_over, 0, drop(step))
    inverse_gap = dr.rcp(maximum(2 * half_gap, 1e-12))
    share = clip((half_gap - distance) * inverse_gap, 0, 1)
    blend = dr.square(share) * (3 - 2 * share)
    rate = 6 * share * (1 - share) * inverse_gap
    depth = dr.fma(beyond - here, blend, here)
    slope = (here - beyond) * rate * dr.select(low_side, types.Float(1), types.Float(-1))
    return depth, slope, filled_share(2 * half_gap, crossed.half_width)


def _fibre_direction(across_slope: Float, along_slope: Float, twist: Float) -> tuple[Float, Float]:
    """Horizontal part, across and along, of the fibre direction t = cos ψ e_u − sin ψ e_v."""
    sine, cosine = dr.sincos(twist)
    lengthwise = dr.square(along_slope) + 1
    inverse_normal = dr.rsqrt(lengthwise + dr.square(across_slope))
    inverse_along = dr.rsqrt(lengthwise)
    crosswise = sine * inverse_along * inverse_normal
    return -crosswise * lengthwise, dr.fma(crosswise, across_slope * along_slope, cosine * inverse_along)


# ----------------------------------------------------------------------------- without derivatives of shadows
# Cloth geometry whose shadows and outlines carry no derivatives.
#
# Searches along rays are loops with discontinuous results: their derivatives would be wrong as well as
# dear. Normals and tangents keep theirs.


class DetachedSurface:
    """Analytic geometry as a `Surface` whose heights carry no derivatives.

    Attributes:
        geometry: a `YarnGeometry`, or that of layered cloth (`yarn/stack.py`).
    """

    def __init__(self, geometry: Any) -> None:
        self.geometry = geometry
        self.size = geometry.size
        self.extents: dict[type, Any] = {}

    @property
    def finest(self) -> tuple[float, float]:
        return self.geometry.finest

    @property
    def height_bounds(self) -> tuple[float, float]:
        return self.geometry.height_bounds

    def sheets(self, x: Any, y: Any, back: Any) -> list[Sheet]:
        with dr.suspend_grad():
            return list(self.geometry.sheets(x, y, back))

    def height(self, x: Any, y: Any, back: Any) -> tuple[Any, Any]:
        with dr.suspend_grad():
            return self.geometry.height(x, y, back)

    def max_heights(self, x: Any, y: Any, back: Any, right: Any, up: Any) -> list[tuple[float, Any]]:
        with dr.suspend_grad():
            return self.geometry.max_heights(x, y, back, right, up)

    def probe(self, x: Any, y: Any, back: Any, right: Any, up: Any) -> Probe:
        with dr.suspend_grad():
            return self.geometry.probe(x, y, back, right, up)

    def cell_bounds(self, x: Any, y: Any, back: Any, right: Any, up: Any) -> CellBounds:
        with dr.suspend_grad():
            return self.geometry.cell_bounds(x, y, back, right, up)

    def surface(self, x: Any, y: Any, back: Any, ray: Any = None) -> SurfacePoint:
        point = self.geometry.surface(x, y, back, ray)
        point.height = dr.detach(point.height)
        return point
