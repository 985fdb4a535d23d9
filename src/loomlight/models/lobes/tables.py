"""All that the model bakes of a fabric, and how it lies in memory: bytes, four to a word.

Colours and roughness are in none of it, so edits of them bake nothing.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.assets.loom_file import LoomFile
from loomlight.core.errors import InputError
from loomlight.core.frozen import FrozenArg
from loomlight.models.lobes.coverage import Coverage, count_cells, measure_coverage, padded_group, words_of
from loomlight.models.lobes.groups import GroupFinder, Groups, cloth_of, find_groups, plan_points
from loomlight.models.lobes.hemisphere import NODES
from loomlight.models.lobes.reach import (
    Reach,
    cast_rays,
    cast_views,
    groups_met,
    measure_reach,
    seen_points,
    sort_rays,
)
from loomlight.yarn.geometry import YarnGeometry

_LARGEST = 255.0
# Numbers of a group; see `_moments`.
MOMENTS = 12


@dataclass(frozen=True, eq=False)
class LobeTables:
    """The tables of one fabric, both faces; see `coverage`, `reach` and `groups` for what they mean.

    Attributes:
        size: side of the squares of the pyramid's first level, millimetres.
        levels: first node, columns, rows of each level [levels, 3].
        coverage: bytes of the pyramid [2, nodes, 4·(words + 1)].
        seen: bytes [2, hemisphere nodes, 4·(2 words + 1)]: roots of what views see of each group and of
            holes, then how much of each group's plan light on the side seen reaches.
        lit: bytes [2 faces, 2 sides, hemisphere nodes, 4·2 words]: irradiance of each group, then how much
            of it is reached.
        moments: [2, 4·words, 12] of each group: mean normal, weight of (coverage byte)·(seen byte)², mean
            fibre direction, and xx, yy, xy, xz, yz of its covariance, whose trace is 1 − |mean|².
        hole_weight: the weight of holes [2].
        warp_words: how many words of each face, the first ones, are the warp's [2].
    """

    size: float
    levels: NDArray[np.int64]
    coverage: NDArray[np.uint8]
    seen: NDArray[np.uint8]
    lit: NDArray[np.uint8]
    moments: NDArray[np.float32]
    hole_weight: NDArray[np.float32]
    warp_words: NDArray[np.int64]

    @property
    def words(self) -> int:
        """Words of four groups each, holes left out."""
        return self.moments.shape[1] // 4

    @property
    def nbytes(self) -> int:
        """Size of all tables."""
        return sum(part.nbytes for part in self.arrays().values())

    def arrays(self) -> dict[str, NDArray[Any]]:
        """The tables by name."""
        return {part.name: getattr(self, part.name) for part in fields(self) if part.name != "size"}


def bake_tables(
    geometry: YarnGeometry, diffuse_blend: float, per_family: int, float_type: type
) -> LobeTables:
    """Bakes the tables of a fabric: the same bytes every time.

    Args:
        diffuse_blend: w, the share of the yarn normal in the diffuse term.
        per_family: groups of each family, on average.
        float_type: the Dr.Jit Float type to compute with.
    """
    cloth = cloth_of(geometry, float_type)
    views = cast_views(cloth, per_family)
    points, met = plan_points(cloth), seen_points(views)
    # Rays are on their way while groups are found.
    rays = cast_rays(cloth, points, views)
    groups = find_groups(points, met, per_family)
    finder = FrozenArg(GroupFinder(groups, cloth.value.types))
    cells = count_cells(cloth, finder, per_family)
    found = sort_rays(rays, groups, diffuse_blend)
    coverage = measure_coverage(cells)
    reach = measure_reach(found)
    seen, seen_scale = _seen(reach, per_family)
    moments, hole_weight = _moments(groups_met(found), coverage, seen_scale)
    return LobeTables(
        coverage.size,
        coverage.levels,
        coverage.bytes,
        seen,
        _lit(reach, per_family),
        moments,
        hole_weight,
        _warp_words(groups),
    )


def tables_of_loom(loom: LoomFile) -> LobeTables:
    """The tables that a `.loom` file holds.

    Raises:
        InputError: tensors that are missing, of another kind, or do not belong together.
    """
    moments = loom.tensor("moments", (2, None, MOMENTS), np.float32)
    if moments.shape[1] % 8 or not moments.size:
        raise InputError(
            f"{loom.file}: the tensor model.moments has {moments.shape[1]} groups a face: it should have "
            "whole words of four, and an even number of them."
        )
    words = moments.shape[1] // 4
    warp_words = loom.tensor("warp_words", (2,), np.int64)
    if not ((warp_words >= 0) & (warp_words <= words)).all():
        raise InputError(
            f"{loom.file}: the tensor model.warp_words is {warp_words.tolist()}: it should be 0 to "
            f"{words} each, the words of four groups that there are."
        )
    levels = loom.tensor("levels", (None, 3), np.int64)
    sizes = levels[:, 1] * levels[:, 2]
    consistent = len(levels) > 0 and (levels[:, 1:] > 0).all() and levels[0, 0] == 0
    if not (consistent and (levels[1:, 0] == np.cumsum(sizes)[:-1]).all()):
        raise InputError(f"{loom.file}: the tensor model.levels is no pyramid: bake it again.")
    size = loom.setting("size", float)
    if not 0 < size < math.inf:
        raise InputError(f"{loom.file}: the setting size is {size:g}: it should be above 0 mm.")
    return LobeTables(
        size,
        levels,
        loom.tensor("coverage", (2, int(sizes.sum()), 4 * (words + 1)), np.uint8),
        loom.tensor("seen", (2, NODES, 4 * (2 * words + 1)), np.uint8),
        loom.tensor("lit", (2, 2, NODES, 8 * words), np.uint8),
        moments,
        loom.tensor("hole_weight", (2,), np.float32),
        warp_words,
    )


def _warp_words(groups: Groups) -> NDArray[np.int64]:
    """Words of the warp of each face: half of them, or as groups are shared out, which is by words."""
    half = words_of(groups.per_family) // 2
    halves = groups.of_warp == groups.per_family
    return np.where(halves, half, groups.of_warp // 4).astype(np.int64)


def _seen(reach: Reach, per_family: int) -> tuple[NDArray[np.uint8], NDArray[np.float64]]:
    """Bytes of what views see, and what 255² stands for [2, 2 K + 1]."""
    words = words_of(per_family)
    scale = np.maximum(reach.seen.max(axis=1), 1e-9)
    places = np.append(padded_group(per_family), 4 * words)
    table = np.zeros((2, NODES, 4 * (2 * words + 1)), np.uint8)
    table[:, :, places] = np.rint(np.sqrt(reach.seen / scale[:, None]) * _LARGEST)
    table[:, :, 4 * (words + 1) + padded_group(per_family)] = np.rint(reach.reached[:, 0] * _LARGEST)
    return table, scale


def _lit(reach: Reach, per_family: int) -> NDArray[np.uint8]:
    """Bytes of what light reaches."""
    words, places = words_of(per_family), padded_group(per_family)
    table = np.zeros((2, 2, NODES, 8 * words), np.uint8)
    table[..., places] = np.rint(np.clip(reach.irradiance * math.pi, 0, 1) * _LARGEST)
    table[..., 4 * words + places] = np.rint(reach.reached * _LARGEST)
    return table


def _moments(
    groups: Groups, coverage: Coverage, seen_scale: NDArray[np.float64]
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Rows of twelve numbers a group, and the weight of holes."""
    words, places = words_of(groups.per_family), padded_group(groups.per_family)
    # Of a footprint that holds as much of a group as the repeat does, views see what they see of the repeat.
    share = np.concatenate([coverage.mean[:, places], coverage.mean[:, 4 * words, None]], axis=1)
    unit = np.concatenate([coverage.scale[:, places], coverage.scale[:, 4 * words, None]], axis=1)
    weight = np.where(share > 0, unit * seen_scale / np.maximum(share, 1e-9) / _LARGEST**3, 0)
    table = np.zeros((2, 4 * words, MOMENTS), np.float32)
    table[..., 2] = table[..., 5] = 1
    spread = groups.spread
    columns = [
        groups.normal,
        weight[:, :-1, None],
        groups.tangent,
        *(spread[..., i, j, None] for i, j in ((0, 0), (1, 1), (0, 1), (0, 2), (1, 2))),
    ]
    table[:, places] = np.concatenate(columns, axis=2)
    return table, weight[:, -1].astype(np.float32)
