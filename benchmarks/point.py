"""Full evaluations of the point model a second (geometry, visibility, all lobes), against the machine.

    python benchmarks/point.py [--output benchmarks/results/point.json]

The floating-point operations of an evaluation are counted in the kernel that Dr.Jit emits (a fused
multiply-add is two, a root or a division one); the FMA peak is measured in the same run with independent
chains of multiply-adds. Every other figure is the median of several timings, so ratios hold on noisy
machines.
"""

from __future__ import annotations

import argparse
import json
import math
import re
import statistics
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import drjit as dr
import numpy as np
from drjit.llvm.ad import Array3f, Bool, Float

from loomlight.core.lane_code import Code, Vectors
from loomlight.core.lane_values import Lanes
from loomlight.core.llvm import require_llvm
from loomlight.core.machine_code import MachineCode, cores, vectors
from loomlight.core.provenance import provenance
from loomlight.evaluation.table import write_json
from loomlight.fabric import fabric_from_text
from loomlight.scattering.appearance import Sheen
from loomlight.scattering.point import PointModel
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.horizon import HorizonMap

COUNT = 1 << 22
REPEATS = 9
# Multiply-adds of a chain.
TURNS = 200_000
_OPERATIONS = re.compile(r"= (?:fast )?(fadd|fsub|fmul|fdiv|fneg|call [^@]*@llvm\.(\w+))")
_TWO = {"fma", "fmuladd"}
_ONE = {"sqrt", "minnum", "maxnum", "floor", "fabs", "minimum", "maximum", "ceil", "round", "rint"}


def operations_of(kernel: str) -> int:
    """Floating-point operations a lane in the text of one LLVM kernel without loops."""
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


def timed(run: Callable[[], None]) -> float:
    """Median seconds of a run, after two that do not count."""
    return statistics.median(_seconds(run))


def fastest(run: Callable[[], None]) -> float:
    """Seconds of the fastest run: others use the machine, and a peak is what it can do."""
    return min(_seconds(run))


def _seconds(run: Callable[[], None]) -> list[float]:
    seconds = []
    for index in range(REPEATS + 2):
        start = time.perf_counter()
        run()
        dr.sync_thread()
        if index >= 2:
            seconds.append(time.perf_counter() - start)
    return seconds


def fma_peak() -> float:
    """Floating-point operations a second of independent multiply-add chains on all cores.

    They are machine code, a short loop. Kernels of Dr.Jit's in their place, long lines of multiply-adds,
    reached two thirds of it on a Xeon.
    """
    code, blocks = _chains(), 32 * cores()
    queries = blocks * code.vectors.block
    compiled, start = MachineCode(code), np.zeros(queries, np.float32)
    found = np.empty_like(start)
    seconds = fastest(lambda: compiled.run(queries, [start], [found], []))
    return 2 * _chain_count(code.vectors) * TURNS * code.vectors.lanes * blocks / seconds


def _chain_count(of: Vectors) -> int:
    """As many chains as registers hold with room to spare: fewer wait for each other on some processors."""
    return of.registers * 3 // 4


def _chains() -> Code:
    code = Code("chains", vectors())
    with code.blocks():
        first = [code.given(0) + number for number in range(_chain_count(code.vectors))]
        before = code.builder.block
        with code.loop(TURNS):
            values = [code.builder.phi(chain.value.type) for chain in first]
            for value, chain in zip(values, first, strict=True):
                value.add_incoming(chain.value, before)
            following = [code.fma(Lanes(code, value), 0.999, 0.001) for value in values]
            for value, chain in zip(values, following, strict=True):
                value.add_incoming(chain.value, code.builder.block)
        total = following[0]
        for chain in following[1:]:
            total = total + chain
        code.answer(1, total)
    return code


def evaluations(model: PointModel, searched: bool) -> tuple[float, int | None]:
    """Evaluations a second, and operations in one (None where the kernel has loops)."""
    rng = np.random.default_rng(0)
    width, height = model.surface.size

    def directions() -> Any:
        z = rng.uniform(0.05, 1, COUNT)
        azimuth = rng.uniform(0, 2 * math.pi, COUNT)
        radius = np.sqrt(1 - z**2)
        return Array3f(Float(radius * np.cos(azimuth)), Float(radius * np.sin(azimuth)), Float(z))

    x, y = Float(rng.uniform(0, width, COUNT)), Float(rng.uniform(0, height, COUNT))
    light, view = directions(), directions()
    front, hole = dr.opaque(Bool, False, COUNT), dr.opaque(Bool, False, COUNT)
    dr.eval(x, y, light, view)

    def run() -> None:
        point = model.locate(x, y, view) if searched else model.at(x, y, front, hole)
        dr.eval(model.evaluate(point, light, view))

    seconds = timed(run)
    if searched:
        return COUNT / seconds, None
    with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
        dr.kernel_history_clear()
        run()
        kernels = [entry for entry in dr.kernel_history() if entry["type"] == dr.KernelType.JIT]
    return COUNT / seconds, sum(operations_of(kernel["ir"].read()) for kernel in kernels)


def main() -> None:
    """Runs the benchmark and prints it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=None)
    arguments = parser.parse_args()
    require_llvm()
    peak = fma_peak()
    result: dict[str, Any] = {
        **provenance("python benchmarks/point.py", Path(__file__).parent),
        "fma_peak_gflops": round(peak / 1e9, 1),
        "fabrics": {},
    }
    for text in ("plain", "twill 3/1", "satin 8/3"):
        fabric = fabric_from_text(text)
        layout, appearance = fabric.layout(), fabric.appearance()
        appearance = type(appearance)(appearance.warp, appearance.weft, sheen=Sheen(0.3, 0.4))
        geometry = YarnGeometry(layout)
        table = HorizonMap(geometry, (256, 256), Float)
        rate, operations = evaluations(PointModel(geometry, appearance, horizon=table), searched=False)
        exact, _ = evaluations(PointModel(geometry, appearance), searched=True)
        assert operations is not None
        result["fabrics"][text] = {
            "tabulated_millions_per_second": round(rate / 1e6, 2),
            "operations": operations,
            "share_of_fma_peak": round(rate * operations / peak, 3),
            "exact_search_millions_per_second": round(exact / 1e6, 2),
        }
    print(json.dumps(result, indent=2))
    if arguments.output is not None:
        write_json(arguments.output, result, digits=None)


if __name__ == "__main__":
    main()
