"""Processor time of `point` on layered cloth, beside one layer of it by itself, paired in the same run.

Places are drawn over the repeat; each is located along its view ray and evaluated for a light, both searched.
What the cloth is measured by is one of its own layers by itself, the one of the finest threads.
"""

from __future__ import annotations

import time
import warnings
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import drjit as dr
import numpy as np
from drjit.llvm.ad import Array3f, Bool, Float

from loomlight.core.errors import LoomlightWarning
from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.fabric import load_fabric
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.stack import cloth_geometry
from studies.harness.study import Figures, Found, Run, Study, listed, names
from studies.instruments.directions import above

# Probes are short: so many of all places are timed together.
SAMPLES_A_TIMING = 16
FOLDER = Path(__file__).parents[2] / "examples" / "layered"


@dataclass(frozen=True)
class LayerSpeed(Settings):
    drafts: str = names(
        "double-plain,stitched-double-cloth,pattern-double-weave,pocket,matelasse,four-layers", "Drafts."
    )
    count: int = setting(1 << 19, "Places.", low=1)
    rounds: int = setting(9, "Timings of each, in turns.", low=1)


def _models(draft: str) -> tuple[int, dict[str, YarnScattering]]:
    """Layers upon one another; the one of the finest threads by itself, and the whole cloth."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", LoomlightWarning)
        fabric = load_fabric(FOLDER / f"{draft}.wif")
    layout, appearance = fabric.layout(), fabric.appearance()
    # Light between yarns is a table of the fabric's, the same for both.
    appearance = replace(appearance, openness=None)
    finest = min(
        (layer.layout for layer in layout.layers if min(layer.ends.size, layer.picks.size) > 1),
        key=lambda layer: min(layer.warp.spacing.min(), layer.weft.spacing.min()),
    )
    return layout.depth, {
        "layer": YarnScattering(cloth_geometry(finest), appearance),
        "cloth": YarnScattering(cloth_geometry(layout), appearance),
    }


def _calls(model: YarnScattering, count: int) -> dict[str, Callable[[], None]]:
    """One that probes the surface of places once, and one that searches for them and for their light."""
    rng = np.random.default_rng(0)
    width, height = model.surface.size
    x, y = Float(rng.uniform(0, width, count)), Float(rng.uniform(0, height, count))
    light, view = (Array3f(above(rng, count, 0.05).astype(np.float32)) for _ in range(2))
    back, right = dr.full(Bool, False, count), dr.full(Bool, True, count)
    dr.eval(x, y, light, view, back, right)

    def evaluate() -> None:
        dr.eval(model.evaluate(model.locate(x, y, view), light, view))
        dr.sync_thread()

    def probe() -> None:
        dr.eval(model.surface.probe(x, y, back, right, right))
        dr.sync_thread()

    return {"evaluation": evaluate, "probe": probe}


def measure(settings: LayerSpeed, run: Run) -> Found:
    """Medians of ratios between neighbouring timings of the process."""
    del run
    require_llvm()
    drafts: dict[str, Any] = {}
    for draft in listed(settings.drafts):
        depth, models = _models(draft)
        calls = {name: _calls(model, settings.count) for name, model in models.items()}
        drafts[draft] = {"layers": depth}
        for kind in ("probe", "evaluation"):
            ratios, microseconds = [], []
            for turn in range(settings.rounds + 1):
                repeats = SAMPLES_A_TIMING if kind == "probe" else 1
                layer, cloth = (_seconds(calls[name][kind], repeats) for name in ("layer", "cloth"))
                # The first turn compiles.
                if turn:
                    ratios.append(cloth / layer)
                    microseconds.append(1e6 * cloth / settings.count)
            drafts[draft][f"{kind}_ratio"] = round(float(np.median(ratios)), 2)
            drafts[draft][f"{kind}_microseconds"] = round(float(np.median(microseconds)), 3)
    return Found({"drafts": drafts})


def _seconds(call: Callable[[], None], repeats: int) -> float:
    start = time.process_time()
    for _ in range(repeats):
        call()
    return (time.process_time() - start) / repeats


def tables(figures: Figures) -> list[Table]:
    """Ratios by draft."""
    keys = ("layers", "probe_ratio", "evaluation_ratio", "probe_microseconds", "evaluation_microseconds")
    rows = {name: [found[key] for key in keys] for name, found in figures["drafts"].items()}
    columns = ["layers", "a sample, ratio", "a place, ratio", "a sample, µs", "a place, µs"]
    note = (
        "Processor time beside the layer of the finest threads by itself; of a place with view and light, "
        "both searched."
    )
    return [Table("Cost of layers by `point`", columns, rows, note)]


STUDY = Study(
    "speed/layers",
    "processor time of layered cloth beside one of its layers, paired",
    LayerSpeed(),
    measure,
    tables,
    stands_on=("point cost",),
    small={"drafts": "double-plain", "count": 1 << 10, "rounds": 1},
)
