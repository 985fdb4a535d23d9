"""Directions that a trained source draws; that they follow their density is in the contract.

Covers: models/neumip/training/proposal_fit.py
"""

from __future__ import annotations

import math
from dataclasses import replace

import drjit as dr
import numpy as np
import torch
from drjit.llvm.ad import Array2f, Array3f, Float, UInt32
from numpy.typing import NDArray

from loomlight.core.llvm import require_llvm
from loomlight.models.mip_pyramid import PyramidShape
from loomlight.models.neumip.btf import QueryStream, light_density
from loomlight.models.neumip.proposal import (
    PARAMETERS,
    DeviceProposal,
    cosine_proposal,
    halvings_of,
    proposal_shape,
)
from loomlight.models.neumip.settings import NeumipSettings
from loomlight.models.neumip.training.proposal_fit import density_of, fitted_proposal

require_llvm()

SHAPE = PyramidShape(8, 8, 1.0, 1.0)
COUNT = 20_000
SETTINGS = NeumipSettings(steps=200, batch=1 << 12)


class Shiny:
    """A plane of rough metal whose facets lean towards +x, α = 0.3, in proportion to a density of facets."""

    faces, transmits, has_holes = 1, False, False
    row = torch.tensor([[0.25, -0.1, 0.3, 0.0, 0.3, 1.0, 0.0]])

    def values(
        self,
        positions: NDArray[np.float32],
        lights: NDArray[np.float32],
        views: NDArray[np.float32],
        seed: tuple[int, ...],
    ) -> NDArray[np.float32]:
        row = self.row.expand(len(lights), 7)
        found = density_of(row, torch.from_numpy(lights), torch.from_numpy(views)).numpy()
        return np.repeat(found[:, None], 3, axis=1)

    def holes(self, positions: NDArray[np.float32], views: NDArray[np.float32]) -> NDArray[np.float32]:
        return np.zeros(len(positions), np.float32)


def weights(texels: NDArray[np.float32]) -> NDArray[np.float32]:
    """f·cos over the density of directions that are drawn for one view."""
    rng = np.random.default_rng(5)
    view = Array3f(0.3, 0.1, math.sqrt(0.9))
    at = DeviceProposal(texels, SHAPE, Float).at(
        *(Float(rng.random(COUNT, np.float32)) for _ in range(2)), Float(0.0), UInt32(0)
    )
    light = at.sample(view, Float(rng.random(COUNT, np.float32)), Array2f(rng.random((2, COUNT), np.float32)))
    density = at.density(light, view).numpy()
    lights = light.numpy().T.copy()
    values = Shiny().values(lights, lights, np.tile(view.numpy().T, (COUNT, 1)), (0,))[:, 0]
    return np.where(lights[:, 2] > 0, values, 0) / density


def test_a_lobe_is_found_and_its_directions_have_a_smaller_variance() -> None:
    queries = QueryStream(Shiny(), SHAPE, 1, 0).part(0, COUNT)
    fitted = fitted_proposal(queries, light_density(queries, False), SHAPE, SETTINGS)
    assert fitted.shape == (SHAPE.texels, PARAMETERS)
    # The texel of the whole, of which most queries are.
    np.testing.assert_allclose(fitted[-1, :2], [0.25, -0.1], atol=0.08)
    np.testing.assert_allclose(fitted[-1, [2, 4]], 0.3, atol=0.1)
    assert fitted[-1, 5] > 0.7
    assert (fitted[:, 6] == 0).all()
    by_cosine, by_lobe = weights(cosine_proposal(SHAPE)), weights(fitted)
    error = by_cosine.std() / math.sqrt(COUNT)
    assert abs(by_cosine.mean() - by_lobe.mean()) < 5 * error
    # An exact lobe loses its directions below the surface too.
    assert by_lobe.var() < 0.35 * by_cosine.var()


def test_densities_are_those_of_torch() -> None:
    rng = np.random.default_rng(2)
    rows = rng.uniform([-0.5, -0.5, 0.1, -0.5, 0.1, 0, 0, 0], [0.5, 0.5, 1, 0.5, 1, 1, 1, 0], (1, 8))
    shape = PyramidShape(1, 1, 1.0, 1.0)
    at = DeviceProposal(rows.astype(np.float32), shape, Float).at(
        Float(0.3), Float(0.4), Float(0.0), UInt32(0)
    )
    lights = rng.normal(size=(COUNT, 3))
    lights /= np.linalg.norm(lights, axis=1, keepdims=True)
    view = [0.6, 0.0, 0.8]
    actual = at.density(Array3f(np.ascontiguousarray(lights.T, np.float32)), Array3f(*view)).numpy()
    row = torch.tensor(rows[:, :7]).expand(COUNT, 7)
    wanted = density_of(row, torch.from_numpy(lights), torch.from_numpy(np.tile(view, (COUNT, 1)))).numpy()
    # In single precision half vectors of nearly opposite directions have few digits.
    np.testing.assert_allclose(actual, wanted, rtol=5e-3, atol=1e-5)


def test_texels_are_the_nearest_ones() -> None:
    """The number of each texel as its mean slope."""
    shape = replace(SHAPE, columns=128, rows=64, faces=2)
    small = proposal_shape(shape)
    assert (small.columns, small.rows, halvings_of(shape)) == (32, 16, 2)
    texels = cosine_proposal(shape)
    texels[:, 0] = np.arange(len(texels))
    device = DeviceProposal(texels, shape, Float)
    found = device.at(Float(0.99, -0.01, 0.5), Float(0.01, 1.99, 0.5), Float(-3, 3.4, 20), UInt32(0, 1, 1))
    dr.eval(found.mean)
    wanted = [31, small.texels + small.starts[1] + 7 * 16 + 15, 2 * small.texels - 1]
    assert found.mean[0].numpy().tolist() == wanted
