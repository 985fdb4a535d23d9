"""Encoder and decoder as ONNX models, built from the weights without torch (ONNX opset 21).

Encoder: `maps` [1, 7, rows, columns] of one face and `parameters` [4] to `latents` [texels, latent_size], in
the order of `pyramid.levels_of` ("field"), or [1, latent_size] ("vector").
Decoder: `latent` [n, latent_size], `place` [n, 3], `light` and `view` [n, 3] in the frame of the face that is
seen, to `components` [n, 4], 1/sr, and `hole` [n], 0 to 1.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import onnx
from numpy.typing import ArrayLike, NDArray
from onnx import TensorProto, helper, numpy_helper

from loomlight.models.woven.architecture import (
    BINS,
    BLOB_REACH,
    HALF_BINS,
    HALF_REACH,
    LARGEST_OUTPUT,
    LOG_ROUGHNESS,
    MOST_THREADS,
    OPPOSITE,
    REFLECTION_GAIN,
    SLOPE,
    TRANSMISSION_GAIN,
)
from loomlight.models.woven.maps import CHANNELS
from loomlight.models.woven.pyramid import FINEST, WHOLE_REPEATS
from loomlight.models.woven.weights import Weights

_OPSET, _IR = 21, 10
_FLOAT = TensorProto.FLOAT


def encoder_graph(weights: Weights) -> onnx.ModelProto:
    """The encoder of one face; "field" takes any repeat of up to 64 threads a side, 16 texels a thread."""
    graph = _Graph(weights)
    stages = _trunk(graph)
    field = weights.table.latent == "field"
    rows = _field_rows(graph, stages) if field else _vector_row(graph, stages[-1])
    _join(graph, rows, "latents")
    return graph.model(
        "woven_encoder",
        {"maps": [1, CHANNELS, "rows", "columns"], "parameters": [4]},
        {"latents": ["texels", weights.table.latent_size]},
    )


def decoder_graph(weights: Weights) -> onnx.ModelProto:
    """The decoder of n queries."""
    graph = _Graph(weights)
    table = weights.table
    coded = _one_blob(graph) if table.position == "one_blob" else "place"
    spatial = graph.add("Concat", "latent", coded, axis=1)
    if table.fusion:
        for number in range(2):
            spatial = graph.leaky(graph.linear(f"decoder.fusion.{number}", spatial))
    eye = graph.add("Slice", "view", graph.integers([0]), graph.integers([2]), graph.integers([1]))
    directions = ["light", eye]
    if table.half_vector:
        directions.append(_coded_half_vector(graph))
    hidden = graph.add("Concat", spatial, *directions, axis=1)
    skip = ""
    count = weights.layers("decoder.angular")
    for number in range(count):
        hidden = graph.linear(f"decoder.angular.{number}", hidden)
        if number == 0:
            skip = hidden
        elif number == 2:
            hidden = graph.add("Add", hidden, skip)
        if number + 1 < count:
            hidden = graph.leaky(hidden)
    _unmapped(graph, hidden)
    hole = graph.leaky(graph.linear("decoder.hole.0", graph.add("Concat", spatial, eye, axis=1)))
    hole = graph.add("Squeeze", graph.linear("decoder.hole.1", hole), graph.integers([1]))
    graph.add("Clip", hole, graph.number(0), graph.number(1), output="hole")
    return graph.model(
        "woven_decoder",
        {
            "latent": ["n", table.latent_size],
            "place": ["n", 3],
            "light": ["n", 3],
            "view": ["n", 3],
        },
        {"components": ["n", 4], "hole": ["n"]},
    )


class _Graph:
    """Nodes and constants as they come; values are called by their names."""

    def __init__(self, weights: Weights) -> None:
        self.weights = weights
        self._nodes: list[Any] = []
        self._constants: dict[str, NDArray[Any]] = {}

    def add(self, operator: str, *inputs: str, output: str | None = None, **attributes: Any) -> str:
        """The result of one node."""
        name = output or f"value_{len(self._nodes)}"
        self._nodes.append(helper.make_node(operator, list(inputs), [name], **attributes))
        return name

    def constant(self, values: NDArray[Any]) -> str:
        """An array."""
        name = f"constant_{len(self._constants)}"
        self._constants[name] = values
        return name

    def number(self, value: ArrayLike) -> str:
        """A float32 number or array."""
        return self.constant(np.asarray(value, np.float32))

    def integers(self, values: ArrayLike) -> str:
        """An int64 array, as shapes and axes are."""
        return self.constant(np.asarray(values, np.int64))

    def weight(self, name: str) -> str:
        """A tensor of the network."""
        self._constants.setdefault(name, self.weights.tensor(name))
        return name

    def linear(self, name: str, value: str) -> str:
        """A linear layer [n, inputs] to [n, outputs]."""
        return self.add("Gemm", value, self.weight(f"{name}.weight"), self.weight(f"{name}.bias"), transB=1)

    def leaky(self, value: str) -> str:
        """Leaky ReLU."""
        return self.add("LeakyRelu", value, alpha=SLOPE)

    def convolution(self, name: str, value: str, stride: int = 1) -> str:
        """A convolution over a periodic map."""
        size = self.weights.tensor(f"{name}.weight").shape[-1]
        edge = size // 2
        if edge:
            pads = self.integers([0, 0, edge, edge, 0, 0, edge, edge])
            value = self.add("Pad", value, pads, mode="wrap")
        weight, bias = self.weight(f"{name}.weight"), self.weight(f"{name}.bias")
        return self.add("Conv", value, weight, bias, strides=[stride, stride], kernel_shape=[size, size])

    def model(self, name: str, inputs: dict[str, Any], outputs: dict[str, Any]) -> onnx.ModelProto:
        """The finished model."""
        graph = helper.make_graph(
            self._nodes,
            name,
            [helper.make_tensor_value_info(key, _FLOAT, shape) for key, shape in inputs.items()],
            [helper.make_tensor_value_info(key, _FLOAT, shape) for key, shape in outputs.items()],
            [numpy_helper.from_array(values, key) for key, values in self._constants.items()],
        )
        model = helper.make_model(
            graph, opset_imports=[helper.make_opsetid("", _OPSET)], ir_version=_IR, producer_name="loomlight"
        )
        helper.set_model_props(model, {"network": self.weights.sha256})
        return model


def _trunk(graph: _Graph) -> list[str]:
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


def _block(graph: _Graph, name: str, maps: str, stride: int) -> str:
    has_skip = f"{name}.skip.weight" in graph.weights.tensors
    short = graph.convolution(f"{name}.skip", maps, stride) if has_skip else maps
    inner = graph.add("Relu", graph.convolution(f"{name}.first", maps, stride))
    branch = graph.add("Mul", graph.convolution(f"{name}.second", inner), graph.weight(f"{name}.gain"))
    return graph.add("Relu", graph.add("Add", short, branch))


def _vector_row(graph: _Graph, maps: str) -> str:
    squeezed = graph.add("Relu", graph.convolution("encoder.squeeze", maps))
    return graph.add("Flatten", squeezed, axis=1)


def _field_rows(graph: _Graph, stages: list[str]) -> str:
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
    share = graph.add("Mul", graph.add("Cast", last, to=_FLOAT), graph.number(1 / 8))
    rows.append(_rows(graph, mean, graph.add("Unsqueeze", share, graph.integers([0]))))
    return graph.add("Concat", *rows, axis=0)


def _rows(graph: _Graph, maps: str, level: str) -> str:
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


def _wide_levels(graph: _Graph, picks: str, ends: str) -> str:
    """How many levels of running means this repeat has [1]."""
    largest = graph.add("Mul", graph.add("Max", picks, ends), graph.integers([WHOLE_REPEATS]))
    exists = graph.add("LessOrEqual", graph.integers(_windows()), largest)
    return graph.add(
        "ReduceSum", graph.add("Cast", exists, to=TensorProto.INT64), graph.integers([0]), keepdims=1
    )


def _wide_rows(graph: _Graph, means: str, picks: str, ends: str, threads: str) -> str:
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


def _rolled(graph: _Graph, maps: str, axis: int, extent: str, shift: int) -> str:
    """A periodic map moved by `shift` texels, as numpy.roll does."""
    if shift == 0:
        return maps
    count = graph.add("Squeeze", extent)
    texels = graph.add("Range", graph.integers(0), count, graph.integers(1))
    source = graph.add("Mod", graph.add("Sub", texels, graph.integers(shift)), count)
    return graph.add("Gather", maps, source, axis=axis)


def _join(graph: _Graph, rows: str, output: str) -> None:
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


def _scaled_parameters(graph: _Graph) -> str:
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


def _one_blob(graph: _Graph) -> str:
    centres = (np.arange(BINS) + 0.5) / BINS
    offset = graph.add(
        "Sub", graph.add("Unsqueeze", "place", graph.integers([2])), graph.number(centres[None, None])
    )
    # Positions wrap around, sizes do not.
    periodic = graph.number(np.array([1, 1, 0])[None, :, None])
    offset = graph.add("Sub", offset, graph.add("Mul", graph.add("Round", offset), periodic))
    distance = graph.add("Mul", offset, graph.number(BINS / BLOB_REACH))
    bump = graph.add("Sub", graph.number(1), graph.add("Mul", distance, distance))
    bump = graph.add("Relu", bump)
    return graph.add("Reshape", graph.add("Mul", bump, bump), graph.integers([0, 3 * BINS]))


def _coded_half_vector(graph: _Graph) -> str:
    total = graph.add("Add", "light", "view")
    square = graph.add("ReduceSum", graph.add("Mul", total, total), graph.integers([1]), keepdims=1)
    length = graph.add("Sqrt", graph.add("Add", square, graph.number(OPPOSITE)))
    half = graph.add("Div", total, length)
    half = graph.add("Slice", half, graph.integers([0]), graph.integers([2]), graph.integers([1]))
    # From −1 to 1 in bins; centres lie half a bin beyond edges.
    centres = (np.arange(HALF_BINS) + 0.5) / HALF_BINS * 2 - 1
    offset = graph.add(
        "Sub", graph.add("Unsqueeze", half, graph.integers([2])), graph.number(centres[None, None])
    )
    distance = graph.add("Mul", offset, graph.number(HALF_BINS / HALF_REACH / 2))
    bump = graph.add("Relu", graph.add("Sub", graph.number(1), graph.add("Mul", distance, distance)))
    return graph.add("Reshape", graph.add("Mul", bump, bump), graph.integers([0, 2 * HALF_BINS]))


def _unmapped(graph: _Graph, output: str) -> None:
    """Components of what the network puts out: `losses.unmapped`."""
    height = graph.add("Slice", "light", graph.integers([2]), graph.integers([3]), graph.integers([1]))
    inverse = graph.add(
        "Where",
        graph.add("Greater", height, graph.number(0)),
        graph.number(1 / REFLECTION_GAIN),
        graph.number(1 / TRANSMISSION_GAIN),
    )
    clipped = graph.add("Clip", output, graph.number(0), graph.number(LARGEST_OUTPUT))
    linear = graph.add("Mul", graph.add("Sub", graph.add("Exp", clipped), graph.number(1)), inverse)
    if graph.weights.linear_diffuse:
        split = graph.integers([2])
        axis = graph.integers([1])
        diffuse = graph.add("Relu", graph.add("Slice", output, graph.integers([0]), split, axis))
        specular = graph.add("Slice", linear, split, graph.integers([4]), axis)
        graph.add("Concat", diffuse, specular, axis=1, output="components")
    else:
        graph.add("Identity", linear, output="components")
