"""Reflectance of measured BRDFs for training: an input of the encoder for each, which is 1 for it alone.

zeltner2024 section 7.1 of the supplemental: measurements have no parameters that an encoder could take, so
that it takes the index of the material, one-hot.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from loomlight.assets.merl import MerlLibrary

_Floats = NDArray[np.float32]
# Texels along a side of a cell: those inside are never interpolated with another BRDF's.
CELL_TEXELS = 4


class MerlReflectance:
    """f·cos of the BRDFs of a library in their grid; `Reflectance` says what its methods do.

    Footprints are squares of the same variance as `Reflectance`'s Gaussians: at the middle of a cell, levels
    up to a cell's size see one BRDF alone.
    """

    faces = 1

    def __init__(self, source: MerlLibrary, resolution: int) -> None:
        del resolution
        self._source = source
        self.inputs = source.names
        self.resolution = (CELL_TEXELS * source.grid[0], CELL_TEXELS * source.grid[1])

    def values(
        self,
        positions: _Floats,
        levels: _Floats,
        lights: _Floats,
        views: _Floats,
        seed: tuple[int, ...],
    ) -> _Floats:
        """Estimates of f·cos from one point each."""
        rng = np.random.default_rng(seed)
        texel = 1 / np.array(self.resolution, np.float32)
        offset = (rng.random((len(levels), 2), np.float32) - 0.5) * texel * np.exp2(levels)[:, None]
        return self._source.evaluate(
            self._source.numbers_at((positions + offset).astype(np.float32)), lights, views
        )

    def encoder_inputs(self, level: int, face: int = 0) -> _Floats:
        """Shares [height, width, BRDFs] of the BRDFs in each texel."""
        del face
        columns, rows = self._source.grid
        count = len(self.inputs)
        shares = np.eye(count, dtype=np.float32)[np.arange(columns * rows) % count]
        shares = shares.reshape(rows, columns, count)
        shares = shares.repeat(CELL_TEXELS, axis=0).repeat(CELL_TEXELS, axis=1)
        for _ in range(level):
            for axis in (0, 1):
                if shares.shape[axis] > 1:
                    even, odd = (np.take(shares, range(k, shares.shape[axis], 2), axis) for k in (0, 1))
                    shares = ((even + odd) / 2).astype(np.float32)
        return np.ascontiguousarray(shares)
