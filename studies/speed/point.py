"""Full evaluations of the point model a second (geometry, visibility, all lobes), against the machine.

The floating-point operations of an evaluation are counted in the kernel that Dr.Jit emits (a fused
multiply-add is two, a root or a division one); the FMA peak is measured in the same run with independent
chains of multiply-adds. Every other figure is the median of several timings, so ratios hold on noisy
machines.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from drjit.llvm.ad import Array3f, Bool, Float

from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.fabric import fabric_from_text
from loomlight.scattering.appearance import Sheen
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.visibility import HorizonMap
from studies.harness.study import Figures, Found, Run, Study, listed, names
from studies.instruments.directions import above
from studies.instruments.machine import fma_peak, median_seconds, operations_of
from studies.instruments.tabulated_visibility import TabulatedScattering
from studies.instruments.timing import launched_kernels


def evaluations(model: YarnScattering, count: int, searched: bool) -> tuple[float, int | None]:
    """Evaluations a second, and operations in one (None where the kernel has loops)."""
    rng = np.random.default_rng(0)
    width, height = model.surface.size

    x, y = Float(rng.uniform(0, width, count)), Float(rng.uniform(0, height, count))
    light, view = (Array3f(above(rng, count, 0.05).astype(np.float32)) for _ in range(2))
    front, hole = dr.opaque(Bool, False, count), dr.opaque(Bool, False, count)
    dr.eval(x, y, light, view)

    def evaluate() -> None:
        point = model.locate(x, y, view) if searched else model.at(x, y, front, hole)
        dr.eval(model.evaluate(point, light, view))

    seconds = median_seconds(evaluate)
    if searched:
        return count / seconds, None
    kernels = launched_kernels(evaluate)
    return count / seconds, sum(operations_of(kernel["ir"].read()) for kernel in kernels)


@dataclass(frozen=True)
class PointSpeed(Settings):
    fabrics: str = names("plain,twill 3/1,satin 8/3", "Weaves.")
    count: int = setting(1 << 22, "Evaluations.", low=1)


def measure(settings: PointSpeed, run: Run) -> Found:
    """Rates of three weaves against the machine's peak."""
    require_llvm()
    peak = fma_peak()
    fabrics: dict[str, Any] = {}
    for text in listed(settings.fabrics):
        fabric = fabric_from_text(text)
        layout, appearance = fabric.layout(), fabric.appearance()
        appearance = type(appearance)(appearance.warp, appearance.weft, sheen=Sheen(0.3, 0.4))
        geometry = YarnGeometry(layout)
        table = HorizonMap(geometry, (256, 256), Float)
        tabulated = TabulatedScattering(geometry, appearance, table)
        rate, operations = evaluations(tabulated, settings.count, searched=False)
        exact = evaluations(YarnScattering(geometry, appearance), settings.count, searched=True)[0]
        assert operations is not None
        fabrics[text] = {
            "tabulated_millions_per_second": round(rate / 1e6, 2),
            "operations": operations,
            "share_of_fma_peak": round(rate * operations / peak, 3),
            "exact_search_millions_per_second": round(exact / 1e6, 2),
        }
    return Found({"fma_peak_gflops": round(peak / 1e9, 1), "fabrics": fabrics})


def tables(figures: Figures) -> list[Table]:
    """Rates by weave."""
    keys = (
        "exact_search_millions_per_second",
        "tabulated_millions_per_second",
        "operations",
        "share_of_fma_peak",
    )
    rows = {name: [found[key] for key in keys] for name, found in figures["fabrics"].items()}
    columns = ["million/s, searched", "million/s, tabulated", "operations, tabulated", "of the FMA peak"]
    note = f"FMA peak {figures['fma_peak_gflops']} GFLOP/s."
    return [Table("Evaluations of `point`", columns, rows, note)]


STUDY = Study(
    "speed/point",
    "full evaluations of the point model a second, against the machine",
    PointSpeed(),
    measure,
    tables,
    stands_on=("point cost",),
    small={"fabrics": "plain", "count": 1 << 12},
)
