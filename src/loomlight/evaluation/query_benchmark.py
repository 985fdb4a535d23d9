"""The query benchmark: predictions for the footprints of held-out fabrics against the truth, by class.

The quantities (`QUANTITIES`), each overall and by band of footprint size, roughness and elevation:

- reflection: f·cos at grey albedos k_d = 0.4 and k_s = 0.6, light and view on one side: the headline;
- transmission: the same with light and view on different sides;
- colour: f·cos in RGB with the albedos of the threads, both sides, fabrics of several colours only;
- each of the four components, and the hole fraction, of all queries;
- sheen: f·cos of a sheen of strength 1, shadowed, light and view on one side.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.aggregate.components import CHANNELS, COLOURS
from loomlight.aggregate.queries import BANDS, QuerySet, fabric_scale
from loomlight.core.backend import array_types
from loomlight.core.errors import InputError
from loomlight.core.llvm import llvm_float
from loomlight.evaluation.metrics import OVERALL, Classes, ErrorSums, sums_by_class
from loomlight.evaluation.predictions import Prediction, Predictor, monte_carlo_predictor
from loomlight.evaluation.table import Cell, Table
from loomlight.evaluation.truth import FOOTPRINTS, PAIRS, query_truth
from loomlight.fabric.fabric import Fabric
from loomlight.scattering.appearance import Sheen
from loomlight.scattering.sheen import sheen

DIFFUSE_ALBEDO, SPECULAR_ALBEDO = 0.4, 0.6
QUANTITIES = ("reflection", "transmission", "colour", *CHANNELS, "sheen")
ROUGHNESS_BOUNDS = (0.15, 0.4)
ROUGHNESS = ("α < 0.15", "α 0.15–0.4", "α > 0.4")
GRAZING_DEGREES = 60.0
ELEVATION = ("within 60°", "beyond 60°")
WEAVES = ("paper's weaves", "unseen weaves")
MONTE_CARLO = (1, 3, 16)
SEED = 2024

Progress = Callable[[int, int], None]


@dataclass(frozen=True, eq=False)
class HeldOut:
    """A fabric of the benchmark, such as those of `experiments/held_out.py`, which are in no training set.

    Attributes:
        name: of its row.
        fabric: the fabric, without sheen and variation.
        unseen_weave: its weave is in no training set.
        coloured: its threads have several colours.
    """

    name: str
    fabric: Fabric
    unseen_weave: bool
    coloured: bool


@dataclass
class RowResult:
    """One row: error sums by quantity and class, and by fabric.

    Attributes:
        sums: by quantity, then by class ("overall", a band, …).
        fabrics: nMAE of grey f·cos, both sides, by the fabric's name.
        rates: queries a second, one a fabric.
        cost: multiply-adds and bytes fetched of one query; None if the model does not state them.
        refused: the reason, by the name of each fabric that the model does not take.
    """

    sums: dict[str, dict[str, ErrorSums]] = field(default_factory=dict)
    fabrics: dict[str, float] = field(default_factory=dict)
    rates: list[float] = field(default_factory=list)
    cost: tuple[int, int] | None = None
    refused: dict[str, str] = field(default_factory=dict)

    def metric(self, quantity: str, name: str = OVERALL, metric: str = "nmae") -> float:
        """One figure; NaN where there were no such queries."""
        sums = self.sums.get(quantity, {}).get(name, ErrorSums())
        return float(getattr(sums, metric))

    def add(self, quantity: str, sums_of_fabric: dict[str, ErrorSums]) -> None:
        """Adds the sums of one fabric."""
        totals = self.sums.setdefault(quantity, {})
        for name, sums in sums_of_fabric.items():
            totals[name] = totals.get(name, ErrorSums()) + sums


@dataclass
class QueryBenchmark:
    """Results of the query benchmark.

    Attributes:
        rows: by name.
        fabrics: names of the fabrics that every row takes; the sums are over these.
        queries: of each fabric.
    """

    rows: dict[str, RowResult]
    fabrics: list[str]
    queries: int

    def to_dict(self) -> dict[str, Any]:
        """Every figure, for JSON."""
        return {
            "fabrics": self.fabrics,
            "queries_per_fabric": self.queries,
            "rows": {
                name: {
                    "metrics": {
                        quantity: {part: sums.values() for part, sums in classes.items() if sums.count}
                        for quantity, classes in row.sums.items()
                    },
                    "nmae_by_fabric": row.fabrics,
                    "queries_per_second": float(np.median(row.rates)) if row.rates else None,
                    "multiply_adds": None if row.cost is None else row.cost[0],
                    "bytes_fetched": None if row.cost is None else row.cost[1],
                    "refused": row.refused,
                }
                for name, row in self.rows.items()
            },
        }

    def tables(self) -> list[Table]:
        """Four tables: nMAE by class, other metrics, nMAE by quantity, and by fabric."""
        note = f"{len(self.fabrics)} fabrics, {self.queries} queries each."
        classes = [OVERALL, *BANDS, *ROUGHNESS, *ELEVATION, *WEAVES]
        by_class = Table("nMAE of grey reflection", classes, note=note)
        metrics = ("mse", "bias")
        headings = ["nMAE", "MSE", "bias", "queries/s", "multiply-adds", "bytes fetched", "refused"]
        others = Table("All metrics of grey reflection", headings, note=note)
        quantities = Table("nMAE by quantity", list(QUANTITIES), note=note)
        fabrics = Table("nMAE of grey f·cos by fabric", self.fabrics)
        for name, row in self.rows.items():
            by_class.rows[name] = [row.metric("reflection", part) for part in classes]
            rate = f"{np.median(row.rates):.2g}" if row.rates else None
            cells: list[Cell] = [row.metric("reflection", metric=metric) for metric in ("nmae", *metrics)]
            others.rows[name] = [*cells, rate, *(row.cost or (None, None)), len(row.refused)]
            quantities.rows[name] = [row.metric(quantity) for quantity in QUANTITIES]
            fabrics.rows[name] = [row.fabrics.get(fabric) for fabric in self.fabrics]
        return [by_class, others, quantities, fabrics]


def run_query_benchmark(
    predictors: Mapping[str, Predictor],
    fabrics: Iterable[HeldOut],
    *,
    pairs: int = PAIRS,
    footprints: int = FOOTPRINTS,
    seed: int = SEED,
    monte_carlo: Iterable[int] = MONTE_CARLO,
    progress: Progress | None = None,
) -> QueryBenchmark:
    """Evaluates predictors by name, and Monte Carlo of a few samples, on the same queries.

    A fabric that a model refuses (InputError) is excluded from every row's sums, so that all rows are of the
    same queries; the row records which it refused and why.

    Args:
        pairs, footprints: queries of each fabric.
        seed: of the queries; fabric number k has seed + k.
        monte_carlo: sample counts of the rows added.
        progress: called with (fabrics done, fabrics in all).
    """
    chosen = list(fabrics)
    all_predictors = {
        **{samples_name(count): monte_carlo_predictor(count) for count in monte_carlo},
        **predictors,
    }
    rows = {name: RowResult() for name in all_predictors}
    used = []
    for number, cloth in enumerate(chosen):
        queries, truth = query_truth(cloth.fabric, seed + number, pairs, footprints, with_colours=True)
        predicted = {}
        for name, predict in all_predictors.items():
            try:
                predicted[name] = predict(cloth.fabric, queries)
            except InputError as error:
                rows[name].refused[cloth.name] = str(error)
        if len(predicted) == len(all_predictors):
            used.append(cloth.name)
            for name, prediction in predicted.items():
                _accumulate(rows[name], cloth, queries, prediction, truth.astype(np.float64))
        if progress is not None:
            progress(number + 1, len(chosen))
    return QueryBenchmark(rows, used, pairs * footprints)


def grey_value(means: NDArray[Any]) -> NDArray[np.float64]:
    """f·cos [...] at grey albedos of components [..., 5]: k_d = 0.4, k_s = 0.6."""
    diffuse, specular = means[..., 0] + means[..., 1], means[..., 2] + means[..., 3]
    return DIFFUSE_ALBEDO * diffuse + SPECULAR_ALBEDO * specular


def query_classes(fabric: Fabric, queries: QuerySet, unseen_weave: bool) -> list[Classes]:
    """The classes of queries [n, m]: band, roughness (of the smoother family), elevation, kind of weave.

    "beyond 60°" is where light or view lies more than 60° from the normal.
    """
    shape = queries.sizes.shape
    smoother = min(fabric.appearance().warp.roughness, fabric.appearance().weft.roughness)
    rough = np.searchsorted(ROUGHNESS_BOUNDS, smoother, side="right")
    cosines = np.abs(
        np.stack([queries.lights[queries.pairs[:, 0], 2], queries.views[queries.pairs[:, 1], 2]])
    )
    grazing = cosines.min(axis=0) < np.cos(np.radians(GRAZING_DEGREES))
    return [
        Classes(BANDS, fabric_scale(fabric.layout()).bands(queries.sizes)),
        Classes(ROUGHNESS, np.full(shape, rough)),
        Classes(ELEVATION, np.broadcast_to(grazing.astype(np.intp)[:, None], shape)),
        Classes(WEAVES, np.full(shape, int(unseen_weave))),
    ]


def _accumulate(
    row: RowResult, cloth: HeldOut, queries: QuerySet, predicted: Prediction, truth: NDArray[np.float64]
) -> None:
    parts = query_classes(cloth.fabric, queries, cloth.unseen_weave)
    light, view = queries.lights[queries.pairs[:, 0]], queries.views[queries.pairs[:, 1]]
    crosses = light[:, 2] * view[:, 2] < 0
    true_colours = truth[..., len(CHANNELS) : len(CHANNELS) + len(COLOURS)]
    if predicted.means is None:
        predicted_value, expected = predicted.colours.mean(axis=-1), true_colours.mean(axis=-1)
    else:
        predicted_value, expected = grey_value(predicted.means), grey_value(truth)
    for name, pairs in (("reflection", ~crosses), ("transmission", crosses)):
        if pairs.any():
            chosen = [Classes(part.names, part.codes[pairs]) for part in parts]
            row.add(name, sums_by_class(predicted_value[pairs], expected[pairs], chosen))
    if cloth.coloured:
        row.add("colour", sums_by_class(predicted.colours, true_colours, parts))
    if predicted.means is not None:
        for index, name in enumerate(CHANNELS):
            row.add(name, sums_by_class(predicted.means[..., index], truth[..., index], parts))
    if predicted.means is not None and predicted.light_visibility is not None:
        hole = CHANNELS.index("hole")
        lobe = _sheen_lobe(light, view)[~crosses, None]
        predicted_sheen, expected_sheen = (
            lobe * (lit + holes)[~crosses]
            for lit, holes in (
                (predicted.light_visibility, predicted.means[..., hole]),
                (truth[..., -1], truth[..., hole]),
            )
        )
        chosen = [Classes(part.names, part.codes[~crosses]) for part in parts]
        row.add("sheen", sums_by_class(predicted_sheen, expected_sheen, chosen))
    row.fabrics[cloth.name] = sums_by_class(predicted_value, expected, [])[OVERALL].nmae
    if predicted.cost is not None:
        row.cost = (predicted.cost.multiply_adds, predicted.cost.bytes_fetched)
    if predicted.rate is not None:
        row.rates.append(predicted.rate)


def _sheen_lobe(lights: NDArray[np.float64], views: NDArray[np.float64]) -> NDArray[np.float64]:
    """f·cos of an unshadowed sheen of strength 1 and the default roughness [n], 1/sr."""
    types = array_types(llvm_float())
    # Both on one side: those on the back are turned to the front.
    light, view = (
        types.Vector3(np.ascontiguousarray(np.c_[v[:, :2], abs(v[:, 2])].T, dtype=np.float32))
        for v in (lights, views)
    )
    return np.asarray(sheen(light, view, 1.0, Sheen().roughness).numpy(), np.float64)


def samples_name(count: int) -> str:
    """The name of the row of so many Monte Carlo samples."""
    return f"{count} sample" + ("s" if count > 1 else "")
