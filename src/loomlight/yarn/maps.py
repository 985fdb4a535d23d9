"""Baked maps: the geometry of one repeat, or of any window of the draft, sampled on a grid.

For other tools and for the models that learn from textures. The renderer does not need them.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import FloatType
from loomlight.core.backend import array_types
from loomlight.core.colour import linear_to_srgb
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.images import write_channels, write_pngs
from loomlight.yarn.search import Surface

MAXIMUM_MAP_SIZE = 16384
# Sides of a texel, longer over shorter, that are still taken for square.
MAX_OBLONG = 1.5
_CHANNELS = {
    "height": ("height",),
    "normal": ("normal.X", "normal.Y", "normal.Z"),
    "tangent": ("tangent.X", "tangent.Y", "tangent.Z"),
    "warp": ("warp",),
    "hole": ("hole",),
}
# One batch of texels: bounds the memory of a large map.
_BATCH = 1 << 22


@dataclass(frozen=True, eq=False)
class SurfaceMaps:
    """Maps [rows, columns, ...]; row 0 is at the lower edge of the window, column 0 at its left.

    Attributes:
        height: millimetres; 0 in holes.
        normal, tangent: unit vectors [..., 3]; x along the weft, y along the warp, z towards the eye.
        warp: whether the warp shows, bool.
        hole: whether neither family is there, bool.
        size: width and height of the window, millimetres.
        thread: index of the thread that shows, among its family's in the repeat.
    """

    height: NDArray[np.float32]
    normal: NDArray[np.float32]
    tangent: NDArray[np.float32]
    warp: NDArray[np.bool_]
    hole: NDArray[np.bool_]
    size: tuple[float, float]
    thread: NDArray[np.int32]


def resolution_of(extent: tuple[float, float], per_mm: float) -> tuple[int, int]:
    """Columns and rows of square texels for width and height in millimetres, at least 1 each."""
    columns, rows = (max(round(side * per_mm), 1) for side in extent)
    return columns, rows


def warn_of_oblong_texels(extent: tuple[float, float], resolution: tuple[int, int]) -> None:
    """Warns of texels far from square: one family of threads is coarser than the other."""
    width, height = (side / texels for side, texels in zip(extent, resolution, strict=True))
    oblong = max(width / height, height / width)
    if oblong > MAX_OBLONG:
        longer = "wide as tall" if width > height else "tall as wide"
        columns, rows = resolution_of(extent, max(resolution) / max(extent))
        warnings.warn(
            f"Texels of {resolution[0]}x{resolution[1]} over {extent[0]:.4g} × {extent[1]:.4g} mm are "
            f"{oblong:.2g} times as {longer}: {columns}x{rows} are square.",
            LoomlightWarning,
            stacklevel=2,
        )


def bake_maps(
    surface: Surface,
    resolution: tuple[int, int],
    float_type: FloatType,
    window: tuple[float, float, float, float] | None = None,
    back: bool = False,
) -> SurfaceMaps:
    """Samples the surface at the middles of a grid of texels.

    Args:
        resolution: columns and rows, 1 to 16384.
        float_type: the Dr.Jit Float type to compute with.
        window: left, bottom, width, height in millimetres; None is one repeat.
        back: sample the back face, in its mirrored frame.

    Raises:
        InputError: a resolution out of range, or a window without extent.
    """
    columns, rows = resolution
    if not (1 <= columns <= MAXIMUM_MAP_SIZE and 1 <= rows <= MAXIMUM_MAP_SIZE):
        raise InputError(f"resolution = {columns}x{rows} is outside 1 to {MAXIMUM_MAP_SIZE} texels a side.")
    left, bottom, width, height = window or (0.0, 0.0, *surface.size)
    if not (0 < width < np.inf and 0 < height < np.inf and np.isfinite([left, bottom]).all()):
        raise InputError(f"window = {window} needs a finite corner and a width and height above 0 mm.")
    batches = [
        _sample(surface, float_type, columns, rows, first, (left, bottom, width, height), back)
        for first in range(0, columns * rows, _BATCH)
    ]
    joined = [np.concatenate(parts, axis=-1) for parts in zip(*batches, strict=True)]
    level, normal, tangent, warp, hole, thread = joined

    def grid(values: NDArray[Any]) -> NDArray[Any]:
        return np.moveaxis(values.reshape(*values.shape[:-1], rows, columns), 0, -1)

    return SurfaceMaps(
        height=level.reshape(rows, columns).astype(np.float32),
        normal=np.ascontiguousarray(grid(normal), dtype=np.float32),
        tangent=np.ascontiguousarray(grid(tangent), dtype=np.float32),
        warp=warp.reshape(rows, columns).astype(bool),
        hole=hole.reshape(rows, columns).astype(bool),
        size=(width, height),
        thread=thread.reshape(rows, columns).astype(np.int32),
    )


def _sample(
    surface: Surface,
    float_type: FloatType,
    columns: int,
    rows: int,
    first: int,
    window: tuple[float, float, float, float],
    back: bool,
) -> tuple[NDArray[Any], ...]:
    types = array_types(float_type)
    count = min(_BATCH, columns * rows - first)
    texel = dr.arange(types.UInt32, first, first + count)
    row = texel // columns
    column = texel - row * columns
    left, bottom, width, height = window
    x = left + (types.Float(column) + 0.5) * (width / columns)
    y = bottom + (types.Float(row) + 0.5) * (height / rows)
    point = surface.surface(x, y, dr.full(types.Bool, back, count))
    level = dr.select(point.hole, 0, point.height)
    thread = dr.select(point.is_warp, types.UInt32(point.warp_thread), types.UInt32(point.weft_thread))
    found = (level, point.normal, point.tangent, point.is_warp, point.hole, thread)
    dr.eval(found)
    return tuple(np.asarray(value.numpy()) for value in found)


def write_maps(
    maps: SurfaceMaps, path: str | os.PathLike[str], material: Mapping[str, NDArray[np.float32]] | None = None
) -> list[Path]:
    """Writes the maps and returns the files: one EXR with named channels, or a PNG a map beside `path`.

    Pictures have row 0 at the top, so the window's upper edge comes first. In PNGs vectors are (v + 1)/2,
    colours sRGB, and the height spans 0 to 1 from its lowest to its highest, 8 bits, with the millimetres in
    the file's header; EXR holds the values themselves.

    Args:
        material: further maps by name, [rows, columns] of 0 to 1, or [rows, columns, 3] of linear RGB.

    Raises:
        InputError: another suffix, or a path that cannot be written; then no file is written.
    """
    target = Path(path)
    planes: dict[str, NDArray[np.float32]] = {
        name: np.flipud(np.asarray(getattr(maps, name), np.float32)) for name in _CHANNELS
    }
    extra = {name: np.flipud(plane) for name, plane in (material or {}).items()}
    if target.suffix.lower() == ".exr":
        channels = {
            channel: plane if len(names) == 1 else plane[..., index]
            for name, names in _CHANNELS.items()
            for index, channel in enumerate(names)
            for plane in (planes[name],)
        }
        for name, plane in extra.items():
            parts = [plane] if plane.ndim == 2 else np.moveaxis(plane, -1, 0)
            names = [name] if plane.ndim == 2 else [f"{name}.{letter}" for letter in "RGB"]
            channels |= dict(zip(names, parts, strict=True))
        channels["size.X"] = np.full_like(planes["height"], maps.size[0])
        channels["size.Y"] = np.full_like(planes["height"], maps.size[1])
        write_channels(target, channels)
        return [target]
    if target.suffix.lower() != ".png":
        raise InputError(f"{target}: maps are written as .exr or .png.")
    low, high = float(maps.height.min()), float(maps.height.max())
    planes["height"] = ((planes["height"] - low) / max(high - low, 1e-12)).astype(np.float32)
    for name in ("normal", "tangent"):
        planes[name] = (0.5 * planes[name] + 0.5).astype(np.float32)
    for name, plane in extra.items():
        planes[name] = plane if plane.ndim == 2 else linear_to_srgb(plane).astype(np.float32)
    pictures = {
        target.with_name(f"{target.stem}_{name}.png"): np.rint(np.clip(plane, 0, 1) * 255).astype(np.uint8)
        for name, plane in planes.items()
    }
    write_pngs(pictures, maps.size)
    return list(pictures)
