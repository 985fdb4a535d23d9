"""Baked maps: the cloth of a fabric over whole repeats, or any window of the draft, sampled on a grid.

For programs that take textures. The renderer does not need them.
"""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import FloatType
from loomlight.core.colour import linear_to_srgb
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.files import discarding_empty, replacing_all
from loomlight.core.images import save_png, write_channels
from loomlight.fabric.fabric import Fabric

if TYPE_CHECKING:  # it loads Dr.Jit, and fabrics do without
    from loomlight.fabric.cloth_surface import ClothPoints

MAXIMUM_MAP_SIZE = 16384
# Sides of a texel, longer over shorter, that are still taken for square.
MAX_OBLONG = 1.5
# Sides of a window that are whole repeats, but for rounding.
_WHOLE = 1e-6
# Maps in the order in which they are written, and the names of their channels in an EXR.
_CHANNELS = {
    "height": ("height",),
    "normal": ("normal.X", "normal.Y", "normal.Z"),
    "tangent": ("tangent.X", "tangent.Y", "tangent.Z"),
    "warp": ("warp",),
    "hole": ("hole",),
    "color": ("color.R", "color.G", "color.B"),
    "opacity": ("opacity",),
    "roughness": ("roughness",),
    "occlusion": ("occlusion",),
}
# One batch of texels: bounds the memory of a large map.
_BATCH = 1 << 21


@dataclass(frozen=True, eq=False)
class ClothMaps:
    """Maps [rows, columns, ...]; row 0 is at the lower edge of the window, column 0 at its left.

    Attributes:
        height: of the yarns' smooth surface, millimetres; 0 in holes.
        normal, tangent: unit vectors [..., 3] of plies, fibres and hairs; x along the weft, y along the warp,
            z towards the eye.
        warp: whether the warp shows, bool.
        hole: whether neither family is there, bool.
        color: of the thread that shows, varied as it is there, linear RGB [..., 3]; its albedo where the
            fabric file gives that. Holes have the colour of a thread beside them, so that filters bring in no
            other.
        opacity: 0 in holes, else 1.
        roughness: root of the fibres' α, as α of other programs is its square.
        occlusion: share of the sky that the yarn sees; 1 in holes.
        size: width and height of the window, millimetres.
    """

    height: NDArray[np.float32]
    normal: NDArray[np.float32]
    tangent: NDArray[np.float32]
    warp: NDArray[np.bool_]
    hole: NDArray[np.bool_]
    color: NDArray[np.float32]
    opacity: NDArray[np.float32]
    roughness: NDArray[np.float32]
    occlusion: NDArray[np.float32]
    size: tuple[float, float]

    @property
    def height_range(self) -> tuple[float, float]:
        """Lowest and highest height, millimetres."""
        return float(self.height.min()), float(self.height.max())


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


def require_window(window: tuple[float, float, float, float]) -> None:
    """Raises InputError unless left and bottom are finite, and width and height above 0 mm."""
    left, bottom, width, height = window
    if not (0 < width < np.inf and 0 < height < np.inf and np.isfinite([left, bottom]).all()):
        raise InputError(f"window = {window} needs a finite corner and a width and height above 0 mm.")


def bake_maps(
    fabric: Fabric,
    resolution: tuple[int, int],
    float_type: FloatType,
    window: tuple[float, float, float, float] | None = None,
    back: bool = False,
) -> ClothMaps:
    """Samples the cloth at the middles of a grid of texels; of whole repeats the maps tile.

    Args:
        resolution: columns and rows, 1 to 16384.
        float_type: the Dr.Jit Float type to compute with.
        window: left, bottom, width, height in millimetres; None is one repeat.
        back: sample the back face, in its mirrored frame.

    Raises:
        InputError: a resolution out of range, or a window without extent.
    """
    from loomlight.fabric.cloth_surface import ClothSurface

    columns, rows = resolution
    if not (1 <= columns <= MAXIMUM_MAP_SIZE and 1 <= rows <= MAXIMUM_MAP_SIZE):
        raise InputError(f"resolution = {columns}x{rows} is outside 1 to {MAXIMUM_MAP_SIZE} texels a side.")
    left, bottom, width, height = window or (0.0, 0.0, *fabric.repeat_mm)
    require_window((left, bottom, width, height))
    surface = ClothSurface(fabric, float_type, _whole_repeats(fabric, (width, height)))
    # As `Footprint.spread_side`.
    side = float(np.sqrt(0.5 * ((width / columns) ** 2 + (height / rows) ** 2)))
    batches = [
        _map_values(fabric, surface.at(left + x * width, bottom + y * height, side, back))
        for x, y in _texels(columns, rows)
    ]
    joined = {name: np.concatenate([batch[name] for batch in batches]) for name in _CHANNELS}
    grids = {name: values.reshape(rows, columns, *values.shape[1:]) for name, values in joined.items()}
    return ClothMaps(**grids, size=(width, height))


def _whole_repeats(fabric: Fabric, extent: tuple[float, float]) -> tuple[int, int] | None:
    """Repeats across and up in an extent, millimetres; None where it cuts some."""
    counts = np.divide(extent, fabric.repeat_mm)
    whole = np.rint(counts)
    if (whole < 1).any() or (abs(counts - whole) > _WHOLE * whole).any():
        return None
    return int(whole[0]), int(whole[1])


def _texels(columns: int, rows: int) -> Iterator[tuple[NDArray[np.float64], NDArray[np.float64]]]:
    """Middles of texels in batches, shares of the width and of the height."""
    for first in range(0, columns * rows, _BATCH):
        texel = np.arange(first, min(first + _BATCH, columns * rows))
        yield (texel % columns + 0.5) / columns, (texel // columns + 0.5) / rows


def _map_values(fabric: Fabric, points: ClothPoints) -> dict[str, NDArray[Any]]:
    """The maps at points, by name."""
    appearance = fabric.appearance()
    of_warp, of_weft = (
        _colours(fabric, family)[thread]
        for family, thread in zip(("warp", "weft"), points.threads, strict=True)
    )
    share = points.warp_share
    alpha = share * appearance.warp.roughness + (1 - share) * appearance.weft.roughness
    color = (share[:, None] * of_warp + (1 - share[:, None]) * of_weft) * points.gain[:, None]
    return {
        "height": points.height,
        "normal": points.normal,
        "tangent": points.tangent,
        "warp": points.warp,
        "hole": points.hole,
        "color": np.clip(color, 0, 1).astype(np.float32),
        "opacity": (~points.hole).astype(np.float32),
        "roughness": np.sqrt(alpha).astype(np.float32),
        "occlusion": points.openness,
    }


def _colours(fabric: Fabric, family: str) -> NDArray[np.float64]:
    """Colours of the threads of a family [n, 3]."""
    colours = getattr(fabric.draft, family).colors
    appearance = getattr(fabric.appearance(), family)
    if colours is None or getattr(fabric.fields, family).diffuse_reflect is not None:
        return np.asarray(appearance.diffuse_reflect + appearance.diffuse_transmit)
    return np.asarray(colours)


def write_maps(maps: ClothMaps, path: str | os.PathLike[str]) -> list[Path]:
    """Writes the maps and returns the files: one EXR with named channels, or beside `path` a PNG a map.

    Pictures have row 0 at the top, so the window's upper edge comes first. In PNGs vectors are (v + 1)/2,
    colours sRGB, and the height spans 0 to 65535 from its lowest to its highest. Their millimetres are in the
    headers of the files, and in a JSON file beside them. EXR holds the values themselves. The folder is made
    where only it is missing.

    Raises:
        InputError: another suffix, or a path that cannot be written; then no file is written.
    """
    target = Path(path)
    planes = {name: np.flipud(np.asarray(getattr(maps, name), np.float32)) for name in _CHANNELS}
    suffix = target.suffix.lower()
    if suffix not in (".exr", ".png"):
        raise InputError(f"{target}: maps are written as .exr or .png.")
    with discarding_empty(target.parent):
        _make_folder(target.parent)
        return _write_exr(maps, planes, target) if suffix == ".exr" else _write_pngs(maps, planes, target)


def _make_folder(folder: Path) -> None:
    try:
        folder.mkdir(exist_ok=True)
    except FileNotFoundError:
        return  # the writer says so
    except OSError as error:
        raise InputError(f"{folder} cannot be written: {error.strerror}.") from error


def _write_exr(maps: ClothMaps, planes: dict[str, NDArray[np.float32]], target: Path) -> list[Path]:
    channels = {
        channel: plane if len(names) == 1 else plane[..., index]
        for name, names in _CHANNELS.items()
        for index, channel in enumerate(names)
        for plane in (planes[name],)
    }
    for axis, side in zip("XY", maps.size, strict=True):
        channels[f"size.{axis}"] = np.full_like(planes["height"], side)
    write_channels(target, channels)
    return [target]


def _write_pngs(maps: ClothMaps, planes: dict[str, NDArray[np.float32]], target: Path) -> list[Path]:
    low, high = maps.height_range
    planes["height"] = (planes["height"] - low) / max(high - low, 1e-12)
    for name in ("normal", "tangent"):
        planes[name] = 0.5 * planes[name] + 0.5
    planes["color"] = linear_to_srgb(planes["color"]).astype(np.float32)
    files = {name: map_file(target, name) for name in planes}
    description = {
        "size_mm": list(maps.size),
        "height_mm": [low, high],
        "texels": list(maps.hole.shape[::-1]),
        "files": {name: file.name for name, file in files.items()},
    }
    text = json.dumps(description, indent=1, ensure_ascii=False) + "\n"
    notes = {"height": {"height_mm": f"{low:.9g} to {high:.9g}"}}
    facts = _facts_file(target)
    with replacing_all([*files.values(), facts]) as temporaries:
        for temporary, (name, plane) in zip(temporaries, planes.items(), strict=False):
            kind = np.uint16 if name == "height" else np.uint8
            pixels = np.rint(np.clip(plane, 0, 1) * np.iinfo(kind).max).astype(kind)
            save_png(temporary, pixels, maps.size, notes.get(name))
        temporaries[-1].write_text(text, encoding="utf-8")
    return [*files.values(), facts]


def map_file(target: Path, name: str) -> Path:
    """The picture of one map beside `target`, a .png."""
    return target.with_name(f"{target.stem}_{name}.png")


def _facts_file(target: Path) -> Path:
    """What the pictures beside `target` show, in millimetres."""
    return target.with_name(f"{target.stem}_maps.json")


def map_files(target: Path) -> list[Path]:
    """The files that `write_maps` writes at `target`."""
    if target.suffix.lower() == ".exr":
        return [target]
    return [*(map_file(target, name) for name in _CHANNELS), _facts_file(target)]
