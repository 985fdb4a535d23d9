"""A fitted material as a MaterialX document with an OpenPBR surface."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from loomlight.core.errors import LoomlightError
from loomlight.core.extras import import_extra
from loomlight.export.fit import FittedMaterial
from loomlight.export.gltf import peak_of
from loomlight.export.gltf_brdf import DIELECTRIC

# Index of refraction whose reflectance at normal incidence is that of glTF's dielectric.
_IOR = (1 + DIELECTRIC**0.5) / (1 - DIELECTRIC**0.5)


def require_materialx() -> Any:
    """The package MaterialX.

    Raises:
        MissingDependencyError: it is not installed.
    """
    return import_extra("MaterialX", "materialx", "Export to MaterialX")


def write_document(path: Path, name: str, material: FittedMaterial) -> None:
    """Writes a .mtlx file that names textures/*.png beside it; uv of 1 is one repeat.

    Raises:
        LoomlightError: MaterialX finds the document invalid.
    """
    mx = require_materialx()
    document = mx.createDocument()
    width, height = material.size
    document.setDocString(f"{name}: one repeat of the weave, {width:g} x {height:g} mm, is uv 0 to 1.")
    graph = document.addNodeGraph("cloth_textures")

    def image(texture: str, kind: str, channel: str | None = None, is_colour: bool = False) -> Any:
        node = graph.addNode("image", f"image_{texture}", "vector4" if channel == "w" else kind)
        file = node.setInputValue("file", f"textures/{texture}.png", "filename")
        if is_colour:
            file.setColorSpace("srgb_texture")
        return node

    def output(label: str, node: Any, kind: str) -> None:
        graph.addOutput(label, kind).setConnectedNode(node)

    def channel(node: Any, label: str, index: int, of: str) -> Any:
        extract = graph.addNode("extract", f"{label}_channel", "float")
        extract.addInput("in", of).setConnectedNode(node)
        extract.setInputValue("index", index, "integer")
        return extract

    output("base_color", image("base_color", "color3", is_colour=True), "color3")
    # Opacity lies in the fourth channel, which a picture of three channels does not read.
    cover = graph.addNode("image", "image_opacity", "vector4")
    cover.setInputValue("file", "textures/base_color.png", "filename")
    output("opacity", channel(cover, "opacity", 3, "vector4"), "float")
    rough = image("metallic_roughness", "vector3")
    output("roughness", channel(rough, "roughness", 1, "vector3"), "float")
    anisotropy = image("anisotropy", "vector3")
    output("anisotropy", channel(anisotropy, "anisotropy", 2, "vector3"), "float")
    output("specular_color", image("specular_color", "color3", is_colour=True), "color3")
    bump = graph.addNode("normalmap", "normal_in_world", "vector3")
    bump.addInput("in", "vector3").setConnectedNode(image("normal", "vector3"))
    output("normal", bump, "vector3")
    transmission = graph.addNode("image", "image_transmission", "vector4")
    transmission.setInputValue("file", "textures/diffuse_transmission.png", "filename")
    output("transmission", channel(transmission, "transmission", 3, "vector4"), "float")
    output("transmission_color", image("diffuse_transmission_color", "color3", is_colour=True), "color3")

    shader = document.addNode("open_pbr_surface", "cloth_surface", "surfaceshader")
    for target, source, kind in (
        ("base_color", "base_color", "color3"),
        ("specular_color", "specular_color", "color3"),
        ("specular_roughness", "roughness", "float"),
        ("specular_roughness_anisotropy", "anisotropy", "float"),
        ("geometry_opacity", "opacity", "float"),
        ("geometry_normal", "normal", "vector3"),
        ("subsurface_weight", "transmission", "float"),
        ("subsurface_color", "transmission_color", "color3"),
    ):
        entry = shader.addInput(target, kind)
        entry.setNodeGraphString("cloth_textures")
        entry.setOutputString(source)
    shader.setInputValue(
        "specular_weight", material.weight * peak_of(material.specular) / DIELECTRIC, "float"
    )
    shader.setInputValue("specular_ior", _IOR, "float")
    shader.setInputValue("geometry_thin_walled", True, "boolean")
    if material.sheen.max() > 0:
        strength = float(material.sheen.max())
        shader.setInputValue("fuzz_weight", strength, "float")
        shader.setInputValue("fuzz_color", mx.Color3(*(material.sheen / strength).tolist()), "color3")
        shader.setInputValue("fuzz_roughness", material.sheen_roughness, "float")
    surface = document.addNode("surfacematerial", "cloth", "material")
    surface.addInput("surfaceshader", "surfaceshader").setConnectedNode(shader)
    _require_valid(mx, document)
    mx.writeToXmlFile(document, str(path))


def _require_valid(mx: Any, document: Any) -> None:
    """Raises LoomlightError unless the document follows MaterialX's standard library."""
    checked = mx.createDocument()
    library = mx.createDocument()
    mx.loadLibraries(mx.getDefaultDataLibraryFolders(), mx.getDefaultDataSearchPath(), library)
    checked.copyContentFrom(document)
    checked.setDataLibrary(library)
    valid, message = checked.validate()
    if not valid:
        raise LoomlightError(f"The MaterialX document is invalid: {message.strip().splitlines()[0]}.")
