"""A camera that orbits about a target: what a viewer's mouse moves. No window is needed."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.realtime.scene import Camera, Vector

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
    """

    target: NDArray[np.float64]
    azimuth: float
    elevation: float
    distance: float
    nearest: float = 2e-3
    farthest: float = 100.0
    field_of_view: float = 26.0

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
            _UP,
            self.field_of_view,
            near=self.distance * 1e-3,
        )

    def turned(self, right: float, down: float) -> Orbit:
        """After a drag, in shares of the picture's shorter side: the object follows the mouse."""
        elevation = min(max(self.elevation + TURN_DEGREES * down, -STEEPEST_DEGREES), STEEPEST_DEGREES)
        return replace(self, azimuth=(self.azimuth - TURN_DEGREES * right) % 360, elevation=elevation)

    def moved(self, right: float, down: float) -> Orbit:
        """After a drag that moves the object with the mouse, in shares of the picture's shorter side."""
        side = 2 * self.distance * math.tan(math.radians(self.field_of_view) / 2)
        to_right = np.cross(_UP, self.backward)
        to_right /= np.linalg.norm(to_right)
        up = np.cross(self.backward, to_right)
        return replace(self, target=self.target + side * (down * up - right * to_right))

    def closer(self, notches: float) -> Orbit:
        """After so many notches of a wheel towards the cloth, within the bounds of the distance."""
        return self.closer_by(NOTCH**notches)

    def closer_by(self, ratio: float) -> Orbit:
        """So many times closer, within the bounds of the distance."""
        distance = self.distance / ratio
        return replace(self, distance=min(max(distance, self.nearest), self.farthest))
