"""Calls kernels on Dr.Jit arrays of the LLVM backend, without copying them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import drjit as dr

from loomlight.core.arrays import Float, FloatType
from loomlight.core.simd.jit import Floats


def is_host_type(float_type: FloatType) -> bool:
    """True if kernels can read arrays of a type: float32 in the memory of the host."""
    return dr.backend_v(float_type) == dr.JitBackend.LLVM and dr.type_v(float_type) == dr.VarType.Float32


def can_use_kernel(float_type: FloatType, inputs: Any) -> bool:
    """True if a kernel can be called now: not while Dr.Jit traces or freezes, nor for derivatives.

    Args:
        inputs: Dr.Jit arrays in any nesting of lists, tuples and vectors.
    """
    return (
        is_host_type(float_type)
        and dr.width(inputs) > 0
        and not dr.flag(dr.JitFlag.SymbolicScope)
        and not dr.flag(dr.JitFlag.FreezingScope)
        and not dr.grad_enabled(inputs)
    )


def call_kernel(
    float_type: FloatType,
    inputs: Any,
    output_count: int,
    launch: Callable[[Sequence[Floats], Sequence[Floats]], None],
) -> list[Float]:
    """Evaluates inputs, launches a kernel on their memory, and returns its outputs.

    Args:
        inputs: Dr.Jit arrays in any nesting, of one width or 1; masks become 1 and 0.
        launch: takes input arrays and output arrays, float32 [width] each.
    """
    width = dr.width(inputs)
    arrays = _evaluate(_flatten(inputs), width)
    outputs = [dr.empty(float_type, width) for _ in range(output_count)]
    # Kernels of Dr.Jit that still run may read memory that `outputs` reuses, or write `arrays`.
    dr.sync_thread()
    launch([array.numpy() for array in arrays], [array.numpy() for array in outputs])
    return outputs


def _flatten(inputs: Any) -> list[Float]:
    if isinstance(inputs, list | tuple) or dr.depth_v(inputs) > 1:
        return [array for part in inputs for array in _flatten(part)]
    if not dr.is_mask_v(inputs):
        return [inputs]
    float_type: Any = dr.float32_array_t(inputs)
    return [dr.select(inputs, float_type(1), float_type(0))]


def _evaluate(arrays: list[Float], width: int) -> list[Float]:
    """The arrays in memory, those of width 1 repeated."""
    wide = [
        type(array)(array)
        if dr.width(array) == width
        else dr.gather(type(array), array, dr.zeros(dr.uint32_array_t(array), width))
        for array in arrays
    ]
    dr.make_opaque(wide)
    return wide
