"""Visibility tables: projected area, light visibility and irradiance of groups, from rays over the repeat.

For every node of the hemisphere:

    projected_area    fraction of the view rays through the plane z = 0 that hit the group, walls included,
                      or that pass through a hole
    light_visibility  fraction of the group's top-down samples that light from the node reaches
    irradiance        mean blended diffuse term of the group's top-down samples, shadowed, 1/sr

The last two are for light from the side of the view and for light from the other side, shadowed as on the
other face.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.models.lobes.groups import Groups, with_view_moments
from loomlight.models.lobes.hemisphere import AZIMUTHS, NODES, RINGS
from loomlight.models.lobes.visibility_rays import VisibilityRays


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
    # Imported here as Numba takes tenths of a second to load, and only baking needs it.
    from loomlight.models.lobes.accumulation import accumulate_light, accumulate_views, hit_arrays

    views, samples = rays.views.hits, rays.samples
    is_skipped = views.hole.numpy()
    if rays.view_is_null is not None:
        is_skipped = is_skipped | rays.view_is_null.numpy()
    view_sums = _with_one_zenith(accumulate_views(hit_arrays(views, is_skipped), groups))
    light_sums = _with_one_zenith(
        accumulate_light(
            hit_arrays(samples, samples.hole.numpy()), rays.is_lit.numpy(), groups, diffuse_blend
        )
    )
    tables = VisibilityTables(_projected_area(rays, groups, view_sums[..., 0]), *_light_tables(light_sums))
    return tables, with_view_moments(groups, view_sums.sum(axis=1, dtype=np.float64))


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


def _light_tables(sums: NDArray[np.float32]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Light visibility and irradiance from `accumulation.LIGHT_SUMS` [2, nodes, groups, 5]."""
    count, *totals = np.moveaxis(sums.astype(np.float64), -1, 0)
    means = [total / np.maximum(count, 1) for total in totals]
    return np.stack(means[:2], axis=1), np.stack(means[2:], axis=1) / math.pi


def _by_face(is_null: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Fraction of rays through gaps that pass through the cloth [2 faces, nodes], from the front's nodes.

    From the other face, the same line has the opposite azimuth.
    """
    front = is_null.reshape(AZIMUTHS, RINGS, -1).mean(axis=2)
    return np.stack([front, np.roll(front, AZIMUTHS // 2, axis=0)]).reshape(2, NODES)
