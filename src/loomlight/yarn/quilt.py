"""The relief of quilted cloth: wadding between two layers lifts the outer one, and stitches hold it down.

Between stitches the outer layer is a thin plate under an even pressure, ∇⁴M = p with M pinned where threads
tie; p is such that M is as high as the wadding is thick. It is solved on a grid over the repeat and read by
bicubic Hermite interpolation, whose slope is continuous.
"""

from __future__ import annotations

from functools import lru_cache

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Mask, UInt
from loomlight.core.backend import ArrayTypes, clip, upload
from loomlight.yarn.cells import Count
from loomlight.yarn.geometry import CellBounds, Relief
from loomlight.yarn.layout import ClothLayout
from loomlight.yarn.max_heights import PYRAMID_RADII

# Most nodes of the grid along either side.
_MAX_NODES = 256
# Somewhere stitches leave a circle free of at least this radius, in threads of the outer layer.
_MIN_FREE = 4.0
# Residual, of the pressure, at which the plate is solved, and most steps until there.
_RESIDUAL, _MAX_STEPS = 1e-4, 400
# Interpolation goes beyond the heights of nodes by less than this share of the relief.
_OVERSHOOT = 0.02


def wadding_of(layout: ClothLayout, straight: list[bool]) -> NDArray[np.bool_]:
    """Which layers are wadding: between two that threads tie to one another; none where layers change places.

    Args:
        straight: of each layer, whether nothing interlaces in it.
    """
    number = np.arange(len(layout.layers))
    between = [
        (number > min(tied.own, tied.over)) & (number < max(tied.own, tied.over)) for tied in layout.ties
    ]
    if layout.stacking is not None or not between:
        return np.zeros(len(number), bool)
    return np.any(between, axis=0) & straight


def quilted(layout: ClothLayout, wadding: NDArray[np.bool_]) -> NDArray[np.float64] | None:
    """The relief on a grid over the repeat, from −1 about stitches to 0 [rows, columns]; None without any.

    Stitches are the ties between the layers on either side of wadding, a bool of each layer.
    """
    ties = [
        tied for tied in layout.ties if wadding[min(tied.own, tied.over) + 1 : max(tied.own, tied.over)].any()
    ]
    if not ties:
        return None
    # Threads that tie may be few: those of the layer that they tie count.
    over = layout.layers[ties[0].over].layout
    pitches = [family.spacing.sum() / family.spacing.size for family in (over.warp, over.weft)]
    pitch = max(min(pitches), max(layout.size) / _MAX_NODES)
    columns, rows = (max(4, round(length / pitch)) for length in layout.size)
    pinned = np.zeros((rows, columns), bool)
    for tied in ties:
        pick, end = np.nonzero(tied.places)
        places = []
        for family, threads, start, nodes in (
            (tied.layer.layout.warp, end, tied.layer.start[0], columns),
            (tied.layer.layout.weft, pick, tied.layer.start[1], rows),
        ):
            centre = (np.cumsum(family.spacing) - family.spacing / 2)[threads] + start
            places.append(np.rint(centre / family.spacing.sum() * nodes).astype(int) % nodes)
        pinned[places[1], places[0]] = True
    if _near(pinned, _MIN_FREE * min(pitches) / pitch).all():
        return None
    steps = layout.size[0] / columns, layout.size[1] / rows
    return _plate(pinned.shape, pinned.tobytes(), steps)


def _near(pinned: NDArray[np.bool_], radius: float) -> NDArray[np.bool_]:
    """Nodes of a repeating grid that are nearer to a pinned one than a radius, in nodes."""
    near, reach = pinned.copy(), int(radius)
    for down in range(-reach, reach + 1):
        for across in range(-reach, reach + 1):
            if down * down + across * across < radius * radius:
                near |= np.roll(pinned, (down, across), (0, 1))
    return near


@lru_cache(maxsize=8)
def _plate(shape: tuple[int, int], pins: bytes, steps: tuple[float, float]) -> NDArray[np.float64]:
    """The plate under even pressure, from −1 to 0 at its highest, where it is pinned near −1 [rows, columns].

    By conjugate gradients, with the plate that is pinned nowhere, of which Fourier's waves are the solutions,
    as preconditioner.
    """
    free = ~np.frombuffer(pins, bool).reshape(shape)
    waves = [
        (2 - 2 * np.cos(2 * np.pi * np.fft.fftfreq(count))) / step**2
        for count, step in zip(shape, steps[::-1], strict=True)
    ]
    stiffness = (waves[0][:, None] + waves[1][: shape[1] // 2 + 1][None]) ** 2
    # Between pins no wave is longer than a few of the nodes there.
    softest = float(np.sort(stiffness, axis=None)[min(stiffness.size - 1, 2)])

    def applied(values: NDArray[np.float64], factors: NDArray[np.float64]) -> NDArray[np.float64]:
        return free * np.fft.irfft2(factors * np.fft.rfft2(values), shape)

    inverse = 1 / (stiffness + softest)
    height, rest = np.zeros(shape), free.astype(np.float64)
    tolerance = _RESIDUAL * float(np.linalg.norm(rest))
    turned = applied(rest, inverse)
    direction, product = turned, float(np.vdot(rest, turned))
    for _ in range(_MAX_STEPS):
        force = applied(direction, stiffness)
        share = product / float(np.vdot(direction, force))
        height = height + share * direction
        rest = rest - share * force
        if np.linalg.norm(rest) < tolerance:
            break
        turned = applied(rest, inverse)
        before, product = product, float(np.vdot(rest, turned))
        direction = turned + product / before * direction
    # Plates that are bent over a line of pins may dip a little beyond it.
    height = (height - height.max()) / np.ptp(height)
    # Interpolated heights stay between −1 and 0 too.
    return (height + 0.5) * (1 - 2 * _OVERSHOOT) - 0.5


def _highest_in_cells(nodes: NDArray[np.float64]) -> NDArray[np.float64]:
    """Bounds of the interpolant in the cells after nodes [rows, columns]: the highest of its control points.

    Args:
        nodes: value, slopes along x and y, and the slope of the slope [rows, columns, 4].
    """
    value, of_x, of_y, of_both = np.moveaxis(nodes, -1, 0)
    highest = np.full(value.shape, -np.inf)
    # Control points stand a third of a cell from its nodes, on its side.
    for row, along in ((0, 1 / 3), (1, -1 / 3)):
        for column, across in ((0, 1 / 3), (1, -1 / 3)):
            for points in (
                value,
                value + across * of_x,
                value + along * of_y,
                value + across * of_x + along * of_y + across * along * of_both,
            ):
                highest = np.maximum(highest, np.roll(points, (-row, -column), (0, 1)))
    return highest


def _highest_around(values: NDArray[np.float64], reach: list[int]) -> NDArray[np.float64]:
    """The highest up to so many columns and rows away [rows, columns], which repeat."""
    for axis, steps in ((1, reach[0]), (0, reach[1])):
        steps = min(steps, values.shape[axis] // 2)
        values = np.max([np.roll(values, step, axis) for step in range(-steps, steps + 1)], axis=0)
    return values


class QuiltRelief:
    """A grid of heights over the repeat on one backend.

    Args:
        heights: of its nodes, the first at x = y = 0 [rows, columns], which repeat.
        size: of the repeat, millimetres.
        finest: extents along x and y that windows are counted in, see `rays.Surface.max_heights`.
    """

    def __init__(
        self,
        heights: NDArray[np.float64],
        size: tuple[float, float],
        finest: tuple[float, float],
        types: ArrayTypes,
    ) -> None:
        self._types = types
        rows, columns = heights.shape
        steps = size[0] / columns, size[1] / rows

        def slope(values: NDArray[np.float64], axis: int) -> NDArray[np.float64]:
            return (np.roll(values, -1, axis) - np.roll(values, 1, axis)) / 2

        along = slope(heights, 0)
        nodes = np.stack([heights, slope(heights, 1), along, slope(along, 1)], axis=-1)
        self._nodes = upload(types.Float, nodes.astype(np.float32))
        highest = _highest_in_cells(nodes)
        self._highest = upload(types.Float, _highest_around(highest, [1, 1]).astype(np.float32))
        windows = [
            _highest_around(
                highest, [int(radius * fine / step) + 1 for fine, step in zip(finest, steps, strict=True)]
            )
            for radius in PYRAMID_RADII
        ]
        self._windows = upload(types.Float, np.stack(windows, axis=-1).astype(np.float32))
        self._steps = [dr.opaque(types.Float, step) for step in steps]
        self._per_length = [dr.opaque(types.Float, 1 / step) for step in steps]
        self._counts = [Count.of(count, types) for count in (columns, rows)]
        self._last = [dr.opaque(types.Float, count - 1) for count in (columns, rows)]
        self._columns = dr.opaque(types.UInt32, columns)

    def at(self, x: Float, y: Float) -> Relief:
        """The height and its slopes at draft coordinates, millimetres."""
        types = self._types
        cells = [self._cell(axis, place) for axis, place in enumerate((x, y))]
        (columns, across, across_rate), (rows, along, along_rate) = cells
        height, slope_x, slope_y = types.Float(0), types.Float(0), types.Float(0)
        for row in (0, 1):
            for column in (0, 1):
                node = dr.gather(types.Vector4, self._nodes, rows[row] * self._columns + columns[column])
                # Value and slope along y, of the value and the slope along x.
                for part in (0, 1):
                    weight, rate = across[part][column], across_rate[part][column]
                    of_y = node[part] * along[0][row] + node[2 + part] * along[1][row]
                    rate_y = node[part] * along_rate[0][row] + node[2 + part] * along_rate[1][row]
                    height = dr.fma(weight, of_y, height)
                    slope_x = dr.fma(rate, of_y, slope_x)
                    slope_y = dr.fma(weight, rate_y, slope_y)
        return Relief(height, slope_x * self._per_length[0], slope_y * self._per_length[1])

    def bounds(self, x: Float, y: Float, right: Mask, up: Mask) -> CellBounds:
        """The highest of the cell of the grid at draft coordinates and of those around, and how far these go.

        A single cell would end soon, and rays that pass it by would be asked again.
        """
        (column, of_column), (row, of_row) = (self._place(axis, place) for axis, place in enumerate((x, y)))
        index = self._index(row, column)
        return CellBounds(
            dr.gather(self._types.Float, self._highest, index),
            self._steps[0] * dr.select(right, 2 - of_column, 1 + of_column),
            self._steps[1] * dr.select(up, 2 - of_row, 1 + of_row),
        )

    def windows(self, x: Float, y: Float) -> list[Float]:
        """The highest in windows around draft coordinates, the widest first; see `Surface.max_heights`."""
        column, row = (self._place(axis, place)[0] for axis, place in enumerate((x, y)))
        found = dr.gather(self._types.Vector4, self._windows, self._index(row, column))
        return [found[number] for number in reversed(range(len(PYRAMID_RADII)))]

    def _index(self, row: Float, column: Float) -> UInt:
        return dr.fma(self._types.UInt32(row), self._columns, self._types.UInt32(column))

    def _place(self, axis: int, place: Float) -> tuple[Float, Float]:
        """The node before a place along an axis, and how far beyond it lies, in steps."""
        local = place * self._per_length[axis]
        whole = dr.floor(local)
        return clip(self._counts[axis].divide(whole)[1], 0, self._last[axis]), local - whole

    def _cell(self, axis: int, place: Float) -> tuple[list[Float], list[list[Float]], list[list[Float]]]:
        """Nodes before and after a place; weights of their values and slopes; derivatives of these."""
        types = self._types
        before, share = self._place(axis, place)
        after = dr.select(before < self._last[axis], before + 1, 0)
        rest = 1 - share
        weights = [
            [dr.square(rest) * (1 + 2 * share), dr.square(share) * (1 + 2 * rest)],
            [share * dr.square(rest), -dr.square(share) * rest],
        ]
        steep = 6 * share * rest
        rates = [[-steep, steep], [rest * (1 - 3 * share), share * (3 * share - 2)]]
        return [types.UInt32(before), types.UInt32(after)], weights, rates
