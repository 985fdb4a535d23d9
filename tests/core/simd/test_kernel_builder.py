"""Control flow, memory and operations across lanes against numpy, for every width this processor can run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
from llvmlite import ir

from loomlight.core.simd import CompiledKernel, KernelBuilder, SimdTarget, SimdValue

from .kernels import TARGETS, computed

X = np.random.default_rng(3).normal(size=1003).astype(np.float32)


@pytest.mark.parametrize("target", TARGETS, ids=str)
def test_registers_hold_a_tile(target: SimdTarget) -> None:
    assert target.block_size == target.width * target.vectors_per_block
    # The sums of a tile, the inputs of a block and a weight; and one output more would not fit.
    for outputs, fits in ((target.max_tile, True), (target.max_tile + 1, False)):
        registers = outputs * target.vectors_per_block + target.vectors_per_block + 1
        assert (registers <= target.registers) == fits


@pytest.mark.parametrize("target", TARGETS, ids=str)
def test_loops_count(target: SimdTarget) -> None:
    def emit(kernel: KernelBuilder, inputs: Sequence[SimdValue]) -> list[SimdValue]:
        total = kernel.stack_floats(kernel.target.width)
        kernel.store(inputs[0], total)
        with kernel.loop(5) as number:
            kernel.store(kernel.load(total) + kernel.broadcast_index(number), total)
        with kernel.loop(1):
            kernel.store(kernel.load(total) * 2, total)
        return [kernel.load(total)]

    (actual,) = computed(emit, X, target=target)
    np.testing.assert_allclose(actual, 2 * (X + 10), rtol=2e-7)


@pytest.mark.parametrize("target", TARGETS, ids=str)
def test_block_buffers_keep_channels_of_all_vectors(target: SimdTarget) -> None:
    kernel = KernelBuilder("buffers", target, inputs=1, outputs=3)
    with kernel.each_block():
        buffer = kernel.block_buffer(3)
        assert buffer.channels == 3
        with kernel.loop(3) as channel, kernel.each_vector():
            buffer[channel] = kernel.load_input(0) + kernel.broadcast_index(channel)
        with kernel.loop(3) as channel, kernel.each_vector():
            kernel.store_output(channel, buffer[channel])
    outputs = np.zeros((3, len(X)), np.float32)
    CompiledKernel(kernel).launch(len(X), [X], [*outputs], [])
    np.testing.assert_array_equal(outputs, [X, X + 1, X + 2])


def test_functions_are_emitted_once() -> None:
    bodies = []

    def emit(kernel: KernelBuilder, inputs: Sequence[SimdValue]) -> list[SimdValue]:
        place = kernel.stack_floats(kernel.target.width)
        kernel.store(inputs[0], place)

        def double(pointer: ir.Value) -> None:
            bodies.append(pointer)
            kernel.store(2 * kernel.load(pointer), pointer)

        kernel.call("double", double, place)
        kernel.call("double", double, place)
        return [kernel.load(place)]

    (actual,) = computed(emit, X)
    np.testing.assert_array_equal(actual, 4 * X)
    assert len(bodies) == 1


@pytest.mark.parametrize("target", TARGETS, ids=str)
def test_table_rows_are_looked_up_per_lane(target: SimdTarget) -> None:
    rng = np.random.default_rng(4)
    table = rng.normal(size=(7, 3)).astype(np.float32)
    kernel = KernelBuilder("table", target, inputs=1, outputs=3)
    with kernel.each_block(), kernel.each_vector():
        count = kernel.load_index(kernel.uniform_buffer(1).pointer, 1)
        rows = kernel.table_rows(kernel.uniform_buffer(0).pointer, 3, count, kernel.load_input(0))
        for number, value in enumerate(rows):
            kernel.store_output(number, value)
    row = rng.integers(0, 7, 100).astype(np.float32)
    outputs = np.zeros((3, len(row)), np.float32)
    CompiledKernel(kernel).launch(len(row), [row], [*outputs], [table.ravel(), np.array([0, 7], np.float32)])
    np.testing.assert_array_equal(outputs.T, table[row.astype(int)])


@pytest.mark.parametrize("width", [4, 8, 16])
def test_squares_are_transposed(width: int) -> None:
    kernel = KernelBuilder("transposed", SimdTarget(width, 32, vectors_per_block=1), inputs=0, outputs=1)
    source, target = kernel.uniform_buffer(0), kernel.uniform_buffer(1)
    with kernel.each_block():
        rows = [kernel.load(kernel.element_pointer(source.pointer, k * width), align=4) for k in range(width)]
        for k, column in enumerate(kernel.transpose(rows)):
            kernel.store(column, kernel.element_pointer(target.pointer, k * width), align=4)
    square = np.arange(width**2, dtype=np.float32)
    actual = np.zeros_like(square)
    CompiledKernel(kernel).launch(width, [], [np.zeros(width, np.float32)], [square, actual])
    np.testing.assert_array_equal(actual.reshape(width, width), square.reshape(width, width).T)


@pytest.mark.parametrize("target", TARGETS, ids=str)
def test_any_sees_every_lane(target: SimdTarget) -> None:
    """Per vector, and per block: a single positive number in each place in turn, and none."""
    kernel = KernelBuilder("any", target, inputs=1, outputs=2)

    def as_float(truth: ir.Value) -> SimdValue:
        return kernel.broadcast_index(kernel.ir.zext(truth, ir.IntType(64)))

    with kernel.each_block():
        buffer = kernel.block_buffer(1)
        with kernel.each_vector():
            buffer[0] = kernel.load_input(0)
            kernel.store_output(0, as_float(kernel.any(kernel.load_input(0) > 0)))
        in_block = kernel.any_positive(buffer)
        with kernel.each_vector():
            kernel.store_output(1, as_float(in_block))
    blocks = np.concatenate([np.eye(target.block_size), -np.ones((1, target.block_size))])
    x = np.ascontiguousarray(blocks.ravel(), np.float32)
    outputs = np.zeros((2, len(x)), np.float32)
    CompiledKernel(kernel).launch(len(x), [x], [*outputs], [])
    vectors = x.reshape(-1, target.width)
    np.testing.assert_array_equal(outputs[0], np.repeat((vectors > 0).any(1), target.width))
    np.testing.assert_array_equal(outputs[1], np.repeat((blocks > 0).any(1), target.block_size))


@pytest.mark.parametrize("vectors", [1, 2, 3, 5])
def test_blocks_may_have_any_number_of_vectors(vectors: int) -> None:
    target = replace(TARGETS[0], vectors_per_block=vectors)
    (actual,) = computed(lambda _, inputs: [inputs[0] + 1], X, target=target)
    np.testing.assert_array_equal(actual, X + 1)
