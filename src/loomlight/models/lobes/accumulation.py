"""Assigns ray hits to groups, and accumulates by face, node of the hemisphere and group.

A hit belongs to the group of its own family whose centroid is nearest, as in `groups.NearestGroup`. Hits are
in the order of `visibility_rays`: by face, then node, then ray. The rays of one node on one face are a block.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from loomlight.core.numba_kernel import numba_kernel
from loomlight.core.parallel_map import core_count, parallel_map
from loomlight.models.lobes.groups import NORMAL_WEIGHT, Groups
from loomlight.models.lobes.hemisphere import NODES, node_directions
from loomlight.models.lobes.visibility_rays import SurfaceHits, start_of_shadow_ray

# Sums over the views that hit a group: 1, normal, fibre direction t, and t tᵀ as xx, xy, xz, yy, yz, zz.
VIEW_SUMS = 13
# Sums over the hits of a group that shadow rays start from: 1; visibility of light on the side seen, and on
# the other side; the blended diffuse term times π under either light.
LIGHT_SUMS = 5
_BLOCKS = 2 * NODES
_NORMAL_WEIGHT = np.float32(NORMAL_WEIGHT)
_ZERO = np.float32(0)


class HitArrays(NamedTuple):
    """Hits of n rays, in the frame of the face they belong to.

    Attributes:
        is_warp: the warp was hit [n].
        is_skipped: no yarn was hit [n].
        normal, tangent: components x, y, z of unit vectors [n] each.
    """

    is_warp: NDArray[np.bool_]
    is_skipped: NDArray[np.bool_]
    normal: tuple[NDArray[np.float32], ...]
    tangent: tuple[NDArray[np.float32], ...]


def hit_arrays(hits: SurfaceHits, is_skipped: NDArray[np.bool_]) -> HitArrays:
    """Hits where NumPy and Numba can read them; waits for the rays."""
    normal, tangent = (tuple(part.numpy() for part in vector) for vector in (hits.normal, hits.tangent))
    return HitArrays(hits.is_warp.numpy(), is_skipped, normal, tangent)


def accumulate_views(hits: HitArrays, groups: Groups) -> tuple[NDArray[np.float32], NDArray[np.int32]]:
    """Sums over the hits of view rays [2 faces, nodes, groups, VIEW_SUMS], and the group of each hit [n].

    The group is −1 where no yarn was hit.
    """
    group_of = np.empty(len(hits.is_warp), np.int32)
    sums = np.zeros((_BLOCKS, groups.count, VIEW_SUMS), np.float32)
    centroids, warp_count = groups.centroids, groups.warp_count

    def accumulate(blocks: range) -> None:
        _accumulate_views(blocks.start, blocks.stop, hits, centroids, warp_count, group_of, sums)

    parallel_map(accumulate, _block_ranges())
    return sums.reshape(2, NODES, groups.count, VIEW_SUMS), group_of


def accumulate_light(
    hits: HitArrays,
    group_of: NDArray[np.int32],
    is_lit: tuple[NDArray[np.bool_], NDArray[np.bool_]],
    groups: Groups,
    diffuse_blend: float,
) -> NDArray[np.float32]:
    """Sums over the shadow rays of each node [2 faces, nodes, groups, LIGHT_SUMS].

    Args:
        hits: of the view rays, which shadow rays start from.
        group_of: of each hit [n]; −1 is none.
        is_lit: whether light from the side of the view, and from the other, reaches the start of each shadow
            ray [n].
        diffuse_blend: w, the weight of the yarn normal in the diffuse term.
    """
    sums = np.zeros((_BLOCKS, groups.count, LIGHT_SUMS), np.float32)
    lights, blend = node_directions().astype(np.float32), np.float32(diffuse_blend)
    rays = len(group_of) // _BLOCKS
    node, ray = np.divmod(np.arange(NODES * rays), rays)
    starts = start_of_shadow_ray(node, ray, rays)

    def accumulate(blocks: range) -> None:
        _accumulate_light(blocks.start, blocks.stop, hits, group_of, starts, *is_lit, lights, blend, sums)

    parallel_map(accumulate, _block_ranges())
    return sums.reshape(2, NODES, groups.count, LIGHT_SUMS)


def _block_ranges() -> list[range]:
    """All blocks as two ranges a core, so that a core delayed by other work delays less."""
    count = 2 * core_count()
    return [range(_BLOCKS * part // count, _BLOCKS * (part + 1) // count) for part in range(count)]


@numba_kernel()
def _assign(
    hits: HitArrays,
    first: int,
    centroids: NDArray[np.float32],
    warp_count: int,
    group_of: NDArray[np.int32],
    least: NDArray[np.float32],
) -> None:
    """Fills `group_of` [n] with the nearest group of hits `first` to `first + n`; −1 where they are skipped.

    Args:
        centroids: of one face [groups, 6], the first `warp_count` of the warp.
        least: scratch memory [n].
    """
    own = slice(first, first + len(group_of))
    is_warp, is_skipped = hits.is_warp[own], hits.is_skipped[own]
    nx, ny, nz = hits.normal[0][own], hits.normal[1][own], hits.normal[2][own]
    tx, ty, tz = hits.tangent[0][own], hits.tangent[1][own], hits.tangent[2][own]
    group_of[:] = -1
    least[:] = np.inf
    for group in range(len(centroids)):
        is_warp_group = group < warp_count
        a, b, c = centroids[group, 0], centroids[group, 1], centroids[group, 2]
        d, e, f = centroids[group, 3], centroids[group, 4], centroids[group, 5]
        # This loop is vectorized: no branch, and contiguous arrays.
        for ray in range(len(group_of)):
            distance = (
                (_NORMAL_WEIGHT * nx[ray] - a) ** 2
                + (_NORMAL_WEIGHT * ny[ray] - b) ** 2
                + (_NORMAL_WEIGHT * nz[ray] - c) ** 2
                + (tx[ray] - d) ** 2
                + (ty[ray] - e) ** 2
                + (tz[ray] - f) ** 2
            )
            is_member = (is_warp[ray] == is_warp_group) & (not is_skipped[ray])
            is_closer = is_member & (distance < least[ray])
            group_of[ray] = group if is_closer else group_of[ray]
            least[ray] = distance if is_closer else least[ray]


@numba_kernel()
def _accumulate_views(
    start: int,
    stop: int,
    hits: HitArrays,
    centroids: NDArray[np.float32],
    warp_count: NDArray[np.intp],
    group_of_hits: NDArray[np.int32],
    sums: NDArray[np.float32],
) -> None:
    """Fills `group_of_hits`; adds hits of blocks `start` to `stop` to sums [blocks, groups, VIEW_SUMS]."""
    # From arrays: Numba would keep constants of other files when they change.
    nodes = len(sums) // 2
    rays = len(hits.is_warp) // len(sums)
    least = np.empty(rays, np.float32)
    nx, ny, nz = hits.normal
    tx, ty, tz = hits.tangent
    for block in range(start, stop):
        first, face = block * rays, block // nodes
        group_of = group_of_hits[first : first + rays]
        _assign(hits, first, centroids[face], warp_count[face], group_of, least)
        for ray in range(rays):
            if group_of[ray] >= 0:
                total = sums[block, group_of[ray]]
                hit = first + ray
                x, y, z = tx[hit], ty[hit], tz[hit]
                total[0] += 1
                total[1] += nx[hit]
                total[2] += ny[hit]
                total[3] += nz[hit]
                total[4] += x
                total[5] += y
                total[6] += z
                total[7] += x * x
                total[8] += x * y
                total[9] += x * z
                total[10] += y * y
                total[11] += y * z
                total[12] += z * z


@numba_kernel()
def _accumulate_light(
    start: int,
    stop: int,
    hits: HitArrays,
    group_of: NDArray[np.int32],
    starts: NDArray[np.intp],
    is_lit: NDArray[np.bool_],
    is_lit_behind: NDArray[np.bool_],
    lights: NDArray[np.float32],
    blend: np.float32,
    sums: NDArray[np.float32],
) -> None:
    """Adds the shadow rays of blocks `start` to `stop` to sums [blocks, groups, LIGHT_SUMS].

    Args:
        starts: index of the hit within its face that each shadow ray of a face starts from [nodes · rays].
        lights: unit vectors by node [nodes, 3].
        blend: w, the weight of the yarn normal in the diffuse term.
    """
    nodes = len(sums) // 2
    rays = len(group_of) // len(sums)
    nx, ny, nz = hits.normal
    for block in range(start, stop):
        face, node = block // nodes, block % nodes
        x, y, z = lights[node]
        for ray in range(rays):
            hit = face * nodes * rays + starts[node * rays + ray]
            if group_of[hit] >= 0:
                total = sums[block, group_of[hit]]
                # Light from the other side comes from (x, y, −z), and lights the side of −n. Factors stand in
                # place of branches, which would be taken at random.
                across, up = nx[hit] * x + ny[hit] * y, nz[hit] * z
                lit = np.float32(is_lit[block * rays + ray])
                lit_behind = np.float32(is_lit_behind[block * rays + ray])
                total[0] += 1
                total[1] += lit
                total[2] += lit_behind
                total[3] += lit * (z + blend * (max(up + across, _ZERO) - z))
                total[4] += lit_behind * (z + blend * (max(up - across, _ZERO) - z))
