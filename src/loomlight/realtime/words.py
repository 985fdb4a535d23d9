"""All that shaders read of materials, as words: networks, tables of models, and the records of fabrics.

`write_tables` is the one writer of what models declare (`core/tables.py`); `pack_fabrics` packs fabrics with
their models into the buffers `fabrics`, `families`, `words` and `packed_numbers`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from loomlight.aggregate import footprint_albedos
from loomlight.aggregate.footprint_albedos import FootprintAlbedos
from loomlight.core.tables import Layer, Number, Packing, Shared, Size, Table, Tables
from loomlight.models.fabric_model import ALBEDOS
from loomlight.models.interface import ShaderTables
from loomlight.realtime.records import numpy_type
from loomlight.scattering.appearance import Appearance, FamilyAppearance
from loomlight.scattering.detail import family_numbers
from loomlight.scattering.fibre import mean_layer_shares
from loomlight.scattering.irregularity import IrregularYarns
from loomlight.scattering.variation import FIBRES_ACROSS
from loomlight.yarn import rays
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout, FamilyLayout
from loomlight.yarn.stack import StackedGeometry, cloth_geometry
from loomlight.yarn.threads import CELL_MAX_LEVELS, FamilyTables, place_family

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
# Level of a plane that is nowhere the first of a face, millimetres.
NOWHERE_FIRST = -1e30
Record = NDArray[np.void]


@dataclass(frozen=True, eq=False)
class Packed:
    """Fabrics as buffers.

    Attributes:
        fabrics: records [n].
        families: records of the warp and the weft of each [2 n], then those of layers.
        words: of all tables.
        packed_numbers: networks and latents [m, 4].
    """

    fabrics: Record
    families: Record
    words: Words
    packed_numbers: Elements

    @property
    def is_layered(self) -> bool:
        """Whether any of the fabrics has layers."""
        return bool((self.fabrics["planes"] > 0).any())

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
    layers = [0 if fabric is None else len(fabric[0].layers) for fabric in fabrics]
    # Two of all threads, and two of each layer.
    first_of_layers = np.cumsum([2 * len(fabrics), *(2 * (count + 1) * (count > 0) for count in layers)])
    families = np.zeros(int(first_of_layers[-1]), numpy_type("Family"))
    for number, fabric in enumerate(fabrics):
        size = (100.0, 100.0) if uv_size_mm is None else uv_size_mm[number]
        fill(records[number], {"warp": 2 * number, "weft": 2 * number + 1})
        fill(records[number], {"uv_width": size[0], "uv_height": size[1], "openness": NO_OPENNESS})
        if fabric is not None:
            own = families[2 * number : 2 * number + 2]
            _pack_fabric(records[number], own, families, int(first_of_layers[number]), buffers.words, *fabric)
        shown = None if models is None else models[number]
        if shown is not None:
            write_tables(records[number][shown.tables.record], shown, buffers)
            if fabric is None:
                fill(records[number], shown.of_source)
    return Packed(records, families, buffers.words.words(), buffers.numbers.elements())


def _pack_fabric(
    record: np.void,
    own: Record,
    families: Record,
    first: int,
    table: WordTable,
    layout: ClothLayout,
    appearance: Appearance,
) -> None:
    """Writes the record of a fabric, those of its families, and from `first` on those of its layers."""
    # Shaders draw layers without ties, and without the relief that these quilt.
    layout = replace(layout, ties=())
    geometry = cloth_geometry(layout)
    means = FootprintAlbedos(geometry, appearance)
    if isinstance(geometry, YarnGeometry):
        threads = geometry.families
    else:
        threads = (place_family(layout.warp), place_family(layout.weft))
    looks = (appearance.warp, appearance.weft)
    for of_family, tables, of_layout, look in zip(
        own, threads, (layout.warp, layout.weft), looks, strict=True
    ):
        _pack_threads(of_family, table, tables, of_layout)
        _pack_look(of_family, table, look, appearance.optical_depth)
    if isinstance(geometry, YarnGeometry):
        for of_family, tables, colours in zip(own, threads, means.tables, strict=True):
            _pack_colours(of_family, table, tables, colours)
            of_family["cloth_mean"] = of_family["colour_mean"]
        surface = _pack_crossings(table, geometry)
    else:
        surface = _pack_stack(own, families, first, table, geometry, appearance, means)
    fine_x, fine_y = geometry.finest
    low, high = geometry.height_bounds
    variation = appearance.variation
    values = surface | {
        "ends": layout.warp_on_top.shape[1],
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
        "is_coloured": int(means.varied),
    }
    fill(record, values)
    if appearance.is_irregular:
        _pack_irregular(own, table, layout, appearance)


def _pack_crossings(table: WordTable, geometry: YarnGeometry) -> dict[str, int]:
    """Words of the runs of one plane, and its max-height pyramid."""
    run_words, max_heights = geometry.words
    return {
        "run_words": table.add(run_words),
        "max_heights": table.add(max_heights),
        "max_height_columns": max_heights.shape[1],
    }


def _pack_stack(
    own: Record,
    families: Record,
    first: int,
    table: WordTable,
    geometry: StackedGeometry,
    appearance: Appearance,
    means: FootprintAlbedos,
) -> dict[str, int]:
    """Appends the planes of layered cloth, their order, and how much of each shows.

    Args:
        own: records of the warp and the weft of all threads.
        first: index of the first record among `families` that is left for the layers.

    Returns:
        fields of the fabric that say where they are.
    """
    seen, layout, stacking = means.seen, geometry.layout, geometry.layout.stacking
    assert seen is not None
    for of_family, look, mean in zip(
        own, (appearance.warp, appearance.weft), seen.front_means(means.planes), strict=True
    ):
        rows = np.concatenate([np.asarray(getattr(look, name), np.float64) for name in ALBEDOS], axis=1)
        values = {"quantities": 1, "colour_mean": table.add(rows.mean(axis=0)), "cloth_mean": table.add(mean)}
        fill(of_family, values)
    for axis, (threads, of_layout) in enumerate(zip(seen.axes, (layout.warp, layout.weft), strict=True)):
        _pack_threads(families[first + axis], table, threads, of_layout, with_tables=True)
        _pack_lengths(families[first + axis], table, threads)
    fields: dict[str, int] = {
        "planes": len(geometry.layers),
        "plane_axes": first,
        "stacks": len(geometry.ranks),
        "plane_orders": table.add(_plane_orders(geometry)),
        "plane_shares": table.add(seen.numbers),
        "regions": table.add(packed_bytes(np.zeros(4, np.uint8) if stacking is None else stacking.regions)),
    }
    if seen.regions is not None:
        stacks = len(geometry.ranks)
        areas = table.add(np.ascontiguousarray(seen.regions[..., :stacks]))
        fill(families[first], {"quantities": stacks, "colour_areas": areas, "area_unit": seen.unit})
    records = np.zeros(len(geometry.layers), numpy_type("Plane"))
    for number, (plane, layer, colours) in enumerate(
        zip(geometry.layers, layout.layers, means.planes, strict=True)
    ):
        of_plane = first + 2 * (number + 1)
        pairs = zip(plane.families, (layer.layout.warp, layer.layout.weft), colours.tables, strict=True)
        for family, (threads, of_layout, of_family) in enumerate(pairs):
            _pack_threads(families[of_plane + family], table, threads, of_layout, with_tables=True)
            _pack_colours(families[of_plane + family], table, threads, of_family)
        low, high = plane.height_bounds
        front, back = geometry.highest_first[number]
        values = _pack_crossings(table, plane) | {
            "warp": of_plane,
            "weft": of_plane + 1,
            "ends": layer.ends.size,
            "end_numbers": table.add(layer.ends),
            "pick_numbers": table.add(layer.picks),
            "height_low": low,
            "height_high": high,
            "front_level": max(front, NOWHERE_FIRST),
            "back_level": max(back, NOWHERE_FIRST),
            "start_x": layer.start[0],
            "start_y": layer.start[1],
            "fine_x": plane.finest[0],
            "fine_y": plane.finest[1],
        }
        fill(records[number], values)
    fields["plane_records"] = table.add(records.view(np.uint32))
    return fields


def _plane_orders(geometry: StackedGeometry) -> Words:
    """Number and level of the planes of each stack from either face, nearest first [stacks, 2, planes, 2].

    The last one stands for those that a stack has not.
    """
    ranks, levels = geometry.ranks, geometry.levels
    orders = np.zeros((len(ranks), 2, ranks.shape[1], 2), np.uint32)
    for stack, of_stack in enumerate(ranks):
        order = np.argsort(np.where(of_stack < 0, 127, of_stack), kind="stable")
        order = order[: np.count_nonzero(of_stack >= 0)]
        for face, (side, nearest_first) in enumerate(((1, order), (-1, order[::-1]))):
            padded = np.pad(nearest_first, (0, ranks.shape[1] - order.size), mode="edge")
            orders[stack, face, :, 0] = padded
            orders[stack, face, :, 1] = (side * levels[stack, padded]).astype(np.float32).view(np.uint32)
    return orders


def _pack_irregular(families: Record, table: WordTable, layout: ClothLayout, appearance: Appearance) -> None:
    """How the yarns of both families vary; families that vary alike share a table."""
    yarns = IrregularYarns(YarnGeometry(layout), appearance)
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


def _pack_threads(
    record: np.void,
    table: WordTable,
    threads: FamilyTables,
    layout: FamilyLayout,
    with_tables: bool = False,
) -> None:
    """Where the threads of a family lie in a plane, and how they bend.

    Args:
        with_tables: also of threads that are alike.
    """
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
    }
    rows = np.stack(
        [np.sin(threads.inclination), np.tan(threads.inclination / 2), threads.arc, threads.edge_drop], axis=1
    )
    values["bend_table"] = table.add(rows[:1] if threads.uniform else rows)
    if with_tables or not threads.uniform:
        first = threads.lower[0]
        lower, upper = threads.lower - first, threads.upper - first
        edges = np.arange(bins) * (threads.period / bins)
        first_threads = np.searchsorted(lower, edges, side="right") - 1
        values["first_thread_table"] = table.add(first_threads)
        values["place_table"] = table.add(
            np.stack([lower, upper, threads.centre - first, threads.half_width], axis=1)
        )
    fill(record, values)


def _pack_look(record: np.void, table: WordTable, appearance: FamilyAppearance, optical_depth: float) -> None:
    """What the yarns of a family scatter."""
    turned, through = mean_layer_shares(appearance.roughness, optical_depth)
    values = {
        "roughness": appearance.roughness,
        "layer_turned": float(turned),
        "layer_through": float(through),
        **family_numbers(appearance.detail),
    }
    albedos = np.stack([np.asarray(getattr(appearance, name), np.float64) for name in ALBEDOS], axis=1)
    alike = bool(np.allclose(albedos, albedos[:1], rtol=0, atol=1e-12))
    values["albedo_table"] = table.add(albedos[:1] if alike else albedos)
    values["albedo_stride"] = 0 if alike else albedos[0].size
    fill(record, values)


def _pack_lengths(record: np.void, table: WordTable, threads: FamilyTables) -> None:
    """Visible widths and cells of the threads of a family before each."""
    lengths = np.stack([2 * threads.half_width, threads.upper - threads.lower], axis=1)
    before = np.concatenate([np.zeros((1, 2)), np.cumsum(lengths, axis=0)])
    values = {
        "before": table.add(before),
        "visible_total": before[-1, 0],
        "smallest_box": footprint_albedos.MIN_BOX * threads.period / threads.lower.size,
    }
    fill(record, values)


def _pack_colours(
    record: np.void, table: WordTable, threads: FamilyTables, colours: footprint_albedos.FamilyColours
) -> None:
    """Albedos of the threads of a family over footprints."""
    _pack_lengths(record, table, threads)
    quantities = len(colours.axes) + 1
    values = {
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
