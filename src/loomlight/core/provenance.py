"""What a measurement was made with, to stand beside its figures."""

from __future__ import annotations

import os
import platform
import subprocess
from pathlib import Path


def provenance(command: str, repository: str | os.PathLike[str]) -> dict[str, str]:
    """`command`, the short hash of the commit of `repository` ("+" where files differ), and the machine.

    The machine is its processor and number of cores, without a name.
    """
    return {"command": command, "commit": _commit(repository), "machine": _machine()}


def _commit(repository: str | os.PathLike[str]) -> str:
    found = _git(repository, "rev-parse", "--short", "HEAD")
    changed = _git(repository, "status", "--porcelain", "--untracked-files=no")
    return f"{found}+" if found and changed else found or "unknown"


def _git(repository: str | os.PathLike[str], *arguments: str) -> str:
    command = ["git", "-C", os.fspath(repository), *arguments]
    try:
        return subprocess.run(command, capture_output=True, text=True, check=False).stdout.strip()
    except OSError:
        return ""


def _machine() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        lines = []
    found = [line.split(": ", 1)[1] for line in lines if line.startswith("model name")]
    processor = found[0] if found else platform.processor() or "unknown processor"
    return f"{platform.machine()}, {os.cpu_count()} cores, {processor}"
