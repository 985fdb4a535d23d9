"""Pictures that show themselves in notebooks."""

from __future__ import annotations

import io
from collections.abc import Callable
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.core.images import encoded

_Drawn = TypeVar("_Drawn")
# How a value of a type is drawn, [height, width, 3]: drawings stand above what they draw.
_DRAWINGS: dict[type, Callable[[Any], NDArray[np.uint8]]] = {}


class Picture(np.ndarray[Any, np.dtype[np.float32]]):
    """Linear RGB [height, width, 3], float32: a NumPy array that notebooks display."""

    def _repr_png_(self) -> bytes | None:
        """The picture in sRGB as PNG; None of what is sliced out of one and is no picture any more."""
        is_picture = self.ndim == 3 and self.shape[2] == 3 and self.size > 0
        return png_bytes(encoded(self)) if is_picture else None


def draw_by(kind: type[_Drawn], drawing: Callable[[_Drawn], NDArray[np.uint8]]) -> None:
    """Lets values of a type show themselves in notebooks by a drawing, sRGB pixels [height, width, 3]."""
    _DRAWINGS[kind] = drawing


def drawn_png(value: object) -> bytes | None:
    """The drawing of a value as PNG; None of a type that nothing draws."""
    drawing = _DRAWINGS.get(type(value))
    return None if drawing is None else png_bytes(drawing(value))


def png_bytes(pixels: NDArray[np.uint8]) -> bytes:
    """8-bit pixels [height, width] or [height, width, 3] as the content of a PNG file."""
    content = io.BytesIO()
    Image.fromarray(pixels).save(content, format="PNG")
    return content.getvalue()
