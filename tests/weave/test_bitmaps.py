"""Bitmaps of looms: what is black, where the first pick lies, and one a weft."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as numpy_strategies
from PIL import Image

from loomlight.core.errors import InputError
from loomlight.weave import draft_of_wefts, load_draft, named_weave, read_bitmap, split_wefts, write_bitmaps
from loomlight.weave.bitmaps import BitmapLayout, order_text, parse_order

TWILL = named_weave("twill 3/1").drawdown


@pytest.mark.parametrize("suffix", ["png", "bmp", "tif", "tiff"])
def test_a_bitmap_has_one_bit_a_crossing_and_black_lifts(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"cloth.{suffix}"
    write_bitmaps([(path, TWILL)])
    with Image.open(path) as picture:
        assert (picture.mode, picture.size) == ("1", (4, 4))
        # End 1 of pick 1 is lifted: the pixel at the bottom left is black.
        assert np.asarray(picture)[::-1].tolist() == (~TWILL).tolist()
    np.testing.assert_array_equal(read_bitmap(path), TWILL)
    np.testing.assert_array_equal(load_draft(path).drawdown, TWILL)


@given(
    warp_up=numpy_strategies.arrays(bool, st.tuples(st.integers(1, 17), st.integers(1, 17))),
    layout=st.builds(
        BitmapLayout,
        st.sampled_from(["black", "white"]),
        st.sampled_from(["bottom", "top"]),
        st.sampled_from(["left", "right"]),
    ),
)
@settings(max_examples=40, suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
def test_every_layout_comes_back(tmp_path: Path, warp_up: np.ndarray, layout: BitmapLayout) -> None:
    """Those of one colour alone, too: a weft may lie under the warp all the way."""
    write_bitmaps([(tmp_path / "a.bmp", warp_up)], layout)
    np.testing.assert_array_equal(read_bitmap(tmp_path / "a.bmp", layout), warp_up)


def test_each_option_of_the_layout_turns_one_thing(tmp_path: Path) -> None:
    path = tmp_path / "a.png"
    Image.fromarray(np.array([[0, 255, 255], [255, 255, 255]], np.uint8)).save(path)
    assert np.argwhere(read_bitmap(path)).tolist() == [[1, 0]]
    assert np.argwhere(~read_bitmap(path, BitmapLayout(lifted="white"))).tolist() == [[1, 0]]
    assert np.argwhere(read_bitmap(path, BitmapLayout(first_pick="top"))).tolist() == [[0, 0]]
    assert np.argwhere(read_bitmap(path, BitmapLayout(first_end="right"))).tolist() == [[1, 2]]


def test_pixels_of_other_colours_are_refused(tmp_path: Path) -> None:
    pixels = np.zeros((3, 3, 3), np.uint8)
    pixels[1, 2] = 200, 30, 30
    Image.fromarray(pixels).save(tmp_path / "a.png")
    with pytest.raises(
        InputError, match=r"a\.png holds pixels that are neither .* the first of them #c81e1e: save it"
    ):
        read_bitmap(tmp_path / "a.png")
    Image.fromarray(np.zeros((2, 16385), np.uint8)).save(tmp_path / "wide.png")
    with pytest.raises(InputError, match="16385 x 2 pixels"):
        read_bitmap(tmp_path / "wide.png")


def test_several_bitmaps_are_written_together_or_not_at_all(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="does not exist"):
        write_bitmaps([(tmp_path / "a.png", TWILL), (tmp_path / "none" / "b.png", TWILL)])
    with pytest.raises(InputError, match=r"written as \.png or \.bmp or \.tif or \.tiff, not \.gif"):
        write_bitmaps([(tmp_path / "a.png", TWILL), (tmp_path / "b.gif", TWILL)])
    assert list(tmp_path.iterdir()) == []


@given(st.lists(st.integers(0, 2), min_size=1, max_size=20), st.integers(0, 2**32 - 1))
@settings(max_examples=60, deadline=None)
def test_wefts_that_are_split_and_woven_again_are_the_draft(weft: list[int], seed: int) -> None:
    drawdown = np.random.default_rng(seed).random((len(weft), 5)) < 0.5
    colors = np.array([[0.1, 0, 0], [0, 0.2, 0], [0, 0, 0.3]])
    plain = named_weave("plain")
    draft = replace(plain, drawdown=drawdown, weft=replace(plain.weft, colors=colors[weft]))
    wefts, order = split_wefts(draft)
    again = draft_of_wefts([weft.warp_up for weft in wefts], order)
    np.testing.assert_array_equal(again.drawdown, drawdown)
    # As many colours, in the same order.
    names = {number: len(set(weft[:at])) for at, number in reversed(list(enumerate(weft)))}
    assert again.weft.color_index is not None
    assert again.weft.color_index.tolist() == [names[number] + 1 for number in weft]
    for each in wefts:
        assert each.color is not None


def test_the_order_is_its_shortest_period() -> None:
    assert split_wefts(named_weave("houndstooth 4"))[1] == [1, 1, 1, 1, 2, 2, 2, 2]
    assert split_wefts(named_weave("twill 2/2"))[1] == [1]
    assert order_text([1, 1, 2]) == "1 1 2"
    assert order_text([1] * 40 + [2, 3, 3, 3]) == "40x1 2 3x3"
    assert parse_order("40x1, 2 3×3") == [1] * 40 + [2, 3, 3, 3]


@pytest.mark.parametrize("text", ["", " ", "a", "0", "17", "1 x2", "0x1", "1.5", "99999x1", "²x1", "1 -2"])
def test_orders_that_are_none_are_refused(text: str) -> None:
    with pytest.raises(InputError, match="order"):
        parse_order(text)


@pytest.mark.parametrize(
    ("shapes", "order", "says"),
    [
        ([(2, 4), (2, 5)], [], r"have 4, 5 ends; all need as many"),
        ([(2, 4), (4, 4)], [], r"have 2, 4 picks, but the order 1 2 takes 3, 3"),
        ([(2, 4), (2, 4)], [1, 3], r"order of wefts 1 3 is none of 2 bitmaps"),
        ([(1, 4)] * 17, [], r"17 bitmaps of wefts; 1 to 16"),
    ],
)
def test_bitmaps_that_do_not_go_together_are_refused(
    shapes: list[tuple[int, int]], order: list[int], says: str
) -> None:
    with pytest.raises(InputError, match=says):
        draft_of_wefts([np.ones(shape, bool) for shape in shapes], order)


def test_more_wefts_than_shuttles_are_refused() -> None:
    draft = named_weave("plain")
    many = replace(draft, drawdown=np.ones((17, 2), bool))
    many = replace(many, weft=replace(many.weft, colors=np.arange(51).reshape(17, 3) / 51))
    with pytest.raises(InputError, match="wefts of 17 colours; looms have up to 16"):
        split_wefts(many)
