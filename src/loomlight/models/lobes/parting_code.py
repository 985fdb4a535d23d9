"""Points parted into groups, as code of `lane_code`: a block is a family, a lane is a point.

`halving_code` halves the widest part again and again, where its points' squared distances from their mean
add up to most: across its longest axis, between the means of both halves. `means_code` takes steps of k-means
from centres on. Both read six coordinates of every point, about the family's mean, and 1 where there is one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from llvmlite import ir

from loomlight.core.lane_code import Code, Vectors
from loomlight.core.lane_values import FLOAT, INDEX, Lanes
from loomlight.models.lobes.lane_sums import LaneSums

FEATURES = 6
# Points of a family, at the most, and numbers of a row about each group: a block has room for so many rows.
POINTS = 1 << 11
ROW = 16
MOST_GROUPS = POINTS // ROW
# What blocks are given: coordinates, where there are points, and how many groups are wanted in the first of
# its lanes. What they answer: rows of groups.
_IS_POINT, _WANTED, _ROWS = range(FEATURES, FEATURES + 3)
# Of a row of halving: which part was halved; of what is near and of what is far along its axis, how many
# points there are, and the sum of their squared distances from their mean; both means. The first row holds
# all points, as what is near.
PARENT, NEAR_ERROR, FAR_POINTS, FAR_ERROR, NEAR_MEAN, FAR_MEAN = 0, 1, 2, 3, 4, 4 + FEATURES
# Steps towards where a part is halved, and of k-means; after so many squarings of a matrix an axis is left
# whose share is 1.02 times that of others.
_HALVINGS, _ITERATIONS, _SQUARINGS = 4, 2, 8
# Sums over a part's points: ones, coordinates, products of two; and their squared distance from their mean.
_PRODUCTS = [(i, j) for i in range(FEATURES) for j in range(i, FEATURES)]
_FIRST_PRODUCT = 1 + FEATURES
_ERROR = _FIRST_PRODUCT + len(_PRODUCTS)
_SUMS = 32
_TINY, _FAR = 1e-30, 1e30


def halving_code(wide: Vectors) -> Code:
    """Code that halves parts."""
    return _of_families("halving", _Halving, wide)


def means_code(wide: Vectors) -> Code:
    """Code for steps of k-means: a point between two groups counts for both; what has none stays."""
    return _of_families("means", _Means, wide)


def _of_families(name: str, writer: type[_Halving | _Means], wide: Vectors) -> Code:
    """Code whose blocks are families."""
    code = Code(name, replace(wide, of_block=POINTS // wide.lanes))
    writing = writer(code)
    with code.blocks():
        writing.write()
    return code


def _wanted(code: Code) -> ir.Value:
    """Groups that are wanted of the family."""
    return code.whole(code.builder.load(code.queries(_WANTED)))


class _Halving:
    """Writes what halves one family."""

    def __init__(self, code: Code) -> None:
        self._code = code
        self._part, self._along = code.rows(1), code.rows(1)
        self._parts = code.stack(_SUMS * (MOST_GROUPS + 1))
        self._sums, self._beyond = LaneSums(code, 1, _ERROR), LaneSums(code, 1, 2)
        self._matrix = code.stack(len(_PRODUCTS) * code.vectors.lanes)
        self._at = code.stack(code.vectors.lanes)
        self._widest, self._most = code.variable(INDEX), code.variable(FLOAT)

    def write(self) -> None:
        code = self._code
        with code.each_vector():
            self._part[0] = code.given(_IS_POINT) - 1.0
        self._measure(INDEX(0))
        self._tell(INDEX(0), INDEX(0), INDEX(0))
        with code.loop(code.builder.sub(_wanted(code), INDEX(1))) as number:
            new = code.builder.add(number, INDEX(1))
            self._find_widest(new)
            widest = code.builder.load(self._widest)
            self._halve(widest, new)
            self._measure(widest)
            self._measure(new)
            self._tell(new, widest, new)

    def _sums_of(self, part: ir.Value) -> ir.Value:
        return self._code.element(self._parts, self._code.times(part, _SUMS))

    def _measure(self, part: ir.Value) -> None:
        """Adds up a part's points."""
        code, sums = self._code, self._sums
        sums.clear(1)
        with code.each_vector():
            own = code.select(self._part[0] == code.counted(part), code.number(1), 0)
            point = [code.given(k) for k in range(FEATURES)]
            sums.add(0, own, [1.0, *point, *(point[i] * point[j] for i, j in _PRODUCTS)])
        place = self._sums_of(part)
        for number, total in enumerate(sums.totals(0)):
            code.builder.store(total, code.element(place, number))
        squares = [products[0] for products in self._about_mean(part).values()]
        code.builder.store(code.first(sum(squares, code.number(0))), code.element(place, _ERROR))

    def _mean(self, part: ir.Value) -> list[Lanes]:
        place, code = self._sums_of(part), self._code
        inverse = 1.0 / code.maximum(code.shared(place, 0), 1)
        return [code.shared(place, k) * inverse for k in range(1, _FIRST_PRODUCT)]

    def _about_mean(self, part: ir.Value) -> dict[int, list[Lanes]]:
        """Of each coordinate sums of products of offsets from the mean, with its own and those after it."""
        place, code, mean = self._sums_of(part), self._code, self._mean(part)
        found: dict[int, list[Lanes]] = {}
        for number, (i, j) in enumerate(_PRODUCTS, _FIRST_PRODUCT):
            product = code.fma(-mean[i], code.shared(place, 1 + j), code.shared(place, number))
            found.setdefault(i, []).append(product)
        return found

    def _find_widest(self, count: ir.Value) -> None:
        """Which of so many parts has the largest error: the first of them."""
        code, builder = self._code, self._code.builder
        builder.store(INDEX(0), self._widest)
        builder.store(FLOAT(-1.0), self._most)
        with code.loop(count) as part:
            error, most = builder.load(code.element(self._sums_of(part), _ERROR)), builder.load(self._most)
            wider = builder.fcmp_ordered(">", error, most)
            builder.store(builder.select(wider, part, builder.load(self._widest)), self._widest)
            builder.store(builder.select(wider, error, most), self._most)

    def _halve(self, part: ir.Value, new: ir.Value) -> None:
        """Gives half of a part's points to a new one."""
        code = self._code
        axis, mean = self._longest_axis(part), self._mean(part)
        with code.each_vector():
            offsets = [code.given(k) - mean[k] for k in range(FEATURES)]
            self._along[0] = _dot(code, axis, offsets)
        code.store(code.number(0), self._at)
        count = code.shared(self._sums_of(part), 0)
        with code.loop(_HALVINGS):
            self._beyond.clear(1)
            with code.each_vector():
                beyond = code.select(self._is_beyond(part), code.number(1), 0)
                self._beyond.add(0, beyond, [1.0, self._along[0]])
            there, along = (code.spread(total) for total in self._beyond.totals(0))
            here = count - there
            # Halfway between both means; both sums cancel.
            halfway = 0.5 * along * (1.0 / code.maximum(there, 1) - 1.0 / code.maximum(here, 1))
            code.store(code.select((there > 0) & (here > 0), halfway, code.load(self._at)), self._at)
        with code.each_vector():
            self._part[0] = code.select(self._is_beyond(part), code.counted(new), self._part[0])

    def _is_beyond(self, part: ir.Value) -> Lanes:
        code = self._code
        return (self._along[0] > code.load(self._at)) & (self._part[0] == code.counted(part))

    def _longest_axis(self, part: ir.Value) -> list[Lanes]:
        """The direction in which a part is longest: what squaring a matrix again and again leaves of it."""
        code, lanes = self._code, self._code.vectors.lanes
        places = [code.element(self._matrix, number * lanes) for number in range(len(_PRODUCTS))]

        def put(products: Sequence[Lanes]) -> None:
            trace = sum(product for product, (i, j) in zip(products, _PRODUCTS, strict=True) if i == j)
            inverse = 1.0 / code.maximum(trace, _TINY)
            for product, place in zip(products, places, strict=True):
                code.store(product * inverse, place)

        def held() -> list[list[Lanes]]:
            found = {pair: code.load(place) for pair, place in zip(_PRODUCTS, places, strict=True)}
            return [[found[min(i, j), max(i, j)] for j in range(FEATURES)] for i in range(FEATURES)]

        put([product for products in self._about_mean(part).values() for product in products])
        with code.loop(_SQUARINGS):
            rows = held()
            put([_dot(code, rows[i], rows[j]) for i, j in _PRODUCTS])
        rows = held()
        axis, most = rows[0], rows[0][0]
        for number, row in enumerate(rows[1:], 1):
            longer = row[number] > most
            axis = [code.select(longer, new, old) for new, old in zip(row, axis, strict=True)]
            most = code.select(longer, row[number], most)
        return axis

    def _tell(self, row: ir.Value, near: ir.Value, far: ir.Value) -> None:
        """Answers a row."""
        code, builder = self._code, self._code.builder
        place = code.element(code.queries(_ROWS), code.times(row, ROW))
        near_sums, far_sums = self._sums_of(near), self._sums_of(far)
        numbers = {
            PARENT: builder.uitofp(near, FLOAT),
            NEAR_ERROR: builder.load(code.element(near_sums, _ERROR)),
            FAR_POINTS: builder.load(far_sums),
            FAR_ERROR: builder.load(code.element(far_sums, _ERROR)),
        }
        for first, part in ((NEAR_MEAN, near), (FAR_MEAN, far)):
            numbers |= {first + k: code.first(value) for k, value in enumerate(self._mean(part))}
        for number, value in numbers.items():
            builder.store(value, code.element(place, number))


class _Means:
    """Writes what takes steps of k-means with one family, from the centres in its rows."""

    def __init__(self, code: Code) -> None:
        self._code = code
        self._sums = LaneSums(code, MOST_GROUPS, 1 + FEATURES)
        self._least = code.stack(code.vectors.lanes)

    def write(self) -> None:
        code = self._code
        count = _wanted(code)
        with code.loop(_ITERATIONS):
            self._sums.clear(count)
            with code.each_vector():
                self._add(count)
            with code.loop(count) as group:
                self._move(group)

    def _row(self, group: ir.Value) -> ir.Value:
        code = self._code
        # Rows begin where the block does, whatever vector is at hand.
        lane, code.lane = code.lane, INDEX(0)
        place = code.element(code.queries(_ROWS), code.times(group, ROW))
        code.lane = lane
        return place

    def _distance(self, group: ir.Value) -> Lanes:
        """Squared distance from a centre: of the same bits each time, as it is compared with itself."""
        code, row, total = self._code, self._row(group), self._code.number(0)
        for number in range(FEATURES):
            offset = code.given(number) - code.shared(row, number)
            total = code.fma(offset, offset, total)
        return total

    def _add(self, count: ir.Value) -> None:
        """Adds the points of a vector to the sums of those nearest to them."""
        code = self._code
        code.store(code.number(_FAR), self._least)
        with code.loop(count) as group:
            code.store(code.minimum(self._distance(group), code.load(self._least)), self._least)
        with code.loop(count) as group:
            nearest = self._distance(group) <= code.load(self._least)
            own = code.select(nearest, code.given(_IS_POINT), 0)
            self._sums.add(group, own, [1.0, *(code.given(number) for number in range(FEATURES))])

    def _move(self, group: ir.Value) -> None:
        """Moves a centre to the mean of its points."""
        code, row = self._code, self._row(group)
        points, *sums = (code.spread(total) for total in self._sums.totals(group))
        for number, total in enumerate(sums):
            mean = code.select(points > 0, total / code.maximum(points, 1), code.shared(row, number))
            code.builder.store(code.first(mean), code.element(row, number))


def _dot(code: Code, first: Sequence[Lanes], second: Sequence[Lanes]) -> Lanes:
    """Sum of products."""
    total = first[0] * second[0]
    for a, b in zip(first[1:], second[1:], strict=True):
        total = code.fma(a, b, total)
    return total
