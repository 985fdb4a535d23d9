"""A mesh in its cloths, or a sheet of one, as a USD stage: UsdPreviewSurface and OpenPBR of MaterialX bound.

The nodes of OpenPBR are those of the MaterialX document, one shader prim a node, so that programs without a
reader of .mtlx files see them too. Metres, y up; asset paths are relative.
"""

from __future__ import annotations

import math
import re
import tempfile
from collections.abc import Iterable, Mapping
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import LoomlightError
from loomlight.core.extras import import_extra
from loomlight.core.picture_settings import GarmentSettings
from loomlight.exporters.fit import FittedMaterial
from loomlight.exporters.garment import (
    ClothedGarment,
    GarmentCloth,
    GarmentPart,
    clothed_garment,
    sheet,
    write_pictures,
)
from loomlight.exporters.gltf import eight_bits
from loomlight.exporters.materials import fitted
from loomlight.exporters.materialx import document_of, document_textures, standard_library
from loomlight.exporters.metal_rough import metal_rough
from loomlight.fabric.fabric import Fabric
from loomlight.mesh.picture_places import FILE_UV

# Textures that only the preview has, and the one that both have.
_PREVIEW_COLOR, _PREVIEW_ROUGHNESS, _NORMAL = "preview_color", "preview_roughness", "normal"
_GREY = (0.32, 0.32, 0.32)
# Ids of MaterialX's nodes that read the uv of a mesh.
_UV_READER, _UV_INPUT, _UV_NAME = "ND_geompropvalue_vector2", "texcoord", "st"


def write_usd(
    folder: Path,
    fabric: Fabric,
    model: str,
    distance: float | None,
    settings: GarmentSettings = GarmentSettings(),  # noqa: B008 (frozen)
) -> dict[str, object]:
    """Writes cloth.usd and its textures, and returns what the manifest says.

    Raises:
        InputError: what `clothed_garment` raises.
        MissingDependencyError: usd-core or MaterialX is missing.
    """
    garment = _garment(fabric, model, distance, settings)
    return {"files": _write_all(folder, garment)} | garment.facts()


def write_usdz(
    file: Path,
    fabric: Fabric,
    model: str,
    distance: float | None,
    settings: GarmentSettings = GarmentSettings(),  # noqa: B008 (frozen)
) -> dict[str, object]:
    """Writes the same as one package.

    Raises:
        InputError, MissingDependencyError: what `write_usd` raises.
        LoomlightError: usd-core cannot make the package.
    """
    garment = _garment(fabric, model, distance, settings)
    write_package(file, garment)
    return garment.facts()


def _garment(fabric: Fabric, model: str, distance: float | None, settings: GarmentSettings) -> ClothedGarment:
    """The mesh of the settings, or a sheet."""
    _require_packages()

    def fit(each: Fabric) -> FittedMaterial:
        return fitted(each, model, distance)

    return sheet(fabric, fit) if settings.mesh is None else clothed_garment(fabric, settings, fit)


def _write_all(folder: Path, garment: ClothedGarment) -> list[str]:
    """Writes cloth.usd and its textures, and returns their paths."""
    names = ["cloth.usd"]
    for cloth in garment.cloths:
        names += write_pictures(folder, cloth.key, textures_of(cloth))
    write_stage(folder / "cloth.usd", garment)
    return names


def write_package(file: Path, garment: ClothedGarment) -> None:
    """Writes a stage and its textures as one .usdz file.

    Raises:
        LoomlightError: usd-core cannot make it.
    """
    utilities = import_module("pxr.UsdUtils")
    with tempfile.TemporaryDirectory(dir=file.parent, prefix=".loomlight-") as name:
        folder = Path(name)
        _write_all(folder, garment)
        made = folder / "cloth.usdz"
        # Readers of phones look for a crate file by its suffix.
        if not utilities.CreateNewUsdzPackage(str(folder / "cloth.usd"), str(made), "cloth.usdc"):
            raise LoomlightError(f"{file}: usd-core cannot make a package of what was written.")
        made.replace(file)


def _require_packages() -> None:
    """Raises MissingDependencyError unless usd-core and MaterialX are there."""
    for module in ("pxr.Usd", "MaterialX"):
        import_extra(module, "usd,materialx", "Export to USD")


def textures_of(cloth: GarmentCloth) -> dict[str, NDArray[np.uint8]]:
    """Textures by name, 8 bits, row 0 at the upper edge: those of the document, and two of the preview."""
    simple = metal_rough(cloth.material)
    return document_textures(cloth.material) | {
        _PREVIEW_COLOR: simple.base_color(cloth.is_opaque),
        _PREVIEW_ROUGHNESS: eight_bits(simple.roughness),
    }


def write_stage(path: Path, garment: ClothedGarment) -> None:
    """Writes a stage that names textures/KEY_NAME.png beside it."""
    usd, geometry, kinds = (import_module(f"pxr.{name}") for name in ("Usd", "UsdGeom", "Kind"))
    stage = usd.Stage.CreateNew(str(path))
    geometry.SetStageMetersPerUnit(stage, 1.0)
    geometry.SetStageUpAxis(stage, geometry.Tokens.y)
    root = f"/{_identifier(garment.name)}"
    whole = geometry.Xform.Define(stage, root)
    stage.SetDefaultPrim(whole.GetPrim())
    usd.ModelAPI(whole.GetPrim()).SetKind(kinds.Tokens.component)
    geometry.Scope.Define(stage, f"{root}/materials")
    materials = [
        _define_material(stage, f"{root}/materials/{name}", cloth)
        for name, cloth in zip(
            _identifiers(cloth.name for cloth in garment.cloths), garment.cloths, strict=True
        )
    ]
    geometry.Scope.Define(stage, f"{root}/geometry")
    for name, part in zip(_identifiers(part.name for part in garment.parts), garment.parts, strict=True):
        material = None if part.cloth is None else materials[part.cloth]
        _define_mesh(stage, f"{root}/geometry/{name}", part, material)
    stage.GetRootLayer().Save()


def _identifier(name: str) -> str:
    return str(import_module("pxr.Tf").MakeValidIdentifier(name))


def _identifiers(names: Iterable[str]) -> list[str]:
    """Names as USD has them, with numbers where several are the same there."""
    found: list[str] = []
    for name in map(_identifier, names):
        same = sum(re.fullmatch(rf"{name}(_\d+)?", other) is not None for other in found)
        found.append(f"{name}_{same + 1}" if name in found else name)
    return found


# ---------------------------------------------------------------------------------------------------- meshes


def _define_mesh(stage: Any, path: str, part: GarmentPart, material: Any) -> None:
    geometry, shade, sdf, vt = (import_module(f"pxr.{name}") for name in ("UsdGeom", "UsdShade", "Sdf", "Vt"))
    types, mesh = sdf.ValueTypeNames, part.mesh
    made = geometry.Mesh.Define(stage, path)
    made.GetPrim().SetDisplayName(part.name)

    def vectors(rows: NDArray[np.float64]) -> NDArray[np.float32]:
        return np.ascontiguousarray(rows, np.float32)

    made.CreatePointsAttr(vt.Vec3fArray.FromNumpy(vectors(mesh.positions)))
    made.CreateFaceVertexCountsAttr(vt.IntArray.FromNumpy(np.full(len(mesh.triangles), 3, np.int32)))
    made.CreateFaceVertexIndicesAttr(vt.IntArray.FromNumpy(mesh.triangles.astype(np.int32).ravel()))
    made.CreateExtentAttr(
        vt.Vec3fArray.FromNumpy(vectors(np.stack([mesh.positions.min(0), mesh.positions.max(0)])))
    )
    made.CreateSubdivisionSchemeAttr(geometry.Tokens.none)
    made.CreateOrientationAttr(geometry.Tokens.rightHanded)
    made.CreateDoubleSidedAttr(True)
    made.CreateNormalsAttr(vt.Vec3fArray.FromNumpy(vectors(mesh.normals)))
    made.SetNormalsInterpolation(geometry.Tokens.vertex)
    primvars = geometry.PrimvarsAPI(made)
    if material is None:
        made.CreateDisplayColorAttr([_GREY])
        return
    sets = {_UV_NAME: mesh.uv}
    if FILE_UV in mesh.attributes:
        sets["st1"] = np.nan_to_num(mesh.attributes[FILE_UV]) * [1, -1] + [0, 1]
    for name, uv in sets.items():
        primvar = primvars.CreatePrimvar(name, types.TexCoord2fArray, geometry.Tokens.vertex)
        primvar.Set(vt.Vec2fArray.FromNumpy(vectors(uv)))
    shade.MaterialBindingAPI.Apply(made.GetPrim()).Bind(material)


# ------------------------------------------------------------------------------------------------- materials


def _define_material(stage: Any, path: str, cloth: GarmentCloth) -> Any:
    """A material with a surface for every renderer, and one for those that know MaterialX."""
    shade = import_module("pxr.UsdShade")
    material = shade.Material.Define(stage, path)
    prim = material.GetPrim()
    prim.SetDisplayName(cloth.name)
    width, height = cloth.material.size
    prim.SetDocumentation(f"Textures show {width:g} x {height:g} mm of {cloth.name}; st of 1 is as much.")
    preview = _define_preview(stage, path, cloth)
    material.CreateSurfaceOutput().ConnectToSource(preview.ConnectableAPI(), "surface")
    _define_document(stage, path, material, document_of(cloth.name, cloth.material, _stem(cloth)))
    return material


def _stem(cloth: GarmentCloth) -> str:
    """What paths of a cloth's textures begin with, as USD writes those that are relative to the file."""
    return f"./textures/{cloth.key}_"


def _define_preview(stage: Any, path: str, cloth: GarmentCloth) -> Any:
    """UsdPreviewSurface with its textures."""
    shade, sdf, gf = (import_module(f"pxr.{name}") for name in ("UsdShade", "Sdf", "Gf"))
    types = sdf.ValueTypeNames
    simple = metal_rough(cloth.material)

    def shader(name: str, kind: str) -> Any:
        made = shade.Shader.Define(stage, f"{path}/{name}")
        made.CreateIdAttr(kind)
        return made

    reader = shader("uv", "UsdPrimvarReader_float2")
    reader.CreateInput("varname", types.String).Set(_UV_NAME)
    coordinates = reader.CreateOutput("result", types.Float2)

    def texture(name: str, space: str) -> Any:
        made = shader(name, "UsdUVTexture")
        made.CreateInput("file", types.Asset).Set(sdf.AssetPath(f"{_stem(cloth)}{name}.png"))
        made.CreateInput("sourceColorSpace", types.Token).Set(space)
        made.CreateInput("st", types.Float2).ConnectToSource(coordinates)
        for axis in ("wrapS", "wrapT"):
            made.CreateInput(axis, types.Token).Set("repeat")
        return made

    surface = shader("preview", "UsdPreviewSurface")
    root = math.sqrt(simple.reflectance)
    surface.CreateInput("metallic", types.Float).Set(0.0)
    surface.CreateInput("ior", types.Float).Set((1 + root) / (1 - root))
    colour = texture(_PREVIEW_COLOR, "sRGB")
    surface.CreateInput("diffuseColor", types.Color3f).ConnectToSource(
        colour.CreateOutput("rgb", types.Float3)
    )
    if not cloth.is_opaque:
        surface.CreateInput("opacity", types.Float).ConnectToSource(colour.CreateOutput("a", types.Float))
    rough = texture(_PREVIEW_ROUGHNESS, "raw")
    surface.CreateInput("roughness", types.Float).ConnectToSource(rough.CreateOutput("r", types.Float))
    normal = texture(_NORMAL, "raw")
    normal.CreateInput("scale", types.Float4).Set(gf.Vec4f(2, 2, 2, 1))
    normal.CreateInput("bias", types.Float4).Set(gf.Vec4f(-1, -1, -1, 0))
    surface.CreateInput("normal", types.Normal3f).ConnectToSource(normal.CreateOutput("rgb", types.Float3))
    surface.CreateOutput("surface", types.Token)
    return surface


def _define_document(stage: Any, path: str, material: Any, document: Any) -> None:
    """The nodes of a MaterialX document as shader prims, its node graph as a node graph."""
    shade, sdf = (import_module(f"pxr.{name}") for name in ("UsdShade", "Sdf"))
    document.setDataLibrary(standard_library())
    graph, surface = document.getNodeGraph("cloth_textures"), document.getNode("cloth_surface")
    textures = shade.NodeGraph.Define(stage, f"{path}/{graph.getName()}")
    inside = f"{path}/{graph.getName()}"
    # 1. The reader of uv, which MaterialX takes for granted and USD calls by a name.
    reader = shade.Shader.Define(stage, f"{inside}/uv")
    reader.CreateIdAttr(_UV_READER)
    reader.CreateInput("geomprop", sdf.ValueTypeNames.String).Set(_UV_NAME)
    reader.CreateOutput("out", sdf.ValueTypeNames.Float2)
    # 2. Nodes with their values, then what connects them.
    shaders = {node.getName(): _define_node(stage, inside, node) for node in graph.getNodes()}
    for node in graph.getNodes():
        shader = shaders[node.getName()]
        if node.getCategory() == "image":
            uv = shader.CreateInput(_UV_INPUT, sdf.ValueTypeNames.Float2)
            uv.ConnectToSource(reader.ConnectableAPI(), "out")
        for each in node.getInputs():
            if each.getNodeName():
                shader.GetInput(each.getName()).ConnectToSource(
                    shaders[each.getNodeName()].ConnectableAPI(), "out"
                )
    # 3. The outputs of the graph, and the surface that takes them.
    for output in graph.getOutputs():
        made = textures.CreateOutput(output.getName(), _type_of(output))
        made.ConnectToSource(shaders[output.getNodeName()].ConnectableAPI(), "out")
    shaded = _define_node(stage, path, surface)
    for each in surface.getInputs():
        if each.getOutputString():
            shaded.GetInput(each.getName()).ConnectToSource(textures.ConnectableAPI(), each.getOutputString())
    # Without its version, readers take the nodes for those of 1.38 and convert them.
    prim = material.GetPrim()
    prim.AddAppliedSchema("MaterialXConfigAPI")
    version = prim.CreateAttribute("config:mtlx:version", sdf.ValueTypeNames.String)
    version.Set(document.getVersionString())
    material.CreateSurfaceOutput("mtlx").ConnectToSource(shaded.ConnectableAPI(), "out")


def _define_node(stage: Any, path: str, node: Any) -> Any:
    """The shader prim of a node, unconnected."""
    shade, sdf = (import_module(f"pxr.{name}") for name in ("UsdShade", "Sdf"))
    made = shade.Shader.Define(stage, f"{path}/{node.getName()}")
    made.CreateIdAttr(node.getNodeDef().getName())
    made.CreateOutput("out", _type_of(node))
    for each in node.getInputs():
        entry = made.CreateInput(each.getName(), _type_of(each))
        if not each.getValueString():
            continue
        value = each.getValue()
        if each.getType() == "filename":
            entry.Set(sdf.AssetPath(value))
            # Colours of sRGB; other numbers as they are.
            entry.GetAttr().SetColorSpace(each.getColorSpace() or "raw")
        elif each.getType() == "color3":
            entry.Set(tuple(value[k] for k in range(3)))
        else:
            entry.Set(value)
    return made


def _type_of(element: Any) -> Any:
    """The type in USD of a node, an input or an output."""
    types = import_module("pxr.Sdf").ValueTypeNames
    names: Mapping[str, str] = {
        "float": "Float",
        "integer": "Int",
        "boolean": "Bool",
        "string": "String",
        "filename": "Asset",
        "color3": "Color3f",
        "vector2": "Float2",
        "vector3": "Float3",
        "vector4": "Float4",
        "surfaceshader": "Token",
    }
    return getattr(types, names[element.getType()])
