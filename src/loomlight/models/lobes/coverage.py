"""The fraction of the cloth that each group covers: a mip pyramid over the repeat, its lookups, and its bake.

`CoverageLookup` reads the pyramid over a footprint, `count_cells` and `build_pyramid` make it; drafts of many
crossings of few kinds are counted by kinds.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Mask, UInt
from loomlight.core.backend import ArrayTypes, InvariantDivider, clip, maximum, minimum, upload
from loomlight.core.footprint import Footprint
from loomlight.core.frozen import FrozenArg, FrozenFunction
from loomlight.core.parallel_map import parallel_map
from loomlight.models.lobes.groups import Groups, NearestGroup, stand_ins
from loomlight.models.lobes.hemisphere import byte_of_group, mean_of_packs, pack_count
from loomlight.models.lobes.rays import GOLDEN_FRACTION, LATTICE_SHIFT, UploadedCloth
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.stack import ClothGeometry
from loomlight.yarn.threads import MAX_TABLE, DistinctWords, distinct_numbers, row_blocks

# -------------------------------------------------------------------------------------------- coverage lookup
# Anisotropic lookups in the coverage pyramid: the fraction of a footprint that each group covers.
#
# A footprint is the mean of nine taps, three along each of its edges, each at the nearest node of the
# pyramid, as anisotropic filtering reads mip maps: footprints are elongated and rotated against the threads,
# and one square tap does not fit them.
#
# A pixel's box filter has zeros at the frequencies f of the pixel grid, where f·a and f·b are integers (not
# both 0) for its edges a and b: threads near such a frequency would alias to long waves, but vanish from the
# box. Nine equal taps a third of the edges apart have the same zeros, except where both integers are
# multiples of 3, which the taps' own filter damps. So all taps of a footprint are of one level: taps of two
# levels fill the zeros, and pictures show rings of moiré.


# Variance of the first level's tent filters over that of the square they stand for: at 1 estimates err 1.5 %
# more, at 1.6 they lose contrast.
TENT_VARIANCE = 1.3
# Positions of the taps in units of the footprint's edges.
TAP_OFFSETS = tuple((i / 3, j / 3) for i in (-1, 0, 1) for j in (-1, 0, 1))
# Largest side of a tap over that of the footprint; the smallest is half of it. Pictures of three fabrics have
# the same error from 0.6 to 0.75; smaller taps damp threads at three times the pixels' frequency too little.
TAP_SIZE = 0.68
# The least spacing of the taps, in units of `base_size`: that of the first level's nodes.
MIN_TAP_SPACING = 1 / 3
# Smallest extent of a footprint that is divided by, in units of `base_size`.
MIN_FOOTPRINT = 1e-6


@dataclass
class CoverageTaps:
    """Nodes of the pyramid whose mean stands for a footprint.

    Attributes:
        nodes: their indices.
    """

    nodes: list[UInt]


class CoverageLookup:
    """The coverage pyramid on one backend.

    CPUs load contiguous words at once and gather single words one by one. So groups are loaded two packs at a
    time, and holes, whose bytes are stored apart, eight nodes at a time, of which one is used.

    Attributes:
        pack_pairs: pairs of packs of groups a node.
    """

    def __init__(
        self,
        base_size: float,
        levels: NDArray[np.int64],
        table: NDArray[np.uint8],
        repeat: tuple[float, float],
        types: ArrayTypes,
    ) -> None:
        """Uploads a pyramid.

        Args:
            base_size, levels, table: see `CoveragePyramid`.
            repeat: width and height of the repeat, millimetres.
        """
        self._types = types
        self._inverse_size = dr.opaque(types.Float, 1 / base_size)
        self._inverse_repeat = [dr.opaque(types.Float, 1 / side) for side in repeat]
        self._last_level = dr.opaque(types.Float, len(levels) - 1)
        self._face = dr.opaque(types.UInt32, table.shape[1])
        # Node indices stay below 2²⁴, which float32 holds exactly.
        self._levels = upload(types.Float, np.pad(levels, ((0, 0), (0, 1))).astype(np.float32))
        self.pack_pairs = (table.shape[2] - 4) // 8
        self._row = dr.opaque(types.UInt32, self.pack_pairs)
        self._groups = upload(types.UInt32, np.ascontiguousarray(table[..., :-4]).view("<u4"))
        holes = table[..., -4].ravel()
        self._holes = upload(types.UInt32, np.pad(holes, (0, -holes.size % 8)).view("<u4"))

    def taps(self, footprint: Footprint, back: Mask) -> CoverageTaps:
        """Nodes that stand for a footprint, millimetres, of the face that is seen."""
        types = self._types
        level, spacing = self._level_and_spacing(footprint)
        first, columns, rows, _ = dr.gather(types.Vector4, self._levels, types.UInt32(level))
        start = dr.select(back, self._face, 0)
        nodes = self._nodes(footprint, spacing, first, columns, rows)
        return CoverageTaps([start + types.UInt32(node) for node in nodes])

    def groups(self, taps: CoverageTaps, pack_pair: UInt) -> list[list[Float]]:
        """Means over the taps of the bytes of two packs, 0 to 255: twice four Floats."""
        packs = [
            dr.gather(self._types.Index2, self._groups, dr.fma(node, self._row, pack_pair))
            for node in taps.nodes
        ]
        return [mean_of_packs(self._types, [pair[half] for pair in packs]) for half in range(2)]

    def holes(self, taps: CoverageTaps) -> Float:
        """Mean over the taps of the byte of holes, 0 to 255."""
        total = self._types.UInt32(0)
        for node in taps.nodes:
            packs = dr.gather(self._types.Index2, self._holes, node >> 3)
            total += (dr.select((node & 4) == 4, packs.y, packs.x) >> ((node & 3) << 3)) & 255
        return self._types.Float(total) * (1 / len(taps.nodes))

    def _level_and_spacing(self, footprint: Footprint) -> tuple[Float, Float]:
        """The pyramid level of a footprint's taps, and their spacing.

        Returns:
            the level, an integer; and the spacing of the taps in units of a third of the footprint. The
            spacing is below 1 where taps are nearly as large as the footprint, so that their union is not too
            wide, but no less than the spacing of nodes: nine taps at one node would show as steps.
        """
        relative = footprint.spread_side * self._inverse_size
        level: Float = dr.log2(maximum(TAP_SIZE * relative, 1))
        level = minimum(dr.floor(level), self._last_level)
        inverse = dr.rcp(maximum(relative, MIN_FOOTPRINT))
        spacing = dr.sqrt(clip(TENT_VARIANCE * (1 - dr.square(inverse)), 0, 1))
        return level, minimum(maximum(spacing, MIN_TAP_SPACING * inverse), 1)

    def _nodes(
        self, footprint: Footprint, spacing: Float, first: Float, columns: Float, rows: Float
    ) -> Iterator[Float]:
        """Indices of the nodes at `TAP_OFFSETS`, integers.

        Args:
            first, columns, rows: first node, columns and rows of the level.
        """
        across, along = self._inverse_repeat
        x, y = footprint.centre.x * across, footprint.centre.y * along
        first_x, second_x = (spacing * edge.x * across for edge in (footprint.duv_dx, footprint.duv_dy))
        first_y, second_y = (spacing * edge.y * along for edge in (footprint.duv_dx, footprint.duv_dy))
        for s, t in TAP_OFFSETS:
            column = _wrapped_cell(dr.fma(s, first_x, dr.fma(t, second_x, x)), columns)
            row = _wrapped_cell(dr.fma(s, first_y, dr.fma(t, second_y, y)), rows)
            yield dr.fma(row, columns, column) + first


def _wrapped_cell(position: Float, count: Float) -> Float:
    """Index of the cell, of so many along the repeat, that holds a position in units of the repeat."""
    return minimum(dr.floor((position - dr.floor(position)) * count), count - 1)


# ------------------------------------------------------------------------------------------------- cell kinds
# Coverage of the cells of large drafts, counted by kinds of crossings.
#
# Where threads are all alike, the surface within a crossing depends on its two run words alone, and the
# crossings of a draft are of few kinds. The groups of each kind are counted once; a cell is the sum of its
# crossings, those at its sides by the part that lies in it.


# Points of each kind and face.
KIND_POINTS = 610
# Crossings of a kind on average, at least: with fewer, texels of all crossings are counted as soon.
MIN_CROSSINGS = 64
# What the counts of a cell add up to.
CELL_COUNT = 255
# Kinds whose points are counted at once.
_CROSSINGS_AT_ONCE = 1 << 14


@dataclass(frozen=True, eq=False)
class CrossingKinds:
    """The kinds of a draft's crossings: pairs of run words.

    Attributes:
        places: number of a crossing of each kind, row by row.
    """

    words: NDArray[np.uint32]
    distinct: tuple[DistinctWords, DistinctWords]
    indices: NDArray[np.intp]
    places: NDArray[np.intp]

    @classmethod
    def find(cls, geometry: ClothGeometry) -> CrossingKinds | None:
        """The kinds of crossings; None where threads differ, or crossings too much, and in layered cloth."""
        if not isinstance(geometry, YarnGeometry):
            return None
        warp, weft = geometry.families
        if warp.distinct is None or weft.distinct is None or not (warp.uniform and weft.uniform):
            return None
        words, distinct = geometry.words[0], (warp.distinct, weft.distinct)
        count = warp.distinct.values.size * weft.distinct.values.size
        if count > MAX_TABLE:
            return None
        pairs = (_pairs(words[rows], *distinct) for rows in row_blocks(*words.shape[:2]))
        _, indices, places = distinct_numbers(pairs, count)
        is_few = places.size * MIN_CROSSINGS <= words[..., 0].size
        return cls(words, distinct, indices, places) if is_few else None

    def of_pick(self, pick: int) -> NDArray[np.intp]:
        """The kinds of the crossings of a pick [ends]."""
        return self.indices.take(_pairs(self.words[pick], *self.distinct))


def _pairs(words: NDArray[np.uint32], warp: DistinctWords, weft: DistinctWords) -> NDArray[np.intp]:
    return warp.indices(words[..., 0]) * weft.values.size + weft.indices(words[..., 1])


def count_by_kinds(
    cloth: UploadedCloth, nearest: NearestGroup, kinds: CrossingKinds, shape: tuple[int, int, int, int]
) -> NDArray[np.uint8]:
    """Counts of each group in each cell, which add up to `CELL_COUNT`.

    Args:
        shape: of the result: 2 faces, rows, columns, bytes of a cell.
    """
    _, rows, columns, size = shape
    per_kind = _points_by_group(cloth, nearest, kinds.places, size) * np.float32(CELL_COUNT / KIND_POINTS)
    picks, ends = kinds.words.shape[:2]
    (pick_of, high), (end_of, wide) = _overlaps(picks, rows), _overlaps(ends, columns)
    # Rounded up as often as their fraction says: shares below half a count are not lost.
    levels = (np.arange(columns * 2 * size, dtype=np.uint32) * np.uint32(GOLDEN_FRACTION)).astype(np.float32)
    levels = levels.reshape(columns, 2 * size) / np.float32(2**32)
    counts = np.empty(shape, np.uint8)

    def count_row(row: int) -> None:
        line = np.zeros((ends, 2 * size), np.float32)
        for pick, share in zip(pick_of[row], high[row], strict=True):
            line += per_kind.take(kinds.of_pick(pick), axis=0) * share
        cells = levels + np.float32(row * LATTICE_SHIFT[0] % 2**32 / 2**32)
        cells -= np.floor(cells)
        for end, share in zip(end_of.T, wide.T, strict=True):
            cells += line.take(end, axis=0) * share[:, None]
        np.minimum(cells, CELL_COUNT, out=cells)
        counts[:, row] = cells.astype(np.uint8).reshape(columns, 2, size).swapaxes(0, 1)

    parallel_map(count_row, range(rows))
    return counts


def _overlaps(threads: int, cells: int) -> tuple[NDArray[np.intp], NDArray[np.float32]]:
    """Threads that may lie in each cell along an axis, and the share of the cell that each takes up."""
    cell = np.arange(cells)[:, None]
    thread = cell * threads // cells + np.arange(-(-threads // cells) + 1)
    # In parts of a thread, `cells` of them.
    end = np.minimum((thread + 1) * cells, (cell + 1) * threads)
    shared = np.maximum(end - np.maximum(thread * cells, cell * threads), 0)
    return np.minimum(thread, threads - 1), (shared / threads).astype(np.float32)


def _points_by_group(
    cloth: UploadedCloth, nearest: NearestGroup, places: NDArray[np.intp], size: int
) -> NDArray[np.float32]:
    """How many of the `KIND_POINTS` of each kind lie in each group, by byte [kinds, 2 faces · `size`]."""
    types = cloth.types
    picks, ends = cloth.geometry.layout.warp_on_top.shape
    width, height = (dr.opaque(types.Float, side) for side in cloth.geometry.size)
    x_step, y_step = (dr.opaque(types.Float, 1 / count) for count in (ends, picks))
    row = dr.opaque(types.UInt32, size)
    found = []
    for first in range(0, places.size, _CROSSINGS_AT_ONCE):
        part = places[first : first + _CROSSINGS_AT_ONCE]
        counts = dr.zeros(types.UInt32, part.size * 2 * size)
        lane = dr.arange(types.UInt32, part.size * 2 * KIND_POINTS)
        point, side = lane % KIND_POINTS, lane // KIND_POINTS
        kind = (side >> 1) + dr.opaque(types.UInt32, first)
        pick, end = (
            dr.gather(types.Float, upload(types.Float, at), side >> 1) for at in np.divmod(part, ends)
        )
        # A lattice, shifted from kind to kind.
        u, v = (
            types.Float((point * step + kind * shift) >> 8) * 2**-24
            for step, shift in zip((2**32 // KIND_POINTS, GOLDEN_FRACTION), LATTICE_SHIFT, strict=True)
        )
        back = (side & 1) == 1
        surface = cloth.geometry.surface((end + u) * x_step * width, (pick + v) * y_step * height, back)
        dr.scatter_add(counts, types.UInt32(1), side * row + nearest.find_byte(back, surface))
        found.append(counts.numpy().reshape(part.size, 2 * size))
    return np.concatenate(found).astype(np.float32)


# ------------------------------------------------------------------------------------------- coverage pyramid
# Coverage: the fraction of the cloth that each group covers, as a mip pyramid of uint8 over the repeat.
#
# Level m stores means over squares of side s_m = s_0·2^m around nodes s_m/3 apart; the last level has one
# node. The squares are tent filters: a box filter resonates with the period of the weave more than pixels
# do. Memory is bounded: s_0 is one thread, and more for drafts of hundreds of threads.


# Blur steps that make tents of cells: what each neighbour gives to a cell, at most (no weight may be
# negative), and how many there may be. Repeats that need more have three nodes at most, and are uniform by
# then.
MAX_BLUR, MAX_BLUR_STEPS = 0.4, 8
# Nodes along a square's side, and where the table would grow too large: estimates are 1 % worse then.
NODES_PER_SIDE, FEWER_NODES = 3, 2
# Texels between two nodes along each axis, and for each thread, at least.
TEXELS_PER_NODE = 4
TEXELS_PER_THREAD = 3
# Texels along a cell, at most: their counts fit a byte, and cells of many threads need no three a thread.
MAX_TEXELS_PER_NODE = 15
# Texels evaluated at once.
_BATCH = 1 << 23
# Numbers of the pyramid that are processed at once, to fit caches.
_BLOCK = 1 << 17
# Large levels are rounded up to even numbers of nodes, so that halving them is slicing.
EVEN_FROM, EVEN_STEP = 64, 16
# Bytes of all levels of both faces; a third of it is levels beyond the first.
MAX_PYRAMID_BYTES = 56 << 20
_MAX = 255.0
# Powers of the plastic number in units of 2⁻³²: products wrap around as fractions do (Roberts 2018).
TEXEL_JITTER_X, TEXEL_JITTER_Y = 0xC13FA9A9, 0x91E10DA5


@dataclass(frozen=True, eq=False)
class CoveragePyramid:
    """The pyramid of both faces.

    Attributes:
        base_size: s_0, millimetres.
        levels: first node, columns and rows of each level [levels, 3].
        scale: coverage that a byte of 255 stands for [2 faces, 4·(packs + 1)].
        mean: coverage of the whole repeat [2, 4·(packs + 1)].
        bytes: [2 faces, nodes of all levels, 4·(packs + 1)]: packed groups, then holes in the first byte of
            the last pack.
    """

    base_size: float
    levels: NDArray[np.int64]
    scale: NDArray[np.float64]
    mean: NDArray[np.float64]
    bytes: NDArray[np.uint8]


@dataclass(frozen=True)
class Spacing:
    """Size of the first level's squares, and how densely its nodes lie.

    Attributes:
        base_size: s_0, millimetres.
        nodes: along a square's side.
    """

    base_size: float
    nodes: int

    @property
    def far_weight(self) -> float:
        """Weight a of the nodes one and a half spacings away in a level made from the one below.

        The rest goes to those half a spacing away. Squares twice as wide have four times the variance; with v
        that of a first-level tent in spacings, v + (1 − a)/4 + 9a/4 = 4v.
        """
        return ((self.nodes**2 - 2) / 4 - 1 / 4) / 2


def spacing_of(geometry: ClothGeometry, per_family: int) -> Spacing:
    """Squares of one thread, or as small as the bound on memory allows."""
    width, height = geometry.size
    picks, ends = geometry.layout.warp_on_top.shape
    thread = math.sqrt(width / ends * height / picks)
    row = 2 * 4 * (pack_count(per_family) + 1)
    for nodes in (NODES_PER_SIDE, FEWER_NODES):
        smallest = nodes * math.sqrt(width * height * row * 4 / 3 / MAX_PYRAMID_BYTES)
        if smallest <= thread:
            return Spacing(thread, nodes)
    return Spacing(smallest, nodes)


@dataclass
class CellCounts:
    """Number of texels of each group in each cell around the first level's nodes.

    Attributes:
        repeat: width and height of the repeat, millimetres.
        spacing: of the nodes.
        shape: faces, rows, columns, 4·(packs + 1).
        texels: of a cell.
        packed: counts of 8 bits in 32-bit words; of arrays on a device, it may still count.
    """

    repeat: tuple[float, float]
    spacing: Spacing
    shape: tuple[int, int, int, int]
    texels: int
    packed: UInt | NDArray[np.uint32]

    def counts(self) -> NDArray[np.uint8]:
        """The counts [2, rows, columns, 4·(packs + 1)]."""
        return np.asarray(self.packed).view(np.uint8).reshape(self.shape)


def count_cells(
    cloth: FrozenArg[UploadedCloth], nearest: FrozenArg[NearestGroup], per_family: int
) -> CellCounts:
    """Counts the texels of each group over the repeat; does not wait for the device where texels are few."""
    types, geometry = cloth.value.types, cloth.value.geometry
    spacing = spacing_of(geometry, per_family)
    columns, rows = (nodes_along(side, spacing) for side in geometry.size)
    picks, ends = geometry.layout.warp_on_top.shape
    across, along = (texels_along(threads, count) for threads, count in ((ends, columns), (picks, rows)))
    shape = 2, rows, columns, 4 * (pack_count(per_family) + 1)
    # The crossings of a cell count as wholes where there are several.
    has_wholes = min(ends / columns, picks / rows) >= 2
    if has_wholes and (kinds := CrossingKinds.find(geometry)) is not None:
        packed = count_by_kinds(cloth.value, nearest.value, kinds, shape).view(np.uint32).ravel()
        return CellCounts(geometry.size, spacing, shape, CELL_COUNT, packed)
    texels = _Texels(types, geometry.size, (columns, rows), (across, along), per_family)
    if texels.count <= _BATCH:
        packed = _count_all(cloth, nearest, FrozenArg(texels), texels.count, texels.words)
    else:
        packed = dr.zeros(types.UInt32, texels.words)
        for start in range(0, texels.count, _BATCH):
            lane = dr.arange(types.UInt32, min(_BATCH, texels.count - start))
            texels.add(cloth.value, nearest.value, lane + dr.opaque(types.UInt32, start), packed)
            dr.eval(packed)
    return CellCounts(geometry.size, spacing, shape, across * along, packed)


def nodes_along(side: float, spacing: Spacing) -> int:
    """Nodes of the first level along one side of the repeat."""
    count = max(1, math.ceil(spacing.nodes * side / spacing.base_size - 1e-6))
    return count if count <= EVEN_FROM else -(-count // EVEN_STEP) * EVEN_STEP


def texels_along(threads: int, nodes: int) -> int:
    """Texels of a cell along one axis of a repeat of so many threads."""
    return max(TEXELS_PER_NODE, min(math.ceil(TEXELS_PER_THREAD * threads / nodes), MAX_TEXELS_PER_NODE))


class _Texels:
    """The texels of the repeat, cell by cell, and their counters in the table: opaque sizes.

    Several counters share a word, so that large tables are written to memory once.

    Attributes:
        count: texels of both faces.
        words: 32-bit words of the table of counts.
    """

    def __init__(
        self,
        types: ArrayTypes,
        repeat: tuple[float, float],
        cells: tuple[int, int],
        texels: tuple[int, int],
        per_family: int,
    ) -> None:
        """
        Args:
            repeat: width and height, millimetres.
            cells: along either side of the repeat.
            texels: along either side of a cell.
        """
        self._types = types
        (columns, rows), (across, along) = cells, texels
        row = pack_count(per_family) + 1
        wide, high = columns * across, rows * along
        self.count, self.words = 2 * wide * high, 2 * columns * rows * row
        self._sizes = [dr.opaque(types.UInt32, size) for size in (wide * high, columns, columns * rows, row)]
        self._wide, self._across, self._along = (
            InvariantDivider(size, types) for size in (wide, across, along)
        )
        self._steps = [
            dr.opaque(types.Float, side / size) for side, size in zip(repeat, (wide, high), strict=True)
        ]

    def add(self, cloth: UploadedCloth, nearest: NearestGroup, lane: UInt, packed: UInt) -> None:
        """Adds 1 to the count of the cell and group of each of some texels."""
        Float, UInt32 = self._types.Float, self._types.UInt32
        face_size, columns, face_nodes, row_words = self._sizes
        back = lane >= face_size
        texel = dr.select(back, lane - face_size, lane)
        row, column = self._wide.divide(texel)
        jitter_x = Float((texel * TEXEL_JITTER_X) >> 8) * 2**-24
        jitter_y = Float((texel * TEXEL_JITTER_Y) >> 8) * 2**-24
        point = cloth.geometry.surface(
            (Float(column) + jitter_x) * self._steps[0], (Float(row) + jitter_y) * self._steps[1], back
        )
        byte = nearest.find_byte(back, point)
        node = self._along.divide(row)[0] * columns + self._across.divide(column)[0]
        node += dr.select(back, face_nodes, 0)
        # Integers: their sum does not depend on the order in which threads add them.
        dr.scatter_add(packed, UInt32(1) << 8 * (byte & 3), node * row_words + (byte >> 2))


@FrozenFunction
def _count_all(cloth: UploadedCloth, nearest: NearestGroup, texels: _Texels, count: int, words: int) -> UInt:
    """Counts all texels at once; the numbers of texels and words are constants of a recording."""
    packed = dr.zeros(cloth.types.UInt32, words)
    texels.add(cloth, nearest, dr.arange(cloth.types.UInt32, count), packed)
    return packed


def cover_hidden(cells: CellCounts, groups: Groups, area: NDArray[np.float64]) -> None:
    """Gives groups that are hidden from straight above the counts of those they lie beside; waits for counts.

    Args:
        area: projected areas [2 faces, nodes, 2 K groups and holes]; see `VisibilityTables`.
    """
    counts, offsets = cells.counts(), byte_of_group(groups.per_family)
    texels = counts.sum(axis=(1, 2), dtype=np.float64)[:, offsets] / (counts[0, ..., 0].size * cells.texels)
    for of_face, sources in zip(counts, stand_ins(groups, texels, area[..., :-1].max(axis=1)), strict=True):
        for group in np.flatnonzero(sources != np.arange(groups.count)):
            of_face[..., offsets[group]] = of_face[..., offsets[sources[group]]]
    cells.packed = counts.view(np.uint32).ravel()


def build_pyramid(cells: CellCounts) -> CoveragePyramid:
    """The pyramid over the cells; waits for their counts."""
    counts = cells.counts()
    # A face after the other: numbers of the first level take four times the memory of their bytes.
    faces = [_levels(cells, counts[face : face + 1]) for face in (0, 1)]
    levels = faces[0][0]
    scale, mean, packed = (np.concatenate([face[part] for face in faces]) for part in (1, 2, 3))
    return CoveragePyramid(cells.spacing.base_size, levels, scale, mean, packed)


def _levels(cells: CellCounts, counts: NDArray[np.uint8]) -> tuple[NDArray[Any], ...]:
    """Levels, scale, mean and bytes, as in `CoveragePyramid`, of some faces' counts."""
    means, mean, largest = _first_level(cells, counts)
    # The largest value is in the first level: the others are means of it.
    scale = np.maximum(largest, 1e-9).astype(np.float64)
    per_share = (_MAX / scale).astype(np.float32)[:, None]
    levels: list[tuple[int, int, int]] = []
    parts: list[NDArray[np.uint8]] = []
    first = 0
    while True:
        rows, columns = means.shape[1:3]
        levels.append((first, columns, rows))
        parts.append(_quantized(means, per_share))
        first += columns * rows
        if columns * rows == 1:
            return np.array(levels, np.int64), scale, mean, np.concatenate(parts, axis=1)
        means = _downsampled(means, cells.spacing.far_weight)


def _first_level(
    cells: CellCounts, counts: NDArray[np.uint8]
) -> tuple[NDArray[np.float32], NDArray[np.float64], NDArray[np.float32]]:
    """Tents over the cells of some faces, means of the repeat, and the largest value of any tent."""
    faces, rows, columns, groups = counts.shape
    sides = zip((rows, columns), cells.repeat[::-1], strict=True)
    steps = [blur_steps(cells.spacing.base_size * count / side) for count, side in sides]
    across = np.arange(-len(steps[1]), columns + len(steps[1])) % columns
    means = np.empty(counts.shape, np.float32)
    totals = np.zeros((faces, columns, groups))
    largest = np.zeros((faces, groups), np.float32)
    for start, stop in _blocks(rows, columns * groups):
        along = np.arange(start - len(steps[0]), stop + len(steps[0])) % rows
        part = counts.take(along, axis=1).take(across, axis=2).astype(np.float32)
        # Integers below 2²⁴, exact in single precision.
        inner = (slice(None), *(slice(len(step), -len(step)) for step in steps))
        totals += part[inner].sum(axis=1)
        part *= np.float32(1 / cells.texels)
        for axis, weights in enumerate(steps, 1):
            for weight in weights:
                part = _blurred(part, axis, weight)
        means[:, start:stop] = part
        largest = np.maximum(largest, part.max(axis=1).max(axis=1))
    return means, totals.sum(axis=1) * (1 / (rows * columns * cells.texels)), largest


def blur_steps(cells: float) -> list[np.float32]:
    """Weights of each neighbour of a cell, step by step, so that cells become tents.

    With w of each neighbour a cell's variance of 1/12 becomes 1/12 + 2w, and interpolation adds 1/6. Wide
    squares, of repeats that are narrow or whose nodes were rounded up, take several such steps.

    Args:
        cells: along the square's side.
    """
    missing = (TENT_VARIANCE * cells**2 - 3) / 12
    steps = min(max(1, math.ceil(missing / (2 * MAX_BLUR))), MAX_BLUR_STEPS)
    return [np.float32(min(missing / (2 * steps), MAX_BLUR))] * steps


def _blurred(means: NDArray[np.float32], axis: int, weight: np.float32) -> NDArray[np.float32]:
    """One step of `blur_steps` along an axis, which loses a cell at either end."""
    before, middle, after = (
        means[(slice(None),) * axis + (slice(start, stop),)] for start, stop in ((0, -2), (1, -1), (2, None))
    )
    total: NDArray[np.float32] = before + after
    total *= weight
    total += (1 - 2 * weight) * middle
    return total


def _quantized(means: NDArray[np.float32], per_share: NDArray[np.float32]) -> NDArray[np.uint8]:
    """Means as bytes [faces, nodes, groups]."""
    flat = means.reshape(means.shape[0], -1, means.shape[-1])
    quantized = np.empty(flat.shape, np.uint8)
    for start, stop in _blocks(flat.shape[1], flat.shape[2]):
        part = flat[:, start:stop] * per_share
        part += np.float32(0.5)
        quantized[:, start:stop] = part
    return quantized


def _downsampled(means: NDArray[np.float32], far_weight: float) -> NDArray[np.float32]:
    """Means over squares twice as wide."""
    faces, rows, columns, groups = means.shape
    across, along = -(-columns // 2), -(-rows // 2)
    if rows != 2 * along:
        return _downsampled_along(_downsampled_along(means, along, 1, far_weight), across, 2, far_weight)
    result = np.empty((faces, along, across, groups), np.float32)
    for start, stop in _blocks(along, 4 * across * groups):
        part = _from_pairs(means.take(np.arange(2 * start - 1, 2 * stop + 1) % rows, axis=1), 1, far_weight)
        result[:, start:stop] = _downsampled_along(part, across, 2, far_weight)
    return result


def _downsampled_along(
    means: NDArray[np.float32], count: int, axis: int, far_weight: float
) -> NDArray[np.float32]:
    """Means over squares twice as wide along one axis, at `count` nodes."""
    before = means.shape[axis]
    if before == 2 * count:
        return _from_pairs(means.take(np.arange(-1, before + 1) % before, axis=axis), axis, far_weight)
    middle = (np.arange(count) + 0.5) * (before / count) - 0.5
    total = np.zeros((*means.shape[:axis], count, *means.shape[axis + 1 :]), np.float32)
    shape = [1] * means.ndim
    shape[axis] = count
    for offset, weight in ((0.5, 0.5 * (1 - far_weight)), (1.5, 0.5 * far_weight)):
        for position in (middle - offset, middle + offset):
            lower = np.floor(position + 1e-9).astype(np.intp)
            share = np.maximum(position - lower, 0)
            for node, part in ((lower, 1 - share), (lower + 1, share)):
                factor = (weight * part).astype(np.float32).reshape(shape)
                total += factor * np.take(means, node % before, axis=axis)
    return total


def _from_pairs(means: NDArray[np.float32], axis: int, far_weight: float) -> NDArray[np.float32]:
    """The same from pairs of nodes, with one more node at either end."""
    last = means.shape[axis] - 2
    before, even, odd, after = (
        means[(slice(None),) * axis + (slice(start, start + last, 2),)] for start in range(4)
    )
    near: NDArray[np.float32] = np.float32(0.5 * (1 - far_weight)) * (even + odd)
    return near + np.float32(0.5 * far_weight) * (before + after)


def _blocks(count: int, size: int) -> Iterator[tuple[int, int]]:
    """Ranges of consecutive rows, `size` numbers each, that fit caches."""
    step = max(2, _BLOCK // size)
    for start in range(0, count, step):
        yield start, min(start + step, count)
