"""Where the camera of a picture stands: settings, declared once for pictures, windows and sheets."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar, Self, TypedDict

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.core.sentences import shown
from loomlight.core.settings import Settings, declared, documented, setting

# Azimuth and elevation in degrees, as those of `light_from`.
VIEWS: dict[str, tuple[float, float]] = {
    "front": (0, 0),
    "back": (180, 0),
    "left": (-90, 0),
    "right": (90, 0),
    "three-quarter": (40, 20),
    "back-three-quarter": (140, 20),
    "top": (0, 90),
    "bottom": (0, -90),
}
# Millimetres of a sensor of 36 × 24 that the picture's shorter side is.
SENSOR_MM = 24.0
_VIEWS_IN_WORDS = f"{', '.join(VIEWS)}, or AZIMUTH,ELEVATION in degrees, such as 30,20"


def view_angles(view: object) -> tuple[float, float] | None:
    """Azimuth, −360 to 360, and elevation, −90 to 90 degrees, of a view's name, "30,20" or (30, 20).

    None where it is none of these.
    """
    if isinstance(view, str) and view in VIEWS:
        return VIEWS[view]
    parts = view.split(",") if isinstance(view, str) else view
    if not isinstance(parts, Iterable):
        return None
    try:
        azimuth, elevation = (float(part) for part in parts)
    except (TypeError, ValueError):
        return None
    return (azimuth, elevation) if abs(azimuth) <= 360 and abs(elevation) <= 90 else None


def direction_of_angles(azimuth: float, elevation: float) -> NDArray[np.float64]:
    """The unit vector towards `azimuth` (0 at +z, 90 at +x) and `elevation` above it, degrees."""
    around, above = np.radians([azimuth, elevation])
    return np.array([np.sin(around) * np.cos(above), np.sin(above), np.cos(around) * np.cos(above)])


@documented
@dataclass(frozen=True, kw_only=True)
class CameraSettings(Settings):
    """Where a camera stands and what it shows; zoom comes closer from there."""

    title: ClassVar[str] = "setting of a camera"

    view: str | tuple[float, float] | None = setting(
        None,
        f"Where the camera stands: {_VIEWS_IN_WORDS}; 0,0 is the front (+z), 90,0 the right (+x).",
        otherwise="as the scene has it",
        fits=lambda view: view_angles(view) is not None,
        expected=_VIEWS_IN_WORDS,
        metavar="NAME|AZIMUTH,ELEVATION",
    )
    look_at: str | None = setting(
        None,
        "Frames the part or material of this name of the mesh.",
        otherwise="the whole object",
        metavar="PART",
    )
    target: tuple[float, float, float] | None = setting(
        None,
        "Where the camera looks, metres.",
        otherwise="the middle of what it frames",
        low=-1e6,
        high=1e6,
        metavar="X,Y,Z",
        example="0,0.3,0",
    )
    distance: float | None = setting(
        None,
        "Of the camera from where it looks, metres.",
        otherwise="as near as shows all of it",
        low=1e-4,
        high=1e6,
        metavar="METRES",
    )
    focal_length: float | None = setting(
        None,
        "Of the lens, millimetres of 35 mm film: the picture's shorter side is its 24 mm.",
        otherwise="52, longer for tall pictures of what stands on paper",
        low=1,
        high=10_000,
        metavar="MM",
    )
    roll: float = setting(0.0, "Turns the picture, counter-clockwise, degrees.", low=-360, high=360)
    camera: str | None = setting(
        None,
        "A camera of the mesh file, by its name, in place of the settings above.",
        otherwise="none",
        metavar="NAME",
    )

    def __post_init__(self) -> None:
        """Raises InputError for a value that cannot be, and for two that contradict."""
        super().__post_init__()
        for one, others in (
            ("camera", ("view", "look_at", "target", "distance", "focal_length", "roll")),
            ("look_at", ("target",)),
        ):
            chosen = self.chosen()
            if one in chosen and (other := next((name for name in others if name in chosen), None)):
                what = "how the file's camera sees" if one == "camera" else "where the camera looks"
                raise InputError(
                    f"{one} = {shown(chosen[one])} and {other} = {shown(chosen[other])} both say {what}: "
                    "leave one of them out."
                )

    @classmethod
    def within(cls, settings: Settings) -> Self:
        """Those among other settings, which may lack some."""
        names = declared(cls).keys() & declared(type(settings)).keys()
        return cls(**{name: getattr(settings, name) for name in names})

    @property
    def angles(self) -> tuple[float, float] | None:
        """Azimuth and elevation of the view, degrees; None where none is chosen."""
        return None if self.view is None else view_angles(self.view)

    @property
    def field_of_view(self) -> float | None:
        """Degrees of the picture's shorter side; None where no lens is chosen."""
        if self.focal_length is None:
            return None
        return float(2 * np.degrees(np.arctan(SENSOR_MM / 2 / self.focal_length)))


def focal_length_of(field_of_view: float) -> float:
    """Millimetres of 35 mm film of a lens that shows so many degrees along the picture's shorter side."""
    return float(SENSOR_MM / 2 / np.tan(np.radians(field_of_view) / 2))


def options_of_camera(
    angles: tuple[float, float],
    target: NDArray[np.float64],
    distance: float,
    field_of_view: float,
    roll: float = 0.0,
) -> str:
    """A camera as options of `render`, `swatches` and `play`; as `web/editor/src/view/camera_options.ts`.

    Lengths are written to a ten-thousandth of the distance, less than a pixel of a picture.

    Args:
        angles: azimuth and elevation, degrees.
        target, distance: metres.
        field_of_view: of the picture's shorter side, degrees.
        roll: counter-clockwise, degrees.
    """
    azimuth, elevation = angles
    digits = min(max(4 - math.floor(math.log10(distance)), 0), 9)
    options = {
        "view": f"{_decimal(azimuth, 2)},{_decimal(elevation, 2)}",
        "target": ",".join(_decimal(float(place), digits) for place in target),
        "distance": _decimal(distance, digits),
        "focal-length": _decimal(focal_length_of(field_of_view), 3),
        "roll": _decimal(roll, 2),
    }
    return " ".join(f"--{name} {value}" for name, value in options.items() if (name, value) != ("roll", "0"))


def _decimal(number: float, digits: int) -> str:
    """Without zeros at its end."""
    text = f"{number:.{digits}f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return "0" if text == "-0" else text


class CameraKeywords(TypedDict, total=False):
    """Keywords of cameras: fields of `CameraSettings`."""

    view: str | tuple[float, float] | None
    look_at: str | None
    target: tuple[float, float, float] | None
    distance: float | None
    focal_length: float | None
    roll: float
    camera: str | None
