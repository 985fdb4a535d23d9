"""Feature maps: what is at the middle of every texel of one repeat, on both faces (zhu2024 3.1)."""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass
from typing import TypeVar

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import FloatType
from loomlight.core.backend import array_types
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.visibility import HorizonMap

_Number = TypeVar("_Number", bound=np.generic)
# Texels along the longer side of small repeats (zhu2024 6), and texels across the finest thread.
DEFAULT_TEXELS = 256
_PER_THREAD, _MIN_PER_THREAD = 6, 2
# Of one face: the bake stays under two minutes and 4 GB, summed-area tables on a device included.
MAX_TEXELS = 1 << 21
_BYTES_A_TEXEL, _SECONDS_A_TEXEL = 1000, 5e-5


@dataclass(frozen=True, eq=False)
class FeatureMaps:
    """Texels of both faces, in the frame of the face; row 0 lies at y = 0, column 0 at x = 0.

    Attributes:
        hole, is_warp: [2 faces, rows, columns]; nothing else means anything in holes.
        thread: index of the thread that shows [2, rows, columns].
        normal, tangent: unit normal and unit fibre direction [2, rows, columns, 3].
        horizon: sines of elevation in steps of 1/255 [2, rows, columns, 16 azimuths].
    """

    hole: NDArray[np.bool_]
    is_warp: NDArray[np.bool_]
    thread: NDArray[np.int32]
    normal: NDArray[np.float32]
    tangent: NDArray[np.float32]
    horizon: NDArray[np.uint8]


def texel_counts(geometry: YarnGeometry, longest: int) -> tuple[int, int]:
    """Columns and rows: `longest` along the longer side, or more where threads would have under 6 texels.

    Threads of large repeats have fewer, at least 2: a warning says so, and what the bake takes.

    Raises:
        InputError: the repeat is too large; the message says what its bake would take.
    """
    width, height = geometry.size
    side = max(width, height) / longest

    def counts(per_thread: float) -> tuple[int, int]:
        columns, rows = (
            max(4, math.ceil(extent / side - 1e-6), math.ceil(per_thread * extent / fine - 1e-6))
            for extent, fine in zip(geometry.size, geometry.finest, strict=True)
        )
        return columns, rows

    found = counts(_PER_THREAD)
    if found[0] * found[1] <= MAX_TEXELS:
        return found
    least = counts(_MIN_PER_THREAD)
    if least[0] * least[1] > MAX_TEXELS:
        raise InputError(
            f"The repeat of {width:.4g} × {height:.4g} mm needs {least[0]} × {least[1]} texels, "
            f"{_cost(least)} to bake: clustered takes up to {MAX_TEXELS / 1e6:.1f} million texels; "
            "use lobes for this draft."
        )
    # Rounding up adds a column and a row.
    per_thread = _PER_THREAD * math.sqrt(MAX_TEXELS / ((found[0] + 2) * (found[1] + 2)))
    fewer = counts(max(per_thread, _MIN_PER_THREAD))
    warnings.warn(
        f"The repeat of {width:.4g} × {height:.4g} mm is large: {fewer[0]} × {fewer[1]} texels, "
        f"{max(per_thread, _MIN_PER_THREAD):.1f} across the finest thread instead of {_PER_THREAD}, take "
        f"{_cost(fewer)} to bake; fewer texels mean more noise, not bias.",
        LoomlightWarning,
        stacklevel=2,
    )
    return fewer


def _cost(counts: tuple[int, int]) -> str:
    texels = counts[0] * counts[1]
    return f"{texels * _BYTES_A_TEXEL / 1e9:.2g} GB and about {texels * _SECONDS_A_TEXEL:.0f} s"


def feature_maps(geometry: YarnGeometry, counts: tuple[int, int], float_type: FloatType) -> FeatureMaps:
    """The maps of one repeat with so many columns and rows."""
    types = array_types(float_type)
    columns, rows = counts
    index = dr.arange(types.UInt32, columns * rows)
    row = index // columns
    x = (types.Float(index - row * columns) + 0.5) * (geometry.size[0] / columns)
    y = (types.Float(row) + 0.5) * (geometry.size[1] / rows)
    points = [geometry.surface(x, y, dr.full(types.Bool, back, len(x))) for back in (False, True)]
    dr.eval(points)
    horizons = HorizonMap(geometry, counts, float_type)

    def both(*parts: NDArray[_Number]) -> NDArray[_Number]:
        return np.stack([part.reshape(rows, columns, *part.shape[1:]) for part in parts])

    return FeatureMaps(
        hole=both(*(np.array(point.hole.numpy(), bool) for point in points)),
        is_warp=both(*(np.array(point.is_warp.numpy(), bool) for point in points)),
        thread=both(
            *(
                dr.select(point.is_warp, point.warp_thread, point.weft_thread).numpy().astype(np.int32)
                for point in points
            )
        ),
        normal=both(*(point.normal.numpy().T for point in points)),
        tangent=both(*(point.tangent.numpy().T for point in points)),
        horizon=horizons.sine,
    )
