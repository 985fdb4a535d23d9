"""The exported decoders compute what `neural` and `latent` compute.

Covers: exporters/networks.py
"""

from __future__ import annotations

import json
import re
import runpy
import subprocess
import sys
from pathlib import Path

import numpy as np
import onnxruntime
import pytest
from drjit.llvm.ad import Array2f, Array3f, Float
from safetensors.numpy import load_file

from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.exporters import export
from loomlight.fabric import fabric_from_text
from loomlight.models.neural import model as model_module
from loomlight.models.neural.encoded_fabric import Level, taps
from loomlight.models.neural.weights import shipped_decoder, shipped_weights
from loomlight.models.registry import make_model
from studies.papers.chen2024.training.decoder import decoder_model
from tests.helpers.arrays import vectors
from tests.helpers.directions import clear_of_the_plane
from tests.helpers.parity import share_beyond
from tests.helpers.shader_cases import bsdf_of, footprint_rows
from tests.helpers.untrained import random_latent
from tests.marks import slow

require_llvm()
FABRIC = fabric_from_text('weave = "twill 2/1"\nends_per_cm = 14\npicks_per_cm = 11\n')
COUNT = 500


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return export(FABRIC, "onnx", tmp_path_factory.mktemp("exports") / "onnx")


@pytest.mark.slow
def test_the_decoder_computes_what_neural_computes(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    nothing = Array2f(0, 0)
    # One tap a footprint, as the page of instructions has it.
    monkeypatch.setattr(model_module, "taps_of_footprint", lambda f, _: (f.spread_side, nothing, nothing))
    rng = np.random.default_rng(2)
    light, view = clear_of_the_plane(rng, COUNT), clear_of_the_plane(rng, COUNT)
    back = view[:, 2] < 0
    pitch = json.loads((folder / "manifest.json").read_text())["mean_pitch_mm"]
    size = np.float32(10 ** rng.uniform(-1, 1, COUNT))
    x, y = np.float32(rng.uniform(0, 5, (2, COUNT)))
    zero = np.zeros(COUNT, np.float32)
    footprint = Footprint(Array2f(x, y), Array2f(size, zero), Array2f(zero, size))
    to_vector = [Array3f(*np.ascontiguousarray(rows.T)) for rows in (view, light)]
    model = make_model("neural", FABRIC)
    at = model.at(to_vector[0], footprint)
    found = at.components(to_vector[1])
    # Where views meet yarn is asked of the program below.
    read, _, _ = model.query(to_vector[0], footprint)
    x, y = read.x.numpy(), read.y.numpy()
    names = ("diffuse_warp", "diffuse_weft", "specular_warp", "specular_weft")
    expected = np.stack([getattr(found, name).numpy() for name in names], axis=-1)
    hole = Float(at.hole).numpy()

    components, holes = np.empty((COUNT, 4)), np.empty(COUNT)
    for side, face in ((back, "back"), (~back, "front")):
        rows = np.flatnonzero(side)
        answer = _decoded(folder, face, x[rows], y[rows], size[rows] / pitch, light[rows], view[rows])
        components[rows], holes[rows] = answer
    # Sums of 64 products in another order, behind an exponential.
    np.testing.assert_allclose(components, expected, rtol=2e-3, atol=2e-4)
    np.testing.assert_allclose(holes, hole, atol=1e-4)
    assert components.max() > 0.1


# Threads of several colours, highlights that rise, sheen, and light between yarns or none.
STRIPES = """weave = "twill 2/1"
ends_per_cm = 14
picks_per_cm = 11
gap = 0.3
[warp]
color = ["#b03020", "#203060", "#e0e0c0"]
specular = 0.8
specular_grazing = 4
[weft]
color = ["#104020", "#f0f0f0"]
translucency = 0.3
"""


@pytest.mark.parametrize(
    "text",
    [
        STRIPES + "[sheen]\nstrength = 0.6\nroughness = 0.3\n",
        slow(STRIPES),
        slow("interreflection = false\n" + STRIPES),
    ],
)
def test_the_program_in_the_folder_computes_colours(text: str, tmp_path: Path) -> None:
    """colour.py, which has nothing of loomlight, against the model: both faces, both sides of the light."""
    fabric = fabric_from_text(text)
    program = runpy.run_path(str(export(fabric, "onnx", tmp_path / "onnx") / "colour.py"))
    rng = np.random.default_rng(5)
    light, view = clear_of_the_plane(rng, COUNT), clear_of_the_plane(rng, COUNT)
    centre = rng.uniform(-4, 6, (COUNT, 2))
    side = 10 ** rng.uniform(-1.5, 1.5, COUNT)
    actual = program["Cloth"](tmp_path / "onnx").value(centre, side, light, view)
    zero, sides = np.zeros(COUNT, np.float32), np.float32(side)
    footprint = Footprint(Array2f(*np.float32(centre).T), Array2f(sides, zero), Array2f(zero, sides))
    to_vector = [Array3f(*np.ascontiguousarray(rows.T)) for rows in (view, light)]
    expected = np.array(make_model("neural", fabric).at(to_vector[0], footprint).value(to_vector[1])).T
    threads = side / json.loads((tmp_path / "onnx" / "manifest.json").read_text())["mean_pitch_mm"]
    large = threads > 2
    # As the decoder's: sums in another order, behind an exponential.
    np.testing.assert_allclose(actual[large], expected[large], rtol=3e-3, atol=3e-4)
    # Heights have 16 texels a thread and no sides of yarns, so rays end a little elsewhere: .07 and .02 off.
    for chosen, most in ((threads < 0.25, 0.12), (~large & (threads > 0.25), 0.04)):
        missed = np.abs(actual[chosen] - expected[chosen]).sum() / expected[chosen].sum()
        assert missed < most
    assert expected.max() > 0.1
    assert np.abs(expected[:, 0] - expected[:, 2]).max() > 0.01


def test_the_program_is_run_in_its_folder(folder: Path) -> None:
    """Without loomlight: it imports NumPy and ONNX Runtime alone."""
    program = (folder / "colour.py").read_text()
    assert set(re.findall(r"^(?:import|from) (\w+)", program, re.MULTILINE)) <= {
        *("__future__", "json", "pathlib", "typing"),
        *("numpy", "onnxruntime"),
    }
    done = subprocess.run([sys.executable, "-I", "colour.py"], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert len(done.stdout.splitlines()) == 8
    assert "0°: [" in done.stdout


def _decoded(
    folder: Path,
    face: str,
    x: np.ndarray,
    y: np.ndarray,
    size: np.ndarray,
    light: np.ndarray,
    view: np.ndarray,
) -> tuple[np.ndarray, np.ndarray]:
    """What a program would do that has nothing of loomlight, but for `taps`, which README.md describes."""
    manifest = json.loads((folder / "manifest.json").read_text())
    tensors = load_file(folder / "latents.safetensors")
    last = len(manifest["levels"]) - 1
    levels = [
        Level(
            level["first"],
            level["columns"],
            level["rows"],
            0 if k == last else 2.0 ** (k - 3),
            level["per_thread"],
        )
        for k, level in enumerate(manifest["levels"])
    ]
    turned = np.float32([1, 1, -1 if face == "back" else 1])
    index, weight = taps(levels, np.float32(x), np.float32(y), np.float32(size))
    latent = (tensors[f"{face}.latents"].astype(np.float32)[index] * weight[..., None]).sum(1)
    coordinates = [x - np.floor(x), y - np.floor(y), np.clip(np.log(64 * size) / np.log(5120), 0, 1)]
    inputs = {
        "latent": latent,
        "coordinates": np.stack(coordinates, axis=-1),
        "light": light * turned,
        "view": view * turned,
        "fibres": tensors[f"{face}.fibres"],
        "bundles": tensors[f"{face}.bundles"],
        "correction": tensors["correction"],
    }
    session = onnxruntime.InferenceSession(folder / "decoder.onnx", providers=["CPUExecutionProvider"])
    components, hole = session.run(None, {name: np.float32(values) for name, values in inputs.items()})
    return components, hole


def test_the_shipped_decoder_is_exported_from_the_shipped_weights() -> None:
    """Another version of torch may order nodes in another way."""
    weights = shipped_weights()
    rng = np.random.default_rng(3)
    answers = []
    for model in (shipped_decoder(), decoder_model(weights)):
        session = onnxruntime.InferenceSession(model, providers=["CPUExecutionProvider"])
        shapes = {
            entry.name: [3 if side == "queries" else side for side in entry.shape]
            for entry in session.get_inputs()
        }
        inputs = {name: np.float32(rng.uniform(0.1, 1, shape)) for name, shape in shapes.items()}
        answers.append(session.run(None, inputs))
        rng = np.random.default_rng(3)
    for first, second in zip(*answers, strict=True):
        np.testing.assert_allclose(first, second, rtol=1e-4, atol=1e-6)


@pytest.mark.quick("True-True")
@pytest.mark.parametrize(("frames", "features"), [(True, True), (False, True), (True, False)])
def test_the_decoder_computes_what_latent_computes(frames: bool, features: bool, tmp_path: Path) -> None:
    """On the query set of the shaders' parity, whose bar this is too."""
    model = random_latent(frames=frames, features=features)
    folder = export(model, "onnx", tmp_path / "onnx")
    rows = footprint_rows(4096, 2)
    at = bsdf_of(model, rows)
    facing = {
        name: rows[name] * np.where(rows["view"][:, 2:] < 0, [1, 1, -1], 1) for name in ("light", "view")
    }
    session = onnxruntime.InferenceSession(folder / "decoder.onnx")
    given = {"latent": np.array(at._latent).T, **facing}
    asked = {name: np.float32(values) for name, values in given.items()}
    (found,) = session.run(None, asked)
    assert share_beyond(found, np.array(at.value(vectors(rows["light"]))).T) == 0
    session = onnxruntime.InferenceSession(folder / "auxiliary.onnx")
    albedo, roughness, normal = session.run(["albedo", "roughness", "normal"], {"latent": asked["latent"]})
    guides = at.auxiliary
    assert share_beyond(albedo, np.array(guides.albedo).T) == 0
    assert share_beyond(roughness[:, 0], np.array(guides.roughness)) == 0
    mirror = np.where(rows["view"][:, 2:] < 0, [1, 1, -1], 1)
    np.testing.assert_allclose(mirror * normal, np.array(guides.normal).T, atol=1e-5)
    latents = load_file(folder / "latents.safetensors")["latents"]
    manifest = json.loads((folder / "manifest.json").read_text())
    assert manifest["model"] == "latent"
    last = manifest["levels"][-1]
    assert latents.shape == (2, last["first"] + 1, 8)
