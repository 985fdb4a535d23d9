"""Images survive being written and read."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import OpenEXR
import pytest
from PIL import ExifTags, Image

from loomlight.core.colour import srgb_to_linear
from loomlight.core.errors import InputError
from loomlight.core.images import is_turned, read_map, read_picture, write_channels, write_image
from tests.limits import HANG


def random_pixels(channels: int) -> np.ndarray:
    return np.random.default_rng(7).random((5, 9, channels)).astype(np.float32)


@pytest.mark.parametrize(("channels", "name"), [(1, "Y"), (3, "RGB"), (4, "RGBA")])
def test_exr_keeps_every_bit(tmp_path: Path, channels: int, name: str) -> None:
    pixels = random_pixels(channels) * 1e4
    write_image(tmp_path / "a.exr", pixels)
    read = OpenEXR.File(str(tmp_path / "a.exr")).channels()[name].pixels
    np.testing.assert_array_equal(read, pixels.squeeze())


def test_exr_keeps_infinity_and_nan(tmp_path: Path) -> None:
    pixels = np.tile(np.array([np.inf, np.nan, -1.0], dtype=np.float32), (2, 2, 1))
    write_image(tmp_path / "a.exr", pixels)
    np.testing.assert_array_equal(OpenEXR.File(str(tmp_path / "a.exr")).channels()["RGB"].pixels, pixels)


def test_channels_keep_their_names(tmp_path: Path) -> None:
    planes = {"height": random_pixels(1)[..., 0], "hole": random_pixels(1)[..., 0] * 2}
    write_channels(tmp_path / "a.exr", planes)
    read = OpenEXR.File(str(tmp_path / "a.exr"), separate_channels=True).channels()
    assert set(read) == {"height", "hole"}
    for name, plane in planes.items():
        np.testing.assert_array_equal(read[name].pixels, plane)


def test_png_is_srgb(tmp_path: Path) -> None:
    levels = np.arange(256)
    linear = srgb_to_linear(np.tile(levels[None, :, None], (2, 1, 3)) / 255)
    write_image(tmp_path / "a.png", linear)
    assert np.array_equal(np.asarray(Image.open(tmp_path / "a.png"))[0, :, 0], levels)
    np.testing.assert_allclose(read_picture(tmp_path / "a.png")[0, :, 1], levels / 255)


def test_png_clips_and_takes_nan_for_black(tmp_path: Path) -> None:
    write_image(tmp_path / "a.png", np.tile([7.0, -2.0, np.nan], (2, 2, 1)))
    assert np.asarray(Image.open(tmp_path / "a.png"))[1, 1].tolist() == [255, 0, 0]


@pytest.mark.parametrize("shape", [(1, 9, 3), (9, 1, 3), (1, 1, 3), (1, 9, 1), (9, 1, 1), (1, 1, 1)])
def test_a_side_of_one_pixel_is_a_side(tmp_path: Path, shape: tuple[int, int, int]) -> None:
    height, width, channels = shape
    write_image(tmp_path / "a.png", np.zeros(shape))
    assert Image.open(tmp_path / "a.png").size == (width, height)
    write_image(tmp_path / "a.exr", np.zeros(shape))
    read = OpenEXR.File(str(tmp_path / "a.exr")).channels()[{1: "Y", 3: "RGB"}[channels]].pixels
    assert read.shape[:2] == (height, width)


def test_transparency_is_seen_on_white(tmp_path: Path) -> None:
    Image.new("RGBA", (2, 2), (0, 0, 0, 0)).save(tmp_path / "a.png")
    assert read_picture(tmp_path / "a.png").min() == 1.0


def write_on_a_full_disk(path: Path) -> str:
    """What an attempt to write a large `path` ends in when files may hold no more than 4 kB."""
    program = (
        "import resource, sys, numpy as np\n"
        "from loomlight.core.images import write_image\n"
        "from loomlight.core.errors import InputError\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))\n"
        "try: write_image(sys.argv[1], np.random.default_rng(1).random((99, 99, 3)))\n"
        "except InputError as error: print(error)\n"
    )
    command = [sys.executable, "-c", program, str(path)]
    return subprocess.run(command, capture_output=True, text=True, timeout=HANG).stdout


def test_a_full_disk_leaves_no_png(tmp_path: Path) -> None:
    assert "a.png cannot be written" in write_on_a_full_disk(tmp_path / "a.png")
    assert list(tmp_path.iterdir()) == []


def test_a_full_disk_leaves_no_exr(tmp_path: Path) -> None:
    assert "a.exr cannot be written" in write_on_a_full_disk(tmp_path / "a.exr")
    assert list(tmp_path.iterdir()) == []


def test_jpegs_show_what_pngs_do(tmp_path: Path) -> None:
    """Threads of two colours a pixel wide: chroma is kept at full size."""
    stripes = np.tile([[0.5, 0.02, 0.02], [0.02, 0.02, 0.5]], (24, 12, 1))
    for name in ("a.png", "a.jpg", "b.jpeg"):
        write_image(tmp_path / name, stripes)
    with Image.open(tmp_path / "a.jpg") as picture:
        assert picture.format == "JPEG"
    exact, lossy = (read_picture(tmp_path / name) for name in ("a.png", "b.jpeg"))
    assert np.abs(exact - lossy).max() < 0.05


@pytest.mark.parametrize("name", ["a.webp", "a", "a.exr.txt"])
def test_other_suffixes_are_refused(tmp_path: Path, name: str) -> None:
    with pytest.raises(InputError, match=r"written as \.png or \.jpg or \.jpeg or \.exr"):
        write_image(tmp_path / name, np.zeros((2, 2, 3)))
    assert list(tmp_path.iterdir()) == []


def test_drawings_of_uint8_keep_every_colour(tmp_path: Path) -> None:
    levels = np.repeat(np.arange(256, dtype=np.uint8)[None, :, None], 3, axis=2)
    write_image(tmp_path / "a.png", levels)
    np.testing.assert_array_equal(np.asarray(Image.open(tmp_path / "a.png")), levels)
    write_image(tmp_path / "a.exr", levels)
    linear = OpenEXR.File(str(tmp_path / "a.exr")).channels()["RGB"].pixels
    np.testing.assert_allclose(linear, srgb_to_linear(levels / 255), rtol=1e-6)


@pytest.mark.parametrize("suffix", [".png", ".tif"])
def test_sixteen_bits_are_scaled(tmp_path: Path, suffix: str) -> None:
    values = np.array([[0, 1, 8121], [59451, 65534, 65535]], np.uint16)
    Image.fromarray(values).save(tmp_path / f"a{suffix}")
    np.testing.assert_allclose(read_picture(tmp_path / f"a{suffix}")[..., 1], values / 65535)
    np.testing.assert_allclose(read_map(tmp_path / f"a{suffix}", 1)[..., 0], values / 65535, rtol=1e-6)


def test_floats_are_pictures_between_0_and_1_and_maps_of_any_number(tmp_path: Path) -> None:
    Image.fromarray(np.array([[0, 0.25, 1]], np.float32)).save(tmp_path / "a.tif")
    np.testing.assert_array_equal(read_picture(tmp_path / "a.tif")[0, :, 2], [0, 0.25, 1])
    for wrong in (-0.5, 7, np.nan):
        Image.fromarray(np.array([[0, wrong]], np.float32)).save(tmp_path / "b.tif")
        with pytest.raises(InputError, match="holds floats that are not between 0 and 1"):
            read_picture(tmp_path / "b.tif")
    Image.fromarray(np.array([[-3, 900]], np.float32)).save(tmp_path / "c.tif")
    np.testing.assert_array_equal(read_map(tmp_path / "c.tif", 1)[0, :, 0], [-3, 900])
    Image.fromarray(np.array([[0, 1 << 20]], np.int32)).save(tmp_path / "d.tif")
    with pytest.raises(InputError, match="whole numbers of 32 bits"):
        read_picture(tmp_path / "d.tif")


# Of EXIF: what shows the stored rows as they were taken.
UPRIGHT = {
    1: lambda stored: stored,
    2: lambda stored: stored[:, ::-1],
    3: lambda stored: stored[::-1, ::-1],
    4: lambda stored: stored[::-1],
    5: lambda stored: stored.T,
    6: lambda stored: stored[::-1].T,
    7: lambda stored: stored[::-1, ::-1].T,
    8: lambda stored: stored.T[::-1],
}


@pytest.mark.parametrize("orientation", UPRIGHT)
@pytest.mark.parametrize("suffix", [".png", ".tif"])
def test_pictures_are_turned_as_their_file_says(tmp_path: Path, suffix: str, orientation: int) -> None:
    stored = np.array([[0, 20, 40], [60, 80, 255]], np.uint8)
    exif = Image.Exif()
    exif[ExifTags.Base.Orientation] = orientation
    file = tmp_path / f"a{suffix}"
    Image.fromarray(stored).save(file, exif=exif)
    upright = UPRIGHT[orientation](stored) / 255
    np.testing.assert_allclose(read_picture(file)[..., 0], upright)
    np.testing.assert_allclose(read_map(file, 1)[..., 0], upright, rtol=1e-6)
    assert is_turned(file) == (orientation != 1)
