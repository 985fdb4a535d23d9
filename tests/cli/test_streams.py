"""Streams that are closed or full, and a current folder that is gone: one sentence at most.

Covers: __main__.py
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

COMMAND = f"'{sys.executable}' -m loomlight"


def by_shell(line: str, folder: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(["sh", "-c", line], cwd=folder, capture_output=True, text=True, check=False)


@pytest.mark.parametrize("closed", [">&-", "2>&-", "<&- >&- 2>&-"])
def test_closed_streams_are_null_devices(tmp_path: Path, closed: str) -> None:
    done = by_shell(f"{COMMAND} weave show plain -o a.png {closed}", tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is always full")
def test_a_full_device_is_one_sentence(tmp_path: Path) -> None:
    done = by_shell(f"{COMMAND} weave info plain > /dev/full", tmp_path)
    assert done.returncode == 2
    assert done.stderr == "loomlight: what is printed cannot be written: No space left on device.\n"


def test_a_folder_that_is_gone_is_one_sentence(tmp_path: Path) -> None:
    (tmp_path / "gone").mkdir()
    # By the shell's own folder, as a test that removes its own cannot start a process.
    done = by_shell(f"cd gone && rmdir ../gone && {COMMAND} weave info plain", tmp_path)
    assert done.returncode == 2
    assert done.stderr == "loomlight: the current folder does not exist any more: change to another.\n"
