"""What code does, counted, which is the same on any machine: processor seconds are not."""

from __future__ import annotations

import sys
import tracemalloc
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Any


def calls_of(run: Callable[[], object]) -> int:
    """How many functions are called meanwhile in this thread, those of libraries included."""
    count = 0

    def count_call(frame: FrameType, event: str, argument: Any) -> None:
        nonlocal count
        count += event in ("call", "c_call")

    before = sys.getprofile()
    sys.setprofile(count_call)
    try:
        run()
    finally:
        sys.setprofile(before)
    return count


@contextmanager
def allocates_at_most(size: int) -> Iterator[None]:
    """Requires that no more bytes than these are held at once by what Python and NumPy allocate meanwhile."""
    tracemalloc.start()
    try:
        yield
        assert tracemalloc.get_traced_memory()[1] <= size
    finally:
        tracemalloc.stop()
