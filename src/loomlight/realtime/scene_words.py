"""One buffer of words for what belongs to a scene: hierarchy, meshes, albedo maps, environment, lights.

Shaders bind few buffers; see `layout.BUFFERS`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.realtime.albedo_map import map_words
from loomlight.realtime.bvh import build_hierarchy
from loomlight.realtime.device import Adapter
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
        vertices: NDArray[np.void],
        faces: NDArray[np.uint32],
        fabrics: NDArray[np.uint32],
        albedos: Sequence[NDArray[np.floating] | None],
    ) -> None:
        """
        Args:
            positions: of all vertices [n, 3], metres.
            vertices: their records [n].
            faces: of all meshes [m, 3].
            fabrics: the number of the fabric of each face [m].
            albedos: the map of each cloth.
        """
        hierarchy = build_hierarchy(positions, faces)
        self._leaves = hierarchy.leaves
        parts = [hierarchy.boxes.ravel().view(np.uint32), hierarchy.leaf_faces.ravel()]
        parts += [faces.ravel(), fabrics, vertices.view(np.uint32)]
        begins = np.cumsum([part.size for part in parts])
        self._begins = dict(zip(("leaf_faces", "corners", "face_fabrics", "vertices"), begins, strict=False))
        first = int(begins[-1])
        self._maps: list[tuple[int, int]] = []
        for albedo in albedos:
            words, levels = (np.zeros(0, np.uint32), 0) if albedo is None else map_words(albedo)
            self._maps.append((first, levels))
            parts.append(words)
            first += words.size
        self._words = np.concatenate(parts)
        self._environment: EnvironmentTables | None = None
        self._buffer: Any = None
        self._first_light = 0
        centred = positions - positions.mean(axis=0)
        extents = np.sqrt(np.maximum(np.linalg.eigvalsh(centred.T @ centred), 0))
        self.is_flat = bool(extents[0] <= FLAT * extents[2])
        largest = float(np.abs(positions).max(initial=0.0))
        self._ray_offset = RAY_OFFSET * max(largest, float(np.ptp(positions, axis=0).max()))

    def describe(self, frame: NDArray[np.void]) -> None:
        """Writes into the record of a frame where the parts begin."""
        frame["leaves"] = self._leaves
        for name, begin in self._begins.items():
            frame[name] = begin
        frame["ray_offset"] = self._ray_offset
        frame["environment_table"] = self._words.size
        frame["light_records"] = self._first_light

    def describe_maps(self, fabrics: NDArray[np.void]) -> None:
        """Writes into the records of fabrics where their albedo maps begin."""
        for record, (first, levels) in zip(fabrics, self._maps, strict=True):
            record["albedo_map"], record["albedo_map_levels"] = first, levels

    def show(self, adapter: Adapter, environment: EnvironmentTables | None, lights: NDArray[np.void]) -> Any:
        """The buffer with this environment and these lights, by which frames are to be described then.

        Where it holds the environment already, or none is asked for, lights alone are written.
        """
        records = lights.view(np.uint32)
        is_held = self._buffer is not None and (environment is None or environment is self._environment)
        if is_held and self._buffer.size >= 4 * (self._first_light + records.size):
            adapter.write(self._buffer, records, 4 * self._first_light)
            return self._buffer
        self._environment = environment
        words = self._words if environment is None else np.concatenate([self._words, environment.words()])
        self._first_light = words.size
        self._buffer = adapter.storage(np.concatenate([words, records]))
        return self._buffer
