"""How long the point model takes to be as near to the truth as lobes are with one sample a pixel, from afar.

    python benchmarks/lobes_render.py [--size 960x540] [--output benchmarks/results/lobes_render.json]

The scene is that of the image test where a pixel of draped cloth covers four yarns a side, the reference the
point model with 1 024 samples a pixel. Lobes look at the pixel's footprint through its middle. Errors are
over pixels wholly on cloth. The samples that the point model needs for the lobes' MSE are read off its errors
at 1, 4, 16 … samples, on logarithmic scales. Seconds are those of pictures that are traced already
(`LivePicture`), the least of several in turns, so that both see the same machine; the point model's are read
off between 1 sample and the next larger picture than it needs. Bar: 20 times.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.provenance import provenance
from loomlight.evaluation.pictures import PictureError, picture_error
from loomlight.evaluation.table import write_json
from loomlight.fabric import Fabric, load_fabric
from loomlight.mitsuba import choose_variant, render
from loomlight.mitsuba.live import LivePicture
from loomlight.mitsuba.measured_scenes import MeasuredScene, measured_scene

SCENE, SIZE, REFERENCE_SAMPLES = "drape far", (960, 540), 1024
POINT_SAMPLES = (1, 4, 16, 64, 256)
TURNS = 7
BAR = 20.0
EXAMPLES = Path(__file__).parents[1] / "examples"
FABRICS = ("denim", "silk-satin", "wool-houndstooth")
_REFERENCE_SEED, _SEED = 1000, 1


def picture_of(scene: MeasuredScene, samples: int, seed: int = _SEED) -> NDArray[np.float32]:
    """The scene with so many samples a pixel."""
    return render(scene.scene, spp=samples, seed=seed, integrator=scene.integrator)


def seconds_of(runs: list[Callable[[], Any]]) -> list[float]:
    """Least seconds of each run; they take turns."""
    taken = []
    for _ in range(TURNS):
        row = []
        for run in runs:
            start = time.perf_counter()
            run()
            row.append(time.perf_counter() - start)
        taken.append(row)
    return [float(value) for value in np.min(taken, axis=0)]


def samples_for(error: float, samples: list[int], errors: list[float]) -> float:
    """Samples at which errors that fall with them reach `error`; the slope of the nearest two goes on."""
    x, y = np.log(samples), np.log(errors)
    first = int(np.clip(np.searchsorted(-y, -np.log(error)) - 1, 0, len(x) - 2))
    share = (np.log(error) - y[first]) / (y[first + 1] - y[first])
    return float(np.exp(x[first] + share * (x[first + 1] - x[first])))


def numbers(error: PictureError) -> dict[str, float]:
    """An error as the record has it."""
    return {"mse": float(f"{error.mse:.3e}"), "flip": round(error.flip, 4)}


def measured(fabric: Fabric, size: tuple[int, int]) -> dict[str, Any]:
    """Errors, seconds and their ratio for one fabric."""
    point = measured_scene(SCENE, [fabric], "point", size)
    lobes = measured_scene(SCENE, [fabric], "lobes", size, pixel_centres=True)
    reference = picture_of(point, REFERENCE_SAMPLES, _REFERENCE_SEED)

    def judged(scene: MeasuredScene, samples: int) -> PictureError:
        return picture_error(picture_of(scene, samples), reference, scene.counted)

    ours = judged(lobes, 1)
    theirs = {samples: judged(point, samples) for samples in POINT_SAMPLES}
    errors = [theirs[samples].mse for samples in POINT_SAMPLES]
    equal = samples_for(ours.mse, list(POINT_SAMPLES), errors)
    # A picture of at least as many samples tells what each costs.
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


def main() -> None:
    """Runs the benchmark, prints it, and exits with 1 if the bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--size", default="x".join(map(str, SIZE)))
    parser.add_argument("--fabrics", default=",".join(FABRICS), help="Names of examples.")
    parser.add_argument("--output", type=Path, default=None)
    arguments = parser.parse_args()
    width, height = (int(side) for side in arguments.size.split("x"))
    choose_variant()
    runs = {}
    for name in arguments.fabrics.split(","):
        runs[name] = measured(load_fabric(EXAMPLES / f"{name}.toml"), (width, height))
        print(name, runs[name], flush=True)
    least = min(run["times_faster"] for run in runs.values())
    result = {
        **provenance("python benchmarks/lobes_render.py", Path(__file__).parent),
        "picture": f"{SCENE}, {width} × {height}, reference {REFERENCE_SAMPLES} samples a pixel",
        "least_times_faster": least,
        "bar_times_faster": BAR,
        "runs": runs,
    }
    if arguments.output is not None:
        write_json(arguments.output, result, digits=None)
    print(f"{least} times faster")
    sys.exit(0 if least >= BAR else 1)


if __name__ == "__main__":
    main()
