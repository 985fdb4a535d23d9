"""Clustering by bisecting split: the cluster with the largest squared error is split in two, again and again.

A cluster is split across the principal axis of its points (Orchard and Bouman 1991, "Color Quantization of
Images"), where 2-means along that axis puts the boundary. Nothing is random: clusters grown from random
centroids make pictures of the same cloth whose error varies by up to a third.
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from loomlight.core.numba_kernel import numba_kernel

Doubles: TypeAlias = NDArray[np.float64]

# Coordinates of a point.
FEATURES = 6
# Points that agree in so many decimals are one, as those of a straight flat yarn are.
_DECIMALS = 4
# Steps of 2-means that place a boundary, and of k-means that refine all clusters.
BOUNDARY_STEPS, REFINING_STEPS = 4, 2
# Squarings of a covariance matrix: 2⁸ = 256 power iterations separate eigenvalues that differ by 2 %.
AXIS_SQUARINGS = 8


class BisectingClusters:
    """Points, and the hierarchy of clusters that bisecting splits make of them."""

    def __init__(self, points: NDArray[np.floating], max_clusters: int) -> None:
        """
        Args:
            points: coordinates [n, 6]; n = 0 is allowed.
            max_clusters: the largest count that the methods take, ≥ 1.
        """
        self._points = np.ascontiguousarray(np.round(points.T, _DECIMALS), np.float64)
        self._means = np.zeros((max_clusters, max_clusters, FEATURES))
        self._errors = np.zeros(max_clusters)
        size = len(points)
        # Fewer clusters than wanted where points coincide.
        self._distinct = _bisect(self._points.copy(), self._means, self._errors) if size else 1
        self._errors /= max(size, 1)

    @property
    def size(self) -> int:
        """Number of points."""
        return self._points.shape[1]

    def error(self, count: int) -> float:
        """Mean squared distance of the points from the mean of their own one of `count` clusters."""
        return float(self._errors[min(count, self._distinct) - 1])

    def means(self, count: int) -> Doubles:
        """Means of `count` clusters [count, 6]; with fewer distinct points, the first is repeated."""
        distinct = min(count, self._distinct)
        means = self._means[distinct - 1]
        return np.concatenate([means[:distinct], np.repeat(means[:1], count - distinct, axis=0)])

    def refined_means(self, count: int) -> Doubles:
        """`means` after a few steps of k-means [count, 6]."""
        means = self.means(count)
        _refine(self._points, means)
        return means


@numba_kernel()
def _bisect(points: Doubles, means: Doubles, errors: Doubles) -> int:
    """Fills the hierarchy, and returns how many clusters there are: fewer where points coincide.

    Args:
        points: [6, n]; they are reordered so that every cluster is contiguous.
        means: [k, k, 6]: in row k − 1, the means of k clusters.
        errors: [k]: sum of squared distances of all points from the means of k clusters.
    """
    most = len(errors)
    starts, stops = np.zeros(most, np.int64), np.zeros(most, np.int64)
    squares = np.zeros(most)
    covariance = np.zeros((most, FEATURES, FEATURES))
    scratch = np.zeros((FEATURES, FEATURES))
    along = np.zeros(points.shape[1])
    stops[0] = points.shape[1]
    squares[0] = _measure(points, 0, stops[0], means[0, 0], covariance[0])
    errors[0] = squares[0]
    for new in range(1, most):
        widest = 0
        for cluster in range(new):
            if squares[cluster] > squares[widest]:
                widest = cluster
        start, stop = starts[widest], stops[widest]
        axis = _principal_axis(covariance[widest], scratch)
        middle = _split(points, start, stop, means[new - 1, widest], axis, along)
        if not start < middle < stop:
            return new
        starts[new], stops[new], stops[widest] = middle, stop, middle
        for cluster in range(new):
            for k in range(FEATURES):
                means[new, cluster, k] = means[new - 1, cluster, k]
        squares[widest] = _measure(points, start, middle, means[new, widest], covariance[widest])
        squares[new] = _measure(points, middle, stop, means[new, new], covariance[new])
        for cluster in range(new + 1):
            errors[new] += squares[cluster]
    return most


@numba_kernel(any_sum_order=True)
def _measure(points: Doubles, start: int, stop: int, mean: Doubles, covariance: Doubles) -> float:
    """Mean [6] and scatter matrix [6, 6] of points [6, start:stop]; returns its trace."""
    # Slices tell LLVM that no index is negative, without which it does not vectorize.
    for k in range(FEATURES):
        total = 0.0
        for value in points[k, start:stop]:
            total += value
        mean[k] = total / (stop - start)
    trace = 0.0
    for k in range(FEATURES):
        for m in range(k + 1):
            first, second = points[k, start:stop], points[m, start:stop]
            total = 0.0
            for point in range(len(first)):
                total += (first[point] - mean[k]) * (second[point] - mean[m])
            covariance[k, m] = covariance[m, k] = total
        trace += covariance[k, k]
    return trace


@numba_kernel()
def _principal_axis(matrix: Doubles, square: Doubles) -> Doubles:
    """Eigenvector of the largest eigenvalue [6], not normalized; overwrites both matrices [6, 6].

    Repeated squaring leaves a multiple of its projector, of which the column with most is taken.
    """
    for _ in range(AXIS_SQUARINGS):
        trace = 1e-30
        for k in range(FEATURES):
            trace += matrix[k, k]
        for k in range(FEATURES):
            for m in range(FEATURES):
                total = 0.0
                for j in range(FEATURES):
                    total += matrix[k, j] * matrix[j, m]
                square[k, m] = total / (trace * trace)
        matrix, square = square, matrix
    largest = 0
    for k in range(FEATURES):
        if matrix[k, k] > matrix[largest, largest]:
            largest = k
    return matrix[largest]


@numba_kernel(any_sum_order=True)
def _split(points: Doubles, start: int, stop: int, mean: Doubles, axis: Doubles, along: Doubles) -> int:
    """Moves the half of points [6, start:stop] that lies farther along an axis last; returns its start.

    Args:
        along: scratch memory [n].
    """
    own = along[start:stop]
    own[:] = 0
    for k in range(FEATURES):
        column = points[k, start:stop]
        for point in range(len(own)):
            own[point] += axis[k] * (column[point] - mean[k])
    total = own.sum()
    boundary = 0.0
    for _ in range(BOUNDARY_STEPS):
        size_beyond, total_beyond = 0, 0.0
        for offset in own:
            size_beyond += offset > boundary
            total_beyond += offset if offset > boundary else 0.0
        size_before = len(own) - size_beyond
        if size_beyond > 0 and size_before > 0:
            boundary = 0.5 * (total_beyond / size_beyond + (total - total_beyond) / size_before)
    middle, last = start, stop - 1
    while middle <= last:
        if along[middle] <= boundary:
            middle += 1
        else:
            along[middle], along[last] = along[last], along[middle]
            for k in range(FEATURES):
                points[k, middle], points[k, last] = points[k, last], points[k, middle]
            last -= 1
    return middle


@numba_kernel()
def _refine(points: Doubles, means: Doubles) -> None:
    """Moves means [k, 6] by steps of k-means over points [6, n]; a cluster without points stays."""
    size = points.shape[1]
    nearest = np.zeros(size, np.int64)
    least = np.zeros(size)
    sums = np.zeros((len(means), FEATURES))
    sizes = np.zeros(len(means))
    for _ in range(REFINING_STEPS):
        least[:] = np.inf
        for cluster in range(len(means)):
            for point in range(size):
                distance = 0.0
                for k in range(FEATURES):
                    distance += (points[k, point] - means[cluster, k]) ** 2
                closer = distance < least[point]
                nearest[point] = cluster if closer else nearest[point]
                least[point] = distance if closer else least[point]
        sums[:] = 0
        sizes[:] = 0
        for point in range(size):
            sizes[nearest[point]] += 1
            for k in range(FEATURES):
                sums[nearest[point], k] += points[k, point]
        for cluster in range(len(means)):
            if sizes[cluster] > 0:
                for k in range(FEATURES):
                    means[cluster, k] = sums[cluster, k] / sizes[cluster]
