"""Settings of all figures: sizes, samples, the network, and progress."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from loomlight.core.llvm import llvm_float
from loomlight.evaluation.query_benchmark import Predictor, model_predictor
from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba import material_bsdf
from loomlight.mitsuba.scenes import BsdfFactory
from loomlight.models.neural.encoding import encode
from loomlight.models.neural.model import NeuralModel
from loomlight.models.neural.weights import Weights, read_weights, shipped_weights

SIZE, SAMPLES = (384, 216), 256
RUNS = Path("runs")
POINT, LOBES, NEURAL, CLUSTERED, LATENT = "point", "lobes", "neural", "clustered", "latent"
NEUMIP = "neumip"

# Called with (steps done, steps in all).
Progress = Callable[[int, int], None]


@dataclass(frozen=True)
class Setting:
    """Settings of a figure.

    Attributes:
        size: width and height of each picture, pixels.
        samples: samples a pixel of references.
        weights: a weights file; None is the package's.
        runs: the folder of trainings, by the names of their configurations.
        progress: called after every step of a figure.
        model: of figures that show one model beside the point model.
        quality: of trainings that a figure makes, such as "preview".
        steps: of these trainings; by default as the quality says.
        resolution: texels a side of the textures of `neumip`; by default as the quality says.
        environment: a latitude-longitude picture for scenes that an environment lights; None is the studio.
    """

    size: tuple[int, int] = SIZE
    samples: int = SAMPLES
    weights: Path | None = None
    runs: Path = RUNS
    progress: Progress | None = None
    model: str = NEURAL
    environment: Path | None = None
    quality: str = "preview"
    steps: int | None = None
    resolution: int | None = None

    def network(self) -> Weights:
        """The network of the figure.

        Raises:
            InputError: no weights file, or a damaged one.
        """
        return shipped_weights() if self.weights is None else read_weights(self.weights)

    def step(self, done: int, total: int) -> None:
        """Reports progress."""
        if self.progress is not None:
            self.progress(done, total)


def cloth_bsdf(fabric: Fabric, model: str, weights: Path | None = None, **options: Any) -> BsdfFactory:
    """`material_bsdf` with the network of a weights file, and with other options of the model."""
    if weights is not None and model == NEURAL:
        options["weights"] = str(weights)
    return material_bsdf(fabric, model, **options)


def neural_predictor(weights: Weights) -> Predictor:
    """A predictor with the network of these weights, which encodes each fabric."""
    return model_predictor(lambda fabric: NeuralModel(fabric, encode(fabric, weights, llvm_float()), weights))
