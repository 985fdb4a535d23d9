"""Full evaluations of the point model a second (geometry, visibility, all lobes), against the machine.

    python -m studies.speed.point [--output FILE.json]

The floating-point operations of an evaluation are counted in the kernel that Dr.Jit emits (a fused
multiply-add is two, a root or a division one); the FMA peak is measured in the same run with independent
chains of multiply-adds. Every other figure is the median of several timings, so ratios hold on noisy
machines.
"""

from __future__ import annotations

import math
from argparse import Namespace
from typing import Any

import drjit as dr
import numpy as np
from drjit.llvm.ad import Array3f, Bool, Float

from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.scattering.appearance import Sheen
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.visibility import HorizonMap
from studies.instruments.harness import Figures, run
from studies.instruments.machine import fma_peak, median_seconds, operations_of
from studies.instruments.tabulated_visibility import TabulatedScattering
from studies.instruments.timing import launched_kernels

COUNT = 1 << 22


def evaluations(model: YarnScattering, searched: bool) -> tuple[float, int | None]:
    """Evaluations a second, and operations in one (None where the kernel has loops)."""
    rng = np.random.default_rng(0)
    width, height = model.surface.size

    def directions() -> Any:
        z = rng.uniform(0.05, 1, COUNT)
        azimuth = rng.uniform(0, 2 * math.pi, COUNT)
        radius = np.sqrt(1 - z**2)
        return Array3f(Float(radius * np.cos(azimuth)), Float(radius * np.sin(azimuth)), Float(z))

    x, y = Float(rng.uniform(0, width, COUNT)), Float(rng.uniform(0, height, COUNT))
    light, view = directions(), directions()
    front, hole = dr.opaque(Bool, False, COUNT), dr.opaque(Bool, False, COUNT)
    dr.eval(x, y, light, view)

    def evaluate() -> None:
        point = model.locate(x, y, view) if searched else model.at(x, y, front, hole)
        dr.eval(model.evaluate(point, light, view))

    seconds = median_seconds(evaluate)
    if searched:
        return COUNT / seconds, None
    kernels = launched_kernels(evaluate)
    return COUNT / seconds, sum(operations_of(kernel["ir"].read()) for kernel in kernels)


def measure(_: Namespace) -> Figures:
    """Rates of three weaves against the machine's peak."""
    require_llvm()
    peak = fma_peak()
    fabrics: dict[str, Any] = {}
    for text in ("plain", "twill 3/1", "satin 8/3"):
        fabric = fabric_from_text(text)
        layout, appearance = fabric.layout(), fabric.appearance()
        appearance = type(appearance)(appearance.warp, appearance.weft, sheen=Sheen(0.3, 0.4))
        geometry = YarnGeometry(layout)
        table = HorizonMap(geometry, (256, 256), Float)
        rate, operations = evaluations(TabulatedScattering(geometry, appearance, table), searched=False)
        exact = evaluations(YarnScattering(geometry, appearance), searched=True)[0]
        assert operations is not None
        fabrics[text] = {
            "tabulated_millions_per_second": round(rate / 1e6, 2),
            "operations": operations,
            "share_of_fma_peak": round(rate * operations / peak, 3),
            "exact_search_millions_per_second": round(exact / 1e6, 2),
        }
    return {"fma_peak_gflops": round(peak / 1e9, 1), "fabrics": fabrics}


if __name__ == "__main__":
    run(measure)
