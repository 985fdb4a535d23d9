"""The scene of a frame, and how shaders have it: meshes with a fabric each, lights, camera, environment.

Lengths are metres. `SceneWords` at the end puts hierarchy, meshes, albedo maps, environment and lights into
one buffer.
"""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from PIL import Image

from loomlight.core.environment_map import read_environment_map
from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric
from loomlight.models.interface import Model
from loomlight.realtime.device import Adapter
from loomlight.realtime.records import numpy_type

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


# -------------------------------------------------------------------------------------------------------- bvh
# A bounding volume hierarchy over triangles: a complete binary tree, split at medians, built with NumPy.


FACES_A_LEAF = 4
NO_FACE = 0xFFFFFFFF


@dataclass(frozen=True, eq=False)
class Hierarchy:
    """Boxes of a complete binary tree, and the faces of its leaves.

    Attributes:
        boxes: lower and upper corners of node 1, 2, 3 … [2·leaves − 1, 6]; below node n are 2n and 2n + 1.
        leaf_faces: [leaves, 4], `NO_FACE` for none.
    """

    boxes: NDArray[np.float32]
    leaf_faces: NDArray[np.uint32]

    @property
    def leaves(self) -> int:
        """Their number, a power of 2."""
        return len(self.leaf_faces)


def build_hierarchy(positions: NDArray[np.float64], faces: NDArray[np.uint32]) -> Hierarchy:
    """The hierarchy of triangles: every node is split at the median of its longest side.

    Args:
        positions: [n, 3].
        faces: [m, 3], m ≥ 1.
    """
    corners = positions[faces]
    low, high = corners.min(axis=1), corners.max(axis=1)
    centres = (low + high) / 2
    depth = max(0, int(np.ceil(np.log2(len(faces) / FACES_A_LEAF))))
    leaves = 1 << depth
    # Places of the leaves; those behind the last face stay empty, and at the end of every node.
    order = np.full((1, leaves * FACES_A_LEAF), -1)
    order[0, : len(faces)] = np.arange(len(faces))
    for _ in range(depth):
        order = _split(order, centres)
    leaf_faces = order.reshape(leaves, FACES_A_LEAF)
    is_empty = leaf_faces < 0
    leaf_low = np.where(is_empty[..., None], np.inf, low[leaf_faces]).min(axis=1)
    leaf_high = np.where(is_empty[..., None], -np.inf, high[leaf_faces]).max(axis=1)
    levels = [np.concatenate([leaf_low, leaf_high], axis=1)]
    while len(levels[-1]) > 1:
        pairs = levels[-1].reshape(-1, 2, 6)
        levels.append(np.concatenate([pairs[..., :3].min(axis=1), pairs[..., 3:].max(axis=1)], axis=1))
    boxes = np.concatenate(levels[::-1])
    # Boxes of nothing become a point far away: shading languages may take infinite numbers for NaN.
    boxes[(boxes[:, :3] > boxes[:, 3:]).any(axis=1)] = 1e30
    boxes = boxes.astype(np.float32)
    return Hierarchy(boxes, np.where(is_empty, NO_FACE, leaf_faces).astype(np.uint32))


def _split(order: NDArray[np.int64], centres: NDArray[np.float64]) -> NDArray[np.int64]:
    """Halves of all nodes of one level [2·nodes, places / 2], each sorted along its longest side."""
    is_empty = order < 0
    points = centres[order]
    low = np.where(is_empty[..., None], np.inf, points).min(axis=1)
    high = np.where(is_empty[..., None], -np.inf, points).max(axis=1)
    axis = np.argmax(np.where(high >= low, high - low, 0), axis=1)
    keys = np.take_along_axis(points, axis[:, None, None], axis=2)[..., 0]
    keys[is_empty] = np.inf
    by_key = np.take_along_axis(order, np.argsort(keys, axis=1, kind="stable"), axis=1)
    # Both halves get as many faces: leaves then are alike, and few are empty.
    count = (by_key >= 0).sum(axis=1)
    half = order.shape[1] // 2
    place = np.arange(half)
    first = (count + 1) // 2
    left = np.where(place < first[:, None], by_key[:, :half], -1)
    from_right = np.minimum(place + first[:, None], order.shape[1] - 1)
    right = np.where(
        place + first[:, None] < count[:, None], np.take_along_axis(by_key, from_right, axis=1), -1
    )
    return np.stack([left, right], axis=1).reshape(-1, half)


# ------------------------------------------------------------------------------------------------- albedo map
# Albedo maps for shaders: a pyramid of means of a texture, packed into words.


MAX_SIDE = 2048  # texels
ROOT_STEPS = 1023  # ten bits


def map_words(texels: NDArray[np.floating]) -> tuple[NDArray[np.uint32], int]:
    """Words of all levels, the finest first, and their number.

    A word holds square roots of red, green and blue in ten bits each. v runs down the picture.

    Args:
        texels: linear RGB [rows, columns, 3], 0 to 1, the top row first.
    """
    side = min(MAX_SIDE, 1 << math.ceil(math.log2(max(texels.shape[:2]))))
    level = _resized(np.clip(np.asarray(texels, np.float32), 0, 1), side)
    words = [_packed(level)]
    while len(level) > 1:
        half = len(level) // 2
        level = level.reshape(half, 2, half, 2, 3).mean(axis=(1, 3))
        words.append(_packed(level))
    return np.concatenate(words), len(words)


def _resized(texels: NDArray[np.float32], side: int) -> NDArray[np.float32]:
    """A square of `side` texels."""
    if texels.shape[:2] == (side, side):
        return texels
    planes = [
        Image.fromarray(np.ascontiguousarray(texels[..., channel])).resize(
            (side, side), Image.Resampling.BOX if side <= min(texels.shape[:2]) else Image.Resampling.BILINEAR
        )
        for channel in range(3)
    ]
    return np.stack([np.asarray(plane, np.float32) for plane in planes], axis=-1)


def _packed(level: NDArray[np.float32]) -> NDArray[np.uint32]:
    roots = np.rint(np.sqrt(level) * ROOT_STEPS).astype(np.uint32).reshape(-1, 3)
    return roots[:, 0] | (roots[:, 1] << np.uint32(10)) | (roots[:, 2] << np.uint32(20))


# ------------------------------------------------------------------------------------------------ environment
# Environments: equirectangular radiance, and the tables by which shaders choose directions from it.


# Larger maps are averaged down: a texel of 0.35° is smaller than the sun.
MAX_COLUMNS = 1024


@dataclass(frozen=True, eq=False)
class Environment:
    """Light from all directions, infinitely far away.

    Attributes:
        radiance: linear RGB [rows, columns, 3], equirectangular: +y is above, columns turn from −z over +x.
        turn: degrees about the vertical, as of `loomlight render --env-turn`.
    """

    radiance: NDArray[np.floating]
    turn: float = 0.0

    def __post_init__(self) -> None:
        if self.radiance.ndim != 3 or self.radiance.shape[2] != 3 or 0 in self.radiance.shape:
            raise InputError(f"An environment needs radiance [rows, columns, 3], not {self.radiance.shape}.")
        if not np.isfinite(self.radiance).all() or self.radiance.min() < 0:
            raise InputError("The environment holds radiance that is negative or no finite number.")

    @classmethod
    def read(cls, path: str | os.PathLike[str], turn: float = 0.0) -> Environment:
        """An environment from a latitude-longitude picture: .exr, .hdr, .png or .jpg.

        Raises:
            InputError: what `read_environment_map` raises.
        """
        return cls(read_environment_map(path), turn)

    def tables(self) -> EnvironmentTables:
        """Distributions for shaders, of a map of at most 1024 columns."""
        radiance = _at_most(np.asarray(self.radiance, np.float64), MAX_COLUMNS)
        rows, columns = radiance.shape[:2]
        edges = np.cos(np.arange(rows + 1) / rows * np.pi)
        solid_angles = (edges[:-1] - edges[1:]) * (2 * np.pi / columns)
        weights = radiance.mean(axis=2) * solid_angles[:, None]
        by_row = weights.sum(axis=1)
        total = float(by_row.sum())
        return EnvironmentTables(
            _distribution(by_row[None])[0].astype(np.float32),
            _distribution(weights).astype(np.float32),
            radiance.astype(np.float32),
            total,
        )


@dataclass(frozen=True, eq=False)
class EnvironmentTables:
    """Distributions that shaders choose directions by.

    Attributes:
        rows: cumulative distribution of rows [rows + 1].
        columns: of columns within each row [rows, columns + 1].
        radiance: of each texel [rows, columns, 3].
        total: integral of the mean of red, green and blue over the sphere.
    """

    rows: NDArray[np.float32]
    columns: NDArray[np.float32]
    radiance: NDArray[np.float32]
    total: float

    def words(self) -> NDArray[np.uint32]:
        """All of them, one behind the other."""
        parts = (self.rows, self.columns, self.radiance)
        return np.concatenate([part.ravel() for part in parts]).view(np.uint32)


def _distribution(weights: NDArray[np.float64]) -> NDArray[np.float64]:
    """Cumulative distributions along the last axis, from 0 to 1; uniform where all weights are 0."""
    sums = np.cumsum(weights, axis=-1)
    total = sums[..., -1:]
    count = weights.shape[-1]
    uniform = np.broadcast_to(np.arange(1, count + 1) / count, sums.shape)
    shares = np.where(total > 0, sums / np.where(total > 0, total, 1), uniform)
    return np.concatenate([np.zeros((*shares.shape[:-1], 1)), shares], axis=-1)


def _at_most(radiance: NDArray[np.float64], columns: int) -> NDArray[np.float64]:
    """Means over equal groups of texels, so that there are at most so many columns."""
    step = -(-radiance.shape[1] // columns)
    if step == 1:
        return radiance
    for axis in (0, 1):
        pad = -radiance.shape[axis] % step
        widths = [(0, pad) if a == axis else (0, 0) for a in range(3)]
        radiance = np.pad(radiance, widths, mode="edge")
    rows, width = radiance.shape[0] // step, radiance.shape[1] // step
    return radiance.reshape(rows, step, width, step, 3).mean(axis=(1, 3))


# ------------------------------------------------------------------------------------------------ scene words
# One buffer of words for what belongs to a scene: hierarchy, meshes, albedo maps, environment, lights.
#
# Shaders bind few buffers; see `layout.BUFFERS`.


# Rays leave surfaces by so much of the scene's extent: coordinates in float32 are rounded by 6e-8 of it.
RAY_OFFSET = 2e-6
# Meshes that are thinner, relative to their extent, are flat.
FLAT = 1e-7


class SceneWords:
    """The words of a scene, and where its parts begin.

    Attributes:
        is_flat: no face can hide another from a light.
    """

    def __init__(
        self,
        positions: NDArray[np.float64],
        vertices: NDArray[np.void],
        faces: NDArray[np.uint32],
        fabrics: NDArray[np.uint32],
        albedos: Sequence[NDArray[np.floating] | None],
    ) -> None:
        """
        Args:
            positions: of all vertices [n, 3], metres.
            vertices: their records [n].
            faces: of all meshes [m, 3].
            fabrics: the number of the fabric of each face [m].
            albedos: the map of each cloth.
        """
        hierarchy = build_hierarchy(positions, faces)
        self._leaves = hierarchy.leaves
        parts = [hierarchy.boxes.ravel().view(np.uint32), hierarchy.leaf_faces.ravel()]
        parts += [faces.ravel(), fabrics, vertices.view(np.uint32)]
        begins = np.cumsum([part.size for part in parts])
        self._begins = dict(zip(("leaf_faces", "corners", "face_fabrics", "vertices"), begins, strict=False))
        first = int(begins[-1])
        self._maps: list[tuple[int, int]] = []
        for albedo in albedos:
            words, levels = (np.zeros(0, np.uint32), 0) if albedo is None else map_words(albedo)
            self._maps.append((first, levels))
            parts.append(words)
            first += words.size
        self._words = np.concatenate(parts)
        self._environment: EnvironmentTables | None = None
        self._buffer: Any = None
        self._first_light = 0
        centred = positions - positions.mean(axis=0)
        extents = np.sqrt(np.maximum(np.linalg.eigvalsh(centred.T @ centred), 0))
        self.is_flat = bool(extents[0] <= FLAT * extents[2])
        largest = float(np.abs(positions).max(initial=0.0))
        self._ray_offset = RAY_OFFSET * max(largest, float(np.ptp(positions, axis=0).max()))

    def describe(self, frame: NDArray[np.void]) -> None:
        """Writes into the record of a frame where the parts begin."""
        frame["leaves"] = self._leaves
        for name, begin in self._begins.items():
            frame[name] = begin
        frame["ray_offset"] = self._ray_offset
        frame["environment_table"] = self._words.size
        frame["light_records"] = self._first_light

    def describe_maps(self, fabrics: NDArray[np.void]) -> None:
        """Writes into the records of fabrics where their albedo maps begin."""
        for record, (first, levels) in zip(fabrics, self._maps, strict=True):
            record["albedo_map"], record["albedo_map_levels"] = first, levels

    def show(self, adapter: Adapter, environment: EnvironmentTables | None, lights: NDArray[np.void]) -> Any:
        """The buffer with this environment and these lights, by which frames are to be described then.

        Where it holds the environment already, or none is asked for, lights alone are written.
        """
        records = lights.view(np.uint32)
        is_held = self._buffer is not None and (environment is None or environment is self._environment)
        if is_held and self._buffer.size >= 4 * (self._first_light + records.size):
            adapter.write(self._buffer, records, 4 * self._first_light)
            return self._buffer
        self._environment = environment
        words = self._words if environment is None else np.concatenate([self._words, environment.words()])
        self._first_light = words.size
        self._buffer = adapter.storage(np.concatenate([words, records]))
        return self._buffer
