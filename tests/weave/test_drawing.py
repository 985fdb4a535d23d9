"""Drawings: what is where, in which colour, and how large."""

from pathlib import Path
from typing import get_args

import numpy as np
import pytest

from loomlight.core.colour import linear_to_srgb
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.weave import Draft, draw_draft, draw_drawdown, drawing, named_weave, read_wif
from loomlight.weave.drawing import Face, Origin

INK = np.array([44, 46, 54])


def crossings(pixels: np.ndarray, cell: int) -> np.ndarray:
    """The middle pixel of each crossing, pick 1 first."""
    return pixels[cell // 2 :: cell, cell // 2 :: cell][::-1].astype(int)


def nearest(pixels: np.ndarray, colors: np.ndarray) -> np.ndarray:
    """Which colour each pixel has, whatever its brightness."""
    encoded = linear_to_srgb(colors) * 255
    hue = pixels / np.linalg.norm(pixels, axis=-1, keepdims=True)
    return np.argmax(hue @ (encoded / np.linalg.norm(encoded, axis=-1, keepdims=True)).T, axis=-1)


@pytest.mark.parametrize("cell", [1, 2, 3, 5, 8, 16])
@pytest.mark.parametrize("face", ["front", "back"])
def test_the_upper_thread_shows_in_its_colour(cell: int, face: str) -> None:
    draft = named_weave("denim")
    assert draft.palette is not None
    pixels = draw_drawdown(draft, face=face, cell_px=cell)  # type: ignore[arg-type]
    assert pixels.shape == (4 * cell, 4 * cell, 3)
    assert pixels.dtype == np.uint8
    warp_on_top = nearest(crossings(pixels, cell), draft.palette) == 0
    expected = draft.drawdown if face == "front" else ~draft.drawdown[:, ::-1]
    assert np.array_equal(warp_on_top, expected)


def test_a_z_twill_rises_to_the_right() -> None:
    pixels = crossings(draw_drawdown(named_weave("twill 1/3"), cell_px=9, repeats=2), 9)
    warp = pixels.sum(axis=-1) < pixels.sum(axis=-1).mean()
    assert warp[0, 0]
    assert warp[1, 1]
    assert warp[2, 2]


def test_parts_stand_where_weaving_software_puts_them(fixtures: Path) -> None:
    draft = read_wif(fixtures / "overshot-treadled.wif")
    cell = 12
    pixels = draw_draft(draft, cell_px=cell, repeats=1)
    # Margin, bar, space, 4 shafts, space, 10 picks, margin; 8 ends, space, 6 treadles, space, bar.
    assert pixels.shape == ((2 + 1 + 1 + 4 + 1 + 10) * cell + 1, (2 + 8 + 1 + 6 + 1 + 1) * cell + 1, 3)
    cells = pixels[cell // 2 :: cell, cell // 2 :: cell]
    inked = np.all(cells == INK, axis=-1)
    # End 1 stands beside the tie-up, pick 1 below it.
    threading = inked[3:7, 1:9][::-1, ::-1]
    assert threading.tolist() == [
        [True, False, False, False, False, False, False, True],
        [False, True, False, False, True, False, False, False],
        [False, False, True, False, False, True, False, False],
        [False, False, False, True, True, False, False, False],
    ]
    tieup = inked[3:7, 10:16][::-1]
    assert tieup[:, 0].tolist() == [True, True, False, False]
    treadling = inked[8:18, 10:16]
    assert np.flatnonzero(treadling[4]).tolist() == [2, 4]
    assert not treadling[5].any()
    bar = cells[1, 1:9].astype(float) / 255
    assert draft.warp.colors is not None
    assert np.allclose(bar, linear_to_srgb(draft.warp.colors)[::-1], atol=1 / 255)


@pytest.mark.parametrize("origin", get_args(Origin))
@pytest.mark.parametrize("face", ["front", "back"])
def test_each_part_follows_the_corner_of_end_1_and_pick_1(fixtures: Path, origin: Origin, face: Face) -> None:
    """Every corner shows the same draft: the drawing turned about, part by part."""
    draft = read_wif(fixtures / "overshot-treadled.wif")
    cells, usual = (
        draw_draft(draft, cell_px=12, repeats=1, origin=corner, face=face)[6::12, 6::12]
        for corner in (origin, "bottom-left")
    )
    rows = slice(None, None, -1 if origin.startswith("top") else 1)
    columns = slice(None, None, -1 if origin.endswith("right") else 1)
    cloth, threading, treadling = np.s_[8:18, 1:9], np.s_[1:7, 1:9], np.s_[8:18, 10:18]
    assert np.array_equal(cells[threading], usual[threading][:, columns])
    assert np.array_equal(cells[treadling], usual[treadling][rows])
    assert np.array_equal(cells[1:7, 10:18], usual[1:7, 10:18])
    # Floats keep their sides, and the middle of a crossing its colour.
    assert np.array_equal(cells[cloth], usual[cloth][rows, columns])


@pytest.mark.parametrize("origin", get_args(Origin))
@pytest.mark.parametrize("face", ["front", "back"])
def test_the_frame_is_around_the_first_repeat(origin: Origin, face: Face) -> None:
    pixels = draw_draft(named_weave("twill 2/1"), cell_px=18, repeats=4, origin=origin, face=face)
    framed = np.argwhere((pixels == [196, 62, 48]).all(axis=-1))
    (top, left), (bottom, right) = framed.min(axis=0) // 18, (framed.max(axis=0) + 9) // 18
    # Margin, bar, space, 3 shafts, space; 12 threads each way.
    rows, columns = (7, 19), (1, 13)
    first_on_right = origin.endswith("right") != (face == "back")
    assert (top, bottom) == ((6, 10) if origin.startswith("top") else (15, 19))
    assert (left, right) == ((9, 13) if first_on_right else (0, 4))
    assert rows[0] - 1 <= top
    assert columns[1] >= right


def test_a_z_twill_rises_to_the_right_from_every_corner() -> None:
    """Weaving software shows cloth half a turn from where scenes have it; mirrored, Z would be S."""
    twill = named_weave("twill 1/3")
    usual = draw_drawdown(twill, cell_px=1, repeats=3)
    half_turn = draw_drawdown(twill, cell_px=1, repeats=3, origin="top-right")
    assert np.array_equal(half_turn, usual[::-1, ::-1])
    assert any(np.array_equal(half_turn, np.roll(usual, step, axis=1)) for step in range(4))


def test_a_liftplan_has_no_tieup(fixtures: Path) -> None:
    draft = read_wif(fixtures / "sinking-liftplan.wif")
    cells = draw_draft(draft, cell_px=12, repeats=1)[6::12, 6::12]
    inked = np.all(cells == INK, axis=-1)
    assert np.argwhere(inked[7:10, 8:11]).tolist() == [[0, 2], [1, 0], [2, 1]]
    assert not inked[3:6, 8:11].any()


def test_large_drafts_are_drawn_a_pixel_a_crossing() -> None:
    rng = np.random.default_rng(1)
    for shape in ((1, 1), (8208, 3), (3, 16380), (700, 900)):
        pixels = draw_draft(Draft(rng.random(shape) < 0.5))
        assert all(pixels.shape[axis] >= shape[axis] for axis in range(2))
    # No room for colours and frame.
    assert draw_draft(Draft(rng.random((24, 16384)) < 0.5)).shape == (24, 16384, 3)


def test_drafts_beyond_a_picture_are_drawn_as_means(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(drawing, "MAXIMUM_PICTURE_PX", 400)
    drawdown = np.random.default_rng(2).random((50, 43)) < 0.5
    with pytest.warns(
        LoomlightWarning, match=r"43 ends and 50 picks are .*: each pixel .* 3 x 3 crossings"
    ) as caught:
        pixels = draw_draft(Draft(drawdown), origin="bottom-left")
    assert len(caught) == 1
    assert pixels.shape == (17, 15, 3)
    flat = np.where(drawdown[::-1, :, None], drawing._WARP, drawing._WEFT)
    for row, column in ((0, 0), (3, 7), (16, 14)):
        block = flat[3 * row : 3 * row + 3, 3 * column : 3 * column + 3]
        expected = linear_to_srgb(block.mean(axis=(0, 1))) * 255
        np.testing.assert_allclose(pixels[row, column], expected, atol=0.51)


def test_refusals() -> None:
    plain = named_weave("plain")
    with pytest.raises(InputError, match="cell_px = 0"):
        draw_drawdown(plain, cell_px=0)
    with pytest.raises(InputError, match=r"2 x 2 crossings: .* 1 to 4095 pixels a crossing would do"):
        draw_drawdown(plain, cell_px=9000)
    scarf = Draft(np.random.default_rng(3).random((8208, 641)) < 0.5)
    with pytest.raises(
        InputError, match=r"cell_px = 2 .* 16384 pixels a side .* 1 pixel a crossing would do"
    ):
        draw_drawdown(scarf, cell_px=2)
    with pytest.raises(InputError, match='face "side"'):
        draw_draft(plain, face="side")  # type: ignore[arg-type]
    with pytest.raises(InputError, match='origin "middle" is not known; it is one of top-right'):
        draw_draft(plain, origin="middle")  # type: ignore[arg-type]
    with pytest.raises(InputError, match="0 repeats"):
        draw_draft(plain, repeats=0)
    with pytest.raises(InputError, match="too many to draw"):
        draw_drawdown(plain, repeats=10**9)
