"""Is a model's mean the Monte Carlo footprint reference's? z-tests over random cases, with Holm's correction.

A case is a fabric (of the 24 held-out ones), a light, a view and a parallelogram of a quarter thread to
four repeats, up to three times as long as wide. Reflection and transmission, both faces. The reference
draws uniform points in the parallelogram and follows each view and shadow ray exactly
(`reference.py`). They may be rectangles along the threads. Of models
that estimate a surface of their own, as `clustered`, the means are others.

Models may draw points themselves, by numbers that they make of what they are asked. Moving a footprint by
whole repeats leaves its integral as it is, changing its edges by a hundred-thousandth as good as does, and
both change what is drawn: a model's mean and its variance are taken over such footprints; of a
deterministic model the variance is that of rounding. Models that do not filter are asked about random
points of the footprint, as a renderer does. z is the difference over the standard error of both. Colours
(red, green, blue) are three tests a case. Holm's procedure keeps the chance of any false alarm below 0.01,
whatever depends on what; a model that fails it is biased. The relative bias over all cases tells by how
much.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from statistics import NormalDist

import drjit as dr
import numpy as np
from drjit.llvm.ad import Array2f, Array3f, Float, UInt32
from numpy.typing import NDArray

from loomlight.aggregate.queries import admits_transmission, fabric_scale
from loomlight.core.errors import InputError
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.query_benchmark import reference_model
from loomlight.evaluation.table import Cell, Table
from loomlight.fabric.fabric import Fabric
from loomlight.models.interface import Model
from loomlight.models.registry import MODELS, make_model, parse_options
from studies.harness.study import Figures, Found, Run, Study, listed, names
from studies.instruments.directions import above
from studies.instruments.held_out import held_out_fabrics
from studies.instruments.reference import reference

SIGNIFICANCE = 0.01
_FABRICS = 24
# Footprints are moved by up to so many repeats each way: more cost digits of single precision.
_SHIFTS = 16
# Edges of footprints are changed by up to so much of themselves.
_SCALES = 1e-5
_MIN, _MAX, _MAX_RATIO = 0.25, 4.0, 3.0
_MIN_COSINE = 0.1
# Of the reference: searches of rays and rounding move means by about so much (docs/research/aggregation.md).
_ROUNDING = 1e-4

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Cases:
    """n cases of one fabric.

    Attributes:
        lights, views: unit vectors [n, 3].
        centres: of the parallelograms [n, 2], millimetres.
        edges: both edges of each [n, 2, 2], millimetres.
    """

    lights: Array
    views: Array
    centres: Array
    edges: Array


@dataclass(frozen=True, eq=False)
class Means:
    """Means over footprints and the variances of these means [n, 3]."""

    mean: Array
    variance: Array


def random_cases(fabric: Fabric, count: int, seed: int, aligned: bool = False) -> Cases:
    """Random directions and parallelograms; light and view lie on both sides, if threads transmit light.

    Args:
        aligned: edges lie along the threads.
    """
    rng = np.random.default_rng(seed)
    scale = fabric_scale(fabric.layout())
    views = above(rng, count, _MIN_COSINE).T * np.where(rng.random(count) < 0.5, -1, 1)[:, None] ** [
        [0, 0, 1]
    ]
    lights = above(rng, count, _MIN_COSINE).T
    side = np.sign(views[:, 2])
    if admits_transmission(fabric.appearance()):
        side = side * np.where(rng.random(count) < 0.5, -1, 1)
    lights[:, 2] *= side
    sizes = np.exp(rng.uniform(np.log(_MIN * scale.thread), np.log(_MAX * scale.repeat), count))
    first = rng.uniform(0, 2 * np.pi, count)
    second = first + rng.uniform(1, 2, count)
    if aligned:
        first = np.round(first / (np.pi / 2)) * (np.pi / 2)
        second = first + np.pi / 2
    angles = np.stack([first, second], axis=1)
    lengths = sizes[:, None] * np.stack([rng.uniform(1, _MAX_RATIO, count), np.ones(count)], axis=1)
    edges = lengths[..., None] * np.stack([np.cos(angles), np.sin(angles)], axis=2)
    return Cases(lights, views, rng.random((count, 2)) * scale.extent, edges)


def reference_means(fabric: Fabric, cases: Cases, samples: int, seed: int) -> Means:
    """The Monte Carlo reference of each case."""
    places = (cases.centres, cases.edges[:, 0], cases.edges[:, 1])
    footprint = Footprint(*(Array2f(_columns(part)) for part in places))
    found = reference(reference_model(fabric), footprint, cases.lights, cases.views, samples, seed)
    first = found.channels.index("red")
    return Means(found.colour, found.variance[:, first : first + 3])


def model_means(model: Model, cases: Cases, repeats: int, seed: int) -> Means:
    """The mean of a model over footprints that are moved by whole repeats of its source."""
    rng = np.random.default_rng(seed)
    count = len(cases.lights)
    lane = dr.arange(UInt32, count * repeats) // repeats
    moves = rng.integers(-_SHIFTS, _SHIFTS + 1, (count * repeats, 2)) * np.asarray(model.source.repeat_mm)
    centres = np.repeat(cases.centres, repeats, axis=0) + moves
    view, light = (dr.gather(Array3f, Array3f(_columns(part)), lane) for part in (cases.views, cases.lights))
    scales = 1 + _SCALES * rng.uniform(-1, 1, (count * repeats, 1))
    edges = [Array2f(_columns(np.repeat(cases.edges[:, k], repeats, axis=0) * scales)) for k in (0, 1)]
    if not model.filters:
        places = rng.uniform(-0.5, 0.5, (count * repeats, 2))
        centres = centres + np.einsum("nk,nkd->nd", places, np.repeat(cases.edges, repeats, axis=0))
    value = model.at(view, Footprint(Array2f(_columns(centres)), *edges)).value(light)
    dr.eval(value)
    samples = np.stack([_numbers(part, count * repeats) for part in value], axis=1)
    samples = samples.reshape(count, repeats, 3)
    return Means(samples.mean(axis=1), samples.var(axis=1, ddof=1) / repeats)


def _numbers(value: Float, count: int) -> Array:
    return np.broadcast_to(np.asarray(value.numpy(), np.float64), (count,))


def _columns(rows: Array) -> NDArray[np.float32]:
    return np.ascontiguousarray(rows.T, np.float32)


def scores(found: Means, truth: Means) -> Array:
    """z of every case and colour [n, 3]; rounding is an error of its own."""
    rounding = (_ROUNDING * np.abs(truth.mean)) ** 2 + 1e-14
    return (found.mean - truth.mean) / np.sqrt(found.variance + truth.variance + rounding)


def holm(z: Array, significance: float) -> int:
    """Number of hypotheses that Holm's step-down procedure rejects, two-sided."""
    normal = NormalDist()
    p = np.sort([2 * normal.cdf(-abs(float(value))) for value in z.ravel()])
    bounds = significance / (len(p) - np.arange(len(p)))
    kept = np.flatnonzero(p > bounds)
    return int(kept[0]) if len(kept) else len(p)


def tested(name: str, made: list[tuple[Fabric, Cases, Means]], settings: Unbiased) -> Figures:
    """The tests of one model over all fabrics."""
    found, truths, refused, names = [], [], [], []
    for number, (fabric, cases, truth) in enumerate(made):
        try:
            model = make_model(name, fabric, parse_options(name, listed(settings.options)))
        except InputError as fault:
            refused.append(str(fault))
            continue
        found.append(model_means(model, cases, settings.repeats, settings.seed + number))
        truths.append(truth)
        names += [fabric.name] * len(cases.lights)
    means, truth = (
        Means(*(np.concatenate([getattr(part, field) for part in parts]) for field in ("mean", "variance")))
        for parts in (found, truths)
    )
    z = scores(means, truth)
    difference = means.mean - truth.mean
    # Of the sum of differences, not of each: what is left of noise shows how small a bias could be seen.
    error = math.sqrt(float((means.variance + truth.variance).sum()))
    total = float(truth.mean.sum())
    expected = math.sqrt(2 * math.log(z.size))
    return {
        "cases": len(z),
        "tests": z.size,
        "rejected": holm(z, SIGNIFICANCE),
        "largest_z": float(np.abs(z).max()),
        "largest_z_expected": round(expected, 2),
        "mean_z_squared": float((z**2).mean()),
        "relative_bias": float(difference.sum() / total),
        "relative_bias_error": error / total,
        "mean_absolute_difference": float(np.abs(difference).sum() / total),
        "mse": float((difference**2).mean()),
        "mse_of_noise": float((means.variance + truth.variance).mean()),
        "refused": refused,
        "fabrics": names,
        "z": z.round(3).tolist(),
    }


@dataclass(frozen=True)
class Unbiased(Settings):
    models: str = names("samples", "Models.", tuple(MODELS))
    options: str = setting("", 'Of these models, such as "points=4096".')
    cases: int = setting(72, "Random cases.", low=1)
    samples: int = setting(1 << 16, "Of the reference, a footprint.", low=2)
    repeats: int = setting(256, "Footprints of a case, a repeat apart.", low=2)
    seed: int = setting(0, "Of the cases.", low=0)
    aligned: bool = setting(False, "Footprints are rectangles along the threads.")


def measure(settings: Unbiased, run: Run) -> Found:
    """Every model against the same references."""
    require_llvm()
    fabrics = held_out_fabrics(min(_FABRICS, settings.cases))
    each = -(-settings.cases // len(fabrics))
    made = []
    for number, held in enumerate(fabrics):
        cases = random_cases(held.fabric, each, settings.seed * 1000 + number, settings.aligned)
        truth = reference_means(held.fabric, cases, settings.samples, settings.seed * 1000 + 500 + number)
        made.append((held.fabric, cases, truth))
        run.report(number + 1, len(fabrics))
    results = {name: tested(name, made, settings) for name in listed(settings.models)}
    return Found(
        {
            "reference_samples": settings.samples,
            "footprints_a_case": settings.repeats,
            "options": settings.options,
            "aligned": settings.aligned,
            "significance": SIGNIFICANCE,
            "correction": "Holm",
            "models": results,
            # Biased models are shown to compare with; only those that claim none are held to it.
            "biased": [name for name, result in results.items() if result["rejected"]],
        }
    )


def tables(figures: Figures) -> list[Table]:
    """Tests and bias by model."""
    keys = ("cases", "tests", "rejected", "largest_z", "largest_z_expected", "mean_z_squared")
    rows: dict[str, list[Cell]] = {
        f"`{name}`": [
            *(found[key] for key in keys),
            f"{found['relative_bias']:.4f} ± {found['relative_bias_error']:.4f}",
        ]
        for name, found in figures["models"].items()
    }
    columns = ["cases", "tests", "rejected", "largest z", "expected", "mean z²", "relative bias"]
    return [Table("z-tests against the footprint reference", columns, rows, "Holm's correction at 0.01.")]


STUDIES = (
    Study(
        "accuracy/unbiased",
        "is the mean of `samples` the Monte Carlo footprint reference's? z-tests over random cases",
        Unbiased(),
        measure,
        tables,
        stands_on=("samples", "point"),
        small={"cases": 2, "samples": 1 << 8, "repeats": 4},
    ),
    Study(
        "accuracy/unbiased_point",
        "the same of `point`, over rectangles along the threads",
        Unbiased(models="point", aligned=True, samples=1 << 14, repeats=1 << 13),
        measure,
        tables,
        stands_on=("point",),
        small={"cases": 2, "samples": 1 << 8, "repeats": 4},
    ),
)
