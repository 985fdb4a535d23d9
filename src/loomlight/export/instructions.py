"""The page of instructions that stands beside exported shader code."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from loomlight.realtime.models import REALTIME_MODELS

_PAGE = Path(__file__).parent / "languages" / "instructions.md"
# How each language is used, a sentence or two.
_USE = {
    "slang": "`import cloth_{model};` and compile with slangc for any API; no other file is needed.",
    "wgsl": "WGSL has no include: put the text of `cloth.wgsl` before your own module. `python sample.py` "
    "draws a sphere (it needs `pip install wgpu numpy`).",
    "hlsl": '`#include "cloth.hlsl"` (shader model 6.0). '
    "`dxc -T cs_6_0 -E cloth_queries cloth_queries.hlsl` compiles the kernel.",
    "glsl": '`#include "cloth.glsl"` behind `#version 450`; '
    "`glslangValidator -V -S comp cloth_queries.glsl` compiles the kernel.",
    "spirv": "A compute shader of SPIR-V 1.3 with the entry point `{model}_queries`, 64 queries a workgroup; "
    "set 1 holds its queries (binding 0, records `Query` of `cloth.h`), their number (binding 1, one uint) "
    "and four floats for each answer (binding 2).",
    "metal": '`#include "cloth.metal"`; `cloth_value` takes a `ClothBuffers` as its last argument, '
    "which holds the pointers to the buffers.",
    "cuda": '`#include "cloth.cu"` in one `.cu` file; call `cloth_bind` of `cloth_queries.cu` once '
    "with pointers to the buffers on the device. `nvcc -c cloth_queries.cu` compiles the kernel.",
}
_BINDING = {
    "slang": "`[[vk::binding({n}, 0)]]`",
    "wgsl": "`@group(0) @binding({n})`",
    "hlsl": "`register(t{n})`",
    "glsl": "`set = 0, binding = {n}`",
    "spirv": "`set = 0, binding = {n}`",
    "metal": "`[[buffer({n})]]`",
    "cuda": "`cloth_buffers`",
}
_SIGNATURE = {
    "slang": "float4 cloth_value(uint fabric, float2 centre, float2 dx, float2 dy, "
    "float3 light, float3 view)",
    "wgsl": "fn cloth_value(fabric: u32, centre: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, "
    "light: vec3<f32>, view: vec3<f32>) -> vec4<f32>",
    "glsl": "vec4 cloth_value(uint fabric, vec2 centre, vec2 dx, vec2 dy, vec3 light, vec3 view)",
    "metal": "float4 cloth_value(uint fabric, float2 centre, float2 dx, float2 dy, "
    "float3 light, float3 view, ClothBuffers thread* buffers)",
}


def shader_instructions(
    name: str,
    model: str,
    language: str,
    code: Sequence[str],
    buffers: Sequence[dict[str, Any]],
    repeat_mm: tuple[float, float],
) -> str:
    """The text of README.md.

    Args:
        code: names of the files of code.
        buffers: as the manifest describes them.
        repeat_mm: size of the draft's repeat.
    """
    rows = [
        f"| `{b['file']}` | {_BINDING[language].format(n=b['binding'])} | {_element(b)} | {b['bytes']} |"
        for b in buffers
    ]
    width, height = repeat_mm
    use = _USE[language].format(model=model)
    files = ", ".join(f"`{file}`" for file in code)
    return _PAGE.read_text(encoding="utf-8").format(
        name=name,
        model=model,
        use=use,
        files=files,
        signature=_SIGNATURE.get(language, _SIGNATURE["slang"]),
        computes=REALTIME_MODELS[model].computes,
        width=width,
        height=height,
        rows="\n".join(rows),
        cost=REALTIME_MODELS[model].cost,
    )


def _element(buffer: dict[str, Any]) -> str:
    kind = buffer["element"]
    return "32-bit words" if kind == "uint" else f"`{kind}`, {buffer['stride']} bytes"
