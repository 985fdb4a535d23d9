"""A close-up in the corner of a picture, in which the weave can be read."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba.camera import FIELD_OF_VIEW, View
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
    """Rendering of a close-up: with the camera and the film of the whole picture, closer.

    The same camera and film mean the same kernels. The middle square of the film is what is shown, at fewer
    pixels, each the mean of several.

    Attributes:
        view: where the camera stands for it.
        side: of the close-up, pixels.
        margin: to the picture's edges, pixels.
        magnification: pixels of the close-up for one of the whole picture.
    """

    view: View
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
        whole_mm = 2e3 * distance * np.tan(np.radians(FIELD_OF_VIEW) / 2)
        zoom = whole_mm / (threads * pitch)
        side = int(_SIDE * shorter)
        return cls(shown.view.closer(zoom, point), side, round(_MARGIN * shorter), zoom * side / shorter)

    def cut(self, film: Picture) -> Picture:
        """The close-up [side, side, 3] from a picture of the whole film, of any size."""
        height, width = film.shape[:2]
        across = min(height, width)
        top, left = (height - across) // 2, (width - across) // 2
        return resized(film[top : top + across, left : left + across, :3], (self.side, self.side))


def resized(picture: Picture, size: tuple[int, int]) -> Picture:
    """A linear picture [h, w, c] at another `size` = (width, height): means if smaller, else interpolated."""
    smaller = size[0] * size[1] < picture.shape[0] * picture.shape[1]
    method = Image.Resampling.BOX if smaller else Image.Resampling.BILINEAR
    planes = [
        np.asarray(Image.fromarray(np.ascontiguousarray(plane)).resize(size, method))
        for plane in np.moveaxis(picture, 2, 0)
    ]
    return np.stack(planes, axis=2)


def composed(whole: Picture, inset: Picture, magnification: float, margin: int) -> Picture:
    """`whole` with a framed `inset` in its upper left corner; linear RGB [h, w, 3].

    A small square in the middle of `whole` marks what the inset shows.

    Args:
        magnification: pixels of `inset` for one of `whole`.
        margin: from the frame to the picture's edges, pixels.
    """
    picture = whole[..., :3].copy()
    height, width = picture.shape[:2]
    side = max(2, round(inset.shape[0] / magnification))
    top, left = (height - side) // 2, (width - side) // 2
    middle = picture[top : top + side, left : left + side]
    picture[top - MARK : top + side + MARK, left - MARK : left + side + MARK] = framed(middle, MARK)
    shown = framed(inset[..., :3], FRAME)
    picture[margin : margin + shown.shape[0], margin : margin + shown.shape[1]] = shown
    return picture


def framed(picture: Picture, line: int) -> Picture:
    """A picture with a white frame of `line` pixels around it."""
    return np.pad(picture, ((line, line), (line, line), (0, 0)), constant_values=_PAPER)
