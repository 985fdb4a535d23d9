"""Seams of cut cloth as smooth lines: triangles are split where a seam would go in steps along their edges.

Pieces are sets of triangles. How much each vertex belongs to each piece is blurred, and a seam lies where two
pieces count alike, as marching triangles find it. A part of a triangle that goes to the piece beside it
takes uv that go on from there.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.mesh.cloth_mesh import BETWEEN, INDEX, ClothMesh
from loomlight.mesh.surface import Surface

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]
Mask = NDArray[np.bool_]

# How often belonging is averaged with that of neighbours.
_BLUR = 6
# Shares of an edge so near to its ends count as the end itself: no slivers.
_SNAP = 0.04
# By how much a vertex within a piece stays with it, at least.
_HOLDS = 0.02
# Cosine between triangles that meet in a sharp edge; a seam along one stays there.
_SHARP = 0.77


@dataclass(frozen=True, eq=False)
class Sheet:
    """Triangles of one mesh in pieces that lie flat.

    Attributes:
        mesh: of which vertices are taken; its own uv count for nothing.
        triangles: vertices of `mesh` [m, 3].
        piece: of each triangle [m]; below 0 it is none whose seams are smooth.
        corners: rows of `uv` [m, 3].
        uv: [k, 2].
    """

    mesh: ClothMesh
    triangles: Indices
    piece: Indices
    corners: Indices
    uv: Floats


def with_smooth_seams(sheet: Sheet) -> Sheet:
    """The sheet with triangles split along smooth seams between its pieces."""
    surface = _welded(sheet)
    pieces, label = np.unique(sheet.piece, return_inverse=True)
    if len(pieces) < 2:
        return sheet
    shares, fixed = _belonging(surface, label)
    own = shares.argmax(axis=1)
    of_corners = own[surface.triangles]
    (touched,) = np.nonzero((of_corners != label[:, None]).any(axis=1) & (sheet.piece >= 0))
    work = _Splitting(sheet, surface, label, shares, fixed, own)
    for triangle in touched.tolist():
        work.split(triangle)
    return work.sheet(touched, pieces)


def _welded(sheet: Sheet) -> Surface:
    """The surface whose vertices are one where they are at one place."""
    rows = np.ascontiguousarray(sheet.mesh.positions.astype(np.float32) + np.float32(0))
    _, vertex = np.unique(rows.view(f"V{rows.strides[0]}").ravel(), return_inverse=True)
    positions = np.zeros((int(vertex.max()) + 1, 3))
    positions[vertex] = sheet.mesh.positions
    return Surface.of(positions, vertex[sheet.triangles])


def _belonging(surface: Surface, label: Indices) -> tuple[Floats, Mask]:
    """How much each vertex belongs to each label [n, labels], and which vertices keep their seam [n]."""
    count = int(label.max()) + 1
    shares = np.zeros((len(surface.positions), count))
    for corner in surface.triangles.T:
        np.add.at(shares, (corner, label), surface.areas)
    shares /= np.maximum(shares.sum(axis=1, keepdims=True), 1e-300)
    start, end = surface.triangles.ravel(), np.roll(surface.triangles, -1, axis=1).ravel()
    first = shares.argmax(axis=1)
    is_inside = shares.max(axis=1) == 1
    near = ~is_inside
    # Seams end where they do, also where several sheets meet in an edge.
    is_open = np.zeros(len(shares), bool)
    is_open[start[surface.twins < 0]] = True
    is_open[end[surface.twins < 0]] = True
    fixed = _on_sharp_seams(surface, label) | (near & is_open)
    # Only near seams is there anything to blur.
    a, b = np.concatenate([start, end]), np.concatenate([end, start])
    for _ in range(_BLUR):
        near[b[near[a]]] = True
    # Along open edges by themselves, so that seams do not bend where they end.
    here = near[a] & (is_open[b] | ~is_open[a])
    a, b = a[here], b[here]
    degree = np.maximum(np.bincount(a, minlength=len(shares)), 1)[:, None]
    moves = (near & ~fixed)[:, None]
    for _ in range(_BLUR):
        mean = np.stack([np.bincount(a, shares[b, each], len(shares)) for each in range(count)], axis=1)
        shares = np.where(moves, 0.5 * (shares + mean / degree), shares)
    # No seam goes past a whole triangle: pieces that are hardly wider would be lost.
    (lost,) = np.nonzero(is_inside & (shares.argmax(axis=1) != first))
    shares[lost, first[lost]] = shares[lost].max(axis=1) + _HOLDS
    return shares, fixed


def _on_sharp_seams(surface: Surface, label: Indices) -> Mask:
    """Vertices whose seams are all sharp edges."""
    twin = surface.twins
    mine = np.repeat(label, 3)
    is_seam = (twin >= 0) & (mine != mine[twin])
    cosine = np.sum(np.repeat(surface.normals, 3, axis=0) * surface.normals[twin // 3], axis=1)
    start, end = surface.triangles.ravel(), np.roll(surface.triangles, -1, axis=1).ravel()
    has_sharp, has_soft = (np.zeros(len(surface.positions), bool) for _ in range(2))
    for chosen, found in ((is_seam & (cosine < _SHARP), has_sharp), (is_seam & (cosine >= _SHARP), has_soft)):
        found[start[chosen]] = True
        found[end[chosen]] = True
    return has_sharp & ~has_soft


class _Splitting:
    """Triangles on the way of a seam, split one after the other.

    A node is a vertex of the mesh, or a new one: a place on an edge, or in the middle of three pieces.
    """

    def __init__(
        self, sheet: Sheet, surface: Surface, label: Indices, shares: Floats, fixed: Mask, own: Indices
    ) -> None:
        self._sheet, self._surface, self._label = sheet, surface, label
        self._shares, self._fixed, self._own = shares, fixed, own
        # New nodes: three vertices each and their shares; by the edges that they lie on.
        self._nodes: list[tuple[tuple[int, int, int], tuple[float, float, float]]] = []
        self._on_edge: dict[tuple[int, int], int] = {}
        # New triangles: nodes, label, uv.
        self._triangles: list[tuple[int, int, int]] = []
        self._labels: list[int] = []
        self._uv: list[Floats] = []
        corner = surface.triangles.ravel()
        self._order = np.argsort(corner, kind="stable")
        self._first = np.searchsorted(corner[self._order], np.arange(len(surface.positions) + 1))

    def split(self, triangle: int) -> None:
        """Puts the parts of a triangle among the new ones."""
        vertices = [int(each) for each in self._sheet.triangles[triangle]]
        places = [int(each) for each in self._surface.triangles[triangle]]
        labels = [int(self._own[place]) for place in places]
        cuts = {}
        for corner in range(3):
            after = (corner + 1) % 3
            if labels[corner] != labels[after]:
                node, share = self._cut(vertices, places, labels, corner, after)
                weights = np.zeros(3)
                weights[corner], weights[after] = 1 - share, share
                cuts[corner] = node, weights
        corners = [(vertex, np.eye(3)[corner]) for corner, vertex in enumerate(vertices)]
        if not cuts:
            self._add(triangle, labels[0], corners)
        elif len(cuts) == 2:
            # One corner against the other two.
            alone = next(each for each in range(3) if each in cuts and (each + 2) % 3 in cuts)
            after, before = (alone + 1) % 3, (alone + 2) % 3
            self._add(triangle, labels[alone], [corners[alone], cuts[alone], cuts[before]])
            self._add(triangle, labels[after], [cuts[alone], corners[after], corners[before], cuts[before]])
        else:
            weights = np.mean([weight for _, weight in cuts.values()], axis=0)
            middle = self._node(vertices, weights), weights
            for corner in range(3):
                sides = [corners[corner], cuts[corner], middle, cuts[(corner + 2) % 3]]
                self._add(triangle, labels[corner], sides)

    def _cut(
        self, vertices: list[int], places: list[int], labels: list[int], corner: int, after: int
    ) -> tuple[int, float]:
        """The node where a seam crosses an edge, and its share of the way from `corner` to `after`."""
        # In one order for both triangles of the edge, so that both have the very same place.
        one, other = (corner, after) if places[corner] < places[after] else (after, corner)
        a, b = places[one], places[other]
        mine, theirs = labels[one], labels[other]
        if self._fixed[a] and self._shares[a, theirs] > 0:
            share = 0.0
        elif self._fixed[b] and self._shares[b, mine] > 0:
            share = 1.0
        else:
            here, there = (self._shares[place, mine] - self._shares[place, theirs] for place in (a, b))
            share = float(here / max(here - there, 1e-300))
            share = 0.0 if share < _SNAP else 1.0 if share > 1 - _SNAP else share
        if share in (0.0, 1.0):
            node = vertices[one] if share == 0 else vertices[other]
        else:
            key = vertices[one], vertices[other]
            if key not in self._on_edge:
                self._on_edge[key] = self._new((*key, key[1]), (1 - share, share, 0.0))
            node = self._on_edge[key]
        return node, share if one == corner else 1 - share

    def _node(self, vertices: list[int], weights: Floats) -> int:
        a, b, c = vertices
        u, v, w = (float(weight) for weight in weights)
        return self._new((a, b, c), (u, v, w))

    def _new(self, vertices: tuple[int, int, int], weights: tuple[float, float, float]) -> int:
        self._nodes.append((vertices, weights))
        return len(self._sheet.mesh.positions) + len(self._nodes) - 1

    def _add(self, triangle: int, label: int, ring: list[tuple[int, Floats]]) -> None:
        """Triangles of a convex part: its nodes, and their weights at the corners of the whole."""
        uv = self._uv_of(triangle, label)
        if uv is None:
            label = int(self._label[triangle])
            uv = self._sheet.uv[self._sheet.corners[triangle]]
        # Of the two ways to cut four sides the one whose smaller triangle is larger.
        turns = [ring] if len(ring) == 3 else [ring, ring[1:] + ring[:1]]
        fans = [[[turn[0], *turn[last - 1 : last + 1]] for last in range(2, len(turn))] for turn in turns]
        fans = [[each for each in fan if len({node for node, _ in each}) == 3] for fan in fans]
        for three in max(fans, key=_least_area):
            a, b, c = (node for node, _ in three)
            self._triangles.append((a, b, c))
            self._labels.append(label)
            self._uv.append(np.array([weights for _, weights in three]) @ uv)

    def _uv_of(self, triangle: int, label: int) -> Floats | None:
        """uv [3, 2] of a triangle's corners, as those of a piece go on; None where it is not near."""
        sheet, surface = self._sheet, self._surface
        if label == self._label[triangle]:
            return sheet.uv[sheet.corners[triangle]]
        beside = [each for each in surface.beside[triangle].tolist() if each >= 0]
        around = [
            each
            for place in surface.triangles[triangle]
            for each in (self._order[self._first[place] : self._first[place + 1]] // 3).tolist()
        ]
        near = [each for each in beside if self._label[each] == label]
        near = near or [each for each in around if self._label[each] == label]
        if not near:
            return None
        source = max(near, key=lambda each: float(surface.areas[each]))
        a, b, c = surface.positions[surface.triangles[source]]
        plane = np.stack([b - a, c - a], axis=1)
        steps = (surface.positions[surface.triangles[triangle]] - a) @ np.linalg.pinv(plane).T
        origin, one, other = sheet.uv[sheet.corners[source]]
        return np.asarray(origin + steps @ np.stack([one - origin, other - origin]))

    def sheet(self, touched: Indices, pieces: Indices) -> Sheet:
        """The whole: what was not touched, and the new triangles."""
        sheet = self._sheet
        left = np.ones(len(sheet.piece), bool)
        left[touched] = False
        uv = np.concatenate(self._uv) if self._uv else np.zeros((0, 2))
        corners = len(sheet.uv) + np.arange(len(uv)).reshape(-1, 3)
        labels = np.array(self._labels, np.int64)
        return Sheet(
            _with_nodes(sheet.mesh, self._nodes),
            np.concatenate([sheet.triangles[left], np.array(self._triangles, np.int64).reshape(-1, 3)]),
            np.concatenate([sheet.piece[left], pieces[labels]]),
            np.concatenate([sheet.corners[left], corners]),
            np.concatenate([sheet.uv, uv]),
        )


def _least_area(fan: list[list[tuple[int, Floats]]]) -> float:
    """The area of the smallest of triangles, of that of the whole that they are a part of."""
    return min((abs(np.linalg.det([weights for _, weights in three])) for three in fan), default=0.0)


def _with_nodes(
    mesh: ClothMesh, nodes: list[tuple[tuple[int, int, int], tuple[float, float, float]]]
) -> ClothMesh:
    """The mesh with further vertices, means of three of its own each."""
    if not nodes:
        return mesh
    vertices, weights = np.array([node for node, _ in nodes]), np.array([weight for _, weight in nodes])

    def further(values: Floats) -> Floats:
        if len(values) != len(mesh.positions):
            return values
        return np.concatenate([values, np.einsum("nk,nkj->nj", weights, values[vertices])])

    attributes = {name: further(values) for name, values in mesh.attributes.items() if name != INDEX}
    if INDEX in mesh.attributes:
        rows = mesh.attributes[INDEX][vertices, 0]
        attributes[INDEX] = np.concatenate([mesh.attributes[INDEX], rows[:, :1]])
        none = np.full((len(mesh.positions), 6), np.nan)
        attributes[BETWEEN] = np.concatenate([none, np.concatenate([rows, weights], axis=1)])
    normals = further(mesh.normals)
    normals = normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    return ClothMesh(further(mesh.positions), normals, mesh.uv[:0], mesh.triangles, mesh.name, attributes)
