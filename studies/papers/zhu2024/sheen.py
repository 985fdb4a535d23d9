"""zhu2024, figure 7: sheen on black cloth.

The paper sets its renderings beside a photograph of black cloth; here they stand beside the point model
with many samples. Without sheen black cloth is black but for the fibres' highlight; fly-away fibres
brighten its outlines.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from loomlight.core.settings import setting
from loomlight.evaluation.metrics import picture_error
from loomlight.evaluation.table import Table
from loomlight.fabric import fabric_from_text
from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba import choose_variant, material_bsdf, shapes
from loomlight.mitsuba.measured_scenes import MeasuredShot, shot_scene
from studies.harness.study import Found, Pixels, Run, Study, listed_numbers, on_display, with_tables
from studies.instruments.renders import one_picture
from studies.instruments.sheet import PictureTable, Tile, error_caption
from studies.papers.zhu2024.scenes import ClothSettings

_MODEL_SAMPLES = 2
# The light stands above: what faces the camera is lit at grazing angles.
_SHOT = MeasuredShot((shapes.drape,), (0.35, 0.35, 1.0), (-0.6, 0.9, 0.12), yarns=2.5, zoom=1.25)
# Stops by which the pictures are brighter: black cloth returns a hundredth of the light.
_EXPOSURE = 3.0


@lru_cache(maxsize=4)
def black_fabric(sheen: float) -> Fabric:
    """A black woollen twill."""
    yarn = 'color = "#111113"\nspecular = 0.25\nroughness = 0.5\n'
    return fabric_from_text(
        f'name = "black wool"\nweave = "twill 2/2"\ninterreflection = false\n'
        f"ends_per_cm = 18\npicks_per_cm = 16\ngap = 0.04\n"
        f"[warp]\n{yarn}[weft]\n{yarn}[sheen]\nstrength = {sheen}\nroughness = 0.45\n"
    )


@dataclass(frozen=True)
class SheenSettings(ClothSettings):
    """Of the figure."""

    strengths: str = setting("0,0.3,1", "Of the sheen, one a column.", metavar="S,…")


def sheen(settings: SheenSettings, run: Run) -> Found:
    """Figure 7: the model above, the point model below, with more and more sheen."""
    choose_variant()
    strengths = listed_numbers("--strengths", settings.strengths)
    columns = [f"sheen {strength:g}" if strength else "without sheen" for strength in strengths]
    table = Table("MSE", columns)
    above, below, errors, light = [], [], [], []
    for number, strength in enumerate(strengths):
        fabric = black_fabric(strength)
        scenes = [
            shot_scene(_SHOT, [(fabric, material_bsdf(fabric, name))], settings.size)
            for name in (settings.model, "point")
        ]
        model, truth = one_picture(scenes[0], _MODEL_SAMPLES, 2), one_picture(scenes[1], settings.spp, 1)
        error = picture_error(model, truth, scenes[1].counted)
        errors.append(error.mse)
        light.append(float(truth[scenes[1].counted].mean()))
        above.append(Tile(_bright(model), f"{_MODEL_SAMPLES} spp, {error_caption(error)}"))
        below.append(Tile(_bright(truth), f"{settings.spp} spp"))
        run.report(number + 1, len(columns))
    table.rows[settings.model] = [*errors]
    table.rows["mean of the reference"] = [*light]
    note = (
        f"Black wool, {_SHOT.yarns:g} yarns a pixel, one directional light from above, direct light; shown "
        f"{_EXPOSURE:g} stops brighter."
    )
    shown = PictureTable("zhu2024 figure 7: sheen on black cloth", columns)
    shown.add(settings.model, above)
    shown.add("point, the reference", below)
    return shown.found(with_tables(table), note)


def _bright(linear: NDArray[np.float32]) -> Pixels:
    return on_display((linear * np.float32(2.0**_EXPOSURE)).astype(np.float32))


STUDY = Study(
    "papers/zhu2024/fig7",
    "sheen on black cloth",
    SheenSettings(),
    sheen,
    stands_on=("point", "clustered", "picture"),
    small={"size": (16, 12), "spp": 4, "model": "lobes", "strengths": "1"},
)
