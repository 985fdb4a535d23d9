"""Drawings: what is where, in which colour, and how large."""

from pathlib import Path

import numpy as np
import pytest

from loomlight.core.colour import linear_to_srgb
from loomlight.core.errors import InputError
from loomlight.weave import Draft, draw_draft, draw_drawdown, named_weave, read_wif

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
    threading = inked[3:7, 1:9][::-1]
    assert threading.tolist() == [
        [True, False, False, False, False, False, False, True],
        [False, True, False, False, True, False, False, False],
        [False, False, True, False, False, True, False, False],
        [False, False, False, True, True, False, False, False],
    ]
    tieup = inked[3:7, 10:16][::-1]
    assert tieup[:, 0].tolist() == [True, True, False, False]
    treadling = inked[8:18, 10:16][::-1]
    assert np.flatnonzero(treadling[4]).tolist() == [2, 4]
    assert not treadling[5].any()
    bar = cells[1, 1:9].astype(float) / 255
    assert draft.warp.colors is not None
    assert np.allclose(bar, linear_to_srgb(draft.warp.colors), atol=1 / 255)


def test_a_liftplan_has_no_tieup(fixtures: Path) -> None:
    draft = read_wif(fixtures / "sinking-liftplan.wif")
    cells = draw_draft(draft, cell_px=12, repeats=1)[6::12, 6::12]
    inked = np.all(cells == INK, axis=-1)
    assert np.argwhere(inked[7:10, 8:11][::-1]).tolist() == [[0, 2], [1, 0], [2, 1]]
    assert not inked[3:6, 8:11].any()


def test_pictures_stay_within_bounds() -> None:
    rng = np.random.default_rng(1)
    for shape in ((1, 1), (4096, 3), (3, 4096), (700, 900)):
        pixels = draw_draft(Draft(rng.random(shape) < 0.5))
        assert max(pixels.shape) <= 4096
        assert min(pixels.shape[:2]) >= min(shape)
    wide = draw_draft(Draft(rng.random((2, 4096)) < 0.5))
    assert wide.shape[1] == 4096


def test_refusals() -> None:
    plain = named_weave("plain")
    with pytest.raises(InputError, match="cell_px = 0"):
        draw_drawdown(plain, cell_px=0)
    with pytest.raises(InputError, match="1 to 2047 pixels a crossing"):
        draw_drawdown(plain, cell_px=4000)
    with pytest.raises(InputError, match='face "side"'):
        draw_draft(plain, face="side")  # type: ignore[arg-type]
    with pytest.raises(InputError, match="0 repeats"):
        draw_draft(plain, repeats=0)
    with pytest.raises(InputError, match="too many to draw"):
        draw_drawdown(plain, repeats=10**9)
