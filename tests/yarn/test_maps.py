"""Baked maps and textures as a second source of geometry.

Covers: yarn/textures.py
"""

from __future__ import annotations

import errno
import os
from dataclasses import replace
from pathlib import Path
from typing import Any

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array3f, Bool, Float
from PIL import Image

from loomlight.cli.main import run
from loomlight.core.errors import InputError
from loomlight.core.images import read_picture, write_channels
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.maps import SurfaceMaps, bake_maps, read_maps, write_maps
from loomlight.yarn.textures import TextureSurface
from loomlight.yarn.visibility import unoccluded

from .layouts import TWILL, even_layout

COUNT = 50_000


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
    again = read_maps(tmp_path / "twill.exr")
    for name in ("height", "normal", "tangent", "warp", "hole"):
        assert (getattr(again, name) == getattr(maps, name)).all(), name
    assert again.size == pytest.approx(maps.size)


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


@pytest.mark.parametrize("back", [False, True])
def test_textures_of_a_surface_are_that_surface(
    geometry: YarnGeometry, maps: SurfaceMaps, back: bool
) -> None:
    textures = TextureSurface(maps, bake_maps(geometry, (400, 400), Float, back=True))
    rng = np.random.default_rng(0)
    x, y = Float(rng.uniform(-2, 4, COUNT)), Float(rng.uniform(-2, 4, COUNT))
    face = dr.full(Bool, back, COUNT)
    expected, actual = geometry.surface(x, y, face), textures.surface(x, y, face)
    same = (expected.hole.numpy() == actual.hole.numpy()) & (
        expected.is_warp.numpy() == actual.is_warp.numpy()
    )
    assert same.mean() > 0.985  # texels at outlines, 4 of 100 a thread and side, take the nearest
    shown = same & ~expected.hole.numpy()
    error = np.abs(expected.height.numpy() - actual.height.numpy())[shown]
    assert np.quantile(error, 0.9) < 1e-3
    cosine = (expected.normal.numpy() * actual.normal.numpy()).sum(axis=0)[shown]
    assert np.quantile(cosine, 0.1) > 0.999
    fibre = (expected.tangent.numpy() * actual.tangent.numpy()).sum(axis=0)[shown]
    assert np.quantile(fibre, 0.1) > 0.999


def test_shadows_of_textures_are_those_of_the_surface(geometry: YarnGeometry, maps: SurfaceMaps) -> None:
    textures = TextureSurface(maps)
    rng = np.random.default_rng(1)
    x, y = Float(rng.uniform(0, 1.6, COUNT)), Float(rng.uniform(0, 1.6, COUNT))
    front = dr.full(Bool, False, COUNT)
    z, azimuth = rng.uniform(0, 1, COUNT), rng.uniform(0, 6.2832, COUNT)
    radius = np.sqrt(1 - z * z)
    light = Array3f(Float(radius * np.cos(azimuth)), Float(radius * np.sin(azimuth)), Float(z))
    shadows = []
    for surface in (geometry, textures):
        height, hole = surface.height(x, y, front)
        shadows.append(unoccluded(surface, x, y, height, light, front).numpy())
    shown = ~hole.numpy()
    assert (shadows[0] == shadows[1])[shown].mean() > 0.96


def test_a_sheet_without_maps_of_its_back_is_the_same_sheet_from_behind(maps: SurfaceMaps) -> None:
    sheet = TextureSurface(maps)
    rng = np.random.default_rng(2)
    x, y = Float(rng.uniform(0, 1.6, COUNT)), Float(rng.uniform(0, 1.6, COUNT))
    front, behind = (sheet.surface(x, y, dr.full(Bool, back, COUNT)) for back in (False, True))
    assert np.allclose(front.height.numpy(), -behind.height.numpy(), atol=1e-6)
    assert np.allclose(front.normal.numpy()[:2], -behind.normal.numpy()[:2], atol=1e-5)


def test_files_that_are_no_maps_end_in_one_sentence(maps: SurfaceMaps, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="does not exist"):
        read_maps(tmp_path / "missing.exr")
    (tmp_path / "broken.exr").write_bytes(b"no picture")
    with pytest.raises(InputError, match="no EXR"):
        read_maps(tmp_path / "broken.exr")
    write_channels(tmp_path / "partial.exr", {"height": maps.height})
    with pytest.raises(InputError, match=r"normal\.X"):
        read_maps(tmp_path / "partial.exr")
    channels = {name: np.ones((4, 4), np.float32) for name in ("height", "normal.X", "normal.Y", "normal.Z")}
    channels |= {"size.X": np.ones((4, 4), np.float32), "size.Y": np.ones((4, 4), np.float32)}
    channels["height"][1, 1] = np.nan
    write_channels(tmp_path / "infinite.exr", channels)
    with pytest.raises(InputError, match="height"):
        read_maps(tmp_path / "infinite.exr")
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
