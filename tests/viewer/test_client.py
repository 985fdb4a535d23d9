"""Where the page comes from: shipped, or built on first use from a source checkout.

Covers: viewer/client.py, viewer/client_build.py
"""

from __future__ import annotations

import os
import stat
import sys
from pathlib import Path

import pytest

from loomlight.core.errors import LoomlightWarning, MissingDependencyError
from loomlight.viewer import client
from loomlight.viewer.client_build import BuildError, build, is_built, is_current

PAGE = "static/index.html"


@pytest.fixture
def checkout(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A checkout whose page is one file, with npm and Node that are scripts."""
    package = tmp_path / "src" / "loomlight" / "viewer"
    package.mkdir(parents=True)
    (package / "client_build.py").touch()
    (tmp_path / "web" / "editor").mkdir(parents=True)
    (tmp_path / "web" / "package.json").write_text("{}")
    (tmp_path / "web" / "editor" / "index.html").write_text("old")
    monkeypatch.setattr(client, "_PACKAGE", package)
    _program(tmp_path / "bin" / "node", "echo v20.19.1")
    _program(
        tmp_path / "bin" / "npm",
        'if [ "$1" = install ]; then mkdir -p node_modules; touch node_modules/.package-lock.json; exit; fi\n'
        'for place; do :; done; mkdir -p "$place"; cp editor/index.html "$place"',
    )
    monkeypatch.setenv("PATH", f"{tmp_path / 'bin'}{os.pathsep}{os.environ['PATH']}")
    return tmp_path


def _program(file: Path, script: str) -> None:
    file.parent.mkdir(exist_ok=True)
    file.write_text(f"#!/bin/sh\n{script}\n")
    file.chmod(file.stat().st_mode | stat.S_IXUSR)


def _package(checkout: Path) -> Path:
    return checkout / "src" / "loomlight" / "viewer"


def test_page_is_built_once_and_again_when_its_sources_change(
    checkout: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page = checkout / "web" / "editor" / "index.html"
    assert (client.client_folder() / "index.html").read_text() == "old"
    assert "Building" in capsys.readouterr().err
    os.utime(_package(checkout) / PAGE, (2e9, 2e9))
    assert client.client_folder().is_dir()
    assert capsys.readouterr().err == ""
    page.write_text("new")
    os.utime(page, (2.1e9, 2.1e9))
    assert (client.client_folder() / "index.html").read_text() == "new"
    assert sorted(each.name for each in _package(checkout).iterdir()) == ["client_build.py", "static"]


def test_without_node_one_sentence(checkout: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(checkout / "nothing"))
    monkeypatch.setattr(sys, "executable", str(checkout / "nothing" / "python"))
    with pytest.raises(MissingDependencyError, match=r"not built: Node 20\.19 or newer is needed"):
        client.client_folder()


def test_an_older_page_is_used_where_it_cannot_be_built(checkout: Path) -> None:
    client.client_folder()
    os.utime(checkout / "web" / "editor" / "index.html", (2.1e9, 2.1e9))
    _program(checkout / "bin" / "node", "echo v18.1.0")
    with pytest.warns(LoomlightWarning, match=r"older than its sources: .*is v18\.1\.0"):
        assert (client.client_folder() / "index.html").is_file()


def test_failed_build_leaves_what_was_there(checkout: Path) -> None:
    package = _package(checkout)
    build(package, checkout)
    _program(checkout / "bin" / "npm", "echo first >&2; echo it is broken >&2; exit 1")
    (checkout / "web" / "package.json").write_text("{ }")
    os.utime(checkout / "web" / "package.json", (2.1e9, 2.1e9))
    with pytest.raises(BuildError, match="cannot be installed: it is broken"):
        build(package, checkout)
    assert is_built(package)
    assert not is_current(package, checkout)
    assert sorted(each.name for each in package.iterdir()) == ["client_build.py", "static"]


def test_wheel_without_a_page_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    package = tmp_path / "a" / "b" / "c" / "viewer"
    package.mkdir(parents=True)
    monkeypatch.setattr(client, "_PACKAGE", package)
    with pytest.raises(MissingDependencyError, match="no editor's page"):
        client.client_folder()
