"""A close-up in the corner of a picture, in which the weave can be read.

It takes the place of what the picture would show there: pixels of the corner look through the same camera
from nearer. So it costs no sample, no kernel and no launch of its own.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba.camera import Corner, View
from loomlight.mitsuba.scenes import ClothScene

Picture = NDArray[np.float32]

# Of the picture's shorter side: the close-up's side, and its distance from the edges.
_SIDE, _MARGIN = 0.37, 0.025
# Pixels of the picture's shorter side below which a close-up is too small to read.
MIN_PICTURE = 160
# Threads across: so many repeats, but enough to see a cloth and few enough to tell them apart.
_REPEATS, _MIN_THREADS, _MAX_THREADS = 2.5, 18, 36
# Widths of lines in pixels, and their radiance.
FRAME, MARK = 2, 1
_PAPER = 1.0


@dataclass(frozen=True)
class Inset:
    """A close-up: what the middle square of the picture shows from nearer, with its field of view.

    Attributes:
        view: where its camera stands.
        size: width and height of the picture, pixels.
        side: of the close-up, pixels.
        margin: from the close-up to the picture's left and upper edge, pixels.
        magnification: pixels of the close-up for one of the whole picture.
    """

    view: View
    size: tuple[int, int]
    side: int
    margin: int
    magnification: float

    @classmethod
    def of(cls, fabric: Fabric, shown: ClothScene, size: tuple[int, int]) -> Inset:
        """The close-up for the picture of `size` = (width, height) pixels that a scene of a fabric makes."""
        shorter = min(size)
        picks, ends = fabric.draft.drawdown.shape
        threads = np.clip(_REPEATS * max(picks, ends), _MIN_THREADS, _MAX_THREADS)
        # The thinner family decides: of neither are more threads shown.
        pitch = min(length / count for length, count in zip(fabric.repeat_mm, (ends, picks), strict=True))
        point = np.array(shown.point)
        distance = float(np.linalg.norm(shown.view.origin - point))
        whole_mm = 2e3 * distance * np.tan(np.radians(shown.view.field_of_view) / 2)
        zoom = whole_mm / (threads * pitch)
        side = int(_SIDE * shorter)
        margin = round(_MARGIN * shorter) + FRAME
        return cls(shown.view.closer(zoom, point), size, side, margin, zoom * side / shorter)

    @property
    def corner(self) -> Corner:
        """The part of the picture that it takes."""
        size = np.array(self.size, float)
        low, high = self.margin / size, (self.margin + self.side) / size
        return Corner(low, high, min(self.size) / self.side, self.view.origin)

    def drawn_on(self, picture: Picture) -> Picture:
        """Linear RGB [h, w, 3] with a frame around the close-up, and a mark around what it shows."""
        picture = picture[..., :3].copy()
        width, height = self.size
        side = max(2, round(self.side / self.magnification))
        _outline(picture, (height - side) // 2, (width - side) // 2, side, MARK)
        _outline(picture, self.margin, self.margin, self.side, FRAME)
        return picture


def resized(picture: Picture, size: tuple[int, int]) -> Picture:
    """A linear picture [h, w, c] at another `size` = (width, height): means if smaller, else interpolated."""
    smaller = size[0] * size[1] < picture.shape[0] * picture.shape[1]
    method = Image.Resampling.BOX if smaller else Image.Resampling.BILINEAR
    planes = [
        np.asarray(Image.fromarray(np.ascontiguousarray(plane)).resize(size, method))
        for plane in np.moveaxis(picture, 2, 0)
    ]
    return np.stack(planes, axis=2)


def _outline(picture: Picture, top: int, left: int, side: int, line: int) -> None:
    """Draws a white frame of `line` pixels around a square."""
    inner = picture[top : top + side, left : left + side].copy()
    picture[top - line : top + side + line, left - line : left + side + line] = _PAPER
    picture[top : top + side, left : left + side] = inner
