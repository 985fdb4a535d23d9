"""How many groups does the lobes model need? Its error in the query benchmark against groups a family.

    python -m studies.accuracy.lobes_groups --output FILE.json
    python -m studies.accuracy.lobes_groups --fabrics 8                                          (a check)

For each number of groups: nMAE of grey reflection overall and by size of the footprint (b0 is below a quarter
yarn, b3 above a repeat), of transmission and of colour, bytes that a query fetches from the tables, and their
size. Close up the model looks at single points, so b0 does not depend on groups. The protocol is that of
`studies.accuracy.query_benchmark`, which keeps the truths on disk; with them it takes some minutes.
"""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from functools import partial
from typing import Any

import numpy as np

from loomlight.aggregate.queries import BANDS
from loomlight.evaluation.metrics import OVERALL
from loomlight.evaluation.query_benchmark import QueryBenchmark, model_predictor, run_query_benchmark
from loomlight.evaluation.table import Table
from loomlight.fabric.fabric import Fabric
from loomlight.models.lobes.model import LobesModel, LobesOptions
from studies.instruments.harness import Figures, run
from studies.instruments.held_out import held_out_fabrics

GROUPS = (1, 2, 4, 8, 16, 32)


def tested(groups: list[int], fabrics: int | None) -> tuple[QueryBenchmark, dict[int, list[int]]]:
    """The query benchmark of each number of groups, and the sizes of the tables of all fabrics, bytes."""
    sizes: dict[int, list[int]] = {count: [] for count in groups}

    def made(count: int, fabric: Fabric) -> LobesModel:
        model = LobesModel.for_source(fabric, LobesOptions(groups=count))
        sizes[count].append(model.tables.nbytes)
        return model

    result = run_query_benchmark(
        {str(count): model_predictor(partial(made, count)) for count in groups},
        held_out_fabrics(fabrics),
        monte_carlo=(),
        progress=lambda done, total: print(f"{done}/{total} fabrics", file=sys.stderr),
    )
    return result, sizes


def figures(result: QueryBenchmark, name: str, sizes: list[int]) -> dict[str, Any]:
    """Figures of one number of groups."""
    row = result.rows[name]
    multiply_adds, bytes_fetched = row.cost or (None, None)
    return {
        "groups_a_family": int(name),
        "reflection": {part: round(row.metric("reflection", part), 4) for part in (OVERALL, *BANDS)},
        **{quantity: round(row.metric(quantity), 4) for quantity in ("transmission", "colour")},
        "multiply_adds": multiply_adds,
        "bytes_fetched": bytes_fetched,
        "table_bytes": {
            "smallest": min(sizes),
            "median": int(np.median(sizes)),
            "largest": max(sizes),
        },
    }


def add_options(parser: ArgumentParser) -> None:
    """Which numbers of groups, on how many fabrics."""
    parser.add_argument("--groups", default=",".join(map(str, GROUPS)), help="numbers, with commas between")
    parser.add_argument("--fabrics", type=int, default=None, help="only so many, of every kind")


def measure(options: Namespace) -> Figures:
    """The curve of errors against groups, printed as a table."""
    groups = [int(count) for count in options.groups.split(",")]
    result, sizes = tested(groups, options.fabrics)
    curve = [figures(result, str(count), sizes[count]) for count in groups]
    columns = [OVERALL, *BANDS, "transmission", "colour", "bytes fetched", "median table, bytes"]
    table = Table("nMAE by groups of each family", columns, note=f"{len(result.fabrics)} fabrics.")
    for point in curve:
        table.rows[str(point["groups_a_family"])] = [
            *point["reflection"].values(),
            point["transmission"],
            point["colour"],
            point["bytes_fetched"],
            point["table_bytes"]["median"],
        ]
    print(table.to_markdown())
    return {"fabrics": result.fabrics, "queries_per_fabric": result.queries, "curve": curve}


if __name__ == "__main__":
    run(measure, add_options, prints=False)
