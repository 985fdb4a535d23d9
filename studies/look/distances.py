"""Eight fabrics from 2 m to 2 cm: a sheet to be looked at beside what such cloth looks like from there.

A row a fabric, a column a distance: the drape of the built-in scene in its default light, in the model of
`render`, seen by a 50 mm lens that comes closer along its own axis; at 2 m, where that shows floor, by twice
the focal length. Numbers are means of each picture, linear.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.fabric.read import load_fabric
from loomlight.mitsuba import build_scene, choose_variant, material_bsdf, render
from loomlight.models.registry import make_model
from studies.harness.study import Figures, Found, Run, Study, example, listed, names, on_display
from studies.instruments.sheet import Row, Tile, contact_sheet

FABRICS = (
    "selvedge-denim",
    "linen",
    "harris-tweed",
    "silk-dupion",
    "poplin-stripe",
    "flannel-melange",
    "silk-satin",
    "organza",
)
# From the camera to the cloth in the middle of the picture, metres, and the field of view, degrees.
DISTANCES = {"2 m": (2.0, 13.0), "50 cm": (0.5, 26.0), "10 cm": (0.1, 26.0), "2 cm": (0.02, 26.0)}


@dataclass(frozen=True)
class Distances(Settings):
    fabrics: str = names(",".join(FABRICS), "Example fabrics.")
    side: int = setting(280, "Pixels of a tile.", low=8)
    spp: int = setting(24, "Samples a pixel.", low=1)


def measure(settings: Distances, run: Run) -> Found:
    """The sheet, and the mean of each tile."""
    choose_variant(None)
    rows, means = [], {}
    for name in listed(settings.fabrics):
        pictures = pictures_of(name, settings.side, settings.spp)
        rows.append(Row(name, [Tile(on_display(picture)) for picture in pictures.values()]))
        means[name] = {distance: float(picture.mean()) for distance, picture in pictures.items()}
        run.report(len(rows), len(listed(settings.fabrics)))
    return Found({"means": means}, contact_sheet("Fabrics by distance", list(DISTANCES), rows))


def pictures_of(name: str, side: int, spp: int) -> dict[str, NDArray[np.float32]]:
    """Linear pictures of a fabric by distance."""
    bsdf = material_bsdf(make_model("lobes", load_fabric(example(name))))
    shown = build_scene("drape", bsdf, size=(side, side), edge=None)
    away = float(np.linalg.norm(shown.view.origin - shown.point))
    found = {}
    for label, (distance, field_of_view) in DISTANCES.items():
        lens: Any = mi.traverse(shown.scene.sensors()[0])
        lens["x_fov"] = field_of_view
        lens.update()
        shown.look_from(shown.view.closer(away / distance, shown.point))
        found[label] = render(shown.scene, spp=spp, integrator=shown.integrator, denoise="auto")
    return found


def tables(figures: Figures) -> list[Table]:
    """Means by fabric and distance."""
    rows = {name: list(found.values()) for name, found in figures["means"].items()}
    return [Table("Mean of each picture, linear", list(DISTANCES), rows)]


STUDY = Study(
    "look/distances",
    "eight fabrics from 2 m to 2 cm",
    Distances(),
    measure,
    tables,
    stands_on=("lobes", "picture"),
    small={"fabrics": "linen", "side": 16, "spp": 1},
)
