"""kuznetsov2021 at equal steps: gains and what they are carried on to, bright queries, parts of a query.

Covers: studies/papers/kuznetsov2021/equal_steps.py, studies/papers/kuznetsov2021/bright_queries.py
Covers: studies/papers/kuznetsov2021/breakdown.py
"""

from __future__ import annotations

import numpy as np
import pytest

from loomlight.evaluation.table import Table
from studies.harness.study import Run, stored_tables, with_tables
from studies.instruments.halved_truth import HalvedTruth
from studies.papers.kuznetsov2021 import breakdown, bright_queries, equal_steps
from studies.papers.kuznetsov2021.designs import (
    ALL_DESIGNS,
    DESIGNS,
    OURS,
    RAINER19,
    RAINER19_SMALL,
    WITHOUT,
)
from studies.papers.kuznetsov2021.stage import clamped

MATERIALS = ("twisted wool", "cliff rock")
# Records have six digits.
ROUNDING = 1e-5
COLUMNS = ["1", "2", "4", "8", "16"]


def _errors(title: str) -> Table:
    """Errors whose gain is the tenth root of millions of queries; Rainer's are twice ours."""
    table = Table(title, COLUMNS)
    for scale, name in enumerate(MATERIALS, 1):
        ours = [scale * 4.0 / k for k in range(1, 6)]
        gain = [float(column) ** 0.1 for column in COLUMNS]
        table.rows[f"{name}, {WITHOUT}"] = [a * b for a, b in zip(ours, gain, strict=True)]
        table.rows[f"{name}, {OURS}"] = [*ours]
        for design in (RAINER19, RAINER19_SMALL):
            table.rows[f"{name}, {design}"] = [None, 2 * ours[1], None, None, None]
    return table


@pytest.fixture
def found() -> dict[str, Table]:
    """The tables of such errors, by their titles."""
    titles = [
        equal_steps._PICTURES,
        equal_steps._FLIP,
        *(equal_steps._of_size(k) for k in range(equal_steps._LEVELS)),
    ]
    figures = with_tables(*(_errors(title) for title in titles))
    return {table.title: table for table in equal_steps.tables(figures)}


def test_gains_grow_as_their_law_and_are_carried_on(found: dict[str, Table]) -> None:
    gains = found["Gain of the offset, pictures, by millions of queries seen"]
    for row in gains.rows.values():
        assert row == pytest.approx([1, 2**0.1, 4**0.1, 8**0.1, 16**0.1], rel=ROUNDING)
    assert list(gains.rows) == [*MATERIALS, "geometric mean"]
    carried = found["Gain of the offset at the paper's queries, pictures"]
    wanted = (equal_steps.PAPER_QUERIES / 1e6) ** 0.1
    for row in carried.rows.values():
        longest, gain, said, exponent, whole, last = row
        assert longest == 16
        assert (gain, said) == pytest.approx((16**0.1, 16**0.1), rel=ROUNDING)
        assert exponent == pytest.approx(0.1, abs=ROUNDING)
        # From 16 million on it is eleven doublings, which rounding of four bends.
        assert (whole, last) == pytest.approx((wanted, wanted), rel=10 * ROUNDING)


def test_few_trainings_are_not_carried_on() -> None:
    gains = Table("", COLUMNS[:3], {"one": [1.0, 1.1, 1.2]})
    assert equal_steps._extrapolated("", gains).rows["one"] == [4, 1.2, None, None, None, None]


def test_baselines_are_compared_at_as_many_steps(found: dict[str, Table]) -> None:
    ratios = found["MSE of Rainer et al. 2019 over ours, pictures"]
    assert ratios.columns == [f"{RAINER19}, 2 million", f"{RAINER19_SMALL}, 2 million"]
    assert ratios.rows[f"{MATERIALS[0]}, over {OURS}"] == pytest.approx([2, 2], rel=ROUNDING)
    assert ratios.rows[f"geometric mean, over {WITHOUT}"] == pytest.approx([2 / 2**0.1] * 2, rel=ROUNDING)


def test_a_gain_by_size_is_of_the_longest_training_that_all_have(found: dict[str, Table]) -> None:
    table = found["Gain of the offset by texels of a footprint's side"]
    assert table.columns == ["1", "2", "4", "8"]
    assert table.rows["geometric mean"] == pytest.approx([16**0.1] * 4, rel=ROUNDING)


def test_the_small_decoder_has_about_as_many_weights_as_ours() -> None:
    small, ours = ALL_DESIGNS[RAINER19_SMALL], DESIGNS[OURS]
    assert str(small.weights) in RAINER19_SMALL
    assert small.weights == pytest.approx(ours.weights, rel=0.01)


def test_values_are_clamped_to_white() -> None:
    halves = (np.array([[[0.5, 2.0, 1.0]]], np.float32), np.array([[[0.25, 9.0, 1.5]]], np.float32))
    found = clamped(HalvedTruth(halves))
    np.testing.assert_array_equal(found.halves[0], [[[0.5, 1, 1]]])
    np.testing.assert_array_equal(found.halves[1], [[[0.25, 1, 1]]])


def test_a_bright_query_alone_is_most_of_the_error(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of 9 queries of 0.1 and one of 3: its share is 9/10 = 0.9, of all 0.009 more."""
    values = np.full((1, 10, 3), 0.1, np.float32)
    values[0, 4] = 3
    monkeypatch.setattr(bright_queries, "traced", lambda *_: HalvedTruth((values, values)))
    settings = bright_queries.BrightSettings(side=16, materials="turtle shell", levels=1, probes=10)
    (table,) = stored_tables(bright_queries.bright_queries(settings, run).figures)
    brightest, degrees, black, alone, white, above = table.rows["turtle shell, 0"]
    assert brightest == pytest.approx(3)
    assert 0 <= degrees < 90
    assert (black, alone, white) == pytest.approx((909, 900, 109), rel=1e-5)
    assert above == pytest.approx(10)


def test_parts_of_a_query_are_the_models() -> None:
    """Layers of 9, 25, 25, 25, 1 and 11, 25, 25, 25, 3; twelve texels of seven numbers."""
    table = breakdown._table_of_parts(
        dict.fromkeys([*breakdown._STAGES, breakdown._WHOLE, breakdown._RAINER], 2.0), ""
    )
    assert table.rows["offset network"][1] == 9 * 25 + 2 * 625 + 25
    assert table.rows["decoder"][1] == 11 * 25 + 2 * 625 + 75
    assert table.rows["stage 1"][1:] == [9 * 25 + 2 * 625 + 25 + 12 * 7, 4 * 12 * 7, 6.0, 0.75]
    assert table.rows[breakdown._WHOLE][1:3] == [3184, 336]
    # All of the paper's 35 725 weights but the biases.
    assert table.rows[breakdown._RAINER][1] == 35725 - 4 * 106 - 3


def test_a_breakdown_counts_what_the_model_counts(run: Run) -> None:
    settings = breakdown.BreakdownSettings(size=(8, 4), resolution=8, turns=1)
    parts = breakdown._parts(settings)
    assert [*parts] == [*breakdown._STAGES, breakdown._WHOLE, breakdown._RAINER]
    for part in parts.values():
        part()
