"""Brightness of `lobes` over distance: the mean over positions against rays, from close-ups to afar.

Flat cloth is seen by footprints of 1/300 to 30 threads, in ten pairs of light and view, from both faces and
through the cloth: every weave at the defaults of fabric files, and three with other gaps and heights. Light
between yarns is off: it is no matter of directions. The mean of a footprint's value over all positions does
not depend on its size, so one mean of the point model over the repeat is the truth of all sizes. Figures are
relative errors of the mean luminance; the bar is on the largest of each cloth.

Then random irregular weaves of 12 by 12 threads, gaps to 0.6: the query benchmark's error by size.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from itertools import islice
from typing import Any

import drjit as dr
import numpy as np
from drjit.llvm.ad import Array2f, Array3f, Float
from numpy.typing import NDArray

from loomlight.aggregate.queries import BANDS
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.query_benchmark import HeldOut, model_predictor, run_query_benchmark
from loomlight.evaluation.table import Cell, Table
from loomlight.fabric.fabric import Fabric, make_fabric
from loomlight.fabric.fields import FabricFile, YarnTable
from loomlight.models.lobes.model import LobesModel
from loomlight.models.neural.weights import ParameterRanges
from loomlight.scattering.point import YarnScattering
from loomlight.weave.named import named_weave
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.rays import SearchQuality
from studies.harness.study import Figures, Found, Run, Study, listed, names
from studies.instruments.directions import direction
from studies.instruments.held_out import irregular_draft
from studies.instruments.luminance import LUMINANCE
from studies.papers.chen2024.training.random_fabrics import random_fabric

WEAVES = (
    "plain",
    "basket 2/2",
    "twill 2/1",
    "twill 3/1",
    "twill 2/2",
    "satin 5/2",
    "satin 8/3",
    "irregular",
)
# Fields of fabric files other than the defaults, on these weaves.
VARIED_WEAVES = "plain", "twill 3/1", "satin 5/2"
VARIATIONS: dict[str, dict[str, Any]] = {
    "gap 0": {"gap": 0.0},
    "gap 0.4": {"gap": 0.4},
    "height 0.3": {"warp": YarnTable(height_scale=0.3), "weft": YarnTable(height_scale=0.3)},
    "height 1.5": {"warp": YarnTable(height_scale=1.5), "weft": YarnTable(height_scale=1.5)},
}
# Signs of z of (light, view) by side.
SIDES = {
    "reflection": (1, 1),
    "transmission": (-1, 1),
    "reflection of the back": (-1, -1),
    "transmission to the back": (1, -1),
}
SIDE, IRREGULAR_SEED = 12, 3
# Angles from the normal and azimuths of light and view, degrees.
PAIRS = {
    "opposite": ((45, 20), (50, 200)),
    "side": ((50, 20), (45, 110)),
    "same": ((50, 40), (30, 50)),
    "grazing view": ((40, 100), (75, 250)),
    "grazing light": ((75, 200), (30, 80)),
    "from above": ((20, 300), (10, 60)),
    "along the warp": ((40, 90), (40, 270)),
    "along the weft": ((40, 0), (40, 180)),
    "askew": ((60, 330), (35, 285)),
    "both grazing": ((70, 140), (65, 15)),
}
THREADS = 1 / 300, 1 / 30, 0.1, 0.3, 0.6, 1.0, 1.6, 2.4, 4.0, 8.0, 16.0, 30.0
BAR, VARIED_BAR, IRREGULAR_BAR = 0.03, 0.05, 0.075
IRREGULAR_RANGES = ParameterRanges(gap=(0.0, 0.6))
_TRUTH_QUALITY = SearchQuality(24, 24, refinements=6, steps=8192)

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Directions:
    """A pair of directions: unit vectors [3]."""

    light: Floats
    view: Floats


def pairs_of(side: str, count: int) -> dict[str, Directions]:
    """The first `PAIRS` as vectors, on one of `SIDES`."""
    of_light, of_view = (np.array([1, 1, sign]) for sign in SIDES[side])
    return {
        name: Directions(direction(*light) * of_light, direction(*view) * of_view)
        for name, (light, view) in islice(PAIRS.items(), count)
    }


def fabric_of(weave: str, fields: Mapping[str, Any] | None = None) -> Fabric:
    """A weave at the defaults of fabric files but for some fields, without light between yarns."""
    draft = irregular_draft(IRREGULAR_SEED, SIDE) if weave == "irregular" else named_weave(weave)
    return make_fabric(FabricFile(interreflection=False, **(fields or {})), draft, weave, ".")


def positions(fabric: Fabric, count: int) -> Array2f:
    """Positions evenly over the repeat, millimetres (Roberts 2018)."""
    number = np.arange(count)
    turns = [number * share % 1 for share in (0.7548776662466927, 0.5698402909980532)]
    return Array2f(
        *(Float((turn * side).astype(np.float32)) for turn, side in zip(turns, fabric.repeat_mm, strict=True))
    )


def _luminance(value: Any) -> float:
    return float(value.numpy().astype(np.float64).mean(axis=1) @ LUMINANCE)


def truth(fabric: Fabric, pair: Directions, count: int) -> float:
    """Mean luminance of the point model over the repeat, 1/sr."""
    model = YarnScattering(YarnGeometry(fabric.layout()), fabric.appearance(), _TRUTH_QUALITY)
    place = positions(fabric, count)
    zeros = dr.opaque(Float, 0, count)
    view, light = (Array3f(*(Float(part) + zeros for part in vector)) for vector in (pair.view, pair.light))
    dr.eval(place, view, light)
    return _luminance(model.evaluate(model.locate(place.x, place.y, view), light, view))


def seen(model: LobesModel, pair: Directions, threads: float, count: int) -> float:
    """Mean luminance of the model over positions, 1/sr, for squares of a side in threads."""
    fabric = model.fabric
    picks, ends = fabric.layout().warp_on_top.shape
    side = threads * float(np.sqrt(np.prod(fabric.repeat_mm) / (picks * ends)))
    # Opaque: directions are no literals of the kernel, which serves all pairs and sizes.
    zeros = dr.opaque(Float, 0, count)
    # Along neither family, as on cloth that is looked at.
    edges = Array2f(0.8 * side + zeros, 0.6 * side), Array2f(-0.6 * side + zeros, 0.8 * side)
    view, light = (Array3f(*(Float(part) + zeros for part in vector)) for vector in (pair.view, pair.light))
    dr.eval(edges, view, light)
    return _luminance(model.at(view, Footprint(positions(fabric, count), *edges)).value(light))


def errors(fabric: Fabric, settings: Brightness) -> dict[str, dict[str, list[float]]]:
    """Relative errors by side of the light, pair and size."""
    model = LobesModel.for_source(fabric)
    return {
        side: {
            name: [seen(model, pair, threads, settings.positions) / exact - 1 for threads in THREADS]
            for name, pair in pairs_of(side, settings.directions).items()
            for exact in (truth(fabric, pair, settings.truth_positions),)
        }
        for side in SIDES
    }


def irregular(count: int, pairs: int, footprints: int) -> dict[str, Any]:
    """nMAE of the query benchmark by band of size, over random irregular weaves with gaps to 0.6."""
    cloths = [
        HeldOut(
            f"irregular {seed}",
            random_fabric(np.random.default_rng(seed), irregular_draft(seed, SIDE), ranges=IRREGULAR_RANGES),
            True,
            False,
        )
        for seed in range(100, 100 + count)
    ]
    result = run_query_benchmark(
        {"lobes": model_predictor(LobesModel.for_source)},
        cloths,
        pairs=pairs,
        footprints=footprints,
        monte_carlo=(),
    )
    row = result.rows["lobes"]
    return {
        quantity: {band: row.metric(quantity, band) for band in BANDS}
        for quantity in ("reflection", "transmission")
    }


@dataclass(frozen=True)
class Brightness(Settings):
    weaves: str = names(",".join(WEAVES), "At the defaults of fabric files.", WEAVES)
    varied: str = names(",".join(VARIED_WEAVES), "With other gaps and heights too.")
    directions: int = setting(
        len(PAIRS), "Pairs of light and view, the first so many.", low=1, high=len(PAIRS)
    )
    positions: int = setting(1 << 13, "Over the repeat, of the model at each size.", low=1)
    truth_positions: int = setting(1 << 15, "Of the truth.", low=1)
    irregular: int = setting(8, "Random irregular weaves.", low=0)
    pairs: int = setting(48, "Pairs of directions of each of these.", low=1)
    footprints: int = setting(96, "Footprints of each pair.", low=1)


def measure(settings: Brightness, run: Run) -> Found:
    """Errors of all weaves, and the largest of each."""
    require_llvm()
    weaves = listed(settings.weaves)
    cloths = {weave: fabric_of(weave) for weave in weaves}
    for weave in listed(settings.varied):
        for change, fields in VARIATIONS.items():
            cloths[f"{weave}, {change}"] = fabric_of(weave, fields)
    by_weave = run.each({name: partial(errors, cloth, settings) for name, cloth in cloths.items()})
    largest = {
        weave: {
            side: max(abs(error) for row in rows.values() for error in row) for side, rows in sides.items()
        }
        for weave, sides in by_weave.items()
    }
    figures: Figures = {
        "threads": THREADS,
        "bar": BAR,
        "varied_bar": VARIED_BAR,
        "largest_relative_error": largest,
        "relative_errors": {weave: by_weave[weave] for weave in weaves},
        "missed": [
            f"{name} {side}"
            for name, sides in largest.items()
            for side, error in sides.items()
            if error > (BAR if name in WEAVES else VARIED_BAR)
        ],
    }
    if settings.irregular:
        figures["irregular_nmae"] = irregular(settings.irregular, settings.pairs, settings.footprints)
        # Above two threads: both upper bands.
        for quantity, bands in figures["irregular_nmae"].items():
            worst = max(bands[band] for band in BANDS[2:] if bands[band] is not None)
            if worst > IRREGULAR_BAR:
                figures["missed"].append(f"irregular weaves in {quantity}")
    return Found(figures)


def tables(figures: Figures) -> list[Table]:
    """The largest errors of all sides and sizes by weave, and those of random irregular weaves."""
    rows: dict[str, list[Cell]] = {}
    for weave, found in figures["largest_relative_error"].items():
        worst = [max(error for side, error in found.items() if kind in side) for kind in ("refl", "trans")]
        rows[weave] = [f"{100 * error:.0f}" for error in worst]
    largest = Table("Largest errors of the mean luminance", ["reflection, %", "transmission, %"], rows)
    random = {quantity: list(bands.values()) for quantity, bands in figures.get("irregular_nmae", {}).items()}
    irregular = Table("nMAE on random irregular weaves with gaps", list(BANDS), random)
    return [largest, irregular] if random else [largest]


STUDY = Study(
    "accuracy/brightness",
    "brightness of `lobes` over distance: means over positions against rays",
    Brightness(),
    measure,
    tables,
    stands_on=("lobes", "point"),
    small={
        "weaves": "plain",
        "varied": "",
        "positions": 64,
        "truth_positions": 64,
        "irregular": 0,
        "directions": 1,
    },
)
