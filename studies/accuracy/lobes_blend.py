"""What `lobes` errs by through the blend of its regimes, on held-out fabrics and on odd ones.

nMAE of grey reflection by size of the footprint: by the bands of the query benchmark, and by the side in
threads, as the blend from points to groups is a matter of threads. The odd fabrics have irregular drafts,
gaps to 0.7 and unequal setts (`studies/instruments/held_out.py`); the truths are kept on disk.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np

from loomlight.aggregate.components import COMPONENTS
from loomlight.aggregate.queries import BANDS, fabric_scale
from loomlight.core.backend import array_types
from loomlight.core.llvm import llvm_float
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.metrics import OVERALL
from loomlight.evaluation.query_benchmark import (
    SEED,
    HeldOut,
    grey_value,
    query_arrays,
    query_truth,
)
from loomlight.evaluation.table import Table
from loomlight.models.lobes.model import DEFAULT_GROUPS, LobesModel, LobesOptions
from studies.harness.study import Figures, Found, Run, Study
from studies.instruments.held_out import held_out_fabrics, odd_fabrics

# Sides of footprints, in threads.
SIDES = 0.0, 0.25, 0.5, 0.7, 1.0, 1.3, 1.6, 2.2, 3.0, 5.0, np.inf
SIDE_NAMES = [f"{low:g} to {high:g}" if high < np.inf else f"above {low:g}" for low, high in pairwise(SIDES)]


@dataclass(frozen=True)
class LobesBlend(Settings):
    groups: int = setting(DEFAULT_GROUPS, "Groups of a family.", low=1, high=64)
    fabrics: int = setting(12, "Of the held-out fabrics.", low=1, high=24)
    odd: int = setting(6, "Of the odd fabrics.", low=0, high=6)
    pairs: int = setting(32, "Pairs of directions of a fabric.", low=1)
    footprints: int = setting(64, "Footprints of a pair.", low=1)


def errors_of(cloth: HeldOut, number: int, settings: LobesBlend) -> dict[str, list[float]]:
    """By class of size: sums of |error| and of the truth, both of grey reflection, over one fabric."""
    fabric = cloth.fabric
    queries, truth = query_truth(fabric, SEED + number, settings.pairs, settings.footprints)
    light, view, footprint = query_arrays(array_types(llvm_float()), queries)
    model = LobesModel.for_source(fabric, LobesOptions(groups=settings.groups))
    parts = model.at(view, footprint).components(light)
    means = np.stack([np.asarray(getattr(parts, name).numpy(), np.float64) for name in COMPONENTS], axis=-1)
    predicted = means.reshape(*queries.sizes.shape, -1)
    lights, views = queries.lights[queries.pairs[:, 0]], queries.views[queries.pairs[:, 1]]
    reflects = lights[:, 2] * views[:, 2] > 0
    exact = grey_value(truth.astype(np.float64))[reflects]
    error = np.abs(grey_value(predicted)[reflects] - exact)
    scale = fabric_scale(fabric.layout())
    sizes = queries.sizes[reflects]
    band, side = scale.bands(sizes), np.searchsorted(SIDES, sizes / scale.thread, side="right") - 1

    def sums(chosen: Any) -> list[float]:
        return [float(error[chosen].sum()), float(exact[chosen].sum())]

    return {
        OVERALL: sums(np.full(sizes.shape, True)),
        **{name: sums(band == number) for number, name in enumerate(BANDS)},
        **{name: sums(side == number) for number, name in enumerate(SIDE_NAMES)},
    }


def measure(settings: LobesBlend, run: Run) -> Found:
    """Errors of both kinds of fabrics by class of size, and of each fabric."""
    kinds = {"held-out": held_out_fabrics(settings.fabrics), "odd": odd_fabrics()[: settings.odd]}
    cloths = [(kind, cloth) for kind, group in kinds.items() for cloth in group]
    by_fabric = run.each(
        {cloth.name: partial(errors_of, cloth, number, settings) for number, (_, cloth) in enumerate(cloths)}
    )
    figures: Figures = {
        "nmae": {
            kind: _means(by_fabric[cloth.name] for cloth in group) for kind, group in kinds.items() if group
        },
        "nmae_by_fabric": {name: _means([sums])[OVERALL] for name, sums in by_fabric.items()},
    }
    return Found(figures)


def _means(rows: Iterable[dict[str, list[float]]]) -> dict[str, float | None]:
    """nMAE by class of size over several fabrics; None without queries."""
    chosen = list(rows)
    found: dict[str, float | None] = {}
    for name in chosen[0]:
        error, exact = np.sum([row[name] for row in chosen], axis=0)
        found[name] = float(error / exact) if exact else None
    return found


def tables(figures: Figures) -> list[Table]:
    """Errors by band, by side in threads, and by fabric."""
    by_band = Table("nMAE of `lobes`, reflection", [OVERALL, *BANDS])
    by_side = Table("nMAE of `lobes` by side of the footprint in threads", SIDE_NAMES)
    for kind, row in figures["nmae"].items():
        by_band.rows[kind] = [row[name] for name in by_band.columns]
        by_side.rows[kind] = [row[name] for name in SIDE_NAMES]
    by_fabric = Table("nMAE of `lobes` by fabric", ["nMAE"])
    by_fabric.rows = {name: [value] for name, value in figures["nmae_by_fabric"].items()}
    return [by_band, by_side, by_fabric]


STUDY = Study(
    "accuracy/lobes_blend",
    "errors of `lobes` on held-out and odd fabrics by size, through the blend of its regimes",
    LobesBlend(),
    measure,
    tables,
    stands_on=("lobes", "point"),
    small={"fabrics": 1, "odd": 1, "pairs": 4, "footprints": 4},
)
