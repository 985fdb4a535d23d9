"""How long the point model takes to be as near to the truth as lobes are with one sample a pixel, from afar.

    python -m benchmarks.lobes_render [--size 960x540] [--output benchmarks/results/lobes_render.json]

The scene is the one of the image benchmark in which a pixel of draped cloth covers four yarns a side; the
reference is the point model with 1 024 samples a pixel. Lobes take the pixel's footprint. Errors are
over pixels wholly on cloth. The samples that the point model needs for the lobes' MSE are read off its errors
at 1, 4, 16 … samples, on logarithmic scales. Seconds are those of pictures that are traced already
(`LivePicture`), the least of several in turns, so that both see the same machine; the point model's are read
off between 1 sample and the next larger picture than it needs. Bar: 20 times.
"""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from typing import Any

import numpy as np

from benchmarks.harness import REPOSITORY, Figures, run
from loomlight.evaluation.pictures import PictureError, picture_error
from loomlight.evaluation.reproduce.renders import one_picture
from loomlight.evaluation.timing import timed
from loomlight.fabric import Fabric, load_fabric
from loomlight.mitsuba import choose_variant
from loomlight.mitsuba.live import LivePicture
from loomlight.mitsuba.measured_scenes import MeasuredScene, measured_scene

SCENE, SIZE, REFERENCE_SAMPLES = "drape far", (960, 540), 1024
POINT_SAMPLES = (1, 4, 16, 64, 256)
TURNS = 7
BAR = 20.0
EXAMPLES = REPOSITORY / "examples"
FABRICS = ("denim", "silk-satin", "wool-houndstooth")
_REFERENCE_SEED = 1000


def seconds_of(runs: list[Callable[[], Any]]) -> list[float]:
    """Least seconds of each run; they take turns."""
    taken = [[timed(each)[1] for each in runs] for _ in range(TURNS)]
    return [float(value) for value in np.min(taken, axis=0)]


def samples_for(error: float, samples: list[int], errors: list[float]) -> float:
    """Samples at which errors that fall with them reach `error`; the slope of the nearest two goes on."""
    x, y = np.log(samples), np.log(errors)
    first = int(np.clip(np.searchsorted(-y, -np.log(error)) - 1, 0, len(x) - 2))
    fraction = (np.log(error) - y[first]) / (y[first + 1] - y[first])
    return float(np.exp(x[first] + fraction * (x[first + 1] - x[first])))


def numbers(error: PictureError) -> dict[str, float]:
    """An error as the record has it."""
    return {"mse": float(f"{error.mse:.3e}"), "flip": round(error.flip, 4)}


def measured(fabric: Fabric, size: tuple[int, int]) -> dict[str, Any]:
    """Errors, seconds and their ratio for one fabric."""
    point = measured_scene(SCENE, [fabric], "point", size)
    lobes = measured_scene(SCENE, [fabric], "lobes", size, pixel_centres=True)
    reference = one_picture(point, REFERENCE_SAMPLES, _REFERENCE_SEED)

    def judged(scene: MeasuredScene, samples: int) -> PictureError:
        return picture_error(one_picture(scene, samples), reference, scene.counted)

    ours = judged(lobes, 1)
    theirs = {samples: judged(point, samples) for samples in POINT_SAMPLES}
    errors = [theirs[samples].mse for samples in POINT_SAMPLES]
    equal = samples_for(ours.mse, list(POINT_SAMPLES), errors)
    # The cost of a sample is measured on a picture of at least as many samples.
    counted = next((samples for samples in POINT_SAMPLES if samples >= equal), POINT_SAMPLES[-1])
    shots = [(lobes, 1), (point, counted), (point, 1)]
    lives = [LivePicture(shown.scene, integrator=shown.integrator, spp=n) for shown, n in shots]
    lobes_seconds, point_seconds, start_seconds = seconds_of([live.take for live in lives])
    each = max(point_seconds - start_seconds, 0) / max(counted - 1, 1)
    wanted = start_seconds + max(equal - 1, 0) * each
    return {
        "lobes_seconds": round(lobes_seconds, 4),
        "lobes": numbers(ours),
        "point": {str(samples): numbers(error) for samples, error in theirs.items()},
        "point_samples_for_the_same_mse": round(equal, 1),
        "point_seconds_for_the_same_mse": round(wanted, 4),
        "times_faster": round(wanted / lobes_seconds, 2),
    }


def add_options(parser: ArgumentParser) -> None:
    """Which pictures are compared."""
    parser.add_argument("--size", default="x".join(map(str, SIZE)))
    parser.add_argument("--fabrics", default=",".join(FABRICS), help="names of examples")


def measure(options: Namespace) -> Figures:
    """Every fabric, and whether the least of them misses the bar."""
    width, height = (int(side) for side in options.size.split("x"))
    choose_variant()
    runs = {}
    for name in options.fabrics.split(","):
        runs[name] = measured(load_fabric(EXAMPLES / f"{name}.toml"), (width, height))
        print(name, runs[name], flush=True)
    least = min(result["times_faster"] for result in runs.values())
    print(f"{least} times faster")
    return {
        "picture": f"{SCENE}, {width} × {height}, reference {REFERENCE_SAMPLES} samples a pixel",
        "least_times_faster": least,
        "bar_times_faster": BAR,
        "missed": [name for name, result in runs.items() if result["times_faster"] < BAR],
        "runs": runs,
    }


if __name__ == "__main__":
    run(measure, add_options, prints=False)
