"""Pictures of scenes, with measured times."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.mitsuba import render
from loomlight.mitsuba.measured_scenes import MeasuredScene
from studies.instruments.halved_truth import HalvedTruth
from studies.instruments.timing import timed

_TIMES = 3


@dataclass(frozen=True, eq=False)
class Rendered:
    """A picture.

    Attributes:
        linear: linear RGB [height, width, 3].
        samples: a pixel.
        seconds: of a picture, the fastest of three after compiling; of a reference, of its single rendering.
    """

    linear: NDArray[np.float32]
    samples: int
    seconds: float


def fastest_picture(scene: MeasuredScene, samples: int) -> Rendered:
    """A picture and its seconds: the fastest of three, after one that compiles."""
    one_picture(scene, samples, 2)
    taken = [timed(lambda: one_picture(scene, samples, 1)) for _ in range(_TIMES)]
    return Rendered(taken[-1][0], samples, min(seconds for _, seconds in taken))


def one_picture(scene: MeasuredScene, samples: int, seed: int = 1) -> NDArray[np.float32]:
    """Linear RGB [height, width, 3] of a scene."""
    return render(scene.scene, spp=samples, seed=seed, integrator=scene.integrator)


def halved_truth(scene: MeasuredScene, samples: int, seed: int) -> HalvedTruth:
    """A picture of so many samples a pixel in two halves, of this seed and the next one."""
    half = max(samples // 2, 1)
    return HalvedTruth((one_picture(scene, half, seed), one_picture(scene, half, seed + 1)))
