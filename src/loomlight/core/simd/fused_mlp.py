"""Fused multilayer perceptrons: all layers of a block of queries, one after another, in the nearest cache.

A dense layer is computed a tile of outputs at a time. Each weight is loaded once and multiplied into all
vectors of the block; each input is loaded once for all outputs of the tile; the sums of the tile stay in
registers. The code is a short loop over inputs, whatever the size of the layer: weights are data.

`FusedMlp` is a whole network. `PackedLayers`, `emit_dense` and `emit_activation` build other kernels, which
fetch or encode features before the first layer.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import Literal, TypeAlias

import numpy as np
from llvmlite import ir
from numpy.typing import NDArray

from loomlight.core.arrays import Float, FloatType
from loomlight.core.simd.drjit_bridge import call_kernel
from loomlight.core.simd.jit import CompiledKernel, Floats, host_target
from loomlight.core.simd.kernel_builder import BlockBuffer, KernelBuilder, SimdTarget
from loomlight.core.simd.values import Index, SimdValue

Activation: TypeAlias = Literal["none", "relu", "leaky_relu", "exp"]

# Cost of a multiply-add and of a load of a vector, relative; sums of fewer multiply-adds wait for each other.
_MULTIPLY_ADD, _LOAD, _PIPELINED = 1.0, 0.5, 8


@dataclass(frozen=True)
class PackedLayer:
    """Where the weights of a dense layer lie among `PackedLayers.weights`, and how it is tiled.

    Attributes:
        offset: of its first number.
        inputs, outputs: widths of the layer.
        tile: outputs that are computed at a time.
    """

    offset: int
    inputs: int
    outputs: int
    tile: int

    @property
    def tiles(self) -> int:
        """Tiles of the layer; the last one may compute outputs that mean nothing."""
        return -(-self.outputs // self.tile)

    @property
    def channels(self) -> int:
        """Channels that are written: whole tiles."""
        return self.tiles * self.tile

    @property
    def size(self) -> int:
        """Numbers among the packed weights."""
        return self.channels * (self.inputs + 1)


class PackedLayers:
    """Layers in the order of memory in which kernels read them.

    Attributes:
        layers: by name.
    """

    def __init__(self, target: SimdTarget) -> None:
        self._target = target
        self._parts: list[Floats] = []
        self._size = 0
        self.layers: dict[str, PackedLayer] = {}

    def add(
        self, name: str, weight: NDArray[np.floating], bias: NDArray[np.floating] | None = None
    ) -> PackedLayer:
        """Appends a layer.

        Args:
            weight: [outputs, inputs].
            bias: [outputs]; without it sums begin at 0, or at the `initial` channels of `emit_dense`.
        """
        outputs, inputs = weight.shape
        layer = PackedLayer(self._size, inputs, outputs, tile_size(outputs, self._target))
        padding = layer.channels - outputs
        biases = np.pad(np.zeros(outputs) if bias is None else bias, (0, padding))
        tiled = np.pad(weight, ((0, padding), (0, 0))).reshape(layer.tiles, layer.tile, inputs)
        # A tile is its biases, then its weights, input after input.
        part = np.concatenate(
            [biases.reshape(layer.tiles, 1, layer.tile), tiled.transpose(0, 2, 1)], axis=1, dtype=np.float32
        )
        self.layers[name] = layer
        self._parts.append(part.ravel())
        self._size += layer.size
        return layer

    def weights(self) -> Floats:
        """All layers, one after another."""
        return np.concatenate(self._parts)


def tile_size(outputs: int, target: SimdTarget) -> int:
    """Number of outputs of a layer computed at a time: few wasted ones against few loads."""

    def cost(tile: int) -> float:
        multiply_adds = max(tile * target.vectors_per_block, _PIPELINED)
        loads = tile + target.vectors_per_block
        return -(-outputs // tile) * (_MULTIPLY_ADD * multiply_adds + _LOAD * loads)

    return min(range(1, target.max_tile + 1), key=cost)


def emit_dense(
    kernel: KernelBuilder,
    weights: ir.Value,
    layer: PackedLayer,
    inputs: BlockBuffer,
    outputs: BlockBuffer,
    *,
    initial: BlockBuffer | None = None,
    residual: BlockBuffer | None = None,
    activation: Activation = "none",
    slope: float = 0.0,
) -> None:
    """Emits outputs = activation(weights · inputs + bias + residual), within `KernelBuilder.each_block`.

    Args:
        weights: address of the packed layers.
        outputs: `layer.channels` channels, none of them an input; may be `initial` or `residual`.
        initial: channels that sums begin with, in place of the bias.
        residual: channels that are added to the sums.
        slope: of "leaky_relu" below 0, less than 1.

    Raises:
        ValueError: if a buffer has too few channels.
    """
    needed = [(inputs, layer.inputs), *((buffer, layer.channels) for buffer in (outputs, initial, residual))]
    if any(buffer is not None and buffer.channels < channels for buffer, channels in needed):
        raise ValueError(f"buffers need {layer.inputs} inputs and {layer.channels} outputs")

    def body(
        outputs: ir.Value, inputs: ir.Value, weights: ir.Value, initial: ir.Value, residual: ir.Value,
        input_count: ir.Value, tiles: ir.Value,
    ) -> None:  # fmt: skip
        width, tile, block = kernel.target.width, layer.tile, kernel.target.block_size
        places = [(number, lane) for number in range(tile) for lane in range(0, block, width)]
        with kernel.loop(tiles) as tile_index:
            tile_floats = kernel.ir.mul(kernel.ir.add(input_count, kernel.index(1)), kernel.index(tile))
            tile_weights = kernel.element_pointer(weights, kernel.ir.mul(tile_index, tile_floats))
            first = kernel.multiply(tile_index, tile * block)
            output, start, added = (
                kernel.element_pointer(pointer, first) for pointer in (outputs, initial, residual)
            )
            if has_initial:
                sums = [kernel.load(kernel.element_pointer(start, n * block + lane)) for n, lane in places]
            else:
                bias = [kernel.load_broadcast(tile_weights, number) for number in range(tile)]
                sums = [bias[number] for number, _ in places]
            columns = kernel.element_pointer(tile_weights, tile)
            sums = _multiply_add(kernel, sums, inputs, columns, input_count, tile)
            for (number, lane), total in zip(places, sums, strict=True):
                place = number * block + lane
                if has_residual:
                    total = total + kernel.load(kernel.element_pointer(added, place))
                total = _activate(kernel, total, activation, slope)
                kernel.store(total, kernel.element_pointer(output, place))

    has_initial, has_residual = initial is not None, residual is not None
    name = f"dense_{layer.tile}_{has_initial:d}{has_residual:d}_{activation}_{slope}"
    kernel.call(
        name,
        body,
        outputs.pointer,
        inputs.pointer,
        kernel.element_pointer(weights, layer.offset),
        (initial or outputs).pointer,
        (residual or outputs).pointer,
        kernel.index(layer.inputs),
        kernel.index(layer.tiles),
    )


def emit_activation(
    kernel: KernelBuilder,
    inputs: BlockBuffer,
    outputs: BlockBuffer,
    channels: int,
    activation: Activation,
    slope: float = 0.0,
) -> None:
    """Emits outputs = activation(inputs) for so many channels; see `emit_dense`."""
    with kernel.loop(channels) as channel, kernel.each_vector():
        outputs[channel] = _activate(kernel, inputs[channel], activation, slope)


def _activate(kernel: KernelBuilder, value: SimdValue, activation: Activation, slope: float) -> SimdValue:
    math = kernel.math
    match activation:
        case "relu":
            return math.maximum(value, 0)
        case "leaky_relu":  # of a slope below 1
            return math.maximum(value, value * slope)
        case "exp":
            return math.exp(value)
    return value


def _multiply_add(
    kernel: KernelBuilder,
    initial: list[SimdValue],
    inputs: ir.Value,
    columns: ir.Value,
    input_count: Index,
    tile: int,
) -> list[SimdValue]:
    """Sums of a tile [tile · vectors_per_block] over all inputs."""
    width, block = kernel.target.width, kernel.target.block_size
    before = kernel.ir.block
    with kernel.loop(input_count) as number:
        sums = [kernel.ir.phi(value.value.type) for value in initial]
        for total, value in zip(sums, initial, strict=True):
            total.add_incoming(value.value, before)
        row = kernel.element_pointer(inputs, kernel.multiply(number, block))
        values = [kernel.load(kernel.element_pointer(row, lane)) for lane in range(0, block, width)]
        column = kernel.element_pointer(columns, kernel.multiply(number, tile))
        found: list[SimdValue] = []
        for output in range(tile):
            weight = kernel.load_broadcast(column, output)
            for value in values:
                found.append(kernel.math.fma(weight, value, SimdValue(kernel, sums[len(found)])))
        for total, value in zip(sums, found, strict=True):
            total.add_incoming(value.value, kernel.ir.block)
    return found


@dataclass(frozen=True)
class LayerShape:
    """A dense layer without its weights: z = W a + b (+ z of an earlier layer), a' = activation(z).

    Attributes:
        inputs, outputs: widths.
        slope: of "leaky_relu" below 0, less than 1.
        skip_from: number of the earlier layer, of the same width, whose z is added to this one's.
    """

    inputs: int
    outputs: int
    activation: Activation = "none"
    slope: float = 0.01
    skip_from: int | None = None


@dataclass(frozen=True, eq=False)
class DenseLayer:
    """A dense layer of a `FusedMlp`; see `LayerShape`.

    Attributes:
        weight: [outputs, inputs].
        bias: [outputs].
    """

    weight: NDArray[np.floating]
    bias: NDArray[np.floating]
    activation: Activation = "none"
    slope: float = 0.01
    skip_from: int | None = None

    @property
    def shape(self) -> LayerShape:
        """All but the weights."""
        outputs, inputs = self.weight.shape
        return LayerShape(inputs, outputs, self.activation, self.slope, self.skip_from)


class FusedMlp:
    """A multilayer perceptron in float32 on the cores of the host. Networks of one shape share their code.

    Attributes:
        inputs, outputs: numbers of a query and of its result.
        flops: floating-point operations of a query, two for each weight.
    """

    def __init__(self, layers: Sequence[DenseLayer], target: SimdTarget | None = None) -> None:
        """Packs weights and compiles, unless a network of this shape was compiled before.

        Raises:
            ValueError: if widths of neighbouring layers, of a bias or of a skip connection differ.
        """
        shapes = tuple(layer.shape for layer in layers)
        _check(layers, shapes)
        target = target or host_target()
        packed = PackedLayers(target)
        for number, layer in enumerate(layers):
            packed.add(f"{number}", layer.weight, layer.bias)
        self._weights = packed.weights()
        self._kernel = _compiled_mlp(shapes, target)
        self.inputs, self.outputs = shapes[0].inputs, shapes[-1].outputs
        self.flops = 2 * sum(layer.weight.size for layer in layers)

    def evaluate(self, inputs: Floats) -> Floats:
        """Outputs [outputs, n] of queries [inputs, n]."""
        inputs = np.ascontiguousarray(inputs, np.float32)
        outputs = np.empty((self.outputs, inputs.shape[1]), np.float32)
        self.launch([*inputs], [*outputs])
        return outputs

    def launch(self, inputs: Sequence[Floats], outputs: Sequence[Floats]) -> None:
        """Writes outputs, an array [n] each, of inputs, an array [n] each; see `CompiledKernel.launch`."""
        self._kernel.launch(len(inputs[0]), inputs, outputs, [self._weights])

    def call(self, float_type: FloatType, inputs: Sequence[Float]) -> list[Float]:
        """Outputs as Dr.Jit arrays, where `can_use_kernel(float_type, inputs)`."""
        return call_kernel(float_type, inputs, self.outputs, self.launch)


def _check(layers: Sequence[DenseLayer], shapes: Sequence[LayerShape]) -> None:
    for number, (layer, shape) in enumerate(zip(layers, shapes, strict=True)):
        if layer.bias.shape != (shape.outputs,):
            raise ValueError(f"layer {number} needs {shape.outputs} biases, not {layer.bias.shape}")
        if number and shape.inputs != shapes[number - 1].outputs:
            raise ValueError(f"layer {number} needs {shapes[number - 1].outputs} inputs, not {shape.inputs}")
        skip = shape.skip_from
        if skip is not None and not (0 <= skip < number and shapes[skip].outputs == shape.outputs):
            raise ValueError(f"layer {number} cannot add layer {skip}: no earlier one of its width")


@cache
def _compiled_mlp(shapes: tuple[LayerShape, ...], target: SimdTarget) -> CompiledKernel:
    return CompiledKernel(_mlp_kernel(shapes, target))


def _mlp_kernel(shapes: Sequence[LayerShape], target: SimdTarget) -> KernelBuilder:
    """The kernel of networks of one shape."""
    packed = PackedLayers(target)
    layers = [
        packed.add(f"{number}", np.zeros((shape.outputs, shape.inputs)))
        for number, shape in enumerate(shapes)
    ]
    skipped = sorted({shape.skip_from for shape in shapes if shape.skip_from is not None})
    kernel = KernelBuilder("fused_mlp", target, shapes[0].inputs, shapes[-1].outputs)
    # Layers alternate between two buffers, so that more of them fit in the nearest cache.
    most = max(shapes[0].inputs, *(layer.channels for layer in layers))
    current, other = kernel.block_buffer(most), kernel.block_buffer(most)
    sums = {number: kernel.block_buffer(layers[number].channels) for number in skipped}
    with kernel.each_block():
        weights = kernel.uniform_buffer(0).pointer
        with kernel.loop(kernel.inputs) as channel, kernel.each_vector():
            current[channel] = kernel.load_input(channel)
        for number, (shape, layer) in enumerate(zip(shapes, layers, strict=True)):
            residual = None if shape.skip_from is None else sums[shape.skip_from]
            if number in sums:
                emit_dense(kernel, weights, layer, current, sums[number], residual=residual)
                emit_activation(kernel, sums[number], other, shape.outputs, shape.activation, shape.slope)
            else:
                emit_dense(
                    kernel, weights, layer, current, other,
                    residual=residual, activation=shape.activation, slope=shape.slope,
                )  # fmt: skip
            current, other = other, current
        with kernel.loop(kernel.outputs) as channel, kernel.each_vector():
            kernel.store_output(channel, current[channel])
    return kernel
