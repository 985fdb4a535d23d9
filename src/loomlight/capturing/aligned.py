"""A captured cloth in the light of its photograph, with its threads where the photograph's lie."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from loomlight.capturing.crossings import Crossings
from loomlight.capturing.photographer import CAMERA_WIDTHS, Light, Linear, photograph
from loomlight.capturing.thread_colours import ColourOrder
from loomlight.capturing.thread_grid import Plane, ThreadGrid, blurred
from loomlight.capturing.weave_match import WeaveFit, placed
from loomlight.capturing.yarn_fit import Cloth, Yarns, even_fabric
from loomlight.core.colour import linear_to_srgb
from loomlight.weave.draft import Draft

# Threads beside the table of crossings that the picture's sides cut.
_BORDER = 2
# Deviations of unsharpness that are tried, pixels.
_BLURS = (0.0, 0.4, 0.6, 0.9, 1.3, 1.9, 2.6)
# Between two deviations, pixels, lies what sharpness is judged by: above noise and below threads.
_FINE = 0.8, 2.0


@dataclass(frozen=True, eq=False)
class ThreadFraming:
    """Pixels by the numbers of the threads that they show.

    Attributes:
        grid: of the photograph.
        first: numbers in it of the end and the pick at the draft's lower left.
        spacing: millimetres a thread of warp and weft.
        width_mm: of the picture.
    """

    grid: ThreadGrid
    first: tuple[float, float]
    spacing: tuple[float, float]
    width_mm: float

    @property
    def size(self) -> tuple[int, int]:
        """Width and height, pixels."""
        height, width = self.grid.warp.number.shape
        return width, height

    def at(self, columns: NDArray[np.float64], rows: NDArray[np.float64]) -> NDArray[np.float64]:
        """Millimetres of the cloth [2, n] at places in pixels."""
        families = self.grid.warp, self.grid.weft
        return np.stack(
            [
                (_between(family.number, columns - 0.5, rows - 0.5) - first) * spacing
                for family, first, spacing in zip(families, self.first, self.spacing, strict=True)
            ]
        )

    def camera(self) -> NDArray[np.float64]:
        """Where the camera is [3], millimetres of the cloth."""
        width, height = self.size
        middle = self.at(np.array([width / 2]), np.array([height / 2]))[:, 0]
        return np.array([*middle, CAMERA_WIDTHS * self.width_mm])


def _between(plane: Plane, columns: NDArray[np.float64], rows: NDArray[np.float64]) -> NDArray[np.float64]:
    """Values of a plane between its pixels, and on along their slope outside [n]."""
    height, width = plane.shape
    left = np.clip(np.floor(columns), 0, width - 2).astype(np.intp)
    top = np.clip(np.floor(rows), 0, height - 2).astype(np.intp)
    x, y = columns - left, rows - top
    return np.asarray(
        (1 - y) * ((1 - x) * plane[top, left] + x * plane[top, left + 1])
        + y * ((1 - x) * plane[top + 1, left] + x * plane[top + 1, left + 1])
    )


def aligned_picture(
    photo: Linear,
    width_mm: float,
    grid: ThreadGrid,
    crossings: Crossings,
    fit: WeaveFit,
    orders: tuple[ColourOrder, ColourOrder],
    yarns: Yarns,
    light: Light,
    samples: int = 4,
) -> Linear:
    """The captured cloth as the photograph shows it, as unsharp as that, linear RGB [height, width, 3].

    Yarns are even but for where the photograph's lie.

    Args:
        photo: linear RGB.
        samples: a pixel.
    """
    shape = crossings.shape[0] + 2 * _BORDER, crossings.shape[1] + 2 * _BORDER
    drawdown = placed(fit.structure, (fit.shift[0] - _BORDER, fit.shift[1] - _BORDER), shape)
    roles = tuple(
        replace(order, first=order.first - _BORDER).of_threads(count)
        for order, count in zip(orders, shape[::-1], strict=True)
    )
    per_mm = photo.shape[1] / width_mm
    per_cm = 10 * grid.warp.per_px * per_mm, 10 * grid.weft.per_px * per_mm
    colours = len(yarns.colours[0]), len(yarns.colours[1])
    cloth = Cloth(Draft(drawdown), (roles[0], roles[1]), colours, per_cm)
    first = crossings.first[0] - _BORDER, crossings.first[1] - _BORDER
    framing = ThreadFraming(grid, first, (10 / per_cm[0], 10 / per_cm[1]), width_mm)
    sharp = photograph(even_fabric(cloth, yarns), framing, light, samples)
    pictures = [np.stack([blurred(c, sigma) for c in np.moveaxis(sharp, -1, 0)], axis=-1) for sigma in _BLURS]
    # As sharp as the photograph: the likest would be a blur wherever plies and fibres lie in other places.
    wanted = _fine(photo)
    return min(pictures, key=lambda each: abs(np.log(_fine(each) / wanted))).astype(np.float32)


def _fine(linear: NDArray[np.floating]) -> float:
    """Deviation of encoded brightness over two or three pixels."""
    light = linear_to_srgb(linear).mean(axis=-1)
    return float((blurred(light, _FINE[0]) - blurred(light, _FINE[1])).std()) + 1e-6
