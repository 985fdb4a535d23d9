"""What light and views reach of groups: tables by direction, and their correlation, from rays.

Sums over hits (`view_sums`, `light_sums`) make the visibility tables; the factors of joint visibility say how
much more, or less, of what a view sees is lit than of all points of a family.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, array_types, clip, upload
from loomlight.core.frozen import FrozenArg, FrozenFunction
from loomlight.models.lobes.groups import Groups, NearestGroup, with_view_moments
from loomlight.models.lobes.hemisphere import AZIMUTHS, NODES, RINGS, NodeTaps, node_directions, node_taps
from loomlight.models.lobes.rays import (
    BAKE_QUALITY,
    SurfaceHits,
    UploadedCloth,
    VisibilityRays,
    direction_of,
    start_of_shadow_ray,
)
from loomlight.yarn.rays import SearchQuality
from loomlight.yarn.visibility import first_hit, unoccluded

# --------------------------------------------------------------------------------------------- sums over hits
# Sums over ray hits by face, node of the hemisphere and group.
#
# Hits are in the order of `rays.py`: by face, then node, then ray. The rays of one node on one face
# are a block, whose sums are a product of matrices: rays that hit each group, times terms of rays.


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


# ------------------------------------------------------------------------------------------ visibility tables
# Visibility tables: projected area, light visibility and irradiance of groups, from rays over the repeat.
#
# For every node of the hemisphere:
#
#     projected_area    fraction of the view rays through the plane z = 0 that hit the group, walls included,
#                       or that pass through a hole
#     light_visibility  fraction of the group's points, as all views see them, that light from the node
#                       reaches
#     irradiance        mean blended diffuse term of these points, shadowed, 1/sr
#
# The last two are for light from the side of the view and for light from the other side, shadowed as on the
# other face. A node has few rays of some groups: means are drawn towards those of the nodes around.


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
    """Light visibility and irradiance from `LIGHT_SUMS` [2, nodes, groups, 5].

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


# ----------------------------------------------------------------------------------------------- joint lookup
# Reads the factors of joint visibility, below: joint over independent visibility of a view and a light.
#
# The table has a row for each face, side of the light, view or light, and node: 16 azimuths of the 8 rings
# of `hemisphere`. A row has the terms of two ratios, of warp and weft.


# Terms of a ratio, and ratios: of warp and weft. Specular terms have that of diffuse ones: one of their own
# makes no difference to means over repeats.
JOINT_TERMS, JOINT_RATIOS = 4, 2
JOINT_FACTORS = JOINT_TERMS * JOINT_RATIOS
# Every second azimuth of the hemisphere: as many as visibility needs from point to point.
JOINT_AZIMUTHS = AZIMUTHS // 2
JOINT_NODES = JOINT_AZIMUTHS * RINGS
# Factors are signed 16-bit numbers in units of 1/FACTOR_UNIT, from −8 to 8.
FACTOR_UNIT = 4096.0
# Ratios above it, of families that are hardly seen or lit, are not trusted.
MAX_JOINT_RATIO = 4.0


def packed_factors(factors: NDArray[np.float64]) -> NDArray[np.int16]:
    """Factors as 16-bit numbers."""
    return np.clip(np.rint(factors * FACTOR_UNIT), -32768, 32767).astype(np.int16)


class JointLookup:
    """The factors of one fabric on one backend."""

    def __init__(self, factors: NDArray[np.int16], types: ArrayTypes) -> None:
        """
        Args:
            factors: [2 faces, 2 sides, view or light, JOINT_NODES, JOINT_FACTORS]; see `joint_factors`.
        """
        self._types = types
        self._factors = upload(types.Float, factors / FACTOR_UNIT)

    def taps(self, direction: Vec3) -> NodeTaps:
        """Nodes around a unit vector [3] in the frame of the face seen."""
        return node_taps(direction, JOINT_AZIMUTHS)

    def ratios(
        self, view: NodeTaps, light: NodeTaps, back: Mask, is_transmission: Mask
    ) -> tuple[Float, Float]:
        """Joint over independent means of (warp, weft), 0 to `MAX_JOINT_RATIO`.

        Args:
            view, light: their `taps`.
            back: the back is seen.
            is_transmission: light comes from the other side.
        """
        types = self._types
        side = dr.select(back, types.UInt32(2), types.UInt32(0)) + dr.select(
            is_transmission, types.UInt32(1), types.UInt32(0)
        )
        row = side * (2 * JOINT_NODES)
        of_view, of_light = self._read(view, row), self._read(light, row + JOINT_NODES)
        ratios = []
        for first in range(0, JOINT_FACTORS, JOINT_TERMS):
            total: Float = 1
            for number in range(first, first + JOINT_TERMS):
                total = dr.fma(of_view[number], of_light[number], total)
            ratios.append(clip(total, 0, MAX_JOINT_RATIO))
        return ratios[0], ratios[1]

    def _read(self, taps: NodeTaps, row: UInt) -> list[Float]:
        """The interpolated factors of the rows from `row` on."""
        width = dr.width(row, taps.nodes[0])
        sums: list[Float] = [0] * JOINT_FACTORS
        for node, share in zip(taps.nodes, taps.weights.shares, strict=True):
            read = dr.gather(self._types.Vectors, self._factors, row + node, shape=(JOINT_FACTORS, width))
            sums = [dr.fma(factor, share, total) for factor, total in zip(read, sums, strict=True)]
        return sums


# ------------------------------------------------------------------------------------------- joint visibility
# What light and view both reach: the ratio of joint to independent visibility, as factors of low rank.
#
# The groups of a footprint hold what light reaches and what views see apart. On cloth the two go together:
# the spots that a grazing view sees are those that light from its side reaches. For each family,
#
#     ratio(view, light) = 1 + Σ_k a_k(view)·b_k(light),    k < JOINT_TERMS
#
# is the mean diffuse term over the points that are lit and seen, over what the groups make of it where
# light and view are independent. It is one number for all groups of a family, and so for footprints of any
# size.
#
# Points are hits of views from all nodes. Shadow rays along each azimuth find by bisection the last ring
# that is free; what a view sees of a point is weighted by the inverse of its density over all views
# (balance heuristic, Veach and Guibas 1995). Means over pairs of directions are then products of matrices.


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
