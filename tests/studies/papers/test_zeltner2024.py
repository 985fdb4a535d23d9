"""The figures of zeltner2024, small: trainings of a few steps, three materials of four left out.

Covers: studies/papers/zeltner2024/analytic_baseline.py, studies/papers/zeltner2024/polar.py
Covers: studies/papers/zeltner2024/learning_curve.py
Covers: studies/papers/zeltner2024/sampling.py, studies/papers/zeltner2024/stage.py
Covers: studies/papers/zeltner2024/tables.py, studies/papers/zeltner2024/two_normals.py
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import nullcontext
from dataclasses import replace

import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Array3f, Float
from numpy.typing import NDArray

from loomlight.core.footprint import Footprint
from loomlight.mitsuba import choose_variant
from loomlight.mitsuba.material_btf import MaterialBtf
from loomlight.models.interface import Model
from loomlight.models.texture.settings import LATENT_QUALITIES, LatentSettings
from loomlight.sources.merl import MerlLibrary
from studies.harness.study import Run, stored_tables
from studies.papers.zeltner2024 import (
    analytic_baseline,
    learning_curve,
    polar,
    sampling,
    stage,
    tables,
    two_normals,
)
from studies.papers.zeltner2024.analytic_brdfs import analytic_library


@pytest.fixture
def settings(monkeypatch: pytest.MonkeyPatch) -> stage.StageSettings:
    """One material with few texels, and trainings that learn next to nothing."""
    choose_variant()
    monkeypatch.setitem(
        LATENT_QUALITIES,
        "preview",
        LatentSettings(queries=1 << 12, samples=1, steps=4, batch=256, sampler_steps=4),
    )
    return stage.StageSettings(size=(24, 16), spp=4, steps=6, resolution=16, materials="rough-plastic")


@pytest.mark.parametrize("name", two_normals.TWO_NORMALS)
def test_two_normal_maps_lean_by_more_than_lobes_are_wide(name: str) -> None:
    normals = [2 * texels - 1 for texels in two_normals.two_normal_maps(name, 64)]
    for normal in normals:
        assert 8 < np.median(np.degrees(np.arccos(normal[..., 2].clip(-1, 1)))) < 15
    between = np.degrees(np.arccos((normals[0] * normals[1]).sum(axis=-1).clip(-1, 1)))
    # α of the wider lobe is 0.1: 6°.
    assert np.median(between) > 12
    btf = MaterialBtf(two_normals.two_normal_material(name, 32))
    assert btf.texels(32).slopes.shape == (1, 3, 32, 32, 2)
    up = np.tile(np.float32([[0, 0, 1]]), (64, 1))
    places = np.random.default_rng(1).random((64, 2)).astype(np.float32)
    assert btf.values(places, up, up, (0,)).max() > 0.5


def tiny_model(settings: stage.StageSettings, run: Run) -> Model:
    return stage.trained(stage.stage_material("rough-plastic", 16), settings, run.runs)


@pytest.mark.slow
def test_ablation_has_six_metrics_of_each_rung(settings: stage.StageSettings, run: Run) -> None:
    actual = tables.ablation(settings, run)
    summary, paper, one = stored_tables(actual.figures)
    assert summary.columns == ["Vanilla MLP", "with encoder", "with frame transform"]
    assert paper.rows["teapot ceramic"] == [0.3343, 0.2552, 0.1362]
    assert list(one.rows) == list(stage.METRICS)
    assert all(np.isfinite(cell) for row in one.rows.values() for cell in row)
    # Trainings are kept.
    assert len(list((run.runs / "zeltner2024").glob("*.loom"))) == 3


def test_gains_of_frames_are_carried_on_by_a_power_of_the_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    def errors(_source: object, shown: stage.StageSettings, _run: Run, rung: str) -> list[float]:
        assert shown.steps is not None
        return [2.0 if rung == "encoder" else shown.steps**-0.5] * 6

    monkeypatch.setattr(learning_curve, "_errors", errors)
    chosen = replace(learning_curve.STUDY.settings, steps=10_000, materials="rough-plastic")
    found = learning_curve.learning_curve(chosen, Run())
    gain, flip, _ = learning_curve.STUDY.tables(found.figures)
    columns = ["1000 steps", "3000 steps", "10000 steps", "300000 steps, extrapolated"]
    assert gain.columns == columns
    assert flip.rows["rough-plastic, with encoder"] == pytest.approx([2, 2, 2, 2], rel=1e-5)
    wanted = [steps**0.5 * 2 for steps in (1000, 3000, 10_000, 300_000)]
    # Records keep six digits.
    assert gain.rows["rough-plastic, Mean FLIP"] == pytest.approx(wanted, rel=1e-5)


@pytest.mark.slow
def test_the_whole_sphere_of_the_default_network(settings: stage.StageSettings, run: Run) -> None:
    summary, one = stored_tables(tables.whole(settings, run).figures)
    assert summary.columns == one.columns == ["2×32"]
    assert summary.rows["Mean FLIP"][0] == pytest.approx(one.rows["Mean FLIP"][0])
    assert one.title == "rough-plastic, whole"


def test_six_errors_are_what_they_are_called() -> None:
    reference = np.full((4, 4, 3), 0.5, np.float32)
    picture = reference + np.float32(0.1)
    actual = stage.six_errors(picture, reference, np.ones((4, 4), bool)).metrics
    expected = (0.1, 0.01, 0.1 / 0.51, 0.01 / 0.26, 0.2 / 1.11)
    assert actual[1:] == pytest.approx(expected, rel=1e-5)


@pytest.mark.slow
def test_sampler_is_compared_with_cosine_and_reference(settings: stage.StageSettings, run: Run) -> None:
    actual = sampling.sampler_variance(settings, run)
    alone, both, cost = stored_tables(actual.figures)
    assert alone.columns == ["cosine", "learned sampler", "reference's own", "gain"]
    assert set(cost.rows) == set(both.rows) == {"rough-plastic"}
    assert len(actual.pictures) == 6


def test_cosine_directions_have_the_density_that_they_say(settings: stage.StageSettings, run: Run) -> None:
    model = sampling.cosine_sampled(tiny_model(settings, run))
    rng = np.random.default_rng(2)
    count = 20000
    nothing = Array2f(0)
    view = Array3f(np.tile([[0.6], [0.0], [0.8]], count).astype(np.float32))
    at = model.at(view, Footprint(Array2f(np.zeros((2, count), np.float32)), nothing, nothing))
    drawn = at.sample(Float(0.5), Array2f(rng.random((2, count)).astype(np.float32)))
    # The cosine's mean under its own density is 2/3; five standard errors.
    assert abs(np.array(drawn.light.z).mean() - 2 / 3) < 5 * 0.24 / np.sqrt(count)
    np.testing.assert_allclose(np.array(drawn.pdf), np.array(drawn.light.z) / np.pi, rtol=1e-4)
    weight, value = np.array(drawn.weight), np.array(at.value(drawn.light))
    np.testing.assert_allclose(weight * np.array(drawn.pdf), value, rtol=1e-3, atol=1e-6)


def test_polar_plots_show_every_place(
    settings: stage.StageSettings, run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(polar, "PLACES", ((0.3, 0.4),))
    actual = polar.polar_plots(replace(settings, spp=2), run)
    places = {"0.3, 0.4 at 15°", "0.3, 0.4 at 60°"}
    decoders = {"2×16", "2×32", "3×64"}
    assert set(actual.pictures) == {f"rough-plastic, {size}-{at}" for size in decoders for at in places}
    # Black, blue and orange lines on white.
    assert len(np.unique(next(iter(actual.pictures.values())).reshape(-1, 3), axis=0)) >= 4


@pytest.mark.slow
def test_libraries_have_a_plot_of_each_brdf(
    settings: stage.StageSettings, monkeypatch: pytest.MonkeyPatch
) -> None:
    del settings  # its trainings alone
    library = analytic_library(3)
    monkeypatch.setattr(polar, "library_of_settings", lambda _settings: nullcontext(library))
    monkeypatch.setattr(polar, "profile_of", exact_profile(library))
    actual = polar.library_plots(replace(polar.STUDIES[0].settings, steps=1), Run())
    (table,) = stored_tables(actual.figures)
    assert (actual.figures["brdfs"], actual.figures["decoder"]) == (3, "3x64")
    # Networks are replaced by a tenth of the truth, densities by the truth.
    assert table.rows["network / BRDF"] == pytest.approx([1, 1, 1, 1], abs=1e-6)
    assert table.rows["density / network"] == pytest.approx([0, 0, 0, 0], abs=1e-6)
    assert actual.sheet is not None
    assert actual.sheet.shape[1] >= 3 * 200


def exact_profile(library: MerlLibrary) -> Callable[..., polar.Profile]:
    count = iter(range(len(library.names)))

    def profile(_at: object, reference: NDArray[np.float32], view_degrees: float) -> polar.Profile:
        # The BRDF of the cell that is asked for, and no other.
        lights, views = polar.plane_of_incidence(view_degrees)
        truth = library.evaluate(np.full(len(lights), next(count)), lights, views)
        np.testing.assert_array_equal(reference, truth)
        mean = truth.mean(axis=1).astype(np.float64)
        return polar.Profile(np.linspace(-1.5, 1.5, len(mean)), 0.7, mean, 0.1 * mean, 3 * mean)

    return profile


def test_eight_channels_learn_a_diffuse_material(monkeypatch: pytest.MonkeyPatch) -> None:
    from loomlight.sources.material import material_from_xml

    choose_variant()
    body = '<bsdf type="diffuse"><rgb name="reflectance" value="0.6 0.3 0.1"/></bsdf>'
    source = material_from_xml(f'<scene version="3.0.0">{body}</scene>', ".", "red", (100, 100))
    monkeypatch.setattr(analytic_baseline, "_BATCH", 1 << 10)
    channels = analytic_baseline.fitted_channels(source, 16, 250)
    assert channels.shape == (1, 1, 8)
    colour = 1 / (1 + np.exp(-channels[0, 0, :3]))
    np.testing.assert_allclose(colour, [0.6, 0.3, 0.1], atol=0.06)
