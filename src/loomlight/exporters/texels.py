"""Means of a fabric over the texels of whole repeats: what textures of a standard material are made of.

Points of the cloth, seen from straight above, are gathered on a grid finer than the texels. Each texel
has the mean normal of its points and the covariance of their slopes about it, by which roughness is widened
(LEAN mapping, Olano and Baker 2010), and the fibre direction of each family.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from drjit.llvm import Float
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.maps import ClothSurface

Numbers = NDArray[np.float64]
# Points across a texel, at least, and across the finest thread.
_POINTS_PER_TEXEL, _POINTS_PER_THREAD = 4, 8
# Points that are looked at at once: their arrays stay near the processor, and take 100 MB.
_MAX_POINTS = 1 << 19
_MAX_TEXTURE = 4096
# Texels whose means are gathered at once: 500 MB.
_MAX_BAND = 1 << 20
# Threads across textures of uneven yarns, at least.
_UNEVEN_THREADS = 24
# Texels that yarns cover less are holes, which say nothing of the yarns.
MIN_COVER = 0.02
# Slopes about the mean normal are at most this, or a few points at the outline of a yarn would outweigh all
# others.
_STEEPEST = 3.0


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


def texture_grid(
    fabric: Fabric, texel_mm: float | None, repeats: tuple[int, int] | None = None
) -> tuple[int, int]:
    """Columns and rows of texels of `repeats`, by default `tile_repeats`; without a size, eight a thread.

    Raises:
        InputError: more than 4096 a side.
    """
    (width, height), (across, up) = fabric.layout().size, repeats or tile_repeats(fabric)
    if texel_mm is None:
        picks, ends = fabric.layout().warp_on_top.shape
        columns, rows = 8 * across * ends, 8 * up * picks
        factor = max(1.0, max(columns, rows) / _MAX_TEXTURE)
        columns, rows = int(columns / factor), int(rows / factor)
    else:
        columns, rows = (max(4, round(side / texel_mm)) for side in (across * width, up * height))
    if max(columns, rows) > _MAX_TEXTURE:
        raise InputError(
            f"Textures of {columns} × {rows} texels are too large, at most {_MAX_TEXTURE} a side: "
            "choose a larger distance."
        )
    return columns, rows


def tile_repeats(fabric: Fabric, threads: int = _UNEVEN_THREADS) -> tuple[int, int]:
    """Repeats across and up that textures hold: one, or where yarns are uneven as many as have these threads.

    Few threads that differ would show as a pattern.
    """
    picks, ends = fabric.layout().warp_on_top.shape
    appearance = fabric.appearance()
    is_uneven = any(family.detail.is_on for family in (appearance.warp, appearance.weft))
    if not (is_uneven or appearance.is_irregular or appearance.variation.colour_noise > 0):
        return 1, 1
    return -(-threads // ends), -(-threads // picks)


class TexelGrid:
    """The texels of whole repeats of a fabric: row 0 at the lower edge, column 0 at the left.

    Args:
        repeats: across and up; by default `tile_repeats`.
        back: of the face behind, in the same places: its frame is the front's with z turned.
    """

    def __init__(
        self,
        fabric: Fabric,
        columns: int,
        rows: int,
        repeats: tuple[int, int] | None = None,
        back: bool = False,
    ) -> None:
        self.columns, self.rows, self.back = columns, rows, back
        across, up = repeats or tile_repeats(fabric)
        layout = fabric.layout()
        picks, ends = layout.warp_on_top.shape
        width, height = map(float, layout.size)
        self.size = across * width, up * height
        self._fabric = fabric
        self._surface = ClothSurface(fabric, Float, (across, up))
        # Points across and up in a texel.
        self._points = tuple(
            max(_POINTS_PER_TEXEL, math.ceil(_POINTS_PER_THREAD * threads / texels))
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

        def of_texels(values: NDArray[np.generic]) -> Numbers:
            """Points of each texel [texels, points, ...]."""
            return values.reshape(len(row), nx * ny, *values.shape[1:]).astype(np.float64)

        # Take the means of what the yarns show.
        seen = of_texels(~point.hole)
        weights = seen[..., None] * np.stack(
            [of_texels(point.warp_share), of_texels(1 - point.warp_share)], axis=-1
        )
        visible = np.maximum(seen.sum(1), 1e-9)
        share = weights.sum(1) / visible[:, None]
        normals, tangents = of_texels(point.normal), of_texels(point.tangent)
        mean = (normals * seen[..., None]).sum(1) / visible[:, None]
        length = np.linalg.norm(mean, axis=-1, keepdims=True)
        normal = np.where(length > 1e-6, mean / np.maximum(length, 1e-6), [0.0, 0, 1])
        # Take the covariance of slopes, and the mean of directions.
        axis_x, axis_y = (axis[:, None] for axis in frames(normal))
        up = np.maximum((normals * normal[:, None]).sum(-1), 0.05)
        slopes = np.stack([(normals * axis).sum(-1) / -up for axis in (axis_x, axis_y)], axis=-1)
        slopes = np.clip(slopes, -_STEEPEST, _STEEPEST)
        covariance = np.einsum("tp,tpi,tpj->tij", seen, slopes, slopes) / visible[:, None, None]
        flat = np.stack([(tangents * axis).sum(-1) for axis in (axis_x, axis_y)], axis=-1)
        direction = np.stack([_mean_axis(flat, weights[..., f]) for f in range(2)], axis=-2)
        # Take the means of albedos.
        gain, albedos = of_texels(point.gain), []
        for name in ("diffuse_reflect", "diffuse_transmit", "specular_reflect"):
            means = []
            for f, family in enumerate((appearance.warp, appearance.weft)):
                table = np.asarray(getattr(family, name), np.float64)
                colours = of_texels(table[point.threads[f]])
                if name != "specular_reflect":
                    colours = colours * gain
                sums = (colours * weights[..., f, None]).sum(1)
                means.append(sums / np.maximum(weights[..., f].sum(1), 1e-9)[:, None])
            albedos.append(np.stack(means, axis=-2))
        return Texels(
            cover=seen.mean(1),
            height=(of_texels(point.height) * seen).sum(1) / visible,
            share=share,
            normal=normal,
            covariance=covariance,
            direction=direction,
            diffuse=albedos[0],
            transmit=albedos[1],
            specular=albedos[2],
            alpha=np.array([family.roughness for family in (appearance.warp, appearance.weft)]),
        )


def _mean_axis(vectors: Numbers, weights: Numbers) -> Numbers:
    """Mean of directions without a sign [..., points, 2] by doubled angles; (1, 0) where there are none."""
    x, y = vectors[..., 0], vectors[..., 1]
    cosine, sine = ((weights * v).sum(-1) for v in (x * x - y * y, 2 * x * y))
    angle = 0.5 * np.arctan2(sine, cosine)
    return np.stack([np.cos(angle), np.sin(angle)], axis=-1)
