"""Baked maps, and the files that they are written to.

Covers: fabric/maps.py
"""

from __future__ import annotations

import errno
import json
import os
from dataclasses import replace
from pathlib import Path
from typing import Any

import drjit as dr
import numpy as np
import OpenEXR
import pytest
from drjit.llvm.ad import Array2f, Bool, Float
from PIL import Image

from loomlight.cli.main import run
from loomlight.core.errors import InputError
from loomlight.core.footprint import Footprint
from loomlight.core.images import read_picture
from loomlight.fabric import fabric_from_text, load_fabric
from loomlight.fabric.maps import ClothMaps, ClothSurface, map_files, sample_maps, write_maps
from loomlight.models.point import PointModel
from loomlight.models.registry import make_model
from loomlight.yarn.geometry import YarnGeometry

TWILL = fabric_from_text('weave = "twill 2/2"\nends_per_cm = 25\n')
RED, BLUE, WHITE = (1, 0, 0), (0, 0, 1), (1, 1, 1)
STRIPES = """weave = "plain"
ends_per_cm = 10
gap = 0.4
[warp]
color = ["#ff0000", "#0000ff"]
roughness = 0.25
[weft]
color = "#ffffff"
roughness = 0.64
"""
# Plies, fibres, slubs and hairs, and colours from thread to thread.
WOOL = """weave = "plain"
ends_per_cm = 8
warp.color = "#c04020"
weft.color = "#204060"
warp.yarn = "wool"
weft.yarn = "wool"
[variation]
colour_noise = 0.3
"""


@pytest.fixture(scope="module")
def maps() -> ClothMaps:
    return sample_maps(TWILL, (400, 400), Float)


def test_texels_hold_the_surface_at_their_middles(maps: ClothMaps) -> None:
    rows, columns = np.array([0, 17, 399]), np.array([3, 250, 399])
    x, y = (columns + 0.5) * 1.6 / 400, (rows + 0.5) * 1.6 / 400
    point = YarnGeometry(TWILL.layout()).surface(Float(x), Float(y), dr.full(Bool, False, 3))
    shown = ~point.hole.numpy()
    assert (maps.hole[rows, columns] == ~shown).all()
    assert np.allclose(maps.height[rows, columns][shown], point.height.numpy()[shown], atol=1e-6)
    assert np.allclose(maps.normal[rows, columns][shown], point.normal.numpy().T[shown], atol=1e-5)
    assert np.allclose(maps.tangent[rows, columns][shown], point.tangent.numpy().T[shown], atol=1e-5)


def test_a_window_is_a_part_of_the_repeat(maps: ClothMaps) -> None:
    window = sample_maps(TWILL, (100, 50), Float, window=(0.4, 0.8, 0.4, 0.2))
    assert window.size == (0.4, 0.2)
    assert (window.warp == maps.warp[200:250, 100:200]).all()
    shown = ~window.hole
    assert np.allclose(window.height[shown], maps.height[200:250, 100:200][shown], atol=1e-5)


def test_maps_have_the_colours_of_threads() -> None:
    maps = sample_maps(fabric_from_text(STRIPES), (200, 200), Float)
    x = (np.arange(200) + 0.5) / 100  # millimetres
    warp = maps.warp & ~maps.hole
    for row, column in ((50, 50), (150, 150), (50, 149), (120, 50)):
        assert not maps.hole[row, column]
        thread = RED if x[column] < 1 else BLUE
        np.testing.assert_allclose(maps.color[row, column], thread if warp[row, column] else WHITE)
        assert maps.roughness[row, column] == pytest.approx(0.5 if warp[row, column] else 0.8)
    assert warp.any()
    assert (~warp & ~maps.hole).any()
    np.testing.assert_array_equal(maps.opacity, ~maps.hole)
    assert maps.opacity.mean() == pytest.approx(1 - 0.4**2, abs=0.01)
    # Yarn sees less of the sky where it dives than on top.
    middle, edge = maps.occlusion[48:52, 48:52].mean(), maps.occlusion[~maps.hole].min()
    assert 0 <= edge < middle - 0.2
    assert (maps.occlusion[maps.hole] == 1).all()


def test_explicit_albedos_are_the_colour() -> None:
    fabric = fabric_from_text('weave = "plain"\n[warp]\ndiffuse_reflect = [0.2, 0.1, 0.05]\nspecular = 0\n')
    maps = sample_maps(fabric, (64, 64), Float)
    color = maps.color[maps.warp & ~maps.hole]
    transmit = fabric.appearance().warp.diffuse_transmit[0]
    np.testing.assert_allclose(color - transmit, np.broadcast_to([0.2, 0.1, 0.05], color.shape), atol=1e-6)


def test_maps_show_the_yarns_of_pictures() -> None:
    """Against the point model, a pixel a texel: frames, families and how colours vary, without hairs."""
    fabric = fabric_from_text(WOOL.replace("[var", "warp.hairiness = 0\nweft.hairiness = 0\n[var"))
    columns, rows = 24, 20
    window = (3.1, 40.2, 1.8, 1.5)
    maps = sample_maps(fabric, (columns, rows), Float, window)
    texel = np.arange(columns * rows)
    x = window[0] + (texel % columns + 0.5) * window[2] / columns
    y = window[1] + (texel // columns + 0.5) * window[3] / rows
    zero = dr.zeros(Float, texel.size)
    footprint = Footprint(
        Array2f(Float(x), Float(y)),
        Array2f(zero + window[2] / columns, zero),
        Array2f(zero, zero + window[3] / rows),
    )
    model = make_model("point", fabric)
    assert isinstance(model, PointModel)
    place, back = model.on_cloth(footprint).centre, dr.full(Bool, False, texel.size)
    hole = model.point_model.surface.surface(place.x, place.y, back).hole
    point = model.point_model.at(place.x, place.y, back, hole, footprint.spread_side)
    shown = ~maps.hole.ravel()
    upright = point.normal.numpy()[2] > 0.05
    same = shown & upright
    assert same.mean() > 0.9
    for ours, theirs in ((maps.normal, point.normal), (maps.tangent, point.tangent)):
        np.testing.assert_allclose(ours.reshape(-1, 3)[same], theirs.numpy().T[same], atol=1e-4)
    np.testing.assert_array_equal(maps.warp.ravel()[shown], point.is_warp.numpy()[shown])
    appearance = fabric.appearance()
    for family, chosen in ((appearance.warp, maps.warp), (appearance.weft, ~maps.warp)):
        chosen = chosen.ravel() & shown
        colour = maps.color.reshape(-1, 3)[chosen]
        gain = point.albedos.diffuse_reflect.numpy().T[chosen] / family.diffuse_reflect[0]
        plain = colour / gain
        # One colour a family, once what varies is taken out; and it does vary.
        np.testing.assert_allclose(plain, plain[:1] * np.ones((len(plain), 1)), rtol=1e-3)
        assert gain[:, 0].std() > 0.1


@pytest.mark.parametrize("back", [False, True])
def test_maps_of_uneven_yarns_tile(back: bool) -> None:
    """Steps over the edges of a tile are as small as within it; in pictures nothing repeats."""
    fabric = fabric_from_text(WOOL)
    tile = 10.0  # four repeats
    count = 160
    # Its edges run along the middles of threads.
    corner = (0.625, 0.625)
    maps = sample_maps(fabric, (count, count), Float, (*corner, tile, tile), back)
    plain = sample_maps(fabric, (count, count), Float, (*corner, 1.0001 * tile, 1.0001 * tile), back)

    def steps(found: ClothMaps, axis: int) -> tuple[float, float]:
        """Root mean square of the differences of colours over the edge, and over lines within."""
        values = np.concatenate([found.color, found.normal], axis=-1)
        over = np.square(values - np.roll(values, 1, axis)).mean(axis=(1 - axis, 2))
        # Middles of threads, as the edge is.
        inner = over[20::20]
        return float(np.sqrt(over[0])), float(np.sqrt(inner.mean()))

    for axis in (0, 1):
        edge, inner = steps(maps, axis)
        cut, _ = steps(plain, axis)
        assert edge < 1.3 * inner
        assert cut > 1.6 * inner


@pytest.mark.parametrize("back", [False, True])
def test_maps_of_layered_cloth_show_the_layer_in_front(back: bool) -> None:
    """Two stitched twills, one red, one blue: the other shows in gaps, lower than yarn, and in dots."""
    fabric = load_fabric("examples/layered/stitched-double-cloth.wif")
    x, y = (np.random.default_rng(3).random((2, 4000)) * np.array(fabric.repeat_mm)[:, None]).astype(
        np.float32
    )
    points = ClothSurface(fabric, Float).at(x, y, 1e-3, back)
    appearance = fabric.appearance()
    warp, weft = (
        np.asarray(family.diffuse_reflect)[threads]
        for family, threads in zip((appearance.warp, appearance.weft), points.threads, strict=True)
    )
    colour = np.where(points.warp[:, None], warp, weft)
    in_front = (colour[:, 0] > colour[:, 2]) != back
    # Gaps of a fifth each way leave 1/25 of the plan; on the face 8 ends rise over 0.8 mm, each 0.64 mm wide.
    dots = 0 if back else 8 * 0.8 * 0.64 / np.prod(fabric.repeat_mm)
    assert 0.93 < in_front[~points.hole].mean() + dots < 0.99
    if back:
        assert points.height[in_front].mean() > points.height[~in_front & ~points.hole].max()


def test_means_stay_what_fabrics_say() -> None:
    """Of many threads: gains of plies, fibres, slubs and threads have mean 1."""
    text = WOOL.replace('weft.color = "#204060"', 'weft.color = "#c04020"')
    maps = sample_maps(fabric_from_text(text), (300, 300), Float, (0, 0, 100, 100))
    mean = maps.color[~maps.hole].mean(axis=0)
    expected = fabric_from_text(text).draft.warp.colors[0]
    # 160 threads, whose deviation is 0.3/√3 where they reflect as much as the mean channel, and half as much
    # again in the darkest one: 2 %.
    np.testing.assert_allclose(mean, expected, rtol=0.06)


def test_exr_files_hold_the_maps_unchanged(maps: ClothMaps, tmp_path: Path) -> None:
    write_maps(maps, tmp_path / "twill.exr")
    channels = OpenEXR.File(str(tmp_path / "twill.exr"), separate_channels=True).channels()
    again = {name: np.flipud(channel.pixels) for name, channel in channels.items()}
    for name in ("height", "warp", "hole", "opacity", "roughness", "occlusion"):
        assert (again[name] == getattr(maps, name)).all(), name
    for name, letters in (("normal", "XYZ"), ("tangent", "XYZ"), ("color", "RGB")):
        vectors = np.stack([again[f"{name}.{letter}"] for letter in letters], axis=-1)
        assert (vectors == getattr(maps, name)).all(), name
    assert (again["size.X"] == np.float32(maps.size[0])).all()
    assert (again["size.Y"] == np.float32(maps.size[1])).all()


def test_png_files_show_the_maps_upright(maps: ClothMaps, tmp_path: Path) -> None:
    *pictures, facts = write_maps(maps, tmp_path / "twill.png")
    assert [*pictures, facts] == map_files(tmp_path / "twill.png")
    picture = read_picture(tmp_path / "twill_warp.png")[..., 0]
    assert ((picture > 0.5) == np.flipud(maps.warp)).all()
    normal = read_picture(tmp_path / "twill_normal.png") * 2 - 1
    assert np.abs(normal - np.flipud(maps.normal)).max() < 1.01 / 127.5
    color = read_picture(tmp_path / "twill_color.png")
    assert color.shape == (400, 400, 3)


def test_heights_have_16_bits_and_say_their_millimetres(maps: ClothMaps, tmp_path: Path) -> None:
    files = write_maps(maps, tmp_path / "twill.png")
    told = json.loads(files[-1].read_text())
    with Image.open(tmp_path / "twill_height.png") as picture:
        pixels = np.asarray(picture)
        low, high = (float(part) for part in picture.info["height_mm"].split(" to "))
    assert told["height_mm"] == pytest.approx([low, high])
    assert told["size_mm"] == list(maps.size)
    assert told["files"]["height"] == "twill_height.png"
    millimetres = low + pixels / 65535 * (high - low)
    np.testing.assert_allclose(millimetres, np.flipud(maps.height), atol=0.6 * (high - low) / 65535)
    assert len(np.unique(pixels)) > 1000


@pytest.mark.parametrize("earlier", [False, True])
def test_no_part_of_the_pictures_is_left_on_a_full_disk(
    maps: ClothMaps, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, earlier: bool
) -> None:
    """The third of nine pictures does not fit: none of them appears, and those of an earlier run stay."""
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
    with pytest.raises(InputError, match=r"twill_\w+\.json cannot be written: No space left on device"):
        write_maps(replace(maps, warp=~maps.warp), tmp_path / "twill.png")
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before


def test_maps_that_cannot_be_end_in_one_sentence(maps: ClothMaps, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"\.exr or \.png"):
        write_maps(maps, tmp_path / "maps.tiff")
    with pytest.raises(InputError, match="resolution"):
        sample_maps(TWILL, (0, 10), Float)


def test_the_folder_is_made_and_heights_are_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    command = ["bake-maps", "plain", "--resolution", "8", "-o"]
    assert run([*command, str(tmp_path / "new" / "x.png")]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith(f"{tmp_path / 'new' / 'x_height.png'} (0 to 65535 are -")
    assert lines[1:] == [str(file) for file in map_files(tmp_path / "new" / "x.png")[1:]]
    assert run([*command, str(tmp_path / "other" / "x.exr")]) == 0
    assert run([*command, str(tmp_path / "no" / "such" / "x.png")]) == 2
    assert "does not exist; make it first" in capsys.readouterr().err
    assert sorted(path.name for path in tmp_path.iterdir()) == ["new", "other"]


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
    ("options", "says"),
    [
        (["--resolution", "64", "--pixels-per-mm", "9"], "pixels_per_mm and resolution both say how many"),
        (["--tile", "3", "--window", "0,0,1,1"], "tile and window both say what is shown"),
        (["--tile", "-1"], "--tile -1 is out of range"),
    ],
)
def test_options_of_maps_that_contradict_end_in_one_sentence(
    options: list[str], says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["bake-maps", "plain", "-o", str(tmp_path / "maps.exr"), *options]) == 2
    assert capsys.readouterr().err.startswith(f"loomlight: {says}")
    assert not list(tmp_path.iterdir())
