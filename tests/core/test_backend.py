"""Bounds against Dr.Jit's own, and where they differ from these."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import drjit as dr
import numpy as np
from drjit.llvm.ad import Array3f, Float, UInt32

from loomlight.core.backend import clip, maximum, minimum, upload, upload_vector
from loomlight.core.llvm import require_llvm
from studies.instruments.timing import launched_kernels

require_llvm()


def test_bounds_are_dr_jits() -> None:
    rng = np.random.default_rng(0)
    values, bounds = (Float(rng.normal(size=1000).astype(np.float32)) for _ in range(2))
    counts = UInt32(rng.integers(0, 9, 1000, np.uint32))
    for second in (bounds, 0.25, -1):
        assert dr.all(maximum(values, second) == dr.maximum(values, second))
        assert dr.all(minimum(values, second) == dr.minimum(values, second))
        assert dr.all(maximum(second, values) == dr.maximum(second, values))
    assert dr.all(clip(values, -0.5, 0.5) == dr.clip(values, -0.5, 0.5))
    assert type(minimum(counts, 5)) is UInt32
    assert dr.all(minimum(counts, 5) == dr.minimum(counts, 5))
    vector = Array3f(values, bounds, -values)
    assert dr.all(maximum(vector, 0) == dr.maximum(vector, 0), axis=None)


def test_no_number_passes() -> None:
    nothing = Float([math.nan, math.nan])
    assert list(maximum(nothing, 2)) == [2, 2]
    assert list(minimum(nothing, 2)) == [2, 2]
    assert list(clip(nothing, 0, 1)) == [0, 0]


def test_derivatives_are_dr_jits() -> None:
    gradients = []
    for bound in (maximum, dr.maximum):
        value = Float([-1, 0, 2])
        dr.enable_grad(value)
        dr.backward(dr.sum(3 * bound(value, 0)))
        gradients.append(list(dr.grad(value)))
    assert gradients[0] == gradients[1]
    assert gradients[0][::2] == [0, 3]


def test_kernels_do_not_depend_on_where_numpy_keeps_numbers() -> None:
    """Vectors whose components begin at any address need one kernel; read in place they need several."""
    memory = np.arange(400, dtype=np.float32)

    def kernels(vector_of: Callable[[Any], Any]) -> int:
        texts = set()
        for start in range(4):
            rows = memory[start : start + 300].reshape(3, 100)
            vector = vector_of(rows)
            (kernel,) = launched_kernels(lambda vector=vector: dr.eval(dr.dot(vector, vector) + 1))
            texts.add(kernel["hash"])
        return len(texts)

    assert kernels(lambda rows: upload_vector(Array3f, rows)) == 1
    assert kernels(lambda rows: Array3f(*(Float(row) for row in rows))) > 1
    np.testing.assert_array_equal(
        upload_vector(Array3f, memory[:300].reshape(3, 100)).numpy().ravel(), memory[:300]
    )
    np.testing.assert_array_equal(upload(UInt32, memory[:9]).numpy(), np.arange(9))
