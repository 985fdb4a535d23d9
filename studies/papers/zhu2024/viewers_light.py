"""Light from behind the viewer: what a surface of texels that none hides another is too dark by.

A ray from the side meets yarn that is lit wherever light comes from the same direction, as nothing stands in
its way back. The texels of `clustered` are seen from everywhere, those in the shadow of a yarn too. Values
are means over places of a repeat and over views with o.z = 0.6 to 1, of light from behind the viewer, from
the side and from across, as high as the view; ratios of `clustered` to `point`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from drjit.llvm.ad import Array2f, Array3f
from numpy.typing import NDArray

from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.fabric import load_fabric
from loomlight.models.clustered.model import ClusteredModel, ClusteredOptions
from loomlight.models.clustered.parallax import side_views
from loomlight.models.interface import Model
from loomlight.models.point import PointModel
from studies.harness.study import EXAMPLES, Figures, Found, Run, Study, listed, names

FABRICS = ("undulating-twill.wif", "denim.toml", "linen.toml", "silk-satin.toml")
_LIGHTS: dict[str, Callable[[NDArray[np.float32]], NDArray[np.float32]]] = {
    "behind the viewer": lambda view: view,
    "from the side": lambda view: np.stack([-view[1], view[0], view[2]]),
    "from across": lambda view: np.stack([-view[0], -view[1], view[2]]),
}
# Every so many views, and the side of a footprint, millimetres: far less than a yarn.
_VIEWS, _SIDE = 4, 1e-3


@dataclass(frozen=True)
class ViewersLight(Settings):
    """Which fabrics, at how many places."""

    fabrics: str = names(",".join(FABRICS), "Files of examples/.")
    places: int = setting(1024, "Of the repeat, for each view.", low=1, high=1 << 20)
    texels: int = setting(64, "Of maps, along the repeat.", low=16, high=1024)


def measure(settings: ViewersLight, run: Run) -> Found:
    """The ratios of each fabric."""
    require_llvm()
    return Found(
        {"fabrics": run.each({name: partial(_ratios, name, settings) for name in listed(settings.fabrics)})}
    )


def tables(figures: Figures) -> list[Table]:
    """How much brighter than by rays, a row a fabric."""
    table = Table("clustered over point, by where light comes from", list(_LIGHTS))
    for name, found in figures["fabrics"].items():
        table.rows[name.split(".")[0]] = [f"{100 * found[column]:+.1f} %" for column in table.columns]
    return [table]


def _ratios(name: str, settings: ViewersLight) -> Figures:
    fabric = load_fabric(EXAMPLES / name)
    views = np.repeat(side_views()[::_VIEWS], settings.places, axis=0).T.astype(np.float32)
    size = np.array(fabric.repeat_mm, np.float32)[:, None]
    places = np.random.default_rng(0).random((2, views.shape[1]), np.float32) * size
    options = ClusteredOptions(texels=settings.texels)
    models = (PointModel(fabric), ClusteredModel.for_source(fabric, options))
    found = {}
    for label, light_of in _LIGHTS.items():
        exact, texels = (_mean(model, views, places, light_of(views)) for model in models)
        found[label] = round(texels / exact - 1, 4)
    return found


def _mean(
    model: Model, views: NDArray[np.float32], places: NDArray[np.float32], lights: NDArray[np.float32]
) -> float:
    """Mean of f·cos over views [3, n], places [2, n] and channels."""
    footprint = Footprint(Array2f(places), Array2f(_SIDE, 0), Array2f(0, _SIDE))
    at = model.at(Array3f(np.ascontiguousarray(views)), footprint)
    return float(np.mean(at.value(Array3f(np.ascontiguousarray(lights))).numpy()))


STUDY = Study(
    "papers/zhu2024/viewers_light",
    "light from behind the viewer, on texels that none hides another",
    ViewersLight(),
    measure,
    tables,
    stands_on=("point", "clustered"),
    small={"fabrics": "denim.toml", "places": 16, "texels": 16},
)
