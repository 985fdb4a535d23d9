"""How exact is `latent`, and how well does it draw directions? Options side by side on sources.

    python -m experiments.latent --sources examples/denim.toml --try loss=log --try loss=relative \\
        [--common resolution=64,steps=4000] [--output FILE.json]

Each `--try` is a model with those options beside the common ones. It is asked about queries of another seed,
a level of the pyramid each; the truth is a mean of estimates of the source. A row has

- `nmae`, `bias`: mean absolute difference and mean difference over the mean, `smape`, and `log`, the mean
  difference of log(1 + f·cos), overall and by level;
- `spread`: standard deviation of f·cos / pdf of drawn directions over its mean (luminance), where light is
  white from everywhere, mean over views; `cosine` is that of cosine sampling, `gain` the ratio of both
  variances, summed over views, and `median_gain` its median;
- `train_s`: CPU seconds of the bake; `value_ns`, `sample_ns`: of a value and of a sample, on one core.
"""

from __future__ import annotations

import time
from argparse import ArgumentParser, Namespace
from math import pi
from pathlib import Path
from typing import Any

import drjit as dr
import numpy as np
from drjit.llvm.ad import Array2f, Array3f, Float
from numpy.typing import NDArray

from benchmarks.harness import Figures, run
from loomlight.assets.load import load_source
from loomlight.assets.sources import kind_of_file
from loomlight.core.footprint import Box, box_footprint
from loomlight.core.llvm import require_llvm
from loomlight.models.interface import FootprintBsdf
from loomlight.models.latent.model import LatentModel
from loomlight.models.latent.queries import reflectance_of
from loomlight.models.latent.query_stream import Queries, QueryStream
from loomlight.models.option_values import parse_options

_SEED = 999  # of no training
_LUMINANCE = np.array([0.2126, 0.7152, 0.0722])
_DIRECTIONS = 64  # drawn for each view
_TIMED = 1 << 18


def measure(options: Namespace) -> Figures:
    require_llvm()
    rows: dict[str, Any] = {}
    for source in options.sources:
        for tried in options.tried or [""]:
            texts = [text for text in f"{options.common},{tried}".split(",") if text]
            rows[f"{Path(source).stem} {tried}".strip()] = _row(source, texts, options)
    return {"queries": options.queries, "estimates": options.estimates, "rows": rows}


def _row(path: str, texts: list[str], options: Namespace) -> Figures:
    source = load_source(path, kind_of_file(path, "fabric"))
    start = time.process_time()
    model = LatentModel.for_source(source, **parse_options("latent", texts))
    spent = time.process_time() - start
    shape = model.weights.shape
    reflectance = reflectance_of(source, max(shape.columns, shape.rows))
    queries = QueryStream(reflectance, shape.levels, options.estimates, _SEED).part(0, options.queries)
    at, light = _asked(model, queries)
    values = at.value(light).numpy().T
    figures = _errors(values, queries.values)
    figures["levels"] = [
        _errors(values[of_level], queries.values[of_level])["nmae"]
        for of_level in (queries.levels == level for level in range(shape.levels))
        if of_level.any()
    ]
    levels = [float(f"{error:.3g}") for error in figures.pop("levels")]
    figures |= {**_spreads(model, queries), "train_s": spent, **_times(model, queries)}
    return {**{name: float(f"{value:.4g}") for name, value in figures.items()}, "levels": levels}


def _asked(model: LatentModel, queries: Queries) -> tuple[FootprintBsdf, Any]:
    """The model at the queries' footprints, and the lights."""
    shape, side = model.weights.shape, np.where(queries.faces == 1, -1, 1)
    sizes = (shape.texel_mm * 2.0**queries.levels).astype(np.float32)
    centres = queries.positions * np.array([shape.width_mm, shape.height_mm], np.float32)
    light, view = (
        Array3f(*(np.ascontiguousarray(c) for c in (*rows.T[:2], rows.T[2] * side)))
        for rows in (queries.lights, queries.views)
    )
    box = Box(Array2f(np.ascontiguousarray(centres.T)), Array2f(Float(sizes), Float(sizes)))
    return model.at(view, box_footprint(box)), light


def _errors(values: NDArray[np.float32], truth: NDArray[np.float32]) -> Figures:
    difference = (values - truth).astype(np.float64)
    return {
        "nmae": np.abs(difference).sum() / truth.sum(),
        "bias": difference.sum() / truth.sum(),
        "smape": (2 * np.abs(difference) / (np.abs(values) + truth + 1e-4)).mean(),
        "log": np.abs(np.log1p(values) - np.log1p(truth)).mean(),
    }


def _spreads(model: LatentModel, queries: Queries) -> Figures:
    """Relative deviations of weights under white light, of drawn directions and of a cosine's."""
    count = min(len(queries), 1000)
    repeated = queries[np.repeat(np.arange(count), _DIRECTIONS)]
    rng = np.random.default_rng(_SEED)
    choice, u, v = (rng.random(len(repeated), np.float32) for _ in range(3))
    drawn = _asked(model, repeated)[0].sample(Float(choice), Array2f(Float(u), Float(v))).weight.numpy()
    radius, angle = np.sqrt(u), 2 * pi * v
    height = np.sqrt(np.maximum(1 - u, 1e-9))
    cosine = np.stack([radius * np.cos(angle), radius * np.sin(angle), height], 1).astype(np.float32)
    by_cosine = Queries(
        repeated.positions, repeated.levels, cosine, repeated.views, repeated.faces, repeated.values
    )
    at, light = _asked(model, by_cosine)
    weights = at.value(light).numpy() * (pi / np.abs(light.z.numpy()))
    variances, means = [], []
    for each in (drawn, weights):
        luminance = (_LUMINANCE @ each).reshape(count, _DIRECTIONS)
        variances.append(luminance.var(axis=1, ddof=1))
        means.append(luminance.mean(axis=1))
    mean = np.maximum((means[0] + means[1]) / 2, 1e-6)
    own, other = (np.sqrt(variance) / mean for variance in variances)
    return {
        "spread": own.mean(),
        "cosine": other.mean(),
        "gain": variances[1].mean() / variances[0].mean(),
        "median_gain": float(np.median(variances[1] / np.maximum(variances[0], 1e-12))),
        "largest_weight": float(drawn.max()),
    }


def _times(model: LatentModel, queries: Queries) -> Figures:
    """CPU nanoseconds of a value and of a sample, textures and frames included."""
    many = queries[np.random.default_rng(0).integers(len(queries), size=_TIMED)]
    numbers = [Float(row) for row in np.random.default_rng(1).random((3, _TIMED)).astype(np.float32)]
    found = {}
    for name in ("value_ns", "sample_ns"):
        times = []
        for _ in range(3):
            at, light = _asked(model, many)
            dr.eval(at.view, at.footprint, light)
            start = time.process_time()
            result = at.value(light) if name == "value_ns" else at.sample(numbers[0], Array2f(*numbers[1:]))
            dr.eval(result)
            dr.sync_thread()
            times.append(time.process_time() - start)
        found[name] = round(min(times) / _TIMED * 1e9)
    return found


def _add_options(parser: ArgumentParser) -> None:
    parser.add_argument("--sources", nargs="+", required=True, help="files of sources")
    parser.add_argument("--try", dest="tried", action="append", help="options of a row: loss=log,rung=mlp")
    parser.add_argument("--common", default="", help="options of all rows")
    parser.add_argument("--queries", type=int, default=2000)
    parser.add_argument("--estimates", type=int, default=1024, help="of the truth of a query")


if __name__ == "__main__":
    run(measure, _add_options)
