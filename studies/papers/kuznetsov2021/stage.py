"""What the tables of kuznetsov2021 are made from: materials, trainings, a plane seen at 45°, and errors.

The paper's height fields are of a library for sale: five formulas of their character stand for them
(`materials.py`). Pictures are of a plane under a camera at 45° and one distant light from the
left, as in the paper's Fig. 6. A pixel is one query of the size of its footprint on the plane; the truth
averages paths over the same Gaussian, so that errors are the model's alone.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from drjit.llvm.ad import Array2f, Array3f
from numpy.typing import NDArray

from loomlight.core.extras import import_extra
from loomlight.core.footprint import Box, box_footprint
from loomlight.core.settings import same_setting, setting
from loomlight.evaluation.metrics import PictureError, picture_error
from loomlight.models.registry import btf_of, model_from_loom
from loomlight.models.texture.neumip import NeumipModel
from loomlight.models.texture.pyramid import SIZE_OF_SIGMA, PyramidShape
from loomlight.models.texture.settings import NeumipSettings
from loomlight.sources.heightfield import Heightfield
from loomlight.sources.loom_file import write_loom
from studies.harness.study import listed, names
from studies.instruments.halved_truth import HalvedTruth
from studies.papers.kuznetsov2021.designs import DESIGNS, OURS, WITHOUT, Design
from studies.papers.kuznetsov2021.materials import RECIPES, SIDE, paper_heightfield
from studies.papers.setting import PictureSettings, TrainedSettings

_Floats = NDArray[np.float32]
# The paper's schedule, for GPUs.
PUBLISHED = NeumipSettings(
    resolution=512,
    queries=400 * 512**2,
    fine_samples=64,
    samples=64,
    steps=30_000,
    batch=1 << 20,
    rate=1e-3,
    texture_rate=1e-3,
    offset_share=1 / 3,
    footprint_texels=1,
)
# The same in fewer steps, with higher rates. `preview` is for tables of 20 or 30 trainings: two cores take
# minutes for a material.
_SHORT = replace(PUBLISHED, rate=3e-3, texture_rate=1e-2, offset_share=2 / 3)
PREVIEW = replace(
    _SHORT, resolution=128, queries=100 * 128**2, fine_samples=8, samples=8, steps=1000, batch=1 << 13
)
FULL = replace(
    _SHORT, resolution=256, queries=300 * 256**2, fine_samples=16, samples=16, steps=6000, batch=1 << 16
)
# Horizontal angle of view; the footprint of the nearest row is about two thirds of the farthest's.
_VIEW_ANGLE = math.radians(20)
_LIGHT = np.array([-0.45, 0.15, 1.0]) / np.linalg.norm([-0.45, 0.15, 1.0])
_SEED = 41
# Paths of one call: a picture's footprints are held in memory.
_CHUNK = 1 << 21

# f·cos, linear RGB [n, 3], 1/sr, of the queries of a shot.
Predict = Callable[["Shot"], _Floats]


@dataclass(frozen=True, eq=False)
class Shot:
    """The queries of a picture.

    Attributes:
        size: width and height, pixels.
        positions: on the reference plane [n, 2], millimetres.
        sides: of the footprints [n], millimetres.
        views: unit vectors [n, 3].
        light: the unit vector of all pixels [3], or of each [n, 3].
    """

    size: tuple[int, int]
    positions: _Floats
    sides: _Floats
    views: _Floats
    light: _Floats

    @property
    def lights(self) -> _Floats:
        """The light of each pixel [n, 3]."""
        return np.ascontiguousarray(np.broadcast_to(self.light, self.views.shape))


@dataclass(frozen=True)
class HeightfieldSettings(PictureSettings):
    """Of figures of height fields."""

    spp: int = same_setting(PictureSettings, "spp", default=64)
    side: int = setting(SIDE, "Texels a side of the maps of height fields.", low=8, high=1024)

    def heightfield(self, name: str) -> Heightfield:
        """A material of Table 2."""
        return paper_heightfield(name, self.side)


@dataclass(frozen=True)
class HeightfieldsSettings(HeightfieldSettings):
    """Of figures of all height fields."""

    materials: str = names(",".join(RECIPES), "Height fields that are shown.", tuple(RECIPES))

    def sources(self) -> list[Heightfield]:
        """The height fields that are shown."""
        return [self.heightfield(name) for name in listed(self.materials)]


@dataclass(frozen=True)
class StageSettings(HeightfieldSettings, TrainedSettings):
    """Of figures that train a height field by the published recipe."""


@dataclass(frozen=True)
class MaterialsSettings(HeightfieldsSettings, StageSettings):
    """Of figures that train all height fields."""


def stage_settings(settings: StageSettings, resolution: int | None = None) -> NeumipSettings:
    """Settings of the trainings of a figure, with as many queries a texel at any resolution."""
    chosen = {"preview": PREVIEW, "full": FULL, "published": PUBLISHED}[settings.quality]
    usual = chosen.resolution or chosen.max_resolution
    resolution = resolution or settings.resolution or usual
    queries = chosen.queries // usual**2 * resolution**2
    return replace(chosen, resolution=resolution, queries=queries, steps=settings.steps or chosen.steps)


def plane_shot(source: Heightfield, texel_mm: float, level: float, size: tuple[int, int]) -> Shot:
    """A plane at 45°, whose middle pixel has a footprint of 2^level texels.

    Args:
        texel_mm: side of a texel of level 0.
    """
    width, _ = size
    pitch = 2 * math.tan(0.5 * _VIEW_ANGLE) / width  # of pixels at distance 1
    x, y = (np.arange(count) + 0.5 - 0.5 * count for count in size)
    across, up = np.meshgrid(pitch * x, -pitch * y)
    eye_direction = np.array([0, -1, 1]) / math.sqrt(2)  # from the plane to the camera
    forward, upward = -eye_direction, np.array([0, 1, 1]) / math.sqrt(2)
    rays = forward + across[..., None] * np.array([1.0, 0, 0]) + up[..., None] * upward
    # A pixel's area on the plane, for a camera at height 1: solid angle · distance² / cosine.
    area = pitch**2 / (-rays[..., 2]) ** 3
    middle = pitch**2 * math.sqrt(2) ** 3
    camera_height = texel_mm * 2**level / math.sqrt(middle)
    distance = camera_height / -rays[..., 2]
    hits = distance[..., None] * rays
    # The middle of the picture shows the middle of a repeat.
    centre = camera_height * np.array([0.0, 1.0])
    positions = hits[..., :2] - centre + 0.5 * np.array(source.repeat_mm)
    views = -rays / np.linalg.norm(rays, axis=-1, keepdims=True)
    sides = camera_height * np.sqrt(area)
    return Shot(
        size,
        # Within a repeat, where single precision suffices.
        (positions % np.array(source.repeat_mm)).reshape(-1, 2).astype(np.float32),
        sides.reshape(-1).astype(np.float32),
        views.reshape(-1, 3).astype(np.float32),
        _LIGHT.astype(np.float32),
    )


def traced(source: Heightfield, shot: Shot, samples: int) -> HalvedTruth:
    """The truth of a picture: π f·cos [height, width, 3].

    Args:
        samples: paths a pixel, half of them for each estimate.
    """
    btf, count, each = btf_of(source, "neumip"), len(shot.sides), max(1, samples // 2)
    halves = []
    for half in range(2):
        rng = np.random.default_rng([_SEED, half])
        parts = []
        rows = max(1, _CHUNK // each)
        for first in range(0, count, rows):
            chosen = slice(first, min(first + rows, count))
            number = chosen.stop - first
            spread = rng.standard_normal((number, each, 2), np.float32)
            sigma = (shot.sides[chosen] / SIZE_OF_SIGMA)[:, None, None]
            points = (shot.positions[chosen, None] + sigma * spread).reshape(-1, 2)
            lights, views = (np.repeat(part[chosen], each, axis=0) for part in (shot.lights, shot.views))
            found = btf.values(points.astype(np.float32), lights, views, (_SEED, half, first))
            parts.append(found.reshape(number, each, 3).mean(axis=1))
        halves.append(_as_picture(np.concatenate(parts), shot))
    return HalvedTruth((halves[0], halves[1]))


def clamped(truth: HalvedTruth) -> HalvedTruth:
    """A truth whose values are at most 1, as of white cloth; of noisy highlights it is a little too dark."""
    one, other = (np.minimum(half, np.float32(1)) for half in truth.halves)
    return HalvedTruth((one, other))


def model_picture(predict: Predict, shot: Shot) -> _Floats:
    """π f·cos of a model [height, width, 3]."""
    return _as_picture(predict(shot), shot)


def stage_error(picture: _Floats, truth: HalvedTruth) -> PictureError:
    """MSE of linear RGB without the noise of the truth, which two estimates cancel, and FLIP with it."""
    found = picture_error(picture, truth.picture, np.ones(picture.shape[:2], bool))
    return replace(found, mse=truth.squared_error(picture))


def trained_model(
    source: Heightfield,
    settings: StageSettings,
    runs: Path,
    name: str = OURS,
    report: Callable[[int, int], None] | None = None,
) -> NeumipModel:
    """The model of a source, with or without the offset; a training is kept in the folder of runs.

    Args:
        name: `OURS` or `WITHOUT`.

    Raises:
        InputError: a folder that cannot be written to.
        MissingDependencyError: PyTorch is missing, where there is a training to do.
    """
    training = stage_settings(settings)
    place = _place(source, training, runs, name)
    file = place / "model.loom"
    if file.exists():
        model = model_from_loom(file)
        if isinstance(model, NeumipModel):
            return model
    import_extra("torch", "train", "Training neumip")
    from studies.papers.kuznetsov2021.neural_textures import trained_textures

    textures = trained_textures(DESIGNS[name], source, training, place, _queries(runs), report)
    model = NeumipModel(source, textures.weights())
    write_loom(file, model.to_loom())
    return model


def predictor(
    source: Heightfield,
    settings: StageSettings,
    runs: Path,
    name: str,
    design: Design | None = None,
    resolution: int | None = None,
) -> Predict:
    """The values of a trained design.

    Args:
        name: of `DESIGNS`, or of the design given.
        design: any other, trained as a torch module.
        resolution: of its textures, instead of `stage_settings`'.

    Raises:
        InputError: as of `trained_model`.
    """
    if design is None and name in (OURS, WITHOUT):
        return model_predictor(trained_model(source, settings, runs, name))
    import_extra("torch", "train", "Training a design")
    from studies.papers.kuznetsov2021.neural_textures import trained_textures

    training = stage_settings(settings, resolution)
    place = _place(source, training, runs, name)
    network = trained_textures(design or DESIGNS[name], source, training, place, _queries(runs))
    return network_predictor(network, source)


def network_predictor(network: Any, source: Heightfield) -> Predict:
    """The values of a torch module of `neural_textures.py`."""
    shape: PyramidShape = network.shape

    def predict(shot: Shot) -> Any:
        repeats = (shot.positions / np.array(source.repeat_mm)).astype(np.float32)
        levels = np.log2(shot.sides / shape.footprint_mm)
        return network.value(repeats, levels, shot.lights[:, :2], shot.views[:, :2])

    return predict


def model_predictor(model: NeumipModel) -> Predict:
    """The values of a model of this package."""

    def predict(shot: Shot) -> _Floats:
        positions, lights, views = (
            np.ascontiguousarray(part.T) for part in (shot.positions, shot.lights, shot.views)
        )
        box = Box(Array2f(positions), Array2f(shot.sides, shot.sides))
        at = model.at(Array3f(views), box_footprint(box))
        return np.asarray(at.value(Array3f(lights)).numpy().T, np.float32)

    return predict


def _as_picture(values: _Floats, shot: Shot) -> _Floats:
    width, height = shot.size
    return np.asarray(np.pi * values.reshape(height, width, 3), np.float32)


def _place(source: Heightfield, settings: NeumipSettings, runs: Path, name: str) -> Path:
    identity = settings.identity(source)[:12]
    return runs / "kuznetsov2021" / f"{source.name}-{name}-{identity}".replace(" ", "-").lower()


def _queries(runs: Path) -> Path:
    folder = runs / "kuznetsov2021" / "queries"
    folder.mkdir(parents=True, exist_ok=True)
    return folder
