"""Times of functions, by the wall clock and of the processor, and the Dr.Jit kernels that they launch."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from typing import Any, TypeVar

Made = TypeVar("Made")


def timed(run: Callable[[], Made]) -> tuple[Made, float]:
    """The result of `run`, and its wall-clock time, seconds.

    Asynchronous kernels are not included: `run` must evaluate and synchronize.
    """
    start = time.perf_counter()
    made = run()
    return made, time.perf_counter() - start


@dataclass(frozen=True)
class Spent:
    """The time of a run.

    Attributes:
        seconds: by the wall clock.
        cpu_seconds: of all threads of this process; other programs do not lengthen them.
    """

    seconds: float
    cpu_seconds: float


def spent(run: Callable[[], Made]) -> tuple[Made, Spent]:
    """The result of `run`, and its times; as of `timed`, it must evaluate and synchronize."""
    before = time.process_time()
    made, seconds = timed(run)
    return made, Spent(seconds, time.process_time() - before)


def least_times(runs: Sequence[Callable[[], object]], turns: int) -> list[Spent]:
    """The least times of each run; they take turns, so that all see the same machine."""
    taken = [[spent(run)[1] for run in runs] for _ in range(turns)]
    return [
        Spent(min(turn[number].seconds for turn in taken), min(turn[number].cpu_seconds for turn in taken))
        for number in range(len(runs))
    ]


@contextmanager
def one_thread() -> Iterator[None]:
    """Dr.Jit works with one thread: others spin before they sleep, which counts as processor time."""
    # As in `launched_kernels`.
    import drjit as dr

    before = dr.thread_count()
    dr.set_thread_count(1)
    try:
        yield
    finally:
        dr.set_thread_count(before)


@dataclass(frozen=True)
class EqualTime:
    """How much of something takes as long as is asked for.

    Attributes:
        count: of it, 1 or more.
        seconds: processor seconds that so many took when they were measured, not as they were predicted.
    """

    count: int
    seconds: float


# Counts between which the time of one more is measured: their distance is far above noise.
_FEW, _MANY = 2, 24
_CORRECTIONS = 3


def equal_time(
    goal: float,
    counted: Callable[[int], object],
    *,
    most: int,
    turns: int = 3,
    possible: Callable[[int], int] = lambda count: count,
) -> EqualTime:
    """The count of which `counted` takes about `goal` processor seconds.

    A line through two counts, each the least of some turns, predicts it; it is measured then, and corrected
    where another count is nearer.

    Args:
        counted: works with a count, whose time grows with it.
        most: bounds counts.
        turns: of each measurement. The least is taken, as other programs lengthen times and shorten none.
        possible: the count that `counted` really works with where another is asked for.
    """

    def measure(*counts: int) -> list[EqualTime]:
        runs = [partial(counted, count) for count in counts]
        for run in runs:  # compiles
            run()
        times = least_times(runs, turns)
        return [EqualTime(count, taken.cpu_seconds) for count, taken in zip(counts, times, strict=True)]

    few, many = measure(possible(_FEW), possible(_MANY))
    one_more = max((many.seconds - few.seconds) / (many.count - few.count), 1e-9)
    measured = {each.count: each for each in (few, many)}
    latest = few
    for _ in range(1 + _CORRECTIONS):
        better = latest.count + (goal - latest.seconds) / one_more
        count = possible(min(max(round(better), 1), most))
        if count not in measured:
            (measured[count],) = measure(count)
        latest = measured[count]
    return min(measured.values(), key=lambda each: abs(each.seconds - goal))


def launched_kernels(run: Callable[[], object]) -> list[dict[str, Any]]:
    """The compiled kernels that `run` launched, as entries of `dr.kernel_history()`.

    Times in them are milliseconds; `entry["ir"].read()` is the kernel's text in LLVM IR or PTX.
    """
    # Studies of whole processes, whose memory counts from this one's, use the rest.
    import drjit as dr

    with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
        dr.kernel_history_clear()
        run()
        return [entry for entry in dr.kernel_history() if entry["type"] == dr.KernelType.JIT]
