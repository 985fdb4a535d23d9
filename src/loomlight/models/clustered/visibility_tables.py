"""Visibility of each cluster from light and view, by direction: means over its texels (zhu2024 4.2)."""

from __future__ import annotations

from dataclasses import dataclass

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import FloatType
from loomlight.core.backend import array_types
from loomlight.core.parallel_map import parallel_map
from loomlight.models.clustered.clusters import NO_CLUSTER
from loomlight.models.clustered.features import FeatureMaps, free_towards
from loomlight.models.clustered.square_map import bin_centres
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.visibility import first_hit

VIEW_BINS = 16
# Texels of a cluster that stand for all, and rays a direction.
_TEXELS = 1024
_RAYS = 4096


@dataclass(frozen=True, eq=False)
class VisibilityTables:
    """Tables of both faces.

    Attributes:
        light: [2 faces, 2 sides, bins, 2, clusters]: the share of the texels that a light reaches, and the
            mean of that times the cosine with the yarn's normal; side 1 is light from the other side.
        view: [2 faces, view bins, clusters]: the clusters' shares of view rays over their shares of texels.
        offset: mean of the parallax offset [2 faces, view bins, 2], millimetres.
    """

    light: NDArray[np.float32]
    view: NDArray[np.float32]
    offset: NDArray[np.float32]


def light_tables(maps: FeatureMaps, labels: NDArray[np.uint8], clusters: int) -> NDArray[np.float32]:
    """`VisibilityTables.light`."""
    directions = bin_centres()
    table = np.zeros((2, 2, len(directions), 2, clusters), np.float32)
    rng = np.random.default_rng(0)
    for face in (0, 1):
        flat = labels[face].ravel()
        order = rng.permutation(flat.size)
        parts = [order[flat[order] == cluster][:_TEXELS] for cluster in range(clusters)]
        sizes = np.array([len(part) for part in parts])
        texels = np.concatenate(parts)
        present = np.flatnonzero(sizes)
        starts = (np.cumsum(sizes) - sizes)[present]
        normal = maps.normal[face].reshape(-1, 3)[texels]
        for side in (0, 1):
            # Light from the other side falls on the other face, whose horizons are in its own frame.
            horizon = maps.horizon[face ^ side].reshape(labels[face].size, -1)[texels]

            def of_direction(
                direction: NDArray[np.float64],
                horizon: NDArray[np.uint8] = horizon,
                normal: NDArray[np.float32] = normal,
                sign: float = 1.0 - 2.0 * side,
                starts: NDArray[np.intp] = starts,
            ) -> NDArray[np.float32]:
                towards = direction * [sign, sign, 1.0]
                cosine = np.maximum(normal @ towards.astype(np.float32), 0)
                lit = free_towards(horizon, direction).astype(np.float32)
                return np.stack([np.add.reduceat(part, starts) for part in (lit, lit * cosine)])

            sums = np.stack(parallel_map(of_direction, directions))
            table[face, side][:, :, present] = sums / sizes[present]
    return table


def view_tables(
    geometry: YarnGeometry, labels: NDArray[np.uint8], clusters: int, float_type: FloatType
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """`VisibilityTables.view` and `offset`, by rays evenly over one repeat."""
    types = array_types(float_type)
    directions = bin_centres(VIEW_BINS)
    rows, columns = labels.shape[1:]
    width, height = geometry.size
    view = np.zeros((2, len(directions), clusters), np.float32)
    offset = np.zeros((2, len(directions), 2), np.float32)
    number = np.arange(_RAYS)
    # The plastic number's powers (Roberts 2018).
    starts = [
        ((0.5 + share * number) % 1 * side).astype(np.float32)
        for share, side in ((0.7548776662466927, width), (0.5698402909980532, height))
    ]
    # All rays of a direction beside each other.
    x, y = (types.Float(np.tile(start, len(directions))) for start in starts)
    towards = types.Vector3(np.ascontiguousarray(np.repeat(directions, _RAYS, axis=0).T, np.float32))
    for face in (0, 1):
        share = np.bincount(labels[face].ravel(), minlength=256)[:clusters] / labels[face].size
        hit = first_hit(geometry, x, y, towards, dr.opaque(types.Bool, bool(face)))
        dr.eval(hit)
        met = ~hit.hole.numpy().reshape(-1, _RAYS)
        hit_x, hit_y = (part.numpy().reshape(-1, _RAYS) for part in (hit.x, hit.y))
        column = np.minimum(np.mod(hit_x / width, 1) * columns, columns - 1).astype(int)
        row = np.minimum(np.mod(hit_y / height, 1) * rows, rows - 1).astype(int)
        label = np.where(met, labels[face][row, column], NO_CLUSTER)
        for index in range(len(directions)):
            counts = np.bincount(label[index], minlength=256)[:clusters] / _RAYS
            view[face, index] = counts / np.maximum(share, 1e-6)
            offset[face, index] = [
                np.where(met[index], after[index] - before, 0).sum() / max(met[index].sum(), 1)
                for after, before in zip((hit_x, hit_y), starts, strict=True)
            ]
    return view, offset


def visibility_tables(
    geometry: YarnGeometry,
    maps: FeatureMaps,
    labels: NDArray[np.uint8],
    clusters: int,
    float_type: FloatType,
) -> VisibilityTables:
    """All tables."""
    return VisibilityTables(
        light_tables(maps, labels, clusters), *view_tables(geometry, labels, clusters, float_type)
    )
