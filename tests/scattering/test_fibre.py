"""The fibre layer against random walks, the weights of its sampler, and the identities that it must keep."""

from __future__ import annotations

import itertools

import drjit as dr
import drjit.llvm.ad as jit
import numpy as np
import pytest

from loomlight.scattering import fibre
from tests.helpers.lobes import FIBRE_ROUGHNESSES
from tests.helpers.references import microflakes as flakes


def vector(values: np.ndarray) -> jit.Array3f:
    """[n, 3] or [3] as Array3f."""
    return jit.Array3f(np.atleast_2d(values).T.astype(np.float32))


def layer(light: np.ndarray, view: np.ndarray, frame: tuple, roughness: float, depth: float) -> np.ndarray:
    """Reflection plus transmission, [n]; at most one of them is not zero."""
    normal, tangent = frame
    arguments = (vector(light), vector(view), vector(normal), vector(tangent), jit.Float(roughness), depth)
    return (fibre.reflection(*arguments) + fibre.transmission(*arguments)).numpy()


# Roughness, optical depth, and how far the fibres may stand out of the plane.
WALKS = [
    (roughness, depth, tilt)
    for tilt in (0.0, 0.9)
    for roughness, depth in (
        (0.01, 2.0),
        (0.05, 2.0),
        (0.05, 0.3),
        (0.1, 2.0),
        (0.2, 5.0),
        (0.3, 2.0),
        (0.3, 0.05),
        (0.5, 2.0),
        (0.7, 1.0),
        (0.9, 2.0),
        (1.0, 2.0),
        (1.0, 20.0),
    )
]


def deviations_from_walks(count: int) -> np.ndarray:
    """z-scores of all bins of all configurations, with `count` walks each."""
    rng = np.random.default_rng(20)
    bins = (8, 12)
    z = []
    for roughness, depth, tilt in WALKS:
        view, normal, tangent = (row[0] for row in flakes.random_frames(rng, 1, tilt))
        frame = flakes.frame_about(normal)
        light, weight = flakes.walk(rng, view, normal, tangent, roughness, depth, count)
        number = flakes.bins_of(light, frame, bins)
        size = bins[0] * bins[1]
        mean = np.bincount(number, weight, size) / count
        square = np.bincount(number, weight**2, size) / count
        grid, solid_angle = flakes.light_grid(view, tangent, roughness, (800, 500))
        value = layer(grid, view, (normal, tangent), roughness, depth) * solid_angle
        expected = np.bincount(flakes.bins_of(grid, frame, bins), value, size)
        # Sums of fewer than 200 walks' worth of weight are too skewed to call their error normal.
        filled = count * mean**2 > 200 * square
        error = np.sqrt((square - mean**2)[filled] / count)
        z.append((mean - expected)[filled] / error)
    return np.concatenate(z)


@pytest.mark.slow
def test_layer_agrees_with_random_walks() -> None:
    z = deviations_from_walks(100_000)
    assert len(WALKS) >= 20
    assert len(z) > 600
    # χ²/dof of n normal variables has the deviation sqrt(2/n); 4 of them. One |z| in 2e6 exceeds 5.
    assert np.mean(z**2) == pytest.approx(1, abs=4 * np.sqrt(2 / len(z)))
    assert np.abs(z).max() < 5
    assert abs(np.mean(z)) < 4 / np.sqrt(len(z))


@pytest.mark.quick("0.3", "1.0")
@pytest.mark.parametrize("roughness", FIBRE_ROUGHNESSES)
def test_normals_project_to_the_area(roughness: float) -> None:
    rng = np.random.default_rng(1)
    for _ in range(4):
        direction, tangent, _ = (row[0] for row in flakes.random_frames(rng, 1))
        light, solid_angle = flakes.light_grid(direction, tangent, roughness, (1000, 300))
        half = flakes.unit(light + direction)
        weight = solid_angle / 4  # |direction·h| dω_h
        density = fibre.density(vector(half), vector(tangent), jit.Float(roughness)).numpy()
        area = fibre.projected_area(vector(direction), vector(tangent), jit.Float(roughness)).numpy()[0]
        # The jittered grid's own error is 2e-4 at this size.
        assert np.sum(density * weight) == pytest.approx(area, rel=1e-3)
        assert area == pytest.approx(flakes.area(direction, tangent, roughness), rel=1e-5)


@pytest.mark.parametrize("roughness", FIBRE_ROUGHNESSES)
def test_sample_weights_are_values_over_density(roughness: float) -> None:
    rng = np.random.default_rng(3)
    view, normal, tangent = (vector(rows) for rows in flakes.random_frames(rng, 1 << 16, 0.5))
    u = jit.Array2f(rng.random((2, 1 << 16)).astype(np.float32))
    alpha, depth = jit.Float(roughness), 2.0
    light = fibre.sample_specular(view, tangent, alpha, u)
    assert np.abs(dr.norm(light).numpy() - 1).max() < 1e-6
    value = fibre.reflection(light, view, normal, tangent, alpha, depth)
    value += fibre.transmission(light, view, normal, tangent, alpha, depth)
    weight = (value / fibre.pdf_specular(light, view, tangent, alpha)).numpy()
    # In closed form, in float64: σ_o G/cos_o, where D has cancelled.
    light, view, normal, tangent = (rows.numpy().T.astype(float) for rows in (light, view, normal, tangent))
    slopes = [slope(direction, normal, tangent, roughness) for direction in (light, view)]
    total, apart = slopes[0] + slopes[1], np.abs(slopes[0] - slopes[1])
    turned = slopes[1] * -np.expm1(-depth * total) / total
    through = slopes[1] * np.exp(-depth * np.minimum(*slopes)) * -np.expm1(-depth * apart) / apart
    expected = np.where(np.sum(light * normal, 1) > 0, turned, through)
    # Slopes lose digits where a direction grazes: float32 cosines carry 1e-7 against 1e-3 here and there.
    np.testing.assert_allclose(weight, expected, rtol=2e-3, atol=2e-4)


def slope(direction: np.ndarray, normal: np.ndarray, tangent: np.ndarray, roughness: object) -> np.ndarray:
    """Λ in float64, written out."""
    along = np.sum(direction * tangent, 1)
    return np.sqrt(1 - (1 - roughness**2) * along**2) / np.abs(np.sum(direction * normal, 1))


def test_reflection_and_transmission_are_reciprocal() -> None:
    rng = np.random.default_rng(4)
    count = 1 << 14
    view, normal, tangent = (vector(rows) for rows in flakes.random_frames(rng, count, 0.8))
    light = vector(flakes.unit(rng.normal(size=(count, 3))))
    alpha = jit.Float(rng.uniform(0.01, 1, count).astype(np.float32))
    depth = jit.Float(rng.uniform(0.1, 5, count).astype(np.float32))
    cos_light, cos_view = dr.dot(light, normal), dr.dot(view, normal)
    there = fibre.reflection(light, view, normal, tangent, alpha, depth) / cos_light
    back = fibre.reflection(view, light, normal, tangent, alpha, depth) / cos_view
    np.testing.assert_allclose(there.numpy(), back.numpy(), rtol=2e-4, atol=1e-12)
    there = fibre.transmission(light, view, normal, tangent, alpha, depth) / -cos_light
    # Seen from the other side, whose normal is −n.
    back = fibre.transmission(view, light, -normal, tangent, alpha, depth) / cos_view
    assert np.count_nonzero(there.numpy()) > count // 3
    # e^{−x} of x up to 20 in float32.
    np.testing.assert_allclose(there.numpy(), back.numpy(), rtol=2e-4, atol=1e-12)


def test_stable_forms_agree_with_the_plain_ones_in_double() -> None:
    rng = np.random.default_rng(5)
    count = 1 << 14
    view, normal, tangent = flakes.random_frames(rng, count)
    # Transmission's Δ is small around the direction straight through.
    light = flakes.unit(-view + rng.normal(size=(count, 3)) * 10.0 ** rng.uniform(-3, 0.5, (count, 1)))
    alpha, depth = rng.uniform(0.01, 1, count), 10.0 ** rng.uniform(-2, 1, count)
    vectors = [vector(rows) for rows in (light, view, normal, tangent)]
    scalars = [jit.Float(values.astype(np.float32)) for values in (alpha, depth)]
    turned, through = (lobe(*vectors, *scalars).numpy() for lobe in (fibre.reflection, fibre.transmission))
    # What the float32 inputs say, in float64.
    light, view, normal, tangent = (rows.numpy().T.astype(float) for rows in vectors)
    alpha, depth = (values.numpy().astype(float) for values in scalars)
    q = 1 + np.sum(flakes.unit(light + view) * tangent, 1) ** 2 * (1 / alpha**2 - 1)
    slopes = [slope(direction, normal, tangent, alpha) for direction in (light, view)]
    total, apart = slopes[0] + slopes[1], np.abs(slopes[0] - slopes[1])
    common = 1 / (np.pi * alpha * q**2) / (4 * np.sum(view * normal, 1))
    above = np.sum(light * normal, 1) > 0
    expected_turned = np.where(above, common * -np.expm1(-depth * total) / total, 0)
    passed = np.exp(-depth * np.minimum(*slopes)) * -np.expm1(-depth * apart) / apart
    expected_through = np.where(above, 0, common * passed)
    for got, expected in ((turned, expected_turned), (through, expected_through)):
        # Where light ≈ −view within 1e-3, the half vector carries 1e-4, times 4 in q², times the steepness
        # of a narrow lobe; nearly everywhere else it is a hundred times better.
        error = np.abs(got - expected) / (np.abs(expected) + 1e-4)
        assert np.quantile(error, 0.99) < 3e-4
        assert error.max() < 3e-2


def hostile_inputs() -> tuple[jit.Array3f, jit.Array3f, jit.Array3f, jit.Array3f, jit.Float]:
    """Every combination of directions that make something vanish, with the smallest and largest α."""
    tiny = 1e-7
    special = flakes.unit(
        [[0, 0, 1], [0, 0, -1], [1, 0, 0], [-1, 0, 0], [0, 1, 0], [1, 0, tiny], [1, 0, -tiny], [0.6, 0, 0.8]]
    )
    frames = flakes.unit([[0, 0, 1], [1, 0, 0], [0.6, 0, 0.8], [0, 1, tiny]])
    alphas = np.array([0.01, 0.5, 1.0])
    index = np.indices((len(special), len(special), len(frames), len(frames), len(alphas))).reshape(5, -1)
    light, view, normal, tangent = (
        vector(rows[k]) for rows, k in zip((special, special, frames, frames), index, strict=False)
    )
    return light, view, normal, tangent, jit.Float(alphas[index[4]].astype(np.float32))


@pytest.mark.parametrize("depth", [1e-3, 2.0, 100.0])
def test_values_and_gradients_are_finite_for_every_input(depth: float) -> None:
    light, view, normal, tangent, roughness = hostile_inputs()
    optical_depth = dr.full(jit.Float, depth, dr.width(light))
    variables = (light, view, normal, tangent, roughness, optical_depth)
    u, mix = jit.Array2f(0.3, 0.6), jit.Array3f(1, 2, 3)
    functions = {
        "reflection": lambda: fibre.reflection(*variables),
        "transmission": lambda: fibre.transmission(*variables),
        "pdf": lambda: fibre.pdf_specular(light, view, tangent, roughness),
        "albedos": lambda: sum(fibre.layer_albedo_estimate(*variables[1:])),
        "sample": lambda: dr.dot(fibre.sample_specular(view, tangent, roughness, u), mix),
    }
    for name, function in functions.items():
        for variable in variables:
            dr.clear_grad(variable)
            dr.enable_grad(variable)
        value = function()
        assert np.isfinite(value.numpy()).all(), name
        dr.backward(dr.sum(value))
        for variable in variables:
            assert np.isfinite(dr.grad(variable).numpy()).all(), name
        dr.disable_grad(*variables)


@pytest.mark.parametrize("lobe", [fibre.reflection, fibre.transmission])
def test_gradients_agree_with_finite_differences(lobe: object) -> None:
    rng = np.random.default_rng(6)
    count = 500
    view, normal, tangent = flakes.random_frames(rng, count, 0.3)
    light = flakes.unit(rng.normal(size=(count, 3)))
    roughness, depth = rng.uniform(0.05, 1, count), rng.uniform(0.2, 4, count)
    # Not at the edges, where differences would mix in the other side.
    inside = (np.abs(np.sum(light * normal, 1)) > 0.02) & (np.linalg.norm(light + view, axis=1) > 0.05)
    arguments = [values[inside] for values in (light, view, normal, tangent, roughness, depth)]

    def arrays(values: list[np.ndarray]) -> list:
        return [jit.Array3f64(value.T) if value.ndim == 2 else jit.Float64(value) for value in values]

    inputs = arrays(arguments)
    dr.enable_grad(inputs)
    dr.backward(dr.sum(lobe(*inputs)))
    for number, argument in enumerate(arguments):
        derivative = dr.grad(inputs[number]).numpy().T
        move = rng.normal(size=argument.shape)
        step = 1e-6
        ahead, behind = (
            lobe(*arrays([*arguments[:number], argument + signed * move, *arguments[number + 1 :]])).numpy()
            for signed in (step, -step)
        )
        expected = derivative * move if argument.ndim == 1 else np.sum(derivative * move, 1)
        # Rounding of values up to 1e3 over the step, and the step squared.
        np.testing.assert_allclose((ahead - behind) / (2 * step), expected, rtol=1e-4, atol=1e-5)


def test_estimates_are_positive_and_near_the_albedos() -> None:
    rng = np.random.default_rng(8)
    count = 1 << 18
    view, normal, tangent = (vector(rows) for rows in flakes.random_frames(rng, count))
    u = jit.Array2f(rng.random((2, count)).astype(np.float32))
    for roughness, depth in itertools.product(FIBRE_ROUGHNESSES, (0.3, 2.0, 6.0)):
        alpha = jit.Float(roughness)
        light = fibre.sample_specular(view, tangent, alpha, u)
        pdf = fibre.pdf_specular(light, view, tangent, alpha)
        estimates = fibre.layer_albedo_estimate(view, normal, tangent, alpha, depth)
        for lobe, estimate in zip((fibre.reflection, fibre.transmission), estimates, strict=True):
            albedo = dr.mean(lobe(light, view, normal, tangent, alpha, depth) / pdf)[0]
            assert dr.min(estimate)[0] > 0
            # These only choose a lobe; what the docstring promises.
            assert 0.75 < dr.mean(estimate)[0] / albedo < 1.25
