"""Where a query reads the textures of a surface that is no plane (kuznetsov2021 section 4.2)."""

from __future__ import annotations

from loomlight.core.arrays import Float
from loomlight.models.mip_pyramid import PyramidShape

# Below this cosine the parallax of eq. 6 grows no further.
MIN_COSINE = 0.6


def shifted(
    shape: PyramidShape, u: Float, v: Float, depth: Float, view_x: Float, view_y: Float, slope: Float
) -> tuple[Float, Float]:
    """The position of eq. 7, in repeats.

    Args:
        depth: r, in units of `PyramidShape.length_mm`.
        slope: 1 / max(cosine of the view, `MIN_COSINE`).
    """
    across, along = shape.unit
    reach = depth * slope
    return u + reach * view_x * across, v + reach * view_y * along
