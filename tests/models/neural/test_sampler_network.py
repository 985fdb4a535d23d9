"""Directions of the sampler network follow their density, over the whole sphere, at any parameters.

That weights are value over density, and that drawn directions follow the density on examples, the contract
suite tests with the shipped network.

Covers: models/networks.py, models/neural/proposal.py
Covers: scattering/lobe_mixture.py
"""

from __future__ import annotations

import numpy as np
import pytest
import torch
from drjit.llvm.ad import Array2f, Array3f, Float
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.models.networks import LearnedProposal
from loomlight.models.neural.model import NeuralModel, NeuralOptions
from loomlight.models.neural.proposal import FURTHER_INPUTS, sampler_layers
from loomlight.models.neural.weights import shipped_weights
from loomlight.scattering.lobe_mixture import OUTPUTS, TwoSidedLobes
from loomlight.training.layers import TORCH
from tests.helpers.chi_square import cell_counts, cell_shares, p_value

require_llvm()


def proposal_of(seed: int) -> LearnedProposal:
    """A proposal of random outputs."""
    rng = np.random.default_rng(seed)
    outputs = rng.normal(scale=0.6, size=OUTPUTS)
    # Narrow lobes would need more points in the cells of the test; `test_lobe_mixture.py` has those.
    outputs[[0, 1, 9, 10]] = rng.uniform(0.2, 1.5, 4)
    view = np.array([*rng.uniform(-0.6, 0.6, 2), 0])
    view[2] = np.sqrt(1 - view @ view)
    lobes = TwoSidedLobes.of([Float(value) for value in outputs])
    sheen = (Float(0.1 * seed), 0.4) if seed else None
    return LearnedProposal(Float(0), lobes, Array3f(*view.tolist()), sheen)


@pytest.mark.parametrize("seed", range(4))
def test_drawn_directions_follow_the_density(seed: int) -> None:
    proposal = proposal_of(seed)
    rng = np.random.default_rng(100 + seed)
    u = rng.random((3, 100_000), np.float32)
    light, is_null = proposal.draw(Float(u[0]), Array2f(Float(u[1]), Float(u[2])))
    assert not np.array(is_null).any()

    def density(directions: NDArray[np.float64]) -> NDArray[np.float64]:
        found = proposal.density(Array3f(np.ascontiguousarray(directions.T.astype(np.float32))))
        return np.array(found, np.float64)

    # Significance 0.01 of four tests.
    counts = cell_counts(light.numpy().T.astype(np.float64))
    assert p_value(counts, cell_shares(density) * u.shape[1]) > 0.01 / 4


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


def test_a_sampler_is_one_of_two() -> None:
    cloth = fabric_from_text('weave = "plain"')
    assert NeuralModel.for_source(cloth, NeuralOptions(refined=False)).sampler == "learned"
    with pytest.raises(InputError, match="known are learned, lobes"):
        NeuralModel.for_source(cloth, NeuralOptions(refined=False, sampler="cosine"))
