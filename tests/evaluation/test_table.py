"""Tables of figures for people and for programs."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest

from loomlight.core.errors import InputError
from loomlight.evaluation.table import Table, write_json


def table() -> Table:
    rows = {"neural": [0.123456, math.nan, 3, None, "text"], "point": [0.0, 1.5e-7, 12345678, None, ""]}
    return Table("Errors", ["a", "b", "c", "d", "e"], rows, note="Of all.")


def test_markdown_rounds_to_significant_digits() -> None:
    lines = table().to_markdown().splitlines()
    assert lines[:3] == ["### Errors", "", "Of all."]
    assert "| neural | 0.123 | – | 3 | – | text |" in lines
    assert "| point | 0 | 1.50e-07 | 12345678 | – |  |" in lines


def test_rows_of_another_length_are_refused() -> None:
    with pytest.raises(ValueError):
        Table("Errors", ["a"], {"neural": [1.0, 2.0]}).to_dict()


def test_json_knows_no_nan(tmp_path: Path) -> None:
    file = tmp_path / "new" / "table.json"
    write_json(file, table().to_dict())
    rows = json.loads(file.read_text())["rows"]
    assert rows["neural"] == {"a": 0.123456, "b": None, "c": 3, "d": None, "e": "text"}


def test_digits_are_kept_as_asked_for(tmp_path: Path) -> None:
    write_json(tmp_path / "a.json", {"x": (1 / 3,)}, digits=2)
    write_json(tmp_path / "b.json", {"x": 1 / 3}, digits=None)
    assert json.loads((tmp_path / "a.json").read_text()) == {"x": [0.33]}
    assert json.loads((tmp_path / "b.json").read_text()) == {"x": 1 / 3}


def test_a_folder_that_cannot_be_made_is_named(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="does not exist"):
        write_json(tmp_path / "no" / "such" / "a.json", {})
