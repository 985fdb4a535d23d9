"""What the tables of zeltner2024's supplemental are made from: a stage, trainings, and six errors.

The paper's scenes and materials are not public: four layered materials of this package stand for them, each
on a sphere of 0.1 m over a grey ground in the studio's light, seen whole, close, and from far. Models and
references are rendered with as many samples, all of them with light that other surfaces scattered once.
"""

from __future__ import annotations

import shutil
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from drjit.llvm.ad import Array2f, Array3f
from numpy.typing import NDArray

from loomlight.core.footprint import Footprint
from loomlight.core.settings import same_setting
from loomlight.evaluation.metrics import PictureError, picture_error
from loomlight.evaluation.table import Table
from loomlight.mitsuba import choose_variant, shapes
from loomlight.mitsuba.lights import environment_dict, light_dicts
from loomlight.mitsuba.material_btf import material_bsdf_of
from loomlight.mitsuba.measured_scenes import MeasuredScene
from loomlight.mitsuba.plugins import make_bsdf
from loomlight.mitsuba.scenes import BsdfFactory
from loomlight.mitsuba.shapes import ground
from loomlight.models.interface import FootprintBsdf, Model
from loomlight.models.registry import model_from_loom
from loomlight.models.texture.latent import LatentModel
from loomlight.models.texture.model import run_training
from loomlight.models.texture.settings import LatentOptions
from loomlight.sources.loom_file import write_loom
from loomlight.sources.material import Material
from studies.harness.study import listed, names
from studies.instruments.composed_scenes import Composition, composed_scene
from studies.instruments.renders import one_picture
from studies.papers.setting import LitSettings, TrainedSettings
from studies.papers.zeltner2024.layered_materials import LAYERED, layered_material
from studies.papers.zeltner2024.six_layers import SIX_LAYERS, six_layer_material
from studies.papers.zeltner2024.two_normals import TWO_NORMALS, two_normal_material

VIEWS = {"whole": 1.0, "close": 3.5, "far": 0.25}
_TOWARDS_CAMERA, _TOWARDS_LIGHT = (0.0, 0.25, 1.0), np.array([-0.6, 0.75, 0.6])
# Camera to sphere, to ground or sphere, to light.
DEPTH = 3
# Where the close view looks: the middle of the sphere's front, a little above.
_FOCUS = (-0.02, 0.04, 0.09)
MATERIALS = (*LAYERED, *TWO_NORMALS, SIX_LAYERS)
METRICS = (
    "Mean FLIP",
    "Mean abs. error",
    "Mean sqr. error",
    "Mean rel. abs. error",
    "Mean rel. sqr. error",
    "SMAPE",
)
# Added to denominators of relative errors; the brightest white of these pictures is about 1.
_FLOOR = 0.01

# The paper's recipe at a tenth of its steps, a 32nd of its batches, and textures of a quarter of the side.
SHORT_RECIPE: dict[str, Any] = {
    "quality": "published",
    "steps": 30_000,
    "batch": 1 << 12,
    "queries": 1 << 22,
    "size": (256, 144),
    "spp": 64,
}


@dataclass(frozen=True, eq=False)
class ShownError:
    """Errors of a picture: the six metrics of the supplemental, in the order of `METRICS`, and FLIP's map."""

    metrics: tuple[float, ...]
    picture: PictureError


@dataclass(frozen=True)
class StageSettings(TrainedSettings, LitSettings):
    """Of figures of materials on the stage."""

    resolution: int = same_setting(
        TrainedSettings,
        "resolution",
        default=128,
        otherwise="",
        help="Texels a side of textures and latents.",
    )
    materials: str = names(",".join(LAYERED), "What is shown.", MATERIALS)
    queries: int | None = same_setting(LatentOptions, "queries", help="Of the material, of each training.")
    batch: int | None = same_setting(LatentOptions, "batch", help="Queries of a step of each training.")
    device: str = same_setting(LatentOptions, "device")

    def sources(self) -> list[Material]:
        """The materials that are shown."""
        return [stage_material(name, self.resolution) for name in listed(self.materials)]


def six_errors(
    picture: NDArray[np.float32], reference: NDArray[np.float32], counted: NDArray[np.bool_]
) -> ShownError:
    """The errors of linear pictures [height, width, 3] over a mask; relative to the reference plus 0.01."""
    flip = picture_error(picture, reference, counted)
    p, t = (part[counted].astype(np.float64) for part in (picture, reference))
    difference = p - t
    size = np.abs(difference)
    metrics = (
        flip.flip,
        float(size.mean()),
        float((difference**2).mean()),
        float((size / (t + _FLOOR)).mean()),
        float((difference**2 / (t**2 + _FLOOR)).mean()),
        float((2 * size / (np.abs(p) + t + _FLOOR)).mean()),
    )
    return ShownError(metrics, flip)


def metric_table(title: str, errors: dict[str, ShownError], note: str = "") -> Table:
    """A table as the supplemental prints them: a row for each metric, a column for each model."""
    table = Table(title, list(errors), note=note)
    for number, metric in enumerate(METRICS):
        table.rows[metric] = [error.metrics[number] for error in errors.values()]
    return table


def stage_material(name: str, side: int) -> Material:
    """One of `MATERIALS`.

    Args:
        side: texels of its textures.
    """
    if name == SIX_LAYERS:
        return six_layer_material(side)
    make = two_normal_material if name in TWO_NORMALS else layered_material
    return make(name, side)


def trained(
    source: Material,
    settings: StageSettings,
    runs: Path,
    decoder: str = "2x32",
    rung: str = "frames",
    **others: Any,
) -> Model:
    """The model of a material; a training is kept in the folder of runs, and read if it is there.

    One that was stopped goes on. Queries stay in a folder that all trainings share.

    Args:
        others: further ones of `LatentOptions`.

    Raises:
        InputError: a folder that cannot be written to.
        MissingDependencyError: PyTorch is missing, where there is a training to do.
    """
    options: dict[str, Any] = {
        "quality": settings.quality,
        "resolution": settings.resolution,
        "decoder": decoder,
        "rung": rung,
        **others,
    }
    given = {name: getattr(settings, name) for name in ("steps", "queries", "batch", "device")}
    options = {name: value for name, value in given.items() if value is not None} | options
    recipe, folder = LatentOptions(**options).settings(), runs / "zeltner2024"
    name = f"{source.name}-{decoder}-{rung}-{recipe.identity(source)[:12]}"
    file = folder / f"{name}.loom"
    if file.exists():
        return model_from_loom(file)
    chosen = LatentOptions(**options, folder=folder / name)
    weights = run_training("latent", source, recipe, chosen, None, shared=folder / "queries")
    model = LatentModel(source, weights)
    write_loom(file, model.to_loom())
    # Nobody goes on from these checkpoints any more.
    shutil.rmtree(folder / name)
    return model


def reference_factory(source: Material) -> BsdfFactory:
    """The material's own BSDF."""
    return lambda _size: material_bsdf_of(source)


def model_factory(model: Model) -> BsdfFactory:
    """The BSDF of a model, whose repeat is a unit of uv as it is the material's."""
    return lambda _size: make_bsdf(model, model.source.default_uv_size_mm)


def at_texel(
    model: Model, place_mm: NDArray[np.float32], texel_mm: float, views: NDArray[np.float32]
) -> FootprintBsdf:
    """The model over the footprint of a texel [2], seen from some views [n, 3]."""
    centre = np.tile(np.asarray(place_mm, np.float32)[:, None], len(views))
    footprint = Footprint(Array2f(centre), Array2f(texel_mm, 0), Array2f(0, texel_mm))
    return model.at(Array3f(np.ascontiguousarray(views.T)), footprint)


def stage_scene(
    factory: BsdfFactory, view: str, settings: StageSettings, depth: int = DEPTH
) -> MeasuredScene:
    """The sphere in one of `VIEWS`.

    Args:
        depth: longest path in segments.
    """
    choose_variant()
    sphere = shapes.sphere()
    centre = np.zeros(3)
    radius = shapes.SPHERE_RADIUS
    light: dict[str, Any] = (
        light_dicts("studio", centre, radius, _TOWARDS_LIGHT)
        if settings.environment is None
        else {"environment": environment_dict(settings.environment)}
    )
    props = {**light, "ground": ground(centre, radius, -radius)}
    zoom = VIEWS[view]
    focus = _FOCUS if zoom > 1 else None
    shown = Composition([sphere], _TOWARDS_CAMERA, props, depth, zoom, focus)
    return composed_scene(shown, [factory], settings.size)


def stage_picture(scene: MeasuredScene, settings: StageSettings, seed: int = 1) -> NDArray[np.float32]:
    """Linear RGB [height, width, 3] with the samples of the settings."""
    return one_picture(scene, settings.spp, seed)
