"""The sampler network: its density by torch, its training, and what ships.

That directions follow the density, and that weights are values over it, the contract suite tests.

Covers: models/neural/proposal.py, scattering/lobe_mixture.py
"""

from __future__ import annotations

import numpy as np
import torch
from drjit.llvm.ad import Float

from loomlight.core.llvm import require_llvm
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
