"""The decoder as an ONNX model, for any runtime.

It holds queries in the last axis, [1, channels, 1, n], where layers are convolutions of one place, so that a
session that knows n keeps them in blocks of channels from the first layer to the last.
"""

from __future__ import annotations

import numpy as np
import onnx
from numpy.typing import NDArray

from loomlight.models.woven.architecture import (
    BINS,
    BLOB_REACH,
    BUNDLE_UNIT,
    BUNDLES,
    DENSITY_GAIN,
    DENSITY_SCALE,
    INCLINATION_BINS,
    INCLINATION_CROWDING,
    INCLINATION_REACH,
    LARGEST_OUTPUT,
    OPPOSITE,
    REFLECTION_GAIN,
    TRANSMISSION_GAIN,
)
from loomlight.models.woven.config import NetworkTable
from loomlight.models.woven.onnx_graph import Graph
from loomlight.models.woven.places import own_share
from loomlight.models.woven.weights import Weights

# Bins beyond either end that a position within the reach of the other end meets.
_AROUND = 2


def decoder_graph(weights: Weights) -> onnx.ModelProto:
    """The decoder of n queries for any runtime.

    `latent` [n, latent_size], `place` [n, 3], `light` and `view` [n, 3] in the frame of the face that is
    seen, and for networks that take them `fibres` [n, 2, 3] of that face (`Fibres.face`) and `bundles`
    [n or 1, 2, `BUNDLES`, 4] (`Fibres.bundles`), and with these `correction` [2 · `BUNDLES`, hidden + 1] of
    the fabric (`EncodedFabric`; zeros where there is none), to `components` [n, 4], 1/sr, and `hole` [n],
    0 to 1.
    """
    graph = Graph(weights)
    spatial, hole, angles, inclinations, light, view = _coded(graph)
    hidden = _hidden(graph, spatial, angles, inclinations)
    output = _last(graph, hidden)
    if weights.table.bundles:
        flat = graph.integers([1, -1])
        size, height = (
            graph.add("Reshape", _sliced(graph, _channels_first(graph, name, 3), 2, 3), flat)
            for name in ("place", "light")
        )
        first, rise = _own_slope()
        share = graph.add("Mul", graph.add("Sub", size, graph.number(first)), graph.number(rise))
        share = graph.add("Clip", share, graph.number(0), graph.number(1))
        lit = graph.add("Greater", height, graph.number(0))
        share = graph.add("Where", lit, share, graph.number(0))
        output = _corrected(graph, output, hidden, share)
    components = _components(graph, output, light, view)
    rows = graph.add("Reshape", components, graph.integers([4, -1]))
    graph.add("Transpose", rows, perm=[1, 0], output="components")
    hole = graph.add("Clip", hole, graph.number(0), graph.number(1))
    graph.add("Reshape", hole, graph.integers([-1]), output="hole")
    inputs = _inputs(weights.table)
    if weights.table.bundles:
        inputs |= {"bundles": ["m", 2, BUNDLES, 4], "correction": [*weights.table.corrected_shape]}
    return graph.model("woven_decoder", inputs, {"components": ["n", 4], "hole": ["n"]})


def _inputs(table: NetworkTable) -> dict[str, list[str | int]]:
    inputs: dict[str, list[str | int]] = {
        "latent": ["n", table.latent_size],
        "place": ["n", 3],
        "light": ["n", 3],
        "view": ["n", 3],
    }
    if table.fibres:
        inputs["fibres"] = ["n", 2, 3]
    return inputs


def _own_slope() -> tuple[float, float]:
    """Where `places.own_share` begins to rise, and how fast."""
    rising = own_share(np.array([0.5, 0.6]), _Straight)
    rise = float(rising[1] - rising[0]) / 0.1
    return 0.5 - float(rising[0]) / rise, rise


class _Straight:
    """Arrays that are not clipped."""

    @staticmethod
    def clip(values: NDArray[np.floating], _low: float, _high: float) -> NDArray[np.floating]:
        return values


def _coded(graph: Graph) -> tuple[str, str, str, str, str, str]:
    """What is fused, holes, angles, inclinations, light and view of the inputs of `decoder_graph`."""
    weights = graph.weights
    size = weights.table.latent_size
    latent, place, light, view = (
        _channels_first(graph, name, count)
        for name, count in (("latent", size), ("place", 3), ("light", 3), ("view", 3))
    )
    if weights.table.fusion:
        first = weights.tensor("decoder.fusion.0.weight")[:, :size]
        latent = _dense(graph, latent, first, weights.tensor("decoder.fusion.0.bias"))
    angles = graph.add("Concat", light, _sliced(graph, view, 0, 2), axis=1)
    inclinations = ""
    if weights.table.fibres:
        cosines, inclinations, densities = _along_fibres(graph, light, view)
        angles = graph.add("Concat", angles, *cosines, densities, axis=1)
    if weights.table.position == "one_blob":
        place = _with_squares(graph, graph.add("Sub", place, graph.number(0.5)))
    spatial, hole = _layers(graph, latent, place, angles)
    return spatial, hole, angles, inclinations, light, view


def _channels_first(graph: Graph, name: str, count: int) -> str:
    columns = graph.add("Transpose", name, perm=[1, 0])
    return graph.add("Reshape", columns, graph.integers([1, count, 1, -1]))


def _layers(graph: Graph, latent: str, place: str, angles: str) -> tuple[str, str]:
    """What is fused [1, channels, 1, n], and what the network puts out of holes [1, 1, 1, n].

    Args:
        latent: multiplied by the first layer where there is fusion.
        place: [1, 3, 1, n], or for networks with one-blob coding [1, 6, 1, n] less a half and followed by
            squares.
        angles: x, y, z of the light and x and y of the view [1, 5, 1, n]; for networks that take fibres six
            more, of both families each, in the order of `network.fibre_features`: cosines of views, of
            lights, densities [1, 11, 1, n].
    """
    weights = graph.weights
    table, tensor = weights.table, weights.tensor
    coded = _one_blob(graph, place) if table.position == "one_blob" else place
    if table.fusion:
        first = tensor("decoder.fusion.0.weight")[:, table.latent_size :]
        placed = _dense(graph, coded, _of_coded(table, first))
        spatial = _layer(graph, "decoder.fusion.1", graph.leaky(graph.add("Add", latent, placed)), leaky=True)
    else:
        spatial = graph.add("Concat", latent, coded, axis=1)
    weight, bias = tensor("decoder.hole.0.weight"), tensor("decoder.hole.0.bias")
    of_spatial, of_view = weight[:, :-2], weight[:, -2:]
    seen = _dense(graph, angles, np.pad(of_view, ((0, 0), (3, 6 if table.fibres else 0))))
    hole = _dense(graph, spatial, _of_spatial(table, of_spatial), bias, seen, leaky=True)
    return spatial, _layer(graph, "decoder.hole.1", hole)


def _last(graph: Graph, hidden: str) -> str:
    """What the last of the angular layers puts out [1, outputs, 1, n]."""
    return _layer(graph, f"decoder.angular.{graph.weights.layers('decoder.angular') - 1}", hidden)


def _corrected(graph: Graph, output: str, hidden: str, share: str) -> str:
    """What is put out [1, outputs, 1, n], with the fabric's own correction for shares of it [1, n]."""
    table = graph.weights.table
    columns = graph.add("Reshape", hidden, graph.integers([table.hidden, -1]))
    axis, width = graph.integers([1]), table.hidden
    weight, bias = (
        graph.add("Slice", "correction", graph.integers([first]), graph.integers([end]), axis)
        for first, end in ((0, width), (width, width + 1))
    )
    added = graph.add("Mul", graph.add("Add", graph.add("MatMul", weight, columns), bias), share)
    shares = graph.add("Add", _sliced(graph, output, 2, table.outputs), _rows(graph, added))
    return graph.add("Concat", _sliced(graph, output, 0, 2), shares, axis=1)


def _hidden(graph: Graph, spatial: str, angles: str, inclinations: str) -> str:
    """What the last of the angular layers takes [1, hidden, 1, n].

    Args:
        inclinations: of both families, and their squares [1, 4, 1, n], where networks take fibres.
    """
    weights, table = graph.weights, graph.weights.table
    weight, bias = (weights.tensor(f"decoder.angular.0.{part}") for part in ("weight", "bias"))
    width = weights.tensor("decoder.hole.0.weight").shape[1] - 2
    of_spatial, of_angles, of_fibres = np.split(weight, [width, width + 5], axis=1)
    if table.fibres:
        of_cosines, of_bins, of_densities = np.split(of_fibres, [4, 4 + 2 * INCLINATION_BINS], axis=1)
        skip = _dense(graph, angles, np.concatenate([of_angles, of_cosines, of_densities], axis=1), bias)
        skip = _dense(graph, _coded_inclinations(graph, inclinations), of_bins, plus=skip)
    else:
        skip = _dense(graph, angles, of_angles, bias)
    skip = _dense(graph, spatial, _of_spatial(table, of_spatial), plus=skip)
    hidden = graph.leaky(skip)
    count = weights.layers("decoder.angular")
    for number in range(1, count - 1):
        plus = skip if number == 2 else None
        hidden = _layer(graph, f"decoder.angular.{number}", hidden, plus, leaky=True)
    return hidden


def _layer(graph: Graph, name: str, value: str, plus: str | None = None, leaky: bool = False) -> str:
    weight, bias = (graph.weights.tensor(f"{name}.{part}") for part in ("weight", "bias"))
    return _dense(graph, value, weight, bias, plus, leaky)


def _dense(
    graph: Graph,
    value: str,
    weight: NDArray[np.floating],
    bias: NDArray[np.floating] | None = None,
    plus: str | None = None,
    leaky: bool = False,
) -> str:
    """A layer of weights [outputs, inputs], what is added to it, and its activation."""
    rest = [] if bias is None else [graph.number(bias)]
    found = graph.add("Conv", value, graph.number(weight[:, :, None, None]), *rest, kernel_shape=[1, 1])
    if plus is not None:
        found = graph.add("Add", found, plus)
    return graph.leaky(found) if leaky else found


def _sliced(graph: Graph, value: str, first: int, end: int) -> str:
    """Some of the channels."""
    return graph.add("Slice", value, graph.integers([first]), graph.integers([end]), graph.integers([1]))


def _of_spatial(table: NetworkTable, weight: NDArray[np.float32]) -> NDArray[np.float32]:
    """Weights over what is fused, or over latent and coded place."""
    if table.fusion:
        return weight
    latent, coded = np.split(weight, [table.latent_size], axis=1)
    return np.concatenate([latent, _of_coded(table, coded)], axis=1)


def _of_coded(table: NetworkTable, weight: NDArray[np.float32]) -> NDArray[np.float32]:
    """Weights over the coded place, whose bins beyond the ends are those that lie there, a period away."""
    if table.position == "plain":
        return weight
    x, y, size = np.split(weight, 3, axis=1)
    around = [np.concatenate([bins[:, -_AROUND:], bins, bins[:, :_AROUND]], axis=1) for bins in (x, y)]
    return np.concatenate([*around, size], axis=1)


def _one_blob(graph: Graph, place: str) -> str:
    """`network.one_blob`, where positions wrap around by bins beyond the ends: see `_of_coded`."""
    inner, wider = ((np.arange(-more, BINS + more) + 0.5) / BINS - 0.5 for more in (0, _AROUND))
    return _bumps(graph, place, [wider, wider, inner], BINS / BLOB_REACH)


def _along_fibres(graph: Graph, light: str, view: str) -> tuple[list[str], str, str]:
    """Cosines of view and light with the fibres, inclinations and their squares, densities; see
    `network.fibre_features`."""
    turned = graph.add("Transpose", "fibres", perm=[2, 1, 0])
    x, y, roughness = (
        graph.add("Reshape", _first_axis(graph, turned, k), graph.integers([1, 2, 1, -1])) for k in range(3)
    )

    def cosine(direction: str) -> str:
        parts = (_sliced(graph, direction, k, k + 1) for k in range(2))
        along = [graph.add("Mul", axis, part) for axis, part in zip((x, y), parts, strict=True)]
        return graph.add("Add", *along)

    def squared(value: str) -> str:
        return graph.add("Mul", value, value)

    cosines = [cosine(view), cosine(light)]
    total, half = graph.add("Add", light, view), graph.add("Add", *cosines)
    square, opposite = squared(half), graph.number(OPPOSITE)
    height = graph.add("Add", squared(_sliced(graph, total, 2, 3)), opposite)
    reach = graph.add("Sqrt", graph.add("Add", square, height))
    wide = graph.add("Mul", reach, graph.number(INCLINATION_CROWDING))
    raised = graph.add("Mul", half, graph.number(1 + INCLINATION_CROWDING))
    inclination = graph.add("Div", raised, graph.add("Add", graph.add("Abs", half), wide))
    length = graph.add("ReduceSum", squared(total), graph.integers([1]), keepdims=1)
    flat = graph.add("Div", square, graph.add("Add", length, opposite))
    squared_roughness = squared(roughness)
    rest = graph.add("Sub", graph.number(1), squared_roughness)
    q = graph.add("Add", squared_roughness, graph.add("Mul", flat, rest))
    scale = graph.add(
        "Mul", graph.add("Mul", squared_roughness, roughness), graph.number(DENSITY_GAIN / np.pi)
    )
    density = graph.add("Add", graph.number(1), graph.add("Div", scale, squared(q)))
    logarithm = graph.add("Mul", graph.add("Log", density), graph.number(DENSITY_SCALE))
    return cosines, _with_squares(graph, inclination), logarithm


def _first_axis(graph: Graph, value: str, number: int) -> str:
    """One entry along the first axis."""
    return graph.add("Gather", value, graph.integers([number]), axis=0)


def _coded_inclinations(graph: Graph, inclinations: str) -> str:
    """Bins of `network.fibre_features`."""
    # From −1 to 1 in bins; centres lie half a bin beyond edges.
    centres = (np.arange(INCLINATION_BINS) + 0.5) / INCLINATION_BINS * 2 - 1
    return _bumps(graph, inclinations, [centres, centres], INCLINATION_BINS / INCLINATION_REACH / 2)


def _with_squares(graph: Graph, values: str) -> str:
    return graph.add("Concat", values, graph.add("Mul", values, values), axis=1)


def _bumps(graph: Graph, values: str, centres: list[NDArray[np.float64]], scale: float) -> str:
    """max(1 − d², 0)² of each value's distances d from its centres, where squares follow the values.

    1 − d² is linear in a value and its square, so it is a layer; values about 0 leave it exact to 1e-6.
    """
    of_value = np.repeat(np.eye(len(centres)), [len(part) for part in centres], axis=0)
    centre = np.concatenate(centres)
    weight = scale**2 * np.concatenate([2 * centre[:, None] * of_value, -of_value], axis=1)
    bump = graph.add("Relu", _dense(graph, values, weight, 1 - (scale * centre) ** 2))
    return graph.add("Mul", bump, bump)


def _components(graph: Graph, output: str, light: str, view: str) -> str:
    """Components [1, 4, 1, n] of what the network puts out."""
    if not graph.weights.table.bundles:
        return _unmapped(graph, output, light)
    shares = _sliced(graph, output, 2, graph.weights.table.outputs)
    total = graph.add("Add", light, view)
    square = graph.add("ReduceSum", graph.add("Mul", total, total), graph.integers([1]), keepdims=1)
    half = graph.add("Div", total, graph.add("Sqrt", graph.add("Add", square, graph.number(OPPOSITE))))
    columns = graph.add("Transpose", half, perm=[3, 1, 2, 0])
    columns = graph.add("Reshape", columns, graph.integers([-1, 3, 1]))
    bundles = graph.add("Reshape", "bundles", graph.integers([-1, 2 * BUNDLES, 4]))
    axes, widths = (
        graph.add("Slice", bundles, graph.integers([first]), graph.integers([end]), graph.integers([2]))
        for first, end in ((0, 3), (3, 4))
    )
    cosines, widths = (
        _rows(graph, graph.add("Transpose", rows, perm=[2, 1, 0]))
        for rows in (graph.add("MatMul", axes, columns), widths)
    )
    specular = _mixed(graph, shares, cosines, widths)
    most = graph.add("Mul", _inverse_gain(graph, light), graph.number(np.expm1(LARGEST_OUTPUT)))
    specular = graph.add("Min", graph.add("Relu", specular), most)
    return graph.add("Concat", _unmapped(graph, _sliced(graph, output, 0, 2), light), specular, axis=1)


def _rows(graph: Graph, values: str) -> str:
    """A number of each bundle and query as [1, 2 · `BUNDLES`, 1, n]."""
    return graph.add("Reshape", values, graph.integers([1, 2 * BUNDLES, 1, -1]))


def _mixed(graph: Graph, shares: str, cosines: str, widths: str) -> str:
    """`network.mixed_bundles` [1, 2, 1, n]."""
    root = graph.add("Add", graph.add("Mul", cosines, cosines), widths)
    lit = graph.add("Div", graph.leaky(shares), graph.add("Mul", root, root))
    return _dense(graph, lit, np.kron(np.eye(2), np.full((1, BUNDLES), BUNDLE_UNIT)))


def _inverse_gain(graph: Graph, light: str) -> str:
    """1/k of `losses.gain` [1, 1, 1, n]."""
    return graph.add(
        "Where",
        graph.add("Greater", _sliced(graph, light, 2, 3), graph.number(0)),
        graph.number(1 / REFLECTION_GAIN),
        graph.number(1 / TRANSMISSION_GAIN),
    )


def _unmapped(graph: Graph, output: str, light: str) -> str:
    """Components of what the network puts out: `losses.unmapped`."""
    inverse = _inverse_gain(graph, light)
    clipped = graph.add("Clip", output, graph.number(0), graph.number(LARGEST_OUTPUT))
    linear = graph.add("Mul", graph.add("Sub", graph.add("Exp", clipped), graph.number(1)), inverse)
    if not graph.weights.linear_diffuse:
        return linear
    diffuse = graph.add("Relu", _sliced(graph, output, 0, 2))
    return graph.add("Concat", diffuse, _sliced(graph, linear, 2, 4), axis=1)
