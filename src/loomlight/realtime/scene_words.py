"""One buffer of words for what belongs to a scene: bounding volume hierarchy, albedo maps, environment."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.realtime.albedo_map import map_words
from loomlight.realtime.bvh import build_hierarchy
from loomlight.realtime.environment import EnvironmentTables

# Rays leave surfaces by so much of the scene's extent: coordinates in float32 are rounded by 6e-8 of it.
RAY_OFFSET = 2e-6
# Meshes that are thinner, relative to their extent, are flat.
FLAT = 1e-7


class SceneWords:
    """The words of a scene, and where its parts begin.

    Attributes:
        is_flat: no face can hide another from a light.
    """

    def __init__(
        self,
        positions: NDArray[np.float64],
        faces: NDArray[np.uint32],
        albedos: Sequence[NDArray[np.floating] | None],
    ) -> None:
        """
        Args:
            positions: of all vertices [n, 3], metres.
            faces: of all meshes [m, 3].
            albedos: the map of each cloth.
        """
        hierarchy = build_hierarchy(positions, faces)
        self._leaves = hierarchy.leaves
        self._leaf_faces = hierarchy.boxes.size
        parts = [hierarchy.boxes.ravel().view(np.uint32), hierarchy.leaf_faces.ravel()]
        first = sum(part.size for part in parts)
        self._maps: list[tuple[int, int]] = []
        for albedo in albedos:
            words, levels = (np.zeros(0, np.uint32), 0) if albedo is None else map_words(albedo)
            self._maps.append((first, levels))
            parts.append(words)
            first += words.size
        self._words = np.concatenate(parts)
        self._environment: EnvironmentTables | None = None
        self._is_stored = False
        centred = positions - positions.mean(axis=0)
        extents = np.sqrt(np.maximum(np.linalg.eigvalsh(centred.T @ centred), 0))
        self.is_flat = bool(extents[0] <= FLAT * extents[2])
        largest = float(np.abs(positions).max(initial=0.0))
        self._ray_offset = RAY_OFFSET * max(largest, float(np.ptp(positions, axis=0).max()))

    def describe(self, frame: NDArray[np.void]) -> None:
        """Writes into the record of a frame where the parts begin."""
        frame["leaves"] = self._leaves
        frame["leaf_faces"] = self._leaf_faces
        frame["ray_offset"] = self._ray_offset
        frame["environment_table"] = self._words.size

    def describe_maps(self, fabrics: NDArray[np.void]) -> None:
        """Writes into the records of fabrics where their albedo maps begin."""
        for record, (first, levels) in zip(fabrics, self._maps, strict=True):
            record["albedo_map"], record["albedo_map_levels"] = first, levels

    def show_environment(
        self, environment: EnvironmentTables | None, store: Callable[[str, NDArray[Any]], None]
    ) -> None:
        """Stores the buffer if it does not hold this environment already."""
        if self._is_stored and (environment is None or environment is self._environment):
            return
        words = self._words if environment is None else np.concatenate([self._words, environment.words()])
        store("scene_words", words)
        self._environment, self._is_stored = environment, True
