"""Groups: the points of both families on each face, parted by normal and fibre direction.

A group stands for all points near one normal n_p and one fibre direction t, wherever in the repeat they lie:
that holds few groups to the whole cloth, however large its draft. Groups 0 to K − 1 are the warp's, K to
2K − 1 the weft's.
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from functools import cache
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
_POINTS = 1 << 13
_LEARNT_FROM = 1 << 10
_ITERATIONS = 10
# Points that agree in so many are one group's, as those of a straight flat yarn are.
_DIGITS = 4
# Multiples of these shares fill the unit cube of four dimensions evenly: powers of the root of x⁵ = x + 1
# (Roberts 2018).
_EVEN_IN_FOUR = 1.1673039782614187 ** -np.arange(1.0, 5.0)


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
        gaps: places where neither family is, evenly spread [n, 2], millimetres.
    """

    per_family: int
    centres: NDArray[np.float32]
    area: NDArray[np.float64]
    hole: NDArray[np.float64]
    normal: NDArray[np.float64]
    tangent: NDArray[np.float64]
    spread: NDArray[np.float64]
    gaps: NDArray[np.float32]

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


@cache
def _turns(count: int, sets: int) -> NDArray[np.float64]:
    """Points [sets, count, 4] of the unit cube of four dimensions, each set evenly spread."""
    number = np.arange(count)[:, None] + 0.5
    shift = np.arange(sets)[:, None, None] * _EVEN_IN_FOUR[::-1]
    return np.asarray((number * _EVEN_IN_FOUR + shift) % 1.0)


def places_over(geometry: YarnGeometry, count: int, sets: int = 1) -> NDArray[np.float32]:
    """Places on the cloth [sets, count, 2], millimetres, the same every time.

    They are even over the crossings and within a crossing both: places that are even over the repeat alone
    may meet a gap of a few per cent too often, as threads repeat.
    """
    turns = _turns(count, sets)
    picks, ends = geometry.layout.warp_on_top.shape
    crossing = np.floor(turns[..., 2:] * (ends, picks))
    return ((crossing + turns[..., :2]) / (ends, picks) * geometry.size).astype(np.float32)


def find_groups(geometry: YarnGeometry, per_family: int, float_type: type) -> Groups:
    """Parts the points of both faces into `per_family` groups for each family (k-means) and sums them up.

    A family that a face never shows has groups without area.
    """
    back, is_warp, hole, normal, tangent = _points(geometry, float_type)
    features = np.concatenate([_NORMAL_SHARE * normal, tangent], axis=1)
    count = 2 * per_family
    centres = np.zeros((2, count, _FEATURES), np.float32)
    number = np.full(len(back), 2 * count)
    for face in range(2):
        for family in range(2):
            chosen = np.flatnonzero((back == bool(face)) & (is_warp == (family == 0)) & ~hole)
            if len(chosen):
                own = slice(family * per_family, (family + 1) * per_family)
                centres[face, own] = _centres(features[chosen], per_family)
                first = face * count + family * per_family
                number[chosen] = first + _nearest(features[chosen], centres[face, own])
    area, mean_normal, mean_tangent, spread = _moments(number, normal, tangent, count)
    # A gap is one seen from both faces.
    gaps = places_over(geometry, _POINTS)[0][hole[:_POINTS]]
    holes = np.full(2, len(gaps) / _POINTS)
    return Groups(per_family, centres, area, holes, mean_normal, mean_tangent, spread, gaps)


def _moments(
    number: NDArray[np.intp], normal: NDArray[np.float64], tangent: NDArray[np.float64], count: int
) -> tuple[NDArray[np.float64], ...]:
    """Areas [2, count], mean normals and fibre directions, covariances of these, of points by group."""
    squares = tangent[:, :, None] * tangent[:, None, :]
    rows = np.concatenate([np.ones((len(number), 1)), normal, tangent, squares.reshape(-1, 9)], axis=1)
    member = (number == np.arange(2 * count)[:, None]).astype(np.float64)
    sums = (member @ rows).reshape(2, count, -1)
    points = sums[..., :1]
    means = sums[..., 1:] / np.maximum(points, 1)
    # Groups without points face the eye, so that nothing is divided by 0.
    means[points[..., 0] == 0, 2] = means[points[..., 0] == 0, 4] = 1
    mean_normal, mean_tangent = means[..., :3], means[..., 3:6]
    spread = means[..., 6:].reshape(2, count, 3, 3) - mean_tangent[..., :, None] * mean_tangent[..., None, :]
    spread[points[..., 0] == 0] = 0
    return points[..., 0] / _POINTS, mean_normal, mean_tangent, spread


def _points(geometry: YarnGeometry, float_type: type) -> tuple[NDArray[Any], ...]:
    """Points of the plan, the front's first: back, is_warp, hole [n], normal and tangent [n, 3]."""
    types = array_types(float_type)
    back = np.repeat([False, True], _POINTS)
    x, y = (uploaded(types.Float, np.tile(part, 2)) for part in places_over(geometry, _POINTS)[0].T)
    point = geometry.surface(x, y, uploaded(types.Bool, back))
    dr.eval(point.is_warp, point.hole, point.normal, point.tangent)
    normal, tangent = (part.numpy().T.astype(np.float64) for part in (point.normal, point.tangent))
    return back, point.is_warp.numpy(), point.hole.numpy(), normal, tangent


def _centres(features: NDArray[np.float64], count: int) -> NDArray[np.float64]:
    learnt = features[:: max(1, len(features) // _LEARNT_FROM)]
    different = np.unique(learnt.round(_DIGITS), axis=0)
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
