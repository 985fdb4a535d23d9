"""Radiance pictures, run-length coded and plain."""

from __future__ import annotations

from pathlib import Path

import mitsuba as mi
import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.core.images import read_linear


@pytest.mark.parametrize("width", [4, 40])  # narrow pictures are not run-length coded
def test_pictures_are_read_as_mitsuba_wrote_them(tmp_path: Path, width: int) -> None:
    mi.set_variant("llvm_ad_rgb")
    picture = np.random.default_rng(0).exponential(size=(5, width, 3)).astype(np.float32)
    picture[1] = 0.25  # a run
    picture[2, 1:3] = 0
    mi.Bitmap(picture).write(str(tmp_path / "sky.hdr"))
    found = read_linear(tmp_path / "sky.hdr")
    # Mantissas have eight bits, which pixels share an exponent for.
    assert (np.abs(found - picture) <= picture.max(axis=2, keepdims=True) / 128).all()


def test_damage_is_one_sentence(tmp_path: Path) -> None:
    head = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n"
    for name, data, message in (
        ("text", b"no picture", "no Radiance picture"),
        ("short", head + b"-Y 2 +X 40\n\x02\x02\x00\x28\x80", "end early"),
        ("plain", head + b"-Y 2 +X 4\n\x00", "end early"),
        ("huge", head + b"-Y 999999999 +X 9\n\x00", "do not hold"),
    ):
        (tmp_path / f"{name}.hdr").write_bytes(data)
        with pytest.raises(InputError, match=message):
            read_linear(tmp_path / f"{name}.hdr")


def write_pixel(file: Path, form: bytes, mantissas: tuple[int, int, int]) -> Path:
    pixel = bytes([*mantissas, 129]) * 8  # an exponent of 129 halves 1/64 of a mantissa: m / 128
    file.write_bytes(b"#?RADIANCE\nFORMAT=" + form + b"\n\n-Y 2 +X 4\n" + pixel)
    return file


def test_xyz_becomes_rgb(tmp_path: Path) -> None:
    """By the definition of chromaticities: x : y : 1 - x - y of a primary is that primary alone."""
    grey = read_linear(write_pixel(tmp_path / "grey.hdr", b"32-bit_rle_xyze", (100, 100, 100)))
    np.testing.assert_allclose(grey, 100 / 128, rtol=1e-6)  # Radiance's white is of equal energy
    # 0.640 : 0.330 : 0.030, rounded to mantissas, which leaves a part in 200 to the other primaries.
    red = read_linear(write_pixel(tmp_path / "red.hdr", b"32-bit_rle_xyze", (213, 110, 10)))[0, 0]
    assert red[0] > 1
    assert np.abs(red[1:]).max() < 0.01 * red[0]


def test_other_formats_are_refused(tmp_path: Path) -> None:
    with pytest.raises(
        InputError, match="has FORMAT=32-bit_yuv; 32-bit_rle_rgbe and 32-bit_rle_xyze are read"
    ):
        read_linear(write_pixel(tmp_path / "a.hdr", b"32-bit_yuv", (1, 1, 1)))
