"""Products of a network's weights with vectors of Dr.Jit arrays, by cooperative vectors.

They compile at once, work in any call, and use the tensor units of GPUs. On CPUs Dr.Jit makes loops of them
that load and store a sum for every multiply-add, which is a third of what a core can do at best.
"""

from __future__ import annotations

from typing import Any

import drjit as dr
import drjit.nn as nn
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import maximum
from loomlight.models.woven.architecture import SLOPE

Matrices = dict[str, NDArray[np.float32]]


class CooperativeLayers:
    """Weights that multiply vectors; a vector is what `product` returns, or numbers one by one."""

    def __init__(self, matrices: Matrices, float_type: type) -> None:
        tensor_type: Any = dr.tensor_t(float_type)
        tensors = [tensor_type(np.ascontiguousarray(values)) for values in matrices.values()]
        views: Any = nn.pack(tensors, layout="inference")
        self._parts: dict[str, Any] = dict(zip(matrices, views, strict=True))

    def product(self, matrix: str, vector: Any, bias: str | None = None) -> Any:
        """A named matrix times a vector, and a named bias."""
        return nn.matvec(
            self._parts[matrix], _cooperative(vector), None if bias is None else self._parts[bias]
        )

    def added(self, one: Any, other: Any) -> Any:
        """The sum of two vectors."""
        return _cooperative(one) + _cooperative(other)

    def leaky(self, vector: Any) -> Any:
        """Leaky ReLU of a vector."""
        return maximum(vector, vector * SLOPE)


def _cooperative(vector: Any) -> Any:
    return vector if isinstance(vector, nn.CoopVec) else nn.CoopVec(*vector)
