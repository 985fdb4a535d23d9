"""Drawdowns from pictures, and drafts from files.

Covers: weave/load.py
"""

import io
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as numpy_strategies
from PIL import Image, ImageColor, ImageOps

from loomlight.core import images
from loomlight.core.errors import InputError
from loomlight.weave import drawdown_from_picture, load_draft, named_weave, write_wif

from .conftest import cases


def save(path: Path, pixels: np.ndarray) -> Path:
    Image.fromarray(pixels).save(path)
    return path


@given(numpy_strategies.arrays(bool, st.tuples(st.integers(1, 20), st.integers(1, 20))))
@settings(max_examples=30, suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
def test_pictures_are_read_from_the_bottom_left(tmp_path: Path, drawdown: np.ndarray) -> None:
    path = save(tmp_path / "drawdown.png", np.where(drawdown[::-1], 0, 255).astype(np.uint8))
    if drawdown.all() or not drawdown.any():
        with pytest.raises(InputError, match="holds only"):
            drawdown_from_picture(path)
        return
    assert np.array_equal(drawdown_from_picture(path).drawdown, drawdown)


def test_grey_colour_and_transparency_are_split_at_half(tmp_path: Path) -> None:
    grey = save(tmp_path / "grey.png", np.array([[120, 135], [0, 255]], dtype=np.uint8))
    assert drawdown_from_picture(grey).drawdown.tolist() == [[True, False], [True, False]]
    rgba = np.array([[[0, 0, 0, 255], [0, 0, 0, 0], [255, 255, 0, 255], [0, 0, 255, 255]]], dtype=np.uint8)
    assert drawdown_from_picture(save(tmp_path / "rgba.png", rgba)).drawdown.tolist() == [
        [True, False, False, True]
    ]


@pytest.mark.parametrize("suffix", ["png", "webp", "jpg"])
@pytest.mark.parametrize(
    ("warp", "weft"),
    [("blue", "red"), ("#30497a", "#6b2020"), ("#c8c8f8", "#f8f0a0"), ("black", "white"), ("red", "#eee")],
)
def test_two_colours_on_one_side_are_told_apart_by_the_eye(
    tmp_path: Path, warp: str, weft: str, suffix: str
) -> None:
    """JPEG's noise is no third colour; halved colour resolution would make some, and is left out."""
    draft = named_weave("basket 16/16")
    dark, light = (np.array(ImageColor.getrgb(colour), np.uint8) for colour in (warp, weft))
    up = draft.drawdown[::-1, :, None]
    if warp == "#30497a":  # the redder one is darker
        up = ~up
    path = tmp_path / f"two.{suffix}"
    Image.fromarray(np.where(up, dark, light)).save(path, lossless=True, quality=95, subsampling=0)
    assert np.array_equal(load_draft(path).drawdown, draft.drawdown)


@pytest.mark.parametrize("case", cases("p5*.png"))
def test_the_case_of_two_colours(case: Path) -> None:
    """Blue is darker than red to the eye."""
    pixels = np.asarray(Image.open(case).convert("RGB"))[::-1]
    assert np.array_equal(drawdown_from_picture(case).drawdown, pixels[..., 2] > pixels[..., 0])


@pytest.mark.parametrize("case", cases("turn4/i02_drawdown_16bit_grey.png"))
def test_sixteen_bits_are_the_draft_of_eight(case: Path) -> None:
    same = drawdown_from_picture(case.with_name("i02_same_8bit.png")).drawdown
    np.testing.assert_array_equal(drawdown_from_picture(case).drawdown, same)


@pytest.mark.parametrize("case", cases("turn4/i09*"))
def test_turned_pictures_are_read_as_they_are_shown(case: Path) -> None:
    content = case.read_bytes()
    with Image.open(io.BytesIO(content)) as picture:  # of bytes, as a file's name makes Pillow garble TIFF
        shown = np.asarray(ImageOps.exif_transpose(picture))
    np.testing.assert_array_equal(drawdown_from_picture(case).drawdown, shown[::-1] < 128)


def test_three_dark_colours_are_refused(tmp_path: Path) -> None:
    path = save(tmp_path / "three.png", np.eye(3, dtype=np.uint8)[None] * 200)
    with pytest.raises(InputError, match="more than two colours, all darker than half of full brightness"):
        drawdown_from_picture(path)


def test_refusals(tmp_path: Path) -> None:
    white = save(tmp_path / "white.png", np.full((4, 4), 255, dtype=np.uint8))
    with pytest.raises(
        InputError, match=r"white\.png holds only pixels of one colour; cloth needs dark crossings"
    ):
        drawdown_from_picture(white)
    wide = save(tmp_path / "wide.png", np.zeros((1, 16385), dtype=np.uint8))
    with pytest.raises(InputError, match=r"16385 x 1 pixels"):
        drawdown_from_picture(wide)


@pytest.mark.filterwarnings("error")
def test_pictures_are_read_beyond_the_bound_of_pillow(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawdown = np.random.default_rng(5).random((300, 40)) < 0.5
    path = save(tmp_path / "tall.png", np.where(drawdown[::-1], 0, 255).astype(np.uint8))
    monkeypatch.setattr(Image, "MAX_IMAGE_PIXELS", 100)
    # Rows are read in parts, here of 25.
    monkeypatch.setattr(images, "_PIXELS_AT_ONCE", 1000)
    assert np.array_equal(drawdown_from_picture(path).drawdown, drawdown)
    assert Image.MAX_IMAGE_PIXELS == 100


def test_untitled_drafts_get_the_name_of_their_file(tmp_path: Path) -> None:
    untitled = replace(named_weave("twill 3/1 s"), title=" ")
    write_wif(untitled, tmp_path / "my twill.wif")
    assert load_draft(tmp_path / "my twill.wif").title == "my twill"
    write_wif(named_weave("plain"), tmp_path / "other.wif")
    assert load_draft(tmp_path / "other.wif").title == "plain"


def test_load_draft_goes_by_the_suffix(tmp_path: Path) -> None:
    twill = named_weave("twill 3/1 s")
    write_wif(twill, tmp_path / "twill.WIF")
    save(tmp_path / "twill.PNG", np.where(twill.drawdown[::-1], 0, 255).astype(np.uint8))
    for name in ("twill.WIF", "twill.PNG"):
        assert np.array_equal(load_draft(tmp_path / name).drawdown, twill.drawdown)
    assert load_draft(tmp_path / "twill.PNG").title == "twill"
    for name in ("twill.txt", "twill"):
        with pytest.raises(InputError, match=r"a draft is a file or picture in \.wif, "):
            load_draft(tmp_path / name)
