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


@pytest.mark.slow
def test_libraries_are_compiled_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(slangc, "LIBRARIES", tmp_path / "none")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    code = slangc.library_code("glsl", "point")
    assert b"void main" in code
    assert [path.name for path in tmp_path.glob("cache/loomlight/shaders/*/glsl/*")] == ["point_queries.glsl"]
    monkeypatch.setattr(slangc, "compile_shader", lambda *_: pytest.fail("compiled again"))
    assert slangc.library_code("glsl", "point") == code


def test_libraries_of_the_package_need_no_compiler(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As wheels hold them; where the Slang sources have changed since, they are compiled anew."""
    monkeypatch.setattr(slangc, "LIBRARIES", tmp_path / "libraries")
    monkeypatch.setattr(slangc, "_compiled_library", lambda language, model: f"{model}.{language}".encode())
    monkeypatch.setattr(slangc, "find_slangc", lambda: None)
    with pytest.raises(MissingDependencyError, match="LOOMLIGHT_SLANGC"):
        slangc.library_code("glsl", "point")
    monkeypatch.setattr(slangc, "SHADERS", tmp_path)
    for name in ("cloth_point", "cloth_lobes"):
        (tmp_path / f"{name}.slang").write_text("", encoding="utf-8")
    slangc.write_libraries()
    assert len(list((tmp_path / "libraries").glob("*/*"))) == 2 * len(slangc.TARGETS)
    assert slangc.library_code("cuda", "lobes") == b"lobes.cuda"
    (tmp_path / "cloth_point.slang").write_text("// edited", encoding="utf-8")
    with pytest.raises(MissingDependencyError):
        slangc.library_code("cuda", "lobes")
