"""Layers of pictures: albedo, normal and depth of what the camera sees, through holes too.

Covers: mitsuba/layers.py
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np
import OpenEXR
import pytest

import loomlight
from loomlight.cli.main import run
from loomlight.core.errors import InputError
from loomlight.fabric import fabric_from_text
from loomlight.mitsuba.plugins import material_bsdf
from loomlight.mitsuba.rendering import render_layers

LAYERS = ("albedo", "normal", "depth")


def wall(bsdf: Any, away: float, size: float) -> dict[str, Any]:
    """A square that faces the camera, so far from it."""
    to_world = mi.ScalarTransform4f().translate([0, 0, -away]).scale(size)
    return {"type": "rectangle", "to_world": to_world, "bsdf": bsdf}


def scene(**shapes: Any) -> Any:
    film = {"type": "hdrfilm", "width": 9, "height": 9, "rfilter": {"type": "box"}}
    to_world = mi.ScalarTransform4f().look_at([0, 0, 0], [0, 0, -1], [0, 1, 0])
    sensor = {"type": "perspective", "fov": 20, "near_clip": 1e-4, "to_world": to_world, "film": film}
    return mi.load_dict({"type": "scene", "sensor": sensor, "light": {"type": "constant"}, **shapes})


def grey(value: float) -> dict[str, Any]:
    return {"type": "diffuse", "reflectance": {"type": "rgb", "value": value}}


def test_a_wall_has_its_own_albedo_normal_and_distance() -> None:
    # Half a pixel of the film's middle row is the wall's edge nowhere: it ends between pixels 2 and 3.
    found = render_layers(scene(wall=wall(grey(0.4), 2.0, 0.1)), LAYERS)
    np.testing.assert_allclose(found["albedo"][4, 4], 0.4, rtol=1e-5)
    np.testing.assert_allclose(found["normal"][4, 4], (0, 0, 1), atol=1e-5)
    # Rays begin at the camera's near_clip, and are at most half a pixel off the axis.
    np.testing.assert_allclose(found["depth"][4, 4], 2.0, rtol=2e-4)
    for layer in found.values():
        np.testing.assert_array_equal(layer[0, 0], 0)


def test_the_middle_of_cloth_with_holes_shows_what_is_behind() -> None:
    loose = fabric_from_text(
        'weave = "plain"\nends_per_cm = 10\npicks_per_cm = 10\n[warp]\nwidth_mm = 0.5\n'
        "[weft]\nwidth_mm = 0.5\n[variation]\nirregularity = 0\n"
    )
    cloth = wall(material_bsdf(loose)((2000.0, 2000.0)), 1.0, 1.0)
    behind = wall(grey(0.0), 3.0, 2.0)
    found = render_layers(scene(cloth=cloth, behind=behind), LAYERS)
    # A quarter of plain weave with yarns of half the spacing is open: (1 − 0.5)².
    np.testing.assert_allclose(found["depth"].mean(), 1.0 + 2.0 * 0.25, rtol=0.05)
    np.testing.assert_allclose(found["normal"][4, 4], (0, 0, 1), atol=1e-3)
    without = render_layers(scene(cloth=cloth, behind=wall(grey(0.8), 3.0, 2.0)), ["albedo"])
    np.testing.assert_allclose((without["albedo"] - found["albedo"]).mean(), 0.25 * 0.8, rtol=0.05)


def test_a_picture_has_the_layers_that_were_asked_for() -> None:
    fabric = fabric_from_text('weave = "plain"\n[warp]\ncolor = "#c02020"\n[weft]\ncolor = "#2020c0"\n')
    shown: dict[str, Any] = {"spp": 1, "size": (24, 16), "denoise": "off", "zoom": 60.0}
    picture = loomlight.render(fabric, "flat", aov="albedo, depth", **shown)
    assert {name: layer.shape for name, layer in picture.layers.items()} == {
        "albedo": (16, 24, 3),
        "depth": (16, 24, 1),
    }
    # The weave shows: some pixels are of the red warp, others of the blue weft.
    redder = picture.layers["albedo"][..., 0] - picture.layers["albedo"][..., 2]
    assert redder.max() > 0.2
    assert redder.min() < -0.2
    assert loomlight.render(fabric, "flat", **shown).layers == {}
    assert (picture * 2).layers == {}


def test_the_command_writes_one_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "cloth.exr"
    arguments = [
        "render",
        "plain",
        "--scene",
        "flat",
        "--size",
        "24x16",
        "--spp",
        "1",
        "--aov",
        ",".join(LAYERS),
    ]
    assert run([*arguments, "-o", str(path)]) == 0
    channels = set(OpenEXR.File(str(path), separate_channels=True).channels())
    assert channels == {
        "R",
        "G",
        "B",
        *(f"albedo.{c}" for c in "RGB"),
        *(f"normal.{c}" for c in "XYZ"),
        "depth.Z",
    }
    for wrong, words in (
        (["-o", str(tmp_path / "cloth.png")], "layers of an .exr"),
        (["-o", str(path), "--turntable", "4"], "goes with single pictures"),
    ):
        assert run([*arguments, *wrong]) == 2
        assert words in capsys.readouterr().err


def test_an_unknown_layer_is_one_sentence() -> None:
    with pytest.raises(InputError, match="give names of albedo, normal, depth"):
        loomlight.RenderSettings(aov="albedo,roughness")
