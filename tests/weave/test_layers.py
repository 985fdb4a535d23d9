"""Layers of drafts: exact ones against strong connection of "lies above", those of windows against plans.

Covers: weave/layers.py, weave/layer_drafts.py, weave/recognition.py
"""

import warnings
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as numpy_strategies
from numpy.typing import NDArray

from examples.makers import layered
from loomlight.core.colour import linear_to_srgb
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.weave import load_draft, named_weave, weave_names
from loomlight.weave.draft import Draft
from loomlight.weave.drawing import draw_layer
from loomlight.weave.layer_drafts import (
    binding_points,
    layer_draft,
    layers_text,
    named_layer,
    plain_draft,
)
from loomlight.weave.layers import Layers, find_layers, layer_sizes
from loomlight.weave.recognition import weave_name

from .conftest import cases, corpus


def connected_sizes(warp_up: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Ends and picks of the strongly connected parts that have both, by walking over all threads."""
    picks, ends = warp_up.shape
    above = np.zeros((ends + picks, ends + picks), dtype=int)
    above[:ends, ends:] = warp_up.T
    above[ends:, :ends] = ~warp_up
    reach = above + np.eye(ends + picks, dtype=int)
    for _ in range(ends + picks):
        reach = np.minimum(reach @ reach, 1)
    mutual = (reach & reach.T).astype(bool)
    parts = {tuple(row) for row in mutual.tolist()}
    # What lies higher reaches more.
    ordered = sorted(parts, key=lambda part: -int(reach[part.index(True)].sum()))
    sizes = [(sum(part[:ends]), sum(part[ends:])) for part in ordered]
    return [size for size in sizes if min(size) > 0]


@given(numpy_strategies.arrays(bool, st.tuples(st.integers(1, 6), st.integers(1, 6))))
def test_any_drawdown_has_the_layers_of_its_connected_parts(warp_up: NDArray[np.bool_]) -> None:
    assert layer_sizes(warp_up) == connected_sizes(warp_up)


@given(st.lists(st.integers(0, 4), min_size=1, max_size=4), st.integers(0, 99))
def test_stacked_layers_are_counted_in_any_order_of_threads(kinds: list[int], seed: int) -> None:
    """Layers of plain weave and of twill, and loose ends and picks, one upon the other."""
    blocks = [
        np.eye(2, dtype=bool),
        named_weave("twill 2/1").drawdown,
        named_weave("sateen 5/2").drawdown,
        np.zeros((0, 1), dtype=bool),
        np.zeros((1, 0), dtype=bool),
    ]
    warp_up = np.zeros((0, 0), dtype=bool)
    for kind in kinds:
        under = blocks[kind]
        # Ends above pass over the picks below; picks above lie over the ends below.
        warp_up = np.block(
            [
                [warp_up, np.zeros((warp_up.shape[0], under.shape[1]), dtype=bool)],
                [np.ones((under.shape[0], warp_up.shape[1]), dtype=bool), under],
            ]
        )
    if 0 not in warp_up.shape:
        rng = np.random.default_rng(seed)
        warp_up = warp_up[rng.permutation(len(warp_up))][:, rng.permutation(warp_up.shape[1])]
        wanted = [blocks[kind].shape[::-1] for kind in kinds if kind < 3]
        assert layer_sizes(warp_up) == wanted == connected_sizes(warp_up)


def test_stitches_bind_layers() -> None:
    double = sateen_double()
    assert layer_sizes(double) == [(5, 5), (5, 5)]
    double[0, 1] = True  # one end of the lower layer rises over one pick of the upper one
    assert layer_sizes(double) == [(10, 10)]


def sateen_double() -> NDArray[np.bool_]:
    sateen = named_weave("sateen 5/2").drawdown
    double = np.zeros((10, 10), dtype=bool)
    double[::2, ::2], double[1::2, 1::2] = sateen, sateen
    double[1::2, ::2] = True
    return double


@pytest.mark.parametrize("case", cases("d1*.wif"))
def test_a_double_weave_warns_in_one_sentence(case: Path) -> None:
    with pytest.warns(LoomlightWarning) as caught:
        load_draft(case)
    assert [str(warning.message) for warning in caught] == [
        f"{case} holds 2 layers of cloth that no thread binds together (2 ends and 2 picks lie above 2 ends "
        "and 2 picks); neural and clustered do not take it, and pages without Python show a single plane."
    ]


@pytest.mark.parametrize("file", [*corpus("good"), *corpus("warn")])
def test_real_drafts_of_one_layer_give_no_warning(file: Path) -> None:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        draft = load_draft(file)
    assert not [warning for warning in caught if "layers" in str(warning.message)]
    assert len(layer_sizes(draft.drawdown)) == 1


@pytest.mark.parametrize("name", weave_names())
def test_named_weaves_are_one_layer(name: str) -> None:
    assert len(layer_sizes(named_weave(name).drawdown)) == 1


def test_large_layers_are_found_by_sums_of_rows_and_columns() -> None:
    double = np.zeros((4096, 4096), dtype=bool)
    double[1::2, ::2] = True
    double[::4, ::4] = double[2::4, 2::4] = double[1::4, 1::4] = double[3::4, 3::4] = True
    assert layer_sizes(double) == [(2048, 2048), (2048, 2048)]


# ------------------------------------------------------------------------ front layers, worked out by hand
#
# Rows from the last pick down to the first, "x" where the warp is on top.

PLAIN = """
.x
x.
"""
TWILL_2_2 = """
x..x
..xx
.xx.
xx..
"""
WEFT_TWILL = """
...x
..x.
.x..
x...
"""
# The pick behind the first of the face binds the third end, and so on.
BEHIND_WEFT_TWILL = """
x.xx
.xxx
xxx.
xx.x
"""
# Of plain weave on twelve ends, woven from the left, with a weft that comes back behind.
TUBE_FRONT = """
.x.x.x.x.x.x
x.x.x.x.x.x.
"""
# The other eleven ends. Behind, the weft goes on over the end after the last one, seen from outside, and
# under the next; seen from the front these are up and down the other way round.
TUBE_BACK = """
x.x.x.x.x.x
.x.x.x.x.x.
"""


def by_hand(text: str, picks: int, ends: int) -> NDArray[np.bool_]:
    rows = np.array([[mark == "x" for mark in line] for line in text.split()])[::-1]
    return np.tile(rows, (picks // rows.shape[0], ends // rows.shape[1]))


def every(first: int, step: int, count: int) -> list[int]:
    return list(range(first, first + step * count, step))


FACE_OF_THREE = [end for end in range(48) if end % 3 != 2]
# Draft, layer, its ends and picks, its drawdown.
BY_HAND = [
    (layered.double_plain, "front", [0, 2], [0, 2], PLAIN),
    (layered.double_plain, "back", [1, 3], [1, 3], PLAIN),
    (layered.tube, "front", every(0, 2, 12), [0, 2], TUBE_FRONT),
    (layered.tube, "back", every(1, 2, 11), [1, 3], TUBE_BACK),
    *((layered.four_layers, str(at + 1), [at, at + 4], [at, at + 4], PLAIN) for at in range(4)),
    (
        layered.matelasse,
        "front",
        FACE_OF_THREE,
        [pick for pick in range(96) if pick % 6 not in (2, 5)],
        PLAIN,
    ),
    (layered.matelasse, "2", FACE_OF_THREE, every(2, 6, 16), "x"),
    (layered.matelasse, "back", every(2, 3, 16), every(5, 6, 16), PLAIN),
    (layered.backed_twill, "front", [0, 1, 2, 3], [0, 2, 4, 6], WEFT_TWILL),
    (layered.backed_twill, "back", [0, 1, 2, 3], [1, 3, 5, 7], BEHIND_WEFT_TWILL),
    (layered.stitched_double_cloth, "front", every(0, 2, 8), every(0, 2, 8), TWILL_2_2),
    (layered.stitched_double_cloth, "back", every(1, 2, 8), every(1, 2, 8), TWILL_2_2),
    (layered.pique, "front", FACE_OF_THREE[:16], [pick for pick in range(40) if pick % 5 < 4], PLAIN),
    (layered.pique, "2", FACE_OF_THREE[:16], every(4, 5, 8), "x"),
]


@pytest.mark.parametrize(("make", "name", "ends", "picks", "text"), BY_HAND)
def test_a_layer_is_the_one_worked_out_by_hand(
    make: Callable[[], Draft], name: str, ends: list[int], picks: list[int], text: str
) -> None:
    draft = make()
    layer = named_layer(draft, name)
    assert layer.end[0].tolist() == ends
    assert layer.pick[:, 0].tolist() == picks
    np.testing.assert_array_equal(layer.warp_up, by_hand(text, len(picks), len(ends)))
    alone = plain_draft(draft, layer)
    assert alone is not None
    assert alone.warp.colors is not None
    assert draft.warp.colors is not None
    np.testing.assert_array_equal(alone.warp.colors, draft.warp.colors[ends])
    # Threads of a layer take up the whole width.
    assert alone.warp.spacing_mm is not None
    assert alone.warp.spacing_mm.sum() == pytest.approx(draft.ends * layered.SPACING_MM)


@pytest.mark.parametrize("case", cases("d1*.wif"))
def test_the_face_of_a_double_weave_is_solid_plain_weave(case: Path) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", LoomlightWarning)
        draft = load_draft(case)
    alone = plain_draft(draft, named_layer(draft, "front"))
    assert alone is not None
    assert alone.warp.colors is not None
    assert alone.weft.colors is not None
    np.testing.assert_array_equal(alone.drawdown, by_hand(PLAIN, 2, 2))
    red = alone.warp.colors[0]
    assert red[0] > 10 * red[2]
    assert np.all(alone.warp.colors == red)
    assert np.all(alone.weft.colors == red)


# Pick and end, from 1, of the stitches: the end behind the k-th pick of the face stands 5k places along.
STITCHES = [(1, 2), (3, 12), (5, 6), (7, 16), (9, 10), (11, 4), (13, 14), (15, 8)]


def test_stitches_are_where_the_plan_has_them() -> None:
    drawdown = layered.stitched_double_cloth().drawdown
    found = np.argwhere(binding_points(drawdown, find_layers(drawdown))) + 1
    assert [tuple(place) for place in found.tolist()] == STITCHES


def in_front(layers: Layers, system: int) -> NDArray[np.bool_]:
    return np.array([stack[0] == (system,) for stack in layers.stacks])[layers.regions]


def test_cloths_change_places_where_the_blocks_do() -> None:
    layers = find_layers(layered.pattern_double_weave().drawdown)
    assert [system.ends[:2].tolist() for system in layers.systems] == [[0, 2], [1, 3]]
    block = np.arange(32) // 16
    wrong = in_front(layers, 0) != (block[:, None] == block[None])
    # Where four blocks meet the crossings around are two of each, at four crossings.
    assert np.count_nonzero(wrong) <= 4
    assert {*np.argwhere(wrong).ravel().tolist()} <= {0, 15, 16, 31}


def test_the_front_of_two_blocks_is_plain_weave_of_either_cloth() -> None:
    draft = layered.pattern_double_weave()
    layer = named_layer(draft, "front")
    half = np.arange(16) // 8
    is_a = layer.end % 2 == 0
    assert np.count_nonzero(is_a != (half[:, None] == half[None])) <= 2
    np.testing.assert_array_equal(is_a, layer.pick % 2 == 0)
    np.testing.assert_array_equal(layer.warp_up, by_hand(PLAIN, 16, 16))
    assert plain_draft(draft, layer) is None


@pytest.mark.parametrize("origin", ["bottom-left", "top-right"])
def test_a_layer_of_several_cloths_is_drawn_in_the_colours_of_their_threads(origin: str) -> None:
    draft = layered.pattern_double_weave()
    layer = named_layer(draft, "back")
    assert draft.warp.colors is not None
    red, blue = (np.rint(255 * linear_to_srgb(colour)) for colour in draft.warp.colors[:2])
    shown = np.where((layer.end % 2 == 0)[..., None], red, blue)
    turned = shown[::-1] if origin == "bottom-left" else shown[:, ::-1]
    np.testing.assert_array_equal(draw_layer(draft, layer, origin=origin, cell_px=1), turned)
    large = draw_layer(draft, layer, origin=origin, cell_px=8, repeats=2)
    assert large.shape == (256, 256, 3)
    # In the middle of a thread the picture has its colour.
    middle = large[4:128:8, 4:128:8].astype(int)
    assert np.array_equal(middle[..., 0] > middle[..., 2], turned[..., 0] > turned[..., 2])


def test_a_pocket_is_closed_where_all_threads_weave_as_one() -> None:
    layers = find_layers(layered.pocket().drawdown)
    assert set(layers.stacks) == {((0,), (1,)), ((0, 1),)}
    inside = np.arange(32) < 24
    wrong = in_front(layers, 0) != (inside[:, None] & inside[None])
    # No more than the pocket is told apart; at its corners a few crossings, of three threads, are not.
    assert not np.any(wrong & ~(inside[:, None] & inside[None]))
    corner = np.isin(np.arange(32), [0, 1, 2, 21, 22, 23])
    assert not np.any(wrong & ~(corner[:, None] & corner[None]))
    assert np.count_nonzero(wrong) < 12


@pytest.mark.parametrize("turn", [(0, 0), (5, 9)])
@pytest.mark.parametrize("flipped", [False, True])
def test_no_thread_floats_from_rim_to_rim_of_a_pocket(turn: tuple[int, int], flipped: bool) -> None:
    """Wherever its repeat begins, and on either side: within the square both cloths are plain weave."""
    drawdown = np.roll(layered.pocket().drawdown, turn, axis=(0, 1))
    drawdown = ~drawdown[:, ::-1] if flipped else drawdown
    layers = find_layers(drawdown)
    apart = np.array([len(stack) == 2 for stack in layers.stacks])[layers.regions]
    for system in layers.systems:
        own, here = (part[np.ix_(system.picks, system.ends)] for part in (drawdown, apart))
        for values, inside in ((own, here), (own.T, here.T)):
            alike = (values == np.roll(values, 1, axis=1)) & inside & np.roll(inside, 1, axis=1)
            assert not alike.any()


def test_an_extra_weft_lies_in_front_in_its_figure() -> None:
    draft = layered.extra_weft_figure()
    layers = find_layers(draft.drawdown)
    assert [system.kind for system in layers.systems] == ["cloth", "extra weft"]
    assert layers.systems[1].picks.tolist() == every(1, 2, 32)
    assert layers.systems[1].host == 0
    away = np.abs(np.arange(32) - 15.5)
    figure = np.repeat(away[:, None] + away[None] < 12, 2, axis=0)
    # A row of 12 steps on either side, each to within a crossing or two of four edges.
    assert np.count_nonzero(in_front(layers, 1) != figure) < 4 * 24
    assert np.all(in_front(layers, 1)[24:40, 12:20])
    assert not np.any(in_front(layers, 1)[:6])


def test_waved_ends_of_a_pique_are_an_extra_warp_behind_its_wadding() -> None:
    layers = find_layers(layered.pique().drawdown)
    kinds = [system.kind for system in layers.systems]
    assert kinds == ["cloth", "extra warp", "extra weft"]
    assert layers.stacks == (((0,), (2,), (1,)),)
    assert layers.systems[1].ends.tolist() == every(2, 3, 8)
    # Eight ends rise over two picks of two groups each.
    assert np.count_nonzero(binding_points(layered.pique().drawdown, layers)) == 8 * 2 * 2


@pytest.mark.parametrize("name", weave_names())
def test_named_weaves_lie_in_one_layer(name: str) -> None:
    draft = named_weave(name)
    layers = find_layers(draft.drawdown)
    assert layers.depth == 1
    assert len(layers.systems) == 1
    assert layers_text(draft) == ""


@st.composite
def repeated_drawdowns(draw: st.DrawFn) -> NDArray[np.bool_]:
    """A small part repeated, with few crossings that are otherwise."""
    shape = st.tuples(st.integers(1, 8), st.integers(1, 8))
    part = draw(numpy_strategies.arrays(bool, shape))
    picks, ends = draw(st.tuples(st.integers(1, 40), st.integers(1, 40)))
    drawdown = np.tile(part, (-(-picks // len(part)), -(-ends // part.shape[1])))[:picks, :ends]
    rng = np.random.default_rng(draw(st.integers(0, 99)))
    return drawdown ^ (rng.random(drawdown.shape) < draw(st.sampled_from([0, 0.03])))


@settings(max_examples=30)
@given(repeated_drawdowns())
def test_any_drawdown_has_layers_that_hold_each_thread_once(warp_up: NDArray[np.bool_]) -> None:
    layers = find_layers(warp_up)
    picks, ends = warp_up.shape
    of_ends = np.concatenate([system.ends for system in layers.systems])
    of_picks = np.concatenate([system.picks for system in layers.systems])
    assert sorted(of_ends.tolist()) == list(range(ends))
    assert sorted(of_picks.tolist()) == list(range(picks))
    for stack in layers.stacks:
        assert sorted(at for group in stack for at in group) == list(range(len(layers.systems)))
    for layer in (0, -1):
        shown = layer_draft(warp_up, layers, layer)
        assert shown.warp_up.size > 0
        np.testing.assert_array_equal(shown.warp_up, warp_up[shown.pick, shown.end])
        plain_draft(Draft(warp_up), shown)
    binding_points(warp_up, layers)
    layers_text(Draft(warp_up))


def test_a_large_figured_double_weave_has_its_two_cloths() -> None:
    """Two plain cloths of 512 ends and picks that change places along waves."""
    pick, end = np.indices((512, 512))
    a_in_front = np.sin(pick / 40) + np.sin(end / 35) > 0
    same = pick % 2 == end % 2
    drawdown = np.where(same, (pick // 2 + end // 2) % 2 == 0, a_in_front == (end % 2 == 0))
    layers = find_layers(drawdown)
    assert set(layers.stacks) == {((0,), (1,)), ((1,), (0,))}
    assert [system.ends[0] for system in layers.systems] == [0, 1]
    # Two waves each way have an edge of about 4 × 512 crossings, told to within one.
    assert np.count_nonzero(in_front(layers, 0) != a_in_front) < 4 * 512


@pytest.mark.parametrize(
    "name", ["plain", "twill 2/1 z", "twill 1/3 s", "twill 3/1/1/2 z", "satin 8/3", "sateen 5/2"]
)
def test_a_weave_is_recognised_wherever_its_repeat_begins(name: str) -> None:
    drawdown = named_weave(name).drawdown
    for turn in range(len(drawdown)):
        assert weave_name(np.roll(drawdown, (turn, 2 * turn), axis=(0, 1))) == name


@pytest.mark.parametrize("name", ["basket 2/2", "basket 3/2", "warp rib 2/2", "weft rib 3/1"])
def test_grouped_plain_weaves_are_recognised(name: str) -> None:
    assert weave_name(named_weave(name).drawdown) == name


def test_what_has_no_name_is_not_named() -> None:
    assert weave_name(named_weave("waffle 8").drawdown) is None
    assert weave_name(np.ones((3, 3), dtype=bool)) is None


def test_the_summary_says_layers_weaves_setts_and_stitches() -> None:
    assert layers_text(layered.stitched_double_cloth()).splitlines() == [
        "layers: 2, A upon B",
        "  A: twill 2/2 z, 8 ends (1, 3, 5 …) and 8 picks (1, 3, 5 …), 12.5 ends/cm and 12.5 picks/cm",
        "  B: twill 2/2 z, 8 ends (2, 4, 6 …) and 8 picks (2, 4, 6 …), 12.5 ends/cm and 12.5 picks/cm",
        "  A and B are bound at 8 of 128 crossings",
    ]


@pytest.mark.parametrize("name", ["0", "4", "rear", "-1", "²", "9" * 5000])
def test_a_layer_that_is_not_there_is_refused(name: str) -> None:
    with pytest.raises(InputError, match='the draft has 3 layers; "front", "back" and 1 to 3 are'):
        named_layer(layered.matelasse(), name)


@pytest.mark.parametrize("picks", ["AB", "AAB", "AABB", "AABAB"])
@pytest.mark.parametrize("ends", ["AB", "AAB", "AABB", "AAABB"])
@pytest.mark.parametrize(
    ("front", "behind"), [("plain", "twill 2/2"), ("satin 8/3", "sateen 8/3"), ("basket 2/2", "satin 5/2")]
)
def test_two_cloths_are_found_in_any_turn_of_their_threads(
    front: str, behind: str, ends: str, picks: str
) -> None:
    """Satin upon sateen is the least layered: warp of both is seen much more, or less, than weft."""
    weaves = {"A": named_weave(front).drawdown, "B": named_weave(behind).drawdown}
    # Sixteen and ten are whole repeats of the weaves here, of the cloth with one thread in a turn.
    turns = 40 if "5/2" in behind else 16
    drawdown = layered.stacked(ends * turns, picks * turns, weaves)
    layers = find_layers(drawdown)
    assert layers.stacks == (((0,), (1,)),)
    is_end, is_pick = (np.array([name == "A" for name in order * turns]) for order in (ends, picks))
    np.testing.assert_array_equal(layers.systems[0].ends, np.flatnonzero(is_end))
    np.testing.assert_array_equal(layers.systems[0].picks, np.flatnonzero(is_pick))
    assert not binding_points(drawdown, layers).any()


@pytest.mark.parametrize("name", ["satin 5/2", "satin 8/3", "twill 3/1"])
def test_figures_of_satin_on_sateen_are_a_single_layer(name: str) -> None:
    """Where a figure ends, threads of the one lie upon those of the other, for the width of the figure."""
    satin = named_weave(name).drawdown
    pick, end = np.indices((160, 120))
    drawdown = satin[pick % len(satin), end % len(satin)]
    for radius, middle in ((30, (50, 40)), (14, (120, 90)), (9, (20, 100))):
        inside = (pick - middle[0]) ** 2 + (end - middle[1]) ** 2 < radius**2
        drawdown = np.where(inside, ~satin[pick % len(satin), -end % len(satin)], drawdown)
    assert find_layers(drawdown).depth == 1


@pytest.mark.parametrize("name", ["warp rib 9/1", "weft rib 8/8", "basket 8/8", "twill 8/8", "waffle 16"])
def test_long_floats_are_a_single_layer(name: str) -> None:
    assert find_layers(named_weave(name).drawdown).depth == 1
