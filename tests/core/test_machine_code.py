"""Code that is written lane by lane, and layers, against numpy; all widths that this processor can run."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from llvmlite import ir

from loomlight.core import machine_code
from loomlight.core.arrays import gather, gather_one, opaque, uploaded
from loomlight.core.dense_code import Packed, dense
from loomlight.core.files import cache_folder
from loomlight.core.lane_code import Code, Vectors
from loomlight.core.lane_piles import Pile
from loomlight.core.lane_values import FLOAT, INDEX, TRUTH, WHOLE, SharedNumbers
from loomlight.core.machine_code import MachineCode, aligned, vectors

# Of other processors: LLVM splits vectors that are too long, and code is right with few registers too.
WIDTHS = [vectors(), Vectors(4, 16), Vectors(8, 16), Vectors(16, 32)]


def computed(
    write: Callable[[Code, Sequence[Any]], Sequence[Any]], *arrays: np.ndarray, wide: Vectors | None = None
) -> list[np.ndarray]:
    """What code makes of arrays, vector by vector."""
    code, count = Code("computed", wide or vectors()), 0
    with code.blocks(), code.each_vector():
        answers = write(code, [code.given(number) for number in range(len(arrays))])
        count = len(answers)
        for number, answer in enumerate(answers):
            code.answer(len(arrays) + number, answer)
    given = [np.ascontiguousarray(array, np.float32) for array in arrays]
    found = [np.full(len(given[0]), np.nan, np.float32) for _ in range(count)]
    MachineCode(code).run(len(given[0]), given, found, [])
    return found


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
@pytest.mark.parametrize("count", [1, 48, 1000])
def test_layers_are_products_of_matrices(wide: Vectors, count: int) -> None:
    rng = np.random.default_rng(2)
    first, second = rng.normal(size=(21, 7)), rng.normal(size=(5, 21))
    biases, slope = (rng.normal(size=21), rng.normal(size=5)), 0.1
    packed = Packed(wide)
    one, other = packed.add("one", first, biases[0]), packed.add("other", second)
    code = Code("layers", wide)
    with code.blocks():
        inputs, hidden, output = (code.rows(n) for n in (7, one.rows(wide), other.rows(wide)))
        start = code.rows(other.rows(wide))
        with code.each_vector():
            for number in range(7):
                inputs[number] = code.given(number)
            for number in range(5):
                start[number] = biases[1][number]
        numbers = code.array(7 + 5)
        dense(code, numbers, one, inputs, hidden, slope=slope)
        dense(code, numbers, other, hidden, output, start=start)
        with code.each_vector():
            for number in range(5):
                code.answer(7 + number, output[number])
    given = rng.normal(size=(7, count)).astype(np.float32)
    found = np.zeros((5, count), np.float32)
    MachineCode(code).run(count, [*given], [*found], [packed.numbers()])
    between = first @ given + biases[0][:, None]
    wanted = second @ np.where(between > 0, between, slope * between) + biases[1][:, None]
    np.testing.assert_allclose(found, wanted, rtol=1e-5, atol=2e-5)


def test_blocks_share_registers() -> None:
    for wide in WIDTHS:
        # All sums of a tile, the inputs of a block and a weight.
        assert wide.sums * wide.of_block + wide.of_block + 1 <= wide.registers
        assert wide.block == wide.lanes * wide.of_block


@pytest.mark.parametrize("cores", [1, 2, 5])
def test_any_number_of_cores_answers_every_query(cores: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(machine_code, "cores", lambda: cores)
    for count in (0, 1, 47, 48, 49, 10_000):
        x = np.arange(count, dtype=np.float32)
        (found,) = computed(lambda _, given: [given[0] + 1], x)
        np.testing.assert_array_equal(found, x + 1)


def test_threads_may_ask_at_once() -> None:
    code = Code("twice", vectors())
    with code.blocks(), code.each_vector():
        code.answer(1, 2 * code.given(0))
    compiled, wrong = MachineCode(code), []

    def ask(seed: int) -> None:
        x = np.random.default_rng(seed).random(5000, np.float32)
        for _ in range(20):
            found = np.empty_like(x)
            compiled.run(len(x), [x], [found], [])
            wrong.append(int((found != 2 * x).sum()))

    threads = [threading.Thread(target=ask, args=(seed,)) for seed in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert wrong == [0] * 80


def test_arrays_that_code_cannot_read_are_refused() -> None:
    code = Code("same", vectors())
    with code.blocks(), code.each_vector():
        code.answer(1, code.given(0))
    compiled, good = MachineCode(code), np.zeros(10, np.float32)
    for bad in (np.zeros(10), np.zeros(20, np.float32)[::2], np.zeros(9, np.float32)):
        with pytest.raises(ValueError, match="float32 in a row"):
            compiled.run(10, [bad], [good], [])


def test_aligned_numbers_begin_with_a_line() -> None:
    for count in (1, 17, 1000):
        values = np.arange(count, dtype=np.float32).reshape(1, -1)
        found = aligned(values)
        assert found.ctypes.data % 64 == 0
        np.testing.assert_array_equal(found, values)


# What lanes say of whole numbers and of what is true goes in and out as the bits of floats.


def as_floats(wholes: np.ndarray) -> np.ndarray:
    return np.ascontiguousarray(wholes, np.uint32).view(np.float32)


def truth(code: Code, value: Any) -> Any:
    """1 for what is true."""
    return code.select(value, 1.0, 0.0)


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
def test_numbers_of_a_fabric_are_read_in_order(wide: Vectors) -> None:
    """Single ones, and elements, pairs and rows of four of tables; code does not know them."""
    rng = np.random.default_rng(8)
    floats = rng.normal(size=(25, 4)).astype(np.float32)
    wholes = rng.integers(0, 2**32, (25, 4), dtype=np.uint32)

    def numbers_of(types: Any, factor: float) -> list[Any]:
        """What is asked for as code is written, and once more for each fabric."""
        return [
            opaque(types.Float, 0.25 * factor),
            uploaded(types.Float, factor * floats),
            opaque(types.Float, -3.0 * factor),
            uploaded(types.UInt32, wholes),
            opaque(types.UInt32, 7),
        ]

    code = Code("fabric", wide)
    code.shares(1 + 17)
    first, table, second, bits, whole = numbers_of(code.types, 0.0)
    with code.blocks(), code.each_vector():
        row, types = code.converted(code.given(0), WHOLE), code.types
        found = [first, second, code.converted(whole, WHOLE)]
        found += [gather(types.Float, table, row * 4 + 3), *gather(types.Vector4, table, row)]
        found += [gather(types.UInt32, bits, row * 4 + 2), *gather(types.Index4, bits, row)]
        found += gather(types.Index2, bits, row * 2 + 1)
        found += [gather_one(types.UInt32, bits, row, row > 12, row < 5), types.Float(0.5)]
        assert len(found) == 17
        for number, lanes in enumerate(found):
            code.answer(1 + number, code.as_floats(lanes))
    compiled, rows = MachineCode(code), rng.integers(0, 25, 1003)
    # Another fabric has other numbers for the same code.
    for factor in (1.0, 2.0):
        shared = SharedNumbers()
        numbers_of(shared.types, factor)
        answers = [np.full(len(rows), np.nan, np.float32) for _ in range(17)]
        compiled.run(len(rows), [rows.astype(np.float32)], answers, shared.arrays())
        np.testing.assert_array_equal(answers[0], 0.25 * factor)
        np.testing.assert_array_equal(answers[1], -3 * factor)
        # As shared numbers are floats.
        np.testing.assert_array_equal(answers[2].view(np.uint32), 7)
        np.testing.assert_array_equal(answers[3], factor * floats[rows, 3])
        np.testing.assert_array_equal(np.stack(answers[4:8], 1), factor * floats[rows])
        of_bits = [answer.view(np.uint32) for answer in answers[8:16]]
        np.testing.assert_array_equal(of_bits[0], wholes[rows, 2])
        np.testing.assert_array_equal(np.stack(of_bits[1:5], 1), wholes[rows])
        np.testing.assert_array_equal(np.stack(of_bits[5:7], 1), wholes[rows, 2:])
        column = (rows > 12) + 2 * (rows < 5)
        np.testing.assert_array_equal(of_bits[7], wholes[rows, column])
        np.testing.assert_array_equal(answers[16], 0.5)


@dataclass
class Parcel:
    """What tests put on piles.

    Attributes:
        query: its number in the block.
        rounds: how often it is put back yet.
        number: a float.
        flags: what is true, beside a whole number.
    """

    query: Any
    rounds: Any
    number: Any
    flags: tuple[Any, Any, Any]


@pytest.mark.parametrize("wide", WIDTHS, ids=str)
def test_piles_give_back_once_what_was_put_on_them(wide: Vectors) -> None:
    """In rounds: some are put back, with another number, before what lies deeper is taken."""
    code = Code("pile", wide)
    whole, number, no = (code.converted(0, kind) for kind in (WHOLE, FLOAT, TRUTH))
    pile = Pile(code, Parcel(whole, whole, number, (no, no, no)), wide.block)
    with code.blocks():
        pile.clear()
        with code.each_vector():
            rounds, bits = code.converted(code.given(0), WHOLE), code.converted(code.given(1), WHOLE)
            flags = (bits & 1) > 0, (bits & 2) > 0, (bits & 4) > 0
            pile.put(Parcel(code.numbered(code.lane), rounds, code.given(2), flags), rounds > 0)
        with code.as_long_as(pile.is_left):
            parcel, there = pile.take()
            query = code.select(there, parcel.query, 0)
            a, b, c = parcel.flags
            more = replace(parcel, rounds=parcel.rounds - 1, number=parcel.number + 1, flags=(b, c, a))
            pile.put(more, there & (parcel.rounds > 1))
            last = there & (parcel.rounds == 1)
            flags = code.select(a, 1.0, 0.0) + code.select(b, 2.0, 0.0) + code.select(c, 4.0, 0.0)
            for answer, lanes in ((3, parcel.number), (4, flags)):
                code.scatter_to(code.queries(answer), query, lanes, last)
            # How often each was taken.
            times = code.gathered_from(code.queries(5), query) + 1
            code.scatter_to(code.queries(5), query, times, there)
    rng = np.random.default_rng(9)
    rounds, bits, numbers = rng.integers(0, 6, 1003), rng.integers(0, 8, 1003), rng.normal(size=1003)
    # Blocks of which all or none is put on the pile.
    rounds[: wide.block] = 3
    rounds[wide.block : 2 * wide.block] = 0
    given = [part.astype(np.float32) for part in (rounds, bits, numbers)]
    found = [np.zeros(1003, np.float32) for _ in range(3)]
    MachineCode(code).run(1003, given, found, [])
    put, turns = rounds > 0, np.maximum(rounds - 1, 0)
    wanted = given[2].copy()
    for turn in range(turns.max()):
        wanted[turns > turn] += np.float32(1)
    turned = ((bits >> turns % 3) | (bits << (3 - turns % 3))) & 7
    np.testing.assert_array_equal(found[0], np.where(put, wanted, 0))
    np.testing.assert_array_equal(found[1], np.where(put, turned, 0))
    np.testing.assert_array_equal(found[2], rounds)


def test_piles_are_taken_from_the_top_without_gaps() -> None:
    wide = Vectors(8, 16)
    code = Code("top", wide)
    pile, turn = Pile(code, code.converted(0, WHOLE), wide.block), code.variable(INDEX)
    with code.blocks():
        pile.clear()
        code.builder.store(INDEX(0), turn)
        with code.each_vector():
            pile.put(code.numbered(code.lane), code.given(0) > 0)
        with code.as_long_as(pile.is_left):
            query, there = pile.take()
            code.builder.store(code.builder.add(code.builder.load(turn), INDEX(1)), turn)
            query = code.select(there, query, 0)
            code.scatter_to(code.queries(1), query, code.counted(code.builder.load(turn)), there)
    chosen = np.random.default_rng(10).random(5 * wide.block) < 0.7
    found = np.zeros(len(chosen), np.float32)
    MachineCode(code).run(len(chosen), [chosen.astype(np.float32)], [found], [])
    for block, turns in zip(chosen.reshape(5, -1), found.reshape(5, -1), strict=True):
        wanted = np.arange(block.sum())[::-1] // wide.lanes + 1
        np.testing.assert_array_equal(turns[block], wanted)
        np.testing.assert_array_equal(turns[~block], 0)


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
        found = code.changed_where(code.given(1) > 0, start, change)
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


@pytest.mark.parametrize("cores", [1, 2, 5])
def test_every_block_is_answered_once(cores: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Threads share a count of blocks; what is answered twice would count twice."""
    monkeypatch.setattr(machine_code, "cores", lambda: cores)
    wide = Vectors(4, 16)
    code = Code("once", wide)
    with code.blocks(), code.each_vector():
        code.answer(1, code.given(1) + code.given(0))
    compiled = MachineCode(code)
    # Whole blocks, and about as many as are taken at once.
    for count in (1, 12, 1019, 1020, 1024, 1032, 12 * 100_000, 1_000_003):
        x = np.arange(count, dtype=np.float32) % 1000 + 1
        found = np.zeros_like(x)
        compiled.run(count, [x], [found], [])
        np.testing.assert_array_equal(found, x)


def squares_of(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Numbers, and what code makes of them that no other test writes."""
    given = np.arange(count, dtype=np.float32)
    (found,) = computed(lambda code, lanes: [lanes[0] * lanes[0] + 0.71875], given)
    return given * given + np.float32(0.71875), found


def test_what_was_compiled_is_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    np.testing.assert_array_equal(*squares_of(100))
    (kept,) = cache_folder("machine_code").iterdir()
    whole = kept.read_bytes()
    compiled = machine_code._optimised

    def never(*_: object) -> bytes:
        raise AssertionError("compiled anew")

    monkeypatch.setattr(machine_code, "_optimised", never)
    np.testing.assert_array_equal(*squares_of(100))
    monkeypatch.setattr(machine_code, "_optimised", compiled)
    # Half a file, or one with a wrong byte, is none.
    for damaged in (whole[: len(whole) // 2], whole[:-1] + bytes([whole[-1] ^ 1]), b""):
        kept.write_bytes(damaged)
        np.testing.assert_array_equal(*squares_of(100))
        assert kept.read_bytes() == whole


def test_nothing_need_be_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("no folder")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    np.testing.assert_array_equal(*squares_of(100))
