"""kuznetsov2021: Table 3 with Fig. 11, and Table 4."""

from __future__ import annotations

from collections.abc import Sequence

from loomlight.evaluation.metrics import PictureError
from loomlight.evaluation.table import Table
from studies.instruments.sheet import Row, Tile, contact_sheet
from studies.papers.figure import Evidence, Pixels, error_caption, on_display
from studies.papers.kuznetsov2021.designs import DESIGNS, OURS, RAINER19, RAINER20, WITHOUT
from studies.papers.kuznetsov2021.materials import RECIPES
from studies.papers.kuznetsov2021.stage import (
    model_picture,
    plane_shot,
    predictor,
    stage_error,
    stage_material,
    stage_settings,
    traced,
)
from studies.papers.setting import Setting

# Levels of Table 3.
LEVELS = range(8)
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


def by_level(setting: Setting, materials: Sequence[str] | None = None) -> Evidence:
    """Table 3: the error of ours over levels of detail.

    Args:
        materials: some of `RECIPES`; all by default.
    """
    return _zooms(setting, "kuznetsov2021 table 3: error by level", False, list(materials or RECIPES))


def zooms(setting: Setting) -> Evidence:
    """Fig. 11: the materials at eight levels of detail, ours above the reference."""
    return _zooms(setting, "kuznetsov2021 figure 11: levels of detail", True, list(RECIPES))


def _zooms(setting: Setting, title: str, with_reference: bool, names: list[str]) -> Evidence:
    """Pictures of ours at all levels, over those of the reference if asked."""
    columns = [str(level) for level in LEVELS]
    squared, flip = Table("MSE × 1000 by level", columns), Table("FLIP by level", columns)
    rows: list[Row] = []
    pictures: dict[str, Pixels] = {}
    done, total = 0, len(names) * len(LEVELS)
    for name in names:
        source = stage_material(name)
        predict = predictor(source, setting, OURS)
        tiles: list[Tile] = []
        below: list[Tile] = []
        errors: list[PictureError] = []
        for level in LEVELS:
            shot = plane_shot(source, _texel_mm(setting), level, setting.size)
            picture, truth = model_picture(predict, shot), traced(source, shot, setting.samples)
            errors.append(stage_error(picture, truth))
            tiles.append(Tile(on_display(picture), error_caption(errors[-1])))
            below.append(Tile(on_display(truth.mean)))
            pictures[f"{name}-{level}"] = on_display(picture)
            pictures[f"{name}-{level}-reference"] = on_display(truth.mean)
            done += 1
            setting.step(done, total)
        squared.rows[name] = [1e3 * error.mse for error in errors]
        flip.rows[name] = [error.flip for error in errors]
        rows.append(Row(name, tiles))
        if with_reference:
            rows.append(Row(f"{name}, reference", below))
    note = squared.note = _note(setting)
    paper = Table("MSE × 1000 in the paper", columns, {name: [*row] for name, row in _PAPER_TABLE3.items()})
    return Evidence(contact_sheet(title, columns, rows, note), pictures, [squared, flip, paper])


def sizes(setting: Setting) -> Evidence:
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
    setting.step(1, 1)
    return Evidence(contact_sheet("kuznetsov2021 table 4", [], lines, ", ".join(columns)), {}, [table])


def _texel_mm(setting: Setting) -> float:
    """Side of a texel of level 0 of the trainings, millimetres."""
    source = stage_material(next(iter(RECIPES)))
    return stage_settings(setting).shape(source, faces=1).texel_mm


def _note(setting: Setting) -> str:
    used = stage_settings(setting)
    a_texel = used.queries // (used.resolution or used.max_resolution) ** 2
    return (
        f"Textures of {used.resolution} texels a side, {a_texel} queries a texel of {used.samples} "
        f"paths, {used.steps} steps of {used.batch} queries (the paper: 512, 200 to 400 of 64, 30000 of "
        f"2^20); references of {setting.samples} paths a pixel."
    )
