"""The decoder compiled for this processor from `decoder_kernel`, for numpy arrays of queries."""

from __future__ import annotations

import time
from collections.abc import Sequence
from functools import cache, lru_cache
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from loomlight.core.simd import CompiledKernel, Floats, host_target
from loomlight.models.neural.architecture import NetworkTable
from loomlight.models.neural.decoder_kernel import EntryPoint, decoder_kernel, packed_layers
from loomlight.models.neural.encoded_fabric import EncodedFabric
from loomlight.models.neural.latent_table import LatentTable
from loomlight.models.neural.weights import Weights


class CompiledDecoder:
    """The decoder of some weights on this processor; all fabrics share its code.

    Attributes:
        seconds: time that all decoders have spent on queries so far, without compiling.
    """

    seconds: ClassVar[float] = 0.0

    def __init__(self, weights: Weights) -> None:
        self._weights = weights
        self._layers = packed_layers(weights, host_target()).weights()

    def run(
        self,
        entry_point: EntryPoint,
        fabric: LatentTable,
        inputs: Sequence[Floats],
        outputs: Sequence[Floats],
    ) -> None:
        """Computes outputs of queries; `decoder_kernel` lists inputs and outputs of each entry point."""
        weights = self._weights
        kernel = _compiled(
            entry_point,
            weights.table,
            weights.linear_diffuse,
            fabric.has_correction,
            fabric.repeat,
            _Shape(weights),
        )
        start = time.perf_counter()
        kernel.launch(len(outputs[0]), inputs, outputs, [self._layers, *fabric.uniforms])
        CompiledDecoder.seconds += time.perf_counter() - start


class _Shape:
    """Weights as a cache key that ignores their values: code depends on the network's shape alone."""

    def __init__(self, weights: Weights) -> None:
        self.weights = weights

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Shape)

    def __hash__(self) -> int:
        return 0


@cache
def _compiled(
    entry_point: EntryPoint,
    _table: NetworkTable,
    _linear_diffuse: bool,
    has_correction: bool,
    repeat: tuple[int, int],
    shape: _Shape,
) -> CompiledKernel:
    kernel = decoder_kernel(entry_point, shape.weights, has_correction, repeat, host_target())
    return CompiledKernel(kernel)


@cache
def compiled_decoder(weights: Weights) -> CompiledDecoder:
    """The decoder of some weights."""
    return CompiledDecoder(weights)


# Fabrics whose tables are cached.
_KEPT = 2


def decode(
    weights: Weights,
    encoded: EncodedFabric,
    lights: NDArray[np.float32],
    views: NDArray[np.float32],
    footprints: NDArray[np.float32],
) -> NDArray[np.float32]:
    """Components, 1/sr, and hole fraction [n, 5] of n queries, on all cores.

    Args:
        lights, views: unit vectors [n, 3]; z < 0 is behind the cloth.
        footprints: position x and y and side [n, 3], in threads; see `footprints_in_threads`.
    """
    light, view, footprint = (columns(rows) for rows in (lights, views, footprints))
    back = view[2] < 0
    turn = np.where(back, np.float32(-1), np.float32(1))
    light[2] *= turn
    view[2] *= turn
    outputs = np.empty((5, len(lights)), np.float32)
    table = kernel_table(weights, encoded)
    inputs = [*one_square(footprint), *view, back.astype(np.float32), *light]
    compiled_decoder(weights).run("components_and_hole", table, inputs, [*outputs])
    return outputs.T


def one_square(footprints: NDArray[np.float32]) -> list[NDArray[np.float32]]:
    """The numbers of `AnisotropicTaps` of footprints [3, n], position x and y and side."""
    zero = np.zeros(footprints.shape[1], np.float32)
    return [*footprints, zero, zero, zero, zero]


def columns(rows: NDArray[np.floating]) -> NDArray[np.float32]:
    """Rows [n, k] transposed to contiguous columns [k, n], float32."""
    return rows.T.astype(np.float32, order="C")


@lru_cache(_KEPT)
def kernel_table(weights: Weights, encoded: EncodedFabric) -> LatentTable:
    """The tables of a fabric for kernels alone."""
    return LatentTable(weights, encoded)
