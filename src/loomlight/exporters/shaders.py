"""Exports of shader code: a library with `cloth_value`, a kernel that calls it, buffers and instructions."""

from __future__ import annotations

import re
import shutil
import tomllib
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from string import Template
from typing import Any

from loomlight.core.errors import LoomlightError
from loomlight.models.registry import REALTIME_MODELS, Shaders
from loomlight.realtime.materials import Material, look_of, source_of, tables_for
from loomlight.realtime.records import BUFFERS, QUERY, RECORDS, Fields
from loomlight.realtime.slangc import SHADERS, TARGETS, library_code
from loomlight.realtime.words import Packed, pack_fabrics

_OWN = Path(__file__).parent / "languages"
_IMPORT = re.compile(r"^import (\w+);", re.MULTILINE)


def write_shaders(folder: Path, material: Material, model: str, language: str) -> dict[str, object]:
    """Writes the files of a shader language and returns what the manifest says of them.

    Args:
        model: a name of `REALTIME_MODELS`.
        language: slang, spirv, or a name of `LANGUAGES`.

    Raises:
        InputError: the model does not take the material.
        MissingDependencyError: the code would have to be compiled, and there is no compiler.
    """
    from loomlight.core.llvm import require_llvm

    require_llvm()
    look = look_of(material, model)
    is_layered = look is not None and look[0].depth > 1
    if language == "slang":
        code = _write_modules(folder, model, is_layered)
    elif language == "spirv":
        (folder / "cloth_queries.spv").write_bytes(spirv_library(model, is_layered))
        code = ["cloth_queries.spv"]
    else:
        code = _write_text(folder, model, language, is_layered)
    (folder / "cloth.h").write_text(c_header(), encoding="utf-8")
    source = source_of(material)
    width, height = source.repeat_mm
    repeat = (float(width), float(height))
    packed = pack_fabrics([look], [repeat], [tables_for(material, model)])
    buffers = write_buffers(folder, packed, model)
    (folder / "README.md").write_text(
        shader_instructions(source.name, model, language, code, buffers, repeat, is_layered), encoding="utf-8"
    )
    return {
        "code": code,
        "function": "cloth_value",
        "repeat_mm": list(repeat),
        "buffers": buffers,
        "knows_layers": is_layered,
        "records": described_records(),
    }


def _write_text(folder: Path, model: str, language: str, is_layered: bool) -> list[str]:
    suffix = TARGETS[language].suffix
    text = library(language, model, is_layered)
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


def _write_modules(folder: Path, model: str, is_layered: bool) -> list[str]:
    """The module of a library and all that it imports."""
    wanted, names = [f"cloth_{model}"], []
    while wanted:
        name = wanted.pop()
        if name not in names:
            names.append(name)
            text = (SHADERS / f"{name}.slang").read_text(encoding="utf-8")
            if name == "planes" and is_layered:
                text = _knowing_layers(text, r"bool HAS_LAYERS = false")
            (folder / f"{name}.slang").write_text(text, encoding="utf-8")
            wanted += _IMPORT.findall(text)
    return [f"{name}.slang" for name in names]


# ---------------------------------------------------------------------------------------------------- kernels


_TEMPLATES = Path(__file__).parent / "languages"
_WGSL_TYPES = {"float": "f32", "uint": "u32"}
# Of each language: where an answer is stored, names of vectors, and a further argument of functions.
KERNELS: dict[str, tuple[str, ...]] = {
    "wgsl": ("answers[id.x]", "vec2<f32>", "vec3<f32>"),
    "hlsl": ("answers[id.x]", "float2", "float3"),
    "glsl": ("answers[gl_GlobalInvocationID.x]", "vec2", "vec3"),
    "metal": ("answers[id]", "float2", "float3", "&buffers"),
    "cuda": ("answers[id]", "make_float2", "make_float3"),
}
# Arguments of `cloth_value` from a query, with two and three numbers a vector.
_ARGUMENTS = (
    "query.fabric",
    "{2}(query.centre_x, query.centre_y)",
    "{2}(query.dx_x, query.dx_y)",
    "{2}(query.dy_x, query.dy_y)",
    "{3}(query.light_x, query.light_y, query.light_z)",
    "{3}(query.view_x, query.view_y, query.view_z)",
)


def _answer(model: Shaders, answer: str, two: str, three: str, last: str = "") -> str:
    """The statements that store an answer: of `cloth_value`, or with a seed of the library's second one.

    Args:
        answer: where it is stored.
        two, three: names of vectors.
        last: a further argument of the functions.
    """
    parts = [part.replace("{2}", two).replace("{3}", three) for part in _ARGUMENTS]

    def call(function: str, *arguments: str) -> str:
        listed = (",\n" + " " * 8).join([*arguments, *([last] if last else [])])
        return f"{answer} = {function}(\n        {listed});"

    value = call("cloth_value", *parts)
    if model.second is None:
        return value
    given = [part for part in parts if model.second != "cloth_auxiliary" or "light" not in part]
    second = call(model.second, *given, "query.seed")
    return f"{value}\n    if (query.seed != 0u) {{\n        {second}\n    }}"


def c_struct(name: str, fields: Fields) -> str:
    """A struct of C, HLSL, GLSL, Metal and CUDA alike."""
    lines = [f"    {kind} {field};" + (f" // {text}" if text else "") for field, kind, text in fields]
    return "\n".join([f"struct {name}", "{", *lines, "};", ""])


def _wgsl_struct(name: str, fields: Fields) -> str:
    lines = [f"    {field}: {_WGSL_TYPES[kind]}," for field, kind, _ in fields]
    return "\n".join([f"struct {name}", "{", *lines, "}", ""])


def kernel(model: Shaders, language: str) -> str:
    """The kernel's text: `languages/kernel.LANGUAGE.in` for a model."""
    text = Template((_TEMPLATES / f"kernel.{language}.in").read_text(encoding="utf-8"))
    typed = {name: f"{_element(name, language)}* {name}" for name in model.buffers}
    if language == "metal":
        parameters = [f"device {of_buffer}" for of_buffer in typed.values()]
        parameters += ["device const Query* queries", "constant uint& count", "device float4* answers"]
        bound = [f"{parameter} [[buffer({n})]]" for n, parameter in enumerate(parameters)]
        listed = (",\n" + " " * 26).join([*bound, "uint id [[thread_position_in_grid]]"])
    else:
        listed = ", ".join(typed.values())
    member = ".data" if language == "cuda" else ""
    return text.substitute(
        query=(_wgsl_struct if language == "wgsl" else c_struct)("Query", QUERY),
        answer=_answer(model, *KERNELS[language]),
        parameters=listed,
        assignments="\n".join(f"    buffers.{name}{member} = {name};" for name in model.buffers),
    )


def _element(buffer: str, language: str) -> str:
    """The type of a buffer's elements in a library."""
    kind = BUFFERS[buffer][0]
    if kind in RECORDS:
        return f"{kind}_0"
    return f"packed_{kind}" if language == "metal" and kind == "uint4" else kind


def library_records() -> tuple[str, ...]:
    """Names of the records that libraries read, nested ones before those that hold them."""
    nested = [kind for _, kind, _ in RECORDS["Fabric"] if kind in RECORDS]
    return (*nested, "Fabric", "Family", "Query")


def c_header() -> str:
    """The records of buffers as C structs with their offsets asserted: what a host in C or C++ fills."""
    lines = (_TEMPLATES / "cloth_records.h.in").read_text(encoding="utf-8").splitlines()
    for record in library_records():
        name = f"Cloth{record}"
        lines += [f"typedef struct {name}", "{"]
        offset = 0
        asserts = []
        for field, kind, text in RECORDS[record]:
            c_type = {"uint": "uint32_t", "float": "float"}.get(kind, f"Cloth{kind}")
            lines.append(f"    {c_type} {field};" + (f" // {text}" if text else ""))
            asserts.append(f"CLOTH_ASSERT(offsetof({name}, {field}) == {offset});")
            offset += size_of(kind)
        lines += [f"}} {name};", *asserts, f"CLOTH_ASSERT(sizeof({name}) == {offset});", ""]
    return "\n".join(lines)


def size_of(kind: str) -> int:
    """Bytes of an element: four a number, or those of a record."""
    if kind in RECORDS:
        return sum(size_of(part) for _, part, _ in RECORDS[kind])
    return 16 if kind.endswith("4") else 4


# -------------------------------------------------------------------------------------------------- libraries
# Libraries in every shading language: `cloth_value` without an entry point, cut out of what slangc emits.
#
# Its code holds a kernel behind the library. Everything before the kernel is the library, apart from the
# buffers of the kernel's queries; the names that an engine uses lose the numbers that slangc appends.


# What an engine calls and binds.
_PUBLIC = (
    "cloth_value",
    "cloth_estimate",
    "cloth_auxiliary",
    "fabrics",
    "families",
    "words",
    "packed_numbers",
)
_QUERY_BUFFERS = "queries|query_count|answers"


@dataclass(frozen=True)
class Language:
    """The form of slangc's code in a language.

    Attributes:
        kernel: where the kernel begins, a pattern.
        removed: declarations of the kernel alone, patterns.
        renamed: further names.
    """

    kernel: str
    removed: tuple[str, ...]
    renamed: tuple[tuple[str, str], ...] = ()


_QUERY_STRUCT = r"struct Query(?:_std430)?_\d+\n\{[^}]*\};\n+"
LANGUAGES = {
    "wgsl": Language(r"@compute\n", (r"@binding\(\d+\) @group\(1\) var<[^;]*;\n+", _QUERY_STRUCT)),
    "hlsl": Language(
        r"\[numthreads",
        (rf"(?:RW)?StructuredBuffer<[^;]*> (?:{_QUERY_BUFFERS})_\d+ : register[^;]*;\n+", _QUERY_STRUCT),
    ),
    "glsl": Language(
        r"layout\(local_size_x",
        (
            rf"layout\(std430, binding = \d+, set = 1\)[^}}]*\}} (?:{_QUERY_BUFFERS})_\d+;\n",
            _QUERY_STRUCT,
            r"#version 450\n",
        ),
    ),
    "metal": Language(
        r"\[\[kernel\]\]",
        (rf"    \w+ device\* (?:{_QUERY_BUFFERS})_\d+;\n", _QUERY_STRUCT),
        (("KernelContext_0", "ClothBuffers"),),
    ),
    "cuda": Language(
        r'extern "C" __global__',
        (
            # Of all global buffers a library reads four at most.
            r"    (?:RW)?StructuredBuffer<[^;]*> (?!fabrics_|families_|words_|packed_numbers_)\w+;\n",
            r"    CUtexObject \w+;\n",
            r"#include <slang-cuda-prelude.h>\n",
            r"__device__ Query_\d+ slang_ldg_\d+\(Query_\d+ \* \w+\)\n\{.*?\n\}\n+",
            _QUERY_STRUCT,
        ),
        (
            ("GlobalParams_0", "ClothBuffers"),
            ("SLANG_globalParams", "cloth_buffers"),
            ('extern "C" __constant__', "static __constant__"),
        ),
    ),
}


@cache
def library(language: str, model: str, is_layered: bool = False) -> str:
    """The text of the library of a model in a language of `LANGUAGES`: everything that `cloth_value` needs.

    Args:
        is_layered: whether it shows cloth in layers with its planes, which makes it slower; it shows other
            cloth too.

    Raises:
        MissingDependencyError: it would have to be compiled, and there is no compiler.
        LoomlightError: the code is not of the form expected, after an edit of the build.
    """
    rules = LANGUAGES[language]
    text = library_code(language, model).decode()
    start = re.search(rules.kernel, text)
    if start is None:
        raise LoomlightError(f"The code of {model} in {language} has no kernel.")
    text = text[: start.start()]
    for pattern in rules.removed:
        text = re.sub(pattern, "", text, flags=re.DOTALL)
    left = re.search(rf"\b(?:{_QUERY_BUFFERS})_\d+\b|\bQuery(?:_std430)?_\d+\b", text)
    if left is not None:
        raise LoomlightError(
            f"The library of {model} reads {left[0]} in {language}: a query belongs to the kernel."
        )
    if is_layered:
        text = _knowing_layers(text, r"\b(?:bool|fn) is_layered_\d+\([^}]*?\bfalse\b")
    for name in _PUBLIC:
        text = re.sub(rf"\b{name}_0\b", name, text)
    for before, after in rules.renamed:
        text = text.replace(before, after)
    return re.sub(r"\n{3,}", "\n\n", text).strip() + "\n"


def _knowing_layers(text: str, constant: str) -> str:
    """Code with `HAS_LAYERS` true, where `planes.slang` or what slangc made of it has false.

    Args:
        constant: pattern of what ends with that "false".

    Raises:
        LoomlightError: it is not there once.
    """
    found = list(re.finditer(constant, text))
    if len(found) != 1:
        raise LoomlightError(
            f"The code says {len(found)} times whether it knows layers, where it should once."
        )
    start, end = found[0].span()
    return text[:start] + "true".join(text[start:end].rsplit("false", 1)) + text[end:]


_SPEC_CONSTANT_TRUE, _SPEC_CONSTANT_FALSE = 48, 49


def spirv_library(model: str, is_layered: bool = False) -> bytes:
    """The kernel of a model's library in SPIR-V; hosts may set its constant 0, whether it knows layers.

    Args:
        is_layered: what the constant is when no host sets it.

    Raises:
        MissingDependencyError: it would have to be compiled, and there is no compiler.
    """
    code = bytearray(library_code("spirv", model))
    words, at = memoryview(code).cast("I"), 5  # behind the header
    while at < len(words):
        if words[at] & 0xFFFF == _SPEC_CONSTANT_TRUE and not is_layered:
            words[at] += _SPEC_CONSTANT_FALSE - _SPEC_CONSTANT_TRUE
        at += words[at] >> 16
    words.release()
    return bytes(code)


# ------------------------------------------------------------------------------------------- buffers as files


def write_buffers(folder: Path, packed: Packed, model: str) -> list[dict[str, Any]]:
    """Writes a file NAME.bin, little-endian, of each buffer that a library reads; returns what they hold."""
    described = []
    for binding, (name, (kind, _)) in enumerate(BUFFERS.items()):
        if name in REALTIME_MODELS[model].buffers:
            content = packed.buffers()[name].tobytes()
            (folder / f"{name}.bin").write_bytes(content)
            described.append(
                {
                    "name": name,
                    "file": f"{name}.bin",
                    "binding": binding,
                    "element": kind,
                    "stride": size_of(kind),
                    "bytes": len(content),
                }
            )
    return described


def described_records() -> dict[str, Any]:
    """Fields of every record: name, type, offset in bytes, meaning."""
    return {name: _described(RECORDS[name]) for name in library_records()}


def _described(fields: Fields) -> list[dict[str, Any]]:
    rows = []
    offset = 0
    for name, kind, meaning in fields:
        rows.append({"name": name, "type": kind, "offset": offset, "meaning": meaning})
        offset += size_of(kind)
    return rows


# ----------------------------------------------------------------------------------- the page of instructions


_FOLDER = Path(__file__).parent / "languages"
_WITH_LAYERS = (
    " This cloth lies in layers, and the code knows them: it costs more of each layer and shows cloth in one "
    "plane too, but code exported of such cloth is faster for that."
)


def shader_instructions(
    name: str,
    model: str,
    language: str,
    code: Sequence[str],
    buffers: Sequence[dict[str, Any]],
    repeat_mm: tuple[float, float],
    is_layered: bool = False,
) -> str:
    """The text of README.md.

    Args:
        code: names of the files of code.
        buffers: as the manifest describes them.
        repeat_mm: size of the draft's repeat.
        is_layered: whether the code knows layers.
    """
    with (_FOLDER / "languages.toml").open("rb") as file:
        of_language = tomllib.load(file)[language]
    rows = [
        f"| `{b['file']}` | {of_language['binding'].format(n=b['binding'])} | {_entry(b)} | {b['bytes']} |"
        for b in buffers
    ]
    width, height = repeat_mm
    use = of_language["use"].format(model=model)
    files = ", ".join(f"`{file}`" for file in code)
    return (
        (_FOLDER / "instructions.md")
        .read_text(encoding="utf-8")
        .format(
            name=name,
            model=model,
            use=use,
            files=files,
            signature=of_language["signature"],
            computes=REALTIME_MODELS[model].computes,
            width=width,
            height=height,
            rows="\n".join(rows),
            layers=_WITH_LAYERS if is_layered else "",
            cost=REALTIME_MODELS[model].cost,
        )
    )


def _entry(buffer: dict[str, Any]) -> str:
    kind = buffer["element"]
    return "32-bit words" if kind == "uint" else f"`{kind}`, {buffer['stride']} bytes"
