"""Exports of a standard material: glTF, or MaterialX with OpenPBR; both of one fit."""

from __future__ import annotations

from pathlib import Path

from loomlight.exporters.fit import FittedMaterial, fit_material
from loomlight.exporters.gltf import glb_of, material_textures, write_textures
from loomlight.exporters.texels import texture_grid
from loomlight.fabric.fabric import Fabric
from loomlight.models.registry import make_model

# Radians that a pixel of a picture of 1080 rows sees, with a field of view of 26°.
PIXEL = 26 / 180 * 3.141592653589793 / 1080


def fitted(fabric: Fabric, model: str, distance: float | None) -> FittedMaterial:
    """The fit for a distance in metres, from where a texel is a pixel of a picture of 1080 rows; by default
    for close views, with eight texels a thread.

    Raises:
        InputError: too many texels, or the model does not take the fabric.
    """
    from loomlight.core.llvm import require_llvm

    require_llvm()
    size = texture_grid(fabric, None if distance is None else 1000 * distance * PIXEL)
    return fit_material(fabric, make_model(model, fabric), size)


def write_gltf(folder: Path, fabric: Fabric, model: str, distance: float | None) -> dict[str, object]:
    """Writes cloth.glb and its textures as pictures, and returns what the manifest says."""
    material = fitted(fabric, model, distance)
    textures = material_textures(material)
    names = write_textures(folder, textures)
    (folder / "cloth.glb").write_bytes(glb_of(fabric.name, material, textures))
    return {"files": ["cloth.glb", *names]} | facts(material)


def write_materialx(folder: Path, fabric: Fabric, model: str, distance: float | None) -> dict[str, object]:
    """Writes cloth.mtlx and its textures, and returns what the manifest says.

    Raises:
        MissingDependencyError: the package MaterialX is missing.
    """
    from loomlight.exporters.materialx import document_textures, require_materialx, write_document

    require_materialx()
    material = fitted(fabric, model, distance)
    names = write_textures(folder, document_textures(material))
    write_document(folder / "cloth.mtlx", fabric.name, material)
    return {"files": ["cloth.mtlx", *names]} | facts(material)


def facts(material: FittedMaterial) -> dict[str, object]:
    """Sizes and errors of a fit."""
    rows, columns = material.cover.shape
    width, height = material.size
    return {
        "repeat_mm": [width, height],
        "texels": [columns, rows],
        "texel_mm": [width / columns, height / rows],
        "relative_rms_error": round(material.error, 4),
        "brightness": round(material.brightness, 4),
    }
