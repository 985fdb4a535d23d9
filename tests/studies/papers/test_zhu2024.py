"""The figures of zhu2024, small: scenes, equal quality, sampling, parallax, sheen and the choice of α.

Covers: studies/instruments/altered_models.py, studies/papers/zhu2024/control.py
Covers: studies/papers/zhu2024/cylinder.py, studies/papers/zhu2024/sampling.py
Covers: studies/papers/zhu2024/scenes.py, studies/papers/zhu2024/sheen.py
Covers: studies/papers/zhu2024/table1.py, studies/papers/zhu2024/storage.py
Covers: studies/papers/zhu2024/summed_areas.py
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Array3f, Float

from loomlight.core.errors import InputError
from loomlight.core.footprint import Footprint
from loomlight.mitsuba import choose_variant
from loomlight.models.point import PointModel
from loomlight.models.registry import make_model
from studies.harness.command import main
from studies.harness.record import read_record
from studies.harness.study import Run, stored_tables
from studies.instruments.altered_models import uniformly_sampled, without_parallax
from studies.papers.setting import PictureSettings
from studies.papers.zhu2024 import control, cylinder, sheen, storage, summed_areas, table1
from studies.papers.zhu2024.scenes import (
    FABRICS,
    SCENES,
    ClothSettings,
    TableSettings,
    table_composition,
    table_fabric,
)


def at_random(count: int) -> tuple[Footprint, Array3f, np.random.Generator]:
    """Footprints on the diamond, and views of its front."""
    rng = np.random.default_rng(3)
    fabric = table_fabric("diamond")
    place = (rng.random((2, count)) * np.array(fabric.repeat_mm)[:, None]).astype(np.float32)
    view = rng.normal(size=(3, count))
    view[2] = np.abs(view[2]) + 0.4
    view /= np.linalg.norm(view, axis=0)
    nothing = Array2f(0)
    return Footprint(Array2f(place), nothing, nothing), Array3f(view.astype(np.float32)), rng


def test_scenes_are_those_of_the_table() -> None:
    choose_variant()
    assert [scene.name for scene in SCENES.values()] == [
        "Couch",
        "Blouse",
        "Evening gown",
        "Cloth cylinder",
        "Draping fabric",
        "Blouse, point light",
        "Evening gown, point light",
    ]
    used = {fabric for scene in SCENES.values() for _, fabric in scene.pieces}
    assert used == set(FABRICS)
    assert table_fabric("sheer").layout().open_area > 0.3
    for scene in SCENES.values():
        with_cv, without = scene.paper.samples
        assert 30 < without / with_cv < 100
        assert len(table_composition(scene).pieces) == len(scene.pieces)


def test_uniform_directions_have_the_models_mean() -> None:
    """Mean weights of both samplers are the same albedo; values are the model's."""
    count = 1 << 15
    footprint, view, rng = at_random(count)
    model = make_model("point", table_fabric("diamond"))
    at, uniform = model.at(view, footprint), uniformly_sampled(model).at(view, footprint)
    light = Array3f(rng.normal(size=(3, count)).astype(np.float32))
    light = dr.normalize(light)
    assert dr.all(dr.all(at.value(light) == uniform.value(light)))
    numbers = [Float(rng.random(count, dtype=np.float32)) for _ in range(3)]
    albedos = []
    for bsdf in (at, uniform):
        weight = bsdf.sample(numbers[0], Array2f(numbers[1], numbers[2])).weight.y.numpy()
        albedos.append((weight.mean(), weight.std() / np.sqrt(count)))
    (one, one_error), (other, other_error) = albedos
    assert abs(one - other) < 4 * np.hypot(one_error, other_error)
    assert other_error > one_error


def test_without_parallax_hidden_points_are_dark() -> None:
    footprint, view, rng = at_random(1 << 12)
    model = make_model("point", table_fabric("diamond"))
    assert isinstance(model, PointModel)
    light = Array3f(0.0, 0.6, 0.8)
    flat, right = without_parallax(model).at(view, footprint), model.at(view, footprint)
    dark, lit = (np.mean((at.value(light).y == 0).numpy()) for at in (flat, right))
    assert dark > lit + 0.05
    numbers = [Float(rng.random(1 << 12, dtype=np.float32)) for _ in range(3)]
    drawn = flat.sample(numbers[0], Array2f(numbers[1], numbers[2]))
    assert np.isfinite(drawn.weight.numpy()).all()
    # Straight from above nothing is hidden, and nothing moved but to the tubes of yarns that dive.
    above = Array3f(0.0, 0.0, 1.0)
    same = [at.at(above, footprint).value(light).y.numpy() for at in (without_parallax(model), model)]
    assert np.mean(np.abs(same[0] - same[1]) > 1e-4) < 0.04


def test_errors_that_no_longer_fall_are_noise() -> None:
    assert table1._falling({1: 1.0, 4: 0.25, 16: 0.3, 64: 0.01}) == {1: 1.0, 4: 0.25}
    assert table1._falling({1: 1.0, 4: -0.1}) == {1: 1.0, 4: 0.25}


@pytest.mark.slow
def test_equal_quality_of_a_scene(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(table1, "_TURNS", 1)
    # Every count of samples is a kernel of its own.
    monkeypatch.setattr(table1, "_POINT_SAMPLES", (1, 4, 16))
    itself = TableSettings(size=(32, 20), spp=32, model="point")
    result = table1.measured(SCENES["cylinder"], itself)
    (surface,) = result.surfaces
    (way,) = surface.ways
    assert way.model.samples == 2
    assert set(surface.point_errors) == {1, 4, 16}
    # The point model needs as many samples as it has; 600 pixels tell that to a third.
    assert way.samples_ratio == pytest.approx(1, rel=0.35)
    assert way.samples_ratio == pytest.approx(way.samples / 2)
    assert min(way.seconds, way.model.seconds, result.lobes.seconds) > 0
    found = table1._found([result], itself)
    assert stored_tables(found.figures)[0].rows["Cloth cylinder, point"][4] == pytest.approx(32.5)
    assert {f"Cloth cylinder-{column}" for column in ("point", "lobes, 1 sample", "truth")} <= set(
        found.pictures
    )


@pytest.mark.slow
def test_both_ways_are_of_one_surface(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of each surface, with and without: fewer samples by two texels than by one, and bytes of the tables."""
    monkeypatch.setattr(table1, "_TURNS", 1)
    monkeypatch.setattr(table1, "_POINT_SAMPLES", (1, 4, 16))
    settings = TableSettings(size=(48, 27), spp=16, visibility="saturating,unsaturated")
    result = table1.measured(SCENES["cylinder"], settings)
    assert [[way.label for way in surface.ways] for surface in result.surfaces] == [
        ["2 texels", "1 texel"],
        ["2 texels, unsaturated", "1 texel, unsaturated"],
    ]
    for surface in result.surfaces:
        two, one = surface.ways
        assert two.samples_ratio > one.samples_ratio > 3
        assert one.scene_share is not None
        assert one.own_ratio is not None
        assert 0 < one.scene_share < 1
        assert one.own_ratio > one.samples_ratio
    saturating, other = (table1.baked("cylinder twill", kind).tables.texels for kind in (True, False))
    # The first three numbers are the axis times the amplitude.
    amplitude = np.linalg.norm(other[..., :3].astype(float), axis=-1)
    assert amplitude.max() < 1.001
    assert np.linalg.norm(saturating[..., :3].astype(float), axis=-1).max() > 2
    (storage,) = [
        table
        for table in stored_tables(table1._found([result], settings).figures)
        if table.title == "Storage"
    ]
    assert storage.rows["Cloth cylinder"][1] < storage.rows["Cloth cylinder"][4]


@pytest.mark.slow
@pytest.mark.usefixtures("height_field_alone")
def test_parallax_is_the_height_fields(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cylinder, "_VERTICES_A_THREAD", 12)
    monkeypatch.setattr(cylinder, "_VIEWS", cylinder._VIEWS[:1])
    found = cylinder.parallax(ClothSettings(size=(24, 16), spp=16, model="lobes"), Run())
    errors, light = stored_tables(found.figures)
    ((flat, point, _),) = errors.rows.values()
    assert 3 * point < flat
    ((flat_light, point_light, _),) = light.rows.values()
    assert flat_light < 0.95
    assert point_light == pytest.approx(1, abs=0.06)


@pytest.mark.slow
def test_the_better_alpha_the_smaller_the_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(control, "_FABRICS", control._FABRICS[1:])
    for name, number in (("_TEXELS", 64), ("_RINGS", 4), ("_SECTORS", 8)):
        monkeypatch.setattr(control, name, number)
    (table,) = stored_tables(control.choice_of_alpha(PictureSettings(size=(48, 32), spp=16), Run()).figures)
    one, mean, clusters = (row[2] for row in table.rows.values())
    # Base and residual add up to the picture whatever α is, with less noise than two samples of it.
    assert min(one, mean, clusters) > 1.3
    assert clusters > one


@pytest.mark.slow
def test_sheen_brightens_black_cloth_by_the_command(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    options = ["-o", str(tmp_path), "--size", "16x12", "--spp", "4", "--model", "lobes", "--strengths", "0,1"]
    assert main(["papers/zhu2024/fig7", *options]) == 0
    assert (tmp_path / "papers/zhu2024/fig7.png").is_file()
    record = read_record(tmp_path / "papers/zhu2024/fig7.json")
    assert record.command == f"python -m studies papers/zhu2024/fig7 {' '.join(options[2:])}"
    _, light = stored_tables(record.figures)[0].rows.values()
    assert light[1] > 2 * light[0] > 0
    assert "MSE" in capsys.readouterr().out


def test_what_cannot_be_is_refused(refused: Callable[..., str]) -> None:
    assert "lobes" in refused(["papers/zhu2024/fig7", "-o", "out", "--model", "loobes"], main)
    with pytest.raises(InputError, match="--strengths"):
        sheen.sheen(sheen.SheenSettings(strengths="0,much"), Run())
    with pytest.raises(InputError, match=r"--ranks = .* from 0 to 16"):
        storage.measure(storage.Storage(fabrics="denim", clusters="4", ranks="-1", texels=16), Run())


@pytest.mark.slow
def test_densities_need_less_room_and_err_less_with_rank() -> None:
    settings = storage.Storage(fabrics="denim", clusters="4", ranks="0,2", texels=16)
    found = storage.measure(settings, Run()).figures
    (table,) = storage.tables(found)
    (none, _, whole, *_), (two, without, _, file, device) = table.rows.values()
    assert 0 < two < none < 1
    # A component in the mean's place is no better than the mean.
    assert without > 0.5 * two
    assert file < device < whole


def test_summed_areas_are_exact_with_all_components() -> None:
    """Boxes of uncompressed tables are plain means; all components give the table, normalised or not."""
    rng = np.random.default_rng(0)
    values = rng.random((5, 4, 12)).astype(np.float32)
    truth = summed_areas.summed(values)
    means = summed_areas.box_means(truth, 2, 3)
    np.testing.assert_allclose(means[1, 0], values[1:3, :3].mean(axis=(0, 1)), rtol=1e-6)
    pair = summed_areas.Compressed.of(values, 1)
    for normalised in (False, True):
        errors = [
            summed_areas.relative_error(pair.table(normalised, rank), truth, (1, 1)) for rank in (0, 2, 12)
        ]
        # Single precision, of sums 20 times as large as what is summed.
        assert errors[0] > errors[1] > errors[2]
        assert errors[2] < 1e-6
        coarse = summed_areas.relative_error(pair.table(normalised, 12, whole=True), truth, (1, 1))
        assert coarse > errors[2]
    assert summed_areas.relative_error(summed_areas.own_table(values), truth, (5, 4)) < 1e-3
