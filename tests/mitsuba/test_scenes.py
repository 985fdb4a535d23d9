"""Scenes: framing, zoom, scale, replacement in scene files, and faults.

Covers: mitsuba/camera.py, mitsuba/lights.py
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.fabric import fabric_from_text
from loomlight.fabric.facts import cloth_facts
from loomlight.mitsuba import (
    SCENES,
    ClothScene,
    Placement,
    RenderSettings,
    build_scene,
    material_bsdf,
    render,
    shapes,
)
from loomlight.mitsuba.camera import framing
from loomlight.mitsuba.meshes import from_shape
from loomlight.models.registry import make_model

DATA = os.environ.get("LOOMLIGHT_DATA")
WHITE = {"type": "twosided", "inner": {"type": "diffuse", "reflectance": 0.8}}


@pytest.mark.parametrize("name", SCENES)
def test_scenes_show_cloth_without_blown_highlights(name: str) -> None:
    shown = build_scene(name, WHITE, size=(32, 24))
    picture = render(shown.scene, spp=16)
    assert picture.shape == (24, 32, 3)
    assert np.isfinite(picture).all()
    assert np.quantile(picture, 0.95) > 0.25
    assert np.quantile(picture.mean(axis=2), 0.99) < 1.0


@pytest.mark.parametrize("name", ["flat", "drape"])
def test_a_grey_card_looks_grey(name: str) -> None:
    """In the default light: without a cast, and neither under- nor overexposed."""
    card = {"type": "twosided", "inner": {"type": "diffuse", "reflectance": 0.18}}
    picture = render(build_scene(name, card, size=(32, 24)).scene, spp=64)
    np.testing.assert_allclose(
        picture, picture.mean(axis=2, keepdims=True) * np.ones(3), rtol=1e-4, atol=1e-6
    )
    # A card that faces the key light would have 0.18; these are turned and in part in shadow.
    assert 0.09 < np.quantile(picture[8:16, 11:21], 0.9) < 0.18


def test_the_fabric_is_told_its_scale() -> None:
    told: list[tuple[float, float]] = []

    def factory(uv_size_mm: tuple[float, float]) -> dict[str, Any]:
        told.append(uv_size_mm)
        return WHITE

    shown = build_scene("flat", factory, size=(8, 8))
    assert told == [shown.uv_size_mm]
    np.testing.assert_allclose(told[0], (100, 100), rtol=1e-6)


@pytest.mark.parametrize("size", [(30, 30), (60, 20), (20, 60)])
def test_framing_is_tight_and_whole(size: tuple[int, int]) -> None:
    points = np.random.default_rng(1).uniform(-1, 1, (500, 3)) * [2, 1, 0.5] + [3, 4, 5]
    view = framing(points, np.array([0.3, 0.5, 1.0]), size)
    forward = view.target - view.origin
    forward /= np.linalg.norm(forward)
    right = np.cross(forward, [0, 1, 0])
    right /= np.linalg.norm(right)
    offset = points - view.origin
    depth = offset @ forward
    half = np.tan(np.radians(13)) / min(size)
    x = offset @ right / depth / (half * size[0])
    y = offset @ np.cross(right, forward) / depth / (half * size[1])
    reach = max(np.abs(x).max(), np.abs(y).max())
    assert 0.9 < reach < 1


def _frame_hits(scene: mi.Scene, count: int = 9) -> np.ndarray:
    """Which rays of the outline of a picture meet something, bool [n]."""
    steps = np.linspace(0, 1, count)
    edges = [np.stack([steps, np.full(count, side)]) for side in (0.0, 1.0)]  # lower and upper
    x, y = np.concatenate([*edges, *(edge[::-1] for edge in edges)], axis=1).astype(np.float32)
    rays, _ = scene.sensors()[0].sample_ray(mi.Float(0), mi.Float(0), mi.Point2f(x, y), mi.Point2f(0))
    return scene.ray_intersect(rays).is_valid().numpy()


@pytest.mark.quick("cylinder-size0-1.0", "drape-size1-0.1", "sphere-size2-1.0")
@pytest.mark.parametrize("zoom", [1.0, 0.1])
@pytest.mark.parametrize("size", [(12, 36), (12, 16), (36, 12)])
@pytest.mark.parametrize("name", [*SCENES, "mesh"])
def test_paper_fills_every_frame(name: str, size: tuple[int, int], zoom: float, tmp_path: Path) -> None:
    """Tall frames looked over the edge of the floor, into the black below an environment's horizon."""
    mesh = None
    if name == "mesh":
        mesh = tmp_path / "wide.obj"
        mesh.write_text("v 0 0 0\nv 2 0 0\nv 2 .3 0\nvt 0 0\nvt 2 0\nvt 2 .3\nf 1/1 2/2 3/3\n")
    scene = "drape" if name == "mesh" else name
    shown = build_scene(scene, WHITE, mesh=mesh, size=size, zoom=zoom, edge=None)
    assert _frame_hits(shown.scene).all()


@pytest.mark.parametrize("light", ["studio", "sunsky", "point", "directional"])
def test_the_edges_of_tall_frames_are_lit(light: str) -> None:
    """No pixel of the upper rows is black, in any light; a point light's floor fades with distance."""
    shown = build_scene("drape", WHITE, size=(12, 36), light=light)
    rows = render(shown.scene, spp=16)[:3]
    assert rows.max(axis=2).min() > (1e-5 if light == "point" else 0.2)


@pytest.mark.parametrize("light", ["studio", "directional"])
def test_light_from_behind_comes_through_flat_cloth(light: str) -> None:
    """The paper stands aside, and what is around the cloth is as dark everywhere."""
    sheer = material_bsdf(fabric_from_text('weave = "plain"\n[warp]\ncolor = "#ffffff"\n'), "point")
    shown = build_scene("flat", sheer, size=(24, 24), zoom=0.6, light=light, light_from=(180, 40))
    picture = render(shown.scene, integrator=shown.integrator, spp=16)
    corners = picture[[0, 0, -1, -1], [0, -1, 0, -1]]
    # A quarter of the way down, where the pinked edge is not.
    assert picture[9:15, 9:15].min() > 0.02
    np.testing.assert_allclose(corners, corners[0, 0], rtol=1e-5, atol=1e-7)
    assert (corners.max() > 0) == (light == "studio")


def test_zoom_comes_so_many_times_closer() -> None:
    def origin(zoom: float) -> np.ndarray:
        shown = build_scene("drape", WHITE, zoom=zoom, size=(8, 8))
        matrix = np.array(mi.traverse(shown.scene.sensors()[0])["to_world"].matrix).reshape(4, 4)
        return matrix[:3, 3] - np.array(shown.point)

    np.testing.assert_allclose(origin(1.0), origin(10.0) * 10, rtol=1e-3, atol=1e-4)


def test_zoom_point_lies_on_the_cloth() -> None:
    shown = build_scene("drape", WHITE, zoom=200, size=(4, 4))
    ray, _ = shown.scene.sensors()[0].sample_ray(0, 0, mi.Point2f(0.5, 0.5), 0)
    hit = shown.scene.ray_intersect(ray)
    np.testing.assert_allclose(np.array(hit.p).ravel(), shown.point, atol=1e-4)


XML = """<scene version="3.0.0">
  <sensor type="perspective"><float name="fov" value="20"/>
    <transform name="to_world"><lookat origin="0,0,10" target="0,0,0" up="0,1,0"/></transform>
    <film type="hdrfilm"><integer name="width" value="8"/><integer name="height" value="8"/></film></sensor>
  <emitter type="constant"/>
  <shape type="obj"><string name="filename" value="quad.obj"/>
    <bsdf type="diffuse" id="{identifier}"><rgb name="reflectance" value="0"/></bsdf></shape>
</scene>"""
QUAD = (
    "v -5 -5 0\nv 5 -5 0\nv 5 5 0\nv -5 5 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"
)


def write_scene(folder: Path, identifier: str = "fabric") -> Path:
    (folder / "quad.obj").write_text(QUAD)
    file = folder / "scene.xml"
    file.write_text(XML.format(identifier=identifier))
    return file


def test_scene_files_are_given_the_fabric(tmp_path: Path) -> None:
    shown = build_scene(write_scene(tmp_path), WHITE, metres_per_unit=0.01)
    np.testing.assert_allclose(shown.uv_size_mm, (100, 100), rtol=1e-5)
    picture = render(shown.scene, spp=64)
    assert picture.shape[:2] == (8, 8)
    # A white sky; the file's own black would give 0. 4096 samples of relative spread below 1.
    np.testing.assert_allclose(picture[..., :3].mean(), 0.8, rtol=0.06)


def test_scene_files_take_size_and_zoom(tmp_path: Path) -> None:
    shown = build_scene(write_scene(tmp_path), WHITE, size=(6, 4), zoom=5)
    assert render(shown.scene, spp=1).shape[:2] == (4, 6)
    matrix = np.array(mi.traverse(shown.scene.sensors()[0])["to_world"].matrix).reshape(4, 4)
    np.testing.assert_allclose(matrix[:3, 3], [0, 0, 2], atol=1e-5)


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"name": "floor"}, 'scene = "floor"'),
        ({"zoom": 0}, "zoom = 0"),
        ({"zoom": float("nan")}, "zoom = nan"),
        ({"size": (0, 8)}, "size = (0, 8)"),
        ({"light": "moon"}, 'light = "moon"'),
        ({"mesh": "none.obj"}, "none.obj does not exist"),
        ({"environment": "none.exr"}, "none.exr does not exist"),
        ({"environment": "sky.docx"}, "sky.docx"),
        ({"metres_per_unit": -1}, "metres_per_unit = -1"),
        ({"name": "none.xml"}, "none.xml does not exist"),
        ({"bsdf": {"type": "no_such_bsdf"}}, "no_such_bsdf"),
        ({"edge": "frayed"}, 'edge = "frayed" is unknown: use hem, pinked, raw'),
    ],
)
def test_bad_arguments_end_in_a_sentence(arguments: dict[str, Any], says: str) -> None:
    given = {"name": "flat", "bsdf": WHITE, "size": (8, 8)} | arguments
    with pytest.raises(InputError) as caught:
        build_scene(given.pop("name"), given.pop("bsdf"), **given)
    assert says in str(caught.value)
    assert "\n" not in str(caught.value)


def test_scene_file_faults(tmp_path: Path) -> None:
    with pytest.raises(InputError, match='id "fabric"'):
        build_scene(write_scene(tmp_path, "other"), WHITE)
    with pytest.raises(InputError, match="light = point"):
        build_scene(write_scene(tmp_path), WHITE, light="point")
    broken = tmp_path / "broken.xml"
    broken.write_text("<scene")
    with pytest.raises(InputError, match=r"broken\.xml"):
        build_scene(broken, WHITE)


def test_damaged_environment_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "sky.exr"
    file.write_bytes(b"no picture")
    with pytest.raises(InputError, match=r"sky\.exr"):
        build_scene("flat", WHITE, environment=file, size=(8, 8))


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_environments_hold_finite_numbers(tmp_path: Path, value: float) -> None:
    picture = np.full((4, 8, 3), 0.5, dtype=np.float32)
    picture[1, 2, 1] = value
    mi.Bitmap(picture).write(str(tmp_path / "sky.exr"))
    with pytest.raises(InputError, match="no finite numbers"):
        build_scene("flat", WHITE, environment=tmp_path / "sky.exr", size=(8, 8))


@pytest.mark.parametrize("scale", [1e30, 1e-30])
def test_cloth_is_of_a_size_that_cloth_has(tmp_path: Path, scale: float) -> None:
    write_scene(tmp_path)
    with pytest.raises(InputError, match="metres_per_unit"):
        build_scene("flat", WHITE, mesh=tmp_path / "quad.obj", metres_per_unit=scale, size=(8, 8))


def test_a_bright_environment_lights_from_where_it_is(tmp_path: Path) -> None:
    # A lamp on one side of the sphere; turned by half a turn it lights the other.
    picture = np.zeros((16, 32, 3), dtype=np.float32)
    picture[6:10, :] = 0.01
    picture[6:10, 20:24] = 20
    file = tmp_path / "sky.exr"
    mi.Bitmap(picture).write(str(file))
    sides = []
    for turn in (0.0, 180.0):
        shown = build_scene("sphere", WHITE, environment=file, environment_turn=turn, size=(16, 16))
        image = render(shown.scene, spp=16).mean(axis=2)
        inside = image[4:12, 4:12]
        sides.append(inside[:, :4].mean() - inside[:, 4:].mean())
    assert sides[0] * sides[1] < 0


@pytest.mark.skipif(DATA is None, reason="LOOMLIGHT_DATA does not name the folder of outside pictures")
def test_outside_mesh_under_outside_sky() -> None:
    folder = Path(DATA or "")
    shown = build_scene(
        "drape",
        WHITE,
        mesh=folder / "meshes" / "towel.obj",
        metres_per_unit=0.1,
        environment=folder / "env" / "museumplein_1k.exr",
        size=(16, 16),
    )
    assert render(shown.scene, spp=4).mean() > 0.05


@pytest.mark.quick("studio")
@pytest.mark.parametrize("light", ["studio", "sunsky", "point", "directional"])
def test_lights_come_from_where_they_are_told(light: str) -> None:
    def halves(azimuth: float, elevation: float) -> tuple[float, float]:
        shown = build_scene("sphere", WHITE, light=light, light_from=(azimuth, elevation), size=(16, 16))
        inside = render(shown.scene, spp=16).mean(axis=2)[4:12, 4:12]
        return inside[:, 4:].mean() / inside[:, :4].mean(), inside[:4].mean() / inside[4:].mean()

    assert halves(60, 10)[0] > 1.2
    assert halves(-60, 10)[0] < 1 / 1.2
    assert halves(0, 60)[1] > 1.2


def test_paths_of_a_scene_file_are_as_long_as_asked_for(tmp_path: Path) -> None:
    file = write_scene(tmp_path)
    assert build_scene(file, WHITE).integrator.max_depth == 2**32 - 1
    assert build_scene(file, WHITE, max_depth=3).integrator.max_depth == 3
    own = '<integrator type="footprint_path"><integer name="max_depth" value="5"/></integrator></scene>'
    file.write_text(file.read_text().replace("</scene>", own))
    assert build_scene(file, WHITE).integrator.max_depth == 5
    assert build_scene(file, WHITE, max_depth=3).integrator.max_depth == 3


def test_no_ray_slips_through_between_two_triangles() -> None:
    """Rays from all around to points of the edges of the draped mesh, which two triangles share."""
    shown = build_scene("drape", WHITE, size=(16, 16))
    (cloth,) = (shape for shape in shown.scene.shapes() if shape.id() == "cloth")
    mesh = from_shape(cloth, "drape")
    positions, faces = mesh.positions, mesh.triangles
    normals = np.cross(
        positions[faces[:, 1]] - positions[faces[:, 0]], positions[faces[:, 2]] - positions[faces[:, 0]]
    )
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    edges = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    order = np.lexsort(edges.T)
    shared = np.flatnonzero((edges[order[1:]] == edges[order[:-1]]).all(axis=1))
    first, second = order[shared], order[shared + 1]
    rng = np.random.default_rng(0)
    chosen = rng.integers(len(first), size=1_000_000)
    ends = positions[edges[first[chosen]]]
    targets = ends[:, 0] + rng.random((len(chosen), 1)) * (ends[:, 1] - ends[:, 0])
    towards = rng.normal(size=targets.shape)
    towards /= np.linalg.norm(towards, axis=1, keepdims=True)
    cosines = [(normals[edge[chosen] % len(faces)] * towards).sum(axis=1) for edge in (first, second)]
    # Where neither is seen from its edge.
    kept = (np.minimum(*np.abs(cosines)) > 0.2) & (cosines[0] * cosines[1] > 0)
    start, direction = (targets - 0.1 * towards)[kept], towards[kept]
    ray = mi.Ray3f(*(mi.Vector3f(np.ascontiguousarray(part.T, np.float32)) for part in (start, direction)))
    hit = shown.scene.ray_intersect_preliminary(ray)
    # Rounding of places half a metre from the origin, seen at an angle.
    assert (np.array(hit.t) < 0.1 + 1e-5).all()


def heights_of(shown: ClothScene) -> np.ndarray:
    """z of the vertices of the cloth, millimetres."""
    (cloth,) = (shape for shape in shown.scene.shapes() if shape.id() == "cloth")
    return 1000 * np.array(cloth.vertex_positions_buffer()).reshape(-1, 3)[:, 2]


@pytest.mark.slow
def test_edges_are_as_suits_the_scene() -> None:
    """A pinked flat piece close to its paper, a hem of the drape, and no edges unless asked for."""
    counts = {
        edge: [len(heights_of(build_scene(name, WHITE, size=(8, 8), edge=edge))) for name in SCENES]
        for edge in ("raw", None, "hem", "pinked")
    }
    raw, own = counts["raw"], counts[None]
    flat, sphere, cylinder, drape = range(len(SCENES))
    assert own[flat] == counts["pinked"][flat] > raw[flat]
    assert own[drape] == counts["hem"][drape] > raw[drape]
    assert (own[sphere], own[cylinder]) == (raw[sphere], raw[cylinder])
    flats = (build_scene("flat", WHITE, size=(8, 8), edge=edge).scene.shapes() for edge in ("raw", None))
    paper = [shape.bbox().min.z for shapes in flats for shape in shapes if shape.id() == "backdrop"]
    np.testing.assert_allclose(paper, [-0.004, -0.001], atol=1e-6)


def test_a_hem_is_twice_as_thick_as_the_fabric() -> None:
    fabric = fabric_from_text('weave = "plain"\n[warp]\nwidth_mm = 0.4\n[weft]\nwidth_mm = 0.4\n')
    thickness = cloth_facts(fabric).thickness_mm
    assert 0.5 < thickness < 1
    for scale in (1.0, 2.0):
        cloth = material_bsdf(make_model("point", fabric))
        shown = build_scene("flat", cloth, size=(8, 8), edge="hem", placement=Placement(scale=scale))
        assert heights_of(shown).min() == pytest.approx(-2 * thickness * scale, rel=1e-5)


def test_edges_leave_the_cloth_within_as_it_was() -> None:
    """The folds of the drape from the very same place, with and without a hem."""
    raw, hem = (build_scene("drape", WHITE, size=(24, 24), zoom=2.5, edge=edge) for edge in ("raw", "hem"))
    hem.look_from(raw.view)
    before, after = (render(shown.scene, spp=256) for shown in (raw, hem))
    # Noise of 256 samples; light from the paper, which lies the thickness of a hem lower, is a part of it.
    np.testing.assert_allclose(after.mean(), before.mean(), rtol=2e-3)
    np.testing.assert_allclose(after, before, rtol=0.1)


def test_scene_files_have_edges_of_their_own(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="edge = hem does not go with the scene file"):
        build_scene(write_scene(tmp_path), WHITE, edge="hem")


def write_ball(file: Path) -> Path:
    """A coarse ball with smooth normals: 16 by 10 quadrilaterals."""

    def place(u: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, ...]:
        around, polar = 2 * np.pi * u, np.pi * (0.02 + 0.96 * v)
        return (
            0.2 * np.sin(polar) * np.cos(around),
            -0.2 * np.cos(polar),
            0.2 * -np.sin(polar) * np.sin(around),
        )

    mesh = shapes.grid_surface((17, 11), place, "ball")
    rows = {"v": mesh.positions, "vt": mesh.uv, "vn": mesh.normals}
    lines = [f"{kind} {' '.join(map(str, row))}" for kind, values in rows.items() for row in values]
    lines += ["f " + " ".join(f"{n}/{n}/{n}" for n in triangle) for triangle in mesh.triangles + 1]
    file.write_text("\n".join(lines) + "\n")
    return file


def test_shadow_ends_where_shading_does(tmp_path: Path) -> None:
    """On a coarse ball, whose triangles turn away from the light before its normals do."""
    ball = write_ball(tmp_path / "ball.obj")
    options: dict[str, Any] = {"light": "directional", "light_from": (-80, 20), "max_depth": 2}
    shown = build_scene("drape", WHITE, mesh=ball, size=(48, 48), **options)
    y, x = (mi.Float(rows.ravel().astype(np.float32)) for rows in np.mgrid[0:48, 0:48])
    ray, _ = shown.scene.sensors()[0].sample_ray(0, 0, mi.Point2f((x + 0.5) / 48, (y + 0.5) / 48), 0)
    si = shown.scene.ray_intersect(ray)
    azimuth, elevation = np.radians(options["light_from"])
    light = [np.sin(azimuth) * np.cos(elevation), np.sin(elevation), np.cos(azimuth) * np.cos(elevation)]
    cosine = np.array(si.sh_frame.n).T @ light
    place = np.array(si.p).T
    # Of the ball, above the ground and well within the outline.
    inside = (np.linalg.norm(place, axis=1) < 0.21) & (place[:, 1] > -0.15) & (np.array(si.wi.z) > 0.3)
    assert inside.sum() > 300
    errors = []
    for soft in (True, False):
        shown.integrator.soft_terminator = soft
        picture = render(shown.scene, spp=16, integrator=shown.integrator)[..., 0].ravel()
        # Irradiance π, albedo 0.8.
        errors.append(np.abs(picture - 0.8 * np.maximum(cosine, 0))[inside].max())
    # A pixel sees 0.4 of 48 of the ball, a change of cosine of 0.03, and its filter is wider.
    assert errors[0] < 0.04
    assert errors[1] > 0.06


def test_narrow_lights_have_a_soft_terminator() -> None:
    assert RenderSettings(light="directional").soft_terminator
    assert not RenderSettings().soft_terminator
