"""Means of a fabric over the texels of whole repeats: what textures of a standard material are made of.

Points of the cloth, seen from straight above, are gathered on a grid finer than the texels. Each texel
has the mean normal of its points and the covariance of their slopes about it, by which roughness is widened
(LEAN mapping, Olano and Baker 2010), and the fibre direction of each family.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from drjit.llvm import Float
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.maps import ClothSurface

Numbers = NDArray[np.float64]
# Points across a texel, at least, and across the finest thread.
_POINTS_PER_TEXEL, _POINTS_PER_THREAD = 4, 8
_MAX_POINTS = 1 << 24
_MAX_TEXTURE = 4096
# Threads across textures of uneven yarns, at least.
_UNEVEN_THREADS = 24
# Texels that yarns cover less are holes, which say nothing of the yarns.
MIN_COVER = 0.02
# Slopes about the mean normal are at most this, or a few points at the outline of a yarn would outweigh all
# others.
_STEEPEST = 3.0


# Arrays of `Texels` with an element a texel.
_OF_TEXELS = (
    "place",
    "cover",
    "share",
    "normal",
    "covariance",
    "direction",
    "diffuse",
    "transmit",
    "specular",
)


@dataclass(frozen=True, eq=False)
class Texels:
    """Texels [rows, columns, ...] of the front of whole repeats; row 0 is at the lower edge, column 0 at
    the left.

    Attributes:
        size: width and height, millimetres.
        place: where in the draft their middles are [..., 2], millimetres, as threads wander.
        cover: share that yarns cover, 0 to 1.
        share: of the warp and of the weft in what is covered [..., 2].
        normal: unit mean normal [..., 3].
        covariance: of slopes about it, along its x and y axes [..., 2, 2]; see `frames`.
        direction: unit vectors along the fibres of each family in these axes [..., 2 families, 2].
        diffuse, transmit, specular: mean albedos of each family's visible threads [..., 2, 3].
        alpha: α of the fibres of each family [2].
    """

    size: tuple[float, float]
    place: Numbers
    cover: Numbers
    share: Numbers
    normal: Numbers
    covariance: Numbers
    direction: Numbers
    diffuse: Numbers
    transmit: Numbers
    specular: Numbers
    alpha: Numbers

    def at(self, row: NDArray[np.int64], column: NDArray[np.int64]) -> Texels:
        """Some texels, by their rows and columns [n]: arrays [n, ...]."""
        chosen = {name: getattr(self, name)[row, column] for name in _OF_TEXELS}
        return replace(self, **chosen)

    def dilated(self) -> Texels:
        """The same cover, and in holes what the nearest texel with yarns has.

        Filters between texels would mix in what an empty one holds.
        """
        index = np.arange(self.cover.size).reshape(self.cover.shape)
        known = self.cover > MIN_COVER
        while known.any() and not known.all():
            for axis, step in ((0, 1), (0, -1), (1, 1), (1, -1)):
                reached = np.roll(known, step, axis) & ~known
                index[reached] = np.roll(index, step, axis)[reached]
                known |= reached
        return replace(self.at(*np.unravel_index(index, self.cover.shape)), cover=self.cover)


def frames(normal: Numbers) -> tuple[Numbers, Numbers]:
    """Axes of the tangent plane of normals [..., 3]: x of the cloth made orthogonal, and normal × x."""
    x = np.zeros_like(normal)
    x[..., 0] = 1
    x -= normal * normal[..., :1]
    x /= np.linalg.norm(x, axis=-1, keepdims=True)
    return x, np.cross(normal, x)


def texture_grid(fabric: Fabric, texel_mm: float | None) -> tuple[int, int]:
    """Columns and rows of texels of `tile_repeats`; by default eight a thread.

    Raises:
        InputError: more than 4096 a side.
    """
    picks, ends, width, height = _tile(fabric)
    if texel_mm is None:
        columns, rows = 8 * ends, 8 * picks
        factor = max(1.0, max(columns, rows) / _MAX_TEXTURE)
        columns, rows = int(columns / factor), int(rows / factor)
    else:
        columns, rows = (max(4, round(side / texel_mm)) for side in (width, height))
    if max(columns, rows) > _MAX_TEXTURE:
        raise InputError(
            f"Textures of {columns} × {rows} texels are too large, at most {_MAX_TEXTURE} a side: "
            "choose a larger distance."
        )
    return columns, rows


def tile_repeats(fabric: Fabric) -> tuple[int, int]:
    """Repeats across and up that textures hold: one, or more where yarns are uneven.

    Few threads that differ would show as a pattern.
    """
    picks, ends = fabric.layout().warp_on_top.shape
    appearance = fabric.appearance()
    is_uneven = any(family.detail.is_on for family in (appearance.warp, appearance.weft))
    if not (is_uneven or appearance.is_irregular or appearance.variation.colour_noise > 0):
        return 1, 1
    return -(-_UNEVEN_THREADS // ends), -(-_UNEVEN_THREADS // picks)


def _tile(fabric: Fabric) -> tuple[int, int, float, float]:
    """Picks, ends, width and height, millimetres, of `tile_repeats`."""
    layout, (across, up) = fabric.layout(), tile_repeats(fabric)
    picks, ends = layout.warp_on_top.shape
    width, height = map(float, layout.size)
    return up * picks, across * ends, across * width, up * height


def texels_of(fabric: Fabric, columns: int, rows: int) -> Texels:
    """The texels of `tile_repeats`."""
    appearance = fabric.appearance()
    picks, ends, width, height = _tile(fabric)
    surface = ClothSurface(fabric, Float, tile_repeats(fabric))
    nx, ny = (
        max(_POINTS_PER_TEXEL, math.ceil(_POINTS_PER_THREAD * threads / texels))
        for threads, texels in ((ends, columns), (picks, rows))
    )
    band = max(1, _MAX_POINTS // (columns * nx * ny))
    parts = []
    for first in range(0, rows, band):
        count = min(band, rows - first)
        parts.append(_points(fabric, surface, (columns, nx), (first, count, ny), rows))
    arrays = {name: np.concatenate(of_bands) for name, *of_bands in zip(_OF_TEXELS, *parts, strict=True)}
    families = (appearance.warp, appearance.weft)
    alpha = np.array([family.roughness for family in families])
    return Texels(size=(width, height), alpha=alpha, **arrays)


def _points(
    fabric: Fabric,
    surface: ClothSurface,
    across: tuple[int, int],
    along: tuple[int, int, int],
    rows: int,
) -> tuple[Numbers, ...]:
    """The arrays `_OF_TEXELS` of some rows."""
    appearance = fabric.appearance()
    _, _, width, height = _tile(fabric)
    (columns, nx), (first, count, ny) = across, along
    index = np.arange(columns * nx * count * ny)
    x = (index % (columns * nx) + 0.5) * (width / (columns * nx))
    y = (index // (columns * nx) + 0.5 + first * ny) * (height / (rows * ny))
    middles = np.arange(columns * count)
    place = surface.place(
        (middles % columns + 0.5) * (width / columns), (middles // columns + first + 0.5) * (height / rows)
    )
    # Plies and fibres as a footprint of a texel shows them: the model that is fitted has no others.
    side = math.sqrt(0.5 * ((width / columns) ** 2 + (height / rows) ** 2))
    point = surface.at(x, y, side)

    def texels(values: NDArray[np.generic]) -> Numbers:
        """Points of each texel: [rows, columns, points, ...]."""
        shape = values.shape[1:]
        grid = values.reshape(count, ny, columns, nx, *shape)
        return np.moveaxis(grid, 1, 2).reshape(count, columns, ny * nx, *shape).astype(np.float64)

    seen = texels(~point.hole)
    weights = seen[..., None] * np.stack([texels(point.warp_share), texels(1 - point.warp_share)], axis=-1)
    visible = np.maximum(seen.sum(2), 1e-9)
    share = weights.sum(2) / visible[..., None]
    normals, tangents = texels(point.normal), texels(point.tangent)
    mean = (normals * seen[..., None]).sum(2) / visible[..., None]
    length = np.linalg.norm(mean, axis=-1, keepdims=True)
    normal = np.where(length > 1e-6, mean / np.maximum(length, 1e-6), [0.0, 0, 1])
    axis_x, axis_y = (axis[:, :, None] for axis in frames(normal))
    up = np.maximum((normals * normal[:, :, None]).sum(-1), 0.05)
    slopes = np.stack([(normals * axis).sum(-1) / -up for axis in (axis_x, axis_y)], axis=-1)
    slopes = np.clip(slopes, -_STEEPEST, _STEEPEST)
    covariance = np.einsum("rcp,rcpi,rcpj->rcij", seen, slopes, slopes) / visible[..., None, None]
    flat = np.stack([(tangents * axis).sum(-1) for axis in (axis_x, axis_y)], axis=-1)
    direction = np.stack([_mean_axis(flat, weights[..., f]) for f in range(2)], axis=-2)
    gain, albedos = texels(point.gain), []
    for name in ("diffuse_reflect", "diffuse_transmit", "specular_reflect"):
        means = []
        for f, family in enumerate((appearance.warp, appearance.weft)):
            table = np.asarray(getattr(family, name), np.float64)
            colours = texels(table[point.threads[f]])
            if name != "specular_reflect":
                colours = colours * gain
            sums = (colours * weights[..., f, None]).sum(2)
            means.append(sums / np.maximum(weights[..., f].sum(2), 1e-9)[..., None])
        albedos.append(np.stack(means, axis=-2))
    places = place.T.reshape(count, columns, 2)
    return (places, seen.mean(2), share, normal, covariance, direction, *albedos)


def _mean_axis(vectors: Numbers, weights: Numbers) -> Numbers:
    """Mean of directions without a sign [..., points, 2] by doubled angles; (1, 0) where there are none."""
    x, y = vectors[..., 0], vectors[..., 1]
    cosine, sine = ((weights * v).sum(-1) for v in (x * x - y * y, 2 * x * y))
    angle = 0.5 * np.arctan2(sine, cosine)
    return np.stack([np.cos(angle), np.sin(angle)], axis=-1)
