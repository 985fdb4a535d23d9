"""How much of each group a footprint holds: a pyramid of running means over the repeat, a byte a group.

Level m holds means over squares of side s_m = s_0·2^m around nodes s_m/3 apart. A footprint is the mean of
nine of them, three along each of its edges, each at the nearest node: footprints are long and lie askew of
the threads, and nine squares of about half their size follow them where one does not. Sizes between two
levels take some from either. The squares are tents: a sharp square answers to a weave's regularity more than
pixels do. Levels end where a square holds the whole repeat.
Size is bounded: s_0 is one thread, and more for drafts of hundreds of threads.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import DRJIT, ArrayTypes, minimum, upload
from loomlight.core.footprint import Footprint
from loomlight.core.frozen import FrozenArg, FrozenFunction
from loomlight.models.lobes.bytes import mean_bytes
from loomlight.models.lobes.divider import Divider
from loomlight.models.lobes.groups import Cloth, GroupFinder
from loomlight.yarn.geometry import YarnGeometry

# Variance of the first level's tents, of that of the square they stand for: at 1 estimates err 1.5 % more, at
# 1.6 they lose contrast.
TENT = 1.3
# What of each neighbour goes to a cell in one step, at most: none may count less than nothing. Repeats that
# need more steps have three nodes at the most, and are even by then.
_MOST_BESIDE, _MOST_STEPS = 0.4, 8
# Nodes along a square's side, and where the table would grow too large: estimates are 1 % worse then.
_NODES_PER_SIDE, _FEWER_NODES = 3, 2
# Plan texels between two nodes along each axis, and for each thread, at least: so many points a mean is of.
_TEXELS_PER_NODE = 4
_TEXELS_PER_THREAD = 3
# Texels evaluated at once.
_BATCH = 1 << 23
# Numbers of the pyramid worked on at once, which the caches hold, and how many make threads worth while.
_BLOCK, _LARGE = 1 << 17, 1 << 22
# Large levels are rounded up to even numbers of nodes, so that their halves are slices.
_EVEN_FROM, _EVEN_STEP = 64, 16
# Bytes of all levels of both faces; a third of it is levels beyond the first.
_MOST_BYTES = 56 << 20
_LARGEST = 255.0
_BEHIND = 64  # bytes of the longest vectors
# Places of squares along the edges of a footprint; the first go over to the wider squares first.
PLACES = tuple(
    (i / 3, j / 3) for i, j in ((0, 0), (-1, -1), (1, 1), (1, -1), (-1, 1), (0, 1), (0, -1), (1, 0), (-1, 0))
)
# Side of the squares, of the footprint's, half an octave up or down: with more what lies askew blurs, with
# less gaps open between nine of them. Pictures of denim err as little at 0.5, and 8 % more at 0.4 and 0.7.
SQUARE_SHARE = 0.6
_NEAREST = 1e-6
# Of a third of s_0, which is where nodes of the first level are; see `_apart`.
CLOSEST = 1 / 3
# Powers of the plastic number in units of 2⁻³²: products wrap around as fractions do (Roberts 2018).
_ACROSS, _ALONG = 0xC13FA9A9, 0x91E10DA5


@dataclass(frozen=True, eq=False)
class Coverage:
    """The pyramid of both faces.

    Attributes:
        size: s_0, millimetres.
        levels: first node, columns and rows of each level [levels, 3].
        scale: share of the area that a byte of 255 stands for [2 faces, 4·words].
        mean: shares of the whole repeat [2, 4·words].
        bytes: [2 faces, nodes of all levels, 4·words]: groups, padded, and holes in the last word's first.
    """

    size: float
    levels: NDArray[np.int64]
    scale: NDArray[np.float64]
    mean: NDArray[np.float64]
    bytes: NDArray[np.uint8]


@dataclass
class CoverageTaps:
    """Nodes that together stand for a footprint, all alike.

    Attributes:
        nodes: their numbers, UInt32 each.
    """

    nodes: list[Any]


def words_of(per_family: int) -> int:
    """Words of four bytes that the groups of both families take up, holes left out."""
    return 2 * -(-per_family // 4)


def padded_group(per_family: int) -> NDArray[np.intp]:
    """Place of each group among the bytes of a node [2 K]; families begin with a word of their own."""
    number = np.arange(2 * per_family)
    return number % per_family + number // per_family * 4 * (words_of(per_family) // 2)


@dataclass(frozen=True)
class Spacing:
    """How squares and nodes lie.

    Attributes:
        size: s_0, millimetres.
        nodes: along a square's side.
    """

    size: float
    nodes: int

    @property
    def far_weight(self) -> float:
        """Weight a of the nodes one and a half spacings away in a level made from the one below.

        The rest goes to those half a spacing away. Squares twice as wide have four times the variance; with v
        that of a baked tent in spacings, v + (1 − a)/4 + 9a/4 = 4v.
        """
        return ((self.nodes**2 - 2) / 4 - 1 / 4) / 2


def spacing_of(geometry: YarnGeometry, per_family: int) -> Spacing:
    """Squares of one thread, or as small as the table's bound allows."""
    width, height = geometry.size
    picks, ends = geometry.layout.warp_on_top.shape
    thread = math.sqrt(width / ends * height / picks)
    row = 2 * 4 * (words_of(per_family) + 1)
    for nodes in (_NODES_PER_SIDE, _FEWER_NODES):
        smallest = nodes * math.sqrt(width * height * row * 4 / 3 / _MOST_BYTES)
        if smallest <= thread:
            return Spacing(thread, nodes)
    return Spacing(smallest, nodes)


@dataclass
class CellCounts:
    """How many texels of each cell between the first level's nodes show which group. Work may go on.

    Attributes:
        repeat: width and height of the repeat, millimetres.
        spacing: of the nodes.
        shape: faces, rows, columns, 4·words.
        texels: of a cell.
        counts: UInt32 [2·rows·columns·4·words / n], n numbers each, as many as fit.
    """

    repeat: tuple[float, float]
    spacing: Spacing
    shape: tuple[int, int, int, int]
    texels: int
    counts: Any

    def numbers(self) -> NDArray[Any]:
        """The counts [2, rows, columns, 4·words]."""
        kind = np.uint8 if _counts_of_a_word(self.texels) == 4 else np.uint16
        return np.asarray(self.counts.numpy().view(kind).reshape(self.shape))


def _counts_of_a_word(texels: int) -> int:
    """How many counts of so many texels at the most a word of four bytes holds: 4 or 2."""
    return 4 if texels < 1 << 8 else 2


def measure_coverage(cells: CellCounts) -> Coverage:
    """The pyramid over the cells."""
    counts = cells.numbers()
    if counts.size < _LARGE:
        levels, *parts = _pyramid(cells, counts)
    else:
        # A face a thread: numpy's loops do not hold the interpreter up.
        with ThreadPoolExecutor(2) as pool:
            faces = list(pool.map(lambda face: _pyramid(cells, face), (counts[:1], counts[1:])))
        levels = faces[0][0]
        parts = [np.concatenate(pair) for pair in zip(*(face[1:] for face in faces), strict=True)]
    scale, mean, packed = parts
    return Coverage(cells.spacing.size, levels, scale, mean, packed)


def _pyramid(cells: CellCounts, counts: NDArray[Any]) -> tuple[NDArray[Any], ...]:
    """Levels, scale, mean and bytes, as in `Coverage`, of some faces' counts."""
    means, mean, largest = _first_level(cells, counts)
    # The first level holds the extremes of all: the others are means of it.
    scale = np.maximum(largest, 1e-9).astype(np.float64)
    unit = (_LARGEST / scale).astype(np.float32)[:, None]
    levels: list[tuple[int, int, int]] = []
    parts: list[NDArray[np.uint8]] = []
    first = 0
    while True:
        rows, columns = means.shape[1:3]
        levels.append((first, columns, rows))
        parts.append(_packed(means, unit))
        first += columns * rows
        if columns * rows == 1:
            return np.array(levels, np.int64), scale, mean, np.concatenate(parts, axis=1)
        means = _halved(means, cells.spacing.far_weight)


def _first_level(
    cells: CellCounts, counts: NDArray[Any]
) -> tuple[NDArray[np.float32], NDArray[np.float64], NDArray[np.float32]]:
    """Tents over the cells of some faces, means of the repeat, and the largest numbers of all tents."""
    faces, rows, columns, groups = counts.shape
    sides = zip((rows, columns), cells.repeat[::-1], strict=True)
    shares = [_beside(cells.spacing.size * count / side) for count, side in sides]
    across = np.arange(-len(shares[1]), columns + len(shares[1])) % columns
    means = np.empty(counts.shape, np.float32)
    totals = np.zeros((faces, columns, groups))
    largest = np.zeros((faces, groups), np.float32)
    for start, stop in _blocks(rows, columns * groups):
        along = np.arange(start - len(shares[0]), stop + len(shares[0])) % rows
        part = counts.take(along, axis=1).take(across, axis=2).astype(np.float32)
        # Whole numbers, which single precision holds.
        own = (slice(None), *(slice(len(share), -len(share)) for share in shares))
        totals += part[own].sum(axis=1)
        part *= np.float32(1 / cells.texels)
        for axis, share in enumerate(shares, 1):
            for beside in share:
                part = _widened(part, axis, beside)
        means[:, start:stop] = part
        largest = np.maximum(largest, part.max(axis=1).max(axis=1))
    return means, totals.sum(axis=1) * (1 / (rows * columns * cells.texels)), largest


def _packed(means: NDArray[np.float32], unit: NDArray[np.float32]) -> NDArray[np.uint8]:
    """Bytes of means [faces, nodes, groups]."""
    flat = means.reshape(means.shape[0], -1, means.shape[-1])
    packed = np.empty(flat.shape, np.uint8)
    for start, stop in _blocks(flat.shape[1], flat.shape[2]):
        part = flat[:, start:stop] * unit
        part += np.float32(0.5)
        packed[:, start:stop] = part
    return packed


def _blocks(count: int, size: int) -> Iterator[tuple[int, int]]:
    """Where blocks of so many rows of one size begin and end that the caches hold them."""
    step = max(2, _BLOCK // size)
    for start in range(0, count, step):
        yield start, min(start + step, count)


def _nodes_along(side: float, spacing: Spacing) -> int:
    """Nodes of the first level along one side of the repeat."""
    count = max(1, math.ceil(spacing.nodes * side / spacing.size - 1e-6))
    return count if count <= _EVEN_FROM else -(-count // _EVEN_STEP) * _EVEN_STEP


class _Texels:
    """The texels of the plan, cell by cell, and where the table counts them: opaque numbers.

    Counts share words, so that large tables are written to memory once.

    Attributes:
        lanes: texels of both faces.
        words: of the table of counts.
    """

    def __init__(
        self,
        types: ArrayTypes,
        repeat: tuple[float, float],
        cells: tuple[int, int],
        texels: tuple[int, int],
        per_family: int,
    ) -> None:
        """Texels of so many along the sides of a cell, of so many cells along the sides of the repeat."""
        self._types = types
        (columns, rows), (across, along) = cells, texels
        counts_of_a_word = _counts_of_a_word(across * along)
        row = 4 * (words_of(per_family) + 1) // counts_of_a_word
        wide, high = columns * across, rows * along
        self.lanes, self.words = 2 * wide * high, 2 * columns * rows * row
        counts = wide * high, columns, columns * rows, row, per_family
        self._numbers = [dr.opaque(types.UInt32, count) for count in counts]
        self._wide, self._across, self._along = (Divider(count, types) for count in (wide, across, along))
        self._of_a_word = Divider(counts_of_a_word, types)
        self._bits = dr.opaque(types.UInt32, 32 // counts_of_a_word)
        self._family_places = dr.opaque(types.UInt32, 4 * words_of(per_family) // 2)
        self._steps = [
            dr.opaque(types.Float, side / count) for side, count in zip(repeat, (wide, high), strict=True)
        ]

    def count(self, cloth: Cloth, finder: GroupFinder, lane: Any, counts: Any) -> None:
        """Adds 1 to the cell and group of each texel of some lanes."""
        Float, UInt32 = self._types.Float, self._types.UInt32
        face, columns, face_nodes, row_words, per_family = self._numbers
        back = lane >= face
        texel = dr.select(back, lane - face, lane)
        row, column = self._wide.divide(texel)
        share_x = Float((texel * _ACROSS) >> 8) * 2**-24
        share_y = Float((texel * _ALONG) >> 8) * 2**-24
        point = cloth.geometry.surface(
            (Float(column) + share_x) * self._steps[0], (Float(row) + share_y) * self._steps[1], back
        )
        group = finder.group(back, point.is_warp, point.hole, point.normal, point.tangent)
        place = dr.select(group < per_family, group, group - per_family + self._family_places)
        place = dr.select(group == finder.holes, 2 * self._family_places, place)
        node = self._along.divide(row)[0] * columns + self._across.divide(column)[0]
        node += dr.select(back, face_nodes, 0)
        word, number = self._of_a_word.divide(place)
        # Whole numbers, whose sum does not depend on the order in which threads add them.
        dr.scatter_add(counts, UInt32(1) << (number * self._bits), node * row_words + word)


def count_cells(cloth: FrozenArg[Cloth], finder: FrozenArg[GroupFinder], per_family: int) -> CellCounts:
    """Looks which group shows at every texel of the plan, and does not wait for it where texels are few."""
    types, geometry = cloth.value.types, cloth.value.geometry
    spacing = spacing_of(geometry, per_family)
    columns, rows = (_nodes_along(side, spacing) for side in geometry.size)
    picks, ends = geometry.layout.warp_on_top.shape
    across, along = (
        max(_TEXELS_PER_NODE, math.ceil(_TEXELS_PER_THREAD * threads / count))
        for threads, count in ((ends, columns), (picks, rows))
    )
    texels = _Texels(types, geometry.size, (columns, rows), (across, along), per_family)
    if texels.lanes <= _BATCH:
        counts = _counted(cloth, finder, FrozenArg(texels), texels.lanes, texels.words)
    else:
        counts = dr.zeros(types.UInt32, texels.words)
        for start in range(0, texels.lanes, _BATCH):
            lane = dr.arange(types.UInt32, min(_BATCH, texels.lanes - start))
            texels.count(cloth.value, finder.value, lane + dr.opaque(types.UInt32, start), counts)
            dr.eval(counts)
    shape = 2, rows, columns, 4 * (words_of(per_family) + 1)
    return CellCounts(geometry.size, spacing, shape, across * along, counts)


@FrozenFunction
def _counted(cloth: Cloth, finder: GroupFinder, texels: _Texels, lanes: int, words: int) -> Any:
    """Counts of all texels; their number and that of the words are part of a recording."""
    counts = dr.zeros(cloth.types.UInt32, words)
    texels.count(cloth, finder, dr.arange(cloth.types.UInt32, lanes), counts)
    return counts


def _beside(cells: float) -> list[np.float32]:
    """What of each neighbour goes to a cell, step by step, so that tents over cells come of it.

    With w of each neighbour a cell's variance of 1/12 becomes 1/12 + 2w, and interpolation adds 1/6. Wide
    squares, of repeats that are narrow or whose nodes were rounded up, take several such steps.

    Args:
        cells: along the square's side.
    """
    missing = (TENT * cells**2 - 3) / 12
    steps = min(max(1, math.ceil(missing / (2 * _MOST_BESIDE))), _MOST_STEPS)
    return [np.float32(min(missing / (2 * steps), _MOST_BESIDE))] * steps


def _widened(means: NDArray[np.float32], axis: int, beside: np.float32) -> NDArray[np.float32]:
    """One step of `_beside` along an axis, which loses a cell at either end."""
    before, middle, after = (
        means[(slice(None),) * axis + (slice(start, stop),)] for start, stop in ((0, -2), (1, -1), (2, None))
    )
    total: NDArray[np.float32] = before + after
    total *= beside
    total += (1 - 2 * beside) * middle
    return total


def _halved(means: NDArray[np.float32], far_weight: float) -> NDArray[np.float32]:
    """Means over squares twice as wide."""
    faces, rows, columns, groups = means.shape
    across, along = -(-columns // 2), -(-rows // 2)
    if rows != 2 * along:
        return _halved_along(_halved_along(means, along, 1, far_weight), across, 2, far_weight)
    halved = np.empty((faces, along, across, groups), np.float32)
    for start, stop in _blocks(along, 4 * across * groups):
        part = _from_pairs(means.take(np.arange(2 * start - 1, 2 * stop + 1) % rows, axis=1), 1, far_weight)
        halved[:, start:stop] = _halved_along(part, across, 2, far_weight)
    return halved


def _halved_along(
    means: NDArray[np.float32], count: int, axis: int, far_weight: float
) -> NDArray[np.float32]:
    """The same along one axis."""
    before = means.shape[axis]
    if before == 2 * count:
        return _from_pairs(means.take(np.arange(-1, before + 1) % before, axis=axis), axis, far_weight)
    middle = (np.arange(count) + 0.5) * (before / count) - 0.5
    total = np.zeros((*means.shape[:axis], count, *means.shape[axis + 1 :]), np.float32)
    shape = [1] * means.ndim
    shape[axis] = count
    for offset, weight in ((0.5, 0.5 * (1 - far_weight)), (1.5, 0.5 * far_weight)):
        for place in (middle - offset, middle + offset):
            lower = np.floor(place + 1e-9).astype(np.intp)
            share = np.maximum(place - lower, 0)
            for node, part in ((lower, 1 - share), (lower + 1, share)):
                factor = (weight * part).astype(np.float32).reshape(shape)
                total += factor * np.take(means, node % before, axis=axis)
    return total


def _from_pairs(means: NDArray[np.float32], axis: int, far_weight: float) -> NDArray[np.float32]:
    """The same of pairs of nodes, with one more node at either end."""
    last = means.shape[axis] - 2
    before, even, odd, after = (
        means[(slice(None),) * axis + (slice(start, start + last, 2),)] for start in range(4)
    )
    near: NDArray[np.float32] = np.float32(0.5 * (1 - far_weight)) * (even + odd)
    return near + np.float32(0.5 * far_weight) * (before + after)


class CoverageTable:
    """Finds the nodes of footprints on one backend, and reads them.

    CPUs fetch what lies in a row together, and single words one by one: groups are read two words at a time,
    and holes, whose bytes lie apart from them, eight nodes at a time, of which one is wanted.

    Attributes:
        pairs: of words of four groups.
    """

    def __init__(
        self,
        size: float,
        levels: NDArray[np.int64],
        table: NDArray[np.uint8],
        repeat: tuple[float, float],
        types: ArrayTypes,
    ) -> None:
        """Uploads what `Coverage` calls size, levels and bytes, of a repeat of so many millimetres."""
        self._types = types
        self._inverse_size = dr.opaque(types.Float, 1 / size)
        self._inverse_repeat = [dr.opaque(types.Float, 1 / side) for side in repeat]
        self._top = dr.opaque(types.Float, len(levels) - 1)
        self._face = dr.opaque(types.UInt32, table.shape[1])
        padded = np.pad(levels, ((0, 0), (0, 1))).astype(np.float32)
        # Node numbers stay below 2^24, which float32 holds exactly.
        self._levels = upload(types.Float, padded)
        self.pairs = (table.shape[2] - 4) // 8
        self._row = dr.opaque(types.UInt32, self.pairs)
        # Machine code reads on to the end of a vector.
        groups = np.zeros(2 * table.shape[1] * (table.shape[2] - 4) + _BEHIND, np.uint8)
        groups[:-_BEHIND].reshape(*table.shape[:2], -1)[:] = table[..., :-4]
        self._groups = upload(types.UInt32, groups.view("<u4"))
        holes = table[..., -4].ravel()
        self._holes = upload(types.UInt32, np.pad(holes, (0, -holes.size % 8)).view("<u4"))

    def taps(self, footprint: Footprint, back: Any) -> CoverageTaps:
        """Nodes that stand for a footprint, millimetres, of the face that is seen."""
        types = self._types
        lower, coarser, apart = level_of(footprint, self._inverse_size, self._top, DRJIT)
        both = [
            dr.gather(types.Vector4, self._levels, types.UInt32(minimum(lower + more, self._top)))
            for more in (0, 1)
        ]
        start = dr.select(back, self._face, 0)
        return CoverageTaps(
            [
                start + types.UInt32(node)
                for node in nodes_of(
                    footprint, apart, coarser, [list(row)[:3] for row in both], self._inverse_repeat, DRJIT
                )
            ]
        )

    def memory(self) -> tuple[NDArray[np.uint32], NDArray[np.uint32]]:
        """See `Estimator.pyramid`."""
        dr.sync_thread()
        return self._groups.numpy(), self._holes.numpy()

    def groups(self, taps: CoverageTaps, pair: Any) -> list[list[Any]]:
        """The bytes of two words, 0 to 255, of all nodes together: twice four Floats."""
        words = [
            dr.gather(self._types.Index2, self._groups, dr.fma(node, self._row, pair)) for node in taps.nodes
        ]
        return [mean_bytes(self._types, [word[half] for word in words]) for half in range(2)]

    def holes(self, taps: CoverageTaps) -> Any:
        """The byte of holes, 0 to 255, of all nodes together: Float."""
        total = self._types.UInt32(0)
        for node in taps.nodes:
            words = dr.gather(self._types.Index2, self._holes, node >> 3)
            total += (dr.select((node & 4) == 4, words.y, words.x) >> ((node & 3) << 3)) & 255
        return self._types.Float(total) * (1 / len(taps.nodes))


# Formulas for Dr.Jit's arrays and for machine code: `arrays` is `backend.DRJIT`, or a `Code` being written.


def level_of(footprint: Any, inverse_size: Any, top: Any, arrays: Any) -> tuple[Any, Any, Any]:
    """The level whose squares a footprint is made of.

    Args:
        footprint: `Footprint`, or what has its numbers.
        inverse_size: 1/s_0.
        top: the last level.

    Returns:
        the level as a whole Float; how near its squares are to those of the next, 0 to 1; and how far from
        the middle they stand, of where thirds of the footprint are: closer where squares are nearly as large
        as it, so that together they are not too wide, but so far apart that their nodes differ, as those of
        one place alone would show as steps.
    """
    relative = footprint.spread_side * inverse_size
    level = arrays.minimum(arrays.log2(arrays.maximum(SQUARE_SHARE * relative, 1)), top)
    lower = arrays.floor(level)
    inverse = arrays.rcp(arrays.maximum(relative, _NEAREST))
    apart = arrays.sqrt(arrays.clip(TENT * (1 - arrays.square(inverse)), 0, 1))
    return lower, level - lower, arrays.minimum(arrays.maximum(apart, CLOSEST * inverse), 1)


def nodes_of(
    footprint: Any, apart: Any, coarser: Any, both: Any, inverse_repeat: Any, arrays: Any
) -> Iterator[Any]:
    """The nodes at `PLACES` of a footprint, whole Floats.

    Args:
        apart, coarser: see `level_of`.
        both: first node, columns and rows of its level and of the next.
        inverse_repeat: of the repeat's width and height.
    """
    across, along = inverse_repeat
    x, y = footprint.centre.x * across, footprint.centre.y * along
    first_x, second_x = (apart * edge.x * across for edge in (footprint.duv_dx, footprint.duv_dy))
    first_y, second_y = (apart * edge.y * along for edge in (footprint.duv_dx, footprint.duv_dy))
    for number, (s, t) in enumerate(PLACES):
        wide = coarser > 1 - (number + 0.5) / len(PLACES)
        first, columns, rows = (arrays.select(wide, b, a) for a, b in zip(both[0], both[1], strict=True))
        column = _node(arrays.fma(s, first_x, arrays.fma(t, second_x, x)), columns, arrays)
        row = _node(arrays.fma(s, first_y, arrays.fma(t, second_y, y)), rows, arrays)
        yield arrays.fma(row, columns, column) + first


def _node(turns: Any, count: Any, arrays: Any) -> Any:
    """The node, of so many along the repeat, nearest to a place in repeats: a whole Float."""
    return arrays.minimum(arrays.floor((turns - arrays.floor(turns)) * count), count - 1)
