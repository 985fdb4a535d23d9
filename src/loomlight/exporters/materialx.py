"""A fitted material as a MaterialX document with an OpenPBR surface.

The fit is of glTF's material; roughness, anisotropy and transmission are converted to what OpenPBR's formulas
(OpenPBR 1.1, as MaterialX 1.39.5 implements them) make of their parameters.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import linear_to_srgb
from loomlight.core.errors import LoomlightError
from loomlight.core.extras import import_extra
from loomlight.exporters.fit import FittedMaterial
from loomlight.exporters.gltf import eight_bits, material_textures, peak_of

# OpenPBR's reflectance rises to 1 at grazing angles, a fit's to `weight`. A larger one at normal incidence,
# under a darker tint, is flatter; much larger, it would hide the base.
_FLAT_FRESNEL = 0.2
# Mean of Schlick's (1 − cos θ)⁵ over the hemisphere.
_SCHLICK_MEAN = 1 / 21
_MAX_PASSED = 0.49


def require_materialx() -> Any:
    """The package MaterialX.

    Raises:
        MissingDependencyError: it is not installed.
    """
    return import_extra("MaterialX", "materialx", "Export to MaterialX")


def document_textures(material: FittedMaterial) -> dict[str, NDArray[np.uint8]]:
    """Textures by name [rows, columns, 3 or 4], 8 bits, row 0 at the upper edge, as the document reads them.

    `anisotropy` is where highlights are wide, in the tangent plane, and OpenPBR's anisotropy a;
    `subsurface` the colour that light has which passes, and the share of it.
    """
    shared = material_textures(material)
    ratio = material.alpha_y / material.alpha_x
    # OpenPBR: α along the tangent is r² √(2/(1 + (1 − a)²)), and (1 − a) times that across it.
    roughness = ((material.alpha_x**2 + material.alpha_y**2) / 2) ** 0.25
    # A thin wall's subsurface passes one half and reflects the other, which the base then reflects less. The
    # largest channel of its colour is 1, and the share carries the brightness: 1.39.5 squares this colour,
    # of which the root keeps the hue there.
    hue = material.transmit / np.maximum(material.transmit.max(-1), 1e-6)[..., None]
    passed = _passed(material)
    reflected = material.base * (1 - material.transmission)[..., None] * (1 - material.weight)
    base = np.maximum(reflected / _below_gloss(material) - passed[..., None] * hue, 0)
    base /= (1 - 2 * passed)[..., None]
    share = passed / max(float(passed.max()), 1e-6)
    direction = 0.5 + 0.5 * material.direction
    return {
        "base_color": eight_bits(np.concatenate([linear_to_srgb(base), material.cover[..., None]], axis=-1)),
        "normal": shared["normal"],
        "specular_color": eight_bits(
            linear_to_srgb(material.specular * (material.weight / _fresnel(material)))
        ),
        "specular_roughness": eight_bits(np.repeat(roughness[..., None], 3, axis=-1)),
        "anisotropy": eight_bits(np.concatenate([direction, 1 - ratio[..., None]], axis=-1)),
        "subsurface": eight_bits(np.concatenate([linear_to_srgb(np.sqrt(hue)), share[..., None]], axis=-1)),
    }


def _passed(material: FittedMaterial) -> NDArray[np.float64]:
    """What passes of the brightest channel [rows, columns] below the gloss, at most half of the light."""
    passed = material.transmission * material.transmit.max(-1)
    return np.minimum(passed / _below_gloss(material), _MAX_PASSED)


def _below_gloss(material: FittedMaterial) -> float:
    """The share of light that OpenPBR's gloss leaves to what lies below it, in the mean over angles."""
    return (1 - _fresnel(material)) * (1 - _SCHLICK_MEAN)


def _fresnel(material: FittedMaterial) -> float:
    """OpenPBR's reflectance at normal incidence, before its tint."""
    fitted = material.weight * peak_of(material.specular)
    # A base of at most 1 has to make up for what the gloss takes.
    most = 1 - float(material.base.max()) * (1 - material.weight) / (1 - _SCHLICK_MEAN)
    return min(max(fitted, min(_FLAT_FRESNEL, most)), 0.99)


def write_document(path: Path, name: str, material: FittedMaterial) -> None:
    """Writes a .mtlx file that names textures/*.png beside it; uv of 1 is one repeat.

    Raises:
        LoomlightError: MaterialX finds the document invalid.
    """
    require_materialx().writeToXmlFile(document_of(name, material), str(path))


def document_of(name: str, material: FittedMaterial, folder: str = "textures") -> Any:
    """The document: a node graph `cloth_textures`, the surface `cloth_surface` and the material `cloth`.

    Args:
        folder: that its textures are said to lie in.

    Raises:
        LoomlightError: MaterialX finds the document invalid.
    """
    mx = require_materialx()
    document = mx.createDocument()
    width, height = material.size
    # What colours of textures are converted to.
    document.setColorSpace("lin_rec709")
    document.setDocString(f"{name}: one repeat of the weave, {width:g} x {height:g} mm, is uv 0 to 1.")
    _add_textures(document.addNodeGraph("cloth_textures"), 2 * float(_passed(material).max()), folder)
    shader = document.addNode("open_pbr_surface", "cloth_surface", "surfaceshader")
    for target, source, kind in (
        ("base_color", "base_color", "color3"),
        ("specular_color", "specular_color", "color3"),
        ("specular_roughness", "roughness", "float"),
        ("specular_roughness_anisotropy", "anisotropy", "float"),
        ("geometry_opacity", "opacity", "float"),
        ("geometry_normal", "normal", "vector3"),
        ("geometry_tangent", "tangent", "vector3"),
        ("subsurface_weight", "transmission", "float"),
        ("subsurface_color", "transmission_color", "color3"),
    ):
        entry = shader.addInput(target, kind)
        entry.setNodeGraphString("cloth_textures")
        entry.setOutputString(source)
    root = _fresnel(material) ** 0.5
    shader.setInputValue("specular_ior", (1 + root) / (1 - root), "float")
    shader.setInputValue("geometry_thin_walled", True, "boolean")
    if material.sheen.max() > 0:
        strength = float(material.sheen.max())
        shader.setInputValue("fuzz_weight", strength, "float")
        shader.setInputValue("fuzz_color", mx.Color3(*(material.sheen / strength).tolist()), "color3")
        shader.setInputValue("fuzz_roughness", material.sheen_roughness, "float")
    surface = document.addNode("surfacematerial", "cloth", "material")
    surface.addInput("surfaceshader", "surfaceshader").setConnectedNode(shader)
    _require_valid(mx, document)
    return document


def _add_textures(graph: Any, most_passed: float, folder: str) -> None:
    """The nodes that read the textures, and the outputs that the surface takes."""

    def image(texture: str, kind: str) -> Any:
        node = graph.addNode("image", f"image_{texture}_{kind}", kind)
        file = node.setInputValue("file", f"{folder}/{texture}.png", "filename")
        if kind == "color3":
            file.setColorSpace("srgb_texture")
        return node

    def output(label: str, node: Any) -> None:
        graph.addOutput(label, node.getType()).setConnectedNode(node)

    def node_of(category: str, label: str, kind: str, **inputs: Any) -> Any:
        node = graph.addNode(category, label, kind)
        for name, value in inputs.items():
            node.addInput(name.strip("_"), value.getType()).setConnectedNode(value)
        return node

    def channel(node: Any, label: str, index: int) -> Any:
        extract = node_of("extract", f"{label}_channel", "float", in_=node)
        extract.setInputValue("index", index, "integer")
        return extract

    output("base_color", image("base_color", "color3"))
    # Opacity lies in the fourth channel, which a picture of three channels does not read.
    output("opacity", channel(image("base_color", "vector4"), "opacity", 3))
    output("specular_color", image("specular_color", "color3"))
    output("roughness", channel(image("specular_roughness", "vector3"), "roughness", 0))
    anisotropy = image("anisotropy", "vector3")
    output("anisotropy", channel(anisotropy, "anisotropy", 2))
    output("normal", node_of("normalmap", "normal_in_world", "vector3", in_=image("normal", "vector3")))
    share = node_of(
        "multiply", "subsurface_share", "float", in1=channel(image("subsurface", "vector4"), "share", 3)
    )
    share.setInputValue("in2", most_passed, "float")
    output("transmission", share)
    output("transmission_color", image("subsurface", "color3"))
    # The tangent in the world, x of the texture along the surface's tangent, y along its bitangent.
    encoded = node_of("multiply", "doubled_direction", "vector3", in1=anisotropy)
    encoded.setInputValue("in2", 2.0, "float")
    signed = node_of("subtract", "direction", "vector3", in1=encoded)
    signed.setInputValue("in2", 1.0, "float")
    along = []
    for index, axis in enumerate(("tangent", "bitangent")):
        world = node_of(axis, f"world_{axis}", "vector3")
        world.setInputValue("space", "world", "string")
        part = channel(signed, axis, index)
        along.append(node_of("multiply", f"along_{axis}", "vector3", in1=world, in2=part))
    sum_of = node_of("add", "along_both", "vector3", in1=along[0], in2=along[1])
    output("tangent", node_of("normalize", "tangent_in_world", "vector3", in_=sum_of))


@cache
def standard_library() -> Any:
    """MaterialX's own definitions of nodes."""
    mx = require_materialx()
    library = mx.createDocument()
    mx.loadLibraries(mx.getDefaultDataLibraryFolders(), mx.getDefaultDataSearchPath(), library)
    return library


def _require_valid(mx: Any, document: Any) -> None:
    """Raises LoomlightError unless the document follows MaterialX's standard library."""
    checked = mx.createDocument()
    checked.copyContentFrom(document)
    checked.setDataLibrary(standard_library())
    valid, message = checked.validate()
    if not valid:
        raise LoomlightError(f"The MaterialX document is invalid: {message.strip().splitlines()[0]}.")
