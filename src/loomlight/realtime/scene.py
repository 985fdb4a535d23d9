"""The scene of a frame: meshes with a fabric each, lights and a camera. Lengths are metres."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric
from loomlight.models.interface import Model
from loomlight.realtime.layout import numpy_type

Vector = Sequence[float] | NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Mesh:
    """Triangles with normals and uv.

    Attributes:
        positions: [n, 3], metres.
        normals: [n, 3], unit vectors.
        uv: [n, 2].
        faces: [m, 3], vertices of each triangle.
    """

    positions: NDArray[np.float64]
    normals: NDArray[np.float64]
    uv: NDArray[np.float64]
    faces: NDArray[np.uint32]

    def __post_init__(self) -> None:
        count = len(self.positions)
        if self.positions.shape != (count, 3) or self.normals.shape != (count, 3):
            raise InputError("A mesh needs positions and normals [n, 3] of the same vertices.")
        if self.uv is None or np.shape(self.uv) != (count, 2):
            raise InputError("The mesh has no uv for each vertex; unwrap it, as they place the weave on it.")
        if self.faces.ndim != 2 or self.faces.shape[1] != 3 or len(self.faces) == 0:
            raise InputError("A mesh needs faces [m, 3], three vertices each, at least one.")
        if self.faces.min() < 0 or self.faces.max() >= count:
            raise InputError(f"A face of the mesh names a vertex outside 0 to {count - 1}.")
        if not all(np.isfinite(a).all() for a in (self.positions, self.normals, self.uv)):
            raise InputError("The mesh holds numbers that are not finite.")


def rectangle(width: float, height: float) -> Mesh:
    """A rectangle in the plane z = 0 about the origin, metres; u along x and v along y, 0 to 1."""
    uv = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])
    positions = np.concatenate([(uv - 0.5) * (width, height), np.zeros((4, 1))], axis=1)
    normals = np.tile([0.0, 0, 1], (4, 1))
    return Mesh(positions, normals, uv, np.array([[0, 1, 2], [0, 2, 3]], np.uint32))


@dataclass(frozen=True, eq=False)
class Cloth:
    """A mesh and its fabric.

    Attributes:
        fabric: a fabric, or a model that is made already, such as `model_from_loom` reads.
        uv_size_mm: millimetres per unit of u and of v.
        albedo: linear RGB [rows, columns, 3], 0 to 1, over the unit of uv, which repeats; v runs down. The
            diffuse albedos are multiplied by its mean over each footprint. None leaves them.
    """

    mesh: Mesh
    fabric: Fabric | Model
    uv_size_mm: tuple[float, float] = (100.0, 100.0)
    albedo: NDArray[np.floating] | None = None

    def __post_init__(self) -> None:
        shape = None if self.albedo is None else self.albedo.shape
        if shape is not None and (len(shape) != 3 or shape[2] != 3 or 0 in shape):
            raise InputError(f"albedo of shape {shape} is no picture: it has [rows, columns, 3].")


@dataclass(frozen=True)
class DirectionalLight:
    """Parallel light.

    Attributes:
        towards: the direction from which it comes, of any length.
        irradiance: linear RGB on a surface that faces it, W/m².
    """

    towards: Vector
    irradiance: Vector = field(default_factory=lambda: (math.pi,) * 3)

    def record(self) -> tuple[int, NDArray[np.float64], NDArray[np.float64]]:
        """As shaders have it: kind, direction, irradiance."""
        return 0, _unit(self.towards, "towards"), np.asarray(self.irradiance, float)


@dataclass(frozen=True)
class PointLight:
    """Light from a point.

    Attributes:
        position: metres.
        intensity: linear RGB, W/sr.
    """

    position: Vector
    intensity: Vector

    def record(self) -> tuple[int, NDArray[np.float64], NDArray[np.float64]]:
        """As shaders have it: kind, position, intensity."""
        return 1, np.asarray(self.position, float), np.asarray(self.intensity, float)


@dataclass(frozen=True)
class Camera:
    """A pinhole camera.

    Attributes:
        origin, target: where it stands and what it looks at, metres.
        up: what is upwards in the picture.
        field_of_view: of the picture's shorter side, degrees.
        near: nearest distance that is drawn, metres.
    """

    origin: Vector
    target: Vector = (0.0, 0.0, 0.0)
    up: Vector = (0.0, 1.0, 0.0)
    field_of_view: float = 26.0
    near: float = 1e-4

    def axes(self, width: int, height: int) -> dict[str, NDArray[np.float64]]:
        """Origin, half the picture's sides at distance 1, and the unit vector forwards, by name.

        Raises:
            InputError: a field of view outside 0 to 180, or no direction to look in.
        """
        if not 0 < self.field_of_view < 180:
            raise InputError(
                f"field_of_view = {self.field_of_view:g} is out of range: it lies between 0 and 180 degrees."
            )
        origin = np.asarray(self.origin, float)
        forward = _unit(np.asarray(self.target, float) - origin, "target − origin")
        right = _unit(np.cross(forward, np.asarray(self.up, float)), "the camera's up")
        up = np.cross(right, forward)
        half = math.tan(math.radians(self.field_of_view) / 2) / min(width, height)
        return {"origin": origin, "right": right * half * width, "up": up * half * height, "forward": forward}


Light = DirectionalLight | PointLight


def light_records(lights: Sequence[Light]) -> NDArray[np.void]:
    """Records of lights; one that is dark if there is none, as no buffer is empty."""
    records = np.zeros(max(1, len(lights)), numpy_type("Light"))
    for record, light in zip(records, lights, strict=False):
        kind, place, colour = light.record()
        record["is_point"] = kind
        for name, value in zip(("x", "y", "z"), place, strict=True):
            record[name] = value
        for name, value in zip(("red", "green", "blue"), colour, strict=True):
            record[name] = value
    return records


def vertex_records(mesh: Mesh) -> NDArray[np.void]:
    """Records of a mesh's vertices."""
    kind = numpy_type("Vertex")
    rows = np.concatenate([mesh.positions, mesh.normals, mesh.uv], axis=1).astype(np.float32)
    return np.ascontiguousarray(rows).view(kind)[:, 0]


def _unit(vector: ArrayLike, what: str) -> NDArray[np.float64]:
    array = np.asarray(vector, float)
    length = float(np.linalg.norm(array))
    if not np.isfinite(length) or length == 0:
        raise InputError(f"{what} = {array.tolist()} has no direction.")
    return array / length
