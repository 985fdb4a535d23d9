"""The baked tables of a fabric in their memory layout, packed uint8x4.

Colours and roughness are not baked, so their edits need no baking.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import FloatType
from loomlight.core.errors import InputError
from loomlight.core.frozen import FrozenArg
from loomlight.models.lobes.cloth_samples import top_down_samples, upload_cloth
from loomlight.models.lobes.coverage_pyramid import CoveragePyramid, build_pyramid, count_cells, cover_hidden
from loomlight.models.lobes.groups import Groups, NearestGroup, find_groups
from loomlight.models.lobes.hemisphere import NODES
from loomlight.models.lobes.joint_lookup import JOINT_FACTORS, JOINT_NODES
from loomlight.models.lobes.joint_visibility import joint_factors, launch_joint
from loomlight.models.lobes.packed_uint8 import byte_of_group, pack_count
from loomlight.models.lobes.visibility_rays import launch_rays, launch_views, view_samples
from loomlight.models.lobes.visibility_tables import VisibilityTables, tabulate_visibility
from loomlight.sources.loom_file import LoomFile
from loomlight.yarn.geometry import YarnGeometry

_MAX = 255.0
# Numbers of a group; see `LobeTables.moments`.
MOMENTS = 12


@dataclass(frozen=True, eq=False)
class LobeTables:
    """The tables of one fabric, both faces; see `coverage_pyramid`, `visibility_tables` and `groups`.

    Attributes:
        base_size: side of the squares of the pyramid's first level, millimetres.
        levels: first node, columns, rows of each level [levels, 3].
        coverage: bytes of the pyramid [2 faces, nodes, 4·(packs + 1)]; holes in the last pack's first byte.
        projected_area: bytes [2 faces, hemisphere nodes, 4·(packs + 1)]: square roots; holes as above.
        light_visibility: bytes [2 faces, 2 sides, hemisphere nodes, 4·packs]: 255 is 1.
        irradiance: bytes [2 faces, 2 sides, hemisphere nodes, 4·packs]: 255 is 1/π.
        moments: [2 faces, 4·packs, 12] of each group: mean normal, weight of (coverage byte)·(projected area
            byte)², mean fibre direction, and xx, yy, xy, xz, yz of its covariance (trace 1 − |mean|²).
        hole_weight: the weight of holes [2 faces].
        warp_packs: how many packs of each face, the first ones, are the warp's [2 faces].
        joint: factors of joint over independent visibility, 16-bit numbers [2 faces, 2 sides, view or light,
            nodes, ratios · terms]; see `joint_lookup`.
    """

    base_size: float
    levels: NDArray[np.int64]
    coverage: NDArray[np.uint8]
    projected_area: NDArray[np.uint8]
    light_visibility: NDArray[np.uint8]
    irradiance: NDArray[np.uint8]
    moments: NDArray[np.float32]
    hole_weight: NDArray[np.float32]
    warp_packs: NDArray[np.int64]
    joint: NDArray[np.int16]

    @property
    def packs(self) -> int:
        """Packs of four groups each, without holes."""
        return self.moments.shape[1] // 4

    @property
    def nbytes(self) -> int:
        """Size of all tables."""
        return sum(part.nbytes for part in self.arrays().values())

    def arrays(self) -> dict[str, NDArray[np.generic]]:
        """The tables by name."""
        return {part.name: getattr(self, part.name) for part in fields(self) if part.name != "base_size"}


def bake_tables(
    geometry: YarnGeometry, diffuse_blend: float, per_family: int, float_type: FloatType
) -> LobeTables:
    """Bakes the tables of a fabric: the same bytes every time.

    Args:
        diffuse_blend: w, the weight of the yarn normal in the diffuse term.
        per_family: groups of each family, on average.
        float_type: the Dr.Jit Float type to compute with.
    """
    cloth = upload_cloth(geometry, float_type)
    views = launch_views(cloth, per_family)
    top_down, from_views = top_down_samples(cloth), view_samples(views)
    # The device traces rays while the CPU clusters groups.
    rays, points = launch_rays(cloth, top_down, views), launch_joint(cloth)
    groups = find_groups(top_down, from_views, per_family)
    cells = count_cells(cloth, FrozenArg(NearestGroup(groups, cloth.value.types)), per_family)
    visibility, groups = tabulate_visibility(rays, groups, diffuse_blend)
    cover_hidden(cells, groups, visibility.projected_area)
    coverage = build_pyramid(cells)
    projected_area, area_scale = _quantized_area(visibility, per_family)
    moments, hole_weight = _moments(groups, coverage, area_scale)
    return LobeTables(
        base_size=coverage.base_size,
        levels=coverage.levels,
        coverage=coverage.bytes,
        projected_area=projected_area,
        light_visibility=_quantized(visibility.light_visibility, per_family),
        irradiance=_quantized(visibility.irradiance * math.pi, per_family),
        moments=moments,
        hole_weight=hole_weight,
        warp_packs=_warp_packs(groups),
        joint=joint_factors(points, groups, diffuse_blend),
    )


def bake_joint(
    geometry: YarnGeometry, diffuse_blend: float, per_family: int, float_type: FloatType
) -> NDArray[np.int16]:
    """`LobeTables.joint` alone; see `bake_tables`."""
    cloth = upload_cloth(geometry, float_type)
    points = launch_joint(cloth)
    groups = find_groups(top_down_samples(cloth), view_samples(launch_views(cloth, per_family)), per_family)
    return joint_factors(points, groups, diffuse_blend)


def tables_of_loom(loom: LoomFile) -> LobeTables:
    """The tables in a `.loom` file.

    Raises:
        InputError: tensors that are missing, of another kind, or do not belong together.
    """
    moments = loom.tensor("moments", (2, None, MOMENTS), np.float32)
    if moments.shape[1] % 8 or not moments.size:
        raise InputError(
            f"{loom.file}: the tensor model.moments has {moments.shape[1]} groups a face: it should have "
            "whole packs of four, and an even number of them."
        )
    packs = moments.shape[1] // 4
    warp_packs = loom.tensor("warp_packs", (2,), np.int64)
    if not ((warp_packs >= 0) & (warp_packs <= packs)).all():
        raise InputError(
            f"{loom.file}: the tensor model.warp_packs is {warp_packs.tolist()}: it should be 0 to "
            f"{packs} each, the packs of four groups that there are."
        )
    levels = loom.tensor("levels", (None, 3), np.int64)
    sizes = levels[:, 1] * levels[:, 2]
    consistent = len(levels) > 0 and (levels[:, 1:] > 0).all() and levels[0, 0] == 0
    if not (consistent and (levels[1:, 0] == np.cumsum(sizes)[:-1]).all()):
        raise InputError(f"{loom.file}: the tensor model.levels is no pyramid: bake it again.")
    base_size = loom.setting("base_size", float)
    if not 0 < base_size < math.inf:
        raise InputError(f"{loom.file}: the setting base_size is {base_size:g}: it should be above 0 mm.")
    return LobeTables(
        base_size=base_size,
        levels=levels,
        coverage=loom.tensor("coverage", (2, int(sizes.sum()), 4 * (packs + 1)), np.uint8),
        projected_area=loom.tensor("projected_area", (2, NODES, 4 * (packs + 1)), np.uint8),
        light_visibility=loom.tensor("light_visibility", (2, 2, NODES, 4 * packs), np.uint8),
        irradiance=loom.tensor("irradiance", (2, 2, NODES, 4 * packs), np.uint8),
        moments=moments,
        hole_weight=loom.tensor("hole_weight", (2,), np.float32),
        warp_packs=warp_packs,
        joint=loom.tensor("joint", (2, 2, 2, JOINT_NODES, JOINT_FACTORS), np.int16),
    )


def _warp_packs(groups: Groups) -> NDArray[np.int64]:
    """Packs of the warp of each face: half of them, or as many whole packs as its groups fill."""
    half = pack_count(groups.per_family) // 2
    is_half = groups.warp_count == groups.per_family
    return np.where(is_half, half, groups.warp_count // 4).astype(np.int64)


def _quantized_area(
    visibility: VisibilityTables, per_family: int
) -> tuple[NDArray[np.uint8], NDArray[np.float64]]:
    """Bytes of the square root of the projected area, and the area that 255² stands for [2, 2 K + 1]."""
    area, packs = visibility.projected_area, pack_count(per_family)
    scale = np.maximum(area.max(axis=1), 1e-9)
    table = np.zeros((2, NODES, 4 * (packs + 1)), np.uint8)
    offsets = np.append(byte_of_group(per_family), 4 * packs)
    table[:, :, offsets] = np.rint(np.sqrt(area / scale[:, None]) * _MAX)
    return table, scale


def _quantized(values: NDArray[np.float64], per_family: int) -> NDArray[np.uint8]:
    """Bytes of numbers from 0 to 1, packed by group [2 faces, 2 sides, nodes, 4·packs]."""
    table = np.zeros((*values.shape[:-1], 4 * pack_count(per_family)), np.uint8)
    table[..., byte_of_group(per_family)] = np.rint(np.clip(values, 0, 1) * _MAX)
    return table


def _moments(
    groups: Groups, coverage: CoveragePyramid, area_scale: NDArray[np.float64]
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Rows of twelve numbers a group, and the weight of holes."""
    packs, offsets = pack_count(groups.per_family), byte_of_group(groups.per_family)
    # Where a footprint's coverage is that of the repeat, the visible fraction is the projected area.
    mean = np.concatenate([coverage.mean[:, offsets], coverage.mean[:, 4 * packs, None]], axis=1)
    scale = np.concatenate([coverage.scale[:, offsets], coverage.scale[:, 4 * packs, None]], axis=1)
    weight = np.where(mean > 0, scale * area_scale / np.maximum(mean, 1e-9) / _MAX**3, 0)
    table = np.zeros((2, 4 * packs, MOMENTS), np.float32)
    # Unused rows keep unit vectors, so that nothing is divided by 0.
    table[..., 2] = table[..., 5] = 1
    covariance = groups.covariance
    columns = [
        groups.normal,
        weight[:, :-1, None],
        groups.tangent,
        *(covariance[..., i, j, None] for i, j in ((0, 0), (1, 1), (0, 1), (0, 2), (1, 2))),
    ]
    table[:, offsets] = np.concatenate(columns, axis=2)
    return table, weight[:, -1].astype(np.float32)
