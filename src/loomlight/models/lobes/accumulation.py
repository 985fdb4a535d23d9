"""Sums over ray hits by face, node of the hemisphere and group.

Hits are in the order of `visibility_rays`: by face, then node, then ray. The rays of one node on one face are
a block, whose sums are a product of matrices: rays that hit each group, times terms of rays.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Mask
from loomlight.core.backend import array_types
from loomlight.models.lobes.groups import Groups, NearestGroup
from loomlight.models.lobes.hemisphere import NODES, node_directions
from loomlight.models.lobes.visibility_rays import SurfaceHits, start_of_shadow_ray

# Sums over the views that hit a group: 1, normal, fibre direction t, and t tᵀ as xx, xy, xz, yy, yz, zz.
VIEW_SUMS = 13
# Sums over the hits of a group that shadow rays start from: 1; visibility of light on the side seen, and on
# the other side; the blended diffuse term times π under either light.
LIGHT_SUMS = 5
_BLOCKS = 2 * NODES

Vectors = Sequence[NDArray[np.float32]]


def group_of_hits(hits: SurfaceHits, is_skipped: Mask, groups: Groups) -> NDArray[np.uint32]:
    """Group of each hit [n], 2 K where it is skipped; waits for the rays."""
    types, count = array_types(hits.normal.x), dr.width(hits.normal)
    back = dr.arange(types.UInt32, count) >= count // 2
    nearest = NearestGroup(groups, types)
    found = nearest.find(back, replace(hits, hole=is_skipped))
    return np.asarray(found.numpy())


def view_sums(
    normal: Vectors, tangent: Vectors, group_of: NDArray[np.uint32], groups: int
) -> NDArray[np.float32]:
    """Sums over the hits of view rays [2 faces, nodes, groups, VIEW_SUMS].

    Args:
        normal, tangent: components x, y, z of the hits' unit vectors [n] each.
        group_of: of each hit [n]; from `groups` on it is none.
    """
    x, y, z = tangent
    products = x * x, x * y, x * z, y * y, y * z, z * z
    return _sums(group_of, np.stack([np.ones_like(x), *normal, *tangent, *products]), groups)


def light_sums(
    normal: Vectors,
    group_of: NDArray[np.uint32],
    is_lit: tuple[NDArray[np.bool_], NDArray[np.bool_]],
    groups: int,
    diffuse_blend: float,
) -> NDArray[np.float32]:
    """Sums over the shadow rays of each node [2 faces, nodes, groups, LIGHT_SUMS].

    Args:
        normal, group_of: of the hits of view rays, which shadow rays start from; see `view_sums`.
        is_lit: whether light from the side of the view, and from the other, reaches the start of each shadow
            ray [n].
        diffuse_blend: w, the weight of the yarn normal in the diffuse term.
    """
    rays = len(group_of) // _BLOCKS
    node, ray = np.divmod(np.arange(NODES * rays), rays)
    starts = start_of_shadow_ray(node, ray, rays)
    hit = np.concatenate([starts, NODES * rays + starts])
    light_x, light_y, light_z = np.tile(np.repeat(node_directions().T.astype(np.float32), rays, axis=1), 2)
    # Light from the other side comes from (x, y, −z), and lights the side of −n.
    across = normal[0][hit] * light_x + normal[1][hit] * light_y
    up = normal[2][hit] * light_z
    terms = np.ones((LIGHT_SUMS, len(hit)), np.float32)
    for side, cosine in enumerate((up + across, up - across)):
        terms[1 + side] = is_lit[side]
        diffuse = light_z + np.float32(diffuse_blend) * (np.maximum(cosine, 0) - light_z)
        terms[3 + side] = is_lit[side] * diffuse
    return _sums(group_of[hit], terms, groups)


def _sums(group_of: NDArray[np.uint32], terms: NDArray[np.float32], groups: int) -> NDArray[np.float32]:
    """Sums of terms [k, n] by face, node and group [2, NODES, groups, k]."""
    is_member = (np.arange(groups, dtype=np.uint32)[:, None] == group_of).astype(np.float32)
    by_block = is_member.reshape(groups, _BLOCKS, -1).transpose(1, 0, 2)
    sums = by_block @ terms.reshape(len(terms), _BLOCKS, -1).transpose(1, 2, 0)
    return sums.reshape(2, NODES, groups, -1)
