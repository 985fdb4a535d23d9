"""`loomlight compare`: a page, a table and pictures; bad input ends in one sentence.

Covers: evaluation/compare.py, evaluation/report.py
"""

from __future__ import annotations

import errno
import json
import os
import shlex
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from loomlight.cli.main import run
from loomlight.core.errors import InputError
from loomlight.evaluation.compare import BakedModels, Comparison, compare
from loomlight.fabric import fabric_from_text
from loomlight.fabric.fabric import Fabric
from loomlight.models.interface import Model
from loomlight.models.registry import make_model


@pytest.fixture(scope="module")
def report(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("compare")
    cloth = folder / "cloth.toml"
    cloth.write_text('name = "Red & <white>"\nweave = "twill 2/1"\n[warp]\ncolor = "#b03030"\n')
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(folder / "cache"))
        arguments = ["compare", str(cloth), "--models", "point", "-o", str(folder / "report")]
        assert run([*arguments, "--scenes", "flat near,sphere", "--size", "32x18", "--spp", "8"]) == 0
    return folder / "report"


@pytest.mark.slow
def test_the_table(report: Path) -> None:
    table = json.loads((report / "table.json").read_text())
    assert table["fabric"] == "Red & <white>"
    assert 'weave = "twill 2/1"' in table["fabric_file"]
    assert table["protocol"]["size"] == [32, 18]
    assert table["protocol"]["reference_samples"] == 8
    assert set(table) >= {"sources", "machine", "command"}
    by_title = {part["title"]: part["rows"] for part in table["tables"]}
    flip = by_title["Mean FLIP"]["point, 1 spp"]
    assert list(flip) == ["flat near (0.25)", "sphere (3)"]
    assert all(0 < value < 1 for value in flip.values())
    models = by_title["All models"]
    assert list(models) == ["point"]
    assert models["point"]["bytes of the .loom"] > 100
    # A sample a pixel of the point model is what the point model is.
    assert models["point"]["point samples of equal error"] == pytest.approx(1, rel=0.5)
    (queries,) = (rows for title, rows in by_title.items() if title.startswith("nMAE of grey reflection"))
    assert 0 < queries["point"]["overall"] < 1


@pytest.mark.slow
def test_the_recorded_command_runs(report: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It asks for the same fabric, models, scenes, size and samples, whatever was left out."""
    asked: list[dict[str, object]] = []

    def record(cloth: Fabric, models: list[str], _folder: Path, **options: object) -> Comparison:
        asked.append({"fabric": cloth.name, "models": models, **options})
        raise InputError("enough")

    monkeypatch.setattr("loomlight.evaluation.compare.compare", record)
    program, *arguments = shlex.split(json.loads((report / "table.json").read_text())["command"])
    assert program == "loomlight"
    assert run(arguments) == 2
    assert asked[0]["fabric"] == "Red & <white>"
    assert asked[0]["models"] == ["point"]
    assert asked[0]["scenes"] == ["flat near", "sphere"]
    assert (asked[0]["size"], asked[0]["reference_samples"]) == ((32, 18), 8)
    assert shlex.split(str(asked[0]["command"])) == ["loomlight", *arguments]
    # Without options all of them are recorded.
    assert run(["compare", "twill 2/1", "-o", "elsewhere"]) == 2
    again = shlex.split(str(asked[1]["command"]))
    assert again[:3] == ["loomlight", "compare", "twill 2/1"]
    assert {"--models", "--scenes", "--size", "--spp", "--output"} <= set(again)


@pytest.mark.slow
def test_the_page_shows_every_picture(report: Path) -> None:
    page = (report / "index.html").read_text()
    assert "Red &amp; &lt;white&gt;" in page
    assert "<white>" not in page
    assert "http" not in page.replace("http-equiv", "")  # nothing is fetched from elsewhere
    pictures = sorted((report / "pictures").iterdir())
    assert len(pictures) == 2 * 5
    for picture in pictures:
        assert f"pictures/{picture.name}" in page
        with Image.open(picture) as opened:
            assert opened.size == (32, 18)
    with Image.open(report / "pictures" / "flat-near.png") as reference:
        assert np.asarray(reference).std() > 0


@pytest.mark.slow
def test_each_scene_is_written_when_it_is_measured(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    rows: list[tuple[str, int]] = []

    def row(line: str) -> None:
        tables = json.loads((tmp_path / "report" / "table.json").read_text())["tables"]
        rows.append((line.partition(",")[0], len(tables[0]["rows"]["point, 1 spp"])))

    compare(
        fabric_from_text('weave = "plain"'),
        ["point"],
        tmp_path / "report",
        scenes=["flat near", "sphere"],
        size=(32, 18),
        reference_samples=2,
        row=row,
    )
    assert rows == [("flat near", 1), ("sphere", 2), ("queries", 2)]


def test_trained_models_are_made_once(monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[str] = []

    def make(name: str, source: Fabric) -> Model:
        made.append(name)
        return make_model("point", source)

    monkeypatch.setattr("loomlight.evaluation.compare.make_model", make)
    cloth = fabric_from_text('weave = "plain"')
    baked = BakedModels()
    for _ in range(2):
        for name in ("point", "neumip"):
            baked.make(name, cloth)
    assert made == ["point", "neumip", "point"]
    assert set(baked.bakings) == {("point", cloth.name), ("neumip", cloth.name)}


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        (["plain", "--models", "nerual"], 'model "nerual" does not exist: did you mean neural?'),
        (["plain", "--models", ","], "No model is given"),
        (["plain", "--models", "point", "--scenes", "moon"], 'scene = "moon"'),
        (["plain", "--models", "point", "--size", "big"], "960x540"),
        (["plain", "--models", "point", "--spp", "0"], "--spp 0"),
    ],
)
def test_faults(options: list[str], expected: str, refused: Callable[..., str]) -> None:
    assert expected in refused(["compare", *options, "-o", "report"])


def test_no_empty_folder_is_left_on_a_full_disk(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))

    def full(*_arguments: object, **_options: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(Image.Image, "save", full)
    options = ["--models", "point", "--scenes", "flat near", "--size", "32x18", "--spp", "2"]
    assert run(["compare", "plain", "-o", "report", *options]) == 2
    assert "cannot be written: No space left on device" in capsys.readouterr().err
    assert not (tmp_path / "report").exists()
