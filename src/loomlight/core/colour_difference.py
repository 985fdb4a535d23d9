"""CIE L*a*b* and the colour difference CIEDE2000 (CIE 142-2001), for the white D65 and the 2° observer."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

# XYZ of linear RGB of BT.709, whose white is D65 (IEC 61966-2-1).
_XYZ_OF_RGB = np.array(
    [
        [0.4123908, 0.35758434, 0.18048079],
        [0.21263901, 0.71516868, 0.07219232],
        [0.01933082, 0.11919478, 0.95053215],
    ]
)
_WHITE = _XYZ_OF_RGB.sum(axis=1)
# Where the cube root of L*a*b* becomes a line (CIE 15:2018).
_EDGE = 6 / 29


def lab_of_linear(linear: ArrayLike) -> NDArray[np.float64]:
    """L*, a*, b* [..., 3] of linear RGB [..., 3]."""
    ratio = np.asarray(linear, np.float64) @ _XYZ_OF_RGB.T / _WHITE
    root = np.where(ratio > _EDGE**3, np.cbrt(ratio), ratio / (3 * _EDGE**2) + 4 / 29)
    x, y, z = np.moveaxis(root, -1, 0)
    return np.stack([116 * y - 16, 500 * (x - y), 200 * (y - z)], axis=-1)


def linear_of_lab(lab: ArrayLike) -> NDArray[np.float64]:
    """Linear RGB [..., 3] of L*, a*, b* [..., 3]; components may lie outside 0 to 1."""
    lightness, a, b = np.moveaxis(np.asarray(lab, np.float64), -1, 0)
    y = (lightness + 16) / 116
    root = np.stack([y + a / 500, y, y - b / 200], axis=-1)
    return linear_of_xyz_ratio(np.where(root > _EDGE, root**3, 3 * _EDGE**2 * (root - 4 / 29)))


def linear_of_xyz_ratio(ratio: ArrayLike) -> NDArray[np.float64]:
    """Linear RGB [..., 3] of XYZ over the XYZ of white [..., 3]."""
    return np.asarray((np.asarray(ratio, np.float64) * _WHITE) @ np.linalg.inv(_XYZ_OF_RGB).T)


def xyz_white() -> NDArray[np.float64]:
    """XYZ [3] of D65, its luminance 1."""
    return _WHITE / _WHITE[1]


def delta_e_2000(first: ArrayLike, second: ArrayLike) -> NDArray[np.float64]:
    """CIEDE2000 [...] of two colours in L*a*b* [..., 3] (Sharma, Wu, Dalal 2005)."""
    (l1, a1, b1), (l2, a2, b2) = (np.moveaxis(np.asarray(lab, np.float64), -1, 0) for lab in (first, second))
    mean_seventh = (0.5 * (np.hypot(a1, b1) + np.hypot(a2, b2))) ** 7
    stretch = 1.5 - 0.5 * np.sqrt(mean_seventh / (mean_seventh + 25.0**7))
    a1, a2 = a1 * stretch, a2 * stretch
    c1, c2 = np.hypot(a1, b1), np.hypot(a2, b2)
    h1, h2 = (np.degrees(np.arctan2(b, a)) % 360 for a, b in ((a1, b1), (a2, b2)))
    is_grey = c1 * c2 == 0
    turn = np.where(is_grey, 0, (h2 - h1 + 180) % 360 - 180)
    hue_difference = 2 * np.sqrt(c1 * c2) * np.sin(np.radians(turn / 2))
    lightness, chroma = 0.5 * (l1 + l2), 0.5 * (c1 + c2)
    hue = np.where(is_grey, h1 + h2, h1 + 0.5 * turn)
    weight = (
        1
        - 0.17 * np.cos(np.radians(hue - 30))
        + 0.24 * np.cos(np.radians(2 * hue))
        + 0.32 * np.cos(np.radians(3 * hue + 6))
        - 0.20 * np.cos(np.radians(4 * hue - 63))
    )
    squared = (lightness - 50) ** 2
    scale_l = 1 + 0.015 * squared / np.sqrt(20 + squared)
    scale_c, scale_h = 1 + 0.045 * chroma, 1 + 0.015 * chroma * weight
    seventh = chroma**7
    turned = 60 * np.exp(-(((hue % 360 - 275) / 25) ** 2))
    rotation = -2 * np.sqrt(seventh / (seventh + 25.0**7)) * np.sin(np.radians(turned))
    by_l, by_c, by_h = (l2 - l1) / scale_l, (c2 - c1) / scale_c, hue_difference / scale_h
    return np.asarray(np.sqrt(by_l**2 + by_c**2 + by_h**2 + rotation * by_c * by_h))
