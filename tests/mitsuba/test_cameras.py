"""Cameras as settings place them: what they see, and where Mitsuba's sensor shows known points.

Covers: core/camera_settings.py, mitsuba/camera.py, mitsuba/scenes.py
"""

from __future__ import annotations

import base64
import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np
import pytest

from loomlight.core.camera_settings import VIEWS, CameraSettings, direction_of_angles
from loomlight.core.errors import InputError
from loomlight.mitsuba import SCENES, ClothScene, RenderSettings, build_scene
from loomlight.mitsuba.camera import chosen_view, framing
from loomlight.mitsuba.pictures import Turntable, turntable
from loomlight.mitsuba.rendering import render
from tests.helpers.meshes import coat

WHITE = {"type": "twosided", "inner": {"type": "diffuse", "reflectance": 0.8}}
FRONT = np.array([0.0, 0.0, 1.0])


def pixel_of(shown: ClothScene, point: Any) -> tuple[float, float]:
    """Where a picture shows a point, in shares of its width and height from its upper left corner."""
    sensor = shown.scene.sensors()[0]
    interaction = mi.Interaction3f()
    interaction.p = mi.Point3f(*map(float, point))
    found, _ = sensor.sample_direction(interaction, mi.Point2f(0))
    size = np.array(sensor.film().size(), float)
    u, v = np.array(found.uv, float).ravel() / size
    return float(u), float(v)


def places(view: Any, points: np.ndarray, size: tuple[int, int]) -> np.ndarray:
    """Of points in a view's picture, -1 to 1 each way."""
    forward = -view.backward
    right = np.cross(forward, view.up)
    right /= np.linalg.norm(right)
    offset = points - view.origin
    half = np.tan(np.radians(view.field_of_view) / 2) / min(size)
    depth = offset @ forward
    assert (depth > 0).all()
    x, y = (
        offset @ right / depth / (half * size[0]),
        offset @ np.cross(right, forward) / depth / (half * size[1]),
    )
    return np.stack([x, y])


def test_framing_shows_all_points_from_everywhere() -> None:
    """From random directions, from above and below, through long and short lenses, turned by any angle."""
    rng = np.random.default_rng(3)
    for number in range(40):
        points = rng.normal(size=(50, 3)) * rng.uniform(0.01, 3, 3) + rng.normal(size=3)
        elevation = (90.0, -90.0)[number % 2] if number < 6 else float(rng.uniform(-90, 90))
        settings = CameraSettings(
            view=(float(rng.uniform(-360, 360)), elevation),
            focal_length=float(rng.uniform(10, 300)),
            roll=float(rng.uniform(-180, 180)),
        )
        size = ((30, 30), (60, 20), (20, 60))[number % 3]
        view = chosen_view(settings, points, FRONT, size)
        np.testing.assert_allclose(view.backward, direction_of_angles(*settings.angles or (0, 0)), atol=1e-9)
        # Between whole and tight: the margin is 4 per cent of the distance, more of a share of near points.
        assert 0.8 < np.abs(places(view, points, size)).max() < 1


def test_above_and_below_have_an_upright_picture() -> None:
    """Walking up to the top from an azimuth, the picture turns nowhere."""
    points = np.random.default_rng(0).normal(size=(20, 3))
    for azimuth in (0.0, 70.0, -150.0):
        for elevation in (90.0, -90.0):
            near, there = (
                chosen_view(CameraSettings(view=(azimuth, angle)), points, FRONT, (8, 8))
                for angle in (elevation * 0.9999, elevation)
            )
            np.testing.assert_allclose(near.origin, there.origin, atol=1e-2)
            np.testing.assert_allclose(near.up, there.up, atol=1e-3)
            assert there.azimuth == pytest.approx(azimuth)


@pytest.mark.parametrize("name", ["flat", "drape"])
def test_nothing_chosen_is_the_view_of_before(name: str) -> None:
    plain, chosen = (
        build_scene(name, WHITE, size=(8, 6)),
        build_scene(name, WHITE, size=(8, 6), roll=0.0, view=None),
    )
    np.testing.assert_array_equal(plain.view.origin, chosen.view.origin)
    assert plain.integrator.background is None


def test_distance_target_and_lens_place_known_points() -> None:
    """A lens of 24 mm shows as much as it is away, over the picture's shorter side."""
    target = np.array([0.1, 0.2, -0.3])
    shown = build_scene(
        "drape", WHITE, size=(60, 40), view="right", target=tuple(target), distance=2.0, focal_length=24.0
    )
    np.testing.assert_allclose(shown.view.origin, target + np.array([2, 0, 0]), atol=1e-12)
    assert pixel_of(shown, target) == pytest.approx((0.5, 0.5), abs=1e-5)
    # From the right, +z is to the left and +y up: half a metre is a quarter of two metres, in height.
    assert pixel_of(shown, target + np.array([0, 0.5, 0])) == pytest.approx((0.5, 0.25), abs=1e-5)
    assert pixel_of(shown, target + np.array([0, 0, 0.75])) == pytest.approx((0.25, 0.5), abs=1e-5)


def test_roll_turns_the_picture_counter_clockwise() -> None:
    shown = build_scene(
        "flat", WHITE, size=(40, 40), view="front", target=(0, 0, 0), distance=1.0, focal_length=12.0, roll=90
    )
    assert pixel_of(shown, (0, 0.5, 0)) == pytest.approx((0.25, 0.5), abs=1e-5)


def test_zoom_comes_closer_to_the_target() -> None:
    shown = build_scene("drape", WHITE, size=(8, 8), view="top", target=(5, 1, 5), distance=3.0, zoom=10)
    np.testing.assert_allclose(shown.view.origin, [5, 1.3, 5], atol=1e-9)


@pytest.mark.filterwarnings("ignore:.*stay uncovered")
@pytest.mark.parametrize(
    ("part", "left", "right"), [("back", 0.5, 0.9), ("shell", 0, 0.4), ("horn", 1.0, 1.4)]
)
def test_a_part_is_framed(part: str, left: float, right: float, tmp_path: Path) -> None:
    """Parts and materials of a coat, with uv or without; in other units too."""
    shown = build_scene(
        "drape", WHITE, mesh=coat(tmp_path), size=(30, 30), look_at=part, view="front", metres_per_unit=0.5
    )
    corners = [pixel_of(shown, (0.5 * x, 0.5 * y, 0)) for x in (left, right) for y in (0, 0.4)]
    found = np.array(corners)
    assert (found > 0).all()
    assert (found < 1).all()
    assert found.max() > 0.95


@pytest.mark.filterwarnings("ignore:.*stay uncovered")
@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (
            {"look_at": "sleeve"},
            'no part and no material "sleeve" to look at: it has front, shell, back, lining',
        ),
        ({"look_at": "sleeve", "mesh": None}, 'look_at = "sleeve" needs a mesh with parts'),
    ],
)
def test_what_is_not_there_is_refused(options: dict[str, Any], sentence: str, tmp_path: Path) -> None:
    given: dict[str, Any] = {"mesh": coat(tmp_path), "size": (8, 8), **options}
    with pytest.raises(InputError, match=sentence):
        build_scene("drape", WHITE, **given)


def test_scene_files_have_their_own_camera(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="view = back does not go with the scene file"):
        build_scene(tmp_path / "a.xml", WHITE, view="back")


@pytest.mark.quick("bottom-drape", "front-drape", "back-flat", "top-flat", "140,30-sphere")
@pytest.mark.parametrize("name", SCENES)
@pytest.mark.parametrize("view", [*VIEWS, "140,30"])
def test_paper_is_seen_from_every_side(name: str, view: str) -> None:
    """The outline of a wide frame shows paper of one radiance, but for shadows; no horizon is black."""
    card = {"type": "twosided", "inner": {"type": "diffuse"}}
    shown = build_scene(name, card, size=(24, 24), view=view, zoom=0.5)
    picture = render(shown.scene, spp=32, integrator=shown.integrator, denoise="off")
    outline = np.concatenate([picture[0], picture[-1], picture[:, 0], picture[:, -1]]).mean(axis=1)
    assert outline.min() > 0.005
    # Noise of 32 samples is 2 per cent; light from the cloth is less.
    assert np.quantile(outline, 0.75) == pytest.approx(shown.integrator.background, rel=0.08)


def test_the_floor_goes_to_the_horizon() -> None:
    """Below a sky, where past its edge the black of an environment's lower half would show."""
    shown = build_scene("drape", WHITE, size=(8, 8), view="30,8", light="sunsky")
    for below, meets in ((0.02, True), (-0.02, False)):
        towards = -direction_of_angles(30, below)
        ray = mi.Ray3f(shown.view.origin.tolist(), towards.tolist())
        # Past the cloth: from as high, a metre to the side.
        ray.o += mi.Vector3f(1, 0, 0)
        assert bool(shown.scene.ray_test(ray)[0]) is meets


def test_flat_cloth_shows_its_back_from_behind() -> None:
    """Red at the front, blue at the back: the paper is moved out of the way."""
    faces = [
        {"type": "diffuse", "reflectance": {"type": "rgb", "value": colour}}
        for colour in ([1, 0, 0], [0, 0, 1])
    ]
    for view, channel in (("front", 0), ("back", 2)):
        shown = build_scene(
            "flat", {"type": "twosided", "front": faces[0], "back": faces[1]}, size=(8, 8), view=view
        )
        middle = render(shown.scene, spp=16, integrator=shown.integrator)[3:5, 3:5].mean(axis=(0, 1))
        assert middle[channel] > 0.3
        assert middle[2 - channel] < 0.05


def test_the_lamp_walks_along_unless_it_is_placed() -> None:
    """The brighter half of a white drape is on the left from everywhere, or where `light_from` says."""

    def brighter(view: str, **options: Any) -> bool:
        shown = build_scene("drape", WHITE, size=(16, 16), view=view, **options)
        picture = render(shown.scene, spp=16, integrator=shown.integrator).mean(axis=2)
        return bool(picture[4:12, 4:8].mean() > picture[4:12, 8:12].mean())

    assert [brighter(view) for view in ("front", "back")] == [True, True]
    assert [brighter(view, light_from=(-60, 30)) for view in ("front", "back")] == [True, False]


@pytest.mark.filterwarnings("ignore:.*stay uncovered")
def test_a_turntable_keeps_the_camera_that_is_placed(tmp_path: Path) -> None:
    def origin(**options: Any) -> np.ndarray:
        shown = build_scene("drape", WHITE, mesh=coat(tmp_path), size=(8, 8), view="0,30", **options)
        Turntable(shown, about_middle=True)
        return shown.scene.sensors()[0].world_transform().translation().numpy().ravel()

    np.testing.assert_allclose(
        origin(distance=7.0, target=(0, 1, 0)), 7 * direction_of_angles(0, 30) + [0, 1, 0], rtol=1e-6
    )
    # Of what it frames the whole turn is in the picture: a part beside the axis, and all of it.
    assert np.linalg.norm(origin(look_at="horn")) > 1


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore:.*yarns a pixel")
def test_a_turntable_starts_at_the_view() -> None:
    settings = RenderSettings(model="point", size=(8, 8), spp=2, view="top", denoise="off", inset=False)
    first, second = turntable("twill 2/2", 2, settings=settings)
    assert np.abs(first - second).mean() > 1e-4
    assert first.mean() == pytest.approx(second.mean(), rel=0.3)
    assert framing(np.eye(3), FRONT, (8, 8)).up.tolist() == [0, 1, 0]


USD = """#usda 1.0
(
    metersPerUnit = 0.01
    upAxis = "Z"
)
def Mesh "cloth"
{{
    int[] faceVertexCounts = [4]
    int[] faceVertexIndices = [0, 1, 2, 3]
    point3f[] points = [(-50, 0, 0), (50, 0, 0), (50, 0, 100), (-50, 0, 100)]
    texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] (interpolation = "vertex")
}}
def Camera "hero"
{{
    double3 xformOp:translate = (0, -200, 50)
    double3 xformOp:rotateXYZ = (90, 0, 0)
    uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateXYZ"]
    token projection = "{projection}"
    float focalLength = 50
    float horizontalAperture = 50
    float verticalAperture = 25
}}
"""


def usd_of_a_camera(folder: Path, projection: str = "perspective") -> Path:
    """A square of 1 m, and a camera 2 m before it that shows 1 m of its height and 2 m across; z is up."""
    pytest.importorskip("pxr")
    file = folder / "shot.usda"
    file.write_text(USD.format(projection=projection))
    return file


def gltf_of_a_camera(folder: Path) -> Path:
    """The same as `usd_of_a_camera`, in metres."""
    data = np.array([[-0.5, 0, 0], [0.5, 0, 0], [0.5, 1, 0], [-0.5, 1, 0]], "<f4").tobytes()
    data += (
        np.array([[0, 1], [1, 1], [1, 0], [0, 0]], "<f4").tobytes()
        + np.array([0, 1, 2, 0, 2, 3], "<u2").tobytes()
    )
    document = {
        "asset": {"version": "2.0"},
        "buffers": [{"byteLength": len(data), "uri": "data:;base64," + base64.b64encode(data).decode()}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 48},
            {"buffer": 0, "byteOffset": 48, "byteLength": 32},
            {"buffer": 0, "byteOffset": 80, "byteLength": 12},
        ],
        "accessors": [
            {
                "bufferView": 0,
                "componentType": 5126,
                "count": 4,
                "type": "VEC3",
                "min": [-0.5, 0, 0],
                "max": [0.5, 1, 0],
            },
            {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
            {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"},
        ],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2}]}],
        "cameras": [
            {
                "type": "perspective",
                "perspective": {"yfov": 2 * math.atan(0.25), "aspectRatio": 2, "znear": 0.1},
            }
        ],
        "nodes": [{"mesh": 0}, {"camera": 0, "name": "hero", "translation": [0, 0.5, 2]}],
        "scenes": [{"nodes": [0, 1]}],
    }
    file = folder / "shot.gltf"
    file.write_text(json.dumps(document))
    return file


@pytest.mark.parametrize("write", [usd_of_a_camera, gltf_of_a_camera])
@pytest.mark.parametrize("units", [1.0, 3.0])
@pytest.mark.parametrize("size", [None, (40, 20), (40, 40), (90, 20)])
def test_a_camera_of_a_file_shows_known_points(
    write: Callable[[Path], Path], units: float, size: tuple[int, int] | None, tmp_path: Path
) -> None:
    """All that the file's camera frames, in pictures of any shape, and its own shape where none is chosen."""
    options: Any = {} if size is None else {"size": size}
    shown = build_scene("drape", WHITE, mesh=write(tmp_path), metres_per_unit=units, camera="hero", **options)
    width, height = (int(side) for side in shown.scene.sensors()[0].film().size())
    assert size is not None or width == 2 * height
    # Of the cloth's width and height, shares of the picture.
    across, up = 1 / max(2, width / height), 1 / max(1, 2 * height / width)
    for x, y in ((-0.5, 0), (0.5, 1), (0, 0.5)):
        place = pixel_of(shown, np.array([x, y, 0]) * units)
        assert place == pytest.approx((0.5 + x * across, 0.5 - (y - 0.5) * up), abs=1e-5)
    np.testing.assert_allclose(shown.point, [0, 0.5 * units, 0], atol=1e-6)
    assert shown.framed is None


@pytest.mark.parametrize(
    ("camera", "projection", "sentence"),
    [
        ("side", "perspective", 'no camera "side": it has hero'),
        ("hero", "orthographic", 'the camera "hero" is orthographic'),
    ],
)
def test_other_cameras_of_files_are_refused(
    camera: str, projection: str, sentence: str, tmp_path: Path
) -> None:
    with pytest.raises(InputError, match=sentence):
        build_scene("drape", WHITE, mesh=usd_of_a_camera(tmp_path, projection), camera=camera)


@pytest.mark.parametrize(
    ("mesh", "sentence"), [(None, "needs a mesh file with cameras"), ("coat.obj", "it has none")]
)
@pytest.mark.filterwarnings("ignore:.*stay uncovered")
def test_files_without_cameras_are_refused(mesh: str | None, sentence: str, tmp_path: Path) -> None:
    coat(tmp_path)
    with pytest.raises(InputError, match=sentence):
        build_scene("drape", WHITE, mesh=mesh and tmp_path / mesh, camera="hero")
