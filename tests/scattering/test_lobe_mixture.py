"""Lobes of the sampler network: their density is that of the listings."""

from __future__ import annotations

import math

import drjit as dr
import numpy as np
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
from tests.helpers.lobes import MIXTURE_VIEWS

require_llvm()


def mixture_of(outputs: list[float]) -> LobeMixture:
    return lobe_mixture([Float(value) for value in outputs])


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
        eye = [Float(part) for part in MIXTURE_VIEWS[1]]
        drawn = sample_mixture(mixture, eye, Float(0.5), [Float(0.3), Float(0.999999)])
        density = mixture_density(mixture, drawn, eye)
        assert all(dr.all(dr.isfinite(part)) for part in (*drawn, density))
