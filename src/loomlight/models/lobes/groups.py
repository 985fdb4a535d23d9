"""Groups: the points of both families on each face, parted by normal and fibre direction.

A group stands for all points near one normal n_p and one fibre direction t, wherever in the repeat they lie:
that holds few groups to the whole cloth, however large its draft. The first groups of a face are the warp's,
the others the weft's. A face has 2 K; a family that fills most of it has more of them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import ArrayTypes, array_types, uploaded
from loomlight.core.recorded import Held, Recorded
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.visibility import upload_extent

# What a group is measured by: this much of the normal beside the fibre direction, in which highlights are
# narrow.
_NORMAL_SHARE = 0.5
# Points of a face's plan that areas are counted over, and points of a family and face that its
# groups are learnt from.
_POINTS = 1 << 13
_LEARNT_FROM = 1 << 11
# Fewer points of a family that views meet say less than its plan.
_FEWEST_SEEN = 64
# A covariance of fewer says nothing.
_FEWEST_MET = 8
_ITERATIONS = 2
_HALVINGS = 4
# Points that agree in so many are one to k-means, as those of a straight flat yarn are.
_DIGITS = 4
# Groups are shared out by so many, as they lie in memory.
_SHARED_OUT = 4
# Parts of fibre directions whose products are summed, and all that is summed of a group; see `as_met`.
_PRODUCTS = (0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)
SUMS = 13
# Numbers of two centres in memory, and coordinates that are far from all points.
_ROW, _NOWHERE = 16, 1e3
# Multiples of these shares fill the unit cube of four dimensions evenly: powers of the root of x⁵ = x + 1
# (Roberts 2018), in units of 2⁻³²: products wrap around as fractions do.
_EVEN_IN_FOUR = [round(2**32 * 1.1673039782614187**-power) for power in range(1, 5)]


@dataclass(frozen=True, eq=False)
class FacePoints:
    """Points of both faces.

    Attributes:
        back, is_warp, hole: Booleans [n].
        normal, tangent: unit vectors [n, 3] in the frame of the face.
    """

    back: NDArray[np.bool_]
    is_warp: NDArray[np.bool_]
    hole: NDArray[np.bool_]
    normal: NDArray[np.float64]
    tangent: NDArray[np.float64]

    def features(self, chosen: NDArray[np.intp]) -> NDArray[np.float64]:
        """What groups of some points are parted by [n, 6]."""
        return np.concatenate([_NORMAL_SHARE * self.normal[chosen], self.tangent[chosen]], axis=1)

    def of_families(self) -> list[NDArray[np.intp]]:
        """Points of the front's warp and weft and of the back's, holes left out."""
        number = 2 * self.back + ~self.is_warp
        return [np.flatnonzero((number == family) & ~self.hole) for family in range(4)]


@dataclass(frozen=True, eq=False)
class PlanPoints(FacePoints):
    """Points spread evenly over the plan, those of the front first.

    Attributes:
        gaps: places where neither family is, evenly spread [m, 2], millimetres.
    """

    gaps: NDArray[np.float32]


@dataclass(frozen=True, eq=False)
class Groups:
    """The groups of both faces and their moments, in the frame of the face that is seen.

    Attributes:
        per_family: K, ≥ 1: half of a face's groups.
        of_warp: how many of a face's groups are the warp's [2].
        centres: what points are compared with [2 faces, 2 K, 6]: half the normal, then the fibre direction.
        hole: share of the plan where neither family is [2].
        normal: of the centre, or the mean of what views meet (`as_met`), shorter than 1 [2, 2 K, 3].
        tangent: fibre direction of the same, shorter than 1 [2, 2 K, 3].
        spread: covariance of the fibre direction [2, 2 K, 3, 3]; its trace is 1 − |tangent|².
    """

    per_family: int
    of_warp: NDArray[np.intp]
    centres: NDArray[np.float32]
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
        # CPUs fetch what lies in a row together: two centres at once, as nothing else takes as long. The last
        # one may be far from everything.
        families = [
            part
            for face, first in zip(groups.centres, groups.of_warp, strict=True)
            for part in (face[:first], face[first:])
        ]
        pairs = [-(-len(part) // 2) for part in families]
        rows = np.full((sum(pairs), 2, _ROW // 2), _NOWHERE, np.float32)
        starts = np.cumsum([0, *pairs[:-1]])
        for part, start in zip(families, starts, strict=True):
            rows.reshape(-1, _ROW // 2)[2 * start : 2 * start + len(part), :6] = part
        self._centres = uploaded(types.Float, rows)
        self._starts, self._pairs = (
            [dr.opaque(types.UInt32, int(number)) for number in numbers] for numbers in (starts, pairs)
        )
        self._of_warp = [dr.opaque(types.UInt32, int(number)) for number in groups.of_warp]
        self.holes = dr.opaque(types.UInt32, groups.count)

    def group(self, back: Any, is_warp: Any, hole: Any, normal: Any, tangent: Any) -> Any:
        """Number of the nearest group of the family that shows; 2 K in holes: UInt32."""
        types = self._types
        UInt32, Float = types.UInt32, types.Float

        def of_family(numbers: list[Any]) -> Any:
            front, behind = (dr.select(is_warp, *pair) for pair in (numbers[:2], numbers[2:]))
            return dr.select(back, behind, front)

        start, pairs = of_family(self._starts), of_family(self._pairs)
        features = *(_NORMAL_SHARE * normal), *tangent

        def compare(step: Any, least: Any, best: Any) -> tuple[Any, Any, Any]:
            row = dr.gather(types.Vectors, self._centres, start + step, shape=(_ROW, dr.width(start)))
            for number in range(2):
                centre = list(row)[_ROW // 2 * number :]
                distance = Float(0)
                for feature, of_centre in zip(features, centre, strict=False):
                    offset = feature - of_centre
                    distance = dr.fma(offset, offset, distance)
                closer = distance < least
                least = dr.select(closer, distance, least)
                best = dr.select(closer, 2 * step + number, best)
            return step + 1, least, best

        nothing = dr.zeros(UInt32, dr.width(normal))
        state = (UInt32(nothing), dr.full(Float, _NOWHERE, dr.width(normal)), UInt32(nothing))
        best = dr.while_loop(state, lambda step, least, best: step < pairs, compare)[2]
        before = dr.select(is_warp, 0, dr.select(back, self._of_warp[1], self._of_warp[0]))
        return dr.select(hole, self.holes, before + best)


class Places:
    """Sets of places on the cloth, the same every time."""

    def __init__(self, geometry: YarnGeometry, types: ArrayTypes) -> None:
        self._types = types
        picks, ends = geometry.layout.warp_on_top.shape
        # Threads, and millimetres a thread.
        self._axes = [
            (dr.opaque(types.Float, threads), dr.opaque(types.Float, side / threads))
            for threads, side in zip((ends, picks), geometry.size, strict=True)
        ]

    def over(self, number: Any, chosen: Any) -> tuple[Any, Any]:
        """Places x, y, millimetres: Float each.

        They are even over the crossings and within a crossing both: places that are even over the repeat
        alone may meet a gap of a few per cent too often, as threads repeat.

        Args:
            number: of the place in its set, from 0: UInt32.
            chosen: which set, each evenly spread: UInt32.
        """
        turns = [
            self._types.Float((number * share + share // 2 + chosen * shift) >> 8) * 2**-24
            for share, shift in zip(_EVEN_IN_FOUR, _EVEN_IN_FOUR[::-1], strict=True)
        ]
        x, y = (
            (dr.floor(crossing * threads) + within) * side
            for within, crossing, (threads, side) in zip(turns[:2], turns[2:], self._axes, strict=True)
        )
        return x, y


class Cloth:
    """The yarns of one fabric on one backend, uploaded, and places on them.

    Attributes:
        geometry: the yarns.
        places: all over them.
        types: of the backend.
    """

    def __init__(self, geometry: YarnGeometry, types: ArrayTypes) -> None:
        geometry.upload(types)
        upload_extent(geometry, types)
        self.geometry = geometry
        self.places = Places(geometry, types)
        self.types = types


def cloth_of(geometry: YarnGeometry, float_type: type) -> Held[Cloth]:
    """A cloth on the backend of a Dr.Jit Float type, for functions that are recorded."""
    return Held(Cloth(geometry, array_types(float_type)))


def plan_points(cloth: Held[Cloth]) -> PlanPoints:
    """Looks at the plan of both faces."""
    x, y, is_warp, hole, normal, tangent = (part.numpy() for part in _plan(cloth))
    # A gap is one seen from both faces.
    gaps = np.stack([part[:_POINTS][hole[:_POINTS]] for part in (x, y)], axis=1)
    normal, tangent = (part.T.astype(np.float64) for part in (normal, tangent))
    return PlanPoints(np.arange(2 * _POINTS) >= _POINTS, is_warp, hole, normal, tangent, gaps)


@Recorded
def _plan(cloth: Cloth) -> tuple[Any, ...]:
    """x, y, whether it is the warp that shows, or a hole, normal and fibre direction of the plan's points."""
    lane = dr.arange(cloth.types.UInt32, 2 * _POINTS)
    back = lane >= _POINTS
    x, y = cloth.places.over(lane & (_POINTS - 1), cloth.types.UInt32(0))
    point = cloth.geometry.surface(x, y, back)
    return x, y, point.is_warp, point.hole, point.normal, point.tangent


def find_groups(points: PlanPoints, seen: FacePoints, per_family: int) -> Groups:
    """Parts the yarns of both faces into groups, 2 `per_family` a face.

    Where that is a multiple of 8 the family that is more of what views meet may have more of them, by fours,
    so that groups are as narrow as can be. Groups of a family that a face never shows face the eye.

    Args:
        seen: what views from all around meet, which groups are made for. What dives under other
            yarns is a large part of the plan, and seldom seen.
    """
    shown, met = points.of_families(), seen.of_families()
    halved = [
        _Halved(_some(seen.features(some) if len(some) >= _FEWEST_SEEN else points.features(family)))
        if len(family)
        else None
        for family, some in zip(shown, met, strict=True)
    ]
    centres = np.empty((2, 2 * per_family, 6), np.float32)
    of_warp = np.empty(2, np.intp)
    for face in range(2):
        own = halved[2 * face : 2 * face + 2]
        first = _shared_out(own, [len(some) for some in met[2 * face : 2 * face + 2]], per_family)
        centres[face, :first] = _centres(own[0], first)
        centres[face, first:] = _centres(own[1], 2 * per_family - first)
        of_warp[face] = first
    # Until views tell more: fibres about the centre, as far from it in all directions.
    tangent = centres[..., 3:].astype(np.float64)
    left = np.maximum(1 - np.square(tangent).sum(axis=-1), 0)
    return Groups(
        per_family,
        of_warp,
        centres,
        np.full(2, len(points.gaps) / _POINTS),
        centres[..., :3].astype(np.float64) / _NORMAL_SHARE,
        tangent,
        left[..., None, None] / 3 * np.eye(3),
    )


def _shared_out(halved: Sequence[_Halved | None], seen: Sequence[int], per_family: int) -> int:
    """How many of a face's 2 `per_family` groups the warp has: so that points are nearest to their groups.

    Args:
        halved: points of warp and weft.
        seen: how often views meet them.
    """
    total = 2 * per_family
    if total % (2 * _SHARED_OUT) or None in halved:
        return per_family
    choices = range(_SHARED_OUT, total, _SHARED_OUT)

    def error(first: int) -> float:
        parts = zip(halved, seen, (first, total - first), strict=True)
        return sum(part.error(count) * often for part, often, count in parts if part is not None)

    # In doubt, halves.
    return min(choices, key=lambda first: (error(first), abs(first - per_family)))


def _some(rows: NDArray[np.float64]) -> NDArray[np.float64]:
    """`_LEARNT_FROM` of them at the most, at random: every k-th would favour some places."""
    if len(rows) <= _LEARNT_FROM:
        return rows
    return rows[np.random.default_rng(0).choice(len(rows), _LEARNT_FROM, replace=False)]


def sums_of(normal: Any, tangent: Any) -> list[Any]:
    """What moments are sums of, beside ones: normal, fibre direction, products of its parts."""
    return [*normal, *tangent, *(tangent[i] * tangent[j] for i, j in _PRODUCTS)]


def as_met(groups: Groups, sums: NDArray[np.float64]) -> Groups:
    """The groups with moments of yarn points as often as views meet them.

    What dives under other yarns is steep and seldom seen: over the plan it would make a group five times as
    wide as it looks. A group that few views meet keeps its moments.

    Args:
        sums: of each group, the number of its points, and over these what `sums_of` says [2, 2 K, SUMS].
    """
    members = sums[..., :1]
    means = sums[..., 1:] / np.maximum(members, 1)
    normal, tangent = means[..., :3], means[..., 3:6]
    spread = -tangent[..., :, None] * tangent[..., None, :]
    for (i, j), product in zip(_PRODUCTS, np.moveaxis(means[..., 6:], -1, 0), strict=True):
        spread[..., i, j] += product
        spread[..., j, i] = spread[..., i, j]
    few = members < _FEWEST_MET
    return replace(
        groups,
        normal=np.where(few, groups.normal, normal),
        tangent=np.where(few, groups.tangent, tangent),
        spread=np.where(few[..., None], groups.spread, spread),
    )


def _centres(halved: _Halved | None, count: int) -> NDArray[np.float64]:
    """Means of `count` groups of points [count, features]: a few steps of k-means from halves.

    Where fewer points differ some groups are one; where a group loses all its points it keeps its place.
    Groups of no points face the eye, so that nothing is divided by 0.
    """
    if halved is None:
        return np.tile([0, 0, _NORMAL_SHARE, 0, 1, 0], (count, 1))
    centres, learnt = halved.centres(count), halved.points
    # With ones beside them, one product each gives distances, and sums together with numbers of points.
    with_ones = np.concatenate([learnt, np.ones((len(learnt), 1))], axis=1)
    turned = np.ascontiguousarray(with_ones.T)
    for _ in range(_ITERATIONS):
        squares = np.square(centres).sum(axis=1)[:, None]
        distance = np.concatenate([-2 * centres, squares], axis=1) @ turned
        # A point between two groups counts for both.
        member = distance == distance.min(axis=0)
        sums = member.astype(np.float64) @ with_ones
        points = sums[:, -1:]
        centres = np.where(points > 0, sums[:, :-1] / np.maximum(points, 1), centres)
    return centres


@dataclass(eq=False)
class _Part:
    """Points of one group to be.

    Attributes:
        centre: their mean [features].
        offsets: from it [features, n].
        products: sums of products of offsets [features, features].
        error: sum of their squares.
    """

    centre: NDArray[np.float64]
    offsets: NDArray[np.float64]
    products: NDArray[np.float64]
    error: float

    @classmethod
    def of(cls, points: NDArray[np.float64], origin: NDArray[np.float64]) -> _Part:
        """The part of points [features, n], seen from an origin."""
        mean = points.sum(axis=1) * (1 / points.shape[1])
        offsets = points - mean[:, None]
        # Of two different arrays: a matrix with itself is another routine, which takes longer.
        products = np.dot(points, offsets.T)
        return cls(origin + mean, offsets, products, float(products.trace()))


class _Halved:
    """Points, and groups that come of halving the widest, again and again.

    Widest is whose points have the largest sum of squared distances from their mean. It is parted across its
    longest axis, where both halves are nearest to their means. No step is left to chance: groups found from
    centres drawn at random make pictures of the same cloth that err up to a third more or less.

    Rays are traced meanwhile, and a matrix library's threads would fight theirs: these products are too small
    for it to start any.

    Attributes:
        points: as far as they are told apart [n, features].
    """

    def __init__(self, features: NDArray[np.float64]) -> None:
        self.points = features.round(_DIGITS)
        turned = np.ascontiguousarray(self.points.T)
        # The parts there are of any number of groups.
        self._steps = [[_Part.of(turned, np.zeros(len(turned)))]]

    def centres(self, count: int) -> NDArray[np.float64]:
        """Means of so many groups [count, features]; where fewer points differ some are one."""
        found = np.array([part.centre for part in self._parts(count)])
        return np.concatenate([found, np.repeat(found[:1], count - len(found), axis=0)])

    def error(self, count: int) -> float:
        """Mean squared distance of points from the middle of their one of so many groups."""
        return sum(part.error for part in self._parts(count)) / len(self.points)

    def _parts(self, count: int) -> list[_Part]:
        """Parts of so many groups, or fewer where no more points differ."""
        while len(self._steps) < count:
            parts = self._steps[-1]
            part = max(parts, key=lambda part: part.error)
            axis = np.linalg.eigh(part.products)[1][:, -1]
            along = np.einsum("in,i->n", part.offsets, axis)
            beyond = along > _between(along)
            halves = [side.nonzero()[0] for side in (~beyond, beyond)]
            if not all(map(len, halves)):
                # All points are one.
                return parts
            near, far = (_Part.of(part.offsets.take(half, axis=1), part.centre) for half in halves)
            self._steps.append([near if other is part else other for other in parts] + [far])
        return self._steps[count - 1]


def _between(along: NDArray[np.float64]) -> float:
    """Where to part points on a line [n], whose mean is 0: halfway between the means of both halves."""
    at, before = 0.0, 0
    for _ in range(_HALVINGS):
        beyond = along > at
        there = int(np.count_nonzero(beyond))
        here = len(along) - there
        if not (here and there) or there == before:
            break
        before = there
        # Both sums cancel.
        at = 0.5 * float(np.dot(along, beyond)) * (1 / there - 1 / here)
    return at
