"""USD is read in another process: what that says, when it ends, and when it takes too long.

Covers: mesh/usd_worker.py
"""

from __future__ import annotations

import os
import shutil
import signal
import sys
import warnings
from pathlib import Path

import pytest

from loomlight.core.errors import InputError, LoomlightWarning, MissingDependencyError
from loomlight.mesh import usd_worker
from loomlight.mesh.reading import read_parts

STAGE = """#usda 1.0
(
    metersPerUnit = 1
)
def Mesh "cloth" {
    int[] faceVertexCounts = [3]
    int[] faceVertexIndices = [0, 1, 2]
    point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0)]
}
"""


@pytest.fixture
def stage(tmp_path: Path) -> Path:
    (tmp_path / "mesh.usda").write_text(STAGE)
    return tmp_path / "mesh.usda"


def test_without_usd_core_the_extra_is_named(stage: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pxr", None)
    with pytest.raises(
        MissingDependencyError, match=r"a mesh in USD needs pxr: pip install 'loomlight\[usd\]'"
    ):
        read_parts(stage)


def test_a_process_that_ends_is_a_sentence(stage: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    worker = usd_worker._Worker()
    with monkeypatch.context() as patched:
        patched.setattr(sys, "executable", shutil.which("true"))
        with pytest.raises(InputError, match="usd-core ended as it read it"):
            worker.answer("read_usd", stage)
    (part,) = worker.answer("read_usd", stage)  # another one is begun
    assert part.name == "cloth"


def test_a_process_that_ended_between_files_is_begun_anew(stage: Path) -> None:
    worker = usd_worker._Worker()
    worker.answer("read_usd", stage)
    first = worker._process
    assert first is not None
    first.send_signal(signal.SIGKILL)
    first.wait()
    assert worker.answer("usd_frames", stage) == []


def test_an_idle_process_ends(stage: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(usd_worker, "_IDLE_SECONDS", 0.0)
    worker = usd_worker._Worker()
    worker.answer("read_usd", stage)
    assert worker._idle is not None
    worker._idle.join()
    assert worker._process is None
    assert worker.answer("usd_frames", stage) == []


def test_a_file_that_takes_too_long_is_given_up(stage: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(usd_worker, "_MAX_SECONDS", 0.0)
    with pytest.raises(InputError, match="was given up after 0 s"):
        usd_worker._Worker().answer("read_usd", stage)


def test_warnings_come_across(stage: Path) -> None:
    stage.write_text(STAGE + 'def "lost" (references = @./lost.usda@) {}\n')
    with pytest.warns(LoomlightWarning, match=r'names "./lost.usda", which cannot be read') as told:
        read_parts(stage)
    assert len(told) == 1


def test_a_forked_process_has_its_own(stage: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        read_parts(stage)
    before = usd_worker._worker()
    number = os.getpid()
    monkeypatch.setattr(os, "getpid", lambda: number + 1)
    assert usd_worker._worker() is not before
    monkeypatch.undo()
    usd_worker._current = before
    assert read_parts(stage)
