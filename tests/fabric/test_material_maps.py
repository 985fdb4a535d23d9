"""Colour, opacity and roughness of baked maps are those of the threads that show.

Covers: fabric/material_maps.py
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import OpenEXR
import pytest
from drjit.llvm import Float

from loomlight.core.images import read_picture
from loomlight.fabric import fabric_from_text
from loomlight.fabric.material_maps import material_maps
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.maps import bake_maps, write_maps

RED, BLUE, WHITE = (1, 0, 0), (0, 0, 1), (1, 1, 1)
TEXT = """weave = "plain"
ends_per_cm = 10
gap = 0.4
[warp]
color = ["#ff0000", "#0000ff"]
roughness = 0.25
[weft]
color = "#ffffff"
roughness = 0.64
"""


def test_maps_have_the_colours_of_threads(tmp_path: Path) -> None:
    fabric = fabric_from_text(TEXT)
    maps = bake_maps(YarnGeometry(fabric.layout()), (200, 200), Float)
    material = material_maps(fabric, maps)
    x = (np.arange(200) + 0.5) / 100  # millimetres
    warp = maps.warp & ~maps.hole
    for row, column in ((50, 50), (150, 150), (50, 149), (120, 50)):
        assert not maps.hole[row, column]
        thread = RED if x[column] < 1 else BLUE
        np.testing.assert_allclose(material["color"][row, column], thread if warp[row, column] else WHITE)
        assert material["roughness"][row, column] == pytest.approx(0.5 if warp[row, column] else 0.8)
    assert warp.any()
    assert (~warp & ~maps.hole).any()
    np.testing.assert_array_equal(material["opacity"], ~maps.hole)
    assert material["opacity"].mean() == pytest.approx(1 - 0.4**2, abs=0.01)

    files = write_maps(maps, tmp_path / "plain.png", material)
    assert [file.stem for file in files[-3:]] == ["plain_color", "plain_opacity", "plain_roughness"]
    shown = read_picture(tmp_path / "plain_color.png")
    np.testing.assert_allclose(shown, np.flipud(material["color"]), atol=1e-6)
    write_maps(maps, tmp_path / "plain.exr", material)
    channels = OpenEXR.File(str(tmp_path / "plain.exr"), separate_channels=True).channels()
    np.testing.assert_array_equal(channels["color.R"].pixels, np.flipud(material["color"][..., 0]))
    np.testing.assert_array_equal(channels["opacity"].pixels, np.flipud(material["opacity"]))


def test_explicit_albedos_are_the_colour() -> None:
    fabric = fabric_from_text('weave = "plain"\n[warp]\ndiffuse_reflect = [0.2, 0.1, 0.05]\nspecular = 0\n')
    maps = bake_maps(YarnGeometry(fabric.layout()), (64, 64), Float)
    color = material_maps(fabric, maps)["color"][maps.warp & ~maps.hole]
    transmit = fabric.appearance().warp.diffuse_transmit[0]
    np.testing.assert_allclose(color - transmit, np.broadcast_to([0.2, 0.1, 0.05], color.shape), atol=1e-6)
