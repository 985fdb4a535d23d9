"""Error of the network against the cost of a query: decoders of three widths on the encoder that ships.

Decoders are trained for a twelfth of the shipped one's time, by width_*.toml. A query is a footprint, a view
and a light. Beside them are the network that ships, with its last layer fitted to each fabric and without,
and `lobes`.
"""

from __future__ import annotations

from loomlight.evaluation.query_benchmark import BANDS, OVERALL, model_predictor, run_query_benchmark
from loomlight.evaluation.table import Table
from loomlight.models.neural.weights import read_weights, shipped_weights
from loomlight.models.registry import make_model
from studies.harness.study import Figures, Found, Pixels, Run, Study
from studies.instruments.held_out import held_out_fabrics
from studies.instruments.plot import Curve, curves_plot
from studies.papers.chen2024.ablation import BenchmarkSettings, weights_files
from studies.papers.chen2024.stage import neural_predictor

WIDTHS = {f"width {width}": f"width_{width}" for width in (40, 64, 96)}


def measured(settings: BenchmarkSettings, run: Run) -> Found:
    """The query benchmark of the networks, and a plot.

    Raises:
        InputError: a training is missing; the message says which commands make them.
    """
    files = weights_files(run.runs, WIDTHS)
    predictors = {name: neural_predictor(read_weights(file)) for name, file in files.items()}
    predictors["the network that ships"] = model_predictor(lambda fabric: make_model("neural", fabric))
    predictors["the same, not fitted to fabrics"] = neural_predictor(shipped_weights())
    predictors["`lobes`"] = model_predictor(lambda fabric: make_model("lobes", fabric))
    result = run_query_benchmark(
        predictors,
        held_out_fabrics(settings.fabrics),
        pairs=settings.pairs,
        footprints=settings.footprints,
        monte_carlo=(),
        progress=run.report,
    )
    figures = {
        "fabrics": result.fabrics,
        "queries_per_fabric": result.queries,
        "rows": {name: row for name, row in result.to_dict()["rows"].items() if name in predictors},
    }
    return Found(figures, _plot(figures))


def _errors(row: Figures, part: str) -> float:
    return float(row["metrics"]["reflection"][part]["nmae"])


def _plot(figures: Figures) -> Pixels:
    """nMAE over multiply-adds, a line for all queries and one for each size of footprint."""
    rows = {name: figures["rows"][name] for name in WIDTHS}
    cost = [row["multiply_adds"] for row in rows.values()]
    return curves_plot(
        "chen2024: error of the network against its cost",
        "multiply-adds of a query",
        "nMAE of grey reflection",
        {
            part: Curve(
                cost, [_errors(row, part) for row in rows.values()], list(rows) if part == OVERALL else ()
            )
            for part in (OVERALL, *BANDS)
        },
    )


def tables(figures: Figures) -> list[Table]:
    """Errors by size of footprint beside multiply-adds and queries a second."""
    parts = [OVERALL, *BANDS]
    table = Table(
        "Error against cost",
        ["multiply-adds", "queries/s", *parts],
        note=f"nMAE of grey reflection; {len(figures['fabrics'])} fabrics, "
        f"{figures['queries_per_fabric']} queries each.",
    )
    for name, row in figures["rows"].items():
        errors = [_errors(row, part) for part in parts]
        table.rows[name] = [row["multiply_adds"], row["queries_per_second"], *errors]
    return [table]


STUDY = Study(
    "papers/chen2024/error_against_cost",
    "decoders of three widths: error by size of footprint against multiply-adds",
    BenchmarkSettings(fabrics=12, pairs=160, footprints=160),
    measured,
    tables,
    stands_on=("point", "lobes", "network"),
    small={"fabrics": 1, "pairs": 4, "footprints": 4},
)
