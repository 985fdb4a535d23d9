"""Compiles kernels for the host processor with LLVM, keeps the object files, and launches on all cores."""

from __future__ import annotations

import ctypes
import hashlib
from collections.abc import Sequence
from functools import cache
from typing import Any, TypeAlias

import llvmlite
import llvmlite.binding as llvm
import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import LoomlightError
from loomlight.core.files import cache_folder, replacing
from loomlight.core.parallel_map import core_count, parallel_map
from loomlight.core.simd.kernel_builder import KernelBuilder, SimdTarget

Floats: TypeAlias = NDArray[np.float32]

_OPTIMISATION = 2  # as of clang -O2
_CACHE_LINE = 16  # floats
# The folder of object files in the cache; each begins with the SHA-256 of the rest.
_FOLDER, _DIGEST = "simd_kernels", 32


@cache
def host_target() -> SimdTarget:
    """The vector unit of this processor: AVX-512, AVX2 with FMA, or 128-bit vectors."""
    try:
        features = llvm.get_host_cpu_features()
    except RuntimeError:  # LLVM cannot tell on this platform
        features = {}
    if features.get("avx512f"):
        return SimdTarget(16, 32)
    if features.get("avx2") and features.get("fma"):
        return SimdTarget(8, 16)
    return SimdTarget(4, 32 if llvm.get_default_triple().startswith(("aarch64", "arm64")) else 16)


def aligned(values: Floats) -> Floats:
    """A copy that begins at a cache line, so that no aligned vector of it straddles two."""
    room = np.empty(values.size + _CACHE_LINE, np.float32)
    first = -(room.ctypes.data // room.itemsize) % _CACHE_LINE
    copy = room[first : first + values.size].reshape(values.shape)
    copy[:] = values
    return copy


class CompiledKernel:
    """A kernel in machine code."""

    def __init__(self, kernel: KernelBuilder) -> None:
        self._signature = kernel.inputs, kernel.outputs
        self._block_size = kernel.target.block_size
        self._engine = _compile(kernel)  # owns the code
        signature = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int64, ctypes.c_void_p)
        self._function = signature(self._engine.get_function_address(kernel.name))

    def launch(
        self, count: int, inputs: Sequence[Floats], outputs: Sequence[Floats], uniforms: Sequence[Floats]
    ) -> None:
        """Computes outputs of so many queries, on all cores.

        Args:
            inputs: float32 [count], contiguous, as many as the kernel was built for.
            outputs: the same, to be written.
            uniforms: contiguous float32 buffers of any shape.

        Raises:
            ValueError: if an array is not of that kind.
        """
        if (len(inputs), len(outputs)) != self._signature:
            raise ValueError(f"the kernel takes (inputs, outputs) = {self._signature}")
        for array in (*inputs, *outputs):
            if array.shape != (count,) or array.dtype != np.float32 or not array.flags.c_contiguous:
                raise ValueError(f"inputs and outputs must be contiguous float32 arrays of {count} numbers")
        full = count // self._block_size
        if full:
            self._run_on_all_cores(full, [*inputs, *outputs, *uniforms])
        done = full * self._block_size
        if done < count:
            # The last block is padded with copies of the last query.
            last_inputs = [_pad(array[done:], self._block_size) for array in inputs]
            last_outputs = [np.empty(self._block_size, np.float32) for _ in outputs]
            self._run_on_all_cores(1, [*last_inputs, *last_outputs, *uniforms])
            for array, last in zip(outputs, last_outputs, strict=True):
                array[done:] = last[: count - done]

    def _run_on_all_cores(self, blocks: int, arrays: Sequence[Floats]) -> None:
        addresses = np.array([array.ctypes.data for array in arrays], np.uint64)
        next_block = np.zeros(1, np.int64)

        def run() -> None:
            self._function(next_block.ctypes.data, blocks, addresses.ctypes.data)

        # Threads share the counter of blocks: one on a busy core takes fewer and delays nobody.
        parallel_map(lambda _: run(), range(min(blocks, core_count())))


@cache
def _llvm_target() -> Any:
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    return llvm.Target.from_default_triple()


def _compile(kernel: KernelBuilder) -> Any:
    """The LLVM engine that holds the machine code, from the cache if it is there."""
    target = _llvm_target()
    try:
        features = llvm.get_host_cpu_features().flatten()
    except RuntimeError:
        features = ""
    processor, text = llvm.get_host_cpu_name(), str(kernel.module)
    machine = target.create_target_machine(cpu=processor, features=features, opt=_OPTIMISATION, jit=True)
    parts = [llvmlite.__version__, str(llvm.llvm_version_info), processor, features, str(_OPTIMISATION), text]
    key = hashlib.sha256("\0".join(parts).encode()).hexdigest()
    code = _read_cached(key)
    if code is None:
        code = _optimise(text, machine)
        _write_cached(key, code)
    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), machine)
    engine.add_object_file(llvm.ObjectFileRef.from_data(code))
    engine.finalize_object()
    return engine


def _optimise(text: str, machine: Any) -> bytes:
    """An object file of LLVM IR."""
    module = llvm.parse_assembly(text)
    module.verify()
    # Kernels are vectors already, and their loops are as long as they should be.
    options = llvm.create_pipeline_tuning_options(speed_level=_OPTIMISATION)
    options.loop_unrolling = options.loop_vectorization = options.slp_vectorization = False
    passes = llvm.create_pass_builder(machine, options)
    passes.getModulePassManager().run(module, passes)
    code: bytes = machine.emit_object(module)
    return code


# The decoder of `neural` takes a second to compile, so object files are kept.


def _read_cached(key: str) -> bytes | None:
    """The object file of a key, unless it is missing or damaged."""
    try:
        stored = (cache_folder(_FOLDER) / key).read_bytes()
    except OSError:
        return None
    digest, code = stored[:_DIGEST], stored[_DIGEST:]
    return code if hashlib.sha256(code).digest() == digest else None


def _write_cached(key: str, code: bytes) -> None:
    """Stores an object file; without a writable cache it is compiled again next time."""
    folder = cache_folder(_FOLDER)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with replacing(folder / key) as temporary:
            temporary.write_bytes(hashlib.sha256(code).digest() + code)
    except (OSError, LoomlightError):
        return


def _pad(values: Floats, count: int) -> Floats:
    """[n] extended to [count] by the last value."""
    return np.concatenate([values, np.repeat(values[-1:], count - len(values))])
