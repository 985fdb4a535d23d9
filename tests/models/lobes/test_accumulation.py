"""Groups of rays and sums over rays by group, against loops and formulas in double precision."""

from __future__ import annotations

import numpy as np
from drjit.llvm import Array3f, Bool, Float
from numpy.typing import NDArray

from loomlight.models.lobes.groups import FEATURES, NORMAL_WEIGHT, SHARE_WEIGHT, Groups
from loomlight.models.lobes.hemisphere import NODES, node_directions
from loomlight.models.lobes.rays import SurfaceHits, start_of_shadow_ray
from loomlight.models.lobes.visibility import (
    LIGHT_SUMS,
    VIEW_SUMS,
    group_of_hits,
    light_sums,
    view_sums,
)

RAYS, PER_FAMILY, WARP_COUNT = 256, 6, (8, 4)
GROUPS = 2 * PER_FAMILY
BLEND = 0.7
COUNT = 2 * NODES * RAYS
# Sums of up to 256 numbers up to 1 in single precision.
ROUNDING = 1e-4
PRODUCTS = (0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)


def _unit_vectors(rng: np.random.Generator, count: int) -> NDArray[np.float32]:
    """Unit vectors [3, n]."""
    vectors = rng.normal(size=(3, count))
    return (vectors / np.linalg.norm(vectors, axis=0)).astype(np.float32)


class _Rays:
    """Random hits, and the group of each by numpy; GROUPS where nothing counts."""

    def __init__(self, seed: int) -> None:
        rng = np.random.default_rng(seed)
        self.is_warp = rng.random(COUNT) < 0.6
        self.is_skipped = rng.random(COUNT) < 0.1
        self.normal, self.tangent = _unit_vectors(rng, COUNT), _unit_vectors(rng, COUNT)
        self.is_lit = rng.random(COUNT) < 0.5
        self.share = rng.random(COUNT).astype(np.float32)
        centroids = (0.6 * rng.normal(size=(2, GROUPS, FEATURES))).astype(np.float32)
        is_warp_group = np.arange(GROUPS) < np.array(WARP_COUNT)[:, None]
        none = np.zeros(0)
        self.groups = Groups(PER_FAMILY, np.array(WARP_COUNT), centroids, none, none, none, none)
        features = self.features().T
        self.group = np.full(COUNT, GROUPS)
        for face, rays in enumerate(np.split(np.arange(COUNT), 2)):
            distance = np.square(features[rays, None] - centroids[face]).sum(axis=2)
            distance[is_warp_group[face] != self.is_warp[rays, None]] = np.inf
            self.group[rays] = np.where(self.is_skipped[rays], GROUPS, distance.argmin(axis=1))

    def features(self) -> NDArray[np.float32]:
        """What groups are told apart by [FEATURES, n]."""
        weighted = (
            np.float32(NORMAL_WEIGHT) * self.normal,
            self.tangent,
            np.float32(SHARE_WEIGHT) * self.share[None],
        )
        return np.concatenate(weighted)

    def found(self) -> NDArray[np.uint32]:
        """The group of each by Dr.Jit."""
        vectors = Array3f(self.normal), Array3f(self.tangent)
        hits = SurfaceHits(Bool(self.is_warp), Bool(self.is_skipped), *vectors, Float(self.share))
        return group_of_hits(hits, Bool(self.is_skipped), self.groups)

    def sums(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Sums of values [n] by face, node and group."""
        block = np.arange(COUNT) // RAYS
        counts = self.group < GROUPS
        place = block[counts] * GROUPS + self.group[counts]
        return np.bincount(place, values[counts], 2 * NODES * GROUPS).reshape(2, NODES, GROUPS)


def test_hits_are_of_the_nearest_group() -> None:
    rays = _Rays(1)
    found = rays.found()
    # Of as good as equal distances, either is right: in single precision few of 131,072 differ.
    assert np.mean(found != rays.group) < 1e-4
    np.testing.assert_array_equal(found == GROUPS, rays.is_skipped)


def test_views_are_summed_by_group() -> None:
    rays = _Rays(1)
    actual = view_sums(rays.normal, rays.tangent, rays.group.astype(np.uint32), GROUPS)
    normal, tangent = rays.normal.astype(float), rays.tangent.astype(float)
    expected = [np.ones(COUNT), *normal, *tangent, *(tangent[i] * tangent[j] for i, j in PRODUCTS)]
    assert len(expected) == VIEW_SUMS
    np.testing.assert_array_equal(actual[..., 0], rays.sums(expected[0]))
    for number, values in enumerate(expected):
        np.testing.assert_allclose(actual[..., number], rays.sums(values), atol=ROUNDING)


def test_light_is_summed_by_group() -> None:
    """Shadow rays start from hits of all views, each from one; light from behind lights the side of −n."""
    rays = _Rays(2)
    is_lit_behind = np.random.default_rng(5).random(COUNT) < 0.3
    is_lit = rays.is_lit, is_lit_behind
    actual = light_sums(rays.normal, rays.group.astype(np.uint32), is_lit, GROUPS, BLEND)
    node, ray = np.divmod(np.arange(NODES * RAYS), RAYS)
    starts = start_of_shadow_ray(node, ray, RAYS)
    assert len(np.unique(starts)) == len(starts)
    start = np.concatenate([starts, NODES * RAYS + starts])
    light = np.tile(np.repeat(node_directions().T, RAYS, axis=1), 2)
    normal = rays.normal[:, start]
    facing, opposite = (normal * light).sum(axis=0), -(normal * light * [[1], [1], [-1]]).sum(axis=0)
    expected = [np.ones(COUNT), rays.is_lit.astype(float), is_lit_behind.astype(float)]
    for lit, cosine in ((rays.is_lit, facing), (is_lit_behind, opposite)):
        expected.append(lit * (BLEND * np.maximum(cosine, 0) + (1 - BLEND) * light[2]))
    assert len(expected) == LIGHT_SUMS
    rays.group = rays.group[start]
    for number, values in enumerate(expected):
        np.testing.assert_allclose(actual[..., number], rays.sums(values), atol=ROUNDING)


def test_a_ray_counts_where_its_face_has_such_groups() -> None:
    """Groups of the other family are left out, however near; a face's own are taken."""
    rays = _Rays(3)
    number = NODES * RAYS + 5
    rays.is_warp[number] = rays.is_skipped[number] = False
    # A centroid of the back's warp lies right there, and one of its weft hardly farther.
    features = rays.features()[:, number]
    rays.groups.centroids[1, 0] = features
    rays.groups.centroids[1, 7] = features + 0.01
    assert rays.found()[number] == 7
