"""Materials with textures: the fit, the glTF file and the MaterialX document.

Covers: exporters/fit.py, exporters/texels.py, exporters/gltf.py
Covers: exporters/materialx.py
"""

from __future__ import annotations

import json
import struct
from collections.abc import Iterator
from dataclasses import fields, replace
from functools import cache
from pathlib import Path
from unittest.mock import patch

import MaterialX
import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.core.images import read_picture
from loomlight.core.llvm import require_llvm
from loomlight.exporters import export, materials
from loomlight.exporters.fit import FittedMaterial
from loomlight.exporters.gltf import glb_of, material_textures, write_textures
from loomlight.exporters.materialx import document_textures, write_document
from loomlight.exporters.standards import StandardMaterial, evaluate_gltf
from loomlight.exporters.texels import TexelGrid, nearest_covered, texture_grid, tile_repeats
from loomlight.fabric import fabric_from_text
from loomlight.mitsuba import read_mesh
from tests.helpers.validators import khronos_issues

from .generated_glsl import answers

require_llvm()
FABRIC = fabric_from_text(
    'weave = "twill 2/1"\nends_per_cm = 14\npicks_per_cm = 11\n[warp]\ncolor = "#2a4680"\nwidth_mm = 0.6\n'
    "[sheen]\nstrength = 0.3\n"
)


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
    # The scale of its textures is in the uv that the reader gives: whole repeats along 100 mm.
    assert mesh.uv.min() == 0
    assert mesh.uv.max(axis=0) == pytest.approx(100 / np.array(FABRIC.layout().size))


@pytest.mark.slow
def test_sizes_are_true(exported: Path) -> None:
    material = _tree(exported)["materials"][0]
    width, height = FABRIC.layout().size
    assert material["extras"]["repeat_mm"] == pytest.approx([width, height])
    scale = material["normalTexture"]["extensions"]["KHR_texture_transform"]["scale"]
    assert scale == pytest.approx([100 / width, 100 / height])
    pixels = read_picture(exported / "textures" / "normal.png")
    columns, rows, _ = texture_grid(FABRIC, 1000 * np.radians(26) / 1080)
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
    issues = khronos_issues(exported / "cloth.glb")
    assert (issues["numErrors"], issues["numWarnings"]) == (0, 0), issues["messages"]


@pytest.mark.slow
def test_materialx_reads_the_document(tmp_path: Path) -> None:
    folder = export(FABRIC, "materialx", tmp_path / "mtlx", distance=1.0)
    document = MaterialX.createDocument()
    MaterialX.readFromXmlFile(document, str(folder / "cloth.mtlx"))
    (surface,) = document.getNodes("open_pbr_surface")
    assert surface.getInputValue("fuzz_weight") > 0
    names = {node.getInputValue("file") for node in document.getNodeGraph("cloth_textures").getNodes("image")}
    assert all((folder / name).is_file() for name in names)
    assert len(names) == 6


def _plain(shape: tuple[int, int] = (2, 3), **changes: object) -> FittedMaterial:
    """A material of the same values everywhere; highlights are wide along y."""
    vectors = {"normal": [0, 0, 1], "axis_x": [0, 1, 0], "axis_y": [-1, 0, 0], "direction": [0, 1]}
    colours = {"base": [0.3, 0.35, 0.4], "transmit": [0.5, 0.3, 0.1], "specular": [1.0, 0.8, 0.6]}
    numbers = {"transmission": 0.3, "alpha_x": 0.6, "alpha_y": 0.15, "cover": 0.9, "height": 0.0}
    arrays = {
        name: np.broadcast_to(np.asarray(value, float), (*shape, *np.shape(value)))
        for name, value in (vectors | colours | numbers | changes).items()
    }
    return FittedMaterial(
        **arrays,
        weight=0.2,
        sheen=np.zeros(3),
        sheen_roughness=0.5,
        size=(1.0, 1.0),
        error=0.0,
        brightness=1.0,
    )


def _generated_and_fitted(
    folder: Path, light: np.ndarray, view: np.ndarray, sheen: float = 0.0
) -> tuple[np.ndarray, np.ndarray]:
    """f·cos of the GLSL that MaterialX generates and of the material, for each light and view."""
    material = replace(_plain(), sheen=np.full(3, sheen), sheen_roughness=0.4)
    write_textures(folder, document_textures(material))
    write_document(folder / "cloth.mtlx", "sateen", material)
    light, view = np.broadcast_arrays(light, view)
    row = column = np.zeros(len(light), np.int64)
    names = (field.name for field in fields(StandardMaterial))
    picked = {
        name: value if np.ndim(value) < 2 else value[row, column]
        for name, value in ((name, getattr(material, name)) for name in names)
    }
    fitted = evaluate_gltf(StandardMaterial(**picked), light, view)
    return answers(folder / "cloth.mtlx", row, column, light, view), fitted * material.cover[0, 0]


def _tilted(degrees: float, axis: int) -> np.ndarray:
    vector = np.array([0.0, 0, np.cos(np.radians(degrees))])
    vector[axis] = np.sin(np.radians(degrees))
    return vector


def _cosines(count: int) -> np.ndarray:
    rng = np.random.default_rng(5)
    cosine, azimuth = np.sqrt(rng.uniform(0.1, 1, count)), rng.uniform(0, 2 * np.pi, count)
    sine = np.sqrt(1 - cosine**2)
    return np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), cosine], axis=-1)


@pytest.mark.slow
def test_generated_glsl_shines_along_the_axes_of_the_fit(tmp_path: Path) -> None:
    """Reflectance and shadowing of the two standards differ: a fifth of each value.

    Without the tangent, or with glTF's roughness, values are wrong by factors of 2 to 9.
    """
    light = np.array([_tilted(20 + offset, axis) for axis in (0, 1) for offset in (0, 15, 30)])
    view = np.array([_tilted(-20, axis) for axis in (0, 1) for _ in range(3)])
    generated, fitted = _generated_and_fitted(tmp_path, light, view)
    assert generated == pytest.approx(fitted, rel=0.2)
    assert fitted[5].max() > 2 * fitted[2].max()


@pytest.mark.slow
def test_generated_glsl_passes_as_much_light_as_the_fit(tmp_path: Path) -> None:
    """In each channel, in the mean over views: to what is taken for the share of the gloss above, a tenth."""
    view = _cosines(1000)
    generated, fitted = _generated_and_fitted(tmp_path, _tilted(180, 0), view)
    assert generated.mean(0) == pytest.approx(fitted.mean(0), rel=0.1)


@pytest.mark.slow
def test_generated_glsl_reflects_as_the_fit_in_the_mean(tmp_path: Path) -> None:
    """OpenPBR's reflectance rises more at grazing angles: a tenth and a half."""
    directions = _cosines(4000)
    generated, fitted = _generated_and_fitted(tmp_path, directions[:2000], directions[2000:])
    assert generated.mean(0) == pytest.approx(fitted.mean(0), rel=0.15)


@pytest.mark.slow
@pytest.mark.parametrize("sheen", [0.15, 0.5])
def test_fuzz_keeps_the_brightness_of_sheen(tmp_path: Path, sheen: float) -> None:
    """OpenPBR's fuzz darkens what lies below it, and what it gives back has its own colour (OpenPBR #176).

    It is another lobe than glTF's sheen: the mean over directions may differ as without either.
    """
    directions = _cosines(4000)
    generated, fitted = _generated_and_fitted(tmp_path, directions[:2000], directions[2000:], sheen)
    assert generated.mean(0) == pytest.approx(fitted.mean(0), rel=0.15)
    (tmp_path / "bare").mkdir()
    bare, _ = _generated_and_fitted(tmp_path / "bare", directions[:2000], directions[2000:])
    assert (generated.mean(0) > 0.98 * bare.mean(0)).all()


def test_holes_hold_the_colour_beside_them() -> None:
    """Filters between texels mix in what holes hold: never black."""
    yarns = "[warp]\nwidth_mm = 0.3\n[weft]\nwidth_mm = 0.3\n"
    net = fabric_from_text(f'weave = "plain"\nends_per_cm = 10\npicks_per_cm = 10\n{yarns}')
    texels = next(TexelGrid(net, 16, 16, (1, 1)).bands())
    cover = texels.cover.reshape(16, 16)
    holes = cover < 0.02
    assert holes.any()
    index = nearest_covered(cover)
    assert texels.diffuse[index][holes].max(-1).max(-1).min() > 0.1
    assert (index[~holes] == np.arange(256).reshape(16, 16)[~holes]).all()


def test_a_texture_without_anisotropy_is_left_out() -> None:
    material = _plain(alpha_x=1.0, alpha_y=1.0)
    textures = material_textures(material)
    assert "anisotropy" not in textures
    content = glb_of("rough", material, textures)
    assert b"KHR_materials_anisotropy" not in content


def test_texels_are_means_of_the_surface() -> None:
    texels = next(TexelGrid(FABRIC, 12, 9, (1, 1)).bands())
    assert np.linalg.norm(texels.normal, axis=-1) == pytest.approx(np.ones(108))
    assert texels.share.sum(-1)[texels.cover > 0] == pytest.approx(1)
    assert 0.7 < texels.cover.mean() < 1
    # Two of three crossings of a 2/1 twill show the warp.
    assert 0.5 < texels.share[..., 0].mean() < 0.8
    assert np.linalg.eigvalsh(texels.covariance).min() > -1e-12


def test_textures_hold_what_uneven_yarns_show() -> None:
    """Several repeats of wool, whose threads differ in colour and wander; of even yarns one."""
    wool = fabric_from_text(
        'weave = "plain"\nends_per_cm = 10\npicks_per_cm = 10\nwarp.yarn = "wool"\nweft.yarn = "wool"\n'
        "[variation]\ncolour_noise = 0.3\n"
    )
    assert tile_repeats(FABRIC, None) == (1, 1)
    grid = TexelGrid(wool, 48, 48, (12, 12))
    assert grid.size == pytest.approx((24, 24))
    texels = next(grid.bands())
    warp = texels.diffuse[..., 0, 0][texels.share[..., 0] > 0.9]
    # Uniform in 1 ± 0.3, and slubs and gaps beside.
    assert 0.15 < warp.std() / warp.mean() < 0.3
    row, column = np.divmod(np.arange(48 * 48), 48) + np.array(0.5)
    step = (grid.places(row, column) - np.stack([column, row]) / 2).T.reshape(48, 48, 2)
    assert 0.02 < step.std() < 0.1
    assert np.abs(step[0] - step[-1]).max() < 0.1


def test_textures_of_uneven_yarns_are_as_large_as_texels_allow() -> None:
    """1024 texels a side, of threads of a millimetre, and a million crossings; not fewer than 24 threads."""
    wool = fabric_from_text('weave = "plain"\nends_per_cm = 10\npicks_per_cm = 10\nyarn = "wool"\n')
    for texel, threads in ((None, 128), (0.5, 512), (1.0, 1024), (4.0, 1024), (0.01, 24)):
        assert tile_repeats(wool, texel) == (threads // 2, threads // 2)
        columns, rows, _ = texture_grid(wool, texel)
        assert max(columns, rows) <= max(1024, 24 / (texel or 1))


def test_too_many_texels_are_refused() -> None:
    with pytest.raises(InputError, match="choose a larger distance"):
        texture_grid(FABRIC, 1e-4)


def _rough_white(count: int, sheen: float) -> StandardMaterial:
    ones = np.ones(count)
    return StandardMaterial(
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


def test_sheen_dims_what_lies_below_alike_from_both_directions() -> None:
    """Khronos and three.js since r182 take the larger of both albedos, so that the material is reciprocal."""
    rng = np.random.default_rng(2)
    light, view = (_cosines(500) for _ in range(2))
    view = view[rng.permutation(500)]
    material = _rough_white(500, 0.5)
    there = evaluate_gltf(material, light, view) / light[:, 2:]
    back = evaluate_gltf(material, view, light) / view[:, 2:]
    np.testing.assert_allclose(there, back, rtol=1e-9)


def test_the_gltf_brdf_keeps_energy() -> None:
    """A white surface reflects at most what it gets; sheen takes from what lies below."""
    rng = np.random.default_rng(1)
    count = 200_000
    cosine, azimuth = rng.uniform(0, 1, count), rng.uniform(0, 2 * np.pi, count)
    sine = np.sqrt(1 - cosine**2)
    light = np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), cosine], axis=-1)
    for sheen in (0.0, 0.5):
        for angle in (0.1, 1.2):
            view = np.tile([np.sin(angle), 0.0, np.cos(angle)], (count, 1))
            material = _rough_white(count, sheen)
            albedo = evaluate_gltf(material, light, view).mean() * 2 * np.pi
            # 0.02 is noise and what the table of the sheen's albedo rounds.
            assert 0.7 < albedo < 1.02
