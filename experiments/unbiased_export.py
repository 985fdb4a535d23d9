"""Is the mean of what exported shader code of `clustered` estimates that of the point model? z-tests.

    python -m experiments.unbiased_export [--fabrics 6] [--frames 2048] [--samples 16384]
        [--output experiments/results/unbiased_export.json]

The library that `loomlight export --to cuda --model clustered` writes is compiled by g++ and asked for
`cloth_estimate` with another seed for every frame, as an engine would. A case is one of the first held-out
fabrics, a light, a view and a rectangle of a quarter thread to four repeats along the threads, 12 a fabric;
colours are three tests a case. The truth is the mean of the model `point` over random points of the
rectangle. z is the difference over the standard error of both; Holm's procedure keeps the chance of any
false alarm below 0.01. Beside it, the base alone, `cloth_value`: a mean bias over all cases.
"""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

import numpy as np
from drjit.llvm import Array2f, Array3f

from benchmarks.counted_library import CountedLibrary, queries_of
from benchmarks.harness import Figures, run
from experiments.held_out import held_out_fabrics
from experiments.unbiased import SIGNIFICANCE, Cases, Means, holm, random_cases, scores
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.fabric.fabric import Fabric
from loomlight.models.clustered.model import ClusteredModel
from loomlight.models.registry import make_model

CASES = 12


def exported_means(library: CountedLibrary, cases: Cases, frames: int, seed: int) -> Means:
    """Means of so many answers a case."""
    rng = np.random.default_rng(seed)
    parts = (cases.centres, cases.edges[:, 0], cases.edges[:, 1], cases.lights, cases.views)
    asked = queries_of(*(np.repeat(part, frames, axis=0).astype(np.float32) for part in parts))
    asked["seed"] = rng.integers(1, 2**32, len(asked), dtype=np.uint32)
    found = library.answers(asked)[0].reshape(len(cases.lights), frames, 4)[..., :3].astype(np.float64)
    return Means(found.mean(axis=1), found.var(axis=1) / frames)


def true_means(fabric: Fabric, cases: Cases, samples: int, seed: int) -> Means:
    """The same of random points of the footprints."""
    rng = np.random.default_rng(seed)
    model = make_model("point", fabric)
    values = []
    for light, view, centre, edges in zip(cases.lights, cases.views, cases.centres, cases.edges, strict=True):
        places = centre + rng.uniform(-0.5, 0.5, (samples, 2)) @ edges
        steps = (Array2f(*map(float, edge)) for edge in edges)
        at = model.at(Array3f(*map(float, view)), Footprint(Array2f(np.float32(places.T)), *steps))
        found = at.value(Array3f(*map(float, light)))
        values.append([np.broadcast_to(np.float64(part.numpy()), (samples,)) for part in found])
    return Means(np.mean(values, axis=2), np.var(values, axis=2) / samples)


def measure(options: Namespace) -> Figures:
    """z of every test, what Holm's procedure rejects, and the bias of the base."""
    require_llvm()
    z, totals = [], np.zeros(3)
    for number, held in enumerate(held_out_fabrics(options.fabrics)):
        model = ClusteredModel.for_source(held.fabric)
        cases = random_cases(held.fabric, CASES, number, aligned=True)
        truth = true_means(held.fabric, cases, options.samples, number)
        library = CountedLibrary(model, "clustered", estimates=True)
        found = exported_means(library, cases, options.frames, number)
        base = exported_means(CountedLibrary(model, "clustered"), cases, 1, number)
        z.append(scores(found, truth))
        totals += [float(means.mean.sum()) for means in (truth, found, base)]
    all_of_them = np.concatenate(z)
    return {
        "fabrics": options.fabrics,
        "frames": options.frames,
        "samples": options.samples,
        "tests": all_of_them.size,
        "rejected": holm(all_of_them, SIGNIFICANCE),
        "largest_z": float(np.abs(all_of_them).max()),
        "mean_squared_z": float(np.mean(all_of_them**2)),
        "bias": float(totals[1] / totals[0] - 1),
        "bias_of_base": float(totals[2] / totals[0] - 1),
    }


def _add_options(parser: ArgumentParser) -> None:
    parser.add_argument("--fabrics", type=int, default=6, help="of the held-out ones")
    parser.add_argument("--frames", type=int, default=2048, help="estimates of a case")
    parser.add_argument("--samples", type=int, default=16384, help="points of the truth of a case")


if __name__ == "__main__":
    run(measure, _add_options)
