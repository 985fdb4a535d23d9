"""Groups: the points of both families on each face, parted by normal and fibre direction.

A group stands for all points near one normal n_p and one fibre direction t, wherever in the repeat they lie:
that holds few groups to the whole cloth, however large its draft. Groups 0 to K − 1 are the warp's, K to
2K − 1 the weft's.
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray
from scipy.cluster.vq import kmeans2

from loomlight.core.backend import ArrayTypes, array_types, uploaded
from loomlight.yarn.geometry import YarnGeometry

# What a group is measured by: half the normal beside the fibre direction. Highlights are narrow in the
# latter; in trials with 8 groups a family other shares were up to 4 % worse.
_NORMAL_SHARE = 0.5
_FEATURES = 6
# Points of a face that groups are found from, and that their moments are summed over.
_POINTS = 1 << 14
_LEARNT_FROM = 1 << 12
_ITERATIONS = 12
# The plastic number's powers: points at multiples of these shares fill a square evenly (Roberts 2018).
_ACROSS, _ALONG = 0.7548776662466927, 0.5698402909980532


@dataclass(frozen=True, eq=False)
class Groups:
    """The groups of both faces and their moments, in the frame of the face that is seen.

    Attributes:
        per_family: K, ≥ 1.
        centres: what points are compared with [2 faces, 2 K, 6]: half the normal, then the fibre direction.
        area: share of the plan of the cloth [2, 2 K].
        hole: share of the plan where neither family is [2].
        normal: mean normal, shorter than 1 [2, 2 K, 3].
        tangent: mean fibre direction, shorter than 1 [2, 2 K, 3].
        spread: covariance of the fibre direction [2, 2 K, 3, 3].
    """

    per_family: int
    centres: NDArray[np.float32]
    area: NDArray[np.float64]
    hole: NDArray[np.float64]
    normal: NDArray[np.float64]
    tangent: NDArray[np.float64]
    spread: NDArray[np.float64]

    @property
    def count(self) -> int:
        """Groups of a face: 2 K."""
        return 2 * self.per_family


class GroupFinder:
    """Tells on one backend which group a point belongs to."""

    def __init__(self, groups: Groups, types: ArrayTypes) -> None:
        self._types = types
        self._centres = uploaded(types.Float, groups.centres)
        self._per_family = dr.opaque(types.UInt32, groups.per_family)
        self.holes = dr.opaque(types.UInt32, groups.count)

    def group(self, back: Any, is_warp: Any, hole: Any, normal: Any, tangent: Any) -> Any:
        """Number of the nearest group of the family that shows; 2 K in holes: UInt32."""
        types = self._types
        UInt32, Float = types.UInt32, types.Float
        first = dr.select(is_warp, UInt32(0), self._per_family)
        start = dr.select(back, 2 * self._per_family, 0) + first
        near = _NORMAL_SHARE * normal

        def compare(step: Any, least: Any, best: Any) -> tuple[Any, Any, Any]:
            row = 3 * (start + step)
            a, b, c = (dr.gather(types.Vector2, self._centres, row + part) for part in range(3))
            distance = dr.square(near.x - a.x) + dr.square(near.y - a.y) + dr.square(near.z - b.x)
            distance += dr.square(tangent.x - b.y) + dr.square(tangent.y - c.x) + dr.square(tangent.z - c.y)
            closer = distance < least
            return step + 1, dr.select(closer, distance, least), dr.select(closer, step, best)

        nothing = dr.zeros(UInt32, dr.width(normal))
        state = (UInt32(nothing), dr.full(Float, 1e9, dr.width(normal)), UInt32(nothing))
        state = dr.while_loop(state, lambda step, least, best: step < self._per_family, compare)
        return dr.select(hole, self.holes, first + state[2])


def evenly_spread(count: int, start: int = 0) -> NDArray[np.float64]:
    """Points [count, 2] that fill the unit square evenly, from number `start` of one endless sequence on."""
    number = np.arange(start, start + count, dtype=np.float64)[:, None]
    return np.asarray((number * [_ACROSS, _ALONG] + 0.5) % 1.0)


def find_groups(geometry: YarnGeometry, per_family: int, float_type: type) -> Groups:
    """Parts the points of both faces into `per_family` groups for each family (k-means) and sums them up.

    A family that a face never shows has groups without area.
    """
    back, is_warp, hole, normal, tangent = _points(geometry, float_type)
    features = np.concatenate([_NORMAL_SHARE * normal, tangent], axis=1)
    count = 2 * per_family
    centres = np.zeros((2, count, _FEATURES), np.float32)
    shape = (2, count)
    area, mean_normal, mean_tangent = np.zeros(shape), np.zeros((*shape, 3)), np.zeros((*shape, 3))
    spread = np.zeros((*shape, 3, 3))
    mean_normal[..., 2] = 1
    mean_tangent[..., 1] = 1
    for face in range(2):
        for family in range(2):
            chosen = np.flatnonzero((back == bool(face)) & (is_warp == (family == 0)) & ~hole)
            if not len(chosen):
                continue
            own = slice(family * per_family, (family + 1) * per_family)
            centres[face, own] = _centres(features[chosen], per_family)
            number = _nearest(features[chosen], centres[face, own])
            for group in range(per_family):
                part = chosen[number == group]
                if not len(part):
                    continue
                at = face, family * per_family + group
                area[at] = len(part) / _POINTS
                mean_normal[at], mean_tangent[at] = normal[part].mean(0), tangent[part].mean(0)
                spread[at] = np.cov(tangent[part].T, bias=True)
    holes = np.array([(hole & (back == bool(face))).sum() / _POINTS for face in range(2)])
    return Groups(per_family, centres, area, holes, mean_normal, mean_tangent, spread)


def _points(geometry: YarnGeometry, float_type: type) -> tuple[NDArray[Any], ...]:
    """Points of the plan, the front's first: back, is_warp, hole [n], normal and tangent [n, 3]."""
    types = array_types(float_type)
    places = np.tile(evenly_spread(_POINTS) * geometry.size, (2, 1)).astype(np.float32)
    back = np.repeat([False, True], _POINTS)
    x, y = (uploaded(types.Float, part) for part in places.T)
    point = geometry.surface(x, y, uploaded(types.Bool, back))
    dr.eval(point.is_warp, point.hole, point.normal, point.tangent)
    normal, tangent = (part.numpy().T.astype(np.float64) for part in (point.normal, point.tangent))
    return back, point.is_warp.numpy(), point.hole.numpy(), normal, tangent


def _centres(features: NDArray[np.float64], count: int) -> NDArray[np.float64]:
    step = max(1, len(features) * 2 // _LEARNT_FROM)
    learnt = features[::step]
    different = np.unique(learnt.round(6), axis=0)
    if len(different) <= count:
        return np.resize(different, (count, _FEATURES))
    with warnings.catch_warnings():
        # A group that loses all its points keeps its place and does no harm.
        warnings.simplefilter("ignore", UserWarning)
        found, _ = kmeans2(learnt, count, iter=_ITERATIONS, minit="++", rng=np.random.default_rng(0))
    return np.asarray(found)


def _nearest(features: NDArray[np.float64], centres: NDArray[np.float32]) -> NDArray[np.intp]:
    distance = (centres.astype(np.float64) ** 2).sum(1) - 2 * features @ centres.T.astype(np.float64)
    return np.asarray(distance.argmin(axis=1))
