"""Lobes of the sampler network: directions follow their density, and the density is that of the listings."""

from __future__ import annotations

import math

import drjit as dr
import numpy as np
import pytest
import torch
from drjit.llvm.ad import Float
from numpy.typing import NDArray

from loomlight.core.llvm import require_llvm
from loomlight.scattering.lobe_mixture import (
    LOBE_OUTPUTS,
    LobeMixture,
    lobe_mixture,
    mixture_density,
    sample_mixture,
)
from loomlight.training.layers import TORCH
from tests.helpers.chi_square import COLUMNS, ROWS, cell_counts, cell_shares, p_value

require_llvm()

# Roughness x and y, correlation, slopes of both lobes, logarithms of weights; before their activations.
OUTPUTS = {
    "round": [-0.5, -0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    "off-centre": [-0.8, 0.3, 0.9, 0.4, -0.3, 0.2, 0.5, 1.0, 0.0],
    "steep": [0.0, -1.0, -2.0, -1.2, 0.8, -2.0, 1.0, 0.5, 0.0],
    "diffuse alone": [0.0, 0.0, 0.0, 0.0, 0.0, 0.7, -0.4, -50.0, 50.0],
}
VIEWS = [(0.0, 0.0, 1.0), (0.6, 0.2, math.sqrt(0.6)), (-0.3, 0.86, math.sqrt(1 - 0.09 - 0.7396))]


def mixture_of(outputs: list[float]) -> LobeMixture:
    return lobe_mixture([Float(value) for value in outputs])


@pytest.mark.parametrize("view", VIEWS)
@pytest.mark.parametrize("name", OUTPUTS)
def test_directions_follow_their_density(name: str, view: tuple[float, float, float]) -> None:
    mixture, count = mixture_of(OUTPUTS[name]), 40_000
    eye = [Float(part) for part in view]

    def density(lights: NDArray[np.float64]) -> NDArray[np.float64]:
        light = [Float(column.astype(np.float32)) for column in lights.T]
        return np.broadcast_to(mixture_density(mixture, light, eye).numpy(), len(lights)).astype(np.float64)

    # Below the surface the density has a pole where light and view are opposite, which no rule integrates:
    # all cells there are one.
    below = ROWS // 2 * COLUMNS
    above = cell_shares(density)[below:]
    shares = np.append(above, 1 - above.sum())
    rng = np.random.default_rng(4)
    choice, *u = (Float(rng.random(count, np.float32)) for _ in range(3))
    drawn = np.stack([part.numpy() for part in sample_mixture(mixture, eye, choice, u)], axis=1)
    np.testing.assert_allclose(np.linalg.norm(drawn, axis=1), 1, atol=1e-5)
    # 12 tests with fixed seeds.
    counts = cell_counts(drawn.astype(np.float64))
    counts = np.append(counts[below:], counts[:below].sum())
    assert p_value(counts, shares * count) > 1e-3


def listed_density(
    outputs: NDArray[np.float64], light: NDArray[np.float64], view: NDArray[np.float64]
) -> float:
    """The density as a matrix: a half vector's slope is a linear map of a standard slope, plus an offset."""
    bounded = outputs / np.sqrt(1 + outputs**2)
    alpha, rho = 1e-4 + 0.5 * (1 + bounded[:2]), bounded[2]
    slopes = outputs[3:7] * np.sqrt(1 + outputs[3:7] ** 2)
    share = math.exp(outputs[7]) / (math.exp(outputs[7]) + math.exp(outputs[8]))
    half = (light + view) / np.linalg.norm(light + view)
    half *= np.sign(half[2])
    matrix = np.array([[alpha[0], 0], [alpha[1] * rho, alpha[1] * math.sqrt(1 - rho**2)]])
    standard = np.linalg.solve(matrix, -half[:2] / half[2] - slopes[:2])
    of_slopes = 1 / (math.pi * (1 + standard @ standard) ** 2) / np.linalg.det(matrix)
    specular = of_slopes / half[2] ** 3 / (4 * abs(view @ half))
    normal = np.array([-slopes[2], -slopes[3], 1])
    diffuse = max(light @ normal / np.linalg.norm(normal), 0) / math.pi
    return float(share * specular + (1 - share) * diffuse)


def test_densities_are_those_of_the_listings() -> None:
    """And the same by torch as by Dr.Jit."""
    rng = np.random.default_rng(5)
    outputs = rng.normal(size=(200, LOBE_OUTPUTS))
    lights, views = (v / np.linalg.norm(v, axis=1, keepdims=True) for v in rng.normal(size=(2, 200, 3)))
    views[:, 2] = np.abs(views[:, 2])
    wanted = [listed_density(*row) for row in zip(outputs, lights, views, strict=True)]
    columns = [[Float(c.astype(np.float32)) for c in part.T] for part in (outputs, lights, views)]
    actual = mixture_density(lobe_mixture(columns[0]), *columns[1:]).numpy()
    # Half vectors along the surface lose digits.
    np.testing.assert_allclose(actual, wanted, rtol=2e-3, atol=1e-5)
    tensors = [torch.from_numpy(part).unbind(1) for part in (outputs, lights, views)]
    by_torch = mixture_density(lobe_mixture(tensors[0], TORCH), *tensors[1:], TORCH)
    np.testing.assert_allclose(by_torch.numpy(), wanted, rtol=1e-6)


def test_extreme_outputs_are_finite() -> None:
    for sign in (-1e6, 1e6):
        mixture = mixture_of([sign] * LOBE_OUTPUTS)
        eye = [Float(part) for part in VIEWS[1]]
        drawn = sample_mixture(mixture, eye, Float(0.5), [Float(0.3), Float(0.999999)])
        density = mixture_density(mixture, drawn, eye)
        assert all(dr.all(dr.isfinite(part)) for part in (*drawn, density))
