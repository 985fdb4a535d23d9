"""What the machine can do, and how operations of kernels are counted."""

from __future__ import annotations

import drjit as dr
import numpy as np
import pytest
from drjit.llvm import Float

from studies.instruments import machine
from studies.instruments.machine import fma_peak, operations_of
from studies.instruments.timing import launched_kernels


def test_operations_of_a_kernel_are_counted() -> None:
    x, y = dr.opaque(Float, 2, 64), dr.opaque(Float, 3, 64)
    (kernel,) = launched_kernels(lambda: dr.eval(dr.sqrt(dr.fma(x, y, x) / y) * x))
    # A multiply-add is two; then a division, a root and a product.
    assert operations_of(kernel["ir"].read()) == 5


def test_the_peak_is_less_than_any_machines() -> None:
    assert 0 < fma_peak() < 1e14


def test_of_many_runs_the_least_and_the_median_count(monkeypatch: pytest.MonkeyPatch) -> None:
    # Two runs that warm up, and as many as are counted: their seconds are 9, 9, 1, 2, 3, …
    counted = range(1, machine.REPEATS + 1)
    for function, expected in ((machine.least_seconds, 1), (machine.median_seconds, np.median(counted))):
        taken = iter([9.0, 9.0, *map(float, counted)])
        monkeypatch.setattr(machine, "timed", lambda run, taken=taken: (run(), next(taken)))
        assert function(lambda: None) == expected
