"""kuznetsov2021: how much of an error of random queries a few bright ones are.

Errors of `table2` by level are of 2000 random queries. Smooth materials have grazing highlights far above
white, and a model that misses one errs by its square: how much would a black picture err by all queries, by
the brightest one, and by all with values clamped to white? Of the brightest the table says how bright it is,
and how far its view is from the normal. Nothing is trained: all designs see the same queries.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from loomlight.core.settings import same_setting
from loomlight.evaluation.table import Table
from loomlight.models.texture.settings import NeumipOptions
from studies.harness.study import Found, Run, Study, with_tables
from studies.papers.kuznetsov2021.equal_cost import BUDGETS, PROBE_RAYS, CostSettings, probe_shot
from studies.papers.kuznetsov2021.stage import HeightfieldsSettings, clamped, traced

# Of the table whose errors are looked into.
_RESOLUTION = BUDGETS["preview"].resolution


@dataclass(frozen=True)
class BrightSettings(HeightfieldsSettings):
    """Of random queries of `table2`."""

    levels: int = same_setting(CostSettings, "levels")
    probes: int = same_setting(CostSettings, "probes")


def bright_queries(settings: BrightSettings, run: Run) -> Found:
    """Squares of random queries, and of the brightest, by material and level."""
    table = Table(
        "Brightest of random queries",
        [
            "π f·cos",
            "degrees from the normal",
            "MSE × 1000 of black",
            "of the brightest alone",
            "of all, clamped to 1",
            "above 1, %",
        ],
        note=f"{settings.probes} queries a level, as of table 2 at {_RESOLUTION} texels a side.",
    )
    sources = settings.sources()
    for number, source in enumerate(sources):
        shape = NeumipOptions(resolution=_RESOLUTION).settings(is_fabric=False).shape(source, faces=1)
        for level in range(settings.levels):
            shot = probe_shot(source, shape.texel_mm * 2**level, level, settings.probes)
            truth = traced(source, shot, PROBE_RAYS)
            colours = truth.picture[0]
            brightest = int(colours.mean(axis=1).argmax())
            black = np.zeros_like(truth.picture)
            alone = math.prod(half[0, brightest].astype(np.float64) for half in truth.halves)
            table.rows[f"{source.name}, {level}"] = [
                float(colours[brightest].mean()),
                math.degrees(math.acos(float(shot.views[brightest, 2]))),
                1e3 * truth.squared_error(black),
                1e3 * float(np.mean(alone)) / settings.probes,
                1e3 * clamped(truth).squared_error(black),
                100 * float((colours.max(axis=1) > 1).mean()),
            ]
        run.report(number + 1, len(sources))
    return Found(with_tables(table))


STUDY = Study(
    "papers/kuznetsov2021/bright_queries",
    "how much of an error of random queries a few bright ones are",
    BrightSettings(),
    bright_queries,
    small={"side": 16, "levels": 2, "probes": 64, "materials": "turtle shell"},
)
