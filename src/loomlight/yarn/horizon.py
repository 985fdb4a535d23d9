"""Tabulated visibility: the horizon of every texel of one repeat, for both faces.

As coarse as its grid: for the models that prefilter visibility. Close-ups search along the light ray.
"""

from __future__ import annotations

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import FloatType
from loomlight.core.backend import ArrayTypes, array_types
from loomlight.core.errors import InputError
from loomlight.yarn.search import SearchQuality, Surface
from loomlight.yarn.visibility import horizon

# Azimuths a texel: more than 16 change the light that cloth reflects by less than 0.5 %.
AZIMUTHS = 16
_BATCH = 1 << 22
_QUALITY = SearchQuality(steps_per_thread=8)


class HorizonMap:
    """Horizons of one repeat: sine of the elevation [2 faces, rows, columns, azimuths] in 1/255 steps.

    Between azimuths the horizon is interpolated; a texel holds the horizon of its middle.
    """

    def __init__(
        self,
        surface: Surface,
        resolution: tuple[int, int],
        float_type: FloatType,
        quality: SearchQuality = _QUALITY,
    ) -> None:
        """Searches the horizons.

        Args:
            resolution: columns and rows.
            float_type: the Dr.Jit Float type to compute with.

        Raises:
            InputError: more than 16 million texels.
        """
        columns, rows = resolution
        if columns * rows > 1 << 24:
            raise InputError(
                f"A horizon map of {columns}x{rows} texels is too large; 16 million can be tabulated."
            )
        self.size = surface.size
        self.resolution = resolution
        self.sine: NDArray[np.uint8] = np.stack(
            [self._search(surface, array_types(float_type), back, quality) for back in (False, True)]
        )

    def _search(
        self, surface: Surface, types: ArrayTypes, back: bool, quality: SearchQuality
    ) -> NDArray[np.uint8]:
        columns, rows = self.resolution
        total = columns * rows * AZIMUTHS
        parts = []
        for first in range(0, total, _BATCH):
            index = dr.arange(types.UInt32, first, min(first + _BATCH, total))
            texel = index // AZIMUTHS
            row = texel // columns
            x = (types.Float(texel - row * columns) + 0.5) * (self.size[0] / columns)
            y = (types.Float(row) + 0.5) * (self.size[1] / rows)
            azimuth = types.Float(index - texel * AZIMUTHS) * (dr.two_pi / AZIMUTHS)
            face = dr.full(types.Bool, back, dr.width(index))
            level, _ = surface.height(x, y, face)
            tangent = horizon(surface, x, y, level, azimuth, face, quality)
            sine = tangent * dr.rsqrt(dr.fma(tangent, tangent, 1))
            parts.append(np.rint(np.clip(sine.numpy(), 0, 1) * 255).astype(np.uint8))
        return np.concatenate(parts).reshape(rows, columns, AZIMUTHS)
