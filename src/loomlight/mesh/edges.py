"""Edges of cloth: turned hems and pinked borders, as further triangles along the open edges of a mesh.

They are bound to the cloth, so that they follow it where it moves.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from loomlight.mesh.cloth_mesh import ClothMesh, cross_products, joined, metric

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]
# Distance of columns; of each row how far out it is in even and odd columns, how far up, its normal's angle.
_Shape = tuple[float, Floats]

EDGES = ("hem", "pinked", "raw")
# Of a hem, and of the teeth of pinking shears, metres.
_HEM_WIDTH, _TOOTH_WIDTH, _TOOTH_DEPTH = 6e-3, 3e-3, 1.6e-3
# Vertices nearer than that, metres, are one: pieces that are sewn together have no edge there.
_WELD = 5e-5
# How far a corner goes out, in widths, at most: a mitre up to 120 degrees.
_MAX_MITRE = 2.0
_MAX_COLUMNS = 100_000
# Across a piece of cloth: a smaller one has no edges.
_MIN_COLUMNS = 16
# Corners that lean by that much are sharp, which is a turn of 33 degrees; none are cut where there are more.
_LEAN, _MAX_PAIRS = 0.3, 10_000_000
# Triangles that a hem crosses below the cloth, at most.
_MAX_STEPS = 64


@dataclass(frozen=True, eq=False)
class Edges:
    """Edges of pieces of cloth, whichever way these move; see `of`."""

    _border: _Border
    _strips: list[_Strip | None]

    @classmethod
    def of(cls, pieces: list[ClothMesh], kind: str, thickness: list[float], scale: float) -> Edges:
        """Edges; where two pieces lie on each other they are sewn together and have none.

        A hem goes on around the edge, back below the cloth and up to it; a pinked edge goes on in teeth. uv
        run on as cloth does. Where they collapse, or where the whole is hardly wider than an edge, nothing is
        added.

        Args:
            pieces: metres.
            kind: of `EDGES`.
            thickness: of the cloth of each piece, metres; a hem is twice as thick.
            scale: of widths and thicknesses.
        """
        whole = joined(pieces)
        shape = _TOOTH_WIDTH * scale / 2, np.array([[0, 0, 0, 0], [0, _TOOTH_DEPTH * scale, 0, 0]])
        if kind == "raw" or np.ptp(whole.positions, axis=0).max() < _MIN_COLUMNS * shape[0]:
            nothing = np.zeros(0, np.int64)
            return cls(_Border(nothing, np.zeros((0, 2), np.int64)), [None] * len(pieces))
        ends = np.stack([whole.triangles, np.roll(whole.triangles, -1, axis=1)], axis=2).reshape(-1, 2)
        twin = _twins(ends)
        border = _Border.of(whole, ends, np.flatnonzero(twin < 0))
        mitre, whole = border.mitred(whole)
        owner = np.repeat(np.arange(len(pieces)), [len(piece.triangles) for piece in pieces])
        strips: list[_Strip | None] = []
        for number in range(len(pieces)):
            (mine,) = np.nonzero(owner[border.half // 3] == number)
            if kind == "hem":
                shape = _hem(thickness[number] * scale, _HEM_WIDTH * scale)
            strips.append(_Strip.of(whole, twin, border, mine, mitre, shape) if len(mine) else None)
        return cls(border, strips)

    def on(self, pieces: list[ClothMesh]) -> list[ClothMesh]:
        """The same pieces, wherever their vertices are now, with their edges."""
        if not any(self._strips):
            return pieces
        mitre, whole = self._border.mitred(joined(pieces))
        return [
            piece if strip is None else joined([piece, strip.on(whole, mitre)])
            for piece, strip in zip(pieces, self._strips, strict=True)
        ]


def _hem(radius: float, width: float) -> _Shape:
    """The shape of a hem."""
    inner = max(width - radius, radius)
    angle = np.concatenate([np.linspace(0, np.pi, 9), [np.pi] * 2, np.linspace(1, 1.9, 10) * np.pi])
    inward = np.concatenate([np.zeros(9), [inner / 3, inner * 2 / 3], np.full(10, inner)])
    across = radius * np.sin(angle) - inward
    return width / 2, np.stack([across, across, radius * (np.cos(angle) - 1), angle], axis=1)


def _twins(ends: Indices) -> Indices:
    """Of each half-edge, from one vertex to another [n, 2], another one between the same two, or -1."""
    low, high = ends.min(axis=1), ends.max(axis=1)
    key = low * (int(ends.max(initial=0)) + 1) + high
    order = np.argsort(key, kind="stable")
    (same,) = np.nonzero(key[order][1:] == key[order][:-1])
    twin = np.full(len(ends), -1)
    twin[order[same]], twin[order[same + 1]] = order[same + 1], order[same]
    return twin


@dataclass(frozen=True, eq=False)
class _Border:
    """Half-edges without a neighbour at their place.

    Attributes:
        half: numbers of half-edges [m].
        place: numbers of the places of their two ends [m, 2].
    """

    half: Indices
    place: Indices

    @classmethod
    def of(cls, mesh: ClothMesh, ends: Indices, alone: Indices) -> _Border:
        """Those of the half-edges `alone` that no other one lies on."""
        spots = np.round(mesh.positions[ends[alone].ravel()] / _WELD).astype(np.int64)
        place = np.unique(spots, axis=0, return_inverse=True)[1].reshape(-1, 2)
        area, _, _ = metric(mesh)
        is_open = (_twins(place) < 0) & np.isfinite(area[alone // 3])
        return cls(alone[is_open], place[is_open])

    def ends(self, mesh: ClothMesh) -> Indices:
        """Vertices of both ends [m, 2]."""
        corner = np.stack([self.half % 3, (self.half % 3 + 1) % 3], axis=1)
        return mesh.triangles[(self.half // 3)[:, None], corner]

    def mitred(self, mesh: ClothMesh) -> tuple[Floats, ClothMesh]:
        """Steps [m, 2, 3] a unit out from both ends; the mesh with one normal at each place of its border."""
        half, place, ends = self.half, self.place, self.ends(mesh)
        along = np.diff(mesh.positions[ends], axis=1)[:, 0]
        out = _unit(np.cross(along, cross_products(mesh)[half // 3]))
        # The sum of two unit vectors, over half its own square, is a unit away from both edges.
        total, normals, ways = (np.zeros((place.max(initial=0) + 1, size)) for size in (3, 3, 1))
        for end in range(2):
            np.add.at(total, place[:, end], out)
            np.add.at(normals, place[:, end], mesh.normals[ends[:, end]])
            np.add.at(ways, place[:, end], 1)
        length = np.maximum(np.linalg.norm(total, axis=1, keepdims=True), 1e-9)
        mitre = total / length * np.minimum(ways / length, _MAX_MITRE)
        smooth, up = mesh.normals.copy(), _unit(normals)
        smooth[ends] = up[place]
        mitre -= np.sum(mitre * up, axis=1, keepdims=True) * up
        return mitre[place], replace(mesh, normals=smooth)


@dataclass(frozen=True, eq=False)
class _Strip:
    """The triangles of an edge along half-edges, in columns across it.

    Attributes:
        mine: which half-edges of the border.
        ends: vertices of their ends [m, 2].
        edge: which half-edge each column is of [columns].
        share: how far along it both sides of the column are [columns, 2, 1].
        across, up, angle: how far out and up each vertex is, and its normal's angle [rows, columns, 2, 1].
        triangle, weights: below which point of the cloth, [rows, columns, 2] and [rows, columns, 2, 3].
        made: the strip on the cloth that it was made for; its uv, triangles and attributes stay.
    """

    mine: Indices
    ends: Indices
    edge: Indices
    share: Floats
    across: Floats
    up: Floats
    angle: Floats
    triangle: Indices
    weights: Floats
    made: ClothMesh

    @classmethod
    def of(
        cls, mesh: ClothMesh, twin: Indices, border: _Border, mine: Indices, mitre: Floats, shape: _Shape
    ) -> _Strip:
        """The strip along some half-edges, of columns as far apart as `shape` says, or less."""
        apart, rows = shape
        half, ends, mitre = border.half[mine], border.ends(mesh)[mine], mitre[mine]
        along = np.diff(mesh.positions[ends], axis=1)[:, 0]
        length = np.linalg.norm(along, axis=1)
        # An even number, so that teeth meet at both ends.
        count = 2 * np.ceil(length / max(2 * apart, 2 * length.sum() / _MAX_COLUMNS)).astype(np.int64)
        edge = np.repeat(np.arange(len(half)), count)
        step = np.arange(len(edge)) - np.repeat(np.cumsum(count) - count, count)
        share = (np.stack([step, step + 1], axis=1) / count[edge][:, None])[..., None]
        # Columns between corners would cross the mitres there: they end before, as far as corners lean.
        lean = np.sum(mitre * along[:, None], axis=2) / length[:, None] * [-1, 1]
        corners, lean = mesh.positions[ends][lean > _LEAN], lean[lean > _LEAN]
        foot = _between(mesh.positions[ends], edge, share)
        room = np.full(share.shape, np.inf)
        if len(corners) * len(foot) < _MAX_PAIRS:
            for place, slope in zip(corners, lean, strict=True):
                away = np.linalg.norm(foot - place, axis=2, keepdims=True)
                room = np.where(away > _WELD, np.minimum(room, away / slope), room)
        out, sideways = _outward(mesh.positions[ends], mitre, edge, share)
        to_uv = np.linalg.pinv(np.stack(metric(mesh)[1:], axis=2)[half // 3])[edge]
        uv = _between(mesh.uv[ends], edge, share)
        uv_out, uv_side = (np.einsum("nij,nkj->nki", to_uv, vectors) for vectors in (out, sideways))
        is_odd = np.stack([step % 2, (step + 1) % 2], axis=1)
        across = np.where(is_odd, rows[:, None, None, 1], rows[:, None, None, 0])[..., None]
        across = np.maximum(across, -room)
        up, angle = rows[:, 2, None, None, None], rows[:, 3, None, None, None]
        inside = uv + np.minimum(across, 0) * uv_out
        beside = np.broadcast_to((half // 3)[edge, None], inside.shape[:-1])
        triangle, weights = _below(mesh, twin, beside, inside)
        run = np.cumsum(np.hypot(np.diff(across, axis=0, prepend=0), np.diff(up, axis=0, prepend=0)), axis=0)
        uv = uv + run * (uv_out - uv_side) + across * uv_side
        size = 2 * len(edge)
        a = (np.arange(0, size, 2) + size * np.arange(len(rows) - 1)[:, None]).ravel()
        b, c, d = a + 1, a + size, a + size + 1
        triangles = np.concatenate([np.stack([b, a, c], axis=1), np.stack([b, c, d], axis=1)])
        attributes = {}
        for name, values in mesh.attributes.items():
            row = _between(values[ends], edge, share)
            attributes[name] = np.broadcast_to(row, (len(rows), *row.shape)).reshape(-1, row.shape[-1])
        nowhere = np.zeros((len(rows) * size, 3))
        made = ClothMesh(nowhere, nowhere, uv.reshape(-1, 2), triangles, mesh.name, attributes)
        return cls(mine, ends, edge, share, across, up, angle, triangle, weights, made)

    def on(self, mesh: ClothMesh, mitre: Floats) -> ClothMesh:
        """The strip on a mesh whose border is mitred so, wherever its vertices are."""
        out, _ = _outward(mesh.positions[self.ends], mitre[self.mine], self.edge, self.share)
        base, normal = (
            np.einsum("...k,...ki->...i", self.weights, values[mesh.triangles[self.triangle]])
            for values in (mesh.positions, mesh.normals)
        )
        normal = _unit(normal)
        position = base + np.maximum(self.across, 0) * out + self.up * normal
        normals = _unit(np.sin(self.angle) * _unit(out) + np.cos(self.angle) * normal)
        return replace(self.made, positions=position.reshape(-1, 3), normals=normals.reshape(-1, 3))


def _between(values: Floats, edge: Indices, share: Floats) -> Floats:
    """Of columns [columns, 2, …], of what edges have at their ends."""
    return values[edge, :1] * (1 - share) + values[edge, 1:] * share


def _outward(places: Floats, mitre: Floats, edge: Indices, share: Floats) -> tuple[Floats, Floats]:
    """Steps out of both sides of columns, square to the edge but at its ends; how far those go along it."""
    along = _unit(np.diff(places, axis=1)[:, 0])[edge][:, None]
    out, is_end = _between(mitre, edge, share), (share == 0) | (share == 1)
    sideways = np.sum(out * along, axis=2, keepdims=True) * along
    return np.where(is_end, out, out - sideways), np.where(is_end, sideways, 0)


def _below(mesh: ClothMesh, twin: Indices, triangle: Indices, uv: Floats) -> tuple[Indices, Floats]:
    """Triangles [n] of a mesh that hold `uv` [n, 2], walking there from `triangle` [n]; weights [n, 3]."""
    for _ in range(_MAX_STEPS):
        a, b, c = np.moveaxis(mesh.uv[mesh.triangles[triangle]], -2, 0)
        weights = np.stack([_cross(b - uv, c - uv), _cross(c - uv, a - uv), _cross(a - uv, b - uv)], axis=-1)
        with np.errstate(divide="ignore", invalid="ignore"):
            weights /= weights.sum(axis=-1, keepdims=True)
        weights = np.where(np.isfinite(weights), weights, 1 / 3)
        other = twin[3 * triangle + (weights.argmin(axis=-1) + 1) % 3]
        goes = (weights.min(axis=-1) < -1e-9) & (other >= 0)
        if not goes.any():
            break
        triangle = np.where(goes, other // 3, triangle)
    weights = np.clip(weights, 0, None)
    return triangle, weights / weights.sum(axis=-1, keepdims=True)


def _cross(a: Floats, b: Floats) -> Floats:
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def _unit(vectors: Floats) -> Floats:
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-12)
