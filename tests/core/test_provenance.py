"""Figures say which command, sources and machine they come from, and nothing about whose machine."""

from __future__ import annotations

import platform
import subprocess
from pathlib import Path

from loomlight.core.provenance import provenance


def git(folder: Path, *arguments: str) -> None:
    identity = ["-c", "user.name=a", "-c", "user.email=a@example.org"]
    subprocess.run(["git", "-C", str(folder), *identity, *arguments], check=True, capture_output=True)


def test_sources_outlive_their_commit_and_changes_are_marked(tmp_path: Path) -> None:
    git(tmp_path, "init", "-q")
    (tmp_path / "src").mkdir()
    (tmp_path / "records").mkdir()
    source, result = tmp_path / "src" / "a", tmp_path / "records" / "a.json"
    source.write_text("1")
    result.write_text("1")
    git(tmp_path, "add", ".")
    git(tmp_path, "commit", "-qm", "a")
    clean = provenance("python a.py", tmp_path / "src")
    assert clean["command"] == "python a.py"
    assert len(clean["sources"]) == 12
    git(tmp_path, "commit", "-q", "--amend", "-m", "another hash of the commit")
    result.write_text("2")
    assert provenance("python a.py", tmp_path)["sources"] == clean["sources"]
    source.write_text("2")
    assert provenance("python a.py", tmp_path)["sources"] == clean["sources"] + " dirty"


def test_no_repository_and_no_host(tmp_path: Path) -> None:
    actual = provenance("python a.py", tmp_path / "none")
    assert actual["sources"] == "unknown"
    assert platform.node() not in actual["machine"] or not platform.node()
    assert "cores" in actual["machine"]
