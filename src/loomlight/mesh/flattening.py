"""Pieces of a surface laid flat: uv at true scale, as rigid as they can be, and how far they are stretched.

Gradients that keep lengths and follow the grain are integrated (Poisson), then uv are relaxed as rigidly as
possible (Liu 2008, "A local/global approach to mesh parameterization"), by conjugate gradients.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]
Indices = NDArray[np.int64]
Mask = NDArray[np.bool_]

# Height over its longest side of the thinnest triangle that is computed with; slivers would drown the others.
_MIN_HEIGHT = 0.03
# How often what is folded over is smoothed away, and relaxed once more.
_REPAIRS = 2


@dataclass(frozen=True, eq=False)
class FlatTriangles:
    """Triangles in planes of their own.

    Attributes:
        across, up: unit vectors in the plane of each [m, 3]; across × up is its normal.
        gradients: of the hat functions of corners, in these [m, 3, 2].
        areas: [m].
        corners: the vertices of uv [m, 3], numbered from 0.
    """

    across: Floats
    up: Floats
    gradients: Floats
    areas: Floats
    corners: Indices

    @classmethod
    def of(cls, places: Floats, corners: Indices) -> FlatTriangles:
        """Triangles with corners at `places` [m, 3, 3]."""
        # Their longest side lies along x.
        sides = np.linalg.norm(np.roll(places, -1, axis=1) - places, axis=2)
        first = sides.argmax(axis=1)
        turned = (first[:, None] + np.arange(3)) % 3
        a, b, c = np.moveaxis(np.take_along_axis(places, turned[..., None], axis=1), 1, 0)
        length = np.maximum(np.linalg.norm(b - a, axis=1), 1e-300)
        x = (b - a) / length[:, None]
        normal = np.cross(b - a, c - a)
        normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
        y = np.cross(normal, x)
        cx, cy = np.sum((c - a) * x, axis=1), np.sum((c - a) * y, axis=1)
        cy = np.maximum(cy, _MIN_HEIGHT * length)
        zero = np.zeros_like(cx)
        # Of a = (0, 0), b = (length, 0), c = (cx, cy).
        made = np.stack([-cy, cx - length, cy, -cx, zero, length], axis=1).reshape(-1, 3, 2)
        made /= (length * cy)[:, None, None]
        gradients = np.empty_like(made)
        np.put_along_axis(gradients, turned[..., None], made, axis=1)
        return cls(x, y, gradients, length * cy / 2, corners)

    def some(self, chosen: Mask) -> tuple[FlatTriangles, Indices]:
        """Some of them, and which of the vertices theirs are."""
        used, corner = np.unique(self.corners[chosen], return_inverse=True)
        across, up, gradients, areas = self.across, self.up, self.gradients, self.areas
        made = across[chosen], up[chosen], gradients[chosen], areas[chosen], corner.reshape(-1, 3)
        return FlatTriangles(*made), used

    def jacobian(self, uv: Floats) -> Floats:
        """Derivatives of u and of v along `across` and `up` [m, 2, 2]."""
        return np.einsum("mck,mcj->mkj", uv[self.corners], self.gradients)

    def along(self, directions: Floats) -> Floats:
        """Directions in space [m, 3], in their planes [m, 2]."""
        return np.stack([np.sum(directions * self.across, axis=1), np.sum(directions * self.up, axis=1)], 1)


@dataclass(frozen=True, eq=False)
class _Stiffness:
    """The matrix of a Laplacian in rows, and its diagonal."""

    first: Indices
    column: Indices
    value: Floats
    diagonal: Floats

    @classmethod
    def of(cls, flat: FlatTriangles) -> _Stiffness:
        local = np.einsum("mik,mjk->mij", flat.gradients, flat.gradients) * flat.areas[:, None, None]
        count = int(flat.corners.max()) + 1
        row = np.repeat(flat.corners, 3, axis=1).ravel()
        column = np.tile(flat.corners, (1, 3)).ravel()
        key = row * count + column
        order = np.argsort(key, kind="stable")
        key = key[order]
        starts = np.flatnonzero(np.append(True, key[1:] != key[:-1]))
        value = np.add.reduceat(local.ravel()[order], starts)
        row, column = np.divmod(key[starts], count)
        first = np.flatnonzero(np.append(True, row[1:] != row[:-1]))
        return cls(first, column, value, value[row == column])

    def __matmul__(self, x: Complexes) -> Complexes:
        made: Complexes = np.add.reduceat(self.value * x[self.column], self.first)
        return made

    def solve(self, right: Complexes, start: Complexes, steps: int, tolerance: float) -> Complexes:
        """x for `right`, from `start` on, by conjugate gradients, real and imaginary parts at once."""
        scale = 1 / np.maximum(self.diagonal, 1e-300)
        x, rest = start, right - self @ start
        goal = tolerance**2 * _power(right, right)
        direction = scale * rest
        power = _power(rest, direction)
        for _ in range(steps):
            image = self @ direction
            reach = power / _power(direction, image)
            x, rest = x + reach * direction, rest - reach * image
            if _power(rest, rest) <= goal:
                break
            step = scale * rest
            power, before = _power(rest, step), power
            direction = step + power / before * direction
        return x


def _power(a: Complexes, b: Complexes) -> float:
    return max(float(np.vdot(a, b).real), 1e-300)


def flattened(
    flat: FlatTriangles,
    grain: Floats,
    start: Floats | None = None,
    rounds: int = 30,
    tolerance: float = 1e-4,
    steps: int = 400,
) -> Floats:
    """uv [n, 2] of triangles, u to the right and v up as the front is seen, in the unit of their places.

    Args:
        grain: the direction of each triangle that should lie along v, in space [m, 3].
        start: uv to go on from, in place of those that follow the grain.
        rounds: of relaxing, at most.
        tolerance, steps: of the conjugate gradients of each.
    """
    matrix = _Stiffness.of(flat)
    count = int(flat.corners.max()) + 1

    def integrated(rotation: Floats, uv: Floats, steps: int, tolerance: float) -> Floats:
        """uv whose gradients are nearest to `rotation` [m, 2, 2]."""
        pulls = np.einsum("mkj,mcj->mck", rotation, flat.gradients) * flat.areas[:, None, None]
        u, v = (np.bincount(flat.corners.ravel(), pulls[..., axis].ravel(), count) for axis in (0, 1))
        found = matrix.solve(u + 1j * v, uv[:, 0] + 1j * uv[:, 1], steps, tolerance)
        return np.stack([found.real, found.imag], axis=1)

    if start is None:
        v = flat.along(grain)
        length = np.linalg.norm(v, axis=1, keepdims=True)
        v = np.where(length > 1e-9, v / np.maximum(length, 1e-300), [0.0, 1.0])
        aligned = np.stack([np.stack([v[:, 1], -v[:, 0]], axis=1), v], axis=1)
        uv = integrated(aligned, np.zeros((count, 2)), 2000, tolerance / 4)
    else:
        uv = start
    for _ in range(_REPAIRS + 1):
        for _ in range(rounds):
            before = uv
            uv = integrated(_rotations(flat.jacobian(uv)), uv, steps, tolerance)
            moved = np.abs(uv - before).max() / max(float(np.ptp(uv, axis=0).max()), 1e-300)
            if moved < 3e-4:
                break
        folded = np.linalg.det(flat.jacobian(uv)) <= 0
        if not folded.any():
            break
        uv, rounds = unfolded(flat, uv), 4
    return uv


def _rotations(jacobian: Floats) -> Floats:
    """The rotation nearest to each."""
    cosine, sine = jacobian[:, 0, 0] + jacobian[:, 1, 1], jacobian[:, 1, 0] - jacobian[:, 0, 1]
    length = np.maximum(np.hypot(cosine, sine), 1e-300)
    cosine, sine = np.where(length > 1e-290, cosine / length, 1.0), sine / length
    return np.stack([cosine, -sine, sine, cosine], axis=1).reshape(-1, 2, 2)


def stretches(jacobian: Floats) -> Floats:
    """The factor by which each triangle is longer or shorter somewhere than it is flat, at least 1.

    Infinite where it is folded over.
    """
    a, b, c, d = jacobian.reshape(-1, 4).T
    larger, smaller = np.hypot(a + d, c - b), np.hypot(a - d, b + c)
    most, least = (larger + smaller) / 2, (larger - smaller) / 2
    with np.errstate(divide="ignore"):
        return np.where(least > 0, np.maximum(most, 1 / np.maximum(least, 1e-300)), np.inf)


def unfolded(flat: FlatTriangles, uv: Floats) -> Floats:
    """uv whose triangles that are folded over are smoothed away, as far as that goes."""
    for _ in range(40):
        folded = np.linalg.det(flat.jacobian(uv)) <= 0
        if not folded.any():
            break
        here = np.zeros(len(uv), bool)
        here[flat.corners[folded]] = True
        near = flat.corners[here[flat.corners].any(axis=1)]
        total, count = np.zeros_like(uv), np.zeros(len(uv))
        for one, other in ((0, 1), (1, 2), (2, 0), (1, 0), (2, 1), (0, 2)):
            np.add.at(total, near[:, one], uv[near[:, other]])
            np.add.at(count, near[:, one], 1)
        uv = np.where(here[:, None], 0.5 * uv + 0.5 * total / np.maximum(count, 1)[:, None], uv)
    return uv
