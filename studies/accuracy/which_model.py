"""Which model for which samples: error and processor time of one picture of the drape, four unlike fabrics.

    python -m studies.accuracy.which_model [--output FILE.json]

The fabrics are a twill of two colours, a satin, a figured damask, and a draft without a short repeat. Two of
`compare`'s scenes show each, from near and from afar. Errors are root mean squares over the mean, against a
picture of the point model in two halves, whose own noise is in no error (`HalvedTruth`). What is left of
many samples is the model's bias. Seconds are processor time of all cores, of pictures whose kernels are
compiled. With `--pictures DIR` the pictures of most samples are kept, beside the truth.
"""

from __future__ import annotations

import gc
import math
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.core.images import write_image
from loomlight.fabric import Fabric, load_fabric
from loomlight.mitsuba import choose_variant, render
from loomlight.mitsuba.live import LivePicture
from loomlight.mitsuba.measured_scenes import MeasuredScene, measured_scene
from studies.instruments.halved_truth import HalvedTruth
from studies.instruments.harness import REPOSITORY, Figures, run
from studies.instruments.timing import least_times

FABRICS = ("denim.toml", "silk-satin.toml", "damask.toml", "undulating-twill.wif")
MODELS = ("point", "samples", "lobes", "clustered", "neural")
SCENES = ("drape near", "drape far")
SAMPLES = (1, 4, 16, 64, 256)
TRUTH_SAMPLES = 1024
SIZE, TURNS = (160, 90), 2
# More samples a pixel are not timed, but extended from these.
_MAX_TIMED = 16
_SEED, _TRUTH_SEED = 7, 1000


def shown(scene: MeasuredScene, samples: int, seed: int) -> NDArray[np.float32]:
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


def measured(fabric: Fabric, scene: str, options: Namespace) -> dict[str, Any]:
    """One fabric in one scene: error and seconds of each model by samples."""
    exact = measured_scene(scene, [fabric], "point", options.size)
    half = options.truth // 2
    truth = HalvedTruth((shown(exact, half, _TRUTH_SEED), shown(exact, half, _TRUTH_SEED + 1)))
    counted = exact.counted
    mean = float(truth.picture[counted].mean())
    del exact
    kept = {"truth": truth.picture}
    rows: dict[str, Any] = {}
    for model in options.models.split(","):
        # Freed while names hold them, BSDFs would be in the next scene's kernel.
        gc.collect()
        try:
            of_model = measured_scene(scene, [fabric], model, options.size)
        except InputError as refusal:
            rows[model] = {"refused": str(refusal)}
            continue
        pictures = {count: shown(of_model, count, _SEED) for count in options.samples}
        errors = {count: truth.squared_error(picture, counted) for count, picture in pictures.items()}
        kept[model] = pictures[max(pictures)]
        rows[model] = {
            "error": {n: round(math.sqrt(max(error, 0)) / mean, 4) for n, error in errors.items()},
            "cpu_seconds": {n: round(cpu_seconds(of_model, n), 4) for n in options.samples},
            "brightness": round(float(kept[model][counted].mean()) / mean - 1, 4),
        }
        print(fabric.name, scene, model, rows[model], flush=True)
    if options.pictures is not None:
        for name, picture in kept.items():
            write_image(
                options.pictures / f"{fabric.name}-{scene}-{name}.png".replace(" ", "-").lower(), picture
            )
    return {"mean": round(mean, 4), "models": rows}


def add_options(parser: ArgumentParser) -> None:
    """Which fabrics, models and scenes, and how many samples."""
    parser.add_argument("--fabrics", default=",".join(FABRICS), help="files of examples/")
    parser.add_argument("--models", default=",".join(MODELS))
    parser.add_argument("--scenes", default=",".join(SCENES))
    parser.add_argument("--truth", type=int, default=TRUTH_SAMPLES, help="samples a pixel of the reference")
    parser.add_argument("--pictures", type=Path, default=None, help="a folder for pictures")
    parser.set_defaults(size=SIZE, samples=SAMPLES)


def measure(options: Namespace) -> Figures:
    """Every fabric in every scene."""
    choose_variant()
    runs = {
        name: {
            scene: measured(load_fabric(REPOSITORY / "examples" / name), scene, options)
            for scene in options.scenes.split(",")
        }
        for name in options.fabrics.split(",")
    }
    return {
        "picture": f"{SIZE[0]} × {SIZE[1]}, one directional light, direct light",
        "error": "root mean square over the mean",
        "seconds": "processor time of all cores",
        "truth_samples": options.truth,
        "runs": runs,
    }


if __name__ == "__main__":
    run(measure, add_options, prints=False)
