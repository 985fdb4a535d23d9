"""The prefiltered lobes on drafts of hundreds of threads: error by band, table, baking.

A repeat of 641 by 641 threads is too large for one slice, so the truth is the mean of 4096 multi-jittered
samples a footprint (its own error, about 1 % of the mean, is part of what is reported); otherwise queries,
bands and metric are those of the query benchmark.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.aggregate.queries import BANDS, admits_transmission, fabric_scale, query_set
from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.metrics import OVERALL, Classes, sums_by_class
from loomlight.evaluation.query_benchmark import (
    Prediction,
    grey_value,
    model_predictor,
    monte_carlo_predictor,
)
from loomlight.evaluation.table import Cell, Table
from loomlight.fabric.fabric import Fabric
from loomlight.models.lobes.model import LobesModel
from loomlight.sources.load import fabric_of_path
from studies.harness.study import Figures, Found, Run, Study, listed, names, outside_data
from studies.instruments.timing import timed

DRAFTS = ("multi-byte-liftplan.wif", "multi-byte-multi-treadled.wif", "multi-byte-single-treadled.wif")


def grey_means(prediction: Prediction) -> NDArray[np.float64]:
    """Grey f·cos of predictions of a model that separates albedos."""
    assert prediction.means is not None
    return grey_value(prediction.means)


def errors(fabric: Fabric, model: LobesModel, settings: LobesLargeDrafts) -> dict[str, dict[str, float]]:
    """NMAE of grey f·cos in reflection by band, of the lobes and of a few samples."""
    scale = fabric_scale(fabric.layout())
    transmits = admits_transmission(fabric.appearance())
    queries = query_set(scale, settings.pairs, settings.footprints, 0, transmits=transmits)
    near = queries.lights[queries.pairs[:, 0], 2] * queries.views[queries.pairs[:, 1], 2] > 0
    truth = grey_means(monte_carlo_predictor(settings.samples, seed=1)(fabric, queries))[near]
    rows = {
        "lobes": model_predictor(lambda _: model),
        "3 samples": monte_carlo_predictor(3),
        "8 samples": monte_carlo_predictor(8),
        f"{settings.samples} other samples": monte_carlo_predictor(settings.samples, seed=2),
    }
    bands = [Classes(BANDS, scale.bands(queries.sizes)[near])]
    by_name = {}
    for name, predict in rows.items():
        guess = grey_means(predict(fabric, queries))[near]
        sums = sums_by_class(guess, truth, bands)
        by_name[name] = {part: round(total.nmae, 4) for part, total in sums.items() if total.count}
    return by_name


@dataclass(frozen=True)
class LobesLargeDrafts(Settings):
    drafts: str = names("", "Drafts; by default three of the folder LOOMLIGHT_DATA.")
    pairs: int = setting(120, "Pairs of directions.", low=1)
    footprints: int = setting(40, "Footprints of a pair.", low=1)
    samples: int = setting(4096, "Of the truth, a footprint.", low=8)


def measure(settings: LobesLargeDrafts, run: Run) -> Found:
    """Size, baking and errors of each draft, as they come."""
    require_llvm()
    files = listed(settings.drafts) or [os.fspath(outside_data("wif", "good", name)) for name in DRAFTS]
    return Found({"drafts": run.each({Path(file).name: partial(of_draft, file, settings) for file in files})})


def of_draft(file: str, settings: LobesLargeDrafts) -> dict[str, Any]:
    """Size, baking and errors of a draft."""
    fabric = fabric_of_path(file)
    LobesModel.for_source(fabric)
    model, seconds = timed(partial(LobesModel.for_source, fabric))
    picks, ends = fabric.layout().warp_on_top.shape
    return {
        "ends": ends,
        "picks": picks,
        "baking_seconds": round(seconds, 3),
        "table_megabytes": round(model.tables.nbytes / 1e6, 2),
        "nmae_of_reflection": errors(fabric, model, settings),
    }


def tables(figures: Figures) -> list[Table]:
    """Error of the lobes and of a few samples, baking and tables by draft."""
    columns = ["ends", "picks", "bake, s", "table, MB", "`lobes`", "3 samples", "8 samples"]
    rows: dict[str, list[Cell]] = {}
    for name, found in figures["drafts"].items():
        errors = [found["nmae_of_reflection"][kind][OVERALL] for kind in ("lobes", "3 samples", "8 samples")]
        sizes = [found[key] for key in ("ends", "picks", "baking_seconds", "table_megabytes")]
        rows[name] = [*sizes, *errors]
    return [Table("nMAE of reflection on large drafts", columns, rows)]


STUDY = Study(
    "accuracy/lobes_large_drafts",
    "the prefiltered lobes on drafts of hundreds of threads: error by band, tables, baking",
    LobesLargeDrafts(),
    measure,
    tables,
    stands_on=("lobes", "point"),
    small={"pairs": 4, "footprints": 4, "samples": 64},
)
