"""The web client draws what the Python package draws: its module runs without a browser, on one adapter."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.core.errors import MissingDependencyError
from loomlight.fabric import fabric_from_text
from loomlight.realtime import Camera, Cloth, DirectionalLight, Environment, PointLight, Renderer, rectangle
from loomlight.realtime.device import default_adapter
from loomlight.viewer.openness_json import openness_json

WEB = Path(__file__).parents[2] / "web"
SIZE = (48, 40)
UV_SIZE_MM = (20.0, 20.0)
MESH = rectangle(0.02, 0.02)
CAMERA = Camera((0.0, -0.012, 0.03))
SUN = DirectionalLight((0.5, 0.3, 0.8))
LAMP = PointLight((0.01, 0.01, 0.03), (0.002, 0.001, 0.001))
TWILL = 'weave = "twill 3/1"\nends_per_cm = 24\npicks_per_cm = 18\n'
DARK = TWILL + '[warp]\ncolor = "#20305c"\n'
# Edits, and what each does to the picture.
PALE = TWILL + '[warp]\ncolor = "#d0d4e4"\n'
DULL = TWILL + '[warp]\ncolor = "#20305c"\nspecular = 0\n'
FLAT = TWILL + '[warp]\ncolor = "#20305c"\nheight_scale = 0.1\n[weft]\nheight_scale = 0.1\n'
OPEN = TWILL + 'gap = 0.6\n[warp]\ncolor = "#20305c"\n'
PLAIN = 'weave = "plain"\nends_per_cm = 22\npicks_per_cm = 20\n[warp]\ncolor = "#e0c060"\n'
BETWEEN = "interreflection = true\n" + PLAIN
REDDER = BETWEEN.replace("#e0c060", "#e06040")
SKY = np.linspace(0.1, 1.0, 8 * 16 * 3).reshape(8, 16, 3)

Step = dict[str, Any]


def _module(folder: Path) -> Path:
    """The built module; skips where the tools that build and run it are missing."""
    npx = shutil.which("npx")
    if npx is None or not (WEB / "node_modules").is_dir():
        pytest.skip("needs Node, and `npm install` in web/: scripts/setup.sh does both")
    command = [npx, "vite", "build", "--config", "loomlight-web/vite.config.ts", "--outDir", str(folder)]
    subprocess.run(command, cwd=WEB, check=True, timeout=120, capture_output=True)
    return folder / "loomlight-web.js"


def _deno() -> str:
    beside = Path(sys.executable).with_name("deno")
    deno = str(beside) if beside.exists() else shutil.which("deno")
    if deno is None:
        pytest.skip("needs Deno, which runs WebGPU without a browser: pip install deno")
    return deno


def _picture(values: NDArray[Any]) -> dict[str, Any]:
    height, width, _ = values.shape
    return {"width": width, "height": height, "pixels": values.ravel().tolist()}


def _piece(text: str) -> dict[str, Any]:
    mesh = {
        "positions": MESH.positions.ravel().tolist(),
        "normals": MESH.normals.ravel().tolist(),
        "uv": MESH.uv.ravel().tolist(),
        "triangles": MESH.faces.ravel().tolist(),
    }
    return {"mesh": mesh, "fabric": text, "uvSizeMm": UV_SIZE_MM}


def _light(light: DirectionalLight | PointLight) -> dict[str, Any]:
    kind = "directional" if isinstance(light, DirectionalLight) else "point"
    return {"kind": kind, **asdict(light)}


STEPS: list[Step] = [
    {
        "model": ["point", 4],
        "pieces": [_piece(DARK)],
        "lights": [_light(SUN)],
        "camera": {"origin": list(CAMERA.origin), "target": list(CAMERA.target)},
        "passes": 2,
    },
    {"fabric": PALE, "passes": 2},
    {"fabric": DULL, "passes": 2},
    {"fabric": FLAT, "passes": 2},
    {"fabric": OPEN, "passes": 2},
    {"fabric": DARK, "lights": [_light(LAMP)], "passes": 2},
    {
        "lights": [],
        "environment": {"picture": _picture(SKY), "turn": 40.0},
        "environmentSamples": 4,
        "passes": 2,
    },
    {"fabric": PLAIN, "passes": 2},
    {"fabric": BETWEEN, "passes": 2},
    {"fabric": REDDER, "passes": 2},
    {"fabric": DARK, "passes": 2},
]
(
    DRAWN,
    BRIGHTER,
    WITHOUT_SHINE,
    FLATTER,
    OPENER,
    BY_LAMP,
    BY_SKY,
    ALONE,
    BETWEEN_YARNS,
    IN_RED,
    _,
) = range(len(STEPS))
LIT_BY_YARNS = (BETWEEN_YARNS, IN_RED)


@dataclass(frozen=True)
class Drawn:
    """What the module drew: a picture a step, linear RGB and cover, and its report."""

    pictures: Sequence[NDArray[np.float32]]
    rest: NDArray[np.float32]
    rebuilt: NDArray[np.float32]
    report: dict[str, Any]


@pytest.fixture(scope="module")
def drawn(tmp_path_factory: pytest.TempPathFactory) -> Drawn:
    try:
        default_adapter()
    except MissingDependencyError as error:
        pytest.skip(str(error))
    folder, deno = tmp_path_factory.mktemp("frames"), _deno()
    module = _module(folder / "module")
    # What the editor's server answers; it is the same for all colours.
    openness = openness_json(fabric_from_text(BETWEEN))
    steps = [
        step | ({"openness": openness} if number in LIT_BY_YARNS else {}) for number, step in enumerate(STEPS)
    ]
    (folder / "scenes.json").write_text(json.dumps([{"size": SIZE, "steps": steps}]))
    script = WEB / "loomlight-web" / "tools" / "render_report.ts"
    command = [
        deno,
        "run",
        "-A",
        "--no-check",
        str(script),
        str(module),
        str(folder / "scenes.json"),
        str(folder),
    ]
    done = subprocess.run(command, cwd=folder, timeout=600, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr

    def picture(name: str) -> NDArray[np.float32]:
        return np.fromfile(folder / f"{name}.linear", np.float32).reshape(SIZE[1], SIZE[0], 4)

    pictures = [picture(f"0.{number}") for number in range(len(STEPS))]
    return Drawn(
        pictures, picture("rest"), picture("rebuilt"), json.loads((folder / "report.json").read_text())
    )


def test_frames_are_those_of_python(drawn: Drawn) -> None:
    """One WGSL on one adapter: pictures differ by what packing rounds, at most the parity bar of shaders."""
    renderer = Renderer([Cloth(MESH, fabric_from_text(DARK), UV_SIZE_MM)], SIZE, "point", bake="gpu")
    sky = {"environment": Environment(SKY, turn=40.0), "environment_samples": 4}
    for number, text, lights, options in (
        (DRAWN, DARK, [SUN], {}),
        (OPENER, OPEN, [SUN], {}),
        (BY_LAMP, DARK, [LAMP], {}),
        (BY_SKY, DARK, [], sky),
        (BETWEEN_YARNS, BETWEEN, [], sky),
        (IN_RED, REDDER, [], sky),
    ):
        renderer.set_fabric(0, fabric_from_text(text))
        ours = renderer.render(CAMERA, lights, passes=2, samples=4, **options).linear
        theirs = drawn.pictures[number]
        close = np.abs(theirs - ours) <= 1e-5 + 1e-3 * np.abs(ours)
        # A ray at the edge of a yarn may meet its neighbour.
        assert close.all(axis=2).mean() > 0.99, number
        assert theirs[..., :3].std() > 0.02, number


def _relief(channel: NDArray[np.float32]) -> float:
    """Mean difference of pixels beside each other, as a share of the mean."""
    steps = np.abs(np.diff(channel, axis=0)).mean() + np.abs(np.diff(channel, axis=1)).mean()
    return float(steps / channel.mean())


def test_controls_change_the_picture_as_they_say(drawn: Drawn) -> None:
    mean = [float(picture[..., :3].mean()) for picture in drawn.pictures]
    relief = [_relief(picture[..., 2]) for picture in drawn.pictures]
    cover = [float(picture[..., 3].mean()) for picture in drawn.pictures]
    assert mean[BRIGHTER] > 1.3 * mean[DRAWN]
    assert mean[WITHOUT_SHINE] < mean[DRAWN]
    assert relief[FLATTER] < 0.8 * relief[DRAWN]
    assert cover[OPENER] < cover[DRAWN] - 0.05


def test_colours_bake_nothing(drawn: Drawn) -> None:
    statistics = drawn.report["statistics"][0]
    for number in (BRIGHTER, WITHOUT_SHINE, BETWEEN_YARNS, IN_RED):
        assert statistics[number]["bakeKernels"] == 0, number
    assert statistics[BY_LAMP]["bakes"] <= 1
    assert drawn.report["complaints"] == []


def test_light_between_yarns_brings_colours_back(drawn: Drawn) -> None:
    """A pale yellow warp is brighter by what yarns send each other, in red more than in blue."""
    alone, between = (drawn.pictures[number][..., :3].mean((0, 1)) for number in (ALONE, BETWEEN_YARNS))
    gain = between / alone
    assert (gain > 1.02).all()
    assert drawn.pictures[IN_RED][..., 2].mean() < between[2]


def test_a_slow_adapter_draws_fewer_pixels_while_the_camera_moves(drawn: Drawn) -> None:
    pace = drawn.report["pace"]
    assert pace["moving"][-1]["width"] < SIZE[0]
    assert pace["resting"][-1]["isComplete"]
    assert pace["resting"][-1]["width"] == SIZE[0]


def test_a_lost_device_is_told_and_drawing_goes_on(drawn: Drawn) -> None:
    loss = drawn.report["loss"]
    assert "lost" in loss["sentence"]
    assert loss["sentence"].endswith(".")
    assert all(not frame["isComplete"] for frame in loss["framesWhileLost"])
    # The scene of the last step, one pass of it.
    assert drawn.rebuilt[..., :3].std() > 0.02
