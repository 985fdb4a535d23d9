"""Visibility tables: projected area, light visibility and irradiance of groups, from rays over the repeat.

For every node of the hemisphere:

    projected_area    fraction of the view rays through the plane z = 0 that hit the group, walls included,
                      or that pass through a hole
    light_visibility  fraction of the group's points, as all views see them, that light from the node reaches
    irradiance        mean blended diffuse term of these points, shadowed, 1/sr

The last two are for light from the side of the view and for light from the other side, shadowed as on the
other face. A node has few rays of some groups: means are drawn towards those of the nodes around.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.models.lobes.accumulation import group_of_hits, light_sums, view_sums
from loomlight.models.lobes.groups import Groups, with_view_moments
from loomlight.models.lobes.hemisphere import AZIMUTHS, NODES, RINGS, node_directions
from loomlight.models.lobes.visibility_rays import VisibilityRays

# Rays that the nodes around count as. With 0 to 40 the error of components of 18 fabrics over repeats is
# 3.1, 3.0 (8 rays), 3.1 %; and groups of which a node has no ray are not black there.
SMOOTHING_RAYS = 8.0
# Keeps the unshadowed term above 0 where light grazes.
MIN_DIFFUSE = 0.02


@dataclass(frozen=True, eq=False)
class VisibilityTables:
    """Means by face, node and group; index 0 of a side is light from the side of the view, 1 from the other.

    Attributes:
        projected_area: [2 faces, nodes, groups + 1], holes last; sums over the last axis are 1.
        light_visibility: [2 faces, 2 sides, nodes, groups], 0 to 1.
        irradiance: [2 faces, 2 sides, nodes, groups], 1/sr, 0 to 1/π.
    """

    projected_area: NDArray[np.float64]
    light_visibility: NDArray[np.float64]
    irradiance: NDArray[np.float64]


def tabulate_visibility(
    rays: VisibilityRays, groups: Groups, diffuse_blend: float
) -> tuple[VisibilityTables, Groups]:
    """The tables, and the groups with the moments of the points that views hit; waits for the rays.

    Args:
        diffuse_blend: w, the weight of the yarn normal in the diffuse term.
    """
    hits = rays.views.hits
    is_skipped = hits.hole if rays.view_is_null is None else hits.hole | rays.view_is_null
    group_of = group_of_hits(hits, is_skipped, groups)
    normal, tangent = ([part.numpy() for part in vector] for vector in (hits.normal, hits.tangent))
    of_views = _with_one_zenith(view_sums(normal, tangent, group_of, groups.count))
    groups = with_view_moments(groups, of_views.sum(axis=1, dtype=np.float64))
    is_lit = rays.is_lit.numpy(), rays.is_lit_behind.numpy()
    of_light = _with_one_zenith(light_sums(normal, group_of, is_lit, groups.count, diffuse_blend))
    light_tables = _light_tables(of_light, groups, diffuse_blend)
    return VisibilityTables(_projected_area(rays, groups, of_views[..., 0]), *light_tables), groups


def _with_one_zenith(sums: NDArray[np.float32]) -> NDArray[np.float32]:
    """Sums [2, nodes, …] with those of the zenith, which is a node of every azimuth, averaged over azimuths.

    Estimates of one direction that differ would show as a pinwheel where the view is along the normal.
    """
    by_ring = sums.reshape(2, AZIMUTHS, RINGS, *sums.shape[2:])
    by_ring[:, :, 0] = by_ring[:, :, 0].mean(axis=1, keepdims=True)
    return by_ring.reshape(sums.shape)


def _projected_area(rays: VisibilityRays, groups: Groups, hits: NDArray[np.float32]) -> NDArray[np.float64]:
    """Projected areas from the number of hits of each group [2, nodes, groups]."""
    hit_yarn = hits.sum(axis=2, dtype=np.float64)
    null_in_gap = np.zeros((2, NODES)) if rays.gap_is_null is None else _by_face(rays.gap_is_null.numpy())
    # All rays that hit no yarn pass through.
    null = np.where(hit_yarn > 0, groups.hole_fraction[:, None] * null_in_gap, 1)
    fractions = hits * ((1 - null) / np.maximum(hit_yarn, 1))[..., None]
    return np.concatenate([fractions, null[..., None]], axis=2)


def _light_tables(
    sums: NDArray[np.float32], groups: Groups, diffuse_blend: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Light visibility and irradiance from `accumulation.LIGHT_SUMS` [2, nodes, groups, 5].

    Irradiance is smoothed in units of the unshadowed diffuse term about the mean normal, which changes from
    node to node by itself.
    """
    count, *totals = np.moveaxis(sums.astype(np.float64), -1, 0)
    lights = node_directions()
    across = np.einsum("nk,fgk->fng", lights[:, :2], groups.normal[..., :2])
    up = lights[:, 2, None] * groups.normal[:, None, :, 2]
    visibility, irradiance = [], []
    for lit, diffuse, cosine in zip(totals[:2], totals[2:], (up + across, up - across), strict=True):
        unshadowed = lights[:, 2, None] * (1 - diffuse_blend) + diffuse_blend * np.maximum(cosine, 0)
        unshadowed = unshadowed + MIN_DIFFUSE
        visibility.append(_smoothed(lit, count))
        smooth = _smoothed(diffuse / unshadowed, count) * unshadowed
        # Smoothed apart, the two could contradict each other.
        irradiance.append(np.minimum(smooth, visibility[-1]) / math.pi)
    return np.stack(visibility, axis=1), np.stack(irradiance, axis=1)


def _smoothed(totals: NDArray[np.float64], count: NDArray[np.float64]) -> NDArray[np.float64]:
    """Means totals/count [2, nodes, groups], drawn towards those of the nine nodes around.

    The neighbours' mean counts as much as `SMOOTHING_RAYS` rays; 0 where no node around has a ray.
    """
    around = [_around(part) for part in (totals, count)]
    mean = around[0] / np.maximum(around[1], 1e-9)
    return np.asarray((totals + SMOOTHING_RAYS * mean) / (count + SMOOTHING_RAYS))


def _around(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Means over nine nodes [2, nodes, groups], weighted 1, 2, 1 along azimuths and rings."""
    table = values.reshape(2, AZIMUTHS, RINGS, -1)
    table = np.roll(table, 1, axis=1) + 2 * table + np.roll(table, -1, axis=1)
    padded = np.pad(table, ((0, 0), (0, 0), (1, 1), (0, 0)), mode="edge")
    table = padded[:, :, :-2] + 2 * table + padded[:, :, 2:]
    return np.asarray(table.reshape(values.shape) / 16)


def _by_face(is_null: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Fraction of rays through gaps that pass through the cloth [2 faces, nodes], from the front's nodes.

    From the other face, the same line has the opposite azimuth.
    """
    front = is_null.reshape(AZIMUTHS, RINGS, -1).mean(axis=2)
    return np.stack([front, np.roll(front, AZIMUTHS // 2, axis=0)]).reshape(2, NODES)
