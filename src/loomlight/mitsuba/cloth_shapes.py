"""The pieces of cloth of the built-in scenes: metres, y up, uv to scale over the whole piece."""

from __future__ import annotations

from collections.abc import Callable
from importlib.resources import files

import numpy as np
from numpy.typing import NDArray

from loomlight.mesh.cloth_mesh import ClothMesh
from loomlight.mesh.reading import read_mesh

Placement = Callable[[NDArray[np.float64], NDArray[np.float64]], tuple[NDArray[np.float64], ...]]

FLAT_SIDE = 0.1
SPHERE_RADIUS = 0.1
# The cap reaches behind the sphere's outline, so that a camera over its pole sees cloth only.
SPHERE_CAP = np.radians(115.0)
CYLINDER_RADIUS = 0.04
CYLINDER_LENGTH = 0.12
# The ball under the draped cloth; tools/make_drape.py drapes over the same one.
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
    """A square of 0.6 m draped over a ball on the ground, made by tools/make_drape.py."""
    return read_mesh(str(files("loomlight.mitsuba").joinpath("data/drape.ply")))


def grid_surface(
    grid: int | tuple[int, int], place: Placement, name: str, stays_within: bool = False
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
