"""Photographs are read upright and in linear light, or refused in a sentence."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from loomlight.capturing.photo import read_photo
from loomlight.core.colour import srgb_to_linear
from loomlight.core.errors import InputError
from loomlight.weave.named import named_weave
from tests.capturing.pictures import save, woven

CLOTH = woven(named_weave("plain").drawdown, size=(160, 120))


def test_it_is_linear_and_has_a_scale(tmp_path: Path) -> None:
    photo = read_photo(save(tmp_path / "a.png", CLOTH), 16.0)
    assert photo.px_per_mm == 10
    # Eight bits: half a step of 255.
    assert np.abs(photo.encoded - CLOTH).max() < 0.6 / 255


def test_it_is_turned_as_its_file_says(tmp_path: Path) -> None:
    from PIL import Image

    exif = Image.Exif()
    exif[0x0112] = 6  # a quarter turn clockwise
    path = save(tmp_path / "a.jpg", np.rot90(CLOTH), exif=exif, quality=97)
    photo = read_photo(path, 16.0)
    assert photo.linear.shape == (120, 160, 3)
    # JPEG's own error.
    assert np.abs(photo.encoded - CLOTH).mean() < 0.02


def test_a_large_one_is_made_smaller(tmp_path: Path) -> None:
    photo = read_photo(save(tmp_path / "a.png", CLOTH), 16.0, side=80)
    assert photo.linear.shape == (60, 80, 3)
    assert photo.full_size == (160, 120)
    # Means of light, not of encoded numbers.
    whole = srgb_to_linear(np.rint(255 * CLOTH) / 255)
    assert photo.linear.mean() == pytest.approx(float(whole.mean()), rel=1e-3)


def test_white_paper_and_a_grey_card_set_the_brightness(tmp_path: Path) -> None:
    path = save(tmp_path / "a.png", CLOTH)
    plain = read_photo(path, 16.0).linear
    shown = srgb_to_linear([0xD8 / 255, 0xD4 / 255, 0xCC / 255])
    for reflects, options in ((0.9, {"white": "#d8d4cc"}), (0.18, {"grey_card": "#d8d4cc"})):
        # Single precision.
        np.testing.assert_allclose(
            read_photo(path, 16.0, **options).linear, plain * reflects / shown, rtol=1e-5
        )


@pytest.mark.parametrize(
    ("picture", "options", "said"),
    [
        (np.ones((120, 160, 3)), {}, "overexposed"),
        (np.full((120, 160, 3), 0.01), {}, "too dark"),
        (CLOTH[:40], {}, "160 x 40 pixels; 96"),
        (CLOTH, {"width_mm": 0.0}, "width_mm = 0"),
        (CLOTH, {"width_mm": float("nan")}, "width_mm = nan"),
        (CLOTH, {"white": "#000000"}, "too dark"),
        (CLOTH, {"white": "white"}, 'white = "white" is no colour'),
        (CLOTH, {"white": "#ffffff", "grey_card": "#777777"}, "give one of them"),
    ],
)
def test_what_cannot_be_used_is_said(
    picture: np.ndarray, options: dict[str, object], said: str, tmp_path: Path
) -> None:
    path = save(tmp_path / "a.png", picture)
    with pytest.raises(InputError, match=said):
        read_photo(path, **{"width_mm": 16.0, **options})  # type: ignore[arg-type]
