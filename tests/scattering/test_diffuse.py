"""The blended diffuse term: its energy, its sides, its weights."""

from __future__ import annotations

import drjit as dr
import drjit.llvm.ad as jit
import numpy as np
import pytest

from loomlight.scattering.diffuse import (
    diffuse_pdf,
    diffuse_reflection,
    diffuse_transmission,
    sample_diffuse,
)
from tests.helpers.lobes import NORMALS, jittered_sphere
from tests.helpers.references import microflakes as flakes


@pytest.mark.parametrize("blend", [0.0, 0.3, 1.0])
@pytest.mark.parametrize("normal", NORMALS)
def test_weights_are_one_above_the_cloth_and_nothing_below(normal: np.ndarray, blend: float) -> None:
    """That samples follow their density, tests/contract asks."""
    n, w = jit.Array3f(normal.astype(np.float32)), jit.Float(blend)
    light = sample_diffuse(
        n, w, jit.Array2f(np.random.default_rng(2).random((2, 1 << 14)).astype(np.float32))
    )
    weight = (diffuse_reflection(light, n, w) / diffuse_pdf(light, n, w)).numpy()
    np.testing.assert_allclose(weight, light.z.numpy() > 0, atol=1e-5)


@pytest.mark.parametrize("normal", NORMALS)
def test_each_side_returns_at_most_all_of_the_light(normal: np.ndarray) -> None:
    n = jit.Array3f(normal.astype(np.float32))
    grid, solid_angle = jittered_sphere()
    light = jit.Array3f(grid.T.astype(np.float32))
    for blend in (0.0, 0.5, 1.0):
        reflected = diffuse_reflection(light, n, jit.Float(blend)).numpy()
        transmitted = diffuse_transmission(light, n, jit.Float(blend)).numpy()
        assert reflected.sum() * solid_angle < 1 + 1e-4
        assert not np.any(reflected[grid[:, 2] <= 0])
        assert not np.any(transmitted[grid[:, 2] >= 0])
        # chen2024 eq. 1 with the cosine: both normals alike is Lambert's law whatever the blend.
        mirrored = diffuse_reflection(-light, n, jit.Float(blend)).numpy()
        np.testing.assert_array_equal(transmitted, mirrored)
    lambert = diffuse_reflection(light, jit.Array3f(0, 0, 1), jit.Float(0.7)).numpy()
    np.testing.assert_allclose(lambert, np.maximum(grid[:, 2], 0) / np.pi, atol=1e-6)


def test_value_is_the_blend_of_two_cosines() -> None:
    normal = flakes.unit([0.3, -0.4, 0.8])
    light = flakes.unit([-0.5, 0.2, 0.4])
    value = diffuse_reflection(jit.Array3f(light), jit.Array3f(normal), jit.Float(0.25)).numpy()[0]
    assert value == pytest.approx((0.25 * max(light @ normal, 0) + 0.75 * light[2]) / np.pi, rel=1e-6)


def test_gradients_are_right_and_finite() -> None:
    light = jit.Array3f64(flakes.unit([0.5, 0.2, 0.4]))
    normal = jit.Array3f64(flakes.unit([0.3, -0.4, 0.8]))
    blend = jit.Float64(0.25)
    dr.enable_grad(blend, normal)
    dr.backward(diffuse_reflection(light, normal, blend))
    difference = (dr.dot(light, dr.detach(normal)) - light.z) * dr.inv_pi
    assert dr.grad(blend).numpy()[0] == pytest.approx(difference.numpy()[0], rel=1e-9)
    np.testing.assert_allclose(dr.grad(normal).numpy(), (light * 0.25 * dr.inv_pi).numpy(), rtol=1e-9)
    # The sampler too, for numbers at the ends of their range.
    for u in ([0.0, 0.0], [1 - 2**-24, 1 - 2**-24], [0.5, 0.5]):
        for w in (0.0, 0.5, 1.0):
            axis, share = jit.Array3f(0, 0, 1), jit.Float(w)
            dr.enable_grad(axis, share)
            sample = sample_diffuse(axis, share, jit.Array2f(u))
            dr.backward(dr.sum(sample))
            assert np.isfinite(sample.numpy()).all()
            assert np.isfinite(dr.grad(axis).numpy()).all()
            assert np.isfinite(dr.grad(share).numpy()).all()
