"""The estimate as code of `lane_code`: footprints, views and lights in, components and holes out.

Where a query lies in the tables is worked out for as many queries at once as there are lanes. Then one query
after another takes a lane for each group: what is fetched of a node lies in a row, so nothing is gathered,
and the groups' numbers are the same vectors for all queries. That is half the instructions of a lane for
each query, which `estimate.py` takes in Dr.Jit, from the same formulas.

Queries and answers are arrays [n]. A query is: centre x and y of the footprint, x and y of both its edges,
millimetres; x, y, z of the view in the frame of the face seen, z > 0; 1 where that is the back, else 0; x, y,
z of the light in that frame; 1 where an answer is wanted, else 0. Answers are: diffuse of warp and of weft,
specular of warp and of weft, 1/sr, and the hole; all 0 where none was wanted.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from llvmlite import ir
from numpy.typing import NDArray

from loomlight.core.lane_code import Code, Rows, Vectors
from loomlight.core.lane_values import INDEX, Lanes, Vector
from loomlight.core.machine_code import aligned
from loomlight.models.lobes.bytes import UNITS
from loomlight.models.lobes.coverage import PLACES, level_of, nodes_of
from loomlight.models.lobes.density import GroupLobe, layer_value
from loomlight.models.lobes.estimate import PER_BYTE, half_vector, raised_by, shadow_correlation
from loomlight.models.lobes.hemisphere import AZIMUTHS, NODES, RINGS, around
from loomlight.models.lobes.tables import MOMENTS, LobeTables

QUERY, ANSWERS = 14, 5
_TAPS = 4
# What all queries share: bytes of groups and of holes by node of the pyramid, the same by node of the
# hemisphere, what light does by node, and numbers.
_COVERAGE, _HOLES, _SEEN, _SEEN_HOLES, _LIT, _NUMBERS = range(QUERY + ANSWERS, QUERY + ANSWERS + 6)
# Where numbers begin: of the fabric, of both faces' groups (rows of moments, roughness, 1 where a group is of
# the warp), of levels.
_DEPTH, _INVERSE_SIZE, _TOP, _INVERSE_REPEAT, _FACE_NODES, _HOLE_WEIGHT, _GROUPS = 0, 1, 2, 3, 5, 6, 16
_ROUGHNESS, _IS_WARP, _ROWS = MOMENTS, MOMENTS + 1, MOMENTS + 2
# What is put down of a query beside places and directions: κ of diffuse and specular terms, where numbers of
# its face's groups begin, and the weight of holes.
_DIFFUSE, _SPECULAR, _FIRST_GROUP, _OF_HOLE = range(4)
# Of all groups together, so that nothing is divided by 0; see `proposal`.
_SMALLEST_WEIGHT = 1e-12


@dataclass
class _Footprint:
    """The numbers of `Footprint`."""

    centre: Vector
    duv_dx: Vector
    duv_dy: Vector
    spread_side: Lanes


def _padded_groups(words: int, wide: Vectors) -> int:
    """Lanes of whole vectors that hold the groups of so many words."""
    return -(-4 * words // wide.lanes) * wide.lanes


def shared_numbers(
    tables: LobeTables,
    repeat: tuple[float, float],
    roughness: tuple[float, float],
    optical_depth: float,
    wide: Vectors,
) -> list[NDArray[np.float32]]:
    """What code for such vectors reads of a fabric: all but the pyramid's bytes, in their order."""
    words, padded = tables.words, _padded_groups(tables.words, wide)
    beside = [(0, 0)] * 2 + [(0, padded - 4 * words)]

    def rows(first: NDArray[np.uint8], second: NDArray[np.uint8]) -> NDArray[np.float32]:
        parts = [np.pad(part.reshape(1, -1, 4 * words), beside) for part in (first, second)]
        return aligned(np.concatenate(parts, axis=2).astype(np.float32).ravel())

    seen, lit = tables.seen, tables.lit
    groups = np.zeros((2, _ROWS, padded), np.float32)
    # Groups that there are not weigh nothing, and have directions all the same.
    groups[:, (2, 5)] = 1
    groups[:, :MOMENTS, : 4 * words] = tables.moments.swapaxes(1, 2)
    groups[:, _IS_WARP] = np.arange(padded) < 4 * tables.warp_words[:, None]
    groups[:, _ROUGHNESS] = np.where(groups[:, _IS_WARP] > 0, *roughness)
    of_fabric = [optical_depth, 1 / tables.size, len(tables.levels) - 1, 1 / repeat[0], 1 / repeat[1]]
    numbers = np.zeros(_GROUPS)
    numbers[: _HOLE_WEIGHT + 2] = [*of_fabric, tables.coverage.shape[1], *tables.hole_weight]
    return [
        rows(seen[..., : 4 * words], seen[..., 4 * (words + 1) :]),
        np.ascontiguousarray(seen[..., 4 * words]).view(np.float32).ravel(),
        rows(lit[..., : 4 * words], lit[..., 4 * words :]),
        # Vectors of groups straddle no lines of the cache then.
        aligned(np.concatenate([numbers, groups.ravel(), tables.levels.ravel()]).astype(np.float32)),
    ]


def estimate_code(words: int, wide: Vectors) -> Code:
    """Code for tables of so many words of four groups."""
    code = Code(f"lobes_{words}", replace(wide, of_block=1))
    with code.blocks():
        _Writer(code, words).write()
    return code


class _Writer:
    """Writes the code of a block, whose queries are as many as there are lanes."""

    def __init__(self, code: Code, words: int) -> None:
        self._code, self._twice, self._words = code, code.doubled(), words
        self._padded = _padded_groups(words, code.vectors)
        self._parts = self._padded // code.vectors.lanes
        # Of each query: what `_find` puts down. Numbers of bytes, weights, directions.
        self._places, self._seen, self._lit = (code.rows(count) for count in (2 * len(PLACES), _TAPS, _TAPS))
        self._seen_weights, self._lit_weights = code.rows(_TAPS), code.rows(_TAPS)
        self._seen_holes = code.rows(_TAPS)
        self._directions, self._facts = code.rows(9), code.rows(4)
        # Of each query a lane for each group: sums over groups are taken in the end.
        self._sums = [code.stack(code.vectors.lanes**2) for _ in range(ANSWERS)]

    def write(self) -> None:
        """Answers a block."""
        code = self._code
        wanted = code.rows(1)
        wanted[0] = code.given(QUERY - 1)
        for answer in range(ANSWERS):
            code.answer(QUERY + answer, 0)
        with code.builder.if_then(code.anywhere(wanted)):
            self._find()
            # One waits for what it has fetched or divided, the other goes on.
            with code.loop(code.vectors.lanes // 2) as pair:
                first = code.times(pair, 2)
                self._add_groups([first, code.builder.add(first, INDEX(1))])
            self._answer(wanted[0] > 0)

    # Where queries lie in the tables.

    def _number(self, number: int) -> Lanes:
        return self._code.shared(self._code.array(_NUMBERS), number)

    def _find(self) -> None:
        """Puts down where every query's numbers lie, and what its groups have in common."""
        code = self._code
        x, y, ax, ay, bx, by, *directions, back = (code.given(number) for number in range(10))
        view, light = Vector(*directions), Vector(*(code.given(number) for number in (10, 11, 12)))
        half = half_vector(light, view, code)
        for number, value in enumerate(
            (light.x, light.y, light.z, view.x, view.y, view.z, half.x, half.y, half.z)
        ):
            self._directions[number] = value
        face = code.select(back > 0.5, 1.0, 0.0)
        beyond = light.z < 0
        self._facts[_DIFFUSE], self._facts[_SPECULAR] = shadow_correlation(light, view, beyond, code)
        code.store_whole(face, _ROWS * self._padded, self._facts.place(_FIRST_GROUP))
        self._facts[_OF_HOLE] = code.select(
            face > 0, self._number(_HOLE_WEIGHT + 1), self._number(_HOLE_WEIGHT)
        )
        self._find_places(Vector(x, y), Vector(ax, ay), Vector(bx, by), face)
        side = 2 * face + code.select(beyond, 1.0, 0.0)
        row = 2 * self._padded
        for number, node in enumerate(self._around(view, face, self._seen_weights)):
            code.store_whole(node, row, self._seen.place(number))
            code.store_whole(node, 1, self._seen_holes.place(number))
        for number, node in enumerate(self._around(light, side, self._lit_weights)):
            code.store_whole(node, row, self._lit.place(number))

    def _find_places(self, centre: Vector, across: Vector, along: Vector, face: Lanes) -> None:
        code = self._code
        squares = sum(edge.x * edge.x + edge.y * edge.y for edge in (across, along))
        footprint = _Footprint(centre, across, along, code.sqrt(0.5 * squares))
        top = self._number(_TOP)
        lower, coarser, apart = level_of(footprint, self._number(_INVERSE_SIZE), top, code)
        levels = code.element(code.array(_NUMBERS), _GROUPS + 2 * _ROWS * self._padded)
        count = code.builder.add(
            code.whole(code.builder.load(code.element(code.array(_NUMBERS), _TOP))), INDEX(1)
        )
        both = [code.looked_up(levels, 3, count, code.minimum(lower + float(more), top)) for more in range(2)]
        repeat = [self._number(_INVERSE_REPEAT + axis) for axis in range(2)]
        start = face * self._number(_FACE_NODES)
        for number, node in enumerate(nodes_of(footprint, apart, coarser, both, repeat, code)):
            code.store_whole(start + node, 4 * self._words, self._places.place(number))
            code.store_whole(start + node, 1, self._places.place(len(PLACES) + number))

    def _around(self, direction: Vector, table: Lanes, weights: Rows) -> list[Lanes]:
        """Nodes around a direction in one of several tables of the hemisphere; puts their weights down."""
        code = self._code
        whole, ring, shares = around(direction, code)
        # Whatever comes in, rows must exist.
        whole = code.clip(whole, -0.5 * AZIMUTHS, 0.5 * AZIMUTHS)
        units = [code.floor(code.fma(share, UNITS, 0.5)) for share in shares]
        inverse = 1 / (units[0] + units[1] + units[2] + units[3])
        for number, unit in enumerate(units):
            weights[number] = unit * inverse
        column = code.select(whole < 0, whole + float(AZIMUTHS), whole)
        following = column + 1
        following = code.select(following >= float(AZIMUTHS), following - float(AZIMUTHS), following)
        first, second = (code.fma(turn, RINGS, table * float(NODES) + ring) for turn in (column, following))
        return [first, first + 1, second, second + 1]

    # What groups do.

    def _add_groups(self, queries: Sequence[ir.Value]) -> None:
        """Puts down the sums of two queries, a lane for each group."""
        if self._parts == 1:
            self._keep(queries, self._of_groups(queries, INDEX(0)))
            return
        nothing = [self._twice.number(0)] * ANSWERS
        self._keep(queries, nothing)
        with self._code.loop(self._parts) as part:
            found = self._of_groups(queries, self._code.times(part, self._code.vectors.lanes))
            before = [self._before(sums, queries) for sums in self._sums]
            self._keep(queries, [a + b for a, b in zip(before, found, strict=True)])

    def _line(self, sums: ir.Value, query: ir.Value) -> ir.Value:
        return self._code.element(sums, self._code.times(query, self._code.vectors.lanes))

    def _before(self, sums: ir.Value, queries: Sequence[ir.Value]) -> Lanes:
        return self._both(queries, lambda query: self._code.load(self._line(sums, query)))

    def _keep(self, queries: Sequence[ir.Value], found: list[Lanes]) -> None:
        for sums, values in zip(self._sums, found, strict=True):
            for query, value in zip(queries, self._code.halves(values), strict=True):
                self._code.store(value, self._line(sums, query))

    def _both(self, queries: Sequence[ir.Value], of_query: Callable[[ir.Value], Lanes]) -> Lanes:
        """Vectors of two queries side by side."""
        return self._twice.joined(*(of_query(query) for query in queries))

    def _of_groups(self, queries: Sequence[ir.Value], first: ir.Value) -> list[Lanes]:
        """Of as many groups as there are lanes, from one on: diffuse and specular by family, and weights."""
        code = self._twice
        light, view, half = (
            Vector(*(self._of_queries(self._directions, 3 * vector + axis, queries) for axis in range(3)))
            for vector in range(3)
        )
        correlations = (
            self._of_queries(self._facts, _DIFFUSE, queries),
            self._of_queries(self._facts, _SPECULAR, queries),
        )
        groups = [self._of_group(row, queries, first) for row in range(_ROWS)]
        coverage = self._both(queries, lambda query: self._coverage(query, first)) * (1 / len(PLACES))
        visible, from_view = self._interpolated(_SEEN, self._seen, self._seen_weights, queries, first)
        irradiance, reached = self._interpolated(_LIT, self._lit, self._lit_weights, queries, first)
        x, y, z, unit, tx, ty, tz, xx, yy, xy, xz, yz, roughness, is_warp = groups
        tangent = Vector(tx, ty, tz)
        zz = 1 - (tx * tx + ty * ty + tz * tz) - xx - yy
        lobe = GroupLobe(Vector(x, y, z), tangent, xx, yy, zz, xy, xz, yz, roughness)
        weight = coverage * (visible * visible) * unit
        reached = reached * PER_BYTE
        more_diffuse, more = raised_by(correlations, reached, from_view * PER_BYTE, code)
        depth = code.shared(code.array(_NUMBERS), _DEPTH)
        value = layer_value(half, light, view, light.z < 0, lobe, depth, code)
        diffuse = weight * irradiance * more_diffuse
        specular = weight * value * (reached * more)
        is_weft = 1 - is_warp
        return [diffuse * is_warp, diffuse * is_weft, specular * is_warp, specular * is_weft, weight]

    def _of_queries(self, rows: Rows, channel: int, queries: Sequence[ir.Value]) -> Lanes:
        """A number of each query, in all its lanes."""
        place = rows.place(channel)
        return self._both(queries, lambda query: self._code.shared(place, query))

    def _of_group(self, row: int, queries: Sequence[ir.Value], first: ir.Value) -> Lanes:
        """One of the numbers of groups."""
        code = self._code

        def load(query: ir.Value) -> Lanes:
            start = code.builder.add(code.whole_at(self._facts.place(_FIRST_GROUP), query), first)
            place = code.builder.add(start, INDEX(_GROUPS + row * self._padded))
            return code.load(code.element(code.array(_NUMBERS), place), align=4)

        return self._both(queries, load)

    def _coverage(self, query: ir.Value, first: ir.Value) -> Lanes:
        """Sums over the nodes of the footprint."""
        code = self._code
        places = [
            code.builder.add(code.whole_at(self._places.place(number), query), first)
            for number in range(len(PLACES))
        ]
        return code.sum_of_bytes(code.array(_COVERAGE), places)

    def _interpolated(
        self, table: int, nodes: Rows, weights: Rows, queries: Sequence[ir.Value], first: ir.Value
    ) -> tuple[Lanes, Lanes]:
        """Both halves of a table's rows."""
        found = [self._twice.number(0), self._twice.number(0)]
        for tap in range(_TAPS):
            weight = self._of_queries(weights, tap, queries)
            for half in range(2):
                value = self._of_node(table, nodes.place(tap), half, queries, first)
                found[half] = self._twice.fma(weight, value, found[half])
        return found[0], found[1]

    def _of_node(
        self, table: int, node: ir.Value, half: int, queries: Sequence[ir.Value], first: ir.Value
    ) -> Lanes:
        """Half of a row of a table."""
        code = self._code

        def load(query: ir.Value) -> Lanes:
            place = code.builder.add(code.whole_at(node, query), first)
            place = code.builder.add(place, INDEX(half * self._padded))
            return code.load(code.element(code.array(table), place))

        return self._both(queries, load)

    # Answers.

    def _answer(self, wanted: Lanes) -> None:
        """Sums over groups, and the hole."""
        code = self._code
        hole = self._hole()
        *components, total = (self._summed(sums) for sums in self._sums)
        share = (1 - hole) / code.maximum(total, _SMALLEST_WEIGHT)
        scales = [PER_BYTE / math.pi] * 2 + [1.0] * 2
        for number, (value, scale) in enumerate(zip(components, scales, strict=True)):
            code.answer(QUERY + number, code.select(wanted, value * share * scale, 0))
        code.answer(QUERY + ANSWERS - 1, code.select(wanted, hole, 0))

    def _summed(self, sums: ir.Value) -> Lanes:
        """Of lines of groups, one a query, the sums: one a lane."""
        code, lanes = self._code, self._code.vectors.lanes
        lines = [code.load(code.element(sums, number * lanes)) for number in range(lanes)]
        columns = code.transposed(lines)
        while len(columns) > 1:
            columns = [a + b for a, b in zip(columns[::2], columns[1::2], strict=True)]
        return columns[0]

    def _hole(self) -> Lanes:
        """Share of the view rays that pass through holes, of all queries; see `Estimator.hole`."""
        code = self._code
        covered, seen = code.rows(1), code.rows(1)
        with code.loop(code.vectors.lanes) as query:
            total = self._hole_bytes(_HOLES, self._places, len(PLACES), query)
            count = code.builder.uitofp(_sum(code, total), covered.pointer.type.pointee)
            code.builder.store(count, code.element(covered.pointer, query))
            mean: ir.Value = ir.Constant(count.type, 0.0)
            for tap, byte in enumerate(self._hole_bytes(_SEEN_HOLES, self._seen_holes, 0, query)):
                weight = code.builder.load(code.element(self._seen_weights.place(tap), query))
                number = code.builder.uitofp(byte, count.type)
                mean = code.builder.fadd(mean, code.builder.fmul(weight, number))
            code.builder.store(mean, code.element(seen.pointer, query))
        weight = covered[0] * (1 / len(PLACES)) * (seen[0] * seen[0]) * self._facts[_OF_HOLE]
        return code.minimum(weight, 1)

    def _hole_bytes(self, table: int, nodes: Rows, first: int, query: ir.Value) -> list[ir.Value]:
        code = self._code
        count = len(PLACES) if table == _HOLES else _TAPS
        return [
            code.byte(code.array(table), code.whole_at(nodes.place(first + tap), query))
            for tap in range(count)
        ]


def _sum(code: Code, numbers: list[ir.Value]) -> ir.Value:
    total = numbers[0]
    for number in numbers[1:]:
        total = code.builder.add(total, number)
    return total
