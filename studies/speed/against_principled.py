"""What a sample of cloth costs beside one of Mitsuba's `principled`, in the same picture of the same drape.

The picture is what `loomlight render` shows with daylight: the drape on its ground, the film's filter, paths
of up to 8 segments. All go through `footprint_path`; `principled` is also measured with Mitsuba's own `path`.
Microseconds are processor time of all cores over the samples of the camera, the least of several pictures
that are traced already (`LivePicture`). Each scene is freed before the next: kernels hold all living BSDFs.
`principled` is measured before and after every fabric, and ratios are to the mean of the two.
Bar: `lobes` costs at most 2.5 times as much.
"""

from __future__ import annotations

import gc
import math
from dataclasses import dataclass
from functools import partial
from typing import Any

import mitsuba as mi

from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.mitsuba import LIGHTS, build_scene, choose_variant, material_bsdf
from loomlight.mitsuba.live import LivePicture
from loomlight.models.registry import MODELS
from studies.harness.study import Figures, Found, Run, Study, example, listed, names
from studies.instruments.timing import spent

FABRICS = ("denim", "silk-satin", "wool-houndstooth", "linen", "voile", "tweed")
BAR = 2.5
# The simplest that a user would take for cloth; its back is black.
_PRINCIPLED = {
    "type": "principled",
    "base_color": {"type": "rgb", "value": [0.2, 0.3, 0.5]},
    "roughness": 0.6,
}


def microseconds(bsdf: Any, settings: AgainstPrincipled, integrator: dict[str, Any] | None = None) -> float:
    """Processor time a sample of a picture of the drape."""
    shown = build_scene("drape", bsdf, size=settings.size, light=settings.light)
    chosen = shown.integrator if integrator is None else mi.load_dict(integrator)
    live = LivePicture(shown.scene, integrator=chosen, spp=settings.samples)
    taken = [spent(partial(live.take, seed))[1].cpu_seconds for seed in range(settings.turns)]
    # Freed while names still hold them, BSDFs would be in the next scene's kernel.
    del live, chosen, shown
    gc.collect()
    return min(taken) / (math.prod(settings.size) * settings.samples) * 1e6


@dataclass(frozen=True)
class AgainstPrincipled(Settings):
    fabrics: str = names(",".join(FABRICS), "Example fabrics.")
    models: str = names("lobes,point", "Models.", tuple(MODELS))
    light: str = setting("sunsky", "Of the scene.", choices=LIGHTS)
    size: tuple[int, int] = setting((320, 240), "Pixels.", low=8)
    samples: int = setting(8, "A pixel.", low=1)
    turns: int = setting(5, "Pictures of each.", low=1)


def measure(settings: AgainstPrincipled, run: Run) -> Found:
    """Every fabric and model, and which fabrics miss the bar with `lobes`."""
    choose_variant()
    path = microseconds(_PRINCIPLED, settings, {"type": "path", "max_depth": 8})
    before = microseconds(_PRINCIPLED, settings)
    runs: dict[str, dict[str, Any]] = {}
    for name in listed(settings.fabrics):
        file = example(name)
        costs = {
            model: microseconds(material_bsdf(file, model), settings) for model in listed(settings.models)
        }
        after = microseconds(_PRINCIPLED, settings)
        beside = (before + after) / 2
        before = after
        runs[name] = {
            "principled": round(beside, 3),
            **{model: round(cost, 3) for model, cost in costs.items()},
            "times_principled": {model: round(cost / beside, 2) for model, cost in costs.items()},
        }
        run.report(len(runs), len(listed(settings.fabrics)))
    width, height = settings.size
    ratios = {name: figures["times_principled"].get("lobes", 0.0) for name, figures in runs.items()}
    return Found(
        {
            "picture": f"drape, {settings.light}, {width} × {height}, {settings.samples} samples, 8 segments",
            "unit": "microseconds of processor time a sample",
            "principled_by_path": round(path, 3),
            "bar_lobes_times_principled": BAR,
            "missed": [name for name, ratio in ratios.items() if ratio > BAR],
            "runs": runs,
        }
    )


def tables(figures: Figures) -> list[Table]:
    """Microseconds a sample, and how many times those of `principled`."""
    runs = figures["runs"]
    models = list(dict.fromkeys(model for run in runs.values() for model in run["times_principled"]))
    rows = {
        name: [
            run["principled"],
            *(run[model] for model in models),
            *(run["times_principled"][m] for m in models),
        ]
        for name, run in runs.items()
    }
    columns = ["`principled`, µs", *(f"`{m}`, µs" for m in models), *(f"`{m}`, times" for m in models)]
    by_path = figures["principled_by_path"]
    note = f"By Mitsuba's own `path`, `principled` takes {by_path} µs; {figures['picture']}."
    return [Table("A sample beside `principled`", columns, rows, note)]


STUDY = Study(
    "speed/against_principled",
    "what a sample of cloth costs beside one of Mitsuba's `principled`, in the same picture",
    AgainstPrincipled(),
    measure,
    tables,
    stands_on=("lobes cost", "point cost"),
    small={"fabrics": "denim", "models": "lobes", "size": (32, 24), "samples": 1, "turns": 2},
)
