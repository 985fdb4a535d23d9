"""SIMD kernels and cooperative vectors against the torch modules that are trained.

Covers: models/texture/neumip_training.py
"""

from __future__ import annotations

from typing import Any

import drjit as dr
import numpy as np
import pytest
import torch
from drjit.llvm.ad import Float, UInt32

from loomlight.core.llvm import require_llvm
from loomlight.models.texture.neumip import MIN_COSINE, DeviceWeights, quantised, shifted
from loomlight.models.texture.neumip_training import NeumipNetwork
from loomlight.models.texture.pyramid import PyramidShape

require_llvm()

SHAPE = PyramidShape(8, 4, 2.0, 1.0, 2)
COUNT = 300


def network(with_offset: bool = True) -> NeumipNetwork:
    """A network of random numbers, none of which is 0."""
    torch.manual_seed(3)
    made = NeumipNetwork(SHAPE, with_offset, scale=4.0)
    with torch.no_grad():
        for parameter in made.parameters():
            parameter.add_(0.1 * torch.randn_like(parameter))
        # What files hold; the scale is a power of two.
        for texture in (made.features, made.offset_texture):
            if texture is not None:
                texture.copy_(torch.from_numpy(np.multiply(*quantised(texture.numpy()))))
    return made.eval()


def inputs() -> tuple[torch.Tensor, ...]:
    """Positions, levels, lights, views and faces."""
    rng = np.random.default_rng(1)

    def directions() -> np.ndarray[tuple[int, ...], np.dtype[np.float32]]:
        angle, radius = 2 * np.pi * rng.random(COUNT), 0.98 * np.sqrt(rng.random(COUNT))
        return np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=1).astype(np.float32)

    return (
        torch.from_numpy(rng.random((COUNT, 2), np.float32)),
        torch.from_numpy(rng.uniform(-1, 5, COUNT).astype(np.float32)),
        torch.from_numpy(directions()),
        torch.from_numpy(directions()),
        torch.from_numpy(rng.integers(2, size=COUNT)),
    )


@pytest.mark.parametrize("derivatives", [False, True])
@pytest.mark.parametrize("with_offset", [True, False])
def test_values_are_those_of_torch(with_offset: bool, derivatives: bool) -> None:
    """By the SIMD kernel, and by cooperative vectors, which derivatives ask for."""
    made, (positions, levels, lights, views, faces) = network(with_offset), inputs()
    with torch.no_grad():
        wanted = made(positions, levels, lights, views, faces)[0].numpy() / np.pi
    assert (wanted > 0).mean() > 0.5
    device = DeviceWeights(made.weights(np.zeros((2, 3), np.float32)), Float)
    (u, v), light, view = (
        [Float(column) for column in part.numpy().T.copy()] for part in (positions, lights, views)
    )
    if derivatives:
        dr.enable_grad(u)
    face = UInt32(faces.numpy().astype(np.uint32))
    if with_offset:
        depth = device.depth(u, v, view, face)
        cosine = dr.sqrt(1 - view[0] * view[0] - view[1] * view[1])
        slope = dr.rcp(dr.maximum(cosine, MIN_COSINE))
        u, v = shifted(SHAPE, u, v, depth, *view, slope)
    actual = device.value(device.latent(u, v, Float(levels.numpy()), face), light, view)
    found = np.stack([channel.numpy() for channel in actual], axis=1)
    # Depths are rounded, and the texture between texels has slopes of a few units a repeat.
    np.testing.assert_allclose(found, wanted, atol=3e-5)


def test_the_networks_have_the_papers_size() -> None:
    """9→25→25→25→1 and 11→25→25→25→3: Table 4's 3332 is 78 more, three further outputs of the first."""
    weights = network().weights(np.zeros((2, 3), np.float32))
    assert weights.count == 3254 == 3332 - 3 * 26
    assert weights.features.shape == (2 * 43, 7)
    assert weights.offset_texels is not None
    assert weights.offset_texels.shape == (2 * 32, 7)


def test_a_frozen_offset_texture_gets_no_gradient() -> None:
    made, queries = network().train(), inputs()
    for frozen in (False, True):
        made.zero_grad(set_to_none=True)
        predicted, _ = made(*queries, offset_frozen=frozen)
        predicted.sum().backward()
        assert made.offset_texture is not None
        assert (made.offset_texture.grad is None) == frozen
        assert made.features.grad is not None


def test_gradients_of_texels_are_those_of_indexing(monkeypatch: pytest.MonkeyPatch) -> None:
    """Texels are seen several times, and positions have gradients through the weights of the taps."""
    made, (positions, *others) = network(), inputs()

    def by_index(table: Any, taps: Any) -> Any:
        return sum(w[:, None] * table[k] for k, w in zip(taps.texels, taps.weights, strict=True))

    gradients = []
    for by_indexing in (False, True):
        made.zero_grad(set_to_none=True)
        place = positions.clone().requires_grad_()
        if by_indexing:
            monkeypatch.setattr("loomlight.models.texture.neumip_training.fetched", by_index)
        made(place, *others)[0].square().sum().backward()
        gradients.append([place.grad, made.features.grad, made.offset_texture.grad])
    for actual, wanted in zip(*gradients, strict=True):
        assert wanted.abs().max() > 0
        # Sums of hundreds of terms, in another order.
        torch.testing.assert_close(actual, wanted, rtol=1e-4, atol=1e-4)


def test_bytes_are_multiples_of_a_power_of_two_and_come_back_as_they_are() -> None:
    """Half a step of error at most; 127 multiples of a power of two are a channel's own largest."""
    rng = np.random.default_rng(5)
    texels = (rng.normal(size=(500, 7)) * np.array([1e-3, 0.1, 1, 3, 50, 0, 2])).astype(np.float32)
    texels[0, 6] = 127 * 0.125
    codes, steps = quantised(texels)
    assert codes.dtype == np.int8
    assert (np.frexp(steps)[0] == 0.5).all()
    assert steps[6] == 0.125
    assert (np.abs(codes).max(axis=0)[[0, 1, 2, 3, 4, 6]] >= 64).all()
    once = codes * steps
    assert once.dtype == np.float32
    assert (np.abs(once - texels) <= 0.5 * steps).all()
    again, same = quantised(once)
    np.testing.assert_array_equal(again, codes)
    # Of a channel of nothing any will do.
    np.testing.assert_array_equal(same[[0, 1, 2, 3, 4, 6]], steps[[0, 1, 2, 3, 4, 6]])


def test_the_shift_is_a_length_and_not_a_share_of_each_side() -> None:
    """Eq. 7: on a repeat twice as wide as high, the same depth is half as many repeats across."""
    u, v = shifted(SHAPE, 0.0, 0.0, 0.1, 0.6, 0.6, 1.0)
    assert u * SHAPE.width_mm == pytest.approx(v * SHAPE.height_mm)
    assert u * SHAPE.width_mm == pytest.approx(0.06 * SHAPE.length_mm)
