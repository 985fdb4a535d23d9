"""How long the point model takes to be as near to the truth as lobes are with one sample a pixel, from afar.

The scene is the one of the image benchmark in which a pixel of draped cloth covers four yarns a side; the
reference is the point model with 1 024 samples a pixel. Lobes take the pixel's footprint. Errors are
over pixels wholly on cloth. The samples that the point model needs for the lobes' MSE are read off its errors
at 1, 4, 16 … samples, on logarithmic scales. Seconds are those of pictures that are traced already
(`LivePicture`), the least of several in turns, so that both see the same machine; the point model's are read
off between 1 sample and the next larger picture than it needs. Bar: 20 times.

By default of `render` the scene is what `loomlight render` shows: the whole drape on its ground, the film's
Gaussian filter, paths of up to 8 segments, and lobes with so many samples a pixel; errors are over the whole
picture, and the point model has to reach both the MSE and the FLIP. Bar: 10 times.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from loomlight.core.settings import Settings, setting
from loomlight.evaluation.metrics import PictureError, picture_error, samples_for
from loomlight.evaluation.table import Table
from loomlight.fabric import Fabric, load_fabric
from loomlight.mitsuba import LIGHTS, build_scene, choose_variant, material_bsdf
from loomlight.mitsuba.live import LivePicture
from loomlight.mitsuba.measured_scenes import MeasuredScene, measured_scene
from studies.harness.study import Figures, Found, Run, Study, example, listed, names
from studies.instruments.renders import one_picture
from studies.instruments.timing import least_times

SCENE = "drape far"
POINT_SAMPLES = (1, 4, 16, 64, 256)
BARS = {"pixel": 20.0, "default": 10.0}
FABRICS = ("denim", "silk-satin", "wool-houndstooth")
_REFERENCE_SEED = 1000


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


def measured(name: str, settings: LobesRender) -> dict[str, Any]:
    """Errors, seconds and their ratio for one fabric."""
    # A pixel's own footprint is one sample through its centre.
    samples = 1 if settings.view == "pixel" else settings.samples
    point, lobes = scenes_of(load_fabric(example(name)), settings.view, settings.size, settings.light)
    reference = one_picture(point, settings.reference, _REFERENCE_SEED)

    def judged(scene: MeasuredScene, count: int) -> PictureError:
        return picture_error(one_picture(scene, count), reference, scene.counted)

    ours = judged(lobes, samples)
    counts = [count for count in POINT_SAMPLES if count <= settings.most]
    theirs = {count: judged(point, count) for count in counts}
    equal = samples_for(ours.mse, counts, [theirs[count].mse for count in counts])
    equal_flip = samples_for(ours.flip, counts, [theirs[count].flip for count in counts])
    needed = equal if settings.view == "pixel" else max(equal, equal_flip)
    # The cost of a sample is measured on a picture of at least as many samples.
    counted = next((count for count in counts if count >= needed), counts[-1])
    shots = [(lobes, samples), (point, counted), (point, 1)]
    lives = [LivePicture(shown.scene, integrator=shown.integrator, spp=n) for shown, n in shots]
    times = least_times([live.take for live in lives], settings.turns)
    lobes_seconds, point_seconds, start_seconds = (taken.seconds for taken in times)
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


@dataclass(frozen=True)
class LobesRender(Settings):
    view: str = setting("pixel", "Which picture.", choices=tuple(BARS))
    size: tuple[int, int] = setting((960, 540), "Pixels.", low=8)
    light: str = setting("directional", "Of the default picture.", choices=LIGHTS)
    samples: int = setting(1, "Of lobes, in the default picture.", low=1)
    reference: int = setting(1024, "Samples of the reference.", low=1)
    most: int = setting(256, "Samples of the point model, at most.", low=4)
    turns: int = setting(7, "Pictures of each that are timed.", low=1)
    fabrics: str = names(",".join(FABRICS), "Example fabrics.")


def measure(settings: LobesRender, run: Run) -> Found:
    """Every fabric, and whether the least of them misses the bar."""
    choose_variant()
    runs = run.each({name: partial(measured, name, settings) for name in listed(settings.fabrics)})
    width, height = settings.size
    least = min(result["times_faster"] for result in runs.values())
    bar = BARS[settings.view]
    scene = SCENE if settings.view == "pixel" else f"drape, {settings.light}, {settings.samples} samples"
    return Found(
        {
            "picture": f"{scene}, {width} × {height}, reference {settings.reference} samples a pixel",
            "least_times_faster": least,
            "bar_times_faster": bar,
            "missed": [name for name, result in runs.items() if result["times_faster"] < bar],
            "runs": runs,
        }
    )


def tables(figures: Figures) -> list[Table]:
    """Samples of `point` for the errors of `lobes`, and how much longer they take."""
    keys = (
        "lobes_seconds",
        "point_samples_for_the_same_mse",
        "point_samples_for_the_same_flip",
        "times_faster",
    )
    rows = {name: [found[key] for key in keys] for name, found in figures["runs"].items()}
    columns = ["seconds, `lobes`", "samples of `point`: MSE", "FLIP", "times longer"]
    return [Table("Equal error", columns, rows, f"{figures['picture']}.", digits=2)]


_SMALL = {"size": (32, 24), "reference": 16, "most": 4, "turns": 2, "fabrics": "denim"}
STUDIES = (
    Study(
        "speed/lobes_render",
        "how much longer `point` takes to be as near to the truth as one sample of `lobes` from afar",
        LobesRender(),
        measure,
        tables,
        stands_on=("lobes", "point", "lobes cost", "point cost"),
        small=_SMALL,
    ),
    Study(
        "speed/lobes_render_default",
        "the same at the defaults of `render`, with 4 samples of `lobes`",
        LobesRender(view="default", samples=4, size=(512, 512)),
        measure,
        tables,
        stands_on=("lobes", "point", "lobes cost", "point cost", "picture"),
        small=_SMALL,
    ),
)
