"""Generated files are in step with their sources, and compilers of other makers accept them.

Covers: realtime/constants.py
"""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from loomlight.realtime.build import (
    COOPERATIVE_LIBRARY,
    DIGESTS,
    HOST_ENTRIES,
    TARGETS,
    digests,
    generated_files,
    generated_slang,
    library_entries,
)
from loomlight.realtime.constants import number_text
from loomlight.realtime.device import default_adapter
from loomlight.realtime.slangc import SHADERS

# Kernels of libraries, in every language; frames are WGSL alone.
LIBRARIES = tuple(library_entries().values())
WGSL = (*LIBRARIES, *(entry for stages in HOST_ENTRIES.values() for entry in stages))
COOPERATIVE_MULTIPLY_ADD = 5292  # OpCooperativeVectorMatrixMulAddNV


def test_generated_slang_is_in_step() -> None:
    assert (SHADERS / "generated.slang").read_text(encoding="utf-8") == generated_slang()


def test_generated_shaders_are_in_step() -> None:
    """Run `python -m loomlight.realtime.build` after edits of Slang, or of what is generated."""
    assert digests() == json.loads(DIGESTS.read_text(encoding="utf-8"))


def test_shaders_come_out_again() -> None:
    """One library in every language: all take more than a minute."""
    generated = generated_files(["cloth_point"])
    assert len(generated) == len(TARGETS)
    assert [path for path in generated if (SHADERS / path).read_bytes() != generated[path]] == []


def test_generated_text_names_no_file_of_a_machine() -> None:
    for target in TARGETS:
        for path in (SHADERS / target.name).iterdir():
            assert b".slang" not in path.read_bytes(), path


def test_shaders_need_neither_wide_numbers_nor_halves() -> None:
    for path in (SHADERS / "wgsl").iterdir():
        assert not re.search(r"\b(f64|i64|u64|f16)\b|enable ", path.read_text(encoding="utf-8")), path


def run(*command: str | Path) -> None:
    name = str(command[0])
    if shutil.which(name) is None:
        pytest.fail(f"{name} is missing: apt install glslang-tools spirv-tools", pytrace=False)
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize("entry", LIBRARIES)
def test_glslang_compiles_glsl(entry: str, tmp_path: Path) -> None:
    source = SHADERS / "glsl" / f"{entry}.glsl"
    run("glslangValidator", "-V", "-S", "comp", "-o", tmp_path / "out.spv", source)


@pytest.mark.parametrize("entry", LIBRARIES)
def test_glslang_compiles_hlsl(entry: str, tmp_path: Path) -> None:
    source = SHADERS / "hlsl" / f"{entry}.hlsl"
    run("glslangValidator", "-D", "-V", "-S", "comp", "-e", entry, "-o", tmp_path / "out.spv", source)


@pytest.mark.parametrize("entry", LIBRARIES)
def test_spirv_is_valid(entry: str, tmp_path: Path) -> None:
    run("spirv-val", "--target-env", "vulkan1.1", SHADERS / "spirv" / f"{entry}.spv")


def test_cooperative_variants_use_cooperative_vectors() -> None:
    """Debian's validator is older than the extension: `docs/notes/realtime.md` says what checked them."""
    name = f"{COOPERATIVE_LIBRARY}_queries_cooperative"
    words = np.fromfile(SHADERS / "spirv" / f"{name}.spv", np.uint32)
    found, at = set(), 5
    while at < words.size:
        found.add(int(words[at] & 0xFFFF))
        at += int(words[at] >> 16)
    assert COOPERATIVE_MULTIPLY_ADD in found
    hlsl = (SHADERS / "hlsl" / f"{name}.hlsl").read_text(encoding="utf-8")
    assert "dx/linalg.h" in hlsl
    # None is required: the ordinary shaders know nothing of them.
    for path in SHADERS.glob("*/*_queries.*"):
        if path.suffix not in (".spv", ".cu"):
            assert "linalg" not in path.read_text(encoding="utf-8"), path


@pytest.mark.parametrize("entry", WGSL)
def test_naga_compiles_wgsl(entry: str) -> None:
    code = (SHADERS / "wgsl" / f"{entry}.wgsl").read_text(encoding="utf-8")
    assert default_adapter().device.create_shader_module(code=code) is not None


@pytest.mark.parametrize("value", [0.0, 1.0, -2.5, 1e-20, 123456.7, 3.0e10, 0.1])
def test_literals_are_exact(value: float) -> None:
    text = number_text(value)
    assert np.float32(text) == np.float32(value)
    assert any(mark in text for mark in ".e")
