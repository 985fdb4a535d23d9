"""Peaks of the machine, to compare rates with: FMA peak and memory bandwidth; counts of operations."""

from __future__ import annotations

import re
import statistics
from collections.abc import Callable

import drjit as dr
import numpy as np
from drjit.llvm.ad import Float

from loomlight.core.parallel_map import core_count
from loomlight.core.simd import (
    CompiledKernel,
    KernelBuilder,
    SimdTarget,
    SimdValue,
    host_target,
)
from studies.instruments.timing import timed

REPEATS = 9
# Multiply-adds of a chain.
TURNS = 200_000
_OPERATIONS = re.compile(r"= (?:fast )?(fadd|fsub|fmul|fdiv|fneg|call [^@]*@llvm\.(\w+))")
_TWO = {"fma", "fmuladd"}
_ONE = {"sqrt", "minnum", "maxnum", "floor", "fabs", "minimum", "maximum", "ceil", "round", "rint"}


def operations_of(kernel: str) -> int:
    """Floating-point operations a lane in the text of one LLVM kernel without loops.

    A fused multiply-add is two, a root or a division one.
    """
    total = 0
    for line in kernel.splitlines():
        match = _OPERATIONS.search(line.strip())
        if match is None:
            continue
        name = match.group(2)
        if name is None:
            total += match.group(1) != "fneg"
        elif name in _TWO:
            total += 2
        elif name in _ONE:
            total += 1
    return total


def median_seconds(run: Callable[[], object]) -> float:
    """Median seconds of a run, after two warm-up runs."""
    return statistics.median(_seconds(run))


def least_seconds(run: Callable[[], object]) -> float:
    """Seconds of the fastest run: others use the machine, and a peak is what it can do."""
    return min(_seconds(run))


def _seconds(run: Callable[[], object]) -> list[float]:
    def whole() -> None:
        run()
        dr.sync_thread()

    return [timed(whole)[1] for _ in range(REPEATS + 2)][2:]


def memory_bandwidth() -> float:
    """Bytes a second of reading and writing arrays far larger than the caches."""
    count = 1 << 26
    values = dr.arange(Float, count)
    dr.eval(values)
    return 8 * count / median_seconds(lambda: dr.eval(values + 1))


def fma_peak() -> float:
    """Floating-point operations a second of independent multiply-add chains on all cores.

    They are a SIMD kernel, a short loop. Kernels of Dr.Jit's in their place, long lines of multiply-adds,
    reached two thirds of it on a Xeon.
    """
    kernel, blocks = _chains(), 32 * core_count()
    target, queries = kernel.target, blocks * kernel.target.block_size
    compiled, start = CompiledKernel(kernel), np.zeros(queries, np.float32)
    outputs = np.empty_like(start)
    seconds = least_seconds(lambda: compiled.launch(queries, [start], [outputs], []))
    return 2 * _chain_count(target) * TURNS * target.width * blocks / seconds


def _chain_count(target: SimdTarget) -> int:
    """As many chains as registers hold with room to spare: fewer wait for each other on some processors."""
    return target.registers * 3 // 4


def _chains() -> KernelBuilder:
    kernel = KernelBuilder("chains", host_target(), inputs=1, outputs=1)
    with kernel.each_block():
        first = [kernel.load_input(0) + number for number in range(_chain_count(kernel.target))]
        before = kernel.ir.block
        with kernel.loop(TURNS):
            values = [kernel.ir.phi(chain.value.type) for chain in first]
            for value, chain in zip(values, first, strict=True):
                value.add_incoming(chain.value, before)
            following = [kernel.math.fma(SimdValue(kernel, value), 0.999, 0.001) for value in values]
            for value, chain in zip(values, following, strict=True):
                value.add_incoming(chain.value, kernel.ir.block)
        total = following[0]
        for chain in following[1:]:
            total = total + chain
        kernel.store_output(0, total)
    return kernel
