"""Queries in NumPy arrays: latents that kernels fetch, and independence of the number of queries.

Covers: models/neural/latent_table.py
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from drjit.llvm.ad import Float

from loomlight.core.llvm import require_llvm
from loomlight.core.simd import host_target
from loomlight.fabric import fabric_from_text
from loomlight.models.neural.architecture import NetworkTable
from loomlight.models.neural.decoder import compiled_decoder, decode, kernel_table
from loomlight.models.neural.encoded_fabric import EncodedFabric, Fibres, levels_of, taps
from loomlight.models.neural.encoding import encode
from loomlight.models.neural.weights import Weights
from studies.papers.chen2024.training.network import ClothNetwork
from tests.helpers.directions import unit_vectors
from tests.helpers.neural_networks import TABLES, network, weights_of

require_llvm()
_FIBRES = Fibres(twist=(-0.5, 0.3), roughness=(0.2, 0.7), inclination=(0.3, 0.6), height_scale=(1.0, 0.5))


def _seeing_latents(folder: Path) -> Weights:
    """A network whose first angular layer is the latent's first numbers."""
    # Bins of places that are no numbers are 0, where such places themselves would be multiplied by 0.
    weights = weights_of(ClothNetwork(NetworkTable(width=8, hidden=32, fusion=False)), folder)
    tensors = dict(weights.tensors)
    first = tensors["decoder.angular.0.weight"]
    tensors["decoder.angular.0.weight"] = np.eye(*first.shape, dtype=np.float32)
    tensors["decoder.angular.0.bias"] = np.zeros(len(first), np.float32)
    return replace(weights, tensors=tensors)


def _fetched(
    weights: Weights,
    encoded: EncodedFabric,
    x: np.ndarray,
    y: np.ndarray,
    size: np.ndarray,
    back: np.ndarray,
    step: np.ndarray | None = None,
) -> np.ndarray:
    """The first numbers [n, hidden] of interpolated latents, of anisotropic taps with both steps [4, n]."""
    view = [np.zeros(len(x), np.float32), np.zeros(len(x), np.float32), np.ones(len(x), np.float32)]
    actual = np.empty((weights.table.hidden + 2, len(x)), np.float32)
    steps = np.zeros((4, len(x)), np.float32) if step is None else step
    queries = [x, y, size, *steps, *view, back.astype(np.float32)]
    compiled_decoder(weights).run("view", kernel_table(weights, encoded), queries, [*actual])
    return actual[: weights.table.hidden].T


@pytest.mark.quick("10-5")
@pytest.mark.parametrize(("picks", "ends"), [(2, 2), (1, 3), (10, 5)])
def test_latents_are_those_of_the_pyramid(picks: int, ends: int, tmp_path: Path) -> None:
    weights = _seeing_latents(tmp_path)
    rng = np.random.default_rng(picks)
    last = levels_of(picks, ends)[-1].first + 1
    front, back = rng.normal(size=(2, last, weights.table.latent_size)).astype(np.float16)
    encoded = EncodedFabric.of((picks, ends), (front, back), _FIBRES)
    # Edges of the repeat and of texels too, where rounding decides which side of them a footprint lies on.
    x = np.concatenate([rng.uniform(-20, 40, 2000), np.arange(-200, 200) / 16]).astype(np.float32)
    y = np.concatenate([rng.uniform(-20, 40, 2000), np.arange(200, -200, -1) / 16]).astype(np.float32)
    size = np.exp(rng.uniform(np.log(0.005), np.log(200), len(x))).astype(np.float32)
    behind = rng.random(len(x)) < 0.5
    texels, shares = taps(encoded.pyramid, x, y, size)
    table = encoded.stacked[:, : weights.table.hidden].astype(np.float64)
    expected = np.einsum("nk,nkc->nc", shares, table[texels + last * behind[:, None]])
    actual = _fetched(weights, encoded, x, y, size, behind)
    # float32 coordinates up to 40·8 texels have 2e-5 of a texel, between two of which values change by up to
    # twice the largest.
    np.testing.assert_allclose(actual, expected, atol=1e-4 * np.abs(expected).max())


def test_footprints_of_four_taps_are_means_of_squares(tmp_path: Path) -> None:
    weights = _seeing_latents(tmp_path)
    rng, count = np.random.default_rng(3), 1000
    last = levels_of(3, 4)[-1].first + 1
    front, back = rng.normal(size=(2, last, weights.table.latent_size)).astype(np.float16)
    encoded = EncodedFabric.of((3, 4), (front, back), _FIBRES)
    x, y = rng.uniform(-5, 9, (2, count)).astype(np.float32)
    size = np.exp(rng.uniform(np.log(0.1), np.log(20), count)).astype(np.float32)
    # Among them some that are one square, in blocks of their own and among others.
    step = (rng.normal(size=(4, count)) * size).astype(np.float32)
    step[:, :300] = 0
    step[:, rng.random(count) < 0.3] = 0
    behind = rng.random(count) < 0.5
    table = encoded.stacked[:, : weights.table.hidden].astype(np.float64)
    expected = np.zeros((count, weights.table.hidden))
    for first, second in ((-1, -1), (-1, 1), (1, -1), (1, 1)):
        place = x + first * step[0] + second * step[2], y + first * step[1] + second * step[3]
        texels, shares = taps(encoded.pyramid, *place, size)
        expected += np.einsum("nk,nkc->nc", shares, table[texels + last * behind[:, None]]) / 4
    actual = _fetched(weights, encoded, x, y, size, behind, step)
    # As above.
    np.testing.assert_allclose(actual, expected, atol=1e-4 * np.abs(expected).max())


def test_footprints_that_are_nowhere_read_no_foreign_memory(tmp_path: Path) -> None:
    weights = _seeing_latents(tmp_path)
    last = levels_of(3, 5)[-1].first + 1
    faces = np.full((last, 64), 1, np.float16), np.full((last, 64), 2, np.float16)
    encoded = EncodedFabric.of((3, 5), faces, _FIBRES)
    odd = np.array([np.nan, np.inf, -np.inf, 3e38, -3e38, 1e30, 0, -1e-30], np.float32)
    x, y, size = (part.ravel() for part in np.meshgrid(odd, odd, odd))
    actual = _fetched(weights, encoded, x, y, size, np.zeros(len(x)))
    # All texels hold the same, so whichever are read, shares that add up to one give it back.
    np.testing.assert_allclose(actual, np.ones_like(actual), rtol=1e-5)


@pytest.mark.quick("field")
@pytest.mark.parametrize("name", TABLES)
def test_any_number_of_queries_is_answered_alike(name: str, tmp_path: Path) -> None:
    weights = weights_of(network(name), tmp_path)
    encoded = encode(fabric_from_text("twill 2/1"), weights, Float)
    rng = np.random.default_rng(5)
    # More than one block for each part of two cores' work, and a last one that is not full.
    block = host_target().block_size
    count = 50 * block + 3
    lights, views = unit_vectors(rng, count), unit_vectors(rng, count)
    footprints = rng.uniform(0.1, 5, (count, 3)).astype(np.float32)
    actual = decode(weights, encoded, lights, views, footprints)
    assert actual.shape == (count, 5)
    assert np.ptp(actual, axis=0).min() > 1e-3
    for first, some in ((0, 0), (0, 1), (5, block), (count - 1500, 1500)):
        part = slice(first, first + some)
        again = decode(weights, encoded, lights[part], views[part], footprints[part])
        # Every query's numbers are its own, wherever in a block it stands.
        np.testing.assert_array_equal(again, actual[part])
