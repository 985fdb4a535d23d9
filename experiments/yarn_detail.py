"""Plies, fibres, slubs and hairs against smooth yarns: do means of reflected light stay?

    python -m experiments.yarn_detail [--points N] [--output FILE.json]

Every kind of yarn in a 2/2 twill, dark and white, under a white sky and from two views: the mean weight of
the point model's sampler over places of the repeat, with the detail that the smallest footprints show and
without it. The bar is 1 %.
"""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

import numpy as np
from drjit.llvm import Array2f, Array3f, Float

from benchmarks.harness import Figures, run
from experiments.interreflection import direction
from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.fabric.file import YARNS
from loomlight.scattering.point import PointModel
from loomlight.yarn.geometry import YarnGeometry

COLOURS = {"dark": "#303438", "white": "#f4f2ec"}
# Side of a footprint that shows everything, millimetres.
SMALLEST = 1e-3
BAR = 0.01


def mean_weight(
    model: PointModel, size: tuple[float, float], angle: float, detail: bool, count: int
) -> float:
    """Mean over places and channels of what a view gets back of a white sky."""
    rng = np.random.default_rng(7)
    x, y = (rng.random((2, count)) * [[50 * size[0]], [50 * size[1]]]).astype(np.float32)
    view = Array3f(*(np.full(count, part, np.float32) for part in direction(angle, 30)))
    point = model.locate(Float(x), Float(y), view, size=Float(SMALLEST) if detail else None)
    numbers = rng.random((3, count)).astype(np.float32)
    sample = model.sample(point, view, Float(numbers[0]), Array2f(numbers[1], numbers[2]))
    return float(np.array(sample.weight).astype(np.float64).mean())


def measure(options: Namespace) -> Figures:
    """Ratios of means with detail to means without."""
    require_llvm()
    rows = []
    for yarn in YARNS:
        for name, colour in COLOURS.items():
            fabric = fabric_from_text(
                f'weave = "twill 2/2"\nyarn = "{yarn}"\n'
                f'[warp]\ncolor = "{colour}"\n[weft]\ncolor = "{colour}"\n'
            )
            model = PointModel(YarnGeometry(fabric.layout()), fabric.appearance())
            for angle in (0.0, 50.0):
                smooth, detailed = (
                    mean_weight(model, fabric.repeat_mm, angle, detail, options.points)
                    for detail in (False, True)
                )
                rows.append({"yarn": yarn, "colour": name, "angle": angle, "change": detailed / smooth - 1})
    changes = [abs(float(str(row["change"]))) for row in rows]
    return {"bar": BAR, "mean": float(np.mean(changes)), "largest": max(changes), "rows": rows}


def add_options(parser: ArgumentParser) -> None:
    """Options of this script."""
    parser.add_argument("--points", type=int, default=1 << 18, help="places a fabric and view")


if __name__ == "__main__":
    run(measure, add_options)
