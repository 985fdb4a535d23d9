"""Mean albedos of both families over footprints, inside a kernel: a few table reads, whatever the size.

Models give components by family; a component is multiplied by the mean of its family's albedos over the
visible parts of the family in the footprint. Seen along the normal, visibility is constant on each crossing.
With A_i(x) = 1 on the visible width of warp thread i, B_j(y) = 1 on that of weft thread j, and W_ji = 1 where
the warp is on top, the warp is visible where

    A_i·((1 − B_j) + B_j·W_ji)        from the front, and from behind        A_i·((1 − B_j) + B_j·(1 − W_ji))

so the integral of a quantity c_i of its threads over a box is one product of two sums along the axes, for the
gaps, plus a box of the summed-area table of c_i·|A_i|·|B_j|·W_ji. The table has one entry a crossing: each
crossing is a rectangle, so linear interpolation within it is exact. `ColourSums` traces the rays of oblique
views instead, on a grid of texels, for one view at a time.

The quantities are 1, whose integral is the weight, and the coordinates of the threads' twelve albedos in
their principal axes: k colours need k − 1, and albedos made from colours 6 at most. Entries are integer
multiples of 2⁻³¹ of the repeat, so that differences between them are exact and no float64 is needed: a
crossing has 5000 units in a draft of 641 by 641 threads, 128 in one of 4096 by 4096, 32 in the largest.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from copy import copy
from dataclasses import dataclass, replace
from typing import Any, Self

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.aggregate.layer_shares import BARE, COVERED, LIT, layer_rates
from loomlight.aggregate.layered_albedos import SEEN_NUMBERS, LayeredAlbedos, SeenNumbers
from loomlight.aggregate.tables import Entries, PairedEntries, SingleEntries
from loomlight.core.arrays import Float, Mask, UInt, Vec2, Vec3
from loomlight.core.backend import ArrayTypes, array_types, clip, maximum, minimum, move, opaque, upload
from loomlight.core.footprint import Footprint
from loomlight.scattering.appearance import ALBEDO_NAMES, Appearance, FamilyAppearance
from loomlight.scattering.fibre import mean_layer_shares
from loomlight.scattering.interreflection import Interreflection
from loomlight.scattering.point import Albedos
from loomlight.yarn.cells import Cell, upload_family
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import Layer
from loomlight.yarn.stack import ClothGeometry, StackedGeometry
from loomlight.yarn.threads import FamilyTables, place_family

_NUMBERS = 3 * len(ALBEDO_NAMES)
# Entries of one family's table: 256 MB. Drafts of 4096 by 4096 threads keep three principal axes.
# Four colours need no more; 4096 random ones are then up to 0.01 off at default shine, 0.03 at the most.
MAX_ENTRIES = 1 << 26
# Larger drafts keep as many: 16 bytes a crossing and family.
MIN_QUANTITIES = 4
# Up to so many entries, each is stored together with its neighbour, so that both are read at once: 32 MB.
_MAX_PAIRED = 1 << 22
# Crossings whose sums are computed at once, within caches.
_CROSSINGS_AT_ONCE = 1 << 17
# Numbers fetched at once.
_WIDEST = 16
# Principal axes that change no albedo by more than this are dropped.
MIN_AXIS = 1e-6
# Least width of boxes in mean threads: float32 positions do not resolve less.
MIN_BOX = 1 / 64
# Weight of hidden threads, which decides where no thread of a family is visible: an oblique view may see
# them. It changes other means by at most this fraction.
HIDDEN_WEIGHT = 2.0**-12
# Units in which table entries are counted; differences must stay within a signed 32-bit number.
AREA_UNITS = 0.99 * 2**31
# Visible areas below so many units, in proportion for boxes smaller than a crossing, and below this fraction
# of the threads' area are rounding errors.
NOISE_UNITS = 16.0
NOISE_FRACTION = 1e-5


class FootprintAlbedos:
    """Mean albedos of warp and weft over footprints of one fabric, for any backend.

    In layered cloth those of all layers, as much of each as a face shows through the gaps before it.

    Attributes:
        planes: of each layer of the cloth; one where it lies in one plane.
        seen: how much of each of several layers shows; None of one.
        tables: colours of the warp and of the weft, of the front layer.
    """

    def __init__(self, geometry: ClothGeometry, appearance: Appearance) -> None:
        """Computes the tables; families whose threads are all the same need none."""
        if isinstance(geometry, YarnGeometry):
            self.planes = [Plane.of(geometry, appearance)]
            self.seen: Seen | None = None
        else:
            layers = zip(geometry.layers, geometry.layout.layers, strict=True)
            self.planes = [Plane.of(own, appearance, layer) for own, layer in layers]
            self.seen = Seen.of(geometry, self.planes, appearance)
        self.tables = self.planes[0].tables
        self._uploaded: dict[type, list[_Uploaded]] = {}
        self._shares: dict[type, _Shares] = {}
        self.appearance = appearance
        self._between: dict[type, Interreflection] = {}

    def with_openness(self, appearance: Appearance) -> Self:
        """These means, with roughness and openness of an edited fabric for light between yarns."""
        edited = copy(self)
        edited.appearance, edited._between = appearance, {}
        # Tables are shared; what is uploaded beside them is not.
        edited._uploaded = {}
        return edited

    @property
    def varied(self) -> bool:
        """Whether threads of a family differ, so that means depend on the position."""
        return any(len(tables.axes) > 0 for plane in self.planes for tables in plane.tables)

    @property
    def bytes(self) -> int:
        """Size of the tables on a device."""
        tables = (tables for plane in self.planes for tables in plane.tables)
        return sum(of_family.areas.nbytes + of_family.threads.nbytes for of_family in tables)

    @property
    def truncation(self) -> float:
        """Largest error of a thread's albedo, from principal axes that were dropped."""
        return max(tables.truncation for plane in self.planes for tables in plane.tables)

    def over(self, footprint: Footprint, back: Mask) -> tuple[Albedos, Albedos]:
        """Mean albedos of (warp, weft) over footprints, as their axis-aligned boxes: Color3 each, 0 to 1.

        Of layered cloth as views and lights along its normal show them.

        Args:
            back: Bool, the footprint is seen from behind.
        """
        if self.seen is None:
            types = array_types(footprint.centre)
            self.upload(types)
            return self.shown(*self._uploaded[types.Float][0].over(footprint, types.Bool(back)))
        types = array_types(footprint.centre)
        return self.layered(footprint, types.Vector3(0, 0, 1), back).albedos

    def layered(self, footprint: Footprint, view: Vec3, back: Mask) -> LayeredAlbedos:
        """Mean albedos of layered cloth over footprints, as one view of each shows them.

        Args:
            view: unit vector [3] in the frame of the face that is seen.
        """
        types = array_types(footprint.centre)
        self.upload(types)
        back, shares = types.Bool(back), self._shares[types.Float]
        planes = [self.shown(*plane.over(footprint, back)) for plane in self._uploaded[types.Float]]
        return LayeredAlbedos(shares.numbers, planes, shares.stacks(footprint), view, back)

    def shown(self, warp: Albedos, weft: Albedos) -> tuple[Albedos, Albedos]:
        """Means of the tables over threads of one plane as a model takes them; derived classes put theirs."""
        return warp, weft

    def upload(self, types: ArrayTypes) -> None:
        """Uploads the tables to a backend, which otherwise happens at first use."""
        if types.Float not in self._uploaded:
            self._uploaded[types.Float] = [_Uploaded(plane, types) for plane in self.planes]
            if self.seen is not None:
                self._shares[types.Float] = _Shares(self.seen, types)
            if self.appearance.openness is not None:
                self._between[types.Float] = Interreflection(self.appearance, types)

    def of_cloth(self, types: ArrayTypes) -> tuple[Albedos, Albedos]:
        """Mean albedos of (warp, weft) over all threads."""
        self.upload(types)
        planes = [self.shown(*plane.means) for plane in self._uploaded[types.Float]]
        return planes[0] if len(planes) == 1 else self._shares[types.Float].of_cloth(planes)

    def between_yarns(self, types: ArrayTypes) -> Interreflection | None:
        """Light between yarns on one backend; None without."""
        self.upload(types)
        return self._between.get(types.Float)


@dataclass(eq=False)
class Plane:
    """Colours of threads that lie in one plane.

    Attributes:
        families: where threads of warp and weft lie.
        tables: colours of the warp and of the weft.
        start: where the first of their cells begins, x and y, millimetres.
        shares: of what shows of it alone, as much is each family [2 faces, 2 families].
    """

    families: tuple[FamilyTables, FamilyTables]
    tables: tuple[FamilyColours, FamilyColours]
    start: tuple[float, float]
    shares: NDArray[np.float64]

    @classmethod
    def of(cls, geometry: YarnGeometry, appearance: Appearance, layer: Layer | None = None) -> Self:
        """Of the whole cloth, or of a layer of it by itself."""
        warp, weft = geometry.families
        on_top = geometry.layout.warp_on_top
        of_warp, of_weft, start = appearance.warp, appearance.weft, (0.0, 0.0)
        if layer is not None:
            of_warp, of_weft = _of_threads(of_warp, layer.ends), _of_threads(of_weft, layer.picks)
            start = layer.start
        tables = (
            _family_tables(of_warp, warp, weft, on_top),
            _family_tables(of_weft, weft, warp, ~on_top.T),
        )
        across, along = 1 - geometry.layout.warp.open_share, 1 - geometry.layout.weft.open_share
        up = float(on_top.mean())
        shown = np.array(
            [
                [across * (1 - along + along * warps), along * (1 - across + across * (1 - warps))]
                for warps in (up, 1 - up)
            ]
        )
        shares = shown / np.maximum(shown.sum(axis=1, keepdims=True), 1e-9)
        return cls((warp, weft), tables, start, shares)


@dataclass(eq=False)
class Seen:
    """How much of layered cloth each layer shows, and what the layers behind it make of light.

    Attributes:
        rates: see `layer_rates` [stacks, layers, 2 faces, 2 families, `RATES`, 2, `RATE_HALF`].
        behind: where a layer has others behind it: share of the light that passes it which they let out, and
            albedo that they add to what is reflected [stacks, layers, 2 faces, 2 families, 6].
        shares: of the cloth that each stack takes up [stacks].
        axes: where threads of the whole draft lie, without gaps.
        regions: summed areas of each stack, units of `unit` square millimetres [picks + 1, ends + 1, padded];
            none where there is one stack.
    """

    rates: NDArray[np.float64]
    behind: NDArray[np.float64]
    shares: NDArray[np.float64]
    axes: tuple[FamilyTables, FamilyTables]
    regions: NDArray[np.uint32] | None
    unit: float

    @classmethod
    def of(cls, geometry: StackedGeometry, planes: Sequence[Plane], appearance: Appearance) -> Self:
        """From rays over the cloth, and the mean colours of its layers."""
        layout = geometry.layout
        rates, stacking = layer_rates(geometry, appearance), layout.stacking
        gaps = np.array([layer.layout.open_area for layer in layout.layers])
        yarns = [_mean_scattered(plane, appearance) for plane in planes]
        behind = np.zeros((*rates.shape[:4], 6))
        behind[..., :3] = 1
        for stack, of_stack in enumerate(geometry.ranks):
            order = [int(np.flatnonzero(of_stack == rank)[0]) for rank in range(of_stack.max() + 1)]
            for face, from_face in ((0, order), (1, order[::-1])):
                # What all layers behind send back and let out, and the share of it that is gaps.
                back, out, free = np.zeros(3), np.ones(3), 1.0
                for layer in from_face[::-1]:
                    if free < 1:
                        behind[stack, layer, face] = _from_behind(yarns[layer], back, out, free)
                    shown = planes[layer].shares[face] * (1 - gaps[layer])
                    sheet_back, sheet_out = (shown @ part for part in yarns[layer])
                    sheet_out = sheet_out + gaps[layer]
                    between = 1 / (1 - sheet_back * back)
                    back, out = sheet_back + sheet_out**2 * back * between, sheet_out * out * between
                    free *= float(gaps[layer])
                # Ties of the last layer lie before all of them.
                behind[stack, from_face[-1], face] = _from_behind(yarns[from_face[-1]], back, out, free)
        axes = tuple(
            replace(place_family(family), half_width=family.spacing / 2)
            for family in (layout.warp, layout.weft)
        )
        across, along = layout.warp.spacing, layout.weft.spacing
        unit = float(across.sum() * along.sum()) / AREA_UNITS
        if stacking is None:
            return cls(rates, behind, np.ones(1), (axes[0], axes[1]), None, unit)
        stacks = len(stacking.ranks)
        regions = np.zeros((along.size + 1, across.size + 1, _padded(max(2, stacks))), np.uint32)
        for stack in range(stacks):
            for part, sums in _prefix_sums(stacking.regions == stack, along, across):
                regions[1:, 1:, stack][part] = np.rint(sums / unit).astype(np.int64).astype(np.uint32)
        return cls(rates, behind, stacking.shares(), (axes[0], axes[1]), regions, unit)

    @property
    def numbers(self) -> NDArray[np.float64]:
        """`rates`, then `behind` [stacks, layers, 2 faces, 2 families, `SEEN_NUMBERS`]."""
        rates = self.rates.reshape(*self.rates.shape[:4], -1)
        padding = np.zeros((*rates.shape[:4], SEEN_NUMBERS - rates.shape[-1] - 6))
        return np.concatenate([rates, self.behind, padding], axis=-1)

    @property
    def front(self) -> NDArray[np.float64]:
        """Weights of the albedos of each layer over all of the front, seen and lit along its normal, and of
        those of what it lets through [layers, 2 families, 1 + 3]."""
        rates = np.exp(self.rates[:, :, 0, :, :, 0, 0])
        passing = rates[..., BARE, None] + rates[..., COVERED, None] * self.behind[:, :, 0, :, :3]
        passing /= np.maximum(rates[..., BARE] + rates[..., COVERED], 1e-9)[..., None]
        lit = self.shares[:, None, None] * rates[..., LIT]
        weights = np.concatenate([lit[..., None], lit[..., None] * passing], axis=-1).sum(axis=0)
        return weights / np.maximum(weights[..., 0].sum(axis=0), 1e-9)[None, :, None]

    def front_means(self, planes: Sequence[Plane]) -> NDArray[np.float64]:
        """Mean albedos of warp and weft over all of the front [2 families, 12]."""
        albedos = np.array([[tables.mean.reshape(-1, 3) for tables in plane.tables] for plane in planes])
        front = self.front
        area, passing = front[..., :1] + np.zeros(3), front[..., 1:]
        weights = np.stack([area, passing, area, passing], axis=2)
        return (albedos * weights).sum(axis=0).reshape(2, -1)


def _from_behind(
    own: tuple[NDArray[np.float64], NDArray[np.float64]],
    back: NDArray[np.float64],
    out: NDArray[np.float64],
    free: float,
) -> NDArray[np.float64]:
    """`Seen.behind` of a layer [2 families, 6], by one to and fro with layers: see `interreflection.beneath`.

    Args:
        own: R and T of its warp and weft [2, 3] each.
        back, out: what layers behind send back and let out [3], gaps included.
        free: share of them that is gaps, 0 to 1.
    """
    covered = max(1 - free, 1e-6)
    back, out = back / covered, (out - free) / covered
    between = 1 / (1 - own[0] * back)
    return np.concatenate([out * between, own[1] ** 2 * back * between], axis=1)


def _mean_scattered(plane: Plane, appearance: Appearance) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """R and T of the yarns of warp and weft of a plane at one scattering, of light from all around [2, 3]."""
    found = []
    for tables, family in zip(plane.tables, (appearance.warp, appearance.weft), strict=True):
        rows = tables.mean.reshape(len(ALBEDO_NAMES), 3)
        turned, onwards = mean_layer_shares(family.roughness, appearance.optical_depth)
        found.append((rows[0] + float(turned) * rows[2], rows[1] + float(onwards) * rows[3]))
    back, through = zip(*found, strict=True)
    return np.array(back), np.array(through)


class _Shares:
    """What layers show, on one backend."""

    def __init__(self, seen: Seen, types: ArrayTypes) -> None:
        self._types = types
        self.numbers = SeenNumbers(seen.numbers, types)
        self._axes = [_Axis(family, types) for family in seen.axes]
        self._regions = None if seen.regions is None else PairedEntries(seen.regions, types)
        self._unit = dr.opaque(types.Float, seen.unit)
        self._stacks = len(seen.shares)
        self._front = opaque(types.Float, seen.front)

    def of_cloth(self, planes: Sequence[tuple[Albedos, Albedos]]) -> tuple[Albedos, Albedos]:
        """Mean albedos of warp and weft over all of the front."""
        found = []
        for family in (0, 1):
            sums = [self._types.Color3(0) for _ in ALBEDO_NAMES]
            for plane, weights in zip(planes, self._front, strict=True):
                area, *passing = weights[family]
                through = self._types.Color3(*passing)
                for number, name in enumerate(ALBEDO_NAMES):
                    weight = through if name.endswith("transmit") else area
                    sums[number] += weight * getattr(plane[family], name)
            found.append(Albedos(*sums))
        return found[0], found[1]

    def stacks(self, footprint: Footprint) -> list[Float]:
        """Share of each stack in footprints, 0 to 1."""
        types = self._types
        if self._regions is None:
            return [types.Float(1)]
        box = footprint.box()
        own, other = (
            (axis, *axis.bounds(centre, size))
            for axis, centre, size in zip(self._axes, box.centre, box.size, strict=True)
        )
        areas = _integrals(self._regions, own, other, types)
        area = own[0].lengths(*own[1:])[0] * other[0].lengths(*other[1:])[0]
        return [clip(part * self._unit / area, 0, 1) for part in areas[: self._stacks]]


def _of_threads(family: FamilyAppearance, threads: NDArray[np.intp]) -> FamilyAppearance:
    """The appearance of some threads of a family."""
    rows: dict[str, Any] = {name: np.asarray(getattr(family, name))[threads] for name in ALBEDO_NAMES}
    return replace(family, **rows)


@dataclass(eq=False)
class FamilyColours:
    """One family's colours. Its quantities are 1 and r principal coordinates; r = 0 if all threads are equal.

    Attributes:
        mean: of the twelve albedos over the threads [12].
        axes: albedos that a principal coordinate of 1 adds [r, 12].
        threads: a row a thread: its quantities, then their integrals over the visible width, then over the
            cells, of all threads before it; one row more for all of them [n + 1, 3, 1 + r].
        areas: integrals over all crossings before, of threads on top; units [crossings + 1, n + 1, padded].
        unit: square millimetres.
        crossing: mean area of a crossing, square millimetres.
        truncation: largest error of an albedo.
    """

    mean: NDArray[np.float64]
    axes: NDArray[np.float64]
    threads: NDArray[np.float64]
    areas: NDArray[np.uint32]
    unit: float
    crossing: float
    truncation: float


def _family_tables(
    appearance: FamilyAppearance, own: FamilyTables, other: FamilyTables, on_top: NDArray[np.bool_]
) -> FamilyColours:
    rows = np.concatenate(
        [np.asarray(getattr(appearance, name), np.float64) for name in ALBEDO_NAMES], axis=1
    )
    entries = (own.lower.size + 1) * (other.lower.size + 1)
    most = max(MAX_ENTRIES // entries, MIN_QUANTITIES) - 1
    mean, coordinates, axes, truncation = _principal(rows, most)
    if not len(axes):
        nothing = np.zeros((0, 0, 0), np.uint32)
        return FamilyColours(mean, axes, np.zeros((0, 3, 1)), nothing, 1.0, 1.0, truncation)
    quantities = np.concatenate([np.ones((len(rows), 1)), coordinates], axis=1)
    visible, cells = 2 * own.half_width, own.upper - own.lower
    crossing = 2 * other.half_width
    threads = np.zeros((len(rows) + 1, 3, quantities.shape[1]))
    threads[:-1, 0] = quantities
    threads[1:, 1] = np.cumsum(quantities * visible[:, None], axis=0)
    threads[1:, 2] = np.cumsum(quantities * cells[:, None], axis=0)
    area = float(visible.sum() * crossing.sum())
    unit = area / AREA_UNITS
    areas = np.zeros((other.lower.size + 1, own.lower.size + 1, _padded(quantities.shape[1])), np.uint32)
    for number, quantity in enumerate(quantities.T):
        for part, sums in _prefix_sums(on_top, crossing, quantity * visible):
            areas[1:, 1:, number][part] = np.rint(sums / unit).astype(np.int64).astype(np.uint32)
    return FamilyColours(mean, axes, threads, areas, unit, area / on_top.size, truncation)


def _prefix_sums(
    on_top: NDArray[np.bool_], lengths: NDArray[np.float64], values: NDArray[np.float64]
) -> Iterator[tuple[slice, NDArray[np.float64]]]:
    """The summed-area table of lengths [m] times values [n] where `on_top` [m, n]: some rows at a time."""
    before = np.zeros(len(values))
    step = max(1, _CROSSINGS_AT_ONCE // len(values))
    for first in range(0, len(lengths), step):
        rows = slice(first, first + step)
        sums = on_top[rows] * lengths[rows, None] * values
        sums[0] += before
        np.cumsum(sums, axis=0, out=sums)
        before = sums[-1].copy()
        np.cumsum(sums, axis=1, out=sums)
        yield rows, sums


def _principal(
    rows: NDArray[np.float64], most: int
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64], float]:
    """Mean, coordinates within −1 to 1 [n, r], axes [r, 12] and largest error of rows [n, 12]."""
    mean = rows.mean(axis=0)
    left, sizes, right = np.linalg.svd(rows - mean, full_matrices=False)
    coordinates, axes = left * sizes, right
    largest = np.abs(coordinates).max(axis=0)
    # Sorted by the sum of squares, so the first ones suffice.
    rank = min(int((largest > MIN_AXIS).sum()), max(most, 0))
    coordinates = coordinates[:, :rank] / largest[:rank]
    axes = axes[:rank] * largest[:rank, None]
    error = np.abs(rows - mean - coordinates @ axes).max()
    return mean, coordinates, axes, float(error)


def _padded_row(numbers: int) -> int:
    """Numbers of a row that is read at once, or in whole reads of the widest kind."""
    return -(-numbers // _WIDEST) * _WIDEST if numbers > _WIDEST else 1 << (numbers - 1).bit_length()


def _padded(quantities: int) -> int:
    """Quantities of a table entry: two, or whole reads of four."""
    return 2 if quantities == 2 else -(-quantities // 4) * 4


@dataclass
class _Bound:
    """One side of a box: the thread whose cell it lies in, and its position there.

    Attributes:
        thread: its index.
        turns: whole repeats away, Float.
        cell: length of the thread's cell before the bound, millimetres.
        visible: fraction of the thread's visible width before it, 0 to 1.
        width: visible width of the thread, millimetres.
        gap: length of the cell before the bound that the thread leaves open, millimetres.
    """

    thread: UInt
    turns: Float
    cell: Float
    visible: Float
    width: Float
    gap: Float


class _Axis:
    """The threads of one family on one backend, and their integrals of 1 between two bounds."""

    def __init__(self, tables: FamilyTables, types: ArrayTypes) -> None:
        self._types = types
        self._family = upload_family(tables, types)
        self._start = dr.opaque(types.Float, float(tables.lower[0]))
        self._period = dr.opaque(types.Float, tables.period)
        self._smallest = dr.opaque(types.Float, MIN_BOX * tables.period / tables.lower.size)
        self.count = dr.opaque(types.UInt32, tables.lower.size)
        lengths = np.stack([2 * tables.half_width, tables.upper - tables.lower], axis=1)
        before = np.concatenate([np.zeros((1, 2)), np.cumsum(lengths, axis=0)])
        self._before = upload(types.Float, before.astype(np.float32))
        self._visible, self._cells = opaque(types.Float, before[-1])

    def bounds(self, centre: Vec2, size: Vec2) -> tuple[_Bound, _Bound]:
        """Lower and upper bound of an interval of the axis, the centre moved into the first repeat."""
        local = centre - dr.floor((centre - self._start) / self._period) * self._period
        half = maximum(size, self._smallest) * 0.5
        return self._bound(local - half), self._bound(local + half)

    def _bound(self, position: Float) -> _Bound:
        types = self._types
        cell: Cell = self._family.locate(position)
        before = dr.gather(types.Vector2, self._before, cell.thread)
        # Rounding decides between neighbouring cells, so the repeat follows from the chosen cell.
        turns = dr.round((position - self._start - before.y - cell.below) / self._period)
        width = 2 * cell.half_width
        visible = clip((cell.across + cell.half_width) / width, 0, 1)
        ahead = cell.below - cell.across - cell.half_width
        gap = minimum(cell.below, ahead) + maximum(cell.across - cell.half_width, 0)
        return _Bound(cell.thread, turns, cell.below, visible, width, gap)

    def lengths(self, low: _Bound, high: _Bound) -> tuple[Float, Float, Float]:
        """Millimetres between two bounds: of visible threads, of gaps, and in all."""
        types = self._types
        first, last = (dr.gather(types.Vector2, self._before, bound.thread) for bound in (low, high))
        turns = high.turns - low.turns
        between = last - first
        visible = between.x + high.visible * high.width - low.visible * low.width + turns * self._visible
        gaps = between.y - between.x + high.gap - low.gap + turns * (self._cells - self._visible)
        return visible, gaps, between.y + high.cell - low.cell + turns * self._cells


class _Uploaded:
    """Both families on one backend."""

    def __init__(self, plane: Plane, types: ArrayTypes) -> None:
        self._axes = tuple(_Axis(family, types) for family in plane.families)
        self._colours = tuple(_Colours(table, types) for table in plane.tables)
        self._start = None if plane.start == (0.0, 0.0) else opaque(types.Float, plane.start)

    @property
    def means(self) -> tuple[Albedos, Albedos]:
        warp, weft = self._colours
        return warp.uniform, weft.uniform

    def over(self, footprint: Footprint, back: Mask) -> tuple[Albedos, Albedos]:
        warp, weft = self._colours
        if warp.is_uniform and weft.is_uniform:
            return warp.uniform, weft.uniform
        box = footprint.box()
        across, along = self._axes
        x, y = box.centre.x, box.centre.y
        if self._start is not None:
            x, y = x - self._start[0], y - self._start[1]
        columns = across.bounds(x, box.size.x)
        rows = along.bounds(y, box.size.y)
        return (
            warp.mean_over((across, *columns), (along, *rows), back),
            weft.mean_over((along, *rows), (across, *columns), back),
        )


_Stretch = tuple[_Axis, _Bound, _Bound]


class _Colours:
    """One family's colours on one backend."""

    def __init__(self, tables: FamilyColours, types: ArrayTypes) -> None:
        self._types = types
        self.is_uniform = len(tables.axes) == 0
        self.uniform = _albedos(types, opaque(types.Float, tables.mean))
        if self.is_uniform:
            return
        self._mean = opaque(types.Float, tables.mean)
        self._axes = opaque(types.Float, tables.axes)
        self._quantities = len(tables.axes) + 1
        self._unit = dr.opaque(types.Float, tables.unit)
        self._crossing = dr.opaque(types.Float, tables.crossing)
        self._row = _padded_row(3 * self._quantities)
        rows = tables.threads.reshape(len(tables.threads), -1)
        padded = np.pad(rows, ((0, 0), (0, self._row - rows.shape[1])))
        self._threads = upload(types.Float, padded.astype(np.float32))
        self._totals = opaque(types.Float, rows[-1])
        if tables.areas.size <= _MAX_PAIRED:
            self._areas: Entries = PairedEntries(tables.areas, types)
        else:
            areas, tables.areas = move(types.UInt32, tables.areas)
            self._areas = SingleEntries(areas, tables.areas.shape, types)

    def mean_over(self, own: _Stretch, other: _Stretch, back: Mask) -> Albedos:
        """Mean albedos over a box: `own` is its stretch across the family's threads."""
        if self.is_uniform:
            return self.uniform
        visible, cells = self._along(own)
        crossing, gaps, length = other[0].lengths(*other[1:])
        exposed = [
            dr.select(back, part * crossing - on_top, on_top)
            for part, on_top in zip(visible, self._on_top(own, other), strict=True)
        ]
        area = visible[0] * crossing
        noise = NOISE_UNITS * self._unit * minimum(area / self._crossing, 1) + NOISE_FRACTION * area
        sums = [
            part * gaps + dr.select(exposed[0] > noise, crossed, 0) + HIDDEN_WEIGHT * length * cell
            for part, crossed, cell in zip(visible, exposed, cells, strict=True)
        ]
        weight = dr.rcp(maximum(sums[0], 1e-20))
        ratios = [total * weight for total in sums[1:]]
        numbers = []
        for index in range(_NUMBERS):
            number = self._mean[index]
            for ratio, axis in zip(ratios, self._axes, strict=True):
                number = dr.fma(ratio, axis[index], number)
            numbers.append(clip(number, 0, 1))
        return _albedos(self._types, numbers)

    def _along(self, own: _Stretch) -> tuple[list[Float], list[Float]]:
        """Integrals of each quantity over visible widths and over cells, millimetres."""
        _, low, high = own
        turns = high.turns - low.turns
        first, last = (self._of_thread(bound.thread) for bound in (low, high))
        count, visible, cells = self._quantities, [], []
        for number in range(count):
            ends = last[number] * high.visible * high.width - first[number] * low.visible * low.width
            index = count + number
            visible.append(last[index] - first[index] + ends + turns * self._totals[index])
            ends = last[number] * high.cell - first[number] * low.cell
            index += count
            cells.append(last[index] - first[index] + ends + turns * self._totals[index])
        return visible, cells

    def _of_thread(self, thread: UInt) -> list[Float]:
        """A thread's row: its quantities, and their integrals over widths and over cells before it."""
        types, step = self._types, min(self._row, _WIDEST)
        reads = self._row // step
        values: list[Float] = []
        for part in range(reads):
            index = thread * reads + part
            values.extend(dr.gather(types.Vectors, self._threads, index, shape=(step, dr.width(thread))))
        return values

    def _on_top(self, own: _Stretch, other: _Stretch) -> list[Float]:
        """Integrals of each quantity over crossings where the family is on top, square millimetres."""
        found = _integrals(self._areas, own, other, self._types)
        return [value * self._unit for value in found[: self._quantities]]


def _integrals(areas: Entries, own: _Stretch, other: _Stretch, types: ArrayTypes) -> list[Float]:
    """Of each quantity of a summed-area table over a box, in its units."""
    columns, rows = _Steps.of(types, own), _Steps.of(types, other)
    values = []
    for entries in areas.read(rows.entries, columns.entries):
        grid = [rows.differences(column) for column in entries]
        total = types.Float(0)
        for row_weight, line in zip(rows.weights, zip(*grid, strict=True), strict=True):
            # Integer differences are exact; only they are converted to floats.
            parts = [types.Float(types.Int32(part)) for part in columns.differences(line)]
            across = sum(weight * part for weight, part in zip(columns.weights, parts, strict=True))
            total = dr.fma(row_weight, across, total)
        values.append(total)
    return values


@dataclass
class _Steps:
    """The integral between two bounds of an axis as a weighted sum of entries of a summed-area table.

    Attributes:
        entries: indices of the entries before and after the thread of either bound, and of the whole repeat.
        weights: of the `differences` of these entries.
        wraps: the upper bound lies in a thread before that of the lower one, so in a later repeat.
    """

    entries: list[Float]
    weights: list[Float]
    wraps: Any

    @classmethod
    def of(cls, types: ArrayTypes, stretch: _Stretch) -> _Steps:
        axis, low, high = stretch
        wraps = high.thread < low.thread
        turns = high.turns - low.turns - dr.select(wraps, types.Float(1), 0)
        entries = [low.thread, low.thread + 1, high.thread, high.thread + 1, axis.count]
        return cls(entries, [1, high.visible, -low.visible, turns], wraps)

    def differences(self, values: Sequence[Float]) -> list[Float]:
        """Threads between the bounds, then those of the upper and the lower bound, then all of a repeat."""
        low, after_low, high, after_high, whole = values
        between = high - low + dr.select(self.wraps, whole, 0)
        return [between, after_high - high, after_low - low, whole]


def _albedos(types: ArrayTypes, numbers: list[Float]) -> Albedos:
    """Twelve numbers in the order of `ALBEDO_NAMES`."""
    return Albedos(*(types.Color3(*numbers[first : first + 3]) for first in range(0, _NUMBERS, 3)))
