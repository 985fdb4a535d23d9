"""Pictures with measured times, and the point model at a sample count that takes as long as the network."""

from __future__ import annotations

import time
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.evaluation.reproduce.setting import POINT, WOVEN, Setting, cloth_bsdf
from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba import choose_variant, render
from loomlight.mitsuba.measured_scenes import MeasuredScene, MeasuredShot, shot_scene
from loomlight.mitsuba.rendering import filling_grid
from loomlight.mitsuba.scenes import BsdfFactory

_TIMES = 3
_MOST_EQUAL = 64
# Sample counts that the time a sample takes is read from.
_FEW, _SOME = 1, 9


@dataclass(frozen=True, eq=False)
class Rendered:
    """A picture.

    Attributes:
        linear: linear RGB [height, width, 3].
        samples: a pixel.
        seconds: of a picture, compiled beforehand, the fastest of three; of a reference its only one.
    """

    linear: NDArray[np.float32]
    samples: int
    seconds: float


class Stage:
    """A shot that fabrics are shown in."""

    def __init__(self, setting: Setting, shot: MeasuredShot) -> None:
        choose_variant()
        self.setting = setting
        self.shot = shot

    def reference(self, fabric: Fabric) -> Rendered:
        """The point model with many samples a pixel."""
        scene = self._scene(fabric, cloth_bsdf(fabric, POINT), centred=False)
        start = time.perf_counter()
        linear = one_picture(scene, self.setting.samples, 0)
        return Rendered(linear, self.setting.samples, time.perf_counter() - start)

    def point(self, fabric: Fabric, samples: int) -> Rendered:
        """The point model with a few samples a pixel."""
        return timed(self._scene(fabric, cloth_bsdf(fabric, POINT), centred=False), samples)

    def woven(self, fabric: Fabric, bsdf: BsdfFactory | None = None) -> Rendered:
        """The network, one sample through the middle of each pixel."""
        return timed(self.woven_scene(fabric, bsdf), 1)

    def woven_scene(self, fabric: Fabric, bsdf: BsdfFactory | None = None) -> MeasuredScene:
        """What `woven` renders; another BSDF may stand for the fabric's."""
        own = cloth_bsdf(fabric, WOVEN, self.setting.weights) if bsdf is None else bsdf
        return self._scene(fabric, own, centred=True)

    def equal_time(self, fabric: Fabric, seconds: float) -> Rendered:
        """The point model with as many samples as take `seconds`, at least 1 and at most 64."""
        scene = self._scene(fabric, cloth_bsdf(fabric, POINT), centred=False)
        few, some = (timed(scene, samples).seconds for samples in (_FEW, _SOME))
        slope = max((some - few) / (_SOME - _FEW), 1e-6)
        guess = _FEW + (seconds - few) / slope
        return timed(scene, grid_near(guess))

    def _scene(self, fabric: Fabric, bsdf: BsdfFactory, centred: bool) -> MeasuredScene:
        return shot_scene(self.shot, [(fabric, bsdf)], self.setting.size, centred)


def grid_near(samples: float) -> int:
    """The count nearest to `samples`, from 1 to 64, that a sampler can lay out as a grid."""
    counts = [count for count in range(1, _MOST_EQUAL + 1) if filling_grid(count) == count]
    return min(counts, key=lambda count: abs(count - samples))


def timed(scene: MeasuredScene, samples: int) -> Rendered:
    """A picture and the seconds of it: the first compiles, the fastest of three others counts."""
    one_picture(scene, samples, 2)
    seconds = []
    linear = None
    for _ in range(_TIMES):
        start = time.perf_counter()
        linear = one_picture(scene, samples, 1)
        seconds.append(time.perf_counter() - start)
    assert linear is not None
    return Rendered(linear, samples, min(seconds))


def one_picture(scene: MeasuredScene, samples: int, seed: int = 1) -> NDArray[np.float32]:
    """Linear RGB [height, width, 3] of a scene."""
    return render(scene.scene, spp=samples, seed=seed, integrator=scene.integrator)
