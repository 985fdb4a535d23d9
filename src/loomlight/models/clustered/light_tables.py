"""Visibility of each cluster by the direction of the light: means over its texels (zhu2024 4.2)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from loomlight.core.parallel_map import parallel_map
from loomlight.models.clustered.gaussians import LOBE_NUMBERS, lobe_values
from loomlight.models.clustered.square_map import bin_centres

# Texels of a cluster that stand for all.
_TEXELS = 1024


def light_tables(lobes: NDArray[np.float32], labels: NDArray[np.uint8], clusters: int) -> NDArray[np.float32]:
    """v̄, the mean visibility of clusters [2 faces, 2 sides, bins, clusters]; side 1 is light from behind.

    Args:
        lobes: see `Gaussians`.
    """
    directions = bin_centres()
    table = np.zeros((2, 2, len(directions), clusters), np.float32)
    rng = np.random.default_rng(0)
    for face in (0, 1):
        flat = labels[face].ravel()
        order = rng.permutation(flat.size)
        parts = [order[flat[order] == cluster][:_TEXELS] for cluster in range(clusters)]
        sizes = np.array([len(part) for part in parts])
        texels = np.concatenate(parts)
        present = np.flatnonzero(sizes)
        starts = (np.cumsum(sizes) - sizes)[present]
        for side in (0, 1):
            # Light from the other side falls on the other face, whose lobes are in its own frame.
            seen = lobes[face ^ side].reshape(-1, LOBE_NUMBERS)[texels]

            def of_direction(
                direction: NDArray[np.float64],
                seen: NDArray[np.float32] = seen,
                starts: NDArray[np.intp] = starts,
            ) -> NDArray[np.float32]:
                return np.add.reduceat(lobe_values(seen, direction), starts)

            sums = np.stack(parallel_map(of_direction, directions))
            table[face, side][:, present] = sums / sizes[present]
    return table
