"""zhu2024, Table 1: samples and seconds to equal quality, with and without clustered control variates.

"Without" is the same surface at independent texels, one a sample (`ClusteredModel.without_control`); of
models that have no such surface it is the point model. "With" is base and residual, whose residual takes two
texels a sample as the model does by default, or one, as many as "without". Visibility is a Gaussian that
saturates, as in the model, or one that does not, of an amplitude of at most 1, as the paper's is; both
surfaces are compared with themselves. One bake serves both ways.

Quality is the mean squared error of linear RGB over pixels that lie wholly on one piece of cloth. The model
takes as many samples a pixel as the paper's in that scene; the samples that are needed without for the same
error are read off its errors at 1, 4, 16 … samples, on logarithmic scales, as far as they bracket it. The
truth is rendered in two halves, so that its own noise is in no error (`HalvedTruth`). Seconds are of the
processor on one thread, of pictures whose kernels are compiled; those without are read off between one sample
and a picture of many. Beside both stand `lobes` with one sample. Places in a pixel are stratified. Counts are
those that fill a grid.

What the scene itself adds is noise to both: the base alone, which has no noise of texels, in a picture of as
many samples, errs from its own mean by shadow edges, folds and what changes within a pixel.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache, partial

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.core.llvm import llvm_float
from loomlight.evaluation.metrics import samples_for
from loomlight.evaluation.table import Cell, Table
from loomlight.mitsuba import choose_variant
from loomlight.mitsuba.live import LivePicture
from loomlight.mitsuba.measured_scenes import MeasuredScene
from loomlight.models.clustered.model import ClusteredModel, ClusteredOptions
from loomlight.models.clustered.square_map import BINS
from loomlight.models.clustered.tables import bake_tables
from loomlight.models.interface import Model
from loomlight.yarn.geometry import YarnGeometry
from studies.harness.study import Found, Run, Study, listed, on_display, with_tables
from studies.instruments.halved_truth import HalvedTruth
from studies.instruments.renders import halved_truth, one_picture
from studies.instruments.sheet import PictureTable, Tile
from studies.instruments.timing import least_times, one_thread
from studies.papers.zhu2024.scenes import (
    SCENES,
    TableScene,
    TableSettings,
    table_fabric,
    table_scene,
)

_POINT_SAMPLES = (1, 4, 16, 64, 256)
_MODEL_SEED, _TRUTH_SEED, _SCENE_SEED = 7, 1000, 2000
# Samples of the picture that a sample's cost is read off, and turns of each timed picture.
_MAX_TIMED, _TURNS = 16, 2
_COLUMNS = (
    "MSE",
    "samples, with",
    "samples, without",
    "samples ratio",
    "paper's",
    "processor seconds, with",
    "without",
    "seconds ratio",
    "paper's, time",
)


@dataclass(frozen=True)
class Way:
    """A way of "with".

    Attributes:
        texels: of the residual, a sample.
        saturating: visibility of texels may saturate.
    """

    texels: int
    saturating: bool

    @property
    def label(self) -> str:
        """As rows are called."""
        texels = "1 texel" if self.texels == 1 else f"{self.texels} texels"
        return texels if self.saturating else f"{texels}, unsaturated"


WAYS = (Way(2, True), Way(1, True), Way(2, False), Way(1, False))


@dataclass(frozen=True, eq=False)
class Shown:
    """A picture, its error, and the processor seconds that it takes."""

    linear: NDArray[np.float32]
    samples: int
    mse: float
    seconds: float


@dataclass(frozen=True, eq=False)
class WayResult:
    """One way of a scene.

    Attributes:
        label: of the way.
        model: with the paper's samples.
        samples: that are needed without for the model's error.
        seconds: of the processor, that they take.
        scene_share: of the model's error that is the scene's own; None where it is not known.
        own_ratio: samples without for one of the model, were there no noise of the scene.
    """

    label: str
    model: Shown
    samples: float
    seconds: float
    scene_share: float | None
    own_ratio: float | None

    @property
    def samples_ratio(self) -> float:
        """Samples without for one of the model."""
        return self.samples / self.model.samples

    @property
    def seconds_ratio(self) -> float:
        """Processor seconds without for one of the model."""
        return self.seconds / max(self.model.seconds, 1e-9)


@dataclass(frozen=True, eq=False)
class SurfaceResult:
    """A surface in a scene: with and without.

    Attributes:
        label: of the surface, "" for that of the model.
        truth: in two halves.
        point_errors: without control variates, by samples.
        point_picture: without, of the model's number of samples.
        ways: with.
    """

    label: str
    truth: HalvedTruth
    point_errors: dict[int, float]
    point_picture: NDArray[np.float32]
    ways: list[WayResult]


@dataclass(frozen=True, eq=False)
class SceneResult:
    """A scene's measurements.

    Attributes:
        scene: which.
        surfaces: those that are compared, the model's own first.
        lobes: with one sample, against the model's truth.
    """

    scene: TableScene
    surfaces: list[SurfaceResult]
    lobes: Shown


def speed_up(settings: TableSettings, run: Run) -> Found:
    """Table 1: every scene that is asked for."""
    choose_variant()
    results = []
    names = listed(settings.scenes)
    for number, name in enumerate(names):
        results.append(measured(SCENES[name], settings))
        run.report(number + 1, len(names))
    return _found(results, settings)


@lru_cache(maxsize=32)
def baked(fabric: str, saturating: bool) -> ClusteredModel:
    """`clustered` of a fabric of the scenes, with visibility that saturates or does not."""
    cloth, options = table_fabric(fabric), ClusteredOptions()
    if saturating:
        return ClusteredModel.for_source(cloth, options)
    appearance = cloth.appearance()
    tables = bake_tables(
        YarnGeometry(cloth.layout()),
        (appearance.warp.roughness, appearance.weft.roughness),
        options.clusters,
        options.rank,
        llvm_float(),
        options.texels,
        saturating=False,
    )
    return ClusteredModel(cloth, tables, options)


def measured(scene: TableScene, settings: TableSettings) -> SceneResult:
    """One scene of the table.

    Raises:
        InputError: an unknown model, or one that does not take a fabric of the scene.
    """
    surfaces = []
    if settings.model == "clustered":
        for kind in listed(settings.visibility):
            saturating = kind == "saturating"
            ways = [way for way in WAYS if way.saturating == saturating]
            surfaces.append(_clustered(scene, settings, ways, "" if saturating else "unsaturated"))
    else:
        whole = partial(table_scene, scene, settings)
        model, point = whole(settings.model), whole("point")
        surfaces.append(_surface(scene, settings, "", point, point, {settings.model: model}, None))
    lobes = table_scene(scene, settings, "lobes", pixel_centres=True)
    picture = one_picture(lobes, 1, _MODEL_SEED)
    (seconds,) = _times([(lobes, 1)])
    error = surfaces[0].truth.squared_error(picture, lobes.counted)
    return SceneResult(scene, surfaces, Shown(picture, 1, error, seconds))


def _clustered(scene: TableScene, settings: TableSettings, ways: Sequence[Way], label: str) -> SurfaceResult:
    """A surface of `clustered`, with and without."""

    def shown(texels: int, controlled: bool = True) -> MeasuredScene:
        def made(fabric: str) -> Model:
            model = baked(fabric, ways[0].saturating).with_samples(texels)
            return model if controlled else model.without_control()

        return table_scene(scene, settings, made)

    models = {way.label: shown(way.texels) for way in ways}
    # All have one mean; of two texels it has the least noise.
    exact = models[ways[0].label]
    return _surface(scene, settings, label, exact, shown(1, controlled=False), models, shown(0))


def _surface(
    scene: TableScene,
    settings: TableSettings,
    label: str,
    exact: MeasuredScene,
    point: MeasuredScene,
    models: dict[str, MeasuredScene],
    base: MeasuredScene | None,
) -> SurfaceResult:
    """A surface with every model, and without.

    Args:
        exact: makes the truth.
        point: without.
        models: with, by the labels of their ways.
        base: what has no noise but the scene's.
    """
    counted = point.counted
    if not counted.any():
        raise InputError(
            f"size = {settings.size} is too small: no pixel of the {scene.name} is wholly on cloth."
        )
    ours = scene.paper.samples[0]
    truth = halved_truth(exact, settings.spp, _TRUTH_SEED)
    pictures = {way: one_picture(model, ours, _MODEL_SEED) for way, model in models.items()}
    errors = {way: truth.squared_error(picture, counted) for way, picture in pictures.items()}
    theirs: dict[int, float] = {}
    for count in _POINT_SAMPLES:
        theirs[count] = truth.squared_error(one_picture(point, count, _MODEL_SEED), counted)
        if len(theirs) > 2 and theirs[count] < min(errors.values()):
            break
    one, as_many = (None, None) if base is None else _scene_noise(base, settings.spp, (1, ours), counted)
    # Where an error is no more than noise about 0, the smallest of the point model bounds it.
    floor = 1e-3 * min(abs(error) for error in theirs.values())
    falling = _falling(theirs)
    needed = {
        way: samples_for(max(error, floor), list(falling), list(falling.values()))
        for way, error in errors.items()
    }
    many = int(np.clip(round(max(needed.values())), 2, _MAX_TIMED))
    *of_models, of_many, of_one = _times(
        [*((model, ours) for model in models.values()), (point, many), (point, 1)]
    )
    one_more = max(of_many - of_one, 0) / (many - 1)
    ways = []
    for (way, error), seconds in zip(errors.items(), of_models, strict=True):
        own_ratio = scene_share = None
        if one is not None and as_many is not None:
            scene_share = as_many / max(error, floor)
            own_ratio = (theirs[1] - one) / (ours * max(error - as_many, floor))
        ways.append(
            WayResult(
                way,
                Shown(pictures[way], ours, error, seconds),
                needed[way],
                of_one + max(needed[way] - 1, 0) * one_more,
                scene_share,
                own_ratio,
            )
        )
    return SurfaceResult(label, truth, theirs, one_picture(point, ours, _MODEL_SEED), ways)


def _scene_noise(
    base: MeasuredScene, spp: int, samples: Sequence[int], counted: NDArray[np.bool_]
) -> list[float]:
    """Mean squared errors of the base alone against itself, of so many samples a pixel."""
    truth = halved_truth(base, spp, _SCENE_SEED)
    return [truth.squared_error(one_picture(base, count, _MODEL_SEED), counted) for count in samples]


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


def _times(shots: Sequence[tuple[MeasuredScene, int]]) -> list[float]:
    """Processor seconds of pictures of so many samples, which take turns."""
    with one_thread():
        lives = [LivePicture(scene.scene, integrator=scene.integrator, spp=count) for scene, count in shots]
        return [spent.cpu_seconds for spent in least_times([live.take for live in lives], _TURNS)]


# ----------------------------------------------------------------------------------------------------- tables


def _found(results: Sequence[SceneResult], settings: TableSettings) -> Found:
    width, height = settings.size
    table = Table(
        "Equal quality",
        list(_COLUMNS),
        note=f"With: {settings.model} with the paper's samples a pixel, whose residual takes so many texels; "
        "without: the same surface at independent texels, one a sample. MSE of linear RGB; the truth has "
        f"{settings.spp} samples, whose own noise is taken out; {width} × {height} pixels. Seconds are of "
        "the processor, on one thread.",
    )
    limits = Table(
        "What limits it",
        ["share of the scene's noise", "samples ratio without it"],
        note="Share of the error with that the base alone has, whose texels have no noise: shadow edges, "
        "folds, light that other cloth scatters, and what changes within a pixel.",
    )
    biased = Table(
        "lobes with one sample, biased",
        ["MSE", "MSE of the model", "processor seconds", "processor seconds of the model"],
    )
    point = Table("MSE without, by samples", [str(count) for count in _POINT_SAMPLES])
    for result in results:
        scene = result.scene
        for surface in result.surfaces:
            name = f"{scene.name}, {surface.label}" if surface.label else scene.name
            point.rows[name] = [surface.point_errors.get(count) for count in _POINT_SAMPLES]
            for way in surface.ways:
                row = f"{scene.name}, {way.label}"
                table.rows[row] = _cells(scene, way)
                if way.scene_share is not None:
                    limits.rows[row] = [way.scene_share, way.own_ratio]
        model = result.surfaces[0].ways[0].model
        biased.rows[scene.name] = [result.lobes.mse, model.mse, result.lobes.seconds, model.seconds]
    tables = [table, limits] if limits.rows else [table]
    if settings.model == "clustered":
        tables.append(_storage([result.scene for result in results]))
    return _pictures(results, settings).found(with_tables(*tables, biased, point), table.note)


def _cells(scene: TableScene, way: WayResult) -> list[Cell]:
    paper = scene.paper
    return [
        way.model.mse,
        way.model.samples,
        way.samples,
        way.samples_ratio,
        paper.samples[1] / paper.samples[0],
        way.model.seconds,
        way.seconds,
        way.seconds_ratio,
        paper.seconds[1] / paper.seconds[0],
    ]


def _storage(scenes: Sequence[TableScene]) -> Table:
    """Bytes of the fabrics of scenes: both faces of each."""
    table = Table(
        "Storage",
        ["uncompressed, GB", "in files, MB", "on a device, MB", "paper's, GB", "paper's compressed, MB"],
        note="Uncompressed: a summed-area table of floats for each cluster and bin of half vectors.",
    )
    for scene in scenes:
        tables = [baked(fabric, True).tables for _, fabric in scene.pieces]
        whole = sum(2 * each.columns * each.rows * each.clusters * BINS**2 * 4 for each in tables)
        table.rows[scene.name] = [
            whole / 1e9,
            sum(each.nbytes for each in tables) / 1e6,
            sum(each.device_bytes for each in tables) / 1e6,
            *scene.paper.storage,
        ]
    return table


def _pictures(results: Sequence[SceneResult], settings: TableSettings) -> PictureTable:
    columns = ("without, as many samples", settings.model, "lobes, 1 sample", "truth")
    shown = PictureTable("zhu2024 table 1: equal quality in five scenes", columns)
    for result in results:
        for surface in result.surfaces:
            way, lobes = surface.ways[0], result.lobes
            model = way.model
            tiles = [
                Tile(on_display(surface.point_picture), f"{model.samples} spp"),
                Tile(
                    on_display(model.linear),
                    f"{model.samples} spp, {way.label}, MSE {model.mse:.1e}, {model.seconds:.2f} s; "
                    f"without: {way.samples:.0f} spp, {way.seconds:.2f} s",
                ),
                Tile(on_display(lobes.linear), f"MSE {lobes.mse:.1e}, {lobes.seconds:.2f} s")
                if not surface.label
                else Tile(None),
                Tile(on_display(surface.truth.picture), f"{settings.spp} spp"),
            ]
            scene = result.scene.name
            shown.add(f"{scene}, {surface.label}" if surface.label else scene, tiles)
    return shown


_STANDS_ON = ("point", "lobes", "clustered", "picture", "point cost", "lobes cost", "clustered cost")
_SMALL = {"size": (24, 16), "spp": 4, "scenes": "cylinder", "model": "lobes"}
STUDIES = (
    Study(
        "papers/zhu2024/table1",
        "five scenes: samples and seconds to equal quality",
        TableSettings(),
        speed_up,
        stands_on=_STANDS_ON,
        small=_SMALL,
    ),
    Study(
        "papers/zhu2024/table1_large",
        "the same of drape and cylinder in larger pictures, with the paper's Gaussians too",
        TableSettings(size=(480, 270), scenes="drape,cylinder", visibility="saturating,unsaturated"),
        speed_up,
        stands_on=_STANDS_ON,
        small=_SMALL,
    ),
    Study(
        "papers/zhu2024/table1_cylinder",
        "the same of the cylinder from afar, with the paper's Gaussians too",
        TableSettings(size=(160, 90), scenes="cylinder", visibility="saturating,unsaturated"),
        speed_up,
        stands_on=_STANDS_ON,
        small=_SMALL,
    ),
)
