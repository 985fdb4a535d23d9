"""A mesh in its cloths as a glTF 2.0 file: a node a part, a material a fabric, textures within."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.picture_settings import GarmentSettings
from loomlight.exporters.garment import (
    ClothedGarment,
    GarmentCloth,
    GarmentPart,
    clothed_garment,
    write_pictures,
)
from loomlight.exporters.gltf import (
    Buffer,
    container,
    material_entry,
    material_textures,
    png_bytes,
)
from loomlight.exporters.materials import fitted
from loomlight.fabric.fabric import Fabric
from loomlight.mesh.picture_places import FILE_UV

# What no cloth covers, such as buttons, is as grey as in pictures.
_UNCOVERED = {
    "name": "uncovered",
    "doubleSided": True,
    "pbrMetallicRoughness": {
        "baseColorFactor": [0.32, 0.32, 0.32, 1.0],
        "metallicFactor": 0.0,
        "roughnessFactor": 1.0,
    },
}


def write_garment_gltf(
    folder: Path, fabric: Fabric, model: str, distance: float | None, settings: GarmentSettings
) -> dict[str, object]:
    """Writes cloth.glb and its textures as pictures, and returns what the manifest says.

    Raises:
        InputError: what `clothed_garment` raises.
    """
    garment = clothed_garment(fabric, settings, lambda each: fitted(each, model, distance))
    textures = [textures_of(cloth) for cloth in garment.cloths]
    names = ["cloth.glb"]
    for cloth, own in zip(garment.cloths, textures, strict=True):
        names += write_pictures(folder, cloth.key, own)
    (folder / "cloth.glb").write_bytes(garment_glb(garment, textures))
    return {"files": names} | garment.facts()


def textures_of(cloth: GarmentCloth) -> dict[str, NDArray[np.uint8]]:
    """Textures by name [rows, columns, 3 or 4], 8 bits, row 0 at the upper edge.

    Light passes through yarns of cloth with holes alone: most programs do not know how, and would show the
    rest too bright.
    """
    if not cloth.is_opaque:
        return material_textures(cloth.half_passing())
    made = material_textures(cloth.reflecting())
    opaque = {name: pixels for name, pixels in made.items() if not name.startswith("diffuse_transmission")}
    return opaque | {"base_color": opaque["base_color"][..., :3]}


def garment_glb(garment: ClothedGarment, textures: list[dict[str, NDArray[np.uint8]]]) -> bytes:
    """The content of a .glb file.

    Args:
        textures: of each cloth; see `textures_of`.
    """
    buffer = Buffer()
    meshes = [
        {"name": part.name, "primitives": [_primitive(part, buffer, len(garment.cloths))]}
        for part in garment.parts
    ]
    images: list[dict[str, Any]] = []
    materials: list[dict[str, Any]] = []
    for cloth, own in zip(garment.cloths, textures, strict=True):
        entry = material_entry(cloth.name, cloth.material, [*own], None, first=len(images))
        entry["alphaMode"] = "OPAQUE" if cloth.is_opaque else "BLEND"
        materials.append(entry)
        images += [
            {
                "name": f"{cloth.key} {name}",
                "mimeType": "image/png",
                "bufferView": buffer.view(png_bytes(pixels)),
            }
            for name, pixels in own.items()
        ]
    if any(part.cloth is None for part in garment.parts):
        materials.append(_UNCOVERED)
    extensions = {name for entry in materials for name in entry.get("extensions", {})}
    tree = {
        "asset": {"version": "2.0", "generator": "loomlight; uv count repeats of the cloth"},
        "extensionsUsed": sorted(extensions),
        "scene": 0,
        "scenes": [{"name": garment.name, "nodes": [*range(len(meshes))]}],
        "nodes": [{"name": part.name, "mesh": number} for number, part in enumerate(garment.parts)],
        "meshes": meshes,
        "materials": materials,
        "textures": [{"source": number, "sampler": 0} for number in range(len(images))],
        "images": images,
        "samplers": [{"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 10497}],
        "accessors": buffer.accessors,
        "bufferViews": buffer.views,
        "buffers": [{"byteLength": len(buffer.content)}],
    }
    # Empty lists are no part of the format.
    return container({key: value for key, value in tree.items() if value != []}, buffer.content)


def _primitive(part: GarmentPart, buffer: Buffer, uncovered: int) -> dict[str, Any]:
    """The triangles of a part.

    Args:
        uncovered: number of the material of what no cloth covers.
    """
    mesh = part.mesh

    def rows(values: NDArray[np.float64], kind: str) -> int:
        return buffer.accessor(np.ascontiguousarray(values, np.float32), kind)

    attributes = {"POSITION": rows(mesh.positions, "VEC3"), "NORMAL": rows(_unit(mesh.normals), "VEC3")}
    if part.cloth is not None:
        # u × v shows towards the viewer, v upwards in the textures, as normal maps have it: no w is -1.
        ones = np.ones((len(mesh.positions), 1))
        attributes["TANGENT"] = rows(np.concatenate([_unit(part.tangent), ones], axis=1), "VEC4")
        attributes["TEXCOORD_0"] = rows(_downwards(mesh.uv), "VEC2")
        if FILE_UV in mesh.attributes:
            attributes["TEXCOORD_1"] = rows(np.nan_to_num(mesh.attributes[FILE_UV]), "VEC2")
    return {
        "attributes": attributes,
        "indices": buffer.accessor(mesh.triangles.astype(np.uint32).ravel(), "SCALAR"),
        "material": uncovered if part.cloth is None else part.cloth,
    }


def _unit(vectors: NDArray[np.float64]) -> NDArray[np.float64]:
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


def _downwards(uv: NDArray[np.float64]) -> NDArray[np.float64]:
    """uv whose v runs down the pictures, from the same whole repeats."""
    v = uv[:, 1]
    return np.stack([uv[:, 0], np.ceil(v.max(initial=0)) - v], axis=1)
