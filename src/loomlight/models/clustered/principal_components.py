"""Rows of numbers as a mean and a few principal components with whole coefficients (zhu2024 4.4).

The unit of a coefficient is within its component, so sums of coefficients are exact.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

# Rows that the components are computed of.
_TRAINING = 2048
# Rows that are held at once.
_BATCH = 8192
_POWERS = 3
_MAX = 127


@dataclass(frozen=True, eq=False)
class Compressed:
    """Compressed rows: coefficients @ basis[1:] + basis[0].

    Attributes:
        basis: the mean, and components times units [1 + rank, d].
        coefficients: whole numbers of −127 to 127 [n, rank].
    """

    basis: NDArray[np.float32]
    coefficients: NDArray[np.int8]


def compressed(
    rows_of: Callable[[NDArray[np.intp]], NDArray[np.float32]],
    count: int,
    rank: int,
    rng: np.random.Generator,
) -> Compressed:
    """Compresses rows with `rank` components, of which the first explain the most.

    Args:
        rows_of: the rows of so many numbers [n, d].
        count: of all rows.
    """
    training = rows_of(rng.permutation(count)[:_TRAINING])
    mean = training.mean(axis=0)
    axes = _principal_axes(training - mean, rank, rng)
    numbers = np.arange(count)
    parts = [(rows_of(numbers[first : first + _BATCH]) - mean) @ axes.T for first in range(0, count, _BATCH)]
    values = np.concatenate(parts)
    unit = np.maximum(np.abs(values).max(axis=0, initial=0) / _MAX, 1e-20)
    basis = np.concatenate([mean[None], axes * unit[:, None]]).astype(np.float32)
    return Compressed(basis, np.rint(values / unit).astype(np.int8))


def _principal_axes(rows: NDArray[np.float32], rank: int, rng: np.random.Generator) -> NDArray[np.float32]:
    """The first principal axes of rows [n, d], orthonormal [rank, d], by subspace iteration."""
    space = rng.standard_normal((rows.shape[1], rank + 4)).astype(np.float32)
    for _ in range(_POWERS):
        space, _ = np.linalg.qr(rows.T @ (rows @ space))
    _, _, axes = np.linalg.svd(rows @ space, full_matrices=False)
    found: NDArray[np.float32] = (axes[:rank] @ space.T).astype(np.float32)
    return found
