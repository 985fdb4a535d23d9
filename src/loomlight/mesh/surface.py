"""Triangles as a surface: which lie beside each other, what hangs together, distances along it, blurring."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]
Mask = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Surface:
    """Triangles that share vertices, with what is asked of them again and again.

    Attributes:
        positions: [n, 3].
        triangles: [m, 3].
        twins: of each edge of each triangle, 3 m, the same edge of the triangle beside it; -1 where there is
            none, where more than two meet, and where two face opposite sides.
        normals: unit normals of triangles [m, 3].
        areas: [m].
    """

    positions: Floats
    triangles: Indices
    twins: Indices
    normals: Floats
    areas: Floats

    @classmethod
    def of(cls, positions: Floats, triangles: Indices) -> Surface:
        """The surface of triangles that have an area."""
        a, b, c = (positions[triangles[:, corner]] for corner in range(3))
        cross = np.cross(b - a, c - a)
        length = np.maximum(np.linalg.norm(cross, axis=1), 1e-300)
        return cls(positions, triangles, twins_of(triangles), cross / length[:, None], length / 2)

    @property
    def beside(self) -> Indices:
        """The triangles beside each triangle [m, 3], or -1."""
        return np.where(self.twins >= 0, self.twins // 3, -1).reshape(-1, 3)

    @property
    def middles(self) -> Floats:
        """Middles of triangles [m, 3]."""
        return self.positions[self.triangles].mean(axis=1)

    def some(self, chosen: Mask) -> Surface:
        """Some of the triangles, with their vertices."""
        used, corner = np.unique(self.triangles[chosen], return_inverse=True)
        return Surface.of(self.positions[used], corner.reshape(-1, 3))


def twins_of(triangles: Indices) -> Indices:
    """`Surface.twins` of triangles."""
    start, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    low, high = np.minimum(start, end), np.maximum(start, end)
    key = low * (int(triangles.max(initial=0)) + 1) + high
    order = np.argsort(key, kind="stable")
    key = key[order]
    same = key[1:] == key[:-1]
    alone = np.append(True, ~same)
    ends = np.append(~same, True)
    (first,) = np.nonzero(alone[:-1] & same & ends[1:])
    one, other = order[first], order[first + 1]
    right = start[one] == end[other]
    twins = np.full(len(start), -1)
    twins[one[right]], twins[other[right]] = other[right], one[right]
    return twins


def together(count: int, a: Indices, b: Indices) -> Indices:
    """The set of each of `count` items, numbered from 0, where a[i] and b[i] are in one."""
    label = np.arange(count)
    while len(a):
        one, other = label[a], label[b]
        differ = one != other
        if not differ.any():
            break
        a, b, one, other = a[differ], b[differ], one[differ], other[differ]
        np.minimum.at(label, np.maximum(one, other), np.minimum(one, other))
        while not np.array_equal(jumped := label[label], label):
            label = jumped
    return np.unique(label, return_inverse=True)[1]


def corners_of(surface: Surface, kept: Mask) -> Indices:
    """Vertices [m, 3] of triangles that hang together across those edges alone, of 3 m, that are `kept`."""
    (edge,) = np.nonzero(kept & (surface.twins >= 0))
    twin = surface.twins[edge]
    after = np.where(edge % 3 == 2, edge - 2, edge + 1)
    twin_after = np.where(twin % 3 == 2, twin - 2, twin + 1)
    a, b = np.concatenate([edge, after]), np.concatenate([twin_after, twin])
    return together(surface.triangles.size, a, b).reshape(-1, 3)


def across(surface: Surface, label: Indices) -> Mask:
    """Of 3 m edges those that have triangles of one label on both sides."""
    mine = np.repeat(label, 3)
    return (surface.twins >= 0) & (mine == mine[surface.twins])


def pieces_of(surface: Surface, label: Indices) -> Indices:
    """The connected set of triangles of one label that each is in [m], numbered from 0."""
    (edge,) = np.nonzero(across(surface, label))
    return together(len(label), edge // 3, surface.twins[edge] // 3)


def crease_conductance(surface: Surface) -> Floats:
    """How well each of 3 m edges lets labels through: 1 where flat, little where sharp, 0 at borders."""
    known = surface.twins >= 0
    cosine = np.sum(np.repeat(surface.normals, 3, axis=0) * surface.normals[surface.twins // 3], axis=1)
    # Sharp is what is bent by 40 to 70 degrees within an edge.
    soft = np.clip((cosine - 0.34) / (0.77 - 0.34), 0.03, 1)
    return np.where(known, soft, 0.0)


def blurred(surface: Surface, values: Floats, conductance: Floats, steps: int) -> Floats:
    """Numbers of triangles [m] or [m, k], blurred over those beside."""
    beside, share = surface.beside, conductance.reshape(-1, 3) * 0.25
    shape = (-1, *(1,) * (values.ndim - 1))
    for _ in range(steps):
        change = np.zeros_like(values)
        for edge in range(3):
            change += share[:, edge].reshape(shape) * (values[beside[:, edge]] - values)
        values = values + change
    return values


def distances(surface: Surface, sources: Indices) -> Floats:
    """Lengths of the shortest ways along edges from vertices `sources` to each [n]; infinite beyond reach."""
    start, end = surface.triangles.ravel(), np.roll(surface.triangles, -1, axis=1).ravel()
    a, b = np.concatenate([start, end]), np.concatenate([end, start])
    order = np.argsort(a, kind="stable")
    a, b = a[order], b[order]
    first = np.flatnonzero(np.append(True, a[1:] != a[:-1]))
    length = np.linalg.norm(surface.positions[a] - surface.positions[b], axis=1)
    found = np.full(len(surface.positions), np.inf)
    found[sources] = 0
    while True:
        nearer = np.minimum(found[a[first]], np.minimum.reduceat(found[b] + length, first))
        if np.array_equal(nearer, found[a[first]]):
            return found
        found[a[first]] = nearer
