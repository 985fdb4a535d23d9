"""Reflectance of measured BRDFs for training: a texel and an input of the encoder for each.

zeltner2024 section 7.1 of the supplemental: measurements have no parameters that an encoder could take, so
that it takes the index of the material, one-hot.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from loomlight.assets.merl import MerlLibrary

_Floats = NDArray[np.float32]


class MerlReflectance:
    """f·cos of the BRDFs of a library in their grid; `Reflectance` says what its methods do."""

    faces = 1
    is_apart = True

    def __init__(self, source: MerlLibrary, resolution: int) -> None:
        del resolution
        self._source = source
        self.inputs, self.resolution = source.names, source.grid
        self.slopes = np.zeros((1, 1, 1, 1, 2), np.float32)

    def values(
        self, positions: _Floats, levels: _Floats, lights: _Floats, views: _Floats, seed: tuple[int, ...]
    ) -> _Floats:
        """f·cos of the BRDFs that the positions lie in."""
        del levels, seed
        return self._source.evaluate(self._source.numbers_at(positions), lights, views)

    def encoder_inputs(self, level: int, face: int = 0) -> _Floats:
        """Inputs [height, width, BRDFs]: 1 for the BRDF of a texel."""
        del level, face
        columns, rows = self._source.grid
        count = len(self.inputs)
        return np.eye(count, dtype=np.float32)[np.arange(columns * rows) % count].reshape(
            rows, columns, count
        )
