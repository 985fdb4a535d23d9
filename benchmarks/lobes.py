"""Evaluations of the prefiltered lobes a second, fetches included, against the machine.

    python benchmarks/lobes.py [--output benchmarks/results/lobes.json]

"far" are footprints that the groups alone answer; "as in pictures" are those of the query test, from 1/128
of the repeat to 5 repeats, sorted by size, as neighbouring pixels are alike; "at random" are the same
shuffled, so that every 16 lanes hold close-ups, which search yarns, beside far views. Floating-point
operations are counted in the kernel that Dr.Jit emits (a fused multiply-add is two, a root or a division
one); unpacking bytes takes whole numbers and is not counted. The FMA peak and the memory's bandwidth are
measured in the same run.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import Any

import drjit as dr
import numpy as np
from drjit.llvm.ad import Float, UInt32
from point import fma_peak, operations_of, timed

from loomlight.aggregate.queries import fabric_scale, query_set
from loomlight.assets.fabrics import fabric_of_path
from loomlight.core.backend import array_types
from loomlight.core.files import replacing
from loomlight.core.llvm import require_llvm
from loomlight.core.provenance import provenance
from loomlight.evaluation.predictions import query_arrays
from loomlight.models.lobes.estimate import half_vector
from loomlight.models.lobes.model import LobesModel

FABRICS = ("plain", "twill 3/1", "satin 8/3")
PAIRS, FOOTPRINTS = 512, 1024


def memory_bandwidth() -> float:
    """Bytes a second of reading and writing arrays far larger than the caches."""
    count = 1 << 26
    values = dr.arange(Float, count)
    dr.eval(values)

    def run() -> None:
        dr.eval(values + 1)

    return 8 * count / timed(run)


def operations(model: LobesModel, arrays: Any) -> int:
    """Floating-point operations of a query far away."""
    light, view, footprint = arrays
    types = array_types(Float)
    estimator = model.estimator(types)
    counts = []
    for words in (1, 2):
        place = estimator.place(footprint.centre, footprint.spread_side, view, view.z < 0)
        nodes, half = estimator.light_nodes(place, light), half_vector(light, view)
        total: Any = 0
        for word in range(words):
            number = dr.opaque(UInt32, word)
            seen = estimator.seen(place, number, number < estimator.warp_words)
            diffuse, specular = estimator.components(seen, place, nodes, number, light, half)
            total = total + diffuse + specular + sum(seen.weights)
        with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
            dr.kernel_history_clear()
            dr.eval(total)
            kernels = [entry for entry in dr.kernel_history() if entry["type"] == dr.KernelType.JIT]
        counts.append(sum(operations_of(kernel["ir"].read()) for kernel in kernels))
    return int(counts[0] + (model.tables.words - 1) * (counts[1] - counts[0]))


def rates(text: str, peak: float, bandwidth: float) -> dict[str, Any]:
    """Figures of one fabric."""
    fabric = fabric_of_path(text)
    model = LobesModel.for_fabric(fabric)
    queries = query_set(fabric_scale(fabric.layout()), PAIRS, FOOTPRINTS, 0)
    arrays = query_arrays(array_types(Float), queries)
    order = np.argsort(queries.sizes.ravel())
    far = order[queries.sizes.ravel()[order] > 1.3 * model.tables.size]
    rng = np.random.default_rng(0)
    found: dict[str, float] = {}
    for name, chosen in (
        ("far", np.resize(rng.permutation(far), order.size)),
        ("as in pictures", order),
        ("at random", rng.permutation(order)),
    ):
        picked = _picked(arrays, chosen)
        found[name] = order.size / timed(lambda picked=picked: dr.eval(model.evaluate(*picked)))
    each = operations(model, _picked(arrays, order))
    return {
        "millions_per_second": {name: round(rate / 1e6, 2) for name, rate in found.items()},
        "operations_far": each,
        "share_of_fma_peak_far": round(found["far"] * each / peak, 3),
        "bytes_fetched": model.bytes_fetched,
        "bytes_of_moments": model.tables.moments[0].nbytes,
        "share_of_bandwidth_far": round(found["far"] * model.bytes_fetched / bandwidth, 3),
        "table_megabytes": round(model.tables.nbytes / 1e6, 3),
    }


def _picked(arrays: Any, chosen: np.ndarray) -> Any:
    light, view, footprint = arrays
    index = UInt32(chosen.astype(np.uint32))
    centre, across, along = (
        dr.gather(type(part), part, index) for part in (footprint.centre, footprint.duv_dx, footprint.duv_dy)
    )
    picked = (
        dr.gather(type(light), light, index),
        dr.gather(type(view), view, index),
        type(footprint)(centre, across, along),
    )
    dr.eval(picked)
    return picked


def main() -> None:
    """Runs the benchmark and prints it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--drafts", nargs="*", default=[], help="further drafts or fabric files")
    parser.add_argument("--output", type=Path, default=None)
    arguments = parser.parse_args()
    require_llvm()
    peak, bandwidth = fma_peak(), memory_bandwidth()
    result: dict[str, Any] = {
        **provenance("python benchmarks/lobes.py", Path(__file__).parent),
        "fma_peak_gflops": round(peak / 1e9, 1),
        "bandwidth_gigabytes_per_second": round(bandwidth / 1e9, 1),
        "fabrics": {Path(text).stem: rates(text, peak, bandwidth) for text in (*FABRICS, *arguments.drafts)},
    }
    text = json.dumps(result, indent=2)
    print(text)
    if arguments.output is not None:
        with replacing(arguments.output) as temporary:
            temporary.write_text(text + "\n")


if __name__ == "__main__":
    main()
