"""Garments without uv for tests and figures, in metres: skirt, trousers, hood, cushion, ball and a scan."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from loomlight.mesh.cloth_mesh import ClothMesh, MeshPart, cleaned

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]


def as_part(positions: Floats, triangles: Indices, name: str) -> MeshPart:
    """A part without uv and without a name; `name` is that of its file."""
    mesh = ClothMesh(positions, np.zeros((0, 3)), np.zeros((0, 2)), triangles, name)
    return MeshPart("", "", cleaned(mesh))


def skirt(triangles: int = 4000) -> MeshPart:
    """A flared skirt in eight waves, open at waist and hem; its front is outside."""
    rows, columns = _grid_of(triangles, 0.28)
    t, angle = _ring(rows, columns)
    radius = 0.13 + 0.25 * t**1.2 + 0.025 * t * np.cos(8 * angle)
    places = np.stack([radius * np.sin(angle), 0.65 * (1 - t), 0.85 * radius * np.cos(angle)], axis=2)
    return as_part(places.reshape(-1, 3), _tube(rows, columns), "skirt")


def trousers(triangles: int = 4000) -> MeshPart:
    """Trousers: a pelvis that parts into two legs, open at waist and ankles."""
    rows, columns = _grid_of(triangles, 1.0)
    columns += -columns % 4
    upper = rows // 4
    t, angle = _ring(upper, columns)
    # The ring narrows to a figure of eight, whose middle is the crotch.
    pinch = 1 - t**2 * np.exp(-((np.sin(angle) / 0.45) ** 2))
    x, z = (0.17 + 0.02 * t) * np.sin(angle), 0.12 * np.cos(angle) * pinch
    pelvis = np.stack([x, 1.0 - 0.25 * t, z], axis=2).reshape(-1, 3)
    made, faces = [pelvis], [_tube(upper, columns)]
    front, back = upper * columns, upper * columns + columns // 2
    pelvis[back] = pelvis[front]
    count = len(pelvis)
    for side in (0, 1):
        half = upper * columns + (side * columns // 2 + np.arange(columns // 2)) % columns
        lower = rows - upper
        top = pelvis[half]
        t = np.linspace(0, 1, lower + 1)[1:, None, None]
        middle = top.mean(axis=0)
        narrow = 1 - 0.45 * t
        leg = middle + (top - middle) * narrow
        leg[..., 1] = top[:, 1] - 0.72 * t[..., 0]
        leg[..., 0] += (0.02 if middle[0] > 0 else -0.02) * t[..., 0]
        ids = np.concatenate([half[None], count + np.arange(lower * len(half)).reshape(lower, -1)])
        faces.append(_between(ids))
        made.append(leg.reshape(-1, 3))
        count += lower * len(half)
    triangles_made = np.concatenate(faces)
    triangles_made[triangles_made == back] = front
    return as_part(np.concatenate(made), triangles_made, "trousers")


def hood(triangles: int = 4000) -> MeshPart:
    """A hood: the back of an ellipsoid, open at face and neck."""
    rows, columns = _grid_of(1.4 * triangles, 0.8)
    t, angle = _ring(rows, columns)
    polar = 0.02 + 1.95 * t
    places = np.stack(
        [0.13 * np.sin(polar) * np.sin(angle), 0.17 * np.sin(polar) * np.cos(angle), -0.15 * np.cos(polar)],
        axis=2,
    ).reshape(-1, 3)
    faces = _tube(rows, columns)
    kept = places[faces][..., 1].max(axis=1) > -0.11
    return as_part(places, faces[kept], "hood")


def cushion(triangles: int = 4000) -> MeshPart:
    """A closed cushion that stands upright."""
    side = max(int(np.sqrt(triangles / 4)), 2)
    a, b = np.meshgrid(np.linspace(-1, 1, side + 1), np.linspace(-1, 1, side + 1), indexing="xy")
    high = 0.09 * np.sqrt(np.clip((1 - a**2) * (1 - b**2), 0, None)) ** 0.8
    front = np.stack([0.22 * a, 0.22 * b, high], axis=2).reshape(-1, 3)
    ids = np.arange((side + 1) ** 2).reshape(side + 1, side + 1)
    faces = _between(ids, closed=False)[:, ::-1]
    rim = (np.abs(np.stack([a, b], axis=2)).max(axis=2) > 1 - 1e-9).ravel()
    # Of corners, both sides would be one triangle.
    faces = faces[~rim[faces].all(axis=1)]
    behind = np.where(rim, np.arange(len(front)), len(front) + np.arange(len(front)))
    places = np.concatenate([front, front * [1, 1, -1]])
    return as_part(places, np.concatenate([faces, behind[faces][:, ::-1]]), "cushion")


def ball(triangles: int = 4000) -> MeshPart:
    """A closed ball of radius 0.1 m, which no piece of cloth fits."""
    rows, columns = _grid_of(triangles, 0.5)
    t, angle = _ring(rows, columns)
    polar = np.pi * t
    places = 0.1 * np.stack(
        [np.sin(polar) * np.sin(angle), np.cos(polar), np.sin(polar) * np.cos(angle)], axis=2
    )
    ids = np.arange((rows + 1) * columns).reshape(rows + 1, columns)
    ids[0], ids[-1] = ids[0, 0], ids[-1, 0]
    return as_part(places.reshape(-1, 3), _between(ids), "ball")


def scan(triangles: int = 4000) -> MeshPart:
    """A vest as a scanner gives it: noise of a millimetre, holes, and triangles that share no vertices."""
    rows, columns = _grid_of(triangles, 0.7)
    t, angle = _ring(rows, columns)
    waist = 1 - 0.18 * np.exp(-(((t - 0.5) / 0.25) ** 2))
    places = np.stack(
        [0.2 * waist * np.sin(angle), 0.6 * (1 - t), 0.13 * waist * np.cos(angle)], axis=2
    ).reshape(-1, 3)
    random = np.random.default_rng(7)
    places += random.normal(0, 1e-3, places.shape)
    faces = _tube(rows, columns)
    middles = places[faces].mean(axis=1)
    for centre in middles[random.integers(0, len(faces), 12)]:
        faces = faces[np.linalg.norm(places[faces].mean(axis=1) - centre, axis=1) > 0.02]
    return as_part(places[faces].reshape(-1, 3), np.arange(3 * len(faces)).reshape(-1, 3), "scan")


def refined(mesh: ClothMesh) -> ClothMesh:
    """Each triangle cut into four at the middles of its edges."""
    triangles, count = mesh.triangles, len(mesh.positions)
    ends = np.sort(np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    pairs, middle = np.unique(ends, axis=0, return_inverse=True)
    a, b, c = triangles.T
    ab, bc, ca = (count + middle.reshape(-1, 3)).T
    faces = [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
    positions = np.concatenate([mesh.positions, mesh.positions[pairs].mean(axis=1)])
    made = np.concatenate([np.stack(face, axis=1) for face in faces])
    return cleaned(ClothMesh(positions, np.zeros((0, 3)), np.zeros((0, 2)), made, mesh.name))


SHAPES: dict[str, Callable[[int], MeshPart]] = {
    "skirt": skirt,
    "trousers": trousers,
    "hood": hood,
    "cushion": cushion,
    "ball": ball,
    "scan": scan,
}


def _grid_of(triangles: float, ratio: float) -> tuple[int, int]:
    """Rows and columns of two triangles a cell, `ratio` rows for each column."""
    columns = max(int(np.sqrt(triangles / 2 / ratio)), 6)
    return max(int(columns * ratio), 3), columns


def _ring(rows: int, columns: int) -> tuple[Floats, Floats]:
    """Shares of the way down and angles of a ring, each [rows + 1, columns]."""
    t, angle = np.linspace(0, 1, rows + 1), 2 * np.pi * np.arange(columns) / columns
    down, around = np.meshgrid(t, angle, indexing="ij")
    return down, around


def _tube(rows: int, columns: int) -> Indices:
    return _between(np.arange((rows + 1) * columns).reshape(rows + 1, columns))


def _between(ids: Indices, closed: bool = True) -> Indices:
    """Triangles between rows of vertices, counter-clockwise from outside where rows go down and around +y."""
    right = np.roll(ids, -1, axis=1)
    a, b, c, d = ids[:-1], right[:-1], ids[1:], right[1:]
    if not closed:
        a, b, c, d = (each[:, :-1] for each in (a, b, c, d))
    faces = np.concatenate(
        [np.stack([a, c, b], axis=2).reshape(-1, 3), np.stack([b, c, d], axis=2).reshape(-1, 3)]
    )
    return faces[(faces != np.roll(faces, 1, axis=1)).all(axis=1)]
