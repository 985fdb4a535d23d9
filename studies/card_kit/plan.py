"""Runs jobs within some minutes, in their order, and keeps in a file how far each has come.

A job that does not resume runs if its expected minutes are left, one that resumes in what is left. Where the
minutes are over it is interrupted: what it keeps is written whole (`core/files.py:replacing`), and it goes on
from its last checkpoint. A job that fails ends no other.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path

from loomlight.core.errors import InputError
from loomlight.evaluation.table import write_json
from studies.card_kit.jobs import Job, Places
from studies.card_kit.machine import Has
from studies.harness.study import REPOSITORY

WAITING, DONE, STOPPED, FAILED, SKIPPED = "waiting", "done", "stopped", "failed", "skipped"
# A job that resumes begins with so many minutes left or more.
_LEAST = 1.0
# A job that does not resume and takes so many times its expected minutes hangs.
_PATIENCE = 3.0
# Minutes that stopping a job may take.
_GRACE = 0.25
# A study that missed a bar has written its record.
_MISSED = 1


@dataclass(frozen=True)
class Standing:
    """How far a job has come.

    Attributes:
        state: `WAITING`, `DONE`, `STOPPED`, `FAILED` or `SKIPPED`.
        says: a sentence about it.
        minutes: spent on it, in all runs.
        command: that was run last; with another one the job begins anew.
    """

    state: str = WAITING
    says: str = ""
    minutes: float = 0.0
    command: str = ""


@dataclass(frozen=True)
class Ended:
    """How a command ended.

    Attributes:
        code: its exit code; None where it was stopped.
        last: its last line.
    """

    code: int | None
    last: str = ""


# Runs words after `python -m` for at most so many minutes; what they print is kept in the file.
Runner = Callable[[Sequence[str], Path, float], Ended]


class Plan:
    """Jobs with their standing, in a file that is rewritten at every change."""

    def __init__(self, jobs: Sequence[Job], places: Places, rehearses: bool) -> None:
        """
        Raises:
            InputError: the file is damaged.
        """
        self.jobs, self.rehearses, self._places = list(jobs), rehearses, places
        self.file = places.work / "state.json"
        self.standings = {job.name: Standing() for job in jobs} | _read(self.file)

    def run(
        self,
        minutes: float,
        has: Callable[[str], Has],
        runner: Runner,
        clock: Callable[[], float] = time.monotonic,
        report: Callable[[int, int], None] = lambda done, total: None,
    ) -> None:
        """Runs what fits.

        Args:
            minutes: for all.
            has: asks the machine for a need.
            clock: seconds.
            report: called with (jobs looked at, in all).
        """
        end = clock() + 60 * minutes
        for number, job in enumerate(self.jobs):
            left = (end - clock()) / 60
            standing = self._considered(job, left, has)
            if standing is None:
                standing = self._run(job, left, runner, clock)
            self._keep(job, standing)
            report(number + 1, len(self.jobs))

    def _considered(self, job: Job, left: float, has: Callable[[str], Has]) -> Standing | None:
        """The standing of a job that is not to be run, or None."""
        before = self.standings[job.name]
        command = " ".join(job.command(self._places, self.rehearses))
        if before.command != command:
            before = Standing()
            self.standings[job.name] = before
        if before.state == DONE:
            return before
        if job.after and self.standings[job.after].state != DONE:
            return replace(before, state=SKIPPED, says=f"It comes after {job.after}, which is not done.")
        lacks = next((found.lacks for found in map(has, job.needs) if found.lacks), "")
        if lacks:
            return replace(before, state=SKIPPED, says=lacks)
        if allowed_minutes(job, left) is None:
            state = before.state if before.state in (STOPPED, FAILED) else WAITING
            says = before.says or f"It takes {job.minutes:g} minutes, and {max(left, 0):.1f} were left."
            return replace(before, state=state, says=says)
        return None

    def _run(self, job: Job, left: float, runner: Runner, clock: Callable[[], float]) -> Standing:
        words = job.command(self._places, self.rehearses)
        spent, begun = self.standings[job.name].minutes, clock()
        # Where the machine is taken away meanwhile, the file says what ran.
        self._keep(job, Standing(STOPPED, "It was running.", spent, " ".join(words)))
        allowed = allowed_minutes(job, left)
        assert allowed is not None
        try:
            ended = runner(words, self._places.work / f"{job.name.replace(' ', '-')}.log", allowed)
        except (KeyboardInterrupt, SystemExit):
            taken = spent + (clock() - begun) / 60
            self._keep(job, Standing(STOPPED, "It was interrupted.", taken, " ".join(words)))
            raise
        taken = spent + (clock() - begun) / 60
        state, says = _judged(job, ended, taken)
        return Standing(state, says, taken, " ".join(words))

    def _keep(self, job: Job, standing: Standing) -> None:
        self.standings[job.name] = standing
        write_json(self.file, {"jobs": {name: asdict(each) for name, each in self.standings.items()}})


def allowed_minutes(job: Job, left: float) -> float | None:
    """How long a job may run, or None if too few minutes are left for it."""
    if job.resumes:
        return left - _GRACE if left >= _LEAST else None
    return min(left - _GRACE, _PATIENCE * job.minutes) if job.minutes <= left else None


def _judged(job: Job, ended: Ended, minutes: float) -> tuple[str, str]:
    if ended.code is None and job.resumes:
        return STOPPED, f"It was stopped after {minutes:.1f} minutes in all, and goes on from there."
    if ended.code is None:
        return FAILED, f"It was stopped after {minutes:.1f} minutes; {job.minutes:g} were expected."
    if ended.code == 0:
        return DONE, ""
    # A study prints missed bars last.
    if ended.code == _MISSED and ended.last.startswith("missed:"):
        return DONE, ended.last
    return FAILED, ended.last or f"It ended with {ended.code} and said nothing."


def _read(file: Path) -> dict[str, Standing]:
    if not file.is_file():
        return {}
    try:
        content = json.loads(file.read_bytes())["jobs"]
        return {name: Standing(**values) for name, values in content.items()}
    except (OSError, ValueError, TypeError, KeyError, AttributeError, RecursionError) as error:
        raise InputError(f"{file} does not hold the state of jobs: remove it to begin anew.") from error


# ------------------------------------------------------------------------------------------------- processes

# Seconds after which a command that was asked to end is asked by the next signal.
_ASKS = ((signal.SIGINT, 8.0), (signal.SIGTERM, 4.0), (signal.SIGKILL, 60.0))


def run_words(words: Sequence[str], log: Path, minutes: float, work: Path) -> Ended:
    """Runs `python -m` with words in a folder, and stops it after some minutes.

    Caches lie in the folder too, as trainings keep checkpoints there.
    """
    paths = os.pathsep.join([str(REPOSITORY), *filter(None, [os.environ.get("PYTHONPATH")])])
    environment = {**os.environ, "PYTHONPATH": paths, "XDG_CACHE_HOME": str(work / "cache")}
    with log.open("w", encoding="utf-8") as output:
        process = subprocess.Popen(
            [sys.executable, "-m", *words],
            cwd=work,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
        before = signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
        try:
            code: int | None = process.wait(60 * minutes)
        except subprocess.TimeoutExpired:
            code = None
            _stop(process)
        except (KeyboardInterrupt, SystemExit):
            # It hears nothing of who ends this process, which has no time to wait for it.
            _ask(process, signal.SIGTERM)
            raise
        finally:
            signal.signal(signal.SIGTERM, before)
    return Ended(code, _last_line(log))


def _stop(process: subprocess.Popen[bytes]) -> None:
    for by, seconds in _ASKS:
        _ask(process, by)
        try:
            process.wait(seconds)
            return
        except subprocess.TimeoutExpired:
            continue


def _ask(process: subprocess.Popen[bytes], by: signal.Signals) -> None:
    try:
        os.killpg(process.pid, by)
    except ProcessLookupError:
        return


def _last_line(log: Path) -> str:
    lines = [line.strip() for line in log.read_text(encoding="utf-8", errors="replace").splitlines()]
    return next((line for line in reversed(lines) if line), "")[:500]
