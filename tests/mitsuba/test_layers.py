"""Layers of pictures: albedo, normal, depth and roughness of what the camera sees, through holes too.

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
from tests.marks import slow

LAYERS = ("albedo", "normal", "depth", "roughness")


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
    without = render_layers(scene(cloth=cloth, behind=wall(grey(0.8), 3.0, 2.0)), LAYERS)
    np.testing.assert_allclose((without["albedo"] - found["albedo"]).mean(), 0.25 * 0.8, rtol=0.05)


@pytest.mark.parametrize("model", [slow("lobes"), "point", "samples", slow("clustered")])
@pytest.mark.parametrize("threads", [0.2, 8.0])
def test_cloth_of_one_roughness_has_it_at_every_distance(model: str, threads: float) -> None:
    even = fabric_from_text(
        'weave = "twill 3/1"\n[warp]\nroughness = 0.3\n[weft]\nroughness = 0.3\ngap = 0.3\n'
    )
    layer = roughness_of(even, model, threads)
    # Rounding of single precision, over some 30 samples a pixel.
    np.testing.assert_allclose(layer, 0.3, rtol=1e-5)


@pytest.mark.parametrize("model", ["lobes", "point"])
def test_near_by_each_yarn_has_its_own_roughness_and_far_away_their_mean(model: str) -> None:
    unlike = fabric_from_text(
        'weave = "twill 3/1"\n[warp]\nroughness = 0.2\n[weft]\nroughness = 0.6\n'
        "[variation]\nirregularity = 0\n"
    )
    near = roughness_of(unlike, model, 0.02)
    # Edges of yarns cross a pixel now and then; all others show one family alone.
    alone = np.isclose(near, 0.2, atol=1e-4) | np.isclose(near, 0.6, atol=1e-4)
    assert alone.mean() > 0.8
    far = roughness_of(unlike, model, 8.0).mean()
    # A 3/1 twill shows its warp three times as often; gaps and heights change that a little.
    np.testing.assert_allclose(far, 0.75 * 0.2 + 0.25 * 0.6, atol=0.05)


def test_other_surfaces_have_the_roughness_that_they_show() -> None:
    def of(bsdf: dict[str, Any]) -> float:
        return float(render_layers(scene(wall=wall(bsdf, 2.0, 2.0)), ["roughness"])["roughness"][4, 4, 0])

    np.testing.assert_allclose(of(grey(0.4)), 1.0)
    np.testing.assert_allclose(of({"type": "roughconductor", "alpha": 0.2}), 0.2, rtol=1e-6)
    np.testing.assert_allclose(of({"type": "principled", "roughness": 0.3}), 0.09, rtol=1e-6)
    unlike = {"type": "roughconductor", "alpha_u": 0.1, "alpha_v": 0.4}
    np.testing.assert_allclose(of(unlike), 0.2, rtol=1e-6)
    np.testing.assert_allclose(of({"type": "conductor"}), 0.0)


def roughness_of(fabric: Any, model: str, threads: float) -> Any:
    """The layer of cloth that fills the picture, whose pixels are so many threads wide."""
    picture_mm = 9 * threads * float(fabric.layout().warp.spacing.mean())
    # The picture is 2 · tan 10° wide a unit away, of a square of 2 units.
    uv = float(picture_mm / np.tan(np.radians(10)))
    cloth = wall(material_bsdf(fabric, model=model)((uv, uv)), 1.0, 1.0)
    return render_layers(scene(cloth=cloth), ["roughness"])["roughness"]


def test_a_picture_has_the_layers_that_were_asked_for() -> None:
    fabric = fabric_from_text('weave = "plain"\n[warp]\ncolor = "#c02020"\n[weft]\ncolor = "#2020c0"\n')
    shown: dict[str, Any] = {"spp": 1, "size": (24, 16), "denoise": "off", "zoom": 60.0, "model": "point"}
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
        "roughness.Y",
    }
    for wrong in ("cloth.png", "cloth.gif"):
        turn = ["--turntable", "4"] if wrong.endswith("gif") else []
        assert run([*arguments, "-o", str(tmp_path / wrong), *turn]) == 2
        assert "layers of an .exr" in capsys.readouterr().err


def test_pictures_of_a_turn_have_their_own_layers(tmp_path: Path) -> None:
    arguments = ["render", "plain", "--scene", "drape", "--size", "16x12", "--spp", "1", "--aov", "normal"]
    arguments += ["--model", "point"]
    assert run([*arguments, "--turntable", "2", "-o", str(tmp_path / "cloth.exr")]) == 0
    normals = [
        OpenEXR.File(str(tmp_path / f"cloth-{number}.exr"), separate_channels=True)
        .channels()["normal.X"]
        .pixels
        for number in ("000", "001")
    ]
    # The drape's folds face to the left and to the right, and other ones half a turn later.
    assert all(found.min() < -0.2 and found.max() > 0.2 for found in normals)
    assert np.abs(normals[1] - normals[0]).max() > 0.2


def test_an_unknown_layer_is_one_sentence() -> None:
    with pytest.raises(InputError, match="give names of albedo, normal, depth, roughness"):
        loomlight.RenderSettings(aov="albedo,gloss")
