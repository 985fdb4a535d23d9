"""Baked maps: the cloth of a fabric over whole repeats, or any window of the draft, sampled on a grid.

For programs that take textures. The renderer does not need them.
"""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, FloatType, Mask
from loomlight.core.backend import array_types, upload
from loomlight.core.colour import linear_to_srgb
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.files import discarding_empty, replacing_all
from loomlight.core.images import save_png, write_channels
from loomlight.fabric.fabric import Fabric
from loomlight.scattering.appearance import ALBEDO_NAMES, Appearance
from loomlight.scattering.detail import turned_frame
from loomlight.scattering.hairs import under_hair
from loomlight.scattering.interreflection import Interreflection
from loomlight.scattering.irregularity import IrregularYarns
from loomlight.scattering.openness import openness_of
from loomlight.scattering.point import Albedos, YarnScattering
from loomlight.scattering.variation import UNEVEN_CELL, Unevenness
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout
from loomlight.yarn.stack import ClothGeometry, cloth_geometry

Numbers = NDArray[np.float32]
# Spacings over which the ends of a tile fade into each other: of where threads run, whose noise has cells of
# this length, and of fibres and slubs; at most so much of the tile.
_PLACE_BAND, _DETAIL_BAND, _MAX_DETAIL_BAND = UNEVEN_CELL, 1.0, 0.25
# Normals of a map point away from the cloth, while plies and fibres may turn them down at steep flanks.
_MIN_NORMAL_Z = 0.02


@dataclass
class ClothPoints:
    """Points of the cloth, in the frame of the face that is seen.

    Attributes:
        height: of the yarn's smooth surface, millimetres; 0 in holes.
        normal, tangent: unit vectors [n, 3], of plies, fibres and hairs.
        warp: the family of the yarn that shows, bool.
        hole: whether neither family is there, bool.
        threads: index of the end and of the pick that cross here, in the repeat [2, n].
        warp_share: of the warp in what shows, with the hair on top, 0 to 1.
        gain: what diffuse albedos are multiplied with here [n, 3], linear RGB, mean 1.
        openness: share of the sky that the yarn sees, 0 to 1; 1 in holes.
    """

    height: Numbers
    normal: Numbers
    tangent: Numbers
    warp: NDArray[np.bool_]
    hole: NDArray[np.bool_]
    threads: NDArray[np.int32]
    warp_share: Numbers
    gain: Numbers
    openness: Numbers


class ClothSurface:
    """The cloth of a fabric.

    Args:
        tile: repeats, across and up, after which the cloth is to be the same again; None is cloth as
            pictures have it, whose threads all differ.
    """

    def __init__(self, fabric: Fabric, float_type: FloatType, tile: tuple[int, int] | None = None) -> None:
        self._types = array_types(float_type)
        layout, appearance = fabric.layout(), fabric.appearance()
        spacings = (float(layout.warp.spacing.mean()), float(layout.weft.spacing.mean()))
        self._unevenness = Unevenness(appearance, spacings)
        self._irregular = IrregularYarns(YarnGeometry(layout), appearance)
        self._scattering = _TiledScattering(cloth_geometry(layout), appearance, tile, self._irregular)
        self._between = _interreflection(layout, appearance, float_type)
        varies = self._scattering.has_detail or self._scattering.varies or self._irregular.is_on
        self._tile = np.multiply(layout.size, tile) if tile is not None and varies else None
        self._spacings = np.array(spacings)

    def at(self, x: NDArray[Any], y: NDArray[Any], size: float, back: bool = False) -> ClothPoints:
        """The cloth at places [n] in millimetres, as footprints whose side is `size` millimetres show it."""
        x, y, shift = self._within_tile(x, y)
        found = self._sampled(x + shift[0], y + shift[1], size, back)
        if self._tile is None:
            return found
        detail_band = np.minimum(_DETAIL_BAND * self._spacings, _MAX_DETAIL_BAND * self._tile)
        in_bands = np.flatnonzero((x < detail_band[0]) | (y < detail_band[1]))
        if not in_bands.size:
            return found
        shift = shift[:, in_bands]

        def varied(x: NDArray[Any], y: NDArray[Any]) -> NDArray[Any]:
            there = self._sampled(x + shift[0], y + shift[1], size, back)
            # A fibre has no front and no rear.
            turned = (there.tangent * found.tangent[in_bands]).sum(axis=1, keepdims=True) < 0
            tangent = np.where(turned, -there.tangent, there.tangent)
            return np.concatenate([there.normal.T, tangent.T, there.gain.T, [there.warp_share]])

        faded = _faded(varied, x[in_bands], y[in_bands], self._tile, detail_band, keep_deviation=False)
        normal = _unit(faded[:3].T)
        tangent = faded[3:6].T - (faded[3:6].T * normal).sum(axis=1, keepdims=True) * normal
        found.normal[in_bands], found.tangent[in_bands] = normal, _unit(tangent)
        found.gain[in_bands], found.warp_share[in_bands] = faded[6:9].T, faded[9]
        return found

    def place(self, x: NDArray[Any], y: NDArray[Any]) -> NDArray[np.float64]:
        """Where in the draft the cloth at places [n] is [2, n], both in millimetres."""
        x, y, shift = self._within_tile(x, y)
        return np.stack([x, y]) + shift

    def _within_tile(
        self, x: NDArray[Any], y: NDArray[Any]
    ) -> tuple[NDArray[Any], NDArray[Any], NDArray[np.float64]]:
        """Places in the tile, and by how much its threads are displaced there [2, n], millimetres."""
        if self._tile is None:
            return x, y, self._displacement(x, y)
        width, height = self._tile
        x, y = x - width * np.floor(x / width), y - height * np.floor(y / height)
        band = np.minimum(_PLACE_BAND * self._spacings, self._tile)
        shift = self._displacement(x, y)
        in_bands = np.flatnonzero((x < band[0]) | (y < band[1]))
        if in_bands.size:
            shift[:, in_bands] = _faded(self._displacement, x[in_bands], y[in_bands], self._tile, band)
        return x, y, shift

    def _displacement(self, x: NDArray[Any], y: NDArray[Any]) -> NDArray[np.float64]:
        """By how much the threads at places are displaced [2, n], millimetres."""
        place = self._types.Vector2(*(upload(self._types.Float, part.astype(np.float32)) for part in (x, y)))
        moved = self._irregular.place(self._unevenness.place(place))
        # Of even threads, Dr.Jit knows that the difference is one 0.
        return np.stack([np.broadcast_to(part.numpy(), x.shape) for part in moved - place]).astype(np.float64)

    def _sampled(self, x: NDArray[Any], y: NDArray[Any], size: float, back: bool) -> ClothPoints:
        # Find the yarn under each place, and the frame of what it shows close up.
        types, scattering = self._types, self._scattering
        x, y = (upload(types.Float, part.astype(np.float32)) for part in (x, y))
        behind, side = dr.full(types.Bool, back, dr.width(x)), dr.opaque(types.Float, size)
        point = scattering.surface.surface(x, y, behind)
        normal, tangent = point.normal, point.tangent
        warp_share = dr.select(point.is_warp, types.Float(1), 0)
        hair = None
        if scattering.has_detail:
            thread = scattering.thread_number(point)
            frame = turned_frame(scattering.detail(types), point, behind, thread, side)
            hairs = scattering.hairs(point, behind, side)
            if hairs is not None:
                hair = hairs.seen(types.Vector3(0, 0, 1))
                frame = under_hair(frame, hair)
                warp_share = dr.lerp(warp_share, dr.select(hair.is_warp, types.Float(1), 0), hair.cover)
            normal, tangent = frame.normal, frame.tangent
        # Find by how much its colour differs from its family's.
        gain = dr.full(types.Color3, 1, dr.width(x))
        if scattering.has_detail or scattering.varies or self._irregular.is_on:
            # Reflected and transmitted light vary alike.
            warp, weft = scattering.parameters(types)
            pairs = (
                (warp.albedo(number, point.warp_thread), weft.albedo(number, point.weft_thread))
                for number in range(len(ALBEDO_NAMES))
            )
            base = Albedos(*(dr.select(point.is_warp, *pair) for pair in pairs))
            toned = scattering.toned(point, base, point.is_warp)
            before, after = (of.diffuse_reflect + of.diffuse_transmit for of in (base, toned))
            gain = dr.select(before > 0, after / before, 1)
            if scattering.has_detail or scattering.varies:
                varied = scattering.varied(point, toned, behind, side, hair)
                # All channels vary alike.
                before, after = (dr.sum(of.diffuse_reflect + of.diffuse_transmit) for of in (toned, varied))
                gain *= dr.select(before > 0, after / before, 1)
        # Find how open it lies.
        blocked = self._between.blocked_at(point.is_warp, behind, point.normal.z, point.height - point.plane)
        openness = dr.select(point.hole, 1, 1 - blocked.by_warp - blocked.by_weft)
        level = dr.select(point.hole, 0, point.height)
        ends, picks = types.UInt32(point.warp_thread), types.UInt32(point.weft_thread)
        parts = (level, normal, tangent, point.is_warp, point.hole, ends, picks, warp_share, gain, openness)
        # Fetch all of it, and turn normals that point into the cloth.
        dr.eval(parts)
        arrays = [part.numpy() for part in parts]
        level, normal, tangent, is_warp, hole, ends, picks, warp_share, gain, openness = arrays
        normal, tangent = normal.T.astype(np.float32), tangent.T.astype(np.float32)
        normal[:, 2] = np.maximum(normal[:, 2], _MIN_NORMAL_Z)
        normal = _unit(normal)
        tangent = _unit(tangent - (tangent * normal).sum(axis=1, keepdims=True) * normal)
        return ClothPoints(
            height=level.astype(np.float32),
            normal=normal,
            tangent=tangent,
            warp=is_warp.astype(bool),
            hole=hole.astype(bool),
            threads=np.stack([ends, picks]).astype(np.int32),
            warp_share=warp_share.astype(np.float32),
            gain=gain.T.astype(np.float32),
            openness=openness.astype(np.float32),
        )


class _TiledScattering(YarnScattering):
    """Yarns whose threads are the same again after some repeats."""

    def __init__(
        self,
        surface: ClothGeometry,
        appearance: Appearance,
        tile: tuple[int, int] | None,
        irregular: IrregularYarns,
    ) -> None:
        super().__init__(surface, appearance, irregular=irregular)
        self._repeats = tile

    def repeat_number(self, repeat: Float, is_warp: Mask) -> Float:
        """Number of the repeat within the tile."""
        if self._repeats is None:
            return repeat
        types = array_types(repeat)
        count = dr.select(is_warp, *(dr.opaque(types.Float, float(number)) for number in self._repeats))
        return repeat - count * dr.floor(repeat / count)


def _interreflection(layout: ClothLayout, appearance: Appearance, float_type: FloatType) -> Interreflection:
    """Light between yarns, for the share of the sky that they see; of fabrics that go without it too."""
    if appearance.openness is None:
        roughness = (appearance.warp.roughness, appearance.weft.roughness)
        openness = openness_of(layout, appearance.diffuse_blend, roughness, appearance.optical_depth)
        appearance = replace(appearance, openness=openness)
    return Interreflection(appearance, array_types(float_type))


def _faded(
    values: Callable[[NDArray[Any], NDArray[Any]], NDArray[Any]],
    x: NDArray[Any],
    y: NDArray[Any],
    tile: NDArray[np.float64],
    band: NDArray[np.float64],
    keep_deviation: bool = True,
) -> NDArray[Any]:
    """Values [k, n] at places within a tile from (0, 0) on, near whose lower edges those beyond fade in.

    Args:
        band: its width at the left and at the lower edge, millimetres.
        keep_deviation: of values of mean 0, whose mean varies less than they do.
    """
    weights = []
    for place, width in zip((x, y), band, strict=True):
        share = np.clip(place / width, 0, 1)
        here = share * share * (3 - 2 * share)
        pair = np.stack([here, 1 - here])
        weights.append(pair / np.linalg.norm(pair, axis=0) if keep_deviation else pair)
    total: NDArray[Any] | float = 0.0
    for i in (0, 1):
        for j in (0, 1):
            total = total + weights[0][i] * weights[1][j] * values(x + i * tile[0], y + j * tile[1])
    return np.asarray(total)


def _unit(vectors: NDArray[Any]) -> NDArray[Any]:
    return vectors / np.maximum(np.linalg.norm(vectors, axis=1, keepdims=True), 1e-12)


# ------------------------------------------------------------------------------------------------- baked maps


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


def sample_maps(
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
    color = (share[:, None] * of_warp + (1 - share[:, None]) * of_weft) * points.gain
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
