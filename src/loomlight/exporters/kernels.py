"""The kernel that calls a library for a batch of queries, in every language: the smallest use of it."""

from __future__ import annotations

from pathlib import Path
from string import Template

from loomlight.models.registry import Shaders
from loomlight.realtime.records import BUFFERS, QUERY, RECORDS, Fields

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
