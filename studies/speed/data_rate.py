"""Seconds a material of chen2024: 3.2 million queries, from the material's number to their answers.

One material of each of the paper's seven weaves, of a seed of its own, with the queries of one side (BRDF):
50 × 50 pairs of directions over 1 280 footprints; visibility and compiling are in the figures. The mean
weighs weaves as the 465 materials do. Processor seconds are those of all threads, half of which is what two
quiet cores would take; the FMA peak before and after shows how quiet they were. One more material is split
into what compiling and each kind of kernel take, by the history that Dr.Jit keeps. The small case is what
training draws: 256 pairs × 256 footprints, 128² texels, of fabrics that are all new. Operations are those of
one texel of one slice in the kernel that evaluates the lobes.
"""

from __future__ import annotations

import statistics
import time
from collections import Counter
from dataclasses import dataclass, replace
from functools import partial

import drjit as dr
import numpy as np
from drjit.llvm.ad import Float

from loomlight.aggregate.queries import fabric_scale, query_set
from loomlight.aggregate.slices import FabricSlices
from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.fabric import Fabric
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from studies.harness.study import Figures, Found, Run, Study
from studies.instruments.machine import fma_peak, operations_of
from studies.instruments.timing import launched_kernels, timed
from studies.papers.chen2024.materials import MATERIALS, paper_material
from studies.papers.chen2024.queries import material_queries, slice_means

FULL = 3.2e6
TEXELS = 128  # a side of the repeat, in the small case
SMALL_PAIRS, SMALL_FOOTPRINTS, SMALL_DIRECTIONS = 256, 256, 32
# Weaves of which one more material is split into what it takes.
SPLIT = ("plain", "twill 8×8")


def material(number: int, seed: int) -> tuple[float, float]:
    """Seconds, and processor seconds of all threads, for 3.2 million queries of one material."""
    start, processor = time.perf_counter(), time.process_time()
    fabric = paper_material(number, seed)
    queries = material_queries(number, seed)
    queries = replace(queries, pairs=queries.pairs[~queries.transmits])
    assert np.isfinite(slice_means(fabric, queries, Float)).all()
    scale = FULL / queries.count
    return (time.perf_counter() - start) * scale, (time.process_time() - processor) * scale


def answer_few(fabric: Fabric, seed: int) -> None:
    """Answers 65 536 queries of a fabric, both sides of the cloth."""
    layout = fabric.layout()
    queries = query_set(
        fabric_scale(layout),
        SMALL_PAIRS,
        SMALL_FOOTPRINTS,
        seed,
        transmits=True,
        lights=SMALL_DIRECTIONS,
        views=SMALL_DIRECTIONS,
    )
    model = YarnScattering(YarnGeometry(layout), fabric.appearance())
    slices = FabricSlices(model, Float, TEXELS / max(layout.warp_on_top.shape), shadows="mapped")
    slices.box_means(queries.lights, queries.views, queries.pairs, queries.centres, queries.boxes)


def operations() -> int:
    """Floating-point operations of one texel of one slice, in the kernels without loops."""
    fabric = paper_material(0)
    model = YarnScattering(YarnGeometry(fabric.layout()), fabric.appearance())
    slices = FabricSlices(model, Float, shadows="mapped")
    light, view = [[0.3, 0.2, 0.9]], [[-0.4, 0.1, 0.8]]
    kernels = launched_kernels(lambda: next(slices.batches(light, view, [[0, 0]])))
    texts = [kernel["ir"].read() for kernel in kernels]
    lobes = [text for text in texts if "_cond:" not in text]
    return max((operations_of(text) for text in lobes), default=0)


def stages(number: int, seed: int) -> dict[str, float]:
    """Seconds of kernels of one material by what they do, and of compiling them."""
    with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
        dr.kernel_history_clear()
        _, total = timed(lambda: material(number, seed))
        history = dr.kernel_history()
    seconds = dict.fromkeys(("compiling", "searching", "lobes", "summing", "reading"), 0.0)
    for entry in history:
        kind = "summing"  # block prefix sums
        if entry["type"] == dr.KernelType.JIT:
            seconds["compiling"] += 1e-3 * (entry.get("backend_time", 0.0) + entry.get("codegen_time", 0.0))
            text = entry["ir"].read()
            if "_cond:" in text:
                kind = "searching" if "llvm.fma.v16f32" in text else "summing"
            else:
                kind = "lobes" if "llvm.sqrt" in text else "reading"
        seconds[kind] += 1e-3 * entry["execution_time"]
    return {name: round(value, 2) for name, value in {"total": total, **seconds}.items()}


@dataclass(frozen=True)
class DataRate(Settings):
    seed: int | None = setting(None, "Of the materials.", low=0, otherwise="of the time: new materials")
    few: int = setting(12, "Fabrics of the small case.", low=2)
    full: bool = setting(True, "Answers the queries of whole materials.")


def measure(settings: DataRate, run: Run) -> Found:
    """Seconds of all weaves, of the small case, and where they go."""
    require_llvm()
    seed = int(time.time()) if settings.seed is None else settings.seed
    counts = Counter(each.weave for each in MATERIALS)
    numbers = {weave: [each.weave for each in MATERIALS].index(weave) for weave in counts}
    peaks = [fma_peak()]
    few = [paper_material(37 * index, seed) for index in range(settings.few)]
    small = [timed(partial(answer_few, fabric, seed))[1] for fabric in few]
    timings = {weave: material(number, seed) for weave, number in numbers.items() if settings.full}
    peaks.append(fma_peak())
    figures: Figures = {
        "fma_peak_gflops_before_and_after": [round(peak / 1e9, 1) for peak in peaks],
        "seed": seed,
        "queries": int(FULL),
        "seconds_a_material": {weave: round(wall, 2) for weave, (wall, _) in timings.items()},
        "processor_seconds_a_material": {weave: round(used, 2) for weave, (_, used) in timings.items()},
        "stages": {weave: stages(numbers[weave] + 1, seed) for weave in SPLIT if settings.full},
        "small_queries": SMALL_PAIRS * SMALL_FOOTPRINTS,
        "small_seconds_first": round(small[0], 3),
        "small_seconds_following": round(statistics.median(small[1:]), 3),
        "operations_a_texel": operations(),
    }
    if timings:
        mean, processor = (
            sum(timings[weave][kind] * count for weave, count in counts.items()) / len(MATERIALS)
            for kind in (0, 1)
        )
        figures |= {
            "seconds_mean_of_465": round(mean, 2),
            "processor_seconds_mean_of_465": round(processor, 2),
        }
    return Found(figures)


def tables(figures: Figures) -> list[Table]:
    """Seconds by weave, and of stages."""
    walls, used = figures["seconds_a_material"], figures["processor_seconds_a_material"]
    rows = {weave: [walls[weave], used[weave]] for weave in walls}
    if "seconds_mean_of_465" in figures:
        rows["mean of the 465"] = [figures["seconds_mean_of_465"], figures["processor_seconds_mean_of_465"]]
    made = [Table("A material of 3.2 million queries", ["s", "processor s"], rows)]
    if figures["stages"]:
        stages = {weave: list(found.values()) for weave, found in figures["stages"].items()}
        made.append(Table("Where seconds go", list(next(iter(figures["stages"].values()))), stages))
    small = [
        figures["small_seconds_first"],
        figures["small_seconds_following"],
        figures["operations_a_texel"],
    ]
    note = f"{figures['small_queries']} queries of a fabric that is new."
    columns = ["first, s", "following, s", "operations a texel"]
    made.append(Table("The small case", columns, {"a fabric": small}, note))
    return [table for table in made if table.rows]


STUDY = Study(
    "speed/data_rate",
    "seconds a material of chen2024: 3.2 million queries, from its number to their answers",
    DataRate(),
    measure,
    tables,
    stands_on=("point cost",),
    small={"few": 2, "full": False},
)
