"""Metrics against values computed by hand, and their tables."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.evaluation.metrics import Classes, ErrorSums, error_sums, sums_by_class
from loomlight.evaluation.table import Table, write_json


def test_metrics_of_two_values() -> None:
    sums = error_sums([0.5, 0.0], [0.4, 0.006])
    assert sums.nmae == pytest.approx((0.1 + 0.006) / 0.406)
    assert sums.mse == pytest.approx((0.01 + 0.000036) / 2)
    assert sums.bias == pytest.approx((0.1 - 0.006) / 0.406)


def test_sums_of_parts_are_those_of_the_whole() -> None:
    rng = np.random.default_rng(1)
    p, t = rng.random((2, 60))
    parted = error_sums(p[:25], t[:25]) + error_sums(p[25:], t[25:])
    whole = error_sums(p, t).values()
    assert parted.values() == pytest.approx(whole, rel=1e-12)


def test_nothing_is_not_perfect() -> None:
    assert math.isnan(ErrorSums().nmae)
    assert math.isnan(error_sums([1.0], [0.0]).nmae)
    assert math.isnan(error_sums([math.nan, 1.0], [1.0, 1.0]).nmae)
    with pytest.raises(ValueError, match="3 predictions of 2 values"):
        error_sums([1.0, 1.0, 1.0], [1.0, 1.0])


def test_classes_part_the_queries() -> None:
    truth = np.ones((2, 3, 3))  # two pairs, three footprints, three colours
    predicted = truth.copy()
    predicted[1, 2] = 2.0
    size = Classes(("small", "large"), np.array([[0, 0, 1], [0, 0, 1]]))
    sums = sums_by_class(predicted, truth, [size])
    assert sums["overall"].nmae == pytest.approx(3 / 18)
    assert sums["small"].nmae == 0
    assert sums["large"].nmae == pytest.approx(1 / 2)
    assert sums["large"].count == 6


def test_a_table_in_both_forms(tmp_path: Path) -> None:
    table = Table("Errors", ["nMAE", "MSE", "n"], {"neural": [0.12345, math.nan, 3]}, note="Of all.")
    assert table.to_markdown() == (
        "### Errors\n\nOf all.\n\n|  | nMAE | MSE | n |\n|---|---:|---:|---:|\n| neural | 0.123 | – | 3 |\n"
    )
    write_json(tmp_path / "t.json", table.to_dict())
    read = json.loads((tmp_path / "t.json").read_text())
    assert read["rows"] == {"neural": {"nMAE": 0.12345, "MSE": None, "n": 3}}


def test_json_keeps_as_many_digits_as_asked_for(tmp_path: Path) -> None:
    content = {"a third": 1 / 3, "none": [math.inf], "millions": 12_345_678, "size": "16 × 16"}
    rounded, whole = tmp_path / "rounded.json", tmp_path / "made" / "whole.json"
    write_json(rounded, content)
    write_json(whole, content, digits=None)
    assert json.loads(rounded.read_text(encoding="utf-8")) == content | {"a third": 0.333333, "none": [None]}
    assert json.loads(whole.read_text(encoding="utf-8")) == content | {"none": [None]}


def test_json_that_cannot_be_written_is_a_fault(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    for folder in (tmp_path / "none" / "none", tmp_path / "file"):
        with pytest.raises(InputError, match="does not exist"):
            write_json(folder / "t.json", {})
    assert not (tmp_path / "none").exists()
