"""Clusters of texels whose visibility is alike: k-means (zhu2024 4.2)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from loomlight.models.clustered.features import FeatureMaps
from loomlight.models.clustered.gaussians import lobe_values
from loomlight.models.clustered.square_map import bin_centres

NO_CLUSTER = 255
_TRAINING = 1 << 13
_ROUNDS = 24
# Bins of directions a side.
_DIRECTIONS = 8


def label_texels(maps: FeatureMaps, lobes: NDArray[np.float32], per_face: int) -> NDArray[np.uint8]:
    """The cluster of every texel [2 faces, rows, columns]; `NO_CLUSTER` in holes.

    Visibility decides, by the values of the lobes towards directions all over the hemisphere: the paper takes
    their parameters, whose distance says less of it. The first half of the clusters of a face is the warp's.

    Args:
        lobes: see `Gaussians`.
        per_face: clusters, an even number.
    """
    labels = np.full(maps.hole.shape, NO_CLUSTER, np.uint8)
    half = per_face // 2
    for face in (0, 1):
        for first, family in ((0, maps.is_warp[face]), (half, ~maps.is_warp[face])):
            of_family = family & ~maps.hole[face]
            if of_family.any():
                labels[face][of_family] = first + _k_means(_features(maps, lobes, face, of_family), half)
    return labels


def _features(
    maps: FeatureMaps, lobes: NDArray[np.float32], face: int, chosen: NDArray[np.bool_]
) -> NDArray[np.float32]:
    """Vectors whose squared distance is the dissimilarity of texels [n, 16]."""
    of_family = lobes[face][chosen]
    seen = [lobe_values(of_family, direction) for direction in bin_centres(_DIRECTIONS)]
    return np.stack(seen, axis=1)


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
