"""Where a query reads the textures of a surface that is no plane."""

from __future__ import annotations

import pytest

from loomlight.models.mip_pyramid import PyramidShape
from loomlight.models.neumip.parallax import shifted

SHAPE = PyramidShape(8, 4, 2.0, 1.0, 2)


def test_the_shift_is_a_length_and_not_a_share_of_each_side() -> None:
    """Eq. 7: on a repeat twice as wide as high, the same depth is half as many repeats across."""
    u, v = shifted(SHAPE, 0.0, 0.0, 0.1, 0.6, 0.6, 1.0)
    assert u * SHAPE.width_mm == pytest.approx(v * SHAPE.height_mm)
    assert u * SHAPE.width_mm == pytest.approx(0.06 * SHAPE.length_mm)
