"""Products of a network's weights with vectors of Dr.Jit arrays, in two ways.

Cooperative vectors compile at once, work in any call, and use the tensor units of GPUs. On CPUs Dr.Jit makes
loops of them that load and store a sum for every multiply-add, which is a third of what a core can do. There
the weights may instead be numbers in straight-line code, eight sums in registers at a time.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Protocol

import drjit as dr
import drjit.nn as nn
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import array_types, keep_order, larger
from loomlight.models.woven.architecture import SLOPE

Matrices = dict[str, NDArray[np.float32]]
# Sums that are in registers at once, and multiply-adds of each in a row: with so many neither additions that
# wait for each other nor loads of the vector cost time (measured: 4 sums 0.5, 8 0.8, 16 0.7 of the peak).
_SUMS = 8
_IN_A_ROW = 4
# Multiply-adds from which on a product is a function of its own.
_LARGE = 4096


class Layers(Protocol):
    """Weights that multiply vectors; a vector is what `product` returns, or numbers one by one."""

    def product(self, matrix: str, vector: Any, bias: str | None = None) -> Any:
        """A named matrix times a vector, and a named bias."""

    def added(self, one: Any, other: Any) -> Any:
        """The sum of two vectors."""

    def leaky(self, vector: Any) -> Any:
        """Leaky ReLU of a vector."""

    def outlined(self, function: Callable[..., list[Any]], *vectors: Sequence[Any]) -> list[Any]:
        """What a function of vectors returns, compiled on its own where that is faster."""


class CooperativeLayers:
    """Layers of cooperative vectors, on any backend."""

    def __init__(self, matrices: Matrices, float_type: type) -> None:
        tensor_type: Any = dr.tensor_t(float_type)
        tensors = [tensor_type(np.ascontiguousarray(values)) for values in matrices.values()]
        views: Any = nn.pack(tensors, layout="inference")
        self._parts: dict[str, Any] = dict(zip(matrices, views, strict=True))

    def product(self, matrix: str, vector: Any, bias: str | None = None) -> Any:
        """See `Layers`."""
        return nn.matvec(
            self._parts[matrix], _cooperative(vector), None if bias is None else self._parts[bias]
        )

    def added(self, one: Any, other: Any) -> Any:
        """See `Layers`."""
        return _cooperative(one) + _cooperative(other)

    def leaky(self, vector: Any) -> Any:
        """See `Layers`."""
        return larger(vector, vector * SLOPE)

    def outlined(self, function: Callable[..., list[Any]], *vectors: Sequence[Any]) -> list[Any]:
        """See `Layers`."""
        return function(*vectors)


class UnrolledLayers:
    """Layers whose weights are numbers in the code, for LLVM; a vector is a list of Floats.

    Attributes:
        only: number of the only function that calls choose from. Recordings have to be given it: where it was
            made while they were recorded, calls took another function now and then.
    """

    def __init__(self, matrices: Matrices, float_type: type) -> None:
        self._parts = {name: values.tolist() for name, values in matrices.items()}
        self._types = array_types(float_type)
        self.only: Any = dr.opaque(self._types.UInt32, 0)

    def product(self, matrix: str, vector: Any, bias: str | None = None) -> Any:
        """See `Layers`."""
        rows = self._parts[matrix]
        if len(rows) * len(rows[0]) < _LARGE:
            return self._summed(rows, bias, vector)
        # Functions twice as long take three times as long to compile.
        return self.outlined(lambda *values: self._summed(rows, bias, values), *vector)

    def _summed(self, rows: list[list[float]], bias: str | None, vector: Sequence[Any]) -> list[Any]:
        sums: list[Any] = [self._types.Float(0)] * len(rows) if bias is None else [*self._parts[bias]]
        for first in range(0, len(rows), _SUMS):
            block = range(first, min(first + _SUMS, len(rows)))
            for column, value in enumerate(vector):
                # Otherwise Dr.Jit would finish one sum after another.
                if column % _IN_A_ROW == 0:
                    keep_order(self._types.Float)
                for row in block:
                    sums[row] = dr.fma(value, rows[row][column], sums[row])
        return sums

    def added(self, one: Any, other: Any) -> Any:
        """See `Layers`."""
        return [a + b for a, b in zip(one, other, strict=True)]

    def leaky(self, vector: Any) -> Any:
        """See `Layers`."""
        return [larger(value, value * SLOPE) for value in vector]

    def outlined(self, function: Callable[..., list[Any]], *vectors: Any) -> list[Any]:
        """See `Layers`. Within the kernel's loop, LLVM would consider for every weight to load it beforehand,
        which takes three times as long to compile as all else."""
        found: Any = dr.switch(self.only, [function], *vectors, mode="symbolic")
        return list(found)


def _cooperative(vector: Any) -> Any:
    return vector if isinstance(vector, nn.CoopVec) else nn.CoopVec(*vector)
