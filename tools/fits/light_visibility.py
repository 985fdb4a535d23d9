"""Fits the constants of `models/neural/codings.py` to slices of held-out fabrics.

    python -m tools.fits.light_visibility [--fabrics 12]

The objective is the mean error of the light visibility, as a fraction of its mean, over queries of the query
benchmark whose light and view are on one side.
"""

from __future__ import annotations

import json
from argparse import ArgumentParser, Namespace
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from loomlight.aggregate.queries import fabric_scale, query_set
from loomlight.aggregate.slices import FabricSlices
from loomlight.core.llvm import llvm_float, require_llvm
from loomlight.evaluation.query_benchmark import reference_model
from loomlight.fabric.fabric import Fabric
from loomlight.models.neural.codings import FACING
from studies.instruments.held_out import held_out_fabrics

PAIRS, FOOTPRINTS, TEXELS_PER_THREAD = 48, 24, 24
_MIN_COSINE = 1e-3

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Queries:
    """Footprints of one fabric, a row each.

    Attributes:
        lights, views: unit vectors [n, 3].
        diffuse: diffuse component of both families [n], 1/sr.
        hole, truth: fractions of the view rays that pass through, and that meet lit yarn [n].
        blend: w.
    """

    lights: Floats
    views: Floats
    diffuse: Floats
    hole: Floats
    truth: Floats
    blend: float

    def estimate(self, constants: Sequence[float]) -> Floats:
        """Light visibility [n], bounded as the model bounds it."""
        found = predicted(constants, self.diffuse, self.lights, self.views, self.blend)
        return np.minimum(found, 1 - self.hole)


def predicted(
    constants: Sequence[float], diffuse: Floats, lights: Floats, views: Floats, blend: float
) -> Floats:
    """`light_visibility_of` for arrays [n] and [n, 3], in NumPy."""
    constant, by_cosine, by_azimuth = constants
    cos_light = np.maximum(np.abs(lights[:, 2]), _MIN_COSINE)
    together = (lights[:, :2] * views[:, :2]).sum(axis=1)
    together = together / np.sqrt(np.maximum(np.square(lights[:, :2]).sum(axis=1), 1e-6))
    facing = (constant + by_cosine * cos_light) * (1 + by_azimuth * together)
    return np.asarray(np.pi * np.maximum(diffuse, 0) / ((1 - blend) * cos_light + blend * facing))


def measured(fabric: Fabric, seed: int) -> Queries:
    """Queries of one fabric, with diffuse component and light visibility from slices."""
    queries = query_set(fabric_scale(fabric.layout()), PAIRS, FOOTPRINTS, seed, transmits=False)
    slices = FabricSlices(
        reference_model(fabric), llvm_float(), TEXELS_PER_THREAD, with_light_visibility=True
    )
    means = slices.box_means(queries.lights, queries.views, queries.pairs, queries.centres, queries.boxes)
    rows = means.reshape(-1, means.shape[-1]).astype(np.float64)
    light, view = (
        np.repeat(vectors[index], FOOTPRINTS, axis=0)
        for vectors, index in zip((queries.lights, queries.views), queries.pairs.T, strict=True)
    )
    blend = fabric.appearance().diffuse_blend
    return Queries(light, view, rows[:, 0] + rows[:, 1], rows[:, 4], rows[:, 5], blend)


def errors(queries: Queries, constants: Sequence[float] = FACING) -> tuple[float, float]:
    """Mean absolute error and bias of the light visibility over its mean."""
    off, total = queries.estimate(constants) - queries.truth, queries.truth.sum()
    return float(np.abs(off).sum() / total), float(off.sum() / total)


def measure(options: Namespace) -> dict[str, Any]:
    """Errors of the shipped constants, and constants fitted anew."""
    require_llvm()
    rows = {
        held.name: measured(held.fabric, number)
        for number, held in enumerate(held_out_fabrics(options.fabrics), 1)
    }

    def mean_error(constants: Floats) -> float:
        return float(np.mean([errors(queries, list(constants))[0] for queries in rows.values()]))

    fit = minimize(mean_error, FACING, method="Nelder-Mead")
    return {
        "shipped": {name: dict(zip(("nmae", "bias"), errors(q), strict=True)) for name, q in rows.items()},
        "shipped_mean": mean_error(np.array(FACING)),
        "fit": [round(float(number), 3) for number in fit.x],
        "fit_mean": float(fit.fun),
    }


def main() -> None:
    """Prints the figures as JSON."""
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("--fabrics", type=int, default=12, help="held-out fabrics, 1 to 24")
    print(json.dumps(measure(parser.parse_args()), indent=2))


if __name__ == "__main__":
    main()
