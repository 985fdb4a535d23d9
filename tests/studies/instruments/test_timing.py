"""Times and the kernels behind them."""

from __future__ import annotations

import time

import drjit as dr
import numpy as np
import pytest
from drjit.llvm import Float

from studies.instruments.timing import equal_time, launched_kernels, least_times, one_thread, timed


def test_what_was_made_comes_with_its_time() -> None:
    begun = time.perf_counter()

    def sleep() -> str:
        time.sleep(0.01)
        return "made"

    made, seconds = timed(sleep)
    assert made == "made"
    assert 0.01 <= seconds < time.perf_counter() - begun


def test_kernels_of_the_run_alone_are_listed() -> None:
    before, values = dr.opaque(Float, 2, 1000), dr.opaque(Float, 3, 1000)
    dr.eval(before + 1)

    def run() -> None:
        dr.eval(dr.sqrt(values))

    (kernel,) = launched_kernels(run)
    assert "llvm.sqrt" in kernel["ir"].read()
    assert kernel["execution_time"] >= 0
    assert launched_kernels(lambda: None) == []


def test_runs_take_turns() -> None:
    order: list[str] = []
    times = least_times([lambda: order.append("a"), lambda: order.append("b")], 3)
    assert order == ["a", "b"] * 3
    assert all(spent.seconds >= 0 and spent.cpu_seconds >= 0 for spent in times)


class _Costs:
    """A clock that runs only while a fake renderer works; other programs lengthen a run, by up to `noise`."""

    def __init__(self, noise: float) -> None:
        self.now, self.noise = 0.0, noise
        self.rng = np.random.default_rng(0)

    def work(self, seconds: float) -> None:
        self.now += seconds * (1 + self.noise * self.rng.uniform() ** 2)


@pytest.mark.parametrize("noise", [0.0, 0.3])
@pytest.mark.parametrize(("goal", "expected"), [(0.02, 1), (0.16, 5), (0.56, 25), (5.0, 64)])
def test_equal_time_finds_the_count_whatever_else_runs(
    monkeypatch: pytest.MonkeyPatch, noise: float, goal: float, expected: int
) -> None:
    """A sample costs 0.02 s and a picture 0.06 s more: less than noise lengthens the whole."""
    costs = _Costs(noise)
    monkeypatch.setattr("studies.instruments.timing.time.process_time", lambda: costs.now)
    found = equal_time(goal, lambda count: costs.work(0.06 + 0.02 * count), most=64)
    # The least of three runs is some hundredths too long.
    assert abs(found.count - expected) <= (0 if noise == 0 else 0.1 * expected + 1)
    assert found.seconds == pytest.approx(0.06 + 0.02 * found.count, rel=0.15)


def test_equal_time_counts_what_is_really_done(monkeypatch: pytest.MonkeyPatch) -> None:
    """Passes of eight: a picture takes what they come to, and that is what is said."""
    costs, asked = _Costs(0), []

    def render(count: int) -> None:
        asked.append(count)
        costs.work(0.02 * -(-count // 8) * 8)

    monkeypatch.setattr("studies.instruments.timing.time.process_time", lambda: costs.now)
    found = equal_time(0.3, render, most=64, possible=lambda count: -(-count // 8) * 8)
    assert (found.count, found.seconds) == (16, pytest.approx(0.32))
    assert all(count % 8 == 0 for count in asked)


def test_one_thread_is_for_a_while() -> None:
    before = dr.thread_count()
    with one_thread():
        assert dr.thread_count() == 1
    assert dr.thread_count() == before
