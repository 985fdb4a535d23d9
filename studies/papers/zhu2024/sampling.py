"""zhu2024, figure 5: importance sampling of the cloth under an environment map, at 32 samples a pixel.

The paper shows its sampling beside none. Here directions are uniform over the sphere in the left column and
drawn by the model in the middle. Above, light sampling and multiple importance sampling are the same in
both; below, the BSDF's directions are all that finds the light. Direct light.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import mitsuba as mi

from loomlight.evaluation.metrics import picture_error
from loomlight.evaluation.table import Table
from loomlight.mitsuba import choose_variant
from loomlight.mitsuba.camera import FIELD_OF_VIEW
from loomlight.mitsuba.measured_scenes import MeasuredScene
from loomlight.mitsuba.plugins import make_bsdf
from loomlight.models.interface import Model
from loomlight.models.registry import make_model
from studies.harness.study import Found, Run, Study, on_display, with_tables
from studies.instruments.altered_models import uniformly_sampled
from studies.instruments.composed_scenes import composed_scene, directions_alone
from studies.instruments.renders import one_picture
from studies.instruments.sheet import PictureTable, Tile, error_caption
from studies.papers.zhu2024.scenes import SCENES, SceneSettings, table_composition, table_fabric, table_scene

SAMPLES = 32
_COLUMNS = ("uniform directions", "importance sampling", "reference")
_ROWS = ("directions and light samples (MIS)", "directions alone")
# Direct light: camera to cloth to light.
_DEPTH = 2
_SCENE = replace(SCENES["blouse"], max_depth=_DEPTH)


def importance_sampling(settings: SceneSettings, run: Run) -> Found:
    """Figure 5."""
    choose_variant()
    truth_scene = table_scene(_SCENE, settings, "point")
    truth = one_picture(truth_scene, settings.spp, 1)
    shown = on_display(truth)
    ways = [_scene(settings, uniformly_sampled), _scene(settings, lambda model: model)]
    table = Table("MSE", list(_COLUMNS[:2]))
    title = "zhu2024 figure 5: importance sampling under an environment"
    pictures = PictureTable(title, _COLUMNS)
    for number, row in enumerate(_ROWS):
        tiles, errors = [], []
        for scene in ways:
            integrator = scene.integrator if number == 0 else directions_alone()
            picture = one_picture(replace(scene, integrator=integrator), SAMPLES, 2)
            error = picture_error(picture, truth, scene.counted)
            errors.append(error.mse)
            tiles.append(Tile(on_display(picture), error_caption(error)))
        table.rows[row] = [*errors]
        pictures.add(row, [*tiles, Tile(shown, f"{settings.spp} spp")])
        run.report(number + 1, len(_ROWS))
    light = "the studio" if settings.environment is None else Path(settings.environment).name
    note = (
        f"{settings.model}, {SAMPLES} samples a pixel, direct light of an environment ({light}); reference: "
        f"the point model with {settings.spp} samples."
    )
    return pictures.found(with_tables(table), note)


def _scene(settings: SceneSettings, altered: Callable[[Model], Model]) -> MeasuredScene:
    composition = table_composition(_SCENE, settings.environment)
    shorter = min(settings.size)
    angle = math.radians(FIELD_OF_VIEW) / shorter

    def factory(fabric: str) -> Callable[[tuple[float, float]], mi.BSDF]:
        def made(millimetres: tuple[float, float]) -> mi.BSDF:
            bsdf = make_bsdf(altered(make_model(settings.model, table_fabric(fabric))), millimetres)
            # Mitsuba's integrators set no footprints.
            bsdf.pixel_angle = angle
            return bsdf

        return made

    return composed_scene(composition, [factory(fabric) for _, fabric in _SCENE.pieces], settings.size)


STUDY = Study(
    "papers/zhu2024/fig5",
    "importance sampling under an environment map, 32 samples",
    SceneSettings(spp=1024),
    importance_sampling,
    stands_on=("point", "clustered", "picture"),
    small={"size": (24, 16), "spp": 8, "model": "lobes"},
)
