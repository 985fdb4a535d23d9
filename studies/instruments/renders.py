"""Pictures with measured times, and the point model at the network's rendering time (equal time)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba import choose_variant, render
from loomlight.mitsuba.measured_scenes import MeasuredScene, MeasuredShot, shot_counted, shot_scene
from loomlight.mitsuba.scenes import BsdfFactory
from studies.instruments.timing import timed
from studies.papers.setting import NEURAL, POINT, Setting, cloth_bsdf

_TIMES = 3
_MAX_EQUAL = 64
_CORRECTIONS = 2
# Sample counts between which the time of a sample is measured.
_FEW, _SOME = 1, 9


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


class Stage:
    """A shot with the fabrics that it shows, one for each of its pieces."""

    def __init__(self, setting: Setting, shot: MeasuredShot, *fabrics: Fabric) -> None:
        choose_variant()
        self.setting = setting
        self.shot = shot
        self.fabrics = fabrics

    @property
    def counted(self) -> NDArray[np.bool_]:
        """Pixels that lie wholly on one piece [height, width]."""
        return shot_counted(self.shot, self.setting.size)

    def reference(self) -> Rendered:
        """The point model with many samples a pixel."""
        scene = self._point_scene
        samples = self.setting.samples
        linear, seconds = timed(lambda: one_picture(scene, samples, 0))
        return Rendered(linear, samples, seconds)

    def point(self, samples: int) -> Rendered:
        """The point model with a few samples a pixel."""
        return fastest_picture(self._point_scene, samples)

    def equal_time(self) -> tuple[Rendered, Rendered]:
        """The network, and the point model with 1 to 64 samples at equal time.

        Both are timed one after the other and again with a better count, since other work on the machine
        comes and goes.
        """
        network, scene = self.neural_scene(), self._point_scene
        few, some = (fastest_picture(scene, samples).seconds for samples in (_FEW, _SOME))
        slope = max((some - few) / (_SOME - _FEW), 1e-6)
        neural = fastest_picture(network, 1)
        pairs = [(neural, fastest_picture(scene, count_near(_FEW + (neural.seconds - few) / slope)))]
        for _ in range(_CORRECTIONS):
            neural, point = pairs[-1]
            better = count_near(point.samples * neural.seconds / point.seconds)
            if better == point.samples:
                break
            pairs.append((fastest_picture(network, 1), fastest_picture(scene, better)))
        return min(pairs, key=lambda pair: abs(math.log(pair[0].seconds / pair[1].seconds)))

    def neural_scene(self, *bsdfs: BsdfFactory) -> MeasuredScene:
        """The scene of the network, for one sample a pixel; `bsdfs` replace the fabrics'."""
        weights = self.setting.weights
        return self._scene(bsdfs or [cloth_bsdf(fabric, NEURAL, weights) for fabric in self.fabrics], True)

    @cached_property
    def _point_scene(self) -> MeasuredScene:
        return self._scene([cloth_bsdf(fabric, POINT) for fabric in self.fabrics], False)

    def _scene(self, bsdfs: Sequence[BsdfFactory], centred: bool) -> MeasuredScene:
        cloths = list(zip(self.fabrics, bsdfs, strict=True))
        return shot_scene(self.shot, cloths, self.setting.size, centred)


def count_near(samples: float) -> int:
    """The whole number nearest to `samples`, from 1 to 64."""
    return min(max(round(samples), 1), _MAX_EQUAL)


def fastest_picture(scene: MeasuredScene, samples: int) -> Rendered:
    """A picture and its seconds: the fastest of three, after one that compiles."""
    one_picture(scene, samples, 2)
    taken = [timed(lambda: one_picture(scene, samples, 1)) for _ in range(_TIMES)]
    return Rendered(taken[-1][0], samples, min(seconds for _, seconds in taken))


def one_picture(scene: MeasuredScene, samples: int, seed: int = 1) -> NDArray[np.float32]:
    """Linear RGB [height, width, 3] of a scene."""
    return render(scene.scene, spp=samples, seed=seed, integrator=scene.integrator)
