"""Code that is written lane by lane, against numpy; all widths that this processor can run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from llvmlite import ir

from loomlight.core.lane_code import Code, Vectors
from loomlight.core.lane_values import FLOAT, INDEX, TRUTH, WHOLE
from loomlight.core.machine_code import MachineCode

from .lanes import WIDTHS, as_floats, computed, truth


@pytest.mark.parametrize("wide", WIDTHS, ids=str)
def test_arithmetic_is_numpys(wide: Vectors) -> None:
    x, y = np.random.default_rng(0).normal(size=(2, 1003)).astype(np.float32)

    def write(code: Code, given: Sequence[Any]) -> Sequence[Any]:
        a, b = given
        return [
            a + b,
            2 - a * b,
            a / (code.abs(b) + 1),
            -code.floor(a),
            code.round(3 * a),
            code.sqrt(code.square(a) + code.rcp(code.square(b) + 1)),
            code.select((a > 0) & (b < 0.5), a, b),
            code.maximum(a, b) - code.minimum(a, b),
            code.clip(a, -0.5, 0.25),
            code.fma(a, b, 1),
            code.select(a >= b, 1, 0),
        ]

    wanted = [
        x + y,
        2 - x * y,
        x / (np.abs(y) + 1),
        -np.floor(x),
        np.round(3 * x),
        np.sqrt(x**2 + 1 / (y**2 + 1)),
        np.where((x > 0) & (y < 0.5), x, y),
        np.abs(x - y),
        np.clip(x, -0.5, 0.25),
        x * y + 1,
        np.where(x >= y, 1, 0),
    ]
    # Quotients may be off by two last digits, sums cancel to what their terms are rounded by.
    for found, value in zip(computed(write, x, y, wide=wide), wanted, strict=True):
        np.testing.assert_allclose(found, value, rtol=5e-7, atol=5e-7)


def test_logarithms_and_exponentials_are_exact_to_rounding() -> None:
    rng = np.random.default_rng(1)
    value = np.concatenate([np.exp(rng.uniform(-80, 80, 20000)), [1, 2, 0.5, np.float32(2**0.5), 1e-37]])
    power = np.concatenate([rng.uniform(-86, 87, 20000), [0, 1, -1, 1e-8, -300]])
    logarithm, binary, exponential = computed(
        lambda code, given: [code.log(given[0]), code.log2(given[0]), code.exp(given[1])], value, power
    )
    exact = value.astype(np.float32).astype(np.float64)
    # Near 1, where logarithms are small, they are exact beside their distance from 1.
    np.testing.assert_allclose(logarithm, np.log(exact), rtol=4e-7, atol=1e-7)
    np.testing.assert_allclose(binary, np.log2(exact), rtol=4e-7, atol=1e-7)
    wanted = np.exp(np.maximum(power.astype(np.float32).astype(np.float64), -87))
    np.testing.assert_allclose(exponential, wanted, rtol=4e-7)


def test_angles_of_vectors() -> None:
    rng = np.random.default_rng(3)
    y, x = rng.normal(size=(2, 20000))
    y, x = (np.concatenate([part, more]) for part, more in ((y, [0, 0, 1, -1, 0]), (x, [1, -1, 0, 0, 0])))
    (found,) = computed(lambda code, given: [code.atan2(given[0], given[1])], y, x)
    exact = np.arctan2(y.astype(np.float32).astype(np.float64), x.astype(np.float32).astype(np.float64))
    np.testing.assert_allclose(found, exact, atol=1e-6)


@pytest.mark.parametrize("wide", WIDTHS, ids=str)
def test_tables_are_read(wide: Vectors) -> None:
    """Rows of a small one by lanes; bytes in a row by a whole number that one lane has."""
    rng = np.random.default_rng(4)
    table = rng.normal(size=(7, 3)).astype(np.float32)
    numbers = rng.integers(0, 256, 200, dtype=np.uint8)
    code = Code("read", replace(wide, of_block=1))
    with code.blocks():
        places, sums, line = code.rows(1), code.rows(1), code.stack(wide.lanes)
        row = code.given(0)
        for number, value in enumerate(code.looked_up(code.array(5), 3, ir.Constant(INDEX, 7), row)):
            code.answer(1 + number, value)
        code.store_whole(row, 2, places.place(0))
        with code.loop(wide.lanes) as query:
            first = code.whole_at(places.place(0), query)
            second = code.builder.add(first, INDEX(5))
            # The first lane's sum alone is kept of each query.
            code.store(code.sum_of_bytes(code.array(6), [first, second]), line)
            one = code.builder.load(line)
            byte = code.builder.uitofp(code.byte(code.array(6), first), one.type)
            code.builder.store(code.builder.fsub(one, byte), code.element(sums.pointer, query))
        code.answer(4, sums[0])
    rows = rng.integers(0, 7, 100).astype(np.float32)
    found = [np.full(len(rows), np.nan, np.float32) for _ in range(4)]
    MachineCode(code).run(len(rows), [rows], found, [table.ravel(), numbers.view(np.float32)])
    np.testing.assert_array_equal(np.stack(found[:3], 1), table[rows.astype(int)])
    np.testing.assert_array_equal(found[3], numbers[2 * rows.astype(int) + 5].astype(np.float32))


def test_what_is_no_number_is_clipped() -> None:
    odd = np.array([np.nan, np.inf, -np.inf, 1], np.float32)
    (found,) = computed(lambda code, given: [code.clip(given[0], 0, 5)], odd)
    np.testing.assert_array_equal(found, [0, 5, 0, 1])


@pytest.mark.parametrize("lanes", [4, 8, 16])
def test_squares_are_transposed(lanes: int) -> None:
    code = Code("turned", Vectors(lanes, 32, of_block=1))
    with code.blocks():
        lines = [code.load(code.element(code.array(1), number * lanes), align=4) for number in range(lanes)]
        for number, line in enumerate(code.transposed(lines)):
            code.store(line, code.element(code.array(2), number * lanes), align=4)
    square = np.arange(lanes**2, dtype=np.float32)
    found = np.zeros_like(square)
    MachineCode(code).run(lanes, [np.zeros(lanes, np.float32)], [], [square, found])
    np.testing.assert_array_equal(found.reshape(lanes, lanes), square.reshape(lanes, lanes).T)


@pytest.mark.parametrize("wide", WIDTHS, ids=str)
def test_whole_numbers_are_numpys(wide: Vectors) -> None:
    rng = np.random.default_rng(5)
    x, y = rng.integers(0, 2**32, (2, 1003), dtype=np.uint32)
    # Small ones too, which are equal now and then, and above and below each other.
    x[:500] %= 7
    y[:500] %= 7
    few, divisor = y % 32, np.maximum(y, 1)

    def write(code: Code, given: Sequence[Any]) -> Sequence[Any]:
        a, b, shift, by = (code.as_kind(one, WHOLE) for one in given)
        found = [a + b, a - b, 5 - a, -a, a * b, 3 * a, a // by, a // 7, a & b, a | b, 12 ^ a, ~a]
        found += [a >> shift, a << shift, a >> 4, code.select(a > b, a, 9), code.select(a > b, 9, b)]
        relations = [a < b, a <= b, a > b, a >= b, a == b, a < 3]
        return [*(code.as_floats(one) for one in found), *(truth(code, one) for one in relations)]

    # As in numpy numbers turn over at 2³².
    with np.errstate(over="ignore"):
        whole = [
            x + y,
            x - y,
            np.uint32(5) - x,
            np.uint32(0) - x,
            x * y,
            np.uint32(3) * x,
            x // divisor,
            x // 7,
        ]
        whole += [x & y, x | y, x ^ 12, ~x, x >> few, x << few, x >> 4]
        whole += [np.where(x > y, x, np.uint32(9)), np.where(x > y, np.uint32(9), y)]
    relations = [x < y, x <= y, x > y, x >= y, x == y, x < 3]
    found = computed(write, *(as_floats(one) for one in (x, y, few, divisor)), wide=wide)
    assert len(found) == len(whole) + len(relations)
    for number, (one, wanted) in enumerate(zip(found, whole, strict=False)):
        np.testing.assert_array_equal(one.view(np.uint32), wanted, err_msg=str(number))
    for one, wanted in zip(found[len(whole) :], relations, strict=True):
        np.testing.assert_array_equal(one, wanted)


@pytest.mark.parametrize("wide", WIDTHS, ids=str)
def test_what_is_true_is_numpys(wide: Vectors) -> None:
    x, y = np.random.default_rng(6).normal(size=(2, 1003)).astype(np.float32)

    def write(code: Code, given: Sequence[Any]) -> Sequence[Any]:
        a, b = (one > 0 for one in given)
        always = code.converted(True, TRUTH)
        found = [a & b, a | b, a ^ b, ~a, a & True, a | True, False ^ b, a & always]
        found += [code.select(a, b, ~b), code.select(a, b, True), code.select(a, False, b)]
        return [truth(code, one) for one in found]

    a, b = x > 0, y > 0
    wanted = [a & b, a | b, a ^ b, ~a, a, np.ones_like(a), b, a, a == b, ~a | b, ~a & b]
    for found, value in zip(computed(write, x, y, wide=wide), wanted, strict=True):
        np.testing.assert_array_equal(found, value)


def test_kinds_of_lanes_become_each_other() -> None:
    """Whole parts are next to 0, whole numbers have a sign as they become floats."""
    x = np.array([0, 0.9, -0.9, 7.5, -7.5, 2e9, -2e9, 123456], np.float32)
    y = np.array([0, 1, -1, 2**24, -(2**24), 2**31 - 128, -(2**31), 17], np.int64).astype(np.int32)

    def write(code: Code, given: Sequence[Any]) -> Sequence[Any]:
        whole = code.converted(given[0], WHOLE)
        return [code.as_floats(whole), code.converted(code.as_kind(given[1], WHOLE), FLOAT)]

    cut, floats = computed(write, x, y.view(np.float32))
    np.testing.assert_array_equal(cut.view(np.int32), np.trunc(x).astype(np.int32))
    np.testing.assert_array_equal(floats, y.astype(np.float32))


@pytest.mark.parametrize("wide", WIDTHS, ids=str)
def test_sines_and_roots(wide: Vectors) -> None:
    rng = np.random.default_rng(7)
    angle = np.concatenate([rng.uniform(-20, 20, 20000), [0, np.pi, -np.pi, 0.5 * np.pi, 1e-20]])
    value = np.concatenate([rng.uniform(-1, 1, 20000), [0, 1, -1, 1 - 1e-6, 1e-20]])
    square = np.concatenate([np.exp(rng.uniform(-65, 80, 20000)), [0, 1, 4, 1e-32, 1e-38]])
    given = [part.astype(np.float32) for part in (angle, value, square)]
    sine, cosine, arc, root = computed(
        lambda code, lanes: [*code.sincos(lanes[0]), code.asin(lanes[1]), code.sqrt(lanes[2])],
        *given,
        wide=wide,
    )
    angle, value, square = (part.astype(np.float64) for part in given)
    # Polynomials' errors and rounding, beside 1; a multiple of π is taken away exactly.
    np.testing.assert_allclose(sine, np.sin(angle), atol=4e-7)
    np.testing.assert_allclose(cosine, np.cos(angle), atol=4e-7)
    # Where a cosine is found that is almost 0, its rounding counts.
    np.testing.assert_allclose(arc, np.arcsin(value), atol=1e-6)
    large = square > 1e-29
    # An estimate and a step of Newton's.
    np.testing.assert_allclose(root[large], np.sqrt(square[large]), rtol=5e-7)
    np.testing.assert_array_equal(root[square == 0], 0)
    # Below what a reciprocal is taken of they are smaller than they should be, and no less than 0.
    assert (root[~large] >= 0).all()
    assert (root[~large] <= np.sqrt(square[~large])).all()


@pytest.mark.parametrize("wide", WIDTHS, ids=str)
def test_loops_stop_lane_by_lane(wide: Vectors) -> None:
    limits, x = np.random.default_rng(11).integers(0, 20, 1003), np.linspace(-1, 1, 1003, dtype=np.float32)
    # Vectors of which no lane begins.
    limits[:100] = 0

    def write(code: Code, given: Sequence[Any]) -> Sequence[Any]:
        limit = code.converted(given[0], WHOLE)

        def turn(pair: Any, count: Any, odd: Any, here: Any) -> Any:
            return (pair[0] * 0.5 + 1, pair[1] + count), count + 1, ~odd, here

        start = (given[1], code.converted(0, WHOLE)), code.converted(0, WHOLE), limit < 0, limit
        (value, total), count, odd, _ = code.while_loop(start, lambda _, n, __, most: n < most, turn)
        return [value, code.converted(total, FLOAT), code.converted(count, FLOAT), truth(code, odd)]

    value = x.copy()
    for turn in range(limits.max()):
        value = np.where(turn < limits, value * np.float32(0.5) + 1, value)
    found = computed(write, limits.astype(np.float32), x, wide=wide)
    # Halves and sums with 1, rounded the same way or fused.
    np.testing.assert_allclose(found[0], value, rtol=2e-7)
    np.testing.assert_array_equal(found[0][limits == 0], x[limits == 0])
    np.testing.assert_array_equal(found[1], limits * (limits - 1) // 2)
    np.testing.assert_array_equal(found[2], limits)
    np.testing.assert_array_equal(found[3], limits % 2)


@pytest.mark.parametrize("wide", WIDTHS, ids=str)
def test_changes_happen_where_they_are_told(wide: Vectors) -> None:
    """And take no time in vectors where there are none."""
    rng, count = np.random.default_rng(12), 6 * wide.block
    x, active = rng.normal(size=count).astype(np.float32), rng.random(count) < 0.5
    active[: 2 * wide.block] = False
    code = Code("changed", wide)
    with code.blocks(), code.each_vector():

        def change(pair: Any) -> Any:
            code.answer(4, 1)
            return pair[0] + 2, pair[1] + 3, ~pair[2]

        value = code.given(0)
        start = value, code.converted(5, WHOLE), value > 0
        found = code.masked_branch(code.given(1) > 0, start, change)
        lanes = found[0], code.converted(found[1], FLOAT), truth(code, found[2])
        # Five arrays: two given, and of four answers the last by the change itself.
        for number, one in zip((2, 3, 5), lanes, strict=True):
            code.answer(number, one)
    answers = [np.zeros(count, np.float32) for _ in range(4)]
    MachineCode(code).run(count, [x, active.astype(np.float32)], answers, [])
    np.testing.assert_array_equal(answers[0], np.where(active, x + 2, x))
    np.testing.assert_array_equal(answers[1], np.where(active, 8, 5))
    np.testing.assert_array_equal(answers[3], active ^ (x > 0))
    entered = active.reshape(-1, wide.lanes).any(1)
    assert not entered.all()
    np.testing.assert_array_equal(
        answers[2].reshape(-1, wide.lanes), np.repeat(entered[:, None], wide.lanes, 1)
    )


@pytest.mark.parametrize("wide", WIDTHS, ids=str)
def test_lanes_are_put_where_they_are_told(wide: Vectors) -> None:
    """To other places, or one after another, and counted."""
    wide = replace(wide, of_block=1)
    code = Code("put", wide)
    with code.blocks():
        value, chosen = code.given(0), code.given(1) > 0
        turned = (wide.lanes - 1) - code.numbered(INDEX(0))
        code.scatter_to(code.queries(2), turned, value, chosen)
        code.compress(value, chosen, code.queries(3))
        code.answer(4, code.converted(code.in_all_lanes(code.count_of(chosen)), FLOAT))
    rng, count = np.random.default_rng(13), 50 * wide.lanes
    x, chosen = rng.normal(size=count).astype(np.float32), rng.random(count) < 0.4
    chosen[: wide.lanes], chosen[wide.lanes : 2 * wide.lanes] = True, False
    answers = [np.full(count, 9, np.float32) for _ in range(3)]
    MachineCode(code).run(count, [x, chosen.astype(np.float32)], answers, [])
    lines, where = x.reshape(-1, wide.lanes), chosen.reshape(-1, wide.lanes)
    put, packed, counts = (part.reshape(-1, wide.lanes) for part in answers)
    np.testing.assert_array_equal(put[:, ::-1], np.where(where, lines, 9))
    np.testing.assert_array_equal(counts, np.repeat(where.sum(1)[:, None], wide.lanes, 1))
    for line, some, found in zip(lines, where, packed, strict=True):
        np.testing.assert_array_equal(found[: some.sum()], line[some])
        np.testing.assert_array_equal(found[some.sum() :], 9)


@pytest.mark.parametrize("wide", WIDTHS, ids=str)
def test_two_vectors_go_side_by_side(wide: Vectors) -> None:
    x, y = np.random.default_rng(14).normal(size=(2, 1003)).astype(np.float32)

    def write(code: Code, given: Sequence[Any]) -> Sequence[Any]:
        twice = code.doubled()
        assert (twice.vectors.lanes, code.vectors.lanes) == (2 * wide.lanes, wide.lanes)
        both = twice.joined(*given)
        # Signs tell halves that were swapped; numbers of Python's are as long as both.
        found = twice.select(both > 0, 2 * twice.floor(both), twice.abs(both) + 0.5)
        return code.halves(found)

    for found, value in zip(computed(write, x, y, wide=wide), (x, y), strict=True):
        wanted = np.where(value > 0, 2 * np.floor(value), np.abs(value) + np.float32(0.5))
        np.testing.assert_array_equal(found, wanted)


@pytest.mark.parametrize("wide", WIDTHS, ids=str)
def test_lanes_are_added_up(wide: Vectors) -> None:
    """Block by block: the sum over a block's lanes, its first lane, and the number of its first query."""
    code = Code("added", replace(wide, of_block=1))
    with code.blocks():
        given = code.given(0)
        code.answer(1, code.spread(code.total(given)))
        code.answer(2, code.spread(code.first(given)))
        code.answer(3, code.counted(code.first_query()))
    count = 7 * wide.lanes
    asked = np.random.default_rng(0).uniform(-1, 1, count).astype(np.float32)
    answers = [np.empty(count, np.float32) for _ in range(3)]
    MachineCode(code).run(count, [asked], answers, [])
    blocks = asked.reshape(7, -1)
    # Sums of as many numbers as there are lanes, in whatever order.
    np.testing.assert_allclose(
        answers[0].reshape(7, -1), blocks.sum(axis=1)[:, None] * np.ones(wide.lanes), atol=1e-5
    )
    np.testing.assert_array_equal(answers[1].reshape(7, -1), np.repeat(blocks[:, :1], wide.lanes, axis=1))
    np.testing.assert_array_equal(answers[2].reshape(7, -1)[:, 0], np.arange(7) * wide.lanes)
