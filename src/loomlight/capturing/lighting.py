"""Light that falls off towards the sides of a photograph, told from the colours of its cloth."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from loomlight.capturing.crossings import Crossings
from loomlight.capturing.thread_colours import ColourOrder
from loomlight.capturing.thread_grid import ThreadGrid
from loomlight.core.colour import srgb_to_linear
from loomlight.core.errors import InputError

# Brightest over darkest light in a picture: above it cloth has folds, or one side of it no light.
MAX_UNEVENNESS = 3.0
_REC709 = np.array([0.2126, 0.7152, 0.0722])
_DARKEST = 2e-3
# Threads a side of a part of which the light is compared with that of others.
_PART = 5


def light_over(
    path: str,
    shape: tuple[int, int],
    grid: ThreadGrid,
    crossings: Crossings,
    warp_up: NDArray[np.bool_],
    orders: tuple[ColourOrder, ColourOrder],
) -> NDArray[np.float64]:
    """Relative brightness of the light at each pixel [height, width], 1 at the middle of the picture.

    Crossings of one colour that lie on top differ by their light alone: a plane and a bowl are fitted to the
    logarithms of all of them, beside a level for each colour of each family.

    Args:
        path: of the photograph, for messages.
        shape: height and width, pixels.
        warp_up: the drawdown of the crossings.
        orders: colours of warp and weft.

    Raises:
        InputError: light that is more than three times as bright in one place as in another.
    """
    picks, ends = crossings.shape
    warp, weft = orders[0].of_threads(ends), orders[1].of_threads(picks)
    level = np.where(warp_up, warp[None, :], len(orders[0].colours) + weft[:, None]).ravel()
    # Where the crossings are, in shares of the picture; the grid is as good as straight for this.
    x = (np.arange(ends) + crossings.first[0] + 0.5 - grid.warp.number.mean()) / np.ptp(grid.warp.number)
    y = (np.arange(picks) + crossings.first[1] + 0.5 - grid.weft.number.mean()) / np.ptp(grid.weft.number)
    columns, rows = (part.ravel() for part in np.meshgrid(x, y))
    light = np.log(np.maximum(srgb_to_linear(np.clip(crossings.colour, 0, 1)) @ _REC709, _DARKEST)).ravel()
    levels = np.eye(int(level.max()) + 1)[level]
    fitted, *_ = np.linalg.lstsq(np.hstack([levels, _terms(columns, rows)]), light, rcond=None)
    v, u = np.meshgrid(*((np.arange(side) + 0.5) / side - 0.5 for side in shape), indexing="ij")
    # Picks count upwards.
    smooth = _terms(u, -v) @ fitted[levels.shape[1] :]
    whole = float(np.exp(np.ptp(smooth)))
    if whole > MAX_UNEVENNESS:
        raise InputError(
            f"{path} is unevenly lit, {whole:.1f} times as bright on one side as on another: lay the cloth "
            "flat, and light all of it alike."
        )
    # The bowl and the plane are 0 at the middle, where cameras have no fall-off, and white is looked at.
    return np.asarray(np.exp(smooth))


def patchiness(
    crossings: Crossings, warp_up: NDArray[np.bool_], orders: tuple[ColourOrder, ColourOrder]
) -> float:
    """Brightest over darkest part of evenly lit cloth, of its colours: 1 without shadows, folds and labels.

    Parts are squares of five threads a side; a median of each leaves out single threads of another shade.
    """
    picks, ends = crossings.shape
    warp, weft = orders[0].of_threads(ends), orders[1].of_threads(picks)
    level = np.where(warp_up, warp[None, :], len(orders[0].colours) + weft[:, None])
    light = np.log(np.maximum(srgb_to_linear(np.clip(crossings.colour, 0, 1)) @ _REC709, _DARKEST))
    for each in np.unique(level):
        light[level == each] -= np.median(light[level == each])
    parts = [
        float(np.median(light[row : row + _PART, column : column + _PART]))
        for row in range(0, picks - _PART + 1, _PART)
        for column in range(0, ends - _PART + 1, _PART)
    ]
    return float(np.exp(max(parts) - min(parts))) if parts else 1.0


def _terms(x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.stack([x, y, x * x, y * y], axis=-1)
