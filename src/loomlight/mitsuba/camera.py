"""Cameras that frame a whole object at zoom 1 and come closer from there."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

import drjit as dr
import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import opaque
from loomlight.core.camera_settings import CameraSettings, direction_of_angles
from loomlight.core.errors import InputError
from loomlight.mesh.file_camera import FileCamera

Vector = NDArray[np.float64]

FIELD_OF_VIEW = 26.0  # degrees, of the picture's shorter side
# Over a floor: degrees from a picture's middle to its upper edge at most, and from there to the horizon at
# least. Taller pictures take a longer lens from farther away, as photographers do, so that floor fills them.
_MAX_UPWARD, _BELOW_HORIZON = 17.5, 4.0
# Cameras below that see over the floor in any case: they keep the lens that they have there, degrees.
_LEAST_ELEVATION = 17.0
_MARGIN = 1.04
MAX_ZOOM = 1000.0
# Of a unit vector's horizontal part, in directions that have no azimuth.
_VERTICAL = 1e-6
# The same for all views, and beyond every scene: kernels hold them.
_NEAR, _FAR = 1e-7, 1e7


def _upwards() -> Vector:
    return np.array([0.0, 1.0, 0.0])


@dataclass(frozen=True)
class View:
    """Where a camera stands, what it looks at, and degrees that the picture's shorter side shows.

    `up` is upwards in the picture, no direction of sight.
    """

    origin: Vector
    target: Vector
    field_of_view: float = FIELD_OF_VIEW
    up: Vector = field(default_factory=_upwards)

    @property
    def backward(self) -> Vector:
        """Unit vector from the target to the camera."""
        offset = self.origin - self.target
        return np.asarray(offset / np.linalg.norm(offset))

    @property
    def azimuth(self) -> float:
        """Degrees about the vertical, 0 from +z, 90 from +x; from above that of its lower edge."""
        x, height, z = self.backward
        if np.hypot(x, z) < _VERTICAL:
            x, _, z = -np.sign(height) * self.up
        return float(np.degrees(np.arctan2(x, z)))

    @property
    def elevation(self) -> float:
        """Degrees above the horizon."""
        return float(np.degrees(np.arcsin(np.clip(self.backward[1], -1, 1))))

    @property
    def roll(self) -> float:
        """Degrees that the picture is turned by, counter-clockwise."""
        around = np.radians(self.azimuth)
        right = np.array([np.cos(around), 0.0, -np.sin(around)])
        above = np.cross(self.backward, right)
        return float(np.degrees(np.arctan2(self.up @ right, self.up @ above)))

    def across(self, size: tuple[int, int]) -> float:
        """Degrees that a picture of `size` shows of its width."""
        return float(2 * np.degrees(np.arctan(_slopes(size, self.field_of_view)[0])))

    def closer(self, zoom: float, point: Vector) -> View:
        """The view `zoom` times closer to `point` on the cloth; at zoom 1 this view itself."""
        origin, target = (point + (place - point) / zoom for place in (self.origin, self.target))
        return replace(self, origin=origin, target=target)


def field_of_view_over_floor(towards_camera: Vector, size: tuple[int, int]) -> float:
    """Degrees of the shorter side of a picture that shows nothing but floor behind its object.

    Args:
        towards_camera: where the camera stands; 17 degrees above the floor and more.
        size: width and height of the picture.
    """
    elevation = np.degrees(np.arcsin(towards_camera[1] / np.linalg.norm(towards_camera)))
    upward = np.radians(min(_MAX_UPWARD, max(elevation, _LEAST_ELEVATION) - _BELOW_HORIZON))
    slope = min(np.tan(np.radians(FIELD_OF_VIEW / 2)), np.tan(upward) * min(size) / size[1])
    return float(2 * np.degrees(np.arctan(slope)))


def framing(
    points: Vector,
    towards_camera: Vector,
    size: tuple[int, int],
    field_of_view: float = FIELD_OF_VIEW,
    up: Vector | None = None,
) -> View:
    """The nearest view from the direction `towards_camera` that shows all `points` [n, 3].

    Args:
        up: upwards in the picture, no direction of sight; +y by default.
    """
    upwards = _upwards() if up is None else up
    backward = towards_camera / np.linalg.norm(towards_camera)
    right = np.cross(upwards, backward)
    right /= np.linalg.norm(right)
    above = np.cross(backward, right)
    x, y, z = points @ right, points @ above, points @ backward
    slope_x, slope_y = _slopes(size, field_of_view)
    # Each pair of opposite points bounds the distance; half their sum centres them in perspective.
    high_x, low_x = np.max(x + slope_x * z), np.max(-x + slope_x * z)
    high_y, low_y = np.max(y + slope_y * z), np.max(-y + slope_y * z)
    distance = max((high_x + low_x) / (2 * slope_x), (high_y + low_y) / (2 * slope_y))
    depth = (z.min() + z.max()) / 2
    across = (high_x - low_x) / 2 * right + (high_y - low_y) / 2 * above
    target = across + depth * backward
    return View(target + (distance - depth) * _MARGIN * backward, target, field_of_view, upwards)


def chosen_view(
    settings: CameraSettings,
    points: Vector,
    towards_camera: Vector,
    size: tuple[int, int],
    over_floor: bool = False,
) -> View:
    """The view that settings of a camera choose, but for a camera of a file; see `view_of_file`.

    Args:
        points: what the camera frames [n, 3], metres.
        towards_camera: where it stands unless they say so.
        over_floor: the lens that shows nothing but floor is taken unless they choose one.
    """
    towards, up = towards_camera, _upwards()
    if settings.angles is not None:
        azimuth, elevation = settings.angles
        towards = direction_of_angles(azimuth, elevation)
        up = direction_of_angles(azimuth, elevation + 90)
    if settings.roll:
        right = np.cross(up, towards)
        above = np.cross(towards, right)
        right, above = (axis / np.linalg.norm(axis) for axis in (right, above))
        angle = np.radians(settings.roll)
        up = np.cos(angle) * above + np.sin(angle) * right
    lens = settings.field_of_view
    if lens is None:
        lens = field_of_view_over_floor(towards, size) if over_floor else FIELD_OF_VIEW
    view = framing(points, towards, size, lens, up)
    if settings.target is None and settings.distance is None:
        return view
    target = view.target if settings.target is None else np.array(settings.target, float)
    distance = settings.distance or float(np.linalg.norm(view.origin - view.target))
    return replace(view, origin=target + distance * view.backward, target=target)


def view_of_file(camera: FileCamera, metres_per_unit: float, size: tuple[int, int]) -> View:
    """The view of a camera of a mesh file: all of its own picture, in one of `size`."""
    right_up_back = camera.to_world[:3, :3]
    origin = metres_per_unit * camera.to_world[:3, 3]
    width, height = size
    vertical = np.tan(np.radians(camera.vertical) / 2)
    if camera.aspect is not None:
        vertical = max(vertical, vertical * camera.aspect * height / width)
    shorter = np.degrees(2 * np.arctan(vertical * min(size) / height))
    return View(origin, origin - right_up_back[:, 2], float(shorter), right_up_back[:, 1])


def size_of_file(camera: FileCamera, longer: int) -> tuple[int, int] | None:
    """Width and height of its own picture of so many pixels; None where the file leaves that open."""
    if camera.aspect is None:
        return None
    width, height = (
        (longer, longer / camera.aspect) if camera.aspect > 1 else (longer * camera.aspect, longer)
    )
    return max(1, round(width)), max(1, round(height))


def perspective(view: View, size: tuple[int, int]) -> dict[str, Any]:
    """The dictionary of Mitsuba's sensor for `view`, `size` = (width, height) in pixels."""
    return {
        "type": "perspective",
        "fov": view.field_of_view,
        "fov_axis": "smaller",
        "near_clip": _NEAR,
        "far_clip": _FAR,
        "to_world": look_at(view),
        "film": {
            "type": "hdrfilm",
            "width": size[0],
            "height": size[1],
            "pixel_format": "rgb",
            "rfilter": {"type": "gaussian"},
        },
        # Stratified in all dimensions: on cloth two to three times fewer samples for the same noise.
        "sampler": {"type": "multijitter"},
    }


class Corner(NamedTuple):
    """A square of a picture in which a camera looks from nearer; by default none.

    Attributes:
        low, high: its edges, shares of the picture's width and height.
        scale: how many times larger its pixels are, for the same camera, than those around it.
        origin: where that camera stands.
    """

    low: Any = (2.0, 2.0)
    high: Any = (2.0, 2.0)
    scale: float = 1.0
    origin: Any = (0.0, 0.0, 0.0)


class Pinhole:
    """Rays of a sensor of `perspective` as data of kernels, of which Mitsuba's own hold the film's size."""

    def __init__(self, camera: Any, corner: Corner) -> None:
        self._camera = camera

        def towards(x: float, y: float) -> Any:
            return camera.sample_ray(0, 0, mi.Point2f(x, y), mi.Point2f(0))[0].d

        axis = towards(0.5, 0.5)
        first, right, below = (
            ray / dr.dot(ray, axis) for ray in (towards(0, 0), towards(1, 0), towards(0, 1))
        )
        self._first, self._across, self._down = first, right - first, below - first
        self._origin = mi.Point3f(camera.world_transform().translation())
        dr.make_opaque(self._origin, self._first, self._across, self._down)
        self._pixel = mi.Vector2f(opaque(mi.Float, 1 / np.array(camera.film().crop_size())))
        self._low, self._high = (mi.Vector2f(opaque(mi.Float, edge)) for edge in (corner.low, corner.high))
        self._scale = opaque(mi.Float, corner.scale)
        self._corner_origin = mi.Point3f(opaque(mi.Float, corner.origin))

    @classmethod
    def of(cls, camera: Any, corner: Corner | None) -> Any:
        """The rays of a sensor of built-in scenes; another sensor as it is."""
        is_ours = camera.class_name() == "PerspectiveCamera" and mi.traverse(camera)["near_clip"] <= 2 * _NEAR
        return cls(camera, corner or Corner()) if is_ours else camera

    def sample_ray_differential(
        self, time: Any, sample1: Any, sample2: Any, sample3: Any, active: Any = True
    ) -> tuple[Any, Any]:
        del sample1, sample3, active
        is_close = dr.all((sample2 >= self._low) & (sample2 < self._high))
        middle = 0.5 * (self._low + self._high)
        place = dr.select(is_close, 0.5 + (sample2 - middle) * self._scale, sample2)
        pixel = dr.select(is_close, self._scale, 1) * self._pixel
        towards = self._first + place.x * self._across + place.y * self._down
        origin = dr.select(is_close, self._corner_origin, self._origin)
        ray = mi.RayDifferential3f(origin, dr.normalize(towards), time)
        ray.o_x = ray.o_y = origin
        ray.d_x = dr.normalize(towards + pixel.x * self._across)
        ray.d_y = dr.normalize(towards + pixel.y * self._down)
        ray.has_differentials = True
        return ray, mi.Spectrum(1)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._camera, name)


def look_at(view: View) -> Any:
    """Mitsuba's camera-to-world transform of `view`."""
    return mi.ScalarTransform4f().look_at(
        origin=view.origin.tolist(), target=view.target.tolist(), up=view.up.tolist()
    )


def require_zoom(zoom: float) -> None:
    """Raises InputError unless 0 < `zoom` ≤ 1000."""
    if not 0 < zoom <= MAX_ZOOM:
        raise InputError(f"zoom = {zoom:g} is out of range: 1 frames the object, 10 is ten times closer.")


def require_size(size: tuple[int, int]) -> None:
    """Raises InputError unless both sides are from 1 to 16384 pixels."""
    if len(size) != 2 or not all(1 <= side <= 16384 for side in size):
        raise InputError(f"size = {size} is out of range: width and height lie between 1 and 16384 pixels.")


def _slopes(size: tuple[int, int], field_of_view: float) -> tuple[float, float]:
    """Half the picture's width and height at distance 1."""
    slope = np.tan(np.radians(field_of_view) / 2)
    width, height = size
    shorter = min(width, height)
    return float(slope * width / shorter), float(slope * height / shorter)
