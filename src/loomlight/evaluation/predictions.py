"""Predictions of models, and of a few Monte Carlo samples, for a query set."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol, runtime_checkable

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.aggregate.components import (
    CHANNELS,
    COLOURS,
    COMPONENTS,
    colours,
    components,
    light_visibility,
    trace_views,
    without_sheen_and_variation,
)
from loomlight.aggregate.queries import QuerySet
from loomlight.core.backend import ArrayTypes, array_types
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import llvm_float
from loomlight.fabric.fabric import Fabric
from loomlight.models.interface import FootprintBsdf, Model
from loomlight.models.separable import SeparableBsdf, shade
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry

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
    s, t = (types.Float(part.astype(np.float32)) for part in (positions - 0.5).reshape(-1, 2).T.copy())
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
        types.Vector3(np.ascontiguousarray(vectors[number].T, dtype=np.float32))
        for vectors, number in (
            (queries.lights, queries.pairs[pair, 0]),
            (queries.views, queries.pairs[pair, 1]),
        )
    )
    centre = queries.centres.reshape(-1, 2)[index].T
    side = types.Float(queries.sizes.ravel()[index].astype(np.float32))
    nothing = dr.zeros(types.Float)
    return (
        light,
        view,
        Footprint(
            types.Vector2(np.ascontiguousarray(centre, dtype=np.float32)),
            types.Vector2(side, nothing),
            types.Vector2(nothing, side),
        ),
    )


def _channels(at: FootprintBsdf, light: Any) -> list[Any]:
    """f·cos without sheen; if the model separates albedos, then the channels and the light visibility."""
    if not isinstance(at, SeparableBsdf):
        return list(at.value(light))
    parts = at.components(light)
    colour = shade(parts, at.albedos, light.z * at.view.z < 0)
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
