"""Small kernels for tests, and the targets that this processor can run."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from loomlight.core.simd import CompiledKernel, KernelBuilder, Operand, SimdTarget, SimdValue, host_target

# Those of other processors too: LLVM splits vectors that are too wide, and spills what has no register.
TARGETS = [host_target(), SimdTarget(4, 16), SimdTarget(8, 16), SimdTarget(16, 32)]


def computed(
    emit: Callable[[KernelBuilder, Sequence[SimdValue]], Sequence[Operand]],
    *inputs: np.ndarray,
    outputs: int = 1,
    target: SimdTarget | None = None,
) -> list[np.ndarray]:
    """Outputs of a kernel that `emit` writes for one vector from its inputs."""
    kernel = KernelBuilder("computed", target or host_target(), len(inputs), outputs)
    with kernel.each_block(), kernel.each_vector():
        values = emit(kernel, [kernel.load_input(number) for number in range(len(inputs))])
        assert len(values) == outputs
        for number, value in enumerate(values):
            kernel.store_output(number, value)
    arrays = [np.ascontiguousarray(array, np.float32) for array in inputs]
    actual = [np.full(len(arrays[0]), np.nan, np.float32) for _ in range(outputs)]
    CompiledKernel(kernel).launch(len(arrays[0]), arrays, actual, [])
    return actual
