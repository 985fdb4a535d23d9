"""Exports of shader code: a library with `cloth_value`, a kernel that calls it, buffers and instructions."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

from loomlight.exporters.buffers import described_records, write_buffers
from loomlight.exporters.instructions import shader_instructions
from loomlight.exporters.kernels import c_header, kernel
from loomlight.exporters.libraries import library
from loomlight.models.registry import REALTIME_MODELS
from loomlight.realtime.materials import Material, source_of
from loomlight.realtime.slangc import SHADERS, TARGETS, library_code

_OWN = Path(__file__).parent / "languages"
_IMPORT = re.compile(r"^import (\w+);", re.MULTILINE)


def write_shaders(folder: Path, material: Material, model: str, language: str) -> dict[str, object]:
    """Writes the files of a shader language and returns what the manifest says of them.

    Args:
        model: a name of `REALTIME_MODELS`.
        language: slang, spirv, or a name of `libraries.LANGUAGES`.

    Raises:
        InputError: the model does not take the material.
        MissingDependencyError: the code would have to be compiled, and there is no compiler.
    """
    from loomlight.core.llvm import require_llvm

    require_llvm()
    if language == "slang":
        code = _write_modules(folder, model)
    elif language == "spirv":
        (folder / "cloth_queries.spv").write_bytes(library_code("spirv", model))
        code = ["cloth_queries.spv"]
    else:
        code = _write_text(folder, model, language)
    (folder / "cloth.h").write_text(c_header(), encoding="utf-8")
    source = source_of(material)
    width, height = source.repeat_mm
    repeat = (float(width), float(height))
    buffers = write_buffers(folder, material, model, repeat)
    (folder / "README.md").write_text(
        shader_instructions(source.name, model, language, code, buffers, repeat), encoding="utf-8"
    )
    return {
        "code": code,
        "function": "cloth_value",
        "repeat_mm": list(repeat),
        "buffers": buffers,
        "records": described_records(),
    }


def _write_text(folder: Path, model: str, language: str) -> list[str]:
    suffix = TARGETS[language].suffix
    text = library(language, model)
    names = [f"cloth.{suffix}", f"cloth_queries.{suffix}"]
    if language == "cuda":
        text = '#include "cloth_prelude.h"\n' + text
        names.append("cloth_prelude.h")
    (folder / names[0]).write_text(text, encoding="utf-8")
    (folder / names[1]).write_text(kernel(REALTIME_MODELS[model], language), encoding="utf-8")
    if language == "wgsl":
        names += ["sample.wgsl", "sample.py"]
    for name in names[2:]:
        shutil.copyfile(_OWN / name, folder / name)
    return names


def _write_modules(folder: Path, model: str) -> list[str]:
    """The module of a library and all that it imports."""
    wanted, names = [f"cloth_{model}"], []
    while wanted:
        name = wanted.pop()
        if name not in names:
            names.append(name)
            text = (SHADERS / f"{name}.slang").read_text(encoding="utf-8")
            (folder / f"{name}.slang").write_text(text, encoding="utf-8")
            wanted += _IMPORT.findall(text)
    return [f"{name}.slang" for name in names]
