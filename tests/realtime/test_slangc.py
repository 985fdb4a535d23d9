"""The compiler's wrapper: what it says of no compiler, a wrong source and too long a run."""

from __future__ import annotations

from pathlib import Path

import pytest

from loomlight.core.errors import MissingDependencyError
from loomlight.realtime import slangc
from loomlight.realtime.slangc import ShaderError, compile_shader

KERNEL = '[shader("compute")] [numthreads(1, 1, 1)] void nothing() { %s }'


def source(folder: Path, statement: str = "") -> Path:
    file = folder / "kernel.slang"
    file.write_text(KERNEL % statement, encoding="utf-8")
    return file


def test_a_kernel_compiles(tmp_path: Path) -> None:
    assert b"fn nothing" in compile_shader(source(tmp_path), "wgsl", ["nothing"])


def test_errors_name_the_line(tmp_path: Path) -> None:
    with pytest.raises(ShaderError, match=r"kernel.slang does not compile to wgsl[\s\S]*unknown_name"):
        compile_shader(source(tmp_path, "float x = unknown_name;"), "wgsl", ["nothing"])


def test_a_compiler_that_hangs_is_stopped(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    slow = tmp_path / "slangc"
    slow.write_text("#!/bin/sh\nexec sleep 30\n", encoding="utf-8")
    slow.chmod(0o755)
    monkeypatch.setenv("LOOMLIGHT_SLANGC", str(slow))
    with pytest.raises(ShaderError, match=r"longer than 0.2 s"):
        compile_shader(source(tmp_path), "wgsl", ["nothing"], seconds=0.2)


def test_no_compiler_is_one_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(slangc, "find_slangc", lambda: None)
    with pytest.raises(MissingDependencyError, match="needs slangc"):
        compile_shader(source(tmp_path), "wgsl", ["nothing"])
    monkeypatch.setattr(slangc, "find_slangc", lambda: tmp_path / "gone")
    with pytest.raises(MissingDependencyError, match="cannot be run"):
        compile_shader(source(tmp_path), "wgsl", ["nothing"])
