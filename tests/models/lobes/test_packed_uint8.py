"""Interpolation of four bytes at once, against numpy."""

from __future__ import annotations

import numpy as np
import pytest
from drjit.llvm.ad import Float, UInt32
from numpy.typing import NDArray

from loomlight.core.backend import array_types
from loomlight.models.lobes.hemisphere import (
    WEIGHT_SUM,
    PackedWeights,
    byte_of_group,
    mean_of_packs,
    pack_count,
)

TYPES = array_types(Float)
COUNT = 1000


def _random_bytes(nodes: int) -> NDArray[np.uint8]:
    """Bytes [nodes, n, 4]; the first are the largest."""
    values = np.random.default_rng(nodes).integers(0, 256, (nodes, COUNT, 4), dtype=np.uint8)
    values[:, :10] = 255
    return values


def _packs(values: NDArray[np.uint8]) -> list[UInt32]:
    return [UInt32(node.reshape(-1).view("<u4")) for node in values]


def _array(means: list[Float]) -> NDArray[np.float32]:
    return np.stack([mean.numpy() for mean in means], axis=1)


def test_families_begin_with_a_pack_of_their_own() -> None:
    assert [pack_count(count) for count in (1, 4, 5, 8, 9)] == [2, 2, 4, 4, 6]
    assert byte_of_group(5).tolist() == [0, 1, 2, 3, 4, 8, 9, 10, 11, 12]


@pytest.mark.parametrize("nodes", [1, 4, 8])
def test_interpolation_is_that_of_rounded_weights(nodes: int) -> None:
    values = _random_bytes(nodes)
    weights = np.random.default_rng(9).dirichlet(np.ones(nodes), COUNT).T.astype(np.float32)
    actual = _array(PackedWeights(TYPES, [Float(part) for part in weights]).interpolate(_packs(values)))
    rounded = np.floor(weights.astype(np.float64) * WEIGHT_SUM + 0.5)
    expected = (rounded[..., None] * values).sum(axis=0) / rounded.sum(axis=0)[:, None]
    # Single precision; float32 rounds a weight to the other integer where it is next to a half.
    np.testing.assert_allclose(actual, expected, atol=255 * 2**-22 + 255 / WEIGHT_SUM * (nodes > 1) * 0.01)
    # Weights are off by half a unit each, as their sum is by the sum of that.
    exact = (weights[..., None] * values).sum(axis=0)
    assert np.abs(actual - exact).max() < 255 * nodes / WEIGHT_SUM


@pytest.mark.parametrize("nodes", [1, 9, 256])
def test_means_are_exact(nodes: int) -> None:
    values = _random_bytes(nodes)
    actual = _array(mean_of_packs(TYPES, _packs(values)))
    np.testing.assert_allclose(actual, values.mean(axis=0), rtol=1e-6)
