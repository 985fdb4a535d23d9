"""Colour: sRGB where people write it, linear RGB (ITU-R BT.709 primaries) where light is computed."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from loomlight.core.colour_difference import linear_of_lab
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
