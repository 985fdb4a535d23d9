"""Furnished and worn pieces of cloth, made of formulas: a couch with pillows and a blanket, a blouse, a gown.

Metres, y up, z towards the camera; uv to scale over the whole piece, as of `shapes.py`. They stand for the
scenes of papers whose own meshes are not public: what matters are curvature, folds, and layers.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from loomlight.mesh.cloth_mesh import ClothMesh, joined
from loomlight.mitsuba.shapes import grid_surface, grid_triangles

Values = NDArray[np.float64]
Point = tuple[float, float, float]

COUCH_WIDTH, COUCH_DEPTH, COUCH_HEIGHT = 1.7, 0.95, 0.82
_SEAT_HEIGHT, _LEGS, _ARM = 0.42, 0.08, 0.2
_BACK_DEPTH, _CUSHION, _ROUNDING = 0.24, 0.17, 0.045
_BLOUSE_HEIGHT = 0.6


def rounded_box(low: Point, high: Point, radius: float, grid: int = 33) -> ClothMesh:
    """A closed box with rounded edges; every face has its own uv, in metres."""
    lower, upper = np.array(low), np.array(high)
    faces = []
    for axis in range(3):
        for side in (0, 1):
            across, up = ((axis + 1) % 3, (axis + 2) % 3) if side else ((axis + 2) % 3, (axis + 1) % 3)
            # v runs along y where the face has it, so that the warp of sides hangs down.
            if across == 1:
                across, up, turned = up, across, True
            else:
                turned = False
            faces.append(_box_face(lower, upper, radius, grid, (axis, across, up), bool(side), turned))
    return joined(faces)


def _box_face(
    low: Values, high: Values, radius: float, grid: int, axes: tuple[int, int, int], far: bool, turned: bool
) -> ClothMesh:
    axis, across, up = axes
    # Vertices are denser where the edge is round.
    line = np.unique(
        np.concatenate([np.linspace(0, 1, grid), np.linspace(0, 0.1, 9), np.linspace(0.9, 1, 9)])
    )
    u, v = (part.ravel() for part in np.meshgrid(line, line))
    if turned:
        u = 1 - u
    flat = np.empty((u.size, 3))
    flat[:, across] = low[across] + u * (high[across] - low[across])
    flat[:, up] = low[up] + v * (high[up] - low[up])
    flat[:, axis] = (high if far else low)[axis]
    core = np.clip(flat, low + radius, high - radius)
    outwards = flat - core
    normals = outwards / np.linalg.norm(outwards, axis=1, keepdims=True)
    uv = np.stack([flat[:, across], flat[:, up]], axis=1)
    return ClothMesh(core + radius * normals, normals, uv, grid_triangles(line.size, line.size), "box")


def couch() -> ClothMesh:
    """Seat, two cushions, back and arms."""
    half, arm = COUCH_WIDTH / 2, _ARM
    front, rear = COUCH_DEPTH / 2, -COUCH_DEPTH / 2
    base = _SEAT_HEIGHT - _CUSHION
    parts = [
        rounded_box((arm - half, _LEGS, rear), (half - arm, base, front - 0.02), 0.02),
        rounded_box((-half, _LEGS, rear), (arm - half, 0.6, front), _ROUNDING),
        rounded_box((half - arm, _LEGS, rear), (half, 0.6, front), _ROUNDING),
        rounded_box((arm - half, base, rear), (half - arm, COUCH_HEIGHT, rear + _BACK_DEPTH), _ROUNDING),
    ]
    for left in (arm - half, 0.0):
        right = left + half - arm
        parts.append(rounded_box((left, base, rear + _BACK_DEPTH), (right, _SEAT_HEIGHT, front), _ROUNDING))
    return _named(joined(parts), "couch")


def pillow(
    centre: Point, side: float = 0.42, turn_degrees: float = 0.0, lean_degrees: float = 18.0
) -> ClothMesh:
    """A puffed square pillow that leans backwards, turned about the vertical; its front and its back."""
    thickness = 0.15

    def half(sign: float) -> ClothMesh:
        def place(u: Values, v: Values) -> tuple[Values, ...]:
            x, y = sign * (2 * u - 1), 2 * v - 1
            # Between the corners the seams are drawn in; a seam is where both sheets meet.
            drawn_in = 1 - 0.07 * (1 - (x * y) ** 2)
            puff = np.maximum((1 - x**4) * (1 - y**4), 0) ** 0.6
            return side / 2 * x * drawn_in, side / 2 * y * drawn_in, sign * thickness / 2 * puff

        return grid_surface(97, place, "pillow", stays_within=True)

    lean, turn = np.radians([-lean_degrees, turn_degrees])
    about_x = np.array([[1, 0, 0], [0, np.cos(lean), -np.sin(lean)], [0, np.sin(lean), np.cos(lean)]])
    about_y = np.array([[np.cos(turn), 0, np.sin(turn)], [0, 1, 0], [-np.sin(turn), 0, np.cos(turn)]])
    return _moved(joined([half(1.0), half(-1.0)]), about_y @ about_x, np.array(centre), "pillow")


def blanket() -> ClothMesh:
    """A strip of 0.55 m thrown over back, seat and front edge of the couch, with folds along it."""
    rear, front = -COUCH_DEPTH / 2, COUCH_DEPTH / 2
    back = rear + _BACK_DEPTH
    off = 0.012
    corners = np.array(
        [
            (rear - off, 0.45),
            (rear - off, COUCH_HEIGHT + off),
            (back + off, COUCH_HEIGHT + off),
            (back + off, _SEAT_HEIGHT + off),
            (front + off, _SEAT_HEIGHT + off),
            (front + off, 0.17),
        ]
    )
    path = _rounded_path(corners, 0.05)
    length = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))])
    tangent = np.gradient(path, length, axis=0)
    normal = np.stack([tangent[:, 1], -tangent[:, 0]], axis=1) * -1
    width, middle = 0.55, 0.32

    def place(u: Values, v: Values) -> tuple[Values, ...]:
        at = v * length[-1]
        z, y = (np.interp(at, length, path[:, k]) for k in (0, 1))
        nz, ny = (np.interp(at, length, normal[:, k]) for k in (0, 1))
        wave = np.sin(2 * np.pi * (3.2 * u + 0.25 * np.sin(4 * v))) + 0.5 * np.sin(
            2 * np.pi * (5.3 * u - 0.7 * v)
        )
        raised = 0.012 * (1 + 0.66 * wave)
        lean = 0.05 * np.sin(2.2 * v + 0.4)
        return middle + width * (u - 0.5) + lean, y + raised * ny, z + raised * nz

    return grid_surface(257, place, "blanket", stays_within=True)


def _rounded_path(corners: Values, radius: float) -> Values:
    """A polyline through corners, each replaced by a quadratic arc that begins `radius` before it."""
    points = [corners[:1]]
    steps = np.linspace(0, 1, 24)[:, None]
    for before, corner, after in zip(corners, corners[1:], corners[2:], strict=False):
        start = corner + radius * (before - corner) / np.linalg.norm(before - corner)
        end = corner + radius * (after - corner) / np.linalg.norm(after - corner)
        points.append((1 - steps) ** 2 * start + 2 * steps * (1 - steps) * corner + steps**2 * end)
    points.append(corners[-1:])
    return np.concatenate(points)


def blouse_body() -> ClothMesh:
    """A loose body with folds that grow from the shoulders to the hem; u around, v up."""
    heights = np.array([0.0, 0.2, 0.36, 0.42, 0.46, 0.5, 0.54, 0.57, 0.59, 0.6])
    widths = np.array([0.235, 0.215, 0.225, 0.224, 0.219, 0.207, 0.183, 0.142, 0.102, 0.085])
    depths = np.array([0.15, 0.128, 0.138, 0.136, 0.131, 0.121, 0.107, 0.094, 0.084, 0.08])

    def place(u: Values, v: Values) -> tuple[Values, ...]:
        y = v * _BLOUSE_HEIGHT
        around = 2 * np.pi * (u - 0.5)
        falling = np.clip(1 - v / 0.85, 0, 1) ** 2
        fold = 1 + falling * (
            0.055 * np.sin(9 * around + 1.5 * np.sin(5 * v)) + 0.03 * np.sin(14 * around + 2 * v)
        )
        width, depth = (_smooth(y, heights, radii) * fold for radii in (widths, depths))
        return width * np.sin(around), y, depth * np.cos(around)

    return grid_surface(385, place, "blouse", stays_within=True)


def blouse_sleeves() -> ClothMesh:
    """Both sleeves, wide at the cuffs and wrinkled at the elbows; u around, v along."""

    def sleeve(sign: float) -> ClothMesh:
        def place(u: Values, v: Values) -> tuple[Values, ...]:
            around = 2 * np.pi * u * sign
            x = 0.155 + 0.16 * v + 0.02 * np.sin(np.pi * v)
            y = 0.525 - 0.38 * v
            radius = 0.062 + 0.022 * np.sin(np.pi * np.clip(1.3 * v - 0.25, 0, 1)) + 0.018 * v
            wrinkle = 0.09 * np.sin(np.pi * v) * np.sin(44 * v + 2.5 * np.cos(around) + around)
            radius = radius * (1 + wrinkle + 0.05 * v * np.sin(7 * around))
            # Across the axis of the sleeve, which runs outwards and down.
            return (
                sign * (x + radius * 0.9 * np.cos(around)),
                y + radius * 0.42 * np.cos(around),
                radius * np.sin(around),
            )

        return grid_surface(193, place, "sleeve", stays_within=True)

    return _named(joined([sleeve(1.0), sleeve(-1.0)]), "sleeves")


def gown() -> ClothMesh:
    """A gown from bust to hem, fitted to the waist and flared below, with deep folds; u around, v up."""
    return _skirted(
        np.array([0.0, 0.5, 0.85, 0.98, 1.12, 1.24, 1.32]),
        np.array([0.4, 0.26, 0.155, 0.118, 0.135, 0.155, 0.15]),
        folds=11,
        depth=0.17,
        name="gown",
    )


def overskirt() -> ClothMesh:
    """A second layer from the waist to above the hem, wider than `gown`, with folds of its own."""
    return _skirted(
        np.array([0.16, 0.5, 0.8, 0.95, 1.0]),
        np.array([0.48, 0.335, 0.205, 0.142, 0.128]),
        folds=8,
        depth=0.15,
        name="overskirt",
    )


def _skirted(heights: Values, radii: Values, folds: int, depth: float, name: str) -> ClothMesh:
    low, high = heights[0], heights[-1]

    def place(u: Values, v: Values) -> tuple[Values, ...]:
        y = low + v * (high - low)
        around = 2 * np.pi * (u - 0.5)
        falling = np.clip((0.97 - y) / 0.97, 0, 1) ** 1.1
        phase = folds * around + 0.8 * np.sin(2 * around + 1.0) + 0.9 * y
        fold = 1 + depth * falling * (np.sin(phase) + 0.25 * np.sin(2 * phase + 0.5))
        radius = _smooth(y, heights, radii) * fold
        return radius * np.sin(around), y, 0.82 * radius * np.cos(around)

    return grid_surface(449, place, name, stays_within=True)


def _smooth(y: Values, heights: Values, values: Values) -> Values:
    """Monotone cubic interpolation (Fritsch and Carlson), constant beyond the ends."""
    from scipy.interpolate import PchipInterpolator

    found: Values = PchipInterpolator(heights, values)(np.clip(y, heights[0], heights[-1]))
    return found


def _moved(mesh: ClothMesh, turn: Values, by: Values, name: str) -> ClothMesh:
    return ClothMesh(mesh.positions @ turn.T + by, mesh.normals @ turn.T, mesh.uv, mesh.triangles, name)


def _named(mesh: ClothMesh, name: str) -> ClothMesh:
    return ClothMesh(mesh.positions, mesh.normals, mesh.uv, mesh.triangles, name)
