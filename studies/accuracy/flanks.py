"""Yarns with flanks against the height field alone: pictures, means and cost.

The same rays over four fabrics, shaded where they meet the yarns' tubes (`yarn/flanks.py`) and where they end
on the height field: reflectance under a dome, seen from 8°, 52° and 75°, and the CPU time of a value of the
point model. The sheet shows both seen from above and from 40° above the cloth at 10, 30, 100 and 300 pixels a
thread, a row each.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import partial

import drjit as dr
import numpy as np
from drjit.llvm import Array3f, Float
from numpy.typing import NDArray

from loomlight.core.arrays import Float as AnyFloat
from loomlight.core.arrays import Mask, Vec3
from loomlight.core.images import encoded
from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Cell, Table
from loomlight.fabric import fabric_from_text
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.flanks import SurfacePoint
from loomlight.yarn.geometry import YarnGeometry
from studies.harness.study import Figures, Found, Pixels, Run, Study, listed, listed_numbers, names
from studies.instruments.directions import as_vectors, by_cosine, copies
from studies.instruments.sheet import Row, Tile, contact_sheet
from studies.instruments.timing import least_times

FABRICS = {
    "woollen twill": ("twill 2/2", "wool", "#70757d", "#a06a41"),
    "cotton denim": ("twill 3/1", "cotton", "#2c3f64", "#ddd6c6"),
    "linen plain": ("plain", "linen", "#c9ba98", "#bfae8a"),
    "silk satin": ("satin 5/2", "silk", "#a03045", "#a03045"),
}
VIEWS = {"8°": 8, "52°": 52, "75°": 75}
SUN = (-0.75, 0.35, 0.6)
# Views of the sheet: degrees above the cloth, and around it.
SHEET_VIEWS = ((89, -90), (40, -60))
SAMPLES = 6


class HeightFieldAlone(YarnGeometry):
    """The geometry without flanks: points are those of the height field where rays end."""

    def surface(
        self, x: AnyFloat, y: AnyFloat, back: Mask, ray: tuple[Vec3, AnyFloat] | None = None
    ) -> SurfacePoint:
        return super().surface(x, y, back)


def models(name: str) -> list[YarnScattering]:
    """Point models of a fabric, without flanks and with them."""
    weave, yarn, warp, weft = FABRICS[name]
    fabric = fabric_from_text(
        f'weave = "{weave}"\nyarn = "{yarn}"\n[warp]\ncolor = "{warp}"\n[weft]\ncolor = "{weft}"\n'
    )
    kinds: tuple[type[YarnGeometry], ...] = (HeightFieldAlone, YarnGeometry)
    return [YarnScattering(kind(fabric.layout()), fabric.appearance()) for kind in kinds]


def value(model: YarnScattering, x: Float, y: Float, light: Array3f, view: Array3f) -> NDArray[np.float64]:
    """f·cos over the cosine of the light, mean of the channels [n]."""
    found = model.evaluate(model.locate(x, y, view), light, view)
    return np.asarray((dr.sum(found) * dr.rcp(3 * light.z)).numpy(), np.float64)


def compare(name: str, count: int) -> dict[str, float]:
    """Relative changes of means by view, with their deviations, and the ratio of costs."""
    rng = np.random.default_rng(1)
    both, figures = models(name), {}
    x, y = (Float((100 * rng.random(count)).astype(np.float32)) for _ in range(2))
    light = as_vectors(by_cosine(rng, count))
    for view_name, degrees in VIEWS.items():
        tilt = math.radians(degrees)
        view = copies((0.8 * math.sin(tilt), 0.6 * math.sin(tilt), math.cos(tilt)), count)
        field, flanks = (value(model, x, y, light, view) for model in both)
        change = (flanks - field) / field.mean()
        figures[view_name] = float(change.mean())
        figures[f"{view_name}, deviation"] = float(change.std() / math.sqrt(count))
    runs = [partial(value, model, x, y, light, view) for model in both]
    least_times(runs, 1)  # compiles
    field_time, flanks_time = least_times(runs, 3)
    return {**figures, "cost": flanks_time.cpu_seconds / field_time.cpu_seconds}


def picture(model: YarnScattering, side: int, pixels: float, elevation: float, azimuth: float) -> Pixels:
    """The cloth by parallel rays, in the sun and a dimmer sky [side, side, 3]."""
    rng = np.random.default_rng(3)
    spacing, count = min(model.surface.finest), side * side
    rise, turn = math.radians(elevation), math.radians(azimuth)
    view = copies((math.cos(rise) * math.cos(turn), math.cos(rise) * math.sin(turn), math.sin(rise)), count)
    row, column = np.mgrid[:side, :side].reshape(2, -1)
    total = np.zeros((3, count))
    for _ in range(SAMPLES):
        right = (column + rng.random(count) - side / 2) / pixels * spacing
        towards = (row + rng.random(count) - side / 2) / pixels * spacing / math.sin(rise)
        x = 1.3 * spacing - math.sin(turn) * right + math.cos(turn) * towards
        y = 2.2 * spacing + math.cos(turn) * right + math.sin(turn) * towards
        size = dr.full(Float, spacing / pixels, count)
        point = model.locate(Float(x.astype(np.float32)), Float(y.astype(np.float32)), view, size=size)
        sky = as_vectors(by_cosine(rng, count))
        lit = 2.6 * model.evaluate(point, copies(SUN, count), view)
        lit += model.evaluate(point, sky, view) * (0.45 * math.pi * dr.rcp(sky.z))
        total += lit.numpy()
    return encoded((total / SAMPLES).T.reshape(side, side, 3).astype(np.float32))


def sheet(fabrics: list[str], side: int, pixels: list[float]) -> Pixels:
    """Rows of fabrics, without flanks and with them."""
    rows = [
        Row(
            f"{name}, {kind}",
            [
                Tile(picture(model, side, each, *view), f"{each:g} pixels a thread, {view[0]}°")
                for view in SHEET_VIEWS
                for each in pixels
            ],
        )
        for name in fabrics
        for kind, model in zip(("the height field", "with flanks"), models(name), strict=True)
    ]
    return contact_sheet("Flanks of yarns", [], rows)


@dataclass(frozen=True)
class Flanks(Settings):
    points: int = setting(60_000, "Points of each cloth.", low=2)
    fabrics: str = names(",".join(FABRICS), "Fabrics.", tuple(FABRICS))
    side: int = setting(110, "Pixels of a tile of the sheet.", low=8)
    pixels: str = setting("10,30,100,300", "Pixels a thread of its tiles.", metavar="N,…")


def measure(settings: Flanks, run: Run) -> Found:
    """Means and cost of all fabrics, and the sheet."""
    require_llvm()
    fabrics = listed(settings.fabrics)
    figures = run.each({name: partial(compare, name, settings.points) for name in fabrics})
    return Found(figures, sheet(fabrics, settings.side, listed_numbers("pixels", settings.pixels)))


def tables(figures: Figures) -> list[Table]:
    """Changes of means by view, and cost."""
    rows: dict[str, list[Cell]] = {}
    for name, found in figures.items():
        means: list[Cell] = [
            f"{100 * found[view]:+.2f} ± {100 * found[f'{view}, deviation']:.2f} %" for view in VIEWS
        ]
        rows[name] = [*means, found["cost"]]
    return [Table("With flanks against the height field alone", [*VIEWS, "cost"], rows)]


STUDY = Study(
    "accuracy/flanks",
    "yarns with flanks against the height field alone: pictures, means and cost",
    Flanks(),
    measure,
    tables,
    stands_on=("point",),
    small={"points": 1000, "fabrics": "silk satin", "side": 16, "pixels": "30"},
)
