"""Is `latent` faster than the layered material that it stands for? CPU seconds of the same picture.

    python -m papers.zeltner2024.speed [--output papers/zeltner2024/results/speed.json]

The stage of zeltner2024's tables: the same sphere, light, samples and length of paths, rendered in turns with
Mitsuba's own layers and with `latent` of each decoder. Kernels are compiled by a picture before. Weights
change no time, so that trainings are of a few steps. A row has CPU seconds, the least of each, and `speedup`.
"""

from __future__ import annotations

import time
from argparse import ArgumentParser, Namespace
from pathlib import Path

from benchmarks.harness import Figures, run
from papers.setting import Setting
from papers.zeltner2024.stage import (
    model_factory,
    reference_factory,
    stage_material,
    stage_picture,
    stage_scene,
    trained,
)

_MATERIALS = ("glazed-ceramic", "brushed-metal", "rough-plastic", "patinated-metal")


def measure(options: Namespace) -> Figures:
    setting = Setting(
        size=(options.width, options.width * 9 // 16),
        samples=options.samples,
        model="latent",
        steps=30,
        runs=options.runs,
    )
    rows = {}
    for name in options.materials:
        source = stage_material(name)
        factories = {"reference": reference_factory(source)}
        factories |= {
            decoder: model_factory(trained(source, setting, decoder)) for decoder in options.decoders
        }
        scenes = {way: stage_scene(factory, "whole", setting) for way, factory in factories.items()}
        seconds: dict[str, list[float]] = {way: [] for way in scenes}
        for turn in range(options.turns + 1):
            for way, scene in scenes.items():
                start = time.process_time()
                stage_picture(scene, setting, seed=turn)
                if turn:
                    seconds[way].append(time.process_time() - start)
        least = {way: min(times) for way, times in seconds.items()}
        rows[name] = {way: round(spent, 3) for way, spent in least.items()} | {
            f"speedup {way}": round(least["reference"] / spent, 2)
            for way, spent in least.items()
            if way != "reference"
        }
    return {"samples": options.samples, "width": options.width, "rows": rows}


def _add_options(parser: ArgumentParser) -> None:
    parser.add_argument("--materials", nargs="+", default=_MATERIALS, choices=_MATERIALS)
    parser.add_argument("--decoders", nargs="+", default=["2x32"])
    parser.add_argument("--samples", type=int, default=32)
    parser.add_argument("--width", type=int, default=256)
    parser.add_argument("--turns", type=int, default=3)
    parser.add_argument("--runs", type=Path, default=Path("out/runs"), help="keeps trainings")


if __name__ == "__main__":
    run(measure, _add_options)
