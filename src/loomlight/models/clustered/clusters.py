"""Clusters of texels that light and half vectors treat alike: k-means (zhu2024 4.2)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from loomlight.models.clustered.features import FeatureMaps

NO_CLUSTER = 255
_TRAINING = 1 << 13
_ROUNDS = 24
# Weights of the squared differences of normals and of fibre directions; that of horizons is 1, their mean
# over azimuths of the squared difference of sines.
_NORMAL, _TANGENT = 1.0, 2.0


def label_texels(maps: FeatureMaps, per_face: int) -> NDArray[np.uint8]:
    """The cluster of every texel [2 faces, rows, columns]; `NO_CLUSTER` in holes.

    Visibility decides as in the paper, by the horizons themselves instead of the parameters of lobes fitted
    to them, and so do normal and fibre direction, as the attenuation of the fibre layer depends on them.
    The first half of the clusters of a face is the warp's.

    Args:
        per_face: clusters, an even number.
    """
    labels = np.full(maps.hole.shape, NO_CLUSTER, np.uint8)
    half = per_face // 2
    for face in (0, 1):
        for first, family in ((0, maps.is_warp[face]), (half, ~maps.is_warp[face])):
            of_family = family & ~maps.hole[face]
            if of_family.any():
                labels[face][of_family] = first + _k_means(_features(maps, face, of_family), half)
    return labels


def _features(maps: FeatureMaps, face: int, chosen: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Vectors whose squared distance is the dissimilarity of texels [n, 22]."""
    horizon = maps.horizon[face][chosen].astype(np.float32) / (255 * 4)
    normal = maps.normal[face][chosen] * np.float32(_NORMAL**0.5)
    tangent = maps.tangent[face][chosen] * np.float32(_TANGENT**0.5)
    return np.concatenate([horizon, normal, tangent], axis=1)


def _k_means(points: NDArray[np.float32], count: int) -> NDArray[np.uint8]:
    """The nearest of `count` means for each point [n]; the same for the same points."""
    rng = np.random.default_rng(0)
    training = points[rng.permutation(len(points))[:_TRAINING]]
    # k-means++: each further mean is drawn in proportion to the squared distance from those before.
    means = training[:1]
    while len(means) < min(count, len(training)):
        distance = _squared_distances(training, means).min(axis=1)
        total = float(distance.sum())
        if total <= 0:
            break
        means = np.concatenate([means, training[[rng.choice(len(training), p=distance / total)]]])
    for _ in range(_ROUNDS):
        label = _squared_distances(training, means).argmin(axis=1)
        for number in range(len(means)):
            if (label == number).any():
                means[number] = training[label == number].mean(axis=0)
    found: NDArray[np.uint8] = _squared_distances(points, means).argmin(axis=1).astype(np.uint8)
    return found


def _squared_distances(points: NDArray[np.float32], means: NDArray[np.float32]) -> NDArray[np.float64]:
    """[n, k], never negative."""
    products = points @ means.T
    squares = np.square(points).sum(axis=1)[:, None] + np.square(means).sum(axis=1) - 2 * products
    return np.maximum(squares.astype(np.float64), 0)
