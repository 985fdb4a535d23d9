"""Samples of the cloth that tables are baked of: positions over the repeat, view rays and shadow rays."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Self

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, FloatType, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, InvariantDivider, array_types, upload
from loomlight.core.frozen import FrozenArg, FrozenFunction
from loomlight.models.lobes.hemisphere import NODES, node_directions
from loomlight.yarn.flanks import SurfacePoint
from loomlight.yarn.rays import SearchQuality, upload_extent
from loomlight.yarn.stack import ClothGeometry
from loomlight.yarn.visibility import first_hit, passes_through, unoccluded

# ---------------------------------------------------------------------------------------------- cloth samples
# Samples of the cloth's surface for baking tables, at low-discrepancy positions over the repeat.


# Top-down samples of each face.
TOP_DOWN_SAMPLES = 1 << 13
# The additive recurrence of Roberts (2018, "The Unreasonable Effectiveness of Quasirandom Sequences") in four
# dimensions: powers of 1/φ₄, the root of x⁵ = x + 1, in units of 2⁻³², where products wrap around as
# fractions.
RECURRENCE = [round(2**32 * 1.1673039782614187**-power) for power in range(1, 5)]

# 2³²/φ: fractions of multiples of the golden ratio fill the unit interval evenly.
GOLDEN_FRACTION = 0x9E3779B9
# Shifts x, y from lattice to lattice: 1/ρ and −1/ρ² − 1/φ in units of 2⁻³², ρ the root of x³ = x + 1. Points
# of successive numbers and lattices, which shadow rays start from, are then nearly an additive recurrence.
LATTICE_SHIFT = 0xC13FA9A9, 2**33 - 0x91E10DA6 - GOLDEN_FRACTION


@dataclass
class SurfaceHits:
    """Yarn points in the frame of their face.

    Attributes:
        is_warp: the warp is hit, else the weft.
        hole: no yarn is hit.
        normal, tangent: unit normal and unit fibre direction.
        shown_share: see `SurfacePoint`.
    """

    is_warp: Mask
    hole: Mask
    normal: Vec3
    tangent: Vec3
    shown_share: Float

    @classmethod
    def of(cls, point: SurfacePoint, hole: Mask) -> Self:
        """The point as a hit; `hole` where nothing was hit."""
        return cls(point.is_warp, hole, point.normal, point.tangent, point.shown_share)

    def features(self) -> list[Float]:
        """What points are told apart by: normal, fibre direction, shown share."""
        return [*self.normal, *self.tangent, self.shown_share]


@dataclass(frozen=True, eq=False)
class FaceSamples:
    """Samples of both faces, in the frame of the face that shows them.

    Attributes:
        back, is_warp, hole: which face, which family, and whether neither family is there [n].
        features: see `SurfaceHits.features` [n, 7].
    """

    back: NDArray[np.bool_]
    is_warp: NDArray[np.bool_]
    hole: NDArray[np.bool_]
    features: NDArray[np.float32]

    def by_family(self) -> list[NDArray[np.intp]]:
        """Indices of samples by family, without holes: the front's warp and weft, then the back's."""
        family_of = 2 * self.back + ~self.is_warp
        return [np.flatnonzero((family_of == family) & ~self.hole) for family in range(4)]


@dataclass(frozen=True, eq=False)
class TopDownSamples(FaceSamples):
    """Samples of the surface as seen along the normal, evenly over the repeat; the front's come first.

    Attributes:
        gaps: positions of the holes among them [m, 2], millimetres.
    """

    gaps: NDArray[np.float32]

    @property
    def hole_fraction(self) -> float:
        """Fraction of the repeat without yarn, 0 to 1: the same for both faces."""
        return len(self.gaps) / TOP_DOWN_SAMPLES


class SamplePositions:
    """Low-discrepancy point sets over the repeat, the same every time."""

    def __init__(self, geometry: ClothGeometry, types: ArrayTypes) -> None:
        self._types = types
        picks, ends = geometry.layout.warp_on_top.shape
        # Of either axis: how many threads there are, and millimetres a thread.
        self._axes = [
            (dr.opaque(types.Float, threads), dr.opaque(types.Float, side / threads))
            for threads, side in zip((ends, picks), geometry.size, strict=True)
        ]

    def at(self, index: UInt, sequence: UInt) -> tuple[Float, Float]:
        """Positions x, y, millimetres.

        Two dimensions choose the crossing and two the position within it: points that are even over the
        repeat alone may hit a gap of a few per cent too often, as threads repeat.

        Args:
            index: of the point in its sequence, from 0.
            sequence: which one of many shifted sequences.
        """
        unit = [
            self._types.Float((index * factor + factor // 2 + sequence * shift) >> 8) * 2**-24
            for factor, shift in zip(RECURRENCE, RECURRENCE[::-1], strict=True)
        ]
        x, y = (
            (dr.floor(crossing * threads) + within) * spacing
            for within, crossing, (threads, spacing) in zip(unit[:2], unit[2:], self._axes, strict=True)
        )
        return x, y

    def in_lattice(self, index: UInt, count: int, lattice: UInt) -> tuple[Float, Float]:
        """Positions x, y, millimetres, of a golden lattice over the repeat.

        With 512 points the area that a family shows has half the noise of `at`, but gaps of a few per cent
        between evenly spaced threads may have more of it.

        Args:
            index: of the point, from 0.
            count: of points in a lattice.
            lattice: which one of many shifted lattices.
        """
        step = dr.opaque(self._types.UInt32, (2**32 - 1) // count)
        x, y = (
            self._types.Float((index * factor + lattice * shift) >> 8) * 2**-24 * (threads * spacing)
            for factor, shift, (threads, spacing) in zip(
                (step, GOLDEN_FRACTION), LATTICE_SHIFT, self._axes, strict=True
            )
        )
        return x, y


class UploadedCloth:
    """The yarns of one fabric on one backend.

    Attributes:
        geometry: the yarns, uploaded.
        positions: point sets over their repeat.
        types: of the backend.
    """

    def __init__(self, geometry: ClothGeometry, types: ArrayTypes) -> None:
        geometry.upload(types)
        upload_extent(geometry, types)
        self.geometry = geometry
        self.positions = SamplePositions(geometry, types)
        self.types = types


def upload_cloth(geometry: ClothGeometry, float_type: FloatType) -> FrozenArg[UploadedCloth]:
    """The yarns on the backend of a Dr.Jit Float type, as an argument of frozen functions."""
    return FrozenArg(UploadedCloth(geometry, array_types(float_type)))


def top_down_samples(cloth: FrozenArg[UploadedCloth]) -> TopDownSamples:
    """Samples both faces along the normal."""
    x, y, hits = _sample_top_down(cloth)
    hole = hits.hole.numpy()
    back = np.arange(2 * TOP_DOWN_SAMPLES) >= TOP_DOWN_SAMPLES
    gaps = np.stack([part.numpy()[hole & ~back] for part in (x, y)], axis=1)
    features = np.stack([part.numpy() for part in hits.features()], axis=1)
    return TopDownSamples(back, hits.is_warp.numpy(), hole, features, gaps)


@FrozenFunction
def _sample_top_down(cloth: UploadedCloth) -> tuple[Float, Float, SurfaceHits]:
    """Positions x, y of all samples, and what is there."""
    lane = dr.arange(cloth.types.UInt32, 2 * TOP_DOWN_SAMPLES)
    back = lane >= TOP_DOWN_SAMPLES
    x, y = cloth.positions.at(lane & (TOP_DOWN_SAMPLES - 1), cloth.types.UInt32(0))
    point = cloth.geometry.surface(x, y, back)
    return x, y, SurfaceHits.of(point, point.hole)


# -------------------------------------------------------------------------------------------- visibility rays
# View and shadow rays over the whole repeat, towards every node of the hemisphere; hits are not grouped
# yet.
#
# Shadow rays start from the points that views hit, not from points spread over the cloth: a third of
# grazing views may end on the steep sides of yarns, which darker light reaches.
#
# Rays are in the order of their face, then their node, then their position. Launches are asynchronous:
# reading a result waits for the device.


# Rays of a node and face, at least, and for each group of a family. With 256, the tables' noise shows as
# blotches on a sphere (FLIP of denim 0.065 in place of 0.055); 1024 gain another 2 %. With 8 a group, errors
# of 32 groups a family are 12 % larger.
MIN_RAYS, RAYS_PER_GROUP = 512, 32
# Rays through gaps, at most so many a node.
MAX_GAP_RAYS = 128
# Views of each node and face that groups are clustered from, evenly: they divide the number of rays.
SAMPLED_VIEWS = 32
# Shadow rays of neighbouring nodes start from views so many nodes apart; odd, so that all nodes occur.
VIEW_STEP = 37
assert NODES & (NODES - 1) == 0
# Without refinement hits cost 6 % of the query benchmark's error. Shadow rays take smaller steps than view
# rays: with equal ones they miss yarn, and cloth is 2 % too bright.
BAKE_QUALITY = SearchQuality(steps_per_thread=2.5, steps_per_relief=2.5, shadow_share=1.6, refinements=1)


@dataclass
class ViewRays:
    """View rays through positions on the plane z = 0.

    Attributes:
        rays: of each node and face.
        directions: unit vectors of all nodes, uploaded [4 NODES].
        hits: first hits; arbitrary where a ray passes through the cloth.
        place: where they lie [3], millimetres, on the yarns' tubes (`yarn/flanks.py`).
        below_plane: the hit lies below z = 0.
        starts_in_gap: the ray crosses z = 0 where there is no yarn.
    """

    rays: int
    directions: Float
    hits: SurfaceHits
    place: Vec3
    below_plane: Mask
    starts_in_gap: Mask


@dataclass
class VisibilityRays:
    """View rays, shadow rays, and rays through gaps.

    Attributes:
        views: the view rays.
        view_is_null: which views pass through the cloth; None where none can.
        is_lit: light from the node reaches the start of the shadow ray; see `start_of_shadow_ray`.
        is_lit_behind: light from the node's direction on the other side reaches the other face there.
        gap_is_null: which rays through gaps pass through the cloth, for the front's nodes; None without gaps.
    """

    views: ViewRays
    view_is_null: Mask | None
    is_lit: Mask
    is_lit_behind: Mask
    gap_is_null: Mask | None


def ray_count(per_family: int) -> int:
    """Rays of each node and face, for so many groups of a family."""
    return max(MIN_RAYS, RAYS_PER_GROUP * per_family)


def start_of_shadow_ray(node: Any, ray: Any, rays: Any) -> Any:
    """Index of the view ray, within its face, whose hit shadow ray number `ray` of a node starts from.

    Every hit is the start of one shadow ray, and a node's shadow rays start from hits of all views alike:
    what a group receives is the mean over its points as views see them, the sides of yarns included.
    """
    return ((node * VIEW_STEP + ray) & (NODES - 1)) * rays + ray


def launch_views(cloth: FrozenArg[UploadedCloth], per_family: int) -> ViewRays:
    """Launches the view rays of both faces and all nodes.

    Args:
        per_family: groups of each family that the rays are for, on average.
    """
    rays = ray_count(per_family)
    rows = np.pad(node_directions(), ((0, 0), (0, 1))).astype(np.float32)
    directions = upload(cloth.value.types.Float, rows)
    hits, place, below_plane = _trace_views(cloth, directions, rays)
    return ViewRays(rays, directions, hits, place, below_plane, _start_in_gaps(cloth, rays))


def view_samples(views: ViewRays) -> FaceSamples:
    """Hits of a few views of every node; views that may pass through a gap count as holes."""

    def some(values: Float | Mask) -> NDArray[Any]:
        by_node = values.numpy().reshape(2 * NODES, SAMPLED_VIEWS, -1)
        return np.asarray(by_node[:, :, 0].ravel())

    hits = views.hits
    hole = some(hits.hole) | (some(views.below_plane) & some(views.starts_in_gap))
    back = np.arange(len(hole)) >= len(hole) // 2
    features = np.stack([some(part) for part in hits.features()], axis=1)
    return FaceSamples(back, some(hits.is_warp), hole, features)


def launch_rays(cloth: FrozenArg[UploadedCloth], samples: TopDownSamples, views: ViewRays) -> VisibilityRays:
    """Launches shadow rays, rays through gaps, and the test for views that pass through the cloth.

    Args:
        samples: their gaps are the start positions of rays through gaps.
    """
    Float, UInt32 = cloth.value.types.Float, cloth.value.types.UInt32
    rays, directions = views.rays, views.directions
    # Few views start in gaps, but most SIMD packets have one: compaction saves time.
    from_gaps = np.flatnonzero(views.starts_in_gap.numpy())
    # Gaps are a few per cent of the cloth: uniform positions would hit them too seldom.
    gaps = samples.gaps[:: max(1, len(samples.gaps) // MAX_GAP_RAYS)][:MAX_GAP_RAYS]
    # Uploads wait for kernels that run, so they come before the launches.
    lanes, starts = upload(UInt32, from_gaps.astype(np.uint32)), upload(Float, gaps)
    is_lit, is_lit_behind = _trace_shadows(cloth, directions, rays, views.place, views.hits.normal)
    gap_is_null = _trace_gaps(cloth, directions, starts, len(gaps)) if len(gaps) else None
    has_null = len(from_gaps) > 0
    view_is_null = _trace_null(cloth, directions, rays, lanes, views.below_plane) if has_null else None
    return VisibilityRays(views, view_is_null, is_lit, is_lit_behind, gap_is_null)


@FrozenFunction
def _start_in_gaps(cloth: UploadedCloth, rays: int) -> Mask:
    """Which views cross the plane z = 0 where there is no yarn."""
    back, x, y = _positions(cloth, rays, dr.arange(cloth.types.UInt32, 2 * NODES * rays))[:3]
    return cloth.geometry.height(x, y, back)[1]


@FrozenFunction
def _trace_shadows(
    cloth: UploadedCloth, directions: Float, rays: int, place: Vec3, normal: Vec3
) -> tuple[Mask, Mask]:
    """Whether light from each node reaches hits, and from the other side the other face there."""
    types = cloth.types
    back, node, ray = _rays_of_nodes(cloth, rays, dr.arange(types.UInt32, 2 * NODES * rays))
    per_node = dr.opaque(types.UInt32, rays)
    start = start_of_shadow_ray(node, ray, per_node) + dr.select(back, NODES * per_node, 0)
    x, y, height = dr.gather(types.Vector3, place, start)
    light = direction_of(cloth, directions, node)

    def reaches(height: Float, normal: Vec3, face: Mask) -> Mask:
        faces_light = dr.dot(normal, light) > 0
        return unoccluded(cloth.geometry, x, y, height, light, face, faces_light, BAKE_QUALITY)

    far = cloth.geometry.surface(x, y, ~back)
    is_lit_behind = ~far.hole & reaches(far.height, far.normal, ~back)
    return reaches(height, dr.gather(types.Vector3, normal, start), back), is_lit_behind


@FrozenFunction
def _trace_views(cloth: UploadedCloth, directions: Float, rays: int) -> tuple[SurfaceHits, Vec3, Mask]:
    """First hits of views that do not pass through the cloth, where they lie [3], and whether below 0."""
    back, x, y, view = _rays(cloth, directions, rays, dr.arange(cloth.types.UInt32, 2 * NODES * rays))
    hit = first_hit(cloth.geometry, x, y, view, back, True, BAKE_QUALITY, passing=False)
    point = cloth.geometry.surface(hit.x, hit.y, back, (view, hit.height))
    hits = SurfaceHits.of(point, point.hole)
    return hits, cloth.types.Vector3(point.x, point.y, point.height), hit.height <= 0


@FrozenFunction
def _trace_null(cloth: UploadedCloth, directions: Float, rays: int, lanes: UInt, below_plane: Mask) -> Mask:
    """Which views pass through the cloth: a mask over all rays; only `lanes` are traced."""
    back, x, y, view = _rays(cloth, directions, rays, lanes)
    # A view that hits yarn above the plane does not reach the gap.
    active = dr.gather(cloth.types.Bool, below_plane, lanes)
    is_null = dr.zeros(cloth.types.Bool, 2 * NODES * rays)
    dr.scatter(is_null, passes_through(cloth.geometry, x, y, view, back, active, BAKE_QUALITY), lanes)
    return is_null


@FrozenFunction
def _trace_gaps(cloth: UploadedCloth, directions: Float, starts: Float, count: int) -> Mask:
    """Which views of the front through `count` positions pass through the cloth."""
    types = cloth.types
    lane = dr.arange(types.UInt32, NODES * count)
    node, ray = InvariantDivider(count, types).divide(lane)
    x, y = dr.gather(types.Vector2, starts, ray)
    view = direction_of(cloth, directions, node)
    return passes_through(cloth.geometry, x, y, view, lane < 0, True, BAKE_QUALITY)


def _rays(cloth: UploadedCloth, directions: Float, rays: int, lane: UInt) -> tuple[Mask, Float, Float, Vec3]:
    """Rays of both faces and all nodes, `rays` of each: back, x, y, direction."""
    back, x, y, node = _positions(cloth, rays, lane)
    return back, x, y, direction_of(cloth, directions, node)


def _positions(cloth: UploadedCloth, rays: int, lane: UInt) -> tuple[Mask, Float, Float, UInt]:
    """Positions of rays on the plane z = 0: back, x, y, node."""
    back, node, ray = _rays_of_nodes(cloth, rays, lane)
    return back, *cloth.positions.in_lattice(ray, rays, node), node


def _rays_of_nodes(cloth: UploadedCloth, rays: int, lane: UInt) -> tuple[Mask, UInt, UInt]:
    """Face (the back or not), node and ray of the node, for indices of rays."""
    face_size = dr.opaque(cloth.types.UInt32, NODES * rays)
    back = lane >= face_size
    node, ray = InvariantDivider(rays, cloth.types).divide(dr.select(back, lane - face_size, lane))
    return back, node, ray


def direction_of(cloth: UploadedCloth, directions: Float, node: UInt) -> Vec3:
    """Unit vector of a node."""
    row = dr.gather(cloth.types.Vector4, directions, node)
    return cloth.types.Vector3(row.x, row.y, row.z)
