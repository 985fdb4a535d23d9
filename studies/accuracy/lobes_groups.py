"""How many groups does the lobes model need? Its error in the query benchmark against groups a family.

For each number of groups: nMAE of grey reflection overall and by size of the footprint (b0 is below a quarter
yarn, b3 above a repeat), of transmission and of colour, bytes that a query fetches from the tables, and their
size. Close up the model looks at single points, so b0 does not depend on groups. The protocol is that of
`query_benchmark.py`, which keeps the truths on disk.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from loomlight.aggregate.queries import BANDS
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.metrics import OVERALL
from loomlight.evaluation.query_benchmark import (
    FOOTPRINTS,
    PAIRS,
    QueryBenchmark,
    model_predictor,
    run_query_benchmark,
)
from loomlight.evaluation.table import Table
from loomlight.fabric.fabric import Fabric
from loomlight.models.lobes.model import LobesModel, LobesOptions
from studies.harness.study import Figures, Found, Run, Study, listed_numbers
from studies.instruments.held_out import held_out_fabrics


def tested(groups: list[int], settings: LobesGroups, run: Run) -> tuple[QueryBenchmark, dict[int, list[int]]]:
    """The query benchmark of each number of groups, and the sizes of the tables of all fabrics, bytes."""
    sizes: dict[int, list[int]] = {count: [] for count in groups}

    def made(count: int, fabric: Fabric) -> LobesModel:
        model = LobesModel.for_source(fabric, LobesOptions(groups=count))
        sizes[count].append(model.tables.nbytes)
        return model

    result = run_query_benchmark(
        {str(count): model_predictor(partial(made, count)) for count in groups},
        held_out_fabrics(settings.fabrics),
        pairs=settings.pairs,
        footprints=settings.footprints,
        monte_carlo=(),
        progress=run.report,
    )
    return result, sizes


def of_groups(result: QueryBenchmark, name: str, sizes: list[int]) -> dict[str, Any]:
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


@dataclass(frozen=True)
class LobesGroups(Settings):
    groups: str = setting("1,2,4,8,16,32", "Numbers of groups of a family.", metavar="N,…")
    fabrics: int = setting(24, "Of the held-out fabrics, of every kind.", low=1, high=24)
    pairs: int = setting(PAIRS, "Pairs of directions of a fabric.", low=1)
    footprints: int = setting(FOOTPRINTS, "Footprints of a pair.", low=1)


def measure(settings: LobesGroups, run: Run) -> Found:
    """The curve of errors against groups."""
    groups = [int(count) for count in listed_numbers("groups", settings.groups)]
    result, sizes = tested(groups, settings, run)
    curve = [of_groups(result, str(count), sizes[count]) for count in groups]
    return Found({"fabrics": result.fabrics, "queries_per_fabric": result.queries, "curve": curve})


def tables(figures: Figures) -> list[Table]:
    """Errors by groups."""
    columns = [OVERALL, *BANDS, "transmission", "colour", "bytes fetched", "median table, bytes"]
    table = Table("nMAE by groups of each family", columns, note=f"{len(figures['fabrics'])} fabrics.")
    for point in figures["curve"]:
        table.rows[str(point["groups_a_family"])] = [
            *point["reflection"].values(),
            *(point[key] for key in ("transmission", "colour", "bytes_fetched")),
            point["table_bytes"]["median"],
        ]
    return [table]


STUDY = Study(
    "accuracy/lobes_groups",
    "how many groups `lobes` needs: its error in the query benchmark by groups of a family",
    LobesGroups(),
    measure,
    tables,
    stands_on=("lobes", "point"),
    small={"groups": "1,8", "fabrics": 1, "pairs": 4, "footprints": 4},
)
