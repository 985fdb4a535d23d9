"""The kernel that calls a library for a batch of queries, in every language: the smallest use of it."""

from __future__ import annotations

from collections.abc import Callable

from loomlight.realtime.layout import BUFFERS, QUERY, RECORDS, Fields
from loomlight.realtime.models import RealtimeModel

_WGSL_TYPES = {"float": "f32", "uint": "u32"}
# Arguments of `cloth_value` from a query, with two and three numbers a vector.
_ARGUMENTS = (
    "query.fabric",
    "{2}(query.centre_x, query.centre_y)",
    "{2}(query.dx_x, query.dx_y)",
    "{2}(query.dy_x, query.dy_y)",
    "{3}(query.light_x, query.light_y, query.light_z)",
    "{3}(query.view_x, query.view_y, query.view_z)",
)


def _answer(model: RealtimeModel, answer: str, two: str, three: str, last: str = "") -> str:
    """The statements that store an answer: of `cloth_value`, or with a seed of `cloth_estimate`.

    Args:
        answer: where it is stored.
        two, three: names of vectors.
        last: a further argument of the functions.
    """
    parts = [part.replace("{2}", two).replace("{3}", three) for part in _ARGUMENTS]

    def call(function: str, *more: str) -> str:
        arguments = (",\n" + " " * 8).join([*parts, *more, *([last] if last else [])])
        return f"{answer} = {function}(\n        {arguments});"

    if not model.has_estimate:
        return call("cloth_value")
    estimate = call("cloth_estimate", "query.seed")
    return f"{call('cloth_value')}\n    if (query.seed != 0u) {{\n        {estimate}\n    }}"


def c_struct(name: str, fields: Fields) -> str:
    """A struct of C, HLSL, GLSL, Metal and CUDA alike."""
    lines = [f"    {kind} {field};" + (f" // {text}" if text else "") for field, kind, text in fields]
    return "\n".join([f"struct {name}", "{", *lines, "};", ""])


def _wgsl_struct(name: str, fields: Fields) -> str:
    lines = [f"    {field}: {_WGSL_TYPES[kind]}," for field, kind, _ in fields]
    return "\n".join([f"struct {name}", "{", *lines, "}", ""])


def _wgsl(model: RealtimeModel) -> str:
    return f"""// To be put behind cloth.wgsl.
// An answer (red, green, blue, share that passes through) for each query.
{_wgsl_struct("Query", QUERY)}
@group(1) @binding(0) var<storage, read> queries: array<Query>;
@group(1) @binding(1) var<storage, read_write> answers: array<vec4<f32>>;

@compute @workgroup_size(64)
fn cloth_queries(@builtin(global_invocation_id) id: vec3<u32>)
{{
    if (id.x >= arrayLength(&queries)) {{ return; }}
    let query = queries[id.x];
    {_answer(model, "answers[id.x]", "vec2<f32>", "vec3<f32>")}
}}
"""


def _hlsl(model: RealtimeModel) -> str:
    return f"""// An answer (red, green, blue, share that passes through) for each query.
#include "cloth.hlsl"

{c_struct("Query", QUERY)}
StructuredBuffer<Query> queries : register(t0, space1);
RWStructuredBuffer<float4> answers : register(u0, space1);

[numthreads(64, 1, 1)]
void cloth_queries(uint3 id : SV_DispatchThreadID)
{{
    uint count, stride;
    queries.GetDimensions(count, stride);
    if (id.x >= count)
        return;
    Query query = queries[id.x];
    {_answer(model, "answers[id.x]", "float2", "float3")}
}}
"""


def _glsl(model: RealtimeModel) -> str:
    return f"""#version 450
#extension GL_GOOGLE_include_directive : require
// An answer (red, green, blue, share that passes through) for each query.
#include "cloth.glsl"

{c_struct("Query", QUERY)}
layout(std430, set = 1, binding = 0) readonly buffer Queries {{ Query queries[]; }};
layout(std430, set = 1, binding = 1) writeonly buffer Answers {{ vec4 answers[]; }};

layout(local_size_x = 64) in;
void main()
{{
    if (gl_GlobalInvocationID.x >= queries.length())
        return;
    Query query = queries[gl_GlobalInvocationID.x];
    {_answer(model, "answers[gl_GlobalInvocationID.x]", "vec2", "vec3")}
}}
"""


def _metal(model: RealtimeModel) -> str:
    parameters = [f"device {_element(name, 'metal')}* {name}" for name in model.buffers]
    parameters += ["device const Query* queries", "constant uint& count", "device float4* answers"]
    bound = [f"{parameter} [[buffer({n})]]" for n, parameter in enumerate(parameters)]
    lines = (",\n" + " " * 26).join([*bound, "uint id [[thread_position_in_grid]]"])
    assignments = "\n".join(f"    buffers.{name} = {name};" for name in model.buffers)
    return f"""// An answer (red, green, blue, share that passes through) for each query.
#include "cloth.metal"

{c_struct("Query", QUERY)}
kernel void cloth_queries({lines})
{{
    if (id >= count)
        return;
    thread ClothBuffers buffers;
{assignments}
    Query query = queries[id];
    {_answer(model, "answers[id]", "float2", "float3", "&buffers")}
}}
"""


def _cuda(model: RealtimeModel) -> str:
    parameters = ", ".join(f"{_element(name, 'cuda')}* {name}" for name in model.buffers)
    assignments = "\n".join(f"    buffers.{name}.data = {name};" for name in model.buffers)
    return f"""// An answer (red, green, blue, share that passes through) for each query.
#include "cloth.cu"

{c_struct("Query", QUERY)}
extern "C" __global__ void cloth_queries(const Query* queries, uint count, float4* answers)
{{
    uint id = blockIdx.x * blockDim.x + threadIdx.x;
    if (id >= count)
        return;
    Query query = queries[id];
    {_answer(model, "answers[id]", "make_float2", "make_float3")}
}}

// Host: pointers to copies of the files .bin of these names on the device, before the first launch.
extern "C" cudaError_t cloth_bind({parameters})
{{
    ClothBuffers buffers = {{}};
{assignments}
    return cudaMemcpyToSymbol(cloth_buffers, &buffers, sizeof buffers);
}}

extern "C" cudaError_t cloth_launch(const Query* queries, uint count, float4* answers)
{{
    cloth_queries<<<(count + 63) / 64, 64>>>(queries, count, answers);
    return cudaGetLastError();
}}
"""


def _element(buffer: str, language: str) -> str:
    """The type of a buffer's elements in a library."""
    kind = BUFFERS[buffer][0]
    if kind in RECORDS:
        return f"{kind}_0"
    return f"packed_{kind}" if language == "metal" and kind == "uint4" else kind


KERNELS: dict[str, Callable[[RealtimeModel], str]] = {
    "wgsl": _wgsl,
    "hlsl": _hlsl,
    "glsl": _glsl,
    "metal": _metal,
    "cuda": _cuda,
}


def library_records() -> tuple[str, ...]:
    """Names of the records that libraries read, nested ones before those that hold them."""
    nested = [kind for _, kind, _ in RECORDS["Fabric"] if kind in RECORDS]
    return (*nested, "Fabric", "Family", "Query")


def c_header() -> str:
    """The records of buffers as C structs with their offsets asserted: what a host in C or C++ fills."""
    lines = [
        "// Records of the buffers of loomlight's cloth, as shaders read them. Every field takes four bytes.",
        "#pragma once",
        "",
        "#include <stddef.h>",
        "#include <stdint.h>",
        "",
        "#ifdef __cplusplus",
        "#define CLOTH_ASSERT(CONDITION) static_assert(CONDITION, #CONDITION)",
        "#else",
        "#define CLOTH_ASSERT(CONDITION) _Static_assert(CONDITION, #CONDITION)",
        "#endif",
        "",
    ]
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
