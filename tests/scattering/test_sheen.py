"""The sheen: its energy and its weights; its lobe is held to the published tables in tests/tools/fits."""

from __future__ import annotations

import drjit as dr
import drjit.llvm.ad as jit
import numpy as np
import pytest

from loomlight.scattering import sheen as module
from loomlight.scattering.sheen import (
    sample_sheen,
    sheen,
    sheen_lobe,
    sheen_pdf,
    sheen_transmittance,
    sheen_with_transmittance,
)
from tests.helpers.lobes import SHEENS, jittered_upper_half, view_at
from tests.helpers.references import microflakes as flakes


@pytest.mark.parametrize(("cos_view", "roughness"), SHEENS)
def test_the_weight_is_the_reflectance(cos_view: float, roughness: float) -> None:
    """For every sample; that samples follow their density, tests/contract asks."""
    u = jit.Array2f(np.random.default_rng(5).random((2, 1 << 14)).astype(np.float32))
    view = view_at(cos_view)
    light = sample_sheen(view, roughness, u)
    weight = (sheen(light, view, 0.8, roughness) / sheen_pdf(light, view, roughness)).numpy()
    np.testing.assert_allclose(weight, 0.8 * sheen_lobe(view.z, roughness)[2].numpy()[0], rtol=1e-5)


@pytest.mark.parametrize(("cos_view", "roughness"), SHEENS)
def test_what_the_sheen_takes_it_returns(cos_view: float, roughness: float) -> None:
    view = view_at(cos_view)
    grid, solid_angle = jittered_upper_half()
    value = sheen(jit.Array3f(grid.T.astype(np.float32)), view, 0.8, roughness).numpy()
    returned = np.sum(value * solid_angle)
    assert returned + sheen_transmittance(view, 0.8, roughness).numpy()[0] == pytest.approx(1, abs=1e-3)


def test_combined_evaluation_is_the_same() -> None:
    light, view = view_at(0.3, 0.2), view_at(0.6)
    both = sheen_with_transmittance(light, view, 0.5, 0.3)
    assert dr.all(both[0] == sheen(light, view, 0.5, 0.3))
    assert dr.all(both[1] == sheen_transmittance(view, 0.5, 0.3))


def test_lobe_stays_in_its_range() -> None:
    axis = np.linspace(0, 1, 301).astype(np.float32)
    cos_view, roughness = (jit.Float(grid.ravel()) for grid in np.meshgrid(axis, axis, indexing="ij"))
    a, b, reflectance = (value.numpy() for value in sheen_lobe(cos_view, roughness))
    assert a.min() >= 0.01
    assert a.max() <= 1
    assert b.max() <= 0
    assert b.min() >= -0.25
    assert np.all(b[cos_view.numpy() == 1] == 0)
    assert reflectance.min() >= 0
    assert reflectance.max() < 0.76


@pytest.mark.parametrize("azimuth", np.linspace(0, 6, 5))
def test_turning_the_frame_changes_nothing(azimuth: float) -> None:
    value = [
        sheen(view_at(0.4, 1.0 + turn), view_at(0.2, turn), 1.0, 0.5).numpy()[0] for turn in (0, azimuth)
    ]
    assert value[0] == pytest.approx(value[1], rel=1e-5)


def test_nothing_below_the_cloth() -> None:
    below = jit.Array3f(0.6, 0, -0.8)
    assert sheen(below, view_at(0.5), 1.0, 0.5).numpy()[0] == 0
    assert sheen(view_at(0.5), below, 1.0, 0.5).numpy()[0] == 0


def test_values_and_gradients_are_finite_for_every_input() -> None:
    directions = flakes.unit(
        [[0, 0, 1], [1, 0, 0], [1, 0, 1e-7], [1e-11, 0, 1], [1e-9, 1e-9, 1], [0, 1, -1e-7], [0, 0, -1]]
    )
    roughnesses = np.array([0.0, 0.01, 0.5, 1.0], dtype=np.float32)
    index = np.indices((len(directions), len(directions), len(roughnesses))).reshape(3, -1)
    light, view = (jit.Array3f(directions[k].T.astype(np.float32)) for k in index[:2])
    roughness, strength = jit.Float(roughnesses[index[2]]), jit.Float(1)
    functions = {
        "value": lambda: sum(sheen_with_transmittance(light, view, strength, roughness)),
        "pdf": lambda: sheen_pdf(light, view, roughness),
        "sample": lambda: dr.sum(sample_sheen(view, roughness, jit.Array2f(0.0, 0.3))),
    }
    for name, function in functions.items():
        variables = (light, view, roughness, strength)
        for variable in variables:
            dr.clear_grad(variable)
            dr.enable_grad(variable)
        value = function()
        assert np.isfinite(value.numpy()).all(), name
        dr.backward(dr.sum(value))
        for variable in variables:
            assert np.isfinite(dr.grad(variable).numpy()).all(), name
        dr.disable_grad(*variables)


def test_gradients_agree_with_finite_differences() -> None:
    light, view = flakes.unit([0.3, -0.5, 0.4]), flakes.unit([-0.2, 0.7, 0.5])

    def value(light: np.ndarray, view: np.ndarray, roughness: float) -> jit.Float64:
        return module.sheen(jit.Array3f64(light), jit.Array3f64(view), 0.7, jit.Float64(roughness))

    inputs = jit.Array3f64(light), jit.Array3f64(view), jit.Float64(0.3)
    dr.enable_grad(inputs)
    dr.backward(module.sheen(*inputs[:2], 0.7, inputs[2]))
    step, move = 1e-6, np.array([0.3, 0.5, -0.8])
    for number, (ahead, behind) in enumerate(
        (
            (value(light + step * move, view, 0.3), value(light - step * move, view, 0.3)),
            (value(light, view + step * move, 0.3), value(light, view - step * move, 0.3)),
            (value(light, view, 0.3 + step), value(light, view, 0.3 - step)),
        )
    ):
        derivative = dr.grad(inputs[number]).numpy()
        expected = derivative[0] if number == 2 else np.sum(derivative.ravel() * move)
        # Constants of the closed form have seven digits either way; the rest is rounding over the step.
        assert (ahead - behind).numpy()[0] / (2 * step) == pytest.approx(expected, rel=1e-6)
