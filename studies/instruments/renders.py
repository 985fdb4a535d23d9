"""Pictures of scenes, with measured times."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from loomlight.mitsuba import render
from loomlight.mitsuba.measured_scenes import MeasuredScene
from studies.instruments.halved_truth import HalvedTruth
from studies.instruments.timing import least_times, one_thread

_TIMES = 3


@dataclass(frozen=True, eq=False)
class Rendered:
    """A picture.

    Attributes:
        linear: linear RGB [height, width, 3].
        samples: a pixel.
        cpu_seconds: processor seconds of a picture whose kernels are compiled, on one thread.
    """

    linear: NDArray[np.float32]
    samples: int
    cpu_seconds: float


def timed_pictures(shots: Sequence[tuple[MeasuredScene, int]]) -> list[Rendered]:
    """Pictures of scenes with so many samples a pixel, which take turns; the least time of each of three.

    Other programs lengthen a picture's processor time, by caches and cores that they share, and shorten none.
    """
    runs = [partial(one_picture, scene, samples) for scene, samples in shots]
    with one_thread():
        pictures = [run() for run in runs]  # compiles
        times = least_times(runs, _TIMES)
    return [
        Rendered(picture, samples, spent.cpu_seconds)
        for picture, (_, samples), spent in zip(pictures, shots, times, strict=True)
    ]


def one_picture(scene: MeasuredScene, samples: int, seed: int = 1) -> NDArray[np.float32]:
    """Linear RGB [height, width, 3] of a scene."""
    return render(scene.scene, spp=samples, seed=seed, integrator=scene.integrator)


def halved_truth(scene: MeasuredScene, samples: int, seed: int) -> HalvedTruth:
    """A picture of so many samples a pixel in two halves, of this seed and the next one."""
    half = max(samples // 2, 1)
    return HalvedTruth((one_picture(scene, half, seed), one_picture(scene, half, seed + 1)))
