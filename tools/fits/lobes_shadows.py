"""Fits the correlation of visibility from light and view within groups: κ of `models/lobes/prefiltered.py`.

    python -m tools.fits.lobes_shadows [--output FILE.json]

For named weaves and irregular ones at the defaults of fabric files, irregular weaves with gaps to 0.6, and
fabrics from the training distribution of `neural`, rays give the components over a whole repeat for random
pairs of directions. Groups give a + κ b − c d: a for independent visibility, b for what full correlation
adds, d for 1 − V(light). For diffuse and specular terms, in reflection and transmission, this prints nMAE and
bias without correlation and with the shipped one, the bias of each fabric, and the fit of c and of
κ = min(k₀ + k₁ cos Δφ, 1.2), by least squares of which large residuals count less; each fabric's mean is 1.
"""

from __future__ import annotations

from argparse import Namespace
from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from drjit.llvm.ad import Float, UInt32
from numpy.typing import NDArray
from scipy.optimize import least_squares

from benchmarks.harness import Figures, run
from experiments.brightness import IRREGULAR_RANGES, irregular_draft
from loomlight.aggregate.components import lobes
from loomlight.core.backend import array_types
from loomlight.core.llvm import require_llvm
from loomlight.fabric.fabric import Fabric, make_fabric
from loomlight.fabric.file import FabricFile
from loomlight.models.lobes.model import LobesModel
from loomlight.models.lobes.prefiltered import DIFFUSE_LOSS, MAX_CORRELATION
from loomlight.scattering.point import YarnScattering
from loomlight.weave.named import named_weave
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.search import SearchQuality
from papers.chen2024.training.config import DataTable
from papers.chen2024.training.dataset import dataset_fabric
from papers.chen2024.training.random_fabrics import random_fabric
from tests.models.lobes.reference import (
    LobesReference,
    Parallelogram,
    direction_nodes,
    half_vector,
    layer_value,
    on_seen_face,
    shadow_correlation,
)

PAIRS, POINTS, SEED = 240, 2048, 77
WEAVES = "plain", "twill 2/1", "twill 2/2", "twill 3/1", "satin 5/2", "satin 8/3", "basket 2/2"
# Irregular weaves at the defaults, as many with gaps, and fabrics of the training distribution.
IRREGULAR, TRAINING = 3, 6
TERMS = "diffuse", "specular"
SIDES = "reflection", "transmission"
_QUALITY = SearchQuality(16, 16, refinements=4, steps=8192)
# Residual, in units of a fabric's mean, from which on residuals count less.
_LARGE_RESIDUAL = 0.05
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
        light: 1 − V_l of each group [pairs, groups].
        shipped: κ as the model has it [2, pairs, 1].
    """

    truth: Floats
    independent: Floats
    full_gain: Floats
    light: Floats
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
    model = YarnScattering(YarnGeometry(fabric.layout()), fabric.appearance(), _QUALITY)
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
    independent, full_gain, dark, cosine, shipped = [], [], [], [], []
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
        dark.append(1 - visibility)
        lengths = float(np.linalg.norm(light[:2]) * np.linalg.norm(view[:2]))
        cosine.append([float(light[:2] @ view[:2]) / max(lengths, 1e-6)])
        shipped.append(shadow_correlation(light, view, is_transmission))
    return Pairs(
        truth(fabric, lights, views),
        np.array(independent).swapaxes(0, 1),
        np.array(full_gain),
        np.array(dark),
        np.array(cosine),
        np.array(shipped).T[..., None],
    )


def gain(pairs: Pairs, numbers: Floats) -> Floats:
    """P(lit given seen)/V(light) of each group [pairs, groups] for k₀, k₁ and, if given, the loss."""
    kappa = np.minimum(numbers[0] + numbers[1] * pairs.cosine, MAX_CORRELATION)
    loss = numbers[2] if len(numbers) > 2 else 0.0
    return np.asarray(np.maximum(1 + kappa * pairs.full_gain - loss * pairs.light, 0))


def fitted(all_pairs: list[Pairs], term: int, with_loss: bool) -> list[float]:
    """k₀, k₁ and the loss, if wanted."""

    def residuals(numbers: Floats) -> Floats:
        rows = [(p.sums(term, gain(p, numbers)) - p.truth[term]) / p.truth[term].mean() for p in all_pairs]
        return np.concatenate(rows)

    start = np.array([0.5, 0.5, 0.3] if with_loss else [0.0, 0.0])
    found = least_squares(residuals, start, loss="soft_l1", f_scale=_LARGE_RESIDUAL)
    return [round(float(number), 3) for number in found.x]


def errors(all_pairs: list[Pairs], term: int, shipped: bool, loss: float) -> dict[str, Any]:
    """Means over fabrics of nMAE and bias, and the bias of each."""
    rows = []
    for pairs in all_pairs:
        of_groups: Any = 1.0
        if shipped:
            of_groups = np.maximum(1 + pairs.shipped[term] * pairs.full_gain - loss * pairs.light, 0)
        off, total = pairs.sums(term, of_groups) - pairs.truth[term], pairs.truth[term].sum()
        rows.append((np.abs(off).sum() / total, off.sum() / total))
    nmae, bias = np.mean(rows, axis=0)
    return {
        "nmae": round(float(nmae), 4),
        "bias": round(float(bias), 4),
        "bias_by_fabric": [round(float(row[1]), 4) for row in rows],
    }


def fabrics() -> dict[str, Fabric]:
    """What the fit is of."""
    cloths = {weave: make_fabric(FabricFile(), named_weave(weave), weave, ".") for weave in WEAVES}
    for seed in range(IRREGULAR):
        draft = irregular_draft(seed)
        cloths[f"irregular {seed}"] = make_fabric(FabricFile(), draft, "irregular", ".")
        rng = np.random.default_rng(seed)
        cloths[f"irregular with gaps {seed}"] = random_fabric(rng, draft, ranges=IRREGULAR_RANGES)
    table = DataTable(seed=SEED)
    return cloths | {f"training {number}": dataset_fabric(table, number) for number in range(TRAINING)}


def measure(_: Namespace) -> Figures:
    """Errors and fits of each term on each side."""
    require_llvm()
    cloths = fabrics()
    figures: Figures = {"fabrics": list(cloths)}
    for is_transmission, side in enumerate(SIDES):
        pairs = [
            measured(fabric, bool(is_transmission), number) for number, fabric in enumerate(cloths.values())
        ]
        for number, term in enumerate(TERMS):
            has_loss = term == "diffuse" and not is_transmission
            figures[f"{term} {side}"] = {
                "independent": errors(pairs, number, shipped=False, loss=0.0),
                "shipped": errors(pairs, number, shipped=True, loss=DIFFUSE_LOSS if has_loss else 0.0),
                "fit": fitted(pairs, number, has_loss),
            }
    return figures


if __name__ == "__main__":
    run(measure)
