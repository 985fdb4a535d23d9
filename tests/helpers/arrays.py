"""Rows of NumPy as arrays of Dr.Jit's LLVM backend.

They are copied: kernels that read NumPy's memory are compiled for its alignment, which is chance.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from drjit.llvm.ad import Array2f, Array3f, Float
from numpy.typing import NDArray

from loomlight.core.backend import upload, upload_vector


def floats(values: NDArray[Any]) -> Float:
    """Numbers [n]."""
    return upload(Float, values)


def pairs(rows: NDArray[Any]) -> Array2f:
    """Points [n, 2]."""
    return upload_vector(Array2f, rows.T)


def vectors(rows: NDArray[Any]) -> Array3f:
    """Vectors [n, 3]."""
    return upload_vector(Array3f, rows.T)


def numbers(rng: np.random.Generator, count: int) -> tuple[Float, Array2f]:
    """What samplers take: uniform numbers, and pairs of them."""
    return upload(Float, rng.random(count, np.float32)), upload_vector(
        Array2f, rng.random((2, count), np.float32)
    )
