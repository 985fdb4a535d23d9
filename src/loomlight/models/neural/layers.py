"""Dense layers by Dr.Jit's cooperative vectors.

Cooperative vectors work in symbolic calls, differentiate, and use the tensor cores of GPUs. On CPUs Dr.Jit
emits loops that load and store a sum for every multiply-add, a third of a core's peak at best: there,
`core.simd` replaces them.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import drjit as dr
import drjit.nn as nn
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import FloatType
from loomlight.core.backend import maximum
from loomlight.models.neural.architecture import LEAKY_SLOPE

Matrices: TypeAlias = dict[str, NDArray[np.float32]]
Vector: TypeAlias = Any


class CooperativeLayers:
    """Matrices and biases on one backend. A vector is a `CoopVec`, or a sequence of Floats."""

    def __init__(self, matrices: Matrices, float_type: FloatType) -> None:
        tensor_type: Any = dr.tensor_t(float_type)
        tensors = [tensor_type(np.ascontiguousarray(values)) for values in matrices.values()]
        views: Any = nn.pack(tensors, layout="inference")
        self._parts: dict[str, Any] = dict(zip(matrices, views, strict=True))

    def product(self, matrix: str, vector: Vector, bias: str | None = None) -> Vector:
        """The named matrix times a vector, plus the named bias."""
        return nn.matvec(
            self._parts[matrix], _cooperative(vector), None if bias is None else self._parts[bias]
        )

    def added(self, one: Vector, other: Vector) -> Vector:
        """The sum of two vectors."""
        return _cooperative(one) + _cooperative(other)

    def leaky(self, vector: Vector) -> Vector:
        """Leaky ReLU of every number."""
        return maximum(vector, vector * LEAKY_SLOPE)


def _cooperative(vector: Vector) -> Vector:
    return vector if isinstance(vector, nn.CoopVec) else nn.CoopVec(*vector)
