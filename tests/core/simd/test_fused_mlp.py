"""Fused networks of the shapes in use against numpy in double precision."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from drjit.llvm.ad import Float
from numpy.typing import NDArray

from loomlight.core.llvm import require_llvm
from loomlight.core.simd import (
    Activation,
    CompiledKernel,
    DenseLayer,
    FusedMlp,
    KernelBuilder,
    PackedLayers,
    SimdTarget,
    call_kernel,
    can_use_kernel,
    emit_activation,
    emit_dense,
    fused_mlp,
    host_target,
)
from loomlight.core.simd.fused_mlp import tile_size

from .kernels import TARGETS

require_llvm()
# Hidden layers, their width, inputs, outputs, activations of hidden layers and of the last, and a skip
# connection from the first layer to the third.
SHAPES: dict[str, tuple[int, int, int, int, Activation, Activation, bool]] = {
    "4x25": (4, 25, 10, 3, "relu", "none", False),
    "2x16": (2, 16, 6, 4, "leaky_relu", "exp", False),
    "2x32": (2, 32, 20, 3, "leaky_relu", "exp", False),
    "3x64": (3, 64, 32, 7, "relu", "none", False),
    "5x64 with skip": (5, 64, 40, 12, "leaky_relu", "none", True),
}
# A sum of n products of about 1 in float32 is off by about √n · 6e-8: 5e-7 for layers of 64. Five layers and
# an exponential are off by a few times that.
TOLERANCE = 5e-6


def network(name: str, seed: int = 0) -> list[DenseLayer]:
    """Random weights that keep activations near 1."""
    hidden, width, inputs, outputs, activation, last, skip = SHAPES[name]
    rng = np.random.default_rng(seed)
    widths = [inputs, *[width] * hidden, outputs]
    layers = []
    for number, (before, after) in enumerate(pairwise(widths)):
        weight = rng.normal(size=(after, before)) * np.sqrt(2 / before)
        bias = 0.1 * rng.normal(size=after)
        is_last = number == hidden
        skip_from = 0 if skip and number == 2 else None
        layers.append(DenseLayer(weight, bias, last if is_last else activation, 0.1, skip_from))
    return layers


def reference(layers: list[DenseLayer], inputs: NDArray[np.float32]) -> NDArray[np.float64]:
    """The network in double precision, of weights rounded to float32."""
    sums: list[NDArray[np.float64]] = []
    values = inputs.astype(np.float64)
    for layer in layers:
        weight, bias = (part.astype(np.float32).astype(np.float64) for part in (layer.weight, layer.bias))
        total = weight @ values + bias[:, None]
        if layer.skip_from is not None:
            total += sums[layer.skip_from]
        sums.append(total)
        values = {
            "none": lambda z: z,
            "relu": lambda z: np.maximum(z, 0),
            "leaky_relu": lambda z, slope=layer.slope: np.where(z > 0, z, slope * z),
            "exp": np.exp,
        }[layer.activation](total)
    return values


def assert_is_reference(
    layers: list[DenseLayer], inputs: NDArray[np.float32], actual: NDArray[np.float32]
) -> None:
    expected = reference(layers, inputs)
    assert np.abs(expected).max() > 0.1
    # Relative to exponentials, whose arguments have that error; beside the largest number elsewhere.
    scale = expected if layers[-1].activation == "exp" else np.abs(expected).max()
    assert (np.abs(actual - expected) / scale).max() < TOLERANCE


@pytest.mark.parametrize("target", TARGETS, ids=str)
@pytest.mark.parametrize("name", SHAPES)
def test_networks_are_numpys(name: str, target: SimdTarget) -> None:
    layers = network(name)
    mlp = FusedMlp(layers, target)
    assert (mlp.inputs, mlp.outputs) == (SHAPES[name][2], SHAPES[name][3])
    for count in (1, 48, 1003):
        inputs = np.random.default_rng(count).normal(size=(mlp.inputs, count)).astype(np.float32)
        assert_is_reference(layers, inputs, mlp.evaluate(inputs))


@pytest.mark.parametrize("name", SHAPES)
def test_networks_take_drjit_arrays(name: str) -> None:
    layers = network(name)
    mlp = FusedMlp(layers)
    inputs = np.random.default_rng(1).normal(size=(mlp.inputs, 5000)).astype(np.float32)
    arrays = [Float(row) for row in inputs]
    assert can_use_kernel(Float, arrays)
    outputs = np.stack([output.numpy() for output in mlp.call(Float, arrays)])
    np.testing.assert_array_equal(outputs, mlp.evaluate(inputs))


def test_a_result_does_not_depend_on_its_place_in_the_batch() -> None:
    mlp = FusedMlp(network("3x64"))
    inputs = np.random.default_rng(2).normal(size=(mlp.inputs, 5000)).astype(np.float32)
    expected = mlp.evaluate(inputs)
    for part in (slice(0, 1), slice(7, 300), slice(4000, 5000)):
        np.testing.assert_array_equal(mlp.evaluate(inputs[:, part]), expected[:, part])


def test_networks_of_one_shape_share_their_code(monkeypatch: pytest.MonkeyPatch) -> None:
    FusedMlp(network("2x16"))

    def never(*_: object) -> None:
        raise AssertionError("compiled again")

    monkeypatch.setattr(fused_mlp, "CompiledKernel", never)
    layers = network("2x16", seed=1)
    inputs = np.random.default_rng(3).normal(size=(6, 100)).astype(np.float32)
    assert_is_reference(layers, inputs, FusedMlp(layers).evaluate(inputs))


def test_several_layers_may_add_the_same_one() -> None:
    rng = np.random.default_rng(4)
    layers = [
        DenseLayer(rng.normal(size=(9, 9)) / 3, rng.normal(size=9), "relu", skip_from=skip)
        for skip in (None, 0, 1, 0)
    ]
    inputs = rng.normal(size=(9, 500)).astype(np.float32)
    assert_is_reference(layers, inputs, FusedMlp(layers).evaluate(inputs))


def test_layers_that_do_not_fit_are_refused() -> None:
    def layer(outputs: int, inputs: int, biases: int | None = None, skip: int | None = None) -> DenseLayer:
        bias = np.zeros(outputs if biases is None else biases)
        return DenseLayer(np.zeros((outputs, inputs)), bias, skip_from=skip)

    for layers, message in (
        ([layer(4, 3, biases=3)], "layer 0 needs 4 biases"),
        ([layer(4, 3), layer(2, 5)], "layer 1 needs 4 inputs, not 5"),
        ([layer(4, 3), layer(2, 4, skip=0)], "layer 1 cannot add layer 0"),
        ([layer(4, 3, skip=0)], "layer 0 cannot add layer 0"),
    ):
        with pytest.raises(ValueError, match=message):
            FusedMlp(layers)
    kernel = KernelBuilder("narrow", host_target(), inputs=1, outputs=1)
    packed = PackedLayers(host_target()).add("layer", np.zeros((4, 3)))
    with kernel.each_block():
        wide, narrow = kernel.block_buffer(packed.channels), kernel.block_buffer(2)
        weights = kernel.uniform_buffer(0).pointer
        for inputs, outputs, initial in ((narrow, wide, None), (wide, narrow, None), (wide, wide, narrow)):
            with pytest.raises(ValueError, match="buffers need 3 inputs"):
                emit_dense(kernel, weights, packed, inputs, outputs, initial=initial)


@pytest.mark.parametrize("target", TARGETS, ids=str)
def test_layers_build_other_kernels(target: SimdTarget) -> None:
    """Sums that begin with channels, a residual, and an activation apart."""
    rng = np.random.default_rng(5)
    first, second, start = rng.normal(size=(21, 7)), rng.normal(size=(5, 21)), rng.normal(size=5)
    bias, slope = rng.normal(size=21), 0.1
    packed = PackedLayers(target)
    one, other = packed.add("one", first, bias), packed.add("other", second)
    assert packed.layers == {"one": one, "other": other}
    assert packed.weights().size == one.size + other.size
    kernel = KernelBuilder("layers", target, inputs=7, outputs=10)
    with kernel.each_block():
        inputs, hidden = kernel.block_buffer(7), kernel.block_buffer(one.channels)
        output, active, initial = (kernel.block_buffer(other.channels) for _ in range(3))
        with kernel.each_vector():
            for number in range(7):
                inputs[number] = kernel.load_input(number)
            for number in range(5):
                initial[number] = float(start[number])
        weights = kernel.uniform_buffer(0).pointer
        emit_dense(kernel, weights, one, inputs, hidden, activation="leaky_relu", slope=slope)
        emit_dense(kernel, weights, other, hidden, output, initial=initial, residual=initial)
        emit_activation(kernel, output, active, 5, "relu")
        with kernel.loop(5) as channel, kernel.each_vector():
            kernel.store_output(channel, output[channel])
            kernel.store_output(kernel.ir.add(channel, kernel.index(5)), active[channel])
    x = rng.normal(size=(7, 1000)).astype(np.float32)
    actual = np.zeros((10, 1000), np.float32)
    CompiledKernel(kernel).launch(1000, [*x], [*actual], [packed.weights()])
    between = first @ x + bias[:, None]
    expected = second @ np.where(between > 0, between, slope * between) + 2 * start[:, None]
    np.testing.assert_allclose(actual[:5], expected, rtol=1e-5, atol=2e-5)
    np.testing.assert_array_equal(actual[5:], np.maximum(actual[:5], 0))


def test_tiles_waste_few_outputs() -> None:
    wide = SimdTarget(16, 32)
    assert [tile_size(outputs, wide) for outputs in (1, 3, 8, 16, 25, 64)] == [1, 3, 8, 8, 5, 8]
    narrow = SimdTarget(8, 16)
    assert [tile_size(outputs, narrow) for outputs in (1, 16, 64)] == [1, 4, 4]


def test_calls_go_by_the_bridge() -> None:
    """What `FusedMlp.call` says is what its launch computes on the arrays' own memory."""
    mlp = FusedMlp(network("2x16"))
    arrays = [Float(row) for row in np.random.default_rng(6).normal(size=(6, 64))]
    by_hand = call_kernel(Float, arrays, mlp.outputs, mlp.launch)
    for one, other in zip(mlp.call(Float, arrays), by_hand, strict=True):
        np.testing.assert_array_equal(one.numpy(), other.numpy())
