"""The query benchmark of all models on the 24 held-out fabrics: the figures that recipes are chosen by.

    python -m studies.accuracy.query_benchmark --models point,neural --output query_benchmark.json
    python -m studies.accuracy.query_benchmark --models neural --weights runs/a/neural.safetensors
    python -m studies.accuracy.query_benchmark --models neural --fabrics 8 --pairs 40 --footprints 40

The protocol is docs/research/evaluation.md: 25 600 queries a fabric against slices on the reference
plane, with 1, 3 and 16 Monte Carlo samples beside the models. The truths are cached on disk: the first
run takes minutes, later ones seconds. Tables are printed; `--output` writes every figure as JSON.

From other code, `run_query_benchmark({"mine": predictor}, held_out_fabrics())` of `loomlight.evaluation`
takes any function (fabric, queries) -> Prediction, and `query_truth(fabric, seed)` returns queries and truth
as NumPy arrays.
"""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from functools import partial
from pathlib import Path
from typing import Any

from loomlight.core.settings import declared
from loomlight.evaluation.query_benchmark import (
    FOOTPRINTS,
    PAIRS,
    SEED,
    Predictor,
    model_predictor,
    run_query_benchmark,
)
from loomlight.models.neural.weights import LAYOUT_RANGES, PARAMETER_RANGES, read_weights
from loomlight.models.registry import make_model, model_class
from studies.instruments.harness import Figures, run
from studies.instruments.held_out import held_out_fabrics
from studies.papers.setting import neural_predictor


def predictors(names: list[str], files: list[Path], quality: str | None = None) -> dict[str, Predictor]:
    """A predictor for each model by its name, and one for each file of weights of the neural network."""
    trained: dict[str, Any] = {} if quality is None else {"quality": quality}
    predictors_by_name = {
        name: model_predictor(
            partial(make_model, name, **trained) if _is_trained(name) else partial(make_model, name)
        )
        for name in names
    }
    for file in files:
        predictors_by_name[f"neural {file.stem}"] = neural_predictor(read_weights(file))
    return predictors_by_name


def _is_trained(name: str) -> bool:
    return "quality" in declared(model_class(name).options_class)


def add_options(parser: ArgumentParser) -> None:
    """Which models, on what."""
    parser.add_argument("--models", default="", help="names, with commas between them")
    parser.add_argument("--weights", type=Path, action="append", default=[], help="weights of neural")
    parser.add_argument("--quality", default=None, help="of models that are trained")
    parser.add_argument("--fabrics", type=int, default=None, help="only so many, of every kind")
    parser.add_argument("--varied-layouts", action="store_true", help="gaps and setts other than chen2024's")
    parser.add_argument("--pairs", type=int, default=PAIRS)
    parser.add_argument("--footprints", type=int, default=FOOTPRINTS)
    parser.add_argument("--seed", type=int, default=SEED, help="of the queries")


def measure(options: Namespace) -> Figures:
    """Runs the benchmark, prints its tables and returns every figure."""
    names = [name for name in options.models.split(",") if name]
    result = run_query_benchmark(
        predictors(names, options.weights, options.quality),
        held_out_fabrics(options.fabrics, LAYOUT_RANGES if options.varied_layouts else PARAMETER_RANGES),
        pairs=options.pairs,
        footprints=options.footprints,
        seed=options.seed,
        progress=lambda done, total: print(f"{done}/{total} fabrics", file=sys.stderr),
    )
    for table in result.tables():
        print(table.to_markdown())
    return result.to_dict()


if __name__ == "__main__":
    run(measure, add_options, prints=False)
