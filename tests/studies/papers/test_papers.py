"""The papers' figures: what is drawn where, what is written down, and what is refused.

Covers: studies/papers/command.py, studies/papers/__main__.py, studies/papers/catalogue.py
Covers: studies/papers/chen2024/comparison.py, studies/papers/chen2024/components.py
Covers: studies/papers/figure.py, studies/papers/chen2024/fabrics.py
Covers: studies/instruments/renders.py, studies/papers/make.py
Covers: studies/papers/setting.py, studies/instruments/sheet.py, studies/papers/chen2024/shots.py
"""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import mitsuba as mi
import numpy as np
import pytest
from PIL import Image

from loomlight.core.errors import InputError
from loomlight.mitsuba import choose_variant
from loomlight.weave.named import named_weave
from studies.instruments.renders import Stage, count_near, one_picture
from studies.instruments.scene_edits import SceneEdits
from studies.instruments.sheet import Row, Tile, contact_sheet
from studies.papers.catalogue import CATALOGUE
from studies.papers.chen2024.ablation import NETWORKS, weights_files
from studies.papers.chen2024.comparison import compared
from studies.papers.chen2024.components import direction_grid
from studies.papers.chen2024.cost import network_time
from studies.papers.chen2024.editing import EDITS, albedo_map
from studies.papers.chen2024.fabrics import paper_fabric, seen_fabrics, unseen_fabrics
from studies.papers.chen2024.shots import DRAPE
from studies.papers.chen2024.training.config import read_config
from studies.papers.chen2024.training.weaves import HELD_OUT_WEAVES, paper_draft
from studies.papers.command import main
from studies.papers.setting import Setting, cloth_bsdf
from tests.helpers.neural_networks import network, written

CHEN2024 = Path(__file__).parents[2] / "studies" / "papers" / "chen2024"


@pytest.fixture(scope="module")
def setting(tmp_path_factory: pytest.TempPathFactory) -> Setting:
    """Small pictures by a narrow network with random weights, which compiles quickly."""
    choose_variant()
    file = written(network("field", hidden=16), tmp_path_factory.mktemp("weights") / "narrow.safetensors")
    return Setting(size=(32, 18), samples=4, weights=file)


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


def test_equal_time_takes_counts_that_fill_a_grid() -> None:
    assert [count_near(wanted) for wanted in (-3, 0.4, 3.2, 4.9, 13.4, 1e9)] == [1, 1, 3, 5, 13, 64]


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
def test_one_comparison(setting: Setting) -> None:
    actual = compared("title", setting, DRAPE, [("plain", [paper_fabric("plain")])])
    tables = {table.title: table for table in actual.tables}
    columns = tables["MSE"].columns
    assert columns == ["point, 1 spp", "point, 3 spp", "point, equal time", "neural, 1 spp"]
    (mse,), (samples,) = tables["MSE"].rows.values(), tables["samples"].rows.values()
    assert samples[0] == 1
    assert samples[1] == 3
    assert samples[3] == 1
    # Of the same noise a third, but for the reference's own.
    assert 0 < mse[1] < mse[0]
    assert {*columns, "reference"} <= set(actual.pictures)
    assert actual.pictures["reference"].shape == (18, 32, 3)
    assert actual.pictures["reference"].max() > 50


@pytest.mark.slow
def test_edits_name_parameters_and_are_taken_back(setting: Setting) -> None:
    fabric = paper_fabric("plain")
    scene = Stage(setting, DRAPE, fabric).neural_scene()
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
    # Kernels lie within the picture's time; those of two threads may overlap on a busy machine.
    spent = network_time(lambda: one_picture(scene, 1))
    assert 0 < spent.network + spent.others < 2 * spent.seconds
    assert min(spent.network, spent.others) > 0


@pytest.mark.slow
def test_another_networks_weights_are_used(setting: Setting) -> None:
    bsdf = cloth_bsdf(paper_fabric("plain"), "neural", setting.weights)((10.0, 10.0))
    assert bsdf.model.weights.tensor("decoder.angular.0.weight").shape[0] == 16
    assert cloth_bsdf(paper_fabric("plain"), "point", setting.weights)((10.0, 10.0)).model.name == "point"


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
        weights_files(tmp_path)
    message = str(fault.value)
    assert (
        "python -m studies.papers.chen2024.training studies/papers/chen2024/ablation_one_blob.toml"
    ) in message
    assert "studies/papers/chen2024/ablation_fusion.toml" in message
    assert "ablation_both.toml" not in message
    assert all((CHEN2024 / f"{name}.toml").is_file() for name in NETWORKS.values())


@pytest.mark.slow
def test_the_command_writes_and_adds(
    setting: Setting, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    options = ["-o", str(out), "--size", "32x40", "--spp", "4", "--weights", str(setting.weights)]
    assert main(["chen2024/fig2", *options]) == 0
    with Image.open(out / "fig2.png") as sheet:
        assert sheet.width >= 640
    with Image.open(out / "pictures" / "fig2-reflection-sampled-bsdf.png") as matrix:
        assert matrix.width == matrix.height
        assert np.asarray(matrix).std() > 5
    written_down = json.loads((out / "table.json").read_text())
    figure = written_down["figures"]["chen2024/fig2"]
    assert set(figure) >= {"command", "sources", "machine", "size", "weights", "tables"}
    assert figure["command"].startswith("python -m studies.papers chen2024/fig2 --size 32x40 --spp 4")
    assert figure["tables"][0]["rows"]["reflection"]["BSDF"] > 0
    assert "nMAE" in capsys.readouterr().out
    # What was found of other figures stays.
    written_down["figures"]["chen2024/fig4"] = {"tables": []}
    (out / "table.json").write_text(json.dumps(written_down))
    assert main(["chen2024/fig2", *options]) == 0
    assert set(json.loads((out / "table.json").read_text())["figures"]) == {"chen2024/fig2", "chen2024/fig4"}


def test_the_list(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == list(CATALOGUE)
    assert {
        f"chen2024/{name}" for name in ("fig2", "fig4", "fig5", "fig6", "fig7", "fig8", "fig9", "table3")
    } <= set(CATALOGUE)


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (["chen2024/fig44", "-o", "out"], 'did you mean "chen2024/fig4"'),
        (["chen2024/fig4"], "-o DIR"),
        (["chen2024/fig4", "-o", "none/out"], "folder none does not exist"),
        (["chen2024/fig4", "-o", "out", "--spp", "0"], "--spp 0"),
        (["chen2024/fig4", "-o", "out", "--size", "big"], "960x540"),
        (["chen2024/fig4", "-o", "out", "--weights", "none.safetensors"], "none.safetensors does not exist"),
        (
            ["chen2024/fig7", "-o", "out", "--runs", "none"],
            "python -m studies.papers.chen2024.training studies/papers/chen2024/ablation_both.toml",
        ),
        (["chen2024/fig4", "-o", "other", "--weights", "other/table.json"], "read by this command"),
        (["zhu2024/table1", "-o", ".", "--environment", "pictures/room.exr"], "read by this command"),
        (["chen2024/fig4", "-o", "other"], "not written by `python -m studies.papers`"),
    ],
)
def test_faults(arguments: list[str], expected: str, refused: Callable[..., str]) -> None:
    Path("other").mkdir()
    Path("pictures").mkdir()
    Path("pictures/room.exr").touch()
    Path("other/table.json").write_text('{"schema": 1, "fabric": "denim"}')
    assert expected in refused(arguments, main, leaves="other/pictures")
