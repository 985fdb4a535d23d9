"""Accuracy of the truth: slices against brute force, their grids, boxes for parallelograms.

- `scores`: z-scores of random queries over all weaves, bands and both sides, slices against `brute_force` on
  the same rays; standard normal if both compute the same mean.
- `grid`: 32 and 64 rays a thread against 128, by band: bias and mean absolute error of f·cos at albedos 0.4
  and 0.6, shares of the mean.
- `boxes`: the axis-aligned box for parallelograms, by how correlated they are, against the reference.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np
from drjit.llvm.ad import Array2f64, Float
from numpy.typing import NDArray
from scipy import stats

from loomlight.aggregate.queries import BANDS, FabricScale, fabric_scale, query_set
from loomlight.aggregate.slices import FabricSlices
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.fabric import fabric_from_text
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from studies.harness.study import Figures, Found, Run, Study
from studies.instruments.reference import brute_force, reference

WEAVES = ("plain", "twill 2/2", "twill 3/1", "twill 4/4", "satin 5/2", "satin 8/3", "basket 2/2")
WEIGHTS = np.array([0.4, 0.4, 0.6, 0.6])
SAMPLES = 2048


def fabric(weave: str, roughness: float = 0.3) -> tuple[YarnScattering, FabricScale]:
    """A weave with its default bends, translucent."""
    lines = [f'weave = "{weave}"']
    for family in ("warp", "weft"):
        lines += [f"[{family}]", f"roughness = {roughness}", "translucency = 0.3"]
    made = fabric_from_text("\n".join(lines))
    return YarnScattering(YarnGeometry(made.layout()), made.appearance()), fabric_scale(made.layout())


def scores(pairs: int, footprints: int) -> dict[str, float]:
    """Moments and the Kolmogorov–Smirnov test of z-scores of one channel a query."""
    found = []
    for number, weave in enumerate(WEAVES):
        rng = np.random.default_rng([7, number])
        model, scale = fabric(weave, (0.15, 0.3, 0.6)[number % 3])
        queries = query_set(scale, pairs, footprints, number, transmits=True)
        slices = FabricSlices(model, Float)
        means = slices.box_means(queries.lights, queries.views, queries.pairs, queries.centres, queries.boxes)
        lights, views = queries.lights[queries.pairs[:, 0]], queries.views[queries.pairs[:, 1]]
        estimate = brute_force(
            model,
            slices.grid,
            np.repeat(lights, footprints, axis=0),
            np.repeat(views, footprints, axis=0),
            queries.centres.reshape(-1, 2),
            queries.boxes.reshape(-1, 2),
            SAMPLES,
            number,
            Float,
        )
        # Where rare highlights dominate a channel, the mean of 2 048 samples is not normal yet. Such pairs
        # are excluded by the skewness over the repeat, which does not depend on these samples.
        tame = np.array(
            [_skewness(slices.slice(a, b).values) < 6 for a, b in zip(lights, views, strict=True)]
        )
        lit = (estimate.mean**2 > 30 * estimate.variance) & (estimate.variance > 1e-12)
        lit &= np.repeat(tame, footprints, axis=0)
        choice = np.where(lit, rng.random(lit.shape), -1).argmax(axis=1)
        chosen = np.arange(len(choice)), choice
        difference = (means.reshape(-1, means.shape[-1]) - estimate.mean)[chosen]
        score = difference / np.sqrt(np.maximum(estimate.variance[chosen], 1e-30))
        found.append(score[lit.any(axis=1)])
    z = np.concatenate(found)
    return {
        "queries": len(z),
        "mean": float(z.mean()),
        "variance": float(z.var()),
        "largest": float(np.abs(z).max()),
        "p_value": float(stats.kstest(z, "norm").pvalue),
    }


def _skewness(values: NDArray[np.float32]) -> NDArray[np.float64]:
    flat = values.reshape(len(values), -1).astype(np.float64)
    deviation = flat - flat.mean(axis=1, keepdims=True)
    spread = np.maximum((deviation**2).mean(axis=1), 1e-30)
    return (deviation**3).mean(axis=1) / spread**1.5


def grid(pairs: int) -> dict[str, Any]:
    """Bias and mean absolute error of coarser grids, by band."""
    totals: dict[int, list[NDArray[np.float64]]] = {32: [], 64: [], 128: []}
    bands = []
    for number, weave in enumerate(WEAVES[:5]):
        model, scale = fabric(weave, 0.2)
        queries = query_set(scale, pairs, 100, number, transmits=True)
        bands.append(scale.bands(queries.sizes).ravel())
        for texels, found in totals.items():
            slices = FabricSlices(model, Float, texels)
            means = slices.box_means(
                queries.lights, queries.views, queries.pairs, queries.centres, queries.boxes
            )
            found.append((means[..., :4] @ WEIGHTS).ravel())
    band = np.concatenate(bands)
    finest = np.concatenate(totals[128])
    return {
        str(texels): {
            name: _errors(np.concatenate(totals[texels])[band == index], finest[band == index])
            for index, name in enumerate(BANDS)
        }
        for texels in (32, 64)
    }


def _errors(values: NDArray[np.float64], truth: NDArray[np.float64]) -> dict[str, float]:
    return {
        "bias": round(float(values.mean() / truth.mean() - 1), 5),
        "nmae": round(float(np.abs(values - truth).mean() / truth.mean()), 5),
    }


def boxes(count: int) -> dict[str, float]:
    """Mean absolute error of boxes for parallelograms of a third to 3 threads, by |correlation|."""
    model, scale = fabric("twill 3/1")
    rng = np.random.default_rng(3)
    queries = query_set(scale, 16, 1, 3)
    slices = FabricSlices(model, Float)
    size = scale.thread * np.exp(rng.uniform(np.log(1 / 3), np.log(3), count))
    turn, stretch = rng.uniform(0, np.pi, count), np.exp(rng.uniform(0, np.log(4), count))
    along = size * np.sqrt(stretch) * np.array([np.cos(turn), np.sin(turn)])
    across = size / np.sqrt(stretch) * np.array([-np.sin(turn), np.cos(turn)])
    centre = rng.random((2, count)) * np.array(scale.extent)[:, None]
    footprint = Footprint(Array2f64(centre), Array2f64(along), Array2f64(across))
    correlation = np.abs(footprint.box_correlation().numpy())
    box = footprint.box().size.numpy().T
    errors, truths = np.zeros(count), np.zeros(count)
    for light, view in queries.pairs:
        one, other = queries.lights[light], queries.views[view]
        exact = reference(model, footprint, one, other, 1024, seed=1).mean[:, :4] @ WEIGHTS
        found = slices.slice(one, other).box_means(centre.T, box)[:, :4] @ WEIGHTS
        errors += np.abs(found - exact)
        truths += exact
    bounds = (0.0, 0.2, 0.5, 0.8, 1.0)
    return {
        f"{low}-{high}": round(float(errors[inside].sum() / truths[inside].sum()), 4)
        for low, high in pairwise(bounds)
        for inside in [(correlation >= low) & (correlation <= high)]
    }


@dataclass(frozen=True)
class Aggregation(Settings):
    pairs: int = setting(40, "Pairs of directions of each weave's z-scores.", low=4)
    footprints: int = setting(50, "Footprints of each pair.", low=1)
    grid_pairs: int = setting(32, "Pairs of directions of each weave's grids.", low=4)
    boxes: int = setting(1500, "Parallelograms.", low=1)


def measure(settings: Aggregation, run: Run) -> Found:
    """Everything."""
    require_llvm()
    return Found(
        {
            "scores": run.parts.kept("scores", partial(scores, settings.pairs, settings.footprints)),
            "grid": run.parts.kept("grid", partial(grid, settings.grid_pairs)),
            "boxes": run.parts.kept("boxes", partial(boxes, settings.boxes)),
        }
    )


def tables(figures: Figures) -> list[Table]:
    """z-scores, errors of coarser grids by band, and errors of boxes by correlation."""
    scores = figures["scores"]
    columns = ["queries", "mean", "variance", "largest", "p"]
    keys = ("queries", "mean", "variance", "largest", "p_value")
    grids = {
        f"{texels} rays a thread, {what}": [100 * bands[band][key] for band in bands]
        for texels, bands in figures["grid"].items()
        for what, key in (("bias, %", "bias"), ("error, %", "nmae"))
    }
    boxes = figures["boxes"]
    return [
        Table("z of slices against brute force", columns, {"all weaves": [scores[key] for key in keys]}),
        Table("Grids against 128 rays a thread", list(BANDS), grids),
        Table(
            "Error of the box for a parallelogram, by correlation",
            list(boxes),
            {"error, %": [100 * error for error in boxes.values()]},
        ),
    ]


STUDY = Study(
    "accuracy/aggregation",
    "accuracy of the truth: slices against brute force, their grids, boxes for parallelograms",
    Aggregation(),
    measure,
    tables,
    stands_on=("point",),
    small={"pairs": 4, "footprints": 4, "grid_pairs": 4, "boxes": 20},
)
