"""What a camera over flat cloth sees of a fabric: the picture that a photograph is compared with.

The camera looks straight down at the middle of the picture, from ten of its widths away, as one holds a
telephone over a swatch. A flash stands at the camera; a window is a wide light from one side. What a white
card that faces the light at the middle shows is 1. Behind holes it is black.

It needs no renderer: flat cloth under one light is what the point model returns, with its shadows and the
light between its yarns, one point a sample.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import array_types, upload
from loomlight.core.footprint import Footprint
from loomlight.fabric.fabric import Fabric
from loomlight.models.point import PointModel

Linear = NDArray[np.float32]

# Of the camera over the cloth, in widths of the picture.
CAMERA_WIDTHS = 10.0
# A window is 36 degrees wide, seen from the cloth: so many directions, a golden turn apart, stand for it.
_WINDOW_RADIUS, _WINDOW_LIGHTS = 18.0, 4
_GOLDEN_TURN = 2.399963
# Samples traced at once: 100 MB of what the point model holds.
_LANES = 1 << 20


@dataclass(frozen=True)
class Light:
    """Where the light of a photograph comes from.

    Attributes:
        kind: "flash" at the camera, or "window", from a side.
        azimuth: of a window, degrees from the right of the picture, anticlockwise.
        elevation: of the middle of a window, degrees above the cloth.
    """

    kind: str = "flash"
    azimuth: float = 90.0
    elevation: float = 40.0

    def directions(self) -> NDArray[np.float64]:
        """Unit vectors [n, 3] towards the parts of a window, in the frame of the cloth."""
        azimuth, elevation = np.radians(self.azimuth), np.radians(self.elevation)
        number = np.arange(_WINDOW_LIGHTS)
        radius = np.radians(_WINDOW_RADIUS) * np.sqrt((number + 0.5) / _WINDOW_LIGHTS)
        up, aside = radius * np.sin(_GOLDEN_TURN * number), radius * np.cos(_GOLDEN_TURN * number)
        elevation, azimuth = elevation + up, azimuth + aside / np.cos(elevation)
        level = np.cos(elevation)
        return np.stack([level * np.cos(azimuth), level * np.sin(azimuth), np.sin(elevation)], axis=1)


class Framed(Protocol):
    """Which cloth the pixels of a picture show."""

    @property
    def size(self) -> tuple[int, int]:
        """Width and height, pixels."""

    def at(self, columns: NDArray[np.float64], rows: NDArray[np.float64]) -> NDArray[np.float64]:
        """Millimetres of the cloth [2, n] at places in pixels: x along the wefts, y up along the ends."""

    def camera(self) -> NDArray[np.float64]:
        """Where the camera is [3], millimetres of the cloth."""


@dataclass(frozen=True, eq=False)
class Framing:
    """Cloth on a plane.

    Attributes:
        size: width and height, pixels.
        to_cloth: 3 × 3 homography from pixels (column, row, 1) to millimetres of the cloth, x to the right
            along the wefts, y up along the ends.
        width_mm: of the picture.
        tilt: where the camera's axis points from the cloth, the tangents of the angles along x and y.
    """

    size: tuple[int, int]
    to_cloth: NDArray[np.float64]
    width_mm: float
    tilt: tuple[float, float] = (0.0, 0.0)

    def at(self, columns: NDArray[np.float64], rows: NDArray[np.float64]) -> NDArray[np.float64]:
        """Millimetres [2, n] of places in pixels."""
        points = self.to_cloth @ np.stack([columns, rows, np.ones_like(columns)])
        return np.asarray(points[:2] / points[2])

    def camera(self) -> NDArray[np.float64]:
        """Where the camera is [3], millimetres of the cloth."""
        middle = self.at(*(np.array([side / 2]) for side in self.size))[:, 0]
        axis = np.array([*self.tilt, 1.0])
        distance = CAMERA_WIDTHS * self.width_mm
        return np.asarray(np.array([*middle, 0.0]) + distance * axis / np.linalg.norm(axis))


def straight(size: tuple[int, int], width_mm: float, turn: float = 0.0) -> Framing:
    """The framing of a camera right over the cloth, turned by `turn` radians anticlockwise."""
    step = width_mm / size[0]
    cosine, sine = step * np.cos(turn), step * np.sin(turn)
    # Rows count downwards.
    matrix = np.array([[cosine, sine, 0.0], [sine, -cosine, 0.0], [0.0, 0.0, 1.0]])
    matrix[:2, 2] = -(matrix[:2, :2] @ [size[0] / 2, size[1] / 2])
    return Framing(size, matrix, width_mm)


def photograph(
    fabric: Fabric, framing: Framed, light: Light | None = None, samples: int = 4, seed: int = 0
) -> Linear:
    """Linear RGB [height, width, 3] of flat cloth.

    Args:
        samples: a pixel, rounded up to a square.
        seed: of their places.
    """
    model = PointModel(fabric)
    width, height = framing.size
    rows_at_once = max(1, _LANES // (width * samples))
    parts = [
        _rows(model, framing, light or Light(), first, min(first + rows_at_once, height), samples, seed)
        for first in range(0, height, rows_at_once)
    ]
    return np.concatenate(parts)


def _rows(
    model: PointModel, framing: Framed, light: Light, first: int, last: int, samples: int, seed: int
) -> Linear:
    """Rows of the picture."""
    across = int(np.ceil(np.sqrt(samples)))
    width = framing.size[0]
    rows, columns = (part.ravel().astype(np.float64) for part in np.mgrid[first:last, 0:width])
    rng = np.random.default_rng([seed, first])
    cells = np.arange(across**2)[:, None]
    places = [
        (base[None, :] + (cell + rng.random((across**2, base.size))) / across).ravel()
        for base, cell in ((columns, cells % across), (rows, cells // across))
    ]
    found = seen(model, framing, light, places[0], places[1], across).reshape(across**2, -1, 3)
    return found.mean(axis=0).reshape(last - first, width, 3).astype(np.float32)


def seen(
    model: PointModel,
    framing: Framed,
    light: Light,
    columns: NDArray[np.float64],
    rows: NDArray[np.float64],
    across: int = 1,
) -> NDArray[np.float64]:
    """Linear RGB [n, 3] at places of the picture.

    Args:
        across: samples along a side of a pixel, which share its footprint.
    """
    types = _llvm_types()
    points = framing.at(columns, rows)
    steps = [framing.at(columns + dx, rows + dy) - points for dx, dy in ((1.0, 0.0), (0.0, 1.0))]

    def on_device(values: NDArray[np.float64]) -> Any:
        return upload(types.Float, values.astype(np.float32))

    def vector(values: NDArray[np.float64]) -> Any:
        kind = types.Vector2 if len(values) == 2 else types.Vector3
        return kind(*(on_device(part) for part in values))

    place = np.concatenate([points, np.zeros((1, points.shape[1]))])
    to_camera = framing.camera()[:, None] - place
    distance = np.linalg.norm(to_camera, axis=0)
    view = to_camera / distance
    footprint = Footprint(vector(points), *(vector(step / across) for step in steps))
    at = model.at(vector(view), model.on_cloth(footprint))
    if light.kind == "flash":
        nearest = np.linalg.norm(framing.camera() - [*framing.camera()[:2], 0.0])
        lights = [(vector(view), np.pi * np.square(nearest / distance))]
    else:
        directions = light.directions()
        strength = np.pi / directions[:, 2].sum()
        lights = [
            (types.Vector3(*(dr.opaque(types.Float, float(part)) for part in towards)), strength)
            for towards in directions
        ]
    total = np.zeros((points.shape[1], 3))
    for towards, strength in lights:
        value = at.value(towards).numpy().T
        total += value * np.broadcast_to(strength, total.shape[:1])[:, None]
    return total


def _llvm_types() -> Any:
    """Of the CPU: pictures are small."""
    from drjit.llvm.ad import Float

    return array_types(Float)
