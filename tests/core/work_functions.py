"""Functions that processes of the tests of `work_map` call."""

from __future__ import annotations

import os
import signal
import warnings
from pathlib import Path

from loomlight.core.errors import InputError, LoomlightWarning


def note(folder: str, name: str) -> bytes:
    """Notes that a process has worked on an item."""
    with open(Path(folder, "log"), "a", encoding="utf-8") as file:
        file.write(f"{name}\n")
    return name.encode()


def dies_at_first(folder: str, name: str) -> bytes:
    """Of "victim" the first process is killed in the middle."""
    if name == "victim" and not Path(folder, "killed").exists():
        Path(folder, "killed").touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return note(folder, name)


def always_dies(folder: str, name: str) -> bytes:
    """Of "victim" every process is killed."""
    if name == "victim":
        os.kill(os.getpid(), signal.SIGKILL)
    return note(folder, name)


def refuses(folder: str, name: str) -> bytes:
    """Cannot use "bad", and warns of others."""
    if name == "bad":
        raise InputError("bad: it is bad.")
    if name == "defect":
        raise ZeroDivisionError("a defect")
    warnings.warn(f"{name} was mended.", LoomlightWarning, stacklevel=1)
    return note(folder, name)
