"""Normals of moving cloth: smooth where those of the first frame are, across seams of uv too."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from loomlight.mesh.cloth_mesh import ClothMesh, cross_products

# Normals at one place that differ by less are one: sharper edges are kept.
_SHARP = np.cos(np.radians(30))


@dataclass(frozen=True, eq=False)
class Smoothing:
    """The normals of a cloth, wherever its vertices are.

    Attributes:
        group: of each vertex [n]: those of a group share a normal.
        sign: of each triangle [m]: -1 where it is wound against the normals.
    """

    group: NDArray[np.int64]
    sign: NDArray[np.float64]

    @classmethod
    def of(cls, mesh: ClothMesh) -> Smoothing:
        """The groups of a mesh: vertices at one place whose normals are alike."""
        places = mesh.positions.astype(np.float32) + np.float32(0)
        _, place = np.unique(places.view(f"V{places.strides[0]}").ravel(), return_inverse=True)
        group = np.full(len(place), -1)
        left = np.arange(len(place))
        while len(left):
            # The first vertex left of each place, and those whose normals are like its own.
            own, first = np.unique(place[left], return_index=True)
            leader = left[first][np.searchsorted(own, place[left])]
            like = np.sum(mesh.normals[left] * mesh.normals[leader], axis=1) > _SHARP
            like |= left == leader
            group[left[like]] = leader[like]
            left = left[~like]
        of_corners = mesh.normals[mesh.triangles].sum(axis=1)
        against = np.sum(cross_products(mesh) * of_corners, axis=1) < 0
        return cls(np.unique(group, return_inverse=True)[1], np.where(against, -1.0, 1.0))

    def of_moved(self, mesh: ClothMesh) -> ClothMesh:
        """The mesh, moved, with its normals: means of those of the triangles around, by area."""
        weighted = cross_products(mesh) * self.sign[:, None]
        corners = self.group[mesh.triangles]
        count = int(self.group.max(initial=-1)) + 1
        total = np.stack(
            [
                np.sum([np.bincount(corner, weighted[:, axis], count) for corner in corners.T], axis=0)
                for axis in range(3)
            ],
            axis=1,
        )[self.group]
        length = np.linalg.norm(total, axis=1, keepdims=True)
        # Where all triangles around have no area now, what was before serves as well as anything.
        return replace(mesh, normals=np.where(length > 0, total / np.maximum(length, 1e-300), mesh.normals))
