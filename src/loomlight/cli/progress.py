"""Progress with an estimate on stderr: a bar where a person is watching, else a line now and then."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

# Between lines of a log.
LINE_SECONDS = 10.0


@contextmanager
def progress(title: str, *, milliseconds: bool = False) -> Iterator[Callable[[int, int], None]]:
    """A function that takes (done, in all) and moves a bar, or without a terminal writes lines.

    Args:
        title: what is done.
        milliseconds: the numbers are times, passed and in all as estimated; otherwise parts of the work, from
            which the time left follows by proportion.
    """
    begun = time.monotonic()
    # When the work will be done, by the latest report.
    expected: list[float] = []

    def expect(done: int, total: int) -> None:
        now = time.monotonic()
        if milliseconds:
            expected[:] = [now + (total - done) / 1000]
        elif done > 0:
            expected[:] = [now + (now - begun) * (total - done) / done]

    if not sys.stderr.isatty():
        lines = Lines(title)

        def write(done: int, total: int) -> None:
            expect(done, total)
            lines.report(done / max(total, 1), expected[0] if expected else None)

        yield write
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, ProgressColumn, Task, TextColumn, TimeElapsedColumn
    from rich.text import Text

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
            expect(done, total)
            bar.update(task, completed=done, total=total)

        yield report


class Lines:
    """Lines such as "denim: 40 %, about 20 s left" on stderr, ten seconds apart: none of short work."""

    def __init__(self, title: str, clock: Callable[[], float] = time.monotonic) -> None:
        self._title, self._clock = title, clock
        self._next = clock() + LINE_SECONDS

    def report(self, share: float, expected: float | None) -> None:
        """Writes a line if it is time.

        Args:
            share: of the work that is done; above 1 where it takes longer than estimated.
            expected: when it will be done, by the clock.
        """
        now = self._clock()
        if now < self._next:
            return
        self._next = now + LINE_SECONDS
        if share > 1:
            said = "longer than estimated"
        elif expected is None or expected <= now:
            said = f"{100 * share:.0f} %"
        else:
            said = f"{100 * share:.0f} %, about {_duration(expected - now)} left"
        print(f"{self._title}: {said}", file=sys.stderr, flush=True)


def _duration(seconds: float) -> str:
    if seconds < 100:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 6000 else f"{seconds / 3600:.1f} h"


def done(path: Path, note: str = "") -> None:
    """Prints the path of a written file to stdout, and in parentheses what is to be known of it."""
    print(f"{path} ({note})" if note else path)
