"""The decoder compiled for this processor, from `decoder_code`, and what it reads of a fabric."""

from __future__ import annotations

import time
from collections.abc import Sequence
from functools import cache
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from loomlight.core.dense_code import Packed
from loomlight.core.machine_code import MachineCode, vectors
from loomlight.models.woven.architecture import NetworkTable
from loomlight.models.woven.decoder_code import Question, decoder_code, packed_layers
from loomlight.models.woven.encoded_fabric import EncodedFabric
from loomlight.models.woven.latents import LatentRows
from loomlight.models.woven.weights import Weights

Floats = NDArray[np.float32]


class FabricNumbers:
    """What machine code reads of a fabric.

    Attributes:
        corrected: whether the fabric has a correction of its own.
        repeat: picks and ends, if code depends on them.
        shared: see `decoder_code.SHARED`, all but the layers.
    """

    def __init__(self, weights: Weights, encoded: EncodedFabric, rows: LatentRows) -> None:
        self.corrected = encoded.correction is not None
        self.repeat = (0, 0) if weights.table.latent == "field" else (encoded.picks, encoded.ends)
        bundles = encoded.fibres.bundles(False) if weights.table.bundles else np.zeros(0)
        counts = [encoded.ends, encoded.picks, rows.texels, len(rows.levels)]
        numbers = np.concatenate([counts, encoded.fibres.face(False).ravel(), bundles.ravel()])
        correction = np.zeros(1, np.float32)
        if encoded.correction is not None:
            packed = Packed(vectors())
            packed.add("correction", encoded.correction[:, :-1], encoded.correction[:, -1])
            correction = packed.numbers()
        self.shared = [rows.values, rows.levels, numbers.astype(np.float32), correction]


class CompiledDecoder:
    """The decoder of some weights on this processor; all fabrics share its code.

    Attributes:
        seconds: that all decoders have spent on answers so far, compiling apart.
    """

    seconds: ClassVar[float] = 0.0

    def __init__(self, weights: Weights) -> None:
        self._weights = weights
        self._numbers = packed_layers(weights).numbers()

    def run(
        self, question: Question, fabric: FabricNumbers, queries: Sequence[Floats], answers: Sequence[Floats]
    ) -> None:
        """Answers queries; see `decoder_code` for what both are."""
        weights = self._weights
        code = _compiled(
            question, weights.table, weights.linear_diffuse, fabric.corrected, fabric.repeat, _Of(weights)
        )
        start = time.perf_counter()
        code.run(len(answers[0]), queries, answers, [self._numbers, *fabric.shared])
        CompiledDecoder.seconds += time.perf_counter() - start


class _Of:
    """Weights as an argument that is not told apart by: code depends on their shape alone."""

    def __init__(self, weights: Weights) -> None:
        self.weights = weights

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Of)

    def __hash__(self) -> int:
        return 0


@cache
def _compiled(
    question: Question,
    _table: NetworkTable,
    _linear_diffuse: bool,
    corrected: bool,
    repeat: tuple[int, int],
    of: _Of,
) -> MachineCode:
    return MachineCode(decoder_code(question, of.weights, corrected, repeat))


@cache
def compiled_decoder(weights: Weights) -> CompiledDecoder:
    """The decoder of some weights."""
    return CompiledDecoder(weights)
