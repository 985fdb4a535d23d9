"""Times and the kernels behind them."""

from __future__ import annotations

import time

import drjit as dr
from drjit.llvm import Float

from studies.instruments.timing import launched_kernels, least_times, timed


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
