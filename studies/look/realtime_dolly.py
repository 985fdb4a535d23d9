"""Zoom without shimmer: how much frames of `lobes` change from one to the next while the camera moves away.

    python -m studies.look.realtime_dolly [--size 256] [--pairs 59]
        [--output FILE.json]

Eight fabrics, a dolly of 60 frames from 0.05 to 0.5 m under one directional light. FLIP between neighbouring
frames is compared with that of a reference, the model `point` with 256 samples a pixel. What changes more
than the reference shimmers: the bar is the reference's own plus a tenth. Smaller sizes show the middle of the
frames of 256 pixels; fewer pairs are spread evenly over the dolly.
"""

from __future__ import annotations

import math
from argparse import ArgumentParser, Namespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.evaluation.metrics import flip_mean
from loomlight.fabric import fabric_from_text, load_fabric
from loomlight.fabric.fabric import Fabric
from loomlight.realtime import Camera, Cloth, DirectionalLight, Renderer, rectangle
from studies.instruments.harness import REPOSITORY, Figures, run

EXAMPLES = REPOSITORY / "examples"
FABRICS = ("denim", "wool-houndstooth", "silk-satin", "linen", "organza", "damask")
WEAVES = ("plain", "twill 3/1")
FRAMES, WHOLE_SIZE, FIELD_OF_VIEW = 60, 256, 26.0
NEAREST, FARTHEST = 0.05, 0.5  # metres
SIDE = 0.5
LIGHTS = [DirectionalLight((0.5, 0.3, 0.8))]
REFERENCE_SAMPLES, PASSES = 256, 4
BAR = 1.1


def camera_of(frame: int, size: int) -> Camera:
    """The camera of a frame, whose pixels see as much as those of frames of 256 pixels."""
    distance = NEAREST * (FARTHEST / NEAREST) ** (frame / (FRAMES - 1))
    slope = math.tan(math.radians(FIELD_OF_VIEW) / 2) * size / WHOLE_SIZE
    angle = 2 * math.degrees(math.atan(slope))
    return Camera((0, -0.6 * distance, 0.8 * distance), field_of_view=angle)


def changes(fabric: Fabric, model: str, size: int, firsts: NDArray[np.int64]) -> list[float]:
    """FLIP between each frame of `firsts` and the next."""
    renderer = Renderer([Cloth(rectangle(SIDE, SIDE), fabric)], (size, size), model)
    samples = REFERENCE_SAMPLES // PASSES if model == "point" else 1
    whole = np.ones((size, size), bool)

    def frame(number: int) -> NDArray[np.float32]:
        picture = renderer.render(camera_of(number, size), LIGHTS, passes=PASSES, samples=samples)
        return picture.linear[..., :3]

    return [float(flip_mean(frame(k), frame(k + 1), whole)) for k in firsts]


def measure(options: Namespace) -> Figures:
    """Changes of every fabric, and those that miss the bar."""
    firsts = np.unique(np.linspace(0, FRAMES - 2, options.pairs).round().astype(int))
    fabrics = {name: load_fabric(EXAMPLES / f"{name}.toml") for name in FABRICS}
    fabrics |= {name: fabric_from_text(f'weave = "{name}"\n') for name in WEAVES}
    rows: list[dict[str, Any]] = []
    for name, fabric in fabrics.items():
        found, expected = (
            float(np.mean(changes(fabric, m, options.size, firsts))) for m in ("lobes", "point")
        )
        rows.append({"fabric": name, "lobes": found, "reference": expected, "ratio": found / expected})
    return {
        "size": options.size,
        "pairs": len(firsts),
        "rows": rows,
        "above_the_bar": [row["fabric"] for row in rows if row["ratio"] > BAR],
    }


def _add_options(parser: ArgumentParser) -> None:
    parser.add_argument("--size", type=int, default=WHOLE_SIZE, help="pixels each way; 256")
    parser.add_argument("--pairs", type=int, default=FRAMES - 1, help="pairs of neighbouring frames; 59")


if __name__ == "__main__":
    run(measure, _add_options)
