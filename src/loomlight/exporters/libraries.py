"""Libraries in every shading language: `cloth_value` without an entry point, cut out of what slangc emits.

Its code holds a kernel behind the library. Everything before the kernel is the library, apart from the
buffers of the kernel's queries; the names that an engine uses lose the numbers that slangc appends.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache

from loomlight.core.errors import LoomlightError
from loomlight.realtime.slangc import library_code

# What an engine calls and binds.
_PUBLIC = ("cloth_value", "cloth_estimate", "fabrics", "families", "words", "packed_numbers")
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
def library(language: str, model: str) -> str:
    """The text of the library of a model in a language of `LANGUAGES`: everything that `cloth_value` needs.

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
    for name in _PUBLIC:
        text = re.sub(rf"\b{name}_0\b", name, text)
    for before, after in rules.renamed:
        text = text.replace(before, after)
    return re.sub(r"\n{3,}", "\n\n", text).strip() + "\n"
