"""Means of a fabric over the texels of whole repeats: what textures of a standard material are made of.

Points of the cloth, seen from straight above, are gathered on a grid finer than the texels. Each texel
has the mean normal of its points and the covariance of their slopes about it, by which roughness is widened
(LEAN mapping, Olano and Baker 2010), and the fibre direction of each family.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product
from typing import NamedTuple

import numpy as np
from drjit.llvm import Float
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.maps import ClothSurface

Numbers = NDArray[np.float64]
# Points across a texel, at least, and across the finest thread, where they do not come to more than so many.
_POINTS_PER_TEXEL, _POINTS_PER_THREAD, _LEAST_PER_THREAD = 4, 8, 4
_POINTS_IN_ALL = 1 << 23
# Points that are looked at at once: their arrays stay near the processor, and take 100 MB.
_MAX_POINTS = 1 << 19
_MAX_TEXTURE = 4096
# Texels whose means are gathered at once: 500 MB.
_MAX_BAND = 1 << 20
# Texels a thread where no size of texels is given.
_TEXELS_PER_THREAD = 8
# Threads across textures of uneven yarns, at least, and texels across and crossings at most: they show as a
# pattern where a picture holds several, and a few megabytes and half a minute buy no more.
_FEWEST_THREADS, _UNEVEN_TEXELS, _UNEVEN_CROSSINGS = 24, 1024, 1 << 20
# Texels that yarns cover less are holes, which say nothing of the yarns.
MIN_COVER = 0.02
# Slopes about the mean normal are at most this, or a few points at the outline of a yarn would outweigh all
# others.
_STEEPEST = 3.0
# The albedos that texels hold, by their names in an appearance.
_ALBEDOS = ("diffuse_reflect", "diffuse_transmit", "specular_reflect")


@dataclass(frozen=True, eq=False)
class Texels:
    """Texels [...] of one face of the cloth, in its frame: x along the weft, y along the warp, z to the eye.

    Attributes:
        cover: share that yarns cover, 0 to 1.
        height: mean of the yarns, towards the eye, millimetres; 0 where there are none.
        share: of the warp and of the weft in what is covered [..., 2].
        normal: unit mean normal [..., 3].
        covariance: of slopes about it, along its x and y axes [..., 2, 2]; see `frames`.
        direction: unit vectors along the fibres of each family in these axes [..., 2 families, 2].
        diffuse, transmit, specular: mean albedos of each family's visible threads [..., 2, 3].
        alpha: α of the fibres of each family [2].
    """

    cover: Numbers
    height: Numbers
    share: Numbers
    normal: Numbers
    covariance: Numbers
    direction: Numbers
    diffuse: Numbers
    transmit: Numbers
    specular: Numbers
    alpha: Numbers

    def where(self, chosen: NDArray[np.bool_]) -> Texels:
        """Some of the texels."""
        arrays = {name: values[chosen] for name, values in vars(self).items() if name != "alpha"}
        return Texels(**arrays, alpha=self.alpha)


def nearest_covered(cover: NDArray[np.floating]) -> NDArray[np.int64]:
    """Flat indices [rows, columns] of texels whose yarns stand for each: its own, in holes the nearest ones.

    Filters between texels would mix in what an empty one holds.
    """
    index = np.arange(cover.size).reshape(cover.shape)
    known = cover > MIN_COVER
    while known.any() and not known.all():
        for axis, step in ((0, 1), (0, -1), (1, 1), (1, -1)):
            reached = np.roll(known, step, axis) & ~known
            index[reached] = np.roll(index, step, axis)[reached]
            known |= reached
    return index


def frames(normal: Numbers) -> tuple[Numbers, Numbers]:
    """Axes of the tangent plane of normals [..., 3]: x of the cloth made orthogonal, and normal × x."""
    x = np.zeros_like(normal)
    x[..., 0] = 1
    x -= normal * normal[..., :1]
    x /= np.linalg.norm(x, axis=-1, keepdims=True)
    return x, np.cross(normal, x)


class TextureSize(NamedTuple):
    """Columns and rows of texels, and the repeats across and up that they hold."""

    columns: int
    rows: int
    repeats: tuple[int, int]


def texture_grid(
    fabric: Fabric, texel_mm: float | None, repeats: tuple[int, int] | None = None
) -> TextureSize:
    """Textures of `repeats`, by default `tile_repeats`, whose texels are so large; by default eight a thread.

    Raises:
        InputError: more than 4096 a side.
    """
    (width, height), (across, up) = fabric.layout().size, repeats or tile_repeats(fabric, texel_mm)
    if texel_mm is None:
        picks, ends = fabric.layout().warp_on_top.shape
        columns, rows = _TEXELS_PER_THREAD * across * ends, _TEXELS_PER_THREAD * up * picks
        factor = max(1.0, max(columns, rows) / _MAX_TEXTURE)
        columns, rows = int(columns / factor), int(rows / factor)
    else:
        columns, rows = (max(4, round(side / texel_mm)) for side in (across * width, up * height))
    if max(columns, rows) > _MAX_TEXTURE:
        raise InputError(
            f"Textures of {columns} × {rows} texels are too large, at most {_MAX_TEXTURE} a side: "
            "choose a larger distance."
        )
    return TextureSize(columns, rows, (across, up))


def tile_repeats(fabric: Fabric, texel_mm: float | None, texels: int = _UNEVEN_TEXELS) -> tuple[int, int]:
    """Repeats across and up that textures hold: one, or of uneven yarns as many as there is room for.

    Args:
        texel_mm: side of a texel; None is eight a thread.
        texels: across textures of uneven yarns at most, unless that were less than 24 threads.
    """
    picks, ends = fabric.layout().warp_on_top.shape
    appearance = fabric.appearance()
    is_uneven = any(family.detail.is_on for family in (appearance.warp, appearance.weft))
    if not (is_uneven or appearance.is_irregular or appearance.variation.colour_noise > 0):
        return 1, 1

    threads = np.array([ends, picks])
    sides = threads * _TEXELS_PER_THREAD if texel_mm is None else np.divide(fabric.layout().size, texel_mm)
    counts = texels / np.asarray(sides, float)
    counts *= min(1.0, math.sqrt(_UNEVEN_CROSSINGS / np.prod(counts * threads)))
    across, up = np.maximum(counts.astype(int), -(-_FEWEST_THREADS // threads))
    return int(across), int(up)


class TexelGrid:
    """The texels of whole repeats of a fabric: row 0 at the lower edge, column 0 at the left.

    Args:
        repeats: across and up.
        back: of the face behind, in the same places: its frame is the front's with z turned.
    """

    def __init__(
        self,
        fabric: Fabric,
        columns: int,
        rows: int,
        repeats: tuple[int, int],
        back: bool = False,
    ) -> None:
        self.columns, self.rows, self.back = columns, rows, back
        across, up = repeats
        layout = fabric.layout()
        picks, ends = layout.warp_on_top.shape
        width, height = map(float, layout.size)
        self.size = across * width, up * height
        self._fabric = fabric
        self._surface = ClothSurface(fabric, Float, (across, up))
        # Points across and up in a texel.
        crossings = across * ends * up * picks
        per_thread = min(max(math.sqrt(_POINTS_IN_ALL / crossings), _LEAST_PER_THREAD), _POINTS_PER_THREAD)
        self._points = tuple(
            max(_POINTS_PER_TEXEL, math.ceil(per_thread * threads / texels))
            for threads, texels in ((across * ends, columns), (up * picks, rows))
        )

    @property
    def step(self) -> tuple[float, float]:
        """Width and height of a texel, millimetres."""
        return self.size[0] / self.columns, self.size[1] / self.rows

    def places(self, row: Numbers, column: Numbers) -> Numbers:
        """Where in the draft places are that are so many texels from the lower left [2, n], millimetres.

        Threads wander.
        """
        return self._surface.place(column * self.step[0], row * self.step[1])

    def at(self, row: NDArray[np.int64], column: NDArray[np.int64]) -> Texels:
        """The texels of rows and columns [n]."""
        most = max(1, _MAX_POINTS // math.prod(self._points))
        parts = [
            self._texels(row[first : first + most], column[first : first + most])
            for first in range(0, len(row), most)
        ]
        arrays = {
            name: np.concatenate([vars(part)[name] for part in parts])
            for name in vars(parts[0])
            if name != "alpha"
        }
        return Texels(**arrays, alpha=parts[0].alpha)

    def bands(self) -> Iterator[Texels]:
        """All texels, some rows at a time: arrays [rows * columns, ...]."""
        most = max(1, _MAX_BAND // self.columns)
        for first in range(0, self.rows, most):
            count = min(most, self.rows - first)
            row, column = np.divmod(np.arange(count * self.columns), self.columns)
            yield self.at(row + first, column)

    def filled(self) -> Texels:
        """All texels [rows, columns, ...]; holes have the yarns of the nearest texel that has any."""
        parts = list(self.bands())
        whole = {
            name: np.concatenate([vars(part)[name] for part in parts])
            for name in vars(parts[0])
            if name != "alpha"
        }
        nearest = nearest_covered(whole["cover"].reshape(self.rows, self.columns))
        arrays = {name: values[nearest] for name, values in whole.items()}
        cover = whole["cover"].reshape(nearest.shape)
        return Texels(**(arrays | {"cover": cover}), alpha=parts[0].alpha)

    def _texels(self, row: NDArray[np.int64], column: NDArray[np.int64]) -> Texels:
        # Look at the points of each texel.
        appearance = self._fabric.appearance()
        (nx, ny), (step_x, step_y) = self._points, self.step
        v, u = np.divmod(np.arange(nx * ny), nx)
        x = ((column[:, None] + (u + 0.5) / nx) * step_x).ravel()
        y = ((row[:, None] + (v + 0.5) / ny) * step_y).ravel()
        # Plies and fibres as a footprint of a texel shows them: the model that is fitted has no others.
        side = math.sqrt(0.5 * (step_x**2 + step_y**2))
        point = self._surface.at(x, y, side, self.back)

        def of_texels(values: NDArray[np.generic]) -> NDArray[np.float32]:
            """Points of each texel [texels, points]: single precision tells more of a mean than they do."""
            return values.reshape(len(row), nx * ny).astype(np.float32, copy=False)

        def parts_of(values: NDArray[np.generic]) -> list[NDArray[np.float32]]:
            """The same of the components of vectors; each by itself, which is quicker than together."""
            return [of_texels(np.ascontiguousarray(part)) for part in values.T]

        def mean_of(values: NDArray[np.floating], weight: NDArray[np.floating]) -> Numbers:
            """Sums over the points of each texel [texels]."""
            return np.einsum("tp,tp->t", values, weight).astype(np.float64)

        # Take the means of what the yarns show.
        seen, warp = of_texels(~point.hole), of_texels(point.warp_share)
        weights = [seen * warp, seen * (1 - warp)]
        visible = np.maximum(seen.sum(1, dtype=np.float64), 1e-9)
        sums = np.stack([each.sum(1, dtype=np.float64) for each in weights], axis=-1)
        normals, tangents = parts_of(point.normal), parts_of(point.tangent)
        mean = np.stack([mean_of(part, seen) for part in normals], axis=-1) / visible[:, None]
        length = np.linalg.norm(mean, axis=-1, keepdims=True)
        normal = np.where(length > 1e-6, mean / np.maximum(length, 1e-6), [0.0, 0, 1])

        def along(vectors: list[NDArray[np.float32]], axis: Numbers) -> NDArray[np.float32]:
            """Dot products with a vector of each texel [texels, 3]."""
            x, y, z = (part[:, None] for part in axis.T.astype(np.float32))
            return np.asarray(vectors[0] * x + vectors[1] * y + vectors[2] * z)

        # Take the covariance of slopes, and the mean of directions.
        axes = frames(normal)
        up = np.maximum(along(normals, normal), np.float32(0.05))
        slopes = [np.clip(along(normals, axis) / -up, -_STEEPEST, _STEEPEST) for axis in axes]
        covariance = np.empty((len(row), 2, 2))
        for i, j in ((0, 0), (0, 1), (1, 1)):
            covariance[:, i, j] = covariance[:, j, i] = mean_of(slopes[i] * slopes[j], seen) / visible
        flat = [along(tangents, axis) for axis in axes]
        cosines, sines = flat[0] ** 2 - flat[1] ** 2, 2 * flat[0] * flat[1]
        direction = np.stack([_mean_axis(mean_of(cosines, w), mean_of(sines, w)) for w in weights], axis=-2)
        # Take the means of albedos.
        gains = parts_of(point.gain)
        means = {name: np.empty((len(row), 2, 3)) for name in _ALBEDOS}
        for f, family in enumerate((appearance.warp, appearance.weft)):
            threads, total = point.threads[f], np.maximum(sums[:, f], 1e-9)
            for name, (channel, gain) in product(_ALBEDOS, enumerate(gains)):
                table = np.asarray(getattr(family, name), np.float32)[:, channel]
                weight = weights[f] if name == "specular_reflect" else weights[f] * gain
                means[name][:, f, channel] = mean_of(of_texels(table[threads]), weight) / total
        return Texels(
            cover=seen.mean(1, dtype=np.float64),
            height=mean_of(of_texels(point.height), seen) / visible,
            share=sums / visible[:, None],
            normal=normal,
            covariance=covariance,
            direction=direction,
            diffuse=means["diffuse_reflect"],
            transmit=means["diffuse_transmit"],
            specular=means["specular_reflect"],
            alpha=np.array([family.roughness for family in (appearance.warp, appearance.weft)]),
        )


def _mean_axis(cosine: Numbers, sine: Numbers) -> Numbers:
    """Mean of directions without a sign [..., 2], by sums of doubled angles; (1, 0) where there are none."""
    angle = 0.5 * np.arctan2(sine, cosine)
    return np.stack([np.cos(angle), np.sin(angle)], axis=-1)
