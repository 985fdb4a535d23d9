"""Compilers and validators of other makers."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from tests.limits import HANG


def run_compiler(*command: str | Path, cwd: Path | None = None) -> None:
    """Fails the test with what the program says, or where there is none."""
    name = str(command[0])
    if shutil.which(name) is None:
        pytest.fail(f"{name} is missing: apt install glslang-tools spirv-tools g++", pytrace=False)
    parts = [str(part) for part in command]
    done = subprocess.run(parts, capture_output=True, text=True, cwd=cwd, timeout=HANG)
    assert done.returncode == 0, done.stdout + done.stderr
