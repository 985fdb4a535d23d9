"""Loops of baking are compiled by a process of their own where none has compiled them."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from loomlight.models.compile_ahead import compile_ahead, loops_are_compiled, wait_for_loops


@pytest.mark.slow
def test_a_fresh_cache_is_filled_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("NUMBA_CACHE_DIR", raising=False)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert not loops_are_compiled()
    assert compile_ahead("point") is None
    assert compile_ahead("") is None
    process = compile_ahead("lobes")
    assert process is not None
    wait_for_loops(process)
    assert process.returncode == 0
    assert loops_are_compiled()
    assert compile_ahead("lobes") is None


def test_what_cannot_be_started_is_left_to_baking(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise OSError

    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(subprocess, "Popen", refuse)
    assert compile_ahead("lobes") is None
    wait_for_loops(None)
