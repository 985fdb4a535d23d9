"""The BTF of pictures: measured pairs of directions alone, pixels interpolated bilinearly and repeated.

A diffuser of albedo 1 facing the lamp has the pixel 1: f·cos is the pixel over π.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from loomlight.assets.measured_btf import MeasuredBtf
from loomlight.core.errors import InputError

# Queries at once: their factors take 100 MB.
_BATCH = 1 << 16
# Cosine of directions at the horizon, where a sample of no height is a line.
_HORIZON = 0.02


class PictureBtf:
    """f·cos of measured pixels; nothing is seen through a sample.

    Attributes:
        measured: lights [n, 3] and views [m, 3], unit vectors: queries have no others.
    """

    faces, transmits, has_holes = 1, False, False

    def __init__(self, source: MeasuredBtf) -> None:
        """
        Raises:
            InputError: a file that is missing, damaged or no BTF.
        """
        self._source, self._pictures = source, source.pictures()
        directions = self._pictures.lights, self._pictures.views
        self._lights, self._views = (np.flatnonzero(part[:, 2] > _HORIZON) for part in directions)
        self.measured = directions[0][self._lights], directions[1][self._views]
        if not all(map(len, self.measured)):
            raise InputError(f"{source.path} is damaged: all of its directions are at the horizon.")

    def values(
        self,
        positions: NDArray[np.float32],
        lights: NDArray[np.float32],
        views: NDArray[np.float32],
        seed: tuple[int, ...],
    ) -> NDArray[np.float32]:
        """f·cos [n, 3] of the pictures with the nearest directions; see `Btf.values`."""
        del seed
        found = np.empty((len(positions), 3), np.float32)
        for first in range(0, len(positions), _BATCH):
            part = slice(first, first + _BATCH)
            light, view = (
                (rows[part] @ known.T).argmax(axis=1)
                for rows, known in zip((lights, views), self.measured, strict=True)
            )
            found[part] = self._interpolated(self._lights[light], self._views[view], positions[part])
        scale = np.float32(self._source.gain / math.pi)
        return found * (scale if self._source.cosine_included else scale * lights[:, 2:])

    def holes(self, positions: NDArray[np.float32], views: NDArray[np.float32]) -> NDArray[np.float32]:
        """0 [n]; see `Btf.holes`."""
        del views
        return np.zeros(len(positions), np.float32)

    def _interpolated(
        self, lights: NDArray[np.intp], views: NDArray[np.intp], positions: NDArray[np.float32]
    ) -> NDArray[np.float32]:
        """Pixels [n, 3] by numbers of light and view."""
        size = np.array([self._pictures.width, self._pictures.height])
        # Row 0 is at the top of a picture, and y = 0 at its bottom.
        texel = positions / np.array(self._source.size_mm, np.float32) * size - 0.5
        corner = np.floor(texel)
        blend = (texel - corner).astype(np.float32)
        total = np.zeros((len(positions), 3), np.float32)
        for right in (0, 1):
            for up in (0, 1):
                column, row = ((corner + np.array([right, up])).astype(np.intp) % size).T
                weight = np.abs(1 - right - blend[:, 0]) * np.abs(1 - up - blend[:, 1])
                pixel = self._pictures.pixels(lights, views, column, self._pictures.height - 1 - row)
                total += weight[:, None] * pixel
        return total
