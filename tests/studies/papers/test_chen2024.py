"""The figures of chen2024: what is drawn where, what is measured, and what is refused.

Covers: studies/papers/chen2024/ablation.py, studies/papers/chen2024/comparison.py
Covers: studies/papers/chen2024/components.py, studies/papers/chen2024/cost.py
Covers: studies/papers/chen2024/editing.py, studies/papers/chen2024/fabrics.py
Covers: studies/papers/chen2024/latents.py, studies/papers/chen2024/shots.py, studies/papers/chen2024/stage.py
Covers: studies/instruments/renders.py, studies/instruments/sheet.py, studies/papers/setting.py
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.mitsuba import choose_variant
from loomlight.models.texture.settings import NeumipOptions
from loomlight.sources.loom_file import write_loom
from loomlight.weave.named import named_weave
from studies.harness.study import Found, Run, stored_tables
from studies.instruments.random_networks import random_neumip
from studies.instruments.renders import one_picture
from studies.instruments.scene_edits import SceneEdits
from studies.instruments.sheet import Row, Tile, contact_sheet
from studies.papers.chen2024 import ablation, comparison, components, cost, editing, latents
from studies.papers.chen2024.ablation import NETWORKS, weights_files
from studies.papers.chen2024.comparison import compared
from studies.papers.chen2024.components import direction_grid
from studies.papers.chen2024.cost import network_time
from studies.papers.chen2024.editing import EDITS, albedo_map
from studies.papers.chen2024.fabrics import paper_fabric, seen_fabrics, unseen_fabrics
from studies.papers.chen2024.shots import DRAPE
from studies.papers.chen2024.stage import NetworkSettings, neural_bsdf
from studies.papers.chen2024.training.config import read_config
from studies.papers.chen2024.training.weaves import HELD_OUT_WEAVES, paper_draft
from tests.helpers.neural_networks import network, written

CHEN2024 = Path(__file__).parents[3] / "studies" / "papers" / "chen2024"


@pytest.fixture(scope="module")
def settings(tmp_path_factory: pytest.TempPathFactory) -> NetworkSettings:
    """Small pictures by a narrow network with random weights, which compiles quickly."""
    choose_variant()
    file = written(network("field", hidden=16), tmp_path_factory.mktemp("weights") / "narrow.safetensors")
    return NetworkSettings(size=(32, 18), spp=4, weights=file)


@pytest.fixture(autouse=True)
def _cache(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))


def test_the_fabrics_are_the_papers() -> None:
    for fabric in seen_fabrics():
        assert (fabric.draft.drawdown == paper_draft(fabric.name).drawdown).all()
    held_out = [named_weave(name).drawdown for name in HELD_OUT_WEAVES]
    for fabric in unseen_fabrics():
        assert any(np.array_equal(fabric.draft.drawdown, drawdown) for drawdown in held_out)
    assert unseen_fabrics()[0].draft.drawdown.shape == (4, 4)


def test_a_sheet_holds_its_pictures_and_texts() -> None:
    red, blue = (np.full((10, 20, 3), colour, np.uint8) for colour in ((255, 0, 0), (0, 0, 255)))
    long = "a heading that is longer than its picture"
    sheet = contact_sheet("α × β", [long, "b"], [Row("one", [Tile(red, "c"), Tile(blue)])], "a note " * 30)
    at = {
        name: np.argwhere((sheet == colour).all(2))
        for name, colour in (("red", red[0, 0]), ("blue", blue[0, 0]))
    }
    for places in at.values():
        assert len(places) == 200
        assert tuple(np.ptp(places, axis=0)) == (9, 19)
    # Beside each other, and the second one beyond the end of the first one's heading.
    assert at["red"][0, 0] == at["blue"][0, 0]
    assert at["blue"][0, 1] - at["red"][0, 1] > 7 * len(long) - 20
    assert (sheet[:, -4:] == 255).all()


def test_directions_are_all_pairs_of_a_side() -> None:
    fabric = paper_fabric("plain")
    queries = direction_grid(fabric, 6, -1.0)
    count = len(queries.views)
    assert queries.pairs.shape == (count**2, 2)
    assert len(np.unique(queries.pairs, axis=0)) == count**2
    assert np.allclose(np.linalg.norm(queries.lights, axis=1), 1)
    assert (queries.lights[:, 2] < 0).all()
    assert (queries.views[:, 2] > 0).all()
    # Views down, lights across.
    assert (queries.pairs[:count, 1] == 0).all()
    assert (queries.pairs[:count, 0] == np.arange(count)).all()


@pytest.mark.slow
def test_one_comparison(settings: NetworkSettings) -> None:
    actual = compared("title", settings, Run(), DRAPE, [("plain", [paper_fabric("plain")])])
    tables = {table.title: table for table in stored_tables(actual.figures)}
    columns = tables["MSE"].columns
    assert columns == ["point, 1 spp", "point, 3 spp", "point, equal time", "neural, 1 spp"]
    (mse,), (seconds,) = tables["MSE"].rows.values(), tables["Processor seconds"].rows.values()
    (equal,) = tables["Equal processor time"].rows.values()
    assert 1 <= equal[0] <= 64
    # Records hold six digits.
    assert equal[1:4] == pytest.approx([seconds[2], seconds[3], mse[2] / mse[3]], rel=1e-5)
    assert ("MSE" in equal[5]) == (mse[2] > mse[3])
    (said,) = tables["Claim"].rows["ours"]
    assert f"nearer by MSE in {int(mse[2] > mse[3])} of 1" in said
    # Of the same noise a third, but for the reference's own.
    assert 0 < mse[1] < mse[0]
    maps = {f"plain-{column}-FLIP" for column in columns}
    assert set(actual.pictures) == {f"plain-{column}" for column in (*columns, "reference")} | maps
    assert actual.pictures["plain-reference"].shape == (18, 32, 3)
    assert actual.pictures["plain-reference"].max() > 50


@pytest.mark.slow
def test_neumip_is_kept_and_stands_beside(settings: NetworkSettings, tmp_path: Path) -> None:
    """The training is that of the fabric and quality: random textures in its place are shown."""
    seen = comparison.SeenSettings(
        size=settings.size, spp=settings.spp, weights=settings.weights, patterns="plain"
    )
    fabric = comparison.pattern_fabric("plain")
    identity = NeumipOptions().settings(is_fabric=True).identity(fabric)[:16]
    kept = tmp_path / "neumip" / identity / "model.loom"
    kept.parent.mkdir(parents=True)
    write_loom(kept, random_neumip(fabric).to_loom())
    actual = comparison.training_patterns(seen, Run(runs=tmp_path))
    tables = {table.title: table for table in stored_tables(actual.figures)}
    assert tables["FLIP"].columns[-1] == "neumip, 1 spp"
    assert tables["FLIP"].rows["plain"][-1] > 0.01
    assert "against `neumip` nearer by" in str(tables["Claim"].rows["ours"][0])
    assert "plain-neumip, 1 spp-FLIP" in actual.pictures


@pytest.mark.slow
def test_edits_name_parameters_and_are_taken_back(settings: NetworkSettings) -> None:
    fabric = paper_fabric("plain")
    scene = settings.stage(DRAPE, fabric).neural_scene()
    edits, parameters = SceneEdits(scene.scene), mi.traverse(scene.scene)
    before = {key: np.array(value) for key, value in parameters.items() if key.startswith("cloth0.bsdf")}
    picture = one_picture(scene, 1)
    for edit in EDITS:
        old = edits.apply(edit.values)
        assert not np.allclose(one_picture(scene, 1), picture, atol=1e-6), edit.label
        edits.apply(old)
    after = mi.traverse(scene.scene)
    for key, value in before.items():
        assert np.array_equal(np.array(after[key]), value), key
    taken = network_time(lambda: one_picture(scene, 1))
    assert 0 < taken.network.seconds < taken.picture.seconds
    assert 0 < taken.network.cpu_seconds < taken.picture.cpu_seconds


@pytest.mark.slow
def test_another_networks_weights_are_used(settings: NetworkSettings) -> None:
    bsdf = neural_bsdf(paper_fabric("plain"), settings.weights)((10.0, 10.0))
    assert bsdf.model.weights.tensor("decoder.angular.0.weight").shape[0] == 16


def test_albedos_are_albedos() -> None:
    values = albedo_map(32)
    assert values.shape == (32, 32, 3)
    assert values.min() >= 0
    assert values.max() <= 1
    assert len(np.unique(values.reshape(-1, 3), axis=0)) == 4


def test_ablations_differ_in_what_they_leave_out() -> None:
    both, one_blob, fusion = (
        read_config(CHEN2024 / f"{run}.toml")
        for run in ("ablation_both", "ablation_one_blob", "ablation_fusion")
    )
    assert both.training == one_blob.training == fusion.training
    assert both.data == one_blob.data == fusion.data
    assert one_blob.network == both.network.model_copy(update={"position": "plain"})
    assert fusion.network == both.network.model_copy(update={"fusion": False})


def test_missing_trainings_are_named_with_their_commands(tmp_path: Path) -> None:
    (tmp_path / "ablation_both").mkdir()
    (tmp_path / "ablation_both" / "neural.safetensors").write_bytes(b"")
    with pytest.raises(InputError) as fault:
        weights_files(tmp_path, NETWORKS)
    message = str(fault.value)
    assert (
        "python -m studies.papers.chen2024.training studies/papers/chen2024/ablation_one_blob.toml"
    ) in message
    assert "studies/papers/chen2024/ablation_fusion.toml" in message
    assert "ablation_both.toml" not in message
    assert all((CHEN2024 / f"{name}.toml").is_file() for name in NETWORKS.values())


def test_trainings_and_weights_that_are_missing_are_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"training studies/papers/chen2024/ablation_published\.toml"):
        ablation.compared(ablation.AllSettings(), Run(runs=tmp_path))
    with pytest.raises(InputError, match=r"none\.safetensors does not exist"):
        NetworkSettings(weights=tmp_path / "none.safetensors").network()


@pytest.mark.slow
def test_figures_say_which_network_they_show(settings: NetworkSettings) -> None:
    small = replace(settings, size=(32, 40), spp=4)
    found = components.separated(small, Run())
    network_shown = small.network()
    assert found.figures["weights"] == {"sha256": network_shown.sha256, "trained": network_shown.trained}
    assert found.figures["tables"][0]["rows"]["reflection"]["BSDF"] > 0
    matrix = found.pictures["reflection, sampled-BSDF"]
    assert matrix.shape[0] == matrix.shape[1]
    assert matrix.std() > 5


# ------------------------------------------------------------------------------------------- whole figures


def rows(actual: Found) -> dict[str, dict[str, list[Any]]]:
    return {table.title: dict(table.rows) for table in stored_tables(actual.figures)}


@pytest.mark.slow
def test_mixed_latents_are_the_encoded_ones_at_both_ends(
    settings: NetworkSettings, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(latents, "_VALUES", (0.2, 0.8))
    monkeypatch.setattr(latents, "_PARAMETERS", latents._PARAMETERS[:1])
    actual = latents.interpolated(settings, Run())
    tables = {title: table["roughness"] for title, table in rows(actual).items()}
    # Half-precision latents are mixed once more.
    assert tables["FLIP of mixed against encoded"] == pytest.approx([0, 0], abs=2e-3)
    assert min(tables["FLIP of encoded against reference"]) > 0.01
    # The network has random weights, so that only the reference knows roughness.
    assert tables["FLIP between 0.2 and 0.8"][0] > 0.01
    assert set(actual.pictures) == {
        f"roughness α, {kind}-{value}"
        for value in ("0.2", "0.8")
        for kind in ("reference", "encoded", "mixed")
    }


@pytest.mark.slow
def test_every_edit_is_timed_and_shown(settings: NetworkSettings, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(editing, "EDITS", editing.EDITS[-1:])
    actual = editing.edited(settings, Run())
    table = rows(actual)["Processor seconds of an edit"]
    assert list(table) == ["the fabric, encoded", "albedo of the warp", "pattern satin 8×8", "albedo map"]
    assert set(actual.pictures) == set(table)
    assert all(seconds > 0 for row in table.values() for seconds in row)


@pytest.mark.slow
def test_the_parts_of_a_pictures_time_are_its_sum(
    settings: NetworkSettings, monkeypatch: pytest.MonkeyPatch
) -> None:
    scenes = cost._scenes()
    monkeypatch.setattr(cost, "_scenes", lambda: dict(list(scenes.items())[:2]))
    actual = cost.split(settings, Run())
    table = rows(actual)["Processor milliseconds of a picture"]
    assert list(table) == list(scenes)[:2] == list(actual.pictures)
    for network_ms, others, whole, share, encoder in table.values():
        assert min(network_ms, others, encoder) > 0
        assert share == pytest.approx(network_ms / whole, rel=1e-5)  # of six digits
        assert network_ms + others == pytest.approx(whole, rel=1e-4)


@pytest.mark.slow
def test_networks_without_a_part_stand_beside_each_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for run in ablation.NETWORKS.values():
        (tmp_path / run).mkdir(parents=True)
        written(network("field", hidden=16), tmp_path / run / "neural.safetensors")
    monkeypatch.setattr(ablation, "_SCENES", dict(list(ablation._SCENES.items())[1:2]))
    sizes = {"fabrics": 1, "pairs": 4, "footprints": 4}
    kept = Run(runs=tmp_path)
    actual = ablation.ablated(ablation.FigureSettings(size=(24, 16), spp=4, **sizes), kept)
    tables = rows(actual)
    (errors,) = tables["FLIP"].values()
    # All three are the same network here.
    assert errors == pytest.approx([errors[0]] * 3, abs=1e-3)
    assert errors[0] > 0.01
    assert len(actual.pictures) == 2 * len(ablation.NETWORKS) + 1
    reflection = next(table for title, table in tables.items() if "reflection" in title)
    assert set(reflection) >= set(ablation.NETWORKS)
    # The benchmark alone, of any of the trainings.
    some = ablation.AllSettings(networks="both,no one-blob", **sizes)
    found = ablation.compared(some, kept).figures
    (table,) = ablation.tables(found)
    assert table.rows["both"] == table.rows["no one-blob"]
    assert table.rows["both"][0] == pytest.approx(reflection["both"][0])
    assert found["queries_per_fabric"] == 16
