"""Tables of figures in pages are those of the records.

Covers: tools/generate/figures.py
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from loomlight.core.settings import Settings
from loomlight.evaluation.table import Table
from studies.harness.record import Record
from studies.harness.study import Found, NoSettings, Study, with_tables
from tools.generate import figures
from tools.generate.figures import pages, with_figures

NAME = "accuracy/one"


@pytest.fixture
def study(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Study[Settings]:
    """A study with two tables in its record."""
    content = with_tables(
        Table("Errors", ["nMAE"], {"lobes": [0.0531]}, note="Of 24 fabrics."),
        Table("Times", ["s"], {"lobes": [1.25], "point": [None]}),
    )
    made = Study(NAME, "one", NoSettings(), lambda settings, run: Found({}))
    machine = "x86_64, 2 cores, AMD EPYC"
    Record(NAME, f"python -m studies {NAME}", "abc", machine, figures=content).write(tmp_path)
    monkeypatch.setattr(figures, "RECORDS", tmp_path)
    monkeypatch.setattr(figures, "ROOT", tmp_path)
    monkeypatch.setattr(figures, "find_study", lambda name: made)
    return made


def test_all_tables_stand_between_the_comments(study: Study[Settings]) -> None:
    text = with_figures(f"before\n\n<!-- study {NAME} -->\nold\n<!-- end -->\n\nafter\n")
    assert text == (
        f"before\n\n<!-- study {NAME} -->\n\n"
        "**Errors.** Of 24 fabrics.\n\n|  | nMAE |\n|---|---:|\n| lobes | 0.0531 |\n\n"
        "**Times.**\n\n|  | s |\n|---|---:|\n| lobes | 1.25 |\n| point | – |\n\n"
        f"`python -m studies {NAME}`; 2 cores, AMD EPYC, sources `abc`; `accuracy/one.json`.\n\n"
        "<!-- end -->\n\nafter\n"
    )
    assert with_figures(text) == text


def test_one_table_is_asked_for_by_its_title(study: Study[Settings]) -> None:
    text = with_figures(f"<!-- study {NAME}: Times -->\n<!-- end -->")
    assert "| lobes | 1.25 |" in text
    assert "nMAE" not in text
    with pytest.raises(ValueError, match="no table of the title Heights"):
        with_figures(f"<!-- study {NAME}: Heights -->\n<!-- end -->")


def test_one_cell_stands_within_a_line(study: Study[Settings]) -> None:
    places = (
        f"<!-- cell {NAME}: {where} -->old<!-- end -->" for where in ("Errors / lobes", "Times / lobes / s")
    )
    text = with_figures(f"| {' | '.join(places)} |\n")
    assert text == (
        f"| <!-- cell {NAME}: Errors / lobes -->0.0531<!-- end --> "
        f"| <!-- cell {NAME}: Times / lobes / s -->1.25<!-- end --> |\n"
    )
    assert with_figures(text) == text
    for where in ("Errors / point", "Heights / lobes", "Times / lobes / m", "Errors"):
        with pytest.raises(ValueError, match="has no cell"):
            with_figures(f"<!-- cell {NAME}: {where} --><!-- end -->")


def test_tables_of_figures_are_read_from_them(
    study: Study[Settings], monkeypatch: pytest.MonkeyPatch
) -> None:
    derived = replace(study, tables=lambda found: [Table("Count", ["tables"], {"": [len(found["tables"])]})])
    monkeypatch.setattr(figures, "find_study", lambda name: derived)
    assert "|  | 2 |" in with_figures(f"<!-- study {NAME} -->\n<!-- end -->")


def test_pages_are_as_records_say() -> None:
    for page in pages():
        text = page.read_text(encoding="utf-8")
        assert with_figures(text) == text, f"{page.name}: run python -m tools.generate.figures"
