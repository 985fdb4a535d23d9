"""Latents as decoders fetch them. Lengths are in threads."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.core.simd import aligned
from loomlight.models.woven.encoded_fabric import EncodedFabric
from loomlight.models.woven.weights import Weights

# Numbers of a texel that are fetched at once: a line of the cache.
PACKET = 16


def fetched_channels(weights: Weights) -> int:
    """Numbers that are fetched of one texel."""
    table = weights.table
    return table.hidden if table.fusion else table.latent_size


@dataclass(frozen=True, eq=False)
class LatentRows:
    """Latents of both faces, multiplied by the first layer where there is fusion.

    That layer is linear, so multiplying before the interpolation is as good as after it.

    Attributes:
        texels: of one face.
        channels: numbers of a texel that mean something.
        values: [2 texels, channels up to whole packets], beginning with a line of the cache.
        levels: [levels, 4]: first texel, columns, rows, and texels a thread of each.
    """

    texels: int
    channels: int
    values: NDArray[np.float32]
    levels: NDArray[np.float32]

    @classmethod
    def of(cls, weights: Weights, encoded: EncodedFabric) -> LatentRows:
        """Those of a fabric."""
        latents = encoded.both
        if weights.table.fusion:
            first = weights.tensor("decoder.fusion.0.weight")[:, : weights.table.latent_size]
            latents = latents @ first.T + weights.tensor("decoder.fusion.0.bias")
        channels = latents.shape[1]
        values = aligned(np.pad(latents, ((0, 0), (0, -channels % PACKET))))
        # Whole numbers below 2^24 are exact in float32.
        levels = [(level.first, level.columns, level.rows, level.per_thread) for level in encoded.levels]
        return cls(len(encoded.faces[0]), channels, values, np.array(levels, np.float32))
