"""The point model as a whole: its sampler, its energy, its faces, for fabrics of all parameter ranges.

Covers: scattering/appearance.py
"""

from __future__ import annotations

import math

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest

from loomlight.core.llvm import require_llvm
from loomlight.scattering.albedo import albedos_from_colour, layer_albedo_bound
from loomlight.scattering.appearance import Appearance, FamilyAppearance, Sheen, Variation
from loomlight.scattering.point import YarnPoint, YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout, FamilyLayout
from loomlight.yarn.visibility import HorizonMap
from studies.instruments.tabulated_visibility import TabulatedScattering
from tests.marks import slow

require_llvm()
mi.set_variant("llvm_ad_rgb")


def _family_layout(rng: np.random.Generator, count: int) -> FamilyLayout:
    spacing = rng.uniform(0.1, 0.5) * rng.uniform(0.6, 1, count)
    return FamilyLayout(
        spacing,
        spacing * rng.uniform(0.4, 1.0, count),
        math.radians(rng.uniform(0, 80)),
        math.radians(rng.uniform(-89, 89)),
        rng.uniform(0.01, 2),
    )


def _family_appearance(rng: np.random.Generator, count: int, white: bool, depth: float) -> FamilyAppearance:
    colour = np.ones((count, 3)) if white else rng.random((count, 3))
    if rng.random() < 0.5:
        albedos = albedos_from_colour(colour, rng.random(), rng.random(), depth)._asdict()
    else:
        # Explicit albedos that use the admitted bound up.
        highlight = rng.random((count, 3))
        diffuse = 1 - layer_albedo_bound(depth) * highlight
        share = rng.random()
        albedos = {
            "diffuse_reflect": diffuse * share,
            "diffuse_transmit": diffuse * (1 - share),
            "specular_reflect": highlight,
            "specular_transmit": highlight,
        }
    return FamilyAppearance(**albedos, roughness=float(np.exp(rng.uniform(math.log(0.01), 0))))


def random_model(seed: int, white: bool = False) -> YarnScattering:
    """A random fabric of all parameter ranges, warp and weft unequal."""
    rng = np.random.default_rng(seed)
    picks, ends = (int(n) for n in rng.integers(2, 9, 2))
    layout = ClothLayout(
        rng.random((picks, ends)) < 0.5, _family_layout(rng, ends), _family_layout(rng, picks)
    )
    depth = float(np.exp(rng.uniform(math.log(0.05), math.log(20))))
    appearance = Appearance(
        _family_appearance(rng, ends, white, depth),
        _family_appearance(rng, picks, white, depth),
        sheen=Sheen(rng.random() * (seed % 2), rng.random()),
        variation=Variation(rng.random(), rng.random(), seed) if seed % 3 == 0 else Variation(),
        # Data of kernels instead of constants in them: fabrics with the same lobes share kernels.
        diffuse_blend=dr.opaque(mi.Float, rng.random()),
        # The bound on varied albedos is computed from the depth in Python.
        optical_depth=depth if seed % 3 == 0 else dr.opaque(mi.Float, depth),
    )
    model = YarnScattering(YarnGeometry(layout), appearance)
    if model.sheen is not None:
        model.sheen = dr.opaque(mi.Float, model.sheen[0]), dr.opaque(mi.Float, model.sheen[1])
    return model


def _view(degrees: float, azimuth: float) -> mi.Vector3f:
    angle = math.radians(degrees)
    # Opaque, as the numbers of fabrics.
    return dr.opaque(
        mi.Vector3f,
        [math.sin(angle) * math.cos(azimuth), math.sin(angle) * math.sin(azimuth), math.cos(angle)],
    )


def _points(model: YarnScattering, view: mi.Vector3f, count: int, seed: int) -> tuple[YarnPoint, mi.Vector3f]:
    # Its own stream: places must not correlate with the numbers that directions are drawn from.
    rng = np.random.default_rng([seed, 77])
    width, height = model.surface.size
    x, y = mi.Float(rng.uniform(0, width, count)), mi.Float(rng.uniform(0, height, count))
    direction = view + dr.zeros(mi.Vector3f, count)
    point = model.locate(x, y, direction)
    dr.eval(point)
    return point, direction


# Near the normal, oblique, grazing, and the same from behind.
VIEWS = (5.0, 35.0, 60.0, 80.0, 88.0, 100.0, 135.0, 172.0)


@pytest.mark.quick("0-35.0", "1-80.0", "2-135.0", "3-60.0", "4-5.0", "5-172.0")
@pytest.mark.parametrize("degrees", VIEWS)
@pytest.mark.parametrize("seed", range(6))
def test_directions_are_distributed_by_their_density(seed: int, degrees: float) -> None:
    model = random_model(seed)
    rng = np.random.default_rng(seed)
    view = _view(degrees, rng.uniform(0, 2 * math.pi))
    # A yarn point that is no hole; the test is about its directions, so it is one for all samples.
    candidates, _ = _points(model, view, 64, seed)
    chosen = int(np.argmin(candidates.hole.numpy()))
    x, y = (dr.opaque(mi.Float, float(each[chosen])) for each in (candidates.x, candidates.y))
    back = dr.opaque(mi.Bool, bool(candidates.back[chosen]))

    def point_for(count: int) -> tuple[YarnPoint, mi.Vector3f]:
        # Shadows scale the weight alone, not the density: their search is left out here.
        point = model.at(
            x + dr.zeros(mi.Float, count),
            y + dr.zeros(mi.Float, count),
            back | dr.full(mi.Bool, False, count),
            dr.full(mi.Bool, False, count),
        )
        return point, view + dr.zeros(mi.Vector3f, count)

    def sample(numbers: mi.Vector3f) -> tuple[mi.Vector3f, mi.Float]:
        point, direction = point_for(dr.width(numbers))
        drawn = model.sample(point, direction, numbers.x, mi.Vector2f(numbers.y, numbers.z))
        return drawn.light, dr.full(mi.Float, 1, dr.width(numbers))

    def density(light: mi.Vector3f) -> mi.Float:
        point, direction = point_for(dr.width(light))
        return model.pdf(point, light, direction)

    test = mi.chi2.ChiSquareTest(
        domain=mi.chi2.SphericalDomain(),
        sample_func=sample,
        pdf_func=density,
        sample_dim=3,
        sample_count=300_000,
        res=101,
        ires=24,  # lobes of α = 0.01 are narrower than a bin: the density is integrated finely
        seed=seed,
    )
    # 48 tests at this level: a false alarm once in twenty runs of the suite, were the seeds not fixed.
    assert test.run(significance_level=0.01, test_count=48, quiet=True), test.messages


@pytest.mark.parametrize("seed", range(8))
def test_weight_is_value_over_density(seed: int) -> None:
    model = random_model(seed)
    rng = np.random.default_rng(seed)
    for degrees in (20.0, 75.0, 120.0):
        count = 20_000
        point, view = _points(model, _view(degrees, rng.uniform(0, 6)), count, seed)
        numbers = [mi.Float(rng.random(count)) for _ in range(3)]
        drawn = model.sample(point, view, numbers[0], mi.Vector2f(numbers[1], numbers[2]))
        dr.eval(drawn)
        value = model.evaluate(point, drawn.light, view).numpy()
        density = model.pdf(point, drawn.light, view).numpy()
        smooth = ~drawn.is_null.numpy() & (density > 0)
        weight = drawn.weight.numpy()
        expected = value[:, smooth] / density[smooth]
        # Two kernels round differently; a light direction in a shadow's edge may then change its mind.
        near = np.isclose(weight[:, smooth], expected, rtol=2e-3, atol=1e-5).all(axis=0)
        assert near.mean() > 0.9995
        assert np.allclose(drawn.pdf.numpy()[smooth], density[smooth], rtol=2e-3)
        assert np.isfinite(weight).all()


@pytest.mark.slow
@pytest.mark.parametrize("batch", [0, slow(1), slow(2)])
def test_cloth_never_sends_back_more_than_it_gets(batch: int) -> None:
    """White furnace over all ranges, point by point; `studies/accuracy/white_furnace.py` goes further."""
    for seed in range(10 * batch, 10 * batch + 10):
        model = random_model(seed, white=True)
        rng = np.random.default_rng(seed)
        degrees = np.degrees(np.arccos(rng.uniform(-1, 1)))
        places, each = 64, 4096
        view = _view(degrees, rng.uniform(0, 6))
        spots, _ = _points(model, view, places, seed)
        # Every place is sampled many times, so that no average hides a single bright point.
        index = dr.repeat(dr.arange(mi.UInt32, places), each)
        point = model.at(
            dr.gather(mi.Float, spots.x, index),
            dr.gather(mi.Float, spots.y, index),
            dr.gather(mi.Bool, spots.back, index),
            dr.gather(mi.Bool, spots.hole, index),
        )
        numbers = [mi.Float(rng.random(places * each)) for _ in range(3)]
        direction = view + dr.zeros(mi.Vector3f, places * each)
        drawn = model.sample(point, direction, numbers[0], mi.Vector2f(numbers[1], numbers[2]))
        weight = drawn.weight.numpy().reshape(3, places, each)
        assert np.isfinite(weight).all()
        mean = weight.mean(axis=2)
        error = weight.std(axis=2) / math.sqrt(each)
        # 30 fabrics, 64 places, 3 channels: 5760 comparisons, of which none may pass 5 deviations.
        assert (mean <= 1 + 5 * error + 1e-4).all(), (seed, mean.max())


@pytest.mark.slow
def test_sampling_and_uniform_directions_agree_on_the_albedo() -> None:
    for seed in range(6):
        model = random_model(seed)
        rng = np.random.default_rng(seed)
        count = 1 << 18
        for degrees in (30.0, 115.0):
            point, view = _points(model, _view(degrees, 1.0), count, seed)
            numbers = [mi.Float(rng.random(count)) for _ in range(5)]
            drawn = model.sample(point, view, numbers[0], mi.Vector2f(numbers[1], numbers[2]))
            sampled = np.where(drawn.is_null.numpy(), 0, drawn.weight.numpy())
            light = mi.warp.square_to_uniform_sphere(mi.Point2f(numbers[3], numbers[4]))
            uniform = model.evaluate(point, light, view).numpy() * 4 * math.pi
            difference = sampled.mean(axis=1) - uniform.mean(axis=1)
            deviation = np.sqrt((sampled.var(axis=1) + uniform.var(axis=1)) / count)
            assert (np.abs(difference) < 4.5 * deviation + 1e-6).all(), (seed, degrees)


def test_holes_pass_light_straight_through() -> None:
    rng = np.random.default_rng(1)
    family = FamilyLayout(np.full(2, 0.4), np.full(2, 0.2), 0.4, 0.0, 1.0)
    grey = np.full((2, 3), 0.4)
    threads = FamilyAppearance(grey, grey * 0, grey, grey * 0, 0.3)
    plain = np.array([[True, False], [False, True]])
    bare = Appearance(threads, threads)
    model = YarnScattering(YarnGeometry(ClothLayout(plain, family, family)), bare)
    point, view = _points(model, _view(0.0, 0.0), 100_000, 1)
    numbers = [mi.Float(rng.random(100_000)) for _ in range(3)]
    drawn = model.sample(point, view, numbers[0], mi.Vector2f(numbers[1], numbers[2]))
    passes = drawn.is_null.numpy()
    assert (passes == point.hole.numpy()).all()
    assert abs(passes.mean() - 0.25) < 4 * math.sqrt(0.25 * 0.75 / 100_000)
    assert np.allclose(drawn.light.numpy()[:, passes], -np.array([[0], [0], [1]]))
    assert np.allclose(drawn.weight.numpy()[:, passes], 1)
    assert np.allclose(model.straight_through(point, view).numpy(), passes)


@pytest.mark.slow
def test_tabulated_shadows_keep_the_albedo() -> None:
    exact = random_model(2)
    layout = YarnGeometry(exact.surface.layout)
    tabulated = TabulatedScattering(layout, exact.appearance, HorizonMap(layout, (160, 160), mi.Float))
    rng = np.random.default_rng(3)
    count = 1 << 16
    point, view = _points(exact, _view(30, 0.3), count, 4)
    light = mi.warp.square_to_cosine_hemisphere(
        mi.Point2f(mi.Float(rng.random(count)), mi.Float(rng.random(count)))
    )
    values = [model.evaluate(point, light, view).numpy().mean() for model in (exact, tabulated)]
    # Coarse azimuths and texels move shadow edges, not the mean; 3 % is what 16 azimuths admit.
    assert abs(values[1] / values[0] - 1) < 0.03
    assert values[1] != values[0]
