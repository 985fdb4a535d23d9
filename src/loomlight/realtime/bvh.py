"""A bounding volume hierarchy over triangles: a complete binary tree, split at medians, built with NumPy."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

FACES_A_LEAF = 4
NO_FACE = 0xFFFFFFFF


@dataclass(frozen=True, eq=False)
class Hierarchy:
    """Boxes of a complete binary tree, and the faces of its leaves.

    Attributes:
        boxes: lower and upper corners of node 1, 2, 3 … [2·leaves − 1, 6]; below node n are 2n and 2n + 1.
        leaf_faces: [leaves, 4], `NO_FACE` for none.
    """

    boxes: NDArray[np.float32]
    leaf_faces: NDArray[np.uint32]

    @property
    def leaves(self) -> int:
        """Their number, a power of 2."""
        return len(self.leaf_faces)


def build_hierarchy(positions: NDArray[np.float64], faces: NDArray[np.uint32]) -> Hierarchy:
    """The hierarchy of triangles: every node is split at the median of its longest side.

    Args:
        positions: [n, 3].
        faces: [m, 3], m ≥ 1.
    """
    corners = positions[faces]
    low, high = corners.min(axis=1), corners.max(axis=1)
    centres = (low + high) / 2
    depth = max(0, int(np.ceil(np.log2(len(faces) / FACES_A_LEAF))))
    leaves = 1 << depth
    # Places of the leaves; those behind the last face stay empty, and at the end of every node.
    order = np.full((1, leaves * FACES_A_LEAF), -1)
    order[0, : len(faces)] = np.arange(len(faces))
    for _ in range(depth):
        order = _split(order, centres)
    leaf_faces = order.reshape(leaves, FACES_A_LEAF)
    is_empty = leaf_faces < 0
    leaf_low = np.where(is_empty[..., None], np.inf, low[leaf_faces]).min(axis=1)
    leaf_high = np.where(is_empty[..., None], -np.inf, high[leaf_faces]).max(axis=1)
    levels = [np.concatenate([leaf_low, leaf_high], axis=1)]
    while len(levels[-1]) > 1:
        pairs = levels[-1].reshape(-1, 2, 6)
        levels.append(np.concatenate([pairs[..., :3].min(axis=1), pairs[..., 3:].max(axis=1)], axis=1))
    boxes = np.concatenate(levels[::-1])
    # Boxes of nothing become a point far away: shading languages may take infinite numbers for NaN.
    boxes[(boxes[:, :3] > boxes[:, 3:]).any(axis=1)] = 1e30
    boxes = boxes.astype(np.float32)
    return Hierarchy(boxes, np.where(is_empty, NO_FACE, leaf_faces).astype(np.uint32))


def _split(order: NDArray[np.int64], centres: NDArray[np.float64]) -> NDArray[np.int64]:
    """Halves of all nodes of one level [2·nodes, places / 2], each sorted along its longest side."""
    is_empty = order < 0
    points = centres[order]
    low = np.where(is_empty[..., None], np.inf, points).min(axis=1)
    high = np.where(is_empty[..., None], -np.inf, points).max(axis=1)
    axis = np.argmax(np.where(high >= low, high - low, 0), axis=1)
    keys = np.take_along_axis(points, axis[:, None, None], axis=2)[..., 0]
    keys[is_empty] = np.inf
    by_key = np.take_along_axis(order, np.argsort(keys, axis=1, kind="stable"), axis=1)
    # Both halves get as many faces: leaves then are alike, and few are empty.
    count = (by_key >= 0).sum(axis=1)
    half = order.shape[1] // 2
    place = np.arange(half)
    first = (count + 1) // 2
    left = np.where(place < first[:, None], by_key[:, :half], -1)
    from_right = np.minimum(place + first[:, None], order.shape[1] - 1)
    right = np.where(
        place + first[:, None] < count[:, None], np.take_along_axis(by_key, from_right, axis=1), -1
    )
    return np.stack([left, right], axis=1).reshape(-1, half)
