"""Cloth cut for meshes that have no uv: pieces that lie flat, in metres, with straight grain.

u runs along the weft and v along the warp, which is the garment's vertical, on a sleeve its own axis.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.mesh.cloth_mesh import ClothMesh, MeshPart, joined
from loomlight.mesh.coarse import carried, coarse_copy
from loomlight.mesh.cutting import cut, leaning_axis, main_axis
from loomlight.mesh.flattening import FlatTriangles, flattened, stretches, unfolded
from loomlight.mesh.seams import Sheet, with_smooth_seams
from loomlight.mesh.surface import Surface, corners_of, pieces_of, together

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]
Mask = NDArray[np.bool_]

# Triangles of the copy on which is decided where to cut, and more for each component of the mesh.
_COARSE, _OF_COMPONENT = 4000, 200
# Components of less of the area are small: they are laid flat as they are.
_SMALL, _MAX_LARGE = 0.004, 40
# A file whose triangles hang together in so many panels at most, of so many triangles, has its own seams.
_MAX_PANELS, _PANEL = 64, 20
# Between pieces that lie beside each other, metres.
_GAP = 0.005
# Border vertices nearer than that, metres, are one place of a seam.
_WELD = 5e-5
# Of the area: what is folded or collapsed there is no measure of the rest.
_OUTLIERS = 1e-3
_MAX_NAMES = 6


@dataclass(frozen=True, eq=False)
class CutPieces:
    """Triangles cut into pieces that lie flat.

    Attributes:
        corners: vertices of uv of each triangle [m, 3].
        uv: [k, 2], metres, u to the right and v up as the front is seen.
        piece: of each triangle [m]: a number of `names`, or -1 for small pieces of which none is named.
        names: of the large pieces, the largest first.
        count: of all pieces.
        stretch, worst: by how much cloth is longer or shorter than it is flat, median and largest, both at
            least 1; a thousandth of the area is left out of the largest.
        angle: between the warp and the grain, median, degrees.
    """

    corners: Indices
    uv: Floats
    piece: Indices
    names: list[str]
    count: int
    stretch: float
    worst: float
    angle: float

    def sentence(self, file: str | os.PathLike[str]) -> str:
        """How a file was cut, for its users."""
        more = ", …" if len(self.names) > _MAX_NAMES else ""
        names = f" ({', '.join(self.names[:_MAX_NAMES])}{more})" if self.names else ""
        what = "a piece" if self.count == 1 else f"{self.count:,} pieces"
        far = "" if self.worst < _FAR else ", far more than cloth is: give such a part uv of its own"
        return (
            f"{file} has no uv and is cut into {what}{names}: its cloth is stretched by "
            f"{_percent(self.stretch)} (median) and {_percent(self.worst)} at worst{far}, and lies "
            f"{self.angle:.0f}° off the grain (median)."
        )


# Stretch that no cloth has: it tears or the piece is wrong.
_FAR = 1.5


def _percent(stretch: float) -> str:
    return f"{100 * (stretch - 1):.1f} %" if stretch < 1.095 else f"{100 * (stretch - 1):.0f} %"


def with_uv(parts: Sequence[MeshPart], found: CutPieces) -> list[MeshPart]:
    """Parts, whose triangles were cut, with uv: a part for each large piece, and one for what is small."""
    made = []
    first = 0
    for part in parts:
        mine = slice(first, first + len(part.mesh.triangles))
        first = mine.stop
        sheet = Sheet(part.mesh, part.mesh.triangles, found.piece[mine], found.corners[mine], found.uv)
        sheet = with_smooth_seams(sheet)
        for number in np.unique(sheet.piece):
            chosen = sheet.piece == number
            mesh = _doubled(sheet.mesh, sheet.triangles[chosen], sheet.corners[chosen], sheet.uv)
            made.append(replace(part, mesh=mesh, piece=found.names[number] if number >= 0 else ""))
    return made


def _doubled(mesh: ClothMesh, triangles: Indices, corners: Indices, uv: Floats) -> ClothMesh:
    """A mesh whose vertices are doubled along seams, with uv as Mitsuba's bitmaps have them."""
    key = triangles.astype(np.int64) * (int(corners.max()) + 1) + corners
    keys, index = np.unique(key, return_inverse=True)
    vertex, of_uv = np.divmod(keys, int(corners.max()) + 1)
    taken = mesh.taken(vertex, index.reshape(-1, 3))
    return replace(taken, uv=np.stack([uv[of_uv, 0], 1 - uv[of_uv, 1]], axis=1))


def cut_pieces(parts: Sequence[MeshPart]) -> CutPieces:
    """Cuts the cloth of parts, in metres; each is cut by itself, and their seams are matched.

    Raises:
        InputError: there are no triangles that have an area.
    """
    whole = joined([replace(part.mesh, uv=part.mesh.uv[:0]) for part in parts])
    if not len(whole.triangles):
        raise InputError(f"{whole.name} holds no triangles that have an area.")
    part = np.repeat(np.arange(len(parts)), [len(each.mesh.triangles) for each in parts])
    surface = _upright(_welded(whole, part))
    component = pieces_of(surface, np.zeros(len(part), np.int64))
    areas = np.bincount(component, surface.areas)
    order = np.argsort(-areas, kind="stable")[:_MAX_LARGE]
    is_large = np.zeros(len(areas), bool)
    is_large[order[areas[order] >= _SMALL * areas.sum()]] = True
    large = is_large[component]
    laid = [_large(surface, large)] if large.any() else []
    if not large.all():
        laid.append(_small(surface, ~large, component))
    return _merged(surface, [large, ~large][: len(laid)] if large.any() else [~large], laid)


@dataclass(frozen=True, eq=False)
class _Laid:
    """Some of the triangles, laid flat: their vertices of uv, pieces, and the grain of each triangle."""

    corners: Indices
    uv: Floats
    label: Indices
    grain: Floats
    is_limb: Mask


def _welded(mesh: ClothMesh, part: Indices) -> Surface:
    """The surface of a mesh, whose vertices are one where they are at one place of one panel."""
    owner = np.zeros(len(mesh.positions), np.int64)
    owner[mesh.triangles] = part[:, None]
    a, b, c = mesh.triangles.T
    panel = together(len(mesh.positions), np.concatenate([a, b]), np.concatenate([b, c]))
    count = len(np.unique(panel[mesh.triangles[:, 0]]))
    if count <= _MAX_PANELS and len(mesh.triangles) >= _PANEL * count:
        owner = panel
    rows = np.concatenate([mesh.positions.astype(np.float32) + np.float32(0), owner[:, None]], axis=1)
    rows = np.ascontiguousarray(rows, np.float64)
    _, vertex = np.unique(rows.view(f"V{rows.strides[0]}").ravel(), return_inverse=True)
    positions = np.zeros((int(vertex.max()) + 1, 3))
    positions[vertex] = mesh.positions
    return Surface.of(positions, vertex[mesh.triangles])


def _upright(surface: Surface) -> Surface:
    """A garment that lies on its back, as files with z upwards have it, stood up: its front along +z."""
    axis = leaning_axis(surface, np.ones(len(surface.areas), bool))
    if axis is None or abs(axis[2]) < 0.87:
        return surface
    return Surface.of(surface.positions[:, [0, 2, 1]] * [1, 1, -1], surface.triangles)


def _large(surface: Surface, chosen: Mask) -> _Laid:
    """Large components, cut on a coarse copy."""
    fine = surface.some(chosen)
    components = len(np.unique(pieces_of(fine, np.zeros(len(fine.areas), np.int64))))
    copy = coarse_copy(fine, _COARSE + _OF_COMPONENT * components)
    pattern = cut(copy.surface)
    corners = corners_of(copy.surface, pattern.kept)
    flat = FlatTriangles.of(copy.surface.positions[copy.surface.triangles], corners)
    uv = unfolded(flat, flattened(flat, pattern.axis[pattern.label]))
    if copy.surface is fine:
        return _Laid(corners, uv, pattern.label, pattern.axis[pattern.label], pattern.is_limb)
    made = carried(fine, copy, pattern, corners, uv)
    grain = pattern.axis[made.label]
    flat = FlatTriangles.of(fine.positions[fine.triangles], made.corners)
    lost: Mask = np.isnan(made.uv[:, 0])
    start = np.where(lost[:, None], 0.0, made.uv)
    if lost.any():
        here = lost[made.corners].any(axis=1)
        here = np.asarray(np.isin(made.corners, np.unique(made.corners[here])).any(axis=1))
        few, which = flat.some(here)
        start[which] = flattened(few, grain[here])
    uv = unfolded(flat, flattened(flat, grain, start, rounds=6, tolerance=1e-4, steps=40))
    return _Laid(made.corners, uv, made.label, grain, pattern.is_limb)


def _small(surface: Surface, chosen: Mask, component: Indices) -> _Laid:
    """Small components, of which closed ones are cut in two where they turn away."""
    fine = surface.some(chosen)
    number = np.unique(component[chosen], return_inverse=True)[1]
    count = int(number.max()) + 1
    has_border = np.zeros(count, bool)
    has_border[number[(fine.twins < 0).reshape(-1, 3).any(axis=1)]] = True
    spread = np.stack(
        [
            np.bincount(number, fine.areas * fine.normals[:, i] * fine.normals[:, j], count)
            for i in range(3)
            for j in range(3)
        ],
        axis=1,
    ).reshape(-1, 3, 3)
    _, vectors = np.linalg.eigh(spread)
    turned = np.sum(fine.normals * vectors[number, :, 2], axis=1) > 0
    label = pieces_of(fine, 2 * number + (turned & ~has_border[number]))
    mine = np.repeat(label, 3)
    corners = corners_of(fine, (fine.twins >= 0) & (mine == mine[fine.twins]))
    axis = main_axis(surface, np.ones(len(surface.areas), bool))
    grain = np.broadcast_to(axis, fine.normals.shape)
    flat = FlatTriangles.of(fine.positions[fine.triangles], corners)
    uv = unfolded(flat, flattened(flat, grain, rounds=12, tolerance=1e-3))
    return _Laid(corners, uv, label, grain, np.zeros(0, bool))


def _merged(surface: Surface, chosen: list[Mask], laid: list[_Laid]) -> CutPieces:
    """All pieces at true scale on straight grain, beside each other; their names and measures."""
    triangles = len(surface.areas)
    corners, label = np.zeros((triangles, 3), np.int64), np.zeros(triangles, np.int64)
    grain = np.zeros((triangles, 3))
    sheets, used, pieces, named = [], 0, 0, 0
    is_limb = np.zeros(0, bool)
    for where, sheet in zip(chosen, laid, strict=True):
        corners[where], label[where], grain[where] = sheet.corners + used, sheet.label + pieces, sheet.grain
        used, pieces = used + len(sheet.uv), pieces + int(sheet.label.max()) + 1
        if len(sheet.is_limb):
            named, is_limb = pieces, sheet.is_limb
        sheets.append(sheet.uv)
    uv = np.concatenate(sheets)
    flat = FlatTriangles.of(surface.positions[surface.triangles], corners)
    uv = _true(flat, uv, label, pieces, grain)
    uv = _beside(surface, corners, uv, label, named)
    stretch = stretches(flat.jacobian(uv))
    off, weight = _angles(flat, uv, grain)
    names = _names(surface, label, named, is_limb)
    order = np.argsort(-np.bincount(label, surface.areas, pieces)[:named], kind="stable")
    rank = np.full(pieces, -1)
    rank[order] = np.arange(named)
    return CutPieces(
        corners,
        uv,
        rank[label],
        [names[each] for each in order],
        pieces,
        _quantile(stretch, surface.areas, 0.5),
        _quantile(stretch, surface.areas, 1 - _OUTLIERS),
        _quantile(off, weight, 0.5),
    )


def _true(flat: FlatTriangles, uv: Floats, label: Indices, pieces: int, grain: Floats) -> Floats:
    """uv of which each piece has its true area and its grain upright, as far as it has one."""
    owner = np.zeros(len(uv), np.int64)
    owner[flat.corners] = label[:, None]
    area = np.bincount(label, flat.areas * np.abs(np.linalg.det(flat.jacobian(uv))), pieces)
    scale = np.sqrt(np.bincount(label, flat.areas, pieces) / np.maximum(area, 1e-300))
    u, v, weight = _grain_in_uv(flat, uv, grain)
    angle = np.arctan2(np.bincount(label, weight * u, pieces), np.bincount(label, weight * v, pieces))
    turn = (scale * np.exp(1j * angle))[owner]
    turned = (uv[:, 0] + 1j * uv[:, 1]) * turn
    return np.stack([turned.real, turned.imag], axis=1)


def _grain_in_uv(flat: FlatTriangles, uv: Floats, grain: Floats) -> tuple[Floats, Floats, Floats]:
    """The direction of the grain of each triangle, and how much it counts: its area, seen along the grain."""
    in_plane = flat.along(grain)
    u, v = np.einsum("mkj,mj->km", flat.jacobian(uv), in_plane)
    length = np.maximum(np.hypot(u, v), 1e-300)
    return u / length, v / length, flat.areas * np.hypot(*in_plane.T)


def _angles(flat: FlatTriangles, uv: Floats, grain: Floats) -> tuple[Floats, Floats]:
    """Degrees between grain and warp, and how much each counts."""
    u, v, weight = _grain_in_uv(flat, uv, grain)
    return np.degrees(np.abs(np.arctan2(u, v))), weight


def _quantile(values: Floats, weights: Floats, share: float) -> float:
    order = np.argsort(values)
    at = np.searchsorted(np.cumsum(weights[order]), share * weights.sum())
    return float(values[order[min(int(at), len(order) - 1)]])


# ------------------------------------------------------------------------------------------ the cutting table


def _beside(surface: Surface, corners: Indices, uv: Floats, label: Indices, named: int) -> Floats:
    """Pieces beside each other along u; at seams along the warp, large ones are at one height."""
    owner = np.zeros(len(uv), np.int64)
    owner[corners] = label[:, None]
    pieces = int(label.max()) + 1
    lift = np.zeros(pieces)
    lift[:named] = _lifts(surface, corners, uv, label, named)
    uv = uv + np.stack([np.zeros(len(uv)), lift[owner]], axis=1)
    low, high = np.full((pieces, 2), np.inf), np.full((pieces, 2), -np.inf)
    np.minimum.at(low, owner, uv)
    np.maximum.at(high, owner, uv)
    size = high - low
    place = -low
    # 1. Large pieces: in a row, as high as their seams say.
    ends = np.cumsum(size[:named, 0] + _GAP)
    place[:named, 0] += ends - size[:named, 0]
    place[:named, 1] = -low[:named, 1].min(initial=np.inf) if named else 0
    # 2. Small ones: in rows below, a cell for each.
    if named < pieces:
        cell = size[named:].max(axis=0) + _GAP
        width = max(float(ends[-1]) if named else 0, float(np.sqrt(cell.prod() * (pieces - named))))
        columns = max(int(width / cell[0]), 1)
        row, column = np.divmod(np.arange(pieces - named), columns)
        place[named:] += np.stack([column * cell[0], -(row + 1) * cell[1]], axis=1)
    return uv + place[owner]


def _lifts(surface: Surface, corners: Indices, uv: Floats, label: Indices, named: int) -> Floats:
    """How far each large piece goes up so that patterns meet where seams run along the warp of both."""
    mine = np.repeat(label, 3)
    is_seam = (surface.twins < 0) | (mine != mine[surface.twins])
    (edge,) = np.nonzero(is_seam & (mine < named))
    start, end = corners.ravel()[edge], np.roll(corners, -1, axis=1).ravel()[edge]
    places = surface.triangles.ravel()[edge], np.roll(surface.triangles, -1, axis=1).ravel()[edge]
    spots = np.round(surface.positions[np.stack(places, axis=1)].reshape(-1, 3) / _WELD).astype(np.int64)
    spot = (
        np.unique(spots, axis=0, return_inverse=True)[1].reshape(-1, 2)
        if len(edge)
        else np.zeros((0, 2), int)
    )
    low, high = spot.min(axis=1), spot.max(axis=1)
    order = np.lexsort((high, low))
    same = (np.diff(low[order]) == 0) & (np.diff(high[order]) == 0)
    one, other = order[:-1][same], order[1:][same]
    p, q = mine[edge[one]], mine[edge[other]]
    # The other side runs along the seam the other way.
    rise, other_rise = uv[end[one]] - uv[start[one]], uv[start[other]] - uv[end[other]]
    length = np.maximum(np.linalg.norm(rise, axis=1), 1e-300)
    along = np.minimum(rise[:, 1] * other_rise[:, 1] / length**2, 1)
    weight = np.where((p != q) & (along > 0.6), length, 0)
    gap = (uv[start[one], 1] + uv[end[one], 1] - uv[start[other], 1] - uv[end[other], 1]) / 2
    matrix, right = np.zeros((named, named)), np.zeros(named)
    for a, b, sign in ((p, q, -1), (q, p, 1)):
        np.add.at(matrix, (a, a), weight)
        np.add.at(matrix, (a, b), -weight)
        np.add.at(right, a, sign * weight * gap)
    return np.asarray(np.linalg.lstsq(matrix, right, rcond=1e-9)[0]) if named else right


def _names(surface: Surface, label: Indices, named: int, is_limb: Mask) -> list[str]:
    """Names of large pieces by where they are: of one kind the largest first, others numbered."""
    areas = np.bincount(label, surface.areas)
    middle = np.average(surface.middles, axis=0, weights=surface.areas)
    used: dict[str, int] = {}
    names = [""] * named
    for number in np.argsort(-areas[:named], kind="stable"):
        mine = label == number
        place = np.average(surface.middles[mine], axis=0, weights=surface.areas[mine]) - middle
        name = _side(np.average(surface.normals[mine], axis=0, weights=surface.areas[mine]))
        if is_limb[number]:
            name = ("left" if place[0] > 0 else "right") + " sleeve"
        used[name] = used.get(name, 0) + 1
        names[number] = name if used[name] == 1 else f"{name} {used[name]}"
    return names


def _side(normal: Floats) -> str:
    if np.linalg.norm(normal) < 0.2:
        return "body"
    axis = int(np.abs(normal).argmax())
    return (("right", "left"), ("bottom", "top"), ("back", "front"))[axis][int(normal[axis] > 0)]
