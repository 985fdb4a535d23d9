"""Yarns with flanks against the height field alone: pictures, means and cost.

    python -m studies.accuracy.flanks [--points N] [--sheet FILE.jpg] [--output FILE.json]

The same rays over four fabrics, shaded where they meet the yarns' tubes (`yarn/flanks.py`) and where they end
on the height field: reflectance under a dome, seen from 8°, 52° and 75°, and the CPU time of a value of the
point model. The sheet shows both seen from above and from 40° above the cloth at 10, 30, 100 and 300 pixels a
thread, a row a fabric: on the left without flanks, on the right with them.
"""

from __future__ import annotations

import math
from argparse import ArgumentParser, Namespace
from pathlib import Path
from time import process_time

import drjit as dr
import numpy as np
from drjit.llvm import Array3f, Float
from numpy.typing import NDArray
from PIL import Image

from loomlight.core.arrays import Float as AnyFloat
from loomlight.core.arrays import Mask, Vec3
from loomlight.core.images import encoded
from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.flanks import SurfacePoint
from loomlight.yarn.geometry import YarnGeometry
from studies.accuracy.yarn_detail import dome, unit
from studies.instruments.harness import Figures, run

FABRICS = {
    "woollen twill": ("twill 2/2", "wool", "#70757d", "#a06a41"),
    "cotton denim": ("twill 3/1", "cotton", "#2c3f64", "#ddd6c6"),
    "linen plain": ("plain", "linen", "#c9ba98", "#bfae8a"),
    "silk satin": ("satin 5/2", "silk", "#a03045", "#a03045"),
}
VIEWS = {"8°": 8, "52°": 52, "75°": 75}
SUN = (-0.75, 0.35, 0.6)
PIXELS_A_THREAD = (10, 30, 100, 300)
# Views of the sheet: degrees above the cloth, and around it.
SHEET_VIEWS = ((89, -90), (40, -60))
SIDE, SAMPLES = 110, 6


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
    light = dome(rng, count)
    for view_name, degrees in VIEWS.items():
        tilt = math.radians(degrees)
        view = unit((0.8 * math.sin(tilt), 0.6 * math.sin(tilt), math.cos(tilt)), count)
        field, flanks = (value(model, x, y, light, view) for model in both)
        change = (flanks - field) / field.mean()
        figures[view_name] = float(change.mean())
        figures[f"{view_name}, deviation"] = float(change.std() / math.sqrt(count))
    times = [math.inf, math.inf]
    for _ in range(4):  # the first compiles
        for index, model in enumerate(both):
            start = process_time()
            value(model, x, y, light, view)
            times[index] = min(times[index], process_time() - start)
    return {**figures, "cost": times[1] / times[0]}


def picture(model: YarnScattering, pixels: int, elevation: float, azimuth: float) -> NDArray[np.uint8]:
    """The cloth by parallel rays, in the sun and a dimmer sky, 8-bit sRGB [SIDE, SIDE, 3]."""
    rng = np.random.default_rng(3)
    spacing, count = min(model.surface.finest), SIDE * SIDE
    rise, turn = math.radians(elevation), math.radians(azimuth)
    view = unit((math.cos(rise) * math.cos(turn), math.cos(rise) * math.sin(turn), math.sin(rise)), count)
    row, column = np.mgrid[:SIDE, :SIDE].reshape(2, -1)
    total = np.zeros((3, count))
    for _ in range(SAMPLES):
        right = (column + rng.random(count) - SIDE / 2) / pixels * spacing
        towards = (row + rng.random(count) - SIDE / 2) / pixels * spacing / math.sin(rise)
        x = 1.3 * spacing - math.sin(turn) * right + math.cos(turn) * towards
        y = 2.2 * spacing + math.cos(turn) * right + math.sin(turn) * towards
        size = dr.full(Float, spacing / pixels, count)
        point = model.locate(Float(x.astype(np.float32)), Float(y.astype(np.float32)), view, size=size)
        sky = dome(rng, count)
        lit = 2.6 * model.evaluate(point, unit(SUN, count), view)
        lit += model.evaluate(point, sky, view) * (0.45 * math.pi * dr.rcp(sky.z))
        total += lit.numpy()
    return encoded((total / SAMPLES).T.reshape(SIDE, SIDE, 3).astype(np.float32))


def sheet() -> Image.Image:
    """Rows of fabrics, without flanks and with them."""
    rows = []
    for name in FABRICS:
        tiles = [
            picture(model, pixels, *view)
            for model in models(name)
            for view in SHEET_VIEWS
            for pixels in PIXELS_A_THREAD
        ]
        rows.append(np.concatenate(tiles, axis=1))
    return Image.fromarray(np.concatenate(rows))


def measure(options: Namespace) -> Figures:
    require_llvm()
    if options.sheet:
        sheet().save(options.sheet, quality=84)
    figures: Figures = {}
    print("| fabric | 8° | 52° | 75° | cost |\n|---|---|---|---|---|")
    for name in FABRICS:
        found = figures[name] = compare(name, options.points)
        means = (f"{100 * found[view]:+.2f} ± {100 * found[f'{view}, deviation']:.2f} %" for view in VIEWS)
        print(f"| {name} | {' | '.join(means)} | {found['cost']:.2f} |", flush=True)
    return figures


def add_options(parser: ArgumentParser) -> None:
    parser.add_argument("--points", type=int, default=100_000)
    parser.add_argument("--sheet", type=Path)


if __name__ == "__main__":
    run(measure, add_options, prints=False)
