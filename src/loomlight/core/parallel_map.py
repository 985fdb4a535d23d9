"""Functions that release Python's lock (numpy's loops), run on all cores."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from typing import Generic, TypeVar

_Item = TypeVar("_Item")
_Result = TypeVar("_Result")


@cache
def core_count() -> int:
    """Cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def parallel_map(function: Callable[[_Item], _Result], items: Iterable[_Item]) -> list[_Result]:
    """Results of a function, in the order of the items; the caller's thread takes its share of them.

    Any number of threads may call it at once.

    Threads of the pool keep no reference to the function, an item or a result: what these hold is freed by
    the caller's thread. A pool thread that frees memory of Dr.Jit waits for Dr.Jit's lock with Python's lock
    held, and the thread that holds Dr.Jit's may be waiting for Python's.
    """
    tasks = [_Task(function, item) for item in items]
    futures = [_pool().submit(task.run) for task in tasks]
    # The pool begins with the first items, this thread with the last.
    for task, future in zip(reversed(tasks), reversed(futures), strict=True):
        if future.cancel():
            task.run()
        else:
            future.result()
        task.drop_call()
    return [task.result() for task in tasks]


class _Task(Generic[_Item, _Result]):
    """A call whose function, item and result are dropped by the thread that asks for the result."""

    def __init__(self, function: Callable[[_Item], _Result], item: _Item) -> None:
        self._call: tuple[Callable[[_Item], _Result], _Item] | None = (function, item)
        self._results: list[_Result] = []
        self._error: BaseException | None = None

    def run(self) -> None:
        """Calls the function; returns nothing, as the pool's threads hold what it returns for a while."""
        assert self._call is not None
        try:
            self._results.append(self._call[0](self._call[1]))
        except BaseException as error:
            self._error = error

    def drop_call(self) -> None:
        """Drops function and item."""
        self._call = None

    def result(self) -> _Result:
        """The result, once; raises the function's error."""
        error, self._error = self._error, None
        if error is not None:
            try:
                raise error
            finally:
                del error  # its traceback holds this frame
        return self._results.pop()


@cache
def _pool() -> ThreadPoolExecutor:
    return ThreadPoolExecutor(core_count(), thread_name_prefix="loomlight")


if hasattr(os, "register_at_fork"):
    # A forked process has none of the pool's threads.
    os.register_at_fork(after_in_child=_pool.cache_clear)
