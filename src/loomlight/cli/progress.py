"""A line of progress with an estimate on stderr, if a person is watching."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager


@contextmanager
def progress(title: str, *, milliseconds: bool = False) -> Iterator[Callable[[int, int], None]]:
    """A function that takes (done, in all) and moves a bar; without a terminal it does nothing.

    Args:
        title: what is done.
        milliseconds: the numbers are times, passed and in all as estimated; otherwise parts of the work, from
            which the time left follows by proportion.
    """
    if not sys.stderr.isatty():
        yield lambda done, total: None
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, ProgressColumn, Task, TextColumn, TimeElapsedColumn
    from rich.text import Text

    begun = time.monotonic()
    # When the work will be done, by the latest report.
    expected: list[float] = []

    class TimeLeftColumn(ProgressColumn):
        """About how many seconds are left."""

        def render(self, task: Task) -> Text:
            if not expected:
                return Text("")
            left = expected[0] - time.monotonic()
            return Text(f"about {_duration(max(left, 1))} left" if left > -1 else "longer than estimated")

    columns = (TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn(), TimeLeftColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task(title, total=None)

        def report(done: int, total: int) -> None:
            now = time.monotonic()
            if milliseconds:
                expected[:] = [now + (total - done) / 1000]
            elif done > 0:
                expected[:] = [now + (now - begun) * (total - done) / done]
            bar.update(task, completed=done, total=total)

        yield report


def _duration(seconds: float) -> str:
    if seconds < 100:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 6000 else f"{seconds / 3600:.1f} h"
