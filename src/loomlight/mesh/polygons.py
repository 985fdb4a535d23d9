"""Faces of any number of corners, cut into triangles."""

from __future__ import annotations

import mapbox_earcut
import numpy as np
from numpy.typing import NDArray


def triangulate(
    positions: NDArray[np.float64], corners: NDArray[np.int64], counts: NDArray[np.int64]
) -> NDArray[np.int64]:
    """Triangles [m, 3] as indices into `corners`; faces of fewer than three corners have none.

    A face is cut into a fan from its first corner, a quadrilateral from the second where that suits its shape
    better, and other concave faces by ear clipping.

    Args:
        positions: [n, 3].
        corners: vertices of all faces, one face after the other.
        counts: corners of each face.
    """
    starts = np.cumsum(counts) - counts
    pieces = [starts[counts == 3, None] + np.arange(3)]
    for count in np.unique(counts[counts > 3]):
        first = starts[counts == count]
        fan = np.stack([np.zeros(count - 2, int), np.arange(1, count - 1), np.arange(2, count)], axis=1)
        quality = _worst_area(positions, corners, first, fan)
        if count == 4:
            other = (fan + 1) % 4
            turn = quality < np.minimum(0, _worst_area(positions, corners, first, other))
            pieces.append((first[:, None, None] + np.where(turn[:, None, None], other, fan)).reshape(-1, 3))
            continue
        convex = ~(quality < 0)  # of numbers that are none too, which the caller refuses
        pieces.append((first[convex, None, None] + fan).reshape(-1, 3))
        pieces += [
            start + _ears(positions[corners[start : start + count]]) for start in first[~convex].tolist()
        ]
    return np.concatenate(pieces)


def strip_triangles(strip: NDArray[np.int64]) -> NDArray[np.int64]:
    """The triangles [m, 3] of a strip of vertices, every other one turned over."""
    rows = np.stack([strip[:-2], strip[1:-1], strip[2:]], axis=1) if len(strip) > 2 else np.zeros((0, 3), int)
    rows[1::2] = rows[1::2, ::-1]
    return rows


def _worst_area(
    positions: NDArray[np.float64],
    corners: NDArray[np.int64],
    first: NDArray[np.int64],
    cut: NDArray[np.int64],
) -> NDArray[np.float64]:
    """The smallest area of the triangles `cut` of each face, negative where they face away from it."""
    a, b, c = (positions[corners[first[:, None] + cut[:, corner]]] for corner in range(3))
    areas = np.cross(b - a, c - a)
    total = areas.sum(axis=1, keepdims=True)
    length = np.maximum(np.linalg.norm(total, axis=2), 1e-300)
    worst = np.min(np.sum(areas * total, axis=2) / length, axis=1)
    # Rounding makes the areas of straight corners a little negative.
    return np.where(worst > -1e-9 * length[:, 0], np.maximum(worst, 0), worst)


def _ears(ring: NDArray[np.float64]) -> NDArray[np.int64]:
    """Triangles of a polygon, seen along its area vector."""
    middle = ring - ring.mean(axis=0)
    area = np.cross(middle, np.roll(middle, -1, axis=0)).sum(axis=0)
    drop = int(np.abs(area).argmax())
    flat = np.delete(middle, drop, axis=1)
    made = mapbox_earcut.triangulate_float64(flat, np.array([len(ring)], np.uint32)).reshape(-1, 3)
    triangles = made.astype(np.int64)
    a, b, c = (middle[triangles[:, corner]] for corner in range(3))
    away = np.sum(np.cross(b - a, c - a) * area, axis=1) < 0
    triangles[away] = triangles[away][:, ::-1]
    return triangles
