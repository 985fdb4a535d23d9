"""Clustering by bisecting split: the cluster with the largest squared error is split in two, again and again.

A cluster is split across the principal axis of its points (Orchard and Bouman 1991, "Color Quantization of
Images"), where 2-means along that axis puts the boundary. Nothing is random: clusters grown from random
centroids make pictures of the same cloth whose error varies by up to a third.
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

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
