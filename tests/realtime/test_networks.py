"""Layers in memory, and `MLP<…>` in Slang against NumPy.

Covers: realtime/words.py
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.realtime.words import NumberTable, layer_size, packed_layer, packed_mlp, packed_numbers
from tests.helpers.parity import share_beyond
from tests.helpers.slang import mapped

COUNT = 2048
# Inputs, width, hidden layers and outputs: of NeuMIP and of latent materials, and of odd sizes.
SHAPES = {"4 × 25": (7, 25, 4, 3), "2 × 32": (14, 32, 2, 4), "3 × 64": (9, 64, 3, 4), "odd": (3, 5, 1, 1)}
Layers = list[NDArray[np.float32]]


def network(shape: tuple[int, int, int, int]) -> tuple[Layers, Layers]:
    """Weights that halves hold exactly, and biases."""
    rng = np.random.default_rng(5)
    inputs, width, hidden, outputs = shape
    sizes = [inputs, *[width] * hidden, outputs]
    weights = [
        np.float32(np.float16(rng.normal(0, np.sqrt(2 / before), (after, before))))
        for before, after in pairwise(sizes)
    ]
    return weights, [np.float32(np.float16(rng.normal(0, 0.2, size))) for size in sizes[1:]]


def evaluated(weights: Layers, biases: Layers, rows: NDArray[np.float32]) -> NDArray[np.float32]:
    for number, (weight, bias) in enumerate(zip(weights, biases, strict=True)):
        rows = rows @ weight.T + bias
        if number + 1 < len(weights):
            rows = np.maximum(rows, np.float32(0.01) * rows)
    return rows


# One shape of each further storage tells whether it is read right.
CASES = [*((name, "half") for name in SHAPES), ("odd", "float"), ("4 × 25", "shared")]


@pytest.mark.quick("odd-float", "odd-half")
@pytest.mark.parametrize(("name", "storage"), CASES)
def test_networks_are_numpys(name: str, storage: str) -> None:
    """Weights as halves or singles in a buffer, and as halves in the memory of a workgroup."""
    shape = SHAPES[name]
    inputs, width, hidden, outputs = shape
    weights, biases = network(shape)
    x = np.float32(np.random.default_rng(6).uniform(-1, 1, COUNT))
    kind = {"half": "HalfWeights", "float": "FloatWeights", "shared": "SharedWeights"}[storage]
    elements = packed_mlp(weights, biases, half=storage != "float")
    body = (
        f"float a[{inputs}]; float b[{outputs}];"
        f"for (int k = 0; k < {inputs}; k++) a[k] = x * float(k + 1);"
        f"MLP<{inputs}, {width}, {hidden}, {outputs}, {kind}, LeakyRelu> net;"
        "net.weights.first = 0u; net.evaluate(a, b);"
    )
    results = ";".join(f"b[{k}]" for k in range(outputs))
    prologue = f"load_shared(0u, {len(elements)}u, id.x % 64u, 64u);" if storage == "shared" else ""
    found = mapped(
        "mlp shared_weights",
        body,
        results,
        {"x": x},
        buffers={"packed_numbers": elements},
        prologue=prologue,
    )
    rows = x[:, None] * np.arange(1, inputs + 1, dtype=np.float32)
    assert share_beyond(found, evaluated(weights, biases, rows)) == 0


@pytest.mark.parametrize(("inputs", "outputs"), [(7, 25), (96, 52), (8, 4), (1, 1), (100, 16)])
def test_a_layer_takes_the_size_that_is_told(inputs: int, outputs: int) -> None:
    weight = np.ones((outputs, inputs))
    halves, singles = packed_layer(weight), packed_layer(weight, half=False)
    assert len(halves) == layer_size(inputs, outputs)
    assert len(singles) == 2 * len(halves)
    assert halves.view(np.float16).sum() == singles.view(np.float32).sum() == weight.size


def test_halves_keep_their_order() -> None:
    numbers = np.arange(16.0)
    np.testing.assert_array_equal(packed_numbers(numbers).view(np.float16).ravel(), numbers)
    np.testing.assert_array_equal(packed_numbers(numbers, half=False).view(np.float32).ravel(), numbers)


def test_parts_stand_one_behind_the_other() -> None:
    table = NumberTable()
    assert table.elements().shape == (1, 4)
    assert table.add(np.ones((3, 4), np.uint32)) == 0
    assert table.add(np.full((2, 4), 2, np.uint32)) == 3
    assert table.elements()[:, 0].tolist() == [1, 1, 1, 2, 2]


def test_layers_that_do_not_fit_are_an_error() -> None:
    with pytest.raises(ValueError, match="outputs of the one before"):
        packed_mlp([np.ones((4, 3)), np.ones((2, 5))], [np.ones(4), np.ones(2)])
