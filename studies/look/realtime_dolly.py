"""Zoom without shimmer: how much frames of `lobes` change from one to the next while the camera moves away.

Eight fabrics, a dolly of 60 frames from 0.05 to 0.5 m under one directional light. FLIP between neighbouring
frames is compared with that of a reference, the model `point` with 256 samples a pixel. What changes more
than the reference shimmers: the bar is the reference's own plus a tenth. Smaller sizes show the middle of the
frames of 256 pixels; fewer pairs are spread evenly over the dolly.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from loomlight.core.settings import Settings, setting
from loomlight.evaluation.metrics import flip_mean
from loomlight.evaluation.table import Table
from loomlight.fabric import fabric_from_text, load_fabric
from loomlight.fabric.fabric import Fabric
from loomlight.realtime import Camera, Cloth, DirectionalLight, Renderer, rectangle
from studies.harness.study import Figures, Found, Run, Study, example, listed, names

FABRICS = ("denim", "wool-houndstooth", "silk-satin", "linen", "organza", "damask")
WEAVES = ("plain", "twill 3/1")
FRAMES, WHOLE_SIZE, FIELD_OF_VIEW = 60, 256, 26.0
NEAREST, FARTHEST = 0.05, 0.5  # metres
SIDE = 0.5
LIGHTS = [DirectionalLight((0.5, 0.3, 0.8))]
PASSES = 4
BAR = 1.1


def camera_of(frame: int, size: int) -> Camera:
    """The camera of a frame, whose pixels see as much as those of frames of 256 pixels."""
    distance = NEAREST * (FARTHEST / NEAREST) ** (frame / (FRAMES - 1))
    slope = math.tan(math.radians(FIELD_OF_VIEW) / 2) * size / WHOLE_SIZE
    angle = 2 * math.degrees(math.atan(slope))
    return Camera((0, -0.6 * distance, 0.8 * distance), field_of_view=angle)


def changes(fabric: Fabric, model: str, settings: RealtimeDolly, firsts: NDArray[np.int64]) -> list[float]:
    """FLIP between each frame of `firsts` and the next."""
    size = settings.size
    renderer = Renderer([Cloth(rectangle(SIDE, SIDE), fabric)], (size, size), model)
    samples = settings.samples // PASSES if model == "point" else 1
    whole = np.ones((size, size), bool)

    def frame(number: int) -> NDArray[np.float32]:
        picture = renderer.render(camera_of(number, size), LIGHTS, passes=PASSES, samples=samples)
        return picture.linear[..., :3]

    return [float(flip_mean(frame(k), frame(k + 1), whole)) for k in firsts]


@dataclass(frozen=True)
class RealtimeDolly(Settings):
    size: int = setting(WHOLE_SIZE, "Pixels each way.", low=8)
    pairs: int = setting(FRAMES - 1, "Pairs of neighbouring frames.", low=1, high=FRAMES - 1)
    cloths: str = names(",".join((*FABRICS, *WEAVES)), "Example fabrics and weaves.")
    samples: int = setting(256, "A pixel of the reference.", low=4)


def measure(settings: RealtimeDolly, run: Run) -> Found:
    """Changes of every fabric, and those that miss the bar."""
    firsts = np.unique(np.linspace(0, FRAMES - 2, settings.pairs).round().astype(int))
    cases = {name: partial(_row, name, settings, firsts) for name in listed(settings.cloths)}
    rows = list(run.each(cases).values())
    return Found(
        {
            "size": settings.size,
            "pairs": len(firsts),
            "rows": rows,
            "above_the_bar": [row["fabric"] for row in rows if row["ratio"] > BAR],
        }
    )


def _row(name: str, settings: RealtimeDolly, firsts: NDArray[np.int64]) -> Figures:
    fabric = fabric_from_text(f'weave = "{name}"\n') if name in WEAVES else load_fabric(example(name))
    found, expected = (
        float(np.mean(changes(fabric, model, settings, firsts))) for model in ("lobes", "point")
    )
    return {"fabric": name, "lobes": found, "reference": expected, "ratio": found / expected}


def tables(figures: Figures) -> list[Table]:
    """Changes by fabric."""
    rows = {row["fabric"]: [row["lobes"], row["reference"], row["ratio"]] for row in figures["rows"]}
    note = f"{figures['pairs']} pairs of frames of {figures['size']}² pixels; the bar is {BAR}."
    return [Table("FLIP from frame to frame", ["`lobes`", "reference", "ratio"], rows, note)]


STUDY = Study(
    "look/realtime_dolly",
    "zoom without shimmer: how much frames of `lobes` change while the camera moves away",
    RealtimeDolly(),
    measure,
    tables,
    stands_on=("shaders", "lobes"),
    small={"size": 8, "pairs": 1, "cloths": "denim", "samples": 4},
)
