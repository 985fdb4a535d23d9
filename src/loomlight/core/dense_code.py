"""Dense layers as code of `lane_code`: a block's sums stay in registers while weights stream past.

A layer is computed some outputs at a time, for all queries of a block. Each weight is loaded once and
multiplied into all vectors of the block; each input is loaded once for all these outputs. So loads are fewer
than multiply-adds, and code is a short loop, which a processor reads far faster than straight-line code of
all weights.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from llvmlite import ir
from numpy.typing import NDArray

from loomlight.core.lane_code import Code, Rows, Vectors
from loomlight.core.lane_values import FLOAT, INDEX, Lanes


@dataclass(frozen=True)
class Dense:
    """A layer among packed numbers.

    Attributes:
        first: where its numbers begin.
        inputs: of the layer.
        tiles: of outputs that are summed at once.
    """

    first: int
    inputs: int
    tiles: int

    def rows(self, vectors: Vectors) -> int:
        """Rows that are written: outputs, and others up to a whole tile, which mean nothing."""
        return self.tiles * vectors.sums


class Packed:
    """Layers in the order in which code reads them.

    Attributes:
        layers: by name.
    """

    def __init__(self, vectors: Vectors) -> None:
        self._vectors = vectors
        self._parts: list[NDArray[np.float32]] = []
        self._count = 0
        self.layers: dict[str, Dense] = {}

    def add(self, name: str, weight: NDArray[np.floating], bias: NDArray[np.floating] | None = None) -> Dense:
        """Adds a layer: weights [outputs, inputs] and, unless sums begin elsewhere, biases [outputs]."""
        outputs, inputs = weight.shape
        tiles, sums = -(-outputs // self._vectors.sums), self._vectors.sums
        padding = tiles * sums - outputs
        rows = np.pad(np.zeros(outputs) if bias is None else bias, (0, padding))
        tiled = np.pad(weight, ((0, padding), (0, 0))).reshape(tiles, sums, inputs).transpose(0, 2, 1)
        # A tile's biases, then its weights, input after input.
        part = np.concatenate([rows.reshape(tiles, 1, sums), tiled], axis=1).astype(np.float32)
        layer = self.layers[name] = Dense(self._count, inputs, tiles)
        self._parts.append(part.ravel())
        self._count += part.size
        return layer

    def numbers(self) -> NDArray[np.float32]:
        """All layers."""
        return np.concatenate(self._parts)


def dense(
    code: Code,
    numbers: ir.Value,
    layer: Dense,
    inputs: Rows,
    outputs: Rows,
    start: Rows | None = None,
    slope: float | None = None,
) -> None:
    """Writes a layer, within `Code.blocks`.

    Args:
        numbers: where packed layers lie.
        outputs: rows to be written, `Dense.rows` of them.
        start: rows to which products are added; the layer's biases without.
        slope: of the leaky ReLU of what comes out, if any.
    """
    name = f"dense{'' if start is None else '_added'}{'' if slope is None else '_leaky'}"
    if not code.has(name):
        _write(code, name, start is not None, slope)
    begin = outputs if start is None else start
    arguments = [
        outputs.pointer,
        inputs.pointer,
        code.element(numbers, layer.first),
        begin.pointer,
        INDEX(layer.inputs),
        INDEX(layer.tiles),
    ]
    code.call(name, arguments)


def _write(code: Code, name: str, added: bool, slope: float | None) -> None:
    """The function of all layers of one kind."""
    pointer = FLOAT.as_pointer()
    with code.function(name, [pointer, pointer, pointer, pointer, INDEX, INDEX]) as arguments:
        outputs, inputs, numbers, start, count, tiles = arguments
        vectors, builder = code.vectors, code.builder
        block, sums = vectors.block, vectors.sums
        places = [(number, k * vectors.lanes) for number in range(sums) for k in range(vectors.of_block)]
        with code.loop(tiles) as tile:
            size = builder.mul(builder.add(count, INDEX(1)), INDEX(sums))
            own = code.element(numbers, builder.mul(tile, size))
            row = code.times(tile, sums * block)
            target, begin = code.element(outputs, row), code.element(start, row)
            if added:
                first = [code.load(code.element(begin, number * block + lane)) for number, lane in places]
            else:
                biases = [code.shared(own, number) for number in range(sums)]
                first = [biases[number] for number, _ in places]
            found = _multiplied(code, first, inputs, code.element(own, sums), count)
            for (number, lane), total in zip(places, found, strict=True):
                if slope is not None:
                    total = code.maximum(total, total * slope)
                code.store(total, code.element(target, number * block + lane))


def _multiplied(
    code: Code, first: list[Lanes], inputs: ir.Value, weights: ir.Value, count: ir.Value
) -> list[Lanes]:
    """Sums of a tile, output after output and for each all vectors, after all inputs."""
    builder, vectors = code.builder, code.vectors
    before = builder.block
    with code.loop(count) as number:
        sums = [builder.phi(lanes.value.type) for lanes in first]
        for total, lanes in zip(sums, first, strict=True):
            total.add_incoming(lanes.value, before)
        row = code.element(inputs, code.times(number, vectors.block))
        values = [code.load(code.element(row, k * vectors.lanes)) for k in range(vectors.of_block)]
        column = code.element(weights, code.times(number, vectors.sums))
        found: list[Lanes] = []
        for output in range(vectors.sums):
            weight = code.shared(column, output)
            for value in values:
                found.append(code.fma(weight, value, Lanes(code, sums[len(found)])))
        for total, lanes in zip(sums, found, strict=True):
            total.add_incoming(lanes.value, builder.block)
    return found
