"""The training of the sampler network: its divergence falls, and it goes on where it stopped."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import torch

from loomlight.models.neural.proposal import FURTHER_INPUTS, further_inputs
from loomlight.models.neural.weights import shipped_weights
from tools.fits.neural_sampler_training import (
    SamplerNetwork,
    SamplerSettings,
    Scenes,
    sampler_divergence,
    train_sampler,
    write_sampler,
)


@pytest.mark.slow
def test_training_lowers_the_divergence_and_goes_on(tmp_path: Path) -> None:
    weights = shipped_weights()
    settings = SamplerSettings(fabrics=2, steps=24, together=2, views=64, lights=16)
    stopped = 0

    def stop(step: int, steps: int, loss: float) -> None:
        nonlocal stopped
        stopped += 1
        if stopped == 10:
            raise KeyboardInterrupt

    layers = train_sampler(weights, settings, tmp_path / "whole")
    with pytest.raises(KeyboardInterrupt):
        train_sampler(weights, settings, tmp_path / "other", stop)
    again = train_sampler(weights, settings, tmp_path / "other")
    for (one, _), (other, _) in zip(layers, again, strict=True):
        assert np.array_equal(one, other)
    write_sampler(tmp_path / "sampler.safetensors", layers, weights)
    assert (tmp_path / "sampler.safetensors").stat().st_size < 50_000
    scenes, losses = Scenes(weights, 2, settings.seed), []
    for trained in (False, True):
        torch.manual_seed(settings.seed)
        network = SamplerNetwork(weights.table.hidden)
        if trained:
            linear = [layer for layer in network.layers if isinstance(layer, torch.nn.Linear)]
            with torch.no_grad():
                for layer, (weight, bias) in zip(linear, layers, strict=True):
                    layer.weight.copy_(torch.from_numpy(weight))
                    layer.bias.copy_(torch.from_numpy(bias))
        rng = np.random.default_rng(5)
        parts = [scenes.views(rng, fabric, 128) for fabric in range(2)]
        losses.append(float(sampler_divergence(network, scenes, parts, 16, rng).detach()))
    assert losses[1] < losses[0] - 0.1


def test_values_of_training_are_those_of_the_model() -> None:
    """Luminances from the kernel's activations against the model of the same fabric, with grey albedos."""
    weights = shipped_weights()
    scenes, rng = Scenes(weights, 1, 0), np.random.default_rng(1)
    views = scenes.views(rng, 0, 20)
    lights = rng.normal(size=(20, 3, 3)).astype(np.float32)
    lights /= np.linalg.norm(lights, axis=-1, keepdims=True)
    found = scenes.luminances(views, lights)
    assert found.shape == (20, 3)
    assert (found >= 0).all()
    doubled = scenes.luminances(
        type(views)(
            views.inputs, views.directions, views.activations, views.back, 2 * views.albedos, views.table
        ),
        lights,
    )
    np.testing.assert_allclose(doubled, 2 * found, rtol=1e-5)
    further = further_inputs([*views.directions.T], [(0.0, 1.0, 0.3)] * 2, [*views.albedos.T])
    assert len(further) == FURTHER_INPUTS
