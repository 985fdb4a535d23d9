"""Tables of lobes baked by compute kernels beside those of the Python bake: error, equal bytes, time.

    python -m benchmarks.bake [FABRIC.toml …] [--fabrics 18 --pairs 128] [--output FILE.json]

Error is the query benchmark's nMAE of grey f·cos against its truth. Times are of bakes after the first,
which compiles kernels: seconds until the tables are read back, and CPU seconds, in which a software adapter
computes.
"""

from __future__ import annotations

import time
from argparse import ArgumentParser, Namespace
from pathlib import Path

import numpy as np

from benchmarks.harness import Figures, run
from loomlight.evaluation.held_out import HeldOut, held_out_fabrics
from loomlight.evaluation.predictions import Predictor, model_predictor
from loomlight.evaluation.query_benchmark import run_query_benchmark
from loomlight.fabric import load_fabric
from loomlight.fabric.fabric import Fabric
from loomlight.models.lobes.model import DEFAULT_GROUPS, LobesModel, tables_of
from loomlight.models.lobes.tables import LobeTables
from loomlight.realtime.device import default_adapter
from loomlight.realtime.fabric_buffers import FabricBuffers

_BYTES = ("coverage", "projected_area", "light_visibility", "irradiance")


class Bench:
    """Predictions from both bakes of the same fabrics, and what the bakes took."""

    def __init__(self) -> None:
        self._tables: dict[str, LobeTables] = {}
        self.equal: list[float] = []
        self.kernels: list[int] = []
        self.seconds: list[tuple[float, float]] = []

    def by_python(self, fabric: Fabric) -> LobesModel:
        """The model as it is baked everywhere else."""
        return LobesModel(fabric, self._remember(fabric, tables_of(fabric, DEFAULT_GROUPS)))

    def by_kernels(self, fabric: Fabric) -> LobesModel:
        """The model of tables baked on the adapter."""
        look = fabric.layout(), fabric.appearance()
        start = time.perf_counter(), time.process_time()
        buffers = FabricBuffers(default_adapter(), [look])
        tables = buffers.read_tables(0)
        self.seconds.append((time.perf_counter() - start[0], time.process_time() - start[1]))
        self.kernels.append(buffers.dispatches)
        reference = self._tables[fabric.name]
        pairs = [(getattr(tables, name), getattr(reference, name)) for name in _BYTES]
        same = sum(int(np.count_nonzero(found == expected)) for found, expected in pairs)
        self.equal.append(same / sum(found.size for found, _ in pairs))
        return LobesModel(fabric, tables)

    def _remember(self, fabric: Fabric, tables: LobeTables) -> LobeTables:
        self._tables[fabric.name] = tables
        return tables


def measure(options: Namespace) -> Figures:
    """Errors by fabric of both bakes."""
    bench = Bench()
    predictors: dict[str, Predictor] = {
        "python": model_predictor(bench.by_python),
        "kernels": model_predictor(bench.by_kernels),
    }
    fabrics = [HeldOut(Path(file).stem, load_fabric(file), False, False) for file in options.files]
    fabrics = fabrics or held_out_fabrics(options.fabrics)
    result = run_query_benchmark(predictors, fabrics, pairs=options.pairs, monte_carlo=())
    wall, cpu = np.median(np.array(bench.seconds[1:] or bench.seconds), axis=0)
    return {
        "adapter": default_adapter().name,
        "nmae": {name: row.metric("reflection") for name, row in result.rows.items()},
        "nmae_by_fabric": {name: row.fabrics for name, row in result.rows.items()},
        "equal_bytes": bench.equal,
        "kernels": bench.kernels,
        "bake_seconds": float(wall),
        "bake_cpu_seconds": float(cpu),
    }


def _add_options(parser: ArgumentParser) -> None:
    parser.add_argument("files", nargs="*", help="fabric files in place of held-out fabrics")
    parser.add_argument("--fabrics", type=int, default=18, help="held-out fabrics")
    parser.add_argument("--pairs", type=int, default=128, help="pairs of directions of each")


if __name__ == "__main__":
    run(measure, _add_options)
