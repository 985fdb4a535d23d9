"""Points of some families parted into groups, by code of `parting_code`."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import numpy as np
from numpy.typing import NDArray

from loomlight.core.machine_code import MachineCode, vectors
from loomlight.models.lobes.parting_code import (
    FAR_ERROR,
    FAR_MEAN,
    FAR_POINTS,
    FEATURES,
    MOST_GROUPS,
    NEAR_ERROR,
    NEAR_MEAN,
    PARENT,
    POINTS,
    ROW,
    halving_code,
    means_code,
)

# Points of a family, at the most.
LEARNT_FROM = POINTS
# Points that agree in so many digits are one, as those of a straight flat yarn are.
_DIGITS = 4


class Parting:
    """Points of some families, and the groups that come of halving the widest, again and again.

    Widest is whose points have the largest sum of squared distances from their mean. It is parted across its
    longest axis, where both halves are nearest to their means. No step is left to chance: groups found from
    centres drawn at random make pictures of the same cloth that err up to a third more or less.
    """

    def __init__(self, families: Sequence[NDArray[np.floating]], most: int) -> None:
        """
        Args:
            families: coordinates [n, 6] of each family's points, 2048 at the most; there may be none.
            most: groups that will be asked for, of each family: 128 at the most.
        """
        if most > MOST_GROUPS or any(len(points) > POINTS for points in families):
            raise ValueError(f"up to {POINTS} points are parted into up to {MOST_GROUPS} groups")
        count = len(families)
        self._points = np.zeros((FEATURES, count, POINTS), np.float32)
        self._is_point = np.zeros((count, POINTS), np.float32)
        for family, points in enumerate(families):
            self._points[:, family, : len(points)] = points.T
            self._is_point[family, : len(points)] = 1
        np.round(self._points, _DIGITS, out=self._points)
        counts = np.maximum(self._is_point.sum(axis=1), 1)
        self._middle = (self._points.sum(axis=2, dtype=np.float64) / counts).T
        self._points -= self._middle.T[..., None].astype(np.float32)
        self._counts = counts
        rows = np.zeros((count, MOST_GROUPS, ROW), np.float32)
        self._run(_halving(), np.full(count, most), rows)
        self._halvings = [_Halvings(own, len(points)) for own, points in zip(rows, families, strict=True)]

    def points_of(self, family: int) -> int:
        """How many points a family has."""
        return int(self._is_point[family].sum())

    def halves(self, family: int, count: int) -> NDArray[np.float64]:
        """Means of so many groups of a family [count, 6]; where fewer points differ some are one."""
        return self._middle[family] + self._halvings[family].means(count)

    def error(self, family: int, count: int) -> float:
        """Mean squared distance of a family's points from the middle of their one of so many groups."""
        return self._halvings[family].error(count) / float(self._counts[family])

    def centres(self, counts: Sequence[int]) -> list[NDArray[np.float64]]:
        """Means of so many groups of each family [count, 6]: a few steps of k-means from halves.

        Where fewer points differ some groups are one.
        """
        rows = np.zeros((len(counts), MOST_GROUPS, ROW), np.float32)
        for own, halvings, count in zip(rows, self._halvings, counts, strict=True):
            own[:count, :FEATURES] = halvings.means(count)
        self._run(_means(), np.asarray(counts), rows)
        return [
            middle + own[:count, :FEATURES]
            for own, middle, count in zip(rows, self._middle, counts, strict=True)
        ]

    def _run(self, code: MachineCode, wanted: NDArray[np.int64], rows: NDArray[np.float32]) -> None:
        """Lets code fill rows [families, groups, 16]."""
        groups = np.zeros(self._is_point.shape, np.float32)
        groups[:, 0] = wanted
        flat = groups.size
        queries = [part.reshape(flat) for part in (*self._points, self._is_point, groups)]
        code.run(flat, queries, [rows.reshape(flat)], [])


class _Halvings:
    """What became of one family, halving by halving: means and error of the parts that there were."""

    def __init__(self, rows: NDArray[np.float32], points: int) -> None:
        """Reads rows of `halving_code`."""
        means, errors, sizes = [rows[0, NEAR_MEAN:FAR_MEAN]], [float(rows[0, NEAR_ERROR])], [points]
        self._steps = [(list(means), sum(errors))]
        for row in rows[1:]:
            parent, far = int(row[PARENT]), int(row[FAR_POINTS])
            if not 0 < far < sizes[parent]:
                # All points of the widest part are one.
                break
            sizes[parent] -= far
            sizes.append(far)
            means[parent] = row[NEAR_MEAN:FAR_MEAN]
            means.append(row[FAR_MEAN:])
            errors[parent] = float(row[NEAR_ERROR])
            errors.append(float(row[FAR_ERROR]))
            self._steps.append((list(means), sum(errors)))

    def means(self, count: int) -> NDArray[np.float32]:
        """Means of so many parts [count, 6]."""
        found = np.array(self._step(count)[0])
        return np.concatenate([found, np.repeat(found[:1], count - len(found), axis=0)])

    def error(self, count: int) -> float:
        """Sum of squared distances of points from the mean of their one of so many parts."""
        return self._step(count)[1]

    def _step(self, count: int) -> tuple[list[NDArray[np.float32]], float]:
        return self._steps[min(count, len(self._steps)) - 1]


@cache
def _halving() -> MachineCode:
    return MachineCode(halving_code(vectors()))


@cache
def _means() -> MachineCode:
    return MachineCode(means_code(vectors()))
