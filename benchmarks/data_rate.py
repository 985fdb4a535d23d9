"""Seconds a material for 3.2 million queries of slices: the full setting of chen2024 (2 500 pairs × 1 280).

    python benchmarks/data_rate.py [--output benchmarks/results/data_rate.json]

Every material is a new draft with parameters of its own, so what compiling costs is in the figures, and
visibility is. One more material is split: into what compiling and each kind of kernel take, by the history
that Dr.Jit keeps. Operations are those of one texel of one slice in the kernel that evaluates the lobes; the
FMA peak is measured in the same run, so a machine that is shared shows.
"""

from __future__ import annotations

import argparse
import json
import statistics
import time
from pathlib import Path
from typing import Any

import drjit as dr
import numpy as np
from drjit.llvm.ad import Float
from point import fma_peak, operations_of

from loomlight.aggregate.queries import fabric_scale, query_set
from loomlight.aggregate.slices import FabricSlices
from loomlight.core.files import replacing
from loomlight.core.llvm import require_llvm
from loomlight.core.provenance import provenance
from loomlight.fabric import fabric_from_text
from loomlight.scattering.point import PointModel
from loomlight.yarn.geometry import YarnGeometry

PAIRS, FOOTPRINTS = 2500, 1280
LIGHTS, VIEWS = 64, 256
TEXELS = 128  # a side of the repeat, 32 a thread in a repeat of 4
WEAVES = ("plain", "twill 2/2", "twill 3/1", "basket 2/2")


def material(number: int) -> PointModel:
    """A fabric of its own: four threads each way, inclination, roughness and height scale drawn."""
    rng = np.random.default_rng(number)
    lines = [f'weave = "{WEAVES[number % len(WEAVES)]}"']
    for family in ("warp", "weft"):
        lines += [
            f"[{family}]",
            f"inclination_deg = {rng.uniform(10, 40):.3f}",
            f"height_scale = {rng.uniform(0.2, 1):.3f}",
            f"roughness = {rng.uniform(0.1, 0.8):.3f}",
            "translucency = 0.3",
        ]
    fabric = fabric_from_text("\n".join(lines))
    return PointModel(YarnGeometry(fabric.layout()), fabric.appearance())


def run(number: int) -> tuple[float, FabricSlices]:
    """Seconds for all queries of one material, from its parameters to the means."""
    start = time.perf_counter()
    model = material(number)
    layout = model.surface.layout  # type: ignore[attr-defined]  # these models stand on YarnGeometry
    queries = query_set(
        fabric_scale(layout), PAIRS, FOOTPRINTS, number, transmits=True, lights=LIGHTS, views=VIEWS
    )
    per_thread = TEXELS / layout.warp_on_top.shape[0]
    slices = FabricSlices(model, Float, per_thread, shadows="mapped")
    means = slices.box_means(queries.lights, queries.views, queries.pairs, queries.centres, queries.boxes)
    assert np.isfinite(means).all()
    return time.perf_counter() - start, slices


def operations(slices: FabricSlices) -> int:
    """Floating-point operations of one texel of one slice, in the kernels without loops."""
    light, view = [[0.3, 0.2, 0.9]], [[-0.4, 0.1, 0.8]]
    with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
        dr.kernel_history_clear()
        next(slices.batches(light, view, [[0, 0]]))
        texts = [entry["ir"].read() for entry in dr.kernel_history() if entry["type"] == dr.KernelType.JIT]
    lobes = [text for text in texts if "_cond:" not in text]
    return max((operations_of(text) for text in lobes), default=0)


def stages(number: int) -> dict[str, float]:
    """Seconds of kernels of one material by what they do, and of compiling them."""
    with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
        dr.kernel_history_clear()
        total, _ = run(number)
        history = dr.kernel_history()
    seconds = {
        "total": total,
        "compiling": 0.0,
        "searching": 0.0,
        "summing": 0.0,
        "reading": 0.0,
        "lobes": 0.0,
    }
    for entry in history:
        if entry["type"] != dr.KernelType.JIT:
            continue
        seconds["compiling"] += 1e-3 * (entry.get("backend_time", 0.0) + entry.get("codegen_time", 0.0))
        text = entry["ir"].read()
        kind = "searching" if "llvm.fma" in text else "summing"
        if "_cond:" not in text:
            kind = "lobes" if "llvm.sqrt" in text else "reading"
        seconds[kind] += 1e-3 * entry["execution_time"]
    return {name: round(value, 2) for name, value in seconds.items()}


def main() -> None:
    """Runs the benchmark and prints it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=None)
    parser.add_argument("--materials", type=int, default=6)
    # Dr.Jit keeps compiled kernels on disk: the same materials again would compile nothing.
    parser.add_argument("--seed", type=int, default=int(time.time()))
    arguments = parser.parse_args()
    require_llvm()
    peak = fma_peak()
    first, _ = run(arguments.seed)
    seconds, slices = [], None
    for number in range(arguments.materials):
        elapsed, slices = run(arguments.seed + 1 + number)
        seconds.append(elapsed)
    assert slices is not None
    counted = operations(slices)
    result: dict[str, Any] = {
        **provenance("python benchmarks/data_rate.py", Path(__file__).parent),
        "fma_peak_gflops": round(peak / 1e9, 1),
        "seed": arguments.seed,
        "queries": PAIRS * FOOTPRINTS,
        "texels_a_slice": slices.grid.texels,
        "seconds_first_material": round(first, 2),
        "seconds_a_material": round(statistics.median(seconds), 2),
        "seconds_slowest": round(max(seconds), 2),
        "stages": stages(arguments.seed + arguments.materials + 1),
        "operations_a_texel": counted,
        "share_of_fma_peak": round(
            counted * slices.grid.texels * PAIRS / statistics.median(seconds) / peak, 4
        ),
    }
    text = json.dumps(result, indent=2)
    print(text)
    if arguments.output is not None:
        with replacing(arguments.output) as temporary:
            temporary.write_text(text + "\n")


if __name__ == "__main__":
    main()
