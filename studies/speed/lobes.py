"""Evaluations of the prefiltered lobes a second, fetches included, against the machine.

"far" are footprints of the prefiltered regime alone, 4 to 100 threads wide; "as in pictures" are rows of
adjacent footprints, each row of one size from 1/20 to 100 threads; "far at random" and "at random" are the
same shuffled: memory access is random, and every packet of 16 lanes has point-sampled footprints, which
search yarns, beside prefiltered ones. Each draft's time of a query is compared with plain weave's in paired
runs. Floating-point operations are counted in the kernel that Dr.Jit emits (a fused multiply-add is two, a
root or a division one); integer operations, which unpack bytes, are not counted. The FMA peak and the memory
bandwidth are measured in the same run. Rates are of the fastest of several runs, as others use the machine;
fractions and ratios are medians.
"""

from __future__ import annotations

import statistics
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import drjit as dr
import numpy as np
from drjit.llvm.ad import Float, UInt32

from loomlight.aggregate.queries import QuerySet, fabric_scale, query_set
from loomlight.core.backend import array_types
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.query_benchmark import query_arrays
from loomlight.evaluation.table import Table
from loomlight.fabric.fabric import Fabric
from loomlight.models.lobes.model import LobesModel
from loomlight.models.lobes.prefiltered import half_vector
from loomlight.sources.load import fabric_of_path
from studies.harness.study import Figures, Found, Run, Study, listed, names
from studies.instruments.machine import fma_peak, memory_bandwidth, operations_of
from studies.instruments.timing import launched_kernels, timed


def operations(model: LobesModel, arrays: Any) -> int:
    """Floating-point operations of a prefiltered query."""
    light, view, footprint = arrays
    types = array_types(Float)
    lobes, _ = model.on_backend(types)
    counts = []
    for pairs in (1, 2):
        at = lobes.lookup(footprint, view, view.z < 0)
        nodes, half = lobes.light_nodes(at, light), half_vector(light, view)
        total: Any = 0
        for pair in range(pairs):
            number = dr.opaque(UInt32, pair)
            packs = lobes.seen_packs(at, number)
            for pack, sums in zip(
                packs, lobes.components(packs, at, nodes, number, light, half), strict=True
            ):
                total = total + sum(sums) + sum(pack.weights)
        kernels = launched_kernels(partial(dr.eval, total))
        counts.append(sum(operations_of(kernel["ir"].read()) for kernel in kernels))
    return int(counts[0] + (model.tables.packs // 2 - 1) * (counts[1] - counts[0]))


def rows_of_pixels(fabric: Fabric, low: float, high: float, shuffled: bool, settings: LobesSpeed) -> Any:
    """Lights, views and footprints in rows of adjacent squares, one pair of directions and one size a row.

    Args:
        low, high: sides of the smallest and the largest, in threads.
        shuffled: in no order.
    """
    rows, across = settings.rows, settings.across
    scale = fabric_scale(fabric.layout())
    rng = np.random.default_rng(0)
    queries = query_set(scale, rows, across, 0)
    side = scale.thread * np.geomspace(low, high, rows)[:, None]
    start = rng.random((rows, 1, 2)) * scale.extent
    step = np.stack([np.arange(across) * side, np.zeros((rows, across))], axis=-1)
    sizes = np.broadcast_to(side, (rows, across))
    arrays = query_arrays(
        array_types(Float), QuerySet(queries.lights, queries.views, queries.pairs, start + step, sizes)
    )
    if shuffled:
        light, view, footprint = arrays
        order = UInt32(rng.permutation(rows * across).astype(np.uint32))
        arrays = (
            dr.gather(type(light), light, order),
            dr.gather(type(view), view, order),
            Footprint(
                *(
                    dr.gather(type(part), part, order)
                    for part in (footprint.centre, footprint.duv_dx, footprint.duv_dy)
                )
            ),
        )
    dr.eval(arrays)
    return arrays


KINDS = {
    "far": (4, 100, False),
    "as in pictures": (0.05, 100, False),
    "far at random": (4, 100, True),
    "at random": (0.05, 100, True),
}


def evaluated(model: LobesModel, arrays: Any) -> None:
    """Evaluates all queries and waits for the device."""
    light, view, footprint = arrays
    dr.eval(model.at(view, footprint).value(light))
    dr.sync_thread()


def rates(
    text: str, plain: LobesModel, peak: float, bandwidth: float, settings: LobesSpeed
) -> dict[str, Any]:
    """Figures of one fabric."""
    fabric = fabric_of_path(text)
    model = LobesModel.for_source(fabric)
    per_second, usual, ratios = {}, {}, {}
    count = settings.rows * settings.across
    for name, kind in KINDS.items():
        own, other = (rows_of_pixels(chosen.fabric, *kind, settings) for chosen in (model, plain))
        seconds: list[tuple[float, float]] = []
        for _ in range(settings.repeats):
            pair = []
            for chosen, arrays in ((model, own), (plain, other)):
                pair.append(timed(partial(evaluated, chosen, arrays))[1])
            seconds.append((pair[0], pair[1]))
        # The first two compile and warm up.
        per_second[name] = count / min(first for first, _ in seconds[2:])
        usual[name] = count / statistics.median(first for first, _ in seconds[2:])
        ratios[name] = statistics.median(first / second for first, second in seconds[2:])
    each = operations(model, rows_of_pixels(fabric, 4, 100, False, settings))
    return {
        "millions_per_second": {name: round(rate / 1e6, 2) for name, rate in per_second.items()},
        "time_against_plain": {name: round(ratio, 3) for name, ratio in ratios.items()},
        "operations_far": each,
        "share_of_fma_peak_far": round(usual["far"] * each / peak, 3),
        "bytes_fetched": model.bytes_fetched,
        "bytes_of_moments": model.tables.moments[0].nbytes,
        "share_of_bandwidth_far": round(usual["far"] * model.bytes_fetched / bandwidth, 3),
        "table_megabytes": round(model.tables.nbytes / 1e6, 3),
    }


@dataclass(frozen=True)
class LobesSpeed(Settings):
    fabrics: str = names("plain,twill 3/1,satin 8/3", "Weaves, drafts or fabric files.")
    rows: int = setting(512, "Rows of adjacent footprints.", low=4)
    across: int = setting(1024, "Footprints of a row.", low=4)
    repeats: int = setting(60, "Paired runs.", low=3)


def measure(settings: LobesSpeed, run: Run) -> Found:
    """Rates of all fabrics against the machine's peak."""
    require_llvm()
    peak, bandwidth = fma_peak(), memory_bandwidth()
    plain = LobesModel.for_source(fabric_of_path("plain"))
    return Found(
        {
            "fma_peak_gflops": round(peak / 1e9, 1),
            "bandwidth_gigabytes_per_second": round(bandwidth / 1e9, 1),
            "fabrics": {
                Path(text).name if Path(text).suffix else text: rates(text, plain, peak, bandwidth, settings)
                for text in listed(settings.fabrics)
            },
        }
    )


def tables(figures: Figures) -> list[Table]:
    """Rates by fabric and how footprints lie."""
    kinds = list(KINDS)
    columns = [
        *(f"million/s, {kind}" for kind in kinds),
        "of the FMA peak, far",
        "bytes fetched",
        "table, MB",
    ]
    keys = ("share_of_fma_peak_far", "bytes_fetched", "table_megabytes")
    rows = {
        name: [*(found["millions_per_second"][kind] for kind in kinds), *(found[key] for key in keys)]
        for name, found in figures["fabrics"].items()
    }
    note = (
        f"FMA peak {figures['fma_peak_gflops']} GFLOP/s, "
        f"memory {figures['bandwidth_gigabytes_per_second']} GB/s."
    )
    return [Table("Queries of `lobes`", columns, rows, note)]


STUDY = Study(
    "speed/lobes",
    "evaluations of the prefiltered lobes a second, fetches included, against the machine",
    LobesSpeed(),
    measure,
    tables,
    stands_on=("lobes cost",),
    small={"fabrics": "plain", "rows": 8, "across": 8, "repeats": 3},
)
