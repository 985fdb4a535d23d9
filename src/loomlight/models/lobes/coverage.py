"""How much of each group a footprint holds: a pyramid of running means over the repeat, a byte a group.

Level m holds means over squares of side s_m = s_0·2^m around nodes s_m/3 apart, and footprints between nodes
and sizes are interpolated. Bilinear interpolation widens a footprint: squares are baked smaller, so that
variances come out right. Levels end where a square holds the whole repeat. Size is bounded: s_0 is one
thread, and more for drafts of hundreds of threads.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import ArrayTypes, array_types, uploaded
from loomlight.models.lobes.bytes import ByteWeights
from loomlight.models.lobes.groups import GroupFinder, Groups
from loomlight.yarn.geometry import YarnGeometry

NODES_PER_SIDE = 3
# Plan texels between two nodes; the number of rays that a mean is of follows from it.
_TEXELS_PER_NODE = 4
# Side of a baked square: with the variance of a bilinear tent of node spacing it makes up that of s_m.
_BAKED_SIDE = math.sqrt(1 - 2 / NODES_PER_SIDE**2)
# A level from the one below: means of nodes half a spacing and one and a half away. Their weights bring the
# variance of the baked squares to that of squares twice as wide.
_FAR_WEIGHT = 0.75
# Bytes of all levels of both faces; a third of it is levels beyond the first.
_MOST_BYTES = 56 << 20
_LARGEST = 255.0
# The golden ratio's fraction and one half, in units of 2⁻³²: products wrap around as fractions do.
_TURN, _START = 0x9E3779B9, 0x80000000


@dataclass(frozen=True, eq=False)
class Coverage:
    """The pyramid of both faces.

    Attributes:
        size: s_0, millimetres.
        levels: first node, columns and rows of each level [levels, 3].
        scale: share of the area that a byte of 255 stands for [2 faces, 4·words].
        bytes: [2 faces, nodes of all levels, 4·words]: groups, padded, and holes in the last word's first.
    """

    size: float
    levels: NDArray[np.int64]
    scale: NDArray[np.float64]
    bytes: NDArray[np.uint8]


@dataclass
class CoverageTaps:
    """Eight nodes around a footprint, two levels of four.

    Attributes:
        nodes: their rows in the table, UInt32 each.
        weights: their shares.
    """

    nodes: list[Any]
    weights: ByteWeights


def words_of(per_family: int) -> int:
    """Words of four bytes that the groups of both families take up, holes left out."""
    return 2 * -(-per_family // 4)


def padded_group(per_family: int) -> NDArray[np.intp]:
    """Place of each group among the bytes of a node [2 K]; families begin with a word of their own."""
    number = np.arange(2 * per_family)
    return number % per_family + number // per_family * 4 * (words_of(per_family) // 2)


def coverage_size(geometry: YarnGeometry, per_family: int) -> float:
    """s_0, millimetres: one thread, or more where the table would grow too large."""
    width, height = geometry.size
    picks, ends = geometry.layout.warp_on_top.shape
    thread = math.sqrt(width / ends * height / picks)
    row = 2 * 4 * (words_of(per_family) + 1)
    smallest = NODES_PER_SIDE * math.sqrt(width * height * row * 4 / 3 / _MOST_BYTES)
    return max(thread, smallest)


def measure_coverage(geometry: YarnGeometry, groups: Groups, float_type: type) -> Coverage:
    """Looks which group shows at every texel of the plan, and sums up."""
    types = array_types(float_type)
    size = coverage_size(geometry, groups.per_family)
    columns, rows = (max(1, math.ceil(NODES_PER_SIDE * side / size - 1e-6)) for side in geometry.size)
    spacings = geometry.size[0] / columns, geometry.size[1] / rows
    faces = [
        _first_level(types, geometry, groups, bool(face), (columns, rows), size, spacings)
        for face in range(2)
    ]
    means = np.stack(faces)
    levels, parts = [[0, columns, rows]], [means.reshape(2, -1, means.shape[-1])]
    while columns * rows > 1:
        levels.append([levels[-1][0] + columns * rows, *(max(1, -(-side // 2)) for side in (columns, rows))])
        means = _next_level(means, levels[-1][2], levels[-1][1])
        columns, rows = levels[-1][1:]
        parts.append(means.reshape(2, -1, means.shape[-1]))
    everything = np.concatenate(parts, axis=1)
    scale = np.maximum(everything.max(axis=1), 1e-9).astype(np.float64)
    packed = np.rint(everything * (_LARGEST / scale[:, None])).astype(np.uint8)
    return Coverage(size, np.array(levels, np.int64), scale, packed)


def _first_level(
    types: ArrayTypes,
    geometry: YarnGeometry,
    groups: Groups,
    back: bool,
    nodes: tuple[int, int],
    size: float,
    spacings: tuple[float, float],
) -> NDArray[np.float32]:
    """Means of one face around the nodes of the first level [rows, columns, 4·words]."""
    columns, rows = (_TEXELS_PER_NODE * count for count in nodes)
    seen = _plan(types, geometry, groups, back, columns, rows)
    words = words_of(groups.per_family) + 1
    lane = dr.arange(types.UInt32, nodes[0] * nodes[1] * words)
    node, word = lane // words, lane % words
    row = node // nodes[0]
    column = node - row * nodes[0]
    half = [0.5 * _BAKED_SIDE * size / spacing * _TEXELS_PER_NODE for spacing in spacings]
    # A square wider than the repeat holds all of it, and that once.
    half = [min(reach, 0.5 * count) for reach, count in zip(half, (columns, rows), strict=True)]
    reach_x, reach_y = (dr.opaque(types.UInt32, math.ceil(reach)) for reach in half)
    half_x, half_y = (dr.opaque(types.Float, reach) for reach in half)
    wide, high = dr.opaque(types.UInt32, columns), dr.opaque(types.UInt32, rows)
    middle_x = column * _TEXELS_PER_NODE + _TEXELS_PER_NODE // 2 + wide - reach_x
    middle_y = row * _TEXELS_PER_NODE + _TEXELS_PER_NODE // 2 + high - reach_y
    holes, per_family = dr.opaque(types.UInt32, groups.count), dr.opaque(types.UInt32, groups.per_family)
    family_bytes = dr.opaque(types.UInt32, 2 * words_of(groups.per_family))

    def share(step: Any, reach: Any, half_side: Any) -> Any:
        """Of a texel's width that lies within the square."""
        from_middle = dr.abs(types.Float(step) - types.Float(reach) + 0.5)
        return dr.clip(half_side - from_middle + 0.5, 0, 1)

    def add(step: Any, *sums: Any) -> tuple[Any, ...]:
        down = step // (2 * reach_x)
        across = step - down * (2 * reach_x)
        weight = share(across, reach_x, half_x) * share(down, reach_y, half_y)
        x, y = middle_x + across, middle_y + down
        x, y = x - wide * (x // wide), y - high * (y // high)
        group = dr.gather(types.UInt32, seen, y * wide + x)
        place = dr.select(group < per_family, group, group - per_family + family_bytes)
        place = dr.select(group == holes, 2 * family_bytes, place)
        own = (place >> 2) == word
        return step + 1, *(
            total + dr.select(own & ((place & 3) == byte), weight, 0) for byte, total in enumerate(sums)
        )

    zero = dr.zeros(types.Float, dr.width(lane))
    state = (dr.zeros(types.UInt32, dr.width(lane)), *(types.Float(zero) for _ in range(4)))
    total = dr.while_loop(state, lambda step, *sums: step < 4 * reach_x * reach_y, add)[1:]
    area = 4 * half[0] * half[1]
    table = np.stack([part.numpy() / area for part in total], axis=-1)
    return table.reshape(nodes[1], nodes[0], 4 * words).astype(np.float32)


def _plan(
    types: ArrayTypes, geometry: YarnGeometry, groups: Groups, back: bool, columns: int, rows: int
) -> Any:
    """The group that shows at one place of each texel of the plan, row by row: UInt32."""
    texel = dr.arange(types.UInt32, columns * rows)
    row = texel // dr.opaque(types.UInt32, columns)
    column = texel - row * dr.opaque(types.UInt32, columns)
    share_x = types.Float((row * _TURN + _START) >> 8) * 2**-24
    share_y = types.Float((column * _TURN + _START) >> 8) * 2**-24
    x = (types.Float(column) + share_x) * dr.opaque(types.Float, geometry.size[0] / columns)
    y = (types.Float(row) + share_y) * dr.opaque(types.Float, geometry.size[1] / rows)
    face = dr.full(types.Bool, back, columns * rows)
    point = geometry.surface(x, y, face)
    group = GroupFinder(groups, types).group(face, point.is_warp, point.hole, point.normal, point.tangent)
    dr.eval(group)
    return group


def _next_level(means: NDArray[np.float32], rows: int, columns: int) -> NDArray[np.float32]:
    """Means over squares twice as wide [faces, rows, columns, bytes]."""
    return _halved(_halved(means, rows, 1), columns, 2)


def _halved(means: NDArray[np.float32], count: int, axis: int) -> NDArray[np.float32]:
    before = means.shape[axis]
    middle = (np.arange(count) + 0.5) * (before / count) - 0.5
    total = np.zeros((*means.shape[:axis], count, *means.shape[axis + 1 :]), np.float32)
    for offset, weight in ((0.5, 0.5 * (1 - _FAR_WEIGHT)), (1.5, 0.5 * _FAR_WEIGHT)):
        for place in (middle - offset, middle + offset):
            lower = np.floor(place + 1e-9).astype(np.intp)
            share = np.maximum(place - lower, 0)
            for node, part in ((lower, 1 - share), (lower + 1, share)):
                if not (part > 1e-9).any():
                    continue
                shape = [1] * means.ndim
                shape[axis] = count
                factor = (weight * part).astype(np.float32).reshape(shape)
                total += factor * np.take(means, node % before, axis=axis)
    return total


class CoverageTable:
    """Finds the nodes of footprints on one backend."""

    def __init__(self, coverage: Coverage, repeat: tuple[float, float], types: ArrayTypes) -> None:
        self._types = types
        self._inverse_size = dr.opaque(types.Float, 1 / coverage.size)
        self._inverse_repeat = [dr.opaque(types.Float, 1 / side) for side in repeat]
        self._top = dr.opaque(types.UInt32, len(coverage.levels) - 1)
        self._face = dr.opaque(types.UInt32, coverage.bytes.shape[1])
        padded = np.pad(coverage.levels, ((0, 0), (0, 1))).astype(np.float32)
        # Node numbers stay below 2^24, which float32 holds exactly.
        self._levels = uploaded(types.Float, padded)
        self.words = coverage.bytes.shape[2] // 4
        self._rows = dr.opaque(types.UInt32, self.words)
        self._table = uploaded(types.UInt32, np.ascontiguousarray(coverage.bytes).view("<u4"))

    def taps(self, centre: Any, size: Any, back: Any) -> CoverageTaps:
        """Nodes around a footprint of a centre [2] and a side, millimetres."""
        types = self._types
        relative = dr.maximum(size * self._inverse_size, 1)
        lower = dr.minimum(types.UInt32(dr.log2(relative)), self._top)
        upper = dr.minimum(lower + 1, self._top)
        # Variances add up: s² of a mixture of two squares is the mixture of theirs.
        of_lower = types.Float(types.UInt32(1) << lower)
        blend = dr.clip((dr.square(relative / of_lower) - 1) * (1 / 3), 0, 1)
        x, y = (part * inverse for part, inverse in zip(centre, self._inverse_repeat, strict=True))
        x, y = x - dr.floor(x), y - dr.floor(y)
        start = dr.select(back, self._face, 0)
        nodes, weights = [], []
        for level, share in ((lower, 1 - blend), (upper, blend)):
            first, columns, rows, _ = dr.gather(types.Vector4, self._levels, level)
            left, right, across = _neighbours(types, x, columns)
            down, up, along = _neighbours(types, y, rows)
            wide = types.UInt32(columns)
            for row, row_share in ((down, 1 - along), (up, along)):
                for column, column_share in ((left, 1 - across), (right, across)):
                    nodes.append((start + types.UInt32(first) + row * wide + column) * self._rows)
                    weights.append(share * row_share * column_share)
        return CoverageTaps(nodes, ByteWeights(types, weights))

    def bytes(self, taps: CoverageTaps, word: Any) -> list[Any]:
        """The four bytes of a word, 0 to 255, interpolated: Float each."""
        words = [dr.gather(self._types.UInt32, self._table, node + word) for node in taps.nodes]
        return taps.weights.interpolated(words)


def _neighbours(types: ArrayTypes, turns: Any, count: Any) -> tuple[Any, Any, Any]:
    """The two nodes around a place in the repeat (0 to 1) and the share of the second."""
    place = turns * count - 0.5
    whole = dr.floor(place)
    lower = dr.select(whole < 0, whole + count, whole)
    lower = dr.minimum(lower, count - 1)
    upper = dr.select(lower + 1 < count, lower + 1, 0)
    return types.UInt32(lower), types.UInt32(upper), place - whole
