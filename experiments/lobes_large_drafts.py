"""The prefiltered lobes on drafts of hundreds of threads: error by band, table, baking.

    python experiments/lobes_large_drafts.py DRAFT.wif … --output experiments/results/lobes_large_drafts.json

A repeat of 641 by 641 threads is too large for one slice, so the truth is the mean of 4096 multi-jittered
samples a footprint (its own error, about 1 % of the mean, is part of what is reported); otherwise queries,
bands and metric are those of the query test. benchmarks/lobes.py has the cost of a query.
"""

from __future__ import annotations

import argparse
import json
import time
from pathlib import Path
from typing import Any

from loomlight.aggregate.queries import BANDS, admits_transmission, fabric_scale, query_set
from loomlight.assets.load import fabric_of_path
from loomlight.core.llvm import require_llvm
from loomlight.core.provenance import provenance
from loomlight.evaluation.metrics import Classes, sums_by_class
from loomlight.evaluation.predictions import model_predictor, monte_carlo_predictor
from loomlight.evaluation.query_test import grey_value
from loomlight.evaluation.table import write_json
from loomlight.fabric.fabric import Fabric
from loomlight.models.lobes.model import LobesModel

PAIRS, FOOTPRINTS, SAMPLES = 120, 40, 4096


def errors(fabric: Fabric, model: LobesModel) -> dict[str, dict[str, float]]:
    """NMAE of grey f·cos in reflection by band, of the lobes and of a few samples."""
    scale = fabric_scale(fabric.layout())
    queries = query_set(scale, PAIRS, FOOTPRINTS, 0, transmits=admits_transmission(fabric.appearance()))
    near = queries.lights[queries.pairs[:, 0], 2] * queries.views[queries.pairs[:, 1], 2] > 0
    truth = grey_value(monte_carlo_predictor(SAMPLES, seed=1)(fabric, queries).means)[near]
    rows = {
        "lobes": model_predictor(lambda _: model),
        "3 samples": monte_carlo_predictor(3),
        "8 samples": monte_carlo_predictor(8),
        f"{SAMPLES} other samples": monte_carlo_predictor(SAMPLES, seed=2),
    }
    bands = [Classes(BANDS, scale.bands(queries.sizes)[near])]
    found = {}
    for name, predict in rows.items():
        guess = grey_value(predict(fabric, queries).means)[near]
        sums = sums_by_class(guess, truth, bands)
        found[name] = {part: round(total.nmae, 4) for part, total in sums.items() if total.count}
    return found


def main() -> None:
    """Runs the experiment and prints it."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("drafts", nargs="+")
    parser.add_argument("--output", type=Path, default=None)
    arguments = parser.parse_args()
    require_llvm()
    names = " ".join(Path(text).name for text in arguments.drafts)
    result: dict[str, Any] = {
        **provenance(f"python experiments/lobes_large_drafts.py {names}", Path(__file__).parent),
        "drafts": {},
    }
    for text in arguments.drafts:
        fabric = fabric_of_path(text)
        LobesModel.for_source(fabric)
        start = time.perf_counter()
        model = LobesModel.for_source(fabric)
        seconds = time.perf_counter() - start
        picks, ends = fabric.layout().warp_on_top.shape
        result["drafts"][Path(text).name] = {
            "ends": ends,
            "picks": picks,
            "baking_seconds": round(seconds, 3),
            "table_megabytes": round(model.tables.nbytes / 1e6, 2),
            "nmae_of_reflection": errors(fabric, model),
        }
        print(json.dumps(result["drafts"][Path(text).name], indent=2), flush=True)
    if arguments.output is not None:
        write_json(arguments.output, result, digits=None)


if __name__ == "__main__":
    main()
