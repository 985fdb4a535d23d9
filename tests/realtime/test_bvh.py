"""The hierarchy holds every face once, within its boxes."""

from __future__ import annotations

import numpy as np
import pytest

from loomlight.realtime.scene import NO_FACE, build_hierarchy


@pytest.mark.parametrize("count", [1, 4, 5, 8, 23, 1000])
def test_every_face_is_in_one_leaf_within_all_its_boxes(count: int) -> None:
    rng = np.random.default_rng(count)
    positions = rng.normal(size=(3 * count, 3))
    faces = np.arange(3 * count, dtype=np.uint32).reshape(-1, 3)
    tree = build_hierarchy(positions, faces)
    held = tree.leaf_faces[tree.leaf_faces != NO_FACE]
    assert sorted(held) == list(range(count))
    assert tree.boxes.shape == (2 * tree.leaves - 1, 6)
    for leaf, row in enumerate(tree.leaf_faces):
        corners = positions[faces[row[row != NO_FACE]].ravel()]
        node = tree.leaves + leaf
        while node and len(corners):
            low, high = tree.boxes[node - 1, :3], tree.boxes[node - 1, 3:]
            assert (corners >= low - 1e-6).all(), node
            assert (corners <= high + 1e-6).all(), node
            node //= 2


def test_leaves_are_small_parts_of_a_sheet() -> None:
    """Boxes of the leaves of a sheet overlap little: their areas sum to about that of the sheet."""
    line = np.linspace(0, 1, 65)
    x, y = (part.ravel() for part in np.meshgrid(line, line))
    positions = np.stack([x, y, 0 * x], axis=1)
    corner = (np.arange(64)[:, None] * 65 + np.arange(64)).ravel()
    quads = np.stack([corner, corner + 1, corner + 66, corner + 65], axis=1)
    faces = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]).astype(np.uint32)
    tree = build_hierarchy(positions, faces)
    leaves = tree.boxes[tree.leaves - 1 :]
    sides = leaves[:, 3:5] - leaves[:, :2]
    assert sides.prod(axis=1).sum() < 1.5
