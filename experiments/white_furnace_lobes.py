"""White furnace of `lobes` over all parameter ranges: does any footprint return more light than it receives?

    python -m experiments.white_furnace_lobes [--fabrics N] [--seed N] [--output FILE.json]

Fabrics are those of `experiments.white_furnace`: warp and weft differ in everything, threads are white or use
the energy bound up, gaps reach 0.95. Footprints lie anywhere on both faces, their sides are from 1/100 of a
thread to four repeats, views are from everywhere, grazing ones among them, shadows included. The albedo of a
footprint is the mean weight of the model's sampler, light through holes included. The brightest ones of each
fabric are measured again with fresh random numbers, since of many estimates the largest is too large.
Footprints that are holes alone return exactly 1 and are left out. One fabric in ten has sheen and variation.
"""

from __future__ import annotations

import math
from argparse import ArgumentParser, Namespace
from dataclasses import dataclass, fields, replace

import drjit as dr
import numpy as np
from drjit.llvm.ad import Array2f, Array3f, Float, UInt32
from numpy.typing import NDArray

from benchmarks.harness import Figures, run
from experiments.white_furnace import directions, fabric
from loomlight.aggregate.footprint_albedos import FootprintAlbedos
from loomlight.core.backend import array_types
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.models.lobes.bsdf import LobesBsdf
from loomlight.models.lobes.model import DEFAULT_GROUPS
from loomlight.models.lobes.prefiltered import PrefilteredLobes
from loomlight.models.lobes.regimes import RegimeScale
from loomlight.models.lobes.tables import bake_tables
from loomlight.scattering.appearance import Appearance, Sheen, Variation
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry

FOOTPRINTS, SAMPLES, BRIGHTEST, AGAIN = 64, 1024, 4, 1 << 16
MIN, MAX = 0.01, 4.0
BAR, SIGMAS = 1.01, 4.0
# One fabric in so many has sheen, variation and any blend of the diffuse term, others one of three blends.
EVERYTHING, BLENDS = 10, 2
# A footprint with so large a hole says nothing of yarn.
_HOLE = 0.999


class LobesOfCloth:
    """The model of a geometry and an appearance that no fabric file needs to describe."""

    def __init__(self, geometry: YarnGeometry, appearance: Appearance) -> None:
        types = array_types(Float)
        tables = bake_tables(geometry, appearance.diffuse_blend, DEFAULT_GROUPS, Float)
        roughness = appearance.warp.roughness, appearance.weft.roughness
        self._lobes = PrefilteredLobes(tables, geometry.size, roughness, appearance.optical_depth, types)
        self._scale = RegimeScale(geometry.layout, tables.base_size, types)
        self._points = YarnScattering(geometry, appearance)
        self._means = FootprintAlbedos(geometry, appearance)

    def at(self, view: Array3f, footprint: Footprint) -> LobesBsdf:
        """The BSDF of footprints for one view each."""
        regime = self._scale.of(footprint)
        return LobesBsdf(self._lobes, self._points, self._means, regime, view, footprint, None)


@dataclass(frozen=True, eq=False)
class Queries:
    """n footprints and their views.

    Attributes:
        views: unit vectors [n, 3].
        centres: [n, 2], millimetres.
        edges: both edges of each parallelogram [n, 2, 2], millimetres.
    """

    views: NDArray[np.float64]
    centres: NDArray[np.float64]
    edges: NDArray[np.float64]

    def __getitem__(self, chosen: NDArray[np.intp]) -> Queries:
        return Queries(*(getattr(self, part.name)[chosen] for part in fields(self)))


def queries(rng: np.random.Generator, geometry: YarnGeometry) -> Queries:
    """Random footprints of a fabric: parallelograms up to three times as long as wide."""
    extent = np.asarray(geometry.size)
    picks, ends = geometry.layout.warp_on_top.shape
    thread = math.sqrt(extent[0] / ends * extent[1] / picks)
    sizes = np.exp(rng.uniform(np.log(MIN * thread), np.log(MAX * extent.max()), FOOTPRINTS))
    angles = rng.uniform(0, 2 * np.pi, FOOTPRINTS)[:, None] + [0, 1] * rng.uniform(1, 2, (FOOTPRINTS, 1))
    lengths = sizes[:, None] * np.stack([rng.uniform(1, 3, FOOTPRINTS), np.ones(FOOTPRINTS)], axis=1)
    edges = lengths[..., None] * np.stack([np.cos(angles), np.sin(angles)], axis=2)
    views = directions(rng, FOOTPRINTS).T.astype(np.float64)
    return Queries(views, rng.random((FOOTPRINTS, 2)) * extent, edges)


def albedos(
    cloth: LobesOfCloth, asked: Queries, samples: int, rng: np.random.Generator
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Mean weight of the brightest channel, its standard error, and the hole [n]."""
    count = len(asked.views)
    lane = dr.arange(UInt32, count * samples) // samples
    view = Array3f(*_spread(asked.views, lane))
    places = (asked.centres, asked.edges[:, 0], asked.edges[:, 1])
    at = cloth.at(view, Footprint(*(Array2f(*_spread(part, lane)) for part in places)))
    numbers = [Float(rng.random(count * samples, dtype=np.float32)) for _ in range(3)]
    drawn = at.sample(numbers[0], Array2f(numbers[1], numbers[2]))
    dr.eval(drawn.weight, at.hole)
    weight = drawn.weight.numpy().astype(np.float64).reshape(3, count, samples)
    if not np.isfinite(weight).all():
        raise ArithmeticError("a weight is not finite")
    mean, error = weight.mean(axis=2), weight.std(axis=2) / math.sqrt(samples)
    channel = mean.argmax(axis=0)[None]
    hole = at.hole.numpy().reshape(count, samples)[:, 0]
    return *(np.take_along_axis(part, channel, 0)[0] for part in (mean, error)), hole


def _spread(rows: NDArray[np.float64], lane: UInt32) -> list[Float]:
    """The columns of vectors [n, k], one row for each lane."""
    return [dr.gather(Float, Float(np.ascontiguousarray(column, np.float32)), lane) for column in rows.T]


def furnace(seed: int, number: int) -> dict[str, float]:
    """The largest albedo of fabric `number`, measured again; and the mean of all of its footprints."""
    rng = np.random.default_rng([seed, number])
    geometry, appearance = fabric(rng)
    if number % EVERYTHING:
        # These numbers are literals of kernels, which take seconds to compile.
        blend = round(BLENDS * appearance.diffuse_blend) / BLENDS
        appearance = replace(appearance, sheen=Sheen(), variation=Variation(), diffuse_blend=blend)
    cloth, asked = LobesOfCloth(geometry, appearance), queries(rng, geometry)
    mean, _, hole = albedos(cloth, asked, SAMPLES, rng)
    brightest = np.argsort(np.where(hole < _HOLE, -mean, 0))[:BRIGHTEST]
    again, error, _ = albedos(cloth, asked[brightest], AGAIN, rng)
    worst = int(np.argmax(again - SIGMAS * error))
    edges = asked.edges[brightest[worst]]
    return {
        "number": number,
        "albedo": float(again[worst]),
        "error": float(error[worst]),
        "hole": float(hole[brightest[worst]]),
        "side_mm": float(np.sqrt(0.5 * (edges**2).sum())),
        "view_z": float(asked.views[brightest[worst], 2]),
        "mean_albedo": float(mean.mean()),
    }


def add_options(parser: ArgumentParser) -> None:
    """How many fabrics, and which."""
    parser.add_argument("--fabrics", type=int, default=200)
    parser.add_argument("--seed", type=int, default=0)


def measure(options: Namespace) -> Figures:
    """The largest albedos, and the fabrics above the bar."""
    require_llvm()
    rows = [furnace(options.seed, number) for number in range(options.fabrics)]
    above = [row for row in rows if row["albedo"] - SIGMAS * row["error"] > BAR]
    return {
        "seed": options.seed,
        "fabrics": len(rows),
        "footprints": f"{FOOTPRINTS} a fabric, {SAMPLES} samples each; {BRIGHTEST} again with {AGAIN}",
        "bar": f"{BAR} + {SIGMAS} standard errors",
        "largest": sorted(rows, key=lambda row: -row["albedo"])[:10],
        "above": above,
        "mean_albedo": float(np.mean([row["mean_albedo"] for row in rows])),
        "missed": [f"fabric {row['number']}" for row in above],
    }


if __name__ == "__main__":
    run(measure, add_options)
