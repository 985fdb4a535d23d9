"""Maps of both faces of a standard material, prefiltered: mip pyramids of sixteen numbers a texel.

All maps of a face share one grid. What does not filter linearly is stored as what does: anisotropy as a
vector at twice its angle, and normals as they come, as the length of their mean says how much they spread.
"""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, FloatType, Mask
from loomlight.core.backend import array_types, clip, upload
from loomlight.core.errors import LoomlightWarning
from loomlight.core.footprint import Footprint
from loomlight.sources.u3m import Map, U3mFace, are_whole

Values = NDArray[np.float32]

# Numbers of a texel, in fours, as one read takes them.
CHANNELS = 16
# Texels of the finest level of a face: 340 MB with all levels.
_MAX_TEXELS = 1 << 22


@dataclass(frozen=True, eq=False)
class FaceMaps:
    """The pyramid of a face.

    Attributes:
        size_mm: width and height of what it shows.
        levels: [rows, columns, 16], the finest first; row 0 at the lower edge.
    """

    size_mm: tuple[float, float]
    levels: tuple[Values, ...]

    @classmethod
    def of(cls, face: U3mFace) -> FaceMaps:
        """The maps of a face on one grid, as fine as the finest of them."""
        width, height = face.size_mm
        sizes = [
            (
                round(each.values.shape[1] * width / each.size_mm[0]),
                round(each.values.shape[0] * height / each.size_mm[1]),
            )
            for each in vars(face).values()
            if each.size_mm is not None
        ]
        columns = max([1, *(columns for columns, _ in sizes)])
        rows = max([1, *(rows for _, rows in sizes)])
        factor = max(1.0, math.sqrt(columns * rows / _MAX_TEXELS))
        grid = _Grid((width, height), max(1, int(columns / factor)), max(1, int(rows / factor)))
        found = {name: grid.resampled(each, name) for name, each in vars(face).items()}
        angle = 4 * np.pi * found["rotation"]
        strength = found["anisotropy"]
        finest = np.concatenate(
            [
                found["base"],
                found["alpha"],
                found["normal"],
                found["roughness"],
                strength * np.cos(angle),
                strength * np.sin(angle),
                found["metalness"],
                found["transmission"],
                found["specular"],
                found["specular_tint"],
                found["sheen"],
                found["sheen_tint"],
            ],
            axis=-1,
        )
        levels = [np.ascontiguousarray(finest, np.float32)]
        while max(levels[-1].shape[:2]) > 1:
            coarse = levels[-1]
            for axis in (0, 1):
                coarse = averaged(coarse, max(1, coarse.shape[axis] // 2), axis)
            levels.append(coarse)
        return cls((width, height), tuple(levels))


@dataclass(frozen=True)
class _Grid:
    """Texels of a face."""

    size_mm: tuple[float, float]
    columns: int
    rows: int

    def resampled(self, each: Map, name: str) -> Values:
        """A map at the middles of the texels, linear between its own."""
        shape = (self.rows, self.columns, each.values.shape[2])
        if each.size_mm is None:
            return np.broadcast_to(each.values, shape)
        repeats = [side / own for side, own in zip(self.size_mm, each.size_mm, strict=True)]
        if not all(map(are_whole, repeats)):
            warnings.warn(
                f"Its map {name} repeats every {each.size_mm[0]:g} × {each.size_mm[1]:g} mm, its colour "
                f"every {self.size_mm[0]:g} × {self.size_mm[1]:g} mm: edges show where that repeats.",
                LoomlightWarning,
                stacklevel=2,
            )
        values = each.values
        for axis, (count, repeat) in enumerate(zip((self.rows, self.columns), repeats[::-1], strict=True)):
            own = values.shape[axis]
            if repeat == 1 and count == own:
                continue
            if repeat == 1 and count < own:
                values = averaged(values, count, axis)
                continue
            place = (np.arange(count) + 0.5) / count * repeat * own - 0.5
            low = np.floor(place).astype(np.int64)
            share = (place - low).astype(np.float32).reshape(-1, *(1 for _ in values.shape[axis + 1 :]))
            below, above = (np.take(values, (low + k) % own, axis) for k in (0, 1))
            values = below + share * (above - below)
        return values


def averaged(values: Values, count: int, axis: int) -> Values:
    """Means over `count` equal parts of an axis, also of parts of texels."""
    moved: Values = np.moveaxis(values, axis, 0)
    own = len(moved)
    if count * 2 == own:
        pairs: Values = np.asarray((moved[::2] + moved[1::2]) / 2, np.float32)
        return np.moveaxis(pairs, 0, axis)
    sums = np.concatenate([np.zeros((1, *moved.shape[1:])), np.cumsum(moved, 0, dtype=np.float64)])
    edges = np.linspace(0, own, count + 1)
    below = np.minimum(edges.astype(np.int64), own - 1)
    part = (edges - below).reshape(-1, *(1 for _ in moved.shape[1:]))
    at = sums[below] + part * moved[below]
    means: Values = (np.diff(at, axis=0) * (count / own)).astype(np.float32)
    return np.moveaxis(means, 0, axis)


class DeviceMaps:
    """The pyramids of both faces on one backend."""

    def __init__(self, faces: tuple[FaceMaps, FaceMaps], float_type: FloatType) -> None:
        self._types = types = array_types(float_type)
        # A face that is as the other one is held once.
        held = list({id(face): face for face in faces}.values())
        numbers = [next(k for k, each in enumerate(held) if each is face) for face in faces]
        starts: list[int] = []
        columns: list[int] = []
        rows: list[int] = []
        firsts: list[int] = []
        texels: list[Values] = []
        start = 0
        for face in held:
            firsts.append(len(starts))
            for level in face.levels:
                starts.append(start)
                rows.append(level.shape[0])
                columns.append(level.shape[1])
                start += level.shape[0] * level.shape[1]
                texels.append(level.reshape(-1))
        self._texels = upload(float_type, np.concatenate(texels))
        self._starts, self._columns, self._rows = (
            upload(types.UInt32, np.array(values, np.uint32)) for values in (starts, columns, rows)
        )
        by_face = [held[number] for number in numbers]
        self._first = upload(types.UInt32, np.array([firsts[number] for number in numbers], np.uint32))
        self._last = upload(types.UInt32, np.array([len(face.levels) - 1 for face in by_face], np.uint32))
        sizes = np.array([face.size_mm for face in by_face])
        counts = np.array([face.levels[0].shape[1::-1] for face in by_face])
        self._width, self._height = (upload(float_type, sizes[:, axis]) for axis in (0, 1))
        self._texel = upload(float_type, np.sqrt((sizes / counts).prod(axis=1)))

    def at(self, footprint: Footprint, back: Mask) -> list[Float]:
        """The sixteen numbers over footprints; on the back x runs the other way."""
        types = self._types
        face = dr.select(back, types.UInt32(1), types.UInt32(0))
        width, height, texel = (
            dr.gather(types.Float, values, face) for values in (self._width, self._height, self._texel)
        )
        x = dr.select(back, -footprint.centre.x, footprint.centre.x)
        u, v = x / width, footprint.centre.y / height
        last = dr.gather(types.UInt32, self._last, face)
        level = dr.log2(dr.fma(footprint.spread_side, 1 / texel, 1e-6))
        level = clip(level, 0, types.Float(last))
        lower = types.UInt32(level)
        upper = dr.select(lower < last, lower + 1, last)
        share = level - types.Float(lower)
        first = dr.gather(types.UInt32, self._first, face)
        fine, coarse = (self._bilinear(first + each, u, v) for each in (lower, upper))
        return [dr.lerp(a, b, share) for a, b in zip(fine, coarse, strict=True)]

    def _bilinear(self, level: Float, u: Float, v: Float) -> list[Float]:
        types = self._types
        start, columns, rows = (
            dr.gather(types.UInt32, values, level) for values in (self._starts, self._columns, self._rows)
        )
        taps = []
        for place, count in ((u, columns), (v, rows)):
            number = types.Float(count)
            # First into the repeat, so that no whole number of texels is lost far from it.
            inner = (place - dr.floor(place)) * number - 0.5
            low = dr.floor(inner)
            share = inner - low
            below = dr.select(low < 0, low + number, low)
            above = dr.select(low + 1 >= number, low + 1 - number, low + 1)
            taps.append(((types.UInt32(below), 1 - share), (types.UInt32(above), share)))
        total = [types.Vector4(0) for _ in range(CHANNELS // 4)]
        for row, vertical in taps[1]:
            for column, horizontal in taps[0]:
                texel = (start + row * columns + column) * (CHANNELS // 4)
                weight = vertical * horizontal
                for group in range(CHANNELS // 4):
                    total[group] += weight * dr.gather(types.Vector4, self._texels, texel + group)
        return [part for group in total for part in group]
