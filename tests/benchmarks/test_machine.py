"""What the machine can do, and how operations of kernels are counted."""

from __future__ import annotations

import drjit as dr
from drjit.llvm import Float

from benchmarks.machine import fma_peak, least_seconds, median_seconds, operations_of
from experiments.timing import launched_kernels


def test_operations_of_a_kernel_are_counted() -> None:
    x, y = dr.opaque(Float, 2, 64), dr.opaque(Float, 3, 64)
    (kernel,) = launched_kernels(lambda: dr.eval(dr.sqrt(dr.fma(x, y, x) / y) * x))
    # A multiply-add is two; then a division, a root and a product.
    assert operations_of(kernel["ir"].read()) == 5


def test_the_peak_is_more_than_a_scalar_core_and_less_than_any_machine() -> None:
    assert 1e9 < fma_peak() < 1e14


def test_the_least_time_is_no_longer_than_the_median() -> None:
    assert 0 < least_seconds(lambda: sum(range(1000))) < 10
    assert 0 < median_seconds(lambda: sum(range(1000))) < 10
