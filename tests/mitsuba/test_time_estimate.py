"""Time left: predicted at once, corrected by what is measured."""

from __future__ import annotations

import pytest

from loomlight.mitsuba.pictures import TimeEstimate, sample_seconds


class Clock:
    """Seconds that pass when they are told to."""

    def __init__(self) -> None:
        self.now = 100.0

    def __call__(self) -> float:
        return self.now


def test_the_prediction_is_reported_at_once() -> None:
    reports: list[tuple[int, int]] = []
    TimeEstimate({"bake": 2.0, "whole": 8.0}, lambda done, total: reports.append((done, total)), Clock())
    assert reports == [(0, 10_000)]


def test_a_slow_machine_is_noticed_and_passes_are_measured() -> None:
    clock = Clock()
    reports: list[tuple[int, int]] = []
    estimate = TimeEstimate(
        {"bake": 2.0, "whole": 8.0}, lambda done, total: reports.append((done, total)), clock
    )
    with estimate.step("bake"):
        clock.now += 5
    # Twice as slow as predicted, with one second of trust: (5 + 1) / (2 + 1).
    assert reports[-1] == (5000, 5000 + 16_000)
    with estimate.step("whole") as advance:
        clock.now += 6
        advance(1, 4)
        assert estimate.left() == pytest.approx(2 * 8 * 3 / 4)
        # The first pass compiled kernels; from the second on passes are measured.
        clock.now += 1
        advance(2, 4)
        assert estimate.left() == pytest.approx(2.0)
        clock.now += 2
        advance(4, 4)
    assert reports[-1] == (14_000, 14_000)


def test_samples_cost_what_their_model_does() -> None:
    assert sample_seconds("point", 2_000_000) == pytest.approx(2 * sample_seconds("point", 1_000_000))
    assert 0 < sample_seconds("point", 1) < sample_seconds("lobes", 1)
    assert sample_seconds("a model of tomorrow", 1) > 0
