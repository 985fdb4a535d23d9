"""What views see of the groups and what light reaches them, measured by rays over the whole repeat.

For every node of the hemisphere:

    seen        share of the view rays through the plane z = 0 that meet the group, walls and all, or a hole
    reached     share of the group's plan that light from there reaches
    irradiance  mean of the blended diffuse term over the group's plan, shadows included, 1/sr

the last two for light on the side that is seen, and for light from the other side, whose shadows are those
of the other face.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import ArrayTypes, array_types, uploaded
from loomlight.models.lobes.groups import GroupFinder, Groups, PlanPoints, places_over
from loomlight.models.lobes.hemisphere import AZIMUTHS, NODES, RINGS, node_directions
from loomlight.yarn.geometry import SurfacePoint, YarnGeometry
from loomlight.yarn.visibility import SearchQuality, first_hit, passes_through, unoccluded

# Rays a node and face, at least, and for each group of a family. With four times as many, estimates are
# better by 2 % of their error; 32 groups a family with as few as 8 were worse by 12 %.
_FEWEST_RAYS, _RAYS_PER_GROUP = 256, 32
# Rays through gaps, at most so many a node and face.
_GAP_RAYS = 128
# Of a diffuse term, as a whole number: sums of 2¹⁶ of them stay below 2³².
_UNITS = 1 << 15
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


@dataclass
class CastRays:
    """What rays met, before groups are known; lanes are faces, then nodes, then rays. Work may go on.

    Attributes:
        hits: the yarn points that views meet.
        nothing: views that meet none: Bool.
        points: the plan points that light goes to.
        towards: unit vectors [3] to eye and light.
        free: light reaches the point: Bool.
        passes: views through gaps that pass through the cloth, of the front's nodes: Bool; None without gaps.
    """

    hits: SurfacePoint
    nothing: Any
    points: SurfacePoint
    towards: Any
    free: Any
    passes: Any | None


def cast_rays(geometry: YarnGeometry, points: PlanPoints, per_family: int, float_type: type) -> CastRays:
    """Casts the rays of both faces and of all nodes to eye and light, and does not wait for them.

    Args:
        points: of the plan, whose gaps rays go through.
        per_family: groups of each family that rays shall tell of.
    """
    types = array_types(float_type)
    directions = uploaded(types.Float, np.pad(node_directions(), ((0, 0), (0, 1))).astype(np.float32))
    back, x, y, towards = _rays(geometry, directions, rays_of(per_family), types)
    point = geometry.surface(x, y, back)
    awake = ~point.hole & (dr.dot(point.normal, towards) > 0)
    free = unoccluded(geometry, x, y, point.height, towards, back, awake, _QUALITY)
    dr.eval(free, towards, point.is_warp, point.hole, point.normal, point.tangent)
    passes = _passing(geometry, points.gaps, directions, types)
    back, x, y, view = _rays(geometry, directions, rays_of(per_family), types)
    hit = first_hit(geometry, x, y, view, back, True, _QUALITY)
    met = geometry.surface(hit.x, hit.y, back)
    nothing = hit.hole | met.hole
    dr.eval(nothing, met.is_warp, met.normal, met.tangent)
    return CastRays(met, nothing, point, towards, free, passes)


def _rays(geometry: YarnGeometry, directions: Any, rays: int, types: ArrayTypes) -> tuple[Any, Any, Any, Any]:
    """So many rays of both faces and of all nodes: back, x, y, direction."""
    each, of_node = (dr.opaque(types.UInt32, count) for count in (NODES * rays, rays))
    lane = dr.arange(types.UInt32, 2 * NODES * rays)
    back = lane >= each
    lane = dr.select(back, lane - each, lane)
    node = lane // of_node
    return back, *places_over(geometry, lane - node * of_node, node), _direction(types, directions, node)


def _direction(types: ArrayTypes, directions: Any, node: Any) -> Any:
    """Unit vector [3] of a node."""
    found = dr.gather(types.Vector4, directions, node)
    return types.Vector3(found.x, found.y, found.z)


def _passing(geometry: YarnGeometry, gaps: NDArray[np.float32], directions: Any, types: ArrayTypes) -> Any:
    """Which view rays pass through the cloth, from rays through its gaps alone; None without gaps.

    Gaps are a few per cent of the cloth, so rays over all of it would know them by a handful of hits.
    """
    gaps = gaps[:: max(1, len(gaps) // _GAP_RAYS)][:_GAP_RAYS]
    if not len(gaps):
        return None
    x, y = (uploaded(types.Float, part) for part in gaps.T)
    each = dr.opaque(types.UInt32, len(gaps))
    lane = dr.arange(types.UInt32, NODES * len(gaps))
    node = lane // each
    number = lane - node * each
    x, y = (dr.gather(types.Float, part, number) for part in (x, y))
    towards = _direction(types, directions, node)
    passes = passes_through(geometry, x, y, towards, lane < 0, True, _QUALITY)
    dr.eval(passes)
    return passes


def measure_reach(rays: CastRays, groups: Groups, diffuse_blend: float) -> Reach:
    """Means by face, node and group of what the rays met.

    Args:
        diffuse_blend: w, the share of the yarn normal in the diffuse term.
    """
    hits, points, free, beyond, *terms = _sums(rays, groups, diffuse_blend)
    # Rays that meet yarn are all that do not pass.
    met_yarn = hits.sum(axis=2)
    passing = np.zeros((2, NODES)) if rays.passes is None else _both_faces(rays.passes.numpy())
    passing = np.where(met_yarn > 0, groups.hole[:, None] * passing, 1)
    shares = hits * ((1 - passing) / np.maximum(met_yarn, 1))[..., None]
    points = np.maximum(points, 1)
    return Reach(
        np.concatenate([shares, passing[..., None]], axis=2),
        np.stack([free / points, beyond / points], axis=1),
        np.stack([term * (1 / (_UNITS * math.pi)) / points for term in terms], axis=1),
    )


def _sums(rays: CastRays, groups: Groups, diffuse_blend: float) -> NDArray[np.float64]:
    """Sums [6, 2 faces, nodes, groups].

    Of views that meet a group, points of its plan, those that light from either side reaches, and the
    diffuse terms of these, π times and in units of 1/_UNITS: whole numbers, whose sums do not depend on the
    order in which threads add them.
    """
    types = array_types(rays.towards)
    UInt32 = types.UInt32
    finder = GroupFinder(groups, types)
    size = 2 * NODES * groups.count
    totals = dr.zeros(UInt32, 6 * size)
    stride, per_row = (dr.opaque(UInt32, count) for count in (size, groups.count))

    def bins(point: SurfacePoint, hole: Any) -> tuple[Any, Any, Any]:
        lanes = dr.width(hole)
        lane = dr.arange(UInt32, lanes)
        half, of_row = (dr.opaque(UInt32, count) for count in (lanes // 2, lanes // (2 * NODES)))
        group = finder.group(lane >= half, point.is_warp, hole, point.normal, point.tangent)
        other = dr.select(lane >= half, lane - half, lane + half)
        return (lane // of_row) * per_row + group, ~hole, other

    def add(number: int, values: Any, place: Any, active: Any) -> None:
        dr.scatter_add(totals, UInt32(values), stride * number + place, active)

    place, shows, _ = bins(rays.hits, rays.nothing)
    add(0, 1, place, shows)
    place, shows, other = bins(rays.points, rays.points.hole)
    add(1, 1, place, shows)
    normal, towards = rays.points.normal, rays.towards
    # The other side's light comes from below: its cosine with the normal is that of (x, y, −z), negated. It
    # falls on the other face, whose rays start at the same places.
    across = normal.x * towards.x + normal.y * towards.y
    cosines = normal.z * towards.z + across, normal.z * towards.z - across
    blend = dr.opaque(types.Float, float(diffuse_blend))
    for side, free in enumerate((rays.free, dr.gather(types.Bool, rays.free, other))):
        term = dr.lerp(towards.z, dr.maximum(cosines[side], 0), blend)
        add(2 + side, 1, place, shows & free)
        add(4 + side, term * _UNITS + 0.5, place, shows & free)
    return np.asarray(totals.numpy(), np.float64).reshape(6, 2, NODES, groups.count)


def _both_faces(passes: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Share of rays through gaps that pass [2 faces, nodes] of those of the front.

    A line that passes is seen from the other face from the opposite azimuth.
    """
    front = passes.reshape(AZIMUTHS, RINGS, -1).mean(axis=2)
    return np.stack([front, np.roll(front, AZIMUTHS // 2, axis=0)]).reshape(2, NODES)
