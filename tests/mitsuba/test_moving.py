"""Pictures of moving cloth: the weave rests on it, and everything but its vertices stands still."""

from __future__ import annotations

from pathlib import Path

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight import render_frames
from loomlight.core.errors import InputError
from loomlight.core.picture_settings import RenderSettings
from loomlight.mesh.moving import Frame, find_frames
from loomlight.mitsuba.moving import MovingCloth

from .test_kernels import new_kernels

pytestmark = pytest.mark.filterwarnings("ignore:.*too many to be seen")

Floats = NDArray[np.float64]

SIDE = 0.06
# Towards the camera, which looks at meshes from there, and to its right.
BACKWARD = np.array([0.3, 0.35, 1.0]) / np.linalg.norm([0.3, 0.35, 1.0])
RIGHT = np.cross([0, 1, 0], BACKWARD) / np.linalg.norm(np.cross([0, 1, 0], BACKWARD))
SMALL = RenderSettings(model="point", size=(24, 16), spp=1, denoise="off", edge="raw")


def square(cells: int = 2) -> tuple[Floats, Floats]:
    """Places and uv of a square that faces the camera."""
    u, v = (values.ravel() for values in np.meshgrid(*[np.linspace(0, 1, cells + 1)] * 2))
    up = np.cross(BACKWARD, RIGHT)
    return SIDE * ((u - 0.5)[:, None] * RIGHT + (v - 0.5)[:, None] * up), np.stack([u, v], axis=1)


def write(path: Path, places: Floats, uv: Floats | None) -> None:
    cells = round(len(places) ** 0.5) - 1
    corner = [row * (cells + 1) + column + 1 for row in range(cells) for column in range(cells)]
    faces = [(a, a + 1, a + cells + 2, a + cells + 1) for a in corner]
    lines = [f"v {x:.9f} {y:.9f} {z:.9f}" for x, y, z in places]
    lines += [] if uv is None else [f"vt {u} {v}" for u, v in uv]
    lines += ["f " + " ".join(str(n) if uv is None else f"{n}/{n}" for n in face) for face in faces]
    path.write_text("\n".join([*lines, ""]))


def frames_in(folder: Path, shifts: list[Floats]) -> list[Frame]:
    places, uv = square()
    found = []
    for number, shift in enumerate(shifts, 1):
        found.append(Frame(number, folder / f"cloth-{number}.obj"))
        write(found[-1].path, places + shift, uv)
    return found


def test_the_weave_moves_with_the_cloth(tmp_path: Path) -> None:
    """A cloth that faces the camera goes three pixels to the right, and its picture with it."""
    frames = frames_in(tmp_path, [0 * RIGHT, 0.1 * SIDE * RIGHT, 0.4 * SIDE * RIGHT])
    settings = SMALL.changed(size=(60, 40), spp=64, light="directional", zoom=12.0)
    cloth = MovingCloth("plain", frames, settings)
    pixel = cloth.shown.pixel_mm() / 1000
    places, uv = square()
    write(frames[1].path, places + 3 * pixel * RIGHT, uv)
    still, gone = (cloth.picture(frame) for frame in frames[:2])
    assert still.std() > 0.05, "threads show"
    inner = still[:, 3:-6]
    difference = [np.abs(gone[:, 3 + by : -6 + by or None] - inner).mean() for by in (1, 2, 3, 4, 5)]
    # Of 64 samples noise is a few per cent of what a pixel's step makes.
    assert int(np.argmin(difference)) == 2
    assert difference[2] < 0.25 * min(difference[1], difference[3])


def test_all_but_vertices_stands_still(tmp_path: Path) -> None:
    """The camera shows the whole motion, whichever frames are rendered; uv stay those of the first frame."""
    shifts = [0 * RIGHT, 2 * SIDE * RIGHT, np.array([0, 3 * SIDE, 0])]
    frames = frames_in(tmp_path, shifts)
    cloth = MovingCloth("plain", frames, SMALL)
    sensor = cloth.shown.scene.sensors()[0]
    params = mi.traverse(cloth.shown.scene)
    before, uv = np.array(sensor.world_transform().matrix), np.array(params["cloth.vertex_texcoords"])
    places, _ = square()
    for frame, shift in zip(frames, shifts, strict=True):
        cloth.show(frame)
        np.testing.assert_array_equal(np.array(sensor.world_transform().matrix), before)
        now = np.array(params["cloth.vertex_positions"]).reshape(-1, 3)
        np.testing.assert_allclose(now, places + shift, atol=1e-6)
        inverse = np.linalg.inv(before.reshape(4, 4))
        x, y, z = (np.c_[now, np.ones(len(now))] @ inverse.T)[:, :3].T
        slope = np.tan(np.radians(cloth.shown.view.field_of_view) / 2)
        assert (np.abs(x) < slope * 1.5 * z).all()
        assert (np.abs(y) < slope * z).all()
    np.testing.assert_array_equal(np.array(params["cloth.vertex_texcoords"]), uv)
    ((number, alone),) = render_frames("plain", 2, SMALL, mesh=tmp_path / "*.obj")
    assert number == 2
    # But for the order of sums.
    np.testing.assert_allclose(alone, cloth.picture(frames[1]), rtol=1e-4, atol=1e-5)


def test_layers_are_those_of_each_frame(tmp_path: Path) -> None:
    frames = frames_in(tmp_path, [0 * RIGHT, 0.5 * SIDE * RIGHT])
    cloth = MovingCloth("plain", frames, SMALL.changed(aov="depth", denoise="off"))
    first, second = (cloth.picture(frame).layers["depth"][..., 0] for frame in frames)
    # Paper is seen where the square was: half of a side of it is a tenth of the way to the camera, or more.
    assert np.abs(first - second).max() > 0.1 * first.mean()


def test_kernels_are_compiled_for_the_first_frame_alone(tmp_path: Path) -> None:
    dr.flush_kernel_cache()
    frames = frames_in(tmp_path, [0 * RIGHT, SIDE * RIGHT])
    cloth = MovingCloth("plain", frames, SMALL.changed(edge="hem"))
    assert new_kernels(lambda: cloth.picture(frames[0])) > 0
    assert new_kernels(lambda: cloth.picture(frames[1])) == 0


@pytest.mark.filterwarnings("ignore:.*cut into")
def test_cloth_without_uv_is_cut_in_its_first_frame(tmp_path: Path) -> None:
    """Every vertex of every piece goes where its row of the file goes."""
    places, _ = square(6)
    bent = places + 0.5 * (places**2).sum(axis=1, keepdims=True) / SIDE * BACKWARD
    frames = [Frame(number, tmp_path / f"{number}.obj") for number in (1, 2)]
    write(frames[0].path, places, None)
    write(frames[1].path, bent, None)
    cloth = MovingCloth("plain", frames, SMALL)
    params = mi.traverse(cloth.shown.scene)
    before, uv = (np.array(params[f"cloth.vertex_{name}"]) for name in ("positions", "texcoords"))
    cloth.show(frames[1])
    nearest = np.linalg.norm(before.reshape(-1, 1, 3) - places, axis=2).argmin(axis=1)
    after = np.array(params["cloth.vertex_positions"]).reshape(-1, 3)
    np.testing.assert_allclose(after, bent[nearest], atol=1e-6)
    np.testing.assert_array_equal(params["cloth.vertex_texcoords"], uv)


def test_a_mesh_has_to_move() -> None:
    with pytest.raises(InputError, match="render_frames needs a mesh that moves"):
        next(render_frames("plain"))


STAGE = """#usda 1.0
(
    metersPerUnit = 1
    upAxis = "Y"
    timeCodesPerSecond = 24
    startTimeCode = 0
    endTimeCode = 1
)
def Mesh "cloth"
{
    int[] faceVertexCounts = [4]
    int[] faceVertexIndices = [0, 1, 2, 3]
    point3f[] points.timeSamples = {
        0: [(-0.5, 0, 0), (0.5, 0, 0), (0.5, 1, 0), (-0.5, 1, 0)],
        1: [(-0.4, 0, 0), (0.6, 0, 0), (0.6, 1, 0), (-0.4, 1, 0)],
    }
    texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] (interpolation = "vertex")
}
def Camera "hero"
{
    double3 xformOp:translate.timeSamples = { 0: (0, 0.5, 2), 1: (0.2, 0.5, 3) }
    uniform token[] xformOpOrder = ["xformOp:translate"]
    float focalLength.timeSamples = { 0: 50, 1: 25 }
    float horizontalAperture = 50
    float verticalAperture = 25
}
"""


@pytest.mark.parametrize("zoom", [1.0, 4.0])
def test_a_camera_of_the_file_moves_as_it_does_there(zoom: float, tmp_path: Path) -> None:
    """Its place and its lens, at each frame: half a metre to the right is seen where the lens has it."""
    pytest.importorskip("pxr")
    file = tmp_path / "shot.usda"
    file.write_text(STAGE)
    frames = find_frames(file)
    moving = MovingCloth("plain", frames, SMALL.changed(mesh=file, camera="hero", size=None, zoom=zoom))
    sensor = moving.shown.scene.sensors()[0]
    point = np.array([0, 0.5, 0])
    for frame, origin, half_height in zip(frames, [(0, 0.5, 2), (0.2, 0.5, 3)], [0.25, 0.5], strict=True):
        moving.show(frame)
        ray = sensor.sample_ray(0, 0, mi.Point2f(1, 0), mi.Point2f(0))[0]
        np.testing.assert_allclose(np.ravel(ray.o), point + (np.array(origin) - point) / zoom, atol=1e-5)
        towards = np.ravel(ray.d)
        np.testing.assert_allclose(towards[:2] / -towards[2], [2 * half_height, half_height], atol=1e-5)
    assert moving.hash_of(frames[0]) != moving.hash_of(frames[1])
