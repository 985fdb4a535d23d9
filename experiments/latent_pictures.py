"""How near are pictures of `latent` to those of the layered materials that it replaces?

    python -m experiments.latent_pictures --steps 3000 [--try optimiser=adam,loss=relative]
        [--try rung=encoder] [--materials NAMES] [--views close,far] [--size WxH] [--spp N] [--runs DIR]
        [--folder DIR] [--output FILE.json]

Each `--try` is a training with those options of `latent` beside the default ones; without any, the defaults
alone. A row has the six errors of Tables 5 to 11 of zeltner2024, by material and view, and their means;
`train_s` are CPU seconds of a training, none where the folder of runs held it. Models and references have as
many samples a pixel; `noise` is the FLIP between two references.
"""

from __future__ import annotations

import time
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.harness import Figures, run
from loomlight.cli.values import parse_size
from loomlight.core.images import write_png
from loomlight.core.llvm import require_llvm
from loomlight.mitsuba import choose_variant
from loomlight.models.option_values import parse_options
from papers.figure import on_display
from papers.setting import LATENT, Setting
from papers.sheet import Row, Tile, contact_sheet
from papers.zeltner2024.layered_materials import LAYERED
from papers.zeltner2024.stage import (
    METRICS,
    model_factory,
    reference_factory,
    six_errors,
    stage_material,
    stage_picture,
    stage_scene,
    trained,
)


def measure(options: Namespace) -> Figures:
    require_llvm()
    choose_variant()
    setting = Setting(
        size=parse_size(options.size),
        samples=options.spp,
        runs=options.runs,
        model=LATENT,
        quality=options.quality,
        steps=options.steps,
    )
    tried = options.tried or [""]
    rows: dict[str, dict[str, Any]] = {text or "default": {} for text in tried}
    noise: dict[str, float] = {}
    sheet: list[Row] = []
    for name in options.materials.split(","):
        source = stage_material(name)
        models = {}
        for text in rows:
            chosen = parse_options(LATENT, [] if text == "default" else text.split(","))
            start = time.process_time()
            models[text] = trained(source, setting, **chosen)
            rows[text].setdefault("train_s", {})[name] = round(time.process_time() - start, 1)
        for view in options.views.split(","):
            scene = stage_scene(reference_factory(source), view, setting)
            reference, again = (stage_picture(scene, setting, seed) for seed in (2, 3))
            label = f"{name}, {view}"
            noise[label] = six_errors(again, reference, scene.counted).metrics[0]
            tiles = []
            for text, model in models.items():
                picture = stage_picture(stage_scene(model_factory(model), view, setting), setting)
                error = six_errors(picture, reference, scene.counted)
                rows[text].setdefault("errors", {})[label] = [float(f"{e:.4g}") for e in error.metrics]
                tiles.append(Tile(on_display(picture), f"FLIP {error.metrics[0]:.3f}"))
            sheet.append(Row(label, [*tiles, Tile(on_display(reference))]))
    for row in rows.values():
        means = np.mean(list(row["errors"].values()), axis=0)
        row["mean"] = {metric: float(f"{value:.4g}") for metric, value in zip(METRICS, means, strict=True)}
    if options.folder is not None:
        options.folder.mkdir(parents=True, exist_ok=True)
        pictures = contact_sheet("latent", [*rows, "reference"], sheet, "")
        write_png(options.folder / "latent_pictures.png", pictures)
    return {
        "metrics": list(METRICS),
        "size": options.size,
        "spp": options.spp,
        "steps": options.steps,
        "noise": {label: float(f"{value:.3g}") for label, value in noise.items()},
        "rows": rows,
    }


def _add_options(parser: ArgumentParser) -> None:
    parser.add_argument("--materials", default=",".join(LAYERED), help="names with commas between them")
    parser.add_argument("--views", default="close,far", help="of whole, close and far")
    parser.add_argument(
        "--try", dest="tried", action="append", help="options of a row: optimiser=adam,rung=mlp"
    )
    parser.add_argument("--quality", default="preview")
    parser.add_argument("--steps", type=int, default=3000)
    parser.add_argument("--runs", type=Path, default=Path("runs"))
    parser.add_argument("--folder", type=Path, default=None, help="for a sheet of pictures")
    parser.add_argument("--size", default="256x144")
    parser.add_argument("--spp", type=int, default=64)


if __name__ == "__main__":
    run(measure, _add_options)
