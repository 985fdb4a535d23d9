"""Chi-square tests of the sampler of trained `latent` materials: do drawn directions follow their density?

    python -m experiments.latent_chi_square FOLDER/*.loom --output experiments/results/latent_chi_square.json

A case is a material, a place of uv, a size of the footprint in texels, and a view. Directions above the
surface are counted in cells of equal solid angle, all others in one cell; expected shares are integrals of
the density by the midpoint rule over each cell. Cells that expect fewer than 10 are one.

- `p`: the smallest and the median p-value of a material's cases;
- `rejected`: how many fall below 1 % with Šidák's correction for all cases;
- `weight_error`: largest relative difference of the drawn weights from value over density, where the density
  exceeds a thousandth;
- `above`: the smallest share of directions above the surface; others have weight 0.
"""

from __future__ import annotations

import math
from argparse import ArgumentParser, Namespace
from itertools import product
from pathlib import Path

import numpy as np
from drjit.llvm.ad import Array2f, Array3f, Float
from numpy.typing import NDArray
from scipy import stats

from benchmarks.harness import Figures, run
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.models.interface import FootprintBsdf
from loomlight.models.latent.model import LatentModel
from loomlight.models.registry import model_from_loom

PLACES = ((0.3, 0.4), (0.55, 0.6), (0.7, 0.3))
TEXELS = (1.0, 16.0)
# Angles from the normal and azimuths, degrees.
VIEWS = ((8.0, 0.0), (45.0, 110.0), (75.0, 250.0))
_ROWS, _COLUMNS = 16, 32
# Points a side of a cell: the narrowest lobes are a twentieth of a cell wide.
_POINTS = 48
_SIGNIFICANCE, _FEWEST, _SEED = 0.01, 10.0, 999


def measure(options: Namespace) -> Figures:
    require_llvm()
    tested = {}
    for file in options.materials:
        model = model_from_loom(file)
        assert isinstance(model, LatentModel), f"{file} holds no latent model"
        tested[Path(file).stem] = [
            _case(_at(model, *case), options.samples, number)
            for number, case in enumerate(product(PLACES, TEXELS, VIEWS))
        ]
    count = sum(map(len, tested.values()))
    threshold = 1 - (1 - _SIGNIFICANCE) ** (1 / count)
    materials = {
        name: {
            "p": [min(case["p"] for case in cases), float(np.median([case["p"] for case in cases]))],
            "rejected": sum(case["p"] < threshold for case in cases),
            "weight_error": max(case["weight_error"] for case in cases),
            "above": min(case["above"] for case in cases),
        }
        for name, cases in tested.items()
    }
    return {
        "cases": count,
        "samples": options.samples,
        "rejected": sum(row["rejected"] for row in materials.values()),
        "materials": materials,
    }


def _at(
    model: LatentModel, place: tuple[float, float], texels: float, view: tuple[float, float]
) -> FootprintBsdf:
    side = texels * model.weights.shape.texel_mm
    width, height = model.source.repeat_mm
    footprint = Footprint(Array2f(place[0] * width, place[1] * height), Array2f(side, 0), Array2f(0, side))
    polar, azimuth = map(math.radians, view)
    return model.at(
        Array3f(math.sin(polar) * math.cos(azimuth), math.sin(polar) * math.sin(azimuth), math.cos(polar)),
        footprint,
    )


def _case(at: FootprintBsdf, samples: int, seed: int) -> Figures:
    random = np.random.default_rng([_SEED, seed]).random((3, samples)).astype(np.float32)
    drawn = at.sample(Float(random[0]), Array2f(random[1:]))
    light = np.array(drawn.light, np.float64).T
    above = light[:, 2] > 0
    row = np.minimum((light[above, 2] * _ROWS).astype(int), _ROWS - 1)
    turn = np.arctan2(light[above, 1], light[above, 0]) / (2 * np.pi) + 0.5
    column = np.minimum((turn * _COLUMNS).astype(int), _COLUMNS - 1)
    observed = np.bincount(row * _COLUMNS + column, minlength=_ROWS * _COLUMNS)
    shares = _shares(at)
    counted = np.append(observed, samples - above.sum()).astype(np.float64)
    expected = samples * np.append(shares, max(1 - shares.sum(), 0))
    density = np.array(drawn.pdf)
    value, weight = np.array(at.value(drawn.light)), np.array(drawn.weight)
    sure = above & (density > 1e-3)
    exact = (value / np.maximum(density, 1e-9))[:, sure]
    error = np.abs(weight[:, sure] - exact) / np.maximum(exact, 1e-6)
    return {"p": _p_value(counted, expected), "weight_error": float(error.max()), "above": above.mean()}


def _shares(at: FootprintBsdf) -> NDArray[np.float64]:
    """Integrals of the density over the cells above the surface [cells]."""
    cos = (np.arange(_ROWS * _POINTS) + 0.5) / (_ROWS * _POINTS)
    azimuth = ((np.arange(_COLUMNS * _POINTS) + 0.5) / (_COLUMNS * _POINTS) - 0.5) * 2 * np.pi
    z, phi = (part.ravel() for part in np.meshgrid(cos, azimuth, indexing="ij"))
    radius = np.sqrt(1 - z**2)
    light = np.stack([radius * np.cos(phi), radius * np.sin(phi), z]).astype(np.float32)
    density = np.array(at.pdf(Array3f(light)), np.float64)
    cells = density.reshape(_ROWS, _POINTS, _COLUMNS, _POINTS).mean(axis=(1, 3))
    return cells.ravel() * 2 * np.pi / (_ROWS * _COLUMNS)


def _p_value(observed: NDArray[np.float64], expected: NDArray[np.float64]) -> float:
    rare = expected < _FEWEST
    observed, expected = (np.append(counts[~rare], counts[rare].sum()) for counts in (observed, expected))
    if expected[-1] < _FEWEST:
        observed, expected = observed[:-1], expected[:-1]
    return float(stats.chi2.sf(((observed - expected) ** 2 / expected).sum(), len(expected) - 1))


def _add_options(parser: ArgumentParser) -> None:
    parser.add_argument("materials", nargs="+", help=".loom files of latent")
    parser.add_argument("--samples", type=int, default=40_000, help="directions of a case")


if __name__ == "__main__":
    run(measure, _add_options)
