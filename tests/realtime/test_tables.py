"""Fabrics as records and words, and the records' layout.

Covers: realtime/records.py, realtime/words.py
"""

from __future__ import annotations

import numpy as np

from loomlight.realtime.records import BUFFERS, RECORDS, numpy_type, slang_structs
from loomlight.realtime.words import WordTable, pack_fabrics
from loomlight.yarn.geometry import YarnGeometry
from tests.helpers.layouts import TWILL, even_layout, layered_layout, random_layout
from tests.helpers.parity import appearance


def test_records_have_no_padding() -> None:
    for record, fields in RECORDS.items():
        kinds = [kind for _, kind, _ in fields]
        size = sum(numpy_type(kind).itemsize if kind in RECORDS else 4 for kind in kinds)
        assert numpy_type(record).itemsize == size


def test_slang_declares_every_field_and_buffer() -> None:
    text = slang_structs()
    for fields in RECORDS.values():
        assert all(f" {kind} {name};" in text for name, kind, _ in fields)
    for binding, name in enumerate(BUFFERS):
        assert f"[[vk::binding({binding}, 0)]]" in text
        assert f"> {name};" in text


def test_words_keep_integers_and_numbers() -> None:
    table = WordTable()
    assert table.add(np.array([1, 2**32 - 1], np.uint64)) == 0
    assert table.add(np.array([[0.5], [-1]])) == 2
    assert table.words().tolist()[:2] == [1, 2**32 - 1]
    np.testing.assert_array_equal(table.words()[2:].view(np.float32), [0.5, -1])
    assert WordTable().words().size == 1


def test_tables_of_two_fabrics_stand_one_behind_the_other() -> None:
    rng = np.random.default_rng(0)
    layouts = [even_layout(TWILL), random_layout(rng, uneven=True)]
    looks = [appearance(rng, layout, True, True) for layout in layouts]
    packed = pack_fabrics(list(zip(layouts, looks, strict=True)), [(10, 20), (30, 40)])
    records, words = packed.fabrics, packed.words
    for record, layout, look in zip(records, layouts, looks, strict=True):
        runs = YarnGeometry(layout).words[0]
        first = int(record["run_words"])
        np.testing.assert_array_equal(words[first : first + runs.size], runs.ravel())
        warp = packed.families[record["warp"]]
        row = int(warp["albedo_table"] + warp["albedo_stride"] * (len(look.warp.diffuse_reflect) - 1))
        found = words[row : row + 3].view(np.float32)
        np.testing.assert_allclose(found, look.warp.diffuse_reflect[-1], rtol=1e-6)
    assert (records["uv_width"].tolist(), records["uv_height"].tolist()) == ([10, 30], [20, 40])


def test_threads_alike_share_one_row() -> None:
    rng = np.random.default_rng(0)
    layout = even_layout(TWILL)
    families = pack_fabrics([(layout, appearance(rng, layout, False, False))]).families
    assert families["is_alike"].tolist() == [1, 1]
    assert families["albedo_stride"].tolist() == [0, 0]


def test_orders_of_planes_are_those_of_the_cloth() -> None:
    """Nearest first from either face; the last plane stands for those that a stack has not."""
    layout = layered_layout("pocket")
    assert layout.stacking is not None
    packed = pack_fabrics([(layout, appearance(np.random.default_rng(0), layout, False, True))])
    assert packed.is_layered
    record, count = packed.fabrics[0], len(layout.layers)
    first, size = int(record["plane_orders"]), len(layout.stacking.ranks) * 2 * count * 2
    orders = packed.words[first : first + size].reshape(-1, 2, count, 2)
    for stack, ranks in enumerate(layout.stacking.ranks):
        order = sorted(np.flatnonzero(ranks >= 0), key=lambda plane: ranks[plane])
        for face, nearest_first in enumerate((order, order[::-1])):
            padded = [*nearest_first, *[nearest_first[-1]] * (count - len(order))]
            assert orders[stack, face, :, 0].tolist() == padded
            heights = orders[stack, face, :, 1].view(np.float32)
            assert (np.diff(heights[: len(order)]) < 0).all()


def test_records_of_layers_stand_behind_those_of_all_fabrics() -> None:
    """A fabric without layers among two with them keeps the place of its families."""
    rng = np.random.default_rng(0)
    layouts = [layered_layout("double-plain"), even_layout(TWILL), layered_layout("four-layers")]
    packed = pack_fabrics([(layout, appearance(rng, layout, False, False)) for layout in layouts])
    assert packed.fabrics["warp"].tolist() == [0, 2, 4]
    assert packed.fabrics["planes"].tolist() == [2, 0, 4]
    assert packed.fabrics["plane_axes"].tolist() == [6, 0, 12]
    assert len(packed.families) == 6 + 2 * 3 + 2 * 5
