"""A coarse copy of a fine surface, on which is decided where to cut, and the way of its pieces back.

Vertices are gathered around seeds that lie evenly over the surface, by ways along its edges (Valette 2004,
"Approximated centroidal Voronoi diagrams"), so that nothing is carried over to another layer of cloth that
lies near. Quadrics (`fast-simplification`) leave slivers where cloth is flat, on which no distance is right.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.mesh.cutting import Cut
from loomlight.mesh.flattening import FlatTriangles
from loomlight.mesh.surface import (
    Surface,
    across,
    blurred,
    corners_of,
    crease_conductance,
    pieces_of,
    together,
)

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]
Mask = NDArray[np.bool_]

# Triangles beside a coarse vertex that are looked at.
_MAX_BESIDE = 12
# Triangles of a small component, at least; how often seeds are moved to the middle.
_OF_COMPONENT, _ROUNDS = 300, 2
# How far labels of coarse triangles are blurred, so that seams are no zigzag.
_BLUR = 6


@dataclass(frozen=True, eq=False)
class CoarseCopy:
    """A coarse copy.

    Attributes:
        surface: its triangles.
        vertex: of each fine vertex the coarse one that it became [n].
    """

    surface: Surface
    vertex: Indices


def coarse_copy(surface: Surface, count: int) -> CoarseCopy:
    """A copy of about `count` triangles; the surface itself where it has not many more."""
    if len(surface.triangles) < 1.5 * count:
        return CoarseCopy(surface, np.arange(len(surface.positions)))
    start, end = surface.triangles.ravel(), np.roll(surface.triangles, -1, axis=1).ravel()
    a, b = np.concatenate([start, end]), np.concatenate([end, start])
    key = np.unique(a * len(surface.positions) + b)
    a, b = np.divmod(key, len(surface.positions))
    length = np.linalg.norm(surface.positions[a] - surface.positions[b], axis=1)
    first = np.searchsorted(a, np.arange(len(surface.positions) + 1))
    cluster = _cells(surface, a, b, count)
    for _ in range(_ROUNDS):
        cluster = _nearest_seed(_seeds(surface.positions, cluster), first, b, length)
        cluster = np.unique(cluster, return_inverse=True)[1]
    size = np.maximum(np.bincount(cluster), 1)[:, None]
    positions = np.stack([np.bincount(cluster, column) for column in surface.positions.T], axis=1) / size
    triangles = cluster[surface.triangles]
    apart = (triangles != np.roll(triangles, -1, axis=1)).all(axis=1)
    triangles = triangles[apart]
    _, one = np.unique(np.sort(triangles, axis=1), axis=0, return_index=True)
    triangles = triangles[np.sort(one)]
    a, b, c = (positions[triangles[:, corner]] for corner in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    return CoarseCopy(Surface.of(positions, triangles[area > 1e-9 * area.max(initial=0)]), cluster)


def _cells(surface: Surface, a: Indices, b: Indices, count: int) -> Indices:
    """Vertices of one cell of a grid that hang together, along edges from `a` to `b`, numbered."""
    component = together(len(surface.positions), a, b)
    of_triangles = component[surface.triangles[:, 0]]
    areas = np.bincount(of_triangles, surface.areas, int(component.max()) + 1)
    # Half as many vertices as triangles; a surface through a grid meets some half as many cells again.
    side = np.sqrt(1.5 * 2 * np.minimum(surface.areas.sum() / count, areas / _OF_COMPONENT))
    cell = np.floor(surface.positions / np.maximum(side, 1e-300)[component][:, None]).astype(np.int64)
    same = (cell[a] == cell[b]).all(axis=1)
    return together(len(surface.positions), a[same], b[same])


def _seeds(positions: Floats, cluster: Indices) -> Indices:
    """The vertex of each cluster that is nearest to its middle; none of clusters of few vertices."""
    size = np.bincount(cluster)
    middle = np.stack([np.bincount(cluster, column) for column in positions.T], axis=1) / size[:, None]
    away = np.sum((positions - middle[cluster]) ** 2, axis=1)
    order = np.lexsort((away, cluster))
    first = order[np.append(True, np.diff(cluster[order]) != 0)]
    return first[size > 0.2 * np.median(size)]


def _nearest_seed(seeds: Indices, first: Indices, b: Indices, length: Floats) -> Indices:
    """The seed of each vertex from which the way along edges is the shortest; its own number beyond reach."""
    count = len(first) - 1
    away, seed = np.full(count, np.inf), np.arange(count)
    away[seeds] = 0
    active = seeds
    while len(active):
        degree = first[active + 1] - first[active]
        edge = np.repeat(first[active] - np.cumsum(degree) + degree, degree) + np.arange(degree.sum())
        here, there = np.repeat(active, degree), b[edge]
        way = away[here] + length[edge]
        better = way < away[there]
        here, there, way = here[better], there[better], way[better]
        np.minimum.at(away, there, way)
        chosen = way == away[there]
        seed[there[chosen]] = seed[here[chosen]]
        active = np.unique(there[chosen])
    return seed


@dataclass(frozen=True, eq=False)
class FinePieces:
    """Pieces on the fine surface.

    Attributes:
        label: the piece of each triangle [m].
        corners: vertices of uv [m, 3].
        uv: where these lie about [k, 2]; NaN where it is not known.
    """

    label: Indices
    corners: Indices
    uv: Floats


def carried(surface: Surface, copy: CoarseCopy, cut: Cut, corners: Indices, uv: Floats) -> FinePieces:
    """Pieces of a coarse copy, which lie flat at `uv` of `corners`, on the surface itself."""
    coarse = copy.surface
    strip = _strips(coarse, cut, corners, uv)
    count = int(strip.max()) + 1
    piece_of = np.zeros(count, np.int64)
    piece_of[strip] = cut.label
    beside, share = _nearest(surface.positions, copy)
    scores = _scores(coarse, strip, count)
    # 1. A triangle is of the strip that counts most at its corners; what is cut off goes to its neighbours.
    of_vertices = np.einsum("nk,nkl->nl", share, scores[beside]) if len(beside) else scores[:0]
    fine = of_vertices[surface.triangles].sum(axis=1).argmax(axis=1)
    fine = _gathered(surface, fine, count)
    # 2. Triangles of two strips hang together where the coarse ones do.
    meet = np.eye(count, dtype=bool)
    edge = np.flatnonzero(cut.kept & (coarse.twins >= 0))
    meet[strip[edge // 3], strip[coarse.twins[edge] // 3]] = True
    meet |= meet.T
    kept = (surface.twins >= 0) & meet[np.repeat(fine, 3), fine[surface.twins // 3]]
    made = corners_of(surface, kept)
    return FinePieces(
        piece_of[fine], made, _places(surface, copy, strip, corners, uv, fine, made, beside, share)
    )


def _strips(coarse: Surface, cut: Cut, corners: Indices, uv: Floats) -> Indices:
    """Labels of triangles, three for a piece that is cut within, in a row, so that they tell its sides."""
    opened = across(coarse, cut.label) & ~cut.kept
    strip = np.zeros(len(cut.label), np.int64)
    used = 0
    for number in range(len(cut.axis)):
        mine = cut.label == number
        strip[mine] = used
        if opened[np.repeat(mine, 3)].any():
            u = uv[corners[mine], 0].mean(axis=1)
            strip[mine] += np.searchsorted(np.quantile(u, [1 / 3, 2 / 3]), u)
        used = int(strip[mine].max(initial=used - 1)) + 1
    return np.unique(strip, return_inverse=True)[1]


def _scores(coarse: Surface, strip: Indices, count: int) -> Floats:
    """How much each coarse vertex belongs to each strip [n, count]."""
    of_faces = blurred(coarse, np.eye(count)[strip], crease_conductance(coarse), _BLUR)
    found = np.zeros((len(coarse.positions), count))
    for corner in coarse.triangles.T:
        np.add.at(found, corner, of_faces * coarse.areas[:, None])
    return found / np.maximum(found.sum(axis=1, keepdims=True), 1e-300)


def _nearest(places: Floats, copy: CoarseCopy) -> tuple[Indices, Floats]:
    """The corners of the coarse triangle that is nearest to each place, of those at its vertex; shares."""
    coarse = copy.surface
    corner = np.argsort(coarse.triangles.ravel(), kind="stable")
    counts = np.bincount(coarse.triangles.ravel(), minlength=len(coarse.positions))
    first = np.cumsum(counts) - counts
    found = np.repeat(copy.vertex[:, None], 3, axis=1)
    share = np.tile([1.0, 0.0, 0.0], (len(places), 1))
    best = np.full(len(places), np.inf)
    for number in range(min(int(counts.max(initial=0)), _MAX_BESIDE)):
        (here,) = np.nonzero(counts[copy.vertex] > number)
        triangle = corner[first[copy.vertex[here]] + number] // 3
        a, b, c = (coarse.positions[coarse.triangles[triangle, each]] for each in range(3))
        one, other, to = b - a, c - a, places[here] - a
        d11, d12, d22 = (np.sum(x * y, axis=1) for x, y in ((one, one), (one, other), (other, other)))
        d1, d2 = np.sum(one * to, axis=1), np.sum(other * to, axis=1)
        below = np.maximum(d11 * d22 - d12 * d12, 1e-300)
        weights = np.stack([d22 * d1 - d12 * d2, d11 * d2 - d12 * d1], axis=1) / below[:, None]
        weights = np.clip(np.stack([1 - weights.sum(axis=1), *weights.T], axis=1), 0, None)
        weights /= np.maximum(weights.sum(axis=1, keepdims=True), 1e-300)
        away = to - weights[:, 1:2] * one - weights[:, 2:] * other
        distance = np.sum(away * away, axis=1)
        nearer = distance < best[here]
        here, triangle = here[nearer], triangle[nearer]
        best[here], found[here], share[here] = distance[nearer], coarse.triangles[triangle], weights[nearer]
    return found, share


def _gathered(surface: Surface, label: Indices, count: int) -> Indices:
    """Labels of which each is one connected set: others than the largest go to what lies around them."""
    for _ in range(8):
        number = pieces_of(surface, label)
        areas = np.bincount(number, surface.areas)
        of_set = np.zeros(len(areas), np.int64)
        of_set[number] = label
        component = pieces_of(surface, np.zeros_like(label))
        whole = np.zeros(len(areas), np.int64)
        whole[number] = component
        # The largest of each label in each component.
        order = np.lexsort((areas, of_set, whole))
        last = np.append((np.diff(of_set[order]) != 0) | (np.diff(whole[order]) != 0), True)
        largest = np.zeros(len(areas), bool)
        largest[order[last]] = True
        (edge,) = np.nonzero((surface.twins >= 0) & ~np.repeat(largest[number], 3))
        there = surface.twins[edge] // 3
        outside = number[edge // 3] != number[there]
        if not outside.any():
            break
        mine, other = number[edge[outside] // 3], label[there[outside]]
        votes = np.bincount(mine * count + other, minlength=len(areas) * count).reshape(-1, count)
        moved = votes.sum(axis=1) > 0
        label = np.where(moved[number], votes.argmax(axis=1)[number], label)
    return label


def _places(
    surface: Surface,
    copy: CoarseCopy,
    strip: Indices,
    corners: Indices,
    uv: Floats,
    fine: Indices,
    made: Indices,
    beside: Indices,
    share: Floats,
) -> Floats:
    """About where vertices of uv lie: as uv go on from the nearest coarse vertices of the same strip."""
    coarse = copy.surface
    count, strips = int(made.max()) + 1, int(strip.max()) + 1
    # 1. uv and their gradients at coarse vertices, for each strip around them.
    flat = FlatTriangles.of(coarse.positions[coarse.triangles], corners)
    jacobian = flat.jacobian(uv)
    gradient = jacobian[:, :, :1] * flat.across[:, None] + jacobian[:, :, 1:] * flat.up[:, None]
    keys, at = np.unique(coarse.triangles * strips + strip[:, None], return_inverse=True)
    at = at.reshape(-1, 3)
    weight, place, slope = np.zeros(len(keys)), np.zeros((len(keys), 2)), np.zeros((len(keys), 2, 3))
    for corner in range(3):
        np.add.at(weight, at[:, corner], flat.areas)
        np.add.at(place, at[:, corner], uv[corners[:, corner]] * flat.areas[:, None])
        np.add.at(slope, at[:, corner], gradient * flat.areas[:, None, None])
    place, slope = place / weight[:, None], slope / weight[:, None, None]
    # 2. Each vertex of uv by one of its triangles.
    triangle = np.zeros(count, np.int64)
    vertex = np.zeros(count, np.int64)
    triangle[made] = np.arange(len(made))[:, None]
    vertex[made] = surface.triangles
    total, found = np.zeros(count), np.zeros((count, 2))
    for corner in range(3):
        near = beside[vertex, corner]
        key = near * strips + fine[triangle]
        where = np.minimum(np.searchsorted(keys, key), len(keys) - 1)
        part = np.where(keys[where] == key, share[vertex, corner] + 1e-6, 0)
        step = surface.positions[vertex] - coarse.positions[near]
        total += part
        found += part[:, None] * (place[where] + np.einsum("nij,nj->ni", slope[where], step))
    with np.errstate(invalid="ignore", divide="ignore"):
        return _filled(made, np.where(total[:, None] > 0, found / total[:, None], np.nan))


def _filled(made: Indices, uv: Floats) -> Floats:
    """uv whose gaps take the mean of what lies beside."""
    for _ in range(200):
        missing = np.isnan(uv[:, 0])
        rows = made[missing[made].any(axis=1)]
        if not len(rows):
            break
        known = ~np.isnan(uv[rows, 0])
        count = known.sum(axis=1)
        if not count.any():
            break
        mean = np.nansum(np.where(known[..., None], uv[rows], 0), axis=1) / np.maximum(count, 1)[:, None]
        total, number = np.zeros_like(uv), np.zeros(len(uv))
        for corner in range(3):
            here = missing[rows[:, corner]] & (count > 0)
            np.add.at(total, rows[here, corner], mean[here])
            np.add.at(number, rows[here, corner], 1)
        reached = number > 0
        uv = np.where(reached[:, None], total / np.maximum(number, 1)[:, None], uv)
    return uv
