"""What the encoder sees of a fabric: maps of a face, as the yarns' geometry gives them."""

from __future__ import annotations

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import array_types
from loomlight.models.neural.encoded_fabric import mean_pitch
from loomlight.yarn.geometry import YarnGeometry

# Numbers of a texel: normal, fibre direction, height.
CHANNELS = 7


def face_maps(
    geometry: YarnGeometry, back: bool, rows: int, columns: int, float_type: type
) -> NDArray[np.float32]:
    """Normal, fibre direction and height of one face [7, rows, columns], row 0 at the repeat's lower edge.

    All are of yarns scaled by β; heights are in pitches (the geometric mean of both families' spacings).
    Holes are 0 in every channel.

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
