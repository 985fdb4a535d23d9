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

from loomlight.core.backend import ArrayTypes, array_types, upload
from loomlight.core.frozen import FrozenArg, FrozenFunction
from loomlight.models.lobes.parting import LEARNT_FROM, Parting
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.search import upload_extent

# What a group is measured by: this much of the normal beside the fibre direction, in which highlights are
# narrow.
NORMAL_SHARE = 0.5
# Points of a face's plan that areas are counted over.
_POINTS = 1 << 13
# Fewer points of a family that views meet say less than its plan.
_FEWEST_SEEN = 64
# A covariance of fewer says nothing.
_FEWEST_MET = 8
# Groups are shared out by so many, as they lie in memory.
_SHARED_OUT = 4
# Parts of fibre directions whose products are summed, and all that is summed of a group; see `as_met`.
_PRODUCTS = (0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)
SUMS = 13
# Numbers of two centres in memory, and coordinates that are far from all points.
_ROW, _NOWHERE = 16, 1e3
# Multiples of the golden ratio fill the unit interval evenly, and those of four shares the unit cube of four
# dimensions: powers of the root of x⁵ = x + 1 (Roberts 2018). All are in units of 2⁻³²: products wrap around
# as fractions do.
_GOLDEN = 0x9E3779B9
_EVEN_IN_FOUR = [round(2**32 * 1.1673039782614187**-power) for power in range(1, 5)]


@dataclass(frozen=True, eq=False)
class FacePoints:
    """Points of both faces.

    Attributes:
        back, is_warp, hole: Booleans [n].
        normal, tangent: unit vectors [3, n] in the frame of the face.
    """

    back: NDArray[np.bool_]
    is_warp: NDArray[np.bool_]
    hole: NDArray[np.bool_]
    normal: NDArray[np.float32]
    tangent: NDArray[np.float32]

    def features(self, chosen: NDArray[np.intp]) -> NDArray[np.float32]:
        """What groups of some points are parted by [n, 6]."""
        normal, tangent = (np.take(part, chosen, axis=1) for part in (self.normal, self.tangent))
        return np.concatenate([np.float32(NORMAL_SHARE) * normal, tangent]).T

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
        self._centres = upload(types.Float, rows)
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
        features = *(NORMAL_SHARE * normal), *tangent

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


def cloth_of(geometry: YarnGeometry, float_type: type) -> FrozenArg[Cloth]:
    """A cloth on the backend of a Dr.Jit Float type, for functions that are recorded."""
    return FrozenArg(Cloth(geometry, array_types(float_type)))


def plan_points(cloth: FrozenArg[Cloth]) -> PlanPoints:
    """Looks at the plan of both faces."""
    x, y, is_warp, hole, normal, tangent = (part.numpy() for part in _plan(cloth))
    # A gap is one seen from both faces.
    gaps = np.stack([part[:_POINTS][hole[:_POINTS]] for part in (x, y)], axis=1)
    return PlanPoints(np.arange(2 * _POINTS) >= _POINTS, is_warp, hole, normal, tangent, gaps)


@FrozenFunction
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
    learnt = [
        seen.features(_some(views))
        if len(plan) and len(views) >= _FEWEST_SEEN
        else points.features(_some(plan))
        for plan, views in zip(shown, met, strict=True)
    ]
    parting = Parting(learnt, max(per_family, 2 * per_family - _SHARED_OUT))
    of_warp = [_shared_out(parting, face, [len(own) for own in met], per_family) for face in range(2)]
    counts = [count for first in of_warp for count in (first, 2 * per_family - first)]
    found = [
        # So that nothing is divided by 0.
        part if len(own) else np.tile([0, 0, NORMAL_SHARE, 0, 1, 0], (len(part), 1))
        for part, own in zip(parting.centres(counts), learnt, strict=True)
    ]
    centres = np.concatenate(found).reshape(2, 2 * per_family, 6).astype(np.float32)
    # Until views tell more: fibres about the centre, as far from it in all directions.
    tangent = centres[..., 3:].astype(np.float64)
    left = np.maximum(1 - np.square(tangent).sum(axis=-1), 0)
    return Groups(
        per_family,
        np.array(of_warp, np.intp),
        centres,
        np.full(2, len(points.gaps) / _POINTS),
        centres[..., :3].astype(np.float64) / NORMAL_SHARE,
        tangent,
        left[..., None, None] / 3 * np.eye(3),
    )


def _shared_out(parting: Parting, face: int, seen: Sequence[int], per_family: int) -> int:
    """How many of a face's 2 `per_family` groups the warp has: so that points are nearest to their groups.

    Args:
        parting: points of the front's warp and weft and of the back's.
        seen: how often views meet them.
    """
    total, families = 2 * per_family, (2 * face, 2 * face + 1)
    if total % (2 * _SHARED_OUT) or not all(parting.points_of(family) for family in families):
        return per_family
    choices = range(_SHARED_OUT, total, _SHARED_OUT)

    def error(first: int) -> float:
        counts = zip(families, (first, total - first), strict=True)
        return sum(parting.error(family, count) * seen[family] for family, count in counts)

    # In doubt, halves.
    return min(choices, key=lambda first: (error(first), abs(first - per_family)))


def _some(points: NDArray[np.intp]) -> NDArray[np.intp]:
    """As many as groups are learnt from at the most, evenly: but every k-th would favour some places."""
    if len(points) <= LEARNT_FROM:
        return points
    # Shares of multiples of the golden ratio.
    shares = np.arange(LEARNT_FROM, dtype=np.uint64) * np.uint64(_GOLDEN) & np.uint64(0xFFFFFFFF)
    return points[(shares * np.uint64(len(points)) >> np.uint64(32)).astype(np.intp)]


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
