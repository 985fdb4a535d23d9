"""Tables 2, 3 and 4 of kuznetsov2021 of some of its five height fields, as one record.

    python -m experiments.neumip_materials [--materials NAMES] [--runs DIR] [--folder DIR] [--size WxH]
        [--spp N] [--steps N] [--resolution N] [--quality NAME] [--output FILE]

The tables are those of `python -m papers kuznetsov2021/table2 kuznetsov2021/table3 kuznetsov2021/table4`,
which makes them of all five. Trainings stay in the folder of runs and are used again.
"""

from __future__ import annotations

import time
from argparse import ArgumentParser, Namespace
from pathlib import Path

from benchmarks.harness import Figures, run
from loomlight.cli.values import parse_size
from loomlight.core.images import write_png
from loomlight.core.llvm import require_llvm
from papers.kuznetsov2021.materials import RECIPES
from papers.kuznetsov2021.tables import by_level, comparison, sizes
from papers.setting import NEUMIP, Setting


def measure(options: Namespace) -> Figures:
    """The tables; sheets go to `--folder`."""
    require_llvm()
    begun, names = time.process_time(), options.materials.split(",")
    setting = Setting(
        size=parse_size(options.size),
        samples=options.spp,
        runs=options.runs,
        model=NEUMIP,
        quality=options.quality,
        steps=options.steps,
        resolution=options.resolution,
    )
    figures: Figures = {"materials": names, "size": options.size}
    for name, evidence in (
        ("table2", comparison(setting, names)),
        ("table3", by_level(setting, names)),
        ("table4", sizes(setting)),
    ):
        figures[name] = [table.to_dict() for table in evidence.tables]
        if options.folder is not None:
            options.folder.mkdir(parents=True, exist_ok=True)
            write_png(options.folder / f"{name}.png", evidence.sheet)
    # Without trainings that the folder of runs held already.
    figures["cpu_seconds"] = round(time.process_time() - begun, 1)
    return figures


def _add_options(parser: ArgumentParser) -> None:
    parser.add_argument("--materials", default=",".join(RECIPES), help="names with commas between them")
    parser.add_argument("--runs", type=Path, default=Path("runs"))
    parser.add_argument("--folder", type=Path, default=None, help="for sheets of pictures")
    parser.add_argument("--size", default="384x216")
    parser.add_argument("--spp", type=int, default=64)
    parser.add_argument("--steps", type=int, default=None)
    parser.add_argument("--resolution", type=int, default=None, help="texels a side of the textures")
    parser.add_argument("--quality", default="preview")


if __name__ == "__main__":
    run(measure, _add_options)
