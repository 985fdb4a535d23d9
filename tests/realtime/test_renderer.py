"""Frames of one or two pieces of cloth: against Mitsuba's direct light on the same scene, edits, and errors.

Covers: realtime/scene.py, realtime/materials.py
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np
import pytest

from loomlight.core.colour import linear_to_srgb
from loomlight.core.errors import InputError
from loomlight.evaluation.metrics import flip_mean
from loomlight.fabric import fabric_from_text, load_fabric
from loomlight.fabric.fabric import Fabric
from loomlight.realtime import Camera, Cloth, DirectionalLight, Mesh, Picture, PointLight, Renderer, rectangle
from studies.accuracy.realtime_frames import mitsuba_frame
from tests.helpers.untrained import random_neumip

EXAMPLES = Path(__file__).parents[2] / "examples"
SIZE, SAMPLES = 40, 1024
TOWARDS = (0.5, 0.3, 0.8)
SIDE = 0.1  # metres


@pytest.fixture(scope="module", autouse=True)
def variant() -> None:
    mi.set_variant("llvm_ad_rgb")


def from_distance(distance: float) -> Camera:
    return Camera((0, -0.6 * distance, 0.8 * distance))


def frame(fabric: Fabric, distance: float, **options: Any) -> Picture:
    renderer = Renderer([Cloth(rectangle(SIDE, SIDE), fabric)], (SIZE, SIZE), "point")
    return renderer.render(from_distance(distance), [DirectionalLight(TOWARDS)], **options)


@pytest.mark.quick("silk-satin-0.2")
@pytest.mark.parametrize(
    ("name", "distance"), [("denim", 0.01), ("wool-houndstooth", 0.05), ("silk-satin", 0.2)]
)
def test_frames_are_those_of_mitsuba(name: str, distance: float) -> None:
    """Two seeds of Mitsuba's own differ by about 0.01 here: both average 1024 points a pixel.

    Of yarns without plies and fibres: Mitsuba filters these by the distance of samples, frames by pixels.
    """
    text = (EXAMPLES / f"{name}.toml").read_text(encoding="utf-8")
    fabric = fabric_from_text(re.sub(r"^yarn = .*\n", "", text, flags=re.MULTILINE))
    cloths = [Cloth(rectangle(SIDE, SIDE), fabric)]
    lights = [DirectionalLight(TOWARDS)]
    expected = mitsuba_frame(cloths, from_distance(distance), (SIZE, SIZE), lights, spp=SAMPLES)
    found = frame(fabric, distance, samples=SAMPLES // 8, passes=8).linear[..., :3]
    assert found.mean() == pytest.approx(expected.mean(), rel=5e-3)
    assert flip_mean(found, expected, np.ones((SIZE, SIZE), bool)) <= 0.03


@pytest.mark.slow
def test_passes_of_lobes_tend_to_the_mean_over_pixels() -> None:
    """Close up, where one pass takes eight points of each pixel: the mean over pixels is that of `point`."""
    fabric = load_fabric(EXAMPLES / "organza.toml")
    camera, lights, size = from_distance(0.00625), [DirectionalLight(TOWARDS)], (20, 20)
    cloths = [Cloth(rectangle(SIDE, SIDE), fabric)]
    truth = Renderer(cloths, size, "point").render(camera, lights, passes=4, samples=128).linear[..., :3]
    renderer = Renderer(cloths, size)
    first, mean = (renderer.render(camera, lights, passes=n).linear[..., :3] for n in (1, 32))
    whole = np.ones(size[::-1], bool)
    assert mean.mean() == pytest.approx(truth.mean(), rel=0.03)
    assert flip_mean(mean, truth, whole) < 0.5 * flip_mean(first, truth, whole)


def plain(color: str = "#8040c0") -> Fabric:
    return fabric_from_text(f'weave = "plain"\n[warp]\ncolor = "{color}"\n[weft]\ncolor = "{color}"\n')


def test_tones_are_srgb_after_exposure() -> None:
    picture = frame(plain(), 0.05, exposure=1.0)
    expected = linear_to_srgb(2 * picture.linear[..., :3]) * 255
    assert np.abs(picture.srgb[..., :3] - expected).max() <= 0.51  # rounding to 8 bits
    assert (picture.srgb[..., 3] == 255).all()


def test_passes_add_up_until_something_changes() -> None:
    """Two frames of three passes are one of six; an edit begins anew."""
    renderer = Renderer([Cloth(rectangle(SIDE, SIDE), plain())], (8, 8), "point")
    camera, light = from_distance(0.05), [DirectionalLight(TOWARDS)]
    whole = renderer.render(camera, light, passes=6).linear
    renderer.render(camera, light, passes=3)
    np.testing.assert_allclose(renderer.accumulate(camera, light, passes=3).linear, whole, rtol=1e-6)
    assert renderer.passes == 6
    for change in (
        lambda: renderer.set_fabric(0, plain("#ffffff")),
        lambda: renderer.resize((8, 9)),
        lambda: light.append(DirectionalLight((0, 0, 1))),
    ):
        change()
        renderer.accumulate(camera, light)
        assert renderer.passes == 1


def test_an_edit_shows_at_once_and_compiles_nothing() -> None:
    renderer = Renderer([Cloth(rectangle(SIDE, SIDE), plain("#ff0000"))], (16, 16), "point")
    light = [DirectionalLight((0, 0, 1))]
    red = renderer.render(from_distance(0.05), light).linear.mean(axis=(0, 1))
    pipelines = dict(renderer.adapter._pipelines)
    renderer.set_fabric(0, load_fabric(EXAMPLES / "denim.toml"))
    blue = renderer.render(from_distance(0.05), light).linear.mean(axis=(0, 1))
    assert red[0] > 2 * red[2]
    assert blue[2] > blue[0]
    assert renderer.adapter._pipelines == pipelines


@pytest.mark.slow
def test_fabrics_of_one_frame_keep_apart() -> None:
    """The nearer of two sheets hides the other, whatever their order."""
    shift = np.array([0.0, 0, 0.01])
    low = rectangle(SIDE, SIDE)
    high = Mesh(low.positions * (0.5, 0.5, 1) + shift, low.normals, low.uv, low.faces)
    cloths = [Cloth(high, plain("#00ff00")), Cloth(low, plain("#ff0000"))]
    light = [DirectionalLight((0, 0, 1))]
    for order in (cloths, cloths[::-1]):
        linear = Renderer(order, (32, 32), "point").render(Camera((0, 0, 0.2)), light).linear
        assert linear[16, 16, 1] > linear[16, 16, 0]
        assert linear[1, 1, 0] > linear[1, 1, 1]


def test_eight_fabrics_share_one_frame() -> None:
    """Eight colours side by side, as the pieces of chen2024 Fig. 1: each shows its own."""
    colours = np.array([[r, g, b] for r in (0.1, 0.9) for g in (0.1, 0.9) for b in (0.1, 0.9)])
    tile = rectangle(0.01, 0.01)
    cloths = []
    for number, colour in enumerate(colours):
        place = np.array([0.01 * (number - 3.5), 0, 0])
        text = "#" + "".join(f"{round(255 * part):02x}" for part in colour)
        cloths.append(Cloth(Mesh(tile.positions + place, tile.normals, tile.uv, tile.faces), plain(text)))
    renderer = Renderer(cloths, (32, 4), "point")
    linear = renderer.render(Camera((0, 0, 0.02), field_of_view=26.6), [DirectionalLight((0, 0, 1))]).linear
    shown = linear[1:3].reshape(2, 8, 4, 4).mean(axis=(0, 2))[:, :3]
    assert (shown[colours > 0.5].min()) > 2 * shown[colours < 0.5].max()


def test_a_far_point_light_is_a_directional_one() -> None:
    fabric = plain()
    renderer = Renderer([Cloth(rectangle(SIDE, SIDE), fabric)], (16, 16), "point")
    camera, far = from_distance(0.05), 1000.0
    towards = np.array(TOWARDS) / np.linalg.norm(TOWARDS)
    sun = renderer.render(camera, [DirectionalLight(TOWARDS, (1, 1, 1))]).linear
    lamp = renderer.render(camera, [PointLight(far * towards, (far**2,) * 3)]).linear
    np.testing.assert_allclose(lamp, sun, rtol=2e-3, atol=1e-5)


def test_the_background_shows_beside_the_cloth_and_through_holes() -> None:
    open_cloth = fabric_from_text('weave = "plain"\n[warp]\ngap = 0.6\n[weft]\ngap = 0.6\n')
    renderer = Renderer([Cloth(rectangle(SIDE, SIDE), open_cloth)], (24, 24), "point")
    above = renderer.render(Camera((0, 0, 0.05)), [], samples=64, background=(0.25, 0.5, 1)).linear
    # Of open cloth, 0.6² of the plan is holes; no light falls on the rest.
    assert above[..., 3].mean() == pytest.approx(1 - 0.36, abs=0.02)
    np.testing.assert_allclose(above[..., :3].mean(axis=(0, 1)), np.array([0.25, 0.5, 1]) * 0.36, rtol=0.05)
    beside = renderer.render(Camera((0, 0, 10.0)), [], background=(0.25, 0.5, 1)).linear
    np.testing.assert_allclose(beside[0, 0], [0.25, 0.5, 1, 0], rtol=1e-6)


def test_errors_are_sentences() -> None:
    flat = rectangle(SIDE, SIDE)
    with pytest.raises(InputError, match="at least one piece"):
        Renderer([])
    with pytest.raises(InputError, match='model = "toy" is unknown here: use lobes or point or'):
        Renderer([Cloth(flat, plain())], (4, 4), "toy")
    with pytest.raises(InputError, match="size = 0 × 4"):
        Renderer([Cloth(flat, plain())], (0, 4))
    with pytest.raises(InputError, match="no uv"):
        Mesh(flat.positions, flat.normals, np.zeros((0, 2)), flat.faces)
    with pytest.raises(InputError, match="outside 0 to 3"):
        Mesh(flat.positions, flat.normals, flat.uv, flat.faces + 2)
    with pytest.raises(InputError, match="not finite"):
        Mesh(flat.positions * np.nan, flat.normals, flat.uv, flat.faces)
    with pytest.raises(InputError, match="field_of_view = 180"):
        Camera((0, 0, 1), field_of_view=180).axes(4, 4)
    with pytest.raises(InputError, match="no direction"):
        Camera((0, 0, 0)).axes(4, 4)
    with pytest.raises(InputError, match="samples = 0"):
        Renderer([Cloth(flat, plain())], (4, 4), "point").render(Camera((0, 0, 1)), [], samples=0)


def test_a_model_to_train_is_one_sentence() -> None:
    cloth = Cloth(rectangle(1, 1), plain())
    with pytest.raises(InputError, match=r"neumip is trained for .* which takes minutes: bake it"):
        Renderer([cloth], (4, 4), "neumip")
    alone = Cloth(rectangle(1, 1), random_neumip(faces=1, offset=False))
    with pytest.raises(InputError, match='"tile" is no fabric: lobes shows fabrics alone'):
        Renderer([alone], (4, 4), "lobes")
