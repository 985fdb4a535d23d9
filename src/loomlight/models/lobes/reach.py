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
from functools import cache
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import upload
from loomlight.core.frozen import FrozenArg, FrozenFunction
from loomlight.core.machine_code import MachineCode, vectors
from loomlight.models.lobes.divider import Divider
from loomlight.models.lobes.groups import SUMS, Cloth, FacePoints, Groups, PlanPoints, as_met
from loomlight.models.lobes.hemisphere import AZIMUTHS, NODES, RINGS, node_directions
from loomlight.models.lobes.parting_code import FEATURES
from loomlight.models.lobes.sorting_code import CENTRE, DIRECTION, LIT_SUMS, ROW, lit_code, seen_code
from loomlight.yarn.search import SearchQuality
from loomlight.yarn.visibility import first_hit, passes_through, unoccluded

# Rays a node and face, at least, and for each group of a family. With four times as many, estimates are
# better by 2 % of their error; 32 groups a family with as few as 8 were worse by 12 %.
_FEWEST_RAYS, _RAYS_PER_GROUP = 256, 32
# Rays through gaps, at most so many a node and face.
_GAP_RAYS = 128
# Views of each node and face that groups are learnt from.
_LEARNT_RAYS = 32
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
class CastViews:
    """What views from every node meet, before groups are known. Work may go on.

    Attributes:
        rays: of each node and face.
        directions: unit vectors of all nodes, uploaded: Float [4 NODES].
        hits: what is met, whatever of those that pass through the cloth.
        below: that lies below the plane z = 0: Bool.
        in_gaps: no yarn is where the view goes through that plane: Bool.
    """

    rays: int
    directions: Any
    hits: Met
    below: Any
    in_gaps: Any


@dataclass
class CastRays:
    """What rays met, before groups are known. Work may go on.

    Attributes:
        views: what views meet.
        pass_cloth: which of these pass through the cloth: Bool; None where none can.
        points: the plan points that light goes to.
        free: light reaches the point: Bool.
        passes: views through gaps that pass through the cloth, of the front's nodes: Bool; None without gaps.
    """

    views: CastViews
    pass_cloth: Any | None
    points: Met
    free: Any
    passes: Any | None


def cast_views(cloth: FrozenArg[Cloth], per_family: int) -> CastViews:
    """Casts the view rays of both faces and of all nodes, and does not wait for them.

    Args:
        per_family: groups of each family that rays shall tell of, on average.
    """
    rays = rays_of(per_family)
    rows = np.pad(node_directions(), ((0, 0), (0, 1))).astype(np.float32)
    directions = upload(cloth.value.types.Float, rows)
    hits, below = _to_eyes(cloth, directions, rays)
    return CastViews(rays, directions, hits, below, _start_in_gaps(cloth, rays))


def seen_points(views: CastViews) -> FacePoints:
    """What a few views from every node meet; those that may pass through a gap count as holes."""

    def some(values: Any) -> NDArray[Any]:
        return np.asarray(values.numpy().reshape(2 * NODES, views.rays)[:, :_LEARNT_RAYS].ravel())

    hits = views.hits
    hole = some(hits.hole) | (some(views.below) & some(views.in_gaps))
    back = np.arange(len(hole)) >= len(hole) // 2
    normal, tangent = (np.stack([some(part) for part in vector]) for vector in (hits.normal, hits.tangent))
    return FacePoints(back, some(hits.is_warp), hole, normal, tangent)


def cast_rays(cloth: FrozenArg[Cloth], points: PlanPoints, views: CastViews) -> CastRays:
    """Casts rays to light and through gaps, and does not wait for them.

    Args:
        points: of the plan, whose gaps rays go through.
    """
    Float, UInt32 = cloth.value.types.Float, cloth.value.types.UInt32
    rays, directions = views.rays, views.directions
    # Few views start in gaps, but one among every sixteen that are followed at once: apart they take less.
    from_gaps = np.flatnonzero(views.in_gaps.numpy())
    # Gaps are a few per cent of the cloth, so rays over all of it would know them by a handful of hits.
    gaps = points.gaps[:: max(1, len(points.gaps) // _GAP_RAYS)][:_GAP_RAYS]
    # Uploads wait for work that goes on.
    lanes, starts = upload(UInt32, from_gaps.astype(np.uint32)), upload(Float, gaps)
    lit, free = _to_lights(cloth, directions, rays)
    passes = _through_gaps(cloth, directions, starts, len(gaps)) if len(gaps) else None
    pass_cloth = _pass(cloth, directions, rays, lanes, views.below) if len(from_gaps) else None
    return CastRays(views, pass_cloth, lit, free, passes)


@FrozenFunction
def _start_in_gaps(cloth: Cloth, rays: int) -> Any:
    """Which views go through the plane z = 0 where no yarn is."""
    back, x, y = _places(cloth, rays, dr.arange(cloth.types.UInt32, 2 * NODES * rays))[:3]
    return cloth.geometry.height(x, y, back)[1]


@FrozenFunction
def _to_lights(cloth: Cloth, directions: Any, rays: int) -> tuple[Met, Any]:
    """Plan points, and whether light reaches them."""
    back, x, y, towards = _rays(cloth, directions, rays, dr.arange(cloth.types.UInt32, 2 * NODES * rays))
    point = cloth.geometry.surface(x, y, back)
    awake = ~point.hole & (dr.dot(point.normal, towards) > 0)
    free = unoccluded(cloth.geometry, x, y, point.height, towards, back, awake, _QUALITY)
    return Met(point.is_warp, point.hole, point.normal, point.tangent), free


@FrozenFunction
def _to_eyes(cloth: Cloth, directions: Any, rays: int) -> tuple[Met, Any]:
    """What views meet that do not pass through, and whether it lies below the plane."""
    back, x, y, view = _rays(cloth, directions, rays, dr.arange(cloth.types.UInt32, 2 * NODES * rays))
    hit = first_hit(cloth.geometry, x, y, view, back, True, _QUALITY, passing=False)
    met = cloth.geometry.surface(hit.x, hit.y, back)
    return Met(met.is_warp, met.hole, met.normal, met.tangent), hit.height <= 0


@FrozenFunction
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


@FrozenFunction
def _through_gaps(cloth: Cloth, directions: Any, starts: Any, count: int) -> Any:
    """Which view rays through so many places pass through the cloth."""
    types = cloth.types
    lane = dr.arange(types.UInt32, NODES * count)
    node, ray = Divider(count, types).divide(lane)
    x, y = dr.gather(types.Vector2, starts, ray)
    towards = _direction(cloth, directions, node)
    return passes_through(cloth.geometry, x, y, towards, lane < 0, True, _QUALITY)


@dataclass(frozen=True, eq=False)
class SortedRays:
    """What rays met, added up by group.

    Attributes:
        rays: what was cast.
        groups: the groups.
        views: sums of what views meet, see `sums_of` [2 faces, nodes, groups, SUMS].
        points: of plan points, see `LIT_SUMS` [2 faces, nodes, groups, 5].
    """

    rays: CastRays
    groups: Groups
    views: NDArray[np.float32]
    points: NDArray[np.float32]


def sort_rays(rays: CastRays, groups: Groups, diffuse_blend: float) -> SortedRays:
    """Finds the groups of what rays met, which it waits for.

    Args:
        diffuse_blend: w, the share of the yarn normal in the diffuse term.
    """
    centres = np.zeros((2, groups.count, CENTRE), np.float32)
    centres[..., :FEATURES] = groups.centres
    centres[..., FEATURES] = np.arange(groups.count) < groups.of_warp[:, None]
    directions = np.zeros((NODES, DIRECTION), np.float32)
    directions[:, :3] = node_directions()
    shared = [centres, directions, np.array([groups.count, diffuse_blend], np.float32)]
    lit = [*_numbers_of(rays.points), rays.free.numpy().astype(np.float32)]
    seen = _numbers_of(rays.views.hits)
    if rays.pass_cloth is not None:
        seen[0][rays.pass_cloth.numpy()] = -1
    return SortedRays(
        rays,
        groups,
        _added_up(_seen_code(rays.views.rays), seen, shared, groups.count)[..., :SUMS],
        _added_up(_lit_code(rays.views.rays), lit, shared, groups.count)[..., :LIT_SUMS],
    )


def _numbers_of(met: Met) -> list[NDArray[np.float32]]:
    """What `sorting_code` is given of points."""
    family = met.is_warp.numpy().astype(np.float32)
    family[met.hole.numpy()] = -1
    return [family, *(part.numpy() for part in (*met.normal, *met.tangent))]


def _added_up(
    code: MachineCode, rays: list[NDArray[np.float32]], shared: list[NDArray[np.float32]], groups: int
) -> NDArray[np.float32]:
    """Rows of sums [2, nodes, groups, 16]."""
    count = len(rays[0])
    found = np.empty(count, np.float32)
    code.run(count, rays, [found], shared)
    return found.reshape(2, NODES, -1, ROW)[:, :, :groups]


@cache
def _seen_code(rays: int) -> MachineCode:
    return MachineCode(seen_code(rays, vectors()))


@cache
def _lit_code(rays: int) -> MachineCode:
    return MachineCode(lit_code(rays, vectors()))


def measure_reach(found: SortedRays) -> Reach:
    """Means by face, node and group of what the rays met."""
    hits = found.views[..., 0].astype(np.float64)
    # Rays that meet yarn are all that do not pass.
    met_yarn = hits.sum(axis=2)
    passes = found.rays.passes
    passing = np.zeros((2, NODES)) if passes is None else _both_faces(passes.numpy())
    passing = np.where(met_yarn > 0, found.groups.hole[:, None] * passing, 1)
    shares = hits * ((1 - passing) / np.maximum(met_yarn, 1))[..., None]
    points, *means = np.moveaxis(found.points.astype(np.float64), -1, 0)
    free, beyond, *terms = (part / np.maximum(points, 1) for part in means)
    return Reach(
        np.concatenate([shares, passing[..., None]], axis=2),
        np.stack([free, beyond], axis=1),
        np.stack(terms, axis=1) / math.pi,
    )


def groups_met(found: SortedRays) -> Groups:
    """The groups with moments of what views from all sides meet."""
    return as_met(found.groups, found.views.sum(axis=1, dtype=np.float64))


def _both_faces(passes: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Share of rays through gaps that pass [2 faces, nodes] of those of the front.

    A line that passes is seen from the other face from the opposite azimuth.
    """
    front = passes.reshape(AZIMUTHS, RINGS, -1).mean(axis=2)
    return np.stack([front, np.roll(front, AZIMUTHS // 2, axis=0)]).reshape(2, NODES)
