"""What light and view both reach: the ratio of joint to independent visibility, as factors of low rank.

The groups of a footprint hold what light reaches and what views see apart. On cloth the two go together: the
spots that a grazing view sees are those that light from its side reaches. For each family,

    ratio(view, light) = 1 + Σ_k a_k(view)·b_k(light),    k < JOINT_TERMS

is the mean diffuse term over the points that are lit and seen, over what the groups make of it where light
and view are independent. It is one number for all groups of a family, and so for footprints of any size.

Points are hits of views from all nodes. Shadow rays along each azimuth find by bisection the last ring that
is free; what a view sees of a point is weighted by the inverse of its density over all views (balance
heuristic, Veach and Guibas 1995). Means over pairs of directions are then products of matrices.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Mask, UInt, Vec3
from loomlight.core.backend import upload
from loomlight.core.frozen import FrozenArg, FrozenFunction
from loomlight.models.lobes.accumulation import group_of_hits
from loomlight.models.lobes.cloth_samples import UploadedCloth
from loomlight.models.lobes.groups import Groups
from loomlight.models.lobes.hemisphere import AZIMUTHS, RINGS, node_directions
from loomlight.models.lobes.joint_lookup import (
    JOINT_AZIMUTHS,
    JOINT_FACTORS,
    JOINT_NODES,
    JOINT_TERMS,
    MAX_JOINT_RATIO,
    packed_factors,
)
from loomlight.models.lobes.visibility_rays import BAKE_QUALITY, SurfaceHits, direction_of
from loomlight.yarn.rays import SearchQuality
from loomlight.yarn.visibility import first_hit, unoccluded

# Views of each node and face that hits are taken from: 4096 points a face. Twice and four times as many lower
# errors of means by less than a twentieth.
VIEWS = 32
_POINTS = JOINT_NODES * VIEWS
# Hits are refined, as heights around them tell which wall is met.
_VIEW_QUALITY = SearchQuality(5.0, 8.0, refinements=4)
# How far from an outline heights are looked up, and how far below the surface a hit lies on a wall, in units
# of the finest thread.
_OUTWARDS, _BELOW = 0.03, 0.02
# What shadow rays are for: the view; light of its side, where that differs; light of the other side.
_VIEW, _LIT, _BEHIND = range(3)
# Means below this, relative to the cloth, are taken for this.
_LEAST_MEAN = 1e-4
# Weight of a row in the approximation: its mean to this power. With 1 the largest errors through the cloth
# are half as large again, with 1/2 the mean errors of plain weave a fifth.
_WEIGHT_POWER = 0.75
# Columns and steps of subspace iteration.
_COLUMNS, _ITERATIONS = 2 * JOINT_TERMS, 8

Floats = NDArray[np.float32]
# Where shadow rays start, and the normal there.
_Start: TypeAlias = tuple[Vec3, Vec3]


@dataclass
class JointPoints:
    """Hits of views of both faces [2·_POINTS], in the frame of the face seen.

    Attributes:
        hits: their yarn.
        on_flank: the ray has ended below its yarn's tube, on a wall or where the yarn dives.
        facing: normal of what is hit, the yarn or its side.
        rings: the last free ring along each azimuth [3·2·_POINTS·JOINT_AZIMUTHS], for the view, light of the
            view's side on flanks, and light of the other side.
    """

    hits: SurfaceHits
    on_flank: Mask
    facing: Vec3
    rings: UInt


def joint_directions() -> NDArray[np.float64]:
    """Unit vectors of the nodes [JOINT_NODES, 3], azimuth by azimuth, z > 0."""
    step = AZIMUTHS // JOINT_AZIMUTHS
    return np.ascontiguousarray(node_directions().reshape(AZIMUTHS, RINGS, 3)[::step].reshape(-1, 3))


def launch_joint(cloth: FrozenArg[UploadedCloth]) -> JointPoints:
    """Launches views and the shadow rays of their hits; returns before the device is done."""
    types = cloth.value.types
    rows = np.pad(joint_directions(), ((0, 0), (0, 1))).astype(np.float32)
    directions = upload(types.Float, rows)
    thread = dr.opaque(types.Float, min(cloth.value.geometry.finest))
    hits, on, of_view, of_light = _trace_hits(cloth, directions, thread)
    rings = _free_rings(cloth, directions, thread, of_view, of_light, on, hits.hole)
    return JointPoints(hits, on[1], of_view[1], rings)


@FrozenFunction
def _trace_hits(
    cloth: UploadedCloth, directions: Float, thread: Float
) -> tuple[SurfaceHits, tuple[Mask, Mask], _Start, _Start]:
    """Hits; whether they are on a wall, on a flank; where views and where light meet them."""
    types, geometry = cloth.types, cloth.geometry
    lane = dr.arange(types.UInt32, 2 * _POINTS)
    back = lane >= _POINTS
    node = dr.select(back, lane - _POINTS, lane) // VIEWS
    x, y = cloth.positions.in_lattice(lane % VIEWS, VIEWS, node)
    view = direction_of(cloth, directions, node)
    hit = first_hit(geometry, x, y, view, back, True, _VIEW_QUALITY)
    point = geometry.surface(hit.x, hit.y, back)
    hole = hit.hole | point.hole
    on_wall = ~hole & (hit.height < dr.fma(-_BELOW, thread, point.height))
    # Sides of yarns face the view, along x where the cloth is lower there, else along y.
    beside = dr.copysign(types.Float(1), view.x), dr.copysign(types.Float(1), view.y)
    height, gap = geometry.height(dr.fma(beside[0] * _OUTWARDS, thread, hit.x), hit.y, back)
    faces_x = gap | (height < hit.height)
    side = types.Vector3(dr.select(faces_x, beside[0], 0), dr.select(faces_x, 0, beside[1]), 0)
    place = types.Vector3(hit.x, hit.y, dr.select(on_wall, hit.height, point.height))
    facing = dr.select(on_wall, side, point.normal)
    met = geometry.surface(hit.x, hit.y, back, (view, hit.height))
    on_flank = ~hole & (met.depth > _BELOW * thread)
    of_light = types.Vector3(met.x, met.y, met.height), met.normal
    return SurfaceHits.of(met, hole), (on_wall, on_flank), (place, facing), of_light


@FrozenFunction
def _free_rings(
    cloth: UploadedCloth,
    directions: Float,
    thread: Float,
    of_view: _Start,
    of_light: _Start,
    on: tuple[Mask, Mask],
    hole: Mask,
) -> UInt:
    """`JointPoints.rings`, by bisection: along an azimuth, rings are free down to the horizon."""
    types, geometry = cloth.types, cloth.geometry
    lane = dr.arange(types.UInt32, 3 * 2 * _POINTS * JOINT_AZIMUTHS)
    ray = lane // JOINT_AZIMUTHS
    kind, number = ray // (2 * _POINTS), ray % (2 * _POINTS)
    (start, facing), lit = ([dr.gather(types.Vector3, v, number) for v in of] for of in (of_view, of_light))
    on_wall, on_flank = (dr.gather(types.Bool, mask, number) for mask in on)
    start = dr.select(kind == _VIEW, start, lit[0])
    face = (number >= _POINTS) ^ (kind == _BEHIND)
    point = geometry.surface(start.x, start.y, face)
    from_wall = on_wall & (kind == _VIEW)
    # Off flanks, light of the view's side reaches what views reach.
    is_lit = (kind == _LIT) & on_flank
    active = ~dr.gather(types.Bool, hole, number) & (is_lit | (~point.hole & (kind != _LIT)) | from_wall)
    normal = dr.select(is_lit, lit[1], dr.select(from_wall, facing, point.normal))
    aside = dr.select(from_wall, _OUTWARDS * thread, 0)
    x, y = dr.fma(normal.x, aside, start.x), dr.fma(normal.y, aside, start.y)
    height = dr.select(from_wall | is_lit, start.z, point.height)
    first = lane % JOINT_AZIMUTHS * RINGS

    def next_ring(rings: UInt, step: UInt) -> tuple[UInt, UInt]:
        """The rings `step` further out where those are free, else as they are."""
        direction = direction_of(cloth, directions, first + rings + step)
        searched = active & (dr.dot(normal, direction) > 0)
        is_free = unoccluded(geometry, x, y, height, direction, face, searched, BAKE_QUALITY)
        return dr.select(is_free, rings + step, rings), step // 2

    rings, _ = dr.while_loop(
        (types.UInt32(0), types.UInt32(RINGS // 2)),
        lambda _, step: step > 0,
        next_ring,
        label="lobes: free rings",
    )
    return rings


def joint_factors(points: JointPoints, groups: Groups, diffuse_blend: float) -> NDArray[np.int16]:
    """Factors [2 faces, 2 sides, view or light, JOINT_NODES, JOINT_FACTORS], packed; waits for rays.

    Args:
        groups: that the independent means are made of.
        diffuse_blend: w, the weight of the yarn normal in the diffuse term.
    """
    rings = points.rings.numpy().reshape(3, 2, _POINTS, JOINT_AZIMUTHS, 1)
    hits = points.hits
    group_of = group_of_hits(hits, hits.hole, groups).reshape(2, _POINTS)
    hole, on_flank = (part.numpy().reshape(2, _POINTS) for part in (hits.hole, points.on_flank))
    normal, facing = (
        np.stack([part.numpy() for part in vector], axis=-1).reshape(2, _POINTS, 3)
        for vector in (hits.normal, points.facing)
    )
    nodes = joint_directions().astype(np.float32)
    factors = np.zeros((2, 2, 2, JOINT_NODES, JOINT_FACTORS))
    for face in range(2):
        is_free = [(rings[kind, face] >= np.arange(RINGS)).reshape(_POINTS, -1) for kind in range(3)]
        seen = _seen_weights(is_free[_VIEW] & ~hole[face, :, None], facing[face], nodes)
        lit = np.where(on_flank[face, :, None], is_free[_LIT], is_free[_VIEW]), is_free[_BEHIND]
        members = _members(group_of[face], groups, face)
        across, up = normal[face, :, :2] @ nodes[:, :2].T, normal[face, :, 2:] * nodes[:, 2]
        for side, cosine in enumerate((up + across, up - across)):
            diffuse = nodes[:, 2] + np.float32(diffuse_blend) * (np.maximum(cosine, 0) - nodes[:, 2])
            light = lit[side] * diffuse
            factors[face, side] = _low_rank([_ratio(seen, light, family) for family in members])
    return packed_factors(factors)


def _seen_weights(is_free: NDArray[np.bool_], facing: Floats, nodes: Floats) -> Floats:
    """Share of what each view shows that is near each point [_POINTS, JOINT_NODES].

    The area that a view shows of a point, over the mean of all views, which its hits are as dense as.
    """
    area = is_free * np.maximum(facing @ nodes.T, 0) / nodes[:, 2]
    mean = area.mean(axis=1, keepdims=True)
    return np.asarray(np.where(mean > _LEAST_MEAN, area / np.maximum(mean, _LEAST_MEAN), 0), np.float32)


def _members(group_of: NDArray[np.uint32], groups: Groups, face: int) -> list[list[NDArray[np.intp]]]:
    """Indices of the points of each group of a face, by family."""
    members = [np.flatnonzero(group_of == group) for group in range(groups.count)]
    warp_count = groups.warp_count[face]
    return [members[:warp_count], members[warp_count:]]


def _ratio(seen: Floats, light: Floats, members: list[NDArray[np.intp]]) -> tuple[Floats, Floats]:
    """Joint over independent means of a family [views, lights], and the independent ones.

    Args:
        seen: weights of points by view [points, views].
        light: what light does at points [points, lights].
        members: of each group of the family.
    """
    joint = np.zeros((JOINT_NODES, JOINT_NODES), np.float32)
    independent = np.zeros_like(joint)
    of_family = np.concatenate(members)
    if len(of_family):
        joint = seen[of_family].T @ light[of_family]
        by_group = [(seen[group].sum(axis=0), light[group].mean(axis=0)) for group in members if len(group)]
        shown, lit = (np.stack(part) for part in zip(*by_group, strict=True))
        independent = shown.T @ lit
    least = np.float32(_LEAST_MEAN * len(seen))
    ratio = np.minimum((joint + least) / (independent + least), np.float32(MAX_JOINT_RATIO))
    return ratio, np.asarray((independent + least) / np.float32(len(seen)))


def _low_rank(ratios: list[tuple[Floats, Floats]]) -> NDArray[np.float64]:
    """Factors [view or light, JOINT_NODES, JOINT_FACTORS] of the nearest ratios of so few terms.

    Rows and columns weigh by their means; the largest singular values and vectors come of subspace iteration
    (Halko, Martinsson and Tropp 2011, algorithm 4.4).

    Args:
        ratios: each with its independent means.
    """
    ratio, mean = (np.stack(part).astype(np.float64) for part in zip(*ratios, strict=True))
    by_view, by_light = (mean.mean(axis=axis, keepdims=True) ** _WEIGHT_POWER for axis in (2, 1))
    matrix = by_view * (ratio - 1) * by_light
    start = np.cos(np.pi / JOINT_NODES * np.outer(np.arange(JOINT_NODES) + 0.5, np.arange(_COLUMNS)))
    basis = np.linalg.qr(matrix @ start)[0]
    for _ in range(_ITERATIONS):
        basis = np.linalg.qr(matrix @ (matrix.swapaxes(1, 2) @ basis))[0]
    left, size, right = np.linalg.svd(basis.swapaxes(1, 2) @ matrix, full_matrices=False)
    root = np.sqrt(size[:, None, :JOINT_TERMS])
    of_view = basis @ left[:, :, :JOINT_TERMS] * root / by_view
    of_light = right[:, :JOINT_TERMS].swapaxes(1, 2) * root / by_light.swapaxes(1, 2)
    return np.stack([part.swapaxes(0, 1).reshape(JOINT_NODES, JOINT_FACTORS) for part in (of_view, of_light)])
