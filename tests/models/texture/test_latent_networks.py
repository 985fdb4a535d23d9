"""SIMD kernels and cooperative vectors against the torch modules that are trained.

Covers: models/texture/latent_training.py, models/networks.py
"""

from __future__ import annotations

import math
from types import SimpleNamespace

import drjit as dr
import numpy as np
import pytest
import torch
from drjit.llvm.ad import Array3f, Float, Int32, UInt32

from loomlight.core.llvm import require_llvm
from loomlight.models.texture.latent import (
    AUXILIARY_WIDTHS,
    DeviceWeights,
    decoder_widths,
    half_vector_features,
)
from loomlight.models.texture.latent_training import LatentNetwork, auxiliary_numbers, loss_of
from loomlight.models.texture.pyramid import PyramidShape
from loomlight.models.texture.settings import DECODERS
from loomlight.scattering.lobe_mixture import lobe_mixture
from loomlight.training.layers import relu_layers
from tests.helpers.directions import upper_directions

require_llvm()

SHAPE = PyramidShape(8, 4, 2.0, 1.0, 2)
COUNT = 300
SCALARS = SimpleNamespace(log=math.log, sqrt=math.sqrt, maximum=max)


def network(decoder: str = "2x32", with_frames: bool = True, with_features: bool = True) -> LatentNetwork:
    """A network of random numbers, none of which is 0."""
    torch.manual_seed(3)
    inputs = np.random.default_rng(2).normal(size=(2 * SHAPE.texels, 5)).astype(np.float32)
    made = LatentNetwork(SHAPE, inputs, DECODERS[decoder], with_frames, with_features, scale=4.0)
    with torch.no_grad():
        for parameter in made.parameters():
            parameter.add_(0.1 * torch.randn_like(parameter))
    return made


@pytest.mark.parametrize(
    ("decoder", "with_frames", "with_features", "derivatives"),
    [
        ("2x16", True, True, False),
        ("2x32", True, True, True),
        ("3x64", True, True, False),
        ("2x32", False, True, False),
        ("2x32", True, False, False),
    ],
)
def test_values_and_lobes_are_those_of_torch(
    decoder: str, with_frames: bool, with_features: bool, derivatives: bool
) -> None:
    """By the SIMD kernel, and by cooperative vectors, which derivatives ask for."""
    made, rng = network(decoder, with_frames, with_features), np.random.default_rng(1)
    positions = rng.random((COUNT, 2)).astype(np.float32)
    levels, faces = rng.integers(SHAPE.levels, size=COUNT), rng.integers(2, size=COUNT)
    lights, views = upper_directions(rng, COUNT), upper_directions(rng, COUNT)
    latent, light, view = (
        made.latent(torch.from_numpy(positions), torch.from_numpy(levels), torch.from_numpy(faces), False),
        torch.from_numpy(lights),
        torch.from_numpy(views),
    )
    with torch.no_grad():
        wanted = made(latent, light, view).numpy()
        outputs, log_albedo = (part.numpy() for part in made.sampler_outputs(latent, view))
    auxiliary = relu_layers(AUXILIARY_WIDTHS)
    with torch.no_grad():
        auxiliary[-1].weight.mul_(3)
        guides = auxiliary_numbers(auxiliary(latent)).numpy()
    device = DeviceWeights(made.weights(np.zeros((2, 3), np.float32), auxiliary), Float)
    u, v = (Float(np.ascontiguousarray(column)) for column in positions.T)
    if derivatives:
        dr.enable_grad(u)
    face = UInt32(faces.astype(np.uint32))
    fetched = device.latent_of_level(u, v, Int32(levels.astype(np.int32)), face)
    np.testing.assert_allclose(np.stack([c.numpy() for c in fetched], 1), latent.detach().numpy(), atol=1e-5)
    frames = device.frames(fetched)
    assert len(frames) == 2 * with_frames
    facing, seen = (Array3f(np.ascontiguousarray(rows.T)) for rows in (lights, views))
    actual = device.value(fetched, frames, facing, seen).numpy().T
    np.testing.assert_allclose(actual, wanted, rtol=2e-4, atol=1e-6)
    found = device.auxiliary(fetched)
    np.testing.assert_allclose(found.albedo.numpy().T, guides[:, :3].clip(0, 1), rtol=2e-4)
    np.testing.assert_allclose(found.roughness.numpy(), guides[:, 3].clip(0, 1), rtol=2e-4)
    normals = np.concatenate([-guides[:, 4:], np.ones((COUNT, 1))], axis=1)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    np.testing.assert_allclose(found.normal.numpy().T, normals, atol=1e-5)
    assert guides.std(axis=0).min() > 0.01
    np.testing.assert_allclose(device.albedo(fetched, seen).numpy().T, np.exp(log_albedo), rtol=2e-4)
    mixture = device.mixture(fetched, seen)
    expected = lobe_mixture([Float(np.ascontiguousarray(column)) for column in outputs.T])
    np.testing.assert_allclose(mixture.specular_share.numpy(), expected.specular_share.numpy(), rtol=1e-3)
    np.testing.assert_allclose(mixture.alpha[0].numpy(), expected.alpha[0].numpy(), rtol=1e-3)


def test_the_networks_have_the_papers_inputs() -> None:
    assert decoder_widths((32, 32), with_frames=True, with_features=False) == (20, 32, 32, 3)
    assert decoder_widths((32, 32), with_frames=False, with_features=False) == (14, 32, 32, 3)
    weights = network().weights(np.zeros((2, 3), np.float32), relu_layers(AUXILIARY_WIDTHS))
    assert [matrix.shape for matrix, _ in weights.layers["sampler"]] == [
        (32, 11),
        (32, 32),
        (32, 32),
        (9, 32),
    ]
    assert weights.frames is not None
    assert weights.frames.shape == (12, 8)
    assert weights.latents.shape == (2 * 43, 8)


def test_features_of_a_half_vector() -> None:
    """Of directions in one plane: the half vector is 15° from the normal, and 45° from both."""
    view, light = ([math.sin(angle), 0.0, math.cos(angle)] for angle in np.radians((60, -30)))
    found = half_vector_features([(view, light)], view, light, SCALARS)
    rest = 1 - math.cos(math.radians(45))
    wanted = [
        0.25 * math.log(math.tan(math.radians(15)) ** 2 + 1e-5),
        rest**5,
        math.log(math.cos(math.radians(30))),
    ]
    assert found == pytest.approx(wanted, rel=1e-9)
    # Opposite directions at the horizon have features too.
    assert np.isfinite(half_vector_features([([1, 0, 0], [-1, 0, 0])], [1, 0, 0], [-1, 0, 0], SCALARS)).all()


def test_textures_begin_as_what_the_encoder_gives() -> None:
    made = network()
    made.encode_texels()
    # Centres of texels, where interpolated inputs are those of the texel. Of many queries all texels are
    # encoded, of few the queries.
    for count in (2, 2 * SHAPE.texels + 2):
        positions = torch.tensor([[1.5, 2.5], [7.5, 0.5]]) / torch.tensor([8.0, 4.0])
        positions = positions.repeat(count // 2, 1)
        levels, faces = torch.zeros(count).long(), torch.tensor([0, 1]).repeat(count // 2)
        by_encoder, by_texels = (made.latent(positions, levels, faces, each) for each in (True, False))
        torch.testing.assert_close(by_texels, by_encoder, rtol=1e-4, atol=1e-5)


def test_losses() -> None:
    ones, more = torch.ones(4, 3), torch.full((4, 3), 8.0)
    assert float(loss_of(more, ones, "log")) == pytest.approx(np.log(9 / 2), rel=1e-5)
    assert float(loss_of(more, ones, "cube-root")) == pytest.approx(3 * (2 - 1), rel=1e-3)
    assert float(loss_of(ones, ones, "cube-root")) == 0
