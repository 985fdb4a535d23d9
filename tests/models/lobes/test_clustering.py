"""Bisecting splits and k-means against formulas in double precision."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.models.lobes.groups import FEATURES, BisectingClusters

PER_FAMILY = 8
# Means are double precision, of up to 2048 coordinates that are rounded to four decimals.
ROUNDING = 1e-12


def _cloud(count: int, seed: int) -> NDArray[np.float64]:
    rng = np.random.default_rng(seed)
    return rng.normal(size=(count, 6)) * [1, 0.5, 0.2, 0.6, 0.1, 0.1] + rng.normal(size=6)


def _squared_error(points: NDArray[np.float64]) -> float:
    return float(np.square(points - points.mean(axis=0)).sum())


def _split_by_numpy(points: NDArray[np.float64], count: int) -> list[NDArray[np.float64]]:
    """The clusters that bisecting splits make."""
    clusters = [points]
    while len(clusters) < count:
        widest = max(range(len(clusters)), key=lambda number: _squared_error(clusters[number]))
        cluster = clusters[widest]
        offsets = cluster - cluster.mean(axis=0)
        along = offsets @ np.linalg.eigh(offsets.T @ offsets)[1][:, -1]
        boundary = 0.0
        for _ in range(4):
            boundary = 0.5 * (along[along > boundary].mean() + along[along <= boundary].mean())
        clusters[widest] = cluster[along <= boundary]
        clusters.append(cluster[along > boundary])
    return clusters


def _k_means_by_numpy(points: NDArray[np.float64], means: NDArray[np.float64]) -> NDArray[np.float64]:
    """Means after two steps of k-means."""
    for _ in range(2):
        nearest = np.square(points[:, None] - means).sum(axis=2).argmin(axis=1)
        means = np.array([points[nearest == number].mean(axis=0) for number in range(len(means))])
    return means


def _sorted(means: NDArray[np.float64]) -> NDArray[np.float64]:
    return means[np.lexsort(means.T)]


@pytest.mark.parametrize(("count", "clusters"), [(100, 2), (2048, 2), (1500, 5), (2048, 12)])
def test_clusters_are_those_of_an_eigensolver(count: int, clusters: int) -> None:
    points = _cloud(count, count + clusters).round(4)
    actual = BisectingClusters(points, 16)
    expected = _split_by_numpy(points, clusters)
    means = np.array([cluster.mean(axis=0) for cluster in expected])
    np.testing.assert_allclose(_sorted(actual.means(clusters)), _sorted(means), atol=ROUNDING)
    error = sum(map(_squared_error, expected)) / count
    assert actual.error(clusters) == pytest.approx(error, rel=ROUNDING)


def test_refined_means_are_those_of_k_means() -> None:
    points = _cloud(2000, 3).round(4)
    actual = BisectingClusters(points, 12)
    for count in (1, 2, 12):
        expected = _k_means_by_numpy(points, actual.means(count))
        np.testing.assert_allclose(actual.refined_means(count), expected, atol=ROUNDING)


def test_as_many_clusters_as_there_can_be() -> None:
    actual = BisectingClusters(_cloud(2048, 12), 128)
    assert actual.size == 2048
    assert len(np.unique(actual.refined_means(128).round(6), axis=0)) == 128
    errors = [actual.error(count) for count in range(1, 129)]
    # Each split lowers it.
    assert (np.diff(errors) < 0).all()


def test_no_points() -> None:
    actual = BisectingClusters(np.zeros((0, FEATURES)), 12)
    assert actual.size == 0
    assert actual.error(4) == 0
    assert actual.refined_means(4).shape == (4, FEATURES)


@pytest.mark.parametrize("count", [1, 100, 2047])
def test_fewer_different_points_than_clusters(count: int) -> None:
    """Flat threads of one direction: one point, eight clusters of it, whatever its mean is rounded to."""
    rng = np.random.default_rng(count)
    for point in ([0, 0, 0.5, 1, 0, 0.0], *rng.uniform(-1, 1, (200, 6)).round(4)):
        actual = BisectingClusters(np.tile(point, (count, 1)), PER_FAMILY)
        expected = np.tile(point, (PER_FAMILY, 1))
        np.testing.assert_allclose(actual.refined_means(PER_FAMILY), expected, atol=ROUNDING)


def test_three_different_points_are_three_clusters() -> None:
    points = np.eye(6)[[0, 1, 1, 2, 2, 2]]
    actual = BisectingClusters(points, PER_FAMILY)
    assert len(np.unique(actual.refined_means(PER_FAMILY).round(9), axis=0)) == 3
    assert actual.error(2) > actual.error(3) == pytest.approx(0, abs=ROUNDING)
    assert actual.error(PER_FAMILY) == actual.error(3)


def test_splits_are_where_points_part() -> None:
    """Four heaps of different size: each is a cluster, whatever the order of the points."""
    rng = np.random.default_rng(5)
    heaps = np.zeros((4, 6))
    heaps[:, :2] = [[0, 0], [1, 0.1], [0, 1.2], [1.1, 1]]
    heap = rng.permutation(np.repeat(np.arange(4), [300, 100, 50, 550]))
    features = heaps[heap] + 0.02 * rng.normal(size=(len(heap), 6))
    for order in (np.arange(len(heap)), rng.permutation(len(heap))):
        means = BisectingClusters(features[order], 4).refined_means(4)
        for number in range(4):
            distance = np.linalg.norm(means - features[heap == number].mean(axis=0), axis=1)
            # Coordinates are rounded to four decimals.
            assert distance.min() < 1e-4


def test_refining_lowers_the_error_and_splits_lower_it_far() -> None:
    """Steps of k-means only lower the sum of squared distances."""
    rng = np.random.default_rng(6)
    features = rng.normal(size=(1000, 6)) * [1, 0.5, 0.2, 0.6, 0.1, 0.1]

    def error(means: NDArray[np.float64]) -> float:
        return float(np.square(features[:, None] - means).sum(axis=2).min(axis=1).mean())

    actual = BisectingClusters(features, 8)
    assert error(actual.refined_means(8)) < error(actual.means(8)) < 0.5 * error(actual.means(1))
    # Until steps of k-means each point counts with its own cluster, near another's mean or not. Rounding to
    # four decimals moves squared distances of about 1 by 1e-4 at most.
    assert error(actual.means(8)) <= actual.error(8) + 1e-4
