"""Shapes of the built-in scenes: pieces of cloth, and the paper and the ball that stand beside them.

Metres, y up; uv of cloth are to scale over the whole piece.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib.resources import files
from typing import Any

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.studio import PAPER
from loomlight.mesh.cloth_mesh import ClothMesh
from loomlight.mesh.reading import read_mesh
from loomlight.mitsuba.meshes import to_shape

SurfaceMap = Callable[[NDArray[np.float64], NDArray[np.float64]], tuple[NDArray[np.float64], ...]]

FLAT_SIDE = 0.1
SPHERE_RADIUS = 0.1
# The cap reaches behind the sphere's outline, so that a camera over its pole sees cloth only.
SPHERE_CAP = np.radians(115.0)
CYLINDER_RADIUS = 0.04
CYLINDER_LENGTH = 0.12
# The ball under the draped cloth; tools/generate/drape.py drapes over the same one.
DRAPE_BALL_RADIUS = 0.115


def flat() -> ClothMesh:
    """A square of 0.1 m in the plane z = 0, facing +z; u to the right, v up."""
    return grid_surface(2, lambda u, v: (FLAT_SIDE * (u - 0.5), FLAT_SIDE * (v - 0.5), 0 * u), "flat")


def sphere() -> ClothMesh:
    """A round piece of cloth over a ball of radius 0.1 m, its middle at (0, 0, 0.1).

    Radii are kept and circles about the middle are gathered, as draped cloth does; u to the right, v up.
    uv spans a square of side 2·radius·115° of arc, of which the piece is the inscribed disc.
    """
    reach = SPHERE_RADIUS * SPHERE_CAP

    def on_ball(u: NDArray[np.float64], v: NDArray[np.float64]) -> tuple[NDArray[np.float64], ...]:
        x, y = reach * (2 * u - 1), reach * (2 * v - 1)
        angle = np.hypot(x, y) / SPHERE_RADIUS
        ratio = np.sinc(angle / np.pi)  # sin θ / θ
        return x * ratio, y * ratio, SPHERE_RADIUS * np.cos(angle)

    square = grid_surface(257, on_ball, "sphere")
    centre = square.uv[square.triangles].mean(axis=1)
    inside = np.hypot(*(2 * centre - 1).T) <= 1
    return ClothMesh(square.positions, square.normals, square.uv, square.triangles[inside], square.name)


def cylinder() -> ClothMesh:
    """Cloth around a cylinder of radius 0.04 m and length 0.12 m about the x axis; u along it, v around."""

    def around(u: NDArray[np.float64], v: NDArray[np.float64]) -> tuple[NDArray[np.float64], ...]:
        # The seam lies behind, away from +z.
        angle = 2 * np.pi * (v - 0.5)
        along = CYLINDER_LENGTH * (u - 0.5)
        return along, CYLINDER_RADIUS * np.sin(angle), CYLINDER_RADIUS * np.cos(angle)

    return grid_surface(513, around, "cylinder")


def drape() -> ClothMesh:
    """A square of 0.6 m draped over a ball on the ground, made by tools/generate/drape.py."""
    return read_mesh(str(files("loomlight.mitsuba").joinpath("data/drape.ply")))


def grid_surface(
    grid: int | tuple[int, int], place: SurfaceMap, name: str, stays_within: bool = False
) -> ClothMesh:
    """A grid of vertices over the unit uv square; `place(u, v)` gives x, y, z.

    Args:
        grid: vertices along u and along v; one number for both.
        stays_within: the place is asked within the unit square alone, also for the normals.
    """
    columns, rows = grid if isinstance(grid, tuple) else (grid, grid)
    lines = np.linspace(0, 1, columns), np.linspace(0, 1, rows)
    u, v = (coordinate.ravel() for coordinate in np.meshgrid(*lines))
    step = 1e-5

    def at(du: float, dv: float) -> NDArray[np.float64]:
        across, along = u + du, v + dv
        if stays_within:
            across, along = np.clip(across, 0, 1), np.clip(along, 0, 1)
        return np.stack(place(across, along), axis=-1)

    normals = np.cross(at(step, 0) - at(-step, 0), at(0, step) - at(0, -step))
    return ClothMesh(
        positions=at(0, 0),
        normals=normals / np.linalg.norm(normals, axis=1, keepdims=True),
        uv=np.stack([u, v], axis=1),
        triangles=grid_triangles(columns, rows),
        name=name,
    )


def grid_triangles(columns: int, rows: int) -> NDArray[np.int64]:
    """Vertex indices of a grid of vertices, row by row [2·(columns − 1)·(rows − 1), 3]."""
    corner = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    lower = np.stack([corner, corner + 1, corner + columns + 1], axis=1)
    upper = np.stack([corner, corner + columns + 1, corner + columns], axis=1)
    return np.concatenate([lower, upper])


# ------------------------------------------------------------------------------------------------ scene props
# Props of built-in scenes: paper below or behind it, and the ball under draped cloth.


# Light paper, as catalogues show cloth on.
_PAPER = {"type": "diffuse", "reflectance": {"type": "rgb", "value": PAPER}}


def ground(
    centre: NDArray[np.float64], radius: float, height: float, distance: float = 0.0
) -> dict[str, Any]:
    """A sheet of paper just below `height`, around an object of `radius`.

    It is 60 times as wide as the object or, if that is more, as the `distance` of the camera: rays that go
    down by 4 degrees meet it, with room for a turntable's camera, which stands farther away.
    """
    transform = mi.ScalarTransform4f().translate([centre[0], height - 1e-3 * radius, centre[2]])
    extent = 60 * max(radius, distance)
    return {"type": "disk", "to_world": transform.rotate([1, 0, 0], -90).scale(extent), "bsdf": _PAPER}


def backdrop(
    centre: NDArray[np.float64], radius: float, depth: float, distance: float = 0.0
) -> dict[str, Any]:
    """A sheet of paper at z = `depth` behind an object of `radius`, as wide as `ground`'s.

    It faces +z, or -z where it stands before the object, for cameras behind it.
    """
    transform = mi.ScalarTransform4f().translate([centre[0], centre[1], depth])
    if depth > 0:
        transform = transform.rotate([0, 1, 0], 180)
    return {"type": "disk", "to_world": transform.scale(60 * max(radius, distance)), "bsdf": _PAPER}


def ball(behind: float = 0.0) -> mi.Mesh:
    """The grey ball under the draped cloth, or unseen so many metres behind other cloth.

    Kernels depend on how many shapes and BSDFs there are, and of which classes: built-in scenes share theirs.
    """
    radius = DRAPE_BALL_RADIUS

    def place(u: NDArray[np.float64], v: NDArray[np.float64]) -> tuple[NDArray[np.float64], ...]:
        # At the very poles there would be no normals.
        around, polar = 2 * np.pi * u, np.pi * (1e-4 + (1 - 2e-4) * v)
        across = radius * np.sin(polar)
        return across * np.cos(around), radius * (1 + np.cos(polar)), across * np.sin(around) - behind

    grey: dict[str, object] = {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.32}}
    return to_shape(grid_surface((129, 65), place, "ball"), grey)
