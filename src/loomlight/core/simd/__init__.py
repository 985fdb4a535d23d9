"""SIMD kernels for networks on CPUs; see README.md. Only `loomlight.models` may use them."""

from __future__ import annotations

import numpy as np

from loomlight.core.simd.drjit_bridge import call_kernel, can_use_kernel, is_host_type
from loomlight.core.simd.fused_mlp import (
    Activation,
    DenseLayer,
    FusedMlp,
    PackedLayer,
    PackedLayers,
    emit_activation,
    emit_dense,
)
from loomlight.core.simd.jit import CompiledKernel, Floats, aligned, host_target
from loomlight.core.simd.kernel_builder import BlockBuffer, KernelBuilder, SimdTarget
from loomlight.core.simd.math import SimdMath
from loomlight.core.simd.values import Index, Operand, SimdValue, Uniform, UniformBuffer

__all__ = [
    "Activation",
    "BlockBuffer",
    "CompiledKernel",
    "DenseLayer",
    "Floats",
    "FusedMlp",
    "Index",
    "KernelBuilder",
    "Operand",
    "PackedLayer",
    "PackedLayers",
    "SimdMath",
    "SimdTarget",
    "SimdValue",
    "Uniform",
    "UniformBuffer",
    "aligned",
    "call_kernel",
    "can_use_kernel",
    "emit_activation",
    "emit_dense",
    "host_target",
    "is_host_type",
    "kernels_work",
]


def kernels_work() -> bool:
    """Compiles and launches a small kernel, and returns whether its outputs are right."""
    kernel = KernelBuilder("self_test", host_target(), inputs=1, outputs=1)
    with kernel.each_block(), kernel.each_vector():
        kernel.store_output(0, kernel.load_input(0) + 1)
    inputs = np.arange(100, dtype=np.float32)
    outputs = np.zeros_like(inputs)
    CompiledKernel(kernel).launch(len(inputs), [inputs], [outputs], [])
    return bool((outputs == inputs + 1).all())
