"""Which model for which samples: error and processor time of one picture of the drape, four unlike fabrics.

The fabrics are a twill of two colours, a satin, a figured damask, and a draft without a short repeat. Two of
`compare`'s scenes show each, from near and from afar. Errors are root mean squares over the mean, against a
picture of the point model in two halves, whose own noise is in no error (`HalvedTruth`). What is left of
many samples is the model's bias. Seconds are processor time of all cores, of pictures whose kernels are
compiled. Pictures of most samples are kept, beside the truth.
"""

from __future__ import annotations

import gc
import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Cell, Table
from loomlight.fabric import Fabric, load_fabric
from loomlight.mitsuba import choose_variant, render
from loomlight.mitsuba.live import LivePicture
from loomlight.mitsuba.measured_scenes import MeasuredScene, measured_scene
from loomlight.models.registry import MODELS as REGISTRY
from studies.harness.study import EXAMPLES, Figures, Found, Pixels, Run, Study, listed, names, on_display
from studies.instruments.halved_truth import HalvedTruth
from studies.instruments.timing import least_times

FABRICS = ("denim.toml", "silk-satin.toml", "damask.toml", "undulating-twill.wif")
MODELS = ("point", "samples", "lobes", "clustered", "neural")
SAMPLES = (1, 4, 16, 64, 256)
TURNS = 2
# Samples whose seconds the table has.
TIMED = (1, 16)
# More samples a pixel are not timed, but extended from these.
_MAX_TIMED = 16
_SEED, _TRUTH_SEED = 7, 1000

Linear = NDArray[np.float32]


def shown(scene: MeasuredScene, samples: int, seed: int) -> Linear:
    """Linear RGB [height, width, 3]."""
    return render(scene.scene, spp=samples, seed=seed, integrator=scene.integrator)


def cpu_seconds(scene: MeasuredScene, samples: int) -> float:
    """Processor time of a picture whose kernels are compiled."""
    few = min(samples, _MAX_TIMED)
    fewer = max(few // 4, 1)
    lives = [LivePicture(scene.scene, integrator=scene.integrator, spp=count) for count in (few, fewer)]
    of_few, of_fewer = (spent.cpu_seconds for spent in least_times([live.take for live in lives], TURNS))
    if samples == few:
        return of_few
    return of_few + (samples - few) * max(of_few - of_fewer, 0) / (few - fewer)


def measured(fabric: Fabric, scene: str, settings: WhichModel) -> tuple[dict[str, Any], dict[str, Linear]]:
    """One fabric in one scene: error and seconds of each model by samples; pictures of the most samples."""
    counts = [count for count in SAMPLES if count <= settings.most]
    exact = measured_scene(scene, [fabric], "point", settings.size)
    half = settings.truth // 2
    truth = HalvedTruth((shown(exact, half, _TRUTH_SEED), shown(exact, half, _TRUTH_SEED + 1)))
    counted = exact.counted
    mean = float(truth.picture[counted].mean())
    del exact
    kept = {"truth": truth.picture}
    rows: dict[str, Any] = {}
    for model in listed(settings.models):
        # Freed while names hold them, BSDFs would be in the next scene's kernel.
        gc.collect()
        try:
            of_model = measured_scene(scene, [fabric], model, settings.size)
        except InputError as refusal:
            rows[model] = {"refused": str(refusal)}
            continue
        pictures = {count: shown(of_model, count, _SEED) for count in counts}
        errors = {count: truth.squared_error(picture, counted) for count, picture in pictures.items()}
        kept[model] = pictures[max(pictures)]
        rows[model] = {
            "error": {n: round(math.sqrt(max(error, 0)) / mean, 4) for n, error in errors.items()},
            "cpu_seconds": {n: round(cpu_seconds(of_model, n), 4) for n in counts},
            "brightness": round(float(kept[model][counted].mean()) / mean - 1, 4),
        }
    return {"mean": round(mean, 4), "models": rows}, kept


@dataclass(frozen=True)
class WhichModel(Settings):
    fabrics: str = names(",".join(FABRICS), "Files of examples/.")
    models: str = names(",".join(MODELS), "Models.", tuple(REGISTRY))
    scenes: str = names("drape far", "Scenes of `compare`.")
    truth: int = setting(1024, "Samples a pixel of the reference.", low=2)
    most: int = setting(SAMPLES[-1], "Samples a pixel of models, at most.", low=1)
    size: tuple[int, int] = setting((160, 90), "Pixels.", low=8)


def measure(settings: WhichModel, run: Run) -> Found:
    """Every fabric in every scene."""
    choose_variant()
    runs: dict[str, dict[str, Any]] = {}
    pictures: dict[str, Pixels] = {}
    for name in listed(settings.fabrics):
        fabric, runs[name] = load_fabric(EXAMPLES / name), {}
        for scene in listed(settings.scenes):
            runs[name][scene], kept = measured(fabric, scene, settings)
            pictures |= {f"{fabric.name} {scene} {model}": on_display(each) for model, each in kept.items()}
    width, height = settings.size
    return Found(
        {
            "picture": f"{width} × {height}, one directional light, direct light",
            "error": "root mean square over the mean",
            "seconds": "processor time of all cores",
            "truth_samples": settings.truth,
            "runs": runs,
        },
        pictures=pictures,
    )


def tables(figures: Figures) -> list[Table]:
    """Error, seconds and brightness by fabric and model, a table a scene."""
    scenes = dict.fromkeys(scene for of_fabric in figures["runs"].values() for scene in of_fabric)
    return [_table(figures, scene) for scene in scenes]


def _table(figures: Figures, scene: str) -> Table:
    rows: dict[str, list[Cell]] = {}
    for file, scenes in figures["runs"].items():
        for model, found in scenes[scene]["models"].items():
            name = f"{file.split('.')[0]}, `{model}`"
            if "refused" in found:
                rows[name] = [None] * (len(SAMPLES) + len(TIMED) + 1)
                continue
            errors, seconds = (
                {int(n): value for n, value in found[key].items()} for key in ("error", "cpu_seconds")
            )
            percent: list[Cell] = [100 * errors[n] if n in errors else None for n in SAMPLES]
            times = [seconds.get(n) for n in TIMED]
            rows[name] = [*percent, *times, f"{100 * found['brightness']:+.1f} %"]
    columns = [*(f"error of {n}, %" for n in SAMPLES), *(f"s of {n}" for n in TIMED), "brightness"]
    return Table(f"Pictures of {scene}, by samples a pixel", columns, rows, digits=2)


STUDIES = (
    Study(
        "accuracy/which_model",
        "which model for which samples: error and processor time of a picture of the drape",
        WhichModel(),
        measure,
        tables,
        stands_on=("point", "samples", "lobes", "clustered", "neural", "picture"),
        small={"fabrics": "denim.toml", "models": "point,lobes", "truth": 4, "most": 4, "size": (32, 24)},
    ),
    Study(
        "accuracy/which_model_flanks",
        "the same of lobes alone",
        WhichModel(models="lobes"),
        measure,
        tables,
        stands_on=("point", "lobes", "picture"),
        small={"fabrics": "denim.toml", "truth": 4, "most": 4, "size": (32, 24)},
    ),
)
