"""No command overwrites a file that it reads.

Covers: core/outputs.py
"""

from __future__ import annotations

import shlex
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from loomlight.cli.main import run

_SCENE = """<scene version="3.0.0"><shape type="obj"><string name="filename" value="mesh.obj"/>
<bsdf type="diffuse"><texture type="bitmap"><string name="filename" value="room.png"/></texture></bsdf>
</shape></scene>"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A fabric file with its draft, a draft as a picture, a scene file and a picture of a room."""
    monkeypatch.chdir(tmp_path)
    Path("cloth.toml").write_text('image = "draft.png"\nends_per_cm = 18\n')
    for name in ("draft.png", "room.png", "cloth_height.png", "frame-001.png"):
        Image.fromarray(np.eye(4, dtype=np.uint8) * 255).save(name)
    Path("scene.xml").write_text(_SCENE)
    assert run(["weave", "convert", "plain", "-o", "plain.wif"]) == 0
    Path("report/pictures").mkdir(parents=True)
    Path("report/table.json").write_text("{}")
    Path("report/pictures/draft.png").write_bytes(Path("draft.png").read_bytes())
    Path("exported").mkdir()
    Path("exported/manifest.json").write_text('{"loomlight_export": 1}')
    Path("exported/own.toml").write_text('weave = "plain"')
    return tmp_path


@pytest.mark.parametrize(
    "command",
    [
        "render draft.png -o draft.png",
        "render cloth.toml -o draft.png",
        "render cloth.toml -o {name}.png --env cloth.png",
        "render plain -o room.png --env room.png",
        "render plain -o room.png --scene scene.xml",
        "render plain -o room.png --scene scene.xml --cloth a=room.png",
        "render frame-001.png -o frame.png --turntable 2",
        "play draft.png -o draft.png",
        "play plain -o room.png --env room.png",
        "swatches plain draft.png -o draft.png",
        "weave show draft.png -o draft.png",
        "weave show cloth.toml -o draft.png",
        "weave convert plain.wif -o plain.wif",
        "bake-maps cloth_height.png -o cloth.png",
        "compare report/pictures/draft.png -o report",
        "export exported/own.toml --to wgsl -o exported",
        "view exported/own.toml --export exported",
    ],
)
def test_what_is_read_stays(command: str, folder: Path, refused: Callable[..., str]) -> None:
    if "--env cloth.png" in command:
        Path("draft.png").rename("cloth.png")
        Path("cloth.toml").write_text('image = "cloth.png"\nends_per_cm = 18\n')
    assert "read by this command" in refused(shlex.split(command))


def test_a_link_to_what_is_read_is_refused(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "link.wif").symlink_to("plain.wif")
    assert run(["weave", "convert", "plain.wif", "-o", "link.wif"]) == 2
    assert "link.wif is read by this command" in capsys.readouterr().err


def test_other_files_are_overwritten(folder: Path) -> None:
    """A name that only looks like a file, and a file beside the one that is read."""
    (folder / "twill.wif").write_text("old")
    assert run(["weave", "convert", "plain.wif", "-o", "twill.wif"]) == 0
    assert "WIF" in (folder / "twill.wif").read_text()
