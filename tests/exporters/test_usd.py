"""USD stages: Pixar's validators, MaterialX' definitions, our reader; parts, metres, paths and packages.

Covers: exporters/usd.py, exporters/metal_rough.py
"""

from __future__ import annotations

import json
import zipfile
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import MaterialX
import numpy as np
import pytest
from pxr import Sdf, Usd, UsdGeom, UsdShade, UsdValidation

from loomlight.core.images import read_picture
from loomlight.exporters import export, usd
from loomlight.exporters.fit import FittedMaterial
from loomlight.exporters.materialx import document_of, standard_library
from loomlight.exporters.metal_rough import metal_rough
from loomlight.exporters.standards import evaluate_gltf
from loomlight.mesh.cloth_mesh import uv_size
from loomlight.mesh.reading import read_parts
from tests.helpers.meshes import coat
from tests.helpers.standard_materials import plain_material

pytestmark = pytest.mark.filterwarnings("ignore:.*stay uncovered")
# What usd-core's wheel says of every node of MaterialX, whose definitions it does not have.
UNKNOWN_NODE = "MissingShaderIdInRegistry"
# Fields of a material with an element a texel, which its formulas read.
TEXTURES = ("base", "transmission", "transmit", "specular", "normal")
TEXTURES += ("alpha_x", "alpha_y", "axis_x", "axis_y")
# The node graph of a material.
GRAPH = "cloth_textures"


@pytest.fixture(autouse=True)
def one_material(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every fabric has the same material, which takes no fit; satins have holes."""

    def fitted(fabric: Any, model: str, distance: float | None) -> Any:
        return plain_material(cover=0.5 if "satin" in fabric.name else 1.0)

    monkeypatch.setattr(usd, "fitted", fitted)


@pytest.fixture
def stage(tmp_path: Path) -> Usd.Stage:
    """The coat, whose back is of satin, and whose button no cloth covers."""
    folder = export("plain", "usd", tmp_path / "out", mesh=coat(tmp_path), cloths={"back": "satin 5/2"})
    return Usd.Stage.Open(str(folder / "cloth.usd"))


def faults(stage: Usd.Stage) -> list[str]:
    """What Pixar's validators find, but for nodes that MaterialX has."""
    registry = UsdValidation.ValidationRegistry()
    context = UsdValidation.ValidationContext(registry.GetOrLoadAllValidators())
    known = {f"'{each.getName()}'" for each in standard_library().getNodeDefs()}
    return [
        f"{error.GetName()}: {error.GetMessage()}"
        for error in context.Validate(stage)
        if error.GetName() != UNKNOWN_NODE or not any(name in error.GetMessage() for name in known)
    ]


def test_pixars_validators_find_no_fault(stage: Usd.Stage, tmp_path: Path) -> None:
    assert faults(stage) == []
    export("plain", "usdz", tmp_path / "coat.usdz", mesh=tmp_path / "coat.obj")
    assert faults(Usd.Stage.Open(str(tmp_path / "coat.usdz"))) == []


def test_they_would_find_one(stage: Usd.Stage) -> None:
    """A texture that is not there, or a node that MaterialX does not have."""
    (shader,) = (
        each
        for each in stage.Traverse()
        if each.GetPath().name == "normal_in_world" and "plain" in str(each.GetPath())
    )
    UsdShade.Shader(shader).CreateIdAttr("ND_normalmap_of_nobody")
    assert any("ND_normalmap_of_nobody" in fault for fault in faults(stage))


def test_metres_and_axes_are_said(stage: Usd.Stage) -> None:
    assert UsdGeom.GetStageMetersPerUnit(stage) == 1
    assert UsdGeom.GetStageUpAxis(stage) == UsdGeom.Tokens.y
    assert stage.GetDefaultPrim().GetName() == "coat"


def test_our_reader_reads_it_again(stage: Usd.Stage) -> None:
    parts = read_parts(stage.GetRootLayer().realPath)
    assert [(part.name, part.material) for part in parts] == [
        ("front", "plain"),
        ("back", "satin_5_2"),
        ("button", ""),
    ]
    for part in parts[:2]:
        assert np.ptp(part.mesh.positions, axis=0) == pytest.approx([0.4, 0.4, 0])
        assert uv_size(part.mesh) == pytest.approx((2, 3), rel=1e-6)
    # The panel's own uv, four times as dense as a unit.
    assert np.ptp(parts[1].mesh.attributes["uv1"], axis=0) == pytest.approx([4, 4])


def test_two_surfaces_are_bound_by_paths_beside_the_file(stage: Usd.Stage) -> None:
    folder = Path(stage.GetRootLayer().realPath).parent
    named = set()
    for prim in stage.Traverse():
        for attribute in prim.GetAttributes():
            value = attribute.Get()
            if isinstance(value, Sdf.AssetPath):
                assert value.path.startswith("./textures/")
                named.add(folder / value.path)
    assert named == set(folder.rglob("*.png"))
    back = stage.GetPrimAtPath("/coat/geometry/back")
    material, _ = UsdShade.MaterialBindingAPI(back).ComputeBoundMaterial()
    assert material.ComputeSurfaceSource("")[0].GetIdAttr().Get() == "UsdPreviewSurface"
    assert material.ComputeSurfaceSource("mtlx")[0].GetIdAttr().Get() == "ND_open_pbr_surface_surfaceshader"


def test_cloth_with_holes_alone_is_transparent_in_previews(stage: Usd.Stage) -> None:
    inputs = {
        name: UsdShade.Shader(stage.GetPrimAtPath(f"/coat/materials/{name}/preview")).GetInput("opacity")
        for name in ("plain", "satin_5_2")
    }
    assert not inputs["plain"]
    assert inputs["satin_5_2"].HasConnectedSource()


def test_nodes_are_those_of_the_valid_document(stage: Usd.Stage) -> None:
    """A document made again of the stage alone is valid, and says what the MaterialX export says."""
    made = rebuilt(stage, "/coat/materials/plain")
    made.setDataLibrary(standard_library())
    valid, message = made.validate()
    assert valid, message
    document = document_of("plain", plain_material(), "./textures/plain")
    for kind in ("open_pbr_surface", "image", "normalmap", "multiply", "extract"):
        assert numbers(made, kind) == numbers(document, kind)


def rebuilt(stage: Usd.Stage, path: str) -> Any:
    """The MaterialX document that shader prims with ids of MaterialX stand for."""
    document, library = MaterialX.createDocument(), standard_library()
    graph = document.addNodeGraph(GRAPH)
    for prim in Usd.PrimRange(stage.GetPrimAtPath(path)):
        shader = UsdShade.Shader(prim)
        kind = shader.GetIdAttr().Get() if shader else None
        if kind is None or not kind.startswith("ND_"):
            continue
        definition = library.getNodeDef(kind)
        assert definition is not None, kind
        is_surface = definition.getType() == "surfaceshader"
        place = document if is_surface else graph
        node = place.addNode(definition.getNodeString(), prim.GetName(), definition.getType())
        for entry in shader.GetInputs():
            declared = definition.getInput(entry.GetBaseName())
            assert declared is not None, f"{kind} has no {entry.GetBaseName()}"
            added = node.addInput(declared.getName(), declared.getType())
            if entry.HasConnectedSource():
                connected = entry.GetConnectedSources()[0][0]
                source, name = connected.source, connected.sourceName
                if is_surface:
                    added.setNodeGraphString(GRAPH)
                    added.setOutputString(str(name))
                else:
                    added.setNodeName(source.GetPrim().GetName())
            else:
                value = entry.Get()
                text = value.path if isinstance(value, Sdf.AssetPath) else str(value).strip("()")
                added.setValueString(text.lower() if isinstance(value, bool) else text)
    for output in UsdShade.NodeGraph(stage.GetPrimAtPath(f"{path}/{GRAPH}")).GetOutputs():
        source = output.GetConnectedSources()[0][0].source
        node = graph.getNode(source.GetPrim().GetName())
        graph.addOutput(output.GetBaseName(), node.getType()).setConnectedNode(node)
    surface = document.addNode("surfacematerial", "material", "material")
    surface.addInput("surfaceshader", "surfaceshader").setConnectedNode(
        document.getNodes("open_pbr_surface")[0]
    )
    return document


def numbers(document: Any, kind: str) -> dict[tuple[str, str], Any]:
    """What inputs of a kind of node are, by node and input, but for those that read uv."""
    nodes = [*document.getNodeGraph(GRAPH).getNodes(kind), *document.getNodes(kind)]
    return {
        (node.getName(), entry.getName()): entry.getNodeName()
        or entry.getOutputString()
        or (
            pytest.approx(entry.getValue())
            if entry.getType() in ("float", "integer")
            else entry.getValueString()
        )
        for node in nodes
        for entry in node.getInputs()
        if entry.getName() != "texcoord"
    }


def test_a_sheet_of_ten_centimetres_is_written_without_a_mesh(tmp_path: Path) -> None:
    folder = export("plain", "usd", tmp_path / "out", distance=1.0)
    (part,) = read_parts(folder / "cloth.usd")
    assert np.ptp(part.mesh.positions, axis=0)[:2] == pytest.approx([0.1, 0.1])
    assert np.ptp(part.mesh.uv, axis=0) == pytest.approx([50, 100 / 3], rel=1e-5)
    manifest = json.loads((folder / "manifest.json").read_text())
    assert all((folder / name).is_file() for name in manifest["files"])


def test_a_package_is_aligned_and_not_compressed(tmp_path: Path) -> None:
    """As USD asks: data of each file begins at a multiple of 64 bytes."""
    file = export("plain", "usdz", tmp_path / "coat.usdz", mesh=coat(tmp_path))
    content = file.read_bytes()
    with zipfile.ZipFile(file) as archive:
        entries = archive.infolist()
    assert entries[0].filename == "cloth.usdc"
    for entry in entries:
        assert entry.compress_type == zipfile.ZIP_STORED
        name, extra = (int.from_bytes(content[entry.header_offset + k :][:2], "little") for k in (26, 28))
        assert (entry.header_offset + 30 + name + extra) % 64 == 0
    assert [part.name for part in read_parts(file)] == ["front", "back", "button"]
    assert {each.name for each in tmp_path.iterdir()} == {"coat.obj", "coat.usdz"}


def test_names_that_usd_does_not_take_stay_for_readers(tmp_path: Path) -> None:
    obj = coat(tmp_path)
    obj.write_text(obj.read_text().replace("o front", "o left sleeve!").replace("o back", "o left sleeve?"))
    folder = export("plain", "usd", tmp_path / "out", mesh=obj)
    stage = Usd.Stage.Open(str(folder / "cloth.usd"))
    names = {prim.GetName(): prim.GetDisplayName() for prim in stage.Traverse() if prim.IsA(UsdGeom.Mesh)}
    assert names == {
        "left_sleeve_": "left sleeve!",
        "left_sleeve__2": "left sleeve?",
        "button": "button",
    }


def test_simple_materials_reflect_as_much_in_the_mean() -> None:
    """By glTF's formulas too, over lights and views that are weighted by their cosines."""
    rng = np.random.default_rng(3)
    count = 100_000

    def cosine_weighted() -> np.ndarray:
        cosine, azimuth = np.sqrt(rng.uniform(0, 1, count)), rng.uniform(0, 2 * np.pi, count)
        sine = np.sqrt(1 - cosine**2)
        return np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), cosine], axis=-1)

    light, view = cosine_weighted(), cosine_weighted()

    def albedo(material: FittedMaterial) -> np.ndarray:
        everywhere = {name: np.repeat(getattr(material, name)[0], count, axis=0) for name in TEXTURES}
        values = evaluate_gltf(replace(material, **everywhere), light, view) / light[:, 2:]
        return values.mean(axis=0) * np.pi

    grey = {"specular": [0.9, 0.9, 0.9], "weight": 0.1, "shape": (1, 1)}
    fit = plain_material(alpha_x=0.9, alpha_y=0.6, sheen=np.full(3, 0.3), sheen_roughness=0.6, **grey)
    simple = metal_rough(fit)
    alpha = simple.roughness[0, 0] ** 2
    made = plain_material(
        base=simple.base[0, 0],
        transmission=0.0,
        alpha_x=alpha,
        alpha_y=alpha,
        specular=[simple.reflectance] * 3,
        weight=1.0,
        shape=(1, 1),
    )
    # The sheen takes from below by the larger of two albedos, of which the mean is taken here.
    assert albedo(made) == pytest.approx(albedo(fit), rel=0.05)


def test_the_preview_shows_base_colours_as_srgb(stage: Usd.Stage) -> None:
    folder = Path(stage.GetRootLayer().realPath).parent / "textures" / "plain"
    pixels = read_picture(folder / "preview_color.png")
    assert pixels.shape == (4, 6, 3)


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["--to", "usdz", "-o", "out"], ".usdz"),
        (["--to", "usd", "--mesh", "no.obj", "-o", "out"], "no.obj does not exist"),
        (["--to", "usdz", "--cloth", "a=plain", "-o", "out.usdz"], "cloths is of a mesh"),
    ],
)
def test_faults_are_one_sentence(arguments: list[str], says: str, refused: Callable[..., str]) -> None:
    assert says in refused(["export", "plain", *arguments])
