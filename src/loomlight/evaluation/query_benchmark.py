"""The query benchmark: predictions for the footprints of held-out fabrics against the truth, by class.

The quantities (`QUANTITIES`), each overall and by band of footprint size, roughness and elevation:

- reflection: f·cos at grey albedos k_d = 0.4 and k_s = 0.6, light and view on one side: the headline;
- transmission: the same with light and view on different sides;
- colour: f·cos in RGB with the albedos of the threads, both sides, fabrics of several colours only;
- each of the four components, and the hole fraction, of all queries;
- sheen: f·cos of a sheen of strength 1, shadowed, light and view on one side.
"""

from __future__ import annotations

import hashlib
import math
import os
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Protocol, runtime_checkable

import drjit as dr
import numpy as np
from numpy.typing import NDArray
from safetensors import SafetensorError
from safetensors.numpy import load_file, save_file

from loomlight.aggregate.components import (
    CHANNELS,
    COLOURS,
    COMPONENTS,
    LIGHT_VISIBILITY,
    colours,
    components,
    light_visibility,
    trace_views,
    without_sheen_and_variation,
)
from loomlight.aggregate.queries import BANDS, QuerySet, admits_transmission, fabric_scale, query_set
from loomlight.aggregate.slices import FabricSlices
from loomlight.core.backend import ArrayTypes, array_types, upload, upload_vector
from loomlight.core.errors import InputError
from loomlight.core.files import cache_folder, replacing
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import llvm_float
from loomlight.evaluation.metrics import OVERALL, Classes, ErrorSums, sums_by_class
from loomlight.evaluation.table import Cell, Table
from loomlight.fabric.fabric import Fabric
from loomlight.models.interface import FootprintBsdf, Model
from loomlight.models.separable import SeparableBsdf, shade
from loomlight.scattering.appearance import Sheen
from loomlight.scattering.point import YarnScattering
from loomlight.scattering.sheen import sheen
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.rays import REFERENCE_QUALITY

DIFFUSE_ALBEDO, SPECULAR_ALBEDO = 0.4, 0.6
QUANTITIES = ("reflection", "transmission", "colour", *CHANNELS, "sheen")
ROUGHNESS_BOUNDS = (0.15, 0.4)
ROUGHNESS = ("α < 0.15", "α 0.15–0.4", "α > 0.4")
GRAZING_DEGREES = 60.0
ELEVATION = ("within 60°", "beyond 60°")
WEAVES = ("paper's weaves", "unseen weaves")
# Pairs of light and view, and footprints, of a fabric.
PAIRS, FOOTPRINTS = 160, 160
MONTE_CARLO = (1, 3, 16)
SEED = 2024

Progress = Callable[[int, int], None]


@dataclass(frozen=True, eq=False)
class HeldOut:
    """A fabric of the benchmark; those of `studies/instruments/held_out.py` are in no training set.

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
    light, view = (upload_vector(types.Vector3, np.c_[v[:, :2], abs(v[:, 2])].T) for v in (lights, views))
    return np.asarray(sheen(light, view, 1.0, Sheen().roughness).numpy(), np.float64)


def samples_name(count: int) -> str:
    """The name of the row of so many Monte Carlo samples."""
    return f"{count} sample" + ("s" if count > 1 else "")


# -------------------------------------------------------------------------------------------------- the truth
# The truth of the query benchmark: slices on the reference plane, searched finely and cached on disk.
#
# The grid has 64 rays a thread (32 for repeats beyond 16 threads), so that its own error is 1 % of the mean
# below a quarter yarn and 0.15 % above (docs/research/aggregation.md).


# Part of every key: to be raised when geometry, scattering, slices or query sets change their values.
_VERSION = 3
_FINE, _COARSE = 64, 32
_MAX_FINE_REPEAT = 16 * 16
_TRUTHS = (*CHANNELS, *COLOURS, LIGHT_VISIBILITY)
_QUERIES = ("lights", "views", "pairs", "centres", "sizes")


def query_truth(
    fabric: Fabric,
    seed: int,
    pairs: int = PAIRS,
    footprints: int = FOOTPRINTS,
    with_colours: bool = False,
    folder: str | os.PathLike[str] | None = None,
    float_type: type | None = None,
) -> tuple[QuerySet, NDArray[np.float32]]:
    """Queries of a fabric and the exact means of its channels over them [pairs, footprints, 5].

    Lights and views lie on both sides; if the fabric's threads transmit light, half of the pairs are of
    different sides (transmission), else none.

    Args:
        seed: of the queries.
        with_colours: adds red, green and blue with the threads' own albedos, and the light visibility, which
            scales sheen: [pairs, footprints, 9].
        folder: of cached results; None is the user's cache.
        float_type: the Dr.Jit Float type to compute with; None is LLVM's.

    Returns:
        the queries, and means in the order of `CHANNELS`: components in 1/sr, `hole` as a fraction.

    Raises:
        InputError: no pairs or footprints, or a repeat too large for one slice (128 by 128 threads).
    """
    root = Path(cache_folder("truth") if folder is None else folder)
    file = root / f"{_key(fabric, seed, pairs, footprints)}.safetensors"
    cached = _read(file, (pairs, footprints, len(_TRUTHS)))
    if cached is None:
        cached = _compute(fabric, seed, pairs, footprints, float_type or llvm_float())
        _write(file, *cached)
    queries, means = cached
    return queries, means if with_colours else means[..., : len(CHANNELS)]


def reference_model(fabric: Fabric) -> YarnScattering:
    """The point model of a fabric with the search quality of the truth."""
    return YarnScattering(YarnGeometry(fabric.layout()), fabric.appearance(), REFERENCE_QUALITY)


def texels_per_thread(fabric: Fabric) -> int:
    """Rays a thread of the truth's grid."""
    return _FINE if fabric.draft.drawdown.size <= _MAX_FINE_REPEAT else _COARSE


def _compute(
    fabric: Fabric, seed: int, pairs: int, footprints: int, float_type: type
) -> tuple[QuerySet, NDArray[np.float32]]:
    transmits = admits_transmission(fabric.appearance())
    queries = query_set(fabric_scale(fabric.layout()), pairs, footprints, seed, transmits=transmits)
    slices = FabricSlices(
        reference_model(fabric),
        float_type,
        texels_per_thread(fabric),
        with_colours=True,
        with_light_visibility=True,
    )
    means = slices.box_means(queries.lights, queries.views, queries.pairs, queries.centres, queries.boxes)
    return queries, means


def _key(fabric: Fabric, seed: int, pairs: int, footprints: int) -> str:
    """A hash of everything that the truth depends on: numbers, not names."""
    digest = hashlib.sha256(repr((_VERSION, seed, pairs, footprints)).encode())
    digest.update(repr(texels_per_thread(fabric)).encode())
    for part in _numbers_of_yarns(fabric):
        digest.update(repr(part.shape).encode() + part.tobytes())
    return digest.hexdigest()[:32]


def _numbers_of_yarns(fabric: Fabric) -> Iterator[NDArray[np.float64]]:
    layout, appearance = fabric.layout(), fabric.appearance()
    yield np.asarray(layout.warp_on_top, np.float64)
    yield np.array([appearance.diffuse_blend, appearance.optical_depth])
    for family in (layout.warp, layout.weft):
        for name in ("spacing", "width", "inclination", "twist", "height_scale"):
            yield np.asarray(getattr(family, name), np.float64)
    for scattering in (appearance.warp, appearance.weft):
        for name in ("diffuse_reflect", "diffuse_transmit", "specular_reflect", "specular_transmit"):
            yield np.asarray(getattr(scattering, name), np.float64)
        yield np.array([scattering.roughness])
    yield np.array([appearance.openness is not None], np.float64)


def _read(file: Path, shape: tuple[int, int, int]) -> tuple[QuerySet, NDArray[np.float32]] | None:
    """The queries and means in a file; None if it does not exist or is damaged."""
    try:
        tensors = load_file(file)
        queries = QuerySet(*(tensors[name] for name in _QUERIES))
        means = tensors["means"]
    except (OSError, SafetensorError, KeyError):
        return None
    return (queries, means) if means.shape == shape else None


def _write(file: Path, queries: QuerySet, means: NDArray[np.float32]) -> None:
    """Writes the file; ignores errors, which cost time on the next run."""
    tensors = {name: np.ascontiguousarray(getattr(queries, name)) for name in _QUERIES}
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        with replacing(file) as temporary:
            save_file({**tensors, "means": means}, temporary)
    except (OSError, InputError, SafetensorError):
        return


# ------------------------------------------------------------------------------------------------ predictions
# Predictions of models, and of a few Monte Carlo samples, for a query set.


# Queries of one launch when speed is measured: enough to keep every core busy for a while.
_TIMED = 1 << 18
# Samples of one launch.
_BATCH = 1 << 20


@runtime_checkable
class Cost(Protocol):
    """The cost of a query, independent of the machine; models that state it have these attributes.

    Attributes:
        multiply_adds: of one query.
        bytes_fetched: from tables, by one query.
    """

    multiply_adds: int
    bytes_fetched: int


@dataclass(frozen=True, eq=False)
class Prediction:
    """Predictions for n pairs of directions and m footprints.

    Attributes:
        means: in the order of `CHANNELS` [n, m, 5], components in 1/sr and the hole fraction; None of models
            that do not separate albedos.
        colours: f·cos with the threads' albedos [n, m, 3], linear RGB, 1/sr, without sheen.
        light_visibility: fraction of view rays that meet lit yarn [n, m]; None like `means`.
        rate: queries a second on this machine, table reads included; None if not measured.
        cost: of one query; None if the model does not state it.
    """

    means: NDArray[np.float64] | None
    colours: NDArray[np.float64]
    light_visibility: NDArray[np.float64] | None = None
    rate: float | None = None
    cost: Cost | None = None


Predictor = Callable[[Fabric, QuerySet], Prediction]


def model_predictor(make: Callable[[Fabric], Model], float_type: type | None = None) -> Predictor:
    """Predicts with the model that `make` returns for each fabric, in batches of Dr.Jit arrays.

    Exceptions of `make` propagate; an InputError means that the model does not take the fabric.
    """

    def predict(fabric: Fabric, queries: QuerySet) -> Prediction:
        types = array_types(float_type or llvm_float())
        model = make(fabric)
        light, view, footprint = query_arrays(types, queries)
        count, shape = dr.width(light), queries.sizes.shape
        parts = _channels(model.at(view, footprint), light)
        numbers = np.stack([_numbers(part, count) for part in parts], axis=-1).reshape(*shape, -1)
        colours, means, lit = np.split(numbers, [len(COLOURS), len(COLOURS) + len(CHANNELS)], axis=-1)
        return Prediction(
            means if means.shape[-1] else None,
            colours,
            lit[..., 0] if lit.shape[-1] else None,
            _rate(types, model, queries),
            model if isinstance(model, Cost) else None,
        )

    return predict


def monte_carlo_predictor(samples: int, seed: int = 0, float_type: type | None = None) -> Predictor:
    """Predicts with `samples` rays a footprint through the point model, as a renderer does.

    Positions in the footprint are correlated multi-jittered, the pattern of Mitsuba's `multijitter`; the
    yarns are searched at the renderer's quality.
    """

    def predict(fabric: Fabric, queries: QuerySet) -> Prediction:
        types = array_types(float_type or llvm_float())
        model = YarnScattering(YarnGeometry(fabric.layout()), fabric.appearance())
        rng = np.random.default_rng([seed, samples])
        count = queries.sizes.size
        at_once = min(count, max(1, _BATCH // samples))
        values = np.empty((count, len(COLOURS) + len(CHANNELS) + 1))
        for first in range(0, count, at_once):
            chosen = np.arange(first, min(first + at_once, count))
            positions = multi_jittered(rng, len(chosen), samples)
            values[chosen] = _sampled(types, model, queries, chosen, positions)
        values = values.reshape(*queries.sizes.shape, -1)
        colours, means, lit = np.split(values, [len(COLOURS), len(COLOURS) + len(CHANNELS)], axis=-1)
        return Prediction(means, colours, lit[..., 0])

    return predict


def query_arrays(types: ArrayTypes, queries: QuerySet) -> tuple[Any, Any, Footprint]:
    """Lights, views [3] and footprints of a query set, pair by pair."""
    return _arrays(types, queries, np.arange(queries.sizes.size))


def multi_jittered(rng: np.random.Generator, sets: int, samples: int) -> NDArray[np.float64]:
    """Correlated multi-jittered points [sets, samples, 2] in the unit square (Kensler 2013).

    One point a cell of a grid, and one a row and a column of the grid of samples × samples cells. A count
    that fills no grid gives a row of cells.
    """
    rows = math.isqrt(samples)
    while samples % rows:
        rows -= 1
    columns = samples // rows
    column, row = np.divmod(np.arange(samples), rows)
    fine_x = rng.permuted(np.tile(np.arange(rows), (sets, columns, 1)), axis=2).reshape(sets, samples)
    ordered = np.tile(np.arange(columns), (sets, rows, 1))
    fine_y = rng.permuted(ordered, axis=2).transpose(0, 2, 1).reshape(sets, samples)
    u, v = rng.random((2, sets, samples))
    x = (column + (fine_x + u) / rows) / columns
    y = (row + (fine_y + v) / columns) / rows
    return np.stack([x, y], axis=-1)


def _sampled(
    types: ArrayTypes,
    model: YarnScattering,
    queries: QuerySet,
    chosen: NDArray[np.intp],
    positions: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Means of colours, channels and light visibility over the samples of each chosen query."""
    count, samples, _ = positions.shape
    light, view, footprint = _arrays(types, queries, np.repeat(chosen, samples))
    s, t = (upload(types.Float, part) for part in (positions - 0.5).reshape(-1, 2).T)
    position = footprint.at(s, t)
    plain = without_sheen_and_variation(model)
    point = trace_views(plain, position.x, position.y, view).point
    visible = plain.visibility(point, light)
    channels = [
        *colours(plain.appearance, point, light, view, visible),
        *components(plain.appearance, point, light, view, visible),
        dr.select(point.hole, types.Float(1), 0),
        light_visibility(point, visible),
    ]
    dr.eval(channels)
    return np.stack([part.numpy().reshape(count, samples).mean(axis=1) for part in channels], axis=-1)


def _arrays(types: ArrayTypes, queries: QuerySet, index: NDArray[np.intp]) -> tuple[Any, Any, Footprint]:
    pair = index // queries.sizes.shape[1]
    light, view = (
        upload_vector(types.Vector3, vectors[number].T)
        for vectors, number in (
            (queries.lights, queries.pairs[pair, 0]),
            (queries.views, queries.pairs[pair, 1]),
        )
    )
    centre = queries.centres.reshape(-1, 2)[index].T
    side = upload(types.Float, queries.sizes.ravel()[index])
    nothing = dr.zeros(types.Float)
    return (
        light,
        view,
        Footprint(
            upload_vector(types.Vector2, centre),
            types.Vector2(side, nothing),
            types.Vector2(nothing, side),
        ),
    )


def _channels(at: FootprintBsdf, light: Any) -> list[Any]:
    """f·cos without sheen; if the model separates albedos, then the channels and the light visibility."""
    if not isinstance(at, SeparableBsdf):
        return list(at.value(light))
    parts = at.components(light)
    colour = shade(parts, at.albedos_towards(light), light.z * at.view.z < 0)
    return [*colour, *(getattr(parts, name) for name in COMPONENTS), at.hole, parts.light_visibility]


def _numbers(value: Any, count: int) -> NDArray[np.float64]:
    """A Dr.Jit Float of width 1 or `count` as a NumPy array of `count`."""
    return np.broadcast_to(np.asarray(value.numpy(), np.float64), (count,))


def _rate(types: ArrayTypes, model: Model, queries: QuerySet) -> float:
    """Queries of `value` a second, compiled beforehand."""
    repeats = -(-_TIMED // queries.sizes.size)
    light, view, footprint = _arrays(types, queries, np.tile(np.arange(queries.sizes.size), repeats)[:_TIMED])
    dr.eval(light, view, footprint)
    seconds = []
    for _ in range(3):
        start = time.perf_counter()
        dr.eval(model.at(view, footprint).value(light))
        dr.sync_thread()
        seconds.append(time.perf_counter() - start)
    return _TIMED / min(seconds)
