"""Colour: sRGB where people write it, linear RGB (ITU-R BT.709 primaries) where light is computed.

Below: differences that an eye sees, and white balance.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from loomlight.core.errors import InputError

_LAB = re.compile(r"lab\(\s*([^\s,]+)[\s,]+([^\s,]+)[\s,]+([^\s,)]+)\s*\)", re.IGNORECASE)
_HEX = re.compile(r"#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})")


def srgb_to_linear(encoded: ArrayLike) -> NDArray[np.float64]:
    """Linear values of sRGB-encoded ones, elementwise, both in [0, 1] (IEC 61966-2-1)."""
    value = np.asarray(encoded, dtype=np.float64)
    return np.where(value <= 0.04045, value / 12.92, ((np.maximum(value, 0.04045) + 0.055) / 1.055) ** 2.4)


def linear_to_srgb(linear: ArrayLike) -> NDArray[np.float64]:
    """sRGB encoding of linear values, elementwise; values outside [0, 1] are clipped (IEC 61966-2-1)."""
    value = np.clip(np.asarray(linear, dtype=np.float64), 0.0, 1.0)
    return np.where(value <= 0.0031308, value * 12.92, 1.055 * np.maximum(value, 1e-12) ** (1 / 2.4) - 0.055)


def parse_colour(value: object, field: str) -> NDArray[np.float64]:
    """Linear RGB [3] of ``"#rrggbb"`` (sRGB), of ``"lab(52 -10 30)"`` (D65), or of a linear triple in [0, 1].

    A Lab colour outside the gamut of BT.709 becomes the nearest in each channel.

    Raises:
        InputError: anything else, a component outside [0, 1] or NaN; the message names `field`.
    """
    if isinstance(value, str):
        lab = _LAB.fullmatch(value.strip())
        if lab is not None:
            return np.clip(linear_of_lab(_lab_numbers(lab, field)), 0, 1)
        match = _HEX.fullmatch(value.strip())
        if match is None:
            raise InputError(f'{field} = "{value}" is no colour: write sRGB hex such as "#20305c".')
        digits = match.group(1)
        if len(digits) == 3:
            digits = "".join(2 * digit for digit in digits)
        return srgb_to_linear([int(digits[i : i + 2], 16) / 255 for i in (0, 2, 4)])
    if isinstance(value, Sequence) and len(value) == 3:
        if not all(isinstance(part, int | float) and not isinstance(part, bool) for part in value):
            raise InputError(
                f"{field} = {list(value)} is no colour: a linear RGB triple holds three numbers."
            )
        triple = np.asarray(value, dtype=np.float64)
        if not np.all((triple >= 0) & (triple <= 1)):
            raise InputError(f"{field} = {list(value)} is out of gamut: linear RGB lies between 0 and 1.")
        return triple
    raise InputError(f'{field} = {value!r} is no colour: write "#rrggbb" or a linear RGB triple.')


def lab_of_text(value: object, field: str) -> NDArray[np.float64] | None:
    """L*, a*, b* [3] of a colour that is written as ``"lab(52 -10 30)"``; None of others."""
    match = _LAB.fullmatch(value.strip()) if isinstance(value, str) else None
    return None if match is None else _lab_numbers(match, field)


def _lab_numbers(match: re.Match[str], field: str) -> NDArray[np.float64]:
    try:
        lightness, a, b = (float(part.rstrip("%")) for part in match.groups())
    except ValueError:
        lightness, a, b = float("nan"), 0.0, 0.0
    if not (0 <= lightness <= 100 and abs(a) <= 150 and abs(b) <= 150):
        raise InputError(
            f'{field} = "{match.group(0)}" is no colour: write lab(L a b) with L from 0 to 100, a and b from '
            "-150 to 150."
        )
    return np.array([lightness, a, b])


def to_hex(linear: ArrayLike) -> str:
    """sRGB hex of linear RGB [3], rounded to 8 bits."""
    red, green, blue = np.rint(linear_to_srgb(linear) * 255).astype(int)
    return f"#{red:02x}{green:02x}{blue:02x}"


# ----------------------------------------------------------------------------------------- colour differences
# CIE L*a*b* and the colour difference CIEDE2000 (CIE 142-2001), for the white D65 and the 2° observer.


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


# ---------------------------------------------------------------------------------------------- white balance
# The gains by which light of a colour temperature becomes white.
#
# Light of the sky has the chromaticities of CIE daylight from 4000 K on (CIE 15:2018), light of lamps those
# of a black body below (Kim et al. 2002). At 6500 K gains are 1 to within 1 %: colours are relative to D65.


COOLEST, WARMEST = 1667.0, 25000.0
_DAYLIGHT_FROM = 4000.0


def chromaticity(kelvin: float) -> tuple[float, float]:
    """CIE 1931 x, y of light of a colour temperature, kelvin, 1667 to 25000."""
    inverse = 1e3 / kelvin
    if kelvin < _DAYLIGHT_FROM:
        x = np.polyval([-0.2661239, -0.2343589, 0.8776956, 0.179910], inverse)
        low = [-1.1063814, -1.34811020, 2.18555832, -0.20219683]
        high = [-0.9549476, -1.37418593, 2.09137015, -0.16748867]
        return float(x), float(np.polyval(low if kelvin <= 2222 else high, x))
    if kelvin <= 7000:
        x = np.polyval([-4.6070, 2.9678, 0.09911, 0.244063], inverse)
    else:
        x = np.polyval([-2.0064, 1.9018, 0.24748, 0.237040], inverse)
    return float(x), float(np.polyval([-3.0, 2.870, -0.275], x))


def white_balance(kelvin: float) -> NDArray[np.float64]:
    """Gains of linear RGB [3] under which light of that colour temperature is white; luminance is kept.

    Raises:
        InputError: a temperature outside 1667 to 25000 K.
    """
    if not COOLEST <= kelvin <= WARMEST:
        raise InputError(
            f"white_balance = {kelvin:g} is out of range: colour temperatures lie between {COOLEST:.0f} and "
            f"{WARMEST:.0f} K; 6500 is daylight and changes nothing."
        )
    x, y = chromaticity(kelvin)
    light = linear_of_xyz_ratio(np.array([x / y, 1.0, (1 - x - y) / y]) / xyz_white())
    # Candlelight lies outside the gamut, where a channel would get no finite gain.
    gains = 1 / np.maximum(light, 0.02)
    return np.asarray(gains / (gains @ np.array([0.2126, 0.7152, 0.0722])))
