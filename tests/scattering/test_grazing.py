"""The rise of highlights towards grazing: the formula written out, what diffuse light loses, and energy."""

from __future__ import annotations

import math

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Array3f, Float

from loomlight.core.llvm import require_llvm
from loomlight.evaluation.isotropic import Pairs, turned_value
from loomlight.fabric import Fabric, fabric_from_text
from loomlight.scattering.fibre import pdf_specular, reflection, sample_specular
from loomlight.scattering.grazing import Grazing
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from studies.accuracy.interreflection import direction
from studies.accuracy.interreflection_furnace import returned
from studies.instruments.turned_cloth import turned_terms
from tests.helpers.arrays import vectors
from tests.helpers.directions import directions
from tests.marks import slow

require_llvm()


def cloth(grazing: float, colour: str, weave: str = "twill 2/2", specular: float = 0.5) -> Fabric:
    yarn = f'albedo = "{colour}"\nspecular = {specular}\nspecular_grazing = {grazing}\n'
    return fabric_from_text(f'weave = "{weave}"\n[warp]\n{yarn}[weft]\n{yarn}')


def test_it_is_schlicks_about_the_half_vector() -> None:
    rng = np.random.default_rng(1)
    light, view = directions(rng, 200), directions(rng, 200)
    light[:, 2], view[:, 2] = abs(light[:, 2]), abs(view[:, 2])
    grazing = Grazing.of(2.5, 0.3)
    half = light + view
    half /= np.linalg.norm(half, axis=1, keepdims=True)
    expected = 2.5 * (1 - (half * view).sum(axis=1)) ** 5
    np.testing.assert_allclose(grazing.rise(vectors(light), vectors(view)).numpy(), expected, atol=2e-6)
    # In the mirror's direction the half vector is the normal.
    mirrored = 2.5 * (1 - view[:, 2]) ** 5
    np.testing.assert_allclose(grazing.rise_towards(vectors(view)).numpy(), mirrored, atol=2e-6)
    losses = [1 - grazing.loss * (1 - each[:, 2]) ** 4 for each in (light, view)]
    kept = grazing.kept(vectors(light), vectors(view)).numpy()
    np.testing.assert_allclose(kept, losses[0] * losses[1], atol=2e-6)


def test_the_rise_has_a_finite_derivative_where_light_is_opposite() -> None:
    light = Array3f(Float(0), Float(0), Float([-1, -0.999999, -0.99]))
    dr.enable_grad(light)
    rise = Grazing.of(2.0, 0.3).rise(light, Array3f(0, 0, 1))
    dr.backward(rise)
    # Of the cosine the root of 1e-8 is left.
    assert rise.numpy()[0] == pytest.approx(2, rel=1e-3)
    # 5 g times half of the derivative of the root, 1e4 at most.
    assert (abs(dr.grad(light).numpy()) < 5e4).all()


@pytest.mark.parametrize("roughness", [0.02, 0.1, 0.3, 0.6, 1.0])
def test_diffuse_light_loses_what_a_layer_reflects_of_the_rise(roughness: float) -> None:
    """Of tangents in the plane, at views to 85°; a quarter of it at least is used."""
    count = 1 << 14
    rng = np.random.default_rng(3)
    u = Array2f(rng.random((2, count)).astype(np.float32))
    grazing, alpha, normal = Grazing.of(1.0, roughness), Float(roughness), Array3f(0, 0, 1)
    used = []
    for degrees in (60, 75, 85):
        view = Array3f(*(float(part) for part in direction(degrees, 0)))
        reflected = []
        for turn in np.radians(np.arange(0, 180, 30)):
            tangent = Array3f(math.cos(turn), math.sin(turn), 0)
            light = sample_specular(view, tangent, alpha, u)
            value = reflection(light, view, normal, tangent, alpha, Float(2.0)) * grazing.rise(light, view)
            density = pdf_specular(light, view, tangent, alpha)
            reflected.append(float(np.nan_to_num((value / density).numpy()).mean(dtype=float)))
        used.append(max(reflected) / (grazing.loss * (1 - math.cos(math.radians(degrees))) ** 4))
    # 16,384 directions leave a hundredth of noise.
    assert 0.25 < max(used) < 1.03, used


def test_cloth_gains_the_rise_times_its_highlights() -> None:
    """Models know it as one factor: of `lobes` with the rise all follows from its terms without."""
    rng = np.random.default_rng(5)
    light, view = (directions(rng, 300) for _ in range(2))
    light[:, 2], view[:, 2] = abs(light[:, 2]), abs(view[:, 2])
    pairs = Pairs(light, view)
    plain, rising = cloth(0, "#703020"), cloth(3.0, "#703020")
    appearance = rising.appearance()
    grazing, albedos = appearance.grazing, appearance.warp
    terms = turned_terms(plain, pairs, 3)
    rise = 3.0 * (1 - np.sqrt(0.5 + 0.5 * (light * view).sum(axis=1))) ** 5
    kept = np.prod([1 - grazing.loss * (1 - each[:, 2]) ** 4 for each in (light, view)], axis=0)
    red = terms.specular * (albedos.specular_reflect[0, 0] + rise)
    between = turned_value(plain, pairs, 3)[:, 0] - terms.specular * albedos.specular_reflect[0, 0]
    # What is no highlight loses a share.
    expected = red + kept * between
    # Single precision, and means over the turns.
    risen = turned_value(rising, pairs, 3)[:, 0]
    np.testing.assert_allclose(risen, expected, atol=2e-5)
    assert (risen / turned_value(plain, pairs, 3)[:, 0]).max() > 1.2


@pytest.mark.parametrize("weave", ["plain", slow("twill 2/2"), slow("satin 5/2")])
def test_white_cloth_gets_no_brighter_by_it(weave: str) -> None:
    """Of all light that falls on white cloth from everywhere no more comes back than without the rise."""
    for degrees in (0, 60, 80):
        seen = []
        for grazing in (0.0, 4.0):
            fabric = cloth(grazing, "#fff", weave, 1.0)
            model = YarnScattering(YarnGeometry(fabric.layout()), fabric.appearance())
            seen.append(returned(model, fabric.repeat_mm, direction(degrees, 30), 3, 1 << 14))
        # 16,384 weights leave half a hundredth of noise.
        assert seen[1] < max(seen[0], 1) + 0.01, (degrees, seen)


def test_families_share_the_mean_of_theirs() -> None:
    text = 'weave = "plain"\n[warp]\nspecular_grazing = 3\nroughness = 0.2\n[weft]\nroughness = 0.4'
    grazing = fabric_from_text(text).appearance().grazing
    assert grazing.gain == 1.5
    assert grazing.loss == pytest.approx(Grazing.of(1.5, 0.3).loss)
