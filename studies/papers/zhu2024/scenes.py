"""The five scenes of zhu2024's Table 1, of pieces and fabrics of our own at their true scale.

The paper's meshes and feature maps are not public. What its table names is here: a couch with twill, plain
weave, diamond and argyle; a blouse of twill and satin under an environment map; an evening gown of satin
under a sheer plain weave; a cylinder of twill; and satin draped over a ball. Cylinder and drape are lit by
a point light, as the paper says of its validation; couch and gown by one lamp too. Light that is scattered
once by other cloth is part of blouse and gown, the others show direct light. Blouse and gown stand here
twice: under a point light alone, direct, more of their noise is the cloth's own.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.settings import same_setting, setting
from loomlight.fabric import fabric_from_text
from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba import ClothMesh, material_bsdf, shapes
from loomlight.mitsuba.lights import environment_dict, light_dicts
from loomlight.mitsuba.measured_scenes import MeasuredScene
from loomlight.mitsuba.shapes import ball, ground
from loomlight.models.interface import Model
from loomlight.models.registry import MODELS
from studies.harness.study import names
from studies.instruments.composed_scenes import Composition, composed_scene
from studies.papers.setting import LitSettings, PictureSettings
from studies.papers.zhu2024 import cloth_pieces

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class PaperRow:
    """A row of the paper's Table 1: with and without clustered control variates.

    Attributes:
        mse: at which both are compared.
        samples: a pixel, with and without.
        seconds: with and without.
        storage: GB uncompressed, MB compressed.
    """

    mse: float
    samples: tuple[int, int]
    seconds: tuple[float, float]
    storage: tuple[float, float]


@dataclass(frozen=True)
class TableScene:
    """A scene of the table.

    Attributes:
        name: as the paper calls it.
        pieces: makes each piece, with the name of its fabric in `FABRICS`.
        towards_camera, towards_light: directions of any length.
        light: of `light_dicts`; "environment" is the settings' picture, or the studio without one.
        max_depth: longest path in segments.
        paper: the paper's row.
        grounded: stands on a grey ground.
        on_ball: is draped over the ball of `shapes.drape`.
        zoom, focus: see `Composition`.
        exposure: stops by which the lamp is brighter than that of the built-in scenes.
    """

    name: str
    pieces: tuple[tuple[Callable[[], ClothMesh], str], ...]
    towards_camera: Vector
    towards_light: Vector
    light: str
    max_depth: int
    paper: PaperRow
    grounded: bool = False
    on_ball: bool = False
    zoom: float = 1.0
    focus: Vector | None = None
    exposure: float = 0.0


def _green_pillow() -> ClothMesh:
    return cloth_pieces.pillow((-0.42, 0.6, -0.06), turn_degrees=22.0)


def _purple_pillow() -> ClothMesh:
    return cloth_pieces.pillow((-0.13, 0.57, 0.02), side=0.36, turn_degrees=-14.0, lean_degrees=24.0)


SCENES: dict[str, TableScene] = {
    "couch": TableScene(
        "Couch",
        (
            (cloth_pieces.couch, "plain"),
            (cloth_pieces.blanket, "twill"),
            (_green_pillow, "diamond"),
            (_purple_pillow, "argyle"),
        ),
        (-0.35, 0.45, 1.0),
        (-0.5, 0.9, 0.8),
        "point",
        2,
        PaperRow(0.02, (10, 619), (25.0, 1140.0), (53.0, 460.0)),
        grounded=True,
        exposure=1.5,
    ),
    "blouse": TableScene(
        "Blouse",
        ((cloth_pieces.blouse_body, "blouse satin"), (cloth_pieces.blouse_sleeves, "blouse twill")),
        (0.25, 0.12, 1.0),
        (-0.6, 0.75, 0.6),
        "environment",
        3,
        PaperRow(0.05, (17, 1109), (16.0, 552.0), (26.0, 230.0)),
    ),
    "gown": TableScene(
        "Evening gown",
        ((cloth_pieces.gown, "gown satin"), (cloth_pieces.overskirt, "sheer")),
        (0.2, 0.15, 1.0),
        (-0.7, 0.7, 0.75),
        "point",
        3,
        PaperRow(0.02, (32, 1760), (15.0, 540.0), (26.0, 230.0)),
        grounded=True,
        zoom=1.45,
        focus=(0.0, 0.72, 0.1),
        exposure=2.5,
    ),
    "cylinder": TableScene(
        "Cloth cylinder",
        ((shapes.cylinder, "cylinder twill"),),
        (0.0, 0.0, 1.0),
        (-0.1, 0.45, 1.0),
        "point",
        2,
        PaperRow(0.04, (2, 65), (5.0, 120.0), (13.0, 115.0)),
        exposure=1.0,
    ),
    "drape": TableScene(
        "Draping fabric",
        ((shapes.drape, "drape satin"),),
        (0.35, 0.55, 1.0),
        (-0.6, 0.75, 0.6),
        "point",
        2,
        PaperRow(0.03, (2, 179), (4.0, 180.0), (13.0, 115.0)),
        grounded=True,
        on_ball=True,
        exposure=1.0,
    ),
}
SCENES |= {
    f"{name} in point light": replace(
        SCENES[name], name=f"{SCENES[name].name}, point light", light="point", max_depth=2
    )
    for name in ("blouse", "gown")
}


@dataclass(frozen=True)
class ClothSettings(PictureSettings):
    """Of figures that show one model beside the point model."""

    model: str = setting("clustered", "The model of the figure.", choices=tuple(MODELS))


@dataclass(frozen=True)
class SceneSettings(ClothSettings, LitSettings):
    """Of the table's scenes; an environment lights the blouse."""


@dataclass(frozen=True)
class TableSettings(SceneSettings):
    """Of the table."""

    size: tuple[int, int] = same_setting(PictureSettings, "size", default=(192, 108))
    spp: int = same_setting(PictureSettings, "spp", default=32)
    visibility: str = names(
        "saturating", "Gaussians of texels, of `clustered`.", ("saturating", "unsaturated")
    )
    scenes: str = names(",".join(SCENES), "Rows of the table.", tuple(SCENES))


def _cloth(weave: str, sett: tuple[int, int], gap: float, warp: str, weft: str, rest: str = "") -> str:
    return (
        f'weave = "{weave}"\ninterreflection = false\n'
        f"ends_per_cm = {sett[0]}\npicks_per_cm = {sett[1]}\ngap = {gap}\n{rest}"
        f"[warp]\n{warp}\n[weft]\n{weft}\n"
    )


def _yarn(color: str, specular: float, roughness: float, translucency: float = 0.05) -> str:
    return f'color = "{color}"\nspecular = {specular}\nroughness = {roughness}\ntranslucency = {translucency}'


_TEXTS = {
    "plain": _cloth("plain", (10, 10), 0.06, _yarn("#b9a98c", 0.3, 0.35), _yarn("#d3c5a9", 0.3, 0.35)),
    "twill": _cloth("twill 3/1", (14, 12), 0.04, _yarn("#8d2f2a", 0.4, 0.25), _yarn("#d8b08a", 0.4, 0.25)),
    "diamond": _cloth(
        "diamond 2/2 8", (24, 24), 0.03, _yarn("#2f7a4c", 0.9, 0.15), _yarn("#b8c98a", 0.7, 0.18)
    ),
    "argyle": _cloth("argyle 32", (32, 32), 0.03, _yarn("#5b2f86", 0.9, 0.15), _yarn("#c2a1d8", 0.7, 0.18)),
    "blouse satin": _cloth(
        "satin 8/3", (90, 45), 0.03, _yarn("#e6dcc8", 1.0, 0.12, 0.08), _yarn("#dcd0b8", 0.7, 0.2, 0.08)
    ),
    "blouse twill": _cloth(
        "twill 2/2", (36, 32), 0.04, _yarn("#27395f", 0.5, 0.25), _yarn("#4a62a0", 0.5, 0.25)
    ),
    "gown satin": _cloth(
        "satin 8/3", (100, 48), 0.03, _yarn("#d98aa4", 1.0, 0.12, 0.05), _yarn("#c97b96", 0.7, 0.2, 0.05)
    ),
    "sheer": _cloth(
        "plain", (40, 38), 0.62, _yarn("#6a3a8c", 0.7, 0.16, 0.4), _yarn("#6a3a8c", 0.7, 0.16, 0.4)
    ),
    "cylinder twill": _cloth(
        "twill 2/1", (16, 14), 0.04, _yarn("#6f7a86", 0.5, 0.25), _yarn("#b9c0c8", 0.5, 0.25)
    ),
    "drape satin": _cloth(
        "satin 8/3", (60, 36), 0.03, _yarn("#176350", 1.0, 0.1, 0.05), _yarn("#145646", 0.7, 0.18, 0.05)
    ),
}
FABRICS = tuple(_TEXTS)


@lru_cache(maxsize=len(_TEXTS))
def table_fabric(name: str) -> Fabric:
    """A fabric of the scenes, by one of the names `FABRICS`."""
    return fabric_from_text(f'name = "{name}"\n{_TEXTS[name]}')


def table_composition(scene: TableScene, environment: os.PathLike[str] | None = None) -> Composition:
    """The pieces and lights of a scene; a Mitsuba variant must be set.

    Raises:
        InputError: an environment that cannot be read.
    """
    pieces = [make() for make, _ in scene.pieces]
    points = np.concatenate([piece.positions for piece in pieces])
    low, high = points.min(axis=0), points.max(axis=0)
    centre, radius = (low + high) / 2, float(np.linalg.norm(high - low)) / 2
    props: dict[str, Any] = {}
    if scene.light != "environment":
        props |= _lamp(scene, centre, radius)
    elif environment is not None:
        props["environment"] = environment_dict(environment)
    else:
        props |= light_dicts("studio", centre, radius, np.array(scene.towards_light))
    if scene.grounded:
        props["ground"] = ground(centre, radius, float(low[1]))
    if scene.on_ball:
        props["ball"] = ball()
    return Composition(pieces, scene.towards_camera, props, scene.max_depth, scene.zoom, scene.focus)


def _lamp(scene: TableScene, centre: NDArray[np.float64], radius: float) -> dict[str, Any]:
    lights = light_dicts(scene.light, centre, radius, np.array(scene.towards_light))
    lights[scene.light]["intensity"]["value"] *= 2.0**scene.exposure
    return lights


def table_scene(
    scene: TableScene,
    settings: SceneSettings,
    model: str | Callable[[str], Model],
    pixel_centres: bool = False,
) -> MeasuredScene:
    """The scene with every fabric by one model.

    Args:
        model: its name, or what makes it of a fabric's name.

    Raises:
        InputError: an unknown model, or one that does not take a fabric.
    """
    bsdfs = [
        material_bsdf(table_fabric(fabric), model) if isinstance(model, str) else material_bsdf(model(fabric))
        for _, fabric in scene.pieces
    ]
    return composed_scene(table_composition(scene, settings.environment), bsdfs, settings.size, pixel_centres)
