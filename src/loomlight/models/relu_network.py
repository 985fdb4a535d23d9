"""Dense layers with ReLU between them, on any backend.

On CPUs a fused SIMD kernel evaluates them; on GPUs, for derivatives, and in symbolic calls Dr.Jit's
cooperative vectors do.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import drjit as dr
import drjit.nn as nn
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, FloatType
from loomlight.core.backend import array_types, maximum
from loomlight.core.simd import DenseLayer, FusedMlp, can_use_kernel

# Weights [outputs, inputs] and biases [outputs] of each layer.
Layers: TypeAlias = list[tuple[NDArray[np.float32], NDArray[np.float32]]]


class ReluNetwork:
    """A network on one backend, without an activation after its last layer."""

    def __init__(self, layers: Layers, float_type: FloatType) -> None:
        self._types = array_types(float_type)
        last = len(layers) - 1
        self._mlp = FusedMlp(
            [DenseLayer(w, b, "relu" if number < last else "none") for number, (w, b) in enumerate(layers)]
        )
        tensor: Any = dr.tensor_t(float_type)
        numbers = [tensor(np.ascontiguousarray(part)) for layer in layers for part in layer]
        views: Any = nn.pack(numbers, layout="inference")
        self._layers = list(zip(views[::2], views[1::2], strict=True))

    def __call__(self, inputs: Sequence[Float]) -> list[Float]:
        """The outputs of a query in each lane."""
        if can_use_kernel(self._types.Float, list(inputs)):
            return self._mlp.call(self._types.Float, list(inputs))
        values: Any = nn.CoopVec(*inputs)
        for number, (weight, bias) in enumerate(self._layers):
            values = nn.matvec(weight, values, bias)
            if number + 1 < len(self._layers):
                values = maximum(values, 0)
        return [*values]
