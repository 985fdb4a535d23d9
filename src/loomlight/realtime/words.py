"""All that shaders read of materials, as words: networks, tables of models, and the records of fabrics.

`write_tables` is the one writer of what models declare (`core/tables.py`); `pack_fabrics` packs fabrics with
their models into the buffers `fabrics`, `families`, `words` and `packed_numbers`.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from loomlight.aggregate import footprint_albedos
from loomlight.aggregate.footprint_albedos import FootprintAlbedos
from loomlight.core.errors import LoomlightWarning
from loomlight.core.tables import Layer, Number, Packing, Shared, Size, Table, Tables
from loomlight.models.fabric_model import ALBEDOS
from loomlight.models.interface import ShaderTables
from loomlight.realtime.records import numpy_type
from loomlight.scattering.appearance import Appearance, FamilyAppearance
from loomlight.scattering.detail import family_numbers
from loomlight.scattering.irregularity import IrregularYarns
from loomlight.scattering.variation import FIBRES_ACROSS
from loomlight.yarn import rays
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout, FamilyLayout
from loomlight.yarn.threads import CELL_MAX_LEVELS, FamilyTables

# --------------------------------------------------------------------------------------------------- networks
# Networks as shaders read them: elements of four 32-bit words that hold eight halves or four singles.
#
# `shaders/mlp.slang` describes a layer in memory; this module writes it. Weights of shipped networks are half
# precision in their files too, so that storing halves rounds nothing.


# Outputs that a shader sums at a time, and numbers that it reads at a time.
_TILE, _EIGHT = 4, 8
# Parts of a layer begin at multiples of so many elements of halves: 64 bytes.
_PART = 4

Elements: TypeAlias = NDArray[np.uint32]
"""Elements of a buffer of packed numbers [n, 4]."""


def _up(count: int, multiple: int) -> int:
    return -(-count // multiple) * multiple


def layer_size(inputs: int, outputs: int) -> int:
    """Size of a layer in eights of numbers: elements of halves, pairs of elements of singles."""
    matrix = _up(outputs, _TILE) * (_up(inputs, _EIGHT) // _EIGHT)
    return _up(_up(outputs, _EIGHT) // _EIGHT, _PART) + _up(matrix, _PART)


def packed_numbers(numbers: NDArray[np.floating], half: bool = True) -> Elements:
    """Numbers [..., 8 n] as elements.

    Args:
        half: in half precision, eight an element; else in single precision, four an element.
    """
    kind = np.dtype("<f2" if half else "<f4")
    return np.ascontiguousarray(numbers, kind).view("<u4").astype(np.uint32).reshape(-1, 4)


def packed_layer(
    weight: NDArray[np.floating], bias: NDArray[np.floating] | None = None, half: bool = True
) -> Elements:
    """A layer in memory.

    Args:
        weight: [outputs, inputs].
        bias: [outputs]; without it sums begin at 0.
        half: in half precision, else in single precision.
    """
    outputs, inputs = weight.shape
    matrix = np.zeros((_up(outputs, _TILE), _up(inputs, _EIGHT)))
    matrix[:outputs, :inputs] = weight
    biases = np.zeros(_up(_up(outputs, _EIGHT), _PART * _EIGHT))
    biases[:outputs] = 0 if bias is None else bias
    numbers = np.concatenate([biases, matrix.ravel()])
    numbers = np.pad(numbers, (0, layer_size(inputs, outputs) * _EIGHT - numbers.size))
    return packed_numbers(numbers, half)


def packed_mlp(
    weights: Sequence[NDArray[np.floating]], biases: Sequence[NDArray[np.floating]], half: bool = True
) -> Elements:
    """The layers of `MLP<…>`, one behind the other.

    Args:
        weights: [outputs, inputs] of each layer.
        biases: [outputs] of each layer.

    Raises:
        ValueError: layers that do not fit each other.
    """
    if any(after.shape[1] != before.shape[0] for before, after in pairwise(weights)):
        raise ValueError("the inputs of each layer are the outputs of the one before")
    return np.concatenate([packed_layer(w, b, half) for w, b in zip(weights, biases, strict=True)])


class NumberTable:
    """Elements of networks and latents, one part behind the other."""

    def __init__(self) -> None:
        self._parts: list[Elements] = []
        self.size = 0

    def add(self, elements: Elements) -> int:
        """Appends a part; the index of its first element."""
        first = self.size
        self._parts.append(elements)
        self.size += len(elements)
        return first

    def elements(self) -> Elements:
        """All of them; at least one, as no buffer is empty."""
        return np.concatenate(self._parts) if self._parts else np.zeros((1, 4), np.uint32)


# ------------------------------------------------------------------------------------------------- word table
# Tables that shaders read: 32-bit words, and elements of networks, which all fabrics share.


Words = NDArray[np.uint32]


class WordTable:
    """Tables of 32-bit words, one behind the other."""

    def __init__(self) -> None:
        self._parts: list[Words] = []
        self.size = 0

    def add(self, values: NDArray[np.generic]) -> int:
        """Appends unsigned integers as they are or numbers as float32; the index of the first word."""
        kind = np.uint32 if np.issubdtype(values.dtype, np.integer) else np.float32
        words = np.ascontiguousarray(values, dtype=kind).ravel().view(np.uint32)
        first = self.size
        self._parts.append(words)
        self.size += words.size
        return first

    def words(self) -> Words:
        """All of them; at least one, as no buffer is empty."""
        return np.concatenate(self._parts) if self._parts else np.zeros(1, np.uint32)


@dataclass
class Buffers:
    """What all fabrics append to.

    Attributes:
        words: tables of words.
        numbers: networks and texels.
        networks: first elements of networks that several fabrics share, by checksum.
    """

    words: WordTable = field(default_factory=WordTable)
    numbers: NumberTable = field(default_factory=NumberTable)
    networks: dict[str, int] = field(default_factory=dict)


def write_tables(record: np.void, shown: ShaderTables, buffers: Buffers) -> None:
    """Appends the tables that a model declares, and writes its record: numbers, and where tables begin.

    Given tables come first, in the order in which they are given.

    Args:
        record: the model's own, within that of a fabric.
    """
    declared = type(shown.tables).declarations
    own = [name for name in declared if name not in shown.given]
    for name in (*shown.given, *own):
        of = declared[name]
        value = shown.given[name] if name in shown.given else getattr(shown.tables, name)
        if isinstance(of, Table | Number) and of.words:
            if value is not None:
                shown_value = of.shown_of(value) if isinstance(of, Table) else value
                record[name] = _added(shown_value, of.words, buffers)
        elif isinstance(of, Size | Number) and of.kind:
            record[name] = value


def _added(value: Any, packing: Packing, buffers: Buffers) -> int:
    """Appends a table; where it begins."""
    if packing == "words":
        return buffers.words.add(value)
    if packing == "bytes":
        return buffers.words.add(packed_bytes(value))
    if packing == "elements":
        return buffers.numbers.add(packed_numbers(value, value.dtype == np.float16))
    if not isinstance(value, Shared):
        return buffers.numbers.add(_packed_layers(value))
    if value.sha256 not in buffers.networks:
        buffers.networks[value.sha256] = buffers.numbers.add(_packed_layers(value.layers()))
    return buffers.networks[value.sha256]


def _packed_layers(layers: Sequence[Layer]) -> Elements:
    return np.concatenate([packed_layer(weight, bias, weight.dtype == np.float16) for weight, bias in layers])


def add_block(block: Tables, table: WordTable) -> int:
    """Appends all tables with words of a class as one block in their order; the index of the first word."""
    return table.add(np.concatenate([array.ravel() for array in block.tables_with_words().values()]))


def packed_bytes(values: NDArray[np.generic]) -> Words:
    """Bytes as little-endian words, filled up with zeros at the end; at least one word."""
    flat = np.ascontiguousarray(values).ravel().view(np.uint8)
    missing = -flat.size % 4 or 4 * (flat.size == 0)
    whole = np.pad(flat, (0, missing)) if missing else flat
    return whole.view("<u4").astype(np.uint32, copy=False)


def fill(record: np.void, values: Mapping[str, float]) -> None:
    """Writes values into the fields of a record by name."""
    for name, value in values.items():
        record[name] = value


# ----------------------------------------------------------------------------------------------------- tables
# Fabrics as shaders read them: one record a fabric, and 32-bit words of all tables.


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
    buffers = Buffers()
    records = np.zeros(len(fabrics), numpy_type("Fabric"))
    families = np.zeros((len(fabrics), 2), numpy_type("Family"))
    for number, fabric in enumerate(fabrics):
        size = (100.0, 100.0) if uv_size_mm is None else uv_size_mm[number]
        fill(records[number], {"warp": 2 * number, "weft": 2 * number + 1})
        fill(records[number], {"uv_width": size[0], "uv_height": size[1], "openness": NO_OPENNESS})
        if fabric is not None:
            _pack_fabric(records[number], families[number], buffers.words, *fabric)
        shown = None if models is None else models[number]
        if shown is not None:
            write_tables(records[number][shown.tables.record], shown, buffers)
            if fabric is None:
                fill(records[number], shown.of_source)
    return Packed(records, families.ravel(), buffers.words.words(), buffers.numbers.elements())


def _warn_of_layers(layout: ClothLayout) -> None:
    """Warns of cloth whose layers shaders do not know."""
    if layout.depth > 1:
        warnings.warn(
            f"Shaders show a single plane, and this cloth has {layout.depth} layers: render, maps and "
            "textured materials show them.",
            LoomlightWarning,
            stacklevel=3,
        )


def _pack_fabric(
    record: np.void, families: Record, table: WordTable, layout: ClothLayout, appearance: Appearance
) -> None:
    _warn_of_layers(layout)
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
        "grazing_gain": appearance.grazing.gain,
        "grazing_loss": appearance.grazing.loss,
        "sheen_strength": appearance.sheen.strength,
        "sheen_roughness": appearance.sheen.roughness,
        "fibre_noise": variation.fibre_noise,
        "colour_noise": appearance.thread_noise,
        "seed": variation.seed & 0xFFFFFFFF,
        "layer_bound": appearance.layer_bound,
        "fibre_size": min(fine_x, fine_y) / FIBRES_ACROSS,
        "has_yarns": 1,
        "openness": NO_OPENNESS if appearance.openness is None else add_block(appearance.openness, table),
        "has_detail": int(appearance.warp.detail.is_on or appearance.weft.detail.is_on),
        "mean_hole": layout.open_area,
        "is_open": int(layout.open_area > MIN_OPEN_SHARE),
        "is_irregular": int(appearance.is_irregular),
        "warp_on_top": layout.warp_on_top.mean(),
    }
    fill(record, values)
    if appearance.is_irregular:
        _pack_irregular(families, table, geometry, appearance)


def _pack_irregular(
    families: Record, table: WordTable, geometry: YarnGeometry, appearance: Appearance
) -> None:
    """How the yarns of both families vary; families that vary alike share a table."""
    yarns = IrregularYarns(geometry, appearance)
    places: dict[int, int] = {}
    for record, family, cover, of_family in zip(
        families, (appearance.warp, appearance.weft), yarns.covers, yarns.tables, strict=True
    ):
        if id(of_family) not in places:
            places[id(of_family)] = table.add(of_family.integrals.view(np.uint32))
        values = {"irregular_table": places[id(of_family)], "cover": cover}
        units = zip(("thickness", "cover", "tone", "nep"), of_family.units, strict=True)
        values |= {f"irregular_{quantity}": unit for quantity, unit in units}
        if family.irregularity.neps > 0:
            channels = zip(("red", "green", "blue"), family.irregularity.nep_albedo, strict=True)
            values |= {f"nep_{channel}": albedo for channel, albedo in channels}
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
