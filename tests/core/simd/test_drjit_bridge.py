"""Kernels on Dr.Jit arrays."""

from __future__ import annotations

from collections.abc import Sequence

import drjit as dr
import numpy as np
from drjit.llvm.ad import Array3f, Bool, Float, Float64, UInt32

from loomlight.core.llvm import require_llvm
from loomlight.core.simd import call_kernel, can_use_kernel, is_host_type

require_llvm()


def test_host_types_are_float32_of_the_llvm_backend() -> None:
    assert is_host_type(Float)
    assert not is_host_type(Float64)
    assert not is_host_type(UInt32)
    assert not is_host_type(dr.cuda.ad.Float)


def test_kernels_are_not_used_while_tracing_or_for_derivatives() -> None:
    x = dr.arange(Float, 10)
    assert can_use_kernel(Float, [x, (Bool(True), x)])
    assert not can_use_kernel(Float, [Float()])
    tracked = Float(x)
    dr.enable_grad(tracked)
    assert not can_use_kernel(Float, [x, tracked])
    actual = []

    def body(number: UInt32) -> tuple[UInt32]:
        actual.append(can_use_kernel(Float, x))
        return (number + 1,)

    dr.while_loop((dr.arange(UInt32, 4),), lambda number: number < 4, body, mode="symbolic")

    @dr.freeze
    def frozen(value: Float) -> Float:
        actual.append(can_use_kernel(Float, value))
        return value + 1

    frozen(x)
    assert set(actual) == {False}


def test_inputs_are_flattened_widened_and_evaluated() -> None:
    count, seen = 1000, []

    def launch(inputs: Sequence[np.ndarray], outputs: Sequence[np.ndarray]) -> None:
        seen.extend(array.copy() for array in inputs)
        outputs[0][:] = inputs[0] + inputs[4]
        outputs[1][:] = inputs[3]

    # Not yet evaluated, a vector of space, a mask, and one number for all lanes.
    x = dr.square(dr.arange(Float, count))
    inputs = [x, (Array3f(x, 2 * x, 3), x > 50), Float(7)]
    total, third = call_kernel(Float, inputs, 2, launch)
    squares = np.arange(count, dtype=np.float32) ** 2
    expected = [squares, squares, 2 * squares, np.full(count, 3), squares > 50, np.full(count, 7)]
    for actual, value in zip(seen, expected, strict=True):
        assert actual.dtype == np.float32
        np.testing.assert_array_equal(actual, value)
    np.testing.assert_array_equal(total.numpy(), squares + (squares > 50))
    np.testing.assert_array_equal(third.numpy(), np.full(count, 3))


def test_memory_in_use_is_not_overwritten() -> None:
    """Outputs take freed memory, which kernels that were launched before may still read."""
    count = 1 << 20
    for turn in range(20):
        x = dr.arange(Float, count) + turn
        y = dr.sqrt(x)
        dr.eval(y)
        del x

        def launch(inputs: Sequence[np.ndarray], outputs: Sequence[np.ndarray]) -> None:
            outputs[0][:] = -1

        (actual,) = call_kernel(Float, [y], 1, launch)
        # Dr.Jit's square root may be an estimate with one Newton step.
        np.testing.assert_allclose(y.numpy()[::1000], np.sqrt(np.arange(count)[::1000] + turn), rtol=1e-6)
        assert (actual.numpy() == -1).all()
