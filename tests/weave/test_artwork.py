"""Artwork whose colours are weaves: each colour's structure lies where the picture has it, in step."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.weave import Draft, figured_structure, longest_floats, named_weave
from loomlight.weave.artwork import BACK, Artwork, weave_artwork
from loomlight.weave.figured import ogee_damask
from loomlight.weave.structures import Structure, sateen, satin

RED, WHITE, BLUE = "#c00000", "#ffffff", "#2060a0"
LEVELS = {RED: (192, 0, 0), WHITE: (255, 255, 255), BLUE: (32, 96, 160)}


@pytest.fixture
def paint(tmp_path: Path) -> Callable[..., Path]:
    """Writes a picture of colours by number [rows, ends], the first row at the bottom."""

    def write(index: Any, colours: tuple[str, ...] = (WHITE, RED, BLUE), name: str = "art.png") -> Path:
        pixels = np.array([LEVELS[colour] for colour in colours], np.uint8)[np.asarray(index)[::-1]]
        Image.fromarray(pixels).save(tmp_path / name)
        return tmp_path / name

    return write


def of(weaves: dict[str, list[Structure | None]], **options: Any) -> Artwork:
    """An artwork whose weaves are named by their colours."""
    return Artwork(weaves, {colour: [colour] * len(listed) for colour, listed in weaves.items()}, **options)


def test_two_colours_are_the_damask(paint: Callable[..., Path]) -> None:
    """The same as the figure of `figured_structure`, which puts two structures by a mask."""
    mask = ogee_damask(160, 240)
    art = of({WHITE: [sateen(8, 3)], RED: [satin(8, 3)]}, longest_float=10)
    draft = weave_artwork(paint(mask.astype(int)), art)
    expected = figured_structure(mask, satin(8, 3), sateen(8, 3), float_limit=10)
    np.testing.assert_array_equal(draft.drawdown, expected)
    assert (draft.title, draft.weft.colors, draft.weft.spacing_mm) == ("art", None, None)


def test_weaves_are_in_step_over_the_whole_artwork(paint: Callable[..., Path]) -> None:
    """Crossing by crossing, as a weaver would look it up; plain weaves of three kinds need no binding."""
    index = np.random.default_rng(2).integers(0, 3, (24, 24))
    weaves = [named_weave(name).drawdown for name in ("twill 2/1", "twill 2/2 s", "plain")]
    art = of(dict(zip((WHITE, RED, BLUE), ([weave] for weave in weaves), strict=True)), longest_float=20)
    draft = weave_artwork(paint(index), art)
    for pick in range(24):
        for end in range(24):
            weave = weaves[index[pick, end]]
            assert draft.drawdown[pick, end] == weave[pick % weave.shape[0], end % weave.shape[1]]


def test_each_weft_has_a_weave_of_its_own(paint: Callable[..., Path]) -> None:
    """Two picks of weft 1 and one of weft 2 a row; each counts its own picks, in its own repeat."""
    index = np.repeat([[0, 1]], [6, 6], axis=1).repeat(12, axis=0)
    twill, plain = named_weave("twill 2/1").drawdown, named_weave("plain").drawdown
    art = of({WHITE: [twill, plain], RED: [plain, twill]}, order=[1, 1, 2], longest_float=20)
    draft = weave_artwork(paint(index), art)
    assert (draft.picks, draft.ends) == (36, 12)
    assert draft.weft.color_index is not None
    assert draft.weft.color_index.tolist() == [1, 1, 2] * 12
    for weft, (left, right) in enumerate(((twill, plain), (plain, twill)), start=1):
        own = draft.drawdown[draft.weft.color_index == weft]
        pick = np.arange(len(own))[:, None]
        end = np.arange(12)[None]
        np.testing.assert_array_equal(own[:, :6], left[pick % len(left), end % len(left)][:, :6])
        np.testing.assert_array_equal(own[:, 6:], right[pick % len(right), end % len(right)][:, 6:])
    assert draft.weft.colors is not None
    assert len(np.unique(draft.weft.colors, axis=0)) == 2


def test_a_regulator_leaves_out_picks_and_takes_up_no_cloth(paint: Callable[..., Path]) -> None:
    """The extra weft is woven in rows 4 to 7 alone, where its picks share the rows' length."""
    index = np.zeros((16, 8), int)
    index[4:8, 2:6] = 1
    plain = named_weave("plain").drawdown
    art = of({WHITE: [plain, BACK], RED: [plain, sateen(8, 3)]}, extra_from=2)
    draft = weave_artwork(paint(index), art, rows_per_cm=20)
    assert draft.picks == 16 + 4
    assert draft.weft.color_index is not None
    assert draft.weft.color_index.tolist() == [1] * 4 + [1, 2] * 4 + [1] * 8
    assert draft.weft.spacing_mm is not None
    np.testing.assert_allclose(draft.weft.spacing_mm, [0.5] * 4 + [0.25] * 8 + [0.5] * 8)
    # Outside its figure the extra weft is on the back, unbound.
    extra = draft.drawdown[draft.weft.color_index == 2]
    assert extra[:, [0, 1, 6, 7]].all()
    np.testing.assert_array_equal(extra[:, 2:6], sateen(8, 3)[4:8, 2:6])


def test_floats_are_bound_where_areas_meet_and_nowhere_else(paint: Callable[..., Path]) -> None:
    rng = np.random.default_rng(7)
    index = np.kron(rng.integers(0, 2, (16, 16)), np.ones((5, 5), int))
    # Both warp-faced, so that their floats join.
    weaves = {WHITE: [satin(8, 3)], RED: [satin(8, 5)]}
    raw = weave_artwork(paint(index), of(weaves, longest_float=1000)).drawdown
    draft = weave_artwork(paint(index), of(weaves))
    assert longest_floats(Draft(raw)).longest > 10
    # Seven in satin, and a third more.
    assert longest_floats(draft).longest <= 10
    changed = draft.drawdown != raw
    assert 0 < changed.mean() < 0.05
    even = weave_artwork(paint(np.zeros((16, 16), int)), of({WHITE: [sateen(8, 3)]}))
    np.testing.assert_array_equal(even.drawdown, np.tile(sateen(8, 3), (2, 2)))


def test_the_nearest_colour_is_taken_where_that_is_asked_for(tmp_path: Path) -> None:
    pixels = np.array([[(250, 250, 250), (190, 2, 1)], [(0, 0, 0), (255, 255, 255)]], np.uint8)
    Image.fromarray(np.tile(pixels, (2, 2, 1))).save(tmp_path / "a.png")
    weaves: dict[str, list[Structure | None]] = {
        WHITE: [np.ones((2, 2), bool)], RED: [np.zeros((2, 2), bool)]
    }  # fmt: skip
    draft = weave_artwork(tmp_path / "a.png", of(weaves, nearest=True, longest_float=9))
    assert draft.drawdown[:2, :2].tolist() == [[False, True], [True, False]]
    with pytest.raises(
        InputError,
        match=r'a\.png has 4 pixels of "#000000", and 2 more colours without a weave; weaves names no such '
        r'colour, and "#c00000" is nearest: give it a weave',
    ):
        weave_artwork(tmp_path / "a.png", of(weaves))


def test_a_photograph_is_refused_in_a_sentence(tmp_path: Path) -> None:
    pixels = np.random.default_rng(0).integers(0, 256, (64, 64, 3), np.uint8)
    Image.fromarray(pixels).save(tmp_path / "photo.png")
    with pytest.raises(
        InputError, match=r"and \d+ more colours .* reduce the picture to few colours"
    ) as caught:
        weave_artwork(tmp_path / "photo.png", of({WHITE: [sateen(5, 2)]}))
    assert "\n" not in str(caught.value)


def test_a_weave_that_does_not_divide_the_artwork_is_cut_with_a_warning(paint: Callable[..., Path]) -> None:
    path = paint(np.zeros((16, 18), int))
    with pytest.warns(
        LoomlightWarning, match=r"has 18 ends, and \"#ffffff\" repeats over 8: .* 16 or 24 would"
    ):
        draft = weave_artwork(path, of({WHITE: [satin(8, 3)]}, longest_float=12))
    assert longest_floats(draft).longest <= 12


@pytest.mark.parametrize(
    ("weaves", "options", "says"),
    [
        ({WHITE: [BACK, BACK]}, {}, r"leaves every weft on the back"),
        ({WHITE: [satin(8, 3)] * 2}, {"order": [1, 1]}, r'order = "1 1" does not fit 2 wefts'),
        ({WHITE: [satin(8, 3)]}, {"order": [1, 2]}, r'order = "1 2" does not fit 1 weft:'),
        ({WHITE: [satin(8, 3)]}, {"extra_from": 2}, r"regulator = 2 is none of the 1 wefts"),
        ({WHITE: [satin(8, 3)] * 2}, {"extra_from": 3}, r"regulator = 3 is none of the 2 wefts"),
        ({WHITE: [satin(8, 3)] * 2}, {"order": [1] * 2000 + [2]}, r"32016 picks, and at most 16384"),
    ],
)
def test_what_cannot_be_woven_is_refused(
    paint: Callable[..., Path], weaves: dict[str, list[Structure | None]], options: dict[str, Any], says: str
) -> None:
    with pytest.raises(InputError, match=says):
        weave_artwork(paint(np.zeros((16, 16), int)), of(weaves, **options))


def test_more_than_one_part_of_the_picture_is_one_cloth(
    paint: Callable[..., Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    index = np.kron(np.random.default_rng(4).integers(0, 3, (10, 6)), np.ones((8, 8), int))
    plain = named_weave("plain").drawdown
    weaves = {WHITE: [sateen(8, 3), BACK], RED: [satin(8, 3), sateen(8, 5)], BLUE: [plain, plain]}
    whole = weave_artwork(paint(index), of(weaves, extra_from=2))
    for name in ("artwork._CROSSINGS_AT_ONCE", "binding._CROSSINGS_AT_ONCE"):
        monkeypatch.setattr(f"loomlight.weave.{name}", 100)
    monkeypatch.setattr("loomlight.core.images._PIXELS_AT_ONCE", 100)
    parts = weave_artwork(paint(index), of(weaves, extra_from=2))
    np.testing.assert_array_equal(parts.drawdown, whole.drawdown)
