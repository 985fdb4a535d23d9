"""Names of processes that no other process ever has: machine, process number, and when it began."""

from __future__ import annotations

import hashlib
import os
import socket
from functools import cache
from pathlib import Path


def process_identity() -> str:
    """The name of this process: letters, digits and dots, without "-"."""
    process = os.getpid()
    return f"{_machine()}.{process}.{_begun(process)}"


def has_ended(identity: str) -> bool:
    """Whether a process of this machine has ended; False of other machines' and of what is no name."""
    machine, _, rest = identity.partition(".")
    number, _, begun = rest.partition(".")
    if machine != _machine() or not (number.isdecimal() and begun.isdecimal()):
        return False
    try:
        os.kill(int(number), 0)
    except ProcessLookupError:
        return True
    except (PermissionError, OverflowError):
        pass  # another user's
    # The number may have been given to another process since.
    return _begun(int(number)) != int(begun)


@cache
def _machine() -> str:
    """A hash of the host and of the numbering of its processes, which containers have of their own."""
    try:
        numbering = os.readlink("/proc/self/ns/pid")
    except OSError:
        numbering = ""
    return hashlib.sha256(f"{socket.gethostname()} {numbering}".encode()).hexdigest()[:12]


def _begun(process: int) -> int:
    """Clock ticks from the machine's start to the process's; 0 where the system does not say."""
    try:
        # The name before it may hold spaces and brackets.
        fields = (
            Path(f"/proc/{process}/stat").read_text(encoding="utf-8", errors="replace").rpartition(")")[2]
        )
        return int(fields.split()[19])
    except (OSError, IndexError, ValueError):
        return 0
