"""kuznetsov2021: Table 3 with Fig. 11, and Table 4.

How does the error of ours fall with the level of detail? Each material is trained once by the published
recipe and seen at levels 0 to 7, whose middle pixel has a footprint of 2^level texels; MSE × 1000 of π f·cos
without the reference's noise, and FLIP with it. Table 4 counts weights of networks and numbers of a texel;
nothing is trained for it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache, partial

import numpy as np
from numpy.typing import NDArray

from loomlight.core.settings import setting
from loomlight.evaluation.table import Cell, Table
from loomlight.sources.heightfield import Heightfield
from studies.harness.parts import Parts
from studies.harness.study import Figures, Found, NoSettings, Run, Study, on_display, with_tables
from studies.instruments.halved_truth import HalvedTruth
from studies.instruments.sheet import PictureTable, Row, Tile, contact_sheet, error_caption
from studies.papers.kuznetsov2021.designs import DESIGNS, OURS, RAINER19, RAINER20, WITHOUT
from studies.papers.kuznetsov2021.stage import (
    MaterialsSettings,
    Predict,
    model_picture,
    plane_shot,
    predictor,
    stage_error,
    stage_settings,
    traced,
)

# MSE times 1000 of Table 3 by level.
_PAPER_TABLE3 = {
    "twisted wool": (3.98, 2.10, 1.47, 1.07, 0.74, 1.16, 1.17, 1.08),
    "straight wool": (0.39, 0.16, 0.11, 0.08, 0.09, 0.05, 0.03, 0.10),
    "turtle shell": (1.31, 0.92, 0.70, 0.67, 0.88, 0.82, 0.55, 0.48),
    "cliff rock": (2.00, 0.87, 0.63, 0.51, 0.42, 0.32, 0.24, 0.10),
    "insulation foam": (3.90, 1.64, 1.20, 0.86, 0.76, 0.55, 0.57, 0.49),
}
# Weights and texture channels of Table 4, in the order of its columns.
_PAPER_TABLE4 = {OURS: (3332, 14), RAINER19: (35725, 14), RAINER20: (38269, 38)}


@dataclass(frozen=True)
class LevelsSettings(MaterialsSettings):
    """Of figures over levels of detail."""

    levels: int = setting(8, "Levels of detail, from the finest.", low=1, high=8)


def by_level(settings: LevelsSettings, run: Run) -> Found:
    """Table 3: the error of ours over levels of detail."""
    return Found(_errors_by_level(settings, run, lambda case: case.errors()))


def zooms(settings: LevelsSettings, run: Run) -> Found:
    """Fig. 11: the materials at eight levels of detail, ours above the reference."""
    sources = settings.sources()
    shown = PictureTable("kuznetsov2021 figure 11: levels of detail", _columns(settings))
    tiles: dict[str, tuple[list[Tile], list[Tile]]] = {source.name: ([], []) for source in sources}

    def shot(case: Zoom) -> list[float]:
        picture, truth = case.pictures()
        error = stage_error(picture, truth)
        above, below = tiles[case.source.name]
        above.append(Tile(on_display(picture), error_caption(error)))
        below.append(Tile(on_display(truth.picture)))
        return [1e3 * error.mse, error.flip]

    # Pictures are not kept with numbers: a run that is stopped begins anew, with its trainings.
    figures = _errors_by_level(settings, replace(run, parts=Parts()), shot)
    for name, (above, below) in tiles.items():
        shown.add(name, above)
        shown.add(f"{name}, reference", below)
    return shown.found(figures, _note(settings))


@dataclass(frozen=True, eq=False)
class Zoom:
    """A material at a level of detail.

    Attributes:
        predict: values of the training of the material, which is made when it is first asked for.
        texel_mm: side of a texel of level 0.
    """

    source: Heightfield
    level: int
    predict: Callable[[], Predict]
    texel_mm: float
    settings: LevelsSettings

    def pictures(self) -> tuple[NDArray[np.float32], HalvedTruth]:
        """Of ours, and of the reference."""
        shot = plane_shot(self.source, self.texel_mm, self.level, self.settings.size)
        return model_picture(self.predict(), shot), traced(self.source, shot, self.settings.spp)

    def errors(self) -> list[float]:
        """MSE × 1000 and FLIP."""
        error = stage_error(*self.pictures())
        return [1e3 * error.mse, error.flip]


def _errors_by_level(settings: LevelsSettings, run: Run, errors_of: Callable[[Zoom], list[float]]) -> Figures:
    """Tables of MSE and FLIP by material and level, beside the paper's."""
    sources, columns = settings.sources(), _columns(settings)
    texel_mm = stage_settings(settings).shape(sources[0], faces=1).texel_mm
    cases = {}
    for source in sources:
        predict = cache(partial(predictor, source, settings, run.runs, OURS))
        for level in range(settings.levels):
            cases[f"{source.name}, {level}"] = Zoom(source, level, predict, texel_mm, settings)
    found = run.each({name: partial(errors_of, case) for name, case in cases.items()})
    squared, flip = (
        Table("MSE × 1000 by level", columns, note=_note(settings)),
        Table("FLIP by level", columns),
    )
    for place, table in enumerate((squared, flip)):
        for source in sources:
            table.rows[source.name] = [found[f"{source.name}, {level}"][place] for level in columns]
    rows_of_paper: dict[str, list[Cell]] = {
        name: [*row[: len(columns)]] for name, row in _PAPER_TABLE3.items()
    }
    return with_tables(squared, flip, Table("MSE × 1000 in the paper", columns, rows_of_paper))


def _columns(settings: LevelsSettings) -> list[str]:
    return [str(level) for level in range(settings.levels)]


def sizes(settings: NoSettings, run: Run) -> Found:
    """Table 4: weights of the networks and numbers of a texel; nothing is trained."""
    columns = [name for name in DESIGNS if name != WITHOUT]
    table = Table("Sizes", columns)
    table.rows["weights"] = [DESIGNS[name].weights for name in columns]
    table.rows["weights in the paper"] = [_PAPER_TABLE4[name][0] for name in columns]
    table.rows["ratio to ours"] = [DESIGNS[name].weights / DESIGNS[OURS].weights for name in columns]
    table.rows["channels of a texel"] = [DESIGNS[name].channels for name in columns]
    table.rows["channels in the paper"] = [_PAPER_TABLE4[name][1] for name in columns]
    lines = [
        Row(f"{name}: {', '.join(table.shown(cell) for cell in cells)}", [Tile(None)])
        for name, cells in table.rows.items()
    ]
    return Found(with_tables(table), contact_sheet("kuznetsov2021 table 4", [], lines, ", ".join(columns)))


def _note(settings: LevelsSettings) -> str:
    used = stage_settings(settings)
    a_texel = used.queries // (used.resolution or used.max_resolution) ** 2
    return (
        f"Textures of {used.resolution} texels a side, {a_texel} queries a texel of {used.samples} "
        f"paths, {used.steps} steps of {used.batch} queries (the paper: 512, 200 to 400 of 64, 30000 of "
        f"2^20); references of {settings.spp} paths a pixel."
    )


_SMALL = {
    "size": (16, 9),
    "spp": 4,
    "steps": 3,
    "resolution": 8,
    "side": 16,
    "materials": "turtle shell",
    "levels": 2,
}
STUDIES = (
    Study(
        "papers/kuznetsov2021/table3",
        "the error of ours over eight levels of detail",
        LevelsSettings(),
        by_level,
        stands_on=("neumip",),
        small=_SMALL,
    ),
    Study(
        "papers/kuznetsov2021/table4",
        "weights of the networks and channels of the textures",
        NoSettings(),
        sizes,
    ),
    Study(
        "papers/kuznetsov2021/fig11",
        "five height fields at eight levels of detail, over the reference",
        LevelsSettings(),
        zooms,
        stands_on=("neumip",),
        small=_SMALL,
    ),
)
