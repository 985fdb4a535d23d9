"""What whole processes cost: CPU seconds of all threads and children, seconds, and peak memory."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TypeVar

from loomlight.core.errors import LoomlightError
from studies.harness.study import REPOSITORY

Made = TypeVar("Made")

Cost = dict[str, float]
_LOOK_SECONDS = 0.02
_CALL = """
import importlib, json, sys
module, name, arguments = json.loads(sys.argv[1])
print(json.dumps(getattr(importlib.import_module(module), name)(*arguments)))
"""


def loomlight(*arguments: object) -> list[str]:
    """The command line of the program with these arguments."""
    return [sys.executable, "-m", "loomlight", *map(str, arguments)]


def cost_of(
    command: Sequence[str], environment: Mapping[str, str] | None = None, shows: Path | None = None
) -> Cost:
    """What a command costs.

    The peak is that of the largest of its processes. It counts from what this process holds on, as a process
    begins as a copy: scripts that measure load no renderer.

    Args:
        environment: variables beside those of this process.
        shows: a file; `first_*` are the costs until it is there, within a fiftieth of a second.

    Raises:
        LoomlightError: the command fails; with its last words.
    """
    begun = time.perf_counter()
    process = subprocess.Popen(
        command,
        cwd=REPOSITORY,
        env={**os.environ, **(environment or {})},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        start_new_session=True,
    )
    first: Cost = {}
    while shows is not None and not first and process.stdout is not None and not _has_ended(process.pid):
        if shows.exists():
            first = {
                "first_cpu_seconds": _cpu_seconds(process.pid),
                "first_seconds": time.perf_counter() - begun,
            }
        time.sleep(_LOOK_SECONDS)
    said = b"" if process.stdout is None else process.stdout.read()
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise LoomlightError(f"{' '.join(command)} failed:\n{said.decode(errors='replace')[-2000:]}")
    return {
        "cpu_seconds": round(used.ru_utime + used.ru_stime, 2),
        "seconds": round(time.perf_counter() - begun, 2),
        **{name: round(value, 2) for name, value in first.items()},
        "peak_megabytes": round(used.ru_maxrss / 1e3),
    }


def in_own_process(
    function: Callable[..., Made], *arguments: object, environment: Mapping[str, str] | None = None
) -> Made:
    """What a function of a module returns in a process of its own, by way of JSON.

    Args:
        arguments: of the function.
        environment: variables beside those of this process.

    Raises:
        LoomlightError: it fails; with the last line of what it said.
    """
    done = subprocess.run(
        [sys.executable, "-c", _CALL, json.dumps([function.__module__, function.__qualname__, arguments])],
        cwd=REPOSITORY,
        env={**os.environ, **(environment or {})},
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode:
        raise LoomlightError(f"{function.__qualname__} failed: {done.stderr.strip().splitlines()[-1]}")
    made: Made = json.loads(done.stdout.splitlines()[-1])
    return made


def _has_ended(process: int) -> bool:
    return os.waitid(os.P_PID, process, os.WEXITED | os.WNOWAIT | os.WNOHANG) is not None


def _cpu_seconds(session: int) -> float:
    """CPU seconds of all processes of a session, and of their children that have ended."""
    ticks = 0
    for status in Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = status.read_text().rpartition(")")[2].split()
        except OSError:  # It has ended since.
            continue
        if int(fields[3]) == session:
            ticks += sum(map(int, fields[11:15]))
    return ticks / os.sysconf("SC_CLK_TCK")
