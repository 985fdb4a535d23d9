"""A training is the same however often it is stopped, and learns what it is shown.

Covers: models/texture/latent_training.py, models/texture/queries.py
Covers: models/texture/btfs.py, training/direction_sampler.py
"""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import torch

from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.models.registry import btf_of
from loomlight.models.texture import training
from loomlight.models.texture.btfs import FabricBtf
from loomlight.models.texture.latent import half_vector_features
from loomlight.models.texture.latent_training import (
    LatentBatches,
    LatentNetwork,
    auxiliary_numbers,
    loss_of,
    rate_factor,
    train_auxiliary,
    train_latent,
)
from loomlight.models.texture.pyramid import PyramidShape
from loomlight.models.texture.queries import (
    FOUR_POINTS,
    EncodedBtf,
    LatentStream,
    Texels,
    cone_angles,
    draw_lights,
    footprint_values,
    spread_over_cones,
)
from loomlight.models.texture.settings import LATENT_QUALITIES, LatentOptions, LatentSettings
from loomlight.models.texture.training import TrainingFolder, folder_queries
from loomlight.scattering.lobe_mixture import lobe_mixture, mixture_density
from loomlight.sources.merl import BINS, library_of
from loomlight.training.direction_sampler import sampler_loss
from loomlight.training.layers import TORCH, relu_layers

require_llvm()

SCALARS = SimpleNamespace(log=math.log, sqrt=math.sqrt, maximum=max)

TWILL = fabric_from_text('weave = "twill 2/1"\n[warp]\ncolor = "#c04020"\n[weft]\ncolor = "#2040c0"')


def short(**changes: float | str) -> LatentSettings:
    base = replace(
        LATENT_QUALITIES["preview"],
        resolution=8,
        queries=4000,
        samples=2,
        steps=20,
        batch=256,
        sampler_steps=8,
    )
    return replace(base, **{"sampler_batch": 64, **changes})  # type: ignore[arg-type]  # any of its fields


def test_the_rungs_of_the_ablation(tmp_path: Path) -> None:
    plain = train_latent(TWILL, short(rung="mlp"), tmp_path / "mlp")
    assert plain.frames is None
    assert not (tmp_path / "mlp" / "encoder.safetensors").exists()
    with_encoder = train_latent(TWILL, short(rung="encoder", loss="cube-root"), tmp_path / "encoder")
    assert with_encoder.frames is None
    assert (tmp_path / "encoder" / "encoder.safetensors").exists()


@pytest.mark.slow
def test_queries_are_means_over_footprints() -> None:
    """Against many points of the point model around the query's position, on the face that is seen."""
    btf = FabricBtf(TWILL)
    texels = btf.texels(16)
    stream = LatentStream(btf, texels, 5, 256, seed=2)
    queries = stream.part(0, 40)
    assert np.array_equal(stream.part(0, 40).values, queries.values)
    assert not np.array_equal(stream.part(1, 40).positions, queries.positions)
    sides = np.where(queries.faces == 1, -1, 1)[:, None] * np.array([0, 0, 1]) + np.array([1, 1, 0])
    wanted = np.mean(
        [
            footprint_values(
                btf,
                texels,
                queries.positions,
                queries.levels,
                (queries.lights * sides).astype(np.float32),
                (queries.views * sides).astype(np.float32),
                (9, k),
            )
            for k in range(256)
        ],
        axis=0,
    )
    assert np.abs(queries.values - wanted).sum() < 0.1 * wanted.sum()
    assert abs(queries.values.sum() - wanted.sum()) < 0.03 * wanted.sum()


def test_inputs_of_the_encoder_are_filtered() -> None:
    reflectance = FabricBtf(TWILL).texels(8)
    finest = reflectance.encoder_inputs(0)
    assert finest.shape == (8, 8, len(reflectance.inputs))
    coarsest = reflectance.encoder_inputs(3)
    np.testing.assert_allclose(coarsest[0, 0], finest.mean(axis=(0, 1)), atol=1e-5)
    # Two thirds of the front are warp of a twill 2/1, of the back weft; -1 is weft and 1 warp.
    warp = reflectance.inputs.index("is_warp")
    assert coarsest[0, 0, warp] > 0.15 > -0.15 > reflectance.encoder_inputs(3, 1)[0, 0, warp]
    # Normals that vary have second moments beyond the squares of their means.
    x, xx = (reflectance.inputs.index(name) for name in ("normal_x", "normal_xx"))
    assert coarsest[0, 0, xx] > coarsest[0, 0, x] ** 2 + 0.02
    assert np.abs(finest).max() < 2


def test_half_vectors_find_highlights() -> None:
    views = np.tile(np.array([[0.6, 0.0, 0.8]], np.float32), (20_000, 1))
    lights = draw_lights(np.random.default_rng(0), views)
    np.testing.assert_allclose(np.linalg.norm(lights, axis=1), 1, atol=1e-5)
    assert (lights[:, 2] > 0).all()
    # Within 5° of the mirror direction: 0.4 % of the hemisphere.
    assert (lights @ np.array([-0.6, 0.0, 0.8]) > math.cos(math.radians(5))).mean() > 0.1


def test_lights_lie_about_the_normals_of_texels() -> None:
    """Mirror directions about a normal that leans by 20°, and by none, of two maps."""
    views = np.tile(np.array([[0.0, 0.0, 1.0]], np.float32), (20_000, 1))
    lean = math.tan(math.radians(20))
    lights = draw_lights(
        np.random.default_rng(0), views, np.tile(np.array([-lean, 0], np.float32), (20_000, 1))
    )
    mirrored = np.array([math.sin(math.radians(40)), 0, math.cos(math.radians(40))])
    near = math.cos(math.radians(5))
    assert (lights @ mirrored > near).mean() > 0.1
    assert (lights @ np.array([0.0, 0.0, 1.0]) > near).mean() < 0.02
    # Yarns lean to all sides alike.
    reflectance = FabricBtf(TWILL).texels(8)
    assert reflectance.slopes.shape == (2, 1, 8, 8, 2)
    assert np.abs(reflectance.slopes).max() > 0.2
    np.testing.assert_allclose(reflectance.slopes.mean(axis=(1, 2, 3)), 0, atol=0.02)


def test_one_cosine_leads_through_encoder_and_textures(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    rates = []

    def kept(*arguments: Any, **_others: Any) -> None:
        rate = arguments[3].rate
        rates.append((rate(0.0), rate(1.0)))

    monkeypatch.setattr(training, "train", kept)
    settings = short()
    train_latent(TWILL, settings, tmp_path)
    encoder, textures, sampler, _ = rates
    share = settings.encoder_share
    assert encoder == pytest.approx((settings.rate, settings.rate * rate_factor(share)))
    assert textures == pytest.approx((encoder[1], 0.1 * settings.rate))
    assert sampler == pytest.approx((settings.rate, 0.1 * settings.rate))


def test_libraries_take_many_small_steps_and_no_frames(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    steps = []
    monkeypatch.setattr(training, "train", lambda *arguments, **_others: steps.append(arguments[3].steps))
    values = np.zeros((3, *BINS, 3), np.float16)
    weights = train_latent(library_of("shelf", ["a", "b", "c"], values), short(), tmp_path)
    assert sum(steps[:2]) == 4 * short().steps
    assert (weights.frames, weights.shape.is_apart, len(weights.latents)) == (None, True, 4)


def test_the_rate_follows_the_supplemental_and_damaged_queries_are_taken_anew(tmp_path: Path) -> None:
    assert rate_factor(0) == 1
    assert rate_factor(1) == pytest.approx(0.1)
    btf = FabricBtf(TWILL)
    stream = LatentStream(btf, btf.texels(8), 4, 2, seed=0)
    first = folder_queries(stream, tmp_path, "some", 4000)
    (file,) = tmp_path.iterdir()
    file.write_bytes(file.read_bytes()[:-100])
    again = folder_queries(stream, tmp_path, "some", 4000)
    assert np.array_equal(first.values, again.values)


def test_published_is_the_papers() -> None:
    """Section 1 of the supplemental, and listing 2, whose decoder is given no features."""
    published = LatentOptions(quality="published").settings()
    assert (published.loss, published.optimiser, published.features) == ("log", "adam", "none")
    assert (published.steps, published.mollified_steps) == (300_000, 20_000)
    assert (published.rate, published.rate * rate_factor(1)) == pytest.approx((1e-3, 1e-4))
    # What is chosen stands above the quality; shorter trainings keep the shares of their phases.
    shorter = LatentOptions(
        quality="published", steps=30_000, batch=4096, queries=1 << 20, loss="cube-root", mollified=False
    ).settings()
    assert (shorter.steps, shorter.batch, shorter.queries) == (30_000, 4096, 1 << 20)
    assert (shorter.loss, shorter.mollified_queries) == ("cube-root", 0)
    assert LatentOptions(quality="published", steps=30_000).settings().mollified_steps == 2000


def test_the_loss_of_the_paper_is_of_logarithms() -> None:
    predicted, truth = torch.tensor([[0.0, 1.0, 3.0]]), torch.tensor([[1.0, 1.0, 0.0]])
    wanted = (math.log(2) + 0 + math.log(4)) / 3
    assert float(loss_of(predicted, truth, "log")) == pytest.approx(wanted, rel=1e-6)


def test_cones_narrow_as_the_supplemental_says() -> None:
    """Equation 2: half of 10° · (1 + cos(π i / M))."""
    angles = np.degrees(cone_angles(np.arange(1200), 1000))
    wanted = [0.5 * 10 * (1 + math.cos(math.pi * (i + 0.5) / 1000)) for i in (0, 250, 500, 999)]
    assert angles[[0, 250, 500, 999]] == pytest.approx(wanted, rel=1e-5, abs=1e-5)
    assert not angles[1000:].any()
    assert not cone_angles(np.arange(10), 0).any()


def test_directions_of_cones_are_uniform_in_them() -> None:
    axis = np.array([0.48, -0.36, 0.8], np.float32)
    count, angle = 20_000, math.radians(10)
    rng = np.random.default_rng(0)
    drawn = spread_over_cones(rng, np.tile(axis, (count, 1)), np.full(count, angle, np.float32))
    np.testing.assert_allclose(np.linalg.norm(drawn, axis=1), 1, atol=1e-5)
    cosines = drawn.astype(np.float64) @ axis
    assert cosines.min() > math.cos(angle) - 1e-6
    # Uniform in solid angle is uniform in the cosine; 0.01 is five standard errors of the mean.
    done = (1 - cosines) / (1 - math.cos(angle))
    assert done.mean() == pytest.approx(0.5, abs=0.01)
    assert (done < 0.1).mean() == pytest.approx(0.1, abs=0.01)
    # To all sides alike: the mean lies on the axis.
    np.testing.assert_allclose(drawn.mean(axis=0), axis * cosines.mean(), atol=0.005)
    # None of a light at the horizon gets below.
    low = np.tile(np.array([1, 0, 0.03], np.float32) / np.float32(math.hypot(1, 0.03)), (count, 1))
    assert (spread_over_cones(rng, low, np.full(count, angle, np.float32))[:, 2] > 0).all()


class _Lobe(EncodedBtf):
    """f·cos of one sharp lobe about the normal's mirror direction, on a grey base, alike everywhere."""

    extent = (1.0, 1.0)

    def values(self, points: Any, lights: Any, views: Any, seed: Any) -> Any:
        mirror = views * np.array([-1, -1, 1], np.float32)
        lobe = np.exp(-400 * (1 - (lights * mirror).sum(axis=1)))
        return np.repeat((lights[:, 2] / math.pi + 4 * lobe)[:, None], 3, axis=1).astype(np.float32)

    def texels(self, resolution: int) -> Texels:
        return _FlatTexels()


class _FlatTexels(Texels):
    inputs, resolution, sigma = ("constant",), (8, 8), np.zeros(2, np.float32)
    slopes = np.zeros((1, 1, 1, 1, 2), np.float32)

    def encoder_inputs(self, level: int, face: int = 0) -> Any:
        return np.ones((8 >> level, 8 >> level, 1), np.float32)


def test_mollified_values_are_means_over_cones() -> None:
    """The first query has nearly 10°: against means over another draw, with 20 times as many lights."""
    btf, count = _Lobe(), 200
    part = LatentStream(btf, btf.texels(8), 4, 1, seed=1, mollified=1 << 20).part(0, count)
    rng, many = np.random.default_rng(5), 20 * 256
    lights = np.repeat(part.lights, many, axis=0)
    lights = spread_over_cones(rng, lights, np.full(len(lights), math.radians(10), np.float32))
    wanted = btf.values(None, lights, np.repeat(part.views, many, axis=0), None)
    wanted = wanted.reshape(count, many, 3).mean(axis=1)
    # 256 lights of a value leave noise of 4 % on average, of 200 values 0.3 %.
    assert np.abs(part.values - wanted).sum() < 0.08 * wanted.sum()
    assert part.values.sum() == pytest.approx(wanted.sum(), rel=0.015)
    sharp = LatentStream(btf, btf.texels(8), 4, 1, seed=1).part(0, count)
    np.testing.assert_array_equal(part.lights, sharp.lights)
    assert np.abs(sharp.values - wanted).sum() > 0.2 * wanted.sum()


def test_mollified_values_become_the_sources_as_cones_narrow() -> None:
    btf, rng, count = _Lobe(), np.random.default_rng(3), 400
    views = np.repeat(draw_lights(rng, np.tile(np.array([0, 0, 1], np.float32), (count, 1))), 256, axis=0)
    lights = np.repeat(draw_lights(rng, views[::256]), 256, axis=0)
    truth = btf.values(None, lights[::256], views[::256], None)
    errors = []
    for degrees in (10.0, 3.0, 1.0, 0.1):
        spread = spread_over_cones(rng, lights, np.full(len(lights), math.radians(degrees), np.float32))
        means = btf.values(None, spread, views, None).reshape(count, 256, 3).mean(axis=1)
        errors.append(np.abs(means - truth).sum() / truth.sum())
    # The mean over a cone is off by its squared half-angle, until noise is left: a tenth of it a hundredth.
    assert errors[0] > 2 * errors[1] > 8 * errors[2] > 40 * errors[3]
    assert errors[3] < 1e-3
    still = spread_over_cones(rng, lights, np.zeros(len(lights), np.float32))
    np.testing.assert_allclose(still, lights, atol=1e-6)


class _Glints(EncodedBtf):
    """Flakes, a hundredth of all points, that shine as bright as makes 1 of the mean."""

    extent = (1.0, 1.0)

    def values(self, points: Any, lights: Any, views: Any, seed: Any) -> Any:
        cells = np.floor(points * 10_000).astype(np.int64)
        flake = (cells[:, 0] * 7919 + cells[:, 1] * 104_729) % 100 == 0
        return np.repeat(np.where(flake, 100.0, 0.0)[:, None], 3, axis=1).astype(np.float32)

    def texels(self, resolution: int) -> Texels:
        return _CheapTexels()


class _CheapTexels(_FlatTexels):
    sigma, turns = np.full(2, 0.02, np.float32), FOUR_POINTS


def test_most_values_of_coarse_footprints_are_near_the_mean() -> None:
    """Losses of logarithms and of cube roots learn medians: of footprints of many glints that is the mean."""
    queries = LatentStream(_Glints(), _CheapTexels(), 4, 8, seed=0).part(0, 4000)
    coarse = queries.values[queries.levels >= 2, 0]
    # 256 points show 2.6 glints, whose median is 2 of them; of 32 points most show none.
    assert np.median(coarse) > 0.7 * coarse.mean()
    assert coarse.mean() == pytest.approx(1, abs=0.1)


def test_fine_footprints_and_dear_points_have_the_estimates_of_the_settings() -> None:
    cheap = LatentStream(_Glints(), _CheapTexels(), 4, 8, seed=0)._samples
    assert list(cheap) == [8, 32, 64, 64]
    assert list(LatentStream(_Lobe(), _FlatTexels(), 4, 8, seed=0)._samples) == [8] * 4
    assert list(LatentStream(_Glints(), _CheapTexels(), 3, 100, seed=0)._samples) == [100] * 3


def test_features_resolve_a_polished_glaze() -> None:
    """Half vectors at the width of a lobe of roughness 0.0036, the median of the glaze, and at its middle."""

    def feature(tangent: float) -> float:
        half = np.array([tangent, 0.0, 1.0]) / math.hypot(tangent, 1)
        view = half
        (first, *_) = half_vector_features([(view, half)], view, half, SCALARS)
        return float(first)

    # A quarter of the logarithm of what the distance grows by: double there, and nearly nothing before.
    assert feature(0.0036) - feature(0.0) > 0.25 * math.log(2)


def test_steps_learn_from_cones_first_and_from_the_others_afterwards() -> None:
    queries = LatentStream(_Lobe(), _FlatTexels(), 4, 1, seed=0).part(0, 3000)
    settings = short(queries=3000, steps=30, batch=100, mollified=1 / 3)
    network = torch.nn.Linear(1, 1)
    batches = LatentBatches(network, queries, settings, "cpu", first=4)
    chosen = [batches._chosen(step) for step in range(26)]
    assert all(len(each) == 100 for each in chosen)
    # Steps 4 to 9 of 10 go along the thousand mollified queries.
    middles = [each.mean() for each in chosen[:6]]
    assert middles == sorted(middles)
    assert max(each.max() for each in chosen[:6]) < 1000
    # Then a pass over the other two thousand.
    assert sorted(np.concatenate(chosen[6:])) == list(range(1000, 3000))


def test_a_mollified_training_goes_on_where_it_stopped(tmp_path: Path) -> None:
    settings = short(mollified=0.5, queries=600, batch=64)
    whole = train_latent(TWILL, settings, tmp_path / "whole")
    plain = train_latent(TWILL, short(queries=600, batch=64), tmp_path / "plain")
    assert not np.array_equal(whole.latents, plain.latents)
    assert np.array_equal(train_latent(TWILL, settings, tmp_path / "whole").latents, whole.latents)


def test_a_sampler_finds_an_off_centre_lobe() -> None:
    """The reflectance is itself a mixture of the family, so the divergence can vanish."""
    torch.manual_seed(0)
    target = lobe_mixture(torch.tensor([-1.0, -0.3, 0.4, 0.3, -0.2, 0.0, 0.0, 1.5, 0.0]), TORCH)
    sampler, albedo = relu_layers((3, 16, 9)), relu_layers((3, 16, 3))
    optimiser = torch.optim.Adam([*sampler.parameters(), *albedo.parameters()], 1e-2)
    generator = torch.Generator().manual_seed(1)
    views = torch.nn.functional.normalize(torch.tensor([[0.3, 0.1, 1.0], [-0.4, 0.5, 1.0]]), dim=1)
    repeated = views.repeat(16, 1)

    def reflected(lights: torch.Tensor) -> torch.Tensor:
        eye = [column[:, None] for column in repeated.T]
        density = mixture_density(target, lights.unbind(-1), eye, TORCH)
        return (0.5 * density)[..., None].expand(-1, -1, 3)

    for _ in range(200):
        outputs, log_albedo = sampler(repeated), albedo(repeated)
        loss = sampler_loss(outputs, log_albedo, repeated, reflected, 64, generator)
        optimiser.zero_grad()
        loss.backward()
        optimiser.step()
    found = lobe_mixture(sampler(views).detach().unbind(1), TORCH)
    for view in range(2):
        for axis in range(2):
            assert found.alpha[axis][view] == pytest.approx(float(target.alpha[axis]), rel=0.25)
            assert found.specular_slope[axis][view] == pytest.approx(
                float(target.specular_slope[axis]), abs=0.1
            )
    # Half of the light, less what the lobe sends below the surface.
    assert ((torch.exp(albedo(views)) > 0.3) & (torch.exp(albedo(views)) < 0.52)).all()


def test_a_source_without_queries_is_refused() -> None:
    with pytest.raises(TypeError, match="is no kind of source"):
        btf_of(Path("a"), "latent")  # type: ignore[arg-type]  # no source: that is what is refused


@pytest.mark.slow
def test_guides_of_denoisers_are_learned_from_lobes_and_albedos(tmp_path: Path) -> None:
    """Roughness and normal of the lobes that the sampler has where it is seen from above."""
    torch.manual_seed(4)
    shape = PyramidShape(8, 8, 1.0, 1.0, 1)
    network = LatentNetwork(shape, np.ones((shape.texels, 1), np.float32), (16, 16), True, True, 1.0)
    with torch.no_grad():
        network.latents.normal_()
        # Rough texels and smooth ones, that lean.
        network.sampler[-1].weight.mul_(15)
        network.albedo[-1].weight.mul_(3)
    run = TrainingFolder(tmp_path, "none")
    settings = short(sampler_steps=1000, sampler_batch=256)
    auxiliary = train_auxiliary(network, settings, run)
    latent = network.latents[:64]
    with torch.no_grad():
        found = auxiliary_numbers(auxiliary(latent))
        outputs, _ = network.sampler_outputs(latent, torch.tensor([[0.0, 0.0, 1.0]]).expand(64, 3))
        lobes = lobe_mixture(outputs.unbind(1), TORCH)
        alpha = (lobes.alpha[0] * lobes.alpha[1]).sqrt() * (1 - lobes.correlation**2) ** 0.25
        wanted = 1 - lobes.specular_share * (1 - alpha)
        lean = lobes.specular_share * lobes.specular_slope[0]
        lean += (1 - lobes.specular_share) * lobes.diffuse_slope[0]
    assert float(wanted.std()) > 0.05
    # What is learned explains four fifths of the deviations.
    for actual, expected in ((found[:, 3], wanted), (found[:, 4], lean)):
        assert float((actual - expected).std()) < 0.45 * float(expected.std())
        assert float(actual.mean()) == pytest.approx(float(expected.mean()), abs=0.1)
    assert (train_auxiliary(network, settings, run)[0].weight == auxiliary[0].weight).all()


def test_trainings_that_differ_in_networks_alone_share_queries(tmp_path: Path) -> None:
    shared = tmp_path / "queries"
    for number, settings in enumerate(
        (short(), short(decoder="2x16", rung="encoder", steps=4), short(seed=1))
    ):
        train_latent(TWILL, settings, tmp_path / str(number), shared=shared)
        assert len(list(shared.iterdir())) == (1 if number < 2 else 2)
        assert not list((tmp_path / str(number)).glob("queries*"))
