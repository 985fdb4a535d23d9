"""The decoder compiled for this processor, from `decoder_kernel`, and the uniform buffers of a fabric."""

from __future__ import annotations

import time
from collections.abc import Sequence
from functools import cache
from typing import ClassVar

import numpy as np

from loomlight.core.simd import CompiledKernel, Floats, host_target
from loomlight.models.woven.architecture import NetworkTable
from loomlight.models.woven.decoder_kernel import (
    EntryPoint,
    correction_layers,
    decoder_kernel,
    packed_layers,
)
from loomlight.models.woven.encoded_fabric import EncodedFabric
from loomlight.models.woven.latents import LatentRows
from loomlight.models.woven.weights import Weights


class FabricNumbers:
    """What kernels read of a fabric.

    Attributes:
        has_correction: whether the fabric has a correction of its own.
        repeat: picks and ends, if code depends on them; else 0 and 0.
        uniforms: the uniform buffers of `decoder_kernel` after the packed layers.
    """

    def __init__(self, weights: Weights, encoded: EncodedFabric, rows: LatentRows) -> None:
        self.has_correction = encoded.correction is not None
        self.repeat = (0, 0) if weights.table.latent == "field" else (encoded.picks, encoded.ends)
        bundles = encoded.fibres.bundles(False) if weights.table.bundles else np.zeros(0)
        counts = [encoded.ends, encoded.picks, rows.texels, len(rows.levels)]
        parameters = np.concatenate([counts, encoded.fibres.face(False).ravel(), bundles.ravel()])
        correction = np.zeros(1, np.float32)
        if encoded.correction is not None:
            correction = correction_layers(encoded.correction, host_target()).weights()
        self.uniforms = [rows.values, rows.levels, parameters.astype(np.float32), correction]


class CompiledDecoder:
    """The decoder of some weights on this processor; all fabrics share its code.

    Attributes:
        seconds: that all decoders have spent on queries so far, without compiling.
    """

    seconds: ClassVar[float] = 0.0

    def __init__(self, weights: Weights) -> None:
        self._weights = weights
        self._layers = packed_layers(weights, host_target()).weights()

    def run(
        self,
        entry_point: EntryPoint,
        fabric: FabricNumbers,
        inputs: Sequence[Floats],
        outputs: Sequence[Floats],
    ) -> None:
        """Computes outputs of queries; `decoder_kernel` says what both are for each entry point."""
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
    """Weights as a cache key that ignores their values: code depends on the shape, which the table says."""

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
