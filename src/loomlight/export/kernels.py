"""The kernel that calls a library for a batch of queries, in every language: the smallest use of it."""

from __future__ import annotations

from loomlight.realtime.layout import QUERY, RECORDS, Fields

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


def _arguments(two: str, three: str, indent: str = "        ") -> str:
    parts = [part.replace("{2}", two).replace("{3}", three) for part in _ARGUMENTS]
    return (",\n" + indent).join(parts)


def c_struct(name: str, fields: Fields) -> str:
    """A struct of C, HLSL, GLSL, Metal and CUDA alike."""
    lines = [f"    {kind} {field};" + (f" // {text}" if text else "") for field, kind, text in fields]
    return "\n".join([f"struct {name}", "{", *lines, "};", ""])


def _wgsl_struct(name: str, fields: Fields) -> str:
    lines = [f"    {field}: {_WGSL_TYPES[kind]}," for field, kind, _ in fields]
    return "\n".join([f"struct {name}", "{", *lines, "}", ""])


def _wgsl() -> str:
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
    answers[id.x] = cloth_value(
        {_arguments("vec2<f32>", "vec3<f32>")});
}}
"""


def _hlsl() -> str:
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
    answers[id.x] = cloth_value(
        {_arguments("float2", "float3")});
}}
"""


def _glsl() -> str:
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
    answers[gl_GlobalInvocationID.x] = cloth_value(
        {_arguments("vec2", "vec3")});
}}
"""


def _metal() -> str:
    return f"""// An answer (red, green, blue, share that passes through) for each query.
#include "cloth.metal"

{c_struct("Query", QUERY)}
kernel void cloth_queries(device Fabric_0* fabrics [[buffer(0)]], device Family_0* families [[buffer(1)]],
                          device uint* words [[buffer(2)]], device const Query* queries [[buffer(3)]],
                          constant uint& count [[buffer(4)]], device float4* answers [[buffer(5)]],
                          uint id [[thread_position_in_grid]])
{{
    if (id >= count)
        return;
    thread ClothBuffers buffers;
    buffers.fabrics = fabrics;
    buffers.families = families;
    buffers.words = words;
    Query query = queries[id];
    answers[id] = cloth_value(
        {_arguments("float2", "float3")},
        &buffers);
}}
"""


def _cuda() -> str:
    return f"""// An answer (red, green, blue, share that passes through) for each query.
#include "cloth.cu"

{c_struct("Query", QUERY)}
extern "C" __global__ void cloth_queries(const Query* queries, uint count, float4* answers)
{{
    uint id = blockIdx.x * blockDim.x + threadIdx.x;
    if (id >= count)
        return;
    Query query = queries[id];
    answers[id] = cloth_value(
        {_arguments("make_float2", "make_float3")});
}}

// Host: pointers to copies of fabrics.bin, families.bin and words.bin on the device, before the first launch.
extern "C" cudaError_t cloth_bind(Fabric_0* fabrics, Family_0* families, uint* words)
{{
    ClothBuffers buffers = {{}};
    buffers.fabrics.data = fabrics;
    buffers.families.data = families;
    buffers.words.data = words;
    return cudaMemcpyToSymbol(cloth_buffers, &buffers, sizeof buffers);
}}

extern "C" cudaError_t cloth_launch(const Query* queries, uint count, float4* answers)
{{
    cloth_queries<<<(count + 63) / 64, 64>>>(queries, count, answers);
    return cudaGetLastError();
}}
"""


KERNELS = {"wgsl": _wgsl, "hlsl": _hlsl, "glsl": _glsl, "metal": _metal, "cuda": _cuda}


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
    for record in ("Lobes", "Woven", "Neumip", "Fabric", "Family", "Query"):
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
    """Bytes of a field's type: four, or those of a record."""
    return sum(size_of(part) for _, part, _ in RECORDS[kind]) if kind in RECORDS else 4
