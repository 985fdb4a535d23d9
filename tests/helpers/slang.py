"""Slang functions over arrays: an entry point is written around a few lines of Slang, compiled and run."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.models.interface import ShaderTables
from loomlight.models.lobes.tables import given_numbers
from loomlight.models.neural.model import NeuralModel
from loomlight.realtime.device import default_adapter
from loomlight.realtime.records import BUFFERS
from loomlight.realtime.slangc import LAYERED, compile_shader
from loomlight.realtime.words import Packed, pack_fabrics

_GROUP = 64
_FIRST_BINDING = len(BUFFERS) + 2


def mapped(
    modules: str,
    body: str,
    results: str,
    arguments: Mapping[str, NDArray[Any]],
    fabric: tuple[Any, ...] | Packed | None = None,
    neural: NeuralModel | None = None,
    buffers: Mapping[str, NDArray[Any]] | None = None,
    declarations: str = "",
    prologue: str = "",
) -> NDArray[np.float32]:
    """What a few lines of Slang make of each row of the arguments: float32 [n, results].

    Args:
        modules: to import, separated by spaces.
        body: statements that may use the arguments by name, and `fabric`.
        results: numbers to return, expressions of type float, uint or bool separated by ";".
        arguments: float [n] or [n, 2 or 3], or bool or unsigned [n].
        fabric: layout, appearance, and tables of lobes where the lines need them; or packed fabrics, of which
            the first is meant.
        neural: the model of that fabric whose latents the lines need.
        buffers: contents of further buffers that the modules read.
        declarations: before the entry point.
        prologue: statements that threads without a row run too, such as barriers.
    """
    count = len(next(iter(arguments.values())))
    columns: list[NDArray[np.uint32]] = []
    lets = []
    for name, values in arguments.items():
        expression, more = _argument(np.asarray(values), len(columns))
        lets.append(f"    let {name} = {expression};")
        columns += more
    outputs = results.split(";")
    source = [
        *(f"import {module};" for module in ["generated", *modules.split()]),
        f"[[vk::binding({_FIRST_BINDING}, 0)]] StructuredBuffer<uint> arguments;",
        f"[[vk::binding({_FIRST_BINDING + 1}, 0)]] RWStructuredBuffer<float> results;",
        "uint argument(uint column, uint row) { return arguments[1 + column * arguments[0] + row]; }",
        declarations,
        f'[shader("compute")] [numthreads({_GROUP}, 1, 1)]',
        "void map_rows(uint3 id : SV_DispatchThreadID)",
        "{",
        "    let i = id.x;",
        prologue,
        "    if (i >= arguments[0]) return;",
        *lets,
        *(["    let fabric = fabrics[0];"] if fabric is not None else []),
        body,
        *(f"    results[i * {len(outputs)} + {k}] = float({value});" for k, value in enumerate(outputs)),
        "}",
    ]
    adapter = default_adapter()
    wgsl = _compiled("\n".join(source))
    data = np.concatenate([np.array([count], np.uint32), *columns])
    resources = {
        "arguments": adapter.storage(data),
        "results": adapter.empty_storage(4 * count * len(outputs)),
    }
    resources |= {name: adapter.storage(values) for name, values in (buffers or {}).items()}
    if fabric is not None:
        packed = fabric if isinstance(fabric, Packed) else _pack(*fabric, neural=neural)
        resources |= {name: adapter.storage(values) for name, values in packed.buffers().items()}
    pipeline = adapter.pipeline(wgsl, "map_rows", fabric is not None and packed.is_layered)
    group = adapter.bindings(pipeline, wgsl, resources)
    encoder = adapter.device.create_command_encoder()
    compute = encoder.begin_compute_pass()
    compute.set_pipeline(pipeline)
    compute.set_bind_group(0, group)
    compute.dispatch_workgroups(-(-count // _GROUP))
    compute.end()
    adapter.device.queue.submit([encoder.finish()])
    return adapter.read(resources["results"], np.float32, count * len(outputs)).reshape(count, len(outputs))


def _pack(layout: Any, appearance: Any, *lobes: Any, neural: NeuralModel | None) -> Packed:
    shown = None if neural is None else neural.shader_tables()
    if lobes:
        shown = ShaderTables(lobes[0], given_numbers(layout, lobes[0].base_size))
    return pack_fabrics([(layout, appearance)], None, [shown])


def _argument(values: NDArray[Any], column: int) -> tuple[str, list[NDArray[np.uint32]]]:
    """The Slang expression of an argument whose first column has this number, and its columns."""
    if values.dtype == bool:
        return f"argument({column}, i) != 0u", [values.astype(np.uint32)]
    if np.issubdtype(values.dtype, np.integer):
        return f"argument({column}, i)", [values.astype(np.uint32)]
    numbers = np.atleast_2d(values.T).astype(np.float32)
    parts = ", ".join(f"asfloat(argument({column + k}, i))" for k in range(len(numbers)))
    kind = "float" if values.ndim == 1 else f"float{len(numbers)}"
    return f"{kind}({parts})", [np.ascontiguousarray(row).view(np.uint32) for row in numbers]


@cache
def _compiled(source: str) -> str:
    with TemporaryDirectory() as folder:
        file = Path(folder) / f"map_{hashlib.sha1(source.encode()).hexdigest()[:8]}.slang"
        file.write_text(source, encoding="utf-8")
        return compile_shader(file, "wgsl", ["map_rows"], LAYERED).decode()
