"""The model lobes as shaders read it: baked tables of a fabric, or room for what kernels will bake."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from loomlight.models.lobes import regimes
from loomlight.models.lobes.tables import LobeTables
from loomlight.realtime.bake import BakePlan
from loomlight.realtime.word_table import Tables, WordTable, fill, packed_bytes
from loomlight.yarn.layout import ClothLayout


def pack_lobes(record: np.void, lobes: LobeTables, layout: ClothLayout | None, tables: Tables) -> None:
    """Appends baked tables; `record` is that of the fabric."""
    if layout is None:
        return
    table, packs = tables.words, lobes.packs
    values = _common_fields(table, lobes.levels, lobes.base_size, packs, layout) | {
        "front_warp_packs": lobes.warp_packs[0],
        "back_warp_packs": lobes.warp_packs[1],
        "coverage": table.add(packed_bytes(lobes.coverage[..., : 4 * packs])),
        "coverage_holes": table.add(packed_bytes(lobes.coverage[..., 4 * packs])),
        "projected_area": table.add(packed_bytes(lobes.projected_area)),
        "light_visibility": table.add(packed_bytes(lobes.light_visibility)),
        "irradiance": table.add(packed_bytes(lobes.irradiance)),
        "moments": table.add(lobes.moments),
        "joint": table.add(packed_bytes(lobes.joint)),
        "front_hole_weight": lobes.hole_weight[0],
        "back_hole_weight": lobes.hole_weight[1],
    }
    fill(record["lobes"], values)


def reserve_lobes(record: np.void, plan: BakePlan, layout: ClothLayout | None, tables: Tables) -> None:
    """The same for tables that kernels write: what they find out themselves stays 0.

    Joint visibility that is not known stays 0 too, which makes ratios of 1.
    """
    if layout is None:
        return
    table = tables.words
    values = _common_fields(table, plan.levels, plan.base_size, plan.sizes["packs"], layout)
    values |= {
        name: table.add(packed_bytes(plan.joint))
        if name == "joint" and plan.joint is not None
        else table.reserve(size)
        for name, size in plan.table_sizes.items()
    }
    fill(record["lobes"], values)


def _common_fields(
    table: WordTable, pyramid: NDArray[np.int64], base_size: float, packs: int, layout: ClothLayout
) -> dict[str, float]:
    """Fields that follow from the draft and the number of groups, and the table of levels."""
    width, height = layout.size
    picks, ends = layout.warp_on_top.shape
    thread = math.sqrt(width / ends * height / picks)
    levels = np.pad(np.asarray(pyramid, np.float64), ((0, 0), (0, 1)))
    return {
        "is_baked": 1,
        "inverse_base_size": 1 / base_size,
        "last_level": len(levels) - 1,
        # Node indices stay below 2²⁴, which float32 holds exactly.
        "levels": table.add(levels),
        "face_nodes": int(pyramid[-1, 0]) + 1,
        "packs": packs,
        "threads_per_mm": 1 / thread,
        "unit_level": math.log2(max(thread, regimes.SQUARE_SCALE * base_size)),
    }
