"""Generated files are in step with their sources, and compilers of other makers accept them.

Covers: tools/generate/shaders/constants.py
"""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

from loomlight.models.lobes import prefiltered, rays
from loomlight.models.registry import REALTIME_MODELS
from loomlight.realtime.device import STORAGE_BUFFERS, default_adapter
from loomlight.realtime.slangc import SHADERS, TARGETS, compile_shader, library_code, library_models
from tests.helpers.commands import run_compiler
from tools.generate.shaders import build
from tools.generate.shaders.build import DIGESTS, WGSL, digests, generated_files, generated_slang
from tools.generate.shaders.constants import number_text, prefixed_numbers, shader_constants

COOPERATIVE_MULTIPLY_ADD = 5292  # OpCooperativeVectorMatrixMulAddNV


def test_generated_slang_is_in_step() -> None:
    assert (SHADERS / "generated.slang").read_text(encoding="utf-8") == generated_slang()


def test_generated_shaders_are_in_step() -> None:
    """Run `python -m tools.generate.shaders` after edits of Slang, or of what is generated."""
    assert digests() == json.loads(DIGESTS.read_text(encoding="utf-8"))


@pytest.mark.slow
def test_shaders_come_out_again() -> None:
    """Those of one Slang file: all take half a minute."""
    generated = generated_files(["layers"])
    assert len(generated) == 3
    assert [name for name in generated if (WGSL / name).read_bytes() != generated[name]] == []


@pytest.mark.slow
def test_generated_text_names_no_file_of_a_machine() -> None:
    for path in WGSL.iterdir():
        assert b".slang" not in path.read_bytes(), path
    for language in TARGETS:
        assert b".slang" not in library_code(language, "point"), language


def test_shaders_need_neither_wide_numbers_nor_halves() -> None:
    for path in WGSL.iterdir():
        assert not re.search(r"\b(f64|i64|u64|f16)\b|enable ", path.read_text(encoding="utf-8")), path


@pytest.mark.slow
def test_shaders_bind_no_more_storage_buffers_than_every_adapter() -> None:
    """WebGPU promises eight a stage, and some of Apple's adapters have no more."""
    texts = {path.name: path.read_text(encoding="utf-8") for path in WGSL.iterdir()}
    texts |= {model: library_code("wgsl", model).decode() for model in library_models()}
    found = {name: len(re.findall(r"var<storage", text)) for name, text in texts.items()}
    assert max(found.values()) == STORAGE_BUFFERS == 8, found


def test_every_model_has_a_library() -> None:
    assert library_models() == sorted(REALTIME_MODELS)


@pytest.mark.quick("point")
@pytest.mark.parametrize("model", REALTIME_MODELS)
def test_spirv_is_valid(model: str, tmp_path: Path) -> None:
    (tmp_path / "library.spv").write_bytes(library_code("spirv", model))
    run_compiler("spirv-val", "--target-env", "vulkan1.1", tmp_path / "library.spv")


@pytest.mark.slow
def test_networks_compile_to_cooperative_vectors() -> None:
    """Debian's validator is older than the extension; `docs/research/notes/realtime.md` has what did."""
    options = ("-DCOOPERATIVE", "-profile", "spirv_1_6", "-O0", "-skip-spirv-validation")
    code = compile_shader(SHADERS / "cloth_neural.slang", "spirv", ["neural_queries"], options)
    words = np.frombuffer(code, np.uint32)
    found, at = set(), 5
    while at < words.size:
        found.add(int(words[at] & 0xFFFF))
        at += int(words[at] >> 16)
    assert COOPERATIVE_MULTIPLY_ADD in found


@pytest.mark.parametrize("entry", [name for names in build.FRAME_ENTRIES.values() for name in names])
def test_naga_compiles_wgsl(entry: str) -> None:
    code = (WGSL / f"{entry}.wgsl").read_text(encoding="utf-8")
    assert default_adapter().device.create_shader_module(code=code) is not None


def test_constants_are_the_public_numbers_of_modules() -> None:
    """Qualities of a search are a constant a field; names that a module imports are another's."""
    found = dict(prefixed_numbers(rays))
    assert found["BAKE_SHADOW_SHARE"] == rays.BAKE_QUALITY.shadow_share
    assert found["MAX_GAP_RAYS"] == rays.MAX_GAP_RAYS
    assert "NODES" not in found
    assert shader_constants()["GROUP_NARROWEST"] == prefiltered.GROUP_NARROWEST


@pytest.mark.parametrize("value", [0.0, 1.0, -2.5, 1e-20, 123456.7, 3.0e10, 0.1])
def test_literals_are_exact(value: float) -> None:
    text = number_text(value)
    assert np.float32(text) == np.float32(value)
    assert any(mark in text for mark in ".e")
