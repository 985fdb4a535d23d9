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

from loomlight.core.backend import array_types, larger, uploaded
from loomlight.core.recorded import Held, Recorded
from loomlight.models.lobes.divider import Divider
from loomlight.models.lobes.groups import (
    SUMS,
    Cloth,
    FacePoints,
    GroupFinder,
    Groups,
    PlanPoints,
    as_met,
    sums_of,
)
from loomlight.models.lobes.hemisphere import AZIMUTHS, NODES, RINGS, node_directions
from loomlight.yarn.visibility import SearchQuality, first_hit, passes_through, unoccluded

# Rays a node and face, at least, and for each group of a family. With four times as many, estimates are
# better by 2 % of their error; 32 groups a family with as few as 8 were worse by 12 %.
_FEWEST_RAYS, _RAYS_PER_GROUP = 256, 32
# Rays through gaps, at most so many a node and face.
_GAP_RAYS = 128
# Rays of each node and face that groups are learnt from.
_FIRST_RAYS = 32
# Moments are those of every so many views.
_MOMENTS_FROM = 4
# Of a diffuse term, as a whole number: sums of 2¹⁶ of them stay below 2³².
_UNITS = 1 << 15
# Finer steps gain nothing in the query test; without refinement hits cost 6 % of its error.
_QUALITY = SearchQuality(steps_per_thread=2.5, steps_per_relief=2.5, shadow_share=0.95, refinements=1)


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
class Met:
    """Yarn points in the frame of a face; lanes are faces, then nodes, then rays.

    Attributes:
        is_warp, hole: Bool.
        normal, tangent: unit vectors [3].
    """

    is_warp: Any
    hole: Any
    normal: Any
    tangent: Any


@dataclass
class CastRays:
    """What rays met, before groups are known. Work may go on.

    Attributes:
        rays: of each node and face.
        hits: what views meet, but for those that pass through the cloth.
        pass_cloth: which views do: Bool; None where none can.
        points: the plan points that light goes to.
        towards: unit vectors [3] to the light.
        free: light reaches the point: Bool.
        passes: views through gaps that pass through the cloth, of the front's nodes: Bool; None without gaps.
    """

    rays: int
    hits: Met
    pass_cloth: Any | None
    points: Met
    towards: Any
    free: Any
    passes: Any | None


def first_looks(cloth: Held[Cloth]) -> Met:
    """What a few views from every node meet; does not wait for it."""
    return _first_looks(cloth, _directions(cloth))


@Recorded
def _first_looks(cloth: Cloth, directions: Any) -> Met:
    lane = dr.arange(cloth.types.UInt32, 2 * NODES * _FIRST_RAYS)
    back, x, y, view = _rays(cloth, directions, _FIRST_RAYS, lane)
    hit = first_hit(cloth.geometry, x, y, view, back, True, _QUALITY)
    met = cloth.geometry.surface(hit.x, hit.y, back)
    return Met(met.is_warp, hit.hole | met.hole, met.normal, met.tangent)


def seen_points(met: Met) -> FacePoints:
    """What `first_looks` found."""
    normal, tangent = (part.numpy().T.astype(np.float64) for part in (met.normal, met.tangent))
    back = np.arange(len(normal)) >= len(normal) // 2
    return FacePoints(back, met.is_warp.numpy(), met.hole.numpy(), normal, tangent)


def _directions(cloth: Held[Cloth]) -> Any:
    """Unit vectors of all nodes, uploaded: Float [4 NODES]."""
    rows = np.pad(node_directions(), ((0, 0), (0, 1))).astype(np.float32)
    return uploaded(cloth.value.types.Float, rows)


def cast_rays(cloth: Held[Cloth], points: PlanPoints, per_family: int) -> CastRays:
    """Casts the rays of both faces and of all nodes to eye and light, and does not wait for them.

    Args:
        points: of the plan, whose gaps rays go through.
        per_family: groups of each family that rays shall tell of, on average.
    """
    Float, UInt32 = cloth.value.types.Float, cloth.value.types.UInt32
    rays = rays_of(per_family)
    # Few views start in gaps, but one among every sixteen that are followed at once: apart they take less.
    from_gaps = np.flatnonzero(_start_in_gaps(cloth, rays).numpy())
    lanes = uploaded(UInt32, from_gaps.astype(np.uint32))
    directions = _directions(cloth)
    # Gaps are a few per cent of the cloth, so rays over all of it would know them by a handful of hits.
    gaps = points.gaps[:: max(1, len(points.gaps) // _GAP_RAYS)][:_GAP_RAYS]
    starts = uploaded(Float, gaps)
    lit, towards, free = _to_lights(cloth, directions, rays)
    passes = _through_gaps(cloth, directions, starts, len(gaps)) if len(gaps) else None
    hits, below = _to_eyes(cloth, directions, rays)
    pass_cloth = _pass(cloth, directions, rays, lanes, below) if len(from_gaps) else None
    return CastRays(rays, hits, pass_cloth, lit, towards, free, passes)


@Recorded
def _start_in_gaps(cloth: Cloth, rays: int) -> Any:
    """Which views go through the plane z = 0 where no yarn is."""
    back, x, y = _places(cloth, rays, dr.arange(cloth.types.UInt32, 2 * NODES * rays))[:3]
    return cloth.geometry.height(x, y, back)[1]


@Recorded
def _to_lights(cloth: Cloth, directions: Any, rays: int) -> tuple[Met, Any, Any]:
    """Plan points, the directions of lights, and whether these reach them."""
    back, x, y, towards = _rays(cloth, directions, rays, dr.arange(cloth.types.UInt32, 2 * NODES * rays))
    point = cloth.geometry.surface(x, y, back)
    awake = ~point.hole & (dr.dot(point.normal, towards) > 0)
    free = unoccluded(cloth.geometry, x, y, point.height, towards, back, awake, _QUALITY)
    return Met(point.is_warp, point.hole, point.normal, point.tangent), towards, free


@Recorded
def _to_eyes(cloth: Cloth, directions: Any, rays: int) -> tuple[Met, Any]:
    """What views meet that do not pass through, and whether it lies below the plane."""
    back, x, y, view = _rays(cloth, directions, rays, dr.arange(cloth.types.UInt32, 2 * NODES * rays))
    hit = first_hit(cloth.geometry, x, y, view, back, True, _QUALITY, passing=False)
    met = cloth.geometry.surface(hit.x, hit.y, back)
    return Met(met.is_warp, met.hole, met.normal, met.tangent), hit.height <= 0


@Recorded
def _pass(cloth: Cloth, directions: Any, rays: int, lanes: Any, below: Any) -> Any:
    """Which views pass through the cloth, of which none but some lanes may: Bool of all."""
    back, x, y, view = _rays(cloth, directions, rays, lanes)
    # What has met yarn above the plane does not pass it.
    active = dr.gather(cloth.types.Bool, below, lanes)
    found = dr.zeros(cloth.types.Bool, 2 * NODES * rays)
    dr.scatter(found, passes_through(cloth.geometry, x, y, view, back, active, _QUALITY), lanes)
    return found


def _rays(cloth: Cloth, directions: Any, rays: int, lane: Any) -> tuple[Any, Any, Any, Any]:
    """Rays of both faces and of all nodes, so many each: back, x, y, direction."""
    back, x, y, node = _places(cloth, rays, lane)
    return back, x, y, _direction(cloth, directions, node)


def _places(cloth: Cloth, rays: int, lane: Any) -> tuple[Any, Any, Any, Any]:
    """Where they go through the plane: back, x, y, node."""
    UInt32 = cloth.types.UInt32
    each = dr.opaque(UInt32, NODES * rays)
    back = lane >= each
    node, ray = Divider(rays, cloth.types).divide(dr.select(back, lane - each, lane))
    return back, *cloth.places.over(ray, node), node


def _direction(cloth: Cloth, directions: Any, node: Any) -> Any:
    """Unit vector [3] of a node."""
    found = dr.gather(cloth.types.Vector4, directions, node)
    return cloth.types.Vector3(found.x, found.y, found.z)


@Recorded
def _through_gaps(cloth: Cloth, directions: Any, starts: Any, count: int) -> Any:
    """Which view rays through so many places pass through the cloth."""
    types = cloth.types
    lane = dr.arange(types.UInt32, NODES * count)
    node, ray = Divider(count, types).divide(lane)
    x, y = dr.gather(types.Vector2, starts, ray)
    towards = _direction(cloth, directions, node)
    return passes_through(cloth.geometry, x, y, towards, lane < 0, True, _QUALITY)


@dataclass
class SortedRays:
    """What rays met, added up by group. Work may go on.

    Attributes:
        rays: what was cast.
        groups: the groups.
        views: that meet a group: UInt32 [2 faces, nodes, groups].
        moments: of what every so many views meet, as whole numbers: UInt32 [2 faces, groups, SUMS].
        points: of plan points, how many there are and, 16 bits above, how many light from the side seen
            reaches; how many that from the other side does; and π times the diffuse terms of either, in units
            of 1/_UNITS: UInt32 [2 faces, nodes, groups, 4].
    """

    rays: CastRays
    groups: Groups
    views: Any
    moments: Any
    points: Any


def sort_rays(rays: CastRays, groups: Groups, finder: Held[GroupFinder], diffuse_blend: float) -> SortedRays:
    """Finds the groups of what rays met, and does not wait for it.

    Args:
        diffuse_blend: w, the share of the yarn normal in the diffuse term.
    """
    blend = dr.opaque(dr.value_t(type(rays.towards)), float(diffuse_blend))
    passing = [] if rays.pass_cloth is None else [rays.pass_cloth]
    views, moments = _seen_sums(finder, rays.hits, passing, rays.rays, groups.count)
    points = _lit_sums(finder, rays.points, rays.towards, rays.free, blend, rays.rays, groups.count)
    return SortedRays(rays, groups, views, moments, points)


@Recorded
def _seen_sums(finder: GroupFinder, met: Met, passing: list[Any], rays: int, groups: int) -> tuple[Any, Any]:
    """Numbers of views, and moments.

    Args:
        passing: which views pass through the cloth, if any do.
    """
    types = array_types(met.normal)
    found = _sorted(finder, met, rays, groups)
    known = ~met.hole
    for passes in passing:
        known &= ~passes
    views = dr.zeros(types.UInt32, 2 * NODES * groups)
    dr.scatter_add(views, types.UInt32(1), found.bins, known)
    moments = dr.zeros(types.UInt32, 2 * groups * SUMS)
    place = SUMS * dr.select(found.back, found.group + dr.opaque(types.UInt32, groups), found.group)
    counts = known & (found.lane % _MOMENTS_FROM == 0)
    dr.scatter_add(moments, types.UInt32(1), place, counts)
    for number, value in enumerate(sums_of(met.normal, met.tangent), 1):
        # Of both signs: whole numbers wrap around as they add up.
        whole = types.Int32(dr.round(value * _moment_units(rays)))
        dr.scatter_add(moments, types.UInt32(whole), place + number, counts)
    return views, moments


def _moment_units(rays: int) -> int:
    """What whole numbers of moments count in, so that sums over all views of a face stay below 2³¹."""
    return (1 << 30) // (NODES * rays // _MOMENTS_FROM)


@Recorded
def _lit_sums(
    finder: GroupFinder, met: Met, towards: Any, free: Any, blend: Any, rays: int, groups: int
) -> Any:
    """Sums over plan points."""
    types = array_types(towards)
    found = _sorted(finder, met, rays, groups)
    # The other side's light comes from below: its cosine with the normal is that of (x, y, −z), negated. It
    # falls on the other face, whose rays start at the same places.
    other = dr.select(found.back, found.lane - found.half, found.lane + found.half)
    normal = met.normal
    across = normal.x * towards.x + normal.y * towards.y
    cosines = normal.z * towards.z + across, normal.z * towards.z - across
    reaches = free, dr.gather(types.Bool, free, other)
    terms = (
        dr.select(frees, types.UInt32(dr.lerp(towards.z, larger(cosine, 0), blend) * _UNITS + 0.5), 0)
        for frees, cosine in zip(reaches, cosines, strict=True)
    )
    numbers = 1 + (types.UInt32(reaches[0]) << 16), types.UInt32(reaches[1]), *terms
    sums = dr.zeros(types.UInt32, len(numbers) * 2 * NODES * groups)
    for place, number in enumerate(numbers):
        dr.scatter_add(sums, number, len(numbers) * found.bins + place, ~met.hole)
    return sums


@dataclass
class _Sorted:
    """Rays by group.

    Attributes:
        lane, half: UInt32; from lane `half` on rays are those of the back, where `back` is true.
        group: of the face.
        bins: a face, a node and a group have one.
    """

    lane: Any
    half: Any
    back: Any
    group: Any
    bins: Any


def _sorted(finder: GroupFinder, met: Met, rays: int, groups: int) -> _Sorted:
    types = array_types(met.normal)
    lane = dr.arange(types.UInt32, 2 * NODES * rays)
    half, row = (dr.opaque(types.UInt32, count) for count in (NODES * rays, groups))
    back = lane >= half
    group = finder.group(back, met.is_warp, met.hole, met.normal, met.tangent)
    return _Sorted(lane, half, back, group, Divider(rays, types).divide(lane)[0] * row + group)


def measure_reach(found: SortedRays) -> Reach:
    """Means by face, node and group of what the rays met."""
    shape = 2, NODES, found.groups.count
    hits = found.views.numpy().reshape(shape)
    # Rays that meet yarn are all that do not pass.
    met_yarn = hits.sum(axis=2)
    passes = found.rays.passes
    passing = np.zeros((2, NODES)) if passes is None else _both_faces(passes.numpy())
    passing = np.where(met_yarn > 0, found.groups.hole[:, None] * passing, 1)
    shares = hits * ((1 - passing) / np.maximum(met_yarn, 1))[..., None]
    first, beyond, *terms = np.moveaxis(found.points.numpy().reshape(*shape, 4), -1, 0)
    free, points = first >> 16, np.maximum(first & 0xFFFF, 1)
    return Reach(
        np.concatenate([shares, passing[..., None]], axis=2),
        np.stack([free / points, beyond / points], axis=1),
        np.stack([term * (1 / (_UNITS * math.pi)) / points for term in terms], axis=1),
    )


def groups_met(found: SortedRays) -> Groups:
    """The groups with moments of what views from all sides meet."""
    sums = found.moments.numpy().view(np.int32).reshape(2, found.groups.count, SUMS).astype(np.float64)
    sums[..., 1:] *= 1 / _moment_units(found.rays.rays)
    return as_met(found.groups, sums)


def _both_faces(passes: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Share of rays through gaps that pass [2 faces, nodes] of those of the front.

    A line that passes is seen from the other face from the opposite azimuth.
    """
    front = passes.reshape(AZIMUTHS, RINGS, -1).mean(axis=2)
    return np.stack([front, np.roll(front, AZIMUTHS // 2, axis=0)]).reshape(2, NODES)
