"""The blended diffuse term: its energy, its sides, its sampler.

Covers: scattering/directions.py
"""

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
from loomlight.scattering.directions import uniform_on_sphere
from tests.helpers.references import microflakes as flakes

COUNT = 1 << 18
NORMALS = [flakes.unit(n) for n in ([0, 0, 1], [0.3, -0.4, 0.8], [0.98, 0.1, 0.17], [0.6, 0, -0.2])]


def numbers(seed: int) -> jit.Array2f:
    return jit.Array2f(np.random.default_rng(seed).random((2, COUNT)).astype(np.float32))


def sphere_grid(size: tuple[int, int] = (1200, 1000)) -> tuple[np.ndarray, float]:
    """A jittered grid of directions, and the solid angle of each."""
    row, column = (np.indices(size) + np.random.default_rng(0).random((2, *size))).reshape(2, -1)
    z, azimuth = 1 - 2 * row / size[0], 2 * np.pi * column / size[1]
    radius = np.sqrt(1 - z**2)
    return np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), z], -1), 4 * np.pi / len(z)


def test_points_are_uniform_on_the_sphere() -> None:
    points = uniform_on_sphere(numbers(1)).numpy().T.astype(float)
    observed = np.bincount(flakes.bins_of(points, np.eye(3), (24, 36)), minlength=24 * 36)
    assert flakes.chi_square_p(observed, np.full(24 * 36, COUNT / (24 * 36))) > 1e-3
    assert np.abs(np.linalg.norm(points, axis=1) - 1).max() < 1e-6


@pytest.mark.quick("normal1-0.3", "normal2-1.0")
@pytest.mark.parametrize("blend", [0.0, 0.3, 1.0])
@pytest.mark.parametrize("normal", NORMALS)
def test_samples_follow_their_density(normal: np.ndarray, blend: float) -> None:
    n, w = jit.Array3f(normal.astype(np.float32)), jit.Float(blend)
    light = sample_diffuse(n, w, numbers(2))
    grid, solid_angle = sphere_grid()
    pdf = diffuse_pdf(jit.Array3f(grid.T.astype(np.float32)), n, w).numpy()
    frame = flakes.frame_about(flakes.unit([0.2, 0.9, 0.4]))
    observed = np.bincount(flakes.bins_of(light.numpy().T.astype(float), frame, (24, 36)), minlength=864)
    expected = np.bincount(flakes.bins_of(grid, frame, (24, 36)), pdf * solid_angle, 864)
    assert expected.sum() == pytest.approx(1, abs=1e-4)
    # 12 tests, one in a thousand of all of them by chance.
    assert flakes.chi_square_p(observed, expected * COUNT) > 1e-3 / 12
    # The weight is 1 above the cloth and 0 below it.
    weight = (diffuse_reflection(light, n, w) / diffuse_pdf(light, n, w)).numpy()
    np.testing.assert_allclose(weight, light.z.numpy() > 0, atol=1e-5)


@pytest.mark.parametrize("normal", NORMALS)
def test_each_side_returns_at_most_all_of_the_light(normal: np.ndarray) -> None:
    n = jit.Array3f(normal.astype(np.float32))
    grid, solid_angle = sphere_grid()
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
