"""Tables of lobes baked by compute kernels beside those of the Python bake: error, equal bytes, time.

Error is the query benchmark's nMAE of grey f·cos against its truth. Times are of bakes after the first,
which compiles kernels: seconds until the tables are read back, and CPU seconds, in which a software adapter
computes.
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from loomlight.core.settings import Settings, setting
from loomlight.evaluation.query_benchmark import (
    FOOTPRINTS,
    HeldOut,
    Predictor,
    model_predictor,
    run_query_benchmark,
)
from loomlight.evaluation.table import Table
from loomlight.fabric import load_fabric
from loomlight.fabric.fabric import Fabric
from loomlight.models.lobes.hemisphere import NODES
from loomlight.models.lobes.model import DEFAULT_GROUPS, LobesModel, tables_of
from loomlight.models.lobes.tables import MOMENTS, LobeTables
from loomlight.models.lobes.visibility import JOINT_FACTORS, JOINT_NODES
from loomlight.realtime.bake import FabricBuffers
from loomlight.realtime.device import default_adapter
from studies.harness.study import Figures, Found, Run, Study, listed, names
from studies.instruments.held_out import held_out_fabrics

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
        tables = _read_tables(buffers)
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


def _read_tables(buffers: FabricBuffers) -> LobeTables:
    """The tables that kernels baked of the only fabric; waits for the device."""
    plan, packed, adapter = buffers.plans[0], buffers.packed, default_adapter()
    record = adapter.read(buffers.buffers["fabrics"], np.uint8, packed.fabrics.nbytes)
    lobes = record.view(packed.fabrics.dtype)[0]["lobes"]
    words = adapter.read(buffers.buffers["words"], np.uint32, packed.words.size)
    parts = {
        name: words[int(lobes[name]) :][:size].view(np.uint8)
        for name, size in LobeTables.word_counts(plan.sizes).items()
    }
    packs, nodes = plan.sizes["packs"], plan.sizes["face_nodes"]
    coverage = np.zeros((2, nodes, 4 * (packs + 1)), np.uint8)
    coverage[..., : 4 * packs] = parts["coverage"].reshape(2, nodes, 4 * packs)
    coverage[..., 4 * packs] = parts["coverage_holes"][: 2 * nodes].reshape(2, nodes)
    return LobeTables(
        base_size=plan.base_size,
        levels=plan.levels,
        coverage=coverage,
        projected_area=parts["projected_area"].reshape(2, NODES, 4 * (packs + 1)),
        light_visibility=parts["light_visibility"].reshape(2, 2, NODES, 4 * packs),
        irradiance=parts["irradiance"].reshape(2, 2, NODES, 4 * packs),
        moments=parts["moments"].view(np.float32).reshape(2, 4 * packs, MOMENTS),
        hole_weight=np.array([lobes["front_hole_weight"], lobes["back_hole_weight"]], np.float32),
        warp_packs=np.array([lobes["front_warp_packs"], lobes["back_warp_packs"]], np.int64),
        joint=parts["joint"].view(np.int16).reshape(2, 2, 2, JOINT_NODES, JOINT_FACTORS),
    )


@dataclass(frozen=True)
class BakeSpeed(Settings):
    files: str = names("", "Fabric files in the place of held-out fabrics.")
    fabrics: int = setting(18, "Held-out fabrics.", low=1, high=24)
    pairs: int = setting(128, "Pairs of directions of each.", low=1)
    footprints: int = setting(FOOTPRINTS, "Footprints of a pair.", low=1)


def measure(settings: BakeSpeed, run: Run) -> Found:
    """Errors by fabric of both bakes."""
    bench = Bench()
    predictors: dict[str, Predictor] = {
        "python": model_predictor(bench.by_python),
        "kernels": model_predictor(bench.by_kernels),
    }
    fabrics = [HeldOut(Path(file).stem, load_fabric(file), False, False) for file in listed(settings.files)]
    fabrics = fabrics or held_out_fabrics(settings.fabrics)
    result = run_query_benchmark(
        predictors, fabrics, pairs=settings.pairs, footprints=settings.footprints, monte_carlo=()
    )
    wall, cpu = np.median(np.array(bench.seconds[1:] or bench.seconds), axis=0)
    return Found(
        {
            "adapter": default_adapter().name,
            "nmae": {name: row.metric("reflection") for name, row in result.rows.items()},
            "nmae_by_fabric": {name: row.fabrics for name, row in result.rows.items()},
            "equal_bytes": bench.equal,
            "kernels": bench.kernels,
            "bake_seconds": float(wall),
            "bake_cpu_seconds": float(cpu),
        }
    )


def tables(figures: Figures) -> list[Table]:
    """Errors of both bakes, and what the one by kernels takes."""
    equal, nmae = figures["equal_bytes"], figures["nmae"]
    row = [nmae["python"], nmae["kernels"], min(equal), figures["bake_seconds"], figures["bake_cpu_seconds"]]
    columns = ["nMAE, Python", "nMAE, kernels", "equal bytes, at least", "s", "processor s"]
    return [Table("Bakes by kernels", columns, {figures["adapter"]: row})]


STUDY = Study(
    "speed/bake",
    "tables of lobes baked by compute kernels beside those of the Python bake",
    BakeSpeed(),
    measure,
    tables,
    stands_on=("lobes", "shaders"),
    small={"fabrics": 1, "pairs": 4, "footprints": 4},
)
