"""Times of functions, by the wall clock and of the processor, and the Dr.Jit kernels that they launch."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
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
