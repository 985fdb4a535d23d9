"""Components and colours against the point model itself; the light they may return."""

from __future__ import annotations

import math

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array2f64, Array3f, Bool, Float

from loomlight.aggregate.components import (
    colours,
    components,
    lobes,
    trace_views,
    without_sheen_and_variation,
)
from loomlight.core.footprint import Box, Footprint, box_footprint
from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.scattering.point import YarnScattering
from loomlight.scattering.sheen import sheen_with_transmittance
from loomlight.yarn.geometry import YarnGeometry
from studies.instruments.reference import reference
from tests.helpers.directions import directions

from .fabrics import NAMES, woven

require_llvm()

COUNT = 20_000


def _vectors(vectors: np.ndarray) -> Array3f:
    return Array3f(np.ascontiguousarray(vectors.T, dtype=np.float32))


def _places(model: YarnScattering, rng: np.random.Generator, count: int) -> tuple[Float, Float]:
    width, height = model.surface.size
    return Float(rng.uniform(0, width, count)), Float(rng.uniform(0, height, count))


@pytest.mark.quick("twill 3/1")
@pytest.mark.parametrize("name", NAMES)
def test_colours_are_the_point_models_values(name: str) -> None:
    rng = np.random.default_rng(0)
    model = without_sheen_and_variation(woven(name, (0.2, 0.5), sheen=0.5))
    light, view = _vectors(directions(rng, COUNT)), _vectors(directions(rng, COUNT))
    point = trace_views(model, *_places(model, rng, COUNT), view).point
    visible = model.visibility(point, light)
    ours = colours(model.appearance, point, light, view, visible).numpy()
    np.testing.assert_allclose(ours, model.evaluate(point, light, view).numpy(), rtol=1e-5, atol=1e-7)


def test_colours_have_light_between_yarns() -> None:
    rng = np.random.default_rng(4)
    fabric = fabric_from_text('weave = "twill 2/1"\n[warp]\ncolor = "#c04020"\n[weft]\ncolor = "#ffffff"')
    model = YarnScattering(YarnGeometry(fabric.layout()), fabric.appearance())
    light, view = _vectors(directions(rng, COUNT)), _vectors(directions(rng, COUNT))
    point = trace_views(model, *_places(model, rng, COUNT), view).point
    visible = model.visibility(point, light)
    ours = colours(model.appearance, point, light, view, visible).numpy()
    assert (ours[:, ~visible.numpy() & ~point.hole.numpy()] > 0).all()
    np.testing.assert_allclose(ours, model.evaluate(point, light, view).numpy(), rtol=1e-5, atol=1e-7)


@pytest.mark.quick("twill 3/1")
@pytest.mark.parametrize("name", NAMES)
def test_components_with_the_albedos_are_the_colours(name: str) -> None:
    rng = np.random.default_rng(1)
    model = woven(name, (0.2, 0.5))
    light, view = _vectors(directions(rng, COUNT)), _vectors(directions(rng, COUNT))
    point = trace_views(model, *_places(model, rng, COUNT), view).point
    visible = model.visibility(point, light)
    parts = [part.numpy() for part in components(model.appearance, point, light, view, visible)]
    reflects = (light.z * view.z > 0).numpy()
    albedos = point.albedos
    diffuse = np.where(reflects, albedos.diffuse_reflect.numpy(), albedos.diffuse_transmit.numpy())
    specular = np.where(reflects, albedos.specular_reflect.numpy(), albedos.specular_transmit.numpy())
    total = diffuse * (parts[0] + parts[1]) + specular * (parts[2] + parts[3])
    expected = colours(model.appearance, point, light, view, visible).numpy()
    np.testing.assert_allclose(total, expected, rtol=1e-5, atol=1e-7)
    # Each point belongs to one family.
    assert not (parts[0] * parts[1]).any()
    assert not (parts[2] * parts[3]).any()


@pytest.mark.parametrize("transmits", [False, True])
def test_lobes_of_a_known_side_are_the_same(transmits: bool) -> None:
    rng = np.random.default_rng(2)
    model = woven("twill 3/1")
    views = directions(rng, COUNT)
    lights = directions(rng, COUNT)
    lights[:, 2] = np.copysign(lights[:, 2], -views[:, 2] if transmits else views[:, 2])
    light, view = _vectors(lights), _vectors(views)
    point = trace_views(model, *_places(model, rng, COUNT), view).point
    known = lobes(model.appearance, point, light, view, transmits)
    for one, other in zip(known, lobes(model.appearance, point, light, view), strict=True):
        np.testing.assert_array_equal(one.numpy(), other.numpy())


def test_walls_are_rare_from_above_and_stand_below_the_surface() -> None:
    rng = np.random.default_rng(3)
    for name, degrees, low, high in (
        ("plain", 0.0, 0.0, 1e-4),
        ("plain", 60.0, 0.005, 0.06),
        ("satin 5/2", 60.0, 0.03, 0.4),
    ):
        model = woven(name)
        angle = math.radians(degrees)
        view = Array3f(0.8 * math.sin(angle), 0.6 * math.sin(angle), math.cos(angle)) + dr.zeros(
            Array3f, COUNT
        )
        met = trace_views(model, *_places(model, rng, COUNT), view)
        share = met.wall.numpy().mean()
        assert low <= share <= high
        assert not (met.wall & met.point.hole).numpy().any()


@pytest.mark.quick("False-twill 3/1", "True-plain")
@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("back", [False, True])
def test_no_view_gets_more_light_than_there_is(name: str, back: bool) -> None:
    """White threads, shadows left out, light from everywhere: at most 1 for every view, holes included."""
    rng = np.random.default_rng(4)
    model = woven(name, (0.1, 0.6))
    view = np.repeat(directions(rng, 12, back), COUNT, axis=0)
    count = len(view)
    z = rng.uniform(-1, 1, count)
    azimuth = rng.uniform(0, 2 * math.pi, count)
    radius = np.sqrt(1 - z**2)
    light = np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), z], axis=1)
    eye, towards = _vectors(view), _vectors(light)
    point = trace_views(model, *_places(model, rng, count), eye).point
    parts = components(model.appearance, point, towards, eye, Bool(True))
    values = sum(part.numpy() for part in (*parts[:2],)), sum(part.numpy() for part in (*parts[2:],))
    hole = point.hole.numpy().reshape(12, -1).mean(axis=1)
    # The bound: k_d_reflect + k_d_transmit + κ·k_s ≤ 1 with κ = (1 + e^{−2})/2 (docs/research/scattering.md).
    for diffuse, specular in ((1.0, 0.0), (0.43, 1.0), (0.5, 0.88)):
        weight = np.where((light * view)[:, 2] > 0, 0.5, 0.5) * diffuse
        samples = (4 * math.pi * (weight * values[0] + specular * values[1])).reshape(12, -1)
        mean = samples.mean(axis=1) + hole
        deviation = samples.std(axis=1) / math.sqrt(COUNT)
        assert (mean < 1 + 4 * deviation).all()


@pytest.mark.slow
def test_the_reference_is_the_mean_of_the_point_model_over_the_parallelogram() -> None:
    rng = np.random.default_rng(5)
    model = woven("twill 3/1", sheen=0.4)
    count, samples = 40, 4000
    draft = max(model.surface.size)
    centre, duv_dx, duv_dy = (
        Array2f64(rng.normal(size=(2, count)) * draft * scale) for scale in (1, 0.5, 0.5)
    )
    footprint = Footprint(centre, duv_dx, duv_dy)
    lights, views = directions(rng, count), directions(rng, count)
    estimate = reference(model, footprint, lights, views, samples, seed=1)
    plain = without_sheen_and_variation(model)
    s, t = rng.random((2, count, samples)) - 0.5
    places = (
        footprint.centre.numpy()[..., None] + s * duv_dx.numpy()[..., None] + t * duv_dy.numpy()[..., None]
    )
    x, y = (Float(part.ravel().astype(np.float32)) for part in places)
    light, view = (_vectors(np.repeat(vectors, samples, axis=0)) for vectors in (lights, views))
    point = plain.locate(x, y, view)
    values = plain.evaluate(point, light, view).numpy().reshape(3, count, samples)
    hole = point.hole.numpy().reshape(count, samples)
    own_variance = np.array([part.var(axis=1) / samples for part in values]).T
    scores = (estimate.colour - values.mean(axis=2).T) / np.sqrt(
        estimate.variance[:, 5:8] + own_variance + 1e-12
    )
    assert np.abs(scores).max() < 4.5
    assert abs(scores[:, 1].std() - 1) < 4 / math.sqrt(2 * count)
    spread = np.sqrt(2 * estimate.variance[:, 4] + 1e-6)
    assert (np.abs(estimate.hole - hole.mean(axis=1)) < 5 * spread).all()
    # Sheen over the footprint is the lobe times light visibility and hole, over what it lets through.
    with_sheen = model.evaluate(model.locate(x, y, view), light, view).numpy().reshape(3, count, samples)
    strength, roughness = model.sheen
    front = [np.c_[v[:, :2], v[:, 2] * np.sign(views[:, 2])] for v in (lights, views)]
    lobe, through = sheen_with_transmittance(*(_vectors(v) for v in front), strength, roughness)
    scale = (estimate.light_visibility + estimate.hole)[:, None]
    expected = through.numpy()[:, None] * estimate.colour + lobe.numpy()[:, None] * scale
    own_variance = np.array([part.var(axis=1) / samples for part in with_sheen]).T
    # Colour and light visibility are of the same points: their deviations add up at most.
    deviation = np.sqrt(estimate.variance[:, 5:8]) + lobe.numpy()[:, None] * np.sqrt(
        estimate.variance[:, 4:5] + estimate.variance[:, 8:]
    )
    scores = (expected - with_sheen.mean(axis=2).T) / np.sqrt(deviation**2 + own_variance + 1e-12)
    assert np.abs(scores).max() < 4.5
    assert (np.abs(lobe.numpy()) > 1e-3).mean() > 0.25


@pytest.mark.slow
def test_variances_are_those_of_repeated_estimates() -> None:
    rng = np.random.default_rng(6)
    model = woven("plain")
    box = Box(Array2f64([0.3, 0.2]), Array2f64([0.9, 0.5]))
    light, view = directions(rng, 1, False)[0], directions(rng, 1, False)[0]
    estimates = [reference(model, box_footprint(box), light, view, 500, seed) for seed in range(100)]
    means = np.array([estimate.mean[0] for estimate in estimates])
    variances = np.mean([estimate.variance[0] for estimate in estimates], axis=0)
    # The variance of 100 values is uncertain by sqrt(2/99) = 14 %.
    np.testing.assert_allclose(means.var(axis=0, ddof=1), variances, rtol=0.6)


@pytest.mark.slow
def test_estimates_do_not_depend_on_batches(monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(7)
    model = woven("plain")
    box = Box(Array2f64(rng.random((2, 9))), Array2f64(rng.random((2, 9))))
    lights, views = directions(rng, 9), directions(rng, 9)
    whole = reference(model, box_footprint(box), lights, views, 64, seed=3)
    monkeypatch.setattr("studies.instruments.reference._BATCH", 128)
    parts = reference(model, box_footprint(box), lights, views, 64, seed=3)
    np.testing.assert_allclose(parts.mean, whole.mean, rtol=1e-6)
