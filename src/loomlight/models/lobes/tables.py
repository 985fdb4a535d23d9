"""The baked tables of a fabric in their memory layout, packed uint8x4.

Colours and roughness are not baked, so their edits need no baking.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import FloatType
from loomlight.core.frozen import FrozenArg
from loomlight.core.tables import Shown, Tables, computed, derived, flag, given, setting, size, table
from loomlight.models.lobes import point_sampled
from loomlight.models.lobes.coverage import CoveragePyramid, build_pyramid, count_cells, cover_hidden
from loomlight.models.lobes.groups import Groups, NearestGroup, find_groups
from loomlight.models.lobes.hemisphere import NODES, byte_of_group, pack_count
from loomlight.models.lobes.rays import (
    launch_rays,
    launch_views,
    top_down_samples,
    upload_cloth,
    view_samples,
)
from loomlight.models.lobes.visibility import (
    JOINT_FACTORS,
    JOINT_NODES,
    VisibilityTables,
    joint_factors,
    launch_joint,
    tabulate_visibility,
)
from loomlight.yarn.layout import ClothLayout
from loomlight.yarn.stack import ClothGeometry

_MAX = 255.0
# Numbers of a group; see `LobeTables.moments`.
MOMENTS = 12


def _pyramid_fault(levels: NDArray[np.int64]) -> str:
    sizes = levels[:, 1] * levels[:, 2]
    consistent = len(levels) > 0 and (levels[:, 1:] > 0).all() and levels[0, 0] == 0
    if consistent and (levels[1:, 0] == np.cumsum(sizes)[:-1]).all():
        return ""
    return "no pyramid: bake it again"


class LobeTables(Tables):
    """The tables of one fabric, both faces: in files, on devices and in shaders.

    See `coverage`, `visibility` and `groups` for what they are made of.
    """

    # 2: shadow rays start from hits. 3: joint visibility is a table.
    version = 3
    record = "lobes"

    is_baked = flag("0 where the fabric has no tables of lobes")
    base_size: float = setting("side of the squares of the pyramid's first level, millimetres", "mm", 0.0)

    @computed("1 / side of the squares of the pyramid's first level")
    def inverse_base_size(self) -> float:
        """1/mm."""
        return 1 / self.base_size

    @computed("of the coverage pyramid")
    def last_level(self) -> float:
        """Number of the level of one node."""
        return len(self.levels) - 1

    levels: NDArray[np.int64] = table(
        "first node, columns, rows of each level",
        (None, 3),
        # Four numbers each; node indices stay below 2²⁴, which float32 holds exactly.
        words="words",
        shown=Shown((None, 4), lambda levels: np.pad(levels.astype(np.float32), ((0, 0), (0, 1)))),
        fault=_pyramid_fault,
    )

    @computed("nodes of the pyramid of one face")
    def face_nodes(self) -> int:
        """Of all levels."""
        return int((self.levels[:, 1] * self.levels[:, 2]).sum())

    packs = size(
        "packs of four groups; even",
        of="moments",
        counted="groups a face",
        expected="whole packs of four, and an even number of them",
        multiple=2,
    )

    @computed("how many, the first ones, are the warp's")
    def front_warp_packs(self) -> int:
        """Of the front."""
        return int(self.warp_packs[0])

    @computed("the same of the back")
    def back_warp_packs(self) -> int:
        """Of the back."""
        return int(self.warp_packs[1])

    coverage: NDArray[np.uint8] = table(
        "packed groups of each node of the pyramid; in files, holes in the first byte of a last pack",
        ("2 faces", "face_nodes", "4 * (packs + 1)"),
        words="bytes",
        shown=Shown(("2 faces", "face_nodes", "4 * packs"), lambda coverage: coverage[..., :-4]),
    )

    @derived("holes of each node of the pyramid", ("2 faces", "face_nodes"), words="bytes")
    def coverage_holes(self) -> NDArray[np.uint8]:
        """They stand apart, as a footprint reads them once and groups pack by pack."""
        return self.coverage[..., -4]

    projected_area: NDArray[np.uint8] = table(
        "square roots of projected areas; holes in the first byte of the last pack",
        ("2 faces", f"{NODES} nodes", "4 * (packs + 1)"),
        words="bytes",
    )
    light_visibility: NDArray[np.uint8] = table(
        "visibility from lights: 255 is 1",
        ("2 faces", "2 sides", f"{NODES} nodes", "4 * packs"),
        words="bytes",
    )
    irradiance: NDArray[np.uint8] = table(
        "irradiance: 255 is 1/π", ("2 faces", "2 sides", f"{NODES} nodes", "4 * packs"), words="bytes"
    )
    moments: NDArray[np.float32] = table(
        "of each group: mean normal, weight of (coverage byte)·(projected area byte)², mean fibre direction, "
        "and xx, yy, xy, xz, yz of its covariance (trace 1 − |mean|²)",
        ("2 faces", "4 * packs", MOMENTS),
        words="words",
    )
    joint: NDArray[np.int16] = table(
        "factors of joint over independent visibility, 16-bit numbers; see `JointLookup`",
        ("2 faces", "2 sides", "2 of view and light", f"{JOINT_NODES} nodes", JOINT_FACTORS),
        words="bytes",
    )

    @computed("weight of holes")
    def front_hole_weight(self) -> float:
        """Of the front."""
        return float(self.hole_weight[0])

    @computed("the same of the back")
    def back_hole_weight(self) -> float:
        """Of the back."""
        return float(self.hole_weight[1])

    hole_weight: NDArray[np.float32] = table("weight of holes", ("2 faces",), low=0)
    warp_packs: NDArray[np.int64] = table(
        "how many packs of each face, the first ones, are the warp's", ("2 faces",), low=0, high="packs"
    )
    threads_per_mm = given("float", "1 / mean size of a thread")
    unit_level = given("float", "log₂ of the length that separates the regimes")


def given_numbers(layout: ClothLayout, base_size: float) -> dict[str, float]:
    """The numbers that `LobeTables` declares as given, of a cloth and the size of its first squares."""
    width, height = layout.size
    picks, ends = layout.warp_on_top.shape
    thread = math.sqrt(width / ends * height / picks)
    unit = max(thread, point_sampled.SQUARE_SCALE * base_size)
    return {"threads_per_mm": 1 / thread, "unit_level": math.log2(unit)}


def bake_tables(
    geometry: ClothGeometry, diffuse_blend: float, per_family: int, float_type: FloatType
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
    geometry: ClothGeometry, diffuse_blend: float, per_family: int, float_type: FloatType
) -> NDArray[np.int16]:
    """`LobeTables.joint` alone; see `bake_tables`."""
    cloth = upload_cloth(geometry, float_type)
    points = launch_joint(cloth)
    groups = find_groups(top_down_samples(cloth), view_samples(launch_views(cloth, per_family)), per_family)
    return joint_factors(points, groups, diffuse_blend)


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
