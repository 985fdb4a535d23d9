"""What views see of the groups and what light reaches them, measured by rays over the whole repeat.

For every node of the hemisphere:

    seen        share of the view rays through the plane z = 0 that meet the group, walls and all, or a hole
    reached     share of the group's plan that light from there reaches
    irradiance  mean of the blended diffuse term over the group's plan, shadows included, 1/sr

the last two for light on the side that is seen, and for light from the other side, whose shadows are those
of the other face.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import array_types, uploaded
from loomlight.models.lobes.groups import GroupFinder, Groups, places_over
from loomlight.models.lobes.hemisphere import NODES, node_directions
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.visibility import SearchQuality, first_hit, passes_through, unoccluded

# Rays a node and face, at least, and for each group of a family. With four times as many, estimates are
# better by 2 % of their error; 32 groups a family with as few as 8 were worse by 12 %.
_FEWEST_RAYS, _RAYS_PER_GROUP = 256, 32
# Rays through gaps, at most so many a node and face.
_GAP_RAYS = 128
_QUALITY = SearchQuality(steps_per_thread=4, steps_per_relief=4, refinements=4)


@dataclass(frozen=True, eq=False)
class Reach:
    """Means a face, a node and a group; index 0 of `side` is light on the side seen, 1 from the other.

    Attributes:
        seen: [2 faces, nodes, groups + 1], holes last; sums over the last axis are 1.
        reached: [2 faces, 2 sides, nodes, groups], 0 to 1.
        irradiance: [2 faces, 2 sides, nodes, groups], 1/sr, 0 to 1/π.
    """

    seen: NDArray[np.float64]
    reached: NDArray[np.float64]
    irradiance: NDArray[np.float64]


def rays_of(per_family: int) -> int:
    """Rays of each node and face for so many groups of a family."""
    return max(_FEWEST_RAYS, _RAYS_PER_GROUP * per_family)


def measure_reach(geometry: YarnGeometry, groups: Groups, diffuse_blend: float, float_type: type) -> Reach:
    """Casts the rays of both faces and of all nodes.

    Args:
        diffuse_blend: w, the share of the yarn normal in the diffuse term.
    """
    types = array_types(float_type)
    finder = GroupFinder(groups, types)
    rays = rays_of(groups.per_family)
    each = NODES * rays
    places = places_over(geometry, rays, NODES)
    lane = np.arange(2 * each)
    node, back = lane % each // rays, lane >= each
    x, y = (uploaded(types.Float, np.tile(part, 2)) for part in places.reshape(-1, 2).T)
    directions = node_directions().astype(np.float32).T
    towards = types.Vector3(
        *(uploaded(types.Float, np.tile(np.repeat(part, rays), 2)) for part in directions)
    )
    face = uploaded(types.Bool, back)

    def group_at(at_x: Any, at_y: Any, hole: Any) -> tuple[Any, Any]:
        point = geometry.surface(at_x, at_y, face)
        number = finder.group(face, point.is_warp, hole | point.hole, point.normal, point.tangent)
        return number, point

    hit = first_hit(geometry, x, y, towards, face, True, _QUALITY)
    met = dr.select(hit.hole, finder.holes, group_at(hit.x, hit.y, hit.hole)[0])
    lit, point = group_at(x, y, face & False)
    facing = dr.dot(point.normal, towards)
    near = dr.maximum(facing, 0)
    free = unoccluded(geometry, x, y, point.height, towards, face, ~point.hole & (facing > 0), _QUALITY)
    far = geometry.surface(x, y, ~face)
    awake = ~far.hole & (dr.dot(far.normal, towards) > 0)
    beyond = unoccluded(geometry, x, y, far.height, towards, ~face, awake, _QUALITY)
    # The other side's light comes from below: its cosine with the normal is that of (x, y, −z), negated.
    under = dr.maximum(
        -(point.normal.x * towards.x + point.normal.y * towards.y - point.normal.z * towards.z), 0
    )
    blend = float(diffuse_blend)
    irradiance = [
        dr.select(reaches, dr.lerp(towards.z, cosine, blend) * dr.inv_pi, 0)
        for reaches, cosine in ((free, near), (beyond, under))
    ]
    dr.eval(met, lit, free, beyond, irradiance)
    return _means(
        groups.count,
        _passing(geometry, groups, float_type),
        back * NODES + node,
        met.numpy(),
        lit.numpy(),
        [free.numpy(), beyond.numpy()],
        [part.numpy() for part in irradiance],
    )


def _passing(geometry: YarnGeometry, groups: Groups, float_type: type) -> NDArray[np.float64]:
    """Share of view rays that pass through the cloth [2 faces, nodes], from rays through its gaps alone.

    Gaps are a few per cent of the cloth, so rays over all of it would know them by a handful of hits.
    """
    types = array_types(float_type)
    gaps = groups.gaps[:: max(1, len(groups.gaps) // _GAP_RAYS)][:_GAP_RAYS]
    if not len(gaps):
        return np.zeros((2, NODES))
    count = 2 * NODES * len(gaps)
    x, y = (uploaded(types.Float, np.tile(part, 2 * NODES)) for part in gaps.T)
    directions = np.tile(np.repeat(node_directions(), len(gaps), axis=0), (2, 1)).astype(np.float32)
    towards = types.Vector3(*(uploaded(types.Float, part) for part in directions.T))
    face = uploaded(types.Bool, np.arange(count) >= count // 2)
    passes = passes_through(geometry, x, y, towards, face, True, _QUALITY)
    return groups.hole[:, None] * passes.numpy().reshape(2, NODES, len(gaps)).mean(axis=2)


def _means(
    count: int,
    passing: NDArray[np.float64],
    row: NDArray[np.intp],
    met: NDArray[np.uint32],
    lit: NDArray[np.uint32],
    reached: list[NDArray[np.bool_]],
    irradiance: list[NDArray[np.float32]],
) -> Reach:
    """Means by row (face and node) and group."""
    size = 2 * NODES * (count + 1)

    def sums(group: NDArray[np.uint32], values: NDArray[Any] | None) -> NDArray[np.float64]:
        total = np.bincount(row * (count + 1) + group, values, minlength=size)
        return total.astype(np.float64).reshape(2, NODES, count + 1)

    points = np.maximum(sums(lit, None)[..., :count], 1)
    hits = sums(met, None)[..., :count]
    # Rays that meet yarn are all that do not pass.
    met_yarn = hits.sum(axis=2)
    passing = np.where(met_yarn > 0, passing, 1)
    shares = hits * ((1 - passing) / np.maximum(met_yarn, 1))[..., None]
    return Reach(
        np.concatenate([shares, passing[..., None]], axis=2),
        np.stack([sums(lit, part)[..., :count] / points for part in reached], axis=1),
        np.stack([sums(lit, part)[..., :count] / points for part in irradiance], axis=1),
    )
