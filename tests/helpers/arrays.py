"""Rows of NumPy as arrays of Dr.Jit's LLVM backend."""

from __future__ import annotations

from typing import Any

import numpy as np
from drjit.llvm.ad import Array2f, Array3f, Float
from numpy.typing import NDArray


def floats(values: NDArray[Any]) -> Float:
    """Numbers [n]."""
    return Float(np.ascontiguousarray(values, np.float32))


def pairs(rows: NDArray[Any]) -> Array2f:
    """Points [n, 2]."""
    return Array2f(np.ascontiguousarray(rows.T, np.float32))


def vectors(rows: NDArray[Any]) -> Array3f:
    """Vectors [n, 3]."""
    return Array3f(np.ascontiguousarray(rows.T, np.float32))


def numbers(rng: np.random.Generator, count: int) -> tuple[Float, Array2f]:
    """What samplers take: uniform numbers, and pairs of them."""
    return Float(rng.random(count, np.float32)), Array2f(rng.random((2, count), np.float32))
