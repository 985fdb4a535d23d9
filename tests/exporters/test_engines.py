"""Packs for engines: channels, handedness of normals, powers of two, sizes, and their settings files.

Covers: exporters/engines.py
"""

from __future__ import annotations

import json
import math
import re
import runpy
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import Any
from unittest.mock import MagicMock

import numpy as np
import pytest
from PIL import Image

from loomlight.core.colour import srgb_to_linear
from loomlight.exporters import engines, export
from loomlight.exporters.engines import ENGINES, power_of_two
from loomlight.exporters.fit import FittedMaterial
from loomlight.exporters.metal_rough import ENGINES_RISE, metal_rough
from loomlight.exporters.texels import TextureSize
from tests.helpers.standard_materials import plain_material

# A normal that leans to the right and up, and α of 0.36: a roughness of 0.6.
LEANING = np.array([0.36, 0.48, 0.8])
FABRIC = "twill 2/1"
OPENGL, DIRECTX = np.round(255 * (0.5 + 0.5 * LEANING)), np.round(255 * (0.5 + 0.5 * LEANING * [1, -1, 1]))


def fit(fabric: Any, model: Any, size: TextureSize, cover: float = 1.0) -> FittedMaterial:
    """Of `near` 4 × 8 mm, of `far`, which is made second and has fewer texels, 40 × 80."""
    return plain_material(
        size=(4.0, 8.0) if size.columns > 16 else (40.0, 80.0),
        shape=(size.rows, size.columns),
        normal=LEANING,
        alpha_x=0.36,
        alpha_y=0.36,
        cover=cover,
        sheen=np.full(3, 0.25),
    )


@pytest.fixture
def dense(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every fabric has the same material, which takes no fit."""
    monkeypatch.setattr(engines, "fit_material", fit)
    monkeypatch.setattr(engines, "make_model", lambda model, fabric: None)


@pytest.fixture
def net(monkeypatch: pytest.MonkeyPatch) -> None:
    """The same with holes."""
    monkeypatch.setattr(engines, "fit_material", lambda *given: fit(*given, cover=0.5))
    monkeypatch.setattr(engines, "make_model", lambda model, fabric: None)


def pixels(file: Path) -> np.ndarray:
    """The first pixel, 0 to 255."""
    return np.asarray(Image.open(file))[0, 0].astype(int)


@pytest.mark.usefixtures("dense")
@pytest.mark.parametrize("engine", ENGINES)
def test_every_pack_holds_two_densities_of_powers_of_two(engine: str, tmp_path: Path) -> None:
    folder = export(FABRIC, engine, tmp_path / "out", distance=2.0)
    manifest = json.loads((folder / "manifest.json").read_text())
    assert set(manifest["files"]) == {
        str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file()
    } - {"manifest.json"}
    assert manifest["densities"]["near"]["distance_m"] is None
    assert manifest["densities"]["far"]["distance_m"] == 2.0
    for label, found in manifest["densities"].items():
        sides = {Image.open(file).size for file in (folder / label).glob("*.png")}
        assert sides == {tuple(found["texels"])}
        assert all(side & (side - 1) == 0 for side in found["texels"])
        assert np.multiply(found["texels"], found["texel_mm"]) == pytest.approx(found["repeat_mm"])
        assert found["repeat_mm"] == ([4, 8] if label == "near" else [40, 80])
    assert manifest["densities"]["near"]["texels"] > manifest["densities"]["far"]["texels"]


@pytest.mark.usefixtures("dense")
@pytest.mark.parametrize("engine", ENGINES)
def test_instructions_say_the_size_and_leave_nothing_open(engine: str, tmp_path: Path) -> None:
    folder = export(FABRIC, engine, tmp_path / "out")
    text = (folder / "README.md").read_text()
    assert "{{" not in text
    assert "| 4 × 8 |" in text
    assert "| 40 × 80 |" in text
    assert "about 1 m away" in text
    assert all(
        "{{" not in file.read_text() for file in folder.rglob("*") if file.suffix != ".png" and file.is_file()
    )


@pytest.mark.usefixtures("dense")
@pytest.mark.parametrize(
    ("engine", "name", "normal"),
    [
        ("unreal", "near/T_Twill21_Near_N.png", DIRECTX),
        ("unity", "near/Twill21_Near_Normal.png", OPENGL),
        ("godot", "near/twill-2-1_near_normal.png", OPENGL),
        ("threejs", "near/normal.png", OPENGL),
    ],
)
def test_normals_have_the_hand_of_the_engine(
    engine: str, name: str, normal: np.ndarray, tmp_path: Path
) -> None:
    folder = export(FABRIC, engine, tmp_path / "out")
    assert pixels(folder / name) == pytest.approx(normal, abs=1)


@pytest.mark.usefixtures("dense")
@pytest.mark.parametrize(
    ("engine", "name", "channels"),
    [
        ("unreal", "near/T_Twill21_Near_ORM.png", [255, 153, 0]),
        ("unity", "near/Twill21_Near_MaskMap.png", [0, 255, 0, 102]),
        ("godot", "near/twill-2-1_near_orm.png", [255, 153, 0]),
        ("threejs", "near/roughness.png", [0, 153, 0]),
    ],
)
def test_channels_are_packed_as_the_engine_reads_them(
    engine: str, name: str, channels: list[int], tmp_path: Path
) -> None:
    """A roughness of 0.6, no metal, no occlusion; Unity has smoothness in alpha."""
    assert list(pixels(export(FABRIC, engine, tmp_path / "out") / name)) == channels


@pytest.mark.parametrize(
    ("engine", "name"),
    [
        ("unreal", "near/T_Twill21_Near_BC.png"),
        ("unity", "near/Twill21_Near_BaseMap.png"),
        ("godot", "near/twill-2-1_near_albedo.png"),
        ("threejs", "near/base_color.png"),
    ],
)
def test_colours_are_srgb_with_opacity_where_there_are_holes(
    engine: str, name: str, tmp_path: Path, request: pytest.FixtureRequest
) -> None:
    request.getfixturevalue("net")
    found = pixels(export(FABRIC, engine, tmp_path / "net") / name)
    assert found[3] in (127, 128)
    expected = metal_rough(fit(None, None, TextureSize(1, 1, (1, 1))), ENGINES_RISE).base[0, 0]
    if engine == "threejs":  # which has sheen and transmission apart
        expected = 0.7 * np.array([0.3, 0.35, 0.4])
    # Half a step of 8 bits.
    assert srgb_to_linear(found[:3] / 255) == pytest.approx(expected, abs=3e-3)
    request.getfixturevalue("dense")
    assert len(pixels(export(FABRIC, engine, tmp_path / "dense") / name)) == 3


def test_packs_are_the_same_material_as_each_engine_reads_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Unlike texels, read by the documented channels, hands of normals and spaces of colours."""

    def varied(fabric: Any, model: Any, size: TextureSize) -> FittedMaterial:
        rng = np.random.default_rng(3)
        shape = (size.rows, size.columns)
        normal = rng.normal(size=(*shape, 3)) * [0.3, 0.3, 0] + [0, 0, 1]
        return plain_material(
            shape=shape,
            base=rng.uniform(0.1, 0.6, (*shape, 3)),
            normal=normal / np.linalg.norm(normal, axis=-1, keepdims=True),
            alpha_x=(alpha := rng.uniform(0.1, 1, shape)),
            alpha_y=alpha,
            cover=rng.uniform(0.2, 1, shape),
        )

    monkeypatch.setattr(engines, "fit_material", varied)
    monkeypatch.setattr(engines, "make_model", lambda model, fabric: None)

    def picture(engine: str, name: str) -> np.ndarray:
        return np.asarray(Image.open(tmp_path / engine / "near" / name), int)

    for engine in ("unreal", "unity", "godot"):
        export(FABRIC, engine, tmp_path / engine)
    # Godot: OpenGL's normals, roughness in green.
    colour = picture("godot", "twill-2-1_near_albedo.png")
    normal = picture("godot", "twill-2-1_near_normal.png")
    rough = picture("godot", "twill-2-1_near_orm.png")[..., 1]
    # Unreal: DirectX's normals, roughness in green.
    assert (picture("unreal", "T_Twill21_Near_BC.png") == colour).all()
    assert (picture("unreal", "T_Twill21_Near_ORM.png")[..., 1] == rough).all()
    turned = picture("unreal", "T_Twill21_Near_N.png")
    assert (turned[..., [0, 2]] == normal[..., [0, 2]]).all()
    assert np.abs(255 - turned[..., 1] - normal[..., 1]).max() <= 1
    # Unity: OpenGL's normals, smoothness in alpha.
    assert (picture("unity", "Twill21_Near_BaseMap.png") == colour).all()
    assert (picture("unity", "Twill21_Near_Normal.png") == normal).all()
    assert np.abs(255 - picture("unity", "Twill21_Near_MaskMap.png")[..., 3] - rough).max() <= 1
    assert np.ptp(rough) > 100


def test_sides_are_the_nearest_powers_of_two() -> None:
    assert [power_of_two(side) for side in (1, 20, 45, 46, 192, 5000)] == [16, 16, 32, 64, 256, 4096]


@pytest.mark.usefixtures("net")
def test_godots_materials_name_their_textures_and_sizes(tmp_path: Path) -> None:
    folder = export(FABRIC, "godot", tmp_path / "out")
    for label in ("near", "far"):
        text = (folder / f"twill-2-1_{label}.tres").read_text()
        header, resources = re.match(r"\[gd_resource type=\"(\w+)\" load_steps=(\d+) format=3\]", text), {}
        for path, number in re.findall(r'\[ext_resource type="Texture2D" path="([^"]+)" id="(\w+)"\]', text):
            assert (folder / path).is_file()
            resources[number] = path
        assert header is not None
        assert (header[1], int(header[2])) == ("StandardMaterial3D", len(resources) + 1)
        used = set(re.findall(r'ExtResource\("(\w+)"\)', text))
        assert used == set(resources)
        # Of uv in metres, and of a material with holes, which writes depth before it blends.
        scale = "250.0000, 125.0000" if label == "near" else "25.0000, 12.5000"
        assert f"uv1_scale = Vector3({scale}, 1)" in text
        assert "transparency = 4" in text
        specular = float(re.search(r"metallic_specular = ([\d.]+)", text)[1])
        assert 0.16 * specular**2 == pytest.approx(
            metal_rough(fit(None, None, TextureSize(1, 1, (1, 1))), ENGINES_RISE).reflectance, abs=1e-3
        )


@pytest.mark.usefixtures("dense")
def test_godot_makes_smaller_copies_and_knows_normals(tmp_path: Path) -> None:
    folder = export(FABRIC, "godot", tmp_path / "out")
    pictures = sorted(folder.rglob("*.png"))
    assert pictures
    for picture in pictures:
        text = picture.with_name(f"{picture.name}.import").read_text()
        assert "mipmaps/generate=true" in text
        is_normal = picture.name.endswith("_normal.png")
        assert f"compress/normal_map={1 if is_normal else 2}\n" in text


@pytest.mark.usefixtures("dense")
def test_godots_highlights_are_wide_where_those_of_the_fit_are(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert not list(export(FABRIC, "godot", tmp_path / "even").rglob("*_flow.png"))
    silk = replace(fit(None, None, TextureSize(16, 16, (1, 1))), alpha_x=np.full((16, 16), 0.6))
    silk = replace(silk, alpha_y=np.full((16, 16), 0.15), direction=np.tile([0.0, 1.0], (16, 16, 1)))
    monkeypatch.setattr(engines, "fit_material", lambda *given: silk)
    folder = export(FABRIC, "godot", tmp_path / "silk")
    flow = pixels(folder / "near" / "twill-2-1_near_flow.png") / 255
    assert flow[:2] == pytest.approx([0.5, 1], abs=1 / 255)
    # Godot's α along the direction is α / √(1 − 0.9 a), across it α √(1 − 0.9 a).
    alpha = (pixels(folder / "near" / "twill-2-1_near_orm.png")[1] / 255) ** 2
    aspect = np.sqrt(1 - 0.9 * flow[3])
    assert [alpha / aspect, alpha * aspect] == pytest.approx([0.6, 0.15], rel=0.02)  # of 8 bits


@pytest.mark.parametrize("specular", [0.01, 0.05, 0.2])
@pytest.mark.parametrize("weight", [0.05, 0.3, 1.0])
@pytest.mark.parametrize("times", [ENGINES_RISE, math.inf])
def test_gloss_keeps_its_mean_by_the_formula_of_a_program(
    specular: float, weight: float, times: float
) -> None:
    """Schlick's rise to 50 times the reflectance, at most 1, or always to 1; the rest is in the base."""
    material = fit(None, None, TextureSize(1, 1, (1, 1)))
    colour = replace(material, specular=np.full((1, 1, 3), specular), weight=weight, sheen=np.zeros(3))
    found = metal_rough(colour, times)
    cosine = (np.arange(4096) + 0.5) / 4096
    schlick = float((2 * cosine * (1 - cosine) ** 5).mean())
    grazing = 1 if math.isinf(times) else min(times * found.reflectance, 1)
    rise = grazing - found.reflectance
    added = float((found.base - colour.base * (1 - colour.transmission)[..., None]).max())
    expected = weight * (specular + (1 - specular) * schlick)
    # Where all is reflected at grazing angles, the mean is that of the rise alone at least.
    least = schlick if math.isinf(times) else 0.0
    assert found.reflectance + rise * schlick + added == pytest.approx(max(expected, least), rel=1e-3)


@pytest.mark.usefixtures("dense")
def test_unity_imports_as_it_must(tmp_path: Path) -> None:
    folder = export(FABRIC, "unity", tmp_path / "out")
    settings = {}
    for file in folder.rglob("*.png.meta"):
        text = file.read_text()
        settings[file.name] = {
            name: re.search(rf"{name}: (\w+)", text)[1] for name in ("guid", "sRGBTexture", "textureType")
        }
        assert file.with_suffix("").is_file()
    assert len({each["guid"] for each in settings.values()}) == len(settings) == 6
    assert all(re.fullmatch("[0-9a-f]{32}", each["guid"]) for each in settings.values())
    kinds = {name: (each["sRGBTexture"], each["textureType"]) for name, each in settings.items()}
    assert kinds["Twill21_Near_BaseMap.png.meta"] == ("1", "0")
    assert kinds["Twill21_Far_Normal.png.meta"] == ("0", "1")
    assert kinds["Twill21_Near_MaskMap.png.meta"] == ("0", "0")


@pytest.mark.usefixtures("net")
def test_unreals_script_imports_every_texture(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Against a module that takes every call: what is imported, as what, and what is connected."""
    folder = export(FABRIC, "unreal", tmp_path / "out")
    unreal: Any = ModuleType("unreal")
    parts = MagicMock()
    unreal.__getattr__ = lambda name: getattr(parts, name)
    textures: dict[str, MagicMock] = {}
    parts.EditorAssetLibrary.load_asset.side_effect = lambda path: textures.setdefault(path, MagicMock())
    tasks: list[MagicMock] = []
    parts.AssetImportTask.side_effect = lambda: tasks.append(MagicMock()) or tasks[-1]
    monkeypatch.setitem(sys.modules, "unreal", unreal)
    runpy.run_path(str(folder / "import_into_unreal.py"))
    given = {
        Path(call.args[1])
        for task in tasks
        for call in task.set_editor_property.call_args_list
        if call.args[0] == "filename"
    }
    assert given == set(folder.rglob("*.png"))
    srgb = {
        path.rsplit("_", 1)[1]: dict(call.args for call in texture.set_editor_property.call_args_list)["srgb"]
        for path, texture in textures.items()
    }
    assert srgb == {"BC": True, "N": False, "ORM": False}
    assert set(textures) == {f"/Game/Loomlight/Twill21/{file.stem}" for file in folder.rglob("*.png")}
    places = [call.args[1:] for call in parts.MaterialEditingLibrary.connect_material_property.call_args_list]
    kinds = parts.MaterialProperty
    assert len(places) == 2 * 6
    numbers = parts.MaterialEditingLibrary.create_material_expression.return_value
    repeats = [
        call.args[1] for call in numbers.set_editor_property.call_args_list if call.args[0] == "default_value"
    ]
    assert repeats == [250, 125, 25, 12.5]
    for pin, place in (("G", kinds.MP_ROUGHNESS), ("A", kinds.MP_OPACITY_MASK), ("RGB", kinds.MP_NORMAL)):
        assert (pin, place) in places


@pytest.mark.usefixtures("dense")
def test_a_name_with_quotes_is_written_as_it_must_be(tmp_path: Path) -> None:
    made = tmp_path / "cloth.toml"
    made.write_text('name = \'The "best" \\\\ cloth\'\nweave = "plain"\n')
    for engine in ENGINES:
        folder = export(made, engine, tmp_path / engine)
        if engine == "godot":
            (line,) = re.findall(r"resource_name = (.*)", (folder / "the-best-cloth_near.tres").read_text())
            assert re.fullmatch(r'"(\\.|[^"\\])*"', line)
        if engine == "unreal":
            compile((folder / "import_into_unreal.py").read_text(), "import_into_unreal.py", "exec")


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["--to", "godot", "--mesh", "a.obj", "-o", "out"], "--to godot writes no meshes"),
        (["--to", "unity", "--distance", "0", "-o", "out"], "from 0.01 to 1000"),
        (["--to", "unreal", "--model", "point", "-o", "out"], 'does not take the model "point"'),
    ],
)
def test_faults_are_one_sentence(arguments: list[str], says: str, refused: Callable[..., str]) -> None:
    assert says in refused(["export", "plain", *arguments])
