"""Figures made whole, of few pictures: what they draw and what they measure.

Covers: studies/papers/chen2024/ablation.py, studies/papers/chen2024/cost.py
Covers: studies/papers/chen2024/editing.py
Covers: studies/papers/chen2024/latents.py
"""

from __future__ import annotations

from pathlib import Path

import pytest

from loomlight.mitsuba import choose_variant
from studies.papers.chen2024 import ablation, cost, editing, latents
from studies.papers.figure import Evidence
from studies.papers.setting import Setting
from tests.helpers.neural_networks import network, written


@pytest.fixture
def setting(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Setting:
    """Small pictures by a narrow network with random weights, which compiles quickly."""
    choose_variant()
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    file = written(network("field", hidden=16), tmp_path / "narrow.safetensors")
    return Setting(size=(24, 16), samples=4, weights=file, runs=tmp_path / "runs")


def rows(actual: Evidence) -> dict[str, dict[str, list[object]]]:
    return {table.title: dict(table.rows) for table in actual.tables}


@pytest.mark.slow
def test_mixed_latents_are_the_encoded_ones_at_both_ends(
    setting: Setting, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(latents, "_VALUES", (0.2, 0.8))
    monkeypatch.setattr(latents, "_PARAMETERS", latents._PARAMETERS[:1])
    actual = latents.interpolated(setting)
    tables = {title: table["roughness"] for title, table in rows(actual).items()}
    # Half-precision latents are mixed once more.
    assert tables["FLIP of mixed against encoded"] == pytest.approx([0, 0], abs=2e-3)
    assert min(tables["FLIP of encoded against reference"]) > 0.01
    # The network has random weights, so that only the reference knows roughness.
    assert tables["FLIP between 0.2 and 0.8"][0] > 0.01
    assert set(actual.pictures) == {
        f"roughness-{value}-{kind}" for value in ("0.2", "0.8") for kind in ("reference", "encoded", "mixed")
    }


@pytest.mark.slow
def test_every_edit_is_timed_and_shown(setting: Setting, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(editing, "EDITS", editing.EDITS[-1:])
    actual = editing.edited(setting)
    table = rows(actual)["Seconds of an edit"]
    assert list(table) == ["the fabric, encoded", "albedo of the warp", "pattern satin 8×8", "albedo map"]
    assert set(actual.pictures) == set(table)
    assert all(seconds > 0 for row in table.values() for seconds in row)


@pytest.mark.slow
def test_the_parts_of_a_pictures_time_are_its_sum(setting: Setting, monkeypatch: pytest.MonkeyPatch) -> None:
    scenes = cost._scenes()
    monkeypatch.setattr(cost, "_scenes", lambda: dict(list(scenes.items())[:2]))
    actual = cost.split(setting)
    table = rows(actual)["Milliseconds of a picture"]
    assert list(table) == list(scenes)[:2] == list(actual.pictures)
    for network_ms, others, host, whole, share, encoder in table.values():
        assert min(network_ms, others, encoder) > 0
        assert share == pytest.approx(network_ms / whole)
        assert network_ms + others + host >= 0.999 * whole


@pytest.mark.slow
def test_networks_without_a_part_stand_beside_each_other(
    setting: Setting, monkeypatch: pytest.MonkeyPatch
) -> None:
    for run in ablation.NETWORKS.values():
        (setting.runs / run).mkdir(parents=True)
        written(network("field", hidden=16), setting.runs / run / "neural.safetensors")
    monkeypatch.setattr(ablation, "_SCENES", dict(list(ablation._SCENES.items())[1:2]))
    for name, count in (("_FABRICS", 1), ("_PAIRS", 4), ("_FOOTPRINTS", 4)):
        monkeypatch.setattr(ablation, name, count)
    actual = ablation.ablated(setting)
    tables = rows(actual)
    (errors,) = tables["FLIP"].values()
    # All three are the same network here.
    assert errors == pytest.approx([errors[0]] * 3, abs=1e-3)
    assert errors[0] > 0.01
    assert len(actual.pictures) == len(ablation.NETWORKS) + 1
    reflection = next(table for title, table in tables.items() if "reflection" in title)
    assert set(reflection) >= set(ablation.NETWORKS)
