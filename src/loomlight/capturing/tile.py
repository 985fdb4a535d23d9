"""One repeat of a photographed cloth: the mean of all its repeats in the picture, and the same of a fabric.

Threads that wander lie over each other in the mean, and what differs from repeat to repeat is averaged out:
fibres, hairs, dust, noise. A fabric's repeat is rendered straight and made as unsharp as the mean is.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil

import numpy as np
from numpy.typing import NDArray

from loomlight.capturing.photographer import Framing, Light, photograph
from loomlight.capturing.thread_grid import ThreadGrid
from loomlight.core.colour import linear_to_srgb
from loomlight.fabric.fabric import Fabric

# Samples a thread of a tile: enough for a highlight, at most as many as a photograph has pixels.
MAX_SAMPLES_A_THREAD, MIN_SAMPLES_A_THREAD = 10, 6
# Threads a side that are rendered at least, so that fibres and plies average out.
_MIN_RENDERED = 16


@dataclass(frozen=True, eq=False)
class Tile:
    """One repeat, of picks upwards and ends to the right.

    Attributes:
        linear: linear RGB [rows, columns, 3], of so many samples a thread; row 0 is the lowest.
        counts: pixels that each mean is of [rows, columns]; 0 where none is.
        variance: of encoded pixels about these means, a mean over channels [rows, columns].
        samples: rows a pick and columns an end.
        pixels: of the picture that a sample has.
    """

    linear: NDArray[np.float64]
    counts: NDArray[np.float64]
    variance: NDArray[np.float64]
    samples: tuple[int, int]
    pixels: float = 1.0

    @property
    def repeat(self) -> tuple[int, int]:
        """Picks and ends."""
        return self.linear.shape[0] // self.samples[0], self.linear.shape[1] // self.samples[1]

    @property
    def repeats(self) -> float:
        """How often the repeat is seen, about."""
        shown = self.counts[self.counts > 0]
        return float(np.median(shown) / self.pixels) if shown.size else 0.0

    @property
    def within(self) -> float:
        """Mean square of encoded pixels about these means."""
        return float((self.counts * self.variance).sum() / max(float(self.counts.sum()), 1.0))

    @property
    def encoded(self) -> NDArray[np.float64]:
        """sRGB-encoded."""
        return linear_to_srgb(self.linear)


def folded(
    linear: NDArray[np.float32],
    encoded: NDArray[np.float64],
    grid: ThreadGrid,
    origin: tuple[float, float],
    repeat: tuple[int, int],
    once: bool = False,
    samples: tuple[int, int] | None = None,
) -> Tile:
    """The mean repeat of a picture.

    Args:
        linear, encoded: the picture [height, width, 3].
        origin: numbers of the end and of the pick, in the grid's, at which a repeat begins.
        repeat: picks and ends.
        once: it does not repeat: only its first place counts.
        samples: rows a pick and columns an end; as many as the picture has pixels by default.
    """
    picks, ends = repeat
    if samples is None:
        pixels = 1 / max(grid.warp.per_px, grid.weft.per_px)
        samples = (int(np.clip(round(pixels), MIN_SAMPLES_A_THREAD, MAX_SAMPLES_A_THREAD)),) * 2
    height, width = picks * samples[0], ends * samples[1]
    x = np.mod(grid.warp.number - origin[0], ends) * samples[1]
    y = np.mod(grid.weft.number - origin[1], picks) * samples[0]
    columns = np.minimum(x.astype(np.intp), width - 1)
    rows = np.minimum(y.astype(np.intp), height - 1)
    size = height * width
    index = (rows * width + columns).ravel()
    if once:
        number_x, number_y = grid.warp.number - origin[0], grid.weft.number - origin[1]
        counted = ((number_x >= 0) & (number_x < ends) & (number_y >= 0) & (number_y < picks)).ravel()
        index, linear, encoded = (
            index[counted],
            linear.reshape(-1, 3)[counted],
            encoded.reshape(-1, 3)[counted],
        )
    counts = np.bincount(index, minlength=size).astype(np.float64)

    def means(picture: NDArray[np.floating]) -> NDArray[np.float64]:
        sums = [np.bincount(index, channel.ravel(), size) for channel in np.moveaxis(picture, -1, 0)]
        return np.asarray(np.stack(sums, axis=-1) / np.maximum(counts, 1)[:, None])

    shape = (height, width)
    squares = means(np.square(encoded)) - np.square(means(encoded))
    variance = np.maximum(squares, 0).mean(axis=-1).reshape(shape)
    pixels = 1 / (grid.warp.per_px * grid.weft.per_px * samples[0] * samples[1])
    return Tile(means(linear).reshape(*shape, 3), counts.reshape(shape), variance, samples, pixels)


def rendered(
    fabric: Fabric, samples: tuple[int, int], light: Light, spp: int = 1, seed: int = 0
) -> NDArray[np.float64]:
    """One repeat of a fabric from above, linear RGB [rows, columns, 3], samples as a `Tile` has them."""
    width, height = fabric.repeat_mm
    ends, picks = fabric.draft.ends, fabric.draft.picks
    times = [max(1, ceil(_MIN_RENDERED / count)) for count in (ends, picks)]
    columns, rows = ends * samples[1], picks * samples[0]
    # A large repeat is rendered once, and fibres average out over its threads.
    framing = Framing(
        (columns * times[0], rows * times[1]),
        np.diag([width / columns, height / rows, 1.0]),
        1000.0 * max(width, height),
    )
    whole = photograph(fabric, framing, light, spp, seed)
    parts = whole.reshape(times[1], rows, times[0], columns, 3)
    return np.asarray(parts.mean(axis=(0, 2)), np.float64)


def unsharp(linear: NDArray[np.float64], deviation: tuple[float, float]) -> NDArray[np.float64]:
    """A repeat blurred by a Gaussian of so many samples, of rows and columns; it goes on beyond its sides."""
    for axis, sigma in enumerate(deviation):
        count = linear.shape[axis]
        gain = np.exp(-2 * np.square(np.pi * sigma * np.fft.rfftfreq(count)))
        shape = [1, 1, 1]
        shape[axis] = -1
        linear = np.fft.irfft(np.fft.rfft(linear, axis=axis) * gain.reshape(shape), count, axis=axis)
    return linear
