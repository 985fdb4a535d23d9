"""Elementary functions of kernels against numpy in double precision."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from loomlight.core.simd import KernelBuilder, SimdTarget, SimdValue

from .kernels import TARGETS, computed


@pytest.mark.parametrize("target", TARGETS, ids=str)
def test_functions_are_numpys(target: SimdTarget) -> None:
    x, y = np.random.default_rng(0).normal(size=(2, 1003)).astype(np.float32)

    def emit(kernel: KernelBuilder, inputs: Sequence[SimdValue]) -> list[SimdValue]:
        (a, b), math = inputs, kernel.math
        return [
            math.floor(a), math.round(3 * a), math.abs(b), math.square(a), math.rcp(math.square(b) + 1),
            math.select((a > 0) & (b < 0.5), a, b), math.select(a > b, 1, a), math.maximum(a, b),
            math.minimum(a, b), math.clip(a, -0.5, 0.25), math.fma(a, b, 1),
        ]  # fmt: skip

    expected = [
        np.floor(x), np.round(3 * x), np.abs(y), x**2, 1 / (y**2 + 1),
        np.where((x > 0) & (y < 0.5), x, y), np.where(x > y, 1, x), np.maximum(x, y),
        np.minimum(x, y), np.clip(x, -0.5, 0.25), x * y + 1,
    ]  # fmt: skip
    # Reciprocals are off by two last digits at most; the sum with 1 is rounded once here, twice in numpy.
    for actual, value in zip(computed(emit, x, y, outputs=11, target=target), expected, strict=True):
        np.testing.assert_allclose(actual, value, rtol=5e-7, atol=1e-7)


@pytest.mark.parametrize("target", TARGETS, ids=str)
def test_logarithms_and_exponentials_are_exact_to_rounding(target: SimdTarget) -> None:
    rng = np.random.default_rng(1)
    value = np.concatenate([np.exp(rng.uniform(-80, 80, 20000)), [1, 2, 0.5, np.float32(2**0.5), 1e-37]])
    power = np.concatenate([rng.uniform(-86, 87, 20000), [0, 1, -1, 1e-8, -300]])
    natural, binary, exponential = computed(
        lambda kernel, inputs: [
            kernel.math.log(inputs[0]), kernel.math.log2(inputs[0]), kernel.math.exp(inputs[1])
        ],
        value, power, outputs=3, target=target,
    )  # fmt: skip
    exact = value.astype(np.float32).astype(np.float64)
    # Near 1, where logarithms are small, the error is relative to the distance from 1.
    np.testing.assert_allclose(natural, np.log(exact), rtol=4e-7, atol=1e-7)
    np.testing.assert_allclose(binary, np.log2(exact), rtol=4e-7, atol=1e-7)
    expected = np.exp(np.maximum(power.astype(np.float32).astype(np.float64), -87))
    np.testing.assert_allclose(exponential, expected, rtol=4e-7)


@pytest.mark.parametrize("target", TARGETS, ids=str)
def test_square_roots_are_exact_to_rounding(target: SimdTarget) -> None:
    rng = np.random.default_rng(7)
    square = np.concatenate([np.exp(rng.uniform(-65, 80, 20000)), [0, 1, 4, 1e-32, 1e-38]]).astype(np.float32)
    (root,) = computed(lambda kernel, inputs: [kernel.math.sqrt(inputs[0])], square, target=target)
    large = square > 1e-29
    # An estimate of the reciprocal root and one Newton step.
    np.testing.assert_allclose(root[large], np.sqrt(square[large].astype(np.float64)), rtol=5e-7)
    np.testing.assert_array_equal(root[square == 0], 0)
    # Below 1e-30 roots are too small, but not negative.
    assert (root[~large] >= 0).all()
    assert (root[~large] <= np.sqrt(square[~large])).all()


def test_clip_bounds_nan_and_infinity() -> None:
    odd = np.array([np.nan, np.inf, -np.inf, 1], np.float32)
    (actual,) = computed(lambda kernel, inputs: [kernel.math.clip(inputs[0], 0, 5)], odd)
    np.testing.assert_array_equal(actual, [0, 5, 0, 1])
