"""Files of clustered: an interrupted bake leaves none, and faulty ones are refused in one sentence."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from loomlight.cli.main import run
from loomlight.core.llvm import require_llvm
from loomlight.models.clustered import model as clustered_model
from loomlight.sources.loom_file import read_loom, write_loom

require_llvm()

SMALL = ["--set", "clusters=4", "--set", "rank=0", "--set", "texels=16"]
BAKE = ["bake", "plain", "--model", "clustered", "-o", "cloth.loom", *SMALL]
SHOW = ["render", "cloth.loom", "-o", "cloth.png"]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty working folder."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_an_interrupted_bake_leaves_nothing(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(clustered_model, "bake_tables", interrupted)
    try:
        code = run(BAKE)
    except KeyboardInterrupt:
        code = 130
    assert code != 0
    assert not list(folder.iterdir())


@pytest.mark.slow
def test_faulty_files_are_refused_in_one_sentence(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(BAKE) == 0
    path = folder / "cloth.loom"
    whole, loom = path.read_bytes(), read_loom(path)

    def refused(expected: str) -> None:
        capsys.readouterr()
        assert run(SHOW) == 2
        error = capsys.readouterr().err.strip()
        assert expected in error, error
        assert len(error.splitlines()) == 1
        assert not (folder / "cloth.png").exists()

    for length in (len(whole) // 2, 100, 0):
        path.write_bytes(whole[:length])
        refused("cloth.loom")
    write_loom(path, replace(loom, settings={**loom.settings, "tables_version": 1}))
    refused("its tables are of another version of loomlight: bake it again")
    # The file of one model that says it is of another.
    write_loom(path, replace(loom, model="lobes"))
    refused("cloth.loom")
