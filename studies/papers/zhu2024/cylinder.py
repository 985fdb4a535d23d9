"""zhu2024, figures 6 and 8: parallax and sheen on a cylinder, against a ray-traced height field.

The reference is cloth of triangles: yarns stand out from the cylinder as far as they do, and Mitsuba traces
what hides what (`height_field.py`). The paper compares figure 8 with a photograph; there is none
here, and the height field under sheen takes its place. Yarns are thick, as on the paper's cylinder, so that
parallax shows.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.evaluation.metrics import PictureError, picture_error
from loomlight.evaluation.table import Table
from loomlight.fabric import fabric_from_text
from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba import ClothMesh, choose_variant, material_bsdf, shapes
from loomlight.mitsuba.lights import light_dicts
from loomlight.mitsuba.measured_scenes import MeasuredScene
from loomlight.mitsuba.plugins import make_bsdf
from loomlight.mitsuba.scenes import BsdfFactory
from loomlight.models.point import PointModel
from studies.harness.study import Found, Pixels, Run, Study, on_display, with_tables
from studies.instruments.altered_models import without_parallax
from studies.instruments.composed_scenes import Composition, composed_scene, scene_of_shapes
from studies.instruments.renders import one_picture
from studies.instruments.sheet import PictureTable, Tile, error_caption
from studies.papers.zhu2024.height_field import height_field_shape
from studies.papers.zhu2024.scenes import ClothSettings

RADIUS, LENGTH = 0.03, 0.05
# Of the cylinder, what the camera sees of it and a little more, degrees on either side.
_HALF_ARC = 105.0
_THREADS_PER_CM = 5.0
_VERTICES_A_THREAD = 20
_MODEL_SAMPLES = 2
_FIG6, _FIG8 = "zhu2024 figure 6: parallax", "zhu2024 figure 8: a cylinder of cloth"


@dataclass(frozen=True)
class _View:
    """A row of the figures.

    Attributes:
        label: of the row.
        zoom: of the camera, towards the upper outline; below 1 it stands further away.
        part: share of the picture's sides that is shown, enlarged.
    """

    label: str
    zoom: float
    part: float = 1.0


_VIEWS = (_View("near, at the upper outline", 3.2), _View("far, enlarged", 0.16, 1 / 7))
_FOCUS = (0.0, 0.92 * RADIUS, 0.39 * RADIUS)
_TOWARDS_LIGHT = (-0.25, 0.75, 0.65)


def arc(columns: int = 129, rows: int = 513) -> ClothMesh:
    """The part of a cylinder about the x axis that faces +z; u along it, v around, upwards in front."""
    half = np.radians(_HALF_ARC)

    def around(u: NDArray[np.float64], v: NDArray[np.float64]) -> tuple[NDArray[np.float64], ...]:
        angle = half * (2 * v - 1)
        return LENGTH * (u - 0.5), RADIUS * np.sin(angle), RADIUS * np.cos(angle)

    return shapes.grid_surface((columns, rows), around, "arc")


@lru_cache(maxsize=2)
def cylinder_fabric(sheen: float) -> Fabric:
    """A coarse twill of opaque yarns, the same both ways but for the colour."""
    yarn = "specular = 0.5\nroughness = 0.3\ntranslucency = 0\n"
    return fabric_from_text(
        f'name = "coarse twill"\nweave = "twill 2/1"\ninterreflection = false\n'
        f"ends_per_cm = {_THREADS_PER_CM}\npicks_per_cm = {_THREADS_PER_CM}\ngap = 0.03\n"
        f'[warp]\ncolor = "#4d6a8f"\n{yarn}[weft]\ncolor = "#c8c2b2"\n{yarn}[sheen]\nstrength = {sheen}\n'
    )


def parallax(settings: ClothSettings, run: Run) -> Found:
    """Figure 6: near and far, without and with parallax, beside the height field."""
    fabric = cylinder_fabric(0.0)
    columns = {
        "without parallax": _flat(fabric),
        "point": material_bsdf(fabric, "point"),
        settings.model: material_bsdf(fabric, settings.model),
    }
    return _compared(_FIG6, settings, run, fabric, columns, _VIEWS)


def cylinder(settings: ClothSettings, run: Run) -> Found:
    """Figure 8: without parallax and sheen, and with both, beside the height field under sheen."""
    fabric = cylinder_fabric(0.35)
    columns = {
        "without parallax, sheen": _flat(cylinder_fabric(0.0)),
        "point": material_bsdf(fabric, "point"),
        settings.model: material_bsdf(fabric, settings.model),
    }
    views = (_View("whole", 0.95), _View("close-up at the upper outline", 4.0))
    return _compared(_FIG8, settings, run, fabric, columns, views)


def _flat(fabric: Fabric) -> BsdfFactory:
    return lambda millimetres: make_bsdf(without_parallax(PointModel(fabric)), millimetres)


def _compared(
    title: str,
    settings: ClothSettings,
    run: Run,
    fabric: Fabric,
    columns: dict[str, BsdfFactory],
    views: Sequence[_View],
) -> Found:
    choose_variant()
    table = Table("MSE", list(columns))
    bias = Table("Mean light over the height field's", list(columns))
    shown = PictureTable(title, [*columns, "height field"])
    for number, view in enumerate(views):
        field = _height_field_scene(settings, view, fabric)
        truth = one_picture(field, settings.spp, 1)
        tiles, errors, ratios = [], [], []
        for name, bsdf in columns.items():
            scene = composed_scene(_composition(view, arc()), [bsdf], settings.size)
            samples = _MODEL_SAMPLES if name == settings.model else settings.spp
            picture = one_picture(scene, samples, 2)
            counted = scene.counted & field.counted
            error = picture_error(picture, truth, counted)
            errors.append(error.mse)
            ratios.append(float(picture[counted].mean() / truth[counted].mean()))
            tiles.append(Tile(_part(picture, view), _caption(samples, error)))
        table.rows[view.label], bias.rows[view.label] = [*errors], [*ratios]
        shown.add(view.label, [*tiles, Tile(_part(truth, view), f"{settings.spp} spp")])
        run.report(number + 1, len(views))
    note = (
        f"{fabric.name}, {_THREADS_PER_CM:g} threads/cm on a cylinder of {200 * RADIUS:g} cm, one "
        f"directional light, direct light. Height field: {_VERTICES_A_THREAD} vertices a thread, shadows and "
        "parallax ray-traced."
    )
    return shown.found(with_tables(table, bias), note)


def _caption(samples: int, error: PictureError) -> str:
    return f"{samples} spp, {error_caption(error)}"


def _composition(view: _View, piece: ClothMesh) -> Composition:
    lights = light_dicts("directional", np.zeros(3), 1.0, np.array(_TOWARDS_LIGHT))
    focus = _FOCUS if view.zoom > 1 else None
    return Composition([piece], (0.0, 0.0, 1.0), lights, 2, view.zoom, focus)


def _height_field_scene(settings: ClothSettings, view: _View, fabric: Fabric) -> MeasuredScene:
    along = round(LENGTH * 100 * _THREADS_PER_CM * _VERTICES_A_THREAD)
    around = round(2 * np.radians(_HALF_ARC) * RADIUS * 100 * _THREADS_PER_CM * _VERTICES_A_THREAD)
    shapes: list[Any] = [height_field_shape(arc(along + 1, around + 1), fabric)]
    return scene_of_shapes(_composition(view, arc()), shapes, settings.size)


def _part(picture: NDArray[np.float32], view: _View) -> Pixels:
    """The middle of a picture, enlarged to the whole one's size."""
    if view.part >= 1:
        return on_display(picture)
    factor = round(1 / view.part)
    height, width = picture.shape[0] // factor, picture.shape[1] // factor
    top, left = (picture.shape[0] - height) // 2, (picture.shape[1] - width) // 2
    middle = picture[top : top + height, left : left + width]
    return on_display(np.repeat(np.repeat(middle, factor, axis=0), factor, axis=1))


_STANDS_ON = ("point", "clustered", "picture")
_SMALL = {"size": (24, 16), "spp": 4, "model": "lobes"}
STUDIES = (
    Study(
        "papers/zhu2024/fig6",
        "parallax near and far, against a ray-traced height field",
        ClothSettings(),
        parallax,
        stands_on=_STANDS_ON,
        small=_SMALL,
    ),
    Study(
        "papers/zhu2024/fig8",
        "a cylinder of cloth: parallax and sheen, against a height field",
        ClothSettings(),
        cylinder,
        stands_on=_STANDS_ON,
        small=_SMALL,
    ),
)
