"""Provenance of a measurement, to stand beside its figures."""

from __future__ import annotations

import os
import platform
import subprocess
from pathlib import Path

# Of a tree's hash, as much as is recorded.
_DIGITS = 12
# Changes of these make no source dirty: records that the command itself writes, and pages.
_NO_SOURCES = (":(top,exclude,glob)**/records/**", ":(top,exclude,glob)**/*.md")


def provenance(command: str, repository: str | os.PathLike[str]) -> dict[str, str]:
    """`command`, the sources that it ran with, and the machine.

    Sources are the hash of the tree `src` in the repository's commit, which outlives squashed branches:
    `git rev-parse COMMIT:src` gives it of any commit. "dirty" follows where the working tree differs. The
    machine is its processor and number of cores, without a name.
    """
    return {"command": command, "sources": _sources(repository), "machine": _machine()}


def _sources(repository: str | os.PathLike[str]) -> str:
    tree = _git(repository, "rev-parse", "--verify", "--quiet", "HEAD:src")[:_DIGITS]
    changed = _git(repository, "status", "--porcelain", "--untracked-files=no", "--", ":(top)", *_NO_SOURCES)
    return f"{tree} dirty" if tree and changed else tree or "unknown"


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
