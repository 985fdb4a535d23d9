"""Groups: clusters of surface points of either family, by normal, fibre direction and shown share.

A group stands for all points near one normal n_p and one fibre direction t, wherever in the repeat threads
show as much as there, so that a few groups serve cloth of any draft. Stitches of a figure lie between long
floats: slanting views see less of them than of the ground's floats, which look alike from above. The first
groups of a face are the warp's, the others the weft's. A face has 2 K groups; the family that more views hit
may have more than half of them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Mask, UInt
from loomlight.core.backend import ArrayTypes, upload
from loomlight.core.parallel_map import parallel_map
from loomlight.models.lobes.hemisphere import pack_count
from loomlight.models.lobes.rays import GOLDEN_FRACTION, FaceSamples, SurfaceHits, TopDownSamples
from loomlight.yarn.flanks import SurfacePoint

# ------------------------------------------------------------------------------------------------- clustering
# Clustering by bisecting split: the cluster with the largest squared error is split in two, again and again.
#
# A cluster is split across the principal axis of its points (Orchard and Bouman 1991, "Color Quantization of
# Images"), where 2-means along that axis puts the boundary. Nothing is random: clusters grown from random
# centroids make pictures of the same cloth whose error varies by up to a third.


Doubles: TypeAlias = NDArray[np.float64]

# Coordinates of a point.
FEATURES = 7
# Points that agree in so many decimals are one, as those of a straight flat yarn are.
_DECIMALS = 4
# Steps of 2-means that place a boundary, and of k-means that refine all clusters.
BOUNDARY_STEPS, REFINING_STEPS = 4, 2


class BisectingClusters:
    """Points, and the hierarchy of clusters that bisecting splits make of them."""

    def __init__(self, points: NDArray[np.floating], max_clusters: int) -> None:
        """
        Args:
            points: coordinates [n, FEATURES]; n = 0 is allowed.
            max_clusters: the largest count that the methods take, ≥ 1.
        """
        self._points = np.round(points, _DECIMALS).astype(np.float64)
        # Of 1, 2, … clusters, fewer where points coincide: means [count, FEATURES], sums of squares.
        self._means: list[Doubles] = []
        self._errors: list[float] = []
        if self.size:
            self._bisect(max_clusters)

    @property
    def size(self) -> int:
        """Number of points."""
        return len(self._points)

    def error(self, count: int) -> float:
        """Mean squared distance of the points from the mean of their own one of `count` clusters."""
        return self._errors[min(count, len(self._errors)) - 1] / self.size if self.size else 0.0

    def means(self, count: int) -> Doubles:
        """Means of `count` clusters [count, FEATURES]; with fewer distinct points, the first is repeated."""
        if not self.size:
            return np.zeros((count, FEATURES))
        means = self._means[min(count, len(self._means)) - 1]
        return np.concatenate([means, np.repeat(means[:1], count - len(means), axis=0)])

    def refined_means(self, count: int) -> Doubles:
        """`means` after a few steps of k-means [count, FEATURES]; a cluster without points stays."""
        means = self.means(count)
        for _ in range(REFINING_STEPS if self.size else 0):
            distance = np.square(means).sum(axis=1) - 2 * self._points @ means.T
            is_member = (distance.argmin(axis=1)[:, None] == np.arange(count)).astype(np.float64)
            sizes = is_member.sum(axis=0)[:, None]
            means = np.where(sizes > 0, is_member.T @ self._points / np.maximum(sizes, 1), means)
        return means

    def _bisect(self, max_clusters: int) -> None:
        clusters = [_Cluster(self._points)]
        while True:
            self._means.append(np.array([cluster.mean for cluster in clusters]))
            self._errors.append(float(sum(cluster.square for cluster in clusters)))
            if len(clusters) == max_clusters:
                return
            widest = max(range(len(clusters)), key=lambda number: clusters[number].square)
            is_beyond = clusters[widest].beyond()
            if not 0 < is_beyond.sum() < len(is_beyond):
                return
            points = clusters[widest].points
            clusters[widest] = _Cluster(points[~is_beyond])
            clusters.append(_Cluster(points[is_beyond]))


class _Cluster:
    """Some of the points [n, FEATURES], their mean [FEATURES] and their sum of squared distances from it."""

    def __init__(self, points: Doubles) -> None:
        self.points = points
        self.mean = points.mean(axis=0)
        self._offsets = points - self.mean
        self.square = float(np.square(self._offsets).sum())

    def beyond(self) -> NDArray[np.bool_]:
        """The points of the half that lies farther along the principal axis [n]."""
        axis = np.linalg.eigh(self._offsets.T @ self._offsets)[1][:, -1]
        # Which of both halves is the new cluster is no matter of LAPACK's sign.
        along = self._offsets @ (axis * np.sign(axis[np.abs(axis).argmax()]))
        boundary = 0.0
        for _ in range(BOUNDARY_STEPS):
            is_beyond = along > boundary
            if is_beyond.all() or not is_beyond.any():
                break
            boundary = 0.5 * (along[is_beyond].mean() + along[~is_beyond].mean())
        return np.asarray(along > boundary)


# ----------------------------------------------------------------------------------------------------- groups


# Weight of the normal beside the fibre direction in distances: highlights are narrow in the latter.
NORMAL_WEIGHT = 0.5
# Weight of the shown share: a damask from afar is .14 off, .22 without. Plain cloth has one share a family.
SHARE_WEIGHT = 2.0
FEATURE_WEIGHTS = np.array([*[NORMAL_WEIGHT] * 3, 1, 1, 1, SHARE_WEIGHT], np.float32)
# Most samples that a family is clustered by.
CLUSTERED_SAMPLES = 1 << 11
# A family with fewer samples from views is clustered by its top-down samples.
MIN_VIEW_SAMPLES = 64
# Groups that fewer views hit keep the moments of their centroid: a covariance of so few is unreliable.
MIN_VIEW_HITS = 8.0
# Groups that cover less of the cloth from above than this share of what some view sees of them are hidden.
HIDDEN_SHARE = 1 / 64
# Families get groups in multiples of a pack, uint8x4.
GROUPS_PER_PACK = 4
# Numbers of a centroid in memory, and a distance above all others.
_ROW, _FAR = 8, 1e3
# Index pairs of the products of the fibre direction among sums over views; see `visibility.py`.
_PRODUCTS = (0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)


@dataclass(frozen=True, eq=False)
class Groups:
    """The groups of both faces and their moments, in the frame of the face that is seen.

    Attributes:
        per_family: K, ≥ 1: half of a face's groups.
        warp_count: how many of a face's groups are the warp's [2].
        centroids: [2 faces, 2 K, FEATURES]: `FEATURE_WEIGHTS` times features of points.
        hole_fraction: fraction of the repeat without yarn [2].
        normal: mean normal, shorter than 1 [2, 2 K, 3].
        tangent: mean fibre direction, shorter than 1 [2, 2 K, 3].
        covariance: of the fibre direction [2, 2 K, 3, 3]; its trace is 1 − |tangent|².
    """

    per_family: int
    warp_count: NDArray[np.intp]
    centroids: NDArray[np.float32]
    hole_fraction: NDArray[np.float64]
    normal: NDArray[np.float64]
    tangent: NDArray[np.float64]
    covariance: NDArray[np.float64]

    @property
    def count(self) -> int:
        """Groups of a face: 2 K."""
        return 2 * self.per_family


class NearestGroup:
    """Assigns points to groups on one backend."""

    def __init__(self, groups: Groups, types: ArrayTypes) -> None:
        self._types = types
        rows = np.zeros((2, groups.count, _ROW), np.float32)
        rows[..., :FEATURES] = groups.centroids
        self._centroids = upload(types.Float, rows)
        self._warp_count = [dr.opaque(types.UInt32, int(count)) for count in groups.warp_count]
        self.hole_index = dr.opaque(types.UInt32, groups.count)
        self._per_family = dr.opaque(types.UInt32, groups.per_family)
        self._bytes_of_family = dr.opaque(types.UInt32, 4 * pack_count(groups.per_family) // 2)

    def find_byte(self, back: Mask, point: SurfacePoint) -> UInt:
        """Byte of the group of a point in the packs of a face; holes have the first one of a last pack."""
        group = self.find(back, SurfaceHits.of(point, point.hole))
        of_weft = group - self._per_family + self._bytes_of_family
        byte = dr.select(group < self._per_family, group, of_weft)
        return dr.select(group == self.hole_index, 2 * self._bytes_of_family, byte)

    def find(self, back: Mask, hits: SurfaceHits) -> UInt:
        """Index of the group of the point's own family with the nearest centroid; 2 K in holes."""
        types, is_warp, width = self._types, hits.is_warp, dr.width(hits.normal)
        warp_count = dr.select(back, self._warp_count[1], self._warp_count[0])
        first = dr.select(is_warp, 0, warp_count)
        end = dr.select(is_warp, warp_count, self.hole_index)
        row_of_face = dr.select(back, self.hole_index, 0)
        features = [float(w) * part for w, part in zip(FEATURE_WEIGHTS, hits.features(), strict=True)]

        def compare(group: UInt, least: Float, nearest: UInt) -> tuple[UInt, Float, UInt]:
            centroid = dr.gather(types.Vectors, self._centroids, row_of_face + group, shape=(_ROW, width))
            distance = types.Float(0)
            for feature, of_centroid in zip(features, list(centroid)[: len(features)], strict=True):
                offset = feature - of_centroid
                distance = dr.fma(offset, offset, distance)
            closer = distance < least
            return group + 1, dr.select(closer, distance, least), dr.select(closer, group, nearest)

        start = dr.zeros(types.UInt32, width) + first
        state = start, dr.full(types.Float, _FAR, width), types.UInt32(start)
        nearest = dr.while_loop(state, lambda group, least, nearest: group < end, compare)[2]
        return dr.select(hits.hole, self.hole_index, nearest)


def find_groups(top_down: TopDownSamples, from_views: FaceSamples, per_family: int) -> Groups:
    """Clusters the surface of both faces into groups, 2 `per_family` a face.

    Where `per_family` is a multiple of 4, the family that more views hit may have more of them, by fours,
    which lowers the error. Groups of a family that a face never shows get a normal along z.

    Args:
        from_views: hits of views from the whole hemisphere, which groups are fitted to: yarn that dives under
            other yarns is a large part of the top-down samples, and seldom visible.
    """
    top_down_families, view_families = top_down.by_family(), from_views.by_family()
    hits = [len(family) for family in view_families]
    points_of_family = [
        FEATURE_WEIGHTS * from_views.features[_thinned(hit)]
        if len(shown) and len(hit) >= MIN_VIEW_SAMPLES
        else FEATURE_WEIGHTS * top_down.features[_thinned(shown)]
        for shown, hit in zip(top_down_families, view_families, strict=True)
    ]
    max_clusters = max(per_family, 2 * per_family - GROUPS_PER_PACK)
    clusters = parallel_map(lambda points: BisectingClusters(points, max_clusters), points_of_family)
    warp_count = [
        _best_warp_count(clusters[face : face + 2], hits[face : face + 2], per_family) for face in (0, 2)
    ]
    counts = [count for warp in warp_count for count in (warp, 2 * per_family - warp)]
    means = [
        family.refined_means(count) if family.size else np.tile([0, 0, NORMAL_WEIGHT, 0, 1, 0, 0], (count, 1))
        for family, count in zip(clusters, counts, strict=True)
    ]
    centroids = np.concatenate(means).reshape(2, 2 * per_family, FEATURES).astype(np.float32)
    tangent = centroids[..., 3:6].astype(np.float64)
    # Until views are counted: fibre directions around the centroid, with the same variance along all axes.
    variance = np.maximum(1 - np.square(tangent).sum(axis=-1), 0)
    return Groups(
        per_family,
        np.array(warp_count, np.intp),
        centroids,
        np.full(2, top_down.hole_fraction),
        centroids[..., :3].astype(np.float64) / NORMAL_WEIGHT,
        tangent,
        variance[..., None, None] / 3 * np.eye(3),
    )


def _thinned(indices: NDArray[np.intp]) -> NDArray[np.intp]:
    """At most `CLUSTERED_SAMPLES` of them, evenly: every k-th one would favour some positions."""
    if len(indices) <= CLUSTERED_SAMPLES:
        return indices
    fractions = np.arange(CLUSTERED_SAMPLES, dtype=np.uint64) * np.uint64(GOLDEN_FRACTION) & np.uint64(
        0xFFFFFFFF
    )
    return indices[(fractions * np.uint64(len(indices)) >> np.uint64(32)).astype(np.intp)]


def _best_warp_count(clusters: Sequence[BisectingClusters], hits: Sequence[int], per_family: int) -> int:
    """Number of a face's 2 `per_family` groups that the warp gets: the one of the least mean squared error.

    Args:
        clusters: of the face's warp and weft.
        hits: how often views hit either.
    """
    total = 2 * per_family
    if total % (2 * GROUPS_PER_PACK) or not all(family.size for family in clusters):
        return per_family
    warp, weft = clusters

    def error(warp_count: int) -> float:
        return warp.error(warp_count) * hits[0] + weft.error(total - warp_count) * hits[1]

    # Of equal errors, the most even split.
    return min(
        range(GROUPS_PER_PACK, total, GROUPS_PER_PACK),
        key=lambda count: (error(count), abs(count - per_family)),
    )


def with_view_moments(groups: Groups, sums: NDArray[np.float64]) -> Groups:
    """The groups with moments of the points that views hit, each weighted by its hits.

    Yarn that dives under other yarns is steep and seldom visible: with top-down samples the spread of a group
    would be up to five times the visible one. A group that few views hit keeps its moments.

    Args:
        sums: over the views that hit each group [2, 2 K, 13]; see `visibility.VIEW_SUMS`.
    """
    hits = sums[..., :1]
    means = sums[..., 1:] / np.maximum(hits, 1)
    normal, tangent = means[..., :3], means[..., 3:6]
    covariance = -tangent[..., :, None] * tangent[..., None, :]
    for (i, j), product in zip(_PRODUCTS, np.moveaxis(means[..., 6:], -1, 0), strict=True):
        covariance[..., i, j] += product
        covariance[..., j, i] = covariance[..., i, j]
    few = hits < MIN_VIEW_HITS
    return replace(
        groups,
        normal=np.where(few, groups.normal, normal),
        tangent=np.where(few, groups.tangent, tangent),
        covariance=np.where(few[..., None], groups.covariance, covariance),
    )


def stand_ins(groups: Groups, coverage: NDArray[np.float64], seen: NDArray[np.float64]) -> NDArray[np.intp]:
    """The group of the same face [2, 2 K] that each group lies where it lies: mostly itself.

    Flanks below the edges of yarns are hidden from straight above, where coverage is counted. They lie where
    that group of their family does which looks most like them among those that show.

    Args:
        coverage: of the repeat, by each group [2, 2 K].
        seen: the largest projected area of each group [2, 2 K].
    """
    hidden = coverage < HIDDEN_SHARE * np.maximum(seen, 1e-9)
    is_warp = np.arange(groups.count) < groups.warp_count[:, None]
    other = hidden[:, None] | (is_warp[:, :, None] != is_warp[:, None])
    offset = groups.centroids[:, :, None] - groups.centroids[:, None]
    distance = np.where(other, np.inf, np.square(offset).sum(axis=-1))
    itself = ~hidden | np.isinf(distance).all(axis=-1)
    return np.where(itself, np.arange(groups.count), distance.argmin(axis=-1))
