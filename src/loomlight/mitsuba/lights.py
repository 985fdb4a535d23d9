"""Lights of the built-in scenes. Units are chosen so that sunlit white cloth has a radiance just below 1."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Literal

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.environment_map import checked_environment_map, read_environment_map
from loomlight.core.errors import InputError
from loomlight.core.files import require_file

Light = Literal["studio", "sunsky", "point", "directional"]
LIGHTS: tuple[Light, ...] = ("studio", "sunsky", "point", "directional")

# The studio's key light: a round softbox, degrees from its middle to where it has faded to a half and, around
# there, from full to none; and how much of the irradiance of a surface that faces it is its own. 10 degrees
# blur shadows without hiding the relief of yarns, and a quarter of fill leaves shadows legible.
_KEY_RADIUS, _KEY_EDGE, _KEY_SHARE = 10.0, 4.0, 0.78
_STUDIO_ROWS = 128

# Mitsuba's own daylight shows white cloth at about 0.4.
_DAYLIGHT = 2.0
_ENVIRONMENT_SUFFIXES = (".exr", ".hdr", ".pfm", ".png", ".jpg", ".jpeg")


def direction_of(azimuth: float, elevation: float) -> NDArray[np.float64]:
    """The unit vector towards a light at `azimuth` (0 at +z, 90 at +x) and `elevation` above it, degrees.

    Raises:
        InputError: an azimuth outside −360 to 360, or an elevation outside −90 to 90.
    """
    if not (-360 <= azimuth <= 360 and -90 <= elevation <= 90):
        raise InputError(
            f"light_from = {azimuth:g},{elevation:g} is out of range: write an azimuth from -360 to 360 and "
            "an elevation from -90 to 90 degrees."
        )
    around, above = np.radians([azimuth, elevation])
    return np.array([np.sin(around) * np.cos(above), np.sin(above), np.cos(around) * np.cos(above)])


def light_dicts(
    light: str, centre: NDArray[np.float64], radius: float, towards: NDArray[np.float64]
) -> dict[str, dict[str, Any]]:
    """Mitsuba's dictionaries, by name, of the emitters that light an object of `radius` at `centre`.

    `towards` points from the object to the light. A point light stands three radii away.

    Raises:
        InputError: no such light, or a studio's key light or a sun below the horizon.
    """
    direction = towards / np.linalg.norm(towards)
    if light in ("studio", "sunsky") and direction[1] < 0:
        raise InputError(
            f"light_from: the light stands {np.degrees(np.arcsin(-direction[1])):.3g} degrees below the "
            f"horizon, where {light} has the ground; write an elevation from 0 to 90, or use directional."
        )
    if light == "studio":
        return {"studio": {"type": "envmap", "bitmap": mi.Bitmap(studio_radiance(direction))}}
    if light == "sunsky":
        # The sun keeps its true width: Mitsuba samples a wider one far too seldom, and allows one sky alone.
        scale = {"sun_scale": _DAYLIGHT, "sky_scale": _DAYLIGHT}
        upright = mi.ScalarTransform4f().rotate([1, 0, 0], -90)  # its own up is z
        sky = {"type": "sunsky", "sun_direction": direction.tolist(), "turbidity": 4.0, "to_world": upright}
        return {"sunsky": sky | scale}
    if light == "point":
        distance = 3 * radius
        intensity = {"type": "rgb", "value": float(np.pi * (distance - radius) ** 2)}
        place = (centre + distance * direction).tolist()
        return {"point": {"type": "point", "position": place, "intensity": intensity}}
    if light == "directional":
        irradiance = {"type": "rgb", "value": float(np.pi)}
        sun = {"type": "directional", "direction": (-direction).tolist(), "irradiance": irradiance}
        return {"directional": sun}
    raise InputError(f'light = "{light}" is unknown: use {", ".join(LIGHTS)}, or an environment picture.')


def environment_dict(
    path: str | os.PathLike[str], turn_degrees: float = 0.0, scale: float = 1.0
) -> dict[str, Any]:
    """Mitsuba's dictionary of an environment picture (latitude-longitude), turned about the vertical.

    Raises:
        InputError: no such file, another suffix, or what `read_environment_map` raises.
    """
    file = Path(path)
    if file.suffix.lower() not in _ENVIRONMENT_SUFFIXES:
        raise InputError(f"{file}: environments are read from {', '.join(_ENVIRONMENT_SUFFIXES)} files.")
    radiance = _read_pfm(file) if file.suffix.lower() == ".pfm" else read_environment_map(file)
    return {
        "type": "envmap",
        "bitmap": mi.Bitmap(radiance),
        "scale": scale,
        "to_world": mi.ScalarTransform4f().rotate([0, 1, 0], turn_degrees),
    }


def _read_pfm(file: Path) -> NDArray[np.float32]:
    require_file(file)
    try:
        bitmap = mi.Bitmap(str(file)).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float32)
    except Exception as error:  # Mitsuba raises bare RuntimeErrors
        raise InputError(f"{file} is damaged or no picture.") from error
    return checked_environment_map(np.array(bitmap), file)


def studio_radiance(direction: NDArray[np.float64]) -> NDArray[np.float32]:
    """Latitude-longitude radiance [128, 256, 3] of a soft key light and a dome that is brightest above.

    All of it is grey, so that a grey card looks grey; a white card that faces the key shows a radiance of 1.
    Nothing comes from below the horizon, where the built-in scenes have a ground.
    """
    rows, columns = _STUDIO_ROWS, 2 * _STUDIO_ROWS
    polar = (np.arange(rows) + 0.5) / rows * np.pi
    around = (np.arange(columns) + 0.5) / columns * 2 * np.pi
    # Mitsuba's envmap: up is +y, and columns turn from -z over +x.
    x, y = np.sin(polar)[:, None] * np.sin(around), np.cos(polar)[:, None] + 0 * around
    towards = np.stack([x, y, -np.sin(polar)[:, None] * np.cos(around)], axis=-1)
    cosine = np.clip(towards @ direction, -1, 1)
    key = np.clip((_KEY_RADIUS - np.degrees(np.arccos(cosine))) / _KEY_EDGE + 0.5, 0, 1)
    dome = np.where(y > 0, 0.5 + 0.5 * y, 0)
    solid_angle = np.sin(polar)[:, None] * (np.pi / rows) * (2 * np.pi / columns)
    facing = np.clip(cosine, 0, None) * solid_angle
    radiance = np.pi * (
        _KEY_SHARE * key / (key * facing).sum() + (1 - _KEY_SHARE) * dome / (dome * facing).sum()
    )
    return np.repeat(radiance[..., None], 3, axis=-1).astype(np.float32)
