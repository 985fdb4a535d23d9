"""Lights of the built-in scenes. Units are chosen so that sunlit white cloth has a radiance just below 1."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Literal

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.camera_settings import direction_of_angles
from loomlight.core.environment_map import checked_environment_map, read_environment_map
from loomlight.core.errors import InputError
from loomlight.core.files import require_file
from loomlight.core.studio import studio_radiance

Light = Literal["studio", "sunsky", "point", "directional"]
LIGHTS: tuple[Light, ...] = ("studio", "sunsky", "point", "directional")

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
    return direction_of_angles(azimuth, elevation)


def light_dicts(
    light: str,
    centre: NDArray[np.float64],
    radius: float,
    towards: NDArray[np.float64],
    paper: bool = False,
) -> dict[str, dict[str, Any]]:
    """Mitsuba's dictionaries, by name, of the emitters that light an object of `radius` at `centre`.

    `towards` points from the object to the light. A point light stands three radii away. Of a studio without
    a floor, light from below stands for that of `paper`.

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
        return {"studio": {"type": "envmap", "bitmap": mi.Bitmap(studio_radiance(direction, paper=paper))}}
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
