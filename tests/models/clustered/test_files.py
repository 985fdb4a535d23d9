"""An interrupted bake leaves no file."""

from __future__ import annotations

from pathlib import Path

import pytest

from loomlight.cli.main import run
from loomlight.core.llvm import require_llvm
from loomlight.models.clustered import model as clustered_model

require_llvm()

SMALL = ["--set", "clusters=4", "--set", "rank=0", "--set", "texels=16"]
BAKE = ["bake", "plain", "--model", "clustered", "-o", "cloth.loom", *SMALL]


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
