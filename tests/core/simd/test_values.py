"""Operators of values against numpy, and uniforms."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from loomlight.core.simd import CompiledKernel, KernelBuilder, SimdTarget, SimdValue
from loomlight.core.simd.values import INT32

from .kernels import TARGETS, computed


@pytest.mark.parametrize("target", TARGETS, ids=str)
def test_float_operators_are_numpys(target: SimdTarget) -> None:
    x, y = np.random.default_rng(0).normal(size=(2, 1003)).astype(np.float32)
    y[:10] = x[:10]

    def emit(kernel: KernelBuilder, inputs: Sequence[SimdValue]) -> list[SimdValue]:
        a, b = inputs
        relations = [a < b, a <= b, a > b, a >= b, a < 0.5]
        return [
            a + b, 2 - a * b, 1 + a, b - 3, a / (b * b + 1), 2 / (a * a + 1), -a,
            *(kernel.math.select(relation, 1, 0) for relation in relations),
        ]  # fmt: skip

    expected = [
        x + y, 2 - x * y, 1 + x, y - 3, x / (y * y + 1), 2 / (x * x + 1), -x,
        x < y, x <= y, x > y, x >= y, x < 0.5,
    ]  # fmt: skip
    # Quotients are off by two last digits at most, fused sums by what their terms are rounded by.
    for actual, value in zip(computed(emit, x, y, outputs=12, target=target), expected, strict=True):
        np.testing.assert_allclose(actual, value, rtol=5e-7, atol=5e-7)


@pytest.mark.parametrize("target", TARGETS, ids=str)
def test_int32_operators_are_numpys(target: SimdTarget) -> None:
    x, y = np.random.default_rng(5).integers(-(2**22), 2**22, (2, 1003))

    def emit(kernel: KernelBuilder, inputs: Sequence[SimdValue]) -> list[SimdValue]:
        a, b = (kernel.to_int32(value) for value in inputs)
        assert a.element == INT32
        return [kernel.to_float(value) for value in (a + b, a - b, 5 - a, a + 7, a >> 3, a << 1)]

    expected = x + y, x - y, 5 - x, x + 7, x >> 3, x << 1
    for actual, value in zip(computed(emit, x, y, outputs=6, target=target), expected, strict=True):
        np.testing.assert_array_equal(actual, value)


@pytest.mark.parametrize("target", TARGETS, ids=str)
def test_mask_operators_are_numpys(target: SimdTarget) -> None:
    x, y = np.random.default_rng(6).normal(size=(2, 1003)).astype(np.float32)

    def emit(kernel: KernelBuilder, inputs: Sequence[SimdValue]) -> list[SimdValue]:
        a, b = (value > 0 for value in inputs)
        return [kernel.math.select(mask, 1, 0) for mask in (a & b, a | b, ~a, a & True, b | False)]

    a, b = x > 0, y > 0
    for actual, value in zip(
        computed(emit, x, y, outputs=5, target=target), (a & b, a | b, ~a, a, b), strict=True
    ):
        np.testing.assert_array_equal(actual, value)


def test_comparisons_with_nan_are_false() -> None:
    x = np.array([np.nan, 1], np.float32)

    def emit(kernel: KernelBuilder, inputs: Sequence[SimdValue]) -> list[SimdValue]:
        (a,) = inputs
        return [kernel.math.select(mask, 1, 0) for mask in (a < 2, a >= 0)]

    for actual in computed(emit, x, outputs=2):
        np.testing.assert_array_equal(actual, [0, 1])


@pytest.mark.parametrize("target", TARGETS, ids=str)
def test_uniforms_are_the_same_in_all_lanes(target: SimdTarget) -> None:
    kernel = KernelBuilder("uniforms", target, inputs=1, outputs=2)
    first, second = kernel.uniform_buffer(0), kernel.uniform_buffer(1)
    with kernel.each_block(), kernel.each_vector():
        x = kernel.load_input(0)
        kernel.store_output(0, x + first[1] * second[2])
        kernel.store_output(1, second.load(0) - x)
    x = np.arange(200, dtype=np.float32)
    outputs = np.zeros((2, len(x)), np.float32)
    buffers = np.array([5, 7], np.float32), np.array([11, 13, 17], np.float32)
    CompiledKernel(kernel).launch(len(x), [x], [*outputs], buffers)
    np.testing.assert_array_equal(outputs, [x + 7 * 17, 11 - x])
