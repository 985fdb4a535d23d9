"""Baked maps, and the files that they are written to."""

from __future__ import annotations

import errno
import os
from dataclasses import replace
from pathlib import Path
from typing import Any

import drjit as dr
import numpy as np
import OpenEXR
import pytest
from drjit.llvm.ad import Bool, Float
from PIL import Image

from loomlight.cli.main import run
from loomlight.core.errors import InputError
from loomlight.core.images import read_picture
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.maps import SurfaceMaps, bake_maps, write_maps

from .layouts import TWILL, even_layout


@pytest.fixture(scope="module")
def geometry() -> YarnGeometry:
    return YarnGeometry(even_layout(TWILL))


@pytest.fixture(scope="module")
def maps(geometry: YarnGeometry) -> SurfaceMaps:
    return bake_maps(geometry, (400, 400), Float)


def test_texels_hold_the_surface_at_their_middles(geometry: YarnGeometry, maps: SurfaceMaps) -> None:
    rows, columns = np.array([0, 17, 399]), np.array([3, 250, 399])
    x, y = (columns + 0.5) * 1.6 / 400, (rows + 0.5) * 1.6 / 400
    point = geometry.surface(Float(x), Float(y), dr.full(Bool, False, 3))
    shown = ~point.hole.numpy()
    assert (maps.hole[rows, columns] == ~shown).all()
    assert np.allclose(maps.height[rows, columns][shown], point.height.numpy()[shown], atol=1e-6)
    assert np.allclose(maps.normal[rows, columns][shown], point.normal.numpy().T[shown], atol=1e-5)
    assert np.allclose(maps.tangent[rows, columns][shown], point.tangent.numpy().T[shown], atol=1e-5)


def test_a_window_is_a_part_of_the_repeat(geometry: YarnGeometry, maps: SurfaceMaps) -> None:
    window = bake_maps(geometry, (100, 50), Float, window=(0.4, 0.8, 0.4, 0.2))
    assert window.size == (0.4, 0.2)
    assert (window.warp == maps.warp[200:250, 100:200]).all()
    shown = ~window.hole
    assert np.allclose(window.height[shown], maps.height[200:250, 100:200][shown], atol=1e-5)


def test_exr_files_hold_the_maps_unchanged(maps: SurfaceMaps, tmp_path: Path) -> None:
    write_maps(maps, tmp_path / "twill.exr")
    channels = OpenEXR.File(str(tmp_path / "twill.exr"), separate_channels=True).channels()
    again = {name: np.flipud(channel.pixels) for name, channel in channels.items()}
    for name in ("height", "warp", "hole"):
        assert (again[name] == getattr(maps, name)).all(), name
    for name in ("normal", "tangent"):
        vectors = np.stack([again[f"{name}.{axis}"] for axis in "XYZ"], axis=-1)
        assert (vectors == getattr(maps, name)).all(), name
    assert (again["size.X"] == np.float32(maps.size[0])).all()
    assert (again["size.Y"] == np.float32(maps.size[1])).all()


def test_png_files_show_the_maps_upright(maps: SurfaceMaps, tmp_path: Path) -> None:
    files = write_maps(maps, tmp_path / "twill.png")
    assert len(files) == 5
    picture = read_picture(tmp_path / "twill_warp.png")[..., 0]
    assert ((picture > 0.5) == np.flipud(maps.warp)).all()
    normal = read_picture(tmp_path / "twill_normal.png") * 2 - 1
    assert np.abs(normal - np.flipud(maps.normal)).max() < 1.01 / 127.5


@pytest.mark.parametrize("earlier", [False, True])
def test_no_part_of_the_pictures_is_left_on_a_full_disk(
    maps: SurfaceMaps, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, earlier: bool
) -> None:
    """The third of five pictures does not fit: none of them appears, and those of an earlier run stay."""
    if earlier:
        write_maps(maps, tmp_path / "twill.png")
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    save, calls = Image.Image.save, []

    def save_until_full(picture: Image.Image, path: Path, **options: Any) -> None:
        calls.append(path)
        if len(calls) == 3:
            Path(path).write_bytes(b"half")
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        save(picture, path, **options)

    monkeypatch.setattr(Image.Image, "save", save_until_full)
    with pytest.raises(InputError, match=r"twill_\w+\.png cannot be written: No space left on device"):
        write_maps(replace(maps, warp=~maps.warp), tmp_path / "twill.png")
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before


def test_maps_that_cannot_be_end_in_one_sentence(maps: SurfaceMaps, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"\.exr or \.png"):
        write_maps(maps, tmp_path / "maps.tiff")
    with pytest.raises(InputError, match="resolution"):
        bake_maps(YarnGeometry(even_layout(TWILL)), (0, 10), Float)


@pytest.mark.parametrize(
    ("options", "size", "millimetres"),
    [
        (["--resolution", "100"], (100, 22), "10 x 2.22222222"),
        (["--pixels-per-mm", "10"], (100, 22), "10 x 2.22222222"),
        (["--tile", "19", "--resolution", "96x96"], (96, 96), "20 x 20"),
    ],
)
def test_texels_are_square_and_pictures_know_their_millimetres(
    options: list[str], size: tuple[int, int], millimetres: str, tmp_path: Path
) -> None:
    """Of denim with seven colours in the warp: 28 ends and 4 picks in 10 × 2.22 mm."""
    fabric = tmp_path / "denim.toml"
    fabric.write_text('weave = "twill 3/1"\nends_per_cm = 28\npicks_per_cm = 18\nwarp.color = "28 #223355"\n')
    assert run(["bake-maps", str(fabric), "-o", str(tmp_path / "maps.png"), *options]) == 0
    with Image.open(tmp_path / "maps_normal.png") as picture:
        assert picture.size == size
        assert picture.info["size_mm"] == millimetres
        width, height = (float(part) for part in millimetres.split(" x "))
        # Files hold whole pixels a metre.
        np.testing.assert_allclose(
            picture.info["dpi"], (25.4 * size[0] / width, 25.4 * size[1] / height), rtol=1e-4
        )


def test_oblong_texels_are_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    oblong, square = (str(tmp_path / f"{name}.exr") for name in ("oblong", "square"))
    assert run(["bake-maps", "rib 4", "-o", square, "--resolution", "16x64"]) == 0
    assert not capsys.readouterr().err
    assert run(["bake-maps", "rib 4", "-o", oblong, "--resolution", "64x64"]) == 0
    assert "over 1 × 4 mm are 4 times as tall as wide: 16x64 are square" in capsys.readouterr().err


@pytest.mark.parametrize(
    "options",
    [
        ["--resolution", "64", "--pixels-per-mm", "9"],
        ["--tile", "3", "--window", "0,0,1,1"],
        ["--tile", "-1"],
    ],
)
def test_options_of_maps_that_contradict_end_in_one_sentence(
    options: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["bake-maps", "plain", "-o", str(tmp_path / "maps.exr"), *options]) == 2
    assert capsys.readouterr().err.startswith("loomlight: --")
    assert not list(tmp_path.iterdir())
