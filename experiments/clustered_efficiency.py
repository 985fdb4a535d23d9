"""Variance times processor time of `clustered` against `point`, for one light and for two lights of a view.

    python -m experiments.clustered_efficiency [--fabrics silk-satin,linen] [--points 2+16,1+4]

Cases are random views and lights above 8° of elevation and footprints of three repeats by three. The
variance of an answer's green channel is divided by the squared mean over all cases; `point` is asked at a
random place of the footprint. Processor time is the least of turns
of all answers, one after another. The efficiency is variance times time of `point` over that of the row:
above 1 the row reaches the same error in less time, of shading alone.
"""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from functools import partial

import drjit as dr
import numpy as np
from drjit.llvm.ad import Array2f, Array3f, Float, UInt32

from benchmarks.harness import REPOSITORY, Figures, run
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.evaluation.equal_error import least_times
from loomlight.fabric import load_fabric
from loomlight.fabric.load import edited_fabric
from loomlight.models.clustered.model import ClusteredModel
from loomlight.models.interface import FootprintBsdf, Model
from loomlight.models.registry import make_model

CASES, EACH, QUERIES, TURNS, REPEATS = 48, 512, 1 << 15, 3, 3.0
_SEED = 11


def directions(rng: np.random.Generator, count: int) -> np.ndarray:
    """Unit vectors above 8° of elevation [3, count]."""
    z, azimuth = rng.uniform(0.14, 1, count), rng.uniform(0, 2 * np.pi, count)
    radius = np.sqrt(1 - z * z)
    return np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), z]).astype(np.float32)


class Asked:
    """Answers of models over footprints of three repeats."""

    def __init__(self, repeat: tuple[float, float], cases: int, each: int) -> None:
        rng = np.random.default_rng(_SEED)
        self.cases, self.each = cases, each
        count = cases * each
        spread = np.repeat(np.arange(cases), each)
        self.view = Array3f(directions(rng, cases)[:, spread])
        self.lights = [Array3f(directions(rng, cases)[:, spread]) for _ in range(2)]
        size = REPEATS * np.asarray(repeat)
        centre = (rng.random((2, cases)) * size[:, None])[:, spread]
        self.centre = Array2f(centre.astype(np.float32))
        self.place = Array2f((centre + (rng.random((2, count)) - 0.5) * size[:, None]).astype(np.float32))
        self.seed = UInt32(rng.integers(0, 2**32, count, dtype=np.uint32))
        self.edges = [dr.opaque(Float, float(extent)) for extent in size]
        dr.eval(self.view, self.lights, self.centre, self.place, self.seed)

    def values(self, model: Model, lights: int) -> list[Array3f]:
        """f·cos for each light."""
        if isinstance(model, ClusteredModel):
            footprint = Footprint(self.centre, Array2f(self.edges[0], 0), Array2f(0, self.edges[1]))
            at: FootprintBsdf = model.at(self.view, footprint, seed=self.seed)
        else:
            at = model.at(self.view, Footprint(self.place, Array2f(1e-6, 0), Array2f(0, 1e-6)))
        found = [at.value(light) for light in self.lights[:lights]]
        dr.eval(found)
        dr.sync_thread()
        return found

    def variance(self, model: Model) -> tuple[float, float]:
        """Mean variance of an answer over the squared mean, and the mean."""
        green = self.values(model, 1)[0].y.numpy().reshape(self.cases, self.each).astype(np.float64)
        return float(green.var(axis=1, ddof=1).mean() / green.mean() ** 2), float(green.mean())


def rows(fabric: str, options: Namespace) -> Figures:
    """The table of one fabric."""
    cloth = edited_fabric(load_fabric(REPOSITORY / f"examples/{fabric}.toml"), {"sheen.strength": 0.0})
    counts = [tuple(map(int, text.split("+"))) for text in options.points.split(",")]
    models: dict[str, Model] = {"point": make_model("point", cloth)}
    for clusters in map(int, options.clusters.split(",")):
        baked = ClusteredModel.for_source(cloth, clusters)
        for exact, texels in counts:
            models[f"{clusters}: {exact} + {texels}"] = baked.with_samples(exact, texels)
    noise, timed = Asked(cloth.repeat_mm, CASES, EACH), Asked(cloth.repeat_mm, QUERIES, 1)
    found: Figures = {}
    for name, model in models.items():
        variance, mean = noise.variance(model)
        found[name] = {"variance": variance, "mean": mean}
        for lights in (1, 2):
            timed.values(model, lights)
    for lights in (1, 2):
        times = least_times([partial(timed.values, model, lights) for model in models.values()], TURNS)
        for name, spent in zip(models, times, strict=True):
            found[name][f"ns, lights {lights}"] = 1e9 * spent.cpu_seconds / QUERIES
    for row in found.values():
        for lights in (1, 2):
            cost = row["variance"] * row[f"ns, lights {lights}"]
            point = found["point"]["variance"] * found["point"][f"ns, lights {lights}"]
            row[f"efficiency, lights {lights}"] = point / max(cost, 1e-12)
    return found


def add_options(parser: ArgumentParser) -> None:
    parser.add_argument("--fabrics", default="silk-satin,linen,denim")
    parser.add_argument("--points", default="2+16,1+4,2+4,2+0,1+0,4+0", help="exact points + texel points")
    parser.add_argument("--clusters", default="16")


def measure(options: Namespace) -> Figures:
    """Tables of all fabrics."""
    require_llvm()
    return {"fabrics": {fabric: rows(fabric, options) for fabric in options.fabrics.split(",")}}


if __name__ == "__main__":
    run(measure, add_options)
