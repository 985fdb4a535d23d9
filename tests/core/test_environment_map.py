"""Environment maps: what is no latitude-longitude picture is refused, or named in a warning."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import numpy as np
import OpenEXR
import pytest
from PIL import Image

from loomlight.core.environment_map import read_environment_map
from loomlight.core.errors import InputError, LoomlightWarning

GREY = np.full((4, 8), 0.5, np.float32)


def write_exr(folder: Path, channels: dict[str, np.ndarray], **header: Any) -> Path:
    plain = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    OpenEXR.File({**plain, **header}, channels).write(str(folder / "sky.exr"))
    return folder / "sky.exr"


def window(left: int, top: int, right: int, bottom: int) -> tuple[np.ndarray, np.ndarray]:
    return np.array([left, top], np.int32), np.array([right, bottom], np.int32)


@pytest.mark.parametrize("names", ["RGB", "RGBA", "Y", "YA", ["Z"], ["lamp.Y"], ["left.R", "R", "G", "B"]])
def test_pictures_are_read(tmp_path: Path, names: list[str]) -> None:
    file = write_exr(tmp_path, dict.fromkeys(names, GREY), envmap=OpenEXR.Envmap.ENVMAP_LATLONG)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        np.testing.assert_array_equal(read_environment_map(file), np.full((4, 8, 3), 0.5))


def test_eight_bit_pictures_are_decoded(tmp_path: Path) -> None:
    Image.new("RGB", (8, 4), (188, 188, 188)).save(tmp_path / "sky.png")
    np.testing.assert_allclose(read_environment_map(tmp_path / "sky.png"), 0.503, atol=1e-3)


@pytest.mark.parametrize(
    ("names", "header", "says"),
    [
        ("RGB", {"envmap": OpenEXR.Envmap.ENVMAP_CUBE}, "is a cube map, as its header says"),
        ("RGB", {"dataWindow": window(2, 0, 9, 3), "displayWindow": window(0, 0, 15, 7)}, "8 x 4 from 2, 0"),
        ("RGB", {"dataWindow": window(0, 2, 7, 5), "displayWindow": window(0, 0, 7, 3)}, "is cropped"),
        (["diffuse.R", "diffuse.G", "diffuse.B"], {}, r"holds layers \(diffuse\), none of them the picture"),
        (["a.R", "b.R", "a.A"], {}, r"holds layers \(a, b\)"),
        ("RG", {}, "has the channels G, R, and neither R, G and B nor a single one"),
        (["Y", "RY", "BY"], {}, "has the channels BY, RY, Y"),
    ],
)
def test_other_pictures_are_refused(tmp_path: Path, names: Any, header: Any, says: str) -> None:
    with pytest.raises(InputError, match=says):
        read_environment_map(write_exr(tmp_path, dict.fromkeys(names, GREY), **header))


def test_several_parts_are_refused(tmp_path: Path) -> None:
    parts = [OpenEXR.Part({"name": name}, {"RGB": np.ones((4, 8, 3), np.float32)}) for name in ("a", "b")]
    OpenEXR.File(parts).write(str(tmp_path / "sky.exr"))
    with pytest.raises(InputError, match="is an EXR file of 2 parts"):
        read_environment_map(tmp_path / "sky.exr")


@pytest.mark.parametrize("size", [(16, 4), (6, 1), (8, 8), (9, 12), (12, 9), (48, 8)])
def test_sides_that_are_not_two_to_one(tmp_path: Path, size: tuple[int, int]) -> None:
    columns, rows = size
    file = write_exr(tmp_path, {"RGB": np.ones((rows, columns, 3), np.float32)})
    if rows < 2:
        with pytest.raises(InputError, match="has 6 x 1 pixels; an environment needs at least 3 x 2"):
            read_environment_map(file)
        return
    with pytest.warns(LoomlightWarning, match=f"has {columns} x {rows} pixels, and a latitude-longitude"):
        assert read_environment_map(file).shape == (rows, columns, 3)


def test_negative_pixels_are_counted(tmp_path: Path) -> None:
    pixels = np.ones((4, 8, 3), np.float32)
    pixels[1, 2] = [-3, 1, -1]
    with pytest.warns(LoomlightWarning, match="1 of 32 pixels are negative, the lowest -3"):
        radiance = read_environment_map(write_exr(tmp_path, {"RGB": pixels}))
    np.testing.assert_array_equal(radiance[1, 2], [0, 1, 0])


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_pixels_are_finite(tmp_path: Path, value: float) -> None:
    pixels = np.ones((4, 8, 3), np.float32)
    pixels[0, 0, 1] = value
    with pytest.raises(InputError, match="no finite numbers"):
        read_environment_map(write_exr(tmp_path, {"RGB": pixels}))


def test_transparent_pixels_shine_nothing(tmp_path: Path) -> None:
    Image.new("RGBA", (8, 4), (255, 255, 255, 0)).save(tmp_path / "sky.png")
    np.testing.assert_array_equal(read_environment_map(tmp_path / "sky.png"), np.zeros((4, 8, 3)))


def test_sixteen_bits_shine_as_eight(tmp_path: Path) -> None:
    Image.fromarray(np.full((4, 8), 188 * 257, np.uint16)).save(tmp_path / "sky.png")
    np.testing.assert_allclose(read_environment_map(tmp_path / "sky.png"), 0.503, atol=1e-3)


def test_suns_warn_and_what_cannot_be_summed_up_is_refused(tmp_path: Path) -> None:
    pixels = GREY.copy()
    pixels[0, 0] = 1e9
    with pytest.warns(LoomlightWarning, match=r"holds a pixel of 1e\+09, beyond the 65504 of half precision"):
        assert read_environment_map(write_exr(tmp_path, {"Y": pixels})).max() == np.float32(1e9)
    pixels[0, 0] = 3e38
    with pytest.raises(InputError, match=r"holds a pixel of 3e\+38; values above 1e\+28 cannot be summed up"):
        read_environment_map(write_exr(tmp_path, {"Y": pixels}))
