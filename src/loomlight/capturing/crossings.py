"""The crossings of a photographed cloth: what each shows, as a table of picks and ends.

A crossing is the square between two boundaries of ends and two of picks. Yarn that lies on top goes on over
its neighbours along itself, and is round across: so along the yarn a crossing shades little and meets no
edge, across it does both. Two numbers say so of each crossing, larger where the warp is on top.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.capturing.thread_grid import Plane, ThreadGrid, blurred

# Samples along a side of a crossing.
CELLS = 6
# Crossings beside one another are no independent evidence: so many count as one.
_CROSSINGS_A_VOTE = 6.0
_REC709 = np.array([0.2126, 0.7152, 0.0722])


@dataclass(frozen=True, eq=False)
class Crossings:
    """Whole crossings of the picture; row 0 is the lowest pick, column 0 the leftmost end.

    Attributes:
        colour: of the middle of each, encoded RGB [picks, ends, 3].
        roundness: how much more it darkens towards its left and right sides than towards the others,
            relative [picks, ends]; larger where the warp is on top.
        edging: how much stronger edges are on its left and right than on the others, −1 to 1 [picks, ends];
            likewise.
        first: number of the end and the pick of column 0 and row 0, in the numbers of the grid.
    """

    colour: NDArray[np.float64]
    roundness: NDArray[np.float64]
    edging: NDArray[np.float64]
    first: tuple[int, int]

    @property
    def shape(self) -> tuple[int, int]:
        """Picks and ends."""
        return self.roundness.shape[0], self.roundness.shape[1]

    @property
    def votes(self) -> float:
        """How many independent crossings these count as."""
        return self.roundness.size / _CROSSINGS_A_VOTE


def find_crossings(encoded: Plane, grid: ThreadGrid) -> Crossings:
    """The crossings of a picture of encoded RGB [height, width, 3] that lie wholly in it."""
    ends, picks = grid.warp.number, grid.weft.number
    first_end, first_pick = int(np.floor(ends.min())), int(np.floor(picks.min()))
    shape = int(np.floor(picks.max())) - first_pick + 1, int(np.floor(ends.max())) - first_end + 1
    column, row = np.floor(ends).astype(np.intp) - first_end, np.floor(picks).astype(np.intp) - first_pick
    x, y = ends - np.floor(ends), picks - np.floor(picks)
    cell = row * shape[1] + column
    place = np.minimum((y * CELLS).astype(np.intp), CELLS - 1) * CELLS + np.minimum(
        (x * CELLS).astype(np.intp), CELLS - 1
    )
    index = (cell * CELLS**2 + place).ravel()
    total = shape[0] * shape[1] * CELLS**2
    counted = np.bincount(index, minlength=total)

    def means(plane: Plane) -> NDArray[np.float64]:
        sums = np.bincount(index, plane.ravel(), total) / np.maximum(counted, 1)
        return np.asarray(sums.reshape(*shape, CELLS, CELLS))

    filled = counted.reshape(*shape, CELLS, CELLS) > 0
    colour = np.stack([means(channel) for channel in np.moveaxis(encoded, -1, 0)], axis=-1)
    inner = slice(1, CELLS - 1)
    weights = filled[:, :, inner, inner, None]
    number = np.maximum(weights.sum(axis=(2, 3)), 1)
    middle = (colour[:, :, inner, inner] * weights).sum(axis=(2, 3)) / number
    light = colour @ _REC709
    roundness = _roundness(light, filled)
    edging = _edging(encoded, grid, means, filled)
    # A crossing that the picture's side cuts has fewer pixels than most.
    pixels = counted.reshape(*shape, -1).sum(axis=2)
    whole = pixels > 0.8 * np.median(pixels[pixels > 0])
    rows, columns = _whole_part(whole)
    part = np.ix_(rows, columns)
    return Crossings(
        colour=middle[part],
        roundness=roundness[part],
        edging=edging[part],
        first=(first_end + int(columns[0]), first_pick + int(rows[0])),
    )


def _whole_part(whole: NDArray[np.bool_]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Rows and columns of a block in which nearly all crossings are whole."""
    top, bottom, left, right = 0, whole.shape[0], 0, whole.shape[1]
    while True:
        sides = {
            "top": whole[top, left:right].mean(),
            "bottom": whole[bottom - 1, left:right].mean(),
            "left": whole[top:bottom, left].mean(),
            "right": whole[top:bottom, right - 1].mean(),
        }
        worst = min(sides, key=lambda side: sides[side])
        if sides[worst] >= 0.9 or bottom - top < 3 or right - left < 3:
            return np.arange(top, bottom), np.arange(left, right)
        top, bottom = top + (worst == "top"), bottom - (worst == "bottom")
        left, right = left + (worst == "left"), right - (worst == "right")


_Part = slice | list[int]


def _strip(
    plane: NDArray[np.float64], weight: NDArray[np.float64], rows: _Part, columns: _Part
) -> NDArray[np.float64]:
    """Means over some cells of each crossing [picks, ends]."""
    part, count = plane[:, :, rows][:, :, :, columns], weight[:, :, rows][:, :, :, columns]
    return np.asarray((part * count).sum(axis=(2, 3)) / np.maximum(count.sum(axis=(2, 3)), 1))


def _roundness(light: NDArray[np.float64], filled: NDArray[np.bool_]) -> NDArray[np.float64]:
    """From luminances [picks, ends, cells, cells]: strips beside the middle, without corners."""
    weight = filled.astype(np.float64)
    inner = slice(1, CELLS - 1)

    outer, next_to_outer = [0, CELLS - 1], [1, CELLS - 2]
    sides = _strip(light, weight, inner, outer) + _strip(light, weight, inner, next_to_outer)
    ends = _strip(light, weight, outer, inner) + _strip(light, weight, next_to_outer, inner)
    return np.asarray((ends - sides) / (0.5 * (ends + sides) + 0.04))


def _edging(
    encoded: Plane,
    grid: ThreadGrid,
    means: Callable[[Plane], NDArray[np.float64]],
    filled: NDArray[np.bool_],
) -> NDArray[np.float64]:
    """Edges across x at the left and right sides against those across y at the others."""
    size = 0.5 * (1 / grid.warp.per_px + 1 / grid.weft.per_px)
    sigma = max(0.7, 0.05 * size)
    across, along = np.zeros(encoded.shape[:2]), np.zeros(encoded.shape[:2])
    for channel in np.moveaxis(encoded, -1, 0):
        smooth = blurred(channel, sigma)
        across += np.square(np.gradient(smooth, axis=1))
        along += np.square(np.gradient(smooth, axis=0))
    x, y = means(np.sqrt(across)), means(np.sqrt(along))
    # In threads, not in pixels.
    x, y = x / grid.warp.per_px, y / grid.weft.per_px
    weight = filled.astype(np.float64)

    inner, outer = slice(1, CELLS - 1), [0, CELLS - 1]
    beside, over = _strip(x, weight, inner, outer), _strip(y, weight, outer, inner)
    return np.asarray((beside - over) / (beside + over + 1e-6))
