"""Functions that release Python's lock (numpy's loops, Numba's with `nogil`), run on all cores."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from typing import TypeVar

_Item = TypeVar("_Item")
_Result = TypeVar("_Result")


@cache
def core_count() -> int:
    """Cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def parallel_map(function: Callable[[_Item], _Result], items: Iterable[_Item]) -> list[_Result]:
    """Results of a function, in the order of the items; the caller's thread takes its share of them.

    Any number of threads may call it at once. (Numba's own threads may not be used so: its "workqueue" layer
    ends the process when two threads call it, and OpenMP's when a process that forked does.)
    """
    tasks = [(item, _pool().submit(function, item)) for item in items]
    # The pool begins with the first items, this thread with the last.
    results = [function(item) if future.cancel() else future.result() for item, future in reversed(tasks)]
    return results[::-1]


@cache
def _pool() -> ThreadPoolExecutor:
    return ThreadPoolExecutor(core_count(), thread_name_prefix="loomlight")


if hasattr(os, "register_at_fork"):
    # A forked process has none of the pool's threads.
    os.register_at_fork(after_in_child=_pool.cache_clear)
