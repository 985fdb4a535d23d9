"""Figures say which command, commit and machine they come from, and nothing about whose machine."""

from __future__ import annotations

import platform
import subprocess
from pathlib import Path

from loomlight.core.provenance import provenance


def git(folder: Path, *arguments: str) -> None:
    identity = ["-c", "user.name=a", "-c", "user.email=a@example.org"]
    subprocess.run(["git", "-C", str(folder), *identity, *arguments], check=True, capture_output=True)


def test_commits_are_named_and_changes_marked(tmp_path: Path) -> None:
    git(tmp_path, "init", "-q")
    (tmp_path / "a").write_text("1")
    git(tmp_path, "add", "a")
    git(tmp_path, "commit", "-qm", "a")
    clean = provenance("python a.py", tmp_path)
    assert clean["command"] == "python a.py"
    assert 4 <= len(clean["commit"]) <= 40
    (tmp_path / "a").write_text("2")
    assert provenance("python a.py", tmp_path)["commit"] == clean["commit"] + "+"


def test_no_repository_and_no_host(tmp_path: Path) -> None:
    actual = provenance("python a.py", tmp_path / "none")
    assert actual["commit"] == "unknown"
    assert platform.node() not in actual["machine"] or not platform.node()
    assert "cores" in actual["machine"]
