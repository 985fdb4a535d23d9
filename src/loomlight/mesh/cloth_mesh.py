"""Triangles with uv, checked; millimetres of cloth a unit of uv; parts that are inside out.

uv follows Mitsuba's bitmaps, v running down the image.
"""

from __future__ import annotations

import os
import re
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import mapbox_earcut
import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError, LoomlightWarning

# Areas are computed of squares, in single precision too.
MAX_COORDINATE = 1e15
# The attribute that tells which row of its file a vertex has its position of, counted over all its parts.
INDEX = "index"
# Of a vertex that was made where cloth is cut: three such rows and their shares; NaN of others.
BETWEEN = "between"
# Each part costs about a millisecond, however small it is.
MAX_PARTS = 20_000
# Parts of a file may show the same arrays any number of times: a bound for all triangles.
MAX_TRIANGLES = 10_000_000


@dataclass(frozen=True, eq=False)
class ClothMesh:
    """Triangles with uv.

    Attributes:
        positions: [n, 3], the file's units.
        normals: unit vertex normals [n, 3].
        uv: [n, 2].
        triangles: vertex indices [m, 3], counter-clockwise from the front.
        name: the file, for messages.
        attributes: further numbers of vertices [n, k] by name, such as "uv1", a second set of uv; they go
            with their vertices wherever those are sorted out, doubled or joined to others.
    """

    positions: NDArray[np.float64]
    normals: NDArray[np.float64]
    uv: NDArray[np.float64]
    triangles: NDArray[np.int64]
    name: str
    attributes: Mapping[str, NDArray[np.float64]] = field(default_factory=dict)

    def scaled(self, factor: float) -> ClothMesh:
        """The same mesh with lengths multiplied by `factor`."""
        return replace(self, positions=self.positions * factor)

    def taken(
        self, vertices: NDArray[np.int64] | NDArray[np.bool_], triangles: NDArray[np.int64]
    ) -> ClothMesh:
        """The mesh of some vertices, which may be named several times, and other triangles of these."""
        count = len(self.positions)

        def rows(values: NDArray[np.float64]) -> NDArray[np.float64]:
            return values[vertices] if len(values) == count else values[:0]

        return ClothMesh(
            self.positions[vertices],
            rows(self.normals),
            rows(self.uv),
            triangles,
            self.name,
            {name: rows(values) for name, values in self.attributes.items()},
        )


@dataclass(frozen=True, eq=False)
class MeshPart:
    """A part of a mesh file that can be clothed by itself.

    Attributes:
        name: of its object or group; "" where the file gives none.
        material: its material's name; "" where the file gives none.
        mesh: its triangles; `uv` is [0, 2] where the part has none.
        piece: the name of a piece that was cut for it, such as "left sleeve"; "" of what has uv of its own.
    """

    name: str
    material: str
    mesh: ClothMesh
    piece: str = ""

    @property
    def names(self) -> list[str]:
        """The words by which cloth is given to it: of its piece, all or the last, part and material."""
        words = [self.piece, *re.findall(r"[^\W\d]+(?= \d+$|$)", self.piece), self.name, self.material]
        return [word for word in dict.fromkeys(words) if word]


def checked(mesh: ClothMesh) -> ClothMesh:
    """The mesh of one cloth, cleaned.

    Raises:
        InputError: what `cleaned` raises, no triangles, or no usable uv.
    """
    mesh = cleaned(mesh)
    if len(mesh.triangles) == 0:
        raise InputError(f"{mesh.name} holds no triangles that have an area.")
    if len(mesh.uv) != len(mesh.positions) or not np.isfinite(mesh.uv).all():
        raise InputError(f"{mesh.name} has no uv coordinates; unwrap it first.")
    if collapses(mesh):
        raise InputError(f"{mesh.name}: its uv coordinates collapse to lines or points; unwrap it first.")
    return mesh


def cleaned(mesh: ClothMesh) -> ClothMesh:
    """The triangles that have an area, their vertices, and unit normals, computed where there are none.

    uv stay as they are, finite or not.

    Raises:
        InputError: an index out of range, or a position that is not finite or too large to compute with.
    """
    count, triangles = len(mesh.positions), mesh.triangles
    check_indices(triangles, count, mesh.name)
    if not (np.abs(mesh.positions[triangles]) < MAX_COORDINATE).all():
        raise InputError(f"{mesh.name} is damaged: a vertex position is not finite, or beyond ±1e15.")
    triangles = triangles[np.any(cross_products(mesh) != 0, axis=1)]
    used = np.zeros(count, bool)
    used[triangles] = True
    if len(mesh.normals) != count:
        mesh = replace(mesh, normals=np.zeros((count, 3)))
    mesh = mesh.taken(used, (np.cumsum(used) - 1)[triangles])
    usable = np.isfinite(mesh.normals).all(axis=1, keepdims=True)
    normals = np.clip(np.where(usable, mesh.normals, 0), -1e100, 1e100)
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    if (length == 0).any():
        normals = np.where(length == 0, vertex_normals(mesh.positions, mesh.triangles), normals)
        length = np.linalg.norm(normals, axis=1, keepdims=True)
    return replace(mesh, normals=normals / length)


def check_indices(indices: NDArray[np.int64], count: int, name: str) -> None:
    """Raises InputError if one of `indices` names none of `count` vertices."""
    wrong = (indices < 0) | (indices >= count)
    if wrong.any():
        raise InputError(
            f"{name} is damaged: a face names vertex {indices[wrong][0]}, and there are {count}, from 0 on."
        )


def collapses(mesh: ClothMesh) -> bool:
    """Whether more than half of the area has uv on lines or points; seams may collapse a few triangles."""
    area, _, _ = metric(mesh)
    return bool(np.nansum(area) < 0.25 * np.linalg.norm(cross_products(mesh), axis=1).sum())


def joined(parts: list[ClothMesh]) -> ClothMesh:
    """One mesh of all parts, of which an attribute that one of them lacks is NaN there.

    Raises:
        InputError: some have uv and one has none.
    """
    if any(len(part.uv) for part in parts) and any(len(part.uv) != len(part.positions) for part in parts):
        raise InputError(f"{parts[0].name}: a part of the mesh has no uv coordinates; unwrap it first.")
    starts = np.cumsum([0] + [len(part.positions) for part in parts[:-1]])

    def stacked(values: Callable[[ClothMesh], NDArray[np.float64]]) -> NDArray[np.float64]:
        return np.concatenate([values(part) for part in parts])

    return ClothMesh(
        positions=stacked(lambda part: part.positions),
        normals=stacked(lambda part: part.normals),
        uv=stacked(lambda part: part.uv),
        triangles=np.concatenate([part.triangles + start for part, start in zip(parts, starts, strict=True)]),
        name=parts[0].name,
        attributes=_joined_attributes(parts),
    )


def _joined_attributes(parts: list[ClothMesh]) -> dict[str, NDArray[np.float64]]:
    widths = {name: values.shape[1] for part in parts for name, values in part.attributes.items()}
    return {
        name: np.concatenate(
            [part.attributes.get(name, np.full((len(part.positions), width), np.nan)) for part in parts]
        )
        for name, width in widths.items()
    }


def placed(mesh: ClothMesh, matrix: NDArray[np.float64]) -> ClothMesh:
    """The mesh where a matrix [4, 4] of columns moves it; what the matrix mirrors keeps its front."""
    linear = matrix[:3, :3]
    determinant = np.linalg.det(linear)
    normals = mesh.normals @ np.linalg.inv(linear) if abs(determinant) > 1e-30 else np.zeros((0, 3))
    triangles = mesh.triangles[:, ::-1] if determinant < 0 else mesh.triangles
    positions = mesh.positions @ linear.T + matrix[:3, 3]
    return replace(mesh, positions=positions, normals=normals, triangles=triangles)


def distinct_rows(rows: NDArray[np.int64]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Where the distinct rows of small numbers from -1 on are first, and of each row which it is.

    It is `np.unique` by rows, quicker.
    """
    inverse, at = np.zeros(len(rows), int), np.zeros(min(1, len(rows)), int)
    for column in rows.T:
        _, at, inverse = np.unique(
            inverse * (column.max(initial=0) + 2) + column + 1, return_index=True, return_inverse=True
        )
    return at, inverse


def cross_products(mesh: ClothMesh) -> NDArray[np.float64]:
    """Of each triangle's edges [m, 3]: normals, of twice the area's length."""
    a, b, c = (mesh.positions[mesh.triangles[:, corner]] for corner in range(3))
    return np.cross(b - a, c - a)


def metric(mesh: ClothMesh) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Area [m] (NaN where the uv collapses), dp/du and dp/dv [m, 3] of each triangle."""
    a, b, c = (mesh.positions[mesh.triangles[:, corner]] for corner in range(3))
    uv_a, uv_b, uv_c = (mesh.uv[mesh.triangles[:, corner]] for corner in range(3))
    (u1, v1), (u2, v2) = (uv_b - uv_a).T, (uv_c - uv_a).T
    determinant = u1 * v2 - u2 * v1
    extent = np.abs([u1, v1, u2, v2]).max(axis=0)
    usable = np.abs(determinant) > 1e-6 * np.maximum(extent, 1e-12) ** 2
    inverse = np.where(usable, 1 / np.where(usable, determinant, 1), np.nan)[:, None]
    dp_du = (v2[:, None] * (b - a) - v1[:, None] * (c - a)) * inverse
    dp_dv = (u1[:, None] * (c - a) - u2[:, None] * (b - a)) * inverse
    area = np.linalg.norm(cross_products(mesh), axis=1) / 2
    return np.where(usable, area, np.nan), dp_du, dp_dv


def vertex_normals(positions: NDArray[np.float64], triangles: NDArray[np.int64]) -> NDArray[np.float64]:
    """Unit normals [n, 3] of vertices, weighted by areas; up (+y) where no area is known."""
    a, b, c = (positions[triangles[:, corner]] for corner in range(3))
    weighted = np.cross(b - a, c - a)
    normals = np.stack(
        [
            sum(np.bincount(corner, weighted[:, axis], len(positions)) for corner in triangles.T)
            for axis in range(3)
        ],
        axis=1,
    )
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    return np.where(length > 0, normals / np.maximum(length, 1e-300), [0.0, 1.0, 0.0])


# -------------------------------------------------------------------------------------- faces of many corners
# Faces of any number of corners, cut into triangles.


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


# ----------------------------------------------------------------------------------- millimetres a unit of uv
# Millimetres of cloth a unit of uv, and warnings of meshes that have no one scale, or none of cloth's.


# Triangles that are stretched by more than that against the median are no measure of the others: slivers,
# collapsed seams, a denser island. Cloth over a ball is stretched by less.
_STRETCH = 2.0
# How far two pieces may differ before it is said: setts of 20 and 24 threads/cm are two fabrics to the eye,
# and islands that unwrapping alone has scaled differ by less.
_SAME_SCALE = 1.2
# Of the area: buttons and the insides of seams are not worth a sentence.
_MIN_ISLAND = 0.01
# Extent of a cloth, metres, beyond which its unit is doubted: a stage curtain, a patch of some threads.
_MIN_EXTENT, _MAX_EXTENT = 0.01, 20.0
# Lengths of a unit that programs write, metres, and the inverse where one was given twice.
_UNITS = (0.01, 0.001, 1e-6, 100.0, 1000.0, 1e6)


def uv_size(mesh: ClothMesh, metres_per_unit: float = 1.0) -> tuple[float, float]:
    """Millimetres on the surface per unit of u and of v, whatever a minority of stretched triangles says.

    Each is the area-weighted RMS of |dp/du| or |dp/dv| over the triangles within a factor of 2 of its
    area-weighted median. `metres_per_unit` is the length of one unit of the mesh's positions.
    """
    area, dp_du, dp_dv = metric(mesh)
    return (
        _typical(np.linalg.norm(dp_du, axis=1), area) * 1000 * metres_per_unit,
        _typical(np.linalg.norm(dp_dv, axis=1), area) * 1000 * metres_per_unit,
    )


def at_one_scale(parts: Sequence[ClothMesh]) -> ClothMesh:
    """Parts of one fabric as one mesh, uv of other scales than the largest part's stretched to its scale.

    Parts of one scale are left as they are, so that their pattern runs on across them.
    """
    areas = [float(np.linalg.norm(cross_products(part), axis=1).sum()) for part in parts]
    size = uv_size(parts[int(np.argmax(areas))])
    own = [uv_size(part) for part in parts]
    return joined(
        [
            part if _factor(each, size) <= _SAME_SCALE else replace(part, uv=part.uv * np.divide(each, size))
            for part, each in zip(parts, own, strict=True)
        ]
    )


def warn_of_scale(mesh: ClothMesh) -> None:
    """Warns of islands whose threads would be far larger or smaller than those of the rest of a mesh."""
    area, _, _ = metric(mesh)
    island = _islands(mesh)
    shares = np.bincount(island, np.nan_to_num(area)) / np.nansum(area)
    (large,) = np.nonzero(shares >= _MIN_ISLAND)
    if len(large) < 2:
        return
    size, worst, share = uv_size(mesh), 1.0, 0.0
    for number in large:
        own = uv_size(ClothMesh(mesh.positions, mesh.normals, mesh.uv, mesh.triangles[island == number], ""))
        factor = _factor(own, size)
        share += float(shares[number]) if factor > _SAME_SCALE else 0.0
        worst = max(worst, factor)
    if share > 0:
        warnings.warn(
            f"{mesh.name}: its uv islands have several scales: threads are up to {worst:.3g} times too large "
            f"or too small on {100 * share:.0f} % of the cloth; scale its islands alike (in Blender, "
            "UV > Average Islands Scale).",
            LoomlightWarning,
            stacklevel=2,
        )


def warn_of_extent(mesh: ClothMesh, metres_per_unit: float) -> None:
    """Warns of a mesh, in metres, that is larger or smaller than cloth is, and names a likely unit."""
    sides = np.sort(np.ptp(mesh.positions, axis=0))[::-1]
    if _MIN_EXTENT <= sides[0] <= _MAX_EXTENT:
        return
    # The unit that makes it the most like a garment.
    unit = min(_UNITS, key=lambda unit: abs(np.log(sides[0] * unit)))
    warnings.warn(
        f"{mesh.name} is {sides[0]:.4g} m by {sides[1]:.4g} m, and threads stay threads: if "
        f"it should be {sides[0] * unit:.3g} m, give --metres-per-unit {metres_per_unit * unit:.3g}.",
        LoomlightWarning,
        stacklevel=2,
    )


def _typical(stretch: NDArray[np.float64], area: NDArray[np.float64]) -> float:
    known = np.isfinite(area) & (area > 0)
    stretch, weight = stretch[known], area[known]
    order = np.argsort(stretch)
    cumulative = np.cumsum(weight[order])
    # Rounding must not choose where two halves are equal.
    median = stretch[order[np.searchsorted(cumulative, 0.5 * cumulative[-1] * (1 - 1e-9))]]
    near = (stretch >= median / _STRETCH) & (stretch <= median * _STRETCH)
    return float(np.sqrt(np.average(stretch[near] ** 2, weights=weight[near])))


def _factor(size: tuple[float, float], other: tuple[float, float]) -> float:
    """The larger of the ratios of u and of v, at least 1."""
    return float(np.exp(np.abs(np.log(np.divide(size, other))).max()))


def _islands(mesh: ClothMesh) -> NDArray[np.intp]:
    """The number of the island of each triangle: triangles share corners of one place and one uv."""
    rows = np.concatenate([mesh.positions, mesh.uv], axis=1).astype(np.float32) + np.float32(0)
    _, corner = np.unique(rows.view(f"V{rows.strides[0]}").ravel(), return_inverse=True)
    triangles = corner[mesh.triangles]
    label = np.arange(corner.max() + 1)
    while True:
        lowest = label[triangles].min(axis=1)
        lower = label.copy()
        for column in triangles.T:
            np.minimum.at(lower, column, lowest)
            # The label's own label too, so that long strips take few rounds.
            np.minimum.at(lower, label[column], lowest)
        lower = lower[lower]
        if np.array_equal(lower, label):
            return np.unique(label[triangles[:, 0]], return_inverse=True)[1]
        label = lower


# ---------------------------------------------------------------------------------- parts that are inside out
# Parts of a mesh that are inside out: their fronts face inward, where those of the others face outward.


Floats = NDArray[np.float64]
# Mean cosine between the front and the direction away from a part's middle: of a sphere 1, of a tube some
# 0.7, of a flat piece 0. Beyond this a part faces outward, or inward.
_FACES = 0.35
# Names in a sentence.
_MAX_NAMES = 4


def warn_of_inside_out(parts: Sequence[MeshPart], file: str | os.PathLike[str]) -> None:
    """Warns, in a sentence, of parts whose fronts are on the other side than those of the others.

    A part's triangles may be wound against its own normals. Along seams, where two parts have the same edge,
    one runs along it and the other back if their fronts are on one side. Parts without seams are compared by
    whether they face outward, but for those within another part, such as a lining; one that is closed has to.
    """
    wound = [_is_wound_against_normals(part.mesh) for part in parts]
    _name(parts, wound, file, "its triangles are wound against its normals")
    right = [part for part, wrong in zip(parts, wound, strict=True) if not wrong]
    _name(right, _turned(right), file, "its front faces the other way than it should beside the others")


def _name(
    parts: Sequence[MeshPart], wrong: Sequence[bool | np.bool_], file: str | os.PathLike[str], why: str
) -> None:
    names = [
        f'"{(part.name or part.material)[:40]}"'
        if part.name or part.material
        else f"{number} of {len(parts)}"
        for number, (part, chosen) in enumerate(zip(parts, wrong, strict=True), 1)
        if chosen
    ]
    if not names:
        return
    if len(parts) == 1:
        what = "the mesh is"
    elif len(names) == 1:
        what = f"the part {names[0]} is"
    else:
        more = " and others" if len(names) > _MAX_NAMES else ""
        what = f"the parts {', '.join(names[:_MAX_NAMES])}{more} are each"
    warnings.warn(
        f"{file}: {what} inside out: {why}, and shows the back of the cloth; turn it over "
        "(in Blender, Mesh > Normals > Recalculate Outside).",
        LoomlightWarning,
        stacklevel=3,
    )


def _is_wound_against_normals(mesh: ClothMesh) -> bool:
    of_corners = mesh.normals[mesh.triangles].sum(axis=1)
    return bool((cross_products(mesh) * of_corners).sum() < 0)


def _turned(parts: Sequence[MeshPart]) -> list[bool]:
    """Which parts are turned over."""
    if not parts:
        return []
    areas = np.array([np.linalg.norm(cross_products(part.mesh), axis=1).sum() for part in parts])
    key, runs_up, owner, length = _borders(parts)
    turned, in_seam = _across_seams(len(parts), areas, key, runs_up, owner, length)
    faces = np.array([_facing(part.mesh) for part in parts])
    faces_outward = bool((areas * faces)[~turned].sum() > _FACES * areas[~turned].sum())
    for number, part in enumerate(parts):
        if in_seam[number] or faces[number] >= -_FACES:
            continue
        is_closed = not (owner == number).any()
        others = [other.mesh for other in parts if other is not part]
        if is_closed if not others else faces_outward and not _lies_within(part.mesh, others):
            turned[number] = True
    return [bool(each) for each in turned]


def _facing(mesh: ClothMesh) -> float:
    """Mean cosine between the front and the direction away from the middle, weighted by area."""
    normal = cross_products(mesh)
    area = np.linalg.norm(normal, axis=1)
    middle = mesh.positions[mesh.triangles].mean(axis=1)
    away = middle - np.average(middle, axis=0, weights=area)
    distance = np.maximum(np.linalg.norm(away, axis=1), 1e-300)
    return float(((normal * away).sum(axis=1) / distance).sum() / area.sum())


def _lies_within(mesh: ClothMesh, others: Sequence[ClothMesh]) -> bool:
    low, high = mesh.positions.min(axis=0), mesh.positions.max(axis=0)
    return any(
        bool((low >= other.positions.min(axis=0)).all() and (high <= other.positions.max(axis=0)).all())
        for other in others
    )


def _borders(
    parts: Sequence[MeshPart],
) -> tuple[NDArray[np.int64], NDArray[np.bool_], NDArray[np.intp], Floats]:
    """Edges of one triangle alone in their part: a key of the edge, its sense, the part and the length."""
    places = np.concatenate([part.mesh.positions for part in parts]).astype(np.float32) + np.float32(0)
    _, place = np.unique(places.view(f"V{places.strides[0]}").ravel(), return_inverse=True)
    count = int(place.max()) + 1
    found: list[tuple[NDArray[np.int64], NDArray[np.bool_], NDArray[np.intp], Floats]] = []
    first = 0
    for number, part in enumerate(parts):
        corners = part.mesh.triangles + first
        first += len(part.mesh.positions)
        edges = corners[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
        start, end = place[edges].T
        key = np.minimum(start, end) * count + np.maximum(start, end)
        _, where, times = np.unique(key, return_index=True, return_counts=True)
        alone = where[times == 1]
        steps = places[edges[alone, 1]].astype(np.float64) - places[edges[alone, 0]]
        owner = np.full(len(alone), number)
        found.append((key[alone], (start < end)[alone], owner, np.linalg.norm(steps, axis=1)))
    key, runs_up, owner, length = (np.concatenate(values) for values in zip(*found, strict=True))
    return key, runs_up, owner, length


def _across_seams(
    count: int,
    areas: Floats,
    key: NDArray[np.int64],
    runs_up: NDArray[np.bool_],
    owner: NDArray[np.intp],
    length: Floats,
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Which parts are turned over against those they are sewn to, the fewer by area; which are sewn."""
    order = np.argsort(key, kind="stable")
    first, second = order[:-1], order[1:]
    pairs = key[first] == key[second]
    # Edges that three parts have say nothing.
    twice = pairs & ~np.append(pairs[1:], False) & ~np.insert(pairs[:-1], 0, False)
    first, second = first[twice], second[twice]
    balance = np.zeros((count, count))
    np.add.at(
        balance,
        (owner[first], owner[second]),
        np.where(runs_up[first] != runs_up[second], length[first], -length[first]),
    )
    balance += balance.T
    turned, seen = np.zeros(count, bool), np.zeros(count, bool)
    for start in np.argsort(-areas):
        if seen[start]:
            continue
        group, left = [start], [start]
        seen[start] = True
        while left:
            here = left.pop()
            for there in np.flatnonzero((balance[here] != 0) & ~seen):
                seen[there] = True
                turned[there] = turned[here] ^ (balance[here, there] < 0)
                group.append(there)
                left.append(there)
        members = np.array(group)
        if areas[members][turned[members]].sum() > 0.5 * areas[members].sum():
            turned[members] = ~turned[members]
    return turned, (balance != 0).any(axis=1)
