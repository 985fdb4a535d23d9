"""What clustered control variates cost: by footprint, to bake and to store.

    python -m studies.speed.clustered [--model clustered] [--output FILE.json]

- Footprints: processor seconds of a million answers whose footprints are one texel (1/256 of the repeat),
  one repeat and 64 repeats wide, in turns; the dearest over the cheapest has to be at most 1.15.
- Baking: seconds, processor seconds and the growth of memory, a fabric in a process of its own; bars: 60 s,
  4 GB.
- Storage: bytes of the `.loom` file and of its tensors, and the mean squared difference of its answers from
  the Monte Carlo reference, over random cases; by clusters and rank as figure 3 of zhu2024 has it.

Any model of the registry can be measured; clusters and rank are options of `clustered`.
"""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from argparse import ArgumentParser, Namespace
from collections.abc import Mapping
from functools import partial
from pathlib import Path

import drjit as dr
import numpy as np
from drjit.llvm.ad import Array2f, Array3f, Float

from loomlight.core.errors import InputError
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.core.settings import declared
from loomlight.fabric import load_fabric
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.read import edited_fabric
from loomlight.models.interface import Model
from loomlight.models.registry import make_model, model_class, options_of
from loomlight.sources.loom_file import write_loom
from studies.accuracy.unbiased import Cases, Means, model_means, random_cases, reference_means
from studies.instruments.harness import REPOSITORY, Figures, run
from studies.instruments.timing import least_times

EXAMPLES = REPOSITORY / "examples"
FABRICS = ("denim", "silk-satin", "linen", "organza", "wool-houndstooth", "damask")
WIDTHS = {"1 texel": 1 / 256, "1 tile": 1.0, "64 tiles": 64.0}
QUERIES, TURNS = 1 << 20, 5
BAR_FOOTPRINT, BAR_BAKE, BAR_MEMORY = 1.15, 60.0, 4e9
_SEED = 5


def directions(rng: np.random.Generator, count: int) -> Array3f:
    """Unit vectors above the cloth."""
    z = rng.uniform(0.1, 1, count)
    azimuth = rng.uniform(0, 2 * np.pi, count)
    radius = np.sqrt(1 - z * z)
    return Array3f(np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), z]).astype(np.float32))


def cost_by_footprint(model: Model, queries: int = QUERIES) -> dict[str, float]:
    """Processor nanoseconds of an answer by the width of footprints in repeats, least of turns."""
    rng = np.random.default_rng(_SEED)
    repeat = np.asarray(model.source.repeat_mm)
    view, light = directions(rng, queries), directions(rng, queries)
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


def bake_cost(fabric: str, model: str) -> dict[str, float]:
    """Seconds and growth of memory of a bake, in a process of its own."""
    command = [sys.executable, "-m", "studies.speed.clustered", "--bake", fabric, "--model", model]
    done = subprocess.run(command, capture_output=True, text=True, check=True, cwd=REPOSITORY)
    found: dict[str, float] = json.loads(done.stdout.splitlines()[-1])
    return found


def bake(fabric: str, model: str) -> dict[str, float]:
    """Bakes, and measures this process: kernels are compiled within, as for a user's first bake."""
    cloth = load_fabric(EXAMPLES / f"{fabric}.toml")
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


def storage_curve(options: Namespace) -> dict[str, dict[str, dict[str, float]]]:
    """Every fabric by clusters and rank; what a model has no option for, or refuses, is left out."""
    names = set(declared(model_class(options.model).options_class))
    grid: list[dict[str, int]] = [{}]
    if {"clusters", "rank"} <= names:
        grid += [
            {"clusters": int(clusters), "rank": int(rank)}
            for clusters in options.clusters.split(",")
            for rank in options.ranks.split(",")
        ]
    found: dict[str, dict[str, dict[str, float]]] = {}
    for fabric in options.fabrics.split(","):
        # The reference has neither sheen nor variation.
        plain = {"sheen.strength": 0.0, "variation.fibre_noise": 0.0, "variation.colour_noise": 0.0}
        cloth = edited_fabric(load_fabric(EXAMPLES / f"{fabric}.toml"), plain)
        cases = random_cases(cloth, options.cases, _SEED)
        truth = reference_means(cloth, cases, options.samples, _SEED)
        found[fabric] = {}
        for chosen in grid:
            label = ", ".join(f"{key} {value}" for key, value in chosen.items()) or "default"
            try:
                found[fabric][label] = storage(cloth, options.model, chosen, cases, truth, options.repeats)
            except InputError as error:
                print(f"{fabric}, {label}: {error}", flush=True)
                continue
            print(fabric, label, found[fabric][label], flush=True)
    return found


def add_options(parser: ArgumentParser) -> None:
    """Which model, which fabrics, which tables."""
    parser.add_argument("--model", default="clustered")
    parser.add_argument("--fabrics", default=",".join(FABRICS), help="names of examples")
    parser.add_argument("--clusters", default="4,8,16", help="of the storage curve")
    parser.add_argument("--ranks", default="1,2,4", help="of the storage curve")
    parser.add_argument("--cases", type=int, default=16, help="of each fabric's error")
    parser.add_argument("--samples", type=int, default=1 << 15, help="of the reference, a case")
    parser.add_argument("--repeats", type=int, default=256, help="answers a case")
    parser.add_argument("--bake", default=None, metavar="FABRIC", help="bakes one and prints what it cost")


def measure(options: Namespace) -> Figures:
    """All of it, and the bars that are missed."""
    require_llvm()
    costs, bakes, missed = {}, {}, []
    for fabric in options.fabrics.split(","):
        try:
            bakes[fabric] = bake_cost(fabric, options.model)
        except subprocess.CalledProcessError as error:
            print(f"{fabric}: {error.stderr.splitlines()[-1]}", flush=True)
            continue
        costs[fabric] = cost_by_footprint(make_model(options.model, load_fabric(EXAMPLES / f"{fabric}.toml")))
        ratio = max(costs[fabric].values()) / min(costs[fabric].values())
        costs[fabric]["ratio"] = ratio
        print(fabric, bakes[fabric], costs[fabric], flush=True)
        missed += [f"{fabric}: footprints {ratio:.3g}"] if ratio > BAR_FOOTPRINT else []
        # By processor seconds over two cores: other programs run beside this one.
        missed += [f"{fabric}: bake"] if bakes[fabric]["cpu_seconds"] > 2 * BAR_BAKE else []
        missed += [f"{fabric}: memory"] if bakes[fabric]["bytes_more"] > BAR_MEMORY else []
    return {
        "model": options.model,
        "nanoseconds_by_footprint": costs,
        "bar_footprint": BAR_FOOTPRINT,
        "bakes": bakes,
        "bar_bake_seconds": BAR_BAKE,
        "bar_bytes": BAR_MEMORY,
        "storage": storage_curve(options),
        "missed": missed,
    }


def main() -> None:
    """Runs everything, or one bake within this process."""
    if "--bake" in sys.argv:
        parser = ArgumentParser()
        add_options(parser)
        options = parser.parse_args()
        print(json.dumps(bake(options.bake, options.model)))
    else:
        run(measure, add_options)


if __name__ == "__main__":
    main()
