"""What the figures of chen2024 are made from: a shot by the network, and by the point model at equal time."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.llvm import llvm_float
from loomlight.core.settings import setting
from loomlight.evaluation.query_benchmark import Predictor, model_predictor
from loomlight.evaluation.table import Table
from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba import choose_variant, material_bsdf
from loomlight.mitsuba.measured_scenes import MeasuredScene, MeasuredShot, shot_counted, shot_scene
from loomlight.mitsuba.scenes import BsdfFactory
from loomlight.models.neural.encoding import encode
from loomlight.models.neural.model import NeuralModel
from loomlight.models.neural.weights import Weights, read_weights, shipped_weights
from studies.harness.study import Figures, with_tables
from studies.instruments.renders import Rendered, fastest_picture, one_picture
from studies.instruments.timing import timed
from studies.papers.setting import PictureSettings

_MAX_EQUAL = 64
_CORRECTIONS = 2
# Sample counts between which the time of a sample is measured.
_FEW, _SOME = 1, 9


@dataclass(frozen=True)
class NetworkSettings(PictureSettings):
    """Of figures that show the network."""

    weights: os.PathLike[str] | None = setting(
        None, "Weights of the network.", otherwise="the package's", metavar="FILE"
    )

    def network(self) -> Weights:
        """The network of the figure.

        Raises:
            InputError: no weights file, or a damaged one.
        """
        return shipped_weights() if self.weights is None else read_weights(Path(self.weights))

    def stage(self, shot: MeasuredShot, *fabrics: Fabric) -> Stage:
        """A shot of fabrics."""
        return Stage(self, shot, *fabrics, weights=self.weights)

    def figures(self, *tables: Table) -> Figures:
        """Tables, and which network they are of."""
        network = self.network()
        return with_tables(*tables, weights={"sha256": network.sha256, "trained": network.trained})


def neural_bsdf(fabric: Fabric, weights: os.PathLike[str] | None = None, **options: Any) -> BsdfFactory:
    """The network as a BSDF.

    Args:
        weights: a weights file; by default the package's.
        options: others of the model.
    """
    if weights is not None:
        options["weights"] = str(weights)
    return material_bsdf(fabric, "neural", **options)


def neural_predictor(weights: Weights) -> Predictor:
    """A predictor with the network of these weights, which encodes each fabric."""
    return model_predictor(lambda fabric: NeuralModel(fabric, encode(fabric, weights, llvm_float()), weights))


class Stage:
    """A shot with the fabrics that it shows, one for each of its pieces."""

    def __init__(
        self,
        settings: PictureSettings,
        shot: MeasuredShot,
        *fabrics: Fabric,
        weights: os.PathLike[str] | None = None,
    ) -> None:
        """
        Args:
            weights: of the network; by default the package's.
        """
        choose_variant()
        self.settings = settings
        self.shot = shot
        self.fabrics = fabrics
        self.weights = weights

    @property
    def counted(self) -> NDArray[np.bool_]:
        """Pixels that lie wholly on one piece [height, width]."""
        return shot_counted(self.shot, self.settings.size)

    def reference(self) -> Rendered:
        """The point model with many samples a pixel."""
        scene = self._point_scene
        samples = self.settings.spp
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
        return self._scene(bsdfs or [neural_bsdf(fabric, self.weights) for fabric in self.fabrics], True)

    @cached_property
    def _point_scene(self) -> MeasuredScene:
        return self._scene([material_bsdf(fabric, "point") for fabric in self.fabrics], False)

    def _scene(self, bsdfs: Sequence[BsdfFactory], centred: bool) -> MeasuredScene:
        cloths = list(zip(self.fabrics, bsdfs, strict=True))
        return shot_scene(self.shot, cloths, self.settings.size, centred)


def count_near(samples: float) -> int:
    """The whole number nearest to `samples`, from 1 to 64."""
    return min(max(round(samples), 1), _MAX_EQUAL)
