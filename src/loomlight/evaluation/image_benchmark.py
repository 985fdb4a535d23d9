"""The image benchmark: eight scenes rendered with one sample a pixel, against the point model with many.

One directional light, direct light only, box filter, exposure 0 (docs/research/evaluation.md). Models that
filter are evaluated once a pixel, with the pixel as their footprint. Models of points are rendered with 1 and
3 samples a pixel from Mitsuba's sampler.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError, MissingDependencyError
from loomlight.evaluation.metrics import PictureError, picture_error
from loomlight.evaluation.table import Cell, Table
from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba import choose_variant, render
from loomlight.mitsuba.measured_scenes import MEASURED_SCENES, MeasuredScene, measured_scene
from loomlight.models.interface import Model
from loomlight.models.registry import REFERENCE_MODEL, model_class, require_model_name

POINT_SAMPLES = (1, 3)
# Comparisons with a few Monte Carlo samples count from so many yarns a pixel on.
COUNTED_FROM_YARNS = 2.0

Progress = Callable[[int, int], None]
# From a model's name and a fabric to the model.
MakeModel = Callable[[str, Fabric], Model]


@dataclass(frozen=True)
class Shot:
    """One row of the table: a model with so many samples a pixel."""

    model: str
    samples: int

    @property
    def name(self) -> str:
        """Such as "neural, 1 spp"."""
        return f"{self.model}, {self.samples} spp"

    @property
    def pixel_centres(self) -> bool:
        """Whether rays go through the middle of pixels."""
        return self.samples == 1 and model_class(self.model).filters


@dataclass(frozen=True, eq=False)
class Picture:
    """One shot of one scene.

    Attributes:
        linear: the picture [height, width, 3].
        seconds: of rendering, with kernels compiled beforehand.
        error: against the reference.
    """

    linear: NDArray[np.float32]
    seconds: float
    error: PictureError


@dataclass(frozen=True, eq=False)
class SceneResult:
    """One scene.

    Attributes:
        name, yarns_per_pixel: which scene.
        reference: the picture [height, width, 3].
        seconds: of rendering it.
        pictures: by the shot's name.
        refused: the reason, by the name of each model that does not take the fabric.
    """

    name: str
    yarns_per_pixel: float
    reference: NDArray[np.float32]
    seconds: float
    pictures: dict[str, Picture]
    refused: dict[str, str] = field(default_factory=dict)


def shots_of(models: Sequence[str]) -> list[Shot]:
    """The rows of these models; the point model's, 1 and 3 samples, are always among them.

    Raises:
        InputError: an unknown model.
    """
    for name in models:
        require_model_name(name)
    others = [Shot(name, 1) for name in dict.fromkeys(models) if name != REFERENCE_MODEL]
    return [*(Shot(REFERENCE_MODEL, samples) for samples in POINT_SAMPLES), *others]


def run_image_benchmark(
    models: Sequence[str],
    fabrics: Sequence[Fabric],
    *,
    scenes: Sequence[str] = MEASURED_SCENES,
    size: tuple[int, int],
    reference_samples: int,
    seed: int = 0,
    progress: Progress | None = None,
    make: MakeModel | None = None,
    finished: Callable[[SceneResult], None] = lambda scene: None,
) -> list[SceneResult]:
    """Renders every scene with every model and measures the errors of the pictures.

    Args:
        models: names; see `shots_of`.
        fabrics: two; the second is the background of "two fabrics".
        size: width and height in pixels.
        reference_samples: samples a pixel of the reference.
        progress: called with (steps done, steps in all); a step is a picture or a pass of a reference.
        make: from a model's name and a fabric to the model; by default each scene makes its own.
        finished: called with each scene when it is measured.

    Raises:
        InputError: an unknown model or scene.
    """
    choose_variant()
    shots = shots_of(models)
    results = []
    for number, name in enumerate(scenes):

        def report(done: int, total: int, number: int = number) -> None:
            if progress is not None:
                progress(number * 100 + round(100 * done / total), 100 * len(scenes))

        results.append(_scene(name, shots, fabrics, size, reference_samples, seed, report, make))
        finished(results[-1])
    return results


def _scene(
    name: str,
    shots: list[Shot],
    fabrics: Sequence[Fabric],
    size: tuple[int, int],
    reference_samples: int,
    seed: int,
    progress: Progress,
    make: MakeModel | None,
) -> SceneResult:
    scene = measured_scene(name, fabrics, REFERENCE_MODEL, size)
    start = time.perf_counter()
    reference = _render(scene, reference_samples, seed, progress)
    seconds = time.perf_counter() - start
    pictures: dict[str, Picture] = {}
    refused: dict[str, str] = {}
    for shot in shots:
        try:
            model_scene = scene
            if shot.model != REFERENCE_MODEL:
                made = shot.model if make is None else partial(make, shot.model)
                model_scene = measured_scene(name, fabrics, made, size, shot.pixel_centres)
            # The first picture, of another seed, compiles the kernels; the next one is measured.
            _render(model_scene, shot.samples, seed + 2)
        except (InputError, MissingDependencyError) as error:
            refused[shot.model] = str(error)
            continue
        start = time.perf_counter()
        linear = _render(model_scene, shot.samples, seed + 1)
        elapsed = time.perf_counter() - start
        pictures[shot.name] = Picture(linear, elapsed, picture_error(linear, reference, model_scene.counted))
    return SceneResult(name, scene.yarns_per_pixel, reference, seconds, pictures, refused)


def _render(
    scene: MeasuredScene, samples: int, seed: int, progress: Progress | None = None
) -> NDArray[np.float32]:
    return render(scene.scene, spp=samples, seed=seed, integrator=scene.integrator, progress=progress)


def image_tables(results: list[SceneResult]) -> list[Table]:
    """Three tables: FLIP, MSE and seconds, a row a shot and a column a scene."""
    names = list(dict.fromkeys(name for result in results for name in result.pictures))
    columns = [f"{result.name} ({result.yarns_per_pixel:g})" for result in results]
    note = (
        "Scenes with the yarns that a pixel covers; the comparison with few samples counts from "
        f"{COUNTED_FROM_YARNS:g} yarns on."
    )
    quantities: list[tuple[str, Callable[[Picture], Cell]]] = [
        ("Mean FLIP", lambda picture: picture.error.flip),
        ("MSE of linear RGB", lambda picture: picture.error.mse),
        ("Seconds a picture", lambda picture: picture.seconds),
    ]
    tables = []
    for title, value in quantities:
        table = Table(title, columns, note=note)
        for name in names:
            table.rows[name] = [value(r.pictures[name]) if name in r.pictures else None for r in results]
        tables.append(table)
    tables[-1].rows["reference"] = [result.seconds for result in results]
    return tables
