"""Maps for the Blender add-on, Cycles' layers, and the add-on's zip. In Blender itself: tests/integrations.

Covers: exporters/blender.py, exporters/blender_addon.py, exporters/cycles.py
"""

from __future__ import annotations

import json
import tomllib
import zipfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import drjit as dr
import numpy as np
import pytest
from drjit.llvm import Array2f, Array3f, Float

from loomlight.core.colour import srgb_to_linear
from loomlight.core.footprint import Footprint
from loomlight.core.images import read_picture
from loomlight.core.llvm import require_llvm
from loomlight.exporters import export
from loomlight.exporters.blender import (
    DENSITIES,
    FAMILIES,
    MAX_TEXELS,
    density_maps,
    heights_of,
    repeats_of,
)
from loomlight.exporters.cycles import (
    CyclesLayers,
    diffuse_of,
    rough_over_lambert,
    sky_lights,
    with_light_of_texels,
)
from loomlight.exporters.fit import FittedMaterial
from loomlight.exporters.texels import TexelGrid, Texels
from loomlight.fabric import fabric_from_text
from loomlight.models.registry import make_model
from tests.helpers.standard_materials import few_queries

require_llvm()
WARP, WEFT = np.array([0.4, 0.2, 0.1]), np.array([0.05, 0.1, 0.3])


def _texels(share: np.ndarray) -> tuple[FittedMaterial, Texels]:
    """Texels [1, n] of two families whose albedos the fit has multiplied by 0.9 and 0.6."""
    shape = share.shape
    diffuse = np.broadcast_to(np.stack([WARP, WEFT]), (*shape, 2, 3))
    both = np.stack([share, 1 - share], axis=-1)
    base = (both[..., None] * np.array([0.9, 0.6])[:, None] * diffuse).sum(-2)
    up = np.broadcast_to([0.0, 0, 1], (*shape, 3))
    one = np.ones(shape)
    material = FittedMaterial(
        base=base,
        transmission=0 * one,
        transmit=np.zeros((*shape, 3)),
        specular=np.full((*shape, 3), 0.5),
        weight=0.0,
        alpha_x=0.8 * one,
        alpha_y=0.2 * one,
        normal=up,
        axis_x=np.broadcast_to([1.0, 0, 0], (*shape, 3)),
        axis_y=np.broadcast_to([0.0, 1, 0], (*shape, 3)),
        sheen=np.zeros(3),
        sheen_roughness=0.5,
        size=(1.0, 1.0),
        cover=one,
        height=share - 0.5,
        direction=np.broadcast_to([1.0, 0], (*shape, 2)),
        error=0.0,
        brightness=1.0,
    )
    zero = np.zeros((*shape, 2, 3))
    texels = Texels(
        cover=one,
        height=share - 0.5,
        share=both,
        normal=up,
        covariance=np.zeros((*shape, 2, 2)),
        direction=np.zeros((*shape, 2, 2)),
        diffuse=diffuse,
        transmit=zero,
        specular=zero,
        alpha=np.ones(2),
    )
    return material, texels


def test_weights_times_colours_are_the_fit_s_base() -> None:
    """And each family's are its own, so that another colour changes no other."""
    share = np.linspace(0, 1, 12)[None]
    material, texels = _texels(share)
    colours = {"warp": np.array([0.5, 0.3, 0.2]), "weft": np.array([0.1, 0.2, 0.5])}
    maps = density_maps(material, CyclesLayers(1.0, 1.0, 0.0, 0.0), texels, colours)
    for family, albedo, factor, part in (("warp", WARP, 0.9, share), ("weft", WEFT, 0.6, 1 - share)):
        found = maps[family].peak * srgb_to_linear(maps[family].pixels / 255) * colours[family]
        # Half a step of 8 bits of sRGB, whose slope is at most 2.3, times the largest weight.
        step = 0.5 / 255 * 2.3 * maps[family].peak
        assert found == pytest.approx(factor * albedo * part[..., None], abs=step * colours[family].max())


def test_the_highlight_is_narrow_along_the_axis_of_the_map() -> None:
    """It is wide along u, so narrow along v: a quarter turn, whose double points backwards."""
    material, texels = _texels(np.full((1, 4), 0.5))
    maps = density_maps(material, CyclesLayers(1.0, 1.0, 0.0, 0.0), texels, {"warp": WARP, "weft": WEFT})
    cosine, sine, anisotropy = (maps["fibres"].pixels[0, 0] / 255).tolist()
    # Steps of 8 bits.
    assert (2 * cosine - 1, 2 * sine - 1) == pytest.approx((-1, 0), abs=0.01)
    assert anisotropy == pytest.approx(1 - np.sqrt(0.2 / 0.8), abs=0.003)
    assert maps["surface"].pixels[0, 0, 0] / 255 == pytest.approx((0.2 * 0.8) ** 0.25, abs=0.003)


def test_heights_are_millimetres_above_the_surface() -> None:
    material, _ = _texels(np.linspace(0, 1, 101)[None])
    pixels, (low, high) = heights_of(material)
    # The lowest 2 % count as one height.
    assert (low, high) == pytest.approx((-0.48, 0.5))
    assert low + pixels[0] / 65535 * (high - low) == pytest.approx(
        np.maximum(material.height[0], low), abs=1e-4
    )


@pytest.mark.parametrize("roughness", [0.0, 0.3, 1.0])
def test_rough_reflection_takes_no_light(roughness: float) -> None:
    """A white surface sends all back, from everywhere; a grey one is brighter towards the light."""
    cosine, azimuth = np.meshgrid((np.arange(64) + 0.5) / 64, (np.arange(128) + 0.5) / 128 * 2 * np.pi)
    sine = np.sqrt(1 - cosine**2)
    light = np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), cosine], axis=-1).reshape(-1, 3)
    normal = np.broadcast_to([0.0, 0, 1], light.shape)
    for elevation in (0.2, 0.7, 1.0):
        view = np.broadcast_to([np.sqrt(1 - elevation**2), 0, elevation], light.shape)
        value = rough_over_lambert(normal, light, view, np.ones(light.shape), roughness)
        # The published mean albedo is rounded to 1e-3.
        assert 2 * (value[:, 0] * light[:, 2]).mean() == pytest.approx(1, abs=0.01)
    lights = np.array([[0.6, 0, 0.8], [-0.6, 0, 0.8]])
    views = np.array([[0.6, 0, 0.8]] * 2)
    towards, away = rough_over_lambert(normal[:2], lights, views, np.full((2, 3), 0.2), roughness)[:, 0]
    assert (towards > away) == (roughness > 0)


def test_two_diffuse_layers_share_the_light() -> None:
    """About the normals of yarns and about the mesh's own, as `lobes` has it."""
    material, _ = _texels(np.full(1, 0.5))
    tilted = np.array([[0.6, 0, 0.8]])
    place = replace(material, normal=tilted, base=np.ones((1, 3)), weight=0.0)
    above = np.array([[0.0, 0, 1]])
    # The tilt is 0.8; seen from above Cycles hides x + x² − x³ of it, of x = 1 / 0.8², clipped to 1: nothing.
    for blend in (0.0, 0.5, 1.0):
        found = diffuse_of(place, above, above, blend, 0.0).ravel()
        assert found == pytest.approx([(0.8 * blend + 1 - blend) / np.pi] * 3)


@pytest.mark.slow
def test_texels_are_as_bright_as_the_model_has_them() -> None:
    """Under a sky: of two like texels that the model shades unlike, each gets its own."""
    fabric = fabric_from_text('weave = "plain"\n[warp]\nroughness = 0.9\n[weft]\nroughness = 0.9\n')
    grid, model = TexelGrid(fabric, 8, 8, (1, 1)), make_model("lobes", fabric)
    texels = grid.filled()
    shape = texels.cover.shape
    one, up = np.ones(shape), np.broadcast_to([0.0, 0, 1], (*shape, 3))
    plain, _ = _texels(one)
    alike = replace(plain, base=np.full((*shape, 3), 0.4), normal=up, cover=texels.cover, size=grid.size)
    lit = with_light_of_texels(alike, grid, model, 0.5)
    # Light from all around, seen from above, by many points of each texel.
    lights = sky_lights(64)
    expected = np.zeros(shape)
    for light in lights:
        expected += shown_by(model, grid, light)
    expected /= len(lights)
    found = lit.base.mean(-1) / np.pi * np.mean(lights[:, 2])
    seen = texels.cover > 0.5
    before = np.abs(0.4 / np.pi * np.mean(lights[:, 2]) - expected)[seen].mean()
    # What is left are highlights, which are no part of the base.
    assert np.abs(found - expected)[seen].mean() < 0.3 * before


def shown_by(model: Any, grid: TexelGrid, light: np.ndarray) -> np.ndarray:
    """Grey value of each texel from above under a light [rows, columns], 1/sr."""
    row, column = (part.ravel() for part in np.indices((grid.rows, grid.columns)))
    places = grid.places(row + 0.5, column + 0.5).astype(np.float32)
    width, height = grid.step
    zero = dr.opaque(Float, 0.0, len(row))
    footprint = Footprint(
        Array2f(*(Float(part) for part in places)), Array2f(width, zero), Array2f(zero, height)
    )
    value = model.at(Array3f(zero, zero, zero + 1), footprint).value(
        Array3f(*(Float(np.full(len(row), part, np.float32)) for part in light))
    )
    return np.asarray(value).mean(axis=0).reshape(grid.rows, grid.columns)


def test_maps_of_uneven_yarns_hold_many_threads() -> None:
    uneven = fabric_from_text('weave = "twill 3/1"\nyarn = "linen"\n')
    assert [repeats_of(uneven, name) for name in DENSITIES] == [(24, 24), (128, 128), (256, 256)]
    assert repeats_of(fabric_from_text('weave = "twill 3/1"\n'), "far") == (1, 1)
    wide = fabric_from_text('weave = "satin 40/7"\nyarn = "linen"\n')
    across, up = repeats_of(wide, "near")
    assert (across, up) == (2, 2)
    assert 8 * 40 * across <= MAX_TEXELS


@pytest.mark.slow
def test_an_export_says_what_it_holds(tmp_path: Path) -> None:
    with few_queries():
        folder = export("plain", "blender", tmp_path / "maps")
    manifest = json.loads((folder / "manifest.json").read_text())
    assert [density["name"] for density in manifest["densities"]] == list(DENSITIES)
    assert set(manifest["colors"]) == set(FAMILIES)
    for density in manifest["densities"]:
        columns, rows = density["texels"]
        for described in density["maps"].values():
            assert read_picture(folder / described["file"]).shape[:2] == (rows, columns)


@pytest.mark.slow
def test_the_zip_is_the_same_each_time_and_has_what_the_panel_offers(tmp_path: Path) -> None:
    with few_queries():
        first, second = (
            next(export("plain", "blender-addon", tmp_path / name).glob("*.zip")) for name in ("one", "two")
        )
    assert first.read_bytes() == second.read_bytes()
    assert sorted(file.name for file in first.parent.iterdir()) == [first.name, "manifest.json"]
    with zipfile.ZipFile(first) as packed:
        held = set(packed.namelist())
        about = tomllib.loads(packed.read("blender_manifest.toml").decode())
        weaves = packed.read("weaves/names.txt").decode().splitlines()
    assert f"loomlight_blender-{about['version']}.zip" == first.name
    assert {
        "__init__.py",
        "LICENSE",
        "ready/manifest.json",
        "gallery/denim.toml",
        "gallery/denim.webp",
    } <= held
    assert {f"weaves/{number}.png" for number in range(len(weaves))} <= held
