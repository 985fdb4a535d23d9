"""Fabrics as shaders read them: one record a fabric, and 32-bit words of all tables."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.aggregate import footprint_albedos
from loomlight.aggregate.footprint_albedos import FootprintAlbedos
from loomlight.models.fabric_model import ALBEDOS
from loomlight.models.interface import ShaderTables
from loomlight.realtime.layout import numpy_type
from loomlight.realtime.networks import Elements
from loomlight.realtime.word_table import Tables, Words, WordTable, add_block, fill, write_tables
from loomlight.scattering.appearance import Appearance, FamilyAppearance
from loomlight.scattering.detail import family_numbers
from loomlight.scattering.variation import FIBRES_ACROSS
from loomlight.yarn import rays
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout, FamilyLayout
from loomlight.yarn.threads import CELL_MAX_LEVELS, FamilyTables

# Cloth with less open area casts the shadow of cloth without: a thousandth of the light is three steps of
# 8-bit sRGB on white cloth.
MIN_OPEN_SHARE = 1e-3
# In the place of the first word of a fabric's openness: there is no light between its yarns.
NO_OPENNESS = 0xFFFFFFFF
Record = NDArray[np.void]


@dataclass(frozen=True, eq=False)
class Packed:
    """Fabrics as buffers.

    Attributes:
        fabrics: records [n].
        families: records of the warp and the weft of each [2 n].
        words: of all tables.
        packed_numbers: networks and latents [m, 4].
    """

    fabrics: Record
    families: Record
    words: Words
    packed_numbers: Elements

    def buffers(self) -> dict[str, NDArray[Any]]:
        """Contents of buffers by name."""
        return {
            "fabrics": self.fabrics,
            "families": self.families,
            "words": self.words,
            "packed_numbers": self.packed_numbers,
        }


def pack_fabrics(
    fabrics: Sequence[tuple[ClothLayout, Appearance] | None],
    uv_size_mm: Sequence[tuple[float, float]] | None = None,
    models: Sequence[ShaderTables | None] | None = None,
) -> Packed:
    """Records of fabrics and the words of their tables.

    Args:
        fabrics: yarns and appearance of each; None for a source that is no fabric.
        uv_size_mm: millimetres per unit of u and of v of each fabric; 100 by default.
        models: what a model reads beside the yarns of each, such as baked tables; None for nothing.
    """
    tables = Tables()
    records = np.zeros(len(fabrics), numpy_type("Fabric"))
    families = np.zeros((len(fabrics), 2), numpy_type("Family"))
    for number, fabric in enumerate(fabrics):
        size = (100.0, 100.0) if uv_size_mm is None else uv_size_mm[number]
        fill(records[number], {"warp": 2 * number, "weft": 2 * number + 1})
        fill(records[number], {"uv_width": size[0], "uv_height": size[1], "openness": NO_OPENNESS})
        if fabric is not None:
            _pack_fabric(records[number], families[number], tables.words, *fabric)
        shown = None if models is None else models[number]
        if shown is not None:
            write_tables(records[number][shown.tables.record], shown, tables)
            if fabric is None:
                fill(records[number], shown.of_source)
    return Packed(records, families.ravel(), tables.words.words(), tables.numbers.elements())


def _pack_fabric(
    record: np.void, families: Record, table: WordTable, layout: ClothLayout, appearance: Appearance
) -> None:
    geometry = YarnGeometry(layout)
    warp, weft = geometry.families
    means = FootprintAlbedos(geometry, appearance)
    _pack_family(families[0], table, warp, layout.warp, appearance.warp)
    _pack_family(families[1], table, weft, layout.weft, appearance.weft)
    for of_family, threads, colours in zip(families, (warp, weft), means.tables, strict=True):
        _pack_colours(of_family, table, threads, colours)
    run_words, max_heights = geometry.words
    fine_x, fine_y = geometry.finest
    low, high = geometry.height_bounds
    variation = appearance.variation
    values = {
        "run_words": table.add(run_words),
        "ends": run_words.shape[1],
        "max_heights": table.add(max_heights),
        "max_height_columns": max_heights.shape[1],
        "height_low": low,
        "height_high": high,
        "lift": rays.LIFT * min(fine_x, fine_y),
        "threads_per_x": 1 / fine_x,
        "threads_per_y": 1 / fine_y,
        "per_relief": 1 / max(high - low, 1e-6),
        "diffuse_blend": appearance.diffuse_blend,
        "optical_depth": appearance.optical_depth,
        "sheen_strength": appearance.sheen.strength,
        "sheen_roughness": appearance.sheen.roughness,
        "fibre_noise": variation.fibre_noise,
        "colour_noise": variation.colour_noise,
        "seed": variation.seed & 0xFFFFFFFF,
        "layer_bound": appearance.layer_bound,
        "fibre_size": min(fine_x, fine_y) / FIBRES_ACROSS,
        "has_yarns": 1,
        "openness": NO_OPENNESS if appearance.openness is None else add_block(appearance.openness, table),
        "has_detail": int(appearance.warp.detail.is_on or appearance.weft.detail.is_on),
        "mean_hole": layout.open_area,
        "is_open": int(layout.open_area > MIN_OPEN_SHARE),
    }
    fill(record, values)


def _pack_family(
    record: np.void,
    table: WordTable,
    threads: FamilyTables,
    layout: FamilyLayout,
    appearance: FamilyAppearance,
) -> None:
    count = threads.lower.size
    size = float(threads.upper[0] - threads.lower[0])
    bins = math.ceil(threads.period / threads.finest) + 1
    values = {
        "is_alike": int(threads.uniform),
        "count": count,
        "inverse_count": 1 / count,
        "half_inverse_count": 0.5 / count,
        "size": size,
        "inverse_size": 1 / size,
        "half_width": threads.half_width[0],
        "start": threads.lower[0],
        "period": threads.period,
        "inverse_period": 1 / threads.period,
        "bins": bins,
        "height_scale": layout.height_scale,
        "twist_sine": math.sin(layout.twist),
        "twist_cosine": math.cos(layout.twist),
        "level": threads.highest / CELL_MAX_LEVELS,
        "roughness": appearance.roughness,
    }
    rows = np.stack(
        [np.sin(threads.inclination), np.tan(threads.inclination / 2), threads.arc, threads.edge_drop], axis=1
    )
    values["bend_table"] = table.add(rows[:1] if threads.uniform else rows)
    if not threads.uniform:
        first = threads.lower[0]
        lower, upper = threads.lower - first, threads.upper - first
        edges = np.arange(bins) * (threads.period / bins)
        first_threads = np.searchsorted(lower, edges, side="right") - 1
        values["first_thread_table"] = table.add(first_threads)
        values["place_table"] = table.add(
            np.stack([lower, upper, threads.centre - first, threads.half_width], axis=1)
        )
    values |= family_numbers(appearance.detail)
    albedos = np.stack([np.asarray(getattr(appearance, name), np.float64) for name in ALBEDOS], axis=1)
    alike = bool(np.allclose(albedos, albedos[:1], rtol=0, atol=1e-12))
    values["albedo_table"] = table.add(albedos[:1] if alike else albedos)
    values["albedo_stride"] = 0 if alike else albedos[0].size
    fill(record, values)


def _pack_colours(
    record: np.void, table: WordTable, threads: FamilyTables, colours: footprint_albedos.FamilyColours
) -> None:
    lengths = np.stack([2 * threads.half_width, threads.upper - threads.lower], axis=1)
    before = np.concatenate([np.zeros((1, 2)), np.cumsum(lengths, axis=0)])
    quantities = len(colours.axes) + 1
    values = {
        "before": table.add(before),
        "visible_total": before[-1, 0],
        "smallest_box": footprint_albedos.MIN_BOX * threads.period / threads.lower.size,
        "quantities": quantities,
        "colour_mean": table.add(colours.mean),
        "colour_axes": table.add(colours.axes),
        "area_unit": colours.unit,
        "crossing_area": colours.crossing,
    }
    if quantities > 1:
        values["colour_threads"] = table.add(colours.threads)
        values["colour_areas"] = table.add(colours.areas[..., :quantities])
    fill(record, values)
