"""What the encoder sees of a fabric: maps of normal, fibre direction and height of one face of the repeat."""

from __future__ import annotations

import math

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import array_types
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout

CHANNELS = 7


def face_maps(
    geometry: YarnGeometry, back: bool, rows: int, columns: int, float_type: type
) -> NDArray[np.float32]:
    """Normal, fibre direction and height of one face [7, rows, columns], row 0 at the repeat's lower edge.

    All are those of yarns scaled by β; heights are in pitches (the geometric mean of
    both families' spacings). Holes are zero in every channel, which no yarn point is.

    Args:
        back: the face behind, in its own mirrored frame.
        float_type: the Dr.Jit Float type to compute with.
    """
    types = array_types(float_type)
    width, height = geometry.size
    texel = np.arange(rows * columns, dtype=np.int64)
    x = (texel % columns + 0.5) * (width / columns)
    y = (texel // columns + 0.5) * (height / rows)
    point = geometry.surface(types.Float(x), types.Float(y), types.Bool(back))
    pitch = mean_pitch(geometry.layout)
    channels = [*point.normal, *point.tangent, point.height / pitch]
    planes = [dr.select(point.hole, 0, plane) + dr.zeros(types.Float, rows * columns) for plane in channels]
    dr.eval(planes)
    return np.stack([plane.numpy() for plane in planes]).astype(np.float32).reshape(CHANNELS, rows, columns)


def mean_pitch(layout: ClothLayout) -> float:
    """Geometric mean of the spacings of both families, millimetres: the unit of footprints."""
    width, height = layout.size
    picks, ends = layout.warp_on_top.shape
    return math.sqrt(width / ends * height / picks)
