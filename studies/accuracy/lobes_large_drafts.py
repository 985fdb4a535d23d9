"""The prefiltered lobes on drafts of hundreds of threads: error by band, table, baking.

    python -m studies.accuracy.lobes_large_drafts DRAFT.wif … --output FILE.json

A repeat of 641 by 641 threads is too large for one slice, so the truth is the mean of 4096 multi-jittered
samples a footprint (its own error, about 1 % of the mean, is part of what is reported); otherwise queries,
bands and metric are those of the query benchmark. `studies.speed.lobes` has the cost of a query.
"""

from __future__ import annotations

import json
from argparse import ArgumentParser, Namespace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.aggregate.queries import BANDS, admits_transmission, fabric_scale, query_set
from loomlight.core.llvm import require_llvm
from loomlight.evaluation.metrics import Classes, sums_by_class
from loomlight.evaluation.query_benchmark import (
    Prediction,
    grey_value,
    model_predictor,
    monte_carlo_predictor,
)
from loomlight.fabric.fabric import Fabric
from loomlight.models.lobes.model import LobesModel
from loomlight.sources.load import fabric_of_path
from studies.instruments.harness import Figures, run
from studies.instruments.timing import timed

PAIRS, FOOTPRINTS, SAMPLES = 120, 40, 4096


def grey_means(prediction: Prediction) -> NDArray[np.float64]:
    """Grey f·cos of predictions of a model that separates albedos."""
    assert prediction.means is not None
    return grey_value(prediction.means)


def errors(fabric: Fabric, model: LobesModel) -> dict[str, dict[str, float]]:
    """NMAE of grey f·cos in reflection by band, of the lobes and of a few samples."""
    scale = fabric_scale(fabric.layout())
    queries = query_set(scale, PAIRS, FOOTPRINTS, 0, transmits=admits_transmission(fabric.appearance()))
    near = queries.lights[queries.pairs[:, 0], 2] * queries.views[queries.pairs[:, 1], 2] > 0
    truth = grey_means(monte_carlo_predictor(SAMPLES, seed=1)(fabric, queries))[near]
    rows = {
        "lobes": model_predictor(lambda _: model),
        "3 samples": monte_carlo_predictor(3),
        "8 samples": monte_carlo_predictor(8),
        f"{SAMPLES} other samples": monte_carlo_predictor(SAMPLES, seed=2),
    }
    bands = [Classes(BANDS, scale.bands(queries.sizes)[near])]
    by_name = {}
    for name, predict in rows.items():
        guess = grey_means(predict(fabric, queries))[near]
        sums = sums_by_class(guess, truth, bands)
        by_name[name] = {part: round(total.nmae, 4) for part, total in sums.items() if total.count}
    return by_name


def add_options(parser: ArgumentParser) -> None:
    """Which drafts."""
    parser.add_argument("drafts", nargs="+")


def measure(options: Namespace) -> Figures:
    """Size, baking and errors of each draft, as they come."""
    require_llvm()
    drafts: dict[str, dict[str, Any]] = {}
    for text in options.drafts:
        fabric = fabric_of_path(text)
        LobesModel.for_source(fabric)
        model, seconds = timed(partial(LobesModel.for_source, fabric))
        picks, ends = fabric.layout().warp_on_top.shape
        drafts[Path(text).name] = {
            "ends": ends,
            "picks": picks,
            "baking_seconds": round(seconds, 3),
            "table_megabytes": round(model.tables.nbytes / 1e6, 2),
            "nmae_of_reflection": errors(fabric, model),
        }
        print(json.dumps(drafts[Path(text).name], indent=2), flush=True)
    return {"drafts": drafts}


if __name__ == "__main__":
    run(measure, add_options, prints=False)
