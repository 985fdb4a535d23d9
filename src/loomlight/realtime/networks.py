"""Networks as shaders read them: elements of four 32-bit words that hold eight halves or four singles.

`shaders/mlp.slang` describes a layer in memory; this module writes it. Weights of shipped networks are half
precision in their files too, so that storing halves rounds nothing.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:  # networks need llvmlite; tables without one are packed by this module too
    from loomlight.models.networks import Layers

# Outputs that a shader sums at a time, and numbers that it reads at a time.
TILE, EIGHT = 4, 8
# Parts of a layer begin at multiples of so many elements of halves: 64 bytes.
_PART = 4

Elements: TypeAlias = NDArray[np.uint32]
"""Elements of a buffer of packed numbers [n, 4]."""


def _up(count: int, multiple: int) -> int:
    return -(-count // multiple) * multiple


def layer_size(inputs: int, outputs: int) -> int:
    """Size of a layer in eights of numbers: elements of halves, pairs of elements of singles."""
    matrix = _up(outputs, TILE) * (_up(inputs, EIGHT) // EIGHT)
    return _up(_up(outputs, EIGHT) // EIGHT, _PART) + _up(matrix, _PART)


def packed_numbers(numbers: NDArray[np.floating], half: bool = True) -> Elements:
    """Numbers [..., 8 n] as elements.

    Args:
        half: in half precision, eight an element; else in single precision, four an element.
    """
    kind = np.dtype("<f2" if half else "<f4")
    return np.ascontiguousarray(numbers, kind).view("<u4").astype(np.uint32).reshape(-1, 4)


def packed_layer(
    weight: NDArray[np.floating], bias: NDArray[np.floating] | None = None, half: bool = True
) -> Elements:
    """A layer in memory.

    Args:
        weight: [outputs, inputs].
        bias: [outputs]; without it sums begin at 0.
        half: in half precision, else in single precision.
    """
    outputs, inputs = weight.shape
    matrix = np.zeros((_up(outputs, TILE), _up(inputs, EIGHT)))
    matrix[:outputs, :inputs] = weight
    biases = np.zeros(_up(_up(outputs, EIGHT), _PART * EIGHT))
    biases[:outputs] = 0 if bias is None else bias
    numbers = np.concatenate([biases, matrix.ravel()])
    numbers = np.pad(numbers, (0, layer_size(inputs, outputs) * EIGHT - numbers.size))
    return packed_numbers(numbers, half)


def packed_mlp(
    weights: Sequence[NDArray[np.floating]], biases: Sequence[NDArray[np.floating]], half: bool = True
) -> Elements:
    """The layers of `MLP<…>`, one behind the other.

    Args:
        weights: [outputs, inputs] of each layer.
        biases: [outputs] of each layer.

    Raises:
        ValueError: layers that do not fit each other.
    """
    if any(after.shape[1] != before.shape[0] for before, after in pairwise(weights)):
        raise ValueError("the inputs of each layer are the outputs of the one before")
    return np.concatenate([packed_layer(w, b, half) for w, b in zip(weights, biases, strict=True)])


class NumberTable:
    """Elements of networks and latents, one part behind the other."""

    def __init__(self) -> None:
        self._parts: list[Elements] = []
        self.size = 0

    def add(self, elements: Elements) -> int:
        """Appends a part; the index of its first element."""
        first = self.size
        self._parts.append(elements)
        self.size += len(elements)
        return first

    def add_mlp(self, layers: Layers) -> int:
        """Appends the layers of `MLP<…>` in single precision; the index of the first element."""
        matrices, biases = zip(*layers, strict=True)
        return self.add(packed_mlp(matrices, biases, half=False))

    def elements(self) -> Elements:
        """All of them; at least one, as no buffer is empty."""
        return np.concatenate(self._parts) if self._parts else np.zeros((1, 4), np.uint32)
