"""Frames of the page's renderer, drawn by WebGPU in Deno, which needs no browser, against frames of Python's.

Both run the same shaders on the same adapter, with what each of them packs and bakes by itself.
"""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.core.colour import linear_to_srgb
from loomlight.core.errors import MissingDependencyError
from loomlight.fabric import fabric_from_text
from loomlight.realtime import (
    Camera,
    Cloth,
    DirectionalLight,
    Environment,
    Mesh,
    PointLight,
    Renderer,
    rectangle,
)
from loomlight.realtime.device import default_adapter
from loomlight.viewer.answers import tables_of
from loomlight.viewer.messages import openness_json
from tests.limits import HANG

ROOT = Path(__file__).parents[2]
WEB = ROOT / "web"
DRAPE = WEB / "editor" / "src" / "assets" / "drape.bin"
DENIM = (ROOT / "examples" / "denim.toml").read_text()
ORGANZA = (ROOT / "examples" / "organza.toml").read_text()
PLAIN = (
    'weave = "twill 2/2"\ninterreflection = false\nends_per_cm = 20\n'
    'warp.color = "{}"\nweft.color = "#d0c8b8"\nwarp.roughness = {}\n'
)
# Tables are baked from words that are equal but for the last bits (test_pack_parity.py) by the same kernels,
# where a compiler may join products and sums in another way.
CLOSE = 2e-3
# Of the pixels: a ray that grazes a yarn, or the edge of a triangle, may fall to the other side.
MAX_BEYOND = 5e-3
# A minute to compile the shaders of frames by the software driver, within Deno.
pytestmark = pytest.mark.slow


@dataclass(frozen=True)
class Drawn:
    """What the page's renderer drew."""

    folder: Path
    report: Mapping[str, Any]

    def linear(self, name: str, size: tuple[int, int]) -> NDArray[np.float32]:
        """[height, width, 4], as `Picture.linear`."""
        return np.fromfile(self.folder / f"{name}.linear", np.float32).reshape(*size[::-1], 4)

    def srgb(self, name: str, size: tuple[int, int]) -> NDArray[np.uint8]:
        return np.fromfile(self.folder / f"{name}.srgb", np.uint8).reshape(*size[::-1], 4)


def drape() -> Mesh:
    """The page's draped cloth, of every eighth vertex each way."""
    grid = np.fromfile(DRAPE, np.dtype("<i2")).reshape(128, 128, 3)[::8, ::8] / 65534
    rows, columns = grid.shape[:2]
    along, across = np.gradient(grid, axis=1), np.gradient(grid, axis=0)
    return _surface(grid, np.cross(along, across), rows, columns)


def sphere() -> Mesh:
    """Of 0.03 m radius; v runs from pole to pole."""
    u, v = np.meshgrid(np.linspace(0, 1, 33), np.linspace(0, 1, 17))
    around, polar = 2 * np.pi * u, np.pi * (0.02 + 0.96 * v)
    normals = np.stack(
        [np.sin(polar) * np.cos(around), -np.cos(polar), -np.sin(polar) * np.sin(around)], axis=-1
    )
    return _surface(0.03 * normals, normals, *u.shape)


def _surface(grid: NDArray[np.float64], normals: NDArray[np.float64], rows: int, columns: int) -> Mesh:
    u, v = np.meshgrid(np.linspace(0, 1, columns), np.linspace(0, 1, rows))
    number = np.arange(rows * columns).reshape(rows, columns)
    one, right, up, both = number[:-1, :-1], number[:-1, 1:], number[1:, :-1], number[1:, 1:]
    faces = np.stack([one, right, both, one, both, up], axis=-1).reshape(-1, 3)
    unit = normals / np.linalg.norm(normals, axis=-1, keepdims=True)
    uv = np.stack([u, v], axis=-1)
    return Mesh(grid.reshape(-1, 3), unit.reshape(-1, 3), uv.reshape(-1, 2), faces.astype(np.uint32))


def sky() -> Environment:
    """Blue above and brown below, with a small sun."""
    radiance = np.full((8, 16, 3), (0.15, 0.1, 0.05))
    radiance[:4] = (0.3, 0.4, 0.6)
    radiance[2, 5] = (9, 8, 6)
    return Environment(radiance, turn=30)


@dataclass(frozen=True)
class Scene:
    """A scene of both renderers; a picture of lobes and one of points."""

    mesh: Mesh
    fabric: str
    uv_size_mm: tuple[float, float]
    camera: Camera
    lights: tuple[DirectionalLight | PointLight, ...]
    environment: Environment | None
    size: tuple[int, int]
    ground: tuple[float, ...] | None = None

    def page_step(self) -> dict[str, Any]:
        mesh, environment = self.mesh, self.environment
        arrays = {
            "positions": mesh.positions,
            "normals": mesh.normals,
            "uv": mesh.uv,
            "triangles": mesh.faces,
        }
        piece = {
            "mesh": {name: np.ravel(values).tolist() for name, values in arrays.items()},
            "fabric": self.fabric,
            "uvSizeMm": self.uv_size_mm,
            "openness": _openness(self.fabric),
        }
        step: dict[str, Any] = {
            "pieces": [piece],
            "model": ["lobes", 4],
            "lights": [_light(light) for light in self.lights],
            "camera": {"origin": self.camera.origin, "target": self.camera.target},
            "environment": None,
            "passes": 2,
        }
        if self.ground is not None:
            x, y, z, offset, lamp_share = self.ground
            step["ground"] = {"normal": (x, y, z), "offset": offset, "lampShare": lamp_share}
        if environment is not None:
            height, width = environment.radiance.shape[:2]
            picture = {"width": width, "height": height, "pixels": environment.radiance.ravel().tolist()}
            step["environment"] = {"picture": picture, "turn": environment.turn}
            step["environmentSamples"] = 4
        return step

    def frame(self, model: str) -> NDArray[np.float32]:
        """Python's picture."""
        cloth = Cloth(self.mesh, fabric_from_text(self.fabric), self.uv_size_mm)
        renderer = Renderer([cloth], self.size, model, bake="gpu")
        options: Any = {"environment": self.environment, "environment_samples": 4, "samples": 4}
        options["ground"] = self.ground
        return renderer.render(self.camera, self.lights, passes=2, **options).linear


def _openness(fabric: str) -> dict[str, list[float]] | None:
    """What the page's server answers for a fabric."""
    return openness_json(fabric_from_text(fabric))


def _light(light: DirectionalLight | PointLight) -> dict[str, Any]:
    if isinstance(light, PointLight):
        return {"kind": "point", "position": light.position, "intensity": light.intensity}
    return {"kind": "directional", "towards": light.towards, "irradiance": light.irradiance}


MODELS = ("lobes", "point", "neural")
LAMP = DirectionalLight((0.5, 0.3, 0.8))
SCENES = {
    "flat": Scene(
        rectangle(0.03, 0.03),
        PLAIN.format("#304a80", 0.3),
        (30, 30),
        Camera((0, -0.02, 0.06)),
        (LAMP,),
        None,
        (48, 48),
    ),
    "drape": Scene(
        drape(),
        DENIM,
        (600, 600),
        Camera((0.4, 0.6, 1.1)),
        (LAMP,),
        sky(),
        (64, 48),
        ground=(0, 1, 0, -0.001, 0.6),
    ),
    "sphere": Scene(
        sphere(),
        ORGANZA,
        (190, 95),
        Camera((0.03, 0.04, 0.18)),
        (PointLight((0.1, 0.15, 0.1), (0.05, 0.04, 0.03)),),
        sky(),
        (40, 40),
    ),
    "light between yarns": Scene(
        rectangle(0.03, 0.03),
        'weave = "plain"\ninterreflection = true\nwarp.color = "#e0c060"\nweft.color = "#e8e4e0"\n',
        (30, 30),
        Camera((0, -0.02, 0.06)),
        (LAMP,),
        sky(),
        (32, 32),
    ),
}
FLAT = SCENES["flat"].size
# Of the flat cloth: by lobes, points, the server's tables of neural, and by lobes once more with one pass.
UNEDITED, FIRST_EDIT = 3, 4
# Edits of the flat cloth by lobes, one after the other: what each changes, as a step of the page.
PRESSED = PLAIN.format("#a04040", 0.9) + "warp.height_scale = 0.3\nweft.height_scale = 0.3\n"
EDITS: dict[str, dict[str, Any]] = {
    "redder": {"fabric": PLAIN.format("#a04040", 0.3)},
    "rougher": {"fabric": PLAIN.format("#a04040", 0.9)},
    "pressed": {"fabric": PRESSED},
    "brighter": {"exposure": 1.0},
    "grazing": {"exposure": 0.0, "lights": [_light(DirectionalLight((0.95, 0.1, 0.2)))]},
    "by the sky": {
        "lights": [],
        "environment": {"picture": {"width": 1, "height": 2, "pixels": [0, 0, 1, 0, 0, 1]}},
    },
    "by yarns": {"fabric": PRESSED.replace("interreflection = false\n", "")},
}
# Of the cloth with light between its yarns, whose openness the page then finds itself.
BETWEEN = SCENES["light between yarns"].fabric
YARN_EDITS: list[dict[str, Any]] = [
    {"fabric": BETWEEN, "passes": 2},
    {"fabric": BETWEEN.replace("#e0c060", "#4080a0"), "passes": 2},
    {"fabric": "gap = 0.4\n" + BETWEEN, "passes": 2},
]


@pytest.fixture(scope="module")
def drawn(tmp_path_factory: pytest.TempPathFactory) -> Drawn:
    node = shutil.which("node")
    if node is None or not (WEB / "node_modules").is_dir():
        pytest.skip("needs Node, and `npm install` in web/: scripts/setup.sh does both")
    deno = shutil.which("deno", path=str(Path(sys.executable).parent)) or shutil.which("deno")
    if deno is None:
        pytest.skip("needs Deno, which runs the page's renderer without a browser: pip install deno")
    try:
        default_adapter()
    except MissingDependencyError as error:
        pytest.skip(str(error))
    folder = tmp_path_factory.mktemp("frames")
    vite = [node, "node_modules/vite/bin/vite.js", "build", "--config", "loomlight-web/vite.config.ts"]
    subprocess.run([*vite, "--outDir", str(folder), "--logLevel", "error"], cwd=WEB, check=True, timeout=HANG)
    points = {"model": ["point", 4], "passes": 2}
    scenes = [{"size": scene.size, "steps": [scene.page_step(), points]} for scene in SCENES.values()]
    (folder / "neural").write_bytes(tables_of(fabric_from_text(SCENES["flat"].fabric), "neural"))
    tables = {"tables": ["neural", "neural"], "passes": 2}
    scenes[-1]["steps"] += YARN_EDITS
    scenes[0]["steps"] += [tables, {"model": ["lobes", 1]}, *EDITS.values()]
    for step in scenes[0]["steps"]:
        if step.get("fabric") in (PRESSED, EDITS["by yarns"]["fabric"]):
            step["openness"] = _openness(step["fabric"])
    (folder / "scenes.json").write_text(json.dumps(scenes))
    script = WEB / "loomlight-web" / "tools" / "render_report.ts"
    command = [deno, "run", "--no-config", "--allow-all", "--unstable-webgpu", str(script)]
    arguments = [str(folder / "loomlight-web.js"), str(folder / "scenes.json"), str(folder)]
    subprocess.run([*command, *arguments], check=True, timeout=HANG)
    return Drawn(folder, json.loads((folder / "report.json").read_text()))


def step_of(edit: str) -> int:
    """The step of the flat cloth that makes an edit, and shows it."""
    return FIRST_EDIT + list(EDITS).index(edit)


def edited(drawn: Drawn, edit: str) -> NDArray[np.float32]:
    """Linear RGB of the flat cloth after an edit [height, width, 3]."""
    return drawn.linear(f"0.{step_of(edit)}", FLAT)[..., :3]


def relief(picture: NDArray[np.float32]) -> float:
    """Mean difference of pixels beside each other, as a share of the mean."""
    return float(np.abs(np.diff(picture, axis=0)).mean() / picture.mean())


@pytest.mark.parametrize(
    ("name", "model"), [*((name, model) for name in SCENES for model in MODELS[:2]), ("flat", "neural")]
)
def test_frames_are_those_of_python(drawn: Drawn, name: str, model: str) -> None:
    """A shadow through holes and several layers are in the sphere's, which is of open cloth."""
    number, scene = list(SCENES).index(name), SCENES[name]
    found = drawn.linear(f"{number}.{MODELS.index(model)}", scene.size)
    expected = scene.frame(model)
    assert expected[..., :3].std() > 0.02
    differences = np.abs(found - expected)
    beyond = (differences > CLOSE * (expected.max() + np.abs(expected))).any(axis=-1)
    assert beyond.mean() <= MAX_BEYOND
    assert differences.mean() <= MAX_BEYOND * expected.mean()


def test_pixels_are_the_encoded_radiance(drawn: Drawn) -> None:
    linear, pixels = drawn.linear("1.0", SCENES["drape"].size), drawn.srgb("1.0", SCENES["drape"].size)
    assert np.abs(pixels[..., :3] - 255 * linear_to_srgb(linear[..., :3])).max() <= 0.51  # rounding to 8 bits
    assert (pixels[..., 3] == 255).all()


def test_controls_change_the_picture_as_they_say(drawn: Drawn) -> None:
    before = drawn.linear(f"0.{UNEDITED}", FLAT)[..., :3]
    means = {edit: edited(drawn, edit).mean(axis=(0, 1)) for edit in EDITS}
    red, blue = means["redder"][0] / before[..., 0].mean(), means["redder"][2] / before[..., 2].mean()
    assert red > 1.3
    assert blue < 0.8
    # The lamp stands where the cloth mirrors it: fibres that stray more mirror less of it.
    assert means["rougher"].mean() < 0.98 * means["redder"].mean()
    # At a third of the height, 0.91 in all.
    assert relief(edited(drawn, "pressed")) < 0.95 * relief(edited(drawn, "rougher"))
    assert means["grazing"].mean() < 0.6 * means["pressed"].mean()
    assert means["by the sky"][2] > 5 * means["by the sky"][0]
    # Yarns that light each other show the colour that they were given.
    assert means["by yarns"][2] > 1.05 * means["by the sky"][2]
    exposed = drawn.srgb(f"0.{step_of('brighter')}", FLAT)[..., :3]
    assert np.abs(exposed - 255 * linear_to_srgb(2 * edited(drawn, "pressed"))).max() <= 0.51


def test_only_edits_of_the_geometry_bake(drawn: Drawn) -> None:
    statistics = drawn.report["statistics"][0]
    bakes = {edit: statistics[step_of(edit)]["bakes"] for edit in EDITS}
    assert bakes == {edit: int(edit == "pressed") for edit in EDITS}
    written = [statistics[step_of(edit)]["writtenBytes"] for edit in ("redder", "rougher")]
    assert 0 < max(written) <= 1024
    assert drawn.report["complaints"] == []


def test_a_slow_adapter_draws_fewer_pixels_while_the_camera_moves(drawn: Drawn) -> None:
    """The budget is no time at all while the camera moves, and any time at rest."""
    pace = drawn.report["pace"]
    assert {frame["width"] for frame in pace["moving"]} == {FLAT[0] // 16}
    widths = [frame["width"] for frame in pace["resting"]]
    assert widths == sorted(widths)
    assert (widths[-1], pace["resting"][-1]["isComplete"]) == (FLAT[0], True)


def test_a_picture_is_refined_in_areas_to_the_size_of_the_canvas(drawn: Drawn) -> None:
    """The budget is no time at all; tables that were kept are baked no more."""
    areas = drawn.report["areas"]
    last = areas["resting"][-1]
    assert (last["width"], last["refined"], last["isComplete"]) == (FLAT[0], 1, True)
    shares = [frame["refined"] for frame in areas["resting"]]
    assert shares == sorted(shares)
    # Areas follow what pixels cost, so how many there are is the machine's; one would be the whole canvas.
    assert any(0 < share < 1 for share in shares)
    assert not any(frame["isComplete"] for frame in areas["resting"][:-1])
    assert areas["bakes"] == 0
    # The camera of an area is the picture's but for rounding: a ray may fall to the other side of yarn.
    differences = np.abs(drawn.linear("areas", FLAT) - drawn.linear("whole", FLAT))
    assert (differences > CLOSE).mean() <= MAX_BEYOND


def test_a_lost_device_is_told_and_drawing_goes_on(drawn: Drawn) -> None:
    loss = drawn.report["loss"]
    assert re.fullmatch(r"The graphics adapter .* was lost.*: the picture is begun again\.", loss["sentence"])
    assert all(not frame["isComplete"] for frame in loss["framesWhileLost"])
    np.testing.assert_array_equal(
        drawn.linear("rebuilt", FLAT), drawn.linear(f"0.{step_of('by yarns')}", FLAT)
    )


def test_the_page_finds_openness_itself(drawn: Drawn) -> None:
    """Without Python's numbers a kernel casts the rays: after edits of yarns, not of a colour."""
    number, scene = list(SCENES).index("light between yarns"), SCENES["light between yarns"]
    statistics = drawn.report["statistics"][number][2:]
    assert [step["openings"] for step in statistics] == [1, 0, 1]
    assert statistics[1]["bakes"] == 0
    for step, edit in enumerate(YARN_EDITS, 2):
        expected = replace(scene, fabric=edit["fabric"]).frame("point")
        differences = np.abs(drawn.linear(f"{number}.{step}", scene.size) - expected)
        assert differences.mean() <= MAX_BEYOND * expected.mean()
