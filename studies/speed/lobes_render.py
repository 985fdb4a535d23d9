"""How long the point model takes to be as near to the truth as lobes are with one sample a pixel, from afar.

    python -m studies.speed.lobes_render [--size 960x540] [--output FILE.json]
    python -m studies.speed.lobes_render --setting default --samples 4 --size 512x512 --output ...

The scene is the one of the image benchmark in which a pixel of draped cloth covers four yarns a side; the
reference is the point model with 1 024 samples a pixel. Lobes take the pixel's footprint. Errors are
over pixels wholly on cloth. The samples that the point model needs for the lobes' MSE are read off its errors
at 1, 4, 16 … samples, on logarithmic scales. Seconds are those of pictures that are traced already
(`LivePicture`), the least of several in turns, so that both see the same machine; the point model's are read
off between 1 sample and the next larger picture than it needs. Bar: 20 times.

With `--setting default` the scene is what `loomlight render` shows: the whole drape on its ground, the film's
Gaussian filter, paths of up to 8 segments, and lobes with so many samples a pixel; errors are over the whole
picture, and the point model has to reach both the MSE and the FLIP. Bar: 10 times.
"""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from typing import Any

import numpy as np

from loomlight.evaluation.metrics import PictureError, picture_error, samples_for
from loomlight.fabric import Fabric, load_fabric
from loomlight.mitsuba import build_scene, choose_variant, material_bsdf
from loomlight.mitsuba.live import LivePicture
from loomlight.mitsuba.measured_scenes import MeasuredScene, measured_scene
from studies.instruments.harness import REPOSITORY, Figures, run
from studies.instruments.renders import one_picture
from studies.instruments.timing import timed

SCENE, SIZE, REFERENCE_SAMPLES = "drape far", (960, 540), 1024
POINT_SAMPLES = (1, 4, 16, 64, 256)
TURNS = 7
BARS = {"pixel": 20.0, "default": 10.0}
EXAMPLES = REPOSITORY / "examples"
FABRICS = ("denim", "silk-satin", "wool-houndstooth")
_REFERENCE_SEED = 1000


def seconds_of(runs: list[Callable[[], Any]]) -> list[float]:
    """Least seconds of each run; they take turns."""
    taken = [[timed(each)[1] for each in runs] for _ in range(TURNS)]
    return [float(value) for value in np.min(taken, axis=0)]


def numbers(error: PictureError) -> dict[str, float]:
    """An error as the record has it."""
    return {"mse": float(f"{error.mse:.3e}"), "flip": round(error.flip, 4)}


def scenes_of(fabric: Fabric, setting: str, size: tuple[int, int], light: str) -> tuple[MeasuredScene, ...]:
    """The point model's scene and that of lobes."""
    if setting == "pixel":
        return (
            measured_scene(SCENE, [fabric], "point", size),
            measured_scene(SCENE, [fabric], "lobes", size, pixel_centres=True),
        )
    everything = np.ones(size[::-1], bool)
    bsdfs = [material_bsdf(fabric, model) for model in ("point", "lobes")]
    shown = [build_scene("drape", bsdf, size=size, light=light) for bsdf in bsdfs]
    return tuple(MeasuredScene(each.scene, each.integrator, everything, float("nan")) for each in shown)


def measured(
    fabric: Fabric,
    size: tuple[int, int],
    setting: str = "pixel",
    light: str = "directional",
    samples: int = 1,
) -> dict[str, Any]:
    """Errors, seconds and their ratio for one fabric."""
    point, lobes = scenes_of(fabric, setting, size, light)
    reference = one_picture(point, REFERENCE_SAMPLES, _REFERENCE_SEED)

    def judged(scene: MeasuredScene, count: int) -> PictureError:
        return picture_error(one_picture(scene, count), reference, scene.counted)

    ours = judged(lobes, samples)
    theirs = {count: judged(point, count) for count in POINT_SAMPLES}
    equal = samples_for(ours.mse, list(POINT_SAMPLES), [theirs[count].mse for count in POINT_SAMPLES])
    equal_flip = samples_for(ours.flip, list(POINT_SAMPLES), [theirs[count].flip for count in POINT_SAMPLES])
    needed = equal if setting == "pixel" else max(equal, equal_flip)
    # The cost of a sample is measured on a picture of at least as many samples.
    counted = next((count for count in POINT_SAMPLES if count >= needed), POINT_SAMPLES[-1])
    shots = [(lobes, samples), (point, counted), (point, 1)]
    lives = [LivePicture(shown.scene, integrator=shown.integrator, spp=n) for shown, n in shots]
    lobes_seconds, point_seconds, start_seconds = seconds_of([live.take for live in lives])
    each = max(point_seconds - start_seconds, 0) / max(counted - 1, 1)
    wanted = start_seconds + max(needed - 1, 0) * each
    return {
        "lobes_seconds": round(lobes_seconds, 4),
        "lobes": numbers(ours),
        "point": {str(count): numbers(error) for count, error in theirs.items()},
        "point_samples_for_the_same_mse": round(equal, 1),
        "point_samples_for_the_same_flip": round(equal_flip, 1),
        "point_seconds_for_the_same_error": round(wanted, 4),
        "times_faster": round(wanted / lobes_seconds, 2),
    }


def add_options(parser: ArgumentParser) -> None:
    """Which pictures are compared."""
    parser.add_argument("--size", default="x".join(map(str, SIZE)))
    parser.add_argument("--setting", choices=list(BARS), default="pixel")
    parser.add_argument("--light", default="directional", help="of the default setting")
    parser.add_argument("--samples", type=int, default=1, help="of lobes, in the default setting")
    parser.add_argument("--fabrics", default=",".join(FABRICS), help="names of examples")


def measure(options: Namespace) -> Figures:
    """Every fabric, and whether the least of them misses the bar."""
    width, height = (int(side) for side in options.size.split("x"))
    choose_variant()
    runs = {}
    for name in options.fabrics.split(","):
        fabric = load_fabric(EXAMPLES / f"{name}.toml")
        # A pixel's own footprint is one sample through its centre.
        samples = 1 if options.setting == "pixel" else options.samples
        runs[name] = measured(fabric, (width, height), options.setting, options.light, samples)
        print(name, runs[name], flush=True)
    least = min(result["times_faster"] for result in runs.values())
    print(f"{least} times faster")
    bar = BARS[options.setting]
    scene = SCENE if options.setting == "pixel" else f"drape, {options.light}, {options.samples} samples"
    return {
        "picture": f"{scene}, {width} × {height}, reference {REFERENCE_SAMPLES} samples a pixel",
        "least_times_faster": least,
        "bar_times_faster": bar,
        "missed": [name for name, result in runs.items() if result["times_faster"] < bar],
        "runs": runs,
    }


if __name__ == "__main__":
    run(measure, add_options, prints=False)
