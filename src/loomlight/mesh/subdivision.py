"""Catmull–Clark subdivision: polygons as finer quadrilaterals of a smooth surface.

Rules and terms are those of OpenSubdiv: borders are smooth curves, corners of one face stay where they are,
and creases are sharp for as many levels as their sharpness says, rounded.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class Polygons:
    """The faces of a mesh, to be subdivided once.

    Attributes:
        corners: vertices of all faces, one face after the other.
        counts: corners of each face, at least three.
        points: number of vertices.
        creases: vertices of both ends of sharp edges [s, 2].
        sharpness: levels [s] for which they stay sharp.
    """

    corners: Indices
    counts: Indices
    points: int
    creases: Indices
    sharpness: Floats

    @cached_property
    def face(self) -> Indices:
        """The face of each corner, and so of each face of the next level."""
        return np.repeat(np.arange(len(self.counts)), self.counts)

    @cached_property
    def _following(self) -> Indices:
        last = np.cumsum(self.counts) - 1
        following = np.arange(1, len(self.corners) + 1)
        following[last] = last - self.counts + 1
        return following

    @cached_property
    def _preceding(self) -> Indices:
        preceding = np.empty_like(self._following)
        preceding[self._following] = np.arange(len(preceding))
        return preceding

    @cached_property
    def _edges(self) -> tuple[Indices, Indices]:
        """Both vertices of each edge [e, 2], the lower first; the edge from each corner to the following."""
        ends = np.sort(np.stack([self.corners, self.corners[self._following]], axis=1), axis=1)
        keys, edge = np.unique(ends[:, 0] * self.points + ends[:, 1], return_inverse=True)
        return np.stack(np.divmod(keys, self.points), axis=1), edge

    @cached_property
    def _is_sharp(self) -> NDArray[np.bool_]:
        """Edges of other than two faces, and those of creases."""
        ends, edge = self._edges
        low, high = np.sort(self.creases, axis=1).T
        creased = (low * self.points + high)[self.sharpness >= 0.5]
        return (np.bincount(edge, minlength=len(ends)) != 2) | np.isin(
            ends[:, 0] * self.points + ends[:, 1], creased
        )

    def finer(self) -> Polygons:
        """The faces of the next level: a quadrilateral for each corner, which it begins with."""
        ends, edge = self._edges
        on_edge = self.points + edge
        corners = np.stack(
            [self.corners, on_edge, self.points + len(ends) + self.face, on_edge[self._preceding]], axis=1
        )
        key = ends[:, 0] * self.points + ends[:, 1]
        low, high = np.sort(self.creases, axis=1).T
        at = np.clip(np.searchsorted(key, low * self.points + high), 0, len(key) - 1)
        there = key[at] == low * self.points + high
        middle = self.points + at[there]
        return Polygons(
            corners=corners.ravel(),
            counts=np.full(len(corners), 4),
            points=self.points + len(ends) + len(self.counts),
            creases=np.concatenate([np.stack([side[there], middle], axis=1) for side in (low, high)]),
            sharpness=np.tile(self.sharpness[there] - 1, 2),
        )

    def moved(self, positions: Floats) -> Floats:
        """The vertices of the next level [n, k]: of vertices, of edges and of faces."""
        ends, edge = self._edges
        of_face = self._mean(positions[self.corners])
        ends_of = positions[ends]
        middle = ends_of.mean(axis=1)
        around = _summed(edge, of_face[self.face], len(ends))
        sharp = self._is_sharp[:, None]
        of_edge = np.where(sharp, middle, middle / 2 + around / 4)

        both, other = ends.T.ravel(), ends_of[:, ::-1].transpose(1, 0, 2).reshape(-1, positions.shape[1])
        valence = np.bincount(both, minlength=self.points)[:, None]
        faces = np.bincount(self.corners, minlength=self.points)[:, None]
        used = np.maximum(valence, 1)
        smooth = (
            _summed(self.corners, of_face[self.face], self.points) / np.maximum(faces, 1)
            + 2 * _summed(both, np.tile(middle, (2, 1)), self.points) / used
            + (valence - 3) * positions
        ) / used
        along = np.tile(self._is_sharp, 2)
        sharp_edges = np.bincount(both[along], minlength=self.points)[:, None]
        curve = (6 * positions + _summed(both[along], other[along], self.points)) / 8
        stays = (valence == 0) | (sharp_edges > 2) | ((sharp_edges == 2) & (faces == 1))
        of_vertex = np.where(stays, positions, np.where(sharp_edges == 2, curve, smooth))
        return np.concatenate([of_vertex, of_edge, of_face])

    def spread(self, values: Floats) -> Floats:
        """Values [c, k] of corners as those of the corners of the next level, linear within each face."""
        following, preceding = values[self._following], values[self._preceding]
        middle = self._mean(values)[self.face]
        made = np.stack([values, (values + following) / 2, middle, (preceding + values) / 2], axis=1)
        return made.reshape(-1, values.shape[1])

    def _mean(self, values: Floats) -> Floats:
        return _summed(self.face, values, len(self.counts)) / self.counts[:, None]


def _summed(index: Indices, values: Floats, count: int) -> Floats:
    return np.stack([np.bincount(index, column, count) for column in values.T], axis=1)
