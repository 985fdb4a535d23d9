"""Functions on all cores: results in order, from any thread, in forked processes."""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager

import pytest

from loomlight.core.parallel_map import core_count, parallel_map
from tests.limits import HANG


def test_results_are_in_the_order_of_the_items() -> None:
    assert parallel_map(lambda number: number**2, range(100)) == [number**2 for number in range(100)]
    assert parallel_map(lambda number: number, []) == []


def test_all_cores_take_part() -> None:
    """Each call waits until as many are running as there are cores: without them it would time out."""
    barrier = threading.Barrier(core_count())

    def wait(_: int) -> int:
        barrier.wait(timeout=HANG)
        return threading.get_ident()

    assert len(set(parallel_map(wait, range(core_count())))) == core_count()


def test_calls_may_come_from_several_threads_and_be_nested() -> None:
    def total(start: int) -> int:
        return sum(parallel_map(lambda number: sum(parallel_map(abs, [start, -number])), range(20)))

    with ThreadPoolExecutor(8) as threads:
        assert list(threads.map(total, range(40))) == [20 * start + 190 for start in range(40)]


def test_errors_are_raised() -> None:
    with pytest.raises(ZeroDivisionError):
        parallel_map(lambda number: 1 // number, [2, 1, 0])


def test_a_forked_process_has_threads_of_its_own() -> None:
    parallel_map(abs, range(10))
    child = os.fork()
    if child == 0:
        os._exit(0 if parallel_map(abs, [-1, -2]) == [1, 2] else 1)
    assert os.waitpid(child, 0)[1] == 0


# One in thirty of the calls frees something on another thread if the pool's threads keep references.
ROUNDS = 150


class _Freed:
    """Notes which thread frees it."""

    def __init__(self, threads: list[int]) -> None:
        self.threads = threads

    def __del__(self) -> None:
        self.threads.append(threading.get_ident())


@contextmanager
def _frequent_switches() -> Iterator[None]:
    """Threads take turns often, so that those of the pool are overtaken by this one."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    try:
        yield
    finally:
        sys.setswitchinterval(before)


def test_what_a_call_holds_is_freed_by_the_caller() -> None:
    """Function, items and results: a pool thread that frees memory of Dr.Jit may wait for it for ever."""
    threads: list[int] = []

    def call() -> None:
        held = _Freed(threads)

        def function(item: _Freed) -> tuple[_Freed, _Freed, _Freed]:
            return held, item, _Freed(threads)

        parallel_map(function, [_Freed(threads) for _ in range(8)])

    with _frequent_switches():
        for _ in range(ROUNDS):
            call()
    assert len(threads) == ROUNDS * 17
    assert set(threads) == {threading.get_ident()}
