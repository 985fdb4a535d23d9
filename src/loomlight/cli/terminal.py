"""What a person sees and does while a command works: progress, paths of written files, and Ctrl-C."""

from __future__ import annotations

import os
import signal
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import FrameType

# Between lines of a log.
LINE_SECONDS = 10.0


# --------------------------------------------------------------------------------------------------- progress
# An estimate on stderr: a bar where a person is watching, else a line now and then.


@contextmanager
def progress(
    title: str, *, milliseconds: bool = False, unit: str = ""
) -> Iterator[Callable[[int, int], None]]:
    """A function that takes (done, in all) and moves a bar, or without a terminal writes lines.

    Args:
        title: what is done.
        milliseconds: the numbers are times, passed and in all as estimated; otherwise parts of the work, from
            which the time left follows by proportion.
        unit: of a part of the work, whose seconds are shown, such as "frame".
    """
    begun = time.monotonic()
    # When the work will be done, by the latest report; and how long a part takes, in words.
    expected: list[float] = []
    pace = [""]

    def expect(done: int, total: int) -> None:
        now = time.monotonic()
        if milliseconds:
            expected[:] = [now + (total - done) / 1000]
        elif done > 0:
            each = (now - begun) / done
            expected[:] = [now + each * (total - done)]
            pace[0] = f", {each:.2g} s a {unit}" if unit else ""

    if not sys.stderr.isatty():
        lines = Lines(title)

        def write(done: int, total: int) -> None:
            expect(done, total)
            lines.report(done / max(total, 1), expected[0] if expected else None, pace[0])

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
            said = f"about {_duration(max(left, 1))} left" if left > -1 else "longer than estimated"
            return Text(said + pace[0])

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

    def report(self, share: float, expected: float | None, pace: str = "") -> None:
        """Writes a line if it is time.

        Args:
            share: of the work that is done; above 1 where it takes longer than estimated.
            expected: when it will be done, by the clock.
            pace: what else is said of it.
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
        print(f"{self._title}: {said}{pace}", file=sys.stderr, flush=True)


def _duration(seconds: float) -> str:
    if seconds < 100:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 6000 else f"{seconds / 3600:.1f} h"


def done(path: Path, note: str = "") -> None:
    """Prints the path of a written file to stdout, and in parentheses what is to be known of it."""
    print(f"{path} ({note})" if note else path)


# ----------------------------------------------------------------------------------------------- interruption
# Ctrl-C: the work ends within a second and says what it leaves behind.
#
# Dr.Jit keeps Python's lock while it compiles a kernel, for seconds, and no handler of Python's runs
# meanwhile. So the work is done by a forked process; the first one waits, and ends it if it does not end by
# itself.


# Seconds after an interruption: when it is passed on to a process that has not heard of it (the terminal
# tells both), and when that is ended.
_PASS_ON, _END = 0.25, 0.6
INTERRUPTED = 128 + signal.SIGINT
# Makes the cursor visible, which a progress bar hides, and clears its line.
_RESTORE_TERMINAL = "\r\x1b[2K\x1b[?25h"

# What an interruption would leave behind, for the word about it.
_left: str | None = None
# Where the working process tells the waiting one the same: lines of text, the last one holds.
_channel: int | None = None
# Whether this process was interrupted, whatever became of the exception: where a library is being imported,
# it ends in other ones, or in none.
_interrupted = False


def note_left(sentence: str | None) -> None:
    """Notes what an interruption would leave behind from now on, such as "a.png holds a coarse picture."."""
    global _left
    _left = sentence
    if _channel is not None and sentence is not None:
        os.write(_channel, sentence.replace("\n", " ").encode(errors="replace") + b"\n")


def was_interrupted(error: BaseException | None) -> bool:
    """Whether an interruption led to an error: Dr.Jit raises a RuntimeError in its place, imports any."""
    if _interrupted:
        return True
    while error is not None and not isinstance(error, KeyboardInterrupt):
        error = error.__cause__ or error.__context__
    return error is not None


def report_interruption() -> int:
    """Prints that the command was interrupted, and what it left; returns the exit code."""
    if _channel is not None:
        # A second interruption, of both processes by the terminal, must not cut this one short.
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        os.write(_channel, b"\0\n")
    _say(_left)
    return INTERRUPTED


def _hear(signum: int, frame: FrameType | None) -> None:
    """Notes an interruption, and raises it as Python's own handler does."""
    global _interrupted
    _interrupted = True
    # What libraries can only print, as they were called by another one: it is the interruption again.
    sys.unraisablehook = lambda _: None
    signal.default_int_handler(signum, frame)


def _heard(work: Callable[[], int]) -> int:
    """Runs `work`, with interruptions noted where this process does not ignore them."""
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, _hear)
    return work()


def supervised(work: Callable[[], int]) -> int:
    """Runs `work` in a forked process and returns its exit code; where nothing can be forked, in this one.

    An interruption ends the process within a second, whatever it does.
    """
    if not hasattr(os, "fork"):
        return _heard(work)
    global _channel
    sys.stdout.flush()
    sys.stderr.flush()
    source, sink = os.pipe()
    process = os.fork()
    if process == 0:
        os.close(source)
        _channel = sink
        return _heard(work)
    try:
        os.close(sink)
        signal.signal(signal.SIGTERM, lambda *_: _end(process, signal.SIGTERM))
        return _code_of(os.waitpid(process, 0)[1])
    except KeyboardInterrupt:
        return _stopped(process, source)


def _stopped(process: int, source: int) -> int:
    """Waits for an interrupted process, ends it if need be, and says what it has not said itself."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    begun = time.monotonic()
    passed_on = ended = False
    while True:
        found, _ = os.waitpid(process, os.WNOHANG)
        if found == process:
            break
        waited = time.monotonic() - begun
        if waited > _PASS_ON and not passed_on:
            passed_on = True
            os.kill(process, signal.SIGINT)
        if waited > _END and not ended:
            ended = True
            os.kill(process, signal.SIGKILL)
        time.sleep(0.02)
    with os.fdopen(source, "rb") as channel:
        lines = channel.read().decode().splitlines()
    if lines[-1:] != ["\0"]:
        if sys.stderr.isatty():
            sys.stderr.write(_RESTORE_TERMINAL)
        _say(lines[-1] if lines else None)
    return INTERRUPTED


def _say(left: str | None) -> None:
    print(f"loomlight: interrupted. {left or 'Nothing was written.'}", file=sys.stderr, flush=True)


def _code_of(status: int) -> int:
    code = os.waitstatus_to_exitcode(status)
    if code >= 0:
        return code
    name = signal.Signals(-code).name
    if name == "SIGKILL":
        why = "was ended by SIGKILL, as a system ends work that fills its memory: try a smaller --size"
    elif name in ("SIGSEGV", "SIGBUS", "SIGABRT", "SIGILL", "SIGFPE"):
        why = (
            f"crashed ({name}) within a library, which says no more; a damaged file or a fault of the "
            "library may be the cause, so try without the files that the command names, one at a time"
        )
    else:
        why = f"was ended by {name}, which another program sent"
    print(f"loomlight: the work {why}.", file=sys.stderr)
    return 128 - code


def _end(process: int, by: signal.Signals) -> None:
    os.kill(process, by)
    sys.exit(128 + by)
