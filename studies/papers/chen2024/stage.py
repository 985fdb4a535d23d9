"""What the figures of chen2024 are made from: a shot by the network, and by the point model at equal time."""

from __future__ import annotations

import gc
import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.llvm import llvm_float
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.query_benchmark import Predictor, model_predictor
from loomlight.evaluation.table import Table
from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba import choose_variant, material_bsdf
from loomlight.mitsuba.measured_scenes import MeasuredScene, MeasuredShot, shot_counted, shot_scene
from loomlight.mitsuba.rendering import samples_rendered
from loomlight.mitsuba.scenes import BsdfFactory
from loomlight.models.neural.encoding import encode
from loomlight.models.neural.model import NeuralModel
from loomlight.models.neural.weights import Weights, read_weights, shipped_weights
from studies.harness.study import Figures, with_tables
from studies.instruments.renders import Rendered, one_picture, timed_pictures
from studies.instruments.timing import equal_time, one_thread
from studies.papers.setting import PictureSettings

_MAX_EQUAL = 64


@dataclass(frozen=True)
class WeightsSettings(Settings):
    """Of what is measured of the network."""

    weights: os.PathLike[str] | None = setting(
        None, "Weights of the network.", otherwise="the package's", metavar="FILE"
    )

    def network(self) -> Weights:
        """The network of the figure.

        Raises:
            InputError: no weights file, or a damaged one.
        """
        return shipped_weights() if self.weights is None else read_weights(Path(self.weights))

    def figures(self, *tables: Table) -> Figures:
        """Tables, and which network they are of."""
        network = self.network()
        return with_tables(*tables, weights={"sha256": network.sha256, "trained": network.trained})


@dataclass(frozen=True)
class NetworkSettings(WeightsSettings, PictureSettings):
    """Of figures of pictures by the network."""

    def stage(self, shot: MeasuredShot, *fabrics: Fabric) -> Stage:
        """A shot of fabrics."""
        return Stage(self, shot, *fabrics, weights=self.weights)


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

    def reference(self) -> NDArray[np.float32]:
        """Linear RGB of the point model with many samples a pixel."""
        return one_picture(self._point_scene, self.settings.spp, 0)

    def pictures(self, few: Sequence[int], *others: Sequence[BsdfFactory]) -> list[Rendered]:
        """The point model with each of a few sample counts, and at equal time; the network; and others.

        Times are processor seconds of one thread, of kernels that are compiled. Networks are gone when the
        point model is timed: its kernels would be traced through every BSDF of the process.

        Args:
            others: BSDFs for all fabrics, shown with one sample as the network is.
        """
        neural, *beside = [
            _alone(partial(self.neural_scene, *bsdfs)) for bsdfs in ((), *(tuple(each) for each in others))
        ]
        point = self._point_scene
        timed = timed_pictures([(point, count) for count in few])
        with one_thread():
            equal = equal_time(
                neural.cpu_seconds,
                partial(one_picture, point),
                most=_MAX_EQUAL,
                possible=partial(samples_rendered, point.scene),
            )
        as_long = Rendered(one_picture(point, equal.count), equal.count, equal.seconds)
        return [*timed, as_long, neural, *beside]

    def neural_scene(self, *bsdfs: BsdfFactory) -> MeasuredScene:
        """The scene of the network, for one sample a pixel; `bsdfs` replace the fabrics'."""
        return self._scene(bsdfs or [neural_bsdf(fabric, self.weights) for fabric in self.fabrics], True)

    @cached_property
    def _point_scene(self) -> MeasuredScene:
        return self._scene([material_bsdf(fabric, "point") for fabric in self.fabrics], False)

    def _scene(self, bsdfs: Sequence[BsdfFactory], centred: bool) -> MeasuredScene:
        cloths = list(zip(self.fabrics, bsdfs, strict=True))
        return shot_scene(self.shot, cloths, self.settings.size, centred)


def _alone(scene: Callable[[], MeasuredScene]) -> Rendered:
    """A picture of a scene with one sample; its BSDFs are gone afterwards."""
    (picture,) = timed_pictures([(scene(), 1)])
    gc.collect()
    return picture
