"""Meshes in their cloths: parts, millimetres, names, and the glTF file.

Covers: exporters/garment_gltf.py
"""

from __future__ import annotations

import json
import warnings
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import trimesh
from PIL import Image

from loomlight.core.errors import LoomlightWarning
from loomlight.core.picture_settings import GarmentSettings, Placement, Worn
from loomlight.exporters import export, garment_gltf
from loomlight.exporters.garment import (
    ClothedGarment,
    GarmentCloth,
    clothed_garment,
    fabric_of,
)
from loomlight.exporters.garment_gltf import garment_glb, textures_of
from loomlight.mesh.cloth_mesh import metric, uv_size
from loomlight.mesh.reading import read_parts
from tests.helpers.meshes import coat, write_gltf
from tests.helpers.standard_materials import plain_material
from tests.helpers.validators import khronos_issues

pytestmark = pytest.mark.filterwarnings("ignore:.*stay uncovered")


def clothed(file: Path, **settings: object) -> ClothedGarment:
    """The coat with a lining of satin; textures of the shell hold 2 × 3 mm, of satins 5 × 5."""
    chosen = GarmentSettings(mesh=file, **settings)
    return clothed_garment(
        fabric_of("plain"),
        chosen,
        lambda fabric: plain_material((5.0, 5.0) if "satin" in fabric.name else (2.0, 3.0)),
    )


def test_parts_wear_the_fabrics_that_they_are_given(tmp_path: Path) -> None:
    found = clothed(coat(tmp_path), cloths={"lining": "satin 5/2"})
    assert [(part.name, part.cloth) for part in found.parts] == [("front", 0), ("back", 1), ("button", None)]
    assert [cloth.name for cloth in found.cloths] == ["plain", "satin 5/2"]
    assert found.name == "coat"
    assert found.facts()["parts"] == {"front": "plain", "back": "satin 5/2", "button": None}


def test_a_fabric_that_several_parts_wear_is_fitted_once(tmp_path: Path) -> None:
    found = clothed(coat(tmp_path), cloths={"front": "satin 5/2", "back": Worn("satin 5/2", 30.0)})
    assert [part.cloth for part in found.parts] == [0, 0, None]
    assert [cloth.key for cloth in found.cloths] == ["satin-5-2"]


def test_fabrics_of_one_name_have_folders_of_their_own(tmp_path: Path) -> None:
    for folder, weave in (("a", "plain"), ("b", "satin 5/2")):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "Ärmel.toml").write_text(f'name = "Ärmel & Saum"\nweave = "{weave}"\n')
    cloths = {"front": tmp_path / "a" / "Ärmel.toml", "back": tmp_path / "b" / "Ärmel.toml"}
    found = clothed(coat(tmp_path), cloths=cloths)
    assert [cloth.name for cloth in found.cloths] == ["Ärmel & Saum", "Ärmel & Saum-2"]
    assert [cloth.key for cloth in found.cloths] == ["armel-saum", "armel-saum-2"]


def test_uv_count_repeats_of_true_size(tmp_path: Path) -> None:
    """The second panel's uv are four times as dense: its threads are not."""
    for part in clothed(coat(tmp_path), cloths={"lining": "satin 5/2"}).parts[:2]:
        size = (2, 3) if part.cloth == 0 else (5, 5)
        assert uv_size(part.mesh) == pytest.approx(size)
        _, along, up = metric(part.mesh)
        assert np.cross(along, up)[:, 2].min() > 0
        assert 0 <= part.mesh.uv.min(axis=0).max() < 1


def test_the_weave_lies_as_it_is_told(tmp_path: Path) -> None:
    found = clothed(
        coat(tmp_path),
        cloths={"lining": Worn("satin 5/2", 90.0)},
        placement=Placement(turn=-90.0, scale=2.0),
    )
    front, back, _ = found.parts
    # A weave that is turned clockwise by a quarter has its x pointing down.
    assert metric(front.mesh)[1][0] * 1000 == pytest.approx([0, -4, 0], abs=1e-9)
    assert metric(back.mesh)[1][0] * 1000 == pytest.approx([10, 0, 0], abs=1e-9)
    assert front.tangent[0] == pytest.approx([0, -1, 0], abs=1e-9)


def cloth_of(**changes: object) -> GarmentCloth:
    return GarmentCloth("cloth", "cloth", plain_material(**changes))


def test_light_passes_through_cloth_with_holes_alone() -> None:
    dense, net = textures_of(cloth_of()), textures_of(cloth_of(cover=0.5))
    assert "diffuse_transmission" not in dense
    assert dense["base_color"].shape[2] == 3
    assert "diffuse_transmission" in net
    assert net["base_color"].shape[2] == 4


def test_what_is_reflected_and_passed_stays_the_same() -> None:
    """f of both is base · (1 − factor) and colour · factor, in each channel."""
    cloth = cloth_of()
    reflected, passed = 0.7 * np.array([0.3, 0.35, 0.4]), 0.3 * np.array([0.5, 0.3, 0.1])
    for made, lets_through in ((cloth.reflecting(), 0), (cloth.half_passing(), 0.5)):
        assert made.base[0, 0] * (1 - made.transmission[0, 0]) == pytest.approx(reflected)
        assert made.transmit[0, 0] * made.transmission[0, 0] == pytest.approx(passed * lets_through)
    # No smaller factor lets so much red through.
    assert cloth.half_passing().transmission[0, 0] == pytest.approx(passed.max() / 2)


@pytest.fixture
def one_material(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every fabric has the same material, which takes no fit."""
    monkeypatch.setattr(garment_gltf, "fitted", lambda fabric, model, distance: plain_material())


@pytest.mark.usefixtures("one_material")
def test_the_file_is_read_again(tmp_path: Path) -> None:
    """By our reader, whose v runs down, and by trimesh, whose v runs up."""
    folder = export("plain", "gltf", tmp_path / "out", mesh=coat(tmp_path), cloths={"back": "satin 5/2"})
    parts = read_parts(folder / "cloth.glb")
    assert [(part.name, part.material) for part in parts] == [
        ("front", "plain"),
        ("back", "satin 5/2"),
        ("button", "uncovered"),
    ]
    assert np.ptp(parts[0].mesh.positions, axis=0) == pytest.approx([0.4, 0.4, 0])
    assert uv_size(parts[0].mesh) == pytest.approx((2, 3), rel=1e-6)
    assert uv_size(parts[1].mesh) == pytest.approx((2, 3), rel=1e-6)
    scene = trimesh.load(folder / "cloth.glb")
    front = scene.geometry["front"]
    assert np.ptp(front.visual.uv, axis=0) == pytest.approx([200, 400 / 3], rel=1e-6)
    assert front.visual.uv[np.argmax(front.vertices @ [1, 1, 0])] == pytest.approx(
        front.visual.uv.max(axis=0)
    )
    manifest = json.loads((folder / "manifest.json").read_text())
    assert all((folder / name).is_file() for name in manifest["files"])
    assert "textures/satin-5-2_normal.png" in manifest["files"]


@pytest.mark.usefixtures("one_material")
def test_the_pictures_of_the_mesh_keep_their_uv(tmp_path: Path) -> None:
    folder = export("plain", "gltf", tmp_path / "out", mesh=write_gltf(tmp_path))
    (part,) = read_parts(folder / "cloth.glb")
    assert part.mesh.attributes["uv1"].min(axis=0) == pytest.approx([0, 0.5])
    assert part.mesh.attributes["uv1"].max(axis=0) == pytest.approx([1, 1])


@pytest.mark.slow
def test_khronos_validator_finds_no_fault(tmp_path: Path) -> None:
    found = clothed(coat(tmp_path), cloths={"lining": "satin 5/2"})
    cloths = [found.cloths[0], cloth_of(cover=0.5)]
    found = ClothedGarment(found.name, found.parts, cloths)
    (tmp_path / "cloth.glb").write_bytes(garment_glb(found, [textures_of(cloth) for cloth in cloths]))
    issues = khronos_issues(tmp_path / "cloth.glb")
    assert (issues["numErrors"], issues["numWarnings"]) == (0, 0), issues["messages"]


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["--to", "wgsl", "--mesh", "quad.glb"], "--to wgsl writes no meshes: leave out --mesh, or use gltf"),
        (
            ["--to", "gltf", "--cloth", "a=satin 5/2"],
            "cloths is of a mesh, and there is none",
        ),
        (["--to", "gltf", "--turn", "20"], "placement is of a mesh"),
        (["--to", "gltf", "--mesh", "none.obj"], "none.obj does not exist"),
        (["--to", "gltf", "--mesh", "quad.glb", "--cloth", "a=satin 5/2"], 'no part and no material "a"'),
        (["--to", "gltf", "--mesh", "quad.glb", "--cloth", "a=no.toml"], "no.toml does not exist"),
        (["--to", "gltf", "--mesh", "quad.glb", "--metres-per-unit", "0"], "from 1e-06 to 1e+06"),
    ],
)
def test_faults_are_one_sentence(arguments: list[str], says: str, refused: Callable[..., str]) -> None:
    write_gltf(Path())
    assert says in refused(["export", "plain", *arguments, "-o", "out"])


def test_a_folder_that_holds_the_mesh_is_not_replaced(refused: Callable[..., str]) -> None:
    Path("out").mkdir()
    write_gltf(Path("out"))
    said = refused(["export", "plain", "--to", "gltf", "--mesh", "out/quad.glb", "-o", "out"])
    assert "out holds out/quad.glb" in said


def test_maps_that_are_not_written_are_said(tmp_path: Path) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error", LoomlightWarning)
        fabric_of("plain")
    made = tmp_path / "printed.toml"
    made.write_text('weave = "plain"\n[maps.color]\npicture = "a.png"\n')
    Image.new("RGB", (4, 4), (200, 30, 30)).save(tmp_path / "a.png")
    with pytest.warns(LoomlightWarning, match="without its maps of color"):
        fabric_of(made)
