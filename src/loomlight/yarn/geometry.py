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
from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, FloatType, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, array_types, clip, maximum, minimum
from loomlight.yarn.cells import Cell, select_cell, span_along
from loomlight.yarn.flanks import Sheet, SurfacePoint, Tube, filled_share, meet_tube
from loomlight.yarn.layout import ClothLayout
from loomlight.yarn.max_heights import TILE_CELLS, read_max_heights
from loomlight.yarn.tables import DeviceTables, prepare_layout
from loomlight.yarn.threads import CELL_MAX_LEVELS, CELL_MAX_SHIFT, SECTION_ANGLE, FamilyTables


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
        layer=types.UInt32(0),
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
