"""Every study runs when it is small, and every record is one of a study and shown by a page."""

from __future__ import annotations

from pathlib import Path

import pytest

from loomlight.core.errors import InputError
from loomlight.core.settings import declared
from studies.harness.catalogue import catalogue, find_study
from studies.harness.probes import PROBES
from studies.harness.record import RECORDS, REPOSITORY, read_record, records
from studies.harness.run import run_study

# They compare trainings that only whoever has made them has.
OF_TRAININGS = tuple(
    f"papers/chen2024/{name}" for name in ("fig7", "ablations", "error_against_cost", "learning_curve")
)
# They run other programs, which are installed by hand.
OF_PROGRAMS = ("accuracy/blender",)

# They measure what another study does by other settings, and are that study when they are small.
SAME_WHEN_SMALL = {
    "accuracy/image_benchmark": "accuracy/comparison_denim",
    "accuracy/realtime_frames_256": "accuracy/realtime_frames",
    "papers/zeltner2024/speed_six_layers": "papers/zeltner2024/speed",
    "papers/zhu2024/table1_large": "papers/zhu2024/table1_cylinder",
}


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in catalogue() if name not in SAME_WHEN_SMALL])
def test_every_study_runs_when_it_is_small(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its figures are whole, and tables, page and record are made of them."""
    # Probes take longer than small studies; tests of their own ask them.
    monkeypatch.setattr("studies.harness.run.probed", lambda names: {})
    study = find_study(name)
    if name in OF_PROGRAMS:
        with pytest.raises(InputError, match="pip install bpy"):
            run_study(study, study.settings.changed(**study.small, python="nowhere"), tmp_path, tmp_path)
        return
    if name in OF_TRAININGS:
        with pytest.raises(InputError, match=r"make (them|the training) with python -m studies\.papers"):
            run_study(study, study.settings.changed(**study.small), tmp_path, tmp_path / "runs")
        return
    record = run_study(study, study.settings.changed(**study.small), tmp_path, tmp_path / "runs")
    assert record.figures
    assert read_record(tmp_path / f"{name}.json").study == name
    page = (tmp_path / f"{name}.md").read_text(encoding="utf-8")
    tables = study.tables(record.figures)
    assert all(table.rows and table.title in page for table in tables)
    # What is found is in the record: a study without figures has something to look at.
    assert tables or len(record.figures) > 0
    assert record.command in page


@pytest.mark.parametrize("name", list(catalogue()))
def test_studies_say_what_they_are(name: str) -> None:
    study, declaration = find_study(name), catalogue()[name]
    assert (study.name, study.shows) == (declaration.name, declaration.shows)
    assert len(study.about) > 60
    assert set(study.stands_on) <= set(PROBES)
    assert set(study.small) <= set(declared(type(study.settings)))
    study.settings.changed(**study.small)


@pytest.mark.parametrize(("name", "other"), SAME_WHEN_SMALL.items())
def test_studies_that_are_not_run_are_those_that_are(name: str, other: str) -> None:
    left_out, run = find_study(name), find_study(other)
    assert (left_out.run, left_out.tables) == (run.run, run.tables)
    assert left_out.settings.changed(**left_out.small) == run.settings.changed(**run.small)


def test_every_record_is_one_of_a_study() -> None:
    for name, record in records(RECORDS).items():
        study = find_study(name)
        assert set(record.settings) <= set(declared(type(study.settings))), name
        for table in study.tables(record.figures):
            assert table.to_markdown()


def test_every_record_is_named_by_a_page() -> None:
    folders = [REPOSITORY / "docs", REPOSITORY / "studies" / "papers", REPOSITORY / "README.md"]
    files = [file for folder in folders for file in ([folder] if folder.is_file() else folder.rglob("*.md"))]
    text = "\n".join(file.read_text(encoding="utf-8") for file in files)
    unnamed = [name for name in records(RECORDS) if name.removeprefix("papers/") not in text]
    assert unnamed == [], "no page names them"
