"""Directions that `neural` draws: no weight far beyond the albedo, whatever the network says at the horizon.

That samples follow their density, and that weights are value over density, the contract suite tests.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Array3f, Float

from loomlight.core.footprint import Footprint
from loomlight.fabric import load_fabric
from loomlight.models.neural.model import SAMPLERS, NeuralModel
from loomlight.models.neural.proposal import Proposal
from loomlight.models.registry import make_model

EXAMPLES = Path(__file__).parents[3] / "examples"
COUNT = 300_000


@cache
def model_of(example: str, sampler: str) -> NeuralModel:
    model = make_model("neural", load_fabric(EXAMPLES / f"{example}.toml"), sampler=sampler)
    assert isinstance(model, NeuralModel)
    return model


def drawn(example: str, sampler: str) -> tuple[np.ndarray, np.ndarray]:
    """Largest channel of weights, 0 for null transmission, and the lights' heights: views all around."""
    model, rng = model_of(example, sampler), np.random.default_rng(0)
    width, height = model.fabric.repeat_mm
    centre = rng.random((2, COUNT)) * [[width], [height]]
    view = rng.normal(size=(3, COUNT))
    view /= np.linalg.norm(view, axis=0)
    threads = np.exp(rng.uniform(np.log(0.05), np.log(5), COUNT))
    side = Float((threads * width / model.fabric.layout().warp_on_top.shape[1]).astype(np.float32))
    footprint = Footprint(Array2f(centre.astype(np.float32)), Array2f(side, 0), Array2f(0, side))
    u = rng.random((3, COUNT)).astype(np.float32)
    sample = model.at(Array3f(view.astype(np.float32)), footprint).sample(Float(u[0]), Array2f(u[1:]))
    dr.eval(sample)
    weight = np.where(np.array(sample.is_null), 0, np.array(sample.weight).max(axis=0))
    return weight, np.array(sample.light)[2]


@pytest.mark.slow
@pytest.mark.parametrize("sampler", SAMPLERS)
@pytest.mark.parametrize("example", ["organza", "silk-satin"])
def test_no_weight_is_a_firefly(example: str, sampler: str) -> None:
    weight, height = drawn(example, sampler)
    # Drawn by the cosine alone, 1 in 100 000 directions at the horizon had a weight of 10 to 100. Direct
    # light keeps below 8 and 3; so much more, a fifth and a third, do yarns send to each other. On organza,
    # more open than most of the training, the network takes one direction in 300 000 for a highlight.
    assert np.sort(weight)[-2] < 9.6
    assert weight.max() < 20
    horizon = (np.abs(height) < 0.01) & (weight > 0)
    assert horizon.sum() > 100
    # One draw of five hundred there may be where the lobes are thin.
    assert np.quantile(weight[horizon], 0.99) < 4


def test_black_cloth_draws_directions_too() -> None:
    zero, up = Float(0), Array3f(0, 0, 1)
    tangents = Array3f(0, 1, 0), Array3f(1, 0, 0)
    black = Proposal(zero, zero, zero, (zero, zero), Float(1), up, tangents, (Float(0.3), Float(0.3)))
    rng = np.random.default_rng(0)
    light, is_null = black.draw(Float(rng.random(1000)), Array2f(rng.random((2, 1000))))
    assert not np.array(is_null).any()
    np.testing.assert_allclose(np.linalg.norm(np.array(light), axis=0), 1, rtol=1e-5)
    assert (np.array(light.z) > 0).all()
    assert (np.array(black.density(light)) > 0).all()
