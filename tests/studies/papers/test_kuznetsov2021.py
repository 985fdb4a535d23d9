"""The figures of kuznetsov2021, small: trainings of a few steps of one material.

Covers: studies/papers/kuznetsov2021/figures.py, studies/papers/kuznetsov2021/stage.py
Covers: studies/papers/kuznetsov2021/tables.py, studies/papers/kuznetsov2021/equal_cost.py
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import InputError
from studies.harness.parts import Parts
from studies.harness.study import NoSettings, Run, stored_tables
from studies.papers.kuznetsov2021 import equal_cost, figures, stage, tables
from studies.papers.kuznetsov2021.designs import DESIGNS
from studies.papers.kuznetsov2021.materials import paper_heightfield

MATERIAL = "turtle shell"


SMALL = {"size": (16, 9), "spp": 4, "side": 16, "materials": MATERIAL}


@pytest.fixture(autouse=True)
def _tiny(monkeypatch: pytest.MonkeyPatch) -> None:
    """Trainings that learn next to nothing."""
    pytest.importorskip("torch", exc_type=ImportError)
    tiny = replace(stage.PREVIEW, resolution=8, queries=8 * 8**2, samples=1, steps=3, batch=64)
    monkeypatch.setattr(stage, "PREVIEW", tiny)


@pytest.mark.slow
def test_table_2_has_every_design_at_equal_rays_and_keeps_its_trainings(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    names = (MATERIAL, "straight wool")
    monkeypatch.setattr(equal_cost, "PROBE_RAYS", 2)
    sizes = {**SMALL, "materials": ",".join(names), "levels": 2, "probes": 32, "steps": 3, "resolution": 8}
    settings = equal_cost.CostSettings(**sizes)
    tables_of = stored_tables(equal_cost.comparison(settings, run).figures)
    squared, flip, ratios, by_level, _, cost, paper, of_paper = tables_of
    assert squared.columns == flip.columns == by_level.columns == list(equal_cost.COLUMNS)
    assert paper.columns == list(DESIGNS)
    assert set(by_level.rows) == {f"{name}, {level}" for name in names for level in range(2)}
    assert np.isfinite(np.array([*squared.rows.values(), *by_level.rows.values()], float)).all()
    assert set(ratios.rows) == {*names, "geometric mean"}
    # 128² texels have 2²² rays.
    assert {cell for name in names for cell in cost.rows[f"{name}, rays"]} == {16384}
    # 11.31, 12.79 and 19.03 over 3.98.
    assert of_paper.rows["twisted wool"] == pytest.approx([2.842, 3.214, 4.781], abs=0.001)
    places = list((run.runs / "kuznetsov2021").iterdir())
    before = {file: file.stat().st_mtime_ns for place in places for file in place.glob("*.json")}
    again = stored_tables(equal_cost.comparison(settings, run).figures)
    assert again[0].rows == squared.rows
    assert again[5].rows == cost.rows
    assert before == {file: file.stat().st_mtime_ns for file in before}


def test_seconds_become_steps(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of a training whose steps take 2 s after a first of 100: 30 s are 15 steps."""
    clock = [0.0]
    monkeypatch.setattr(equal_cost.time, "process_time", lambda: clock[0])
    trainings = equal_cost.EqualCost([], equal_cost.Budget(8, 64, 30), tmp_path)
    ran: list[int] = []

    def run(steps: int, folder: Path, report: Callable[[int, int], None]) -> None:
        ran.append(steps)
        for step in range(steps):
            clock[0] += 2 if step else 100
            report(step + 1, steps)

    _, cost = trainings._run("ours", "one", run)
    assert ran[1:] == [15]
    assert cost == {"steps": 15, "cpu_seconds": pytest.approx(30)}
    _, again = trainings._run("ours", "one", run)
    assert again == cost
    assert ran[2:] == [15]
    assert equal_cost.EqualCost([], equal_cost.Budget(8, 64, 30, steps=4), tmp_path)._run("ours", "one", run)[
        1
    ] == {"steps": 4, "cpu_seconds": pytest.approx(8)}


@pytest.mark.slow
def test_table_3_has_levels_and_keeps_its_trainings(run: Run) -> None:
    settings = tables.LevelsSettings(**SMALL, levels=2)
    first = stored_tables(tables.by_level(settings, run).figures)[0].rows
    places = list((run.runs / "kuznetsov2021").iterdir())
    before = {file: file.stat().st_mtime_ns for place in places for file in place.iterdir()}
    assert stored_tables(tables.by_level(settings, replace(run, parts=Parts())).figures)[0].rows == first
    assert stored_tables(tables.zooms(settings, run).figures)[0].rows == first
    assert len(first[MATERIAL]) == 2
    assert before == {file: file.stat().st_mtime_ns for file in before}


def test_figures_5_and_10(run: Run) -> None:
    settings = figures.AblationSettings(
        size=(16, 9), spp=4, side=16, resolution=8, channels="3,7", layers="2"
    )
    (table,) = stored_tables(figures.ablation(settings, run).figures)
    assert table.rows["7 channels"][0] == 1
    assert table.rows["2 layers"][2] < table.rows["3 channels"][2]
    figure = figures.offsets(stage.StageSettings(size=(16, 9), side=16), run)
    assert set(figure.pictures) == {"height", "texture", *stored_tables(figure.figures)[0].rows}


def test_table_4_is_the_papers(run: Run) -> None:
    (table,) = stored_tables(tables.sizes(NoSettings(), run).figures)
    assert table.rows["weights"][1:] == table.rows["weights in the paper"][1:]
    assert table.rows["channels of a texel"] == table.rows["channels in the paper"]


def test_footprints_of_a_shot_tile_the_plane() -> None:
    source = paper_heightfield(MATERIAL, 16)
    shot = stage.plane_shot(source, 0.1, 2, (31, 21))
    middle = 10 * 31 + 15
    assert shot.sides[middle] == pytest.approx(0.4, rel=1e-5)
    np.testing.assert_allclose(shot.views[middle], [0, -(0.5**0.5), 0.5**0.5], atol=1e-6)
    positions = shot.positions.reshape(21, 31, 2).astype(float)
    half = np.array(source.repeat_mm) / 2
    across = (positions[10, 16] - positions[10, 15] + half) % (2 * half) - half
    up = (positions[9, 15] - positions[11, 15] + half) % (2 * half) - half
    # The pixel's area is that of its footprint; differences over two rows are of the second order.
    assert abs(across[0] * up[1] / 2) == pytest.approx(0.4**2, rel=2e-3)


def test_what_cannot_be_is_refused(run: Run) -> None:
    with pytest.raises(InputError, match="need two"):
        equal_cost.comparison(equal_cost.CostSettings(materials=MATERIAL), run)
    with pytest.raises(InputError, match=r"--layers = .* from 2 to 16"):
        figures.ablation(figures.AblationSettings(size=(16, 9), spp=2, side=16, layers="1"), run)
    with pytest.raises(InputError, match="names with commas"):
        equal_cost.CostSettings(materials="")
