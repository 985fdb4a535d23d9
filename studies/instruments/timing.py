"""Wall-clock times of functions, and the Dr.Jit kernels that they launch."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any, TypeVar

import drjit as dr

Made = TypeVar("Made")


def timed(run: Callable[[], Made]) -> tuple[Made, float]:
    """The result of `run`, and its wall-clock time, seconds.

    Asynchronous kernels are not included: `run` must evaluate and synchronize.
    """
    start = time.perf_counter()
    made = run()
    return made, time.perf_counter() - start


def launched_kernels(run: Callable[[], object]) -> list[dict[str, Any]]:
    """The compiled kernels that `run` launched, as entries of `dr.kernel_history()`.

    Times in them are milliseconds; `entry["ir"].read()` is the kernel's text in LLVM IR or PTX.
    """
    with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
        dr.kernel_history_clear()
        run()
        return [entry for entry in dr.kernel_history() if entry["type"] == dr.KernelType.JIT]
