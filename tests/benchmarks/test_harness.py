"""Measuring scripts: what they record, where they write it, and how they end.

Covers: studies/papers/zhu2024/storage.py, studies/papers/zeltner2024/merl.py
Covers: studies/papers/zeltner2024/speed.py
"""

from __future__ import annotations

import importlib
import json
import sys
from pathlib import Path

import pytest

from studies.instruments import harness

LIBRARIES = (
    "__init__",
    "harness",
    "machine",
    "processes",
    "counted_library",
    "random_networks",
    "cloth_paths",
    "held_out",
    "reference",
    "scene_edits",
    "tabulated_visibility",
    "timing",
    "neural_sampler_training",
)
# They write constants, or a picture.
NO_FIGURES = ("tools.fits.sheen", "tools.fits.neural_sampler", "studies.look.distances")
SCRIPTS = sorted(
    [
        f"{folder.replace('/', '.')}.{file.stem}"
        for folder in ("benchmarks", "experiments", "tools/fits")
        for file in (harness.REPOSITORY / folder).glob("*.py")
        if file.stem not in LIBRARIES
    ]
    + [
        "studies.papers.zhu2024.storage",
        "studies.papers.zeltner2024.merl",
        "studies.papers.zeltner2024.speed",
    ]
)


def run(monkeypatch: pytest.MonkeyPatch, figures: harness.Figures, *arguments: str) -> None:
    monkeypatch.setattr(sys, "argv", ["script", *arguments])
    harness.run(lambda options: figures)


def test_the_record_is_printed_and_written(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "new" / "record.json"
    run(monkeypatch, {"rate": 1 / 3}, "--output", str(file))
    written = json.loads(file.read_text())
    assert written["rate"] == 0.333333
    assert list(written) == ["command", "sources", "machine", "rate"]
    assert "--output" not in written["command"]
    assert json.loads(capsys.readouterr().out)["rate"] == 1 / 3


def test_missed_bars_end_with_1_after_the_record_is_written(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    with pytest.raises(SystemExit) as ended:
        run(monkeypatch, {"missed": ["speed"]}, "--output", str(tmp_path / "record.json"))
    assert ended.value.code == "missed: speed"  # Python prints it and exits with 1
    assert (tmp_path / "record.json").is_file()
    run(monkeypatch, {"missed": []})


def test_commands_name_no_folder_of_the_machine(tmp_path: Path) -> None:
    (tmp_path / "a draft.wif").touch()
    inside = harness.REPOSITORY / "examples" / "denim.toml"
    words = [str(tmp_path / "a draft.wif"), str(inside), "--groups", "4", "--output=a.json", "--output", "b"]
    assert harness.command("studies.speed.lobes", words) == (
        "python -m studies.speed.lobes 'a draft.wif' examples/denim.toml --groups 4"
    )


def test_data_from_outside_is_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LOOMLIGHT_DATA", "folder")
    assert harness.outside_data("wif", "good") == Path("folder/wif/good")
    monkeypatch.delenv("LOOMLIGHT_DATA")
    with pytest.raises(SystemExit, match="LOOMLIGHT_DATA"):
        harness.outside_data("wif")


@pytest.mark.parametrize("name", SCRIPTS)
def test_every_script_says_how_it_is_run(name: str) -> None:
    """Importing it also finds names that no longer exist in what it measures."""
    script = importlib.import_module(name)
    assert f"python -m {name}" in (script.__doc__ or "")
    assert hasattr(script, "measure") or name in NO_FIGURES
