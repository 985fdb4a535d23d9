"""A window of cloth: mouse and keys change camera, model and light; frames add up while it rests."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from loomlight.realtime.device import Adapter
from loomlight.realtime.orbit import Orbit
from loomlight.realtime.renderer import FrameOptions, Picture, Renderer
from loomlight.realtime.scene import Light

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
    ) -> None:
        self._renderer = renderer
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
