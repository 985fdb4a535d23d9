"""Fits the correlation of visibility from light and view within groups: κ of `models/lobes/prefiltered.py`.

    python -m tools.fits.lobes_shadows [--fabrics 40] [--output tools/fits/results/lobes_shadows.json]

For random fabrics (from the training distribution of `woven`, with another seed) and random pairs of
directions, rays give the components over a whole repeat; groups give a + κ b, a for independent visibility, b
for what full correlation adds. For diffuse and specular terms, in reflection and transmission, this prints
nMAE and bias without correlation and with the shipped one, and the least-squares fit of κ = k₀ + k₁ cos Δφ,
alone and after a common factor; each fabric's mean is scaled to 1.
"""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from drjit.llvm.ad import Float, UInt32
from numpy.typing import NDArray

from benchmarks.harness import Figures, run
from loomlight.aggregate.components import lobes
from loomlight.core.backend import array_types
from loomlight.core.llvm import require_llvm
from loomlight.fabric.fabric import Fabric
from loomlight.models.lobes.model import LobesModel
from loomlight.models.lobes.reference import (
    LobesReference,
    Parallelogram,
    direction_nodes,
    half_vector,
    layer_value,
    on_seen_face,
    shadow_correlation,
)
from loomlight.models.woven.training.config import DataTable
from loomlight.models.woven.training.dataset import dataset_fabric
from loomlight.scattering.point import PointModel
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.search import SearchQuality

PAIRS, POINTS, SEED = 400, 4096, 77
TERMS = "diffuse", "specular"
SIDES = "reflection", "transmission"
_QUALITY = SearchQuality(10, 10)
_GRAZING = 0.1
_PER_BYTE = 1 / 255

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Pairs:
    """Components of one fabric for pairs of directions.

    Attributes:
        truth: from rays [2 terms, pairs].
        independent: of each group, with independent visibility [2, pairs, groups].
        full_gain: 1/max(V_l, V_v) − 1 of each group, the factor of κ [pairs, groups].
        cosine: of the angle between azimuths [pairs, 1].
        shipped: κ as the model has it [2, pairs, 1].
    """

    truth: Floats
    independent: Floats
    full_gain: Floats
    cosine: Floats
    shipped: Floats

    def sums(self, term: int, gain: Any = 1.0) -> Floats:
        """Over groups [pairs]."""
        return np.asarray((self.independent[term] * gain).sum(axis=1))


def directions(rng: np.random.Generator) -> Floats:
    """Unit vectors [PAIRS, 3], the second half of them below the cloth."""
    z = rng.uniform(_GRAZING, 1, PAIRS)
    azimuth = rng.uniform(0, 2 * np.pi, PAIRS)
    radius = np.sqrt(1 - z**2)
    z[PAIRS // 2 :] *= -1
    return np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), z], axis=1)


def truth(fabric: Fabric, lights: Floats, views: Floats) -> Floats:
    """Diffuse and specular means over a repeat [2, pairs], 1/sr."""
    model = PointModel(YarnGeometry(fabric.layout()), fabric.appearance(), _QUALITY)
    lane = dr.arange(UInt32, PAIRS * POINTS)
    pair = lane // POINTS
    number = np.arange(POINTS)
    # Even over the square (Roberts 2018).
    turns = [number * share % 1 for share in (0.7548776662466927, 0.5698402909980532)]
    x, y = (
        dr.gather(Float, Float((turn * side).astype(np.float32)), lane - pair * POINTS)
        for turn, side in zip(turns, fabric.layout().size, strict=True)
    )

    def spread(vectors: Floats) -> Any:
        parts = (Float(np.ascontiguousarray(part, dtype=np.float32)) for part in vectors.T)
        return array_types(Float).Vector3(*(dr.gather(Float, part, pair) for part in parts))

    light, view = spread(lights), spread(views)
    point = model.locate(x, y, view)
    lit = model.visibility(point, light) & ~point.hole
    terms = [dr.select(lit, term, 0) for term in lobes(model.appearance, point, light, view)]
    return np.stack([term.numpy().reshape(PAIRS, POINTS).mean(axis=1) for term in terms])


def measured(fabric: Fabric, is_transmission: bool, seed: int) -> Pairs:
    """Random pairs on one side of the cloth, or through it."""
    rng = np.random.default_rng(seed)
    views, lights = directions(rng), directions(rng)
    if is_transmission:
        lights[:, 2] *= -1
    tables = LobesModel.for_source(fabric).tables
    appearance, size = fabric.appearance(), fabric.layout().size
    roughness = appearance.warp.roughness, appearance.weft.roughness
    reference = LobesReference(tables, size, roughness, appearance.optical_depth, appearance.diffuse_blend)
    # So large that the whole repeat counts alike.
    everything = Parallelogram(np.zeros(2), np.array([100 * size[0], 0]), np.array([0, 100 * size[1]]))
    independent, full_gain, cosine, shipped = [], [], [], []
    for given_light, given_view in zip(lights, views, strict=True):
        back, light, view = on_seen_face(given_light, given_view)
        groups, weights = reference.groups(back), reference.weights(view, everything, back)
        nodes, side = direction_nodes(light), (int(back), int(is_transmission))
        irradiance = nodes.of(tables.irradiance[side]) * _PER_BYTE
        visibility = nodes.of(tables.light_visibility[side]) * _PER_BYTE
        fractions = weights.groups / weights.groups.sum() * (1 - weights.hole)
        value = layer_value(half_vector(light, view), light, view, groups, appearance.optical_depth)
        independent.append([fractions * irradiance / np.pi, fractions * visibility * value])
        full_gain.append(1 / np.maximum(np.maximum(visibility, weights.view_visibility), _PER_BYTE) - 1)
        lengths = float(np.linalg.norm(light[:2]) * np.linalg.norm(view[:2]))
        cosine.append([float(light[:2] @ view[:2]) / max(lengths, 1e-6)])
        shipped.append(shadow_correlation(light, view, is_transmission))
    return Pairs(
        truth(fabric, lights, views),
        np.array(independent).swapaxes(0, 1),
        np.array(full_gain),
        np.array(cosine),
        np.array(shipped).T[..., None],
    )


def fitted(all_pairs: list[Pairs], term: int, with_factor: bool) -> list[float]:
    """Least squares of a factor less one, if wanted, and of k₀ and k₁."""
    products, sums = 0.0, 0.0
    for pairs in all_pairs:
        terms = [pairs.full_gain, pairs.full_gain * pairs.cosine]
        if with_factor:
            terms.insert(0, np.ones_like(pairs.full_gain))
        scale = pairs.truth[term].mean()
        basis = np.stack([pairs.sums(term, way) for way in terms]) / scale
        residual = (pairs.truth[term] - pairs.sums(term)) / scale
        products, sums = products + basis @ basis.T, sums + basis @ residual
    return [round(float(number), 3) for number in np.linalg.solve(products, sums)]


def errors(all_pairs: list[Pairs], term: int, shipped: bool) -> dict[str, float]:
    """Means over fabrics of nMAE and bias."""
    rows = []
    for pairs in all_pairs:
        gain = np.maximum(1 + pairs.shipped[term] * pairs.full_gain, 0) if shipped else 1.0
        off, total = pairs.sums(term, gain) - pairs.truth[term], pairs.truth[term].sum()
        rows.append((np.abs(off).sum() / total, off.sum() / total))
    nmae, bias = np.mean(rows, axis=0)
    return {"nmae": round(float(nmae), 4), "bias": round(float(bias), 4)}


def add_options(parser: ArgumentParser) -> None:
    """How many fabrics."""
    parser.add_argument("--fabrics", type=int, default=40)


def measure(options: Namespace) -> Figures:
    """Errors and fits of each term on each side."""
    require_llvm()
    table = DataTable(seed=SEED)
    all_pairs: dict[str, list[Pairs]] = {side: [] for side in SIDES}
    for number in range(options.fabrics):
        fabric = dataset_fabric(table, number)
        for is_transmission, side in enumerate(SIDES):
            all_pairs[side].append(measured(fabric, bool(is_transmission), number))
    return {
        f"{term} {side}": {
            "independent": errors(all_pairs[side], number, shipped=False),
            "shipped": errors(all_pairs[side], number, shipped=True),
            "fit": fitted(all_pairs[side], number, with_factor=False),
            "fit_after_factor": fitted(all_pairs[side], number, with_factor=True),
        }
        for side in SIDES
        for number, term in enumerate(TERMS)
    }


if __name__ == "__main__":
    run(measure, add_options)
