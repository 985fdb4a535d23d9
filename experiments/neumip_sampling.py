"""How much noise the fitted proposal of `neumip` saves: variances of sampled weights against the cosine's.

    python -m experiments.neumip_sampling MATERIAL.loom…

One number a material: the mean over footprints and views of the variance of f·cos over the density, under a
white sky, in units of that of the cosine on either side. Light that passes straight through is left out.
"""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from dataclasses import replace
from pathlib import Path

import numpy as np
from drjit.llvm.ad import Array2f, Array3f, Float

from benchmarks.harness import Figures, run
from loomlight.core.footprint import Box, box_footprint
from loomlight.models.neumip.model import NeumipModel
from loomlight.models.neumip.proposal import cosine_proposal
from loomlight.models.registry import model_from_loom

_PLACES, _SAMPLES = 2000, 64


def variance(model: NeumipModel) -> tuple[float, float]:
    """Mean of the weights, and mean over places of their variance."""
    rng = np.random.default_rng(3)
    width, height = model.source.repeat_mm
    places = rng.random((_PLACES, 2)) * (width, height)
    sizes = model.weights.shape.texel_mm * np.exp2(rng.uniform(0, 4, _PLACES))
    cosine, angle = np.sqrt(rng.random(_PLACES)), 2 * np.pi * rng.random(_PLACES)
    sine = np.sqrt(1 - cosine**2)
    views = np.stack([sine * np.cos(angle), sine * np.sin(angle), np.maximum(cosine, 0.1)], axis=1)
    views /= np.linalg.norm(views, axis=1, keepdims=True)
    places, sizes, views = (np.repeat(part, _SAMPLES, axis=0) for part in (places, sizes, views))
    box = Box(Array2f(np.ascontiguousarray(places.T, np.float32)), Array2f(Float(np.float32(sizes))))
    at = model.at(Array3f(np.ascontiguousarray(views.T, np.float32)), box_footprint(box))
    count = len(sizes)
    drawn = at.sample(Float(rng.random(count, np.float32)), Array2f(rng.random((2, count), np.float32)))
    weights = np.where(drawn.is_null.numpy(), np.nan, drawn.weight.numpy().mean(axis=0))
    grid = weights.reshape(_PLACES, _SAMPLES)
    return float(np.nanmean(grid)), float(np.nanmean(np.nanvar(grid, axis=1)))


def measure(options: Namespace) -> Figures:
    """Mean weights and ratios of variances by material."""
    rows: Figures = {}
    for path in options.materials:
        model = model_from_loom(path)
        assert isinstance(model, NeumipModel)
        assert model.weights.proposal is not None
        # The cosine of either side, as often as the fitted texels choose it.
        plain_texels = cosine_proposal(model.weights.shape)
        plain_texels[:, 6] = model.weights.proposal[:, 6]
        cosine = NeumipModel(model.source, replace(model.weights, proposal=plain_texels))
        (mean, fitted), (other, plain) = variance(model), variance(cosine)
        rows[model.source.name] = {"mean": mean, "mean_by_cosine": other, "ratio": fitted / plain}
    return {"rows": rows}


def _add_options(parser: ArgumentParser) -> None:
    parser.add_argument("materials", nargs="+", type=Path)


if __name__ == "__main__":
    run(measure, _add_options)
