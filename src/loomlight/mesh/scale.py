"""Millimetres of cloth a unit of uv, and warnings of meshes that have no one scale, or none of cloth's."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import LoomlightWarning
from loomlight.mesh.cloth_mesh import ClothMesh, cross_products, joined, metric

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
