"""Materials with textures: the fit, the glTF file and the MaterialX document.

Covers: export/fit.py, export/texels.py, export/gltf.py, export/gltf_brdf.py, export/materialx.py
"""

from __future__ import annotations

import json
import os
import shutil
import struct
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from unittest.mock import patch

import MaterialX
import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.core.images import read_picture
from loomlight.core.llvm import require_llvm
from loomlight.export import export, materials
from loomlight.export.gltf_brdf import GltfMaterial, evaluate
from loomlight.export.texels import texels_of, texture_grid
from loomlight.fabric import fabric_from_text
from loomlight.mitsuba import read_mesh

require_llvm()
FABRIC = fabric_from_text(
    'weave = "twill 2/1"\nends_per_cm = 14\npicks_per_cm = 11\n[warp]\ncolor = "#2a4680"\nwidth_mm = 0.6\n'
    "[sheen]\nstrength = 0.3\n"
)
# Khronos' validator, which scripts/setup.sh installs beside Python's packages where there is npm.
_VALIDATE = """
const validator = require('gltf-validator');
const content = new Uint8Array(require('fs').readFileSync(process.argv[1]));
validator.validateBytes(content).then(report => console.log(JSON.stringify(report.issues)));
"""


@pytest.fixture(scope="module", autouse=True)
def one_fit() -> Iterator[None]:
    """All exports here are of one fit."""
    with patch.object(materials, "fitted", cache(materials.fitted)):
        yield


@pytest.fixture(scope="module")
def exported(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The glTF export of a distance, from where a texel is half a thread."""
    return export(FABRIC, "gltf", tmp_path_factory.mktemp("exports") / "gltf", distance=1.0)


def _tree(folder: Path) -> dict:
    content = (folder / "cloth.glb").read_bytes()
    magic, version, length = struct.unpack_from("<4sII", content)
    assert (magic, version, length) == (b"glTF", 2, len(content))
    size = struct.unpack_from("<I", content, 12)[0]
    return json.loads(content[20 : 20 + size])


@pytest.mark.slow
def test_the_file_is_read_again(exported: Path) -> None:
    mesh = read_mesh(exported / "cloth.glb")
    assert np.ptp(mesh.positions, axis=0)[:2] == pytest.approx([0.1, 0.1], rel=1e-5)
    assert mesh.uv.min() == 0
    assert mesh.uv.max() == 1


@pytest.mark.slow
def test_sizes_are_true(exported: Path) -> None:
    material = _tree(exported)["materials"][0]
    width, height = FABRIC.layout().size
    assert material["extras"]["repeat_mm"] == pytest.approx([width, height])
    scale = material["normalTexture"]["extensions"]["KHR_texture_transform"]["scale"]
    assert scale == pytest.approx([100 / width, 100 / height])
    pixels = read_picture(exported / "textures" / "normal.png")
    columns, rows = texture_grid(FABRIC, 1000 * np.radians(26) / 1080)
    assert pixels.shape[:2] == (rows, columns)


@pytest.mark.slow
def test_holes_are_transparent(exported: Path) -> None:
    """0.6 mm of 0.71 mm a warp thread: the cloth has holes."""
    assert _tree(exported)["materials"][0]["alphaMode"] == "BLEND"
    manifest = json.loads((exported / "manifest.json").read_text())
    # The mean over directions is kept; what textures cannot show is parallax and shadows.
    assert manifest["brightness"] == pytest.approx(1, abs=0.05)
    assert manifest["relative_rms_error"] < 0.6


@pytest.mark.slow
def test_khronos_validator_finds_no_fault(exported: Path) -> None:
    command = ["node", "-e", _VALIDATE, str(exported / "cloth.glb")]
    if shutil.which("node") is None:
        pytest.skip("node is not installed; docs/research/notes/export.md has the validator's report.")
    search = os.environ | {"NODE_PATH": str(Path(sys.prefix) / "node_modules")}
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, env=search)
    if "Cannot find module" in done.stderr:
        pytest.skip("npm install gltf-validator is missing; docs/research/notes/export.md has its report.")
    issues = json.loads(done.stdout)
    assert (issues["numErrors"], issues["numWarnings"]) == (0, 0), issues["messages"]


def test_materialx_reads_the_document(tmp_path: Path) -> None:
    folder = export(FABRIC, "materialx", tmp_path / "mtlx", distance=1.0)
    document = MaterialX.createDocument()
    MaterialX.readFromXmlFile(document, str(folder / "cloth.mtlx"))
    (surface,) = document.getNodes("open_pbr_surface")
    assert surface.getInputValue("fuzz_weight") > 0
    names = {node.getInputValue("file") for node in document.getNodeGraph("cloth_textures").getNodes("image")}
    assert all((folder / name).is_file() for name in names)
    assert len(names) == 7


def test_texels_are_means_of_the_surface() -> None:
    texels = texels_of(FABRIC, 12, 9)
    assert np.linalg.norm(texels.normal, axis=-1) == pytest.approx(np.ones((9, 12)))
    assert texels.share.sum(-1)[texels.cover > 0] == pytest.approx(1)
    assert 0.7 < texels.cover.mean() < 1
    # Two of three crossings of a 2/1 twill show the warp.
    assert 0.5 < texels.share[..., 0].mean() < 0.8
    assert np.linalg.eigvalsh(texels.covariance).min() > -1e-12


def test_too_many_texels_are_refused() -> None:
    with pytest.raises(InputError, match="choose a larger distance"):
        texture_grid(FABRIC, 1e-4)


def test_the_gltf_brdf_keeps_energy() -> None:
    """A white surface reflects at most what it gets; sheen takes from what lies below."""
    rng = np.random.default_rng(1)
    count = 200_000
    cosine, azimuth = rng.uniform(0, 1, count), rng.uniform(0, 2 * np.pi, count)
    sine = np.sqrt(1 - cosine**2)
    light = np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), cosine], axis=-1)
    ones = np.ones(count)
    for sheen in (0.0, 0.5):
        for angle in (0.1, 1.2):
            view = np.tile([np.sin(angle), 0.0, np.cos(angle)], (count, 1))
            material = GltfMaterial(
                base=np.ones((count, 3)),
                transmission=0 * ones,
                transmit=np.zeros((count, 3)),
                specular=np.full((count, 3), 0.3),
                weight=0.5,
                alpha_x=0.6 * ones,
                alpha_y=0.4 * ones,
                normal=np.tile([0.0, 0, 1], (count, 1)),
                axis_x=np.tile([1.0, 0, 0], (count, 1)),
                axis_y=np.tile([0.0, 1, 0], (count, 1)),
                sheen=np.full(3, sheen),
                sheen_roughness=0.6,
            )
            albedo = evaluate(material, light, view).mean() * 2 * np.pi
            # 0.02 is noise and what the table of the sheen's albedo rounds.
            assert 0.7 < albedo < 1.02
