"""What a sample of cloth costs beside one of Mitsuba's `principled`, in the same picture of the same drape.

    python -m studies.speed.against_principled [--output FILE.json]

The picture is what `loomlight render` shows with daylight: the drape on its ground, the film's filter, paths
of up to 8 segments. All go through `footprint_path`; `principled` is also measured with Mitsuba's own `path`.
Microseconds are processor time of all cores over the samples of the camera, the least of several pictures
that are traced already (`LivePicture`). Each scene is freed before the next: kernels hold all living BSDFs.
`principled` is measured before and after every fabric, and ratios are to the mean of the two.
Bar: `lobes` costs at most 2.5 times as much.
"""

from __future__ import annotations

import gc
import time
from argparse import ArgumentParser, Namespace
from typing import Any

import mitsuba as mi

from loomlight.mitsuba import build_scene, choose_variant, material_bsdf
from loomlight.mitsuba.live import LivePicture
from studies.instruments.harness import REPOSITORY, Figures, run

FABRICS = ("denim", "silk-satin", "wool-houndstooth", "linen", "voile", "tweed")
MODELS = ("lobes", "point")
SIZE, SAMPLES, TURNS = (320, 240), 8, 5
BAR = 2.5
EXAMPLES = REPOSITORY / "examples"
# The simplest that a user would take for cloth; its back is black.
_PRINCIPLED = {
    "type": "principled",
    "base_color": {"type": "rgb", "value": [0.2, 0.3, 0.5]},
    "roughness": 0.6,
}


def microseconds(bsdf: Any, light: str, integrator: dict[str, Any] | None = None) -> float:
    """Processor time a sample of a picture of the drape."""
    shown = build_scene("drape", bsdf, size=SIZE, light=light)
    chosen = shown.integrator if integrator is None else mi.load_dict(integrator)
    live = LivePicture(shown.scene, integrator=chosen, spp=SAMPLES)
    taken = []
    for seed in range(TURNS):
        start = time.process_time()
        live.take(seed)
        taken.append(time.process_time() - start)
    # Freed while names still hold them, BSDFs would be in the next scene's kernel.
    del live, chosen, shown
    gc.collect()
    return min(taken) / (SIZE[0] * SIZE[1] * SAMPLES) * 1e6


def add_options(parser: ArgumentParser) -> None:
    """Which fabrics, models and light are measured."""
    parser.add_argument("--fabrics", default=",".join(FABRICS), help="names of examples")
    parser.add_argument("--models", default=",".join(MODELS))
    parser.add_argument("--light", default="sunsky")


def measure(options: Namespace) -> Figures:
    """Every fabric and model, and which fabrics miss the bar with `lobes`."""
    choose_variant()
    path = microseconds(_PRINCIPLED, options.light, {"type": "path", "max_depth": 8})
    before = microseconds(_PRINCIPLED, options.light)
    runs: dict[str, dict[str, Any]] = {}
    for name in options.fabrics.split(","):
        file = EXAMPLES / f"{name}.toml"
        costs = {
            model: microseconds(material_bsdf(file, model), options.light)
            for model in options.models.split(",")
        }
        after = microseconds(_PRINCIPLED, options.light)
        beside = (before + after) / 2
        before = after
        runs[name] = {
            "principled": round(beside, 3),
            **{model: round(cost, 3) for model, cost in costs.items()},
            "times_principled": {model: round(cost / beside, 2) for model, cost in costs.items()},
        }
        print(name, runs[name], flush=True)
    ratios = {name: figures["times_principled"].get("lobes", 0.0) for name, figures in runs.items()}
    return {
        "picture": f"drape, {options.light}, {SIZE[0]} × {SIZE[1]}, {SAMPLES} samples, 8 segments",
        "unit": "microseconds of processor time a sample",
        "principled_by_path": round(path, 3),
        "bar_lobes_times_principled": BAR,
        "missed": [name for name, ratio in ratios.items() if ratio > BAR],
        "runs": runs,
    }


if __name__ == "__main__":
    run(measure, add_options, prints=False)
