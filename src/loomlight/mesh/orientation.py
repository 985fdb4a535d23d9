"""Parts of a mesh that are inside out: their fronts face inward, where those of the others face outward."""

from __future__ import annotations

import os
import warnings
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import LoomlightWarning
from loomlight.mesh.cloth_mesh import ClothMesh, MeshPart, cross_products

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
