"""White furnace over all parameter ranges: does a point of any admitted fabric return more than it receives?

Each fabric is drawn at random from everything that a fabric file admits, limits included; warp and weft
differ in all of it, threads are white or use the energy bound up. Places all over both faces are lit from
everywhere and seen from directions of their own, grazing ones among them; the albedo is the mean weight of
the model's sampler. Shadows only take light away: they are left out, so the bound that is tested is stronger.
The brightest yarn point of each fabric is measured again with fresh numbers, since of many estimates the
largest is too large. (Holes without sheen return exactly 1 and would always win.)
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from drjit.llvm import Array2f, Array3f, Bool, Float, UInt32
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Cell, Table
from loomlight.scattering.albedo import (
    Albedos,
    LayerBound,
    albedos_from_colour,
    check_albedos,
    layer_albedo_bound,
)
from loomlight.scattering.appearance import Appearance, FamilyAppearance, Sheen, Variation
from loomlight.scattering.fibre import cloth_layer_bound
from loomlight.scattering.point import YarnPoint, YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout, FamilyLayout
from studies.harness.study import Figures, Found, Run, Study

POSITIONS, SAMPLES = 96, 2048
# Largest of some 10⁶ normal deviations, and rounding of float32.
SIGMAS, ROUNDING = 5.5, 1e-4

Generator = np.random.Generator


class Unshadowed(YarnScattering):
    """The point model with every yarn point in the open."""

    def visibility(self, point: YarnPoint, light: Any, active: Any = True) -> Any:
        return Bool(active) | True


def within(rng: Generator, low: float, high: float, logarithmic: bool = False) -> float:
    """A number of the range; one in six is a limit."""
    if rng.random() < 1 / 6:
        return low if rng.random() < 0.5 else high
    if logarithmic:
        return float(np.exp(rng.uniform(math.log(low), math.log(high))))
    return float(rng.uniform(low, high))


def family_layout(rng: Generator, count: int) -> FamilyLayout:
    """One family; its threads are alike or all different."""
    alike = rng.random() < 0.5
    spacing = within(rng, 0.01, 10, True) * (np.ones(count) if alike else rng.uniform(0.2, 1, count))
    gap = within(rng, 0.02, 0.95) if alike else rng.uniform(0.02, 0.95, count)
    return FamilyLayout(
        spacing,
        spacing * (1 - gap),
        math.radians(within(rng, 0, 80)),
        math.radians(within(rng, -89, 89)),
        within(rng, 0.01, 2, True),
    )


def family_appearance(rng: Generator, count: int, depth: float, between_yarns: bool) -> FamilyAppearance:
    """White threads, or explicit albedos that use the energy bound up; as a fabric file admits them."""
    rows = (count, 3) if rng.random() < 0.5 else (1, 3)
    kind = rng.integers(3)
    if kind == 0:
        strength, translucency = within(rng, 0, 1), within(rng, 0, 1)
    else:
        maximum = np.ones(rows) if rng.random() < 0.2 else rng.random(rows)
        minimum = maximum * within(rng, 0, 1)
        fraction = within(rng, 0, 1)
    roughness = within(rng, 0.01, 1, True)
    bound = LayerBound(layer_albedo_bound(depth))
    if between_yarns:
        bound = cloth_layer_bound(roughness, depth)
    if kind == 0:
        albedos = albedos_from_colour(np.ones((count, 3)), strength, translucency, depth, bound)
    else:
        diffuse = 1 - bound.taken(maximum, minimum)
        values = (
            diffuse * fraction,
            diffuse * (1 - fraction),
            *((maximum, minimum) if kind == 1 else (minimum, maximum)),
        )
        albedos = Albedos(*(np.broadcast_to(value, (count, 3)).copy() for value in values))
    check_albedos(albedos, "warp or weft", depth, bound)
    return FamilyAppearance(**albedos._asdict(), roughness=roughness)


def fabric(rng: Generator, between_yarns: bool = False) -> tuple[YarnGeometry, Appearance]:
    """A random fabric of all parameter ranges, within the energy bound."""
    while True:
        picks, ends = (int(number) for number in rng.integers(1, 13, 2))
        drawdown = rng.random((picks, ends)) < rng.uniform(0.1, 0.9)
        try:
            geometry = YarnGeometry(
                ClothLayout(drawdown, family_layout(rng, ends), family_layout(rng, picks))
            )
        except InputError:  # threads too uneven; the box ends there
            continue
        break
    depth = within(rng, 0.01, 100, True)
    appearance = Appearance(
        family_appearance(rng, ends, depth, between_yarns),
        family_appearance(rng, picks, depth, between_yarns),
        sheen=Sheen(within(rng, 0, 1), within(rng, 0, 1)) if rng.random() < 0.6 else Sheen(),
        variation=Variation(within(rng, 0, 1), within(rng, 0, 1), int(rng.integers(2**32)))
        if rng.random() < 0.5
        else Variation(),
        diffuse_blend=within(rng, 0, 1),
        optical_depth=depth,
    )
    return geometry, appearance


def directions(rng: Generator, count: int) -> NDArray[np.float32]:
    """Unit vectors [3, count] on both sides; a third of them grazing, down to a cosine of 10⁻⁴."""
    cosine = rng.uniform(1e-3, 1, count)
    grazing = rng.random(count) < 1 / 3
    cosine[grazing] = 10 ** rng.uniform(-4, -1, int(grazing.sum()))
    cosine *= rng.choice([-1, 1], count)
    azimuth = rng.uniform(0, 2 * math.pi, count)
    sine = np.sqrt(1 - cosine**2)
    return np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), cosine]).astype(np.float32)


def albedos(
    model: Unshadowed, positions: NDArray[np.float64], views: NDArray[np.float32], each: int, rng: Generator
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.bool_]]:
    """Mean weight and standard error [3, n] at `positions` [2, n] (mm) from `views` [3, n]; holes [n]."""
    count = positions.shape[1]
    index = dr.repeat(dr.arange(UInt32, count), each)
    x, y = (dr.gather(Float, Float(row.astype(np.float32)), index) for row in positions)
    view = Array3f(*(dr.gather(Float, Float(row), index) for row in views))
    back = view.z < 0
    _, hole = model.surface.height(x, y, back)
    numbers = [Float(rng.random(count * each, dtype=np.float32)) for _ in range(3)]
    dr.eval(x, y, view, numbers)
    point = model.at(x, y, back, hole)
    drawn = model.sample(point, view, numbers[0], Array2f(numbers[1], numbers[2]))
    weight = drawn.weight.numpy().astype(np.float64).reshape(3, count, each)
    if not np.isfinite(weight).all():
        raise ArithmeticError("a weight is not finite")
    return weight.mean(axis=2), weight.std(axis=2) / math.sqrt(each), hole.numpy()[::each]


def measured(seed: int, number: int, samples: int) -> dict[str, float]:
    """The largest albedo of fabric `number`, its error, and both measured again where it is largest."""
    rng = np.random.default_rng([seed, number])
    model = Unshadowed(*fabric(rng))
    positions = rng.uniform(0, 1, (2, POSITIONS)) * np.array(model.surface.size)[:, None]
    views = directions(rng, POSITIONS)
    mean, error, hole = albedos(model, positions, views, SAMPLES, rng)
    brightest = int(np.argmax(np.where(hole, 0, mean.max(axis=0))))
    again, its_error, _ = albedos(model, positions[:, [brightest]], views[:, [brightest]], samples, rng)
    channel = int(np.argmax(again[:, 0]))
    excess = (mean - 1 - ROUNDING) / np.maximum(error, 1e-12)
    return {
        "number": number,
        "albedo": float(again[channel, 0]),
        "error": float(its_error[channel, 0]),
        "largest_excess_in_errors": float(np.where(mean > 1 + ROUNDING, excess, -np.inf).max(initial=-1e9)),
        "mean_albedo": float(mean.mean()),
    }


@dataclass(frozen=True)
class WhiteFurnace(Settings):
    fabrics: int = setting(1200, "Random fabrics.", low=1)
    seed: int = setting(0, "Of the fabrics.", low=0)
    again: int = setting(1 << 19, "Samples of each fabric's brightest place.", low=1)


def measure(settings: WhiteFurnace, run: Run) -> Found:
    """The largest albedos, and those above the bar."""
    require_llvm()
    rows = [measured(settings.seed, number, settings.again) for number in range(settings.fabrics)]
    above = [row for row in rows if max(_excess(row), row["largest_excess_in_errors"]) > SIGMAS]
    return Found(
        {
            "seed": settings.seed,
            "places": (
                f"{POSITIONS} a fabric, {SAMPLES} samples each; the brightest again with {settings.again}"
            ),
            "bar": f"none above 1 + {SIGMAS} standard errors + {ROUNDING}",
            "fabrics": len(rows),
            "above": above,
            "largest": max(rows, key=lambda row: row["albedo"]),
            "closest_to_the_bar": max(rows, key=lambda row: row["largest_excess_in_errors"]),
            "mean_albedo": float(np.mean([row["mean_albedo"] for row in rows])),
        }
    )


def _excess(row: dict[str, float]) -> float:
    """By how many errors the brightest place, measured again, exceeds 1."""
    return (row["albedo"] - 1 - ROUNDING) / max(row["error"], 1e-12)


def tables(figures: Figures) -> list[Table]:
    """The largest albedo, and the place that is the most errors above 1."""
    rows: dict[str, list[Cell]] = {}
    for name, key in (("largest albedo", "largest"), ("closest to the bar", "closest_to_the_bar")):
        found = figures[key]
        above = found["largest_excess_in_errors"]
        rows[name] = [found["albedo"], found["error"], above if above > 0 else None]
    note = f"{figures['fabrics']} fabrics, {len(figures['above'])} above the bar: {figures['bar']}."
    columns = ["albedo", "error", "errors above 1"]
    return [Table("Albedos of random fabrics", columns, rows, note, digits=5)]


STUDY = Study(
    "accuracy/white_furnace",
    "white furnace over all that a fabric file admits: the largest albedo of a point",
    WhiteFurnace(),
    measure,
    tables,
    stands_on=("point",),
    small={"fabrics": 2, "again": 1 << 12},
)
