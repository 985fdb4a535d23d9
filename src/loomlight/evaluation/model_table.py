"""All models of one fabric in one table: error by band, samples to equal error, cost, size, time to bake."""

from __future__ import annotations

import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path

from loomlight.aggregate.queries import BANDS
from loomlight.evaluation.equal_error import samples_for
from loomlight.evaluation.query_benchmark import MONTE_CARLO, QueryBenchmark, samples_name
from loomlight.evaluation.table import Cell, Table
from loomlight.fabric.fabric import Fabric
from loomlight.models.interface import Model
from loomlight.models.registry import make_model, model_class
from loomlight.sources.loom_file import write_loom

COLUMNS = (
    "nMAE",
    *BANDS,
    "point samples of equal error",
    "multiply-adds",
    "bytes fetched",
    "bytes of the .loom",
    "seconds to bake",
)


@dataclass(frozen=True)
class Baking:
    """What it took to make a model.

    Attributes:
        seconds: of processor time, all threads; of trained models the training.
        size: bytes of the model's `.loom`.
    """

    seconds: float
    size: int


@dataclass
class BakedModels:
    """Models by name and fabric; those that are trained are made once, however many scenes show them.

    Attributes:
        bakings: what each model took, by its name and the fabric's.
    """

    bakings: dict[tuple[str, str], Baking] = field(default_factory=dict)
    _trained: dict[tuple[str, int], tuple[Fabric, Model]] = field(default_factory=dict)

    def make(self, name: str, fabric: Fabric) -> Model:
        """The model of a fabric.

        Raises:
            InputError: no such model, or one that does not take the fabric.
            MissingDependencyError: a package that it needs is missing.
        """
        key = name, id(fabric)
        if key in self._trained:
            return self._trained[key][1]
        start = time.process_time()
        model = make_model(name, fabric)
        seconds = time.process_time() - start
        if (name, fabric.name) not in self.bakings:
            self.bakings[name, fabric.name] = Baking(seconds, _loom_size(model))
        if model_class(name).trains:
            # The fabric is kept too, so that no other one gets its id.
            self._trained[key] = fabric, model
        return model


def model_table(fabric: Fabric, benchmark: QueryBenchmark, baked: BakedModels) -> Table:
    """A row for each model that was baked, from a query benchmark of that fabric alone.

    Samples of equal error are those of the point model over the footprint whose nMAE is the model's, between
    and beyond 1, 3 and 16 on logarithmic scales.
    """
    note = (
        f"{fabric.name}, {benchmark.queries} queries of grey reflection; processor seconds, the first "
        "time in a process; kernels that a model compiles when it is first rendered are in no column."
    )
    table = Table("All models", list(COLUMNS), note=note)
    counts = [count for count in MONTE_CARLO if samples_name(count) in benchmark.rows]
    errors = [benchmark.rows[samples_name(count)].metric("reflection") for count in counts]
    for name, row in benchmark.rows.items():
        baking = baked.bakings.get((name, fabric.name))
        if baking is None:
            continue
        error = row.metric("reflection")
        equal: Cell = samples_for(error, counts, errors) if len(counts) > 1 and error > 0 else None
        cells: list[Cell] = [error, *(row.metric("reflection", band) for band in BANDS)]
        table.rows[name] = [*cells, equal, *(row.cost or (None, None)), baking.size, baking.seconds]
    return table


def _loom_size(model: Model) -> int:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "model.loom"
        write_loom(file, model.to_loom())
        return file.stat().st_size
