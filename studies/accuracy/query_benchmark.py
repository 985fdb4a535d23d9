"""The query benchmark of all models on the 24 held-out fabrics: the figures that recipes are chosen by.

The protocol is docs/research/evaluation.md: 25 600 queries a fabric against slices on the reference
plane, with 1, 3 and 16 Monte Carlo samples beside the models. The truths are kept on disk:
the first run takes minutes, later ones seconds.

From other code, `run_query_benchmark({"mine": predictor}, held_out_fabrics())` of `loomlight.evaluation`
takes any function (fabric, queries) -> Prediction, and `query_truth(fabric, seed)` returns queries and truth
as NumPy arrays.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from loomlight.aggregate.queries import BANDS
from loomlight.core.settings import Settings, declared, setting
from loomlight.evaluation.metrics import OVERALL
from loomlight.evaluation.query_benchmark import (
    ELEVATION,
    FOOTPRINTS,
    PAIRS,
    ROUGHNESS,
    SEED,
    WEAVES,
    Predictor,
    model_predictor,
    run_query_benchmark,
)
from loomlight.evaluation.table import Cell, Table
from loomlight.models.neural.weights import LAYOUT_RANGES, PARAMETER_RANGES, read_weights
from loomlight.models.registry import MODELS, make_model, model_class
from studies.harness.study import Figures, Found, Run, Study, listed, names
from studies.instruments.held_out import held_out_fabrics
from studies.papers.chen2024.stage import neural_predictor


def predictors(models: list[str], files: list[Path], quality: str = "") -> dict[str, Predictor]:
    """A predictor for each model by its name, and one for each file of weights of the neural network."""
    trained: dict[str, Any] = {"quality": quality} if quality else {}
    predictors_by_name = {
        name: model_predictor(
            partial(make_model, name, **trained) if _is_trained(name) else partial(make_model, name)
        )
        for name in models
    }
    for file in files:
        predictors_by_name[f"neural {file.stem}"] = neural_predictor(read_weights(file))
    return predictors_by_name


def _is_trained(name: str) -> bool:
    return "quality" in declared(model_class(name).options_class)


@dataclass(frozen=True)
class QueryQuestions(Settings):
    models: str = names("point,lobes,neural", "Models.", tuple(MODELS))
    weights: str = names("", "Files of weights of `neural`, each a row.")
    quality: str = setting("", "Of models that are trained; by default their own.")
    fabrics: int = setting(24, "Of the held-out fabrics, of every kind.", low=1, high=24)
    varied_layouts: bool = setting(False, "Gaps and setts other than chen2024's.")
    pairs: int = setting(PAIRS, "Pairs of directions of a fabric.", low=1)
    footprints: int = setting(FOOTPRINTS, "Footprints of a pair.", low=1)
    seed: int = setting(SEED, "Of the queries.", low=0)


def measure(settings: QueryQuestions, run: Run) -> Found:
    """Every figure of the benchmark."""
    files = [Path(file) for file in listed(settings.weights)]
    result = run_query_benchmark(
        predictors(listed(settings.models), files, settings.quality),
        held_out_fabrics(settings.fabrics, LAYOUT_RANGES if settings.varied_layouts else PARAMETER_RANGES),
        pairs=settings.pairs,
        footprints=settings.footprints,
        seed=settings.seed,
        progress=run.report,
    )
    return Found(result.to_dict())


def tables(figures: Figures) -> list[Table]:
    """Errors by class, other figures, and errors by fabric."""
    note = f"{len(figures['fabrics'])} fabrics, {figures['queries_per_fabric']} queries each."
    rows = {f"`{name}`" if name in MODELS else name: row for name, row in figures["rows"].items()}

    def nmae(row: Figures, quantity: str, part: str = OVERALL) -> Cell:
        return row["metrics"].get(quantity, {}).get(part, {}).get("nmae")

    parts = [OVERALL, *BANDS, ROUGHNESS[0], *ELEVATION]
    quantities = ("transmission", "colour")
    errors = Table("Errors of models", [*parts, *quantities], note=f"nMAE of grey reflection; {note}")
    columns = [*ROUGHNESS[1:], *WEAVES, "MSE", "bias", "queries/s", "multiply-adds", "bytes fetched"]
    others = Table("Other figures", columns, note=f"Of grey reflection, {note}")
    by_fabric = Table("nMAE of grey f·cos by fabric", list(rows))
    for name, row in rows.items():
        means = row["metrics"]["reflection"][OVERALL]
        costs = [row[key] for key in ("queries_per_second", "multiply_adds", "bytes_fetched")]
        errors.rows[name] = [
            *(nmae(row, "reflection", part) for part in parts),
            *(nmae(row, quantity) for quantity in quantities),
        ]
        others.rows[name] = [
            *(nmae(row, "reflection", part) for part in (*ROUGHNESS[1:], *WEAVES)),
            *(means[metric] for metric in ("mse", "bias")),
            *costs,
        ]
    for fabric in figures["fabrics"]:
        by_fabric.rows[fabric] = [row["nmae_by_fabric"].get(fabric) for row in rows.values()]
    return [errors, others, by_fabric]


_FEW = {"fabrics": 1, "pairs": 4, "footprints": 4}
STUDIES = (
    Study(
        "accuracy/query_benchmark",
        "the query benchmark on the 24 held-out fabrics: errors of models by size, roughness and angle",
        QueryQuestions(),
        measure,
        tables,
        stands_on=("point", "lobes", "neural", "network"),
        small={**_FEW, "models": "point,lobes"},
    ),
    Study(
        "accuracy/query_benchmark_neumip",
        "the same of `neumip`, which is trained for each of three fabrics",
        QueryQuestions(models="lobes,neumip", fabrics=3, pairs=40, footprints=40),
        measure,
        tables,
        stands_on=("point", "lobes", "neumip"),
        small={**_FEW, "models": "lobes"},
    ),
    Study(
        "accuracy/query_benchmark_layouts",
        "the same of `neural` on layouts that its paper does not have",
        QueryQuestions(models="neural", fabrics=8, varied_layouts=True, pairs=40, footprints=40),
        measure,
        tables,
        stands_on=("point", "neural", "network"),
        small=_FEW,
    ),
)
