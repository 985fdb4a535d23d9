"""A window of cloth: mouse and keys change camera, model and light; frames add up while it rests."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.camera_settings import options_of_camera
from loomlight.core.errors import InputError
from loomlight.realtime.device import Adapter
from loomlight.realtime.renderer import FrameOptions, Picture, Renderer
from loomlight.realtime.scene import Camera, Light, Vector

# ------------------------------------------------------------------------------------------------------ orbit
# A camera that orbits about a target: what a viewer's mouse moves. No window is needed.


# Degrees that a drag over the picture's shorter side turns the camera by.
TURN_DEGREES = 180.0
# Closer than that to the vertical the camera would have no up.
STEEPEST_DEGREES = 89.0
# Distances per notch of a wheel.
NOTCH = 1.15
_UP = np.array([0.0, 1.0, 0.0])


@dataclass(frozen=True, eq=False)
class Orbit:
    """Position of a camera, as seen from its target; +y is up.

    Attributes:
        target: what it looks at, metres.
        azimuth: degrees about the vertical, 0 from +z, 90 from +x.
        elevation: degrees above the horizon, −89 to 89.
        distance: from the target, metres.
        nearest, farthest: bounds of the distance.
        field_of_view: of the picture's shorter side, degrees.
        roll: that the picture is turned by, counter-clockwise, degrees.
    """

    target: NDArray[np.float64]
    azimuth: float
    elevation: float
    distance: float
    nearest: float = 2e-3
    farthest: float = 100.0
    field_of_view: float = 26.0
    roll: float = 0.0

    @classmethod
    def between(cls, origin: Vector, target: Vector, nearest: float = 2e-3) -> Orbit:
        """The orbit of a camera at `origin` that looks at `target`.

        Raises:
            InputError: both are the same point.
        """
        aim = np.asarray(target, float)
        offset = np.asarray(origin, float) - aim
        distance = float(np.linalg.norm(offset))
        if not distance > 0:
            raise InputError(f"The camera at {aim.tolist()} looks at the point where it stands.")
        elevation = math.degrees(math.asin(offset[1] / distance))
        azimuth = math.degrees(math.atan2(offset[0], offset[2]))
        steepest = min(max(elevation, -STEEPEST_DEGREES), STEEPEST_DEGREES)
        return cls(aim, azimuth, steepest, distance, min(nearest, distance), 10 * distance)

    @property
    def backward(self) -> NDArray[np.float64]:
        """Unit vector from the target to the camera."""
        around, above = math.radians(self.azimuth), math.radians(self.elevation)
        across = math.cos(above)
        return np.array([across * math.sin(around), math.sin(above), across * math.cos(around)])

    def camera(self) -> Camera:
        """The camera that stands there."""
        return Camera(
            self.target + self.distance * self.backward,
            self.target,
            self._axes()[1],
            self.field_of_view,
            near=self.distance * 1e-3,
        )

    def options(self) -> str:
        """The camera as options of the command line."""
        angles = (self.azimuth + 180) % 360 - 180, self.elevation
        return options_of_camera(angles, self.target, self.distance, self.field_of_view, self.roll)

    def turned(self, right: float, down: float) -> Orbit:
        """After a drag, in shares of the picture's shorter side: the object follows the mouse."""
        cosine, sine = math.cos(math.radians(self.roll)), math.sin(math.radians(self.roll))
        right, down = cosine * right - sine * down, sine * right + cosine * down
        elevation = min(max(self.elevation + TURN_DEGREES * down, -STEEPEST_DEGREES), STEEPEST_DEGREES)
        return replace(self, azimuth=(self.azimuth - TURN_DEGREES * right) % 360, elevation=elevation)

    def moved(self, right: float, down: float) -> Orbit:
        """After a drag that moves the object with the mouse, in shares of the picture's shorter side."""
        side = 2 * self.distance * math.tan(math.radians(self.field_of_view) / 2)
        to_right, up = self._axes()
        return replace(self, target=self.target + side * (down * up - right * to_right))

    def _axes(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Unit vectors to the right and upwards in the picture."""
        right = np.cross(_UP, self.backward)
        right /= np.linalg.norm(right)
        up = np.cross(self.backward, right)
        cosine, sine = math.cos(math.radians(self.roll)), math.sin(math.radians(self.roll))
        return cosine * right - sine * up, cosine * up + sine * right

    def closer(self, notches: float) -> Orbit:
        """After so many notches of a wheel towards the cloth, within the bounds of the distance."""
        return self.closer_by(NOTCH**notches)

    def closer_by(self, ratio: float) -> Orbit:
        """So many times closer, within the bounds of the distance."""
        distance = self.distance / ratio
        return replace(self, distance=min(max(distance, self.nearest), self.farthest))


# ----------------------------------------------------------------------------------------------------- viewer


# Passes after which a resting picture is left as it is.
MAX_PASSES = 256
_PIXELS_A_NOTCH = 100.0  # that a wheel event tells
_STOPS_A_KEY = 0.5
_EVENTS = ("pointer_down", "pointer_move", "pointer_up", "wheel", "key_down", "resize")


@dataclass(frozen=True)
class Lighting:
    """Lights that the key l goes through.

    Attributes:
        name: in the window's title.
        lights: directional and point lights.
        options: of the frame; the environment.
    """

    name: str
    lights: Sequence[Light]
    options: FrameOptions = field(default_factory=FrameOptions)


class Viewer:
    """State of a window, and its response to events; the canvas is any of rendercanvas'.

    Attributes:
        orbit: of the camera.
        exposure: stops.
        lighting: the lights.
    """

    def __init__(
        self,
        renderer: Renderer,
        orbit: Orbit,
        lightings: Sequence[Lighting],
        models: Sequence[str] = ("lobes", "point"),
        exposure: float = 0.0,
        tell: Callable[[str], object] = print,
    ) -> None:
        """Options of the camera are told when they are asked for."""
        self._renderer, self._tell = renderer, tell
        self._lightings, self._models = list(lightings), list(models)
        self._start, self._start_exposure = orbit, exposure
        self._pointer: tuple[float, float] | None = None
        self._moves = False
        self.orbit, self.exposure = orbit, exposure
        self.lighting = self._lightings[0]

    @property
    def model(self) -> str:
        """The name of the model that shades."""
        return self._renderer.model

    @property
    def adapter(self) -> Adapter:
        """The graphics adapter that computes."""
        return self._renderer.adapter

    def frame(self) -> Picture:
        """One more pass of the picture at rest, or the first of another."""
        return self._renderer.accumulate(
            self.orbit.camera(), self.lighting.lights, exposure=self.exposure, **self.lighting.options
        )

    def title(self, seconds: float) -> str:
        """The window's title after a frame that took so long."""
        return (
            f"loomlight · {self.model} · {self.lighting.name} · {1000 * seconds:.1f} ms a frame · "
            f"{self._renderer.passes} passes"
        )

    def handle(self, event: Mapping[str, Any]) -> bool:
        """Takes an event of rendercanvas; whether there is something new to draw."""
        kind = event["event_type"]
        if kind == "pointer_down":
            self._pointer = event["x"], event["y"]
            self._moves = event["button"] != 1 or "Shift" in event.get("modifiers", ())
        elif kind == "pointer_up":
            self._pointer = None
        elif kind == "pointer_move":
            return self._drag(event["x"], event["y"], event.get("side"))
        elif kind == "wheel":
            self.orbit = self.orbit.closer(-event["dy"] / _PIXELS_A_NOTCH)
            return True
        elif kind == "key_down":
            return self._press(event["key"])
        elif kind == "resize":
            ratio = event.get("pixel_ratio", 1)
            return self.resize(round(event["width"] * ratio), round(event["height"] * ratio))
        return False

    def resize(self, width: int, height: int) -> bool:
        """Gives frames another size; whether it is another one."""
        size = min(max(width, 1), 8192), min(max(height, 1), 8192)
        if size == self._renderer.size:
            return False
        self._renderer.resize(size)
        return True

    def _drag(self, x: float, y: float, side: float | None) -> bool:
        if self._pointer is None:
            return False
        shorter = side or min(self._renderer.size)
        right, down = (x - self._pointer[0]) / shorter, (y - self._pointer[1]) / shorter
        self._pointer = x, y
        self.orbit = self.orbit.moved(right, down) if self._moves else self.orbit.turned(right, down)
        return True

    def _press(self, key: str) -> bool:
        if key == "m":
            self._renderer.set_model(_following(self._models, self.model))
        elif key == "l":
            self.lighting = _following(self._lightings, self.lighting)
        elif key in ("+", "=", "-"):
            self.exposure += -_STOPS_A_KEY if key == "-" else _STOPS_A_KEY
        elif key == "r":
            self.orbit, self.exposure = self._start, self._start_exposure
        else:
            if key == "c":
                self._tell(self.orbit.options())
            return False
        return True

    def attach(self, canvas: Any) -> None:
        """Draws into a canvas of rendercanvas, and takes its events."""
        context = canvas.get_bitmap_context()

        def draw() -> None:
            start = time.perf_counter()
            picture = self.frame()
            context.set_bitmap(picture.srgb)
            canvas.set_title(self.title(time.perf_counter() - start))
            if self._renderer.passes < MAX_PASSES:
                canvas.request_draw()

        def on_event(event: dict[str, Any]) -> None:
            side = min(canvas.get_logical_size())
            if self.handle({**event, "side": side}):
                canvas.request_draw()

        canvas.add_event_handler(on_event, *_EVENTS)
        self.resize(*canvas.get_physical_size())
        canvas.request_draw(draw)


def _following(items: Sequence[Any], item: Any) -> Any:
    """The item behind another one, the first behind the last."""
    return items[(items.index(item) + 1) % len(items)]
