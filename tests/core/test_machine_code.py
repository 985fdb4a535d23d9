"""Code that is written lane by lane, and layers, against numpy; all widths that this processor can run."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from llvmlite import ir

from loomlight.core import machine_code
from loomlight.core.dense_code import Packed, dense
from loomlight.core.lane_code import INDEX, Code, Vectors
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
