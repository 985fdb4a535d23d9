"""zhu2024, Table 1: samples and seconds to equal quality, with and without clustered control variates.

"Without" is the same surface at independent points, a texel a sample (`ClusteredModel.without_control`); of
models that have no such surface it is the point model. Quality is the mean squared error of linear RGB
against a picture of 1 024 samples a pixel or more, over pixels that lie wholly on one piece of cloth. The
model takes as many samples a pixel as the paper's in that scene; the samples that are needed without for the
same error are read off its errors at 1, 4, 16 … samples, on logarithmic scales. The truth is rendered in two
halves, so that its own noise is in no error (`HalvedTruth`). Seconds are those of pictures whose kernels are
compiled; those without are read off between one sample and a picture of many. Beside both stand `lobes` with
one sample. Places in a pixel are stratified. Counts are those that fill a grid.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.evaluation.metrics import samples_for
from loomlight.evaluation.table import Cell, Table
from loomlight.mitsuba import choose_variant
from loomlight.mitsuba.live import LivePicture
from loomlight.mitsuba.measured_scenes import MeasuredScene
from studies.harness.study import Found, Run, Study, listed, on_display, with_tables
from studies.instruments.halved_truth import HalvedTruth
from studies.instruments.renders import halved_truth, one_picture
from studies.instruments.sheet import PictureTable, Tile
from studies.instruments.timing import Spent, least_times
from studies.papers.zhu2024.scenes import SCENES, SceneSettings, TableScene, TableSettings, table_scene

_POINT_SAMPLES = (1, 4, 16, 64, 256)
_MODEL_SEED, _TRUTH_SEED = 7, 1000
# Samples of the picture that a sample's cost is read off, and turns of each timed picture.
_MAX_TIMED, _TURNS = 64, 5
_COLUMNS = (
    "MSE",
    "samples, with",
    "samples, without",
    "samples ratio",
    "paper's",
    "seconds, with",
    "seconds, without",
    "seconds ratio",
    "paper's, time",
)


@dataclass(frozen=True, eq=False)
class _Shown:
    """A picture, its error and the time that it takes."""

    linear: NDArray[np.float32]
    samples: int
    mse: float
    spent: Spent


@dataclass(frozen=True, eq=False)
class SceneResult:
    """A scene's measurements.

    Attributes:
        scene: which.
        truth: in two halves.
        model, lobes: the model with the paper's samples, and lobes with one.
        point_errors: without control variates, by samples.
        samples: that are needed without for the model's error.
        seconds, cpu_seconds: that they take.
        point_picture: without, of the model's number of samples.
    """

    scene: TableScene
    truth: HalvedTruth
    model: _Shown
    lobes: _Shown
    point_errors: dict[int, float]
    samples: float
    seconds: float
    cpu_seconds: float
    point_picture: NDArray[np.float32]

    @property
    def samples_ratio(self) -> float:
        """Samples without for one of the model."""
        return self.samples / self.model.samples

    @property
    def seconds_ratio(self) -> float:
        """Seconds without for one of the model."""
        return self.seconds / self.model.spent.seconds


def speed_up(settings: TableSettings, run: Run) -> Found:
    """Table 1: every scene that is asked for."""
    choose_variant()
    results = []
    names = listed(settings.scenes)
    for number, name in enumerate(names):
        results.append(measured(SCENES[name], settings))
        run.report(number + 1, len(names))
    return _found(results, settings)


def measured(scene: TableScene, settings: SceneSettings, samples: int | None = None) -> SceneResult:
    """One scene of the table.

    Args:
        samples: of the model, a pixel; by default the paper's.

    Raises:
        InputError: an unknown model, or one that does not take a fabric of the scene.
    """
    point = table_scene(scene, settings, settings.model, controlled=False)
    model = table_scene(scene, settings, settings.model)
    lobes = table_scene(scene, settings, "lobes", pixel_centres=True)
    counted = point.counted
    if not counted.any():
        raise InputError(
            f"size = {settings.size} is too small: no pixel of the {scene.name} is wholly on cloth."
        )
    # Both have one mean; with control variates it has less noise.
    exact = model if settings.model == "clustered" else point
    truth = halved_truth(exact, settings.spp, _TRUTH_SEED)
    ours = samples or scene.paper.samples[0]
    pictures = {
        "point": one_picture(point, ours, _MODEL_SEED),
        "model": one_picture(model, ours, _MODEL_SEED),
        "lobes": one_picture(lobes, 1, _MODEL_SEED),
    }
    errors = {name: truth.squared_error(picture, counted) for name, picture in pictures.items()}
    theirs = {
        count: truth.squared_error(one_picture(point, count, _MODEL_SEED), counted)
        for count in _POINT_SAMPLES
        if count <= settings.spp
    }
    # Where an error is no more than noise about 0, the smallest of the point model bounds it.
    floor = 1e-3 * min(abs(error) for error in theirs.values())
    falling = _falling(theirs)
    needed = samples_for(max(errors["model"], floor), list(falling), list(falling.values()))
    model_time, lobes_time, (seconds, cpu) = _times(model, lobes, point, ours, needed)
    return SceneResult(
        scene,
        truth,
        _Shown(pictures["model"], ours, errors["model"], model_time),
        _Shown(pictures["lobes"], 1, errors["lobes"], lobes_time),
        theirs,
        needed,
        seconds,
        cpu,
        pictures["point"],
    )


def _falling(errors: dict[int, float]) -> dict[int, float]:
    """Errors as far as they fall and are above 0: beyond, noise is all that they are."""
    found: dict[int, float] = {}
    for count, error in errors.items():
        if error <= 0 or (found and error >= min(found.values())):
            break
        found[count] = error
    if len(found) < 2:
        first = next(iter(errors))
        # Monte Carlo errors fall as 1/n.
        found = {first: max(errors[first], 1e-12), 4 * first: max(errors[first], 1e-12) / 4}
    return found


def _times(
    model: MeasuredScene, lobes: MeasuredScene, point: MeasuredScene, ours: int, needed: float
) -> tuple[Spent, Spent, tuple[float, float]]:
    """Times of the model, of lobes, and of the point model with the samples that it needs."""
    many = int(np.clip(round(needed), 2, _MAX_TIMED))
    shots = [(model, ours), (lobes, 1), (point, many), (point, 1)]
    lives = [LivePicture(shot.scene, integrator=shot.integrator, spp=count) for shot, count in shots]
    of_model, of_lobes, of_many, of_one = least_times([live.take for live in lives], _TURNS)

    def extended(more: float, one: float) -> float:
        return one + max(needed - 1, 0) * max(more - one, 0) / (many - 1)

    point_times = (
        extended(of_many.seconds, of_one.seconds),
        extended(of_many.cpu_seconds, of_one.cpu_seconds),
    )
    return of_model, of_lobes, point_times


def _found(results: Sequence[SceneResult], settings: SceneSettings) -> Found:
    columns = ("without, as many samples", settings.model, "lobes, 1 sample", "truth")
    shown = PictureTable("zhu2024 table 1: equal quality in five scenes", columns)
    width, height = settings.size
    table = Table(
        "Equal quality",
        list(_COLUMNS),
        note=f"With: {settings.model} with the paper's samples a pixel; without: the same surface at "
        f"independent points. MSE of linear RGB against {settings.spp} samples, whose own noise is taken "
        f"out; {width} × {height} pixels. Seconds of pictures whose kernels are compiled.",
    )
    processor = Table("Processor seconds of equal quality", ["with", "without", "ratio"])
    biased = Table(
        "lobes with one sample, biased", ["MSE", "MSE of the model", "seconds", "seconds of the model"]
    )
    point = Table("MSE without, by samples", [str(count) for count in _POINT_SAMPLES])
    for result in results:
        name, model = result.scene.name, result.model
        cells: list[Cell] = [
            model.mse,
            model.samples,
            result.samples,
            result.samples_ratio,
            result.scene.paper.samples[1] / result.scene.paper.samples[0],
            model.spent.seconds,
            result.seconds,
            result.seconds_ratio,
            result.scene.paper.seconds[1] / result.scene.paper.seconds[0],
        ]
        table.rows[name] = cells
        ours = model.spent.cpu_seconds
        processor.rows[name] = [ours, result.cpu_seconds, result.cpu_seconds / max(ours, 1e-9)]
        biased.rows[name] = [
            result.lobes.mse,
            model.mse,
            result.lobes.spent.seconds,
            model.spent.seconds,
        ]
        point.rows[name] = [result.point_errors.get(count) for count in _POINT_SAMPLES]
        shown.add(name, _tiles(result, settings))
    return shown.found(with_tables(table, processor, biased, point), table.note)


def _tiles(result: SceneResult, settings: SceneSettings) -> list[Tile]:
    model, lobes = result.model, result.lobes
    return [
        Tile(on_display(result.point_picture), f"{model.samples} spp"),
        Tile(
            on_display(model.linear),
            f"{model.samples} spp, MSE {model.mse:.1e}, {model.spent.seconds:.2f} s; "
            f"without: {result.samples:.0f} spp, {result.seconds:.2f} s",
        ),
        Tile(on_display(lobes.linear), f"MSE {lobes.mse:.1e}, {lobes.spent.seconds:.2f} s"),
        Tile(on_display(result.truth.picture), f"{settings.spp} spp"),
    ]


STUDY = Study(
    "papers/zhu2024/table1",
    "five scenes: samples and seconds to equal quality",
    TableSettings(),
    speed_up,
    stands_on=("point", "lobes", "clustered", "picture", "point cost", "lobes cost", "clustered cost"),
    small={"size": (24, 16), "spp": 4, "scenes": "cylinder", "model": "lobes"},
)
