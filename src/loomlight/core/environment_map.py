"""Environment maps: latitude-longitude pictures of radiance, checked in one place for every renderer."""

from __future__ import annotations

import os
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import OpenEXR
from numpy.typing import NDArray

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.files import require_file
from loomlight.core.images import opened_exr, read_linear

# Of the ratio of width to height; rounding of sides makes small pictures differ more.
_RATIO_TOLERANCE = 0.02
# What renderers interpolate between.
_MIN_COLUMNS, _MIN_ROWS = 3, 2
# The highest value of half precision, which pictures are often kept in; and one of which float32 sums up as
# many as an environment and a picture have.
_MAX_HALF, _MAX_RADIANCE = 65504.0, 1e28


def read_environment_map(path: str | os.PathLike[str]) -> NDArray[np.float32]:
    """Linear radiance [rows, columns, 3] of an .exr, .hdr, PNG or JPEG; a single channel is read as grey.

    Raises:
        InputError: no such file, no picture, pixels that are not finite, or an .exr that is a cube map, a
            cropped picture, or layers.
    """
    require_file(path)
    return checked_environment_map(
        _read_exr(path) if Path(path).suffix.lower() == ".exr" else read_linear(path), path
    )


def checked_environment_map(
    radiance: NDArray[np.float32], path: str | os.PathLike[str]
) -> NDArray[np.float32]:
    """The radiance [rows, columns, 3] of the picture `path` without negative values.

    Warns where there are such values, some beyond half precision, and where the sides are not 2 to 1.

    Raises:
        InputError: too few pixels, or some that are not finite or cannot be summed up.
    """
    rows, columns = radiance.shape[:2]
    if rows < _MIN_ROWS or columns < _MIN_COLUMNS:
        raise InputError(
            f"{path} has {columns} x {rows} pixels; an environment needs at least "
            f"{_MIN_COLUMNS} x {_MIN_ROWS}."
        )
    if not np.isfinite(radiance).all():
        raise InputError(f"{path} holds pixels that are no finite numbers; replace them in a picture editor.")
    if abs(columns - 2 * rows) > max(1, _RATIO_TOLERANCE * columns):
        warnings.warn(
            f"{path} has {columns} x {rows} pixels, and a latitude-longitude picture is twice as wide "
            "as high: it is stretched over the whole sphere; convert cube maps and mirror balls first.",
            LoomlightWarning,
            stacklevel=3,
        )
    highest = float(radiance.max())
    if highest > _MAX_RADIANCE:
        raise InputError(
            f"{path} holds a pixel of {highest:.3g}; values above {_MAX_RADIANCE:.0g} cannot be summed up: "
            "limit them in a picture editor."
        )
    if highest > _MAX_HALF:
        warnings.warn(
            f"{path} holds a pixel of {highest:.3g}, beyond the {_MAX_HALF:.0f} of half precision: unless "
            "that is the sun, limit it in a picture editor.",
            LoomlightWarning,
            stacklevel=3,
        )
    negative = int((radiance < 0).any(axis=2).sum())
    if negative:
        warnings.warn(
            f"{path}: {negative} of {rows * columns} pixels are negative, the lowest {radiance.min():.3g}; "
            "they are taken as 0.",
            LoomlightWarning,
            stacklevel=3,
        )
    return np.maximum(radiance, 0)


def _read_exr(path: str | os.PathLike[str]) -> NDArray[np.float32]:
    try:
        with opened_exr(path) as file:
            _check_header(file.header(), len(file.parts), path)
            planes = {name: np.asarray(channel.pixels) for name, channel in file.channels().items()}
    except (RuntimeError, ValueError, TypeError, MemoryError) as error:
        raise InputError(f"{path} is no EXR file that can be read.") from error
    names = list("RGB")
    if not set(names) <= set(planes):
        # An opacity beside it changes nothing: light comes from infinitely far away.
        names = [name for name in planes if name.rpartition(".")[2] != "A"]
        if len(names) != 1:
            raise InputError(_not_a_picture(sorted(planes), path))
        names *= 3
    if len({planes[name].shape for name in names}) > 1:
        raise InputError(f"{path} stores its channels at different resolutions; save it as plain RGB.")
    return np.stack([planes[name] for name in names], axis=-1).astype(np.float32)


def _check_header(header: dict[str, Any], parts: int, path: str | os.PathLike[str]) -> None:
    if header.get("envmap") == OpenEXR.Envmap.ENVMAP_CUBE:
        raise InputError(
            f'{path} is a cube map, as its header says ("envmap"); environments are latitude-longitude '
            "pictures: convert it (exrenvmap -latlong)."
        )
    if parts > 1:
        raise InputError(
            f"{path} is an EXR file of {parts} parts; save the one that is the environment alone."
        )
    (left, top), (right, bottom) = data = [corner.tolist() for corner in header["dataWindow"]]
    display = [corner.tolist() for corner in header["displayWindow"]]
    if data != display:
        (from_x, from_y), (to_x, to_y) = display
        raise InputError(
            f"{path} is cropped: its pixels ({right - left + 1} x {bottom - top + 1} from {left}, {top}) are "
            f"not its whole picture ({to_x - from_x + 1} x {to_y - from_y + 1} from {from_x}, {from_y}); "
            "save it with the data window of the display window."
        )


def _not_a_picture(names: list[str], path: str | os.PathLike[str]) -> str:
    layers = sorted({name.rpartition(".")[0] for name in names if "." in name})
    if layers:
        shown = ", ".join(layers[:4]) + (" and others" if len(layers) > 4 else "")
        return (
            f"{path} holds layers ({shown[:200]}), none of them the picture itself; save one of them as RGB."
        )
    return (
        f"{path} has the channels {', '.join(names)[:200]}, and neither R, G and B nor a single one (grey)."
    )
