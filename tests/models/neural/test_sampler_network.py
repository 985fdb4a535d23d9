"""The sampler network: its density by torch, its training, and what ships.

That directions follow the density, and that weights are values over it, the contract suite tests.

Covers: models/neural/proposal.py, scattering/lobe_mixture.py
"""

from __future__ import annotations

import numpy as np
import pytest
import torch
from drjit.llvm.ad import Float

from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.models.networks import LearnedProposal
from loomlight.models.neural.model import NeuralModel, NeuralOptions
from loomlight.models.neural.proposal import FURTHER_INPUTS, sampler_layers
from loomlight.models.neural.weights import shipped_weights
from loomlight.scattering.lobe_mixture import OUTPUTS, TwoSidedLobes
from loomlight.training.layers import TORCH

require_llvm()


def test_torch_has_the_same_density() -> None:
    rng = np.random.default_rng(3)
    outputs = rng.normal(size=(OUTPUTS, 50)).astype(np.float32)
    light, view = rng.normal(size=(2, 3, 50)).astype(np.float32)
    light, view = (part / np.linalg.norm(part, axis=0) for part in (light, view))
    view[2] = np.abs(view[2])
    found = TwoSidedLobes.of([Float(row) for row in outputs]).density(
        [Float(row) for row in light], [Float(row) for row in view]
    )
    tensors = [[torch.from_numpy(row) for row in part] for part in (outputs, light, view)]
    wanted = TwoSidedLobes.of(tensors[0], TORCH).density(*tensors[1:], TORCH)
    # Single precision, cubes of small cosines.
    np.testing.assert_allclose(found.numpy(), wanted.numpy(), rtol=2e-4)


def test_the_shipped_network_is_that_of_the_shipped_decoder() -> None:
    weights = shipped_weights()
    layers = sampler_layers(weights)
    assert layers is not None
    assert layers[0][0].shape[1] == weights.table.hidden + FURTHER_INPUTS
    assert layers[-1][0].shape[0] == OUTPUTS


<<<<<<< HEAD
def test_a_sampler_is_one_of_two() -> None:
    cloth = fabric_from_text('weave = "plain"')
    assert NeuralModel.for_source(cloth, NeuralOptions(refined=False)).sampler == "learned"
    with pytest.raises(InputError, match="known are learned, lobes"):
        NeuralModel.for_source(cloth, NeuralOptions(refined=False, sampler="cosine"))
=======
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
>>>>>>> 9c85dec3 (Contract of models in one folder: samplers, files and options are asked once, of every model)
