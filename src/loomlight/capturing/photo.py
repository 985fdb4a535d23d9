"""A photograph of flat cloth, as it is read: upright, in linear light, of a size that is worked on."""

from __future__ import annotations

import os
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.core.colour import linear_to_srgb, parse_colour
from loomlight.core.errors import InputError
from loomlight.core.images import read_linear

# Pixels of the longer side that are worked on: first, and of fine cloth.
WORKING_SIDE, FINE_SIDE = 1024, 2400
MIN_SIDE = 96
MIN_WIDTH_MM, MAX_WIDTH_MM = 1.0, 2000.0
# Of the light that falls on it, what white paper and a grey card reflect.
WHITE_PAPER, GREY_CARD = 0.9, 0.18
# Share of pixels that may be as bright as the file can say.
_MAX_CLIPPED, _CLIPPED = 0.04, 0.995
_MIN_LIGHT = 0.004


@dataclass(frozen=True, eq=False)
class Photo:
    """A photograph.

    Attributes:
        linear: linear RGB [height, width, 3], in which white that faces the light is 1.
        width_mm: of the cloth that the picture is wide.
        path: of the file.
        full_size: width and height of the file, pixels.
    """

    linear: NDArray[np.float32]
    width_mm: float
    path: str
    full_size: tuple[int, int]

    @property
    def encoded(self) -> NDArray[np.float64]:
        """sRGB-encoded [height, width, 3], 0 to 1."""
        return linear_to_srgb(self.linear)

    @property
    def px_per_mm(self) -> float:
        """Pixels a millimetre."""
        return self.linear.shape[1] / self.width_mm


def read_photo(
    path: str | os.PathLike[str],
    width_mm: float,
    *,
    white: str | None = None,
    grey_card: str | None = None,
    side: int = WORKING_SIDE,
) -> Photo:
    """The photograph of a file.

    Args:
        width_mm: millimetres of cloth that the picture is wide, as it is shown upright.
        white: sRGB hex that white paper has in the photograph, in the same light as the cloth.
        grey_card: the same of a grey card of 18 %.
        side: pixels of the longer side that are kept.

    Raises:
        InputError: no picture, too small, too dark or clipped; a width or a colour out of range.
    """
    if not MIN_WIDTH_MM <= width_mm <= MAX_WIDTH_MM:
        raise InputError(
            f"width_mm = {width_mm:g} is out of range: say how many millimetres of cloth the photograph is "
            f"wide, {MIN_WIDTH_MM:g} to {MAX_WIDTH_MM:g}."
        )
    gains = _gains(white, grey_card)
    linear = read_linear(path).astype(np.float64)
    height, width = linear.shape[:2]
    if min(height, width) < MIN_SIDE:
        raise InputError(f"{path} has {width} x {height} pixels; {MIN_SIDE} or more a side are needed.")
    _require_exposed(path, linear)
    if max(height, width) > side:
        scale = side / max(height, width)
        linear = _resized(linear, (max(1, round(width * scale)), max(1, round(height * scale))))
    return Photo((linear * gains).astype(np.float32), float(width_mm), str(path), (width, height))


def _gains(white: str | None, grey_card: str | None) -> NDArray[np.float64]:
    """By which linear RGB is multiplied [3]."""
    if white is not None and grey_card is not None:
        raise InputError("white and grey_card say the same: give one of them.")
    for text, field, reflects in ((white, "white", WHITE_PAPER), (grey_card, "grey_card", GREY_CARD)):
        if text is None:
            continue
        shown = parse_colour(text, field)
        if shown.min() < 0.02:
            raise InputError(
                f'{field} = "{text}" is too dark: give the colour that it has in the photograph, such as '
                '"#d8d4cc".'
            )
        return np.asarray(reflects / shown)
    return np.ones(3)


def _require_exposed(path: str | os.PathLike[str], linear: NDArray[np.float64]) -> None:
    clipped = float((linear.max(axis=-1) >= _CLIPPED).mean())
    if clipped > _MAX_CLIPPED:
        raise InputError(
            f"{path} is overexposed: {100 * clipped:.0f} % of its pixels are as bright as can be; expose it "
            "less and sharpen nothing, so that none of the cloth is pure white."
        )
    if float(linear.mean()) < _MIN_LIGHT:
        raise InputError(f"{path} is too dark to tell threads apart; expose it more.")


def _resized(linear: NDArray[np.float64], size: tuple[int, int]) -> NDArray[np.float64]:
    """Linear colours averaged over the pixels of a smaller picture."""
    channels = [
        np.asarray(Image.fromarray(channel.astype(np.float32)).resize(size, Image.Resampling.BOX))
        for channel in np.moveaxis(linear, -1, 0)
    ]
    return np.stack(channels, axis=-1).astype(np.float64)
