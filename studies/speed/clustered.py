"""What clustered control variates cost: by footprint, to bake and to store.

- Footprints: processor seconds of a million answers whose footprints are one texel (1/256 of the repeat),
  one repeat and 64 repeats wide, in turns; the dearest over the cheapest has to be at most 1.15.
- Baking: seconds, processor seconds and the growth of memory, a fabric in a process of its own; bars: 60 s,
  4 GB.
- Storage: bytes of the `.loom` file and of its tensors, and the mean squared difference of its answers from
  the Monte Carlo reference, over random cases; by clusters and rank as figure 3 of zhu2024 has it.

Any model of the registry can be measured; clusters and rank are options of `clustered`.
"""

from __future__ import annotations

import os
import resource
import tempfile
import time
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import drjit as dr
import numpy as np
from drjit.llvm.ad import Array2f, Array3f, Float

from loomlight.core.errors import InputError
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, declared, setting
from loomlight.evaluation.table import Table
from loomlight.fabric import load_fabric
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.read import edited_fabric
from loomlight.models.interface import Model
from loomlight.models.registry import MODELS, make_model, model_class, options_of
from loomlight.sources.loom_file import write_loom
from studies.accuracy.unbiased import Cases, Means, model_means, random_cases, reference_means
from studies.harness.study import Figures, Found, Run, Study, example, listed, listed_numbers, names
from studies.instruments.directions import above
from studies.instruments.processes import in_own_process
from studies.instruments.timing import least_times

WIDTHS = {"1 texel": 1 / 256, "1 tile": 1.0, "64 tiles": 64.0}
TURNS = 5
BAR_FOOTPRINT, BAR_BAKE, BAR_MEMORY = 1.15, 60.0, 4e9
_SEED = 5


def cost_by_footprint(model: Model, queries: int) -> dict[str, float]:
    """Processor nanoseconds of an answer by the width of footprints in repeats, least of turns."""
    rng = np.random.default_rng(_SEED)
    repeat = np.asarray(model.source.repeat_mm)
    view, light = (Array3f(above(rng, queries, 0.1).astype(np.float32)) for _ in range(2))
    # From every corner of the repeat: positions are read at random, as bytes of far tables are.
    centre = Array2f((rng.random((2, queries)) * repeat[:, None]).astype(np.float32))
    widths = {name: dr.opaque(Float, width) for name, width in WIDTHS.items()}
    dr.eval(view, light, centre)

    def answers(width: Float) -> None:
        across = Array2f(width * float(repeat[0]), 0)
        along = Array2f(0, width * float(repeat[1]))
        dr.eval(model.at(view, Footprint(centre, across, along)).value(light))
        dr.sync_thread()

    for width in widths.values():
        answers(width)
    times = least_times([partial(answers, width) for width in widths.values()], TURNS)
    return {name: 1e9 * spent.cpu_seconds / queries for name, spent in zip(widths, times, strict=True)}


def bake(fabric: str, model: str) -> dict[str, float]:
    """Bakes, and measures this process: kernels are compiled within, as for a user's first bake."""
    cloth = load_fabric(example(fabric))
    require_llvm()
    model_class(model)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    start, processor = time.perf_counter(), time.process_time()
    make_model(model, cloth)
    return {
        "seconds": time.perf_counter() - start,
        "cpu_seconds": time.process_time() - processor,
        # The system counts kilobytes.
        "bytes_more": 1024.0 * (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before),
    }


def stored_bytes(model: Model) -> int:
    """Size of the model's `.loom` file."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "one.loom")
        write_loom(file, model.to_loom())
        return os.path.getsize(file)


def storage(
    fabric: Fabric, name: str, options: Mapping[str, int], cases: Cases, truth: Means, repeats: int
) -> dict[str, float]:
    """Bytes of a baked model, and the error and the noise of its answers in some cases."""
    model = make_model(name, fabric, options_of(name, options))
    found = model_means(model, cases, repeats, _SEED)
    noise = repeats * found.variance
    return {
        "loom_bytes": stored_bytes(model),
        "squared_error_of_mean": float(((found.mean - truth.mean) ** 2).mean()),
        "variance_of_an_answer": float(noise.mean()),
        "mean": float(truth.mean.mean()),
    }


def storage_curve(fabric: str, settings: ClusteredSpeed) -> dict[str, dict[str, float]]:
    """A fabric by clusters and rank; what a model has no option for, or refuses, is left out."""
    names = set(declared(model_class(settings.model).options_class))
    grid: list[dict[str, int]] = [{}]
    if {"clusters", "rank"} <= names:
        grid += [
            {"clusters": int(clusters), "rank": int(rank)}
            for clusters in listed_numbers("clusters", settings.clusters)
            for rank in listed_numbers("ranks", settings.ranks)
        ]
    # The reference has neither sheen nor variation.
    plain = {"sheen.strength": 0.0, "variation.fibre_noise": 0.0, "variation.colour_noise": 0.0}
    cloth = edited_fabric(load_fabric(example(fabric)), plain)
    cases = random_cases(cloth, settings.cases, _SEED)
    truth = reference_means(cloth, cases, settings.samples, _SEED)
    found = {}
    for chosen in grid:
        label = ", ".join(f"{key} {value}" for key, value in chosen.items()) or "default"
        with suppress(InputError):
            found[label] = storage(cloth, settings.model, chosen, cases, truth, settings.repeats)
    return found


@dataclass(frozen=True)
class ClusteredSpeed(Settings):
    model: str = setting("clustered", "That is measured.", choices=tuple(MODELS))
    fabrics: str = names("denim,silk-satin,linen", "Example fabrics.")
    clusters: str = setting("4,8", "Of the storage curve.", metavar="N,…")
    ranks: str = setting("1,4", "Of the storage curve.", metavar="N,…")
    cases: int = setting(16, "Of each fabric's error.", low=1)
    samples: int = setting(1 << 15, "Of the reference, a case.", low=2)
    repeats: int = setting(256, "Answers of a case.", low=2)
    queries: int = setting(1 << 20, "Answers that are timed.", low=1)


def measure(settings: ClusteredSpeed, run: Run) -> Found:
    """All of it, and the bars that are missed."""
    require_llvm()
    costs, bakes, missed = {}, {}, []
    found = run.each({name: partial(of_fabric, name, settings) for name in listed(settings.fabrics)})
    for fabric, figures in found.items():
        bakes[fabric], costs[fabric] = figures["bake"], figures["cost"]
        ratio = costs[fabric]["ratio"]
        missed += [f"{fabric}: footprints {ratio:.3g}"] if ratio > BAR_FOOTPRINT else []
        # By processor seconds over two cores: other programs run beside this one.
        missed += [f"{fabric}: bake"] if bakes[fabric]["cpu_seconds"] > 2 * BAR_BAKE else []
        missed += [f"{fabric}: memory"] if bakes[fabric]["bytes_more"] > BAR_MEMORY else []
    return Found(
        {
            "model": settings.model,
            "nanoseconds_by_footprint": costs,
            "bar_footprint": BAR_FOOTPRINT,
            "bakes": bakes,
            "bar_bake_seconds": BAR_BAKE,
            "bar_bytes": BAR_MEMORY,
            "storage": {fabric: figures["storage"] for fabric, figures in found.items()},
            "missed": missed,
        }
    )


def of_fabric(fabric: str, settings: ClusteredSpeed) -> Figures:
    """What a fabric costs to bake, by footprint, and to store."""
    baked = in_own_process(bake, fabric, settings.model)
    cost = cost_by_footprint(make_model(settings.model, load_fabric(example(fabric))), settings.queries)
    cost["ratio"] = max(cost.values()) / min(cost.values())
    return {"bake": baked, "cost": cost, "storage": storage_curve(fabric, settings)}


def tables(figures: Figures) -> list[Table]:
    """Costs and bakes by fabric, and files by clusters and rank."""
    costs = figures["nanoseconds_by_footprint"]
    rows = {
        fabric: [
            figures["bakes"][fabric]["cpu_seconds"],
            figures["bakes"][fabric]["bytes_more"] / 1e6,
            *(cost[width] for width in WIDTHS),
            cost["ratio"],
        ]
        for fabric, cost in costs.items()
    }
    columns = [
        "bake, processor s",
        "memory, MB",
        *(f"ns, {width}" for width in WIDTHS),
        "dearest over cheapest",
    ]
    files = {
        f"{fabric}, {label}": [
            found["loom_bytes"] / 1e6,
            found["squared_error_of_mean"],
            found["variance_of_an_answer"],
        ]
        for fabric, curve in figures["storage"].items()
        for label, found in curve.items()
    }
    kept = ["`.loom`, MB", "squared error of the mean", "variance of an answer"]
    return [
        Table(f"What `{figures['model']}` costs", columns, rows),
        Table("Files, and errors of answers", kept, files),
    ]


STUDY = Study(
    "speed/clustered",
    "what clustered control variates cost: by footprint, to bake and to store",
    ClusteredSpeed(),
    measure,
    tables,
    stands_on=("clustered", "clustered cost"),
    small={
        "model": "samples",
        "fabrics": "denim",
        "cases": 2,
        "samples": 1 << 8,
        "repeats": 4,
        "queries": 1 << 10,
    },
)
