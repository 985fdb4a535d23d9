"""The encoder as an ONNX model.

`maps` [1, 7, rows, columns] of one face and `parameters` [4] to `latents` [texels, latent_size], in the order
of `pyramid.levels_of` ("field"), or [1, latent_size] ("vector").
"""

from __future__ import annotations

import numpy as np
import onnx
from onnx import TensorProto

from loomlight.models.woven.architecture import LOG_ROUGHNESS, MOST_THREADS
from loomlight.models.woven.maps import CHANNELS
from loomlight.models.woven.onnx_graph import FLOAT, Graph
from loomlight.models.woven.pyramid import FINEST, WHOLE_REPEATS
from loomlight.models.woven.weights import Weights


def encoder_graph(weights: Weights) -> onnx.ModelProto:
    """The encoder of one face; "field" takes any repeat of up to 64 threads a side, 16 texels a thread."""
    graph = Graph(weights)
    stages = _trunk(graph)
    field = weights.table.latent == "field"
    rows = _field_rows(graph, stages) if field else _vector_row(graph, stages[-1])
    _join(graph, rows, "latents")
    return graph.model(
        "woven_encoder",
        {"maps": [1, CHANNELS, "rows", "columns"], "parameters": [4]},
        {"latents": ["texels", weights.table.latent_size]},
    )


def _trunk(graph: Graph) -> list[str]:
    maps = graph.add("Relu", graph.convolution("encoder.trunk.stem", "maps", 2))
    found = [maps]
    maps = graph.add("AveragePool", maps, kernel_shape=[2, 2], strides=[2, 2])
    for stage in range(3):
        for block in range(2):
            maps = _block(
                graph, f"encoder.trunk.stages.{stage}.{block}", maps, 2 if stage and not block else 1
            )
        found.append(maps)
    return found


def _block(graph: Graph, name: str, maps: str, stride: int) -> str:
    has_skip = f"{name}.skip.weight" in graph.weights.tensors
    short = graph.convolution(f"{name}.skip", maps, stride) if has_skip else maps
    inner = graph.add("Relu", graph.convolution(f"{name}.first", maps, stride))
    branch = graph.add("Mul", graph.convolution(f"{name}.second", inner), graph.weight(f"{name}.gain"))
    return graph.add("Relu", graph.add("Add", short, branch))


def _vector_row(graph: Graph, maps: str) -> str:
    squeezed = graph.add("Relu", graph.convolution("encoder.squeeze", maps))
    return graph.add("Flatten", squeezed, axis=1)


def _field_rows(graph: Graph, stages: list[str]) -> str:
    """Features of all levels, a row a texel, with the level's number beside them."""
    found = [graph.convolution(f"encoder.sideways.{FINEST}", stages[FINEST])]
    for number in range(FINEST - 1, -1, -1):
        scales = graph.number([1, 1, 2, 2])
        coarser = graph.add(
            "Resize",
            found[0],
            "",
            scales,
            mode="nearest",
            coordinate_transformation_mode="asymmetric",
            nearest_mode="floor",
        )
        joined = graph.add(
            "Relu",
            graph.add("Add", graph.convolution(f"encoder.sideways.{number}", stages[number]), coarser),
        )
        found.insert(0, graph.convolution(f"encoder.smooth.{number - 1}", joined) if number else joined)
    rows = [_rows(graph, maps, graph.number([[number / 8]])) for number, maps in enumerate(found)]
    shape = graph.add("Shape", found[FINEST])
    picks, ends = (graph.add("Gather", shape, graph.integers([axis])) for axis in (2, 3))
    threads = graph.add("Mul", picks, ends)
    rows.append(_wide_rows(graph, found[FINEST], picks, ends, threads))
    mean = graph.add("ReduceMean", found[FINEST], graph.integers([2, 3]), keepdims=1)
    last = graph.add("Add", _wide_levels(graph, picks, ends), graph.integers([FINEST + 1]))
    share = graph.add("Mul", graph.add("Cast", last, to=FLOAT), graph.number(1 / 8))
    rows.append(_rows(graph, mean, graph.add("Unsqueeze", share, graph.integers([0]))))
    return graph.add("Concat", *rows, axis=0)


def _rows(graph: Graph, maps: str, level: str) -> str:
    """Maps [1, features, rows, columns] as rows [texels, features + 1]; `level` [1, 1] is the last."""
    features = graph.weights.table.latent_size
    flat = graph.add("Reshape", maps, graph.integers([features, -1]))
    rows = graph.add("Transpose", flat, perm=[1, 0])
    count = graph.add("Slice", graph.add("Shape", rows), graph.integers([0]), graph.integers([1]))
    shape = graph.add("Concat", count, graph.integers([1]), axis=0)
    return graph.add("Concat", rows, graph.add("Expand", level, shape), axis=1)


def _windows() -> list[int]:
    """Threads across of every running mean that a repeat of `MOST_THREADS` has."""
    windows = [2]
    while 2 * windows[-1] <= WHOLE_REPEATS * MOST_THREADS:
        windows.append(2 * windows[-1])
    return windows


def _wide_levels(graph: Graph, picks: str, ends: str) -> str:
    """How many levels of running means this repeat has [1]."""
    largest = graph.add("Mul", graph.add("Max", picks, ends), graph.integers([WHOLE_REPEATS]))
    exists = graph.add("LessOrEqual", graph.integers(_windows()), largest)
    return graph.add(
        "ReduceSum", graph.add("Cast", exists, to=TensorProto.INT64), graph.integers([0]), keepdims=1
    )


def _wide_rows(graph: Graph, means: str, picks: str, ends: str, threads: str) -> str:
    """Rows of the running means; all that a repeat may have are computed, those that it has are kept."""
    rows = []
    for number, window in enumerate(_windows(), FINEST + 1):
        half = window // 2
        shifts = (0, -1) if half == 1 else (half // 2, -(half // 2))
        for axis, extent in ((3, ends), (2, picks)):
            moved = [_rolled(graph, means, axis, extent, shift) for shift in shifts]
            means = graph.add("Mul", graph.add("Add", *moved), graph.number(0.5))
        rows.append(_rows(graph, means, graph.number([[number / 8]])))
    end = graph.add("Mul", _wide_levels(graph, picks, ends), threads)
    return graph.add("Slice", graph.add("Concat", *rows, axis=0), graph.integers([0]), end)


def _rolled(graph: Graph, maps: str, axis: int, extent: str, shift: int) -> str:
    """A periodic map moved by `shift` texels, as numpy.roll does."""
    if shift == 0:
        return maps
    count = graph.add("Squeeze", extent)
    texels = graph.add("Range", graph.integers(0), count, graph.integers(1))
    source = graph.add("Mod", graph.add("Sub", texels, graph.integers(shift)), count)
    return graph.add("Gather", maps, source, axis=axis)


def _join(graph: Graph, rows: str, output: str) -> None:
    """Latents of rows of features; the parameters are the same in all, so their part is a bias."""
    weight = graph.weights.tensor("encoder.join.first.weight")
    features = weight.shape[1] - 4
    bias = graph.add(
        "Gemm",
        graph.add("Unsqueeze", _scaled_parameters(graph), graph.integers([0])),
        graph.constant(np.ascontiguousarray(weight[:, features:])),
        graph.weight("encoder.join.first.bias"),
        transB=1,
    )
    joined = graph.add(
        "Gemm", rows, graph.constant(np.ascontiguousarray(weight[:, :features])), bias, transB=1
    )
    hidden = graph.linear("encoder.join.second", graph.leaky(joined))
    hidden = graph.leaky(graph.add("Add", joined, hidden))
    last = "encoder.join.last"
    graph.add(
        "Gemm",
        hidden,
        graph.weight(f"{last}.weight"),
        graph.weight(f"{last}.bias"),
        transB=1,
        output=output,
    )


def _scaled_parameters(graph: Graph) -> str:
    roughness = graph.add("Slice", "parameters", graph.integers([0]), graph.integers([2]))
    height_scale = graph.add("Slice", "parameters", graph.integers([2]), graph.integers([4]))
    return graph.add(
        "Concat",
        graph.add(
            "Add",
            graph.number(1),
            graph.add("Div", graph.add("Log", roughness), graph.number(LOG_ROUGHNESS)),
        ),
        graph.add("Sub", graph.add("Mul", graph.number(2), height_scale), graph.number(1)),
        axis=0,
    )
